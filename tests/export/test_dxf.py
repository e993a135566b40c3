"""The drawing: sound DXF R12 whose points are the closed form's."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from catopt import Case, Line, Load, PointLoad, Segment, Site, read_case, solve
from catopt.export.dxf import LAYERS, dxf_drawing
from catopt.export.export_result import Exported, Source, exported_lines

from .cases import FSO, chain_and_wire, tanker

PLACE = 5e-7
"""Coordinates are written to the micrometre, m."""


@dataclass
class Entity:
    kind: str
    layer: str = ""
    place: list[float] = field(default_factory=list)
    words: str = ""
    size: float = 0.0
    flag: int = 0


def groups(text: str) -> list[tuple[int, str]]:
    lines = text.splitlines()
    assert len(lines) % 2 == 0
    return [(int(code), value) for code, value in zip(lines[::2], lines[1::2], strict=True)]


def sections(text: str) -> dict[str, list[tuple[int, str]]]:
    """Split a drawing at its sections; every one that is opened is closed."""
    found: dict[str, list[tuple[int, str]]] = {}
    rest = [group for group in groups(text) if group[0] != 999]
    assert rest.pop() == (0, "EOF")
    while rest:
        assert rest[0] == (0, "SECTION")
        end = rest.index((0, "ENDSEC"))
        found[rest[1][1]] = rest[2:end]
        rest = rest[end + 1 :]
    return found


def entities(text: str) -> list[Entity]:
    found: list[Entity] = []
    for code, value in sections(text)["ENTITIES"]:
        if code == 0:
            found.append(Entity(value))
        elif code == 8:
            found[-1].layer = value
        elif code in (10, 20, 30):
            found[-1].place.append(float(value))
        elif code == 1:
            found[-1].words = value
        elif code == 40:
            found[-1].size = float(value)
        elif code == 70:
            found[-1].flag = int(value)
    return found


def polylines(text: str) -> Iterator[tuple[Entity, list[list[float]]]]:
    """Yield every polyline with its vertices."""
    head: Entity | None = None
    vertices: list[list[float]] = []
    for entity in entities(text):
        if entity.kind == "POLYLINE":
            assert head is None
            head, vertices = entity, []
        elif entity.kind == "VERTEX":
            vertices.append(entity.place)
        elif entity.kind == "SEQEND":
            assert head is not None
            yield head, vertices
            head = None
    assert head is None


def marks(exported: Exported, layer: str) -> list[list[float]]:
    return [e.place for e in entities(exported.text) if e.kind == "POINT" and e.layer == layer]


def words(exported: Exported) -> list[str]:
    return [entity.words for entity in entities(exported.text) if entity.kind == "TEXT"]


def test_the_file_is_r12_with_named_layers() -> None:
    exported = dxf_drawing(exported_lines(tanker()), sources=[Source("case.toml", 64 * "b")])
    parts = sections(exported.text)
    assert list(parts) == ["HEADER", "TABLES", "ENTITIES"]
    assert parts["HEADER"] == [(9, "$ACADVER"), (1, "AC1009")]
    table = parts["TABLES"]
    at = table.index((2, "LAYER"))
    assert table[at + 1] == (70, str(len(LAYERS)))
    assert [value for code, value in table[at + 1 :] if code == 2] == list(LAYERS)
    assert {entity.layer for entity in entities(exported.text)} <= set(LAYERS)
    comments = [value for code, value in groups(exported.text) if code == 999]
    assert f"From case.toml, SHA-256 {64 * 'b'}" in comments
    assert max(map(len, exported.text.splitlines())) <= 255  # R12's longest line


def test_the_line_is_drawn_where_the_closed_form_has_it() -> None:
    """Every vertex is a point of the profile."""
    case = tanker()
    exported = dxf_drawing(exported_lines(case))
    assert case.load is not None
    due = solve(case.line, height=20.0, horizontal_force=100e3)
    drawn = {head.layer: vertices for head, vertices in polylines(exported.text)}
    x, z = (list(each) for each in (due.profile(201).x, due.profile(201).z))
    assert [v[0] for v in drawn["LINE"]] == pytest.approx(x, abs=PLACE)
    assert [v[1] for v in drawn["LINE"]] == pytest.approx(z, abs=PLACE)
    assert {v[2] for v in drawn["LINE"]} == {0.0}
    assert {v[1] for v in drawn["BED"]} == {0.0}
    assert {v[1] for v in drawn["WATER"]} == {20.0}
    (anchor,), (fairlead,) = marks(exported, "ANCHOR"), marks(exported, "FAIRLEAD")
    assert anchor == [0.0, 0.0, 0.0]
    assert fairlead == pytest.approx([due.span, 20.0, 0.0], abs=PLACE)
    # On the bed the chain lies straight, stretched by H/EA: that is where it comes off.
    (touchdown,) = marks(exported, "TOUCHDOWN")
    lying = due.grounded_length * (1.0 + 100e3 / 2e8)
    assert touchdown == pytest.approx([lying, 0.0, 0.0], abs=PLACE)
    assert "fairlead, 141.97 kN" in words(exported)


def test_segments_are_apart_and_loads_have_layers_of_their_own() -> None:
    case = chain_and_wire()
    buoy = PointLoad(300.0, -2e3, name="phao tiêu")
    solved = exported_lines(
        replace(case, line=Line(case.line.segments, [*case.line.point_loads, buoy]))
    )
    exported = dxf_drawing(solved)
    chain, wire = (vs for head, vs in polylines(exported.text) if head.layer == "LINE")
    assert chain[-1] == wire[0]
    solution = solved.lines[0].solution
    clump, float_ = solution.point_loads
    assert marks(exported, "CLUMP_WEIGHTS") == [pytest.approx([clump.x, clump.z, 0.0], abs=PLACE)]
    assert marks(exported, "BUOYS") == [pytest.approx([float_.x, float_.z, 0.0], abs=PLACE)]
    assert marks(exported, "JOINTS") == marks(exported, "CLUMP_WEIGHTS") == [chain[-1]]
    assert {"clump, 50.00 kN in water", "chain / wire"} <= set(words(exported))
    assert "phao ti\\U+00EAu, -2.00 kN in water" in words(exported)
    assert exported.text.isascii()


def test_a_raised_anchor_has_two_touchdowns() -> None:
    line = Line([Segment(120.0, 1000.0)])
    case = Case(Site(20.0), line, Load(horizontal_force=20e3), 20.0, anchor_height=3.0)
    exported = dxf_drawing(exported_lines(case))
    first, second = marks(exported, "TOUCHDOWN")
    assert 0.0 < first[0] < second[0]
    assert first[1] == pytest.approx(0.0, abs=PLACE)
    # Each side hangs over a cosh: a acosh(1 + h/a) wide, a = H/w = 20 m.
    for height, width in ((3.0, first[0]), (20.0, marks(exported, "FAIRLEAD")[0][0] - second[0])):
        assert width == pytest.approx(20.0 * math.acosh(1.0 + height / 20.0), abs=2 * PLACE)


def test_a_system_is_drawn_in_space() -> None:
    exported = dxf_drawing(exported_lines(read_case(FSO)))
    lines = list(polylines(exported.text))
    assert (len(lines), {head.layer for head, _ in lines}) == (36, {"LINE"})
    assert {head.flag for head, _ in lines} == {8}
    assert all(e.flag == 32 for e in entities(exported.text) if e.kind == "VERTEX")
    anchors = marks(exported, "ANCHOR")
    for place, azimuth in zip(anchors, [-3, 0, 3, 117, 120, 123, 237, 240, 243], strict=True):
        angle = math.radians(azimuth)
        due = [1056.0 * math.cos(angle), 1056.0 * math.sin(angle), 0.0]
        assert place == pytest.approx(due, abs=PLACE)
    for first, last in ((lines[k][1][0], lines[k + 3][1][-1]) for k in range(0, 36, 4)):
        assert first in anchors
        assert last[2] == pytest.approx(71.4, abs=PLACE)
    assert len(marks(exported, "BODY")) == 1
    assert "body under 4281.00 kN" in words(exported)
    assert "line 9, 64.92 kN" in words(exported)


def test_what_is_not_drawn_as_it_is_is_said() -> None:
    slack = Case(Site(20.0), Line([Segment(120.0, 1000.0)]), Load(span=90.0), 20.0)
    exported = dxf_drawing(exported_lines(slack))
    assert "what lies in bights on the bed is drawn straight" in exported.remarks
    assert any("the line is slack" in remark for remark in exported.remarks)
    written = " ".join(" ".join(words(exported)).split())
    assert all(f"Remark: {remark}" in written for remark in exported.remarks)
    assert max(map(len, exported.text.splitlines())) <= 255
    assert dxf_drawing(exported_lines(tanker())).remarks == ()
    with_EA = dxf_drawing(exported_lines(replace(slack, load=Load(horizontal_force=1e5)), EA=1e9))
    assert any("EA of 1e+09 N that was given" in remark for remark in with_EA.remarks)


@pytest.mark.parametrize("case", [tanker(), chain_and_wire(), read_case(FSO)])
def test_another_reader_finds_no_fault(case: Case, tmp_path: Path) -> None:
    ezdxf = pytest.importorskip("ezdxf", reason="optional extra: peers")
    path = tmp_path / "line.dxf"
    path.write_bytes(dxf_drawing(exported_lines(case)).content)
    drawing = ezdxf.readfile(path)
    found = drawing.audit()
    assert (found.errors, found.fixes, drawing.dxfversion) == ([], [], "AC1009")
