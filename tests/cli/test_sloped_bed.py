"""``[site] seabed_slope``: a line in motion on a bed that slopes, and who refuses it."""

from __future__ import annotations

import json
import math
from pathlib import Path

import jsonschema
import pytest

from catopt import schemas
from catopt.casefile import parse_case, read_case
from catopt.errors import InputError
from catopt.figures.motion import on_slope
from catopt.verify.case import verify_case
from catopt.verify.dynamic import verify_dynamic

from .conftest import Run

CASE = """
title = "A chain on a slope"
[site]
water_depth = "60 m"
seabed_friction = 0.6
seabed_slope = "5 deg"
[line]
[[line.segments]]
length = "200 m"
submerged_weight = "1000 N/m"
mass = "117 kg/m"
EA = "500 MN"
MBL = "3 MN"
drag_diameter = "76 mm"
drag_normal = 2.4
[load]
horizontal_force = "40 kN"
[motion]
period = "10 s"
surge = "0.5 m"
[dynamics]
duration = "10 s"
ramp = "5 s"
elements = 40
"""


@pytest.fixture
def sloped(tmp_path: Path) -> Path:
    path = tmp_path / "sloped.toml"
    path.write_text(CASE, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "command",
    [
        ("solve",), ("solve", "--method", "pso"), ("check",), ("curve",), ("verify",),
        ("report",), ("report", "--dynamic"), ("export", "--to", "moordyn"),
    ],
)  # fmt: skip
def test_what_has_no_answer_refuses_the_key(run: Run, sloped: Path, command: list[str]) -> None:
    ran = run(command[0], sloped, *command[1:])
    assert (ran.status, ran.out) == (2, "")
    assert "site.seabed_slope: found 5 deg; must be 0 or left out" in ran.err


def test_a_design_refuses_it(run: Run, tmp_path: Path) -> None:
    given = Path("cases/design-leg-56m/case.toml").read_text(encoding="utf-8")
    path = tmp_path / "case.toml"
    path.write_text(
        given.replace("[site]\n", '[site]\nseabed_slope = "-2 deg"\n'), encoding="utf-8"
    )
    ran = run("design", path)
    assert (ran.status, ran.out) == (2, "")
    assert "site.seabed_slope: found -2 deg" in ran.err


@pytest.mark.parametrize("slope", ['"46 deg"', '"-46 deg"', '"3 m"'])
def test_a_slope_out_of_range_is_refused(slope: str) -> None:
    with pytest.raises(InputError, match=r"site\.seabed_slope"):
        parse_case(CASE.replace('"5 deg"', slope))


def test_a_line_in_motion_on_a_slope(run: Run, sloped: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = run("verify", sloped, "--dynamic", "--once", "--out", out)
    assert ran.status == 0
    assert "the bed slopes by 5°" in " ".join(ran.out.split())
    assert "quasi-static" not in ran.out
    found = json.loads((out / "verify.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schemas.schema("catopt.verify/1")).validate(found)
    assert (found["static"], found["load_cases"], found["verdict"]) == (None, [], "not compared")
    (part,) = found["dynamic"]["load_cases"]
    assert part["quasi_static_max_tension_N"] is None
    assert not (out / "verify.xlsx").exists()
    assert "slopes by 5°" in (out / "line.svg").read_text(encoding="utf-8")
    said = run("verify", sloped, "--dynamic", "--once", "--lang", "vi").out
    assert "đáy biển dốc 5°" in " ".join(said.split())


def test_the_drawing_has_the_slope_and_the_line_on_it(sloped: Path) -> None:
    case = read_case(sloped)
    (part,) = verify_dynamic(case, proof="none").parts
    chart = on_slope(part, 60.0, case.site.seabed_slope)
    bed, line = chart.series
    rise = math.tan(math.radians(5.0))
    assert [z / x for x, z in zip(bed.x, bed.y, strict=True)] == pytest.approx([rise, rise])
    above = [z - rise * x for x, z in zip(line.x, line.y, strict=True)]
    # Own weight presses the bed 1 cm deep; half of the line lies.
    assert min(above) > -0.02
    assert sum(each < 0.02 for each in above) > 20
    assert chart.to_scale == 1.0


def test_the_fairlead_tension_is_no_load_on_a_slope() -> None:
    text = CASE.replace('horizontal_force = "40 kN"', 'fairlead_tension = "90 kN"')
    with pytest.raises(InputError, match=r"load\.fairlead_tension: found 90000 N; give horiz"):
        verify_dynamic(parse_case(text))


def test_what_is_sought_needs_a_level_bed() -> None:
    text = CASE.replace("[load]", '[find]\nquantity = "touchdown_force"\n[load]').replace(
        '[load]\nhorizontal_force = "40 kN"', ""
    )
    with pytest.raises(InputError, match=r"site\.seabed_slope"):
        verify_dynamic(parse_case(text))


def test_python_refuses_it_too(sloped: Path) -> None:
    with pytest.raises(InputError, match=r"site\.seabed_slope"):
        verify_case(read_case(sloped))
