"""A tanker's mooring from its place and its weather: one line, or several around a body."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Final, NamedTuple

from catopt.constants import STANDARD_GRAVITY
from catopt.design.result import DesignPoint
from catopt.errors import NoAnswerError
from catopt.largest import largest
from catopt.loads.component import Loads
from catopt.loads.environment import WaterLevels
from catopt.model import Buoy, ClumpWeightChoice, Design, LoadCase
from catopt.sizing.answer import (
    case_of,
    in_place_of_allowance,
    loads_on,
    new_and_worn,
    sizing_of,
    worn_name,
)
from catopt.sizing.converge import (
    Assumed,
    ConvergedSizing,
    LoadsAt,
    SizingCase,
    Water,
    converge,
    point_diameter,
    point_pull,
    rounded_up,
)
from catopt.sizing.environment import turning_words
from catopt.sizing.line_choice import longest_useful
from catopt.sizing.pattern import BodyState, DragGround, Pattern, pattern, shared_force
from catopt.sizing.result import Sizing, SwingPart, SwingRadius
from catopt.sizing.ship_afloat import runs_quickly, ship_afloat, worst_lying
from catopt.sizing.tanker_request import MooredShip, TankerRequest
from catopt.words import Measure, Message

EVERYDAY_SHARE: Final = 0.1
"""Of the largest force: the state that the excursion of a single line starts from; catopt's own."""

_CLUMP_PLACES: Final = (0.25, 0.5, 1.0, 1.5, 2.0, 3.0)
"""Where a clump weight may hang: from the anchor, in heights that the line spans."""

_SCOPE: Final = 6.0
"""Of a ship's cable, in depths: what UR A1 takes for her own anchors (C)."""

_ON_THE_BOW: Final = 0.1
"""Of a ship's weight: what lines may pull her bow down with; catopt's own. The bow of a box goes
down by four times as much of the draught."""

_MOST_TRIES: Final = 8
_LESS: Final = 0.98
"""Of the pull that would just do: less, for the other lines pull more where this one pulls less."""

_LITTLE_WATER: Final = 0.1
"""Of the draught: less than that under the keel is told."""


class _State(NamedTuple):
    """A condition of the ship at a water level, and how much higher its fairlead is there."""

    name: str
    moored: MooredShip
    water: Water
    depth: float
    level: float
    rise: float


def sized_tanker(request: TankerRequest) -> Sizing:
    """Size the chain and the anchor of a tanker's mooring.

    The ship lies head to wind, current and waves, or as it turns to them where they come from
    different directions. Of a single line the horizontal force is that of
    the loads. Of several lines around the body it is at first that of the rule of practice of S4;
    the mooring equilibrium then says what the most loaded line carries, and the line is sized anew
    for no less than that (`catopt.sizing.converge`). InputError: no such chain, a buoy pulled
    under. NoAnswerError: nothing that is sold passes; the buoy does not carry all lines.
    """
    rest = request.beyond_the_line
    aim = max(rest, _SCOPE * request.environment.levels.high)
    line = replace(request.line, rest=rest, aim=aim)
    request = replace(request, line=line)
    settled = _settled(request)
    if request.in_motion is not None and request.in_motion.quick and not runs_quickly(request):
        request = replace(request, in_motion=None)
    if request.in_motion is not None:
        return _sized_in_motion(request, settled)
    around = _around(request, settled)
    _check_bow(request, settled, around)
    masses = (load.mass for load in settled.point.line.point_loads)
    narrowed = replace(request, clump_masses=tuple(each for each in masses if each is not None))
    return sizing_of(
        "tanker",
        request,
        settled,
        of_size=lambda line, _: _settled(replace(narrowed, line=line), settled.needed),
        of_line=lambda line: _settled(replace(request, line=line), settled.needed),
        swing=lambda each: _swing(
            request, each, around if each is settled else _around(request, each)
        ),
        drag_anchor=settled.posed.drag_anchor,
        pattern=around,
        ship_case=ship_afloat(request, settled, around),
        assumptions=tuple(_assumptions(request, settled)),
    )


