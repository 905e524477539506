"""docs/stability.md: written from the verdicts."""

import re

import numpy as np

from stress.forming import command
from stress.judge import ENERGY, PENETRATION, SAME_MESH
from verification.page import table_line
from verification.runs import ROOT

PAGE = ROOT / "docs/stability.md"
HEAD = f"""# Where the integration stands and where it gives up

`scripts/stress` varies one factor after another over its range, then all of them together (drawn at random from a fixed
seed), on the quarter models of two scenes: `cases/hemisphere.toml` with 1,600 elements and `cases/double_dome.toml` with
2,600 (of the whole blank), each on one thread. It writes this page and fails when a trial is wrong in silence; the test
`stress` does the same with a handful of trials.

A trial **stands** when it ends with exit code 0, every number of `results.h5` is finite, the energies' sum, taken from
`history.csv`, is within {100 * ENERGY:g} % of the external work from a quarter of the run on, and no node was deeper in a tool than
{PENETRATION} mm. Where nothing of the physics changes, the answer has to be that of the scene as it is, too: shear (RMS of means
over circles of 20 mm radius, so that meshes can be compared), the punch's mean force over the last twentieth of the run (beyond twice its
standard error: contact trembles), and draw-in. On the same
mesh (other steps, penalties, masses, slivers in the tools) they may be {SAME_MESH.shear} degrees, {100 * SAME_MESH.force:g} % and {SAME_MESH.draw_in} mm apart, for what a softer
contact and the noise of folds change. On another mesh of the same fineness they may be apart what halving the edge of the scene's own mesh
changes, and in draw-in, which is measured at single points of the outline, a fifth of an edge: {{bands}}. Draws of all factors are formed again with half the step, and have to give the same answer.

A trial **says so** when its answer is outside but the program's own output says why: that inertia matters (with twice the
reference's kinetic energy at least), that `strip_stiffness` locks the mesh, or that elements are flat. It **gives up** when it stops with an exit code of
its own, naming cause, time and place, and leaves results that are finite. Anything else is **wrong**.
"""
TAIL = """
## What it showed

- **The step** stands up to the limit itself: 0.5 to 1.0 of it give the same shear to a few hundredths of a degree. Where a sheet without
  bending folds, tiny differences choose between folds, the more the longer the step. The finer hemisphere of `docs/verification.md` and its
  quarter, each formed four times with thicknesses that differ in the fifteenth digit, and that with two orders of the elements: at most
  0.06 degrees RMS apart at 0.85 of the limit, then the default, up to 0.65 at 0.87, up to 0.8 at 0.9 (an earlier program). The penalty matters by penetration alone.
- **Mass scaling** is the factor with the least room at 1 m/s: beyond a few times, inertia shapes the answer, which the run says; at 100 the
  step is so long that the punch is inside the sheet before it meets resistance.
- **What a stiff or sticky sheet presses into the die's radius** ends most of the runs that give up: penetration passes its gate, at the fineness used
  here. A higher penalty or a finer mesh carries them further.
- **Meshes that cross the yarns** must not keep the scenes' `strip_stiffness = 300`: degrees of shear are lost, and the run now says so. With the
  default, nodes may be a fifth of an edge off. Flat elements cost accuracy and steps; with `time.step` they cost mass.
- **A sheet that hangs loose** (the tilted blanks, until holder and punch have it) must not keep the scenes' `relaxation_ratio = 0.015`: it
  crumples in longer steps, and the energy account is off by some per cent of the little work done on it. The run stops and says so; with the
  default it stands.
- **Pinched hard**, in a case of its own (a strip drawn out between two plates under 20 N, friction 0.25), friction is within 0.1 % of exact for
  penalties of 0.05 to 0.5, contact damping of 0.1 to 1 and edges of 2.5 and 5 mm. That is the work of `tool.damping`: without it the plate trembles
  on its springs for the whole run, and the sheet slips while it is off, 12 % too little friction and, with `contact.penalty = 0.5` and
  `time.safety = 1`, 30 %.

## Not covered

- Gravity, pressure, boundaries in grips and the implicit solver are not varied here; nor are the `incremental` and
  `elastic` laws, whose stable step is another.
- Coarse meshes on purpose, so that the whole suite takes minutes: a finer mesh penetrates less and sees smaller folds.
- The largest punch force of `summary.json` is that of the first touch of a press that starts at full speed. It follows the contact's
  stiffness, hence the step and the penalty, and is not compared here; `motion.profile = "smooth"` avoids it.
- That kinetic energy is small is not asked: a press at 1 m/s has inertia in its answer. Where it is large, the run says so.
"""
# factor, figure of a run, +1 where it has to rise with the factor, how the page says it
TRENDS = (("friction", "force", 1, "the punch's force rises with friction"),
          ("viscosity", "force", 1, "the punch's force rises with the viscosity"),
          ("press speed", "kinetic", 1, "kinetic over internal energy rises with the press speed"),
          ("yarn modulus in GPa", "strain", -1, "the yarns' strain falls with their modulus"))
