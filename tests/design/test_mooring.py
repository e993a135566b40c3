"""Fronts of whole moorings: bounds change nothing, and another route finds the same."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt.checks.kinds import ROUNDING, USER, Place
from catopt.checks.result import CheckResult
from catopt.checks.system import check_system
from catopt.design.assess import BOUNDS, least_forces
from catopt.design.front import Outcome
from catopt.design.mooring import MooringProblem
from catopt.design.mooring_point import distinct_states, hardest_of, widest_gap
from catopt.design.search import design_case, enumerate_designs
from catopt.design.tables import room
from catopt.errors import InputError
from catopt.model import Case, Checks, DesignLoad, SegmentChoice, System
from catopt.mooring.case import one_line_out
from catopt.mooring.solution import solve_system
from tests.design.mooring_by_hand import Chain, Pull, all_round, mooring
from tests.design.mooring_cases import HEIGHT, SIX, mooring_case, random_case

SAME = 1e-7
"""Relative: the other route ends its balance at 1e-10 of the force, and slack moorings are soft."""


ONE_LOAD: dict[str, Any] = {"headings": 1, "line_out": False}
"""What a design says beside loads of its own."""
LOADS = (
    DesignLoad("storm", 1.5e6, 0.3, headings=4, water_level=1.5, line_out=True),
    DesignLoad("current", 0.9e6, 1.1, headings=2),
    DesignLoad("storm at low water", 1.4e6, -0.4, water_level=-1.0, fairlead_rise=3.0),
)


# ------------------------------------------------------------------ states that differ


@pytest.mark.parametrize("fairlead_radius", [0.0, 5.0])
@pytest.mark.parametrize(
    "degrees",
    [
        (0, 60, 120, 180, 240, 300),
        (-3, 0, 3, 117, 120, 123, 237, 240, 243),
        (0, 50, 130),
    ],
)
def test_states_that_are_left_out_are_turned_or_mirrored_ones(
    degrees: tuple[float, ...], fairlead_radius: float
) -> None:
    """Every state is solved by `solve_system`; those kept hold every value there is."""
    azimuths = tuple(map(math.radians, degrees))
    case = mooring_case(azimuths=azimuths, fairlead_radius=fairlead_radius, headings=4)
    system = case.system
    assert system is not None
    directions = DesignLoad("", 1.5e6, headings=4).directions
    kept = distinct_states(azimuths, directions, with_line_out=True, mirrors=not system.turns)
    found = {}
    for heading, angle in enumerate(directions):
        loaded = system.under((1.5e6 * math.cos(angle), 1.5e6 * math.sin(angle)))
        found[-1, heading] = solve_system(loaded)
        for out in one_line_out(loaded):
            assert out.solution is not None
            found[out.missing, heading] = out.solution
    values = {
        state: (math.hypot(at.x, at.y), max(line.tension for line in solved.lines))
        for state, solved in found.items()
        for at in (solved.position,)
    }
    represented = np.array([values[state.missing, state.heading] for state in kept])
    for value in values.values():
        assert np.isclose(represented, value, rtol=1e-8).all(axis=1).any()
    if len(degrees) == 6:
        # Half a turn makes 0 and 180 one, and 90 and 270: 2 whole; of the 24 with a line out 12.
        # Mirrored about 0 deg, the lines at 60 and 300, and at 120 and 240, are one: 4 under the
        # force towards 0; about 90 deg those at 0 and 180, 60 and 120, 240 and 300: 3.
        assert len(kept) == (2 + 4 + 3 if fairlead_radius == 0.0 else 2 + 12)
    if len(degrees) == 3:
        assert len(kept) == 4 * (1 + 3)


def test_the_widest_gap() -> None:
    assert widest_gap([0.0]) == pytest.approx(2.0 * math.pi)
    assert widest_gap([math.radians(-10.0), math.radians(30.0), math.radians(200.0)]) == (
        pytest.approx(math.radians(170.0))
    )


# ------------------------------------------------------------------ one design


@pytest.mark.slow
@pytest.mark.parametrize("fairlead_radius", [0.0, 5.0])
def test_a_design_is_worth_what_checking_the_body_says(fairlead_radius: float) -> None:
    """Mass by hand; offset and excess from `check_system` and `one_line_out` at every heading."""
    problem = MooringProblem.of(mooring_case(fairlead_radius=fairlead_radius))
    for genes in ((3, 1, 1, 0), (4, 0, 0, 1), (5, 2, 0, 0), (1, 0, 1, 1)):
        system = problem.system(genes)
        line = system.legs[0].line
        worst, offset, anchor_load = -math.inf, 0.0, 0.0
        for angle in DesignLoad("", 1.5e6, headings=12).directions:
            loaded = system.under((1.5e6 * math.cos(angle), 1.5e6 * math.sin(angle)))
            report = check_system(replace(problem.case, line=line, system=loaded, design=None))
            worst = max(worst, *(each.exceedance for each in report.results))
            whole = solve_system(loaded)
            offset = max(offset, math.hypot(*whole.offset))
            anchor_load = max(anchor_load, *(each.solution.anchor.tension for each in whole.lines))
            for out in one_line_out(loaded):
                assert out.response is not None
                offset = max(offset, out.response.offset)
                assert out.solution is not None
                pulls = (each.solution.anchor.tension for each in out.solution.lines)
                anchor_load = max(anchor_load, *pulls)
        assessed = problem.assess(np.array([genes]))
        assert assessed.exceedance[0] == pytest.approx(worst, rel=1e-8, abs=1e-9)
        assert assessed.objectives[0, 1] == pytest.approx(offset, rel=1e-8)
        assert assessed.objectives[0, 5] == pytest.approx(anchor_load, rel=1e-8)
        segment = line.segments[0]
        assert segment.mass is not None
        mass = len(system.legs) * segment.length * segment.mass
        assert assessed.objectives[0, 0] == pytest.approx(mass, rel=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("azimuths", [SIX, (0.2, 1.0, 2.7, 4.0)])
def test_several_loads_at_several_levels_are_worth_what_checking_says(
    azimuths: tuple[float, ...],
) -> None:
    """Each load by `check_system` and `one_line_out`, of a body at its water level."""
    case = mooring_case(azimuths=azimuths, lines=(), loads=LOADS, headings=1, line_out=False)
    problem = MooringProblem.of(case)
    assert case.system is not None
    for genes in ((3, 1, 0, 0), (4, 0, 0, 1), (1, 0, 0, 1)):
        line = problem.system(genes).legs[0].line
        worst, offset = -math.inf, 0.0
        for load in LOADS:
            around = System.around(
                line,
                azimuths=azimuths,
                anchor_radius=(600.0, 620.0)[genes[-1]],
                fairlead_height=HEIGHT + load.water_level + load.fairlead_rise,
                seabed_friction=0.3,
            )
            rest = solve_system(around).position
            step = 2.0 * math.pi / load.headings
            for angle in (load.direction + k * step for k in range(load.headings)):
                loaded = around.under((load.force * math.cos(angle), load.force * math.sin(angle)))
                report = check_system(
                    replace(
                        case,
                        line=line,
                        fairlead_height=loaded.legs[0].fairlead_height,
                        system=loaded,
                        design=None,
                    )
                )
                whole = [each for each in report.results if each.place.state == "intact"]
                used = report.results if load.line_out else whole
                worst = max(worst, *(each.exceedance for each in used))
                there = [solve_system(loaded).position]
                if load.line_out:
                    there += [
                        out.solution.position
                        for out in one_line_out(loaded)
                        if out.solution is not None
                    ]
                offset = max(
                    offset, *(math.hypot(each.x - rest.x, each.y - rest.y) for each in there)
                )
        assessed = problem.assess(np.array([genes]))
        assert assessed.exceedance[0] == pytest.approx(worst, rel=1e-8, abs=1e-9)
        assert assessed.objectives[0, 1] == pytest.approx(offset, rel=1e-8)


@pytest.mark.slow
def test_one_load_of_its_own_is_as_the_force_of_the_system() -> None:
    plain = MooringProblem.of(mooring_case())
    own = DesignLoad("storm", 1.5e6, headings=12, line_out=True)
    loaded = MooringProblem.of(mooring_case(force=(0.0, 0.0), **ONE_LOAD, loads=(own,)))
    assert same(enumerate_designs(plain), enumerate_designs(loaded))


@pytest.mark.parametrize("fairlead_radius", [0.0, 5.0])
def test_a_pretension_places_the_anchors(fairlead_radius: float) -> None:
    """Without a load each line of six bears it; the design is that of the radius it comes to."""
    pretensions = (200e3, 400e3)
    case = mooring_case(
        lines=(6,), anchor_radii=(), pretensions=pretensions, headings=2,
        fairlead_radius=fairlead_radius,
    )  # fmt: skip
    problem = MooringProblem.of(case)
    for genes in ((1, 1, 0, 0), (3, 0, 0, 1)):
        system = problem.system(genes)
        for leg in solve_system(system.under((0.0, 0.0))).lines:
            pull = leg.solution.horizontal_force
            assert pull == pytest.approx(pretensions[genes[-1]], rel=1e-9)
        radius = system.legs[0].anchor_radius
        by_radius = mooring_case(
            lines=(6,), anchor_radii=(radius,), headings=2, fairlead_radius=fairlead_radius
        )
        one = problem.assess(np.array([genes]))
        other = MooringProblem.of(by_radius).assess(np.array([(*genes[:-1], 0)]))
        assert one.objectives == pytest.approx(other.objectives, rel=1e-9, nan_ok=True)
        assert one.exceedance == pytest.approx(other.exceedance, rel=1e-9)


@pytest.mark.slow
def test_the_answer_of_a_search_by_pretension_names_it() -> None:
    result = design_case(
        mooring_case(lines=(6,), anchor_radii=(), pretensions=(100e3, 300e3, 500e3), headings=2)
    )
    chosen = {point.mooring.pretension for point in result.front if point.mooring is not None}
    assert chosen <= {100e3, 300e3, 500e3}
    system = result.to_dict()["front"][0]["system"]
    assert system["pretension_N"] in chosen
    assert any("pretension 300" in str(each.change) for each in result.neighbours)


def test_the_least_force_by_hand() -> None:
    """Six lines that may not turn at all share a force along one of them as 1 + 2 cos(60 deg).

    With the line opposite the force gone, the two beside it carry it: 2 cos(60 deg) = 1. Chains so
    long that they may turn any way share it evenly: a sixth, and with one gone a fifth.
    """
    for length, shares in ((600.0, (2.0, 1.0)), (6000.0, (6.0, 5.0))):
        case = mooring_case(
            lines=(6,), anchor_radii=(596.0,), headings=1,
            segments=(SegmentChoice((length,), ("chain studless R4",), (0.1,)),),
        )  # fmt: skip
        problem = MooringProblem.of(case)
        tables, work = problem.mooring, room(problem.tables)
        assert tables is not None
        work.length[0], work.place[0], work.option[0] = length, 0, 0
        # As good as unstretchable, and just long enough: 596^2 + 68^2 = 599.867^2.
        work.compliance[0] = 0.0
        if length == 600.0:
            work.length[0] = math.hypot(596.0, HEIGHT)
        forces = least_forces(tables, problem.tables, work, 1, 0, 596.0)
        assert forces == pytest.approx([1.5e6 / share for share in shares], rel=1e-3)


def test_lines_that_do_not_reach_have_no_least_force() -> None:
    case = mooring_case(segments=(SegmentChoice((300.0,), ("chain studless R4",), (0.1,)),))
    outcome = enumerate_designs(MooringProblem.of(case), bounds=True)
    assert outcome.feasible == 0
    assert outcome.least_exceedance > ROUNDING


# ------------------------------------------------------------------ bounds


def same(one: Outcome, other: Outcome) -> bool:
    return np.array_equal(one.genes, other.genes) and np.array_equal(
        one.objectives, other.objectives
    )


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"lines": (), "headings": 3, "azimuths": (0.0, 0.9, 2.5, 3.9)},
        {"objectives": ("cost", "mass"), "headings": 2},
        {"loads": LOADS[1:], **ONE_LOAD},
        {"objectives": ("mass", "anchor_load"), "headings": 2},
        {"anchor_radii": (), "pretensions": (100e3, 300e3), "headings": 2},
        *(
            pytest.param(changes, marks=pytest.mark.slow)
            for changes in (
                {"fairlead_radius": 5.0},
                {"fairlead_radius": 5.0, "yaw_free": False, "friction": 0.0},
                {"objectives": ("mass", "offset", "cost"), "headings": 2},
                {"line_out": False},
                {"loads": LOADS, **ONE_LOAD},
                {"loads": LOADS, **ONE_LOAD, "fairlead_radius": 5.0},
                {"anchor_radii": (), "pretensions": (100e3, 300e3, 500e3)},
                {"anchor_radii": (), "pretensions": (100e3, 300e3), "fairlead_radius": 5.0},
            )
        ),
    ],
)
def test_with_bounds_the_front_is_the_same_bit_for_bit(changes: dict[str, Any]) -> None:
    problem = MooringProblem.of(mooring_case(**changes))
    with_bounds = enumerate_designs(problem)
    without = enumerate_designs(problem, bounds=False)
    assert same(with_bounds, without)
    assert len(without.genes) > 1 or "cost" in changes.get("objectives", ())
    assert without.evaluations == problem.space.count
    assert sum(without.excluded) == 0
    assert with_bounds.evaluations + sum(with_bounds.excluded) == problem.space.count
    assert with_bounds.evaluations < problem.space.count


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_no_bound_excludes_what_is_on_the_front_of_random_spaces(seed: int) -> None:
    problem = MooringProblem.of(random_case(100 + seed, 150))
    assert same(enumerate_designs(problem), enumerate_designs(problem, bounds=False))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fairlead_radius", "lengths", "size"), [(0.0, 84, 30_000), (5.0, 28, 10_000)]
)
def test_with_bounds_the_front_of_large_spaces_is_the_same(
    fairlead_radius: float, lengths: int, size: int
) -> None:
    """The number of threads changes nothing, either."""
    case = mooring_case(
        fairlead_radius=fairlead_radius,
        lines=(4, 6, 8),
        anchor_radii=tuple(np.arange(550.0, 670.0, 10.0).tolist()),
        segments=(
            SegmentChoice(
                tuple(np.linspace(560.0, 720.0, lengths).tolist()),
                ("chain studless R3", "chain studless R4"),
                (0.07, 0.081, 0.09, 0.1, 0.12),
            ),
        ),
    )
    problem = MooringProblem.of(case)
    assert problem.space.count >= size
    one, two = (enumerate_designs(problem, workers=workers) for workers in (1, 2))
    assert same(one, two)
    assert one.excluded == two.excluded
    assert same(one, enumerate_designs(problem, bounds=False, workers=2))
    assert all(count > 0 for count in one.excluded)


# ------------------------------------------------------------------ another route


def by_hand(case: Case) -> dict[tuple[int, ...], tuple[float, float, float]]:
    """Mass, offset and excess of every design by the formulas of tests/design/mooring_by_hand."""
    problem = MooringProblem.of(case)
    design, system = case.design, case.system
    assert design is not None
    assert system is not None
    checks, leg = case.checks, system.legs[0]
    size, direction = math.hypot(*system.force), math.atan2(system.force[1], system.force[0])
    forces = all_round(size, direction, design.headings)
    factors = checks.safety_factor, checks.safety_factor_line_out or 0.0
    found: dict[tuple[int, ...], tuple[float, float, float]] = {}
    for kind, option in enumerate(problem.space.segments[0].options):
        for place, length in enumerate(problem.space.segments[0].lengths):
            assert option.MBL is not None
            assert option.mass is not None
            weight = option.submerged_weight
            pull = Pull(
                Chain(length, weight, option.EA, case.site.seabed_friction, leg.fairlead_height)
            )
            for row, count in enumerate(design.lines):
                azimuths = leg.azimuth + 2.0 * math.pi * np.arange(count) / count
                for column, radius in enumerate(design.anchor_radii):
                    reach = radius - leg.fairlead_radius
                    solved = mooring(pull, azimuths, reach, forces, line_out=design.line_out)
                    assert solved.residual < 1e-9 or solved.pull > pull.chain.lift_off
                    used = [
                        t * f / option.MBL - 1.0
                        for t, f in zip(solved.tension, factors, strict=True)
                    ]
                    lifts = solved.pull / pull.chain.lift_off - 1.0
                    mass = count * length * option.mass
                    found[kind, place, row, column] = mass, solved.offset, max(*used, lifts)
    return found


def compare(seed: int, designs: int) -> int:
    """Compare a random space with the other route; how many designs of it are feasible."""
    case = random_case(seed, designs)
    problem = MooringProblem.of(case)
    outcome = enumerate_designs(problem, workers=2)
    wanted = by_hand(case)
    assert len(wanted) == problem.space.count
    feasible = {genes: (m, x) for genes, (m, x, exceedance) in wanted.items() if exceedance <= SAME}
    certain = {genes: feasible[genes] for genes in feasible if wanted[genes][2] <= -SAME}
    on_front = np.array(sorted(outcome.objectives.tolist())).reshape(-1, 2)
    for genes, values in zip(outcome.genes.tolist(), outcome.objectives.tolist(), strict=True):
        assert feasible[tuple(genes)] == pytest.approx(values, rel=SAME)
    # Nothing that certainly passes is better than the front, but for what the two routes differ by.
    for mass, offset in certain.values():
        as_light = on_front[on_front[:, 0] <= mass * (1.0 + SAME)]
        assert len(as_light)
        assert as_light[:, 1].min() <= offset * (1.0 + SAME)
    return len(feasible)


@pytest.mark.slow
def test_random_spaces_agree_with_another_route() -> None:
    assert sum(compare(seed, 100) for seed in range(3)) > 0


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_ten_random_spaces_agree_with_another_route(seed: int) -> None:
    compare(seed, 300)


# ------------------------------------------------------------------ the answer


@pytest.mark.slow
def test_the_answer_says_what_governs_and_what_was_excluded() -> None:
    result = design_case(mooring_case(headings=4, lines=(4, 6)))
    assert result.is_exact
    assert result.method == "enumeration"
    assert set(result.excluded) == set(BOUNDS)
    assert result.evaluations + sum(result.excluded.values()) == result.designs == 72
    for point in result.front:
        assert point.checks.passes
        assert point.mooring is not None
        assert point.objectives["offset_m"] == point.mooring.offset
    chosen = result.best.mooring
    assert chosen is not None
    # With all lines there the body goes less far than at its farthest.
    assert math.hypot(*chosen.farthest.offset) <= chosen.offset * (1.0 + 1e-9)
    assert "force towards" in str(chosen.state)
    document = result.to_dict()
    assert document["front"][0]["system"]["anchor_radius_m"] in (600.0, 620.0)
    changes = [str(each.change) for each in result.neighbours]
    assert any("layout: " in change and " lines instead of " in change for change in changes)
    assert str(result.present.change) == "the mooring in the case file"
    assert result.present.point is not None


def test_when_no_mooring_passes_the_nearest_one_is_named() -> None:
    from catopt.design.neighbours import NoFeasibleDesignError

    case = mooring_case(checks=Checks(safety_factor=20.0), headings=2)
    with pytest.raises(NoFeasibleDesignError) as caught:
        design_case(case)
    assert caught.value.near_miss is not None
    assert caught.value.near_miss.failing


@pytest.mark.slow
def test_nsga2_finds_designs_of_the_exact_front() -> None:
    case = mooring_case(headings=2)
    exact = design_case(case)
    assert case.design is not None
    found = design_case(case, method="nsga2", evaluations=60)
    assert not found.is_exact
    assert not found.excluded
    best = np.array([list(p.objectives.values())[:2] for p in exact.front])
    for point in found.front:
        own = list(point.objectives.values())[:2]
        assert not ((np.array(own) < best * (1.0 - 1e-9)).all(axis=1)).all()


# ------------------------------------------------------------------ what is refused


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"objectives": ("mass", "excursion")}, "design.objectives"),
        ({"force": (0.0, 0.0)}, "system.force"),
        ({"lines": (6, 4)}, "lines"),
        ({"headings": 0}, "headings"),
        ({"pretensions": (1e5,)}, "pretensions"),
        ({"loads": LOADS, "line_out": False}, "design.headings"),
        ({"loads": LOADS, "headings": 1}, "design.line_out"),
        ({"loads": 2 * LOADS, **ONE_LOAD}, "design.loads[3].name"),
        (
            {"loads": (replace(LOADS[0], water_level=-68.0),), **ONE_LOAD},
            "design.loads[0].water_level",
        ),
    ],
)
def test_what_does_not_go_together_is_refused(changes: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as caught:
        mooring_case(**changes)
    assert key in [problem.key for problem in caught.value.problems]


def test_what_only_the_search_can_know_is_refused_there() -> None:
    case = mooring_case(anchor_radii=(4.0, 600.0), fairlead_radius=5.0, lines=(1,))
    with pytest.raises(InputError) as caught:
        MooringProblem.of(case)
    keys = {problem.key for problem in caught.value.problems}
    assert keys == {"design.anchor_radii", "design.line_out"}


def test_what_is_of_a_body_wants_a_system() -> None:
    with pytest.raises(InputError) as caught:
        replace(mooring_case(), system=None, checks=Checks())
    keys = {problem.key for problem in caught.value.problems} - {"load"}
    assert keys == {f"design.{key}" for key in ("lines", "anchor_radii", "headings", "line_out")}


# ------------------------------------------------------------------ the hardest of many


@pytest.mark.parametrize(("more", "kept"), [(1e-12, 1), (1e-6, 2), (-0.1, 1)])
def test_the_first_of_those_that_rounding_alone_tells_apart_is_kept(more: float, kept: int) -> None:
    first, second = (
        CheckResult(
            name="tension", kind="tension", load_case="intact", demand=1.2 * (1.0 + more * k),
            capacity=1.0, unit="N", exceedance=0.2 * (1.0 + more * k), source=USER,
            place=Place("intact", line=k + 1),
        )
        for k in (0, 1)
    )  # fmt: skip
    (worst,) = hardest_of([first, second])
    assert worst.place.line == kept
