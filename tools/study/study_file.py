"""Reads a study file and says everything that is wrong with it at once."""

import re
from pathlib import Path

from . import quantity
from .document import checked, plain, read_document
from .formula import FUNCTIONS, Formula
from .names import FIELD_UNITS, FIELDS, OUTLINE, SUMMARY, unit_of
from .problems import Problems, did_you_mean
from .study import Derived, Optimise, Parameter, Response, Sampling, Study
from .study_keys import REDUCTIONS

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
_SPREADING = ("latin_hypercube", "sobol", "saltelli")
MOST_RUNS = 100_000
RESERVED = ("run", "status", "exit_code", "reason", "directory", "wall_time_s", "attempts", "version")  # columns of the table


def read_study(program, path):
    """A Study, or Refused with every problem."""
    tree = read_document(program, str(path))
    problems = Problems(str(path))
    top = checked("", tree, problems)
    study = Study(path=Path(path), text=Path(path).read_text(), title=plain(top["title"]) if "title" in top else Path(path).stem,
                  case=Path(), threads=_whole(top, "threads", 1, 1, 1024, problems), settings=[], parameters=[], derived=[],
                  responses=[], sampling=None, optimise=None)
    if "case" in top:
        study.case = Path(path).parent / plain(top["case"])
        if not study.case.is_file():
            problems.add(top["case"]["at"], f"case: {study.case} is not there")
    if "set" in top:
        study.settings = _settings(top["set"], problems)
    study.optimise = _optimise(top, problems)
    study.sampling = _sampling(top, tree, problems)
    method = study.sampling.method if study.sampling else "optimise" if study.optimise else ""
    for node in top["parameter"]["value"] if "parameter" in top else []:
        _add(study.parameters, _parameter(node, method, problems), node, "parameter", problems)
    for node in top["derived"]["value"] if "derived" in top else []:
        _derived(node, study, problems)
    for node in top["response"]["value"] if "response" in top else []:
        _add(study.responses, _response(node, problems), node, "response", problems)
    _together(study, tree, problems)
    problems.refuse()
    if study.optimise and not study.optimise.initial:
        study.optimise.initial = min(4 * len(study.parameters), study.optimise.runs)
    return study


def _whole(table, key, default, low, high, problems):
    if key not in table:
        return default
    value = plain(table[key])
    if not low <= value <= high:
        problems.add(table[key]["at"], f"{key}: must be within {low} and {high}, not {value}")
        return default
    return value


def _settings(node, problems):
    """Nested tables become dotted keys."""
    found = []

    def flatten(prefix, table):
        for key, item in table["value"].items():
            if isinstance(item["value"], dict):
                flatten(f"{prefix}{key}.", item)
            elif plain(item) is None:
                problems.add(item["at"], f"set: {prefix}{key} has no value that a case takes")
            else:
                found.append((prefix + key, quantity.as_toml(plain(item)), item["at"]))

    flatten("", node)
    return found


def _optimise(top, problems):
    if "optimise" not in top:
        return None
    table = checked("optimise", top["optimise"], problems)
    runs = _whole(table, "runs", 1, 1, MOST_RUNS, problems)
    return Optimise(runs, _whole(table, "batch", 4, 1, 1000, problems), _whole(table, "initial", 0, 1, max(runs, 1), problems),
                    _whole(table, "seed", 0, 0, 2**32 - 1, problems))


def _sampling(top, tree, problems):
    if "sampling" not in top:
        if "optimise" not in top:
            problems.add(None, "`sampling` is missing in a study: [sampling] method = … says which runs, [optimise] searches")
        return None
    if "optimise" in top:
        problems.add(tree["value"]["sampling"]["at"], "[sampling] and [optimise] exclude each other")
    table = checked("sampling", top["sampling"], problems)
    if "method" not in table:
        return None
    method = plain(table["method"])
    for key in ("runs", "seed"):
        if method not in _SPREADING and key in table:
            problems.add(table[key]["key_at"], f"{key}: has no meaning with method `{method}`, whose runs follow from the values")
    if method in _SPREADING and "runs" not in table:
        problems.add(table["method"]["at"], f"runs: is missing, which method `{method}` needs")
    return Sampling(method, _whole(table, "runs", 1, 1, MOST_RUNS, problems), _whole(table, "seed", 0, 0, 2**32 - 1, problems))


def _name_of(table, default, problems):
    name = plain(table["name"]) if "name" in table else default
    if "name" in table and not _NAME.match(name):
        problems.add(table["name"]["at"], f"name: `{name}` must be letters, digits and _, a letter first")
    elif name in RESERVED or name in FUNCTIONS:
        place = table["name"]["at"] if "name" in table else None
        problems.add(place, f"name: `{name}` means something else in tables and formulas")
    return name


def _add(entries, entry, node, what, problems):
    if entry is None:
        return
    if any(other.name == entry.name for other in entries):
        problems.add(node["value"].get("name", node)["at"], f"there are two {what}s `{entry.name}`")
    entries.append(entry)


