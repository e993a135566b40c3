"""The case of a sizing with what it knows of the sea, which runs in motion as it is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any, Final, Literal, cast, get_args

from catopt.catalogue import component, standard
from catopt.checks.profiles import profiles_of
from catopt.largest import largest
from catopt.loads.buoy import buoys
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.environment import Headings
from catopt.loads.ship import TAKEN_FOR, ShipKind
from catopt.loads.ship_coefficients import SQUARE_ENDED
from catopt.loads.ship_loads import METHODS
from catopt.loads.ship_ranges import at_the_end
from catopt.loads.weathervane import (
    CLARKE_LEVER,
    YAW_TYPES,
    Afloat,
    ShipHeading,
    Turning,
    every_lying,
)
from catopt.model import (
    Case,
    CurrentProfile,
    Dynamics,
    Floater,
    LoadCase,
    Segment,
    ShipAfloat,
    System,
    WaveState,
)
from catopt.model.wear import worn_line
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.converge import ConvergedSizing
from catopt.sizing.environment import LONGEST_MEAN, WIND_MEAN, Environment, Weathervaning, mean_over
from catopt.sizing.in_motion import RunsAfloat, Sea
from catopt.sizing.pattern import Pattern, system_case
from catopt.sizing.tanker_request import MooredShip, TankerRequest

COMPONENTS: Final = 100
"""Waves of equal energy that the sea consists of: half of the usual, for time."""
MOTION_CODE: Final = "API-RP-2SK"
"""What judges lines in motion in the place of codes without factors for dynamic analysis."""
MOST_SLIDE: Final = 0.1
"""How far a sinker may then slide in the storm, over the length of its line: catopt's own number.
A buoy swings about as far as its line is long, so that nobody sees her a tenth of it off."""
_STIFF: Final = "chain studless R3"
"""Chain whose axial stiffness, per area of bar, stands for one of which no source states any."""


def buoy_afloat(case: Case, request: BuoyRequest) -> Case | None:
    """Add buoy, waves, current and the settings of a run to the case of its recommended line.

    None for a buoy that is not of the library, or has marine growth, which runs know nothing of,
    or a sea without waves.
    """
    env, shape, how = request.environment, request.buoy, request.in_motion or RunsAfloat()
    sea = env.sea
    if not isinstance(shape, BuoyShape) or not sea.hs > 0.0 or request.marine_growth:
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
            shape.name,
            wind_speed=env.wind.speed,
            centre_of_gravity=how.centre_of_gravity,
            max_heel=how.max_heel,
            pitch_damping=how.pitch_damping,
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
        slide = slide or round(MOST_SLIDE * found.line.length, 1)
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


_RUN: Final = 3600.0
"""s, of a run: slow motion has periods of minutes."""
_RUNS: Final = 3
_COMPONENTS: Final = 200
_LEAST_FREEBOARD: Final = 0.01
"""m, where a fairlead in the water says nothing of the deck: the areas are given."""
_AHEAD: Final = 1e-9
"""rad, up to which a direction is from ahead."""


def runs_afloat(request: TankerRequest) -> bool:
    """Whether the ship can be run in motion: on her own lines, in waves, free to turn to weather.

    Not a ship at a buoy, one whose moment of the current is of two figures of her own or whose
    coefficients are of no file, loads by another method than UFC's current and Blendermann's wind,
    or a sea without waves.
    """
    turning, env = request.weathervaning.turning, request.environment
    of_file = all(
        each.coefficients in (None, SQUARE_ENDED) or each.coefficients.file
        for each in request.ships
    )
    return (
        request.buoy is None
        and of_file
        and all(_kind_of(each) is not None for each in request.ships)
        and (turning is None or turning.yaw is None or _yaw_of(turning) != "")
        and request.load_methods == METHODS[:1]
        and env.sea.hs > 0.0
    )


def runs_quickly(request: TankerRequest) -> bool:
    """Whether the fast judgement runs the ship: on a single line, where she can be run at all."""
    return request.lines == 1 and runs_afloat(request)


def _yaw_of(turning: Turning | None) -> Literal["", "Clarke-lever", "series-60", "FFG"]:
    """Name what the current turns a ship by; empty where that is her own, or Clarke's."""
    names: tuple[Literal["series-60", "FFG"], ...] = ("series-60", "FFG")
    if turning is None or turning.yaw is None:
        return ""
    if turning.yaw == CLARKE_LEVER:
        return CLARKE_LEVER
    return next((each for each in names if turning.yaw == YAW_TYPES[each]), "")


