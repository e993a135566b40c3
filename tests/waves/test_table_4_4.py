"""S4, Table 4.4: what Tm = 10 s and Hs = 8.48 m give for the FSO Rang Dong. Printed digits."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from catopt.errors import InputError
from catopt.waves import (
    jonswap,
    peak_enhancement,
    peak_from_mean,
    peak_from_zero_crossing,
    pierson_moskowitz,
    s4_range_jonswap,
    s4_range_pierson_moskowitz,
    zero_crossing_from_mean,
)
from catopt.waves.random_surface import thousandth

HS, TM = 8.48, 10.0


def periods(between: tuple[float, float]) -> tuple[float, float]:
    low, high = between
    return 2.0 * math.pi / high, 2.0 * math.pi / low


def test_peak_period() -> None:
    assert f"{peak_from_mean(TM):.3f}" == "12.965"
    assert peak_from_mean(TM) == peak_from_zero_crossing(zero_crossing_from_mean(TM))


def test_pierson_moskowitz_range() -> None:
    """The longest period is printed as 15.87; 15.876 was cut off, not rounded."""
    low, high = s4_range_pierson_moskowitz(zero_crossing_from_mean(TM))
    assert (f"{low:.3f}", f"{high:.3f}") == ("0.396", "3.487")
    shortest, longest = periods((low, high))
    assert f"{shortest:.3f}" == "1.802"
    assert 15.87 <= longest < 15.88


def test_gamma() -> None:
    assert f"{jonswap(HS, peak_from_mean(TM)).gamma:.3f}" == "1.878"


def test_jonswap_range() -> None:
    """Lower end to the printed digits; upper end, whose rule is not printed, within 0.2 %."""
    low, high = s4_range_jonswap(jonswap(HS, peak_from_mean(TM)))
    assert f"{low:.3f}" == "0.282"
    assert high == pytest.approx(2.186, rel=0.002)
    assert high < 2.1855  # not the printed digits: should they be met, the rule was found


def test_jonswap_longest_period_is_a_misprint() -> None:
    """2 pi/0.282 is 22.28, where 11.14 stands: half of it. The shortest agrees with its range."""
    shortest, longest = periods((0.282, 2.186))
    assert f"{longest:.2f}" == "22.28"
    assert f"{longest / 2.0:.2f}" == "11.14"
    assert f"{shortest:.3f}" == "2.874"


def test_what_the_factor_5_1101_means() -> None:
    """S of Pierson-Moskowitz falls to 1/1000 of its peak at 5.1099 peak frequencies."""
    spectrum = pierson_moskowitz(HS, 10.0)
    assert thousandth(spectrum) / spectrum.peak_frequency == pytest.approx(5.1101, rel=1e-4)


def test_the_pierson_moskowitz_range_leaves_out_six_percent() -> None:
    """1.408 times 0.58 peak frequencies: exp(-1.25 (0.58 · 1.408)^-4) = 0.0602."""
    spectrum = pierson_moskowitz(HS, peak_from_mean(TM))
    low, _ = s4_range_pierson_moskowitz(zero_crossing_from_mean(TM))
    assert float(spectrum.energy_below(low)) / spectrum.moment(0) == pytest.approx(0.0602, abs=1e-4)


@pytest.mark.parametrize("rule", [zero_crossing_from_mean, peak_from_zero_crossing, peak_from_mean])
def test_no_period_is_refused(rule: Callable[[float], float]) -> None:
    with pytest.raises(InputError, match="must be above 0 s"):
        rule(0.0)
    with pytest.raises(InputError, match="must be above 0 s"):
        s4_range_pierson_moskowitz(0.0)


def test_the_gamma_printed_for_the_second_weather_is_not_the_rule_s() -> None:
    """S4 prints 5.228 for Tp 10.372 s and 8.48 m: its exponential beyond where its rule has 5."""
    peak = peak_from_mean(8.0)
    assert peak == pytest.approx(10.372, abs=5e-4)  # printed digits
    assert math.exp(5.75 - 1.15 * peak / math.sqrt(8.48)) == pytest.approx(5.228, abs=5e-4)
    assert peak_enhancement(8.48, peak) == 5.0
