"""A buoy's chain by zone: where it works, how it wears, when it is renewed, and what that costs.

IALA's guideline names the parts of one line: ground chain that lies, the thrash section that is
lifted and laid down, riding chain that hangs. A zone here is such a part, between two arc lengths;
its wear and its size may be its own. The line that is recommended stays one chain.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final, Literal

from catopt.catalogue.practice import condition as kept_condition
from catopt.checks.case import check_case
from catopt.constants import YEAR
from catopt.errors import NoAnswerError
from catopt.loads.buoy_shape import BuoyShape
from catopt.model import Line, Segment
from catopt.model.kinds import Duration, Findings, Height, Length, NotNegative, WearRate
from catopt.model.service import WEAR_TABLES
from catopt.records import FromZero, Record
from catopt.sizing.line_choice import sold
from catopt.words import is_said

if TYPE_CHECKING:
    from catopt.sizing.buoy_request import BuoyRequest
    from catopt.sizing.result import Sizing

ZoneName = Literal["ground", "thrash", "riding"]

_MM_A_YEAR: Final = 1e-3 / YEAR
RECALLED_THRASH: Final = (1.0 * _MM_A_YEAR, 3.0 * _MM_A_YEAR)
"""m/s, wear of the thrash section of exposed buoys: recalled (R), read nowhere; it is printed and
decides nothing."""

_TABLE_OF: Final = {"ground": "bottom", "riding": "catenary"}
"""Zone of the published tables of wear; none has the thrash section."""

COSTED: Final = 20.0 * YEAR
"""s, over which the whole cost is counted."""

_OF_THE_SHORTEST: Final = 0.5
"""Part of the shortest life after which a chain is looked at: catopt's own rule."""


_MOST_WEAR: Final = 0.01 / YEAR * (1.0 + 1e-9)
"""10 mm a year, m/s, with what the conversion of a unit may add."""


