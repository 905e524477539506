"""The paper's double dome with the paper's law beside the same press with the viscous law (Figure 13, field by field)."""

import numpy as np

from towform_results import Results
from verification.dome_checks import weighted_rms
from verification.rows import reported
from verification.runs import Run

VISCOUS = Run("double_dome_1_thread", "double_dome")
PAPER = Run("double_dome_paper", "double_dome_paper")
TIMES = (0.02, 0.04, 0.06)  # [s], of Figure 13


def patchiness(results, values):
    """RMS over the sheet of an element's difference from the mean of the elements across its edges."""
    across = results.neighbours()
    inside = (across >= 0).all(axis=1)
    uneven = values - values[across].mean(axis=1)
    return weighted_rms(uneven[inside], results.areas[inside])


def paper(workshop):
    viscous, printed = Results(workshop.form(VISCOUS)), Results(workshop.form(PAPER))
    rows, name, command = [], "double dome, viscous beside the paper's law", PAPER.command
    for time in TIMES:
        ours, theirs = viscous.at(time), printed.at(time)
        when = f"at {1e3 * time:g} ms"
        scatter = [patchiness(r, f.curve_position.astype(float)) for r, f in ((viscous, ours), (printed, theirs))]
        rows.append(reported(name, f"indicator, element to element, {when}, RMS", f"{scatter[1]:.3f} curves",
                             f"{scatter[0]:.3f} curves", command, f"{100 * (1 - scatter[0] / scatter[1]):.0f} % removed"))
        scatter = [patchiness(r, np.abs(f.shear_angle)) for r, f in ((viscous, ours), (printed, theirs))]
        rows.append(reported(name, f"shear angle, element to element, {when}, RMS", f"{scatter[1]:.3f} deg",
                             f"{scatter[0]:.3f} deg", command))
        difference = weighted_rms(ours.shear_angle - theirs.shear_angle, viscous.areas)
        largest = [np.percentile(np.abs(f.shear_angle), 99) for f in (ours, theirs)]
        rows.append(reported(name, f"shear angle {when}, 99th percentile", f"{largest[1]:.1f} deg", f"{largest[0]:.1f} deg",
                             command, f"{difference:.2f} deg RMS over the sheet"))
        force = [abs(np.interp(time, r.history["time_s"], smoothed(r.history["force_punch_N"]))) for r in (viscous, printed)]
        rows.append(reported(name, f"punch force {when}, mean over 1.5 ms", f"{force[1]:.1f} N", f"{force[0]:.1f} N", command,
                             f"{100 * (force[0] / force[1] - 1):+.0f} %"))
    for column, what in (("draw_in_x_mid_mm", "middle of the short side"), ("draw_in_y_mid_mm", "middle of the long side")):
        ends = [r.history[column][-1] for r in (viscous, printed)]
        rows.append(reported(name, f"draw-in, {what}", f"{ends[1]:.1f} mm", f"{ends[0]:.1f} mm", command,
                             f"{ends[0] - ends[1]:+.1f} mm"))
    return rows


def smoothed(values):
    """Mean over five history rows, 1.5 ms of this case."""
    return np.convolve(np.pad(values, 2, mode="edge"), np.ones(5) / 5, mode="valid")
