"""The compiled evaluation against plain `solve` and `check_case`, design by design."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt import Line, NoEquilibriumError, PointLoad, Segment, solve
from catopt.catenary.batch import room_for_runs
from catopt.catenary.equilibrium import given_force
from catopt.catenary.pieces import LineProblem, cut
from catopt.checks.case import check_line
from catopt.checks.kinds import ROUNDING
from catopt.design.assess import NO_DESIGN, NO_EQUILIBRIUM, segment_tensions
from catopt.design.evaluation import DesignProblem
from catopt.model import (
    Anchor,
    Buoy,
    Case,
    Checks,
    ClumpWeightChoice,
    Load,
    SegmentChoice,
    SinkerChoice,
)
from tests.design.small_cases import all_genes, plain_value, small_case

AGREES = 1e-10
"""Relative: both solve to 1e-12 of the line's length or better, and the objectives of the batch are
rounded to 2^-40 of the largest."""


def random_line(rng: np.random.Generator, buoyant: bool) -> Line:
    """One to four segments, up to three point loads, every second one of them at a joint."""
    count = rng.integers(1, 5)
    weights = rng.uniform(50.0, 2000.0, count)
    if buoyant:
        weights[rng.integers(count)] *= -0.1
    segments = [
        Segment(rng.uniform(20.0, 150.0), weight, rng.choice([math.inf, 1e7, 5e8]))
        for weight in weights.tolist()
    ]
    joints = np.cumsum([segment.length for segment in segments])
    loads = []
    for k in range(rng.integers(0, 4)):
        position = rng.uniform(0.02, 0.98) * joints[-1]
        if k % 2 == 0 and count > 1:
            position = joints[rng.integers(count - 1)]
        sign = -0.2 if buoyant and rng.random() < 0.3 else 1.0
        loads.append(PointLoad(float(position), sign * rng.uniform(1e3, 8e4)))
    return Line(segments, loads)


@pytest.mark.parametrize("buoyant", [False, True])
@pytest.mark.parametrize("anchor_height", [0.0, 6.0])
@pytest.mark.parametrize("friction", [0.0, 0.7])
def test_largest_tensions_are_those_of_the_laid_out_line(
    buoyant: bool, anchor_height: float, friction: float
) -> None:
    rng = np.random.default_rng(7)
    solved = grounded = 0
    for _ in range(150):
        line = random_line(rng, buoyant)
        H = float(rng.uniform(2e3, 5e5))
        setting: dict[str, Any] = {"height": 30.0, "seabed_friction": friction}
        try:
            solution = solve(line, horizontal_force=H, anchor_height=anchor_height, **setting)
        except NoEquilibriumError:
            continue
        pieces, owner = cut(line)
        moored = LineProblem(pieces, anchor_height, 30.0, friction)
        state = given_force(H, moored)
        largest = [0.0] * len(line.segments)
        runs = room_for_runs(len(pieces.length))
        segment_tensions(state, moored, runs, owner, len(line.segments), largest)
        wanted = [segment.max_tension for segment in solution.segments]
        # Both walk the same pieces: what differs is the order of a dozen additions.
        assert largest == pytest.approx(wanted, rel=1e-12, abs=1e-9)
        solved += 1
        grounded += solution.grounded_length > 0.0
    assert solved > 80
    assert 20 < grounded < solved


def demanding_case(**changes: object) -> Case:
    """Every kind of check at once."""
    return replace(
        small_case(),
        checks=Checks(
            safety_factor=3.0,
            proof_load_factor=None,
            max_anchor_uplift_angle=math.radians(2.0),
            max_anchor_uplift_force=5e3,
            min_grounded_length=10.0,
            min_tension=60e3,
            max_span=400.0,
        ),
        buoy=Buoy(150e3),
        **changes,  # type: ignore[arg-type]
    )


SINKERS = SinkerChoice((50e3, 150e3, 250e3, 400e3), 2400.0, 0.6, 1.5)

VARIANTS = {
    "plain": small_case(),
    "three objectives": small_case(objectives=("mass", "excursion", "cost")),
    "load of the anchor": small_case(objectives=("mass", "anchor_load")),
    "every check": demanding_case(anchor=Anchor("drag", holding_capacity=9e5, safety_factor=1.5)),
    "raised anchor": demanding_case(anchor_height=5.0),
    "sinkers": replace(demanding_case(), design=small_case(sinker=SINKERS).design),
    "own sinker": demanding_case(
        anchor=Anchor("sinker", submerged_weight=1e6, friction=0.7, safety_factor=1.5)
    ),
    "load alone": replace(small_case(), load_cases=(), load=Load(horizontal_force=4e5)),
    "no check": replace(small_case(), checks=Checks()),
    "weight at the joint": small_case(
        clump_weights=(ClumpWeightChoice((5e3, 20e3), 7850.0, joint=1, optional=True),)
    ),
    "two weights, the farther one first": small_case(
        clump_weights=(
            ClumpWeightChoice((5e3, 20e3), 7850.0, (150.0,), friction=0.2),
            ClumpWeightChoice((9e3,), 2400.0, (20.0, 60.0), optional=True),
        )
    ),
}


@pytest.mark.parametrize("name", VARIANTS)
def test_every_design_is_worth_what_its_report_says(name: str) -> None:
    problem = DesignProblem.of(VARIANTS[name])
    genes = all_genes(problem)[:: 1 if problem.space.count < 100 else 3]
    evaluated = problem.evaluate(np.array(genes))
    seen = 0
    for row, design in enumerate(genes):
        plain = plain_value(problem, design)
        if plain is None:
            assert evaluated.exceedance[row] >= NO_EQUILIBRIUM
            assert np.isnan(evaluated.objectives[row]).all()
            continue
        objectives, exceedance, _ = plain
        assert evaluated.objectives[row] == pytest.approx(objectives, rel=AGREES, abs=AGREES * 500)
        assert evaluated.exceedance[row] == pytest.approx(exceedance, rel=AGREES, abs=AGREES)
        seen += 1
    assert seen > 10


def test_the_offset_is_the_largest_span_of_both_tides_and_of_the_reference() -> None:
    problem = DesignProblem.of(small_case(objectives=("offset", "excursion")))
    genes = (3, 2, 0, 0, 0, 0)
    line = problem.space.line(genes)
    spans = [
        solve(line, height=height, horizontal_force=force, seabed_friction=0.3).span
        for height, force in ((50.0, 500e3), (46.0, 520e3), (48.0, 100e3))
    ]
    (value,) = problem.evaluate(np.array([genes])).objectives
    assert value == pytest.approx([max(spans), max(spans) - spans[2]], rel=AGREES, abs=1e-8)


def test_absent_parts_are_absent() -> None:
    """The design without wire and weight is that of a space which has no such choice."""
    small, large = (
        DesignProblem.of(case)
        for case in (
            small_case(segments=small_case().design.segments[:1], clump_weights=()),  # type: ignore[union-attr]
            small_case(),
        )
    )
    short = np.array([[2, 1], [1, 2]])
    long = np.array([[2, 1, 0, 1, 0, 1], [1, 2, 0, 0, 0, 0]])
    ours, theirs = large.evaluate(long), small.evaluate(short)
    assert np.array_equal(ours.exceedance, theirs.exceedance)
    # Only the rounding, which goes by the largest value of the space, differs.
    assert ours.objectives == pytest.approx(theirs.objectives, rel=AGREES)


def test_weights_are_taken_in_the_order_of_their_places() -> None:
    one = ClumpWeightChoice((5e3,), 7850.0, positions=(60.0, 90.0))
    other = ClumpWeightChoice((20e3,), 7850.0, positions=(70.0,))
    problem = DesignProblem.of(small_case(clump_weights=(one, other)))
    for place in (0, 1):
        genes = (3, 2, 0, 0, 0, place, 0, 0)
        plain = plain_value(problem, genes)
        assert plain is not None
        found = problem.evaluate(np.array([genes]))
        assert found.objectives[0] == pytest.approx(plain[0], rel=AGREES)
        assert found.exceedance[0] == pytest.approx(plain[1], rel=AGREES, abs=AGREES)


def test_a_weight_lies_on_the_bed_with_its_own_friction() -> None:
    """Two weights near a weak anchor, given the other way round: friction takes off its force."""
    values = []
    for friction in (None, 1.5):
        far = ClumpWeightChoice((20e3,), 7850.0, positions=(20.0,), friction=friction)
        near = ClumpWeightChoice((10e3,), 7850.0, positions=(10.0,), friction=0.0)
        weak = Anchor("drag", holding_capacity=1e4, safety_factor=1.5)
        problem = DesignProblem.of(replace(small_case(clump_weights=(far, near)), anchor=weak))
        genes = (3, 2, 0, 0, 0, 0, 0, 0)
        plain = plain_value(problem, genes)
        assert plain is not None
        found = problem.evaluate(np.array([genes]))
        assert found.exceedance[0] == pytest.approx(plain[1], rel=AGREES, abs=AGREES)
        line = problem.space.line(genes)
        assert [load.friction for load in line.point_loads] == [0.0, friction]
        values.append(plain[1])
    assert values[1] < values[0] - 1e-3


def test_a_weight_beyond_the_line_is_no_design_and_the_exceedance_says_how_far() -> None:
    weight = ClumpWeightChoice((5e3,), 7850.0, positions=(100.0, 120.0, 200.0))
    problem = DesignProblem.of(small_case(clump_weights=(weight,)))
    found = problem.evaluate(np.array([(0, 0, 0, 0, 0, place) for place in range(3)]))
    assert found.exceedance[0] < NO_EQUILIBRIUM
    assert NO_DESIGN < found.exceedance[1] < found.exceedance[2] < 2 * NO_DESIGN
    assert np.isnan(found.objectives[1:]).all()


def test_a_line_that_is_too_short_has_a_finite_exceedance_that_falls_with_its_length() -> None:
    choice = SegmentChoice((30.0, 40.0, 60.0))
    problem = DesignProblem.of(small_case(segments=(choice,), clump_weights=()))
    found = problem.evaluate(np.array([[0, 0], [0, 1], [0, 2]]))
    assert np.isnan(found.objectives[:2]).all()
    assert np.isfinite(found.exceedance).all()
    assert found.exceedance[0] > found.exceedance[1] > NO_EQUILIBRIUM > found.exceedance[2]


def test_the_sinker_is_the_lightest_that_holds() -> None:
    problem = DesignProblem.of(replace(demanding_case(), design=small_case(sinker=SINKERS).design))
    genes = problem.space.genes_between(0, problem.space.count)
    chosen = problem.assess(genes).sinker
    checked = 0
    for row in range(0, len(genes), 9):
        design = tuple(genes[row].tolist())
        anchor = problem.anchor(design)
        assert anchor is not None
        assert anchor.mass == SINKERS.masses[chosen[row]]
        assert anchor.submerged_weight is not None
        report = check_line(problem.space.line(design), problem.case, anchor)
        sliding = [result for result in report.results if result.kind == "sliding"]
        needed = max(result.demand for result in sliding)
        lighter = [
            mass * 9.80665 * (1.0 - 1025.0 / 2400.0) for mass in SINKERS.masses[: chosen[row]]
        ]
        assert all(weight < needed for weight in lighter)
        if chosen[row] < len(SINKERS.masses) - 1:
            assert all(result.passes for result in sliding)
            checked += 1
    assert checked > 5


@pytest.mark.parametrize("name", ["plain", "every check", "sinkers"])
def test_stopping_early_changes_nothing_of_what_is_feasible(name: str) -> None:
    problem = DesignProblem.of(VARIANTS[name])
    genes = problem.space.genes_between(0, problem.space.count)
    whole, early = problem.assess(genes), problem.assess(genes, stops_early=True)
    is_feasible = whole.exceedance <= ROUNDING
    assert 0 < is_feasible.sum() < len(genes)
    assert np.array_equal(early.exceedance <= ROUNDING, is_feasible)
    same = (early.objectives[is_feasible], early.sinker[is_feasible])
    assert np.array_equal(same[0], whole.objectives[is_feasible], equal_nan=True)
    assert np.array_equal(same[1], whole.sinker[is_feasible])


def test_one_line_made_up_in_two_ways_is_worth_the_same() -> None:
    """27.5 m and 82.5 m of one chain, or 82.5 m and 27.5 m: equal to the last digit."""
    choice = SegmentChoice((27.5, 82.5, 137.3), ("chain studless R3",), diameters=(0.06,))
    problem = DesignProblem.of(small_case(segments=(choice, choice), clump_weights=()))
    pairs = np.array([[0, a, 0, b] for a in range(3) for b in range(3)])
    swapped = pairs[:, [0, 3, 2, 1]]
    ours, theirs = problem.evaluate(pairs), problem.evaluate(swapped)
    assert np.array_equal(ours.objectives, theirs.objectives)


def test_a_weight_at_a_joint_is_borne_by_the_segment_above_it() -> None:
    """Largest tension below the joint: hypot(H, V at the anchor + w L of the lower segment)."""
    line = Line([Segment(40.0, 500.0), Segment(40.0, 100.0)], [PointLoad(40.0, 30e3)])
    solution = solve(line, height=60.0, horizontal_force=50e3)
    assert solution.regime == "suspended"
    V = solution.anchor.vertical_force
    below, above = (segment.max_tension for segment in solution.segments)
    assert below == pytest.approx(math.hypot(50e3, V + 500.0 * 40.0), rel=1e-12)
    assert above == pytest.approx(math.hypot(50e3, V + 20e3 + 30e3 + 4e3), rel=1e-12)
