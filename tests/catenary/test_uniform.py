"""One uniform line against the textbook formulas, S1 (1)-(7), written out here on their own."""

from __future__ import annotations

import math
from functools import partial
from itertools import pairwise

import pytest

from catopt.catenary.solve import solve
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import NoEquilibriumError
from catopt.model import Line, PointLoad, Segment
from tests.campaign.oracle import check

# S1: 9.5 m of water, 20 m of chain, 0.343 tf. w = 9.5 kgf/m is identified, not printed.
W = 9.5 * STANDARD_GRAVITY
H = 343.0 * STANDARD_GRAVITY
BUOY = Line([Segment(20.0, W)])


def test_marker_buoy_gives_the_figures_that_s1_prints() -> None:
    """S1 Table 1: theta0 0.272 rad, S 17.430 m, T 0.446 tf. Tolerance: half the last digit."""
    solution = solve(BUOY, height=9.5, horizontal_force=H)
    assert solution.anchor.angle == pytest.approx(0.272, abs=0.0005)
    assert solution.span == pytest.approx(17.430, abs=0.0005)
    assert solution.fairlead.tension / (1000 * STANDARD_GRAVITY) == pytest.approx(0.446, abs=0.0005)
    assert solution.regime == "suspended"


def test_suspended_line_satisfies_s1_equations() -> None:
    """(4) height, (5) span and (7) tension with the angle that came out; double precision."""
    solution = solve(BUOY, height=9.5, horizontal_force=H)
    a, t, L = H / W, math.tan(solution.anchor.angle), 20.0
    height = a * math.sqrt(1 + (L / a + t) ** 2) - a / math.cos(solution.anchor.angle)
    span = a * math.asinh(L / a + t) - a * math.asinh(t)
    tension = H * math.sqrt(1 + (L / a + t) ** 2)
    assert height == pytest.approx(9.5, rel=1e-14)
    assert solution.span == pytest.approx(span, rel=1e-14)
    assert solution.fairlead.tension == pytest.approx(tension, rel=1e-14)


def test_slack_line_has_the_grounded_length_of_the_textbook() -> None:
    """L_min = sqrt(h (h + 2 a)), T = H + w h (S2 (1), (4)); the rest lies on the bed."""
    w = 30.0 * STANDARD_GRAVITY
    solution = solve(Line([Segment(20.0, w)]), height=9.5, horizontal_force=H)
    a = H / w
    hanging = math.sqrt(9.5 * (9.5 + 2 * a))
    assert solution.regime == "grounded"
    assert solution.suspended_length == pytest.approx(hanging, rel=1e-14)
    assert solution.span == pytest.approx(20.0 - hanging + a * math.acosh(1 + 9.5 / a), rel=1e-14)
    assert solution.fairlead.tension == pytest.approx(H + w * 9.5, rel=1e-14)
    assert solution.anchor.vertical_force == 0.0
    assert solution.anchor.tension == pytest.approx(H, rel=1e-15)


def test_elastic_line_on_the_bed() -> None:
    """Irvine's elastic catenary from the touchdown up, the grounded part stretched by H/EA."""
    w, EA, L, h = 1000.0, 5e6, 600.0, 200.0
    solution = solve(Line([Segment(L, w, EA)]), height=h, horizontal_force=3e5)
    V = solution.fairlead.vertical_force
    s = V / w
    T = math.hypot(3e5, V)
    assert (T - 3e5) / w + V * V / (2 * EA * w) == pytest.approx(h, rel=1e-13)
    x = 3e5 / w * math.asinh(V / 3e5) + 3e5 * s / EA + (L - s) * (1 + 3e5 / EA)
    assert solution.span == pytest.approx(x, rel=1e-13)


def test_friction_takes_tension_off_towards_the_anchor() -> None:
    """The anchor gets H - mu w l_g, and the bed part stretches by the mean of both tensions."""
    w, EA, mu = 1000.0, 5e6, 0.6
    free = solve(Line([Segment(600.0, w, EA)]), height=200.0, horizontal_force=3e5)
    held = solve(
        Line([Segment(600.0, w, EA)]), height=200.0, horizontal_force=3e5, seabed_friction=mu
    )
    grounded = held.grounded_length
    assert held.anchor.horizontal_force == pytest.approx(3e5 - mu * w * grounded, rel=1e-13)
    assert free.span - held.span == pytest.approx(grounded * mu * w * grounded / 2 / EA, rel=1e-9)


