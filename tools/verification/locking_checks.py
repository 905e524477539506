"""Bias extension on meshes that cross the yarns: what the mesh adds to the force.

Yarns of 2e6 N/m, 34 degrees of shear in the middle. Beside the theory stands the mesh along the yarns that meets the grips'
corners, of about as many elements across, with the strips and springs of the press cases.
"""

from verification.rows import Row, reported
from verification.runs import Run
from verification.specimens import Specimen, bias_extension, percent

SETTINGS = ('material.fibre_modulus="2 GPa"', "material.relaxation_ratio=0.05",
            'boundary.head.motion.displacement="24.87 mm"', 'time.end="0.28 s"', "time.mass_scaling=10", "output.frames=10",
            "gates.yarn_strain=1")
STIFF = ("material.yarn_strain=strip", "material.strip_stiffness=300")  # as cases/double_dome.toml
ALIGNED = {8: 11.785113, 16: 5.8925565, 32: 2.9462783, 64: 1.47313915}  # [mm], 6, 12, 24 and 48 diagonals across
MESHES = (("diagonal", 0), ("diagonal", 15), ("diagonal", 30), ("diagonal", 45), ("cross", 0), ("cross", 30),
          ("cross", 45), ("unstructured", 0))


def bias_run(pattern, angle, across, edge, *more):
    return Run("_".join(["locking", pattern, str(angle), str(across), *(m.split("=")[1] for m in more)]), "bias_extension",
               (f'blank.edge="{edge:g} mm"', f"blank.pattern={pattern}", f'blank.mesh_angle="{angle} deg"', *SETTINGS, *more))


def over_theory(workshop, run):
    """Force over the textbook's, mean over the last three frames: single ones still ring."""
    points = bias_extension(Specimen(workshop.form(run)))[-3:]
    return sum(p.force / p.exact_force for p in points) / len(points)


def locking(workshop):
    rows, aligned = [], {}
    what = "force over theory, {} elements across"
    for across, edge in ALIGNED.items():
        for kind, settings in (("each triangle for itself", ()), ("strips, stiff spring", STIFF)):
            run = bias_run("diagonal", 0, f"{across}_aligned", edge, *settings)
            aligned[across] = over_theory(workshop, run)  # the last one counts
            rows.append(reported(f"bias extension to 34 deg, mesh along the yarns, {kind}", what.format(across), "1",
                                 f"{aligned[across]:.3f}", run.command))
    largest = dict.fromkeys(ALIGNED, 0.0)
    for pattern, angle in MESHES:
        for across in ALIGNED:
            run = bias_run(pattern, angle, across, 100 / across)
            ours = over_theory(workshop, run)
            error = percent(ours, aligned[across])
            largest[across] = max(largest[across], abs(error))
            fine = across >= 32
            rows.append(Row(f"bias extension to 34 deg, {pattern}, edges at {angle} deg to the yarns", what.format(across),
                            f"{aligned[across]:.3f}, mesh along the yarns", f"{ours:.3f}", f"{error:+.1f} %",
                            "5 %" if fine else "", run.command, bool(abs(error) <= 5) if fine else None))
    errors = list(largest.values())
    rows.append(Row("the same, of all eight meshes the one that is farthest off", ", ".join(map(str, ALIGNED)) + " elements across",
                    "mesh along the yarns", ", ".join(f"{e:.1f} %" for e in errors), "", "falls", "the runs above",
                    all(b < a for a, b in zip(errors, errors[1:]))))
    # What a plain triangle would say.
    run = bias_run("diagonal", 45, 16, 6.25, "material.yarn_strain=triangle")
    ours = over_theory(workshop, run)
    rows.append(reported("the same, diagonal, 45 deg, each triangle for itself", what.format(16),
                         f"{aligned[16]:.3f}, mesh along the yarns", f"{ours:.3f}", run.command,
                         f"{percent(ours, aligned[16]):+.0f} %"))
    return rows
