"""What makers lay, what ships carry and when used chain is discarded.

It stands beside what is recommended. Lengths are in m and masses in kg.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Final

from catopt.catalogue.components import RECALLED, Confidence, Source
from catopt.model.kinds import Findings
from catopt.units import UNITS, Dimension
from catopt.words import Cited, Listed, Message, Several, Translated

SCHEMA: Final = "catopt.practice/1"

_MM: Final = 1e-3
_SAME_BUOY: Final = 0.05
"""m: buoys of a printed diameter, which has one decimal."""
_SAME_CHAIN: Final = 0.5e-3
"""m: half a step of the smallest between sizes of chain."""
_TONNE: Final = 1000.0
_ROUNDING: Final = 1e-9


@dataclass(frozen=True)
class Origin:
    """Where a figure was read."""

    source: Source
    place: str
    confidence: Confidence

    @property
    def is_recalled(self) -> bool:
        """Whether it was read in no document."""
        return self.confidence == RECALLED

    @property
    def text(self) -> Several:
        """Title, place and confidence in one line."""
        end = Cited(f"[{self.confidence}]")
        return Several((Several((self.source.title, self.place), ", "), end), " ")


@dataclass(frozen=True)
class LaidForBuoy:
    """What a maker lays for its buoy here."""

    buoy_diameter: float  # of the buoy that it was printed for, m
    is_of_size: bool  # whether that is the size that was asked for
    chain: float  # nominal diameter, m
    lengths: tuple[float, float]  # least and largest, m
    shackle: float  # to chain and sinker, nominal, m
    swivel: float  # m
    bridle_shackle: float  # m
    origin: Origin


@dataclass(frozen=True)
class EquipmentRow:
    """Anchors and cable of ships of an equipment number."""

    above: float
    up_to: float
    stockless: float  # mass of one bower anchor, kg
    length: float  # of both cables, m
    grades: tuple[float, float, float]  # diameter of stud link of Grade 1 to 3, m; 0: none
    high_holding: float  # mass of an anchor of high holding power, kg
    origin: Origin


@dataclass(frozen=True)
class Equipment:
    """A ship's own anchoring equipment."""

    number: float
    row: EquipmentRow | None  # None: no row was read or is recalled
    origin: Origin  # of the formula

    @property
    def decides(self) -> bool:
        """Whether its row was read."""
        return self.row is not None and not self.row.origin.is_recalled


@dataclass(frozen=True)
class Condition:
    """Parts of the nominal diameter: good from the first on, below the second discarded."""

    good: float
    discard: float
    origin: Origin


@dataclass(frozen=True)
class Practice:
    """The line of an answer that sets it beside practice."""

    message: Message
    laid: LaidForBuoy | None = None
    equipment: Equipment | None = None


@cache
def _data() -> Mapping[str, Any]:
    import tomllib
    from importlib.resources import files

    text = files("catopt.catalogue").joinpath("data", "practice.toml").read_text("utf-8")
    return tomllib.loads(text)


def _said(text: str | dict[Any, str]) -> str:
    return Translated(text) if isinstance(text, dict) else Cited(text)


def _origin(of: Mapping[str, Any], prefix: str = "") -> Origin:
    key = of[f"{prefix}source"]
    source = _data()["sources"][key]
    cited = Source(key, _said(source["title"]), _said(source["place"]))
    return Origin(cited, _said(of[f"{prefix}place"]), of[f"{prefix}confidence"])


# ------------------------------------------------------------------ buoys


