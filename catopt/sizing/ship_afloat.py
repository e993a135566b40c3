"""The case of a ship's sizing with what it knows of the sea, so that the ship runs as it is."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from catopt.checks.profiles import profiles_of
from catopt.loads.environment import HEAD_ON
from catopt.model import (
    Case,
    CurrentProfile,
    Dynamics,
    Floater,
    LoadCase,
    ShipAfloat,
    System,
    WaveState,
)
from catopt.sizing.afloat import MOTION_CODE
from catopt.sizing.environment import WIND_MEAN, mean_over
from catopt.sizing.in_motion import RunsAfloat, Sea
from catopt.sizing.pattern import Pattern, system_case
from catopt.sizing.settle import ConvergedSizing
from catopt.sizing.tanker_request import MooredShip, TankerRequest
from catopt.ties import largest

_AN_HOUR: Final = 3600.0
_RUN: Final = 3600.0
"""s, of a run: slow motion has periods of minutes."""
_RUNS: Final = 3
_COMPONENTS: Final = 200


def runs_afloat(request: TankerRequest) -> bool:
    """Whether the ship can be run in motion: at her bow, all weather from ahead, in waves.

    Not a ship at a buoy, one whose loads come from several directions, or a sea without waves.
    """
    is_head_on = request.weathervaning.directions == (HEAD_ON,)
    return request.buoy is None and is_head_on and request.environment.sea.hs > 0.0


def ship_afloat(
    request: TankerRequest,
    settled: ConvergedSizing,
    around: Pattern | None,
    load_case: str | None = None,
    *,
    line_out: bool = False,
    sea: Sea | None = None,
) -> Case | None:
    """Add ship, wind, waves and current to the case of her lines in a load case, or the hardest.

    A single line is a system of one, its anchor where the everyday force has it. Several are turned
    so that the weather, along x, comes from the side that is hardest on a line at rest: with all
    there, or with `line_out` without line 1. `sea`: in the place of that of the place. The ship
    turns about the bow, to which her lines go.
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
        (there,) = (each for each in around.states if each.load_case == load_case)
        rest = there.line_out if line_out else there
        made = system_case(case, replace(around, states=(there,)))
        held = _turned(made, rest.solution.system.force)
    moored = next(each for each in request.ships if each.condition == at.condition)
    wind = mean_over(env.wind.speed, WIND_MEAN, _AN_HOUR) if env.wind.speed > 0.0 else 0.0
    flows = env.current.speed > 0.0
    checks = held.checks
    if any(not each.is_for_motion for each in profiles_of(checks)):
        checks = replace(checks, motion_code=MOTION_CODE)
    return replace(
        held,
        site=replace(held.site, water_depth=at.depth),
        checks=checks,
        waves=WaveState("jonswap", height, period, components=_COMPONENTS),
        current=CurrentProfile("power", speed=env.current.speed) if flows else None,
        floater=Floater(ship=_ship(moored, env.water_density), wind_speed=wind),
        dynamics=_dynamics(request.in_motion),
    )


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
    assert case.system is not None
    angle = math.atan2(force[1], force[0])
    system, design = case.system.turned(-angle), case.design
    if design is not None:
        loads = (replace(each, direction=each.direction - angle) for each in design.loads)
        design = replace(design, loads=tuple(loads))
    return replace(case, system=system.under((math.hypot(*system.force), 0.0)), design=design)


def _ship(moored: MooredShip, water_density: float) -> ShipAfloat:
    ship = moored.ship
    return ShipAfloat(
        length=ship.length_overall,
        breadth=ship.breadth,
        draught=ship.draught,
        moulded_depth=ship.draught + moored.fairlead,
        condition="ballast" if moored.condition == "ballast" else "loaded",
        mooring_point=0.5 * ship.length_overall,
        displacement=ship.displacement * water_density,
        frontal_area=ship.frontal_area,
        lateral_area=ship.lateral_area,
    )
