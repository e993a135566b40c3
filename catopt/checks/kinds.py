"""The kinds of check: demand beside capacity, by how much a limit is overrun; a criterion."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, Literal, NamedTuple, TypeAlias, get_args

from catopt.catalogue.components import Confidence
from catopt.compiled import inlined
from catopt.model.anchor import sinker_needed
from catopt.model.line import LINE_KINDS, LineKind
from catopt.model.load import LoadCaseKind
from catopt.quantities import QUANTITIES, Quantity
from catopt.records import Counted, Record
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.case import Carried
    from catopt.model import Anchor, Case
    from catopt.model.network import Network

    Judged: TypeAlias = Solution | Carried
    """A line of which something is measured: at rest, or what it came to in motion."""

__all__ = [
    "ROUNDING",
    "grounded_exceedance",
    "holding_exceedance",
    "least_tension_exceedance",
    "ratio_exceedance",
    "uplift_angle_exceedance",
    "uplift_force_exceedance",
]

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


ROUNDING: Final = 1e-9
"""What rounding may add to an excess: a thousand times the error of a solved line."""


@inlined
def ratio_exceedance(demand: float, capacity: float) -> float:
    """Demand beside capacity, in one unit.

    Of a segment's tension and strength over factor, span and limit, pull at the fairlead and
    reserve buoyancy, the weight that a sinker needs (`sinker_needed` of model) and its own.
    """
    return demand / capacity - 1.0


@inlined
def uplift_angle_exceedance(angle: float, limit: float) -> float:
    """Inclination at the anchor beside the largest allowed one; rad, and the excess per rad."""
    return angle - limit


@inlined
def uplift_force_exceedance(vertical: float, horizontal: float, limit: float) -> float:
    """Vertical pull at the anchor beside the largest allowed one; N.

    Measured by the limit or by the horizontal force, whichever is larger, for the limit may be 0.
    No limit is an infinite one.
    """
    if math.isinf(limit):
        return -1.0
    scale = max(limit, horizontal)
    return (vertical - limit) / scale if scale > 0.0 else vertical


@inlined
def grounded_exceedance(grounded: float, wanted: float) -> float:
    """Length on the bed short of what is required, by what is required; m. 0 wants nothing."""
    if wanted == 0.0:
        return -1.0
    return 1.0 - grounded / wanted


@inlined
def holding_exceedance(horizontal: float, factor: float, capacity: float) -> float:
    """Pull on a drag anchor times its factor beside its ultimate holding capacity; N."""
    return factor * horizontal / capacity - 1.0


@inlined
def least_tension_exceedance(tension: float, wanted: float) -> float:
    """Tension of a line short of the least that is required, by that; N. 0 wants nothing."""
    if wanted == 0.0:
        return -1.0
    return 1.0 - tension / wanted


CheckKind = Literal[
    "tension",
    "least_tension",
    "uplift_angle",
    "uplift_force",
    "grounded_length",
    "span",
    "buoyancy",
    "sliding",
    "slide",
    "heel",
    "holding",
    "equilibrium",
]
CHECK_KINDS: tuple[CheckKind, ...] = get_args(CheckKind)
"""In the order in which a report has them."""


class Demand(NamedTuple):
    """Demand and capacity, SI, by how much the limit is overrun, and what to know of them."""

    demand: float
    capacity: float
    exceedance: float
    note: str = ""


def _uplift_angle(limit: float, solution: Judged, _: Anchor | None) -> Demand:
    """Inclination of the line at the anchor <= limit, rad."""
    angle = solution.anchor.angle
    return Demand(angle, limit, uplift_angle_exceedance(angle, limit))


def _uplift_force(limit: float, solution: Judged, _: Anchor | None) -> Demand:
    """Vertical pull of the line on the anchor <= limit, N."""
    pull = solution.anchor
    exceedance = uplift_force_exceedance(pull.vertical_force, pull.horizontal_force, limit)
    return Demand(pull.vertical_force, limit, exceedance)


def _least_tension(wanted: float, solution: Judged, _: Anchor | None) -> Demand:
    """Wanted tension <= tension at the fairlead, N."""
    there = solution.least_tension
    exceedance = least_tension_exceedance(there, wanted)
    return Demand(wanted, there, exceedance, Message("checks.wanted_tension"))


def _grounded_length(wanted: float, solution: Judged, _: Anchor | None) -> Demand:
    """Wanted length <= unstretched length that lies on the bed, m."""
    lies = solution.grounded_length
    return Demand(wanted, lies, grounded_exceedance(lies, wanted), Message("checks.wanted"))


def _span(limit: float, solution: Judged, _: Anchor | None) -> Demand:
    """Span <= limit, m."""
    return Demand(solution.span, limit, ratio_exceedance(solution.span, limit))


def _buoyancy(reserve: float, solution: Judged, _: Anchor | None) -> Demand:
    """Vertical pull at the fairlead <= reserve buoyancy, N."""
    vertical = solution.fairlead.vertical_force
    return Demand(vertical, reserve, ratio_exceedance(vertical, reserve))


def _sliding(factor: float, solution: Judged, anchor: Anchor | None) -> Demand:
    """Weight that the sinker needs, V + SF H / mu <= its weight in water, N.

    On clay SF H <= what its base holds, too: the one that is nearer to its limit is said.
    """
    assert anchor is not None
    assert anchor.submerged_weight is not None
    assert anchor.friction is not None
    pull, weight = solution.anchor, anchor.submerged_weight
    needed = sinker_needed(pull.horizontal_force, pull.vertical_force, anchor.friction, factor)
    note = Message("checks.sinker_needed", factor=factor, friction=anchor.friction)
    by_weight = Demand(needed, weight, ratio_exceedance(needed, weight), note)
    base, pushed = anchor.base_holding, factor * pull.horizontal_force
    if base is None or ratio_exceedance(pushed, base) <= by_weight.exceedance:
        return by_weight
    return Demand(
        pushed, base, ratio_exceedance(pushed, base), Message("checks.base_holds", factor=factor)
    )


def _holding(factor: float, solution: Judged, anchor: Anchor | None) -> Demand:
    """Horizontal pull on the drag anchor <= ultimate holding capacity / factor, N."""
    assert anchor is not None
    assert anchor.holding_capacity is not None
    pull, capacity = solution.anchor.horizontal_force, anchor.holding_capacity
    note = Message("checks.capacity", capacity=Measure("tension", capacity), factor=factor)
    return Demand(pull, capacity / factor, holding_exceedance(pull, factor, capacity), note)


class LineCheck(NamedTuple):
    """A check of the line as a whole."""

    quantity: str
    """Of its demand and its capacity, a key of `catopt.quantities.QUANTITIES`."""
    measure: Callable[[float, Judged, Anchor | None], Demand]
    """From a criterion's number, a line and what holds it."""
    own: Callable[[Case | Network], float | None] | None = None
    """The limit that a case gives itself, None where it gives none."""
    is_factor: bool = False
    is_wanted: bool = False
    """Whether its demand is the least that is required of the line, not what the line asks for."""