def worst_lying(
    request: TankerRequest, moored: MooredShip, depth: float, directions: Sequence[Headings]
) -> ShipHeading:
    """Find how the ship lies under the largest force; the line has no part in that."""
    return _worst_lying(
        Afloat(moored.condition, moored.ship, moored.wind_on, moored.coefficients),
        request.environment,
        depth,
        request.weathervaning._replace(directions=tuple(directions)),
        request.load_methods,
        request.wave_coefficient,
    )


@lru_cache(maxsize=64)
def _worst_lying(
    afloat: Afloat,
    env: Environment,
    depth: float,
    vane: Weathervaning,
    methods: tuple[str, ...],
    wave_coefficient: float | None,
) -> ShipHeading:
    every = every_lying(
        [afloat],
        env.wind,
        env.current,
        env.sea,
        [depth],
        vane.directions,
        methods=methods,
        turning=vane.turning,
        wave_coefficient=wave_coefficient,
        water_density=env.water_density,
    )
    return largest(every, lambda each: each.loads.horizontal_force)


def ship_afloat(
    request: TankerRequest,
    settled: ConvergedSizing,
    around: Pattern | None,
    load_case: str | None = None,
    *,
    line_out: bool = False,
    sea: Sea | None = None,
    directions: Headings | None = None,
    worn: bool = False,
    lull: bool = False,
) -> Case | None:
    """Add ship, wind, waves and current to the case of her lines in a load case, or the hardest.

    A single line is a system of one, its anchor where the everyday force has it. Several are turned
    so that the weather, along x, comes from the side that is hardest on a line at rest: with all
    there, or with `line_out` without line 1. `sea`: in the place of that of the place.
    `directions`: where wind, current and waves come from; of those of the request that of the
    largest force when left out. They are turned so that what she pulls at rest is along x. She
    turns about the bow, to which her lines go, or the request's own point. `worn`: the lines weigh
    what wear leaves of them at the end of their life. `lull`: no wind blows.
    None where she cannot be run: `runs_afloat`.
    """
    env = request.environment
    if not runs_afloat(request):
        return None
    height, period = sea or Sea(env.sea.hs, env.sea.period)
    case, loads = settled.case, settled.posed.loads
    if load_case is None and around is not None:
        load_case = around.hardest.load_case
    if load_case is None:
        load_case = largest(loads, lambda each: each.horizontal_force).load_case
    at = next(each for each in loads if each.load_case == load_case)
    if around is None:
        state = next(each for each in case.load_cases if each.name == load_case)
        held = _one_line(case, state, settled)
    else:
        there = around.state_in(load_case)
        rest = there.line_out if line_out else there
        made = system_case(case, replace(around, states=(there,)))
        held = _turned(made, rest.solution.system.force)
    if worn:
        own = held.own_system
        legs = (replace(leg, line=worn_line(leg.line, held.service)) for leg in own.legs)
        held = replace(held, system=replace(own, legs=tuple(legs)))
    moored = next(each for each in request.ships if each.condition == at.condition)
    vane = request.weathervaning
    lies = worst_lying(request, moored, at.depth, (directions,) if directions else vane.directions)
    off = _along_x(lies)
    blows = env.wind.speed > 0.0 and not lull
    wind = mean_over(env.wind.speed, WIND_MEAN, LONGEST_MEAN) if blows else 0.0
    flows = env.current.speed > 0.0
    checks = held.checks
    if any(not each.is_for_motion for each in profiles_of(checks)):
        checks = replace(checks, motion_code=MOTION_CODE)
    return replace(
        held,
        site=replace(held.site, water_depth=at.depth),
        checks=checks,
        waves=WaveState("jonswap", height, period, direction=off.waves, components=_COMPONENTS),
        current=_same_over_depth(env.current.speed, at.depth, off.current) if flows else None,
        floater=Floater(ship=_ship(moored, env.water_density, off, vane.turning), wind_speed=wind),
        dynamics=_dynamics(request.in_motion),
    )


