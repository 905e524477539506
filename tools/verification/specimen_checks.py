"""Specimen tests against their theory."""

from verification.rows import bounded, reported
from verification.runs import Run
from verification.specimens import Specimen, bias_errors, bias_extension, frame_errors, picture_frame

FRAME = Run("picture_frame", "picture_frame")
FRAME_INCREMENTAL = Run("picture_frame_incremental", "picture_frame", ("material.law=incremental",))
FRAME_EXPLICIT = Run("picture_frame_explicit", "picture_frame_explicit")
BIAS_2 = Run("bias_extension_2", "bias_extension")
BIAS_3 = Run("bias_extension_3", "bias_extension",
             ('blank.size=["100 mm", "300 mm"]', 'boundary.head.motion.displacement="66 mm"'))


def frame_rows(name, run, directory):
    points = picture_frame(Specimen(directory))
    angle, rate, force = frame_errors(points)
    last = points[-1]
    return [
        bounded(name, "shear angle to 76 deg", "Eq. 13", f"{last.angle:.3f} deg at the end", angle, 0.1, "deg", run.command),
        bounded(name, "shear rate to 76 deg", "Eq. 14", f"{last.rate:.4g} rad/s at the end", rate, 1, "%", run.command),
        bounded(name, "axial force to 76 deg", "2 N_s L cos(pi/4 - theta/2)", f"{last.force:.4g} N at the end", force, 1, "%",
                run.command)]


def picture_frames(workshop):
    return (frame_rows("picture frame, implicit", FRAME, workshop.form(FRAME))
            + frame_rows("picture frame, explicit", FRAME_EXPLICIT, workshop.form(FRAME_EXPLICIT)))


def bias_extensions(workshop):
    rows = []
    for ratio, run in ((2, BIAS_2), (3, BIAS_3)):
        points = bias_extension(Specimen(workshop.form(run)))
        angle, net_angle, force, net_force = bias_errors(points)
        name, last = f"bias extension, L/W = {ratio}", points[-1]
        ours = f"{last.angle:.2f} deg, {last.force / last.width:.4g} N/m at the end"
        rows += [bounded(name, "central shear angle", "net of least power", ours, net_angle, 0.5, "deg", run.command),
                 bounded(name, "force over width", "net of least power", ours, net_force, 2, "%", run.command)]
        if ratio == 2:
            rows += [bounded(name, "central shear angle", "pi/2 - 2 acos((D + d)/(sqrt 2 D))", ours, angle, 0.5, "deg",
                             run.command),
                     bounded(name, "force over width", "power of the three regions", ours, force, 2, "%", run.command)]
        else:  # the textbook's regions are not the answer of least power here
            rows += [reported(name, "central shear angle", "pi/2 - 2 acos((D + d)/(sqrt 2 D))", ours, run.command,
                              f"{angle:.2f} deg"),
                     reported(name, "force over width", "power of the three regions", ours, run.command, f"{force:.2f} %")]
    return rows
