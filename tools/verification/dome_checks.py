"""The double dome and the hemisphere: symmetry, energy, contact, yarns, the same bits on one thread and two."""

import numpy as np

from towform_results import Results
from verification.rows import Row, bounded, reported
from verification.runs import Run


def quarter_difference(results, shear):
    """Largest difference of a quarter's mean |shear| from the mean of the four, over that mean."""
    x, y = results.centres.T
    means = np.array([np.average(shear[m], weights=results.areas[m])
                      for m in ((sx * x > 0) & (sy * y > 0) for sx in (1, -1) for sy in (1, -1))])
    return np.abs(means - means.mean()).max() / means.mean()


def partners(whole, part):
    """For each element of `part` the one of `whole` with the same centre, or the nearest."""
    def key(centre):
        return tuple(np.round(centre * 1e7).astype(int))

    centres = whole.centres
    index = {key(c): e for e, c in enumerate(centres)}
    found = [index.get(key(c), -1) for c in part.centres]
    if -1 in found:
        found = [int(np.argmin(((centres - c) ** 2).sum(axis=1))) for c in part.centres]
    return np.array(found)


def weighted_rms(values, weights):
    return np.sqrt(np.average(values**2, weights=weights))


def dome_rows(workshop, name, case):
    one_run, two_run = Run(f"{case}_1_thread", case), Run(f"{case}_2_threads", case, (), 2)
    quarter_run = Run(f"{case}_quarter", case, ("blank.symmetry=quarter",), 2)
    one, two, quarter = (Results(workshop.form(run)) for run in (one_run, two_run, quarter_run))
    summary, history, last = one.summary, one.history, one.frame(-1)
    shear = np.abs(last.shear_angle)
    difference = np.abs(quarter.frame(-1).shear_angle) - shear[partners(one, quarter)]
    late = history["time_s"] >= 0.5 * history["time_s"][-1]
    ratio = history["kinetic_to_internal"]
    strained = np.mean(np.abs(last.fibre_strain).max(axis=1) > 0.02)
    command = one_run.command
    same = all(np.array_equal(getattr(last, f), getattr(two.frame(-1), f))
               for f in ("position", "velocity", "shear_angle", "shear_rate", "shear_force", "fibre_strain"))
    done = {one.status, two.status, quarter.status} == {"done"}
    draw_in = " / ".join(f"{v:.1f}" for v in summary["draw_in_mm"].values())
    return [
        Row(name, "runs to its end", "done", "done" if done else "stopped", "", "done", command, done),
        reported(name, "elements, steps", "", f"{summary['elements']}, {summary['steps']}", command),
        reported(name, "largest shear angle", "", f"{summary['shear_angle_max_deg']:.1f} deg", command),
        reported(name, "draw-in, x / y / corner", "", f"{draw_in} mm", command),
        reported(name, "largest punch force", "", f"{summary['punch_force_max_N']:.0f} N", command),
        bounded(name, "mean shear, quarter by quarter", "equal", "", 100 * quarter_difference(one, shear), 1, "%", command),
        bounded(name, "shear, whole against quarter, RMS", "equal", "", weighted_rms(difference, quarter.areas), 0.5, "deg",
                quarter_run.command),
        bounded(name, "energy account over external work", "0", "", 100 * summary["energy_error"], 1, "%", command),
        bounded(name, "kinetic over internal and dissipated energy, second half", "small", "", 100 * ratio[late].max(), 10,
                "%", command),
        bounded(name, "the same at the end", "small", "", 100 * ratio[-1], 10, "%", command),
        bounded(name, "deepest penetration", "0", "", summary["penetration_max_mm"], 0.1, "mm", command),
        bounded(name, "elements over 2 % yarn strain", "few", "", 100 * strained, 1, "%", command),
        Row(name, "last frame, two threads against one", "the same bits", "the same bits" if same else "other bits", "",
            "the same bits", two_run.command, bool(same))]


def domes(workshop):
    return dome_rows(workshop, "double dome", "double_dome") + dome_rows(workshop, "hemisphere", "hemisphere")
