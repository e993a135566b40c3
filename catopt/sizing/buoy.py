"""A buoy's chain and sinker from its place and its weather."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

from catopt.constants import STANDARD_GRAVITY
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.result import DesignPoint
from catopt.errors import refused
from catopt.largest import largest
from catopt.loads.buoy import check_breaking
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.environment import WaterLevels
from catopt.model import Buoy, Design, LoadCase
from catopt.sizing.answer import (
    case_of,
    in_place_of_allowance,
    loads_on,
    new_and_worn,
    sizing_of,
    worn_name,
)
from catopt.sizing.buoy_request import BuoyRequest
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
from catopt.sizing.floating import floats_in_storm
from catopt.sizing.line_choice import LineChoice, sold
from catopt.sizing.maintenance import upkeep_of
from catopt.sizing.result import Sizing, SwingPart, SwingRadius
from catopt.sizing.ship_afloat import buoy_afloat
from catopt.words import Measure, Message

GROWTH_DENSITY: Final = 1325.0
"""kg/m3, of marine growth: recalled (R) of DNV-OS-E301."""

if TYPE_CHECKING:
    from catopt.sizing.motion_search import Moved


def sized_buoy(request: BuoyRequest) -> Sizing:
    """Size the chain and the sinker of a buoy.

    The loads of wind, current and waves make a case with a storm at high and one at low water; the
    design search finds its best lines. The loads are those on a chain of at least the recommended
    size and under at least its pull (`catopt.sizing.converge`). InputError: no such chain, reserve
    buoyancy below the weight of any chain. NoFeasibleDesignError: nothing that is sold passes.
    BreakingSeaError: CALMAR has no answer where waves break.
    """
    env = request.environment
    for levels in (env.levels, WaterLevels.steady(env.levels.low)):
        check_breaking(env.sea, levels, request.load_method)
    _check_reserve(request)
    aim = request.scope * env.levels.deepest(env.sea)
    request = replace(request, line=replace(request.line, aim=aim))
    request, settled = _within_scope(request)

    def of_line(line: LineChoice) -> ConvergedSizing:
        return _settled(replace(request, line=line))

    moved = None
    others: dict[str, Any] = {}
    if request.in_motion is not None:
        from catopt.sizing.motion_search import can_be_run, search_in_motion

        if request.in_motion.quick and not can_be_run(settled, request):
            request = replace(request, in_motion=None)
    if request.in_motion is not None:
        moved = search_in_motion(request, settled, of_line)
        settled = moved.settled
    else:
        others["of_line"] = of_line
        others["of_size"] = lambda line, size: _settled(
            replace(request, line=line), replace(settled.needed, diameter=size)
        )
    found = sizing_of(
        "buoy",
        request,
        settled,
        **others,
        swing=_swing,
        assumptions=tuple(_assumptions(request, settled.assumed)),
        afloat=buoy_afloat(settled.case, request),
    )
    if moved is not None:
        found = _moved_sizing(found, request, moved)
    shape = request.buoy if isinstance(request.buoy, BuoyShape) else None
    return replace(
        found,
        shape=shape,
        floats=floats_in_storm(request, found),
        prices=request.upkeep,
        upkeep=upkeep_of(request, found),
        crane=request.crane,
    )


def _moved_sizing(of: Sizing, request: BuoyRequest, moved: Moved) -> Sizing:
    """Put what the runs say in the place of what an allowance for motion would."""
    case, assumptions = moved.in_motion.case, of.assumptions
    if case.anchor is not None and case.anchor.max_slide is not None:
        assumptions += (Message("sizing.may_slide", way=case.anchor.max_slide),)
    found = in_place_of_allowance(
        of, moved.in_motion, Message("sizing.motion_by_runs"), moved.sinker
    )
    return replace(
        found,
        afloat=case,
        assumptions=assumptions,
        other_sinker=request.ground.by_other_rule(moved.sinker, request.environment.water_density),
    )


def _within_scope(request: BuoyRequest) -> tuple[BuoyRequest, ConvergedSizing]:
    """Settle loads and line within the scope of practice, or beyond it where nothing passes.

    With what was asked for in the end.
    """
    try:
        return request, _settled(request)
    except NoFeasibleDesignError:
        least, most = request.line.scope
        if math.isinf(most):
            raise
        longer = replace(request, line=replace(request.line, scope=(least, math.inf)))
        said = Message("sizing.beyond_scope", scope=most)
        return replace(longer, defaults=(*request.defaults, said)), _settled(longer)


def _swing(settled: ConvergedSizing) -> SwingRadius:
    low = Message("sizing.storm_low")
    spans = {name: solution.span for name, solution in settled.point.checks.solutions}
    widest = largest((low, worn_name(low)), lambda name: spans.get(name, 0.0))
    return SwingRadius(widest, (SwingPart(Message("sizing.line_at_low_water"), spans[widest]),))


def _settled(request: BuoyRequest, start: Assumed | None = None) -> ConvergedSizing:
    """Settle loads and line on each other."""

    def needed(_: SizingCase, point: DesignPoint) -> Assumed:
        pull = min(rounded_up(point_pull(point)), request.reserve_buoyancy)
        return Assumed(point_diameter(point), pull)

    return converge(lambda assumed: pose_buoy(request, assumed), needed, request.line, start)


def _eye(request: BuoyRequest, assumed: Assumed) -> float:
    """From the water to where the chain is made fast, m."""
    return request.eye_depth(min(assumed.pull, request.reserve_buoyancy))


def pose_buoy(request: BuoyRequest, assumed: Assumed) -> SizingCase:
    """Make the case of a buoy whose size of chain and pull are assumed."""
    env, line = request.environment, request.line
    eye, levels = _eye(request, assumed), env.levels

    def loads_at(water: Water, at: WaterLevels) -> LoadsAt:
        name = Message(f"sizing.storm_{water}")
        if not isinstance(request.buoy, BuoyShape):
            return LoadsAt(name, at.high, water, given=request.buoy.horizontal_force)
        part = loads_on(
            request.buoy,
            env,
            at,
            assumed,
            marine_growth=request.marine_growth,
            wave_height=request.wave_height,
            chain_waves=request.chain_waves,
            method=request.load_method,
        )
        return LoadsAt(name, at.high, water, parts=(part,))

    low = WaterLevels.steady(levels.low)
    loads = loads_at("high", levels), loads_at("low", low)
    rises = (env.crest, levels.low - levels.high)
    height = levels.high + env.crest - eye
    case = case_of(
        request,
        body=request.buoy.name,
        length=2.0 * height,
        rest=0.0,
        fairlead_height=levels.high - eye,
        load_cases=new_and_worn(
            (
                LoadCase(each.load_case, line.allowance * each.horizontal_force, rise)
                for each, rise in zip(loads, rises, strict=True)
            ),
            line.service,
        ),
        buoy=Buoy(_reserve_left(request, assumed)),
        design=Design(
            segments=(line.segment(height, depth=levels.high),),
            objectives=line.objectives,
            sinker=request.ground.choice(coded=line.has_factor("sliding")),
        ),
    )
    return SizingCase(case, loads)


def growth_weight(request: BuoyRequest, assumed: Assumed) -> float:
    """Weight in water of the growth on hull and hanging chain, N; 0 where none is given.

    On a chain of bar d the growth t weighs 2 (1325 - rho) g pi/4 ((d + 2 t)^2 - d^2) a metre, as
    DNV-OS-E301 has it, recalled (R): it counts where a user names a growth. What hangs of the chain
    is the pull over its own weight a metre.
    """
    growth, shape, rho = request.marine_growth, request.buoy, request.environment.water_density
    if growth == 0.0 or not isinstance(shape, BuoyShape):
        return 0.0
    heavier = (GROWTH_DENSITY - rho) * STANDARD_GRAVITY
    draught = shape.afloat(min(assumed.pull, request.reserve_buoyancy), rho).draught
    wet = math.pi * shape.outline(high=draught) + 0.25 * math.pi * shape.widest**2
    d = assumed.diameter
    chain = min(sold(request.line, rho), key=lambda each: abs((each.nominal_diameter or 0.0) - d))
    ring = 2.0 * 0.25 * math.pi * ((d + 2.0 * growth) ** 2 - d**2)
    return heavier * (wet * growth + ring * assumed.pull / chain.submerged_weight)


def _reserve_left(request: BuoyRequest, assumed: Assumed) -> float:
    """Reserve of buoyancy that growth leaves, N."""
    growth = growth_weight(request, assumed)
    left = request.reserve_buoyancy - growth
    if left <= 0.0:
        values = {"weight": growth / 1e3, "reserve": request.reserve_buoyancy / 1e3}
        allowed = Message("sizing.growth_sinks", **values)
        raise refused("marine_growth", f"{request.marine_growth:g} m", allowed, "BuoyRequest")
    return left


def _check_reserve(request: BuoyRequest) -> None:
    """Refuse a buoy that the lightest chain would pull under, hanging straight down."""
    density = request.environment.water_density
    lightest = min(sold(request.line, density), key=lambda each: each.submerged_weight)
    height = request.environment.levels.high + request.environment.crest - request.eye_depth(0.0)
    weight = lightest.submerged_weight * height
    if weight >= request.reserve_buoyancy:
        name = lightest.name or lightest.component
        values = {"weight": weight / 1e3, "height": height, "name": name}
        allowed = Message("sizing.below_lightest", **values)
        reserve = f"{request.reserve_buoyancy / 1e3:.3g} kN"
        if not isinstance(request.buoy, BuoyShape):
            raise refused("reserve_buoyancy", reserve, allowed, "BuoyRequest")
        allowed = Message("sizing.buoy_carries", reserve=reserve, allowed=allowed)
        raise refused("buoy", f'"{request.buoy.name}"', allowed, "BuoyRequest")


def _assumptions(request: BuoyRequest, assumed: Assumed) -> Iterator[str]:
    env, service, eye = request.environment, request.line.service, _eye(request, assumed)
    levels = {"high": env.levels.high, "crest": env.crest, "low": env.levels.low, "keel": eye}
    yield Message("sizing.high_water", **levels)
    if isinstance(request.buoy, BuoyShape):
        pull = Measure("vertical_force", assumed.pull)
        yield Message("sizing.loads_on_chain", diameter=assumed.diameter * 1e3, pull=pull)
    else:
        yield Message("sizing.force_given")
        if env.sea.breaks(env.levels):
            yield Message("loads.departs_breaking")
    grown = growth_weight(request, assumed)
    if grown > 0.0:
        yield Message("sizing.growth_weighs", weight=Measure("vertical_force", grown))
    if service is None:
        yield Message("sizing.as_new")
    else:
        yield Message("sizing.worn", loss=service.diameter_loss() * 1e3)
    # Where a buoy that is afloat in still water touches the bed between two crests.
    keel = request.keel_depth(min(assumed.pull, request.reserve_buoyancy))
    room = env.levels.low - 0.5 * env.sea.height_in(env.levels.low) - keel
    if room < 0.0:
        yield Message("sizing.touches_bed", depth=-room)
