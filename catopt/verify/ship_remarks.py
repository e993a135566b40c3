"""What the answer of a ship on two time scales rests on, and where it does not hold."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.floater.ship import ShipInWeather
from catopt.floater.two_scales import MooredShip, ShipAtRest, ShipHistory
from catopt.model import Case
from catopt.model.dynamics import Dynamics
from catopt.ties import largest
from catopt.units import lasting
from catopt.verify.motion_file import energy_beyond
from catopt.verify.ship_result import LineOfShip
from catopt.waves import Sea, Waves, breaking_warning
from catopt.waves.random_surface import wave_number
from catopt.words import Message

_WIDE: Final = 0.2
"""Breadth over the wave length above which a hull changes the waves."""
_CYCLES: Final = 50
"""Slow cycles from which a deviation is known to some 10 %."""
_LEFT_OUT: Final = 0.01
"""Part of the waves' energy beyond a table of RAOs from which it is remarked on."""


def remarks_of(case: Case, moored: MooredShip, sea: Sea, rest: ShipAtRest) -> Iterator[Message]:
    """Yield what the answer rests on, and where it does not hold."""
    waves = sea.waves
    assert waves is not None
    breaks = breaking_warning(sea)
    if isinstance(breaks, Message):
        yield breaks
    if rest.others:
        others = ", ".join(f"{math.degrees(each):.0f}" for each in rest.others)
        yield Message("floater.other_headings", others=others)
    yield from _of_waves(moored, waves)
    yield Message("floater.quasi_static_lines")
    yield from _of_slow_motion(moored.ship)
    assert case.system is not None
    if any(case.system.force):
        given = math.hypot(*case.system.force)
        yield Message("floater.own_force", given=given / 1e3, own=math.hypot(*rest.force) / 1e3)


def judged_by_words(lines: tuple[LineOfShip, ...], dynamics: Dynamics) -> Iterator[Message]:
    """Yield by what the most loaded line is judged, where that is not the combined largest."""
    by = dynamics.judged_by
    most = largest(lines, lambda each: each.judged(by))
    seen, judged = most.fairlead.seen / 1e3, most.judged(by) / 1e3
    if by == "largest" or most.storm is None:
        over = [each for each in lines if each.fairlead.seen > each.fairlead.combined]
        if over:
            most = largest(over, lambda each: each.fairlead.seen - each.fairlead.combined)
            seen = most.fairlead.seen / 1e3
            yield Message("floater.seen_more", number=most.number, seen=seen, count=len(over))
        return
    storm = lasting(dynamics.duration_of_interest)
    said = {"number": most.number, "judged": judged, "seen": seen, "storm": storm}
    yield Message(f"floater.judged_{by.replace('-', '_')}", **said)


def few_cycles(runs: tuple[ShipHistory, ...], rest: ShipAtRest) -> Iterator[Message]:
    """Yield that slow motion was too short to know its deviation."""
    count = 0
    for each in runs:
        off = np.hypot(*(each.slow[:, :2] - np.array(rest.zero)).T)
        off -= off.mean()
        count += int(((off[:-1] < 0.0) & (off[1:] >= 0.0)).sum())
    if count < _CYCLES:
        yield Message("floater.few_cycles", count=count, wanted=_CYCLES)


def _of_waves(moored: MooredShip, waves: Waves) -> Iterator[Message]:
    """Yield what drift and response in waves rest on."""
    of, ship = moored.ship.of, moored.ship
    k = wave_number(float(waves.omega[np.argmax(_density(waves))]), ship.depth)
    length = 2.0 * math.pi / k
    if of.drift_file:
        yield Message("floater.drift_of_file")
        yield from ship.remarks
    elif of.reflection is None:
        yield Message("floater.drift_above_keel")
    else:
        yield Message("floater.drift_by_reflection", part=of.reflection)
    if k * ship.depth < 0.5 * math.pi:
        yield Message("floater.shallow_drift", depth=ship.depth, length=length)
    if moored.response is not None:
        beyond = energy_beyond(moored.response.omega, waves)
        if beyond > _LEFT_OUT:
            yield Message("floater.beyond_raos", part=beyond)
        return
    yield Message("floater.closed_raos")
    if ship.ship.breadth > _WIDE * length:
        yield Message("floater.wide_hull", breadth=ship.ship.breadth, length=length)
    if of.roll_period is None:
        yield Message("floater.no_roll")
    else:
        yield Message("floater.roll_damping", part=of.roll_damping)


def _of_slow_motion(ship: ShipInWeather) -> Iterator[Message]:
    """Yield what damps slow motion, and what wind and current rest on."""
    of = ship.of
    dampings = {"surge": of.surge_damping, "sway": of.sway_damping, "yaw": of.yaw_damping}
    yield Message("floater.slow_damping", **dampings)
    if math.hypot(*ship.wind) > 0.0:
        yield Message("floater.gusts_npd" if of.gusts == "NPD" else "floater.gusts_none")
    if of.current_yaw:
        yield Message("floater.current_recalled", hull=of.current_yaw)
    elif math.hypot(*ship.current) > 0.0:
        yield Message("floater.current_amidships")


def _density(waves: Waves) -> Array:
    """Energy of the waves over the width between their neighbours, smoothed; for the peak."""
    order = np.argsort(waves.omega)
    energy = waves.amplitude[order] ** 2
    if energy.size < 20:
        return np.asarray(waves.amplitude**2)
    width = np.gradient(waves.omega[order])
    window = np.ones(9)
    smooth = np.convolve(energy, window, "same") / np.convolve(width, window, "same")
    out = np.empty_like(energy)
    out[order] = smooth
    return out
