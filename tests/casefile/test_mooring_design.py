"""A design of a whole mooring in a case file: read, written, refused, and out of its front."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from catopt.casefile import parse_case, read_case, write_case
from catopt.casefile.reading import DESIGN_CASE, DESIGN_DOCUMENT, read_design
from catopt.checks.case import check_case
from catopt.design.search import design_case
from catopt.errors import InputError
from catopt.model import Case
from catopt.render.files import document_bytes

SHIPPED = Path("cases/design-mooring-30m/case.toml")


def shipped() -> str:
    return SHIPPED.read_text(encoding="utf-8")


def problems(text: str) -> dict[str, str]:
    with pytest.raises(InputError) as caught:
        parse_case(text)
    return {problem.key: problem.allowed for problem in caught.value.problems}


def check_told(text: str, old: str, new: str, key: str, told: str) -> None:
    assert old in text
    found = problems(text.replace(old, new, 1))
    assert key in found
    assert told in found[key]


def test_the_shipped_case_is_read_as_it_is_written() -> None:
    case = read_case(SHIPPED)
    assert case.design is not None
    assert case.design.lines == (4, 6, 8)
    assert case.design.anchor_radii == (170.0, 180.0, 190.0, 200.0, 210.0, 220.0)
    assert (case.design.headings, case.design.line_out) == (12, True)
    assert parse_case(write_case(case)) == case


def test_a_single_radius_and_one_heading_are_read_as_they_are_written() -> None:
    text = shipped()
    for key in ("min", "max", "step"):
        text = "\n".join(
            row for row in text.splitlines() if not row.startswith(f"anchor_radius_{key}")
        )
    text = text.replace("headings = 12", 'anchor_radius = "200 m"')
    case = parse_case(text)
    assert case.design is not None
    assert case.design.anchor_radii == (200.0,)
    assert case.design.headings == 1
    assert "headings" not in write_case(case)
    assert parse_case(write_case(case)) == case


@pytest.mark.parametrize(
    ("old", "new", "key", "told"),
    [
        ("lines = [4, 6, 8]", "lines = [4, 0]", "design.lines[1]", "1"),
        ("lines = [4, 6, 8]", "lines = [8, 4]", "design.lines", "rising"),
        ("headings = 12", "headings = 361", "design.headings", "360"),
        ("headings = 12", 'anchor_radius = "3 m"', "design", "only one way"),
        ('force = ["400 kN", "0 kN"]', "", "system.force", "along x and y"),
        ('force = ["400 kN", "0 kN"]', "force = [0, 0]", "system.force", "other than 0"),
        ("[design]", '[design]\nobjectives = ["mass", "excursion"]', "design.objectives", "offset"),
        (
            "[[design.segments]]",
            '[design.sinker]\nmass = "2 t"\ndensity = 2400\nfriction = 0.5\n[[design.segments]]',
            "design.sinker",
            "leave it out",
        ),
    ],
)
def test_what_is_wrong_is_told_with_its_key(old: str, new: str, key: str, told: str) -> None:
    check_told(shipped(), old, new, key, told)


def test_keys_of_a_body_want_one() -> None:
    text = shipped()
    start, end = text.index("[system]"), text.index("[checks]")
    line = '[load]\nhorizontal_force = "400 kN"\n\n'
    text = text[:start] + line + text[end:].replace("safety_factor_line_out = 1.43", "")
    found = problems(text)
    wanted = {"lines", "anchor_radius_min", "headings", "line_out"}
    assert set(found) == {f"design.{key}" for key in wanted}
    assert all("[system]" in allowed for allowed in found.values())


def pretensioned() -> str:
    rows = [row for row in shipped().splitlines() if not row.startswith("anchor_radius_")]
    range_of = 'pretension_min = "30 kN"\npretension_max = "90 kN"\npretension_step = "20 kN"'
    return "\n".join(rows).replace("headings = 12", f"headings = 12\n{range_of}")


def test_pretensions_are_read_as_they_are_written() -> None:
    case = parse_case(pretensioned())
    assert case.design is not None
    assert case.design.pretensions == (30e3, 50e3, 70e3, 90e3)
    assert case.design.anchor_radii == ()
    assert parse_case(write_case(case)) == case


def test_a_radius_beside_a_pretension_is_refused() -> None:
    found = problems(pretensioned().replace("headings = 12", 'anchor_radii = ["200 m"]', 1))
    assert "the radius or the pretension" in found["design.pretension_min"]


LOADS = """
[[design.loads]]
name = "storm"
force = "400 kN"
headings = 12
water_level = "1.5 m"
line_out = true

