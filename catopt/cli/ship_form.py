"""What ``catopt loads ship`` makes of its options: the ship afloat, and what turns it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from catopt.words import Message, term

if TYPE_CHECKING:
    from catopt.loads import Afloat, Lying, Turning
    from catopt.loads.ship_estimate import Condition
    from catopt.sizing.known import Known


class Form(NamedTuple):
    """What makes a ship of its main dimensions, beside them."""

    waterline: float
    block: float | None
    midship: float
    kind: str | None
    propeller: str | None
    wind_centre: float | None


def ships_afloat(of: Known, form: Form) -> tuple[list[Afloat], tuple[Message, ...]]:
    """Make the ship at each draught that is known, and say what was estimated."""
    from catopt.loads import Afloat, Ship
    from catopt.loads.ship_estimate import BLOCK, estimates
    from catopt.sizing.requests import TAKEN_FOR, ship_at
    from catopt.sizing.tanker_request import check_deadweight

    wind_on, _ = TAKEN_FOR[of["ship"] or "tanker"]
    ships = []
    conditions: dict[Condition, float | None] = {
        "loaded": of["draught"],
        "ballast": of["ballast_draught"],
    }
    for condition, draught in conditions.items():
        if draught is None:
            continue
        windage = of.telling.make(partial(ship_at, of, condition, "tanker"))
        of.telling.raise_if_any()
        assert windage is not None
        section = of["breadth"] * draught
        block = BLOCK[condition] if form.block is None else form.block
        centre = windage.lateral_centre if form.wind_centre is None else form.wind_centre
        key = "loads.ship_of" if of["ballast_draught"] is None else "loads.ship_in_condition"
        make_ship = partial(
            Ship,
            Message(key, length=of["length"], condition=term(condition)),
            length_overall=of["length"],
            length_waterline=form.waterline,
            breadth=of["breadth"],
            draught=draught,
            displacement=block * form.waterline * section,
            midship_area=form.midship * section,
            lateral_area=windage.lateral_area,
            frontal_area=windage.frontal_area,
            propeller=form.propeller,
            lateral_centre=centre,
        )
        body = of.telling.make(make_ship)
        of.telling.raise_if_any()
        assert body is not None
        if condition == "loaded" and of["dwt"] is not None:
            of.telling.make(check_deadweight, of["dwt"], body)
            of.telling.raise_if_any()
        ships.append(Afloat(condition, body, form.kind or wind_on.format(condition)))
    is_given = of["frontal_area"] is not None and of["lateral_area"] is not None
    return ships, () if is_given else estimates()[1:]


def needs_turning() -> str:
    """Say what to do with what is of a ship that weathervanes."""
    return "leave it out, or give --weathervane with it"


def refuse_needless(options: dict[str, str | None]) -> None:
    """Refuse what is of a ship that weathervanes."""
    from catopt.errors import InputError, Problem

    given = [
        Problem(name, each, needs_turning()) for name, each in options.items() if each is not None
    ]
    if given:
        raise InputError(given, "heading")


def what_is_taken(form: Form, worst: Lying, turning: Turning | None) -> Iterator[Message]:
    """Say what the ship was taken for."""
    ship = worst.afloat.ship
    block = ship.displacement / (ship.length_waterline * ship.breadth * ship.draught)
    yield Message("loads.hull_form", length=form.waterline, block=block, midship=form.midship)
    if turning is not None:
        from catopt.sizing.headings import turning_words

        yield turning_words(turning, ship)