def test_friction_never_pushes() -> None:
    """Where friction needs less than all of itself, the anchor is left without tension."""
    line = Line([Segment(600.0, 1000.0, 5e6)])
    solution = solve(line, height=20.0, horizontal_force=3e4, seabed_friction=1.0)
    assert solution.anchor.tension == 0.0
    assert "friction alone holds the line" in " ".join(solution.warnings)


def test_line_just_long_enough_to_reach_the_bed() -> None:
    """At L = L_min the touchdown is at the anchor: both regimes meet there."""
    w = 1000.0
    force = w / 2 * (600.0**2 / 200.0 - 200.0)  # H_1 of S2
    below = solve(Line([Segment(600.0, w)]), height=200.0, horizontal_force=force * (1 - 1e-9))
    above = solve(Line([Segment(600.0, w)]), height=200.0, horizontal_force=force * (1 + 1e-9))
    assert below.regime == "grounded"
    assert above.regime == "suspended"
    # Over 2e-9 of H the answers differ by that order and no more.
    assert below.span == pytest.approx(above.span, rel=1e-8)
    assert above.anchor.angle == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize("known", [{"horizontal_force": 1000.0}, {"fairlead_tension": 9000.0}])
def test_line_shorter_than_the_height_says_how_much_is_missing(known: dict[str, float]) -> None:
    with pytest.raises(NoEquilibriumError, match="it is 1 m too short") as caught:
        solve(BUOY, height=21.0, **known)
    assert caught.value.quantity == "length"
    assert caught.value.missing == pytest.approx(1.0, rel=1e-15)


def test_line_shorter_than_the_span_says_how_much_is_missing() -> None:
    with pytest.raises(NoEquilibriumError, match="too short") as caught:
        solve(BUOY, height=9.5, span=30.0)
    assert caught.value.missing == pytest.approx(math.hypot(30.0, 9.5) - 20.0, rel=1e-14)


def test_line_just_as_long_as_the_distance_needs_an_infinite_force() -> None:
    with pytest.raises(NoEquilibriumError, match="no finite force pulls it straight") as caught:
        solve(Line([Segment(5.0, W)]), height=3.0, span=4.0)
    assert caught.value.missing == 0.0


def test_taut_line_carries_the_force_of_a_parabola() -> None:
    """Near-taut: (L - c)/c = (w x cos / H)2 / 24 for the chord c; here 1e-6, sag squared 1e-5."""
    chord = math.hypot(17.0, 9.5)
    line = Line([Segment(chord * (1 + 1e-6), W)])
    solution = solve(line, height=9.5, span=17.0)
    parabola = W * 17.0 * (17.0 / chord) / math.sqrt(24 * 1e-6)
    # What is neglected is of the order of the sag squared.
    assert solution.horizontal_force == pytest.approx(parabola, rel=1e-4)


def test_taut_elastic_line_longer_than_its_length() -> None:
    """A line drawn beyond its length: T = EA e where its weight no longer matters."""
    line = Line([Segment(19.0, W, EA=80e6)])
    solution = solve(line, height=9.5, span=17.0)
    chord = math.hypot(17.0, 9.5)
    assert solution.fairlead.tension == pytest.approx(80e6 * (chord / 19.0 - 1), rel=1e-3)


def test_slack_line_hangs_straight_down() -> None:
    """Span below L - h: no horizontal force; the fairlead carries w h, the rest lies in bights."""
    solution = solve(BUOY, height=9.5, span=8.0)
    assert solution.regime == "slack"
    assert solution.horizontal_force == 0.0
    assert solution.fairlead.tension == pytest.approx(W * 9.5, rel=1e-12)
    assert solution.grounded_length == pytest.approx(10.5, rel=1e-12)
    assert solution.anchor.tension == 0.0
    assert "lie in bights" in solution.warnings[0]


def test_slack_limit_is_met_from_both_sides() -> None:
    """At S = L - h the line turns from slack to grounded."""
    assert solve(BUOY, height=9.5, span=10.5 * (1 - 1e-9)).regime == "slack"
    pulled = solve(BUOY, height=9.5, span=10.5 * (1 + 1e-3))
    assert pulled.regime == "grounded"
    assert 0.0 < pulled.horizontal_force < 0.01 * W * 20.0


def test_tension_below_the_hanging_weight_says_how_much_is_missing() -> None:
    """No force lifts less than the part that must hang: w h = 885.05 N."""
    with pytest.raises(NoEquilibriumError, match="N too small") as caught:
        solve(BUOY, height=9.5, fairlead_tension=800.0)
    assert caught.value.quantity == "force"
    # The least tension is found as a limit H -> 0, at 1e-13 of the weight.
    assert caught.value.missing == pytest.approx(W * 9.5 - 800.0, rel=1e-9)


