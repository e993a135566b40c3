"""Lines that meet: what is written for each program, and what is found there.

MoorPy solves the same equations, so that it finds the same forces to its own tolerance; MoorDyn's
chains of straight elements miss the curve by w l^2 / (8 H).
"""

from __future__ import annotations

import math
from dataclasses import replace
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from catopt import InputError, Line, PointLoad, Segment, Site, read_case, solve_system
from catopt.decks.reading import read_deck
from catopt.export.drawing import dxf_drawing
from catopt.export.export_result import exported_lines
from catopt.export.moordyn import moordyn_input
from catopt.export.programs import program_input
from catopt.model.network import LineBetween, MooredBody, Network, Point

from .cases import CASES

CHAIN = Segment(220.0, 1200.0, EA=6e8, mass=140.0, name="chain")
WIRE = Segment(90.0, 250.0, EA=3e8, mass=31.0, name="wire")
BRIDLE = Segment(42.0, 400.0, EA=4e8, mass=50.0, name="bridle")


def bridle(friction: float = 0.0, weight: float = 20e3, up: float = 0.0) -> Network:
    """Split a leg of chain and wire with a clump by a plate into two lines to a held barge."""
    clump = PointLoad(220.0, 15e3, mass=2000.0, name="clump")
    points = [
        Point("anchor", "anchor", 0.0, 0.0, 0.0),
        Point("plate", "joint", submerged_weight=weight, force=(0.0, 0.0, up)),
        Point("port", "fairlead", 320.0, 15.0, 60.0),
        Point("starboard", "fairlead", 320.0, -15.0, 60.0),
    ]
    lines = [
        LineBetween(Line([CHAIN, WIRE], [clump]), "anchor", "plate", "leg"),
        LineBetween(Line([BRIDLE]), "plate", "port", "port"),
        LineBetween(Line([BRIDLE]), "starboard", "plate", "starboard"),
    ]
    site = Site(60.0, seabed_friction=friction)
    return Network(site, tuple(points), tuple(lines), title="Bridle")


def barge() -> Network:
    """Moor a barge that is free in x, y and yaw on a bridle ahead and a line to one side."""
    held = bridle()
    points = [
        *(replace(p, body="barge") if p.kind == "fairlead" else p for p in held.points),
        Point("west", "anchor", 600.0, 150.0, 0.0),
        Point("quarter", "fairlead", 380.0, 15.0, 60.0, body="barge"),
    ]
    side = Line([replace(CHAIN, length=290.0)])
    lines = [*held.lines, LineBetween(side, "quarter", "west", "side")]
    body = MooredBody("barge", 350.0, 0.0, force=(40e3, 20e3), moment=2e5)
    return replace(held, points=tuple(points), lines=tuple(lines), bodies=(body,))


MOORINGS = [
    (bridle(), "bridle"),
    (bridle(0.6), "friction"),
    (bridle(weight=-30e3), "buoy"),
    (bridle(up=-12e3), "pulled"),
    (barge(), "barge"),
    (read_case(CASES / "lake-buoy" / "case.toml"), "lake"),
    (read_case(CASES / "raft-four-lines" / "case.toml"), "raft"),
    (read_case(CASES / "ship-at-quay" / "case.toml"), "quay"),
]
every_mooring = pytest.mark.parametrize(
    "mooring", [each for each, _ in MOORINGS], ids=[name for _, name in MOORINGS]
)


def rows(text: str, section: str) -> list[list[str]]:
    """Return the rows of a section of a MoorDyn file below its two heads."""
    part = text.split(f"--- {section} ---\n")[1].split("---")[0]
    return [line.split() for line in part.splitlines()[2:]]


def test_a_point_in_which_lines_meet_stands_once() -> None:
    """By hand: 20 kN is a weight without volume of 20000/g kg where the solver has the plate."""
    solved = exported_lines(bridle())
    exported = moordyn_input(solved)
    points = {row[0]: row for row in rows(exported.text, "POINTS")}
    kinds = [row[1] for row in points.values()]
    assert kinds == ["Fixed", "Free", "Free", "Coupled", "Coupled"]
    plate = points["3"]
    place = solve_system(bridle()).place_of("plate")
    due = (place[0], place[1], place[2] - 60.0, 20e3 / 9.80665, 0.0)
    assert [float(each) for each in plate[2:7]] == pytest.approx(due, rel=1e-9, abs=1e-9)
    ends = [tuple(row[2:4]) for row in rows(exported.text, "LINES")]
    assert ends == [("1", "2"), ("2", "3"), ("3", "4"), ("5", "3")]
    assert "Points: 1 anchor, 3 plate, 4 port, 5 starboard" in exported.text
    assert [each.name for each in exported.expected] == ["leg", "port", "starboard"]


@every_mooring
@pytest.mark.parametrize("to", ["moordyn", "orcaflex"])
def test_what_is_written_reads_back(mooring: Network, to: str) -> None:
    """Ten digits of MoorDyn's file, doubles of OrcaFlex's: the pulls at what is held agree.

    The deck has the bodies held where they rest, and floats with the buoyancy that is used; its
    friction is that of the case, but without energy between joints other places may be as good.
    """
    solved = exported_lines(mooring)
    if to == "moordyn":
        text = moordyn_input(solved).text
    else:
        text = program_input("orcaflex", solved).text
        yaml.safe_load(text)
    back = read_deck(text, f"back.{to}").case
    if isinstance(back, Network):
        found = solve_system(back)
        pulls: list[tuple[float, float, float]] = []
        for end, run in zip(found.joints.ends, found.runs, strict=True):
            for number, force in ((run.first, end.first), (run.second, end.second)):
                if back.points[number].kind != "joint":
                    pulls.append((found.joints.places[number][0], force[0], force[2]))
    own = solve_system(mooring)
    due = []
    for end, run in zip(own.joints.ends, own.runs, strict=True):
        for number, force in ((run.first, end.first), (run.second, end.second)):
            if mooring.points[number].kind != "joint":
                due.append((own.joints.places[number][0], force[0], force[2]))
    size = max(math.hypot(*each[1:]) for each in due)
    for one, other in zip(sorted(pulls), sorted(due), strict=True):
        assert one[1:] == pytest.approx(other[1:], abs=1e-5 * size)


