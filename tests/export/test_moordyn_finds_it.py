"""MoorDyn on the exported file: it comes to rest where the closed form says.

MoorDyn's line is a chain of straight elements. Over an element of length l the curve, whose
curvature is at most w/H, leaves it by up to w l^2 / (8 H): as if the fairlead were that much higher
or lower. What that does to the tension is the tolerance of every comparison here; it is of second
order in l. To it comes the millimetre that the bed gives way, and the buoyancy of a diameter's
length of line, half of which MoorDyn sees out of the water where the fairlead is at the surface.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt import Case, read_case
from catopt.catenary.solve import solve
from catopt.constants import STANDARD_GRAVITY
from catopt.export.body_in_water import of_segment
from catopt.export.export_result import exported_lines
from catopt.export.exported_line import ExportedLine, ExportedLines
from catopt.export.moordyn import SINKING, moordyn_input

from .cases import FSO, chain_and_wire, suspended, tanker, tanker_with_sinker

moordyn = pytest.importorskip("moordyn", reason="optional extra: peers")

FIXED, COUPLED = 1, -1


def at_rest(solved: ExportedLines, folder: Path, elements: int) -> tuple[Any, Any]:
    """Let it settle; forces on the fairleads and at the anchors, N, shape (lines, 3)."""
    path = folder / "lines.txt"
    path.write_bytes(moordyn_input(solved, elements=elements).content)
    system = moordyn.Create(str(path))
    assert system
    try:
        count = moordyn.GetNumberPoints(system)
        points = [moordyn.GetPoint(system, number) for number in range(1, count + 1)]
        held = [point for point in points if moordyn.GetPointType(point) == COUPLED]
        places = [float(x) for point in held for x in moordyn.GetPointPos(point)]
        still = [0.0] * len(places)
        moordyn.Init(system, places, still)
        forces = moordyn.Step(system, places, still, 0.0, 0.01)
        anchors = [_pull(point) for point in points if moordyn.GetPointType(point) == FIXED]
    finally:
        moordyn.Close(system)
    return np.reshape(forces, (-1, 3)), np.array(anchors)


def _pull(anchor: Any) -> Any:
    """Tension of the element at an anchor; MoorDyn keeps no force on a point that is fixed."""
    line, _ = moordyn.GetPointAttached(anchor, 0)
    return moordyn.GetLineNodeTen(line, 0)


def allowed(line: ExportedLine, elements: int) -> float:
    """Move the fairlead by what the elements miss of the curve; what that changes, N."""
    due = line.expected
    weight = max(abs(segment.submerged_weight) for segment in due.line.segments)
    length = due.line.length / elements
    missed = weight * length**2 / (8.0 * due.anchor.horizontal_force) + SINKING
    top = of_segment(due.line.segments[-1], 1025.0, "")
    buoyancy = 1025.0 * top.volume * STANDARD_GRAVITY * top.diameter
    moved = [
        solve(due.line, height=due.fairlead_height + by, span=due.span).fairlead.tension
        for by in (missed, -missed)
    ]
    return max(abs(each - due.fairlead.tension) for each in moved) + buoyancy


def check(line: ExportedLine, top: Any, bottom: Any, elements: int) -> None:
    """Compare the forces at both ends with the closed form."""
    due, near = line.expected, allowed(line, elements)
    assert np.linalg.norm(top) == pytest.approx(due.fairlead.tension, abs=near)
    assert np.hypot(*top[:2]) == pytest.approx(due.horizontal_force, abs=near)
    assert -top[2] == pytest.approx(due.fairlead.vertical_force, abs=near)
    assert np.hypot(*bottom[:2]) == pytest.approx(due.anchor.horizontal_force, abs=near)


@pytest.mark.parametrize("elements", [12, 24])
@pytest.mark.parametrize(
    ("case", "EA"),
    [
        (suspended(), None),
        (tanker(), None),
        (chain_and_wire(), None),
        (chain_and_wire(friction=0.5), None),
    ],
    ids=["suspended", "grounded", "clump", "friction"],
)
def test_it_comes_to_rest_at_the_closed_form(
    case: Case, EA: float | None, elements: int, tmp_path: Path
) -> None:
    solved = exported_lines(case, EA)
    (top,), (bottom,) = at_rest(solved, tmp_path, elements)
    check(solved.lines[0], top, bottom, elements)
    assert allowed(solved.lines[0], elements) < 0.05 * solved.lines[0].expected.fairlead.tension


def test_the_gap_closes_with_the_square_of_the_element(tmp_path: Path) -> None:
    """Where nothing lies on the bed: halved elements leave a quarter of the gap.

    On a bed the touchdown jumps from node to node, and the gap is no smooth function of the length.
    """
    solved = exported_lines(suspended())
    due = solved.lines[0].solution.fairlead.tension
    gaps = []
    for elements in (5, 10, 20):
        (top,), _ = at_rest(solved, tmp_path, elements)
        gaps.append(due - float(np.linalg.norm(top)))
    assert gaps[0] < 0.02 * due
    # The next order is l^2 smaller, (1/5)^2 of the first; and half a diameter is out of the water.
    assert gaps[0] / gaps[1] == pytest.approx(4.0, rel=0.1)
    assert gaps[1] / gaps[2] == pytest.approx(4.0, rel=0.1)


@pytest.mark.slow  # 45 points and 360 elements take a quarter of a minute
def test_the_turret_with_its_nine_lines(tmp_path: Path) -> None:
    solved = exported_lines(read_case(FSO))
    tops, bottoms = at_rest(solved, tmp_path, 40)
    for line, top, bottom in zip(solved.lines, tops, bottoms, strict=True):
        check(line, top, bottom, 40)


@pytest.mark.slow
def test_the_tanker_with_its_sinker(tmp_path: Path) -> None:
    """The sinker hangs 11 cm above the bed between elements of 2 m."""
    solved = exported_lines(tanker_with_sinker(), EA=2e8)
    (top,), (bottom,) = at_rest(solved, tmp_path, 24)
    check(solved.lines[0], top, bottom, 24)
