"""A study as read: values resolved, within their ranges, names that exist."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from . import quantity
from .formula import Formula


@dataclass
class Parameter:
    """What varies. A quantitative one has numbers in its unit, any other one has values as they are."""

    name: str
    label: str
    key: str  # of the case; empty for formulas only
    unit: str
    values: list = field(default_factory=list)  # numbers, or as given when not quantitative; empty for a range
    low: float = 0.0
    high: float = 0.0
    log: bool = False
    whole: bool = False
    quantitative: bool = True
    at: list = field(default_factory=list)  # place of the parameter
    value_places: list = field(default_factory=list)  # of every value, or of both ends of a range

    def sampled(self, u):
        """The value for u in [0, 1)."""
        if self.values:
            return self.values[min(int(u * len(self.values)), len(self.values) - 1)]
        if self.log:
            value = self.low * (self.high / self.low) ** u
        else:
            value = self.low + (self.high - self.low) * u
        return self.rounded(min(max(value, self.low), self.high))

    def rounded(self, value):
        """To twelve digits, as it stands in the case; to whole numbers where they are wanted."""
        return float(round(value)) if self.whole else float(quantity.shown(value))

    def spaced(self, points):
        space = np.geomspace if self.log else np.linspace
        return list(dict.fromkeys(self.rounded(value) for value in space(self.low, self.high, points)))

    def setting(self, value):
        """What --set takes for a value."""
        return quantity.with_unit(value, self.unit) if self.quantitative else quantity.as_toml(value)

    def place_of(self, value):
        return self.value_places[self.values.index(value)] if self.values else self.value_places[0]

    def shown(self, value):
        if not self.quantitative:
            return value if isinstance(value, str) else quantity.as_toml(value)
        return f"{value:.6g} {self.unit}".strip()

    @property
    def heading(self):
        return f"{self.label} [{self.unit}]" if self.unit else self.label


@dataclass
class Derived:
    key: str
    formulas: list[Formula]
    is_list: bool
    unit: str
    at: list

    def setting(self, numbers):
        parts = [quantity.with_unit(formula.value(numbers), self.unit) for formula in self.formulas]
        return f"[{', '.join(parts)}]" if self.is_list else parts[0]


@dataclass
class Response:
    name: str
    label: str
    source: str  # summary, history, field or outline
    what: str  # key, column, dataset or "draw_in"
    unit: str
    reduce: str = ""
    time: float | None = None  # [s]
    component: int | None = None
    point: tuple | None = None  # [m]
    section: tuple | None = None  # ((x, y), (x, y)) [m]
    flat: bool = False
    goal: str = ""
    low: float | None = None
    high: float | None = None
    at: list = field(default_factory=list)

    @property
    def heading(self):
        return f"{self.label} [{self.unit}]" if self.unit else self.label

    def excess(self, value):
        """By how much a value is beyond its limits, over the limit; 0 within them."""
        over = [] if self.high is None else [(value - self.high) / (abs(self.high) or 1.0)]
        over += [] if self.low is None else [(self.low - value) / (abs(self.low) or 1.0)]
        return max([0.0, *over])

    def limits(self):
        parts = [f"{words} {limit:g}" for words, limit in (("at least", self.low), ("at most", self.high)) if limit is not None]
        return " and ".join(parts) + (f" {self.unit}" if parts and self.unit else "")


@dataclass
class Sampling:
    method: str
    runs: int = 0
    seed: int = 0


@dataclass
class Optimise:
    runs: int
    batch: int = 4
    initial: int = 0
    seed: int = 0


@dataclass
class Study:
    path: Path
    text: str
    title: str
    case: Path
    threads: int
    settings: list  # [(key, TOML, place)]
    parameters: list[Parameter]
    derived: list[Derived]
    responses: list[Response]
    sampling: Sampling | None
    optimise: Optimise | None

    @property
    def goals(self):
        return [response for response in self.responses if response.goal]

    def without_value(self, values):
        """[(Derived, why)] that have no value with these parameter values."""
        numbers, found = {p.name: values[p.name] for p in self.parameters if p.quantitative}, []
        for derived in self.derived:
            try:
                derived.setting(numbers)
            except ValueError as e:
                found.append((derived, str(e)))
        return found

    def overrides(self, values):
        """[(key=value, place in the study file)] of a run with these parameter values, {name: value}."""
        numbers = {p.name: values[p.name] for p in self.parameters if p.quantitative}
        words = [(f"{key}={toml}", at) for key, toml, at in self.settings]
        words += [(f"{p.key}={p.setting(values[p.name])}", p.place_of(values[p.name])) for p in self.parameters if p.key]
        return words + [(f"{d.key}={d.setting(numbers)}", d.at) for d in self.derived]
