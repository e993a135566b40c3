"""What must hold between the keys of a case file.

These checks read the document itself and pass over what is missing or unreadable, so that they
find their mistakes beside those of the single keys, not after them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.casefile.document import (
    Place,
    as_in_file,
    in_file,
    misspelt,
    number,
    refusals,
    table,
    tables,
    text,
    values,
)
from catopt.casefile.location import Finding, parts
from catopt.casefile.ranges import duplicates
from catopt.casefile.schema import (
    AnchorTable,
    CaseTable,
    ChecksTable,
    FindTable,
    LineTable,
    LoadCaseTable,
    LoadTable,
    PointLoadTable,
    SegmentTable,
    SiteTable,
    SystemTable,
    Table,
    entries,
)
from catopt.constants import SEA_WATER_DENSITY
from catopt.documents import Path
from catopt.errors import InputError
from catopt.model import Anchor, Find, Load
from catopt.model.anchor import ANCHOR_KINDS
from catopt.model.checks import NEEDS_SEVERAL_LINES
from catopt.model.find import FIND_QUANTITIES, FORCES, misfits
from catopt.model.line import END_ROUNDING, break_test_misfits, drag_misfits, point_drag_misfits
from catopt.model.service import wear_misfits
from catopt.model.site import LEVEL_ONLY
from catopt.model.system import system_misfits
from catopt.units import Dimension, as_written

if TYPE_CHECKING:
    from catopt.catalogue import Component


def consistency_findings(
    document: dict[str, Any], components: Mapping[Path, Component]
) -> list[Finding]:
    """List what contradicts itself in a document, with its components by their paths."""
    line = table(document, "line")
    loads = tables(line, "line", "point_loads")
    return [
        *_load(document),
        *_find(document),
        *_misfits(document, line, components),
        *(f for place in tables(line, "line", "segments") for f in _segment(document, place)),
        *(f for place in loads for f in _weight(PointLoadTable, place)),
        *(f for place in loads for f in _drag(document, place)),
        *_positions(line),
        *_contact_offset(document),
        *_load_cases(document),
        *_system(document),
        *_checks(document),
        *_anchor(document),
        *_wear(document, line),
    ]


def _load(document: dict[str, Any]) -> Iterator[Finding]:
    """Find any but exactly one known quantity at the fairlead, as the model has it."""
    load, sought = document.get("load"), _sought(document)
    if not isinstance(load, dict) or (sought is not None and sought.seeks_force):
        return
    known = [key for key in entries(LoadTable) if key in load]
    if known or not misspelt(LoadTable, entries(LoadTable), load):
        problems = refusals(Load, **dict.fromkeys(known, 1.0))
        yield from (Finding(("load",), each.found, each.allowed) for each in problems)


def _wear(document: dict[str, Any], line: dict[str, Any]) -> Iterator[Finding]:
    """Find rates, tables and zones of wear that do not go together, as the model has it."""
    segments = [segment for _, segment in tables(line, "line", "segments")]
    yield from in_file(document, wear_misfits(table(document, "service"), segments))


def _find(document: dict[str, Any]) -> Iterator[Finding]:
    """Find conditions too few or too many, and keys that go with another quantity."""
    find = table(document, "find")
    if _sought(document) is None or misspelt(FindTable, entries(FindTable), find):
        return
    given: dict[str, Any] = {key: 1 for key in entries(FindTable) if key in find}
    for problem in refusals(Find, **given | {"quantity": find["quantity"]}):
        path = ("find", problem.key) if problem.key in find else ("find",)
        yield as_in_file(document, Finding(path, problem.found, problem.allowed))


def _misfits(
    document: dict[str, Any], line: dict[str, Any], components: Mapping[Path, Component]
) -> Iterator[Finding]:
    """Find what does not fit between what is sought, the load and the line, as the model has it."""
    sought, load = _sought(document), document.get("load")
    if sought is None and ("find" in document or misspelt(CaseTable, ["find"], document)):
        return
    segments = tables(line, "line", "segments")
    loads = tables(line, "line", "point_loads")
    problems = misfits(
        sought,
        load=None if load is None else list(table(document, "load")),
        MBL_known=[_has_MBL(segment, components.get(path)) for path, segment in segments],
        point_loads=len(loads),
        anchor_height=number(LineTable, "anchor_height", line) or 0.0,
        has_load_cases="load_cases" in document or "system" in document,
    )
    unsure = misspelt(LineTable, entries(LineTable), line) or ("point_loads" in line and not loads)
    for problem in problems:
        about_load = problem.key.startswith("load")
        if about_load and load is None and misspelt(CaseTable, ["load", "load_cases"], document):
            continue
        if about_load or (segments and not unsure):
            either = about_load and sought is None
            allowed = problem.allowed + (", or [[load_cases]]" if either else "")
            yield from in_file(document, [replace(problem, allowed=allowed)])


def _has_MBL(segment: dict[str, Any], component: Component | None) -> bool:
    """Whether a segment's strength is given, or may be for all that is clear."""
    if "MBL" in segment or misspelt(SegmentTable, ["MBL"], segment):
        return True
    return component.MBL is not None if component else "component" in segment


