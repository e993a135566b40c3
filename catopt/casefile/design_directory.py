"""One design out of the directory that a design search left, as a case."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, TypeVar

from catopt.casefile.reading import read_case, read_mooring
from catopt.documents import attributes
from catopt.errors import InputError, Problem
from catopt.model import Anchor, Case, Line, PointLoad, Segment, System
from catopt.model.network import Network
from catopt.schemas import read_document
from catopt.words import Message
from catopt.words.saved import with_messages

T = TypeVar("T")

DESIGN_DOCUMENT = "design.json"
"""Name of the document in a result directory."""
DESIGN_CASE = "case.toml"
"""Name of the case file in a result directory."""

_SCHEMA = "catopt.design/1"
_MOTION = ("drag_diameter", "drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial")


def read_case_or_design(path: Path, design: int | None) -> Case:
    """Read a case file, or the design of a number out of a result directory, counted from 1.

    InputError as `read_case` and `read_design`; or a directory without a number of a design.
    """
    return _read(path, design, read_case)


def read_mooring_or_design(path: Path, design: int | None) -> Case | Network:
    """Read the same, or a file of lines that meet in joints."""
    return _read(path, design, read_mooring)


def _read(path: Path, design: int | None, read: Callable[[Path], T]) -> T | Case:
    if design is not None:
        return read_design(path, design)
    if path.is_dir() and (path / DESIGN_DOCUMENT).exists():
        allowed = Message("refused_command.result_directory_add_design_k")
        raise InputError([Problem("CASE", str(path), allowed)], "options")
    return read(path)


def read_design(directory: Path, number: int) -> Case:
    """Read a design out of the directory that ``catopt design --out`` wrote, as a case of its own.

    It is the case of the search with the line and the anchor of the design; nothing varies any
    more. A whole mooring is under the force that takes it farthest. Numbers count from 1, as in the
    tables of the front. InputError: no result directory, or no such design.
    """
    front = read_design_document(directory)["front"]
    if not 1 <= number <= len(front):
        allowed = Message("refused_command.front_has_designs_1", front=len(front))
        raise InputError([Problem("--design", str(number), allowed)], "options")
    case = read_case(directory / DESIGN_CASE)
    design = front[number - 1]
    title = f"{case.title}, design {number}" if case.title else f"Design {number}"
    try:
        line, anchor = _line(design, case), _anchor(design, case)
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
        wanted = Message(
            "refused_command.directory_catopt_design_out_wrote", design_document=DESIGN_DOCUMENT
        )
        raise InputError([Problem("CASE", str(directory), wanted)], "options")
    document = read_document(directory / DESIGN_DOCUMENT, _SCHEMA)
    try:
        found: dict[str, Any] = with_messages(document, document.pop("messages", {}))
    except ValueError as error:
        problem = Problem(
            "messages", str(error), Message("refused_command.this_edition_catopt_design_writes")
        )
        raise InputError([problem], str(directory / DESIGN_DOCUMENT)) from None
    return found


def _line(design: dict[str, Any], case: Case) -> Line:
    return Line(
        [_with_motion(_segment(each), case) for each in design["segments"]],
        [PointLoad(**attributes(each)) for each in design["point_loads"]],
    )


def _segment(each: dict[str, Any]) -> Segment:
    given = attributes(each)
    EA = math.inf if given["EA"] is None else given["EA"]
    return Segment(**given | {"EA": EA, "component": given["component"] or ""})


def _with_motion(segment: Segment, case: Case) -> Segment:
    """Give a segment of a design its drag and added mass: its model's, or its component's."""
    from catopt.catalogue.choice import chosen

    kept = {field.name for field in fields(Segment)} - {"length", *_MOTION}
    same = [
        own
        for own in case.line.segments
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
    if found is None or case.system is None:
        return case.system
    own, first = case.system, case.system.legs[0]
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


def _anchor(design: dict[str, Any], case: Case) -> Anchor | None:
    sinker = design.get("sinker")
    return case.anchor if sinker is None else Anchor("sinker", **attributes(sinker))