def _check_bow(request: TankerRequest, settled: ConvergedSizing, around: Pattern | None) -> None:
    """Raise NoAnswerError where lines at a ship's bow pull her down by more than she carries."""
    if request.buoy is not None:
        return
    volume = min(each.ship.displacement for each in request.ships)
    weight = volume * request.environment.water_density * STANDARD_GRAVITY
    pull = point_pull(settled.point) if around is None else around.largest_pull
    if pull > _ON_THE_BOW * weight:
        share, most = 100.0 * pull / weight, 100.0 * _ON_THE_BOW
        values = {"pull": pull / 1e3, "share": share, "most": most}
        raise NoAnswerError(Message("sizing.bow_pulled_down", **values))


def _sized_in_motion(request: TankerRequest, at_rest: ConvergedSizing) -> Sizing:
    """Recommend a line that passes in motion, and put what its runs say in place of an allowance.

    Lines of other sizes and preferences were not run, and how long a chain may wear is known at
    rest alone: nothing is said of them.
    """
    from catopt.sizing.ship_search import search_ship_in_motion

    moved = search_ship_in_motion(request, at_rest, _settled, _around)
    _check_bow(request, moved.settled, moved.around)
    name, span = moved.span
    first = _swing(request, moved.settled, moved.around).parts
    key = "sizing.line_in_motion" if moved.around is None else "sizing.offset_line_out"
    first = (SwingPart(Message(key), span), *first[1:])
    found = sizing_of(
        "tanker",
        request,
        moved.settled,
        swing=lambda _: SwingRadius(name, first),
        drag_anchor=moved.drag_anchor,
        pattern=moved.around,
        ship_case=moved.in_motion.case,
        assumptions=tuple(_assumptions(request, moved.settled)),
    )
    return in_place_of_allowance(
        found, moved.in_motion, Message("sizing.motion_by_ship_runs"), moved.sinker
    )


def pose_tanker(
    request: TankerRequest, assumed: Assumed, reserve: float | None = None
) -> SizingCase:
    """Make the case of one line of a tanker's mooring.

    `assumed`: chain and pull that the loads on the buoy are computed for, and the least horizontal
    force of the line in each load case; `reserve`: what the line may pull down on a buoy, N.
    """
    states, levels = tuple(_states(request)), request.environment.levels
    base = levels.high + _fairlead(request, request.ships[0])
    loads = tuple(_loads_at(request, each, assumed) for each in states)
    forces = _line_forces(request, loads, assumed)
    height = base + max(state.level + state.rise for state in states)
    drag = anchor = None
    if isinstance(request.ground, DragGround):
        drag = request.ground.sized(max(forces))
        anchor = request.ground.held(drag)
    cases = [
        LoadCase(state.name, force, state.level, fairlead_rise=state.rise)
        for state, force in zip(states, forces[: len(states)], strict=True)
    ]
    if request.lines == 1:
        everyday = Message("sizing.everyday")
        cases.append(LoadCase(everyday, EVERYDAY_SHARE * max(forces), 0.0, "reference"))
    for intact, force in zip(tuple(cases), forces[len(states) :], strict=False):
        name = Message("sizing.one_line_out", load_case=intact.name)
        cases.append(replace(intact, name=name, horizontal_force=force, state="one_line_out"))
    case = case_of(
        request,
        body=request.ships[0].ship.name,
        length=3.0 * height,
        rest=request.beyond_the_line,
        fairlead_height=base,
        load_cases=new_and_worn(cases, request.line.service),
        buoy=None if reserve is None else Buoy(reserve),
        anchor=anchor,
        design=_design(request, height),
    )
    return SizingCase(case, loads, drag)


def _settled(request: TankerRequest, start: Assumed | None = None) -> ConvergedSizing:
    """Settle loads and line on each other, within what the buoy carries of all lines."""
    reserve = request.reserve_buoyancy
    if reserve is None or request.lines == 1:
        return _settled_within(request, reserve, start)
    allowed = reserve
    for _ in range(_MOST_TRIES):
        settled = _settled_within(request, allowed, start)
        pull = _pattern(request, settled.posed, settled.point).largest_pull
        if pull <= reserve:
            return settled
        # Of the pull of all, one line has its part: the search is to find a line with less of it.
        allowed = _LESS * point_pull(settled.point) * reserve / pull
    pulled = {"pull": pull / 1e3, "more": (pull - reserve) / 1e3}
    raise NoAnswerError(Message("sizing.pulled_under", lines=request.lines, **pulled))


