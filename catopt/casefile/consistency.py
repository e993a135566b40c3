"""What must hold between the keys of a case file."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.casefile import building as ranges
from catopt.casefile.building import SIZES, duplicates
from catopt.casefile.document import FileSection, Finding, parts, refusals
from catopt.casefile.schema import LENGTHS, MASSES, POSITIONS, PRETENSIONS, RADII, entries
from catopt.constants import SEA_WATER_DENSITY
from catopt.documents import Path
from catopt.errors import InputError, Problem
from catopt.model import Anchor, ClumpWeightChoice, Design, Find, Load, SegmentChoice
from catopt.model.anchor import ANCHOR_KINDS
from catopt.model.case import WET
from catopt.model.design import (
    FIND_QUANTITIES,
    FORCES,
    OF_SPAN,
    body_misfits,
    inconsistencies,
)
from catopt.model.dynamics import OF_MOTION
from catopt.model.joined import network_misfits
from catopt.model.line import (
    END_ROUNDING,
    break_test_misfits,
    drag_misfits,
    point_drag_misfits,
    table_misfits,
)
from catopt.model.service import wear_misfits
from catopt.model.system import system_misfits
from catopt.units import Dimension
from catopt.words import Message, given_keys

if TYPE_CHECKING:
    from catopt.catalogue import Component


def consistency_findings(case: FileSection, components: Mapping[Path, Component]) -> list[Finding]:
    """List what contradicts itself in a document, with its components by their paths."""
    line = case.table("line")
    segments, loads = line.tables("segments"), line.tables("point_loads")
    dragged = [load for load in loads if not load.misspelt("drag_area", "drag_coefficient")]
    return [
        *_load(case),
        *_find(case),
        *_misfits(case, line, components),
        *(f for segment in segments for f in segment_findings(segment)),
        *(f for load in loads for f in _weight(load)),
        *(f for load in dragged for f in load.refused(point_drag_misfits(load.given))),
        *_positions(segments, loads),
        *_contact_offset(case.table("site"), line),
        *_levels(case, case.tables("load_cases")),
        *_levels(case, case.table("design").tables("loads")),
        *_system(case),
        *limit_findings(case, segments),
    ]


def without_site(case: FileSection) -> Iterator[Finding]:
    """Find what a line in air, of a file without site, does not go with, and what it lacks."""
    line = case.table("line")
    if "site" in case or case.misspelt("site"):
        return
    wet = [f"[{key}]" for key in WET if key in case]
    if wet:
        yield Finding(("site",), "", Message("refused_case.site_for", keys=", ".join(wet)))
    elif "line" not in case:
        yield case.missing("site", Message("refused.table_named", line="[site]"))
    elif line.lacks("fairlead_height"):
        yield Finding(("line", "fairlead_height"), "", Message("refused_case.height_in_air"))


def limit_findings(case: FileSection, segments: list[FileSection]) -> list[Finding]:
    """List what contradicts itself in what lines are judged by: checks, anchor, service."""
    service = case.table("service").given
    return [
        *_checks(case),
        *_anchor(case),
        *case.refused(wear_misfits(service, [segment.given for segment in segments])),
    ]


def _load(case: FileSection) -> Iterator[Finding]:
    """Find any but exactly one known quantity at the fairlead, as the model has it."""
    load, sought = case.table("load"), _sought(case)
    if not isinstance(case.given.get("load"), dict) or (sought and sought.seeks_force):
        return
    known = [key for key in entries(load.schema) if key in load]
    if known or not load.misspelt():
        problems = refusals(Load, **dict.fromkeys(known, 1.0))
        yield from (Finding(("load",), problem.found, problem.allowed) for problem in problems)


def _find(case: FileSection) -> Iterator[Finding]:
    """Find conditions too few or too many, and keys that go with another quantity."""
    find = case.table("find")
    if _sought(case) is None or find.misspelt():
        return
    given: dict[str, Any] = {key: 1 for key in entries(find.schema) if key in find}
    for problem in refusals(Find, **given | {"quantity": find.given["quantity"]}):
        here = problem if problem.key in find else replace(problem, key="")
        yield from find.refused([here])


def _misfits(
    case: FileSection, line: FileSection, components: Mapping[Path, Component]
) -> Iterator[Finding]:
    """Find what does not fit between what is sought, the load and the line, as the model has it."""
    sought, has_load = _sought(case), case.given.get("load") is not None
    if sought is None and not case.lacks("find"):
        return
    segments, loads = line.tables("segments"), line.tables("point_loads")
    problems = inconsistencies(
        sought,
        load=list(case.table("load").given) if has_load else None,
        MBL_known=[_has_MBL(part, components.get(part.path)) for part in segments],
        point_loads=len(loads),
        anchor_height=line.number("anchor_height") or 0.0,
        has_load_cases="load_cases" in case or "system" in case,
    )
    unsure = line.misspelt() or ("point_loads" in line and not loads)
    for problem in problems:
        about_load = problem.key.startswith("load")
        if about_load and not has_load and case.misspelt("load", "load_cases"):
            continue
        if about_load or (segments and not unsure):
            if about_load and sought is None:
                either = Message("refused.or_load_cases", wanted=problem.allowed)
                problem = replace(problem, allowed=either)
            yield from case.refused([problem])


def _has_MBL(segment: FileSection, component: Component | None) -> bool:
    """Whether a segment's strength is given, or may be for all that is clear."""
    if not segment.lacks("MBL"):
        return True
    return component.MBL is not None if component else "component" in segment