def _same_over_depth(speed: float, depth: float, direction: float) -> CurrentProfile:
    """Give a ship the speed over all of her draught, as her loads at rest have it."""
    ends = ((0.0, depth), (speed, speed))
    return CurrentProfile("table", depths=ends[0], speeds=ends[1], direction=direction)


def _along_x(lies: ShipHeading) -> Headings:
    """Turn directions until what the ship pulls at rest is along x; where they go to, from x."""
    seen, pull = lies.headings, math.atan2(lies.loads.all_sway, -lies.loads.all_surge)
    ways = (each - pull for each in (seen.wind, seen.current, seen.waves))
    turned = (math.remainder(each, 2.0 * math.pi) for each in ways)
    # What the search for a heading leaves of a direction from ahead is no direction.
    return Headings(*(each if abs(each) > _AHEAD else 0.0 for each in turned))


def _dynamics(how: RunsAfloat | None) -> Dynamics:
    """Set the runs: those of the sizing, judged by what is most probable, or the usual ones."""
    if how is None:
        return Dynamics(_RUN, runs=_RUNS)
    return Dynamics(how.duration, runs=how.seeds, judged_by="most-probable")


def _one_line(case: Case, state: LoadCase, settled: ConvergedSizing) -> Case:
    """Put the line alone around the ship's mooring point, pulled away from its anchor."""
    rise = state.water_level + state.fairlead_rise
    height = case.fairlead_height + rise
    spans = {name: each.span for name, each in settled.point.checks.solutions}
    everyday = next(each for each in case.load_cases if each.kind == "reference")
    system = System.around(
        settled.point.line,
        azimuths=(math.pi,),
        anchor_radius=spans[everyday.name],
        fairlead_height=height,
        seabed_friction=case.site.seabed_friction,
        force=(state.horizontal_force, 0.0),
    )
    return replace(
        case,
        title=f"{case.title}: {state.name}",
        fairlead_height=height,
        load=None,
        load_cases=(),
        design=None,
        system=system,
    )


def _turned(case: Case, force: tuple[float, float]) -> Case:
    """Turn lines, and the loads that they are designed for, until a force of theirs is along x."""
    angle = math.atan2(force[1], force[0])
    system, design = case.own_system.turned(-angle), case.design
    if design is not None:
        loads = (replace(each, direction=each.direction - angle) for each in design.loads)
        design = replace(design, loads=tuple(loads))
    return replace(case, system=system.under((math.hypot(*system.force), 0.0)), design=design)


def _ship(
    moored: MooredShip, water_density: float, off: Headings, turning: Turning | None
) -> ShipAfloat:
    """Describe the ship that the loads at rest are of, at the unfavourable end of every range."""
    ship, own, kind = moored.ship, moored.coefficients, _kind_of(moored)
    assert kind is not None
    afloat = ShipAfloat(
        length=ship.length_overall,
        breadth=ship.breadth,
        draught=ship.draught,
        moulded_depth=ship.draught + max(moored.fairlead, _LEAST_FREEBOARD),
        condition="ballast" if moored.condition == "ballast" else "loaded",
        kind=kind,
        propeller=cast(Any, ship.propeller or ""),
        coefficients="" if own is None else own.file,
        length_waterline=ship.length_waterline,
        mooring_point=(turning or Turning(None)).lever(ship),
        displacement=ship.displacement * water_density,
        frontal_area=ship.frontal_area,
        lateral_area=ship.lateral_area,
        midship_area=ship.midship_area,
        lateral_centre=ship.lateral_centre,
        wind_direction=off.wind,
        current_yaw=_yaw_of(turning),
    )
    return at_the_end(afloat)


def _kind_of(moored: MooredShip) -> ShipKind | None:
    """Name a kind of ship that has the wind and the tables of a moored one; None: there is none."""
    if moored.coefficients == SQUARE_ENDED:
        return "barge"
    kinds: tuple[ShipKind, ...] = get_args(ShipKind)
    alike = (e for e in kinds if TAKEN_FOR[e][0].format(moored.condition) == moored.wind_on)
    return next(alike, None)