def _settled_within(
    request: TankerRequest, allowed: float | None, start: Assumed | None
) -> ConvergedSizing:
    """Settle loads and line on each other; `allowed` is what one line may pull down, N."""
    reserve = request.reserve_buoyancy

    def needed(posed: SizingCase, point: DesignPoint) -> Assumed:
        diameter = point_diameter(point) if request.buoy is not None else 0.0
        pull = point_pull(point)
        forces: tuple[float, ...] = ()
        if request.lines > 1:
            found = _pattern(request, posed, point)
            pull = found.largest_pull
            carried = (*found.states, *(state.line_out for state in found.states))
            forces = tuple(rounded_up(each.line_force, 3) for each in carried)
        return Assumed(diameter, 0.0 if reserve is None else min(rounded_up(pull), reserve), forces)

    return converge(
        lambda assumed: pose_tanker(request, assumed, allowed), needed, request.line, start
    )


def _states(request: TankerRequest) -> Iterator[_State]:
    """Put each condition at high and at low water; once where these are the same."""
    levels = request.environment.levels
    crest = request.environment.crest if request.buoy is not None else 0.0
    first = _fairlead(request, request.ships[0])
    for each in request.ships:
        higher = _fairlead(request, each) - first
        high = Message(f"sizing.{each.condition}_high")
        yield _State(high, each, "high", levels.high, crest, higher)
        fall = levels.high - levels.low
        if fall or crest:
            low = Message(f"sizing.{each.condition}_low")
            yield _State(low, each, "low", levels.low, -fall, higher)


def _fairlead(request: TankerRequest, moored: MooredShip) -> float:
    """Height of the fairlead above the still water, m: at the bow, or below the buoy."""
    if request.buoy is None:
        return moored.fairlead
    return -request.buoy.afloat(0.0, request.environment.water_density).eye_depth


def _loads_at(request: TankerRequest, state: _State, assumed: Assumed) -> LoadsAt:
    env = request.environment
    lying = worst_lying(request, state.moored, state.depth, request.weathervaning.directions)
    parts: list[Loads] = [lying.loads]
    if request.buoy is not None:
        parts.append(loads_on(request.buoy, env, WaterLevels.steady(state.depth), assumed))
    where = state.name, state.depth, state.water, state.moored.condition
    return LoadsAt(*where, parts=tuple(parts), lying=lying)


def _line_forces(
    request: TankerRequest, loads: tuple[LoadsAt, ...], assumed: Assumed
) -> tuple[float, ...]:
    """Horizontal force of one line in each load case, N: of several, then with one line out."""
    totals = [request.line.allowance * each.horizontal_force for each in loads]
    if request.lines == 1:
        return tuple(totals)
    totals *= 2
    least = assumed.forces or (0.0,) * len(totals)
    return tuple(
        max(shared_force(total, request.lines), force)
        for total, force in zip(totals, least, strict=True)
    )


def _design(request: TankerRequest, height: float) -> Design:
    line = request.line
    weights: tuple[ClumpWeightChoice, ...] = ()
    if request.clump_masses:
        places = request.clump_places or tuple(
            float(round(share * height) or 1) for share in _CLUMP_PLACES
        )
        weights = (
            ClumpWeightChoice(
                masses=tuple(sorted(request.clump_masses)),
                density=request.clump_density,
                positions=tuple(sorted(set(places))),
                name=Message("sizing.clump_weight"),
            ),
        )
    sinker = None
    if not isinstance(request.ground, DragGround):
        sinker = request.ground.choice(coded=line.has_factor("sliding"), heavy=True)
    longest = longest_useful(line, request.environment.water_density, height)
    return Design(
        segments=(line.segment(height, longest=longest),),
        objectives=line.objectives,
        clump_weights=weights,
        sinker=sinker,
    )


def _around(request: TankerRequest, settled: ConvergedSizing) -> Pattern | None:
    """Solve the equilibrium of several lines."""
    return _pattern(request, settled.posed, settled.point) if request.lines > 1 else None


