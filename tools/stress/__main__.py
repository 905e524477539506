"""scripts/stress: see there."""

import argparse
import sys
from pathlib import Path

from stress import page
from stress.forming import form_all
from stress.judge import SAME_MESH, judge, other_mesh
from stress.trials import long_suite, short_suite
from towform_results import Results
from verification.runs import ROOT


def show(trial, verdict):
    s = verdict.summary
    figures = (f"energy {100 * s['energy_error']:6.2f} %  penetration {s['penetration_max_mm']:6.3f} mm  "
               f"shear max {s['shear_angle_max_deg']:5.1f} deg  " if s else "")
    a = verdict.apart
    distance = f"apart {a.shear:.2f} deg {100 * a.force:.0f} % {a.draw_in:.1f} mm  " if a is not None else ""
    print(f"{trial.name:<64} {verdict.word:<8} {figures}{distance}{verdict.why}", flush=True)


def main():
    parser = argparse.ArgumentParser(prog="scripts/stress", description="Tries to break towform and writes docs/stability.md.")
    parser.add_argument("directory", nargs="?", default=ROOT / "out/stress", type=Path, help="where trials are formed (default: out/stress)")
    parser.add_argument("--short", action="store_true", help="a handful of the harshest trials; writes no page")
    parser.add_argument("--only", default="", help="trials with this in their name, and the references; writes no page")
    parser.add_argument("--seconds", type=float, default=900, help="given to a trial (default: 900)")
    options = parser.parse_args()
    trials = short_suite() if options.short else long_suite()
    trials = [t for t in trials if options.only in t.name or t.factor in ("reference", "edge")]
    references, bands, verdicts = {}, {}, []
    for trial, formed in form_all(trials, options.directory, options.seconds, 1 if options.short else 2):
        known = references.get(trial.against or f"{trial.scene}.reference")
        verdict = judge(trial, formed, known, bands[trial.scene] if trial.same == "other mesh" else SAME_MESH)
        if trial.factor in ("reference", "edge") and verdict.word != "stands":
            sys.exit(f"{trial.name} has to stand: {verdict.why or formed.said}")
        verdicts.append((trial, verdict))
        show(trial, verdict)
        if formed.code == 0:
            results = Results(formed.directory)
            references[trial.name] = results
            if trial.factor == "edge":
                bands[trial.scene] = other_mesh(results, known)
            if trial.factor == "reference":
                references[f"{trial.scene}.reference"] = results
    wrong = [trial.name for trial, verdict in verdicts if verdict.word == "WRONG"]
    if not options.short and not options.only:
        if not page.write(verdicts, references, bands):
            wrong.append("a trend")
        print(f"wrote {page.PAGE.relative_to(ROOT)}")
    print(f"{len(verdicts)} trials, {len(wrong)} wrong" + (": " + ", ".join(wrong) if wrong else ""))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
