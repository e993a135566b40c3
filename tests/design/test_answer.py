"""`design_case`: the front in full, the recommended design, and what is said when there is none."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any

import jsonschema
import numpy as np
import pytest

from catopt import Line, PointLoad, Segment, schemas, solve
from catopt.checks.case import check_line
from catopt.design.evaluation import DesignProblem, design_point
from catopt.design.neighbours import NoFeasibleDesignError, Step, neighbour, steps
from catopt.design.result import DesignPoint
from catopt.design.search import Found, answer, design_case, enumerate_designs
from catopt.errors import CatoptError, InputError, NotConvergedError
from catopt.model import (
    Checks,
    ClumpWeightChoice,
    Find,
    Load,
    LoadCase,
    SegmentChoice,
    SinkerChoice,
)
from catopt.model.design import SearchMethod
from catopt.words import say
from tests.design.small_cases import small_case

SINKERS = SinkerChoice((50e3, 150e3, 250e3, 400e3), 2400.0, 0.6, 1.5)


@pytest.mark.parametrize("method", ["enumeration", "nsga2", "swarm"])
@pytest.mark.parametrize("objectives", [("mass", "offset"), ("offset", "mass", "cost")])
def test_every_design_of_the_front_is_feasible_and_none_beats_another(
    method: str, objectives: tuple[str, ...]
) -> None:
    case = small_case(objectives=objectives, evaluations=200, population=20, sinker=SINKERS)
    result = design_case(case, method=method)  # type: ignore[arg-type]
    values = np.array(
        [[point.objectives[key] for key in result.objectives] for point in result.front]
    )
    assert len(values) > 3
    assert (np.diff(values[:, 0]) >= 0.0).all()
    for point, own in zip(result.front, values, strict=True):
        assert check_line(point.line, case, point.anchor).passes
        assert point.checks.passes
        assert not ((values <= own).all(axis=1) & (values < own).any(axis=1)).any()
    assert result.method == method
    assert result.is_exact == (method == "enumeration")


def test_auto_enumerates_up_to_a_number_of_designs() -> None:
    assert design_case(small_case(max_enumerated=300)).method == "enumeration"
    searched = design_case(small_case(max_enumerated=299, evaluations=100, population=20))
    assert searched.method != "enumeration"
    assert searched.evaluations <= 100


@pytest.mark.parametrize("method", ["nsga2", "swarm"])
def test_the_same_seed_gives_the_same_front(method: str) -> None:
    case = small_case(evaluations=120, population=20)
    first, again = (design_case(case, method=method, seed=5) for _ in range(2))  # type: ignore[arg-type]
    assert [p.genes for p in first.front] == [p.genes for p in again.front]
    assert [p.objectives for p in first.front] == [p.objectives for p in again.front]
    assert first.seed == 5


def test_settings_are_taken_before_those_of_the_case() -> None:
    result = design_case(small_case(population=20), method="nsga2", seed=7, evaluations=60)
    assert (result.method, result.seed) == ("nsga2", 7)
    assert result.evaluations <= 60


def test_what_is_announced_before_the_search() -> None:
    told: list[str] = []
    design_case(small_case(), announce=told.append)
    design_case(small_case(), method="nsga2", evaluations=50, announce=told.append)
    assert told == [
        "enumeration of 300 designs, less than a second",
        "nsga2: 50 evaluations in a space of 300 designs",
        "enumeration would be exact: 300 designs, less than a second",
    ]


@pytest.mark.parametrize("method", ["nsga2", "swarm"])
def test_a_search_that_reaches_every_design_enumerates(method: SearchMethod) -> None:
    """Its front is that of enumeration, and the answer says what was done instead of what."""
    exact = design_case(small_case())
    searched = design_case(small_case(), method=method, evaluations=300)
    assert (searched.method, searched.is_exact) == ("enumeration", True)
    assert [p.genes for p in searched.front] == [p.genes for p in exact.front]
    said = (
        f"{method} was requested with 300 evaluations, no fewer than the 300 designs: "
        "all of them were enumerated instead, which is exact"
    )
    assert said in searched.warnings
    assert said not in exact.warnings
    found = next(each for each in searched.warnings if each == said)
    assert say(found, "vi") != said


@pytest.mark.parametrize("method", ["nsga2", "swarm"])
def test_a_search_by_name_says_that_enumeration_is_exact(method: SearchMethod) -> None:
    searched = design_case(small_case(population=20), method=method, evaluations=299)
    said = (
        f"the front of {method} is approximate; all 300 designs can be enumerated, which is exact "
        "(--method enumeration)"
    )
    assert searched.method == method
    assert said in searched.warnings
    found = next(each for each in searched.warnings if each == said)
    assert say(found, "vi") != said
    beyond = design_case(
        small_case(population=20, max_enumerated=299), method=method, evaluations=60
    )
    assert said not in beyond.warnings


def test_the_recommended_design_is_on_the_front_and_is_explained() -> None:
    result = design_case(small_case())
    assert 1 < result.recommended < len(result.front)
    assert "knee" in result.recommendation
    assert "mass" in result.recommendation


def test_neighbours_are_one_step_away_and_checked() -> None:
    problem = DesignProblem.of(small_case())
    words = {step.change: step.genes for step in steps(problem.space, (1, 1, 1, 0, 1, 0))}
    assert words == {
        "segment 1: chain studless R3 50 mm instead of chain studless R3 60 mm": (0, 1, 1, 0, 1, 0),
        "segment 1: chain studless R4 60 mm instead of chain studless R3 60 mm": (3, 1, 1, 0, 1, 0),
        "segment 1: 110 m instead of 220 m": (1, 0, 1, 0, 1, 0),
        "segment 1: 330 m instead of 220 m": (1, 2, 1, 0, 1, 0),
        "segment 2: wire spiral-strand 90 mm instead of wire spiral-strand 76 mm": (
            1,
            1,
            2,
            0,
            1,
            0,
        ),
        "segment 2: 100 m instead of 50 m": (1, 1, 1, 1, 1, 0),
        "segment 2 removed": (1, 1, 0, 0, 1, 0),
        "clump weight 1: 10 t instead of 5 t": (1, 1, 1, 0, 2, 0),
        "clump weight 1: at 90 m instead of 60 m": (1, 1, 1, 0, 1, 1),
        "clump weight 1 removed": (1, 1, 1, 0, 0, 0),
    }
    added = [step.change for step in steps(problem.space, (0, 0, 0, 0, 0, 0))]
    assert "segment 2 added: 50 m of wire spiral-strand 76 mm" in added
    assert "clump weight 1 added: 5 t at 60 m" in added
    result = design_case(small_case())
    assert result.neighbours
    for each in result.neighbours:
        assert each.point is not None
        assert each.point.genes != result.best.genes


def test_a_neighbour_without_equilibrium_says_why() -> None:
    case = replace(
        small_case(segments=(SegmentChoice((40.0, 60.0, 300.0)),), clump_weights=()),
        checks=Checks(safety_factor=2.0),
    )
    result = design_case(case)
    (short,) = [
        each for each in result.neighbours if each.change == "segment 1: 40 m instead of 60 m"
    ]
    assert short.point is None
    assert "too short" in short.reason


def test_the_ends_say_what_they_run_into() -> None:
    """The lightest line is the shortest of the smallest chain that lies level at the anchor."""
    result = design_case(small_case(clump_weights=()))
    least_mass, least_offset = result.ends
    assert least_mass.startswith("Least mass, design 1: ")
    assert least_offset.startswith(f"Least offset, design {len(result.front)}: ")
    assert "the uplift angle at the anchor" in least_mass + least_offset


def test_a_choice_that_ends_is_told() -> None:
    case = replace(small_case(clump_weights=()), checks=Checks(safety_factor=2.0))
    least_mass = design_case(case).ends[0]
    assert (
        "the allowed values end for the size of segment 1 and the length of segment 1" in least_mass
    )


def test_an_interrupted_search_keeps_its_front_and_says_so() -> None:
    problem = DesignProblem.of(small_case())

    def stop(done: int, _: int) -> None:
        if done >= 200:
            raise KeyboardInterrupt

    outcome = enumerate_designs(problem, chunk=100, progress=stop)
    result = answer(problem, Found(outcome, "enumeration", 0.1))
    assert result.interrupted
    assert not result.is_exact
    assert result.evaluations == 200
    assert any("interrupted after 200 of 300 designs" in warning for warning in result.warnings)


def test_no_feasible_design_names_the_check_and_by_how_much() -> None:
    case = replace(small_case(), checks=Checks(safety_factor=20.0))
    with pytest.raises(NoFeasibleDesignError) as raised:
        design_case(case)
    error = raised.value
    assert error.exit_status == 3
    miss = error.near_miss
    assert miss is not None
    report = check_line(miss.line, case)
    assert [result.exceedance for result in miss.failing] == [r.exceedance for r in report.failed]
    worst = miss.failing[0]
    message = str(error)
    assert "none of the 300 designs passes every check" in message
    assert f"{worst.demand / 1e3:.4g} kN, allowable {worst.capacity / 1e3:.4g} kN" in message
    assert f"utilisation {worst.utilisation:.3f}" in message
    assert 'load case "storm' in message


def test_no_equilibrium_at_all_says_why() -> None:
    case = small_case(segments=(SegmentChoice((30.0, 40.0)),), clump_weights=())
    with pytest.raises(NoFeasibleDesignError, match="too short") as raised:
        design_case(case)
    assert raised.value.near_miss is not None
    assert raised.value.near_miss.line.length == 40.0


def test_a_least_grounded_length_is_wanted_and_not_allowed() -> None:
    case = replace(small_case(), checks=Checks(min_grounded_length=400.0))
    with pytest.raises(NoFeasibleDesignError, match=r"m, required 400 m"):
        design_case(case)


def test_a_search_that_was_stopped_before_it_found_anything_says_so() -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    case = replace(small_case(), checks=Checks(safety_factor=20.0))
    with pytest.raises(NoFeasibleDesignError, match="interrupted: none of ") as raised:
        design_case(case, progress=stop)
    assert raised.value.near_miss is None


def test_a_space_beyond_counting_is_not_enumerated() -> None:
    lengths = tuple(100.0 + 0.02 * k for k in range(10_000))
    segment = SegmentChoice(lengths, ("chain studless R3",))
    case = small_case(segments=(segment, segment, segment, segment))
    assert DesignProblem.of(case).space.count > 2**63
    with pytest.raises(InputError, match="enumeration; is for at most 1,000,000,000,000 designs"):
        design_case(case, method="enumeration")


def test_short_lines_in_a_space_of_long_ones() -> None:
    """Masses are rounded by what the largest is: 500 km of chain beside 60 m of a thin one."""
    case = small_case(
        segments=(SegmentChoice((60.7, 500_000.0), ("chain studless R3",)),),
        clump_weights=(),
        objectives=("mass", "cost"),
    )
    result = design_case(replace(case, checks=Checks(), load_cases=(LoadCase("calm", 50.0),)))
    (point,) = result.front
    size = (point.line.segments[0].nominal_diameter or 0.0) * 1e3
    # Studless chain has 0.0200 d^2 kg/m, d in mm.
    assert point.objectives["mass_kg"] == pytest.approx(0.02 * size**2 * 60.7, rel=1e-12)


def test_what_the_closed_form_does_not_confirm_is_left_out_and_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    whole = design_case(small_case())
    missing = whole.front[0].genes

    def stubborn(problem: DesignProblem, genes: tuple[int, ...]) -> DesignPoint:
        if genes == missing:
            raise NotConvergedError("a root was not found")
        return design_point(problem, genes)

    monkeypatch.setattr("catopt.design.search.design_point", stubborn)
    monkeypatch.setattr("catopt.design.neighbours.design_point", stubborn)
    result = design_case(small_case())
    assert [p.genes for p in result.front] == [p.genes for p in whole.front[1:]]
    (warning,) = set(result.warnings) - set(whole.warnings)
    assert warning.startswith("designs left out of the front")
    problem = DesignProblem.of(small_case())
    assert neighbour(problem, Step("back", missing)).reason == "a root was not found"

    def hopeless(*_: object) -> DesignPoint:
        raise NotConvergedError("a root was not found")

    monkeypatch.setattr("catopt.design.search.design_point", hopeless)
    with pytest.raises(NotConvergedError, match="confirms none of the"):
        design_case(small_case())


def test_what_the_case_seeks_of_its_own_line_does_not_matter() -> None:
    load = Load(horizontal_force=4e5)
    plain = replace(small_case(), load_cases=(), load=load)
    seeking = replace(plain, find=Find("length", anchor_angle=0.0))
    assert [p.genes for p in design_case(seeking).front] == [
        p.genes for p in design_case(plain).front
    ]


def test_clump_weights_that_no_line_reaches_are_a_mistake_of_the_input() -> None:
    weight = ClumpWeightChoice((5e3,), 7850.0, positions=(900.0,))
    with pytest.raises(InputError, match="would hang at 900 m"):
        design_case(small_case(clump_weights=(weight,)))


def test_a_search_that_disagrees_with_the_closed_form_is_a_fault_of_ours() -> None:
    problem = DesignProblem.of(small_case())
    heavier = problem.tables._replace(weight=problem.tables.weight * 1.001)
    wrong = replace(problem, tables=heavier)
    with pytest.raises(CatoptError, match="is not that of the closed form") as raised:
        design_point(wrong, (3, 2, 0, 0, 0, 0))
    assert raised.value.exit_status == 1


def line_of(design: dict[str, Any]) -> Line:
    """Line out of the figures of the document."""
    segments = [
        Segment(
            length=each["length_m"],
            submerged_weight=each["submerged_weight_N_per_m"],
            EA=each["EA_N"] if each["EA_N"] is not None else math.inf,
            mass=each["mass_kg_per_m"],
            MBL=each["MBL_N"],
            name=each["name"],
            component=each["component"] or "",
            nominal_diameter=each["nominal_diameter_m"],
            proof_load=each["proof_load_N"],
            price=each["price_USD_per_m"],
        )
        for each in design["segments"]
    ]
    loads = [
        PointLoad(each["position_m"], each["submerged_weight_N"], each["mass_kg"], each["name"])
        for each in design["point_loads"]
    ]
    return Line(segments, loads)


def without_motion(line: Line) -> Line:
    """Leave out drag and added mass, which the catalogue has and the document has not."""
    bare = [
        replace(
            each,
            drag_diameter=None,
            drag_normal=None,
            drag_axial=None,
            added_mass_normal=None,
            added_mass_axial=None,
        )
        for each in line.segments
    ]
    return Line(bare, line.point_loads)


def test_the_document_reads_back_as_the_same_line() -> None:
    result = design_case(small_case(sinker=SINKERS, objectives=("mass", "excursion", "cost")))
    text = json.dumps(result.to_dict(), allow_nan=False)
    document = json.loads(text)
    validator = jsonschema.Draft202012Validator(schemas.schema("catopt.design/1"))
    validator.validate(document)
    assert document["objectives"] == ["mass_kg", "excursion_m", "cost_USD"]
    assert [case["fairlead_height_m"] for case in document["load_cases"]] == [50.0, 46.0, 48.0]
    for own, point in zip(document["front"], result.front, strict=True):
        line = line_of(own)
        assert line == without_motion(point.line)
        assert own["mass_kg"] == line.mass
        assert own["feasible"] is True
        assert own["sinker"]["mass_kg"] in SINKERS.masses
        solution = solve(line, height=50.0, horizontal_force=500e3, seabed_friction=0.3)
        names = [case["name"] for case in document["load_cases"]]
        assert own["spans_m"][names.index("storm, high water")] == solution.span


def test_a_mass_that_is_not_known_is_null() -> None:
    case = replace(
        small_case(segments=(SegmentChoice((250.0, 300.0)),), objectives=("offset", "excursion")),
        line=Line([Segment(300.0, 700.0, MBL=4e6)]),
    )
    document = design_case(case).to_dict()
    jsonschema.Draft202012Validator(schemas.schema("catopt.design/1")).validate(document)
    assert {design["mass_kg"] for design in document["front"]} == {None}


def test_hypervolume_of_two_objectives_is_the_area_of_the_steps() -> None:
    result = design_case(small_case())
    corner = result.reference_point
    points = [tuple(p.objectives[key] for key in result.objectives) for p in result.front]
    area, height = 0.0, corner[1]
    for x, y in points:
        area += (corner[0] - x) * (height - y)
        height = y
    assert math.isclose(result.hypervolume, area, rel_tol=1e-9)
