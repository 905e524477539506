"""The case of every run: checked by towform, and written out whole so that it can be run alone."""

import concurrent.futures
import hashlib
import os
import re
import subprocess
import tomllib
from functools import lru_cache
from pathlib import Path

from .names import history_columns
from .problems import CASE_FILE, Problems, Refused, did_you_mean


@lru_cache(maxsize=None)
def _digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def fingerprint(text):
    """What makes two cases the same: their text, with what the files they name hold in place of where these are. Of a card
    its keys are in the text."""
    case = tomllib.loads(text)
    files = [entry["mesh"] for entry in case.get("tool", [])]
    files += [case["blank"]["mesh"]] if "mesh" in case.get("blank", {}) else []
    files += [case["material"]["curves"]] if "curves" in case.get("material", {}) else []
    for path in files:
        text = text.replace(path, _digest(path))
    return hashlib.sha256(re.sub(r"(?m)^card = .*\n", "", text).encode()).hexdigest()


def _resolve(program, study, values):
    """(text of the case, None) or (None, [(place or None, message)], code)."""
    overrides = study.overrides(values)
    words = [word for text, _ in overrides for word in ("--set", text)]
    done = subprocess.run([program, "check", study.case, "--resolved", *words], capture_output=True, text=True)
    if done.returncode == 0:
        return done.stdout, [], 0
    found = []
    for line in done.stderr.strip().splitlines():
        # What is wrong with an override is wrong where the study file has it.
        place = next(((at, line[len(f"--set {text}: "):]) for text, at in overrides if line.startswith(f"--set {text}: ")), None)
        if place is None and not line.startswith(str(study.case)):
            # A value that is not possible together with others names its key.
            place = next(((at, line) for text, at in overrides if line.startswith(text.split("=")[0] + ":")), None)
        found.append(place or (None, line))
    return None, found, done.returncode


def resolved_cases(program, study, rows, progress):
    """The text of every row's case. Raises Refused with everything that towform says against any of them."""
    problems, others, codes, texts = Problems(str(study.path)), [], set(), []
    for row in rows:
        for derived, message in study.without_value(row):
            shown = ", ".join(f"{p.name} = {p.shown(row[p.name])}" for p in study.parameters)
            problems.add(derived.at, f"formula: {derived.key} {message} ({shown})")
    problems.refuse()
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for number, (text, found, code) in enumerate(pool.map(lambda row: _resolve(program, study, row), rows), 1):
            progress(number, len(rows))
            texts.append(text)
            if code:
                codes.add(code)
            for place, message in found:
                if place is None:
                    others += [message] if message not in others else []
                else:
                    problems.add(place, message)
    if codes:
        messages = []
        try:
            problems.refuse()
        except Refused as refused:
            messages = refused.messages
        raise Refused(messages + others, CASE_FILE if CASE_FILE in codes else max(codes))
    _check_history(study, texts[0])
    return texts


def _check_history(study, text):
    """Columns of history.csv follow from the case's tools."""
    columns, problems = history_columns(tomllib.loads(text)), Problems(str(study.path))
    for response in study.responses:
        if response.source == "history" and response.what not in columns:
            problems.add(response.at, f"history: response `{response.name}`: there is no column `{response.what}`"
                         + did_you_mean(response.what, columns))
    problems.refuse()
