"""A ship, as far as wind and current mind it."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal, NamedTuple, get_args

from catopt.display import Tabled
from catopt.errors import NoAnswerError
from catopt.loads.component import MARPOL, LoadSource
from catopt.model.kinds import Findings, NotNegative, Positive, SomeMass, exceeds
from catopt.words import Message

PROPELLER_AREA_RATIOS = MappingProxyType(
    {
        "destroyer": 100.0,
        "cruiser": 160.0,
        "carrier": 125.0,
        "cargo": 240.0,
        "tanker": 270.0,
        "submarine": 125.0,
    }
)
"""LwL B over the propellers' projected area (UFC 4-159-03 of 2005, page 92, A)."""


@dataclass(frozen=True)
class Ship:
    """A ship afloat; lengths in m, areas in m2."""

    name: str
    length_overall: float
    length_waterline: float
    breadth: float
    draught: float
    displacement: float
    """Volume displaced, m3."""
    midship_area: float
    """Of the section amidships under water."""
    lateral_area: float
    frontal_area: float
    """Both above water, as the wind sees them from the side and from ahead."""
    propeller: str | None = None
    """Kind for the propeller's area, a key of `PROPELLER_AREA_RATIOS`; None: no propeller, or one
    that is not locked."""
    lateral_centre: float = 0.0
    """Of the lateral area above water, m forward of midships."""

    def __post_init__(self) -> None:
        found = self._findings()
        for key in ("length_overall", "length_waterline"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=600.0)
        for key in ("breadth", "draught"):
            found.number(key, getattr(self, key), "m", above=0.0, at_most=100.0)
        found.number("displacement", self.displacement, "m3", above=0.0)
        for key in ("midship_area", "lateral_area", "frontal_area"):
            found.number(key, getattr(self, key), "m2", above=0.0)
        half = 0.5 * self.length_overall
        found.number("lateral_centre", self.lateral_centre, "m", at_least=-half, at_most=half)
        if self.propeller is not None:
            found.word("propeller", self.propeller, tuple(PROPELLER_AREA_RATIOS))
        if not found.problems:
            self._check_form(found)
        found.raise_if_any()

    def _check_form(self, found: Findings) -> None:
        """Note what no hull can be."""
        box = self.length_waterline * self.breadth * self.draught
        section = self.breadth * self.draught
        limits = (
            ("length_waterline", "m", self.length_overall, "refused_sizing.longer_than_ship"),
            ("displacement", "m3", box, "refused_sizing.beyond_the_box"),
            ("midship_area", "m2", section, "refused_sizing.above_section"),
            ("draught", "m", self.breadth, "refused_sizing.above_breadth"),
        )
        for key, unit, most, words in limits:
            value = getattr(self, key)
            if exceeds(value, most):
                found.add(key, f"{value:g} {unit}", Message(words, limit=most))

    @property
    def block(self) -> float:
        """Block coefficient: of the displacement."""
        return self.displacement / (self.length_waterline * self.breadth * self.draught)

    def check_afloat(self, depth: float) -> None:
        """Raise InputError unless there is water, of a depth in m, under the keel."""
        found = self._findings()
        found.number("depth", depth, "m", above=0.0)
        if not found.problems and self.draught >= depth:
            aground = Message("refused_sizing.water_m_deep_ship_would", depth=depth)
            found.add("draught", f"{self.draught:g} m", aground)
        found.raise_if_any()

    def _findings(self) -> Findings:
        return Findings(f"ship {self.name}".rstrip())


ShipKind = Literal["tanker", "bulk carrier", "general cargo", "barge"]
"""A barge or a pontoon has square ends."""

BARGE: Final = "barge"