def forces_due(solved: Any) -> dict[int, Any]:
    """Sum what the lines pull with at each point that is held, on a bed without friction; N."""
    pulls: dict[int, Any] = {}
    for line in solved.lines:
        due = line.expected
        ahead = np.array([math.cos(line.heading), math.sin(line.heading)])
        first = np.array([*(due.anchor.horizontal_force * ahead), due.anchor.vertical_force])
        last = np.array([*(-due.fairlead.horizontal_force * ahead), -due.fairlead.vertical_force])
        for end, force in zip(line.ends, (first, last), strict=True):
            if solved.points[end].end != "free":
                pulls[end] = pulls.get(end, 0.0) + force
    return pulls


@every_mooring
@pytest.mark.parametrize("built", ["moordyn", "script", "map"])
def test_moorpy_finds_the_same_tensions(mooring: Network, built: str, tmp_path: Path) -> None:
    """To 1e-6 of the largest, from the ten digits of MoorDyn's file to 1e-4 where lines are taut.

    With friction joints stand elsewhere, and the head has headings with it.
    """
    pytest.importorskip("moorpy", reason="optional extra: peers")
    from .test_moorpy_finds_it import of_map, of_moordyn, of_script

    solved = exported_lines(mooring)
    system = {"moordyn": of_moordyn, "script": of_script, "map": of_map}[built](solved, tmp_path)
    for point in system.pointList:
        point.zTol = 1e-3
        point.zSpan = np.array([-2.0, -1.0]) * system.depth
    system.initialize()
    assert system.solveEquilibrium(DOFtype="free", tol=1e-8)
    due = forces_due(solved)
    near = (1e-4 if built == "moordyn" else 1e-6) * float(max(map(np.linalg.norm, due.values())))
    held = [point for point in system.pointList if point.type != 0]
    left = {number: point.getForces(xyz=True) for number, point in enumerate(held)}
    for end, force in due.items():
        x, y, height = solved.points[end].place
        place = (x, y, height - system.depth)
        there = [k for k in left if math.dist(held[k].r, place) < 1e-6]  # two chocks may be one
        found = left.pop(min(there, key=lambda k: float(np.linalg.norm(left[k] - force))))
        if mooring.site.seabed_friction:
            assert np.linalg.norm(found) == pytest.approx(np.linalg.norm(force), abs=near)
        else:
            assert found == pytest.approx(force, abs=near)
    assert not left


@pytest.mark.slow  # its light wire wants a fine time step
@pytest.mark.parametrize("mooring", [bridle(), bridle(weight=-30e3)])
def test_moordyn_comes_to_rest_there(mooring: Network, tmp_path: Path) -> None:
    """With 12 elements a line: to 1 % of the largest pull."""
    pytest.importorskip("moordyn", reason="optional extra: peers")
    from .test_moordyn_finds_it import at_rest

    solved = exported_lines(mooring)
    tops, _ = at_rest(solved, tmp_path, 12)
    due = [f for end, f in forces_due(solved).items() if solved.points[end].end == "coupled"]
    near, by_y = 0.01 * float(max(map(np.linalg.norm, due))), itemgetter(1)
    for found, force in zip(sorted(tops, key=by_y), sorted(due, key=by_y), strict=True):
        assert found == pytest.approx(force, abs=near)


def test_a_horizontal_force_is_for_moorpy_and_map_alone() -> None:
    own = bridle()
    points = [replace(p, force=(3e3, -1e3, 0.0)) if p.name == "plate" else p for p in own.points]
    pulled = exported_lines(replace(own, points=tuple(points)))
    assert "(3000.0, -1000.0, 0.0)" in program_input("moorpy", pulled).text
    assert " 3000 -1000 0" in program_input("map", pulled).text
    for write in (moordyn_input, lambda solved: program_input("orcaflex", solved)):
        with pytest.raises(InputError, match=r"points\[1\].force.*no horizontal force"):
            write(pulled)


def test_what_a_program_has_not_is_refused_by_name() -> None:
    with pytest.raises(InputError, match="points: each line of the ontology"):
        program_input("ontology", exported_lines(bridle()))
    flows = read_case(CASES / "hanging-instrument" / "case.toml")
    with pytest.raises(InputError, match="current: lines are exported in still water"):
        exported_lines(flows)
    light = replace(BRIDLE, submerged_weight=-1.0, mass=None)
    own = bridle()
    lines = [own.lines[0], replace(own.lines[1], line=Line([BRIDLE, light])), own.lines[2]]
    with pytest.raises(InputError, match=r"lines\[1\].segments\[1\].mass"):
        moordyn_input(exported_lines(replace(own, lines=tuple(lines))))


def test_what_stands_in_for_floats_is_said() -> None:
    said = " ".join(moordyn_input(exported_lines(MOORINGS[5][0])).remarks)
    assert "at the surface: marker west, marker east" in said
    assert "the vertical force on plate" in " ".join(exported_lines(bridle(up=5e3)).warnings)
    assert "the barge is not in the file" in " ".join(
        moordyn_input(exported_lines(barge())).remarks
    )


def test_lines_that_meet_are_drawn_in_space() -> None:
    text = dxf_drawing(exported_lines(barge())).text
    assert text.count("barge under 44.72 kN") == 1
    assert "leg," in text
