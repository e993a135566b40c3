"""Files of lines that meet in joints: ``[[points]]`` and ``[[lines]]`` in place of ``[line]``."""

from __future__ import annotations

from typing import Any

from catopt.casefile.building import made_of
from catopt.casefile.consistency import judged_findings
from catopt.casefile.document import Section
from catopt.casefile.location import Finding, parts, refuse
from catopt.casefile.schema import LineBetweenTable, NetworkTable, Table
from catopt.casefile.structure import read_tables
from catopt.documents import parse_toml
from catopt.errors import InputError, Problem
from catopt.model import Line, PointLoad, Segment, Site
from catopt.model.network import LineBetween, MooredBody, Network, Point


def is_network(document: dict[str, Any]) -> bool:
    """Whether a document is of lines that meet in joints."""
    return "points" in document and "lines" in document


def parse_network(text: str, source: str = "") -> Network:
    """Read the text of such a file.

    InputError: with every problem of its keys; where those are in order, of how its parts fit
    together.
    """
    document = parse_toml(text, source)
    table, findings = read_tables(document, NetworkTable)
    case = Section(document, schema=NetworkTable)
    findings += judged_findings(case, [])
    problems: list[Problem] = []
    points: list[Any] = []
    lines: list[Any] = []
    bodies: list[Any] = []
    if not findings:
        points = [
            _built(problems, f"points[{k}]", Point, **each.given())
            for k, each in enumerate(table.points)
        ]
        lines = [_line(problems, f"lines[{k}]", each) for k, each in enumerate(table.lines)]
        bodies = [
            _built(problems, f"bodies[{k}]", MooredBody, **each.given())
            for k, each in enumerate(table.given().get("bodies") or ())
        ]
        findings = [Finding(parts(each.key), each.found, each.allowed) for each in problems]
    refuse(document, findings, source)
    site = Site(**table.site.given())
    given: dict[str, Any] = {key: getattr(table, key) or "" for key in ("title", "source")}
    for key in ("checks", "service", "anchor", "current"):
        if (part := table.given().get(key)) is not None:
            own = {k: tuple(v) if isinstance(v, list) else v for k, v in part.given().items()}
            given[key] = made_of(part, own, site)
    try:
        return Network(site, tuple(points), tuple(lines), bodies=tuple(bodies), **given)
    except InputError as error:
        raise InputError(error.problems, source) from None


def _line(problems: list[Problem], path: str, table: LineBetweenTable) -> Any:
    segments = [_segment(each) for each in table.segments]
    loads = [PointLoad(**each.given()) for each in table.point_loads or ()]
    line = _built(problems, path, Line, segments=segments, point_loads=loads)
    return LineBetween(line, table.start, table.end, table.name or "")


def _segment(table: Table) -> Segment:
    given = table.given()
    if "diameter" in given:
        given["nominal_diameter"] = given.pop("diameter")
    return Segment(**given)


def _built(problems: list[Problem], path: str, part: Any, /, **given: Any) -> Any:
    """Build a part of the model; what it refuses is noted under its path in the file."""
    try:
        return part(**given)
    except InputError as error:
        problems += [Problem(f"{path}.{p.key}", p.found, p.allowed) for p in error.problems]
        return None
