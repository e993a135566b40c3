"""Fatigue against ASTM E1049's example, hand calculations, and a count of the test's own."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from catopt.checks.fatigue import (
    CURVES,
    Cycles,
    FatigueStrength,
    count_cycles,
    design_factor,
    fatigue_strengths,
)
from catopt.constants import YEAR
from catopt.errors import InputError
from catopt.model import (
    Case,
    Checks,
    Dynamics,
    Fatigue,
    FatigueSeaState,
    Line,
    Load,
    Motion,
    Segment,
    SegmentCurve,
    Service,
    Site,
    WaveState,
)

DOUBLE = 1e-12
MM_A_YEAR = 1e-3 / YEAR


def counted(values: Sequence[float]) -> dict[float, float]:
    found = count_cycles(np.array(values, dtype=float), 1.0)
    return {
        float(size): float(found.counts[found.ranges == size].sum())
        for size in np.unique(found.ranges)
    }


def test_the_example_of_ASTM_E1049() -> None:
    """E1049-85, figure 6: ranges and cycles as printed there."""
    series = [-2, 1, -3, 5, -1, 3, -4, 4, -2]
    assert counted(series) == {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}


def test_a_constant_series_does_no_damage() -> None:
    assert CURVES["E301 stud"].damage(count_cycles(np.full(5, 3.0), 1.0), 0.01) == 0.0


def turning_points(values: Sequence[float]) -> list[float]:
    """First value, every local extreme, last value; of equal neighbours one."""
    kept = [values[0]]
    for value in values[1:]:
        if value != kept[-1]:
            if len(kept) > 1 and (kept[-1] - kept[-2]) * (value - kept[-1]) > 0:
                kept.pop()
            kept.append(value)
    return kept


def four_points(values: Sequence[float]) -> list[tuple[float, float]]:
    """Range and count of each cycle by four points: an inner pair within an outer one is a cycle.

    What remains at counts half. The sum over the ranges is that of E1049's three points, for
    both leave out the same pairs and leave over the same residue.
    """
    stack: list[float] = []
    found = []
    for value in turning_points(values):
        stack.append(value)
        while len(stack) > 3:
            a, b, c, d = stack[-4:]
            if min(a, d) <= min(b, c) and max(b, c) <= max(a, d):
                found.append((abs(b - c), 1.0))
                del stack[-3:-1]
            else:
                break
    found += [(abs(b - a), 0.5) for a, b in pairwise(stack)]
    return found


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("slope", [3.0, 4.0, 13.46])
def test_the_damage_of_a_random_series_is_that_of_another_count(seed: int, slope: float) -> None:
    values = np.random.default_rng(seed).normal(5e5, 1e5, 400)
    own = sum(count * (size / 1e6) ** slope for size, count in four_points(values.tolist()))
    found = count_cycles(values, 1.0)
    curve = replace(CURVES["E301 polyester"], factor=1.0, slope=slope)
    assert curve.damage(found, 1e6) == pytest.approx(own, rel=1e-9)


def sinusoid(amplitude: float, mean: float, periods: int, period: float) -> Cycles:
    """Tension from its lowest value, 40 samples a period: half a range per half period."""
    t = np.arange(40 * periods + 1) * period / 40.0
    values = mean - amplitude * np.cos(2.0 * math.pi * t / period)
    return count_cycles(values, periods * period)


def test_a_sinusoid_by_an_S_N_curve() -> None:
    """Range 400 kN of studless chain 100 mm, 8 s, a year.

    A = 2 pi 0.1^2/4 = 0.01570796 m2, s = 4e5/A = 25.46479 MPa; N = 6e10/25.46479^3 = 3,633,560;
    31,557,600 s a year/8 s = 3,944,700 cycles; D = 3,944,700/3,633,560 = 1.08563.
    """
    area = 2.0 * math.pi * 0.1**2 / 4.0
    of = FatigueStrength(CURVES["E301 studless"], area, 0.1)
    by_hand = (31_557_600.0 / 8.0) * (400e3 / area / 1e6) ** 3 / 6.0e10
    assert by_hand == pytest.approx(1.0856, abs=5e-5)
    assert of.damage([sinusoid(200e3, 800e3, 50, 8.0)]) == pytest.approx(by_hand, rel=1e-9)


def test_a_sinusoid_by_a_T_N_curve_with_mean_tension() -> None:
    """Range 400 kN of six-strand of 4000 kN at a mean of 800 kN, 8 s, a year.

    R = 0.1, Lm = 0.2, K = 10^(3.20 - 2.79 x 0.2) = 438.53; N = 438.53 x 10^4.09 = 5,395,106;
    D = 3,944,700/5,395,106 = 0.73116.
    """
    of = FatigueStrength(CURVES["API six-strand"], 4000e3, 0.08)
    # one sample more than whole periods: its mean is not quite that of the sinusoid
    even = replace(sinusoid(200e3, 800e3, 50, 8.0), mean=800e3)
    by_hand = 3_944_700.0 / (10.0 ** (3.20 - 2.79 * 0.2) * 0.1**-4.09)
    assert by_hand == pytest.approx(0.7312, abs=1e-4)
    assert of.damage([even]) == pytest.approx(by_hand, rel=1e-9)


def test_runs_are_put_together_by_their_time() -> None:
    """Of two runs the damage in a year is the sum of their damages over the sum of their times."""
    of = FatigueStrength(CURVES["E301 studless"], 0.01, 0.08)
    calm, rough = sinusoid(50e3, 5e5, 10, 10.0), sinusoid(100e3, 5e5, 30, 10.0)
    # a quarter of the time calm: 1/4 + 3/4 8 times the calm's, by m = 3
    assert of.damage([calm, rough]) == pytest.approx(6.25 * of.damage([calm]), rel=1e-9)


@pytest.mark.parametrize(
    ("name", "kind", "factor", "slope", "fall", "grade"),
    [
        ("E301 stud", "S-N", 1.2e11, 3.0, 0.0, "B"),
        ("E301 studless", "S-N", 6.0e10, 3.0, 0.0, "B"),
        ("E301 six-strand", "S-N", 3.4e14, 4.0, 0.0, "B"),
        ("E301 spiral", "S-N", 1.7e17, 4.8, 0.0, "B"),
        ("E301 polyester", "T-N", 0.259, 13.46, 0.0, "B"),
        ("API stud", "T-N", 1000.0, 3.0, 0.0, "C"),
        ("API studless", "T-N", 316.0, 3.0, 0.0, "B"),
        ("API six-strand", "T-N", 10.0**3.20, 4.09, 2.79, "C"),
        ("API spiral", "T-N", 10.0**3.25, 5.05, 3.43, "C"),
    ],
)
def test_the_curves_are_those_of_the_sheet(
    name: str, kind: str, factor: float, slope: float, fall: float, grade: str
) -> None:
    curve = CURVES[name]
    assert (curve.kind, curve.slope, curve.per_mean) == (kind, slope, fall)
    assert curve.factor == pytest.approx(factor, rel=DOUBLE)
    assert curve.source.confidence == grade


def test_every_curve_that_a_file_may_name_is_there() -> None:
    from catopt.model.dynamics import CURVE_NAMES

    assert set(CURVES) == set(CURVE_NAMES)


def segment(component: str, diameter: float | None = 0.1, MBL: float | None = None) -> Segment:
    return Segment(
        100.0, 1700.0, EA=8e8, mass=200.0, MBL=MBL, component=component, nominal_diameter=diameter
    )


def case(fatigue: Fatigue, *segments: Segment, **changes: object) -> Case:
    given: dict[str, object] = {
        "site": Site(20.0),
        "line": Line(list(segments)),
        "load": Load(horizontal_force=3e5),
        "fairlead_height": 20.0,
        "motion": Motion(period=8.0, surge=1.0),
        "waves": WaveState("regular", 2.0, 8.0),
        "dynamics": Dynamics(60.0),
        "service": Service(20.0 * YEAR, 0.4 * MM_A_YEAR),
        "fatigue": fatigue,
    }
    return Case(**(given | changes))  # type: ignore[arg-type]


STATES = (FatigueSeaState(2.0, 8.0, 1.0),)
E301 = Fatigue(STATES, code="DNV-OS-E301-2008")
API = Fatigue(STATES, code="API-RP-2SK", design_factor=3.0)


def test_half_the_loss_of_diameter_goes_into_the_area() -> None:
    """100 mm, 20 years of 0.4 mm: 8 mm lost, half of it 4 mm; 96 mm; A = 2 pi 96^2/4 mm2."""
    (found,) = fatigue_strengths(case(E301, segment("chain studless R3")))
    assert found.diameter == pytest.approx(0.096, rel=DOUBLE)
    assert found.reference == pytest.approx(2.0 * math.pi * 0.096**2 / 4.0, rel=DOUBLE)


def test_a_rope_has_one_cross_section() -> None:
    (found,) = fatigue_strengths(case(E301, segment("wire spiral-strand")))
    assert found.curve is CURVES["E301 spiral"]
    assert found.reference == pytest.approx(math.pi * 0.096**2 / 4.0, rel=DOUBLE)


def test_chain_by_API_refers_to_ORQ_at_half_the_loss_whatever_its_grade() -> None:
    """ORQ: 0.0211 d^2 (44 - 0.08 d) kN, d in mm: 0.0211 x 96^2 x 36.32 = 7062.7 kN at 96 mm."""
    by_hand = 0.0211 * 96.0**2 * (44.0 - 0.08 * 96.0) * 1e3
    assert by_hand == pytest.approx(7062.7e3, abs=50.0)
    for grade in ("R3", "R4"):
        (found,) = fatigue_strengths(case(API, segment(f"chain stud-link {grade}")))
        assert found.curve is CURVES["API stud"]
        assert found.reference == pytest.approx(by_hand, rel=1e-9)


def test_wire_by_API_refers_to_its_own_strength() -> None:
    """(96/100)^2 of 8000 kN is 7372.8 kN; a wire's MBL goes with the square of its diameter."""
    wire = segment("wire 6-strand wire-core", MBL=8000e3)
    (found,) = fatigue_strengths(case(API, wire))
    assert found.reference == pytest.approx(7372.8e3, rel=1e-9)


