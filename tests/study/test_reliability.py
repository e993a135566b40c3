"""Probabilities by counting and by the first order, beside formulas."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.stats import binom, gumbel_r, lognorm, norm, uniform

from catopt import Line, PointLoad, Segment, solve
from catopt.study.reliability import _nearest, _sampled, counted_interval
from catopt.study.result import StudyResult
from catopt.study.run import run_study
from catopt.study.study import Distribution

# A chain without stretch that lies on the bed: its tension at the fairlead is H + w h.
CASE = """
[site]
water_depth = "20 m"

[[line.segments]]
length = "300 m"
submerged_weight = "800 N/m"

[load]
horizontal_force = "50 kN"
"""
WEIGHT, DEPTH = 800.0, 20.0
FORCE = 'key = "load.horizontal_force"\ndistribution = "{kind}"\nmean = "50 kN"\n'
FORCE += 'deviation = "8 kN"\n'


def run(folder: Path, vary: str, samples: int, limit: str) -> StudyResult:
    text = CASE.replace("[[line", "[line]\n\n[[line", 1)
    (folder / "case.toml").write_text(text, encoding="utf-8")
    head = f'case = "case.toml"\ncompute = "statics"\nsamples = {samples}\nseed = 2\n'
    head += f"limits = {{ {limit} }}\n"
    (folder / "study.toml").write_text(head + vary, encoding="utf-8")
    return run_study(folder / "study.toml", workers=1)


@pytest.mark.parametrize("kind", ["normal", "lognormal", "gumbel"])
def test_one_force(tmp_path: Path, kind: str) -> None:
    """Exact by the first order, and within the interval of the counted one."""
    found = run(tmp_path, "[[vary]]\n" + FORCE.format(kind=kind), 20_000,
                'fairlead_tension = "85 kN"')  # fmt: skip
    width = math.sqrt(math.log1p(0.16**2))
    scale = 8.0 * math.sqrt(6.0) / math.pi
    of = {
        "normal": norm(50.0, 8.0),
        "lognormal": lognorm(width, scale=50.0 * math.exp(-0.5 * width**2)),
        "gumbel": gumbel_r(50.0 - float(np.euler_gamma) * scale, scale),
    }[kind]
    exact = float(of.sf(85.0 - WEIGHT * DEPTH / 1e3))
    (tension,) = (each for each in found.statistics if each.limit is not None)
    order = found.first_orders["fairlead_tension"]
    assert order is not None
    assert order.probability == pytest.approx(exact, rel=1e-4)
    assert order.point == pytest.approx({"load.horizontal_force": 69e3}, rel=1e-6)
    assert order.importance == pytest.approx({"load.horizontal_force": 1.0})
    assert tension.interval is not None
    low, high = tension.interval
    assert low < exact < high
    assert tension.beyond is not None
    assert low < tension.beyond < high


def test_two_of_them_make_a_plane(tmp_path: Path) -> None:
    """H and h normal: H + w h is, too, so that the first order is exact; importance by variance."""
    vary = "[[vary]]\n" + FORCE.format(kind="normal")
    vary += '[[vary]]\nkey = "site.water_depth"\ndistribution = "normal"\nmean = "20 m"\n'
    vary += 'deviation = "5 m"\n'
    found = run(tmp_path, vary, 300, 'fairlead_tension = "90 kN"')
    spread = math.hypot(8.0, 0.8 * 5.0)
    order = found.first_orders["fairlead_tension"]
    assert order is not None
    assert order.index == pytest.approx((90.0 - 66.0) / spread, rel=1e-5)
    assert order.importance["site.water_depth"] == pytest.approx((4.0 / spread) ** 2, rel=1e-4)


def test_a_limit_that_the_medians_pass_already_has_an_index_below_zero(tmp_path: Path) -> None:
    vary = "[[vary]]\n" + FORCE.format(kind="normal")
    found = run(tmp_path, vary, 100, 'fairlead_tension = "58 kN"')
    order = found.first_orders["fairlead_tension"]
    assert order is not None
    assert order.index == pytest.approx(-1.0, rel=1e-5)
    assert order.probability == pytest.approx(float(norm.cdf(1.0)), rel=1e-4)


def test_a_limit_that_nothing_reaches_has_no_index(tmp_path: Path) -> None:
    """The force is drawn between two ends; no value of it reaches the limit."""
    vary = '[[vary]]\nkey = "load.horizontal_force"\ndistribution = "uniform"\n'
    vary += 'min = "40 kN"\nmax = "60 kN"\n'
    found = run(tmp_path, vary, 100, 'fairlead_tension = "80 kN"')
    assert found.first_orders == {"fairlead_tension": None}
    assert found.statistics[0].beyond == 0.0


def test_each_choice_has_its_own_probability(tmp_path: Path) -> None:
    vary = '[[vary]]\nkey = "site.water_depth"\nvalues = ["15 m", "20 m", "30 m"]\n'
    found = run(tmp_path, vary + "[[vary]]\n" + FORCE.format(kind="normal"), 2_000,
                'fairlead_tension = "80 kN"')  # fmt: skip
    assert found.first_orders == {}
    assert found.statistics[0].interval is None
    assert [each.member for each in found.by_choice] == [0, 2_000, 4_000]
    assert [each.count for each in found.by_choice] == [2_000] * 3
    for each, depth in zip(found.by_choice, (15.0, 20.0, 30.0), strict=True):
        exact = float(norm.sf(80.0 - 0.8 * depth, 50.0, 8.0))
        spread = math.sqrt(exact * (1.0 - exact) / 2_000)
        assert abs(each.share - exact) < 4.0 * spread
        assert each.share == each.beyond / 2_000


@pytest.mark.parametrize(("beyond", "count"), [(0, 50), (3, 50), (50, 50), (12, 10_000)])
def test_the_interval_leaves_a_fortieth_on_either_side(beyond: int, count: int) -> None:
    """By the binomial distribution itself."""
    low, high = counted_interval(beyond, count)
    if beyond > 0:
        assert binom.sf(beyond - 1, count, low) == pytest.approx(0.025)
    if beyond < count:
        assert binom.cdf(beyond, count, high) == pytest.approx(0.025)


@pytest.mark.parametrize("kind", ["normal", "lognormal", "gumbel", "uniform"])
def test_values_by_a_normal_one_have_the_distribution_that_is_drawn(kind: str) -> None:
    of = Distribution(kind, 5.0, 6.0 if kind == "uniform" else 0.5)  # type: ignore[arg-type]
    drawn = np.sort(of.draw(np.random.default_rng(3), 400_000))
    for share in (0.05, 0.5, 0.95):
        (found,) = of.at(np.array([norm.ppf(share)]))
        assert found == pytest.approx(drawn[int(share * drawn.size)], rel=5e-3)
        assert of.normal_of(np.array([found])) == pytest.approx(norm.ppf(share), abs=1e-9)
    if kind == "uniform":
        assert of.at(np.array([1.0])) == pytest.approx(uniform(5.0, 1.0).ppf(norm.cdf(1.0)))


FORM = Path(__file__).parents[1] / "hard_cases" / "form"


def exact_uplift(length: float) -> float:
    """Probability of more than 50 N of uplift, by the force that gives it at each weight.

    The uplift rises with the force: P = integral of f(w) P(H > H(w)) dw, by Gauss and Hermite.
    """
    scale = 0.1 * math.sqrt(6.0) / math.pi
    force = gumbel_r(0.343 - float(np.euler_gamma) * scale, scale)
    nodes, weights = np.polynomial.hermite_e.hermegauss(15)
    total = 0.0
    for node, weight in zip(nodes, weights, strict=True):
        w = (9.5 + 0.5 * node) * 9.80665
        line = Line([Segment(length, w)], [PointLoad(7.0, 50.0 * 9.80665)])

        def left(H: float, line: Line = line) -> float:
            V = solve(line, height=9.5, horizontal_force=H).anchor.vertical_force
            return V - 50.0

        at = brentq(left, 100.0, 30e3, xtol=1e-6)
        total += weight * float(force.sf(at / 9806.65))
    return total / math.sqrt(math.tau)


@pytest.mark.parametrize("length", [20, 26, 28])
def test_an_anchor_that_seldom_lifts_has_an_index(tmp_path: Path, length: int) -> None:
    """At the medians the uplift is 0 whatever changes a little: draws that fail lead there."""
    case = (FORM / "case.toml").read_text(encoding="utf-8").replace('"28 m"', f'"{length} m"')
    (tmp_path / "case.toml").write_text(case, encoding="utf-8")
    text = (FORM / "study.toml").read_text(encoding="utf-8").replace("20000", "400")
    (tmp_path / "study.toml").write_text(text, encoding="utf-8")
    found = run_study(tmp_path / "study.toml", workers=1)
    order = found.first_orders["anchor_uplift"]
    assert order is not None, found.no_first_orders
    assert order.sampled is not None
    assert order.interval is not None
    exact = exact_uplift(length)
    low, high = order.interval
    assert abs(order.sampled - exact) < high - low  # four of its standard deviations
    # The force decides, nearly alone: the limit is nearly a plane in its normal value.
    assert order.probability == pytest.approx(exact, abs=0.01)
    assert order.importance["load.horizontal_force"] > 0.9


def test_a_limit_passed_either_way_has_two_points() -> None:
    """Passed for x > 2 or y < -2.2 in standard deviations: 1 - P(x < 2) P(y > -2.2)."""

    def room(u: np.ndarray) -> np.ndarray:
        return np.minimum(2.0 - u[:, 0], 2.2 + u[:, 1])

    points = [np.array([2.0, 0.0]), np.array([0.0, -2.2])]
    starts = [np.array([2.0, 0.5]), np.array([0.3, -2.2])]
    for start, point in zip(starts, points, strict=True):
        assert _nearest(room, start) == pytest.approx(point, abs=1e-6)
    share, interval = _sampled(room, points, False)
    assert share is not None
    assert interval is not None
    low, high = interval
    exact = 1.0 - float(norm.cdf(2.0) * norm.cdf(2.2))
    assert low < exact < high
    assert low < share < high < 1.2 * exact


@pytest.mark.parametrize("is_passed", [False, True])
def test_draws_without_an_answer_are_counted_neither_way(is_passed: bool) -> None:
    def room(u: np.ndarray) -> np.ndarray:
        return np.where(u[:, 0] > 1.0, np.nan, 2.0 - u[:, 0])

    assert _sampled(room, [np.array([2.0, 0.0])], is_passed) == (None, None)


def test_why_there_is_no_index_is_said(tmp_path: Path) -> None:
    vary = '[[vary]]\nkey = "load.horizontal_force"\ndistribution = "uniform"\n'
    vary += 'min = "40 kN"\nmax = "60 kN"\n'
    found = run(tmp_path, vary, 100, 'fairlead_tension = "80 kN"')
    assert "no draw exceeds the limit" in found.no_first_orders["fairlead_tension"]
