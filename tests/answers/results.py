"""Results to lay out: a buoy's line, a swarm's history by hand, and two sizings."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution, SwarmReport
from catopt.loads import SeaState, SurfaceCurrent, WaterLevels, Wind, buoy, estimated_tanker
from catopt.model import Case, Checks, Line, Load, PointLoad, Segment, Site
from catopt.sizing import (
    BuoyRequest,
    Environment,
    GivenBuoy,
    MooredShip,
    Sizing,
    TankerRequest,
    size_buoy,
    size_tanker,
)

G0 = 9.80665
CURVED = Case(
    Site(20.0),
    Line(
        [Segment(55.0, 2100.0, MBL=7.5e6, name="chain")],
        [PointLoad(7.0, 200e3, name="sinker"), PointLoad(9.0, 5e4)],
    ),
    Load(horizontal_force=4.5e5),
    20.0,
    checks=Checks(5.0, math.radians(3.0)),
    title="Bến phao $20$ m",
)


def buoy_case(**changes: object) -> Case:
    """Build the case of S1: 20 m of chain of 9.5 kgf/m in 9.5 m of water under 0.343 tf."""
    line = Line([Segment(20.0, 9.5 * G0, mass=10.9, MBL=230e3, name="chain")])
    case = Case(
        Site(9.5), line, Load(horizontal_force=343.0 * G0), 9.5, checks=Checks(5.0), title="Buoy"
    )
    return replace(case, **changes)  # type: ignore[arg-type]


def report_with(history: tuple[float, ...], iterations: int = 200) -> SwarmReport:
    """Build a swarm's report with a given history of f."""
    return SwarmReport(
        objective=history[-1],
        evaluations=200 * len(history),
        iterations=iterations,
        runs=1,
        seed=1,
        converged_runs=1,
        best_run=1,
        objectives=(history[-1],),
        span_consistency=0.0,
        closed_form_difference={"angle_rad": 0.0, "span_m": 0.0, "tension_N": 0.0},
        best_objective_history=history,
        tension_history=tuple(4376.8 + 1e3 * f for f in history),
        iterations_flown=(len(history),),
    )


@cache
def solved() -> Solution:
    """Solve the case of S1."""
    return solve_case(buoy_case())


@cache
def swarm() -> Solution:
    """Solve the case of S1 by a swarm that finds it in the sixth iteration."""
    history = (1.0, 0.3, 1e-3, 1e-8, 3.55e-15, 0.0, 0.0)
    return replace(solved(), method="pso", swarm=report_with(history))


def _place(low: float, high: float) -> Environment:
    return Environment(WaterLevels(low, high), Wind(20.0), SurfaceCurrent(1.2), SeaState(8.0, 2.0))


@cache
def around() -> Sizing:
    """Size the lines around a mooring buoy to which a tanker is tied, held by drag anchors."""
    ship = estimated_tanker("tanker", 120.0, 18.0, 7.0, moulded_depth=9.0)
    moored = MooredShip("loaded", ship, "tanker loaded", 3.0)
    body = buoy("mooring buoy 5.0 m")
    return size_tanker(
        TankerRequest((moored,), _place(20.0, 22.0), buoy=body, hawser=50.0, lines=4)
    )


@cache
def by_force() -> Sizing:
    """Size the line of a buoy whose horizontal force is given, held by a sinker."""
    return size_buoy(BuoyRequest(GivenBuoy(3363.7, 12e3), _place(9.5, 9.5)))
