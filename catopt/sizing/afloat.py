"""The case of a sizing with what it knows of the sea, so that its line runs in motion as it is."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from catopt.catalogue import component, standard
from catopt.checks.profiles import profiles_of
from catopt.loads.buoy import buoys
from catopt.loads.buoy_shape import BuoyShape
from catopt.model import Case, CurrentProfile, Dynamics, Floater, LoadCase, Segment, WaveState
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.in_motion import RunsAfloat

COMPONENTS: Final = 100
"""Waves of equal energy that the sea consists of: half of the usual, for time."""
MOTION_CODE: Final = "API-RP-2SK"
"""What judges lines in motion in the place of codes without factors for dynamic analysis."""
MOST_SLIDE: Final = 1.0
"""How far a sinker may then slide in the storm, m: catopt's own number."""
_STIFF: Final = "chain studless R3"
"""Chain whose axial stiffness, per area of bar, stands for one of which no source states any."""


def buoy_afloat(case: Case, request: BuoyRequest) -> Case | None:
    """Add buoy, waves, current and the settings of a run to the case of its recommended line.

    None for a buoy that is not one of the library, or a sea without waves.
    """
    env, shape, how = request.environment, request.buoy, request.in_motion or RunsAfloat()
    sea = env.sea
    if not isinstance(shape, BuoyShape) or not sea.hs > 0.0:
        return None
    # A buoy of CALMAR's own file is one of the library, wherever that file lies.
    if not any(replace(each, origin=shape.origin) == shape for each in buoys()):
        return None
    segments = tuple(_stiff(each) for each in case.line.segments)
    source = case.source
    if any(math.isinf(each.EA) for each in case.line.segments):
        source = f"{source}; EA as that of {_STIFF}"
    flows = env.current.speed > 0.0
    return replace(
        case,
        line=replace(case.line, segments=segments),
        source=source,
        waves=WaveState("jonswap", sea.hs, sea.period, components=COMPONENTS),
        current=CurrentProfile("power", speed=env.current.speed) if flows else None,
        floater=Floater(
            shape.name, wind_speed=env.wind.speed, centre_of_gravity=how.centre_of_gravity
        ),
        dynamics=Dynamics(how.duration, elements=how.elements),
    )


def run_in_still_water(case: Case, request: BuoyRequest) -> Case | None:
    """Make the case whose runs decide on a line, as `buoy_afloat` does, with the request's runs.

    Its levels are those of still water: the crest that a load case at rest is raised by comes with
    the waves. Of load cases that then are alike one is left. By a code without factors for dynamic
    analysis, whose loads and factors stand for motion, the line is judged at rest alone; in motion
    by `MOTION_CODE`, and its sinker by how far it slides.
    """
    found, how = buoy_afloat(case, request), request.in_motion or RunsAfloat()
    if found is None or found.dynamics is None or found.anchor is None:
        return None
    checks, slide = found.checks, how.max_slide
    if any(not each.is_for_motion for each in profiles_of(checks)):
        checks = replace(checks, motion_code=MOTION_CODE)
        slide = slide or MOST_SLIDE
    anchor = replace(found.anchor, max_slide=slide)
    states: dict[tuple[float, object], LoadCase] = {}
    for each in found.load_cases:
        level = min(each.water_level, 0.0)
        states.setdefault((level, each.condition), replace(each, water_level=level))
    dynamics = replace(found.dynamics, runs=how.seeds, judged_by=how.judged_by)
    return replace(
        found,
        load_cases=tuple(states.values()),
        checks=checks,
        anchor=anchor,
        dynamics=dynamics,
        design=None,
    )


def _stiff(segment: Segment) -> Segment:
    if not math.isinf(segment.EA) or not segment.nominal_diameter:
        return segment
    diameter = segment.nominal_diameter
    least, greatest = standard().family(_STIFF).range
    known = min(max(diameter, least), greatest)
    per_area = component(_STIFF, known).segment(1.0).EA / known**2
    return replace(segment, EA=per_area * diameter**2)
