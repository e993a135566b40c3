"""Spectra against closed forms and quadrature of their printed formulas."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from catopt.errors import InputError
from catopt.waves import Spectrum, frequency_range, jonswap, peak_enhancement, pierson_moskowitz

HS, TP = 8.48, 12.965
PEAK = 2.0 * math.pi / TP
GAMMAS = [1.0, 1.878, 3.3, 7.0, 20.0]


def printed(omega: float, gamma: float) -> float:
    """S4 [2.59], [2.65]-[2.67] as they stand."""
    plain = 5.0 / 16.0 * HS**2 * PEAK**4 * omega**-5 * math.exp(-1.25 * (omega / PEAK) ** -4)
    sigma = 0.07 if omega <= PEAK else 0.09
    peak = math.pow(gamma, math.exp(-0.5 * ((omega - PEAK) / (sigma * PEAK)) ** 2))
    return (1.0 - 0.287 * math.log(gamma)) * plain * peak


def integral(gamma: float, order: int, end: float = math.inf) -> float:
    """Moment of the printed formula by adaptive quadrature, in pieces about the peak."""
    cuts = [0.3, 0.7, 0.9, 1.0, 1.1, 1.3, 2.0, 5.0]
    edges = [PEAK * c for c in cuts if PEAK * c < end] + [end]
    return math.fsum(
        quad(lambda w: w**order * printed(w, gamma), a, b, epsabs=0.0, epsrel=1e-12)[0]
        for a, b in pairwise(edges)
    )


@pytest.mark.parametrize("gamma", GAMMAS)
@pytest.mark.parametrize("ratio", [0.6, 0.95, 1.0, 1.05, 3.0])
def test_density_is_the_printed_formula(gamma: float, ratio: float) -> None:
    """Equal but for the rounding of a dozen operations."""
    spectrum = Spectrum(HS, TP, gamma, "S4")
    assert spectrum.density(ratio * PEAK) == pytest.approx(printed(ratio * PEAK, gamma), rel=1e-13)


@pytest.mark.parametrize("ratio", [0.5, 0.99, 1.0, 1.2, 4.0])
def test_jonswap_of_gamma_1_is_pierson_moskowitz(ratio: float) -> None:
    """As its own formula, without a peak; rounding only."""
    omega = ratio * PEAK
    alone = 5.0 / 16.0 * HS**2 * PEAK**4 * omega**-5 * math.exp(-1.25 * (omega / PEAK) ** -4)
    assert jonswap(HS, TP, 1.0).density(omega) == pytest.approx(alone, rel=1e-14)
    assert pierson_moskowitz(HS, TP).density(omega) == pytest.approx(alone, rel=1e-14)


def test_pierson_moskowitz_moments_have_closed_forms() -> None:
    """m0 = Hs²/16, m2 = (Hs²/16) omega_p² sqrt(5 pi/4), m_-4 = 0.8 m0/omega_p⁴; rounding only."""
    spectrum = pierson_moskowitz(HS, TP)
    m0 = HS**2 / 16.0
    assert spectrum.moment(0) == pytest.approx(m0, rel=1e-14)
    assert spectrum.moment(2) == pytest.approx(m0 * PEAK**2 * math.sqrt(1.25 * math.pi), rel=1e-14)
    assert spectrum.moment(-4) == pytest.approx(0.8 * m0 / PEAK**4, rel=1e-14)


@pytest.mark.parametrize("gamma", GAMMAS)
@pytest.mark.parametrize("order", [-2, -1, 0, 1, 2])
def test_moments_agree_with_quadrature(gamma: float, order: int) -> None:
    """Quadrature was asked for 1e-12 and starts at 0.3 omega_p, below which there is e^-154."""
    assert Spectrum(HS, TP, gamma, "S4").moment(order) == pytest.approx(
        integral(gamma, order), rel=1e-11
    )


@pytest.mark.parametrize("gamma", GAMMAS)
def test_energy_below_agrees_with_quadrature(gamma: float) -> None:
    ends = PEAK * np.array([0.7, 0.97, 1.0, 1.04, 1.5, 6.0])
    wanted = [integral(gamma, 0, end) for end in ends]
    np.testing.assert_allclose(Spectrum(HS, TP, gamma, "S4").energy_below(ends), wanted, rtol=1e-11)


@pytest.mark.parametrize("gamma", GAMMAS)
def test_significant_height_is_kept(gamma: float) -> None:
    """4 sqrt(m0) = Hs, m0 by quadrature of the density; the printed factor only comes near."""
    spectrum = jonswap(HS, TP, gamma)
    printed_m0 = integral(gamma, 0)
    m0 = printed_m0 * float(spectrum.density(PEAK)) / printed(PEAK, gamma)
    assert 4.0 * math.sqrt(m0) == pytest.approx(HS, rel=1e-11)


def test_how_far_the_printed_factor_is_off() -> None:
    """0.2 % of Hs for the gammas of the rule, 0.9 % at 7, and 22 % at 20, far from its fit."""
    off = {
        gamma: 4.0 * math.sqrt(jonswap(HS, TP, gamma, normalisation="S4").moment(0)) / HS - 1.0
        for gamma in (1.5, 2.0, 3.3, 5.0, 7.0, 20.0)
    }
    assert max(abs(off[gamma]) for gamma in (1.5, 2.0, 3.3, 5.0)) < 0.002, off
    assert abs(off[7.0]) == pytest.approx(0.009, abs=0.0005)
    assert off[20.0] == pytest.approx(-0.22, abs=0.005)


def test_periods_of_pierson_moskowitz() -> None:
    """S4 prints Tp = 1.408 Tz and Tz = Tm/1.086: four digits of the ratios of the moments."""
    spectrum = pierson_moskowitz(HS, TP)
    assert f"{TP / spectrum.zero_crossing_period:.3f}" == "1.408"
    assert f"{spectrum.mean_period / spectrum.zero_crossing_period:.3f}" == "1.086"


@pytest.mark.parametrize(
    ("x", "gamma"),
    [
        (2.0, 5.0),
        (3.6, 5.0),
        (3.6000001, math.exp(5.75 - 1.15 * 3.6000001)),
        (4.5, math.exp(0.575)),
        (4.9999999, math.exp(5.75 - 1.15 * 4.9999999)),
        (5.0, 1.0),
        (9.0, 1.0),
    ],
)
def test_gamma_rule(x: float, gamma: float) -> None:
    """S4 [2.68]-[2.70]; the rule has a step from 5 to 5.003 at 3.6. Rounding of x only."""
    assert peak_enhancement(4.0, 2.0 * x) == pytest.approx(gamma, rel=1e-13)


@pytest.mark.parametrize("gamma", GAMMAS)
def test_default_range_leaves_out_a_thousandth(gamma: float) -> None:
    spectrum = jonswap(HS, TP, gamma)
    low, high = spectrum.energy_below(np.array(frequency_range(spectrum))) / spectrum.moment(0)
    assert low < 1e-8
    assert 1.0 - high < 1e-3


@pytest.mark.parametrize(
    ("arguments", "keys"),
    [
        ((0.0, -1.0, 0.5), ["significant_height", "peak_period", "gamma"]),
        ((8.0, math.nan, 21.0), ["peak_period", "gamma"]),
        ((8.0, 10.0, 1.0, "DNV"), ["normalisation"]),
    ],
)
def test_wrong_input_is_named_all_at_once(arguments: tuple[float, ...], keys: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        Spectrum(*arguments)  # type: ignore[arg-type]
    assert [p.key for p in caught.value.problems] == keys


def test_jonswap_by_the_rule_and_the_fourth_moment_refuse() -> None:
    with pytest.raises(InputError, match="significant_height"):
        jonswap(-1.0, 10.0)
    with pytest.raises(InputError, match="order"):
        jonswap(8.0, 10.0).moment(4)
