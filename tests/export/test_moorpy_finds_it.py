"""MoorPy 1.3 on the exported files: the same equations, so the same forces to its own tolerance."""

from __future__ import annotations

import runpy
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from catopt import Case, read_case
from catopt.export.export_result import exported_lines
from catopt.export.exported_line import ExportedLines
from catopt.export.moordyn import moordyn_input
from catopt.export.moordyn_model import is_above
from catopt.export.programs import program_input

from .cases import FSO, chain_and_wire, suspended, tanker, tanker_with_sinker

moorpy = pytest.importorskip("moorpy", reason="optional extra: peers")

NEAR = 1e-3
"""Height over the bed within which MoorPy is to take weight off a point, m; its own is 2 m."""


def of_moordyn(solved: ExportedLines, folder: Path) -> Any:
    path = folder / "lines.txt"
    path.write_bytes(moordyn_input(solved).content)
    return moorpy.System(file=str(path))


def of_script(solved: ExportedLines, folder: Path) -> Any:
    """Run the script as it is."""
    path = folder / "lines.py"
    path.write_bytes(program_input("moorpy", solved).content)
    return runpy.run_path(str(path))["system"]


def of_map(solved: ExportedLines, folder: Path) -> Any:
    """Build what stands in the four sections; MoorPy reads no MAP++ file by itself."""
    del folder
    text = program_input("map", solved).text
    sections = [part.splitlines()[3:] for part in ("\n" + text).split("\n----")[1:4]]
    types, nodes, lines = ([row.split() for row in rows] for rows in sections)
    depth: float = solved.case.site.water_depth
    sunk = lowered(solved)
    system = moorpy.System(depth=depth + sunk, rho=solved.case.site.water_density, g=9.80665)
    for name, *numbers in types:
        d_vol, m, EA, _ = map(float, numbers[:4])
        system.lineTypes[name] = {"name": name, "d_vol": d_vol, "m": m, "EA": EA, "w": 0.0}
    for _, kind, x, y, z, mass, volume, *_ in nodes:
        own = -depth if z == "depth" else float(z.removeprefix("#"))
        place = [float(x.removeprefix("#")), float(y.removeprefix("#")), own - sunk]
        number = {"fix": 1, "vessel": -1, "connect": 0}[kind]
        system.addPoint(number, np.array(place), m=float(mass), v=float(volume))
    for _, name, unstretched, a, b, *_ in lines:
        system.addLine(float(unstretched), name, pointA=int(a), pointB=int(b))
    return system


def lowered(solved: ExportedLines) -> float:
    """Return by how much the lines are put deeper: above the water MoorPy lets them weigh more."""
    depth: float = solved.case.site.water_depth
    return solved.highest - depth if is_above(solved) else 0.0


def strung(system: Any, ends: Any, parts: Any) -> None:
    """Add a line from its first end: parts are a type with a length, or a mass with a volume."""
    total = sum(part[1] for part in parts if isinstance(part[0], str))
    # MoorPy begins where the points are put: along the bed, then straight up, for from the chord
    # of a line that lies it may not come down. hypot(u, h) = u + d, d to spare of the length.
    over = ends[1] - ends[0]
    span, rise = float(np.hypot(*over[:2])), float(over[2])
    spare = total - span
    up = (rise**2 - spare**2) / (2.0 * spare) if 0.0 < spare < rise else 0.0
    foot = ends[0] + max(span - up, 0.0) / span * np.array([*over[:2], 0.0])
    lying = float(np.linalg.norm(foot - ends[0]))
    hung = max(float(np.linalg.norm(ends[1] - foot)), total - lying)
    arc, held = 0.0, [system.addPoint(1, ends[0])]
    for kind, number in parts:
        if isinstance(kind, str):
            arc += number
            at = ends[0] + (foot - ends[0]) * min(arc / lying, 1.0) if lying else ends[0]
            at = at + (ends[1] - foot) * max(arc - lying, 0.0) / hung
            held.append(system.addPoint(0, at))
            numbers = [len(system.pointList) - 1, len(system.pointList)]
            system.addLine(number, kind, pointA=numbers[0], pointB=numbers[1])
        else:
            held[-1].m, held[-1].v = kind, number
    held[-1].type = -1
    held[-1].r = ends[1]


def of_ontology(solved: ExportedLines, folder: Path) -> Any:
    """Build what a YAML reader finds: headings clockwise from y, sections from the anchor."""
    del folder
    read = yaml.safe_load(program_input("ontology", solved).text)
    general, sunk = read["site"]["general"], lowered(solved)
    depth = general["water_depth"] + sunk
    system = moorpy.System(depth=depth, rho=general["rho_water"], g=general["g"])
    for name, kind in read["mooring_line_types"].items():
        system.lineTypes[name] = kind | {"name": name, "w": 0.0}
    hung = read.get("mooring_connector_types", {})
    for config, heading, _, fairlead in read["mooring_systems"]["ms1"]["data"]:
        place = np.array(read["platform"]["fairleads"][fairlead - 1]["r_rel"]) - [0, 0, sunk]
        line = read["mooring_line_configs"][config]
        ahead = np.array([np.sin(np.radians(heading)), np.cos(np.radians(heading))])
        foot = np.array([*(place[:2] + line["span"] * ahead), -depth])
        parts = [
            (part["type"], part["length"])
            if "type" in part
            else (hung[part["connectorType"]]["m"], hung[part["connectorType"]]["v"])
            for part in line["sections"]
        ]
        strung(system, (foot, place), parts)
    return system


