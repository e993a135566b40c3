"""Both models over lines of every kind; and that the verdict can fail."""

from __future__ import annotations

import math
import time
from dataclasses import replace

import numpy as np
import pytest

import catopt
from catopt.casefile import parse_case
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.errors import InputError, NoEquilibriumError, NotConvergedError
from catopt.fem import mesh_line, solve_line
from catopt.model import Case, Line, Load, Segment
from catopt.verify import line as line_module
from catopt.verify.line import compare_line, on_meshes, verify_line
from catopt.verify.motion_words import part_sentence
from catopt.verify.result import StaticComparison, closed_form_at, largest_distances
from catopt.words import say

from .cases import CASES, EA, TOUCHES_TWICE, force, moored


@pytest.mark.parametrize("name", list(CASES))
def test_the_models_agree_with_second_order(name: str) -> None:
    """Order 2 within 0.1, and after extrapolation 1e-6 of the tension or the length.

    At 800 bars the error before is some 1e-6; Richardson leaves the next term, two orders higher.
    """
    found = catopt.verify_case(CASES[name])
    part = found.static
    assert found.verdict == "agrees"
    assert part.rough == ()
    for each in part.quantities:
        assert each.gap < 1e-6, each.quantity
        if each.order is not None:
            assert each.order == pytest.approx(2.0, abs=0.1), each.quantity
    assert part.residual < 1e-10  # the solver's own tolerance
    assert [mesh.elements for mesh in part.meshes] == [
        part.meshes[0].elements * factor for factor in (1, 2, 4)
    ]


def test_every_quantity_is_there() -> None:
    part = catopt.verify_case(CASES["on the bed"]).static
    assert [each.key for each in part.quantities] == [
        "span_m", "fairlead_tension_N", "fairlead_vertical_force_N", "fairlead_angle_rad",
        "anchor_tension_N", "anchor_vertical_force_N", "anchor_angle_rad", "grounded_length_m",
        "shape_m",
    ]  # fmt: skip
    held = catopt.verify_case(CASES["on the bed, span given"]).static
    assert held.quantities[0].key == "horizontal_force_N"
    orders = [each for each in part.quantities if each.order is not None]
    assert len(orders) >= 5  # so that the test above has something to look at


# ------------------------------------------------------------------ a verdict that can fail


def tampered(solution: Solution, what: str, part: float) -> Solution:
    """Return a closed form with one of its numbers off by a part of itself."""
    if what in ("span", "grounded_length"):
        return replace(solution, **{what: getattr(solution, what) * (1.0 + part)})
    end, name = what.split(".")
    state = getattr(solution, end)
    return replace(solution, **{end: replace(state, **{name: getattr(state, name) * (1.0 + part)})})


def comparison(closed: Solution, case: Case) -> StaticComparison:
    assert case.load is not None
    mesh = mesh_line(case.line, 100)
    trusses = []
    for _ in range(3):
        trusses.append(
            solve_line(case.line, height=case.fairlead_height, mesh=mesh,
                       horizontal_force=case.load.horizontal_force)
        )  # fmt: skip
        mesh = mesh.refined()
    return compare_line(case, closed, trusses, tolerance=1e-4)


@pytest.mark.parametrize(
    ("what", "quantity"),
    [
        ("span", "span"),
        ("grounded_length", "grounded_length"),
        ("fairlead.tension", "fairlead_tension"),
        ("fairlead.vertical_force", "fairlead_vertical_force"),
        ("fairlead.angle", "fairlead_angle"),
        ("anchor.tension", "anchor_tension"),
    ],
)
def test_a_tampered_closed_form_is_caught(what: str, quantity: str) -> None:
    """A thousandth off, ten times what is allowed; of all quantities that one is named."""
    case = CASES["on the bed"]
    true = solve(case.line, height=50.0, horizontal_force=2e5)
    assert comparison(true, case).verdict == "agrees"
    part = comparison(tampered(true, what, 1e-3), case)
    assert part.verdict == "differs"
    assert part.worst.quantity == quantity
    assert [each.quantity for each in part.quantities if not each.agrees] == [quantity]


SHARP = [(8.0, 3.0), (11.0, 4.0), (22.0, 8.0), (100.0, 50.0)]
"""Length and fairlead height, m, of lines of 1000 N/m that 6 N draw into a bend of 6 mm."""


