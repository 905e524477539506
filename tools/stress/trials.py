"""What the suite tries: every factor alone over its range, then factors drawn together."""

from dataclasses import dataclass
from math import log10

import numpy as np

SCENES = {"hemisphere": 1600, "double_dome": 2600}  # cases of cases/, and the elements of their whole blanks
SPEED = {"hemisphere": ("75 mm", 75.0), "double_dome": ("60 mm", 60.0)}  # stroke, its time at 1 m/s [ms]
SEED = 20  # of every random number here
TOOLS = ("punch", "die", "holder")


@dataclass(frozen=True)
class Trial:
    scene: str
    factor: str  # "reference" for the scene as it is
    value: str  # as the page shows it
    settings: tuple = ()  # "key.path=value"
    blank: tuple = ()  # (maker, number) of a mesh in place of the grid; see blanks.py
    tools: float = 0.0  # height over edge of the slivers in the tools' meshes; 0: as they are
    same: str = ""  # the answer must be that of `against`, on the same "mesh" or, nearly, on an "other mesh"
    against: str = ""  # name of a trial formed before; the scene's reference without

    @property
    def name(self):
        return f"{self.scene}.{self.factor}.{self.value}".replace(" ", "_").replace(",", "")


def number(value):
    return f"{value:.4g}"


def of_scene(scene, values):
    """The second scene takes every other value: half the time."""
    return values if scene == "hemisphere" else values[1::2]


def friction(value):
    return tuple(f"tool.{tool}.friction={number(value)}" for tool in TOOLS)


def speed(scene, factor):
    return (f"time.end={number(SPEED[scene][1] / factor)} ms",)


def viscosity(factor):
    return (f"material.matrix.zero_shear_viscosity={number(300 * factor)} Pa s",)


def one_by_one(scene):
    """Every factor of the case file alone: name, values, settings, whether the answer must stay."""
    def trials(factor, values, settings, same=""):
        return [Trial(scene, factor, number(v), tuple(settings(v)), same=same) for v in of_scene(scene, values)]

    key = lambda path, unit="": lambda v: (f"{path}={number(v)}{unit}",)
    return (
        [Trial(scene, "reference", "as it is"),
         Trial(scene, "edge", "half", (f"blank.elements={4 * SCENES[scene]}",))]
        + trials("step over the stable step", (0.5, 0.6, 0.7, 0.8, 0.95, 1.0), key("time.safety"), "mesh")
        + trials("mass scaling", (3, 10, 30, 100, 300, 1000), key("time.mass_scaling"), "mesh")
        + trials("penalty", (0.01, 0.03, 0.2, 0.3, 0.5, 1.0), key("contact.penalty"), "mesh")
        + trials("friction", (0.0, 0.1, 0.2, 0.5, 0.7, 1.0), friction)
        + trials("viscosity", (0.01, 0.03, 0.1, 0.3, 3, 10, 30, 100), viscosity)
        + trials("press speed", (0.1, 0.3, 3, 10), lambda v: speed(scene, v))
        + trials("yarn modulus in GPa", (0.1, 0.3, 3, 10, 35), key("material.fibre_modulus", " GPa")))


def meshes(scene):
    """Blanks and tools as no one should mesh them. The grid in a file is the reference of the jittered ones."""
    step = ("time.step=4 us",)  # slivers alone would set a step of nanoseconds
    free = ("material.strip_stiffness=50",)  # what meshes that cross the yarns have: the scenes' own value is for those along them
    return (
        [Trial(scene, "jitter of nodes", number(j), free if j > 0 else (), ("jitter", j), same="other mesh") for j in of_scene(scene, (0.0, 0.1, 0.2, 0.3, 0.4, 0.5) if scene == "double_dome" else (0.0, 0.1, 0.2, 0.3, 0.5))]
        + [Trial(scene, "jitter of nodes, strip_stiffness = 300", number(j), (), ("jitter", j), same="other mesh") for j in of_scene(scene, (0.1, 0.2))]
        + [Trial(scene, "sliver elements", number(h), free, ("slivers", h), same="other mesh") for h in of_scene(scene, (0.3, 0.1))]
        + [Trial(scene, "sliver elements, time.step", number(h), step + free, ("slivers", h), same="other mesh")
           for h in of_scene(scene, (0.1, 0.03, 0.01, 1e-3, 1e-4))]
        + [Trial(scene, "slivers in the tools", number(h), (), (), h, same="mesh") for h in of_scene(scene, (1e-2, 1e-3, 1e-4, 1e-5, 1e-6))])