TAKEN_FOR: Final = MappingProxyType(
    {
        "tanker": ("tanker {}", "tanker"),
        "bulk carrier": ("tanker {}", "cargo"),
        "general cargo": ("cargo loaded", "cargo"),
        BARGE: ("cargo loaded", None),
    }
)
"""For which kind of ship each is taken by wind, after Blendermann, and by propeller, after UFC. The
first lacks bulk carriers; a tanker's bow has the largest coefficient. The wind on a barge is by
`catopt.loads.ship_coefficients.SQUARE_ENDED`."""

DIMENSIONS_SOURCE: Final = "PIANC 2002 / ROM 3.1 [R]"
"""Recalled, read in neither; checked by their block coefficients (0.71 to 0.84)."""

_TONNE: Final = 1000.0


class ShipDimensions(NamedTuple):
    """Length over all, breadth, moulded depth and full draught, m."""

    length: float
    breadth: float
    moulded_depth: float
    draught: float


# Averages by deadweight in t: length over all, breadth, depth, full draught, m.
_TABLE: Final = {
    "tanker": {
        3e3: (90.0, 13.0, 7.2, 6.0),
        5e3: (110.0, 15.0, 8.6, 7.0),
        10e3: (145.0, 19.0, 10.0, 7.8),
        20e3: (174.0, 24.5, 12.6, 9.8),
        30e3: (188.0, 28.0, 14.2, 10.8),
        40e3: (200.0, 30.0, 15.4, 11.8),
        50e3: (210.0, 32.2, 16.4, 12.6),
        60e3: (217.0, 36.0, 17.0, 13.0),
        100e3: (250.0, 43.0, 19.8, 15.1),
        150e3: (285.0, 49.5, 22.0, 16.9),
        200e3: (310.0, 55.0, 24.0, 18.5),
        300e3: (350.0, 63.0, 27.0, 21.0),
    },
    "bulk carrier": {
        10e3: (130.0, 18.0, 10.0, 7.5),
        20e3: (160.0, 23.5, 12.6, 9.3),
        40e3: (195.0, 29.0, 16.3, 11.5),
        60e3: (220.0, 33.5, 18.2, 12.8),
        100e3: (255.0, 39.0, 20.8, 15.3),
        150e3: (290.0, 44.0, 23.3, 17.5),
        200e3: (315.0, 48.5, 25.0, 19.0),
        300e3: (350.0, 56.0, 28.1, 21.8),
    },
    "general cargo": {
        5e3: (105.0, 15.8, 8.5, 6.4),
        10e3: (133.0, 19.8, 11.2, 8.0),
        20e3: (166.0, 24.8, 13.8, 10.0),
        30e3: (188.0, 27.7, 16.0, 11.3),
        40e3: (209.0, 30.0, 18.0, 12.5),
    },
}


def ship_dimensions(kind: str, deadweight: float) -> ShipDimensions:
    """Estimate main dimensions from the deadweight, kg, between the rows of a table of averages.

    Between two rows the logarithms are interpolated, so that a dimension goes with a power of the
    deadweight there. Another kind of ship and a deadweight beyond the table are refused.

    Examples
    --------
    >>> from catopt.loads.ship import ship_dimensions
    >>> ship_dimensions("tanker", 50e6)
    ShipDimensions(length=210.0, breadth=32.2, moulded_depth=16.4, draught=12.6)
    """
    found = Findings("ship dimensions")
    found.word("kind", kind, get_args(ShipKind))
    if kind == "barge":
        allowed = Message("refused_sizing.no_table_barges_pontoons_was")
        found.add("deadweight", f"{deadweight / _TONNE:.6g} t", allowed)
    found.raise_if_any()
    rows = _TABLE[kind]
    tonnes, known = deadweight / _TONNE, sorted(rows)
    if exceeds(known[0], tonnes) or exceeds(tonnes, known[-1]):
        values = {"kind": kind, "value": known[0], "value2": known[-1]}
        allowed = Message("refused_sizing.dimensions_are_known_from_t", **values)
        found.add("deadweight", f"{tonnes:.6g} t", allowed)
    found.raise_if_any()
    tonnes = min(max(tonnes, known[0]), known[-1])
    if tonnes in rows:
        return ShipDimensions(*rows[tonnes])
    upper = bisect_left(known, tonnes)
    low, high = known[upper - 1], known[upper]
    part = math.log(tonnes / low) / math.log(high / low)
    length, *others = (a * (b / a) ** part for a, b in zip(rows[low], rows[high], strict=True))
    # Rounded as the table is: lengths to 1 m, the rest to 0.1 m.
    return ShipDimensions(float(round(length)), *(round(each, 1) for each in others))