def of_orcaflex(solved: ExportedLines, folder: Path) -> Any:
    """Build what a YAML reader finds: tonnes and kN, sections from the fairlead, clumps on them."""
    del folder
    read = yaml.safe_load(program_input("orcaflex", solved).text)
    sea = read["Environment"]
    lying = 0.5 * read["LineTypes"][0]["OuterContactDiameter"]
    depth = sea["WaterDepth"] - lying
    system = moorpy.System(depth=depth, rho=sea["Density"] * 1e3, g=9.80665)
    for kind in read["LineTypes"]:
        own = {"d_vol": kind["OD"], "m": kind["MassPerUnitLength"] * 1e3, "EA": kind["EA"] * 1e3}
        system.lineTypes[kind["Name"]] = own | {"name": kind["Name"], "w": 0.0}
    clumps = {clump["Name"]: clump for clump in read.get("ClumpTypes", ())}
    for line in read["Lines"]:
        top, foot = next(rows for key, rows in line.items() if key.startswith("Connection,"))
        assert (top[0], foot[0]) == ("body", "Anchored")
        ends = np.array([*foot[1:3], foot[3] - sea["WaterDepth"]]), np.array(top[1:4])
        sections = [tuple(row[:2]) for row in line["LineType, Length, TargetSegmentLength"]]
        at = {round(row[3], 6): row[0] for key, rows in line.items()
              if key.startswith("AttachmentType") for row in rows}  # fmt: skip
        parts: list[tuple[Any, float]] = []
        arc = 0.0
        for name, unstretched in sections:
            parts.append((name, unstretched))
            arc += unstretched
            clump = clumps.get(at.get(round(arc, 6), ""))
            parts += [(clump["Mass"] * 1e3, clump["Volume"])] if clump else []
        strung(system, ends, parts[::-1])
    return system


def by_moorpy(
    solved: ExportedLines, folder: Path, reach: float = NEAR, built: Any = of_moordyn
) -> tuple[Any, Any]:
    """Solve; forces that the lines exert on fairleads and anchors, N, shape (lines, 3)."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its own
        system = built(solved, folder)
        for point in system.pointList:
            point.zTol = reach
        system.initialize()
        # On displacements of its points, m: the forces are then balanced far more closely.
        assert system.solveEquilibrium(DOFtype="free", tol=1e-8)
        ends = {
            kind: np.array([p.getForces(xyz=True) for p in system.pointList if p.type == kind])
            for kind in (-1, 1)
        }
    return ends[-1], ends[1]


@pytest.mark.parametrize(
    ("case", "EA"),
    [
        (suspended(), None),
        (tanker(), None),
        (chain_and_wire(), None),
        (chain_and_wire(friction=0.5), None),
        (tanker_with_sinker(), 5e8),
        (read_case(FSO), None),
    ],
    ids=["suspended", "grounded", "clump", "friction", "sinker", "FSO"],
)
@pytest.mark.parametrize("built", [of_moordyn, of_map, of_script, of_ontology, of_orcaflex])
def test_it_finds_the_closed_form(case: Case, EA: float | None, built: Any, tmp_path: Path) -> None:
    """Ten digits of the file and MoorPy's 1e-9 of the catenary leave 1e-7 of the tension.

    With bed friction it is the answer without that is found, as the file says.
    """
    solved = exported_lines(case, EA)
    fairleads, anchors = by_moorpy(solved, tmp_path, built=built)
    assert len(fairleads) == len(solved.lines)
    for line, top, bottom in zip(solved.lines, fairleads, anchors, strict=True):
        due = line.expected
        size = due.fairlead.tension
        assert np.linalg.norm(top) == pytest.approx(size, abs=1e-7 * size)
        assert np.hypot(*top[:2]) == pytest.approx(due.horizontal_force, abs=1e-7 * size)
        assert -top[2] == pytest.approx(due.fairlead.vertical_force, abs=1e-7 * size)
        assert np.hypot(*bottom[:2]) == pytest.approx(due.anchor.horizontal_force, abs=1e-7 * size)
        assert bottom[2] == pytest.approx(due.anchor.vertical_force, abs=1e-7 * size)


def test_the_lines_of_the_turret_balance_its_load(tmp_path: Path) -> None:
    solved = exported_lines(read_case(FSO))
    fairleads, _ = by_moorpy(solved, tmp_path)
    assert -fairleads.sum(axis=0)[:2] == pytest.approx([-4281e3, 0.0], abs=1.0)  # 1e-7 of each line


def test_what_the_remark_says_of_points_near_the_bed(tmp_path: Path) -> None:
    """As MoorPy comes, it takes weight off the sinker 11 cm above the bed, and half the tension."""
    solved = exported_lines(tanker_with_sinker(), EA=5e8)
    (line,) = solved.lines
    assert 0.05 < line.solution.point_loads[0].z < 0.15
    (top,), _ = by_moorpy(solved, tmp_path, reach=2.0)
    assert np.linalg.norm(top) < 0.6 * line.solution.fairlead.tension
