"""Files of a study, written whole or not at all."""

import json
import os
from pathlib import Path


def replace_file(path, text):
    """Writes text (or bytes) beside the file and renames it; leaves a file alone that has this text already, and with it
    its time, by which Snakemake knows what is out of date."""
    path = Path(path)
    data = text if isinstance(text, bytes) else text.encode()
    if path.exists() and path.read_bytes() == data:
        return
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    with open(beside, "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    os.replace(beside, path)


def replace_json(path, data):
    replace_file(path, json.dumps(data, indent=1, ensure_ascii=False) + "\n")


def read_json(path):
    """None when the file is not there."""
    try:
        return json.loads(Path(path).read_text())
    except FileNotFoundError:
        return None
