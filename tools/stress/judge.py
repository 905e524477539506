"""Whether a trial ended right, said why it stopped, or was wrong in silence."""

import json
import re
from dataclasses import dataclass

import h5py
import numpy as np

from towform_results import Results
from verification.dome_checks import weighted_rms

ENERGY = 0.02  # of the external work, from a quarter of the run on
PENETRATION = 0.2  # [mm], the default gate

@dataclass
class Apart:
    """How far two answers are from each other."""
    shear: float  # RMS over smoothed fields [deg]
    force: float  # of the punch over the last twentieth of the run, relative
    draw_in: float  # largest of the three [mm]


SAME_MESH = Apart(0.3, 0.1, 0.5)  # what contact's softness and the noise of folds may change
STOPS = {3: "case file", 4: "files", 5: "stability or energy gate", 6: "contact gate"}


@dataclass
class Verdict:
    word: str  # "stands", "says so", "stops" or "WRONG"
    why: str = ""
    apart: Apart | None = None  # from what it is compared with
    summary: dict | None = None


def not_finite(path):
    """Names of the datasets of a results.h5 with values that are not finite."""
    found = []

    def look(name, item):
        if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not np.isfinite(item[...]).all():
            found.append(name)

    with h5py.File(path, "r") as file:
        file.visititems(look)
    return found


def smoothed(results, at, radius=0.02):
    """|shear| at places of the flat blank: mean over the elements within `radius` [m], so that meshes can be compared."""
    centres = results.centres
    near = ((at[:, None, :] - centres[None, :, :]) ** 2).sum(axis=2) < radius**2
    return near @ (results.areas * np.abs(results.frame(-1).shear_angle)) / (near @ results.areas)


def account(history):
    """Largest error of the energies' sum over the external work, taken from the history's columns themselves."""
    kinds = ("kinetic", "yarn", "shear_elastic", "shear_dissipated", "bending", "bending_damping", "contact", "friction", "damping")
    external, found = history["energy_external_J"], sum(history[f"energy_{kind}_J"] for kind in kinds)
    late = history["time_s"] >= 0.25 * history["time_s"][-1]
    return np.max(np.abs(found - external)[late] / np.maximum(np.abs(external), np.abs(found))[late])


def final_force(results):
    """Force of the punch over the last twentieth of the run: mean and its standard error [N]. The run's largest is that of
    the first touch."""
    history = results.history
    force = np.abs(history["force_punch_N"][history["time_s"] >= 0.95 * history["time_s"][-1]])
    return force.mean(), force.std() / np.sqrt(len(force))


def force_apart(results, reference):
    """Relative difference of the final forces beyond twice its standard error: contact trembles."""
    (ours, our_error), (known, known_error) = final_force(results), final_force(reference)
    return max(0.0, abs(ours - known) - 2 * np.hypot(our_error, known_error)) / known


def apart(results, reference):
    """Of a trial from what it is compared with, over the elements of the latter."""
    at, ours, known = reference.centres, results.summary["draw_in_mm"], reference.summary["draw_in_mm"]
    return Apart(weighted_rms(smoothed(results, at) - smoothed(reference, at), reference.areas),
                 force_apart(results, reference), max(abs(ours[k] - known[k]) for k in known))


def warned(formed, summary, known):
    """Did the run itself say what is wrong with it? That inertia matters counts when it is twice the reference's."""
    inertia = summary["kinetic_to_internal_max"] > 2 * known["kinetic_to_internal_max"]
    mesh = "strip_stiffness locks" in formed.said or "flat elements" in formed.said
    return mesh or ("inertia matters" in formed.said and inertia)


def stopped(formed):
    if formed.code not in STOPS:
        return Verdict("WRONG", f"exit code {formed.code}: {formed.said.strip()[-200:]}")
    if formed.code in (3, 4):
        said = [line for line in formed.said.splitlines() if line.strip()]
        return Verdict("stops", said[0]) if said else Verdict("WRONG", f"exit code {formed.code} without a word")
    summary = json.loads((formed.directory / "summary.json").read_text())
    if not re.match(r"stopped at t = [\d.e+-]+ ms, step \d+: .+", summary["message"]):
        return Verdict("WRONG", f"exit code {formed.code} does not name time and cause: {summary['message']}")
    bad = not_finite(formed.directory / "results.h5")
    return Verdict("WRONG", f"stopped, but not finite: {', '.join(bad[:3])}") if bad else Verdict("stops", summary["message"], summary=summary)


def judge(trial, formed, reference, band):
    """The verdict on a trial; `reference` are the Results that it is compared with, None when that run was stopped;
    `band` is how far they may be apart."""
    if formed.code is None:
        return Verdict("WRONG", formed.said)
    if formed.code != 0:
        return stopped(formed)
    results = Results(formed.directory)
    if trial.factor == "reference":
        reference = results
    summary, faults = results.summary, []
    verdict = Verdict("stands", summary=summary)
    bad = not_finite(results.path)
    if summary["status"] != "done" or results.status != "done":
        faults.append(f"exit code 0, but status {results.status}")
    if bad:
        faults.append(f"not finite: {', '.join(bad[:3])}")
    else:
        if (error := account(results.history)) > ENERGY:
            faults.append(f"energy account off by {100 * error:.1f} %")
        if summary["penetration_max_mm"] > PENETRATION:
            faults.append(f"penetration {summary['penetration_max_mm']:.2f} mm")
        if reference is not None:
            verdict.apart = apart(results, reference)
    if faults:
        return Verdict("WRONG", "; ".join(faults), verdict.apart, summary)
    if trial.same and reference is not None:
        found = verdict.apart
        if found.shear > band.shear:
            faults.append(f"shear {found.shear:.2f} degrees RMS apart")
        if found.force > band.force:
            faults.append(f"force at the end {100 * found.force:.0f} % apart")
        if found.draw_in > band.draw_in:
            faults.append(f"draw-in {found.draw_in:.1f} mm apart")
        verdict.why = "; ".join(faults)
        if faults:
            verdict.word = "says so" if warned(formed, summary, reference.summary) else "WRONG"
    return verdict


def other_mesh(finer, reference):
    """How far another mesh of the same fineness may be from the reference: as far as half its edge. Draw-in is measured
    at single points of the outline and may be a fifth of an edge off."""
    band, edge = apart(finer, reference), 1e3 * np.sqrt(2 * reference.areas.mean())
    return Apart(band.shear, band.force, max(band.draw_in, edge / 5))