SLACK = 0.05  # by which a figure may fall back between neighbours: contact leaves some noise


def short(message):
    """A stop's cause without the place that only this run has."""
    message = re.sub(r"(?<!\S)\S*/(?=[\w.]+: ?)", "", message)  # folders of files
    return message if len(message) <= 230 else message[:227] + "..."


def worst(standing):
    """What the trials that stand reached."""
    summaries = [v.summary for _, v in standing]
    text = f"{100 * max(s['energy_error'] for s in summaries):.2f} %, {max(s['penetration_max_mm'] for s in summaries):.3f} mm"
    apart = [v.apart.shear for t, v in standing if t.same and v.apart is not None]
    return text + (f", {max(apart):.2f} deg" if apart else "")


def factor_rows(factor, verdicts):
    for scene in dict.fromkeys(t.scene for t, _ in verdicts):
        mine = [(t, v) for t, v in verdicts if t.scene == scene]
        values = {word: [t.value for t, v in mine if v.word == word] for word in ("stands", "says so", "stops", "WRONG")}
        stand = [(t, v) for t, v in mine if v.word == "stands"]
        yield table_line((factor, scene.replace("_", " "), ", ".join(values["stands"]) or "-", worst(stand) if stand else "-",
                          ", ".join(values["says so"]) or "-", ", ".join(values["stops"]) or "-",
                          f"**{', '.join(values['WRONG'])}**" if values["WRONG"] else "-"))


def causes(verdicts):
    """Every stop once per factor, scene and kind of message."""
    seen = set()
    for trial, verdict in verdicts:
        key = (trial.factor, trial.scene, re.sub(r"[\d.e+-]+", "", verdict.why)[:60])
        if verdict.word in ("stands",) or key in seen:
            continue
        seen.add(key)
        yield table_line((trial.factor, trial.scene.replace("_", " "), trial.value, verdict.word, short(verdict.why)))


def figure(name, formed):
    history, summary = formed.history, formed.summary
    late = history["time_s"] >= 0.95 * history["time_s"][-1]
    return {"force": np.abs(history["force_punch_N"][late]).mean(), "kinetic": summary["kinetic_to_internal_max"],
            "strain": summary["fibre_strain_p99"]}[name]


def trend_rows(verdicts, results):
    for factor, name, sign, text in TRENDS:
        for scene in dict.fromkeys(t.scene for t, _ in verdicts):
            standing = sorted(((float(t.value), figure(name, results[t.name])) for t, v in verdicts
                               if t.factor == factor and t.scene == scene and v.word == "stands"))
            if len(standing) < 2:
                continue
            figures = np.array([f for _, f in standing])
            holds = bool(np.all(sign * np.diff(figures) >= -SLACK * np.abs(figures[:-1])))
            yield holds, table_line((text, scene.replace("_", " "), ", ".join(f"{v:g}" for v, _ in standing),
                                     ", ".join(f"{f:.3g}" for f in figures), "holds" if holds else "**misses**"))


def write(verdicts, results, bands):
    """Writes the page; False when a trend misses."""
    by_factor = {}
    for trial, verdict in verdicts:
        if trial.factor not in ("reference", "edge"):
            by_factor.setdefault(trial.factor, []).append((trial, verdict))
    words = [v.word for _, v in verdicts]
    counts = ", ".join(f"{words.count(w)} {text}" for w, text in
                       (("stands", "stand"), ("says so", "say so"), ("stops", "give up"), ("WRONG", "are wrong")))
    trends = list(trend_rows(verdicts, results))
    said = "; ".join(f"{scene.replace('_', ' ')} {b.shear:.2f} degrees, {100 * b.force:.0f} %, {b.draw_in:.1f} mm" for scene, b in bands.items())
    lines = [HEAD.replace("{bands}", said), f"Of {len(verdicts)} trials {counts}.", "", "## By factor", "",
             "The columns of figures show the largest energy error, penetration and, where the trial's shear is compared, RMS difference.", "",
             table_line(("factor", "scene", "stands at", "with at most", "says so at", "gives up at", "wrong at")), table_line(["---"] * 7)]
    lines += [row for factor, mine in by_factor.items() for row in factor_rows(factor, mine)]
    lines += ["", "## Causes named", "", table_line(("factor", "scene", "value", "", "what the program or the comparison said")), table_line(["---"] * 5)]
    lines += causes(verdicts)
    lines += ["", "## Where the physics changes", "", f"Neighbouring values may fall back by {100 * SLACK:g} %.", "",
              table_line(("trend", "scene", "values", "figures", "")), table_line(["---"] * 5)]
    lines += [row for _, row in trends]
    lines += ["", "## To repeat a trial", "",
              "    scripts/stress out/stress --only jitter", "",
              "forms the trials with that in their name, into a directory each, whose case file and meshes stay. One of the case's own keys needs no more than", "",
              f"    {command(next(t for t, _ in verdicts if t.factor == 'penalty'))}", TAIL.rstrip(), ""]
    PAGE.write_text("\n".join(lines))
    return all(holds for holds, _ in trends)
