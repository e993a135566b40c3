"""From a case file to a Case."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from catopt.casefile.building import build_case, made_of
from catopt.casefile.components import from_catalogue
from catopt.casefile.consistency import consistency_findings, judged_findings
from catopt.casefile.design_consistency import design_findings
from catopt.casefile.document import Section
from catopt.casefile.location import Finding, parts, refuse
from catopt.casefile.motion_consistency import motion_findings
from catopt.casefile.schema import CaseTable, LineBetweenTable, NetworkTable, Table
from catopt.casefile.sizing_file import not_a_case
from catopt.casefile.structure import read_tables
from catopt.documents import parse_toml, read_text
from catopt.errors import InputError, Problem
from catopt.model import Case, Line, PointLoad, Segment, Site
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


def read_case(path: str | os.PathLike[str]) -> Case:
    """Read a case file.

    Parameters
    ----------
    path : str or path
        The file, TOML in UTF-8; or an input file of another program (`catopt.decks`), which ends in
        anything but ``.toml``.

    Returns
    -------
    Case
        In SI.

    Raises
    ------
    InputError
        When the file cannot be read, or with every problem of what it says.
    """
    found = read_mooring(path)
    if isinstance(found, Network):
        from catopt.decks.reading import NOT_FOR_THIS

        raise InputError([Problem("lines", "", NOT_FOR_THIS)], os.fspath(path))
    return found


def read_mooring(path: str | os.PathLike[str]) -> Case | Network:
    """Read a case file, or a file of lines that meet in joints.

    As `read_case`; the latter has ``[[points]]`` and ``[[lines]]``.
    """
    source = os.fspath(path)
    if Path(path).suffix.lower() != ".toml":
        from catopt.decks.reading import is_deck, read_any_deck
        from catopt.decks.told import tell

        deck = read_text(Path(path), source, broken=True)
        if is_deck(deck):
            case, remarks = read_any_deck(deck, source)
            tell(remarks)
            return case
    return parse_mooring(read_text(Path(path), source), source, folder=str(Path(path).parent))


def parse_mooring(text: str, source: str = "", *, folder: str = "") -> Case | Network:
    """Read the text of a case file, or of a file of lines that meet in joints; as `parse_case`."""
    if is_network(parse_toml(text, source)):
        return parse_network(text, source)
    return parse_case(text, source, folder=folder)


def parse_case(text: str, source: str = "", *, folder: str = "") -> Case:
    """Read the text of a case file.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        Name of the file, for messages.
    folder : str
        Where the paths in the file count from; the working directory when left out.

    Raises
    ------
    InputError
        With every problem of the text, in its order.
    """
    return case_of(parse_toml(text, source), source, folder=folder)


def case_of(document: dict[str, Any], source: str = "", *, folder: str = "") -> Case:
    """Make the case of a document, as the TOML reader returns it; as `parse_case`."""
    table, findings = read_tables(document, CaseTable)
    case = Section(document)
    catalogue = from_catalogue(case, folder)
    findings += catalogue.findings
    findings += consistency_findings(case, catalogue.segments)
    findings += design_findings(case)
    findings += motion_findings(case)
    if findings and (other := not_a_case(document)):
        raise InputError([other], source)
    refuse(document, findings, source)
    return build_case(table, catalogue, folder)