def _sought(case: FileSection) -> Find | None:
    """Return what is sought, with a condition that fits; None when nothing is or it is unclear."""
    find = case.table("find").given
    quantity: Any = find.get("quantity")
    if quantity not in FIND_QUANTITIES:
        return None
    sought = Find(quantity, anchor_angle=None if quantity in FORCES else 0.0)
    of_span: dict[str, Any] = {key: 1.0 for key in OF_SPAN if key in find}
    if quantity == "length" and len(of_span) == 1:
        sought = replace(sought, anchor_angle=None, **of_span)
    for key in ("segment", "point_load"):
        given: dict[str, Any] = {key: find.get(key)}
        with suppress(InputError):  # wrong in itself, or goes with another quantity
            sought = replace(sought, **given)
    return sought


def segment_findings(segment: FileSection) -> Iterator[Finding]:
    """Find a segment without weight or component, and a component without its diameter."""
    if "component" in segment:
        if segment.lacks("diameter"):
            yield segment.missing("diameter", Message("refused.component_diameter"))
    elif segment.lacks("submerged_weight") and not segment.misspelt("component"):
        example = Dimension.FORCE_PER_LENGTH.example
        wanted = Message("refused.weight_or_component", example=example)
        yield segment.missing("submerged_weight", wanted)
    if "drag_axial_area" in segment and "drag_axial" not in segment:
        yield segment.wrong("drag_axial_area", Message("refused.with_drag_axial"))
    if not segment.misspelt("drag_method", "roughness"):
        yield from segment.refused(drag_misfits(segment.values()))
        yield from segment.refused(break_test_misfits(segment.given))
    yield from _strain_table(segment)


def _strain_table(segment: FileSection) -> Iterator[Finding]:
    """Find a table of strains that is half, wrong, or beside an axial stiffness."""
    keys = ("strain", "strain_tension")
    given = [key for key in keys if key in segment]
    if not given or segment.misspelt(*keys, "EA"):
        return
    if "EA" in segment:
        yield segment.wrong("EA", Message("refused_case.table_or_stiffness"))
    for key in keys:
        if key not in given:
            yield segment.missing(key, Message("refused.missing_goes_with", key_=given[0]))
    values = segment.values()
    if len(given) == len(keys) and all(values[key] is not None for key in keys):
        yield from segment.refused(table_misfits(values["strain"], values["strain_tension"]))


def _weight(body: FileSection) -> Iterator[Finding]:
    """Find a body whose weight is not given, or given both itself and by density or volume."""
    if body.misspelt("submerged_weight", "mass", "density", "volume"):
        return
    weight, mass, density = (key in body for key in ("submerged_weight", "mass", "density"))
    wanted = Message("refused.weight_or_mass")
    if "volume" in body:
        if weight or density or not mass:
            yield body.wrong("volume", Message("refused.with_mass"))
    elif density and not mass:
        yield body.wrong("density", Message("refused.density_with_mass"))
    elif weight and density:
        every = Message("refused_file.all_of", some="submerged_weight, mass", last="density")
        yield Finding(body.path, every, Message("refused.leave_out_either"))
    elif mass and not weight and not density:
        yield Finding(body.path, Message("refused_file.mass_without_density"), wanted)
    elif not weight and not mass:
        yield body.missing("submerged_weight", wanted)