SINKER_MASSES: Final = tuple(
    1e3 * tonnes
    for tonnes in (
        *(0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0),
        *(25.0, 30.0, 40.0, 50.0, 60.0),
    )
)
"""kg, in air: steps for sinkers, which are cast to order. catopt's own list."""

_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class NextSize(Tabled):
    """The next size sold that holds a pull: masses in kg, forces in N."""

    needed_mass: SomeMass
    """In air: the least that holds."""
    mass: SomeMass
    """In air: the size that is taken."""
    smaller: SomeMass | None
    """The next smaller size; None when there is none."""
    larger: SomeMass | None
    """The next larger size; None when there is none."""
    horizontal_force: float
    safety_factor: Positive
    """That was wanted, a pure number."""

    @property
    def held(self) -> float:
        """Horizontal pull that it holds, N."""
        raise NotImplementedError

    @property
    def factor(self) -> NotNegative | None:
        """What it holds over the horizontal pull, a pure number; None without a pull."""
        return None if self.horizontal_force == 0.0 else self.held / self.horizontal_force


def next_size(needed: float, series: Sequence[float], what: str) -> float:
    """Pick the smallest of a rising series that is enough, kg; `NoAnswerError` when none is."""
    found = Findings("series of sizes")
    if not series:
        found.add("series", Message("refused.none"), Message("refused_sizing.one_size_or_more"))
    for index, size in enumerate(series):
        found.number(f"series[{index}]", size, "kg", above=0.0)
    if not found.problems and list(series) != sorted(set(series)):
        found.add("series", "", Message("refused_motion.must_rise"))
    found.raise_if_any()
    for size in series:
        if size >= needed * (1.0 - _ROUNDING):
            return size
    largest = series[-1]
    tonnes = {"needed": needed, "largest": largest, "missing": needed - largest}
    values = {name: mass / 1e3 for name, mass in tonnes.items()}
    raise NoAnswerError(Message("loads.too_small", what=what, **values))


def neighbours(size: float, series: Sequence[float]) -> tuple[float | None, float | None]:
    """Pick the next smaller and the next larger of a rising series, kg; None beyond its ends."""
    smaller = [each for each in series if each < size]
    larger = [each for each in series if each > size]
    return max(smaller, default=None), min(larger, default=None)


Condition = Literal["loaded", "ballast"]

WATERLINE: Final = 0.97
"""Of the length over all."""

BLOCK: Final = MappingProxyType({"loaded": 0.80, "ballast": 0.72})
"""Block coefficient."""

MIDSHIP: Final = 0.98
"""Midship coefficient."""

MOULDED: Final = 1.3
"""Moulded depth in draughts of the loaded ship."""

BALLAST_SOURCE: Final = LoadSource(MARPOL, "2.1, of tankers", "B")
"""Of `ballast_draught`."""

HOUSE_HEIGHT: Final = 15.0
HOUSE_LENGTH: Final = 25.0
"""Of the deckhouse of a ship of `SHORTEST` and more, m; it is as wide as the ship."""

SHORTEST: Final = 90.0
"""m, over all: the shortest ship of the table of dimensions. The estimates come from such ships and
longer ones; below, a deckhouse goes with the length, and the screen says so."""