def sharp(length: float, height: float) -> tuple[Case, Solution]:
    case = moored([(length, 1000.0, 2e7 * length)], height, force(6.0))
    return case, solve(case.line, height=height, horizontal_force=6.0)


@pytest.mark.slow
@pytest.mark.parametrize(("length", "height"), SHARP)
def test_a_bend_of_6_mm_is_resolved(length: float, height: float) -> None:
    given, closed = sharp(length, height)
    part = verify_line(given, closed, elements=200, tolerance=1e-4)
    assert part.verdict == "agrees"
    assert part.worst.gap < 1e-6  # what other lines are held to after extrapolation
    assert part.rough == ()


@pytest.mark.parametrize(("length", "height"), SHARP[:2])
def test_a_mesh_that_cannot_tell_does_not_say_that_the_models_differ(
    length: float, height: float
) -> None:
    """Bars of 40 mm and more about a bend of 6 mm."""
    given, closed = sharp(length, height)
    trusses = on_meshes(
        200,
        lambda bars: [mesh_line(given.line, bars)],
        lambda meshes: solve_line(given.line, height=height, horizontal_force=6.0, mesh=meshes[0]),
    )
    part = compare_line(given, closed, trusses, tolerance=1e-4)
    assert part.verdict == "not resolved"
    assert not part.is_settled
    assert say(part_sentence(part), "vi").startswith("CHƯA PHÂN GIẢI ĐƯỢC: các")
    wrong = tampered(closed, "fairlead.tension", 1e-2)
    assert compare_line(given, wrong, trusses, tolerance=1e-4).verdict == "differs"


def test_a_heavier_line_in_the_closed_form_is_caught_in_its_shape() -> None:
    """One part in a thousand of the weight moves nearly everything."""
    case = CASES["on the bed"]
    other = solve(Line([Segment(400.0, 1001.0, EA)]), height=50.0, horizontal_force=2e5)
    wrong = {q.quantity for q in comparison(other, case).quantities if not q.agrees}
    assert {"fairlead_tension", "grounded_length"} <= wrong


def test_the_tolerance_decides() -> None:
    case = CASES["on the bed"]
    true = solve(case.line, height=50.0, horizontal_force=2e5)
    slightly = tampered(true, "fairlead.tension", 0.5e-4)
    assert comparison(slightly, case).verdict == "agrees"
    part = comparison(slightly, case)
    assert part.worst.gap == pytest.approx(0.5e-4, rel=1e-3)  # the models themselves: 1e-9


# ------------------------------------------------------------------ shape


def test_the_distance_is_no_less_than_that_from_the_curve() -> None:
    """Against the closest of 20,001 points of the closed form."""
    case = CASES["wire and chain"]
    closed = solve(case.line, height=71.4, horizontal_force=1.2e6)
    truss = solve_line(case.line, height=71.4, horizontal_force=1.2e6, elements=50)
    (distance,), _ = largest_distances(closed, [truss])
    profile = closed.profile(20001)
    curve = np.column_stack([profile.x, profile.z])
    nearest = max(float(np.hypot(*(curve - node).T).min()) for node in truss.nodes[:, [0, 2]])
    assert nearest <= distance + 0.03  # half of the points' spacing
    assert 1e-4 < distance < 0.5


def test_the_closed_form_s_places_are_those_of_its_profile() -> None:
    case = CASES["clump weights off the bed"]
    closed = solve(case.line, height=50.0, horizontal_force=1.5e5)
    profile = closed.profile(31)
    found = closed_form_at(closed, profile.s)
    assert found[:, 0] == pytest.approx(profile.x, rel=1e-12, abs=1e-9)
    assert found[:, 1] == pytest.approx(profile.z, rel=1e-12, abs=1e-9)


# ------------------------------------------------------------------ slack


def test_a_slack_line_is_of_first_order_and_so_extrapolated() -> None:
    part = catopt.verify_case(moored([(100.0, 1000.0, np.inf)], 50.0, Load(span=30.0))).static
    assert part.lines[0].closed.regime == "slack"
    assert part.verdict == "agrees"
    tension = part.of("fairlead_tension")
    assert tension.order == pytest.approx(1.0, abs=0.1)
    # The tension is what hangs, 50 m of 1000 N/m, to the weight of a bar of 0.125 m.
    assert tension.fem[-1] == pytest.approx(50e3 - 125.0, abs=1.0)
    assert tension.extrapolated == pytest.approx(50e3, rel=1e-6)
    assert {each.quantity for each in part.quantities} & {"shape", "anchor_angle"} == set()
    assert "bights" in part.remarks[0]


