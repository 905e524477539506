"""study PROGRAM STUDY.toml [options]: what `towform study` starts."""

import argparse
import importlib.util
import sys
from pathlib import Path

from .problems import DONE, FILES, Refused

# Module: the Debian package that has it; all are in scripts/packages-study.
NEEDED = {"numpy": "python3-numpy", "h5py": "python3-h5py", "scipy": "python3-scipy", "matplotlib": "python3-matplotlib",
          "jinja2": "python3-jinja2", "snakemake": "snakemake"}
NEEDED_TO_OPTIMISE = {"optuna": "python3-optuna"}


def require(modules, what):
    missing = [package for module, package in modules.items() if importlib.util.find_spec(module) is None]
    if missing:
        raise Refused(f"towform: {what} needs Debian packages that are not there: "
                      f"apt-get install --no-install-recommends {' '.join(missing)}", FILES)


def parsed(words):
    parser = argparse.ArgumentParser(prog="study")
    parser.add_argument("program", type=Path)
    parser.add_argument("study", type=Path)
    parser.add_argument("--output", type=Path)
    parser.add_argument("--profile")
    parser.add_argument("--jobs", type=int, default=0)
    for flag in ("--force", "--retry-failed", "--dry-run", "--quiet"):
        parser.add_argument(flag, action="store_true")
    return parser.parse_args(words)


def main(words):
    arguments = parsed(words)
    try:
        require(NEEDED, "towform study")
        from .campaign import Campaign
        from .study_file import read_study
        study = read_study(arguments.program, arguments.study)
        if study.optimise:
            require(NEEDED_TO_OPTIMISE, "[optimise]")
        directory = arguments.output or Path("out") / arguments.study.stem
        campaign = Campaign(study, arguments, directory.resolve())
        return campaign.plan() if arguments.dry_run else campaign.go()
    except Refused as refused:
        print("\n".join(refused.messages), file=sys.stderr)
        return refused.code
    except BrokenPipeError:
        return DONE


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
