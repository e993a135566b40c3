"""One number of a file from one condition on its answer: by hand and by the plain catenary."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from scipy.optimize import brentq

from catopt import InputError, Line, Segment, solve
from catopt.constants import STANDARD_GRAVITY as G
from catopt.errors import NoAnswerError
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest
from catopt.study.finding import find_value

HANGING = """
[site]
water_depth = "200 m"

[[points]]
name = "ice"
kind = "fairlead"
x = "0 m"
y = "0 m"
height = "200 m"

[[points]]
name = "weight"
kind = "joint"
submerged_weight = "300 N"

[[lines]]
name = "cable"
start = "ice"
end = "weight"

[[lines.segments]]
length = "60 m"
submerged_weight = "2 N/m"
EA = "20 kN"
"""

FLOAT = """
[site]
water_depth = "20 m"

[[points]]
name = "anchor"
kind = "anchor"
x = "0 m"
y = "0 m"

[[points]]
name = "mark"
kind = "joint"
submerged_weight = "-800 N"
mass = "20 kg"
float_height = "0.5 m"

[[lines]]
name = "riser"
start = "anchor"
end = "mark"

[[lines.segments]]
length = "19 m"
submerged_weight = "1 N/m"
EA = "50 kN"
"""

STRUNG = """
[site]
water_depth = "1000 m"

[line]
fairlead_height = "600 m"
anchor_height = "600 m"

[load]
span = "100 m"

[[line.segments]]
length = "110 m"
submerged_weight = "50 N/m"
EA = "500 GN"
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "case.toml"


def test_a_cable_that_reaches_a_depth(file: Path) -> None:
    file.write_text(HANGING)
    found = find_value(file, "lines[cable].segments[0].length", "weight.z = 100 m")
    (only,) = found.solutions
    # L + (W L + w L^2 / 2) / EA = 100 m.
    EA, W, w = 20e3, 300.0, 2.0
    b = 1.0 + W / EA
    length = (-b + math.sqrt(b * b + 4.0 * 100.0 * w / (2.0 * EA))) / (w / EA)
    assert only.value == pytest.approx(length, rel=1e-9)
    assert only.reached == pytest.approx(100.0, rel=1e-8)
    assert abs(only.residual) < 1e-8
    assert found.key == "lines[0].segments[0].length"
    (same,) = find_value(file, found.key, "weight.depth = 100 m").solutions
    assert same.value == pytest.approx(length, rel=1e-9)
    mooring = found.mooring()
    assert isinstance(mooring, Network)
    assert at_rest(mooring).place_of("weight")[2] == pytest.approx(100.0, rel=1e-8)
    assert (found.low, found.high) == (6.0, 600.0)
    assert found.to_dict()["solutions"][0]["value"] == only.value


def test_a_riser_that_takes_its_float_just_under(file: Path) -> None:
    file.write_text(FLOAT)
    # With its top at the surface the float pulls with all of 800 N, the riser weighs 1 N/m.
    found = find_value(file, "lines[riser].segments[0].length", "mark.awash = 0", "15 m", "25 m")
    (only,) = found.solutions
    # L + (800 L - L^2 / 2) / 50 kN = 19.5 m.
    b = 1.0 + 800.0 / 50e3
    length = (b - math.sqrt(b * b - 4.0 * 19.5 / 100e3)) * 50e3
    assert only.value == pytest.approx(length, rel=1e-9)
    half = find_value(
        file, "lines[riser].segments[0].length", "mark.freeboard = 0.25 m", "15 m", "25 m"
    )
    lost = 0.5 * (800.0 + 20.0 * G)
    mooring = half.mooring()
    assert isinstance(mooring, Network)
    assert at_rest(mooring).floats[0].used == pytest.approx(800.0 - lost, rel=1e-7)


def test_all_of_several_values_are_told(file: Path) -> None:
    # A short cable is taut, a long one heavy: either pulls with 6 kN.
    file.write_text(STRUNG)
    found = find_value(file, "line.segments[0].length", "line.fairlead_tension = 6 kN", "100 m")
    short, long = found.solutions
    for each in (short, long):
        line = Line([Segment(each.value, 50.0, EA=5e11)])
        solution = solve(line, height=600.0, anchor_height=600.0, span=100.0)
        assert solution.fairlead.tension == pytest.approx(6e3, rel=1e-8)
    # The catenary: T = (w S / 2) cosh u / u and L = S sinh u / u.
    for each, ends in ((short, (0.1, 1.0)), (long, (1.5, 5.0))):
        u = brentq(lambda u: 2500.0 * math.cosh(u) / u - 6e3, *ends, xtol=1e-14)
        assert each.value == pytest.approx(100.0 * math.sinh(u) / u, rel=1e-5)


def test_what_is_in_reach_of_a_part_of_the_range_alone(file: Path) -> None:
    file.write_text(STRUNG.replace('EA = "500 GN"\n', ""))
    found = find_value(file, "line.segments[0].length", "line.sag = 20 m", "50 m", "200 m")
    (only,) = found.solutions
    assert solve(
        Line([Segment(only.value, 50.0)]), height=600.0, anchor_height=600.0, span=100.0
    ).sag == pytest.approx(20.0, rel=1e-8)
    assert "too short" in found.reasons[0]
    with pytest.raises(NoAnswerError, match=r"no line\.segments\[0\]\.length of the range has"):
        find_value(file, "line.segments[0].length", "line.sag = 20 m", "50 m", "90 m")


def test_where_nothing_gives_it_the_nearest_is_told(file: Path) -> None:
    file.write_text(HANGING)
    with pytest.raises(NoAnswerError, match=r"from 30 N to 3000 N gives weight\.z = 150 m"):
        find_value(file, "points[weight].submerged_weight", "weight.z = 150 m")


@pytest.mark.parametrize(
    ("key", "until", "low", "said"),
    [
        ("points[weight].name", "weight.z = 1 m", None, "number is required"),
        ("points[weight].submerged_weight", "weight = 1 m", None, "weight.z = 100 m"),
        ("points[weight].submerged_weight", "ring.z = 1 m", None, "weight"),
        ("points[weight].submerged_weight", "weight.draught = 1 m", None, "bed_reaction"),
        ("points[weight].submerged_weight", "weight.z = 1 kN", None, "length"),
        ("points[weight].drag_area", "weight.z = 1 m", None, "no number at"),
        ("points[weight].submerged_weight", "weight.z = 1 m", "9 kN", "must be below"),
    ],
)
def test_what_cannot_be_asked_is_refused_with_what_can(
    file: Path, key: str, until: str, low: str | None, said: str
) -> None:
    file.write_text(HANGING)
    with pytest.raises(InputError) as error:
        find_value(file, key, until, low)
    assert said in str(error.value)


def test_a_sinker_that_begins_to_slide(file: Path) -> None:
    file.write_text(
        STRUNG.replace('anchor_height = "600 m"\n', "")
        .replace("600 m", "60 m")
        .replace("110 m", "150 m")
        + '\n[anchor]\nkind = "sinker"\nsubmerged_weight = "8 kN"\n'
        + "friction = 0.5\nsafety_factor = 1.5\n"
    )
    found = find_value(file, "load.span", "check.sliding = 1", "100 m", "135 m")
    (only,) = found.solutions
    anchor = solve(Line([Segment(150.0, 50.0, EA=5e11)]), height=60.0, span=only.value).anchor
    needed = anchor.vertical_force + 1.5 * anchor.horizontal_force / 0.5
    assert needed == pytest.approx(8e3, rel=1e-7)
