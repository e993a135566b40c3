"""A front in motion beside every design run by itself; what ends it, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt.design.front import non_dominated
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.result import DesignResult
from catopt.design.search import design_case, problem_of
from catopt.errors import InputError
from catopt.model import Case
from catopt.notes.front_in_motion import design_once
from catopt.schemas import schema
from catopt.schemas.validation import inconsistencies
from catopt.study.design_in_motion import case_of, design_in_motion
from tests.chain_in_a_sea import chain_in_a_sea, raos_in

SPACE = """
max_anchor_uplift_angle = "0 deg"
[design]
in_motion = true
[[design.segments]]
components = ["chain studless R3"]
diameters = ["32 mm", "40 mm", "54 mm", "70 mm"]
lengths = ["80 m", "95 m", "110 m", "130 m", "155 m"]
"""


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> Case:
    return chain_in_a_sea(raos_in(tmp_path_factory.mktemp("raos")), 84, 110, 2, 2.0, SPACE)


def asking(case: Case, **changes: Any) -> Case:
    assert case.design is not None
    return replace(case, design=replace(case.design, **changes))


def worth(found: DesignResult) -> list[tuple[float, ...]]:
    return [tuple(each.objectives[key] for key in found.objectives) for each in found.front]


@pytest.mark.slow
def test_it_is_the_front_of_all_that_pass_both_each_run_by_itself(case: Case) -> None:
    problem = problem_of(case)
    passing, at_rest = [], []
    for genes in product(*map(range, problem.sizes)):
        point = problem.point(genes)
        own = tuple(point.objectives[key] for key in ("mass_kg", "offset_m"))
        if point.checks.passes:
            at_rest.append(own)
            run = design_once([(1, case_of(case, point), own)], 0, lambda *_: None)
            passing += [own] if run.passes else []
    expected = [passing[k] for k in non_dominated(np.array(passing))]
    found = design_in_motion(case, workers=1)
    assert np.array(worth(found)) == pytest.approx(np.array(expected), rel=1e-9)
    # Motion makes a difference: of the front at rest some fail, and others come up behind them.
    by_rest = [at_rest[k] for k in non_dominated(np.array(at_rest))]
    assert set(by_rest) - set(passing)
    assert set(expected) - set(by_rest)
    of = found.in_motion
    assert of is not None
    assert (of.complete, of.proven, found.is_exact) == (True, True, True)
    assert of.run == len(found.front) + len(of.failing) < len(at_rest)
    for point in found.front:
        assert point.in_motion is not None
        assert point.in_motion.checks is not None
        assert point.in_motion.checks.passes
        assert point.in_motion.runs == 2
    for each in of.failing:
        assert tuple(each.point.objectives[key] for key in found.objectives) not in passing
        assert each.reason
    document = found.to_dict()
    assert list(inconsistencies(document, schema("catopt.design/1"))) == []
    assert len(document["in_motion"]["failing"]) == len(of.failing)
    assert document["front"][0]["in_motion"]["checks"]["passes"] is True


@pytest.mark.slow
def test_max_run_ends_it_with_what_was_run(case: Case) -> None:
    whole = design_in_motion(case, convergence_check="none", workers=1)
    assert whole.in_motion is not None
    few = design_in_motion(
        asking(case, max_run=whole.in_motion.run - 1), convergence_check="none", workers=1
    )
    assert few.in_motion is not None
    assert (few.in_motion.run, few.in_motion.complete) == (whole.in_motion.run - 1, False)
    assert not few.is_exact
    assert not few.interrupted
    assert all(each.in_motion is not None for each in few.front)


@pytest.mark.slow
def test_ctrl_c_keeps_what_was_run(case: Case) -> None:
    whole = design_in_motion(case, convergence_check="none", workers=1)
    assert whole.in_motion is not None
    most = whole.in_motion.run - 0.5

    def stop(at: int, _: int) -> None:
        if at >= 1000 * most:
            raise KeyboardInterrupt

    found = design_in_motion(case, workers=1, progress=stop)
    assert found.interrupted
    assert found.in_motion is not None
    assert not found.in_motion.complete
    assert found.in_motion.run == whole.in_motion.run - 1
    assert worth(found) == worth(whole)[:-1] or worth(found) == worth(whole)[1:]


@pytest.mark.slow
def test_where_none_passes_in_motion_the_nearest_is_named(case: Case) -> None:
    assert case.design is not None
    (chain,) = case.design.segments
    short = asking(case, segments=(replace(chain, lengths=(80.0, 95.0)),))
    assert design_case(asking(short, in_motion=False)).front
    with pytest.raises(
        NoFeasibleDesignError, match=r"pass at rest.*passes in motion.*The nearest is .* fails"
    ):
        design_in_motion(short, workers=1)


def refusal(case: Case) -> str:
    with pytest.raises(InputError) as caught:
        design_in_motion(case)
    return str(caught.value)


def test_what_cannot_be_run_or_judged_is_refused(case: Case) -> None:
    still = replace(case, dynamics=None, waves=None, motion=None)
    assert "dynamics" in refusal(still)
    assert "codes or a safety_factor" in refusal(
        replace(case, checks=replace(case.checks, safety_factor=1.0))
    )
    assert "design.method: found nsga2" in refusal(asking(case, method="nsga2"))
    assert "found 20; in motion every design is enumerated" in refusal(
        asking(case, max_enumerated=19)
    )


def test_what_does_not_stretch_is_refused_by_its_segment(case: Case) -> None:
    assert case.design is not None
    (chain,) = case.design.segments
    rigid = asking(
        case, segments=(replace(chain, components=("chain open-link 4D Q2",), diameters=(0.03,)),)
    )
    said = refusal(rigid)
    assert "design.segments[0]: found chain open-link 4D Q2; its EA is not known" in said


def test_a_search_at_rest_does_not_pass_it_over(case: Case) -> None:
    with pytest.raises(InputError, match=r"design.in_motion: found true; .*design_in_motion"):
        design_case(case)


def test_the_example_is_the_chain_of_its_case() -> None:
    folder = Path(__file__).parents[2] / "cases" / "dynamic-chain-56m"
    text = (folder / "design.toml").read_text("utf-8")
    assert "in_motion = true" in text
    assert (folder / "rao.csv").exists()
