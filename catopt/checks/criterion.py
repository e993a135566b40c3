"""One criterion: what is checked, against which number, for what, and where that comes from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.catalogue.figure import Confidence
from catopt.checks.kinds import CheckKind
from catopt.model.line_kind import LINE_KINDS, LineKind
from catopt.model.load import LoadCaseKind
from catopt.records import Counted, Record
from catopt.words import Message

State = Literal["intact", "one_line_out", "transient"]
STATES: tuple[State, ...] = get_args(State)
"""Of a mooring: whole, at rest anew without a line, and on the way there after it parted."""

Analysis = Literal["quasi-static", "dynamic"]
ANALYSES: tuple[Analysis, ...] = get_args(Analysis)
"""Tensions of lines at rest, or of lines run in time."""

StrengthKind = Literal["MBL", "proof_load"]
STRENGTHS: tuple[StrengthKind, ...] = get_args(StrengthKind)

LOAD_KINDS: tuple[LoadCaseKind, ...] = get_args(LoadCaseKind)


@dataclass(frozen=True)
class Place(Record):
    """Of which line a check is, and in which state of the mooring."""

    DOCUMENT = "state line missing=missing_line"

    state: State = "intact"
    """Only of a body: its state."""
    line: Counted | None = None
    """Only of a body: the line; None where the check is of the body."""
    missing: Counted | None = None
    """Only of a body: the line that is out; None where all are there."""
    segment: int | None = None
    """Of a tension: from 1 at the anchor."""


@dataclass(frozen=True)
class CheckSource:
    """Where a criterion comes from."""

    code: str
    """Name of the profile; user for the case's own numbers, anchor for the factor of its anchor
    where the case says what that is from."""
    document: str = ""
    clause: str = ""
    """What to open, and where in it; empty for the case's own numbers, which are then those of the
    case file."""
    confidence: Confidence | None = None
    """A read in the document itself; B in two independent secondary sources, or in one and checked
    by numbers; C in one secondary source; R recalled, read in no document; None for the case's own
    numbers."""

    @property
    def text(self) -> str:
        """Document, place and confidence in words; case file for the case's own numbers."""
        if self.confidence is None:
            return self.document or Message("checks.case_file")
        where = ", ".join(part for part in (self.document, self.clause) if part)
        return f"{where} [{self.confidence}]"


USER = CheckSource("user")
"""A number of the case file."""


@dataclass(frozen=True)
class Criterion:
    """A limit or a factor that a line has to keep."""

    check: CheckKind
    value: float
    """The factor of a tension, a sliding or a holding check; else the limit in SI."""
    source: CheckSource
    of: StrengthKind | Literal[""] = ""
    """Of a tension check: the strength that is divided by the factor."""
    part: float = 1.0
    """Of a tension check: characteristic strength over that of the catalogue or certificate."""
    mean_factor: float | None = None
    """Of a tension in motion: the factor on its mean, where `value` is that on what is added to the
    mean; None where `value` is on the whole."""
    lines: tuple[LineKind, ...] = LINE_KINDS
    kinds: tuple[LoadCaseKind, ...] = LOAD_KINDS
    states: tuple[State, ...] = STATES
    """For which kinds of line (of a tension check), load cases and states of the mooring it is."""
    analysis: Analysis = "quasi-static"
    """Of a tension check: from which analysis its tensions are."""
    note: str = ""
    """What else the document says of it."""

    @property
    def takes_tests(self) -> bool:
        """Whether statistics of break tests take the place of a part of the MBL."""
        return self.of == "MBL" and self.part != 1.0

    def is_for(self, line: LineKind | None) -> bool:
        """Whether it is for a kind of line; for one whose kind is not known every criterion is."""
        return line is None or line in self.lines
