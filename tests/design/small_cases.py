"""Cases with small design spaces: chain and wire in 50 m of water, two tides, a reference state."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

from catopt.checks.case import check_line
from catopt.checks.result import CheckReport
from catopt.design.evaluation import DesignProblem
from catopt.errors import NoAnswerError
from catopt.model import (
    Case,
    Checks,
    ClumpWeightChoice,
    Design,
    Line,
    LoadCase,
    Segment,
    SegmentChoice,
    Site,
)

STATES = (
    LoadCase("storm, high water", 500e3, 2.0),
    LoadCase("storm, low water", 520e3, -2.0),
    LoadCase("everyday", 100e3, kind="reference"),
)

DESIGN = Design(
    segments=(
        SegmentChoice(
            lengths=(110.0, 220.0, 330.0),
            components=("chain studless R3", "chain studless R4"),
            diameters=(0.05, 0.06),
        ),
        SegmentChoice(
            lengths=(50.0, 100.0),
            components=("wire spiral-strand",),
            diameters=(0.076, 0.09),
            optional=True,
        ),
    ),
    clump_weights=(ClumpWeightChoice((5e3, 10e3), 7850.0, positions=(60.0, 90.0), optional=True),),
)


def small_case(**changes: Any) -> Case:
    """Case with a design space of a few hundred designs; changes go to its `Design`."""
    return Case(
        Site(50.0, seabed_friction=0.3),
        Line([Segment(300.0, 700.0, mass=80.0, MBL=4e6)]),
        None,
        48.0,
        checks=Checks(safety_factor=3.0, max_anchor_uplift_angle=0.0),
        load_cases=STATES,
        design=replace(DESIGN, **changes),
    )


def all_genes(problem: DesignProblem) -> list[tuple[int, ...]]:
    """Every combination of genes, absent parts with all their places."""
    return list(product(*(range(size) for size in problem.sizes)))


def plain_value(
    problem: DesignProblem, genes: tuple[int, ...]
) -> tuple[list[float], float, CheckReport] | None:
    """Objectives and largest excess of a design out of plain `check_line`; None where it is none.

    Nothing of the compiled evaluation is used but the line of the genes.
    """
    if problem.space.flaw(genes):
        return None
    line = problem.space.line(genes)
    try:
        report = check_line(line, problem.case, problem.anchor(genes))
    except NoAnswerError:
        return None
    spans = {name: solution.span for name, solution in report.solutions}
    values = {
        "mass": line.mass,
        "offset": max(spans.values()),
        "excursion": max(spans.values()) - spans.get("everyday", 0.0),
        "cost": sum(s.length * (s.price or 0.0) for s in line.segments),
        "anchor_load": max(solution.anchor.tension for _, solution in report.solutions),
    }
    exceedance = max((result.exceedance for result in report.results), default=-1.0)
    assert problem.case.design is not None
    return [values[name] or 0.0 for name in problem.case.design.objectives], exceedance, report
