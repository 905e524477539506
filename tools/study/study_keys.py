"""Every key of a study file: its type and what it means. The table reads the file and makes its reference page."""

TEXT, NUMBER, WHOLE, YES_NO, ANY, LIST, TABLE, TABLES, QUANTITY, POINT, FORMULA = (
    "text", "number", "whole number", "true or false", "any value", "list", "table", "tables", "number, or text with a unit",
    "two lengths", "text, or a list of texts")
METHODS = ("grid", "list", "latin_hypercube", "sobol", "saltelli")
REDUCTIONS = ("last", "max", "min", "mean", "largest", "spread")

# Table ("" is the file itself): key: (type or choices, required, meaning)
KEYS = {
    "": {
        "title": (TEXT, False, "shown in the report"),
        "case": (TEXT, True, "base case, looked for beside the study file"),
        "threads": (WHOLE, False, "of one run; 1 by default, which gives the most runs an hour (docs/studies.md)"),
        "set": (TABLE, False, "keys of the case that every run has, beside those of the base case"),
        "sampling": (TABLE, False, "which runs; this or `optimise`"),
        "parameter": (TABLES, True, "what varies"),
        "derived": (TABLES, False, "keys of the case that follow from parameters"),
        "response": (TABLES, True, "what is wanted of every run"),
        "optimise": (TABLE, False, "search for the best run; this or `sampling`"),
    },
    "sampling": {
        "method": (METHODS, True, "`grid`: every value with every other; `list`: first values, second values, …; "
                                  "`latin_hypercube`, `sobol`: `runs` points that fill the ranges; `saltelli`: the sample of "
                                  "Sobol's sensitivity indices, runs x (parameters + 2)"),
        "runs": (WHOLE, False, "of the last three methods; powers of two fill ranges best with `sobol` and `saltelli`"),
        "seed": (WHOLE, False, "of the last three methods; 0 by default"),
    },
    "parameter": {
        "name": (TEXT, False, "in tables, formulas and plots: letters, digits and _; by default the key, with _ for dots"),
        "label": (TEXT, False, "on plots; by default the name"),
        "key": (TEXT, False, "key of the case that it sets, as for `--set`: blank.fibre_angle, tool.holder.force; without one "
                             "it is for formulas"),
        "unit": (TEXT, False, "of values that are plain numbers"),
        "values": (LIST, False, "its values, of any type that the key takes; this or a range"),
        "min": (QUANTITY, False, "low end of a range"),
        "max": (QUANTITY, False, "high end of a range, in the same unit"),
        "scale": (("linear", "log"), False, "how a range is filled; linear by default"),
        "points": (WHOLE, False, "of a range in a grid or list"),
        "whole": (YES_NO, False, "rounds a range's values to whole numbers"),
    },
    "derived": {
        "key": (TEXT, True, "key of the case"),
        "formula": (FORMULA, True, "arithmetic on the parameters' numbers, each in the parameter's unit; a list for a key that "
                                   "takes one"),
        "unit": (TEXT, False, "of the result"),
    },
    "response": {
        "name": (TEXT, True, "in tables and plots: letters, digits and _"),
        "label": (TEXT, False, "on plots; by default the name"),
        "summary": (TEXT, False, "a value of summary.json, as `draw_in_mm.corner`"),
        "history": (TEXT, False, "a column of history.csv"),
        "field": (TEXT, False, "a dataset of results.h5, over the whole sheet, or at a `point`, or along a section `from` … `to`"),
        "outline": (TEXT, False, "`draw_in`: how far the outline has moved inwards, square to the flat outline"),
        "reduce": (TEXT, False, "how many values become one: last, max, min, mean (of the whole sheet by area), largest (in "
                                "magnitude), spread (max - min), p1 … p99 (percentile)"),
        "time": (QUANTITY, False, "of the row or frame (the nearest); by default the last"),
        "component": (TEXT, False, "of a field that has several: x, y, z or warp, weft"),
        "point": (POINT, False, "in plan, of the uppermost layer where the sheet is folded"),
        "from": (POINT, False, "start of a section, in plan"),
        "to": (POINT, False, "end of a section, in plan"),
        "on": (("formed", "flat"), False, "the sheet on which point and section lie; formed by default"),
        "goal": (("minimise", "maximise"), False, "makes the response count for the best runs and the Pareto set"),
        "min": (NUMBER, False, "what a good run does not go below, in the response's unit"),
        "max": (NUMBER, False, "what a good run does not exceed"),
    },
    "optimise": {
        "runs": (WHOLE, True, "in all"),
        "batch": (WHOLE, False, "proposed at a time, and run side by side; 4 by default"),
        "initial": (WHOLE, False, "spread over the ranges before the search begins (Latin hypercube); 4 for each parameter by "
                                  "default"),
        "seed": (WHOLE, False, "0 by default"),
    },
}


def reference():
    """The keys as a Markdown page."""
    lines = ["# Keys of a study", "", "Made from `tools/study/study_keys.py`; `docs/studies.md` explains them.", ""]
    for table, keys in KEYS.items():
        name = f"[[{table}]]" if table in ("parameter", "derived", "response") else f"[{table}]"
        lines += [f"## {name}" if table else "## The file itself", "", "| key | type | meaning |", "|---|---|---|"]
        for key, (kind, required, meaning) in keys.items():
            kind = kind if isinstance(kind, str) else " \\| ".join(kind)
            lines.append(f"| `{key}` | {kind}{', required' if required else ''} | {meaning} |")
        lines.append("")
    return "\n".join(lines)


if __name__ == "__main__":
    print(reference(), end="")