def _sought(document: dict[str, Any]) -> Find | None:
    """Return what is sought, with a condition that fits; None when nothing is or it is unclear."""
    find = table(document, "find")
    quantity: Any = find.get("quantity")
    if quantity not in FIND_QUANTITIES:
        return None
    sought = Find(quantity, anchor_angle=None if quantity in FORCES else 0.0)
    with suppress(InputError):  # wrong in itself, or goes with another quantity
        sought = replace(sought, segment=find.get("segment"))
    with suppress(InputError):
        sought = replace(sought, point_load=find.get("point_load"))
    return sought


def _segment(document: dict[str, Any], place: Place) -> Iterator[Finding]:
    """Find a segment without weight or component, and a component without its diameter."""
    path, segment = place
    if "component" in segment:
        if "diameter" not in segment and not misspelt(SegmentTable, ["diameter"], segment):
            yield Finding((*path, "diameter"), "", "missing; a component needs its diameter")
    elif not (
        "submerged_weight" in segment
        or misspelt(SegmentTable, ["submerged_weight", "component"], segment)
    ):
        example = Dimension.FORCE_PER_LENGTH.example
        wanted = f"a weight per length is wanted, such as {example}, or a component"
        yield Finding((*path, "submerged_weight"), "", f"missing; {wanted}")
    if "drag_axial_area" in segment and "drag_axial" not in segment:
        allowed = "goes with drag_axial, which is missing; the catalogue's has its own area"
        yield Finding((*path, "drag_axial_area"), as_written(segment["drag_axial_area"]), allowed)
    if not misspelt(SegmentTable, ("drag_method", "roughness"), segment):
        problems = drag_misfits(values(SegmentTable, segment)) + break_test_misfits(segment)
        yield from in_file(document, problems, *path)


def _weight(schema: type[Table], place: Place) -> Iterator[Finding]:
    """Find a body whose weight is not given, or given both itself and by density or volume."""
    path, body = place
    keys = ("submerged_weight", "mass", "density")
    if misspelt(schema, (*keys, "volume"), body):
        return
    weight, mass, density = (key in body for key in keys)
    if "volume" in body:
        if weight or density or not mass:
            allowed = "goes with mass, in place of submerged_weight and density"
            yield Finding((*path, "volume"), as_written(body["volume"]), allowed)
        return
    wanted = "submerged_weight, or mass with density, is wanted"
    if density and not mass:
        found = as_written(body["density"])
        yield Finding((*path, "density"), found, "density goes with mass, which is missing")
    elif weight and density:
        found = "submerged_weight, mass and density"
        yield Finding(path, found, "leave out submerged_weight or density")
    elif mass and not weight and not density:
        yield Finding(path, "mass without density", wanted)
    elif not weight and not mass:
        yield Finding((*path, "submerged_weight"), "", f"missing; {wanted}")


def _drag(document: dict[str, Any], place: Place) -> Iterator[Finding]:
    """Find a drag of a point load that lacks its area or its coefficient."""
    path, body = place
    if not misspelt(PointLoadTable, ("drag_area", "drag_coefficient"), body):
        yield from in_file(document, point_drag_misfits(body), *path)


def _positions(line: dict[str, Any]) -> Iterator[Finding]:
    """Find point loads beyond the end of the line."""
    segments = tables(line, "line", "segments")
    lengths = [number(SegmentTable, "length", segment) for _, segment in segments]
    known = [length for length in lengths if length is not None]
    if not known or len(known) < len(lengths):
        return
    total = math.fsum(known)
    for path, load in tables(line, "line", "point_loads"):
        position = number(PointLoadTable, "position", load)
        if position is not None and not position < total * (1.0 - END_ROUNDING):
            allowed = f"must be below {total:g} m, the length of the line"
            yield Finding((*path, "position"), as_written(load["position"]), allowed)


def _contact_offset(document: dict[str, Any]) -> Iterator[Finding]:
    """Find depth and heights that are not above the axis of a line that lies on the bed."""
    site, line = table(document, "site"), table(document, "line")
    offset = number(SiteTable, "contact_offset", site)
    if not offset:
        return
    if number(SiteTable, "seabed_slope", site):
        yield Finding(("site", "contact_offset"), as_written(site["contact_offset"]), LEVEL_ONLY)
    allowed = f"must be above {offset:g} m, the contact_offset of the site"
    for part, key in (
        ("site", "water_depth"),
        ("line", "fairlead_height"),
        ("line", "anchor_height"),
    ):
        schema, given = (SiteTable, site) if part == "site" else (LineTable, line)
        height = number(schema, key, given)
        if height and height <= offset:
            on_bed = "; 0 is an end on the seabed" if part == "line" else ""
            yield Finding((part, key), as_written(given[key]), allowed + on_bed)


