"""Numbers with units as they stand in a study file. What a unit means is for towform to say: within a study a parameter
keeps the unit it was given in. Only places and times of responses are turned into SI here."""

import json
import math
import re

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*\Z")
_TO_SI = {"length": {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}, "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0}}


def split(value):
    """(number, unit) of 35, "35 N" or "35"; None of anything else, NaN and infinity included."""
    if isinstance(value, bool):
        return None
    if isinstance(value, (int, float)):
        return (float(value), "") if math.isfinite(value) else None
    match = _QUANTITY.match(value) if isinstance(value, str) else None
    if match is None or not math.isfinite(float(match[1])):
        return None
    return float(match[1]), match[2]


def in_si(value, dimension):
    """A length or time in SI. Raises ValueError saying what it should have been."""
    parts = split(value)
    units = _TO_SI[dimension]
    if parts is None or (parts[1] and parts[1] not in units):
        raise ValueError(f"is not a {dimension} (a number with {', '.join(units)})")
    return parts[0] * units.get(parts[1], 1.0)


def shown(number):
    """A number in twelve digits, whole ones without a point."""
    return f"{number:.12g}"


def as_toml(value):
    """A scalar or list as TOML, for --set. JSON writes what TOML reads."""
    if isinstance(value, float):
        return shown(value)
    if isinstance(value, list):
        return "[" + ", ".join(as_toml(item) for item in value) + "]"
    return json.dumps(value, ensure_ascii=False)


def with_unit(number, unit):
    """What --set takes for a number in a unit."""
    return json.dumps(f"{shown(number)} {unit}", ensure_ascii=False) if unit else shown(number)
