"""A buoy's chain and sinker from its place and its weather."""

from __future__ import annotations

from dataclasses import replace

from catopt.design.result import DesignPoint
from catopt.errors import InputError, Problem
from catopt.loads.buoy import buoy_loads
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.component import Loads
from catopt.loads.environment import WaterLevels
from catopt.model import Buoy, Case, Design, LoadCase, Site
from catopt.sizing.alternatives import alternatives
from catopt.sizing.assumed import Assumed, rounded_up
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.candidates import candidates
from catopt.sizing.components import catalogue_of, first_line, sold, unpriced_components
from catopt.sizing.limits import limits
from catopt.sizing.line_choice import Prefer
from catopt.sizing.posed import LoadsAt, Posed
from catopt.sizing.result import Sizing, SwingRadius
from catopt.sizing.settle import Settled, point_diameter, point_pull, settle
from catopt.words import Measure, Message

HIGH = "storm, high water"
LOW = "storm, low water"
"""Load cases of a buoy."""


def sized_buoy(request: BuoyRequest) -> Sizing:
    """Size the chain and the sinker of a buoy.

    The loads of wind, current and waves make a case with a storm at high and one at low water; the
    design search finds its best lines. The loads are those on a chain of at least the recommended
    size and under at least its pull (`catopt.sizing.settle`).

    Parameters
    ----------
    request : BuoyRequest
        Buoy, place, weather, and what the line may be.

    Returns
    -------
    Sizing
        With the case that `catopt.design_case` and `catopt.check_case` take.

    Raises
    ------
    InputError
        With what is wrong: no such chain, a reserve buoyancy below the weight of any chain.
    NoFeasibleDesignError
        Nothing that is sold passes every check.
    """
    _check_reserve(request)
    settled = _settled(request)
    solutions = dict(settled.point.checks.solutions)
    sinker = request.ground.sized(
        max(each.anchor.horizontal_force for each in solutions.values()),
        max(0.0, *(each.anchor.vertical_force for each in solutions.values())),
        request.environment.water_density,
    )
    return Sizing(
        kind="buoy",
        settled=settled,
        candidates=candidates(
            settled,
            lambda component, diameter: _settled(
                replace(request, line=request.line.only(component, diameter)),
                replace(settled.needed, diameter=diameter),
            ),
        ),
        alternatives=alternatives(
            request.line.prefer,
            lambda prefer: _by(request, prefer),
            priced=not unpriced_components(request.line, request.environment.water_density),
        ),
        limits=limits(settled),
        swing=_swing(settled),
        dynamic_factor=request.line.dynamic_factor,
        sinker=sinker,
        other_sinker=request.ground.by_other_rule(sinker, request.environment.water_density),
        reserve_buoyancy=request.reserve_buoyancy,
        assumptions=_assumptions(request, settled.assumed),
        defaults=request.defaults,
        inputs=request.inputs,
    )


def _by(request: BuoyRequest, prefer: Prefer) -> tuple[Settled, float]:
    """Settle the line of another preference, with its swing radius."""
    settled = _settled(replace(request, line=request.line.by(prefer)))
    return settled, _swing(settled).total


def _swing(settled: Settled) -> SwingRadius:
    span = dict(settled.point.checks.solutions)[LOW].span
    parts = ((Message("sizing.line_at_low_water"), span),)
    return SwingRadius(Message("sizing.storm_low"), parts)


def _settled(request: BuoyRequest, start: Assumed | None = None) -> Settled:
    """Settle loads and line on each other."""

    def needed(_: Posed, point: DesignPoint) -> Assumed:
        pull = min(rounded_up(point_pull(point)), request.reserve_buoyancy)
        return Assumed(point_diameter(point), pull)

    return settle(lambda assumed: pose_buoy(request, assumed), needed, request.line, start)


