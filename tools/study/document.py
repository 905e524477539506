"""A study file as towform's own TOML reader sees it: values with the places they stand at."""

import json
import subprocess

from .problems import Refused, did_you_mean
from .study_keys import ANY, FORMULA, KEYS, LIST, NUMBER, POINT, QUANTITY, TABLE, TABLES, TEXT, WHOLE, YES_NO


def read_document(program, path):
    """The file's tree: {"value": …, "at": [line, column]}, "key_at" beside it within tables. Raises Refused."""
    done = subprocess.run([program, "study", "--places", path], capture_output=True, text=True)
    if done.returncode != 0:
        raise Refused(done.stderr.strip().splitlines(), done.returncode)
    return json.loads(done.stdout)


def plain(node):
    """The value of a node without its places."""
    value = node["value"]
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    return [plain(item) for item in value] if isinstance(value, list) else value


def _fits(kind, node):
    value = node["value"]
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    quantity = number or isinstance(value, str)
    match kind:
        case _ if kind == TEXT:
            return isinstance(value, str) and value != ""
        case _ if kind == NUMBER:
            return number
        case _ if kind == WHOLE:
            return isinstance(value, int) and not isinstance(value, bool)
        case _ if kind == YES_NO:
            return isinstance(value, bool)
        case _ if kind == QUANTITY:
            return quantity
        case _ if kind == LIST:
            return isinstance(value, list) and len(value) > 0
        case _ if kind == TABLE:
            return isinstance(value, dict)
        case _ if kind == TABLES:
            return isinstance(value, list) and len(value) > 0 and all(isinstance(item["value"], dict) for item in value)
        case _ if kind == POINT:
            return isinstance(value, list) and len(value) == 2 and all(_fits(QUANTITY, item) for item in value)
        case _ if kind == FORMULA:
            return _fits(TEXT, node) or (_fits(LIST, node) and all(_fits(TEXT, item) for item in value))
        case _ if kind == ANY:
            return value is not None
    return value in kind


def checked(table, node, problems):
    """The table's entries that are known and of their type, {key: node}; the rest becomes problems."""
    keys, good = KEYS[table], {}
    header = f"in [{table}]" if table else "in a study"
    for key, item in node["value"].items():
        if key not in keys:
            problems.add(item["key_at"], f"unknown key `{key}` {header}{did_you_mean(key, list(keys))}")
            continue
        kind = keys[key][0]
        if _fits(kind, item):
            good[key] = item
        elif isinstance(kind, tuple):
            problems.add(item["at"], f"{key}: {json.dumps(plain(item))} is not one of them{did_you_mean(plain(item), kind)}")
        else:
            head = f"[[{key}]]: must be" if kind == TABLES else f"{key}: must be"
            problems.add(item["at"], f"{head} {'a ' if kind in (TEXT, NUMBER, WHOLE, LIST, TABLE) else ''}{kind}"
                                     f"{', not empty' if kind in (TEXT, LIST, TABLES) else ''}")
    for key, (kind, required, _) in keys.items():
        if required and key not in node["value"]:
            what = f"[[{key}]]" if kind == TABLES else f"`{key}`"
            problems.add(node["at"] if table else None, f"{what} is missing {header}")
    return good
