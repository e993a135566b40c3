"""Solutions to report on, a swarm's history written out by hand, and browsers to look at pages."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from functools import cache

import pytest

from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution, SwarmReport
from catopt.catenary.solve import solve
from catopt.model import Case, Checks, Line, Load, PointLoad, Segment, Site

from .browser import FONTS, Tab, chromium

G0 = 9.80665


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


@pytest.fixture
def case() -> Case:
    return buoy_case()


@pytest.fixture
def buoy(case: Case) -> Solution:
    return solve_case(case)


@pytest.fixture
def leg() -> Solution:
    """Solve a leg of wire and chain with a clump weight and a buoy, much of it on the bed."""
    line = Line(
        [
            Segment(750.0, 298.0, EA=3.8e8, MBL=6.14e6, name="wire"),
            Segment(332.0, 1470.0, MBL=6.14e6),
        ],
        [PointLoad(900.0, 5e4, name="=clump"), PointLoad(1000.0, -2e4)],
    )
    solution = solve(line, height=71.4, horizontal_force=1.2e6, seabed_friction=0.3)
    return replace(solution, safety_factor=2.0, title="Leg")


@pytest.fixture
def swarm(buoy: Solution) -> Solution:
    history = (1.0, 0.3, 1e-3, 1e-8, 3.55e-15, 0.0, 0.0)
    return replace(buoy, method="pso", swarm=report_with(history))


@pytest.fixture(scope="session")
def browsers(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], Tab]]:
    """Start a browser for each font that is asked for."""
    with ExitStack() as started:
        yield cache(
            lambda font: started.enter_context(chromium(tmp_path_factory.mktemp("browser"), font))
        )


@pytest.fixture
def font() -> str:
    """Name the font of the pages; tests that measure words take all of `FONTS`."""
    return FONTS[0]


@pytest.fixture
def tab(browsers: Callable[[str], Tab], font: str) -> Tab:
    return browsers(font)


@pytest.fixture
def quiet(tab: Tab) -> Iterator[Tab]:
    """Give the tab, and see afterwards that nothing was said and nothing else was asked for."""
    tab.messages.clear()
    tab.requests.clear()
    yield tab
    assert tab.messages == []
    assert len(set(tab.requests)) == 1
