"""One chart of each kind, and of each regime that is laid out in its own way."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial

from catopt.catenary.case_curve import curve_case
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.figures import line, mooring, studies, swarm
from catopt.figures import line as curve
from catopt.figures import sizing as front
from catopt.figures.chart import Chart
from catopt.model import Case, Line, Load, PointLoad, Segment, Site
from catopt.mooring.restoring import WatchCircle
from catopt.mooring.solution import SystemSolution
from tests.answers.results import report_with
from tests.report.notes import TURRET, body_note

LONG = (
    "Phao $dấu hiệu$ luồng số 1, độ sâu 9,5 m: a title that somebody made far longer than any "
    "page is wide, so that it folds twice and is then cut off at its end, which is here"
)
turret = partial(body_note, TURRET)
"""The note of a ship on a turret, computed once."""


def short(height: float, force: float) -> Solution:
    """Solve a line of 30 m."""
    return solve(Line([Segment(30.0, 1e3)]), height=height, horizontal_force=force)


def leg() -> Solution:
    """Solve a leg of wire and chain with a clump weight and a buoy, much of it on the bed."""
    made = Line(
        [
            Segment(750.0, 298.0, EA=3.8e8, MBL=6.14e6, name="wire"),
            Segment(332.0, 1470.0, MBL=6.14e6),
        ],
        [PointLoad(900.0, 5e4, name="=clump"), PointLoad(1000.0, -2e4)],
    )
    solved = solve(made, height=71.4, horizontal_force=1.2e6, seabed_friction=0.3)
    return replace(solved, safety_factor=2.0, title="Leg")


def front_document(objectives: tuple[str, ...]) -> dict[str, object]:
    """Make the document of a front of four designs."""
    designs = [
        {
            "mass_kg": 1e3 * k,
            "offset_m": 40.0 - k,
            "cost_USD": 100.0 + 7.0 * k,
            "segments": [{"component": "chain studless R3 76 mm", "length_m": 45.0}],
            "point_loads": [{"mass_kg": 2e3, "submerged_weight_N": 1.7e4, "position_m": 7.0}],
        }
        for k in range(4)
    ]
    return {
        "objectives": list(objectives),
        "front": designs,
        "recommended": 1,
        "method": "nsga2",
        "is_exact": False,
    }


def _busy() -> Case:
    loads = [PointLoad(7.0 + k, 4e4, name=LONG) for k in range(4)]
    busy = Line([Segment(55.0, 2100.0, MBL=7.5e6, name=LONG)], loads)
    return Case(Site(20.0), busy, Load(horizontal_force=3e5), 20.0, title=LONG)


def _circle() -> tuple[SystemSolution, WatchCircle]:
    circle = turret().report.circle
    assert circle is not None
    return turret().solution, circle


def _there(chart: Chart | None) -> Chart:
    assert chart is not None
    return chart


KINDS: dict[str, Callable[[], Chart]] = {
    "suspended": lambda: line.line_in_water(short(28.0, 4e3), 28.0),
    "on the bed": lambda: line.line_in_water(leg(), 56.0),
    "upright": lambda: line.line_in_water(short(28.0, 10.0), 28.0),
    "nearly on the bed": lambda: line.line_in_water(short(0.1, 1e3), 3.0),
    "flat": lambda: line.line_in_water(turret().loaded.solution, 56.0),
    "magnified": lambda: _there(line.magnified(turret().loaded.solution, 56.0)),
    "tension": lambda: line.tension_along(leg(), (3.07e6, None)),
    "tension far below": lambda: line.tension_along(short(28.0, 4e3), (9e9,), "MBL / 5"),
    "curve": lambda: curve.load_curve(curve_case(_busy())),
    "fitness": lambda: swarm.fitness(report_with((1.0, 1e-3, 3.55e-15, 0.0))),
    "swarm tension": lambda: swarm.swarm_tension(report_with((1.0, 1e-3)), 4376.8),
    "front": lambda: front.front(front_document(("mass_kg", "offset_m")), 3),
    "front of three": lambda: front.front(front_document(("mass_kg", "offset_m", "cost_USD"))),
    "lines": lambda: studies.lines_to_scale([("first", short(28.0, 4e3)), (LONG, leg())], 71.4),
    "plan": lambda: mooring.plan(turret().solution),
    "near": lambda: _there(mooring.near(turret().solution)),
    "track": lambda: mooring.watch_track(*_circle()),
    "round": lambda: mooring.watch_round(*_circle(), 3e6),
    "restoring": lambda: mooring.restoring(turret().report.curves, turret().solution, 4.0),
}
"""What makes a chart of each kind, by names of their own."""


@cache
def made(kind: str) -> Chart:
    """Make a chart, once."""
    chart = KINDS[kind]()
    assert math.isfinite(chart.x.high - chart.x.low)
    return chart