def _load_cases(document: dict[str, Any]) -> Iterator[Finding]:
    """Find names used twice, and water levels that leave no water, at rest and of a design."""
    yield from _levels(document, tables(document, "load_cases"))
    yield from _levels(document, tables(table(document, "design"), "design", "loads"))


def _levels(document: dict[str, Any], states: list[Place]) -> Iterator[Finding]:
    depth = number(SiteTable, "water_depth", table(document, "site"))
    line = table(document, "line")
    height = number(LineTable, "fairlead_height", line)
    given = "fairlead_height" in line or misspelt(LineTable, ["fairlead_height"], line)
    unclear = depth is None or (given and height is None)
    names: list[str] = []
    for path, state in states:
        name = text(LoadCaseTable, "name", state)
        if name in names:
            yield Finding((*path, "name"), as_written(name), "another load case has this name")
        names += [name] if name is not None else []
        level = number(LoadCaseTable, "water_level", state)
        rise = number(LoadCaseTable, "fairlead_rise", state) or 0.0
        lowest = min(depth or 0.0, (depth or 0.0 if height is None else height) + rise)
        if level is not None and not unclear and not level > -lowest:
            allowed = f"must leave the fairlead above the seabed: above {-lowest:g} m"
            yield Finding((*path, "water_level"), as_written(state["water_level"]), allowed)


def _system(document: dict[str, Any]) -> Iterator[Finding]:
    """Find what does not go with a system, and a load in yaw on a body that cannot turn."""
    if "system" not in document:
        return
    others: dict[str, object] = {k: 1 for k in ("load", "load_cases", "find") if k in document}
    others["site.seabed_slope"] = number(SiteTable, "seabed_slope", table(document, "site"))
    yield from (Finding(parts(p.key), p.found, p.allowed) for p in system_misfits(others))
    system = table(document, "system")
    if misspelt(SystemTable, entries(SystemTable), system):
        return
    radius = number(SystemTable, "fairlead_radius", system)
    unclear = "fairlead_radius" in system and radius is None
    has_arms = unclear or bool(radius)
    yaw_free = system.get("yaw_free", has_arms)
    if yaw_free is True and not has_arms:
        allowed = "must be false, or fairlead_radius above 0: nothing else holds the body in yaw"
        yield Finding(("system", "yaw_free"), "true", allowed)
    elif yaw_free is False and number(SystemTable, "moment", system):
        allowed = "must be 0 where the body does not yaw: give fairlead_radius, or leave it out"
        yield Finding(("system", "moment"), as_written(system["moment"]), allowed)


def _checks(document: dict[str, Any]) -> Iterator[Finding]:
    """Find codes or a largest span given in two ways, and what goes with several lines."""
    checks, line_out = table(document, "checks"), "safety_factor_line_out"
    has_system = "system" in document or misspelt(CaseTable, ["system"], document)
    for name, given in (("checks", checks), ("anchor", table(document, "anchor"))):
        if line_out in given and not has_system:
            yield Finding((name, line_out), as_written(given[line_out]), NEEDS_SEVERAL_LINES)
    if "code" in checks and "codes" in checks:
        yield Finding(("checks",), "code and codes", "put all of them into codes")
    if "max_span" in checks and "max_offset" in checks:
        allowed = "leave it out: it limits the span, as max_span does"
        yield Finding(("checks", "max_offset"), as_written(checks["max_offset"]), allowed)
    yield from duplicates(ChecksTable, (("checks",), checks), "codes")


def _anchor(document: dict[str, Any]) -> Iterator[Finding]:
    """Find what does not go with the kind of anchor, as the model has it."""
    anchor, path = table(document, "anchor"), ("anchor",)
    kind: Any = anchor.get("kind")
    if kind not in ANCHOR_KINDS:
        return
    given: dict[str, Any] = {
        key: 1.0 for key in entries(AnchorTable) if key in anchor and key not in {"kind", "density"}
    }
    if "factor_source" in given:
        given["factor_source"] = "-"
    if kind == "sinker":
        yield from _weight(AnchorTable, (path, anchor))
        yield from sinks_findings(document, AnchorTable, (path, anchor))
        given["submerged_weight"] = 1.0
    elif "density" in anchor:
        allowed = "does not go with a drag anchor; leave it out"
        yield Finding((*path, "density"), as_written(anchor["density"]), allowed)
    for problem in refusals(Anchor, **given | {"kind": kind}):
        if problem.key in anchor or not misspelt(AnchorTable, [problem.key], anchor):
            yield from in_file(document, [problem], "anchor")


def sinks_findings(
    document: dict[str, Any], schema: type[Table], place: Place
) -> Iterator[Finding]:
    """Find a sinker that floats."""
    path, body = place
    site = table(document, "site")
    water = number(SiteTable, "water_density", site)
    if water is None and "water_density" in site:
        return
    water = water or SEA_WATER_DENSITY
    density = number(schema, "density", body)
    if density is not None and not density > water:
        allowed = f"must be above {water:g} kg/m^3, the density of the water, for a sinker to sink"
        yield Finding((*path, "density"), as_written(body["density"]), allowed)
