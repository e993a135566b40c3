"""``[site] seabed_slope``: a line in motion on a bed that slopes, and who refuses it in Python."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from catopt.casefile import parse_case, read_case
from catopt.errors import InputError
from catopt.figures.motion import on_slope
from catopt.verify.case import verify_case
from catopt.verify.dynamic import verify_dynamic

from .conftest import OWN, Run, names, read_document, words

SLOPED = OWN / "sloped.toml"
CASE = SLOPED.read_text("utf-8")
FORCE = 'horizontal_force = "40 kN"'


def test_a_line_in_motion_on_a_slope(run: Run, tmp_path: Path) -> None:
    moving = ("verify", SLOPED, "--dynamic", "--once")
    ran = run(*moving, "--out", tmp_path)
    assert ran.status == 0
    assert "the bed slopes by 5°" in words(ran.out)
    assert "quasi-static" not in ran.out
    found = read_document(run(*moving, "--json").out)
    assert (found["static"], found["load_cases"], found["verdict"]) == (None, [], "not compared")
    (part,) = found["dynamic"]["load_cases"]
    assert part["quasi_static_max_tension_N"] is None
    assert "verify.xlsx" not in names(tmp_path)
    assert "slopes by 5°" in (tmp_path / "line.svg").read_text(encoding="utf-8")
    assert "đáy biển dốc 5°" in words(run(*moving, "--lang", "vi").out)


def test_the_drawing_has_the_slope_and_the_line_on_it() -> None:
    case = read_case(SLOPED)
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


@pytest.mark.parametrize(
    ("old", "new", "asked", "told"),
    [
        ('"5 deg"', '"46 deg"', parse_case, r"site\.seabed_slope"),
        ('"5 deg"', '"-46 deg"', parse_case, r"site\.seabed_slope"),
        ('"5 deg"', '"3 m"', parse_case, r"site\.seabed_slope"),
        ("", "", verify_case, r"site\.seabed_slope"),
        (f"[load]\n{FORCE}", '[find]\nquantity = "touchdown_force"', verify_dynamic,
         r"site\.seabed_slope"),
        (FORCE, 'fairlead_tension = "90 kN"', verify_dynamic,
         r"load\.fairlead_tension: found 90000 N; give horiz"),
    ],
)  # fmt: skip
def test_what_has_no_answer_on_a_slope_is_refused(
    old: str, new: str, asked: Callable[..., Any], told: str
) -> None:
    text = CASE.replace(old, new) if old else CASE
    with pytest.raises(InputError, match=told):
        asked(text if asked is parse_case else parse_case(text))
