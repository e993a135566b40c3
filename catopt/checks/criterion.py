"""One criterion: what is checked, against which number, and where that comes from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.checks.line_kind import LINE_KINDS, LineKind
from catopt.checks.result import CheckSource
from catopt.model.load_case import LoadCaseKind

__all__ = ["CHECK_KINDS", "STATES", "STRENGTHS", "CheckKind", "Criterion", "StrengthKind"]

CheckKind = Literal[
    "tension",
    "uplift_angle",
    "uplift_force",
    "grounded_length",
    "offset",
    "buoyancy",
    "sliding",
    "holding",
]
CHECK_KINDS: tuple[CheckKind, ...] = get_args(CheckKind)
"""In the order in which a report has them."""

StrengthKind = Literal["MBL", "proof_load"]
STRENGTHS: tuple[StrengthKind, ...] = get_args(StrengthKind)

STATES: tuple[LoadCaseKind, ...] = get_args(LoadCaseKind)
"""Kinds of load case."""


@dataclass(frozen=True)
class Criterion:
    """A limit or a factor that a line has to keep.

    Attributes
    ----------
    check : str
        What is checked, one of `CHECK_KINDS`.
    value : float
        The factor of a tension, a sliding or a holding check; else the limit in SI.
    source : CheckSource
        Where it comes from.
    of : {"MBL", "proof_load", ""}
        Of a tension check: the strength that is divided by the factor.
    lines : tuple of str
        Of a tension check: kinds of line that it is for.
    states : tuple of str
        Kinds of load case that it is for.
    note : str
        What else the document says of it.
    """

    check: CheckKind
    value: float
    source: CheckSource
    of: StrengthKind | Literal[""] = ""
    lines: tuple[LineKind, ...] = LINE_KINDS
    states: tuple[LoadCaseKind, ...] = STATES
    note: str = ""

    def is_for(self, line: LineKind | None) -> bool:
        """Whether it is for a kind of line; for one whose kind is not known every criterion is."""
        return line is None or line in self.lines
