"""The kinds of check: in what each is measured, and demand beside capacity of a line at rest.

A new kind is an entry in `CheckKind`, its function and its row in `OF_LINE` here, and its words in
both languages in ``catopt/words/texts/checks.toml``; where its number is the case's own, the row
says which.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Literal, NamedTuple, Protocol, get_args

from catopt.checks.excess import (
    grounded_excess,
    holding_excess,
    ratio_excess,
    uplift_angle_excess,
    uplift_force_excess,
)
from catopt.model.anchor import sinker_needed
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.model import Anchor, Buoy, CatalogueChoice, Checks, Service

CheckKind = Literal[
    "tension",
    "uplift_angle",
    "uplift_force",
    "grounded_length",
    "span",
    "buoyancy",
    "sliding",
    "slide",
    "holding",
    "equilibrium",
]
CHECK_KINDS: tuple[CheckKind, ...] = get_args(CheckKind)
"""In the order in which a report has them."""


class Demand(NamedTuple):
    """Demand and capacity, SI, by how much the limit is overrun, and what to know of them."""

    demand: float
    capacity: float
    excess: float
    note: str = ""


class EndPull(Protocol):
    """Force of a line at one of its ends."""

    @property
    def horizontal_force(self) -> float:
        """N."""

    @property
    def vertical_force(self) -> float:
        """N."""

    @property
    def angle(self) -> float:
        """Rad."""


class Judged(Protocol):
    """What is measured of a line: at rest, or what it came to in motion."""

    @property
    def anchor(self) -> EndPull:
        """Pull on what holds it."""

    @property
    def fairlead(self) -> EndPull:
        """Pull at its upper end."""

    @property
    def grounded_length(self) -> float:
        """Unstretched, m."""

    @property
    def span(self) -> float:
        """Horizontal distance of its ends, m."""


class Asks(Protocol):
    """What asks lines to keep something: a case, or lines between points."""

    @property
    def checks(self) -> Checks:
        """Its own numbers, and the codes that it names."""

    @property
    def anchor(self) -> Anchor | None:
        """What holds a line."""

    @property
    def buoy(self) -> Buoy | None:
        """What carries its upper end."""

    @property
    def service(self) -> Service | None:
        """For how long, and how fast a line wears."""

    @property
    def catalogue(self) -> CatalogueChoice:
        """Where components come from."""


Measuring = Callable[[float, Judged, "Anchor | None"], Demand]
"""From a criterion's number, a line and what holds it."""


def _uplift_angle(limit: float, solution: Judged, _: Anchor | None) -> Demand:
    """Inclination of the line at the anchor <= limit, rad."""
    angle = solution.anchor.angle
    return Demand(angle, limit, uplift_angle_excess(angle, limit))


def _uplift_force(limit: float, solution: Judged, _: Anchor | None) -> Demand:
    """Vertical pull of the line on the anchor <= limit, N."""
    pull = solution.anchor
    excess = uplift_force_excess(pull.vertical_force, pull.horizontal_force, limit)
    return Demand(pull.vertical_force, limit, excess)


def _grounded_length(wanted: float, solution: Judged, _: Anchor | None) -> Demand:
    """Wanted length <= unstretched length that lies on the bed, m."""
    lies = solution.grounded_length
    return Demand(wanted, lies, grounded_excess(lies, wanted), Message("checks.wanted"))


def _span(limit: float, solution: Judged, _: Anchor | None) -> Demand:
    """Span <= limit, m."""
    return Demand(solution.span, limit, ratio_excess(solution.span, limit))


def _buoyancy(reserve: float, solution: Judged, _: Anchor | None) -> Demand:
    """Vertical pull at the fairlead <= reserve buoyancy, N."""
    vertical = solution.fairlead.vertical_force
    return Demand(vertical, reserve, ratio_excess(vertical, reserve))


def _sliding(factor: float, solution: Judged, anchor: Anchor | None) -> Demand:
    """Weight that the sinker needs, V + SF H / mu <= its weight in water, N."""
    assert anchor is not None
    assert anchor.submerged_weight is not None
    assert anchor.friction is not None
    pull, weight = solution.anchor, anchor.submerged_weight
    needed = sinker_needed(pull.horizontal_force, pull.vertical_force, anchor.friction, factor)
    note = Message("checks.sinker_needed", factor=factor, friction=anchor.friction)
    return Demand(needed, weight, ratio_excess(needed, weight), note)


def _holding(factor: float, solution: Judged, anchor: Anchor | None) -> Demand:
    """Horizontal pull on the drag anchor <= ultimate holding capacity / factor, N."""
    assert anchor is not None
    assert anchor.holding_capacity is not None
    pull, capacity = solution.anchor.horizontal_force, anchor.holding_capacity
    note = Message("checks.capacity", capacity=Measure("tension", capacity), factor=factor)
    return Demand(pull, capacity / factor, holding_excess(pull, factor, capacity), note)


class LineCheck(NamedTuple):
    """A check of the line as a whole."""

    quantity: str
    """Of its demand and its capacity, a key of `catopt.quantities.QUANTITIES`."""
    measure: Measuring
    own: Callable[[Asks], float | None] | None = None
    """The limit that a case gives itself, None where it gives none."""
    is_factor: bool = False


def _longest_span(case: Asks) -> float | None:
    checks = case.checks
    return checks.max_span if checks.max_offset is None else checks.max_offset


def _reserve(case: Asks) -> float | None:
    return None if case.buoy is None else case.buoy.reserve_buoyancy


OF_LINE: Mapping[CheckKind, LineCheck] = MappingProxyType(
    {
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
        ),
        "span": LineCheck("span", _span, _longest_span),
        "buoyancy": LineCheck("vertical_force", _buoyancy, _reserve),
        "sliding": LineCheck("point_weight", _sliding, is_factor=True),
        "holding": LineCheck("horizontal_force", _holding, is_factor=True),
    }
)
"""Every check of a line but that of its tensions."""

_OTHERS = {
    "tension": QUANTITIES["tension"],
    "slide": QUANTITIES["length"],
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


def limit_quantity(kind: CheckKind) -> Quantity:
    """Return what the number of a criterion is: a factor, or a limit."""
    row = OF_LINE.get(kind)
    if kind == "slide":
        return QUANTITY_OF[kind]
    return QUANTITIES["safety_factor" if row is None or row.is_factor else row.quantity]
