"""The fabric laws beside the surface N_s(theta, rate) that they stand for, when the rate changes.

A picture frame opened fast, slowly, held and closed is one point of the sheet: the force is known at every moment. A
hemisphere pressed fast, slowly and held adds what an explicit solver does to the rate: its scatter from element to
element. There the rate is the difference of the shear angle over two frame intervals, which no law sees.
"""

from dataclasses import dataclass

import numpy as np

from towform_results import Results
from verification.rows import Row, bounded, reported
from verification.runs import Run
from verification.specimens import frame_kinematics
from verification.surface import Surface, SurfaceTable, si

LAWS = {"viscous": ("material.law=viscous",),
        "incremental, next higher": ("material.law=incremental", "material.curve_selection=next_higher"),
        "incremental, interpolated": ("material.law=incremental", "material.curve_selection=interpolate")}
# Middle or end of the phases of cases/frame_reversal.toml and cases/press_speed.toml [s]
FRAME_PHASES = {"fast": 0.039, "slow": 0.139, "held": 0.179, "back": 0.200}
PRESS_PHASES = {"fast": 0.039, "slow": 0.138, "held": 0.198}


def frame_run(law):
    return Run("frame_reversal_" + law.replace(", ", "_").replace(" ", "_"), "frame_reversal", LAWS[law])


def press_run(law):
    return Run("press_speed_" + law.replace(", ", "_").replace(" ", "_"), "press_speed", LAWS[law])


@dataclass
class FrameHistory:
    """Shear force of the middle of a picture frame over time beside the surface's."""

    time: np.ndarray  # [s]
    force: np.ndarray  # [N/m]
    exact: np.ndarray  # N_s(theta, rate) with the sign of the rate [N/m]
    given_back: float  # work the sheet does on the way back over the work put in [%]


def frame_history(directory):
    results = Results(directory)
    arm = si(results.case["blank"]["size"][0])
    history, surface = results.history, SurfaceTable(Surface(results.case))
    travel, pull = history["position_frame_m"], history["force_frame_N"]
    speed = np.gradient(travel, history["time_s"])
    theta, rate = frame_kinematics(arm, travel, speed)
    exact = np.copysign(surface(theta, rate), rate)
    force = pull / (2 * arm * np.cos(np.pi / 4 - theta / 2))
    step = np.diff(travel) * 0.5 * (pull[1:] + pull[:-1])
    put_in = step[np.diff(travel) > 0].sum()
    return FrameHistory(history["time_s"], force, exact, -100 * step[np.diff(travel) < 0].sum() / put_in)


@dataclass
class PressField:
    """RMS over the sheared elements (more than 5 deg) of a frame."""

    error: float  # force from the surface, over the surface's at the end of the fast phase [%]
    scatter: float  # rate of an element from the mean of its neighbours, over the rate [%]


def press_fields(directory):
    results = Results(directory)
    surface, across, areas = SurfaceTable(Surface(results.case)), results.neighbours(), results.areas
    inside = (across >= 0).all(axis=1)

    def fields(time):
        index = int(np.argmin(np.abs(results.times - time)))
        before, frame, after = (results.frame(i) for i in (index - 1, index, index + 1))
        rate = np.radians(after.shear_angle - before.shear_angle) / (after.time - before.time)
        theta = np.radians(frame.shear_angle)
        chosen = inside & (np.abs(frame.shear_angle) > 5)
        exact = np.copysign(surface(theta, rate), rate)
        return frame, rate, exact, chosen

    def rms(values, chosen):
        return np.sqrt(np.average(values[chosen] ** 2, weights=areas[chosen]))

    _, _, fast, chosen = fields(PRESS_PHASES["fast"])
    scale, found = rms(fast, chosen), {}
    for phase, time in PRESS_PHASES.items():
        frame, rate, exact, chosen = fields(time)
        seen = frame.shear_rate
        uneven = np.abs(seen) - np.abs(seen)[across].mean(axis=1)
        found[phase] = PressField(100 * rms(frame.shear_force - exact, chosen) / scale,
                                  100 * rms(uneven, chosen) / max(rms(seen, chosen), 1e-300))
    return found


def frame_laws(workshop):
    rows = []
    for law in LAWS:
        run = frame_run(law)
        history, name = frame_history(workshop.form(run)), f"frame and back, {law}"
        scale = np.interp(FRAME_PHASES["fast"], history.time, history.exact)
        for phase, time in FRAME_PHASES.items():
            ours, exact = (np.interp(time, history.time, v) for v in (history.force, history.exact))
            error, what = 100 * abs(ours - exact) / scale, f"shear force, {phase}"
            values = (name, what, f"{exact:.3g} N/m", f"{ours:.3g} N/m")
            # The law that is meant to follow the surface has to; of the others it is told how far they stray.
            rows.append(bounded(*values, error, 2, "% of fast", run.command) if law == "viscous"
                        else reported(*values, run.command, f"{error:.3g} % of fast"))
        given = (f"{history.given_back:.3g} % of the work put in" if history.given_back > 0
                 else f"none: takes {-history.given_back:.3g} % more")
        rows.append(Row(name, "work given back on the way home", "none", given, "", "none", run.command,
                        bool(history.given_back <= 0)) if law == "viscous"
                    else reported(name, "work given back on the way home", "none", given, run.command))
    return rows


def press_laws(workshop):
    rows = []
    for law in LAWS:
        run = press_run(law)
        directory = workshop.form(run)
        name = f"press, {law}"
        for phase, field in press_fields(directory).items():
            rows.append(reported(name, f"shear force from the surface, {phase}, RMS", "0", "", run.command,
                                 f"{field.error:.3g} % of fast"))
            if phase != "held":
                rows.append(reported(name, f"rate, element to element, {phase}, RMS", "smooth", "", run.command,
                                     f"{field.scatter:.3g} % of it"))
    return rows