def laid_for_buoy(buoy_diameter: float, depth: float, current: float) -> LaidForBuoy | None:
    """Look up what a maker lays for a buoy of a diameter, m, in water of a depth, m.

    The current is in m/s. Where two rows meet, the heavier chain counts. None where no table was
    read for that depth or current; of another size of buoy than the printed one `is_of_size` says
    so.

    Examples
    --------
    >>> from catopt.catalogue.practice import laid_for_buoy
    >>> laid = laid_for_buoy(2.2, 10.0, 1.0)
    >>> laid.chain, laid.lengths
    (0.044, (20.0, 30.0))
    """
    found = Findings("practice of buoys")
    found.number("buoy_diameter", buoy_diameter, "m", above=0.0)
    found.number("depth", depth, "m", above=0.0)
    found.number("current", current, "m/s", at_least=0.0)
    found.raise_if_any()
    table = _data()["buoy"]
    chains = [size for low, high, size in table["chains"] if low <= depth <= high]
    knots = current / UNITS[Dimension.SPEED]["kn"]
    scopes = [each["scope"] for each in table["scopes"] if _is_for(each, depth, knots)]
    if not chains or not scopes:
        return None
    return LaidForBuoy(
        buoy_diameter=table["diameter_m"],
        is_of_size=abs(buoy_diameter - table["diameter_m"]) <= _SAME_BUOY,
        chain=chains[0] * _MM,
        lengths=(min(scopes) * depth, max(scopes) * depth),
        shackle=table["shackle_mm"] * _MM,
        swivel=table["swivel_mm"] * _MM,
        bridle_shackle=table["bridle_shackle_mm"] * _MM,
        origin=_origin(table),
    )


def _is_for(scope: Mapping[str, float], depth: float, knots: float) -> bool:
    below = scope.get("below_kn")
    is_slow = knots < below if below is not None else knots <= scope["up_to_kn"] + _ROUNDING
    return is_slow and depth <= scope["depth_m"]


def practice_of_buoy(
    diameter: float,
    length: float,
    *,
    buoy_diameter: float,
    depth: float,
    current: float,
    chain_limits: tuple[float, float] | None = None,
) -> Practice:
    """Set a chain, its nominal diameter and length in m, beside what is laid for such a buoy.

    The limits are the smallest and the largest chain of the buoy's own entry in a library, m; the
    rest is as of `laid_for_buoy`.

    Examples
    --------
    >>> from catopt.catalogue.practice import practice_of_buoy
    >>> print(practice_of_buoy(0.03, 27.0, buoy_diameter=2.2, depth=10.0, current=1.0).message)
    makers of a 2.2 m buoy lay 44 mm and 20 to 30 m here: this is thinner
    """
    laid = laid_for_buoy(buoy_diameter, depth, current)
    said: list[Message] = []
    if laid is None:
        said.append(Message("practice.no_table", depth=depth, current=current))
    else:
        least, most = laid.lengths
        lengths = Message("practice.lengths", least=least, most=most)
        if least == most:
            lengths = Message("practice.length", length=least)
        # Of another size of buoy its length says something, its chain nothing.
        chains = (laid.chain, laid.chain) if laid.is_of_size else chain_limits or (0.0, math.inf)
        values = {
            "size": laid.buoy_diameter,
            "chain": laid.chain / _MM,
            "lengths": lengths,
            "verdict": _verdict(
                _compared(diameter, *chains, _SAME_CHAIN, "chain"),
                _compared(length, least, most, _ROUNDING, "length"),
            ),
        }
        key = "practice.buoy" if laid.is_of_size else "practice.other_buoy"
        said.append(Message(key, **values))
    if chain_limits is not None:
        low, high = chain_limits
        said.insert(0, Message("practice.limits", least=low / _MM, most=high / _MM))
    return Practice(Several(said), laid)


def _compared(own: float, least: float, most: float, same: float, what: str) -> Message | None:
    if own < least - same:
        return Message(f"practice.{what}_less")
    return Message(f"practice.{what}_more") if own > most + same else None


def _verdict(*compared: Message | None) -> Message:
    differs = [each for each in compared if each is not None]
    return Listed(differs, "and") if differs else Message("practice.as_laid")


# ------------------------------------------------------------------ ships


_READ_NUMBER: Final = 2990.0
"""Of the row of equipment that was read in a secondary copy (C)."""


def equipment_number(displacement: float, front: float, side: float) -> float:
    """EN = displacement^(2/3) + 2 (h B + sum A_i) + A/10, the displacement in t.

    Of the loaded ship: its displacement, kg; what is seen of hull, houses and funnel above water
    from ahead, h B + sum A_i, and from the side, A, m2.
    """
    found = Findings("equipment number")
    found.number("displacement", displacement, "kg", above=0.0)
    found.number("front", front, "m2", above=0.0)
    found.number("side", side, "m2", above=0.0)
    found.raise_if_any()
    return float((displacement / _TONNE) ** (2.0 / 3.0) + 2.0 * front + side / 10.0)