def _parameter(node, method, problems):
    table = checked("parameter", node, problems)
    if "key" not in table and "name" not in table:
        problems.add(node["at"], "parameter: a key or a name is missing")
        return None
    key = plain(table["key"]) if "key" in table else ""
    name = _name_of(table, re.sub(r"[^A-Za-z0-9_]", "_", key), problems)
    label = plain(table["label"]) if "label" in table else name.replace("_", " ")
    parameter = Parameter(name, label, key, plain(table["unit"]) if "unit" in table else "", at=node["at"])
    ends = [k for k in ("min", "max") if k in table]
    if ("values" in table) == bool(ends) or len(ends) == 1:
        if not any(k in node["value"] for k in ("values", "min", "max")) or "values" in table or len(ends) == 1:
            problems.add(node["at"], f"parameter `{name}`: must have values = […], or min and max")
        return None
    if "values" in table:
        for k in ("scale", "points", "whole"):
            if k in table:
                problems.add(table[k]["key_at"], f"{k}: has no meaning for a parameter with values")
        _values(parameter, table["values"], problems)
    else:
        _range(parameter, table, method, problems)
    return parameter


def _quantities(parameter, nodes, problems):
    """Numbers of the nodes in one unit, or None; the parameter gets the unit."""
    parts = [quantity.split(plain(node)) for node in nodes]
    if any(part is None for part in parts):
        return None
    units = list(dict.fromkeys(unit for _, unit in parts))
    if parameter.unit and units != [""]:
        problems.add(nodes[0]["at"], f"parameter `{parameter.name}`: unit = \"{parameter.unit}\" is for plain numbers")
    elif len(units) > 1:
        problems.add(nodes[0]["at"], f"parameter `{parameter.name}`: all in one unit, please, not in "
                                     f"{' and '.join(unit or 'none' for unit in units)}")
    parameter.unit = parameter.unit or units[0]
    return [number for number, _ in parts]


def _values(parameter, node, problems):
    items = node["value"]
    if any(isinstance(item["value"], dict) or plain(item) is None for item in items):
        problems.add(node["at"], f"parameter `{parameter.name}`: values must be numbers, texts, true or false, or lists")
        return
    numbers = _quantities(parameter, items, problems)
    parameter.quantitative = numbers is not None
    parameter.values = [float(quantity.shown(n)) for n in numbers] if numbers is not None else [plain(item) for item in items]
    if numbers is None and parameter.unit:
        problems.add(items[0]["at"], f"parameter `{parameter.name}`: has a unit, but not all of its values are numbers")
    parameter.value_places = [item["at"] for item in items]


def _range(parameter, table, method, problems):
    ends = [table["min"], table["max"]]
    numbers = _quantities(parameter, ends, problems)
    parameter.value_places = [end["at"] for end in ends]
    if numbers is None:
        bad = next(end for end in ends if quantity.split(plain(end)) is None)
        problems.add(bad["at"], f"parameter `{parameter.name}`: {plain(bad)!r} is not a number, or a number with a unit")
        return
    parameter.low, parameter.high = numbers
    parameter.log = plain(table["scale"]) == "log" if "scale" in table else False
    parameter.whole = plain(table["whole"]) if "whole" in table else False
    if not parameter.low < parameter.high:
        problems.add(table["min"]["at"], f"parameter `{parameter.name}`: min must be less than max")
    elif parameter.log and parameter.low <= 0.0:
        problems.add(table["min"]["at"], f"parameter `{parameter.name}`: scale = \"log\" needs min > 0")
    elif method in ("grid", "list"):
        if "points" not in table:
            problems.add(table["min"]["at"], f"parameter `{parameter.name}`: a range in a {method} needs points, how many")
        else:
            parameter.values = parameter.spaced(_whole(table, "points", 2, 2, MOST_RUNS, problems))
            parameter.value_places = [table["min"]["at"]] * len(parameter.values)
    elif "points" in table:
        problems.add(table["points"]["key_at"], f"points: has no meaning with {method or 'this method'}, which chooses its own")


def _derived(node, study, problems):
    table = checked("derived", node, problems)
    if "key" not in table or "formula" not in table:
        return
    items = table["formula"]["value"] if isinstance(table["formula"]["value"], list) else [table["formula"]]
    names = [p.name for p in study.parameters if p.quantitative]
    formulas = []
    for item in items:
        try:
            formula = Formula(plain(item))
        except ValueError as e:
            problems.add(item["at"], f"formula: `{plain(item)}` {e}")
            continue
        for name in sorted(formula.names - set(names)):
            near = did_you_mean(name, names) if names else ""
            problems.add(item["at"], f"formula: `{name}` is not a parameter that is a number{near}")
        formulas.append(formula)
    study.derived.append(Derived(plain(table["key"]), formulas, isinstance(table["formula"]["value"], list),
                                 plain(table["unit"]) if "unit" in table else "", table["formula"]["at"]))


