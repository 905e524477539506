"""The responses of a run from its directory. Everything of towform_results is used here and in sheet.py only."""

import numpy as np

from towform_results import Results

from . import sheet


class Missing(Exception):
    """A response that this run does not have, and why."""


def evaluate(responses, directory):
    """({name: number or None}, {name: why there is none})."""
    values, reasons = {}, {}
    try:
        results = Results(directory)
    except (OSError, KeyError) as e:
        return {r.name: None for r in responses}, {r.name: f"no results: {e}" for r in responses}
    for response in responses:
        try:
            value = float(_SOURCES[response.source](results, response))
            if not np.isfinite(value):
                raise Missing("is not a finite number")
            values[response.name] = value
        except (Missing, KeyError, AttributeError, OSError, ValueError, IndexError) as e:
            values[response.name], reasons[response.name] = None, str(e)
    return values, reasons


def reduced(values, how, weights=None):
    """One number of many: max, min, mean, largest in magnitude, spread, last or a percentile p1 … p99."""
    if len(values) == 0:
        raise Missing("no sheet there")
    match how:
        case "max" | "min":
            return getattr(values, how)()
        case "mean":
            return np.average(values, weights=weights)
        case "largest":
            return values[np.abs(values).argmax()]
        case "spread":
            return np.ptp(values)
        case "last":
            return values[-1]
    return np.percentile(values, float(how[1:]))


def _summary(results, response):
    value = results.summary
    for part in response.what.split("."):
        value = value[part]
    if value is None:
        raise Missing("is not a finite number")
    return value


def _history(results, response):
    column = results.history[response.what]
    if response.time is not None:
        return column[np.abs(results.history["time_s"] - response.time).argmin()]
    return reduced(column, response.reduce)


def _frame(results, response):
    return results.frame(-1) if response.time is None else results.at(response.time)


def _field(results, response):
    frame = _frame(results, response)
    values = getattr(frame, response.what)
    if response.component is not None:
        values = values[:, response.component]
    if response.point is not None:
        value = sheet.values_at(results, frame, values, [response.point], response.flat)[0]
        if np.isnan(value):
            raise Missing("no sheet at the point")
        return value
    if response.section is not None:
        return reduced(sheet.along(results, frame, values, response.section, response.flat), response.reduce)
    return reduced(values, response.reduce, results.areas if len(values) == len(results.triangles) else None)


def _outline(results, response):
    return reduced(sheet.draw_in(results, _frame(results, response)), response.reduce)


_SOURCES = {"summary": _summary, "history": _history, "field": _field, "outline": _outline}