[[design.loads]]
name = "ballast"
force = "350 kN"
direction = "30 deg"
fairlead_rise = "2 m"
"""


def loaded() -> str:
    rows = shipped().splitlines()
    own = ("headings =", "line_out =", "force =")
    return "\n".join(row for row in rows if not row.startswith(own)) + LOADS


def test_loads_of_a_design_are_read_as_they_are_written() -> None:
    case = parse_case(loaded())
    assert case.design is not None
    storm, ballast = case.design.loads
    assert (storm.force, storm.headings, storm.water_level) == (400e3, 12, 1.5)
    assert storm.line_out
    assert ballast.direction == pytest.approx(0.5235987755982988, rel=1e-15)
    assert (ballast.fairlead_rise, ballast.headings, ballast.line_out) == (2.0, 1, False)
    assert parse_case(write_case(case)) == case


@pytest.mark.parametrize(
    ("old", "new", "key", "told"),
    [
        ("[design]", "[design]\nheadings = 4", "design.headings", "[[design.loads]]"),
        ("[design]", "[design]\nline_out = true", "design.line_out", "[[design.loads]]"),
        ('name = "ballast"', 'name = "storm"', "design.loads[1].name", "this name"),
        ('"1.5 m"', '"-30 m"', "design.loads[0].water_level", "above the seabed"),
        ('force = "350 kN"', "", "design.loads[1].force", "missing"),
        ('force = "350 kN"', "force = 0", "design.loads[1].force", "above 0"),
        ('direction = "30 deg"', 'directon = "30 deg"', "design.loads[1].directon", "direction"),
    ],
)
def test_what_is_wrong_in_a_load_is_told_with_its_key(
    old: str, new: str, key: str, told: str
) -> None:
    check_told(loaded(), old, new, key, told)


def test_loads_of_a_design_want_a_body() -> None:
    text = loaded()
    start, end = text.index("[system]"), text.index("[checks]")
    text = text[:start] + '[load]\nhorizontal_force = "400 kN"\n\n' + text[end:]
    assert "[system]" in problems(text)["design.loads"]


@pytest.mark.slow
def test_a_design_under_several_loads_is_read_at_its_water_level(tmp_path: Path) -> None:
    case = small()
    assert case.design is not None
    loads = parse_case(loaded()).design
    assert loads is not None
    design = replace(case.design, loads=loads.loads, headings=1, line_out=False)
    result = design_case(replace(case, design=design))
    (tmp_path / DESIGN_CASE).write_text(write_case(result.case), encoding="utf-8")
    (tmp_path / DESIGN_DOCUMENT).write_bytes(document_bytes(result.to_dict()))
    point = result.front[0]
    assert point.mooring is not None
    found = read_design(tmp_path, 1)
    assert found.system == point.mooring.farthest.system
    lift = point.mooring.load.water_level + point.mooring.load.fairlead_rise
    assert lift in (1.5, 2.0)
    # What the farthest load does not ask for is not judged, in words.
    assert found.system is not None
    assert found.system.judged_line_out == point.mooring.load.line_out
    unasked = replace(found, system=replace(found.system, judged_line_out=False))
    told = check_case(unasked)
    assert {place.state for place in told.places} == {"intact"}
    assert any("no damaged (one line out) state was requested" in each for each in told.warnings)
    assert found.fairlead_height == case.fairlead_height + lift
    assert found.site.water_depth == case.site.water_depth + point.mooring.load.water_level
    assert check_case(found).passes


def small() -> Case:
    """Narrow the shipped case to 18 designs."""
    case: Case = read_case(SHIPPED)
    assert case.design is not None
    segment = replace(
        case.design.segments[0],
        lengths=(200.0, 210.0, 220.0),
        components=("chain studless R4",),
        diameters=(0.058, 0.078, 0.1),
        diameter_min=None,
        diameter_max=None,
    )
    design = replace(
        case.design, segments=(segment,), lines=(6, 8), anchor_radii=(200.0,), headings=4
    )
    return replace(case, design=design)


@pytest.mark.slow
def test_a_design_of_the_front_is_a_case_that_passes(tmp_path: Path) -> None:
    result = design_case(small())
    (tmp_path / DESIGN_CASE).write_text(write_case(result.case), encoding="utf-8")
    (tmp_path / DESIGN_DOCUMENT).write_bytes(document_bytes(result.to_dict()))
    for number, point in enumerate(result.front, start=1):
        case = read_design(tmp_path, number)
        assert point.mooring is not None
        assert case.system is not None
        assert case.design is None
        # The layout of the design, under the force that takes it farthest.
        assert case.system == point.mooring.farthest.system
        assert len(case.system.legs) in (6, 8)
        assert case.system.legs[0].anchor_radius == 200.0
        assert check_case(case).passes