def pose_buoy(request: BuoyRequest, assumed: Assumed) -> Posed:
    """Make the case of a buoy whose size of chain and pull are assumed."""
    env, line = request.environment, request.line
    keel = request.keel_depth(min(assumed.pull, request.reserve_buoyancy))
    levels = env.levels
    loads = (
        LoadsAt(Message("sizing.storm_high"), levels.high, *_loads(request, assumed, levels)),
        LoadsAt(
            Message("sizing.storm_low"),
            levels.low,
            *_loads(request, assumed, WaterLevels.steady(levels.low)),
        ),
    )
    rises = (env.crest, levels.low - levels.high)
    height = levels.high + env.crest - keel
    case = Case(
        site=Site(levels.high, water_density=env.water_density),
        line=first_line(line, env.water_density, 2.0 * height),
        load=None,
        fairlead_height=levels.high - keel,
        checks=line.checks_beyond(0.0),
        title=request.title or _title(request.buoy.name, levels),
        source=request.source or "catopt size buoy",
        load_cases=tuple(
            LoadCase(each.load_case, each.horizontal_force, rise)
            for each, rise in zip(loads, rises, strict=True)
        ),
        service=line.service,
        buoy=Buoy(request.reserve_buoyancy),
        catalogue=catalogue_of(line),
        design=Design(
            segments=(line.segment(height),),
            objectives=line.objectives,
            sinker=request.ground.choice(coded=line.has_factor("sliding")),
        ),
    )
    return Posed(case, loads)


def _title(name: str, levels: WaterLevels) -> Message:
    return Message("sizing.title", body=name, depth=levels.high)


def _loads(
    request: BuoyRequest, assumed: Assumed, levels: WaterLevels
) -> tuple[tuple[Loads, ...], float]:
    """Compute the parts at one level, or give the force that was given."""
    if not isinstance(request.buoy, BuoyShape):
        return (), request.buoy.horizontal_force
    env = request.environment
    loads = buoy_loads(
        request.buoy,
        env.wind,
        env.current,
        env.sea,
        levels,
        chain_diameter=assumed.diameter,
        pull=assumed.pull,
        marine_growth=request.marine_growth,
        water_density=env.water_density,
    )
    return (loads,), 0.0


def _check_reserve(request: BuoyRequest) -> None:
    """Refuse a buoy that the lightest chain would pull under, hanging straight down."""
    density = request.environment.water_density
    lightest = min(sold(request.line, density), key=lambda each: each.submerged_weight)
    height = request.environment.levels.high + request.environment.crest - request.keel_depth(0.0)
    weight = lightest.submerged_weight * height
    if weight >= request.reserve_buoyancy:
        name = lightest.name or lightest.component
        values = {"weight": weight / 1e3, "height": height, "name": name}
        allowed = Message("sizing.below_lightest", **values)
        found = f"{request.reserve_buoyancy / 1e3:.3g} kN"
        raise InputError([Problem("reserve_buoyancy", found, allowed)], "BuoyRequest")


def _assumptions(request: BuoyRequest, assumed: Assumed) -> tuple[str, ...]:
    env = request.environment
    keel = request.keel_depth(min(assumed.pull, request.reserve_buoyancy))
    levels = {"high": env.levels.high, "crest": env.crest, "low": env.levels.low, "keel": keel}
    crest = Message("sizing.high_water", **levels)
    if isinstance(request.buoy, BuoyShape):
        values = {
            "diameter": assumed.diameter * 1e3,
            "pull": Measure("vertical_force", assumed.pull),
        }
        settled = Message("sizing.loads_on_chain", **values)
    else:
        settled = Message("sizing.force_given")
    return crest, settled, *_wear(request), *_trough(request, keel)


def _trough(request: BuoyRequest, keel: float) -> tuple[str, ...]:
    """Say where a buoy that is afloat in still water touches the bed between two crests."""
    env = request.environment
    room = env.levels.low - 0.5 * env.sea.height_in(env.levels.low) - keel
    if room >= 0.0:
        return ()
    return (Message("sizing.touches_bed", depth=-room),)


def _wear(request: BuoyRequest) -> tuple[str, ...]:
    if request.line.service is None:
        return (Message("sizing.as_new"),)
    loss = request.line.service.diameter_loss()
    return (Message("sizing.worn", loss=loss * 1e3),)