def _positions(segments: list[FileSection], loads: list[FileSection]) -> Iterator[Finding]:
    """Find point loads beyond the end of the line."""
    lengths = [segment.number("length") for segment in segments]
    known = [length for length in lengths if length is not None]
    if not known or len(known) < len(lengths):
        return
    total = math.fsum(known)
    for load in loads:
        position = load.number("position")
        if position is not None and not position < total * (1.0 - END_ROUNDING):
            yield load.wrong("position", Message("refused.below_line", length=total))


def _contact_offset(site: FileSection, line: FileSection) -> Iterator[Finding]:
    """Find depth and heights that are not above the axis of a line that lies on the bed."""
    offset = site.number("contact_offset")
    if not offset:
        return
    if site.number("seabed_slope"):
        yield site.wrong("contact_offset", Message("refused_case.level_only"))
    allowed = Message("refused.above_contact_offset", offset=offset)
    if (site.number("water_depth") or math.inf) <= offset:
        yield site.wrong("water_depth", allowed)
    for key in ("fairlead_height", "anchor_height"):
        if (line.number(key) or math.inf) <= offset:
            yield line.wrong(key, Message("refused_case.end_on_seabed", allowed=allowed))


def _levels(case: FileSection, states: list[FileSection]) -> Iterator[Finding]:
    """Find names used twice, and water levels that leave no water, of load cases or of loads."""
    depth = case.table("site").number("water_depth")
    line = case.table("line")
    height = line.number("fairlead_height")
    unclear = depth is None or (height is None and not line.lacks("fairlead_height"))
    names: list[str] = []
    for state in states:
        name = state.value("name")
        if name in names:
            yield state.wrong("name", Message("refused.name_taken"))
        names += [name] if name is not None else []
        level, rise = state.number("water_level"), state.number("fairlead_rise") or 0.0
        lowest = min(depth or 0.0, (depth or 0.0 if height is None else height) + rise)
        if level is not None and not unclear and not level > -lowest:
            yield state.wrong("water_level", Message("refused.fairlead_above_bed", least=-lowest))


def _system(case: FileSection) -> Iterator[Finding]:
    """Find what does not go with a system, and a load in yaw on a body that cannot turn."""
    if "system" not in case:
        return
    others: dict[str, object] = {k: 1 for k in ("load", "load_cases", "find") if k in case}
    others["site.seabed_slope"] = case.table("site").number("seabed_slope")
    yield from (Finding(parts(p.key), p.found, p.allowed) for p in system_misfits(others))
    system = case.table("system")
    if system.misspelt():
        return
    radius = system.number("fairlead_radius")
    unclear = "fairlead_radius" in system and radius is None
    has_arms = unclear or bool(radius)
    yaw_free = system.given.get("yaw_free", has_arms)
    if yaw_free is True and not has_arms:
        yield system.wrong("yaw_free", Message("refused.no_yaw"))
    elif yaw_free is False and system.number("moment"):
        yield system.wrong("moment", Message("refused.zero_without_yaw"))


def _checks(case: FileSection) -> Iterator[Finding]:
    """Find codes or a largest span given in two ways, and what goes with several lines."""
    checks = case.table("checks")
    for section in (checks, case.table("anchor")):
        single = case.lacks("system") and "points" not in case.given
        if "safety_factor_line_out" in section and single:
            yield section.wrong("safety_factor_line_out", Message("refused.needs_several_lines"))
    if "dynamics" not in case.given and "points" not in case.given:  # points: as the model has it
        for part, key in OF_MOTION:
            if key in case.table(part):
                yield case.table(part).wrong(key, Message("refused.with_dynamics"))
    if "code" in checks and "codes" in checks:
        both = Message("refused_file.two_keys", one="code", other="codes")
        yield Finding(("checks",), both, Message("refused.all_into_codes"))
    if "max_span" in checks and "max_offset" in checks:
        yield checks.wrong("max_offset", Message("refused.limits_span"))
    yield from duplicates(checks, "codes")


def _anchor(case: FileSection) -> Iterator[Finding]:
    """Find what does not go with the kind of anchor, as the model has it."""
    anchor = case.table("anchor")
    kind: Any = anchor.given.get("kind")
    if kind not in ANCHOR_KINDS:
        return
    given: dict[str, Any] = {key: 1.0 for key in entries(anchor.schema) if key in anchor}
    given.pop("density", None)
    if "factor_source" in given:
        given["factor_source"] = "-"
    if kind == "sinker":
        yield from _weight(anchor)
        yield from sinks_findings(case, anchor)
        given["submerged_weight"] = 1.0
    elif "density" in anchor:
        yield anchor.wrong("density", Message("refused.not_with_drag"))
    for problem in refusals(Anchor, **given | {"kind": kind}):
        if problem.key in anchor or not anchor.misspelt(problem.key):
            yield from anchor.refused([problem])