@cache
def equipment_rows() -> tuple[EquipmentRow, ...]:
    """List every row of the table of equipment, in the order of their numbers."""
    data = _data()["equipment"]
    rows = [
        EquipmentRow(
            above=above,
            up_to=up_to,
            stockless=mass,
            length=length,
            grades=(first * _MM, second * _MM, third * _MM),
            high_holding=data["high_holding"] * mass,
            origin=_origin(table),
        )
        for table in data["table"]
        for above, up_to, mass, length, first, second, third in table["rows"]
    ]
    return tuple(sorted(rows, key=lambda each: each.above))


def equipment(displacement: float, front: float, side: float) -> Equipment:
    """Look up the anchors and the cable that a ship carries; as `equipment_number`.

    Examples
    --------
    >>> from catopt.catalogue.practice import equipment
    >>> own = equipment(67.8e6, 605.0, 1173.0)
    >>> round(own.number), own.row.grades[2], own.row.stockless
    (2990, 0.073, 8700)
    """
    number = equipment_number(displacement, front, side)
    row = next((each for each in equipment_rows() if each.above < number <= each.up_to), None)
    return Equipment(number, row, _origin(_data()["equipment"], "formula_"))


def own_cable(displacement: float, front: float, side: float) -> float | None:
    """Estimate the cable that a ship carries, m: nominal diameter of stud-link chain of Grade 2.

    Below the smallest row it goes with the root of her equipment number (catopt's own), as it
    nearly does in the table; None where no row was read. The rest is as of `equipment_number`.

    Examples
    --------
    >>> from catopt.catalogue.practice import own_cable
    >>> own_cable(67.8e6, 605.0, 1173.0)
    0.084
    """
    own = equipment(displacement, front, side)
    if own.decides and own.row is not None:
        return own.row.grades[1]
    first = equipment_rows()[0]
    if own.number > first.above:
        return None
    return first.grades[1] * math.sqrt(own.number / first.above)


def laid_cable(displacement: float, front: float, side: float) -> float:
    """Estimate the cable that a ship would be laid on, m: nominal diameter of Grade 3.

    That of the row that was read (C), by the root of her equipment number: catopt's own, within
    8 % of the recalled rows. The rest is as of `equipment_number`.

    Examples
    --------
    >>> from catopt.catalogue.practice import laid_cable
    >>> round(1e3 * laid_cable(67.8e6, 605.0, 1173.0))
    73
    """
    number = equipment_number(displacement, front, side)
    read = next(each for each in equipment_rows() if each.above < _READ_NUMBER <= each.up_to)
    return read.grades[2] * math.sqrt(number / (0.5 * (read.above + read.up_to)))


def practice_of_ship(
    diameter: float, length: float, *, displacement: float, front: float, side: float
) -> Practice:
    """Set a chain, its nominal diameter and length in m, beside a ship's own cable.

    The rest is as of `equipment_number`. Her equipment is for waiting in sheltered water: it is a
    comparison, and no mooring.
    """
    own = equipment(displacement, front, side)
    if own.row is None:
        return Practice(Message("practice.no_row", number=own.number), equipment=own)
    grade = 3 if own.row.grades[2] else 2
    cable, each = own.row.grades[grade - 1], 0.5 * own.row.length
    said = Message(
        "practice.ship" if own.decides else "practice.ship_recalled",
        cable=cable / _MM,
        grade=grade,
        length=each,
        anchor=own.row.stockless / _TONNE,
        number=own.number,
        verdict=_verdict(
            _compared(diameter, cable, cable, _SAME_CHAIN, "chain"),
            _compared(length, each, each, _ROUNDING, "length"),
        ),
    )
    return Practice(said, equipment=own)


# ------------------------------------------------------------------ used chain


def condition() -> Condition:
    """Return up to which part of its nominal diameter a used chain is kept."""
    data = _data()["condition"]
    return Condition(data["good"], data["discard"], _origin(data))
