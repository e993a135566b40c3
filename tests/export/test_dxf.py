"""The drawing: sound DXF R12 whose points are the closed form's."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import pytest

from catopt import Case, Line, Load, PointLoad, Segment, Site, read_case, solve
from catopt.casefile import read_mooring
from catopt.errors import InputError
from catopt.export.drawing import LAYERS, dxf_drawing
from catopt.export.export_result import Exported, Source, exported_lines
from catopt.loads.buoy import buoy
from catopt.model import (
    Anchor,
    CurrentProfile,
    Dynamics,
    Floater,
    LoadCase,
    System,
    TitleBlock,
    WaveState,
)
from catopt.model.network import Network
from catopt.model.system import ShipAfloat
from catopt.model.title_block import Revision

from .cases import CASES, FSO, chain_and_wire, tanker

RAFT = CASES / "raft-four-lines" / "case.toml"

SEA = WaveState(spectrum="jonswap", height=1.0, period=6.0)
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
    lines = [each for each in polylines(exported.text) if each[0].layer == "LINE"]
    assert len(lines) == 36
    assert {head.flag for head, _ in lines} == {8}
    vertices = [e for e in entities(exported.text) if e.kind == "VERTEX" and e.layer == "LINE"]
    assert {e.flag for e in vertices} == {32}
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


def moored_buoy(**own: Any) -> Case:
    """Moor by a chain of 45 mm in 12 m of water on a sinker of 12 t of 2400 kg/m3."""
    sinker = Anchor("sinker", 12e3 * 9.80665 * (1.0 - 1025.0 / 2400.0), 0.3, mass=12e3)
    states = [
        LoadCase("high", 13e3, water_level=1.4),
        LoadCase("low", 13e3, water_level=-2.0),
    ]
    chain = Segment(33.5, 335.0, name="open-link", nominal_diameter=0.045)
    own = {"anchor": sinker, "load": None, "load_cases": states, "title": "Fairway buoy"} | own
    return Case(Site(12.0), Line([chain]), fairlead_height=9.9, **own)


def drawn(case: Case) -> Exported:
    return dxf_drawing(exported_lines(case), whole=case)


def in_plane(exported: Exported, layer: str) -> list[list[list[float]]]:
    return [vertices for head, vertices in polylines(exported.text) if head.layer == layer]


def test_still_water_is_apart_from_that_of_the_load_case() -> None:
    exported = drawn(moored_buoy())
    assert {v[1] for line in in_plane(exported, "WATER") for v in line} == {12.0, 13.4}
    assert "still water, 12 m deep" in words(exported)
    assert "water of this load case, 13.4 m deep (+1.4 m)" in words(exported)
    at_rest = drawn(moored_buoy(load=Load(horizontal_force=13e3), load_cases=()))
    assert {v[1] for line in in_plane(at_rest, "WATER") for v in line} == {12.0}


def test_what_holds_the_line_has_a_sign_of_its_own() -> None:
    """A cube of 5 m3 as a block, three corners of a drag anchor, a circle of what is not known."""
    (block,) = in_plane(drawn(moored_buoy()), "ANCHOR")
    side = 5.0 ** (1.0 / 3.0)
    assert block == [
        pytest.approx(each, abs=PLACE)
        for each in ([-side, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, side, 0.0], [-side, side, 0.0])
    ]
    drag = drawn(moored_buoy(anchor=Anchor("drag", holding_capacity=1e5)))
    assert [len(each) for each in in_plane(drag, "ANCHOR")] == [3]
    unknown = drawn(moored_buoy(anchor=None))
    assert in_plane(unknown, "ANCHOR") == []
    circles = [e for e in entities(unknown.text) if e.kind == "CIRCLE" and e.layer == "ANCHOR"]
    assert len(circles) == 1
    for exported, said in ((drag, "drag anchor, "), (unknown, "anchor, ")):
        assert any(each.startswith(said) for each in words(exported))
    assert any(each.startswith("sinker of 12 t, ") for each in words(drawn(moored_buoy())))


def test_a_chain_has_its_size_beside_it() -> None:
    assert "open-link 45 mm, 33.5 m" in words(drawn(moored_buoy()))
    names = [each for each in words(drawn(chain_and_wire())) if each.endswith(", 200 m")]
    assert len(names) == 2


def test_the_swing_circle_is_that_of_the_widest_state() -> None:
    case = moored_buoy()
    spans = [
        solve(case.line, height=9.9 + rise, horizontal_force=13e3).span for rise in (1.4, -2.0)
    ]
    exported = drawn(case)
    radii = [e.size for e in entities(exported.text) if e.kind == "CIRCLE" and e.layer == "SWING"]
    assert max(radii) == pytest.approx(max(spans), abs=PLACE)
    assert any(f"radius {max(spans):.2f} m, low" in each for each in words(exported))


def test_the_buoy_stands_on_its_line() -> None:
    """Pillar buoy of 1.8 m: as wide as its name says, its eye at the fairlead."""
    floater = Floater(buoy="pillar 1.8 m")
    case = moored_buoy(floater=floater, dynamics=Dynamics(duration=60.0), waves=SEA)
    exported = drawn(case)
    corners = [v for part in in_plane(exported, "BODY") for v in part]
    x = marks(exported, "FAIRLEAD")[0][0]
    assert max(v[0] for v in corners) - x == pytest.approx(0.9, abs=PLACE)
    assert x - min(v[0] for v in corners) == pytest.approx(0.9, abs=PLACE)
    shape = buoy("pillar 1.8 m")
    assert min(v[1] for v in corners) == pytest.approx(9.9 + 1.4 - shape.eye + shape.lowest)


def test_the_title_block_is_that_of_the_firm() -> None:
    last = Revision("B", date="2026-11-29", changed="Issued", checked="T. T. Bình")
    block = TitleBlock(client="Port", number="MO-1", revisions=(Revision("A"), last))
    said = words(drawn(moored_buoy(document=block)))
    for name, value in (
        ("Client", "Port"), ("Number", "MO-1"), ("Title", "Fairway buoy"), ("Revision", "B"),
        ("Date", "2026-11-29"), ("Changed", "Issued"), ("Checked", "T. T. B\\U+00ECnh"),
    ):  # fmt: skip
        assert said[said.index(name) + 1] == value
    assert "Project" not in said
    assert said[said.index("Approved") + 1] == ""  # to be signed
    assert said[said.index("Program") + 1].startswith("catopt ")


def test_a_body_has_its_coordinates_and_its_watch_circle() -> None:
    case = read_case(FSO)
    exported = dxf_drawing(exported_lines(case))
    said = words(exported)
    at = said.index("anchor of line 4")
    azimuth = math.radians(117.0)
    due = [1056.0 * math.cos(azimuth), 1056.0 * math.sin(azimuth), 0.0]
    assert said[at + 1 : at + 4] == [f"{each:.3f}" for each in due]
    assert said[at + 4 : at + 6] == ["117.00", "1056.000"]
    # Its load goes round: where it points along the case's own force, the body is where it rests.
    (track,) = in_plane(exported, "SWING")
    ((x, y, _),) = marks(exported, "BODY")
    assert min(math.dist(v[:2], (x, y)) for v in track) < 1e-3
    assert len(track) == 72


def test_lines_between_points_are_drawn_with_joints_and_coordinates() -> None:
    raft = read_mooring(RAFT)
    assert isinstance(raft, Network)
    exported = dxf_drawing(exported_lines(raft))
    assert len(in_plane(exported, "LINE")) == sum(len(e.line.segments) for e in raft.lines)
    given = [[*e.place] for e in raft.points if e.kind == "anchor"]
    assert marks(exported, "ANCHOR") == given
    said = words(exported)
    for point in raft.points:
        at = said.index(f"{point.kind} {point.name}")
        if point.kind == "anchor":
            assert said[at + 1 : at + 4] == [f"{each:.3f}" for each in point.place]
    assert len(in_plane(exported, "SWING")) == 1
    assert exported.expected[0].name == "line 1"
    dragged = [
        replace(
            e, line=Line([replace(s, drag_normal=1.2, drag_diameter=0.05) for s in e.line.segments])
        )
        for e in raft.lines
    ]
    flows = replace(raft, lines=tuple(dragged), current=CurrentProfile("power", speed=1.0))
    with pytest.raises(InputError, match="current"):
        exported_lines(flows)


def test_a_ship_is_drawn_along_her_axis_where_lines_hold_her_so() -> None:
    """A hull of 200 m by 32 m from above, its origin 10 m forward of midships, without load."""
    ship = ShipAfloat(200.0, 32.0, 12.0, 18.0, mooring_point=10.0)
    line = Line([Segment(300.0, 1470.0)])
    quarters = [math.radians(each) for each in (45.0, 135.0, 225.0, 315.0)]

    def hull(radius: float) -> list[list[list[float]]]:
        system = System.around(
            line, azimuths=quarters, anchor_radius=270.0 + radius, fairlead_height=18.0,
            fairlead_radius=radius,
        )  # fmt: skip
        case = Case(
            Site(20.0), line, None, system=system, floater=Floater(ship=ship), fairlead_height=18.0,
            dynamics=Dynamics(duration=600.0), waves=SEA,
        )  # fmt: skip
        return [each for each in in_plane(drawn(case), "BODY") if len(each) > 2]

    (outline,) = hull(80.0)
    x, y, _ = zip(*outline, strict=True)
    assert (min(x), max(x)) == pytest.approx((-110.0, 90.0), abs=1e-3)
    assert (min(y), max(y)) == pytest.approx((-16.0, 16.0), abs=1e-3)
    assert hull(0.0) == []  # she turns freely: where she points is not known


@pytest.mark.parametrize("case", [tanker(), chain_and_wire(), moored_buoy(), read_case(FSO)])
def test_another_reader_finds_no_fault(case: Case, tmp_path: Path) -> None:
    ezdxf = pytest.importorskip("ezdxf", reason="optional extra: peers")
    path = tmp_path / "line.dxf"
    path.write_bytes(dxf_drawing(exported_lines(case)).content)
    drawing = ezdxf.readfile(path)
    found = drawing.audit()
    assert (found.errors, found.fixes, drawing.dxfversion) == ([], [], "AC1009")