def sinks_findings(case: FileSection, body: FileSection) -> Iterator[Finding]:
    """Find a sinker that floats."""
    site = case.table("site")
    water = site.number("water_density")
    if water is None and "water_density" in site:
        return
    water = water or SEA_WATER_DENSITY
    density = body.number("density")
    if density is not None and not density > water:
        yield body.wrong("density", Message("refused.sinker_floats", water=water))


_COMPONENTS = ("components", "component")


def design_findings(case: FileSection) -> list[Finding]:
    """List what contradicts itself in the design of a document."""
    design, line = case.table("design"), case.table("line")
    if not design.given:
        return []
    segments, weights = design.tables("segments"), design.tables("clump_weights")
    sinker, of_line = design.table("sinker"), line.tables("segments")
    is_clear = bool(of_line) and not line.misspelt("segments")
    # Each segment with that of the line in its place, from which it may take over what it lacks.
    pairs = list(zip(segments, (*of_line, *[None] * len(segments)), strict=False))
    return [
        *(
            f
            for k, (choice, own) in enumerate(pairs)
            for f in _design_segment(choice, k, own, is_clear=is_clear)
        ),
        *(f for weight in weights for f in _clump_weight(weight)),
        *_design_positions(pairs, weights),
        *(ranges.findings(MASSES, sinker, required=True) if sinker.given else ()),
        *(sinks_findings(case, sinker) if sinker.given else ()),
        *(_as_the_model_has_it(design, segments, weights) if segments else ()),
        *_excursion(case, design),
        *_of_a_body(case, design),
    ]


def group_findings(case: FileSection) -> Iterator[Finding]:
    """Find what contradicts itself in the groups of a design of lines between points."""
    for choice in case.table("design").tables("groups"):
        yield from ranges.findings(LENGTHS, choice, required=True)
        if all(key in choice for key in _COMPONENTS):
            both = Message("refused_file.two_keys", one="component", other="components")
            yield Finding(choice.path, both, Message("refused.only_one"))
        yield from _sizes(choice)
        if choice.lacks(*_COMPONENTS) and (key := next((k for k in SIZES if k in choice), "")):
            yield choice.wrong(key, Message("refused.with_components"))


def _design_segment(
    choice: FileSection, index: int, own: FileSection | None, *, is_clear: bool
) -> Iterator[Finding]:
    """Find what is given in two ways, and what the line has not got to be taken over."""
    yield from ranges.findings(LENGTHS, choice)
    if all(key in choice for key in _COMPONENTS):
        both = Message("refused_file.two_keys", one="component", other="components")
        yield Finding(choice.path, both, Message("refused.only_one"))
    yield from _sizes(choice)
    nothing = Message("refused.no_such_segment", number=index + 1)
    if is_clear and own is None and choice.lacks(*LENGTHS.keys):
        yield choice.missing("lengths", nothing)
    if not is_clear or not choice.lacks(*_COMPONENTS):
        return
    if own is None:
        yield choice.missing("components", nothing)
    elif any(key in choice for key in SIZES) and own.lacks("component"):
        why = Message("refused.segment_without_component", number=index + 1)
        yield choice.missing("components", why)


def _sizes(choice: FileSection) -> Iterator[Finding]:
    """Find diameters given in two ways, twice, or as a range that is none."""
    ranged = [key for key in ("diameter_min", "diameter_max") if key in choice]
    singly = [key for key in ("diameter", "diameters") if key in choice]
    if len(singly) + bool(ranged) > 1:
        allowed = Message("refused.diameters_one_way")
        yield Finding(choice.path, given_keys([*singly, *ranged]), allowed)
    yield from ranges.upside_down(choice, "diameter_min", "diameter_max")
    yield from duplicates(choice, "diameters")


def _clump_weight(choice: FileSection) -> Iterator[Finding]:
    """Find a clump weight without mass or place, or with two."""
    yield from ranges.findings(MASSES, choice, required=True)
    yield from ranges.findings(POSITIONS, choice)
    placed = [key for key in POSITIONS.keys if key in choice]
    if placed and "joint" in choice:
        found = given_keys([*placed, "joint"])
        yield Finding(choice.path, found, Message("refused.positions_or_joint"))
    if choice.lacks(*POSITIONS.keys, "joint"):
        ways = Message("refused.or_a_joint", ways=ranges.wanted(POSITIONS))
        yield choice.missing("positions", ways)


