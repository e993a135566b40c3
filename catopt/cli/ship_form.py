"""What ``catopt loads ship`` makes of its options: the ship afloat, and what turns it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from catopt.words import Message, term

if TYPE_CHECKING:
    from catopt.loads import Afloat, Headings, Lying, Turning
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


def refuse_needless(options: dict[str, str | None]) -> None:
    """Refuse what is of a ship that weathervanes."""
    from catopt.errors import InputError, Problem

    allowed = "leave it out, or give --weathervane with it"
    given = [Problem(name, each, allowed) for name, each in options.items() if each is not None]
    if given:
        raise InputError(given, "heading")


def read_turning(current_yaw: str, own: dict[str, float]) -> Turning:
    """Read what turns the ship."""
    from catopt.errors import InputError, Problem
    from catopt.loads import YAW_TYPES, CurrentYaw, Turning

    allowed = (
        f'one of {", ".join(YAW_TYPES)} (recalled, R) or "a, b" of UFC\'s table 4-10 is wanted'
    )
    if not current_yaw:
        raise InputError([Problem("current_yaw", "", f"missing; {allowed}")], "heading")
    if current_yaw in YAW_TYPES:
        return Turning(YAW_TYPES[current_yaw], own.get("--mooring-point"))
    try:
        intercept, slope = (float(each) for each in current_yaw.split(","))
    except ValueError:
        raise InputError([Problem("current_yaw", f'"{current_yaw}"', allowed)], "heading") from None
    return Turning(CurrentYaw(intercept, slope), own.get("--mooring-point"))


def turned_round(directions: Headings, own: dict[str, float]) -> list[Headings]:
    """Turn the current right round in the steps of a scan, if there is one."""
    from catopt.errors import InputError, Problem

    step = own.get("--scan")
    if step is None:
        return [directions]
    if not math.radians(1.0) <= step <= math.pi:
        found = f"{math.degrees(step):g} deg"
        raise InputError([Problem("scan", found, "a step of 1 to 180 deg is wanted")], "heading")
    count = math.ceil(2.0 * math.pi / step - 1e-9)
    turned = (math.remainder(directions.current + k * step, 2.0 * math.pi) for k in range(count))
    return [replace(directions, current=each) for each in turned]


def what_is_taken(form: Form, worst: Lying, turning: Turning | None) -> Iterator[Message]:
    """Say what the ship was taken for."""
    ship = worst.afloat.ship
    block = ship.displacement / (ship.length_waterline * ship.breadth * ship.draught)
    yield Message("loads.hull_form", length=form.waterline, block=block, midship=form.midship)
    if turning is not None:
        yield Message(
            "loads.turning_recalled" if turning.yaw.recalled else "loads.turning",
            point=turning.lever(ship),
            centre=ship.lateral_centre,
            intercept=turning.yaw.intercept,
            slope=turning.yaw.slope,
        )
