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
from catopt.sizing.assumed import Assumed, rounded_up
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.candidates import candidates
from catopt.sizing.components import catalogue_of, first_line, sold
from catopt.sizing.limits import limits
from catopt.sizing.posed import LoadsAt, Posed
from catopt.sizing.result import Sizing, SwingRadius
from catopt.sizing.settle import Settled, point_diameter, point_pull, settle

__all__ = ["HIGH", "LOW", "pose_buoy", "size_buoy"]

HIGH = "storm, high water"
LOW = "storm, low water"
"""Load cases of a buoy."""


def size_buoy(request: BuoyRequest) -> Sizing:
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
        limits=limits(settled),
        swing=SwingRadius(LOW, (("line at low water", solutions[LOW].span),)),
        sinker=sinker,
        reserve_buoyancy=request.reserve_buoyancy,
        assumptions=_assumptions(request, settled.assumed),
        defaults=request.defaults,
    )


def _settled(request: BuoyRequest, start: Assumed | None = None) -> Settled:
    """Settle loads and line on each other."""

    def needed(_: Posed, point: DesignPoint) -> Assumed:
        pull = min(rounded_up(point_pull(point)), request.reserve_buoyancy)
        return Assumed(point_diameter(point), pull)

    return settle(lambda assumed: pose_buoy(request, assumed), needed, request.line.prefer, start)


def pose_buoy(request: BuoyRequest, assumed: Assumed) -> Posed:
    """Make the case of a buoy whose chain and pull are assumed.

    Parameters
    ----------
    request : BuoyRequest
        Buoy, place and weather.
    assumed : Assumed
        Size of chain and pull that the loads are computed for.
    """
    env, line = request.environment, request.line
    keel = request.keel_depth(min(assumed.pull, request.reserve_buoyancy))
    levels = env.levels
    loads = (
        LoadsAt(HIGH, levels.high, *_loads(request, assumed, levels)),
        LoadsAt(LOW, levels.low, *_loads(request, assumed, WaterLevels.steady(levels.low))),
    )
    rises = (env.crest, levels.low - levels.high)
    height = levels.high + env.crest - keel
    case = Case(
        site=Site(levels.high, water_density=env.water_density),
        line=first_line(line, env.water_density, 2.0 * height),
        load=None,
        fairlead_height=levels.high - keel,
        checks=line.checks,
        title=request.title or f"{request.buoy.name} in {levels.high:g} m of water",
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
            sinker=request.ground.choice(coded=line.has_factor("sliding")),
        ),
    )
    return Posed(case, loads)


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
        allowed = (
            f"below the pull of the lightest line that may be, {weight / 1e3:.3g} kN: {height:.3g} "
            f"m of {name} hanging straight down; a larger buoy is wanted"
        )
        found = f"{request.reserve_buoyancy / 1e3:.3g} kN"
        raise InputError([Problem("reserve_buoyancy", found, allowed)], "BuoyRequest")


def _assumptions(request: BuoyRequest, assumed: Assumed) -> tuple[str, ...]:
    env = request.environment
    keel = request.keel_depth(min(assumed.pull, request.reserve_buoyancy))
    crest = (
        f"High water is {env.levels.high:g} m with the largest wave's crest of {env.crest:.3g} m "
        f"on it (Hmax/2, as CALMAR has it); low water is {env.levels.low:g} m, still. The chain is "
        f"made fast {keel:.3g} m below the water."
    )
    if isinstance(request.buoy, BuoyShape):
        settled = (
            f"The loads are those on a chain of {assumed.diameter * 1e3:g} mm and under a pull of "
            f"{assumed.pull / 1e3:.3g} kN, no less than the recommended line's."
        )
    else:
        settled = "The horizontal force was given; the drag on the chain is taken to be in it."
    return crest, settled, *_wear(request), *_trough(request, keel)


def _trough(request: BuoyRequest, keel: float) -> tuple[str, ...]:
    """Say where a buoy that is afloat in still water touches the bed between two crests."""
    env = request.environment
    room = env.levels.low - 0.5 * env.sea.height_in(env.levels.low) - keel
    if room > 0.0:
        return ()
    return (
        f"In the trough of the largest wave at low water the buoy reaches {-room:.2g} m into the "
        "bed: it needs deeper water or a place with less sea.",
    )


def _wear(request: BuoyRequest) -> tuple[str, ...]:
    if request.line.service is None:
        return ("The line stays as new: no wear.",)
    loss = request.line.service.diameter_loss()
    return (
        f"At the end of its life {loss * 1e3:.2g} mm of the chain's diameter are gone; strength is "
        "that of what is left, weight that of the new chain.",
    )
