"""From a case file, or a directory that a design search left, to a Case."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, Final, Literal

from catopt.casefile.building import (
    FromCatalogue,
    build_case,
    from_catalogue,
    made_segment,
    network_parts,
)
from catopt.casefile.consistency import (
    consistency_findings,
    design_findings,
    group_findings,
    joining_findings,
    limit_findings,
    segment_findings,
    without_site,
)
from catopt.casefile.document import FileSection, Finding, parts, read_tables, refuse, table
from catopt.casefile.motion_consistency import motion_findings, network_motion_findings
from catopt.casefile.plausibility import plausibility_findings
from catopt.casefile.schema import CaseTable, LineBetweenTable, NetworkTable, TableSchema
from catopt.documents import attributes, parse_toml, read_text
from catopt.errors import InputError, Problem, refused
from catopt.model import Anchor, Case, Line, PointLoad, Segment, Site, System
from catopt.model.network import LineBetween, MooredBody, Network, Point, require_case
from catopt.model.plausible_ranges import NAMES, accepting
from catopt.schemas import read_document
from catopt.words import Message
from catopt.words.message_records import with_messages

Moored = Literal["buoy", "tanker"]
"""What is to be moored."""

SIZING: Final = "sizing.toml"
"""Usual name of a sizing file, as ``case.toml`` is of a case file."""

_OF_A_CASE: Final = ("load", "load_cases", "design", "find", "pso", "catalogue")
"""Sections that only a case file has."""


def moored_in(path: str | os.PathLike[str]) -> Moored | None:
    """Say what a file is to find the mooring of; None for a case file and for what is no TOML."""
    try:
        document = parse_toml(read_text(Path(path), os.fspath(path)), os.fspath(path))
    except InputError:
        return None
    return moored_of(document)


def case_key(document: dict[str, Any]) -> tuple[str, ...]:
    """Find a key that only a case file has; empty where there is none."""
    known = next((key for key in _OF_A_CASE if key in document), None)
    if known is not None:
        return (known,)
    return ("line", "segments") if "segments" in table(document, "line") else ()


def moored_of(document: dict[str, Any]) -> Moored | None:
    """Say what a document of a file is to find the mooring of; None for that of a case."""
    if case_key(document):
        return None
    if "ship" in document:
        return "tanker"
    is_found = "environment" in document or {"name", "horizontal_force"} & {
        *table(document, "buoy")
    }
    return "buoy" if is_found else None


def is_network(document: dict[str, Any]) -> bool:
    """Whether a document is of lines that meet in joints."""
    return "points" in document and "lines" in document


def parse_network(text: str, source: str = "", *, folder: str = "") -> Network:
    """Read the text of such a file; paths in it count from the folder.

    InputError: with every problem of its keys; where those are in order, of how its parts fit
    together.
    """
    return network_of(parse_toml(text, source), source, folder=folder)


def network_of(document: dict[str, Any], source: str = "", *, folder: str = "") -> Network:
    """Make the points and lines of a document, as the TOML reader returns it."""
    table, findings = read_tables(document, NetworkTable)
    malformed = {finding.path[:2] for finding in findings}
    case = FileSection(document, schema=NetworkTable)
    catalogue = from_catalogue(case, folder)
    findings += catalogue.findings
    for line in case.tables("lines"):
        findings += [
            finding for part in line.tables("segments") for finding in segment_findings(part)
        ]
    findings += [*limit_findings(case, []), *network_motion_findings(case), *group_findings(case)]
    findings += plausibility_findings(case, findings)
    if findings:  # else the model says the rest, and all of it
        known = {finding.path[:2] for finding in findings}
        beside = _refused_beside(table, catalogue, document, malformed, known)
        findings += [*case.refused(beside), *joining_findings(case)]
    refuse(document, findings, source)
    with accepting(table.accept or ()):
        return _network(table, catalogue, document, source, folder)


def _network(
    table: NetworkTable,
    catalogue: FromCatalogue,
    document: dict[str, Any],
    source: str,
    folder: str,
) -> Network:
    problems: list[Problem] = []
    points = [_point(problems, k, point) for k, point in enumerate(table.points)]
    lines = [_line(problems, k, line, catalogue) for k, line in enumerate(table.lines)]
    given_bodies = table.given().get("bodies") or ()
    bodies = [_body(problems, k, body) for k, body in enumerate(given_bodies)]
    if problems:
        findings = [Finding(parts(p.key), p.found, p.allowed) for p in problems]
        case = FileSection(document, schema=NetworkTable)
        refuse(document, [*findings, *joining_findings(case)], source)
    site = Site(**table.site.given())
    given: dict[str, Any] = {key: getattr(table, key) or "" for key in ("title", "source")}
    given |= network_parts(table, catalogue, site, folder)
    try:
        return Network(site, tuple(points), tuple(lines), bodies=tuple(bodies), **given)
    except InputError as error:
        raise InputError(error.problems, source) from None


def _refused_beside(
    table: NetworkTable,
    catalogue: FromCatalogue,
    document: dict[str, Any],
    malformed: Collection[tuple[Any, ...]],
    known: Collection[tuple[Any, ...]],
) -> list[Problem]:
    """List what the model refuses of points, lines and bodies of which nothing is `known` to be.

    Those that are `malformed` are no part of the table.
    """
    problems: list[Problem] = []
    build: dict[str, Callable[[int, Any], object]] = {
        "points": lambda k, part: _point(problems, k, part),
        "lines": lambda k, part: _line(problems, k, part, catalogue),
        "bodies": lambda k, part: _body(problems, k, part),
    }
    with accepting(NAMES):  # what is implausible is told already
        for key, made in build.items():
            read, written = table.given().get(key) or (), document.get(key)
            count = len(written) if isinstance(written, list) else 0
            sound = [k for k in range(count) if (key, k) not in malformed]
            if len(sound) == len(read):
                for k, part in zip(sound, read, strict=True):
                    if (key, k) not in known:
                        made(k, part)
    return problems


def _point(problems: list[Problem], k: int, table: TableSchema) -> Any:
    return _built(problems, f"points[{k}]", Point, **table.given())


def _body(problems: list[Problem], k: int, table: TableSchema) -> Any:
    return _built(problems, f"bodies[{k}]", MooredBody, **table.given())


def _line(
    problems: list[Problem], k: int, table: LineBetweenTable, catalogue: FromCatalogue
) -> Any:
    path = f"lines[{k}]"
    segments = [
        _built(problems, f"{path}.segments[{i}]", made_segment, table=part, component=component)
        for i, part in enumerate(table.segments)
        for component in [catalogue.segments.get(("lines", k, "segments", i))]
    ]
    loads = [
        _built(problems, f"{path}.point_loads[{i}]", PointLoad, **load.given())
        for i, load in enumerate(table.point_loads or ())
    ]
    if None in (*segments, *loads):
        return None
    line = _built(problems, path, Line, segments=segments, point_loads=loads)
    return LineBetween(line, table.start, table.end, table.name or "")


def _built(problems: list[Problem], path: str, part: Any, /, **given: Any) -> Any:
    """Build a part of the model; what it refuses is noted under its path in the file."""
    try:
        return part(**given)
    except InputError as error:
        problems += [Problem(f"{path}.{p.key}", p.found, p.allowed) for p in error.problems]
        return None


def read_case(path: str | os.PathLike[str]) -> Any:
    """Read a case file.

    Parameters
    ----------
    path : str or path
        The file, TOML in UTF-8; or an input file of another program (`catopt.decks`), which ends in
        anything but ``.toml``.

    Returns
    -------
    Case or Network
        In SI. A file of ``[[points]]`` and ``[[lines]]``, and a deck whose lines differ or meet in
        joints, is a `catopt.Network`, for `catopt.solve_system` and `catopt.verify_case`; all else
        a `catopt.Case`.

    Raises
    ------
    InputError
        When the file cannot be read, or with every problem of what it says.

    Examples
    --------
    >>> import catopt
    >>> case = catopt.read_case("cases/buoy-9.5m/case.toml")
    >>> case.title, case.line.length
    ('Marker buoy, 9.5 m', 20.0)
    """
    return read_mooring(path)


def read_mooring(path: str | os.PathLike[str]) -> Case | Network:
    """Read a case file, or a file of lines that meet in joints; as `read_case`."""
    source = os.fspath(path)
    if Path(path).suffix.lower() != ".toml":
        from catopt.decks.reading import is_deck, is_yaml, read_any_deck, refuse_yaml
        from catopt.decks.remarks import report_remarks

        deck = read_text(Path(path), source, broken=True)
        if is_deck(deck):
            case, remarks = read_any_deck(deck, source)
            report_remarks(remarks)
            return case
        if is_yaml(deck, source):
            raise refuse_yaml(deck, source)
    return parse_mooring(read_text(Path(path), source), source, folder=str(Path(path).parent))


def parse_mooring(text: str, source: str = "", *, folder: str = "") -> Case | Network:
    """Read the text of a case file, or of a file of lines that meet in joints; as `parse_case`."""
    if is_network(parse_toml(text, source)):
        return parse_network(text, source, folder=folder)
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
    case = FileSection(document)
    catalogue = from_catalogue(case, folder)
    findings = [*without_site(case), *findings, *catalogue.findings]
    findings += consistency_findings(case, catalogue.segments)
    findings += design_findings(case)
    findings += motion_findings(case)
    findings += plausibility_findings(case, findings)
    if findings and (moored := moored_of(document)):  # no case but a file for ``catopt size``
        key = next(key for key in ("ship", "environment", "buoy") if key in document)
        allowed = Message("refused.for_size", moored=moored)
        raise refused(key, f"[{key}]", allowed, source)
    refuse(document, findings, source)
    return build_case(table, catalogue, folder)


DESIGN_DOCUMENT = "design.json"
"""Name of the document in a result directory."""
DESIGN_CASE = "case.toml"
"""Name of the case file in a result directory."""

_MOTION = ("drag_diameter", "drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial")


def read_case_or_design(path: Path, design: int | None) -> Case:
    """Read a case file, or the design of a number out of a result directory, counted from 1.

    InputError as `read_case` and `read_design`; or a directory without a number of a design.
    """
    return require_case(read_mooring_or_design(path, design), os.fspath(path))


def read_mooring_or_design(path: Path, design: int | None) -> Case | Network:
    """Read the same, or a file of lines that meet in joints."""
    if design is not None:
        return read_design(path, design)
    if path.is_dir() and (path / DESIGN_DOCUMENT).exists():
        allowed = Message("refused_command.result_directory_add_design_k")
        raise refused("CASE", str(path), allowed, "options")
    return read_mooring(path)


def read_design(directory: Path, number: int) -> Case | Network:
    """Read a design out of the directory that ``catopt design --out`` wrote, as a case of its own.

    It is the case of the search with the line and the anchor of the design, or with the lines of
    its groups; nothing varies any more. A whole mooring is under the force that takes it farthest.
    Numbers count from 1, as in the tables of the front. InputError: no result directory, or no such
    design.
    """
    front = read_design_document(directory)["front"]
    if not 1 <= number <= len(front):
        allowed = Message("refused_command.front_has_designs_1", front=len(front))
        raise refused("--design", str(number), allowed, "options")
    case = read_mooring(directory / DESIGN_CASE)
    design = front[number - 1]
    title = f"{case.title}, design {number}" if case.title else f"Design {number}"
    try:
        with accepting(case.accept):
            segments = [_design_segment(part, case) for part in design["segments"]]
            if isinstance(case, Network):
                return replace(case.made_of(segments), title=title)
            line = Line(
                segments,
                [PointLoad(**attributes(load)) for load in design["point_loads"]],
            )
            sinker = design.get("sinker")
            anchor = case.anchor if sinker is None else Anchor("sinker", **attributes(sinker))
        # Raise water and fairleads to where a whole mooring goes farthest.
        found = design.get("system") or {}
        level = found.get("farthest_water_level_m", 0.0)
        lift = level + found.get("farthest_fairlead_rise_m", 0.0)
        site = replace(case.site, water_depth=case.site.water_depth + level)
        case = replace(case, site=site, fairlead_height=case.fairlead_height + lift, design=None)
        system = _system(design, line, case)
    except InputError as error:
        problems = [replace(p, key=f"front[{number - 1}]: {p.key}") for p in error.problems]
        raise InputError(problems, str(directory / DESIGN_DOCUMENT)) from error
    return replace(case, title=title, line=line, anchor=anchor, system=system)


def read_design_document(directory: Path) -> dict[str, Any]:
    """Read the document of what ``catopt design --out`` wrote; InputError if there is none."""
    if not (directory / DESIGN_DOCUMENT).is_file():
        key = "refused_command.directory_catopt_design_out_wrote"
        wanted = Message(key, design_document=DESIGN_DOCUMENT)
        raise refused("CASE", str(directory), wanted, "options")
    document = read_document(directory / DESIGN_DOCUMENT, "catopt.design/1")
    try:
        found: dict[str, Any] = with_messages(document, document.pop("messages", {}))
    except ValueError as error:
        allowed = Message("refused_command.this_edition_catopt_design_writes")
        problem = Problem("messages", str(error), allowed)
        raise InputError([problem], str(directory / DESIGN_DOCUMENT)) from None
    return found


def _design_segment(each: dict[str, Any], case: Case | Network) -> Segment:
    """Build a segment of a design; drag and added mass are its model's, or its component's."""
    from catopt.catalogue.choice import chosen

    given = attributes(each)
    EA = math.inf if given["EA"] is None else given["EA"]
    segment = Segment(**given | {"EA": EA, "component": given["component"] or ""})
    kept = {field.name for field in fields(Segment)} - {"length", *_MOTION}
    same = [
        own
        for line in case.every_line
        for own in line.segments
        if all(getattr(own, key) == getattr(segment, key) for key in kept)
    ]
    if not same and segment.component and segment.nominal_diameter is not None:
        families = chosen(case.catalogue, case.site.water_density)
        component = families.component(segment.component, segment.nominal_diameter)
        same = [component.segment(segment.length)]
    return replace(segment, **{key: getattr(same[0], key) for key in _MOTION}) if same else segment


def _system(design: dict[str, Any], line: Line, case: Case) -> System | None:
    """Build the body with the lines of the design."""
    found = design.get("system")
    if found is None:
        return case.system
    own, first = case.own_system, case.own_system.legs[0]
    return System.around(
        line,
        azimuths=found["azimuths_rad"],
        anchor_radius=found["anchor_radius_m"],
        fairlead_height=case.fairlead_height,
        fairlead_radius=first.fairlead_radius,
        anchor_height=first.anchor_height,
        seabed_friction=own.seabed_friction,
        force=tuple(found["farthest_force_N"]),
        moment=own.moment,
        yaw_free=own.yaw_free,
        judged_line_out=found.get("farthest_line_out", own.judged_line_out),
    )
