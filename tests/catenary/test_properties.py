"""Properties that any right answer has, over wide ranges."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.model import Line, Segment

EPS = 2.0**-52

lengths = st.floats(1.0, 3000.0)
weights = st.floats(1e-2, 1e5)
ratios = st.floats(0.01, 0.99)
force_ratios = st.floats(-3.0, 3.0).map(lambda power: 10.0**power)
stiffness_ratios = st.one_of(st.just(math.inf), st.floats(1.0, 6.0).map(lambda p: 10.0**p))


def _solve(L: float, w: float, r: float, f: float, k: float) -> Solution:
    line = Line([Segment(L, w, EA=max(w * L, f * w * L) * k)])
    return solve(line, height=r * L, horizontal_force=f * w * L)


def _span_condition(solution: Solution) -> float:
    """Relative change of H that one rounding of the span and the height brings about."""
    step = 1e-5
    more = solve(
        solution.line,
        height=solution.fairlead_height,
        horizontal_force=solution.horizontal_force * (1 + step),
    )
    slope = abs(more.span - solution.span) / step
    steep = solution.fairlead_height / solution.span
    return EPS * solution.line.length * (1.0 + steep) / slope


@given(lengths, weights, ratios, force_ratios, stiffness_ratios)
def test_force_to_span_to_force(L: float, w: float, r: float, f: float, k: float) -> None:
    """Round trip to 1e-10, or to a few roundings of the span where the line is all but taut."""
    there = _solve(L, w, r, f, k)
    assume(there.span > 1e-6 * L)
    back = solve(there.line, height=r * L, span=there.span)
    allowed = 1e-10 + 20.0 * _span_condition(there)
    assert back.horizontal_force == pytest.approx(there.horizontal_force, rel=allowed)
    assert back.fairlead.tension == pytest.approx(there.fairlead.tension, rel=allowed)


@given(lengths, weights, ratios, force_ratios, stiffness_ratios)
def test_force_to_tension_to_force(L: float, w: float, r: float, f: float, k: float) -> None:
    """Round trip to 1e-10; below H = 1e-3 V the tension hardly knows H: T rounds 1/(H/T)2 worse."""
    there = _solve(L, w, r, f, k)
    back = solve(there.line, height=r * L, fairlead_tension=there.fairlead.tension)
    steepness = (there.fairlead.tension / there.horizontal_force) ** 2
    allowed = 1e-10 + 20.0 * EPS * steepness
    assert back.horizontal_force == pytest.approx(there.horizontal_force, rel=allowed)


@given(lengths, weights, ratios, force_ratios, stiffness_ratios, st.floats(0.1, 100.0))
def test_lengths_and_forces_scale(
    L: float, w: float, r: float, f: float, k: float, scale: float
) -> None:
    """Lengths times c and weights per length over c: same forces and angles, shape times c."""
    one = _solve(L, w, r, f, k)
    other = _solve(L * scale, w / scale, r, f, k)
    assert other.span == pytest.approx(scale * one.span, rel=1e-10, abs=1e-12 * L * scale)
    assert other.fairlead.tension == pytest.approx(one.fairlead.tension, rel=1e-10)


@given(lengths, weights, ratios, force_ratios, stiffness_ratios, st.floats(1e-3, 1e3))
def test_forces_scale(L: float, w: float, r: float, f: float, k: float, scale: float) -> None:
    """All forces times c: the same shape. So no unit of force is better than another."""
    one = _solve(L, w, r, f, k)
    other = _solve(L, w * scale, r, f, k)
    assert other.span == pytest.approx(one.span, rel=1e-10, abs=1e-12 * L)
    assert other.anchor.angle == pytest.approx(one.anchor.angle, abs=1e-9)


@given(lengths, weights, ratios, force_ratios, stiffness_ratios)
def test_tension_is_never_below_the_horizontal_force(
    L: float, w: float, r: float, f: float, k: float
) -> None:
    solution = _solve(L, w, r, f, k)
    least = solution.horizontal_force * (1.0 - 2.0 * EPS)
    assert min(solution.profile(50).tension) >= least
    assert solution.fairlead.tension >= solution.anchor.tension


@given(lengths, weights, ratios, force_ratios, stiffness_ratios, st.floats(1.001, 3.0))
def test_span_and_tension_rise_with_the_force(
    L: float, w: float, r: float, f: float, k: float, more: float
) -> None:
    """Strictly in tension; in span up to rounding where the line is all but taut."""
    line = Line([Segment(L, w, EA=max(w * L, f * w * L) * k)])
    less = solve(line, height=r * L, horizontal_force=f * w * L)
    harder = solve(line, height=r * L, horizontal_force=more * f * w * L)
    assert harder.span >= less.span - 1e-12 * L
    assert harder.fairlead.tension > less.fairlead.tension


@given(lengths, weights, ratios, force_ratios, stiffness_ratios)
def test_vertical_balance(L: float, w: float, r: float, f: float, k: float) -> None:
    """The ends carry what hangs: V_fairlead - V_anchor = w times the suspended length."""
    solution = _solve(L, w, r, f, k)
    carried = solution.fairlead.vertical_force - solution.anchor.vertical_force
    assert carried == pytest.approx(w * solution.suspended_length, rel=1e-12)


@given(lengths, weights, st.floats(0.05, 0.9), st.floats(-1.0, 1.0).map(lambda p: 10.0**p))
def test_elastic_tends_to_inextensible_in_proportion_to_1_over_EA(
    L: float, w: float, r: float, f: float
) -> None:
    """Halving 1/EA halves the difference: order 1, asserted to 2 % at strains near 1e-4."""
    H = f * w * L
    EA = 1e4 * max(H, w * L)
    stiff = solve(Line([Segment(L, w)]), height=r * L, horizontal_force=H)
    soft, softer = (
        solve(Line([Segment(L, w, EA=e)]), height=r * L, horizontal_force=H) for e in (EA, EA / 2)
    )
    order = math.log2((softer.span - stiff.span) / (soft.span - stiff.span))
    assert order == pytest.approx(1.0, abs=0.02)


@given(lengths, weights, ratios, force_ratios, stiffness_ratios)
def test_cutting_a_line_changes_nothing(L: float, w: float, r: float, f: float, k: float) -> None:
    """A uniform line in three segments is the same line, to rounding of its length."""
    whole = _solve(L, w, r, f, k)
    EA = whole.line.segments[0].EA
    parts = Line([Segment(L * part, w, EA=EA) for part in (0.2, 0.5, 0.3)])
    cut = solve(parts, height=r * L, horizontal_force=f * w * L)
    assert cut.span == pytest.approx(whole.span, rel=1e-9, abs=1e-11 * L)
    assert cut.fairlead.tension == pytest.approx(whole.fairlead.tension, rel=1e-9)
