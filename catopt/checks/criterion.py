"""One criterion: what is checked, against which number, and where that comes from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.checks.line_kind import LINE_KINDS, LineKind
from catopt.checks.result import CheckSource
from catopt.checks.state import STATES, Analysis, State
from catopt.model.load_case import LoadCaseKind

CheckKind = Literal[
    "tension",
    "uplift_angle",
    "uplift_force",
    "grounded_length",
    "span",
    "buoyancy",
    "sliding",
    "holding",
    "equilibrium",
]
CHECK_KINDS: tuple[CheckKind, ...] = get_args(CheckKind)
"""In the order in which a report has them."""

StrengthKind = Literal["MBL", "proof_load"]
STRENGTHS: tuple[StrengthKind, ...] = get_args(StrengthKind)

LOAD_KINDS: tuple[LoadCaseKind, ...] = get_args(LoadCaseKind)
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
    part : float
        Of a tension check: characteristic strength over that of the catalogue or certificate.
    mean_factor : float or None
        Of a tension in motion: the factor on its mean, where `value` is that on what is added to
        the mean; None where `value` is on the whole.
    lines : tuple of str
        Of a tension check: kinds of line that it is for.
    kinds : tuple of str
        Kinds of load case that it is for.
    states : tuple of str
        States of the mooring that it is for.
    analysis : {"quasi-static", "dynamic"}
        Of a tension check: from which analysis its tensions are.
    note : str
        What else the document says of it.
    """

    check: CheckKind
    value: float
    source: CheckSource
    of: StrengthKind | Literal[""] = ""
    part: float = 1.0
    mean_factor: float | None = None
    lines: tuple[LineKind, ...] = LINE_KINDS
    kinds: tuple[LoadCaseKind, ...] = LOAD_KINDS
    states: tuple[State, ...] = STATES
    analysis: Analysis = "quasi-static"
    note: str = ""

    @property
    def takes_tests(self) -> bool:
        """Whether statistics of break tests take the place of a part of the MBL."""
        return self.of == "MBL" and self.part != 1.0

    def is_for(self, line: LineKind | None) -> bool:
        """Whether it is for a kind of line; for one whose kind is not known every criterion is."""
        return line is None or line in self.lines
