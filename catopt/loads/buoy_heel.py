"""A buoy in slices, and how it heels under steady forces."""

from __future__ import annotations

import itertools
import math
from typing import Final, NamedTuple

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.buoy import AIR_DENSITY
from catopt.loads.buoy_shape import BuoyShape

_THICK: Final = 0.1
"""Thickest slice, over the height of the hull."""


class Disc(NamedTuple):
    """A slice of a buoy, heights above the hull's bottom, m."""

    foot: float
    top: float
    volume: float  # m3
    width: float  # as the water sees it from the side; 0 of what stands inside the hull, m
    below: float  # part of it that is below the hull

    @property
    def middle(self) -> float:
        """Height of its middle, m."""
        return 0.5 * (self.foot + self.top)


def slices_of(shape: BuoyShape) -> list[Disc]:
    """Cut a buoy into slices, the lowest first; what stands inside the hull is not seen."""
    hull, structure = shape.stacks
    rows = []
    for stack, is_hull in ((hull, True), (structure, False)):
        for foot, each in stack:
            cuts = [foot, foot + each.height]
            if not is_hull:  # where it enters the hull and leaves it
                cuts += [level for level in (0.0, shape.deck) if foot < level < cuts[1]]
            cuts.sort()
            for low, high in itertools.pairwise(cuts):
                count = max(1, math.ceil((high - low) / (_THICK * shape.deck)))
                step = (high - low) / count
                ends = [*(k * step + low for k in range(count)), high]
                for a, b in itertools.pairwise(ends):
                    volume = each.displaced(b - foot) - each.displaced(a - foot)
                    seen = is_hull or b <= 1e-9 or a >= shape.deck - 1e-9
                    width = each.outline(a - foot, b - foot) / (b - a) if seen else 0.0
                    under = 0.0 if is_hull or a >= 0.0 else 1.0
                    rows.append(Disc(a, b, max(volume, 0.0), width, under))
    return sorted(rows)


def centre_of(shape: BuoyShape, given: float | None = None) -> float:
    """Height of the centre of gravity above the hull's bottom, m: given, the buoy's, or assumed.

    Assumed: as if hull and structure were spread over what they displace.
    """
    if given is None:
        given = shape.centre_of_gravity
    if given is not None:
        return given
    slices = slices_of(shape)
    volume = math.fsum(each.volume for each in slices)
    spread = math.fsum(each.volume * each.middle for each in slices) / volume * shape.mass
    return (spread + shape.ballast * shape.lowest) / shape.total_mass


def wind_on(speed: float, shape: BuoyShape, draught: float) -> tuple[float, float]:
    """Force of the wind, N, and the height above the hull's bottom at which it acts, m."""
    height = shape.tower_height or math.fsum(each.height for each in shape.pylons)
    areas = (
        (shape.outline(low=draught), 0.5 * (draught + shape.deck)),
        (shape.tower_area, shape.deck + 0.5 * height),
        (shape.marks_area, shape.deck + height),
    )
    area = math.fsum(each for each, _ in areas)
    if area == 0.0:
        return 0.0, shape.deck
    force = 0.5 * AIR_DENSITY * shape.drag_in_air * area * speed**2
    return force, math.fsum(each * z for each, z in areas) / area


def heel_at_rest(
    shape: BuoyShape,
    density: float,
    pull: float,
    wind: float,
    current: float,
    centre_of_gravity: float | None = None,
) -> float | None:
    """Heel of a buoy under steady forces, rad; None for one that would not float upright.

    Wind and current push where their areas are, N; the line holds both at the eye, and its pull
    downwards, N, rights it. M cos a = K sin a, with the slope K of the upright buoy: above some
    15 deg, where the deck dips, it is an estimate.
    """
    draught, centre = shape.afloat(pull, density).draught, centre_of(shape, centre_of_gravity)
    second = lever = seen = middle = 0.0
    for each in slices_of(shape):
        wet = min(max(draught - each.foot, 0.0), each.top - each.foot)
        area = each.volume / (each.top - each.foot)
        if each.foot < draught <= each.top:
            second += 0.25 * area**2 / math.pi
        lever += area * wet * (each.foot + 0.5 * wet - centre)
        seen += each.width * wet
        middle += each.width * wet * (each.foot + 0.5 * wet)
    slope = density * STANDARD_GRAVITY * (second + lever)
    slope += pull * max(centre - shape.eye, 0.0)
    if slope <= 0.0:
        return None
    _, high = wind_on(1.0, shape, draught)
    moment = wind * (high - shape.eye) + current * (middle / seen - shape.eye)
    return math.atan2(moment, slope)