@dataclass(frozen=True)
class UpkeepInputs:
    """What is known of a chain's wear by zone, and of prices."""

    thrash_wear: float | None = None  # m/s, of the thrash section; None: that of the whole chain
    chain_price: float | None = None  # USD a tonne
    sinker_price: float | None = None  # USD a tonne
    fittings_price: float | None = None  # USD, of a set
    visit_price: float | None = None  # USD, of laying, and of every renewal

    def __post_init__(self) -> None:
        found = Findings("UpkeepInputs")
        found.numbers(self, "m/s", "thrash_wear", at_least=0.0, at_most=_MOST_WEAR)
        keys = ("chain_price", "sinker_price", "fittings_price", "visit_price")
        found.numbers(self, "", *keys, at_least=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class ChainZone(Record):
    """A part of the chain, by how it works."""

    DOCUMENT = (
        "name start end diameter wear_rate lowest_rate highest_rate limit life shortest_life "
        "longest_life"
    )

    name: ZoneName
    """ground: it lies; thrash: it is lifted and laid down; riding: it hangs."""
    start: Height
    """Arc length from the sinker."""
    end: Height
    """Likewise."""
    diameter: Length
    """Nominal, new."""
    wear_rate: WearRate
    """Of its diameter, that the life is by."""
    lowest_rate: WearRate
    """Lowest that is published for it, or recalled of the thrash section."""
    highest_rate: WearRate
    """Highest, likewise."""
    limit: Length
    """Diameter at which it is taken out."""

    @property
    def life(self) -> Duration | None:
        """Until it is taken out; None where it does not wear."""
        return self._after(self.wear_rate)

    @property
    def shortest_life(self) -> Duration | None:
        """The same at the highest rate."""
        return self._after(self.highest_rate)

    @property
    def longest_life(self) -> Duration | None:
        """The same at the lowest rate."""
        return self._after(self.lowest_rate)

    def _after(self, rate: float) -> float | None:
        return (self.diameter - self.limit) / rate if rate > 0.0 else None


@dataclass(frozen=True)
class WholeCost(Record):
    """What the mooring costs over twenty years, without interest, USD."""

    DOCUMENT = (
        "duration chain=chain_USD sinker=sinker_USD fittings=fittings_USD visit=visit_USD renewals "
        "renewed=renewed_USD total=total_USD"
    )

    duration: Duration
    """Over which it is counted."""
    chain: NotNegative
    """USD, new."""
    sinker: NotNegative
    """USD."""
    fittings: NotNegative
    """USD, of the first set."""
    visit: NotNegative
    """USD, of laying."""
    renewals: FromZero
    """Visits at which chain is renewed, with its fittings."""
    renewed: NotNegative
    """USD, of them all."""

    @property
    def total(self) -> NotNegative:
        """USD, of all."""
        return math.fsum((self.chain, self.sinker, self.fittings, self.visit, self.renewed))


@dataclass(frozen=True)
class Upkeep(Record):
    """A buoy's chain by zone, when to look at it and what it costs."""

    DOCUMENT = "zones inspection passes_by_zone cost"

    zones: tuple[ChainZone, ...]
    """From the sinker upwards."""
    inspection: Duration | None
    """How often to look at it: half of the shortest life; None where nothing wears."""
    passes_by_zone: bool | None
    """Whether the line with each zone's own size and wear passes every check at rest; None where
    all zones are alike."""
    cost: WholeCost | None
    """None where a price is not known."""


def upkeep_of(request: BuoyRequest, of: Sizing) -> Upkeep | None:
    """Lay the recommended chain out by zone; None where its life is not known."""
    service, life = of.case.service, of.chain_life
    first = of.point.line.segments[0]
    if service is None or life is None or first.nominal_diameter is None or not service.wear_rate:
        return None
    given, rate = request.upkeep, service.wear_rate
    limit = first.nominal_diameter - life * rate
    own = rate if given.thrash_wear is None else given.thrash_wear
    thrash = first
    if given.thrash_wear is not None:
        thrash = _lasting(request, first, own * service.life, limit) or first
    low, high = thrash_ends(
        of.point.line.length,
        first.submerged_weight,
        _everyday_pull(request, of),
        *_eye_heights(request),
    )
    ends: dict[ZoneName, tuple[float, float]] = {
        "ground": (0.0, low),
        "thrash": (low, high),
        "riding": (high, of.point.line.length),
    }
    zones = tuple(
        _zone(name, start, end, thrash if name == "thrash" else first, limit, rate, own)
        for name, (start, end) in ends.items()
        if end > start
    )
    lives = [
        each.life if each.name == "thrash" else each.shortest_life or each.life for each in zones
    ]
    known = [each for each in lives if each is not None]
    return Upkeep(
        zones,
        _OF_THE_SHORTEST * min(known) if known else None,
        None if given.thrash_wear is None else _passes(of, zones, thrash),
        _cost(request, of, zones),
    )


def thrash_ends(
    length: float, weight: float, pull: float, lowest: float, highest: float
) -> tuple[float, float]:
    """Arc lengths from the sinker between which a chain is lifted and laid down, m.

    The upper one is where it touches the bed hanging plumb with the eye at its lowest, the lower
    one where it does under a horizontal pull, N, with the eye at its highest: of a chain of weight
    w (N/m) sqrt(h^2 + 2 h H / w) hang from an eye at h over the bed.

    Examples
    --------
    >>> from catopt.sizing.maintenance import thrash_ends
    >>> ends = thrash_ends(30.0, 100.0, 900.0, 9.0, 12.0)  # sqrt(144 + 216) = 18.97 m hang
    >>> [round(each, 2) for each in ends]
    [11.03, 21.0]
    """
    hangs = math.sqrt(highest**2 + 2.0 * highest * pull / weight)
    return max(0.0, length - hangs), max(0.0, length - lowest)


def _eye_heights(request: BuoyRequest) -> tuple[float, float]:
    """Lowest and highest that the eye stands over the bed, m: at low and high water, by a crest."""
    env = request.environment
    eye = request.eye_depth(0.0)
    low = max(env.levels.low - env.crest, 0.5 * env.levels.low) - eye
    return max(0.0, low), env.levels.high + env.crest - eye


def _everyday_pull(request: BuoyRequest, of: Sizing) -> float:
    """Horizontal pull of the tide alone, N; of a buoy by its force, that force."""
    shape, env = request.buoy, request.environment
    if not isinstance(shape, BuoyShape):
        return shape.horizontal_force
    wet = shape.afloat(0.0, env.water_density).hull_area_in_water(request.marine_growth)
    hull = 0.5 * env.water_density * shape.drag_in_water * wet * env.current.speed**2
    parts = (part for part in of.settled.posed.loads[0].parts)
    every = (each for part in parts for each in part.components)
    on_chain = (e.force for e in every if is_said(e.name, "loads.current_on_chain"))
    return hull + math.fsum(on_chain)


def _zone(
    name: ZoneName,
    start: float,
    end: float,
    segment: Segment,
    limit: float,
    rate: float,
    thrash_rate: float,
) -> ChainZone:
    size = segment.nominal_diameter or 0.0
    if name == "thrash":
        rate, (lowest, highest) = thrash_rate, RECALLED_THRASH
    else:
        lowest, highest = published_rates(_TABLE_OF[name])
    least = max(limit, kept_condition().discard * size)
    return ChainZone(name, start, end, size, rate, lowest, highest, least)


def published_rates(zone: str) -> tuple[float, float]:
    """Lowest and highest wear of a zone in the tables that were read, m/s."""
    rates = [t.rates[zone] for t in WEAR_TABLES.values() if zone in t.rates and t.confidence != "R"]
    return min(rates), max(rates)


def _lasting(request: BuoyRequest, first: Segment, loss: float, limit: float) -> Segment | None:
    """Pick the least size sold that is not worn out by a loss of diameter, m; None: none is."""
    discard = kept_condition().discard
    any_size = replace(request.line, diameter_max=None)
    every = (
        each
        for each in sold(any_size, request.environment.water_density)
        if each.component == first.component
        and (each.nominal_diameter or 0.0) >= (first.nominal_diameter or 0.0)
        and (each.nominal_diameter or 0.0) - loss
        >= max(limit, discard * (each.nominal_diameter or 0.0))
    )
    return min(every, key=lambda each: each.nominal_diameter or 0.0, default=None)


def _passes(of: Sizing, zones: tuple[ChainZone, ...], thrash: Segment) -> bool:
    """Check the line of zones at rest, each with its own size and wear."""
    first = of.point.line.segments[0]

    def segments() -> Iterator[Segment]:
        for zone in zones:
            made = thrash if zone.name == "thrash" else first
            yield replace(made, length=zone.end - zone.start, wear_rate=zone.wear_rate)

    anchor = of.point.anchor or of.case.anchor
    case = replace(of.case, line=Line(segments()), design=None, anchor=anchor)
    try:
        return check_case(case).passes
    except NoAnswerError:
        return False


def _cost(request: BuoyRequest, of: Sizing, zones: tuple[ChainZone, ...]) -> WholeCost | None:
    given, anchor = request.upkeep, of.point.anchor
    first = of.point.line.segments[0]
    parts = (given.sinker_price, given.fittings_price, given.visit_price)
    if None in parts or anchor is None or anchor.mass is None or first.mass is None:
        return None
    sinker_price, fittings, visit = (float(each or 0.0) for each in parts)
    price = given.chain_price
    if price is None and first.price is not None:
        price = 1e3 * first.price / first.mass
    if price is None:
        return None
    # Chain weighs with the square of its size.
    masses = [
        first.mass
        * (zone.diameter / (first.nominal_diameter or 1.0)) ** 2
        * (zone.end - zone.start)
        for zone in zones
    ]
    counts = [renewals(zone.life) for zone in zones]
    visits = max(counts)
    chain = price / 1e3
    renewed = math.fsum(n * m * chain for n, m in zip(counts, masses, strict=True))
    return WholeCost(
        COSTED,
        chain * math.fsum(masses),
        sinker_price * anchor.mass / 1e3,
        fittings,
        visit,
        visits,
        renewed + visits * (fittings + visit),
    )


def renewals(life: float | None) -> int:
    """Count how often what lasts a life (s) is renewed in twenty years, but for the last day.

    Examples
    --------
    >>> from catopt.constants import YEAR
    >>> from catopt.sizing.maintenance import renewals
    >>> renewals(5.0 * YEAR), renewals(6.0 * YEAR), renewals(25.0 * YEAR), renewals(None)
    (3, 3, 0, 0)
    """
    return 0 if life is None else max(0, math.ceil(COSTED / life - 1e-9) - 1)