OF_LINE: Mapping[CheckKind, LineCheck] = MappingProxyType(
    {
        "least_tension": LineCheck(
            "tension",
            _least_tension,
            lambda case: case.checks.min_tension or None,
            is_wanted=True,
        ),
        "uplift_angle": LineCheck(
            "angle", _uplift_angle, lambda case: case.checks.max_anchor_uplift_angle
        ),
        "uplift_force": LineCheck(
            "vertical_force", _uplift_force, lambda case: case.checks.max_anchor_uplift_force
        ),
        "grounded_length": LineCheck(
            "grounded_length",
            _grounded_length,
            lambda case: case.checks.min_grounded_length or None,
            is_wanted=True,
        ),
        "span": LineCheck(
            "span",
            _span,
            lambda case: (
                case.checks.max_span if case.checks.max_offset is None else case.checks.max_offset
            ),
        ),
        "buoyancy": LineCheck(
            "vertical_force",
            _buoyancy,
            lambda case: None if case.buoy is None else case.buoy.reserve_buoyancy,
        ),
        "sliding": LineCheck("point_weight", _sliding, is_factor=True),
        "holding": LineCheck("horizontal_force", _holding, is_factor=True),
    }
)
"""Every check of a line but that of its tensions."""

_OTHERS = {
    "tension": QUANTITIES["tension"],
    "slide": QUANTITIES["length"],
    "heel": QUANTITIES["angle"],
    "equilibrium": Quantity("lines", "", "", "-", "-", 1.0, 0),
}

QUANTITY_OF: Mapping[str, Quantity] = MappingProxyType(
    {
        kind: QUANTITIES[OF_LINE[kind].quantity] if kind in OF_LINE else _OTHERS[kind]
        for kind in CHECK_KINDS
    }
)
"""What demand and capacity of each kind of check are."""

CHECK_UNITS = tuple(sorted({quantity.si_unit.strip("-") for quantity in QUANTITY_OF.values()}))
"""SI units of demand and capacity; that of a count is empty."""


def is_wanted(kind: CheckKind) -> bool:
    """Whether the demand of a check is the least that is required, not the largest that comes."""
    return kind in OF_LINE and OF_LINE[kind].is_wanted


def limit_quantity(kind: CheckKind) -> Quantity:
    """Return what the number of a criterion is: a factor, or a limit."""
    row = OF_LINE.get(kind)
    if kind in ("slide", "heel"):
        return QUANTITY_OF[kind]
    return QUANTITIES["safety_factor" if row is None or row.is_factor else row.quantity]