def test_polyester_keeps_its_strength() -> None:
    (found,) = fatigue_strengths(case(E301, segment("polyester", 0.14, MBL=8000e3)))
    assert found.curve is CURVES["E301 polyester"]
    assert found.reference == 8000e3


def test_given_curves_go_before_the_code() -> None:
    own = (SegmentCurve(segment=2, log_a_D=10.0, m=3.5), SegmentCurve(K=100.0, M=3.0))
    fatigue = Fatigue(STATES, curves=own, design_factor=5.0)
    chain = segment("chain studless R3", MBL=5e6)
    first, second = fatigue_strengths(case(fatigue, chain, chain, service=Service(YEAR)))
    assert (first.curve.kind, first.curve.factor, first.curve.slope) == ("T-N", 100.0, 3.0)
    assert first.reference == 5e6
    assert (second.curve.kind, second.curve.slope) == ("S-N", 3.5)
    assert second.curve.factor == pytest.approx(1e10, rel=DOUBLE)


def test_what_has_no_curve_is_refused_for_every_segment_at_once() -> None:
    wrong = case(
        E301, segment("chain open-link 3D"), segment(""), segment("chain studless R3", None)
    )
    with pytest.raises(InputError) as caught:
        fatigue_strengths(replace(wrong, service=Service(YEAR)))
    keys = [problem.key for problem in caught.value.problems]
    assert keys == ["line.segments[0]", "line.segments[1]", "line.segments[2].diameter"]