def _pattern(request: TankerRequest, posed: SizingCase, point: DesignPoint) -> Pattern:
    """Solve the equilibrium of all lines, each like a design's."""
    case = posed.case
    extreme = [
        each for each in case.load_cases if each.state == "intact" and each.condition != "worn"
    ]
    factor = request.line.allowance
    states = [
        BodyState(each.load_case, factor * each.horizontal_force, case.under(state).fairlead_height)
        for each, state in zip(posed.loads, extreme, strict=True)
    ]
    return pattern(
        point.line,
        request.lines,
        states,
        pretension=request.pretension * max(state.horizontal_force for state in extreme),
        still_height=case.fairlead_height,
        seabed_friction=case.site.seabed_friction,
    )


def _swing(request: TankerRequest, settled: ConvergedSizing, around: Pattern | None) -> SwingRadius:
    """Add up how far the stern swings round the anchor, or round the middle of the pattern."""
    if around is not None:
        widest = largest(around.states, lambda state: state.line_out.offset)
        first = SwingPart(Message("sizing.offset_line_out"), widest.line_out.offset)
        name = widest.load_case
    else:
        every = settled.point.checks.solutions
        at_low = {each.load_case for each in settled.posed.loads if each.water == "low"}
        low = {*at_low, *map(worn_name, at_low)}
        there = [each for each in every if each[0] in low]
        name, solution = largest(there or every, lambda each: each[1].span)
        first = SwingPart(Message("sizing.line_at_low_water"), solution.span)
    parts = [first]
    if request.hawser > 0.0:
        parts.append(SwingPart(Message("sizing.hawser"), request.hawser))
    parts.append(SwingPart(Message("sizing.ship"), request.longest))
    return SwingRadius(name, tuple(parts))


def _lies(request: TankerRequest, settled: ConvergedSizing) -> Iterator[str]:
    """Say how the ship lies: head to everything, or how under the force that governs."""
    directions, turning = request.weathervaning
    if turning is None:
        said = "sizing.weathervanes" if request.in_motion is None else "sizing.weathervanes_in_runs"
        yield Message(said)
        return
    worst = largest(settled.posed.loads, lambda each: each.horizontal_force)
    lying = worst.lying
    assert lying is not None
    came = lying.directions
    angles = {"wind": came.wind, "current": came.current, "waves": came.waves}
    yield Message(
        "sizing.heading_governs",
        count=len(directions),
        load_case=worst.load_case,
        force=Measure("horizontal_force", worst.horizontal_force),
        heading=math.degrees(lying.heading),
        **{name: math.degrees(angle) for name, angle in angles.items()},
    )
    yield turning_words(turning, lying.afloat.ship)
    if request.buoy is not None:
        yield Message("sizing.buoy_from_one_side")


def _assumptions(request: TankerRequest, settled: ConvergedSizing) -> Iterator[str]:
    env = request.environment
    yield from _lies(request, settled)
    if all(each.condition == "loaded" for each in request.ships):
        yield Message("sizing.loaded_alone")
    yield from request.estimates
    if request.buoy is None:
        yield Message("sizing.at_the_bow")
    else:
        diameter = settled.assumed.diameter * 1e3
        name = request.buoy.name
        yield Message("sizing.at_a_buoy", buoy=name, crest=env.crest, diameter=diameter)
    if request.lines > 1:
        yield Message("sizing.equal_lines", lines=request.lines)
        reserve, own = request.reserve_buoyancy, settled.posed.case.buoy
        if reserve is not None and own is not None and own.reserve_buoyancy < reserve:
            # What is left of the buoy's reserve to one line.
            values = {"reserve": reserve, "own": own.reserve_buoyancy}
            said = {name: Measure("vertical_force", force) for name, force in values.items()}
            yield Message("sizing.share_of_reserve", **said)
    else:
        everyday = Message("sizing.everyday")
        yield Message("sizing.excursion_from", share=100 * EVERYDAY_SHARE, load_case=everyday)
    for each in request.ships:
        room = env.levels.low - each.ship.draught
        if room < _LITTLE_WATER * each.ship.draught:
            yield Message(f"sizing.little_water_{each.condition}", room=room)
