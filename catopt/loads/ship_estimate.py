"""A tanker of which only the main dimensions are known: what is not given is estimated."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final, Literal, get_args

from catopt.loads.ship import Ship
from catopt.loads.source import MARPOL, LoadSource
from catopt.model.validity import Findings
from catopt.words import Message

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
"""Of the deckhouse, m; it is as wide as the ship."""


def estimates() -> tuple[Message, Message]:
    """Say what is taken of hull and deckhouse where nothing is given; catopt's own figures."""
    return (
        Message(
            "loads.estimated_hull", part=WATERLINE, loaded="0.80", ballast="0.72", midship=MIDSHIP
        ),
        Message("loads.estimated_house", height=HOUSE_HEIGHT, length=HOUSE_LENGTH),
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
    >>> from catopt.loads.ship_estimate import ballast_draught
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
) -> Ship:
    """Make a tanker out of its main dimensions, in m: length over all, depth from deck to keel.

    The block coefficient is that of the condition. The areas above water, m2, are estimated when
    left out; `lateral_centre` is of an area that is given, m forward of midships: that of the
    estimated one follows from a deckhouse at the stern. A square-ended hull is a box without one.

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
    waterline, block, midship, height = WATERLINE * length, BLOCK[condition], MIDSHIP, HOUSE_HEIGHT
    if is_square_ended:
        waterline, block, midship, height = length, 1.0, 1.0, 0.0
    section = breadth * draught
    frontal = breadth * (freeboard + height)
    house = height * HOUSE_LENGTH
    lateral = length * freeboard + house
    house_lever = -house * 0.5 * (length - HOUSE_LENGTH) / lateral
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