def _response(node, problems):
    table = checked("response", node, problems)
    if "name" not in table:
        return None
    name = _name_of(table, "", problems)
    sources = [source for source in ("summary", "history", "field", "outline") if source in table]
    if len(sources) != 1:
        problems.add(node["at"], f"response `{name}`: must have one of summary, history, field and outline")
        return None
    source = sources[0]
    what = plain(table[source])
    response = Response(name, plain(table["label"]) if "label" in table else name.replace("_", " "), source, what, "",
                        flat="on" in table and plain(table["on"]) == "flat", at=node["at"])
    known = {"summary": SUMMARY, "field": list(FIELDS), "outline": list(OUTLINE)}.get(source)
    if known is not None and what not in known:
        near = did_you_mean(what, known)
        problems.add(table[source]["at"], f"{source}: there is no `{what}`{near}")
        return response
    response.unit = FIELD_UNITS.get(what, "") if source == "field" else OUTLINE[what] if source == "outline" else unit_of(what)
    _reduction(response, table, problems)
    _places(response, table, problems)
    for key, name_of in (("min", "low"), ("max", "high")):
        if key in table:
            setattr(response, name_of, float(plain(table[key])))
    if response.low is not None and response.high is not None and response.low > response.high:
        problems.add(table["min"]["at"], f"response `{name}`: min must not be more than max")
    response.goal = plain(table["goal"]) if "goal" in table else ""
    return response


def _reduction(response, table, problems):
    source = response.source
    one = source == "summary" or "point" in table or (source == "history" and "time" in table)
    if "reduce" in table:
        word = plain(table["reduce"])
        percentile = re.fullmatch(r"p([1-9][0-9]?)", word)
        if one:
            problems.add(table["reduce"]["key_at"], f"reduce: response `{response.name}` is one value already")
        elif not percentile and word not in REDUCTIONS:
            problems.add(table["reduce"]["at"], f"reduce: there is no `{word}`{did_you_mean(word, [*REDUCTIONS, 'p99'])}")
        elif word == "last" and source != "history":
            problems.add(table["reduce"]["at"], "reduce: `last` is for a history")
        response.reduce = word
    elif source == "history" and not one:
        response.reduce = "last"
    elif not one:
        problems.add(table[source]["at"], f"reduce: is missing, which says how the values of `{response.what}` become one "
                                          f"({', '.join(word for word in REDUCTIONS if word != 'last')} or p99)")


def _places(response, table, problems):
    for key, sources in (("time", ("history", "field", "outline")), ("component", ("field",)), ("point", ("field",)),
                         ("from", ("field",)), ("to", ("field",)), ("on", ("field",))):
        if key in table and response.source not in sources:
            problems.add(table[key]["key_at"], f"{key}: has no meaning for a response from {response.source}")
            return
    try:
        if "time" in table:
            response.time = quantity.in_si(plain(table["time"]), "time")
        points = {key: tuple(quantity.in_si(plain(item), "length") for item in table[key]["value"])
                  for key in ("point", "from", "to") if key in table}
    except ValueError as e:
        problems.add(table["time"]["at"] if "time" in table else response.at, f"response `{response.name}`: a place or time {e}")
        return
    if "point" in points and len(points) > 1 or ("from" in points) != ("to" in points):
        problems.add(response.at, f"response `{response.name}`: must have a point, or from and to, or neither")
    elif "on" in table and not points:
        problems.add(table["on"]["key_at"], "on: has no meaning without a point or a section")
    response.point = points.get("point")
    response.section = (points["from"], points["to"]) if "from" in points and "to" in points else None
    components = FIELDS.get(response.what, ()) if response.source == "field" else ()
    if "component" in table:
        word = plain(table["component"])
        if word not in components:
            problems.add(table["component"]["at"], f"component: `{response.what}` has no `{word}`"
                         + (did_you_mean(word, components) if components else "; it is one value"))
        else:
            response.component = components.index(word)
    elif components:
        problems.add(response.at, f"component: is missing: `{response.what}` has {', '.join(components)}")


def _together(study, tree, problems):
    """What is wrong between entries that are each right."""
    keys = {}
    for key, at in [(p.key, p.at) for p in study.parameters if p.key] + [(d.key, d.at) for d in study.derived] + [
            (key, at) for key, _, at in study.settings]:
        if key in keys:
            problems.add(at, f"`{key}` is set twice, also in line {keys[key][0]}")
        keys[key] = at
    used = {name for d in study.derived for formula in d.formulas for name in formula.names}
    for p in study.parameters:
        if not p.key and p.name not in used:
            problems.add(p.at, f"parameter `{p.name}`: has no key and no formula uses it, so that nothing varies")
    for name in {p.name for p in study.parameters} & {r.name for r in study.responses}:
        at = next(r.at for r in study.responses if r.name == name)
        problems.add(at, f"response `{name}`: a parameter has that name")
    if study.sampling and study.sampling.method == "list":
        lengths = {p.name: len(p.values) for p in study.parameters if p.values}
        if len(set(lengths.values())) > 1:
            problems.add(tree["value"]["sampling"]["at"], "method `list` needs as many values of every parameter: "
                         + ", ".join(f"{name} has {count}" for name, count in lengths.items()))
    goals = [r for r in study.responses if r.goal]
    if study.optimise and len(goals) != 1:
        problems.add(tree["value"]["optimise"]["at"],
                     f"[optimise] needs one response with a goal, not {len(goals) or 'none'}; bound the others with min and max")
