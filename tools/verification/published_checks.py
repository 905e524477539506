"""Beside published results of other double domes: only as good as what is known of them."""

from towform_results import Results
from verification.compared import compared, rms
from verification.rows import reported
from verification.runs import Run

OUTLINE = "double_dome_outline_pierce_falzon_2017.csv"
AXES = ("--column", "x=y_mm", "--column", "y=x_mm", "--mirror")
SIDE = 200  # [mm] along the ply's long side from the middle: before the mould's round end
PLAIN_WEAVE = ("material.card=gf_pp_plain_weave", "material.law=elastic", "blank.symmetry=quarter", "blank.thickness=1.2mm",
               *(f'tool.{name}.position=["0 mm", "0 mm", "{z} mm"]' for name, z in (("punch", 0.1), ("holder", 0.1), ("die", -0.1))))


def outlines(workshop):
    rows = []
    for layup, angle in (("0/90", 0), ("+-45", 45)):
        name = f"male double dome, {layup}"
        run = Run(f"pierce_falzon_{angle}", "double_dome_pierce_falzon", (f'blank.fibre_angle="{angle} deg"',))

        def differences(*more):
            return compared(workshop, run, OUTLINE, (*AXES, "--where", f"layup={layup}", *more))

        edge = differences("--where", "y_mm=0")
        side = differences("--where", f"y_mm<={SIDE}")
        whole = differences()
        published = "Pierce and Falzon 2017, +-3 mm by a third party"
        rows += [
            reported(name, "short axis, sheet beyond the published edge", published, "", run.command, f"{edge[0]:+.1f} mm"),
            reported(name, f"long side to {SIDE} mm from the middle, RMS", published, "", run.command, f"{rms(side):.1f} mm"),
            reported(name, "whole outline, RMS and largest", published, "", run.command,
                     f"{rms(whole):.0f} mm, {max(abs(d) for d in whole):.0f} mm"),
            reported(name, "largest shear angle", "", f"{Results(workshop.form(run)).summary['shear_angle_max_deg']:.1f} deg",
                     run.command)]
    return rows


def plain_weave(workshop):
    run = Run("double_dome_plain_weave", "double_dome", PLAIN_WEAVE)
    peak = Results(workshop.form(run)).summary["shear_angle_max_deg"]
    return [reported("double dome, plain weave of Cao et al. 2008", "largest shear angle",
                     "48.2 deg, 37.2 deg with optimised clamps: Chen et al., abstract", f"{peak:.1f} deg", run.command,
                     f"{peak - 48.2:+.1f} deg")]


def published(workshop):
    return outlines(workshop) + plain_weave(workshop)