def test_fairlead_at_the_bed_no_force_lifts_the_line() -> None:
    """With both ends on the bed the line lies there whatever pulls."""
    solution = solve(Line([Segment(20.0, W, EA=1e6)]), height=0.0, horizontal_force=1e5)
    assert solution.regime == "on-bed"
    assert solution.grounded_length == 20.0
    assert solution.span == pytest.approx(20.0 * (1 + 0.1), rel=1e-14)


@pytest.mark.parametrize("EA", [math.inf, 5e7])
@pytest.mark.parametrize("force", [100.0, 3000.0, 3e5])
def test_stretched_length_is_the_length_of_the_shape(EA: float, force: float) -> None:
    """Sum of chords of a fine profile: an order h2 below the arc, h = 1/4000 of it."""
    solution = solve(Line([Segment(20.0, W, EA)]), height=9.5, horizontal_force=force)
    profile = solution.profile(4001)
    pairs = list(zip(profile.x, profile.z, strict=True))
    chords = math.fsum(math.dist(p, q) for p, q in pairwise(pairs))
    assert chords == pytest.approx(solution.stretched_length, rel=1e-5)
    assert solution.stretched_length >= chords


def test_a_buoy_does_not_pull_an_anchor_on_the_bed_down() -> None:
    """100 m with a buoy at 40 m: V is 0 at the anchor from the force at which all of it hangs.

    A hair below that force a few millimetres lie on the bed; the anchor is never pulled down.
    """
    line = Line([Segment(100.0, 1000.0)], [PointLoad(40.0, -20000.0)])
    regimes = []
    for force in (182000.0, 182500.0, 182520.0, 182530.0, 183000.0, 190000.0):
        solution = solve(line, height=20.0, horizontal_force=force)
        assert solution.anchor.vertical_force >= 0.0
        regimes.append(solution.regime)
    assert regimes == ["grounded"] * 4 + ["suspended"] * 2


def test_a_span_that_friction_above_one_jumps_over_is_held() -> None:
    """Raised anchor, mu = 1.16: 1 - mu dV/dH at the anchor changes sign, so the line slides.

    By the force the span is seen to jump: neighbouring forces have spans on both sides of it. Held
    at a span between them the line rests all the same, and the answer says that it would slide.
    """
    line = Line([Segment(20.0, 1.0)])
    at = partial(solve, line, height=0.2, anchor_height=0.4, seabed_friction=1.16)
    held = at(span=19.65)
    assert check(held, "span", 19.65).is_right
    (warning,) = [each for each in held.warnings if "slides there" in each]
    assert f"span of {at(horizontal_force=held.horizontal_force).span:.6g} m" in warning
    forces = [held.horizontal_force * 1.001**k for k in range(-800, 800)]
    spans = [at(horizontal_force=force).span for force in forces]
    below = max(span for span in spans if span < 19.65)
    above = min(span for span in spans if span > 19.65)
    assert above - below > 0.05


def test_every_span_between_the_sides_of_a_jump_has_its_line() -> None:
    """Along the force at the anchor every span is passed, where friction is above 1, too.

    One chain, closed form: with V(H) = sqrt(w h (w h + 2 H)) at the fairlead and alike at the
    anchor, friction leaves H_anchor = H - mu (w L - V - V_down).
    """
    w, length, height, anchor, mu = 30.0, 1.8, 0.6, 0.34, 1.3

    def span(H_anchor: float) -> float:
        down = math.sqrt(w * anchor * (w * anchor + 2 * H_anchor))
        held = H_anchor + mu * (w * length - down)
        # H + mu V(H) = held, a quadratic equation for H
        b = held + mu**2 * w * height
        H = b - math.sqrt(b * b - held * held + (mu * w * height) ** 2)
        up = math.sqrt(w * height * (w * height + 2 * H))
        lies = length - (up + down) / w
        return lies + H / w * math.asinh(up / H) + H_anchor / w * math.asinh(down / H_anchor)

    for wanted in (0.5, 1.0, 2.0, 5.0, 10.0):
        found = solve(
            Line([Segment(length, w)]),
            height=height,
            anchor_height=anchor,
            seabed_friction=mu,
            span=span(wanted),
        )
        assert found.anchor.horizontal_force == pytest.approx(wanted, rel=1e-7)
