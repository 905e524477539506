"""docs/verification.md: written from the rows, and read back to be checked."""

import hashlib
import re
from dataclasses import dataclass

from verification.rows import Row
from verification.runs import ROOT

PAGE = ROOT / "docs/verification.md"
COLUMNS = ("case", "what", "exact, published or compared", "ours", "error", "limit", "", "command")
HEAD = """# Verification

What the program computes beside exact answers, published ones, and its own other answers. Written by `scripts/verify`,
which forms every case named here and fails when a row with a limit misses it; the test `verification_page` forms the
quick ones again and compares. Commands are as typed with `build/release` in the path. The material is the card
`gf_pp_twill` unless a row says otherwise: typical values, not measured ones.
"""


@dataclass
class Section:
    title: str
    text: str  # what the reader should know before the table
    figures: tuple  # (file under docs/images, caption)
    rows: list


def write(sections):
    lines = [HEAD]
    cases = sorted({case for s in sections for row in s.rows for case in re.findall(r"cases/\S+\.toml", row.command)})
    for section in sections:
        lines += [f"## {section.title}", "", section.text.strip(), "", table_line(COLUMNS),
                  table_line("---" for _ in COLUMNS)]
        lines += [table_line((r.case, r.what, r.reference, r.ours, r.error, r.limit, r.verdict, f"`{r.command}`"))
                  for r in section.rows]
        for image, caption in section.figures:
            lines += ["", f"![{caption}](images/{image})", "", caption]
        lines.append("")
    lines += ["<!-- The cases as they were when this was measured:"]
    lines += [f"{case} {digest(case)}" for case in cases]
    lines += ["-->", ""]
    PAGE.write_text("\n".join(lines))


def table_line(cells):
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def digest(case):
    return hashlib.sha256((ROOT / case).read_bytes()).hexdigest()[:16]


def read():
    """Rows of the page as it stands, by (case, what, command), and the digests of its cases."""
    text = PAGE.read_text()
    rows = {}
    for line in text.splitlines():
        cells = [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) == len(COLUMNS) and cells[-1].startswith("`"):
            row = Row(*cells[:6], cells[7].strip("`"), {"holds": True, "**misses**": False}.get(cells[6]))
            rows[row.case, row.what, row.reference, row.command] = row
    return rows, dict(re.findall(r"^(cases/\S+\.toml) ([0-9a-f]{16})$", text, re.MULTILINE))


def numbers(text):
    return [float(n) for n in re.findall(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?", text)]


def alike(first, second):
    """The same words; numbers within 2 % or the last digits of a small one: other processors round otherwise."""
    a, b = numbers(first), numbers(second)
    return len(a) == len(b) and all(abs(x - y) <= 0.02 * max(abs(x), abs(y)) + 1e-3 for x, y in zip(a, b))


def compare(rows):
    """What is wrong with the page, in words: rows that it lacks or shows otherwise, cases that have changed since."""
    known, digests = read()
    wrong = [f"{case} has changed since the page was written" for case, seen in digests.items()
             if not (ROOT / case).exists() or digest(case) != seen]
    for row in rows:
        there = known.get((row.case, row.what, row.reference, row.command))
        if there is None:
            there = next((r for r in known.values() if (r.case, r.what, r.command) == (row.case, row.what, row.command)
                          and alike(r.reference, row.reference)), None)
        if there is None:
            wrong.append(f"the page lacks: {row.case}, {row.what}")
        elif row.holds is False:
            wrong.append(f"{row.case}, {row.what}: {row.error or row.ours}, limit {row.limit}")
        elif not (alike(there.ours, row.ours) and alike(there.error, row.error)):
            wrong.append(f"{row.case}, {row.what}: the page has {there.ours}, {there.error}; now {row.ours}, {row.error}")
    if not known:
        wrong.append("the page has no table")
    return wrong
