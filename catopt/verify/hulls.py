"""Hulls that are stepped with their lines: one row a kind; see docs/architecture.md."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final, NamedTuple

from catopt.fem.solve import Leg
from catopt.floater.alone import freedoms
from catopt.floater.hulls import buoy_hull, floating_buoy, hull_of_files
from catopt.hydro.build import IN_PLANE, FloatingHull, HullOfCoefficients, SteppedHull
from catopt.model import Case
from catopt.verify.dynamic_setup import Excitation
from catopt.verify.motion_file import energy_beyond
from catopt.waves import wavelength
from catopt.words import Message

_SMALL: Final = 0.2
"""Part of the wave length above which a hull is not small beside it."""


class HullKind(NamedTuple):
    """A kind of hull.

    `make`: from a case, InputError where it would not float upright; on several lines it has an eye
    for each. `remarks`: what is assumed of it, and where the method ends.
    """

    make: Callable[[Case], SteppedHull]
    remarks: Callable[[Excitation, Any, Sequence[Leg]], Iterator[Message]]


def hull_of(case: Case) -> SteppedHull:
    """Make the hull of what floats in a case; InputError where it would not float upright."""
    assert case.floater is not None
    return HULLS[case.floater.kind].make(case)


def _buoy(case: Case) -> FloatingHull:
    """Make that of a buoy: its eyes are at the height of its own, off its axis by the fairleads."""
    of, site = case.floater, case.site
    assert of is not None
    pull = 0.0
    for line in case.every_line:
        heavy = sum(each.submerged_weight * each.length for each in line.segments)
        pull += heavy / line.length * min(site.water_depth, line.length)
    hull = buoy_hull(of, site.water_depth, site.water_density, pull)
    ((*_, height),) = hull.eyes
    eyes = tuple((*leg.fairlead, height) for leg in case.legs)
    return replace(hull, eyes=eyes) if eyes else hull


def _of_buoy(drive: Excitation, hull: FloatingHull, legs: Sequence[Leg]) -> Iterator[Message]:
    case, of = drive.one, drive.one.floater
    assert of is not None
    shape = floating_buoy(of)
    # Weather and lines may leave the buoy in the plane of x and z.
    broken = drive.dynamics.broken_line
    lost = None if broken is None else broken - 1
    is_in_plane = freedoms(hull, legs, drive.sea(0), lost) == IN_PLANE
    moves = "floater.moves" if is_in_plane else "floater.moves_all"
    yield Message(moves, buoy=shape.name, draught=hull.draught)
    if of.centre_of_gravity is None or of.pitch_radius is None:
        radius = math.sqrt(hull.inertia / hull.mass)
        yield Message("floater.assumed_mass", centre=hull.centre, radius=radius)
    if of.pitch_damping is None:
        yield Message("floater.pitch_damping")
    yield Message("floater.heave_drag", drag=of.heave_drag)
    for train in case.waves.all_trains if case.waves is not None else ():
        length = wavelength(train.period, case.site.water_depth)
        if shape.widest > _SMALL * length:
            yield Message("floater.wide", width=shape.widest, length=length)
    yield Message("floater.linear_radiation")
    if any(case.own_force):
        given = math.hypot(*case.own_force) / 1e3
        yield Message("floater.own_force_of_buoy", given=given)


def _by_files(case: Case) -> HullOfCoefficients:
    """Make that of a panel program's files: its eyes are the fairleads themselves."""
    of, site = case.floater, case.site
    assert of is not None
    assert of.hull is not None
    return hull_of_files(of.hull, case.own_system, site.water_depth, site.water_density)


def _of_files(drive: Excitation, hull: HullOfCoefficients, _: Sequence[Leg]) -> Iterator[Message]:
    known, waves = hull.coefficients, drive.sea(0).waves
    yield Message("floater.by_coefficients", mass=hull.mass / 1e3, source=known.source)
    yield from known.remarks
    yield Message("floater.no_drift", given=math.hypot(*hull.force) / 1e3)
    if waves is not None and (beyond := energy_beyond(known.omega, waves)):
        yield Message("floater.beyond_coefficients", part=beyond)


HULLS: Final[Mapping[str, HullKind]] = {
    "buoy": HullKind(_buoy, _of_buoy),
    "hull": HullKind(_by_files, _of_files),
}
"""By their keys in `catopt.model.system.FLOATERS`; what is on two time scales is not stepped."""