def deckhouse(length: float) -> tuple[float, float]:
    """Estimate height and length of the deckhouse of a ship of a length over all, m.

    Examples
    --------
    >>> from catopt.loads.ship import deckhouse
    >>> deckhouse(234.0), deckhouse(18.0)
    ((15.0, 25.0), (3.0, 5.0))
    """
    scale = min(1.0, length / SHORTEST)
    return scale * HOUSE_HEIGHT, scale * HOUSE_LENGTH


def estimates(length: float) -> tuple[Message, Message]:
    """Say what is taken of hull and deckhouse where nothing is given; catopt's own figures.

    `length` over all, m.
    """
    height, long = deckhouse(length)
    key = "loads.estimated_house" if length >= SHORTEST else "loads.scaled_house"
    return (
        Message(
            "loads.estimated_hull", part=WATERLINE, loaded="0.80", ballast="0.72", midship=MIDSHIP
        ),
        Message(key, height=height, length=long, shortest=SHORTEST),
    )


def box_estimates() -> tuple[Message, ...]:
    """Say what is taken of a square-ended hull where nothing is given; catopt's own figures."""
    return (Message("loads.estimated_box"),)


def ballast_draught(length: float) -> float:
    """Estimate the draught in ballast of a ship of a length over all, m: 2.0 + 0.02 L.

    L is the length of the waterline, `WATERLINE` of the length over all. It is the least that
    MARPOL wants of a tanker with segregated ballast; a ship may lie deeper.

    Examples
    --------
    >>> from catopt.loads.ship import ballast_draught
    >>> round(ballast_draught(210.0), 2)
    6.07
    """
    return 2.0 + 0.02 * WATERLINE * length


def estimated_tanker(
    name: str,
    length: float,
    breadth: float,
    draught: float,
    *,
    moulded_depth: float,
    condition: Condition = "loaded",
    frontal_area: float | None = None,
    lateral_area: float | None = None,
    propeller: str | None = "tanker",
    lateral_centre: float = 0.0,
    is_square_ended: bool = False,
    length_waterline: float | None = None,
) -> Ship:
    """Make a tanker out of its main dimensions, in m: length over all, depth from deck to keel.

    The block coefficient is that of the condition. The areas above water, m2, and the length of the
    waterline are estimated when left out; `lateral_centre` is of an area that is given, m forward
    of midships: that of the estimated one follows from a deckhouse at the stern. A square-ended
    hull is a box without one.

    Raises
    ------
    InputError
        A deck below the water, or what no hull can be.
    """
    found = Findings(f"ship {name}".rstrip())
    found.word("condition", condition, get_args(Condition))
    found.number("length_overall", length, "m", above=0.0)
    found.number("breadth", breadth, "m", above=0.0)
    found.number("draught", draught, "m", above=0.0)
    found.number("moulded_depth", moulded_depth, "m", above=0.0)
    if not found.problems and moulded_depth <= draught:
        low = Message("refused_sizing.not_above_draught_m_deck", draught=draught)
        found.add("moulded_depth", f"{moulded_depth:g} m", low)
    found.raise_if_any()
    freeboard = moulded_depth - draught
    waterline, block, midship = WATERLINE * length, BLOCK[condition], MIDSHIP
    height, long = deckhouse(length)
    if is_square_ended:
        waterline, block, midship, height = length, 1.0, 1.0, 0.0
    if length_waterline is not None:
        waterline = length_waterline
    section = breadth * draught
    frontal = breadth * (freeboard + height)
    house = height * long
    lateral = length * freeboard + house
    house_lever = -house * 0.5 * (length - long) / lateral
    return Ship(
        name,
        length_overall=length,
        length_waterline=waterline,
        breadth=breadth,
        draught=draught,
        displacement=block * waterline * section,
        midship_area=midship * section,
        lateral_area=lateral if lateral_area is None else lateral_area,
        frontal_area=frontal if frontal_area is None else frontal_area,
        propeller=propeller,
        lateral_centre=house_lever if lateral_area is None else lateral_centre,
    )