def _design_positions(
    pairs: list[tuple[FileSection, FileSection | None]], weights: list[FileSection]
) -> Iterator[Finding]:
    """Find clump weights that are beyond the end of the longest line at every position."""
    longest = []
    for choice, own in pairs:
        if ranges.is_given(LENGTHS, choice):
            length = max(ranges.read(LENGTHS, choice), default=None)
        else:
            length = own.number("length") if own else None
        if length is None or choice.misspelt(*LENGTHS.keys):
            return
        longest.append(length)
    total = math.fsum(longest)
    for weight in weights:
        positions = ranges.read(POSITIONS, weight)
        if longest and positions and not positions[0] < total:
            key = next(key for key in POSITIONS.keys if key in weight)
            which = "one_below_longest" if key == POSITIONS.many else "below_longest"
            yield weight.wrong(key, Message(f"refused.{which}", length=total))


def _as_the_model_has_it(
    design: FileSection, segments: list[FileSection], weights: list[FileSection]
) -> Iterator[Finding]:
    """Find objectives too few or too many, joints that are not there, and no fixed segment."""
    choices = (
        SegmentChoice((1.0,), optional=part.given.get("optional") is True) for part in segments
    )
    hung = [
        ClumpWeightChoice((1.0,), 1e3, positions=() if joint else (1.0,), joint=joint)
        for joint in (weight.value("joint") for weight in weights)
    ]
    problems = refusals(
        Design,
        segments=tuple(choices),
        clump_weights=tuple(hung),
        objectives=tuple(design.value("objectives") or ("mass", "offset")),
        lines=tuple(design.value("lines") or ()),
        anchor_radii=(1.0,) if ranges.is_given(RADII, design) else (),
        pretensions=(1.0,) if ranges.is_given(PRETENSIONS, design) else (),
    )
    yield from design.refused(_as_given(design, problems))


def _of_a_body(case: FileSection, design: FileSection) -> Iterator[Finding]:
    """Find radii given in two ways, and what goes with several lines alone or not with them."""
    yield from ranges.findings(RADII, design)
    yield from ranges.findings(PRETENSIONS, design)
    has_system = "system" in case
    if not has_system and case.misspelt("system"):
        return
    system = case.table("system")
    force = system.value("force") or []
    unclear = not force and not system.lacks("force")
    given = {key: design.value(key) for key in ("lines", "headings", "objectives")}
    given |= {"line_out": design.given.get("line_out") is True}
    given |= {key: key in design for key in ("sinker", "loads")}
    given |= {values.many: ranges.is_given(values, design) for values in (RADII, PRETENSIONS)}
    has_force = bool(unclear or any(force))
    problems = body_misfits(given, has_system=has_system, has_force=has_force)
    yield from case.refused(_as_given(design, problems))


def _as_given(design: FileSection, problems: Iterable[Problem]) -> Iterator[Problem]:
    """Say which key of the file gives what the model has under one name."""
    for problem in problems:
        for values in (RADII, PRETENSIONS):
            if problem.key.endswith(values.many):
                given = next(key for key in values.keys if key in design)
                problem = replace(problem, key=problem.key.replace(values.many, given))
        yield problem


def _excursion(case: FileSection, design: FileSection) -> Iterator[Finding]:
    """Find an excursion that has no reference to count from."""
    objectives, states = design.value("objectives") or [], case.tables("load_cases")
    misread = "load_cases" in case and not states
    count = sum(state.given.get("kind") == "reference" for state in states)
    if "excursion" not in objectives or misread or count == 1 or "system" in case:
        return
    if not case.misspelt("load_cases"):
        path = ("design", "objectives", objectives.index("excursion"))
        key = "refused.references" if count else "refused.no_reference"
        yield Finding(path, '"excursion"', Message(key, found=count))


def joining_findings(case: FileSection) -> list[Finding]:
    """List what does not fit together of the points and lines of a file, as far as they are read.

    Nothing where a name or an end is not: it might be the one that another looks for.
    """
    points, lines = case.tables("points"), case.tables("lines")
    names = [point.value("name") for point in points]
    ends = [(line.value("start"), line.value("end")) for line in lines]
    bodies = [body.value("name") for body in case.tables("bodies")]
    if not points or not lines or None in (*names, *bodies, *itertools.chain(*ends)):
        return []
    joints = [point.value("name") for point in points if point.value("kind") == "joint"]
    tied = [[p.value("name") for p in points if p.value("body") == body] for body in bodies]
    return [*case.refused(network_misfits(names, joints, ends, tied))]
