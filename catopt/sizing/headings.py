"""The directions of wind, current and waves at a ship on one point, and what turns it."""

from __future__ import annotations

import math
from functools import partial
from typing import Final, NamedTuple

from catopt.errors import InputError, Problem
from catopt.loads.heading import HEAD_ON, Headings
from catopt.loads.ship import Ship
from catopt.loads.weathervane import YAW_TYPES, CurrentYaw, Turning
from catopt.sizing.known import ResolvedInputs
from catopt.units import as_written
from catopt.words import Message

DIRECTIONS: Final = ("wind_angle", "current_angle", "wave_angle", "scan")
"""Inputs of which any makes a ship turn until it is at rest."""

_LEAST_STEP: Final = math.radians(1.0)


class Weathervaning(NamedTuple):
    """From where a ship is pushed, and what turns it."""

    directions: tuple[Headings, ...] = (HEAD_ON,)  # each is one case
    turning: Turning | None = None  # None: all comes from one side, and the ship lies head to it


def weathervaning_of(of: ResolvedInputs, *, is_turned: bool = False) -> Weathervaning | None:
    """Make the directions that are known; None where something is wrong with them.

    `is_turned`: whether the ship's own tables have the moment of the current.
    """
    make = of.telling.make
    if of.given.isdisjoint(DIRECTIONS):
        if "current_yaw" in of.given:
            allowed = Message(
                "refused_sizing.leave_out_or_give_one",
                spell=", ".join(map(of.telling.spell, DIRECTIONS)),
            )
            of.telling.add("current_yaw", as_written(of["current_yaw"]), allowed)
        return Weathervaning()
    if of.values.keys().isdisjoint(DIRECTIONS):
        return None  # what is wrong with them is told
    turning = make(partial(read_turning, of["current_yaw"] or "", is_known=is_turned))
    directions = make(partial(directions_of, of))
    turned = make(turned_round, directions, of["scan"] or math.inf)
    return make(Weathervaning, turned, turning)


def directions_of(of: ResolvedInputs) -> Headings:
    """Make where wind, current and waves come from: ahead where that is not given."""
    return Headings(*(of[name] or 0.0 for name in DIRECTIONS[:3]))


def read_turning(
    current_yaw: str, mooring_point: float | None = None, *, is_known: bool = False
) -> Turning:
    """Read what turns a ship; anything else is refused.

    `is_known`: whether the moment of the current is in tables of the ship's own.

    `current_yaw` is a key of `catopt.loads.YAW_TYPES`, or "a, b" of UFC's table 4-10, b per degree;
    the mooring point is in m forward of midships, the bow when left out.
    """
    allowed = Message("refused_sizing.one_recalled_r_or_b", yaw_types=", ".join(YAW_TYPES))
    if is_known:
        if current_yaw:
            own = Message("refused_sizing.leave_out_ship_s_own")
            raise InputError([Problem("current_yaw", f'"{current_yaw}"', own)], "heading")
        return Turning(None, mooring_point)
    if not current_yaw:
        raise InputError(
            [Problem("current_yaw", "", Message("refused.missing", wanted=allowed))], "heading"
        )
    if current_yaw in YAW_TYPES:
        return Turning(YAW_TYPES[current_yaw], mooring_point)
    try:
        intercept, slope = (float(each) for each in current_yaw.split(","))
    except ValueError:
        raise InputError([Problem("current_yaw", f'"{current_yaw}"', allowed)], "heading") from None
    return Turning(CurrentYaw(intercept, slope), mooring_point)


def turned_round(directions: Headings, step: float) -> tuple[Headings, ...]:
    """Turn the current right round from where it is, in steps of 1 to 180 deg, in rad.

    A step of infinity gives the beginning alone; any other is refused.
    """
    if step == math.inf:
        return (directions,)
    if not _LEAST_STEP <= step <= math.pi:
        found = f"{math.degrees(step):g} deg"
        raise InputError(
            [Problem("scan", found, Message("refused_sizing.step_1_180_deg_wanted"))], "heading"
        )
    count = math.ceil(2.0 * math.pi / step - 1e-9)
    turned = (math.remainder(directions.current + k * step, 2.0 * math.pi) for k in range(count))
    return tuple(
        Headings(wind=directions.wind, current=each, waves=directions.waves) for each in turned
    )


def turning_words(turning: Turning, ship: Ship) -> Message:
    """Say what turns a ship."""
    held = {"point": turning.lever(ship), "centre": ship.lateral_centre}
    if turning.yaw is None:
        return Message("loads.turning_own", **held)
    return Message(
        "loads.turning_recalled" if turning.yaw.recalled else "loads.turning",
        **held,
        intercept=turning.yaw.intercept,
        slope=turning.yaw.slope,
    )