def bending(scene):
    """Bending that is held for some steps must give what it gives at every step."""
    stiffness = lambda b: f"material.bending_stiffness={number(b)} mN m"
    cases = [(f"{number(b)} mN m", (stiffness(b),)) for b in (0.1, 1, 10, 100)]
    cases += [(f"1 mN m, {key} = {value}", (stiffness(1), f"{key}={value}"))
              for key, value in (("time.safety", 1), ("time.mass_scaling", 100), ("contact.penalty", 0.03), ("contact.penalty", 0.5))]
    trials = []
    for value, settings in of_scene(scene, cases):
        each = Trial(scene, "bending at every step", value, (*settings, "time.subcycling=false"))
        trials += [each, Trial(scene, "bending", value, settings, same="mesh", against=each.name)]
    return trials


def tilted(scene):
    """The blank lies ten degrees askew: the tools start apart, and the half x >= 0 is modelled."""
    rise = {"hemisphere": 27, "double_dome": 40}[scene]  # of the blank's edge [mm]
    way = SPEED[scene][1] + rise + 3
    apart = (f"tool.die.position=[0, 0, '-{rise} mm']", f"tool.holder.position=[0, 0, '{rise} mm']", "tool.punch.position=[0, 0, '3 mm']")
    # The holder falls on the sheet, with more energy than the sheet has taken up by then.
    gently = ("tool.holder.force=-15 N", "gates.kinetic_to_internal=1000")
    time = (f"tool.punch.motion.displacement=-{number(way)} mm", f"time.end={number(way)} ms")
    # Until then it hangs loose: the scenes' soft spring of the law is for sheets that are held.
    springs = {"": (), ", relaxation_ratio = 0.1": ("material.relaxation_ratio=0.1",)}
    return [Trial(scene, "tilt of the blank in degrees" + name, number(a),
                  apart + gently + time + spring + (f"blank.tilt=['{number(a)} deg', 0]", "blank.symmetry=x"))
            for name, spring in springs.items() for a in of_scene(scene, (0.0, 10.0))]


def together(count):
    """Factors drawn at random, each over its whole range; then the same with half the step, whose answer has to be the same."""
    rng = np.random.default_rng(SEED)
    trials = []
    while len(trials) < 2 * count:
        scene = rng.choice(list(SCENES))
        safety, coefficient, jitter = rng.uniform(0.5, 1.0), rng.uniform(0.0, 1.0), rng.choice([0.0, 0.15, 0.3])
        mass, penalty, eta = 10 ** rng.uniform(0, 3), 10 ** rng.uniform(-2, log10(0.5)), 10 ** rng.uniform(-2, 2)
        rate, modulus = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-1, log10(35))
        if (modulus / mass) ** 0.5 / rate > 8.0:
            continue  # a run of many minutes
        rest = (f"time.mass_scaling={number(mass)}", f"contact.penalty={number(penalty)}", *friction(coefficient), *viscosity(eta),
                *speed(scene, rate), f"material.fibre_modulus={number(modulus)} GPa")
        blank = ("jitter", float(jitter)) if jitter else ()
        drawn = Trial(str(scene), "all together", f"draw {len(trials) // 2 + 1}", (f"time.safety={number(safety)}", *rest), blank)
        half = Trial(drawn.scene, "all together, half the step", drawn.value, (f"time.safety={number(0.5 * safety)}", *rest), blank,
                     same="mesh", against=drawn.name)
        trials += [drawn, half]
    return trials


def long_suite():
    return [t for scene in SCENES for t in one_by_one(scene) + meshes(scene) + bending(scene) + tilted(scene)] + together(10)


# Of the hemisphere: what came nearest to the edge, and what has to be stopped. A minute on one thread at most.
SHORT = ("reference.as_it_is", "edge.half", "step_over_the_stable_step.1", "mass_scaling.30", "mass_scaling.1000", "penalty.0.5", "friction.1",
         "viscosity.0.01", "yarn_modulus_in_GPa.0.1", "press_speed.10", "jitter_of_nodes.0.3", "jitter_of_nodes.0.5",
         "slivers_in_the_tools.1e-05", "sliver_elements_time.step.0.001")


def short_suite():
    return [t for t in one_by_one("hemisphere") + meshes("hemisphere") if t.name.removeprefix("hemisphere.") in SHORT]