# ------------------------------------------------------------------ on the bed twice


@pytest.mark.parametrize("name", list(TOUCHES_TWICE))
def test_a_line_that_touches_down_twice_has_its_buoy_s_weight_less_on_bed_and_fairlead(
    name: str,
) -> None:
    """The whole weight is 300 kN less 50 kN of the buoy: fairlead and bed carry it."""
    pair = catopt.verify_case(TOUCHES_TWICE[name]).static.lines[0]
    assert pair.closed.regime == "grounded-in-parts"
    assert pair.finest.touchdowns == 2
    carried = pair.finest.fairlead.vertical_force + pair.finest.bed_reaction.sum()
    assert carried == pytest.approx(250e3, rel=1e-8)
    lies = 1000.0 * pair.closed.grounded_length
    assert pair.closed.fairlead.vertical_force + lies == pytest.approx(250e3, rel=1e-12)


def test_a_fairlead_tension_is_met_on_every_mesh() -> None:
    """The truss model is under the closed form's force: its tension is off by what bars leave."""
    tension = catopt.verify_case(TOUCHES_TWICE["touches twice, fairlead tension given"]).static.of(
        "fairlead_tension"
    )
    assert tension.closed_form == pytest.approx(8e4, rel=1e-12)
    assert tension.extrapolated == pytest.approx(8e4, rel=1e-8)


def test_a_fairlead_tension_that_is_too_small_is_refused() -> None:
    """50 m of 1000 N/m hang from the fairlead, whatever pulls."""
    case = replace(TOUCHES_TWICE["touches twice"], load=Load(fairlead_tension=4e4))
    with pytest.raises(NoEquilibriumError, match="too small"):
        catopt.verify_case(case)


# ------------------------------------------------------------------ settings and failures


def test_settings_out_of_range_are_told_at_once() -> None:
    with pytest.raises(InputError) as caught:
        catopt.verify_case(CASES["hanging"], elements=3, tolerance=0.0)
    assert [problem.key for problem in caught.value.problems] == ["elements", "tolerance"]


def test_no_equilibrium_stays_an_error() -> None:
    case = moored([(40.0, 1000.0, np.inf)], 50.0, force(1e5))
    with pytest.raises(NoEquilibriumError):
        catopt.verify_case(case)


def test_a_truss_that_does_not_converge_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, mesh: object, **__: object) -> object:
        raise NotConvergedError(f"{mesh.elements} bars")  # type: ignore[attr-defined]

    monkeypatch.setattr(line_module, "solve_line", never)
    with pytest.raises(NotConvergedError, match="200 bars"):
        catopt.verify_case(CASES["hanging"])


def test_a_plain_case_takes_well_below_a_second_after_compilation() -> None:
    """Measured 0.03 s of processor time; ten times that leaves room for a busy machine."""
    catopt.verify_case(CASES["on the bed"])
    start = time.process_time()
    catopt.verify_case(CASES["on the bed"])
    assert time.process_time() - start < 0.3


STRETCHED = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "{length} m"
submerged_weight = "100 N/m"
EA = "100 kN"
[load]
span = "0 m"
"""


@pytest.mark.parametrize("length", [49.0, 50.0])
def test_a_line_that_reaches_the_bed_by_its_stretch_alone_is_known_on_every_mesh(
    length: float,
) -> None:
    """It hangs straight down: there the last step is not defined, and is not taken."""
    (part,) = catopt.verify_case(parse_case(STRETCHED.format(length=length))).parts
    assert part.verdict == "agrees"
    assert all(math.isfinite(value) for each in part.quantities for value in each.fem)
    assert all(math.isfinite(each.penetration) for each in part.meshes)
    # The weight of what hangs: w l with l (1 + w l / 2 EA) = 50 m.
    hangs = (math.sqrt(1.0 + 2.0 * 100.0 * 50.0 / 1e5) - 1.0) * 1e5 / 100.0
    (tension,) = (each for each in part.quantities if each.quantity == "fairlead_tension")
    assert tension.fem[-1] == pytest.approx(100.0 * hangs, rel=1e-3)
