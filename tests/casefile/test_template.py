"""The commented cases to start from."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import catopt.casefile
from catopt.casefile import TEMPLATES, parse_case, read_case, template
from catopt.casefile.reading import parse_network
from catopt.casefile.schema import entries
from catopt.errors import InputError
from catopt.model import Find
from tests.casefile.test_schema import tables

MOVING = ("waves", "current", "motion", "anchor_motion", "body", "floater", "dynamics", "fatigue")
CASES = Path(__file__).parents[2] / "cases"


def test_the_buoy_is_the_case_of_the_project() -> None:
    assert parse_case(template("buoy")) == read_case(CASES / "buoy-9.5m" / "case.toml")


NOT_OF_A_BUOY = (
    *("safety_factor_line_out", "max_offset", "motion_code", "max_slide"),
    *("strain", "strain_tension", "sag"),
)
"""Of several lines, the older name of max_span, of lines in motion, ropes and cables."""


def test_every_key_is_in_that_of_the_buoy() -> None:
    """But for designs, systems, lines in motion, names of quantities, and an older name."""
    lines = template("buoy").splitlines()
    for header, table in tables().items():
        elsewhere = ("design", "system", "catalogue.variants", *MOVING)
        if header.strip("[]").startswith(elsewhere):
            continue
        for key, entry in entries(table).items():
            if entry.kind is not None and header and key not in NOT_OF_A_BUOY:
                given = [line for line in lines if re.match(rf"(# )?{key} = ", line)]
                assert given, key


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_template_fits_a_screen_and_says_what_it_is(name: str) -> None:
    lines = template(name).splitlines()
    assert all(len(line) <= 100 for line in lines)
    assert lines[0].startswith(("# A case for catopt:", "# A file for catopt:"))


def test_what_is_commented_out_is_right_too() -> None:
    """With its comment marks off every optional key is read; some are given another way."""
    text = re.sub(r"^# (?=\[|\w+ = )", "", template("buoy"), flags=re.MULTILINE)
    others = ("span", "fairlead_tension", "density", "volume", "point_load", "grounded_length")
    worn = ("wear_zone", "wear_table")
    rough = ("drag_method", "roughness", "keulegan_carpenter", "wake_amplification")
    for other in (*others, *rough, *worn, "code", "holding_capacity", "file"):
        assert re.search(rf"^{other} = ", text, re.MULTILINE)
        text = re.sub(rf"^{other} = .*\n", "", text, flags=re.MULTILINE)
    case = parse_case(text)
    assert case.line.segments[0].MBL is not None
    assert case.line.point_loads[0].mass is not None
    assert case.find == Find("length", segment=1, anchor_angle=0.0)
    assert case.checks.max_anchor_uplift_angle == 0.0
    assert [state.name for state in case.load_cases] == ["storm, high water"]
    assert case.line.segments[0].component == "chain studless R3"
    assert case.anchor is not None
    assert case.service is not None


def test_each_template_is_a_file_and_the_other_way_round() -> None:
    folder = Path(catopt.casefile.__file__).parent / "templates"
    assert sorted(path.stem for path in folder.iterdir()) == sorted(TEMPLATES)


def test_an_unknown_template_is_refused() -> None:
    with pytest.raises(InputError, match='template: found "bouy"; one of buoy, tanker,'):
        template("bouy")


BEHIND = re.compile(r"(?:# )?(?:\[.*?\]+|[\w.]+ = .*?) {1,}# (.*)")
ALONE = re.compile(r" *# (?!\[|[\w.]+ = )(.*)")


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_template_says_every_comment_in_the_other_language(name: str) -> None:
    """Keys and values are the same; no comment of it is left in English, and it fits a screen."""
    english, other = template(name).splitlines(), template(name, "vi").splitlines()
    assert len(english) == len(other)
    for one, two in zip(english, other, strict=True):
        found = BEHIND.fullmatch(one) or ALONE.fullmatch(one)
        if found:
            assert two.startswith(one[: found.start(1)])
            said = two[found.start(1) :]
            assert said != found[1]
        elif not one.startswith("title"):
            assert one == two
        assert len(two) <= 100


@pytest.mark.parametrize("name", sorted({*TEMPLATES} - {"study", "size-buoy", "size-tanker"}))
def test_it_is_the_same_case_in_the_other_language(name: str) -> None:
    one, two = parse(template(name)), parse(template(name, "vi"))
    assert one.title != two.title
    assert replace(two, title=one.title) == one


def parse(text: str) -> Any:
    return parse_network(text) if "[[points]]" in text else parse_case(text)
