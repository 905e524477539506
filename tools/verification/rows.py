"""A line of the verification's table."""

from dataclasses import dataclass


@dataclass
class Row:
    case: str
    what: str
    reference: str  # the exact or published answer, or what it is compared with
    ours: str
    error: str  # with its unit; empty when `ours` is itself the error
    limit: str  # empty for what is only reported
    command: str
    holds: bool | None = None  # None: no limit

    @property
    def verdict(self):
        return {None: "", True: "holds", False: "**misses**"}[self.holds]


def bounded(case, what, reference, ours, value, limit, unit, command, digits=3):
    """A row whose error [unit] has an upper limit."""
    return Row(case, what, reference, ours, f"{value:.{digits}g} {unit}", f"{limit:g} {unit}", command, bool(value <= limit))


def reported(case, what, reference, ours, command, error=""):
    """A row without a limit."""
    return Row(case, what, reference, ours, error, "", command)
