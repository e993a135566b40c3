"""Ropes whose strain follows a table: quadrature over the line, plain ropes, MoorDyn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from catopt import Line, PointLoad, Segment, StrainTable, load_curve, solve, verify_case
from catopt.casefile import parse_case, write_case
from catopt.catenary.find import find_limit_force
from catopt.catenary.solution import Solution
from catopt.decks.reading import read_any_deck
from catopt.errors import InputError, NoAnswerError, NoEquilibriumError

STIFFENS = StrainTable([0.0, 0.05, 0.1, 0.2], [0.0, 20e3, 60e3, 220e3])
SOFTENS = StrainTable([0.0, 0.02, 0.1, 0.3], [0.0, 30e3, 50e3, 70e3])
NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)


def reach(of: Solution, table: StrainTable, w: float, friction: float = 0.0) -> tuple[float, ...]:
    """Reach of a rope from its forces at the anchor, by Gauss' rule between the rows of its table.

    What lies is `grounded_length` long and loses friction w a metre towards the anchor.
    """
    H, lies, length = of.horizontal_force, of.grounded_length, of.line.length
    V0 = 0.0 if lies > 0.0 else of.anchor.vertical_force

    hung = [(load.position, load.submerged_weight) for load in of.line.point_loads]

    def forces(s: float) -> tuple[float, float]:
        if s < lies:
            return max(H - friction * w * (lies - s), 0.0), 0.0
        return H, V0 + w * (s - lies) + sum(weight for place, weight in hung if place < s)

    places = {0.0, lies, length, *(place for place, _ in hung)}
    steps = [sum(weight for _, weight in hung[:k]) for k in range(len(hung) + 1)]
    for T in table.tension:
        rise = math.sqrt(max(T * T - H * H, 0.0))
        places |= {lies + (sign * rise - V0 - W) / w for sign in (-1.0, 1.0) for W in steps}
        places.add(lies - (H - T) / (friction * w) if friction else 0.0)
    cuts = sorted(place for place in places if 0.0 <= place <= length)
    x = z = 0.0
    for low, high in pairwise(cuts):
        for node, weight in zip(NODES, WEIGHTS, strict=True):
            h, v = forces(0.5 * (low + high) + 0.5 * (high - low) * node)
            T = math.hypot(h, v)
            strain = float(np.interp(T, table.tension, table.strain))
            ds = 0.5 * (high - low) * weight * (1.0 + strain)
            x, z = x + ds * (h / T if T else 1.0), z + ds * (v / T if T else 0.0)
    return x, z


@pytest.mark.parametrize("span", [380.0, 400.0, 415.0, 430.0, 444.0, 455.0])
@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_it_reaches_its_fairlead_by_quadrature(span: float, friction: float) -> None:
    """To 1e-8 of the length, tensions passing rows of the table or not, lying or not."""
    line = Line([Segment(440.0, 27.5, EA=STIFFENS)])
    found = solve(line, height=190.0, span=span, seabed_friction=friction)
    assert reach(found, STIFFENS, 27.5, friction) == pytest.approx((span, 190.0), abs=440e-8)
    assert found.grounded_length + found.suspended_length == pytest.approx(440.0, rel=1e-14)


@pytest.mark.parametrize("hung", [(205.0, 4e3), (205.0, -3e3), (13.75, 2e3), (439.9, 4e3)])
def test_with_what_hangs_inside_a_part(hung: tuple[float, float]) -> None:
    """To 1e-8 of the length; parts that a load did not end missed it by up to 1.1e-4."""
    line = Line([Segment(440.0, 27.5, EA=STIFFENS)], [PointLoad(*hung), PointLoad(317.0, 1e3)])
    found = solve(line, height=190.0, span=440.0)
    assert reach(found, STIFFENS, 27.5) == pytest.approx((440.0, 190.0), abs=440e-8)


@pytest.mark.parametrize("span", [420.0, 450.0])
def test_a_rope_that_softens(span: float) -> None:
    found = solve(Line([Segment(440.0, 27.5, EA=SOFTENS)]), height=190.0, span=span)
    assert reach(found, SOFTENS, 27.5) == pytest.approx((span, 190.0), abs=440e-8)


@pytest.mark.parametrize("known", [{"horizontal_force": 30e3}, {"fairlead_tension": 50e3}])
def test_under_a_force_or_a_tension(known: dict[str, float]) -> None:
    found = solve(Line([Segment(440.0, 27.5, EA=STIFFENS)]), height=190.0, **known)
    assert reach(found, STIFFENS, 27.5) == pytest.approx((found.span, 190.0), abs=440e-8)


def test_in_proportion_it_is_a_plain_rope() -> None:
    """Chain, rope and a buoy on it; the rows of the table lie on one line through 0."""
    table = StrainTable([0.0, 0.01, 0.08], [0.0, 20e3, 160e3])

    def answer(EA: float | StrainTable) -> Solution:
        rope = Segment(300.0, 20.0, EA=EA, MBL=3e5)
        line = Line([Segment(150.0, 400.0, EA=5e8), rope], [PointLoad(220.0, -2e3)])
        return solve(line, height=120.0, span=425.0, seabed_friction=0.4)

    found, plain = answer(table), answer(2e6)
    assert found.fairlead.tension == pytest.approx(plain.fairlead.tension, rel=1e-11)
    assert found.grounded_length == pytest.approx(plain.grounded_length, rel=1e-10)
    assert found.stretched_length == pytest.approx(plain.stretched_length, rel=1e-12)
    (state,), (other,) = found.point_loads, plain.point_loads
    assert (state.position, state.x, state.z) == pytest.approx((220.0, other.x, other.z), rel=1e-10)
    assert found.segments[1].max_tension == pytest.approx(plain.segments[1].max_tension, rel=1e-11)
    ends, others = found.profile(21), plain.profile(21)
    assert (ends.x[-1], ends.z[-1]) == pytest.approx((others.x[-1], others.z[-1]), rel=1e-10)


def test_its_curve_has_the_slope_of_its_answers() -> None:
    line = Line([Segment(440.0, 27.5, EA=STIFFENS)])
    curve = load_curve(line, height=190.0, over="span", start=435.0, stop=445.0, points=3)
    ahead, back = (
        solve(line, height=190.0, span=440.0 + d).horizontal_force for d in (0.01, -0.01)
    )
    assert curve.stiffness[1] == pytest.approx((ahead - back) / 0.02, rel=1e-6)


CASE = """
[site]
water_depth = "200 m"
[line]
fairlead_height = "190 m"
[[line.segments]]
length = "440 m"
submerged_weight = "27.5 N/m"
strain = [0, 0.05, 0.1, 0.2]
strain_tension = ["0 kN", "20 kN", "60 kN", "220 kN"]
[load]
span = "440 m"
"""


def test_the_truss_model_has_the_same() -> None:
    """Bars with the law of their own tension, second order."""
    found = verify_case(parse_case(CASE), elements=40)
    assert found.is_settled
    for each in found.parts[0].quantities:
        assert abs(each.difference) < 1e-6, each.quantity


def test_a_file_says_it_and_reads_it_back() -> None:
    case = parse_case(CASE)
    EA: object = case.line.segments[0].EA
    assert EA == STIFFENS
    assert parse_case(write_case(case)) == case


@pytest.mark.parametrize(
    ("was", "now", "words"),
    [
        (", 0.2]", "]", "strain_tension.*3 are required"),
        ("[0, 0.05,", "[0.01, 0.05,", "strain.0.: found 0.01; 0 is required first"),
        ('"60 kN"', '"20 kN"', r"strain_tension.2.: found .20 kN.; must be above 20000"),
        ("0.2]", "5.0]", "softens"),
        ("strain = [0, 0.05, 0.1, 0.2]\n", "", "line.segments.0..strain: missing"),
        ("strain =", 'EA = "1 MN"\nstrain =', "leave it out"),
    ],
)
def test_refused(was: str, now: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        parse_case(CASE.replace(was, now))


def test_beyond_the_last_row_there_is_no_answer() -> None:
    line = Line([Segment(440.0, 27.5, EA=STIFFENS)])
    with pytest.raises(NoEquilibriumError, match=r"segment 1 has .* ends at 220.000 kN"):
        solve(line, height=190.0, horizontal_force=300e3)


def test_what_needs_one_stiffness_refuses_it() -> None:
    from catopt.catenary.batch import solve_many

    line = Line([Segment(440.0, 27.5, EA=STIFFENS)])
    with pytest.raises(InputError, match="table of strain and tension"):
        solve_many(line, height=190.0, span=[400.0])


BROUGHT = Path(__file__).parents[1] / "decks" / "brought"


def settled_by_moordyn(folder: Path, span: float, bars: int) -> Sequence[float]:
    """Tension of the first and last bar after 600 s, N."""
    moordyn = pytest.importorskip("moordyn", reason="optional extra: peers")
    deck = (BROUGHT / "17_rope_table.txt").read_text()
    for was, now in (
        ("Fixed 420", f"Fixed {span + 20.0}"),
        ("440 20 p", f"440 {bars} p"),
        ("stiff.dat -1 0 1.2 1 0 0", "stiff.dat 3e4 0 1.2 1 0.5 0.5"),
        ("200 WtrDpth", "200 WtrDpth\n0.005 dtM\n1e5 kBot\n1e4 cBot\n60 TmaxIC\n0 writeLog"),
    ):
        assert was in deck
        deck = deck.replace(was, now)
    (folder / "deck.txt").write_text(deck)
    # Its reader takes no empty line at the end.
    (folder / "stiff.dat").write_text((BROUGHT / "stiff.dat").read_text().rstrip("\n"))
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        system = moordyn.Create("deck.txt")
        moordyn.Init(system, [0.0] * 6, [0.0] * 6)
        for k in range(6):
            moordyn.Step(system, [0.0] * 6, [0.0] * 6, 100.0 * k, 100.0)
        line = moordyn.GetLine(system, 1)
        found = [math.hypot(*moordyn.GetLineNodeTen(line, node)) for node in (0, bars)]
        moordyn.Close(system)
    return found


def test_moordyn_comes_to_rest_there(tmp_path: Path) -> None:
    """Within 0.1 % at both ends, where it has the tension of the middle of a bar."""
    case, _ = read_any_deck(
        (BROUGHT / "17_rope_table.txt").read_text(), str(BROUGHT / "17_rope_table.txt")
    )
    found = solve(case.line, height=190.0, span=440.0)  # type: ignore[union-attr]
    low, high = settled_by_moordyn(tmp_path, 440.0, 100)
    assert found.anchor.tension == pytest.approx(low, rel=1e-3)
    assert found.fairlead.tension == pytest.approx(high, rel=1e-3)


@pytest.mark.parametrize("factor", [2.0, 2.5, 5.0, 10.0])
def test_the_force_at_which_it_reaches_its_limit(factor: float) -> None:
    """The table ends at 60 kN: what is beyond that is too much, not without an answer."""
    table = StrainTable([0.0, 0.05, 0.1], [0.0, 20e3, 60e3])
    line = Line([Segment(150.0, 20.0, EA=table, MBL=100e3)])
    found = find_limit_force(line, height=100.0, safety_factor=factor)
    assert found.solution.fairlead.tension == pytest.approx(100e3 / factor, rel=1e-9)
    known = solve(line, height=100.0, fairlead_tension=100e3 / factor)
    assert found.value == pytest.approx(known.horizontal_force, rel=1e-9)


def test_a_limit_beyond_the_last_row_has_no_force() -> None:
    table = StrainTable([0.0, 0.05, 0.1], [0.0, 20e3, 60e3])
    line = Line([Segment(150.0, 20.0, EA=table, MBL=100e3)])
    with pytest.raises(NoAnswerError, match="table of strains ends"):
        find_limit_force(line, height=100.0, safety_factor=1.5)
