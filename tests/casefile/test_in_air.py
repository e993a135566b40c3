"""A line in air: a case without site, without water and bed."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import catopt
from catopt.casefile import parse_case, write_case
from catopt.catenary.solution import Solution
from catopt.errors import InputError
from catopt.model import Case
from tests.cli.conftest import Run, document_of, run, words

__all__ = ("run",)

CABLE = """
[line]
fairlead_height = "5 m"
[[line.segments]]
length = "23 m"
submerged_weight = "100 N/m"
[load]
span = "20 m"
"""


def of(text: str) -> tuple[Case, Solution]:
    case = parse_case(text)
    return case, catopt.solve_case(case)


def test_a_cable_in_air_has_its_lowest_point_and_its_sag() -> None:
    """A catenary of 23 m over 20 m and 5 m: a sinh(10/a) = sqrt(23^2 - 5^2)/2, H = 100 a.

    By bisection a = 11.8729 m; its lowest point is at x = 10 - a artanh(5/23), where the cable is
    a (cosh(x/a) - 1) below its lower end; it is as steep as its chord, 1/4, at x + a asinh(1/4).
    """
    low, high = 1.0, 100.0
    for _ in range(200):
        a = 0.5 * (low + high)
        low, high = (a, high) if a * math.sinh(10.0 / a) > 0.5 * math.sqrt(504.0) else (low, a)
    _, found = of(CABLE)
    assert found.horizontal_force == pytest.approx(100.0 * a, rel=1e-9)
    x = 10.0 - a * math.atanh(5.0 / 23.0)
    deep = a * (math.cosh(x / a) - 1.0)
    steep = x + a * math.asinh(0.25)
    sag = 0.25 * steep - (a * math.cosh((steep - x) / a) - a - deep)
    lowest = found.lowest_point
    assert (lowest.x, lowest.z, found.sag) == pytest.approx((x, -deep, sag), abs=1e-8)
    assert (found.anchor_height, found.fairlead_height) == pytest.approx((0.0, 5.0), abs=1e-9)
    assert min(found.profile(501).z) == pytest.approx(-deep, abs=1e-3)


def test_level_supports_sag_midway() -> None:
    """The parabola's w L^2/(8 H) is the sag to the order of (sag/span)^2."""
    text = CABLE.replace('"5 m"', '"0 m"').replace('"23 m"', '"20.02 m"')
    _, found = of(text)
    sag = 100.0 * 20.0**2 / (8.0 * found.horizontal_force)
    assert found.lowest_point.x == pytest.approx(10.0, abs=1e-6)
    assert found.sag == pytest.approx(sag, rel=2.0 * (sag / 20.0) ** 2)
    assert found.lowest_point.z == pytest.approx(-found.sag, abs=1e-9)


@pytest.mark.parametrize("water", ["5 m", "50 m"])
def test_water_is_no_longer_invented(water: str) -> None:
    """On a bed 5 m below, 16.5 m of it would lie there; in air the tension is 1.924 kN."""
    _, in_air = of(CABLE)
    assert in_air.fairlead.tension == pytest.approx(1923.94, abs=5e-3)
    assert in_air.grounded_length == 0.0
    high = CABLE.replace('"5 m"', '"25 m"\nanchor_height = "20 m"')
    _, above = of(f'[site]\nwater_depth = "{water}"\n{high}')
    assert above.fairlead.tension == pytest.approx(in_air.fairlead.tension, rel=1e-9)
    assert above.lowest_point.z == pytest.approx(in_air.lowest_point.z + 20.0, abs=1e-8)


def test_a_component_weighs_in_air_what_its_mass_does() -> None:
    chain = CABLE.replace('submerged_weight = "100 N/m"', 'component = "chain studless R3"')
    case, _ = of(chain.replace('length = "23 m"', 'length = "23 m"\ndiameter = "20 mm"'))
    (segment,) = case.line.segments
    assert segment.mass is not None
    assert segment.submerged_weight == pytest.approx(9.80665 * segment.mass, rel=1e-12)
    assert parse_case(write_case(case)) == case


def test_every_command_answers_or_says_what_it_wants(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "cable.toml"
    place.write_text(CABLE, encoding="utf-8")
    said = words(run("solve", place).out)
    assert "the line hangs in air: no [site]" in said
    assert "-2.367 m" in said
    document = document_of(run, "solve", place)
    assert document["sag_m"] == pytest.approx(4.5799, abs=5e-5)
    for command in ("check", "curve", "verify"):
        assert run(command, place).status == 0, command
    assert run("solve", place, "--out", tmp_path / "out").status == 0
    for typed in (("report",), ("export", "--to", "moordyn"), ("system",)):
        assert run(*typed, place).status == 2, typed
    assert "[site] with water_depth" in words(run("report", place).err)


def test_what_wants_water_wants_a_site() -> None:
    wet = CABLE + '[current]\nprofile = "uniform"\nspeed = "1 m/s"\n[anchor]\nkind = "sinker"\n'
    with pytest.raises(
        InputError, match=r"site: missing; \[anchor\], \[current\] needs a table \[site\]"
    ):
        parse_case(wet)
    with pytest.raises(InputError, match=r"line\.fairlead_height: missing"):
        parse_case(CABLE.replace('fairlead_height = "5 m"', ""))
    with pytest.raises(InputError, match="an unknown key"):
        parse_case("[sites]\nwater_depth = 5\n" + CABLE)