def test_a_curve_of_another_kind_of_line_is_refused() -> None:
    fatigue = Fatigue(STATES, design_factor=5.0, curves=(SegmentCurve(name="E301 spiral"),))
    with pytest.raises(InputError, match=r"fatigue.curves\[0\].name: .*is for wire"):
        fatigue_strengths(case(fatigue, segment("chain studless R3")))


@pytest.mark.parametrize(("component", "factor"), [("chain studless R3", 8.0), ("polyester", 60.0)])
def test_the_factor_of_E301(component: str, factor: float) -> None:
    of = case(E301, segment(component, 0.14, MBL=5e6))
    (found,) = fatigue_strengths(of)
    assert design_factor(of, found.curve)[0] == factor
    assert design_factor(of, found.curve)[1].confidence == "C"
    assert design_factor(of, found.curve)[1].document == "DNV-OS-E301 (2008)"


def test_the_recalled_factor_of_API_is_not_taken_unless_allowed() -> None:
    of = case(replace(API, design_factor=None), segment("chain studless R3"))
    curve = CURVES["API studless"]
    with pytest.raises(InputError, match=r"design_factor.*recalled \(R\).*allow_recalled"):
        design_factor(of, curve)
    allowed = replace(of, checks=Checks(allow_recalled=True))
    assert design_factor(allowed, curve)[0] == 3.0
    assert design_factor(allowed, curve)[1].confidence == "R"
    assert design_factor(allowed, curve)[1].document == "API RP 2SK 3rd ed. (2005)"


def test_the_recalled_factor_of_API_is_the_same_for_polyester() -> None:
    """A factor of 3 on the damage of every component."""
    of = case(replace(API, design_factor=None), segment("chain studless R3"))
    allowed = replace(of, checks=Checks(allow_recalled=True))
    assert design_factor(allowed, CURVES["E301 polyester"])[0] == 3.0


def test_a_factor_of_one_s_own_goes_before_the_code_s() -> None:
    of = case(replace(E301, design_factor=4.5), segment("chain studless R3"))
    factor, source = design_factor(of, CURVES["E301 studless"])
    assert (factor, source.code) == (4.5, "user")


def test_without_rainflow_the_way_out_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rainflow", None)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    with pytest.raises(InputError, match=r"rainflow: .*pip install 'catopt\[fatigue\]'"):
        count_cycles(np.array([0.0, 1.0, 0.0]), 1.0)
