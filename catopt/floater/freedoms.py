"""In how many ways a hull moves: in one plane where weather and lines keep it there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from catopt.fem.solve import Leg
from catopt.hydro.build import IN_PLANE, AnyHull, FloatingHull
from catopt.waves import Sea

_ALONG: Final = 1e-9
"""Sine of an angle, or speed across, m/s, up to which a direction is along x."""
_SAME_PLACE: Final = 1e-6
"""Part of the anchors' radius within which places mirror each other."""


def freedoms(hull: AnyHull, legs: Sequence[Leg], sea: Sea) -> tuple[bool, ...]:
    """Say which freedoms a hull has: all six, or those of the plane of x and z.

    Weather along x, and lines that x mirrors, leave it in that plane. Nothing turns a body of
    revolution about its axis but lines that are fast to it away from that.
    """
    if not isinstance(hull, FloatingHull):
        return (True,) * 6
    if not any((waves_across(sea), current_across(sea), wind_across(hull), unmirrored(hull, legs))):
        return IN_PLANE
    yaws = any(math.hypot(x, y) > 0.0 for x, y, _ in hull.eyes)
    return (True, True, True, True, True, yaws)


def waves_across(sea: Sea) -> bool:
    """Whether waves go in another direction than along x."""
    waves = sea.waves
    return waves is not None and float(np.abs(np.sin(waves.direction)).max()) > _ALONG


def current_across(sea: Sea) -> bool:
    """Whether the current has a part across x."""
    flow = sea.flow
    sideways = (flow.current[:, 2], flow.power_currents[:, 1], flow.current_series[:, 2])
    return float(np.abs(np.concatenate(sideways)).max(initial=0.0)) > _ALONG


def wind_across(hull: FloatingHull) -> bool:
    """Whether the wind blows in another direction than along x."""
    return hull.wind[0] != 0.0 and abs(math.sin(hull.wind_direction)) > _ALONG


def unmirrored(hull: FloatingHull, legs: Sequence[Leg]) -> tuple[int, ...]:
    """Which lines, from 0, have not as many mirrored by x as there are in their own place."""
    if not legs:
        return ()
    ends = [np.array([leg.anchor, eye]) for leg, eye in zip(legs, hull.eyes, strict=True)]
    near = _SAME_PLACE * max(float(np.abs(each).max()) for each in ends)

    def alike(number: int, side: float) -> int:
        """Count the lines of its kind in its place, or in that on the other side."""
        there = ends[number] * [1.0, side, 1.0]
        return sum(
            leg.line == legs[number].line and float(np.abs(each - there).max()) <= near
            for leg, each in zip(legs, ends, strict=True)
        )

    return tuple(k for k in range(len(legs)) if alike(k, 1.0) != alike(k, -1.0))
