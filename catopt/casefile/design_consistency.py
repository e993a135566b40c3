"""What must hold between the keys of ``[design]``, and between them and the line."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from catopt.casefile import ranges
from catopt.casefile.components import SIZES
from catopt.casefile.consistency import sinks_findings
from catopt.casefile.document import (
    Place,
    as_in_file,
    misspelt,
    number,
    refusals,
    table,
    tables,
    value,
)
from catopt.casefile.location import Finding, parts
from catopt.casefile.ranges import duplicates
from catopt.casefile.schema import (
    LENGTHS,
    MASSES,
    POSITIONS,
    PRETENSIONS,
    RADII,
    CaseTable,
    ClumpWeightChoiceTable,
    DesignTable,
    LineTable,
    SegmentChoiceTable,
    SegmentTable,
    SinkerChoiceTable,
    SystemTable,
)
from catopt.documents import Path
from catopt.model import ClumpWeightChoice, Design, SegmentChoice
from catopt.model.design import body_misfits
from catopt.units import as_written

_COMPONENTS = ("components", "component")


def design_findings(document: dict[str, Any]) -> list[Finding]:
    """List what contradicts itself in the design of a document."""
    design = table(document, "design")
    if not design:
        return []
    line = _Line(document)
    sinker: Place = (("design", "sinker"), table(design, "sinker"))
    segments = tables(design, "design", "segments")
    weights = tables(design, "design", "clump_weights")
    return [
        *(f for index, place in enumerate(segments) for f in _segment(place, index, line)),
        *(f for place in weights for f in _clump_weight(place)),
        *_positions(segments, weights, line),
        *(_sinker(document, sinker) if sinker[1] else ()),
        *_as_the_model_has_it(document, segments, weights),
        *_excursion(document),
        *_of_a_body(document),
    ]


class _Line:
    """What the segments of a design may take over from the line."""

    def __init__(self, document: dict[str, Any]) -> None:
        line = table(document, "line")
        self.segments = [segment for _, segment in tables(line, "line", "segments")]
        self.is_clear = bool(self.segments) and not misspelt(LineTable, ["segments"], line)

    def at(self, index: int) -> dict[str, Any] | None:
        """Return the segment at a place, counted from 0; None when there is none."""
        return self.segments[index] if index < len(self.segments) else None

    def lacks(self, index: int) -> bool:
        """Whether there is certainly no segment at a place."""
        return self.is_clear and self.at(index) is None

    def length(self, index: int) -> float | None:
        """Return the length of the segment at a place; None when it is not clear."""
        return number(SegmentTable, "length", self.at(index) or {})


def _segment(place: Place, index: int, line: _Line) -> Iterator[Finding]:
    """Find what is given in two ways, and what the line has not got to be taken over."""
    path, given = place
    yield from ranges.findings(LENGTHS, SegmentChoiceTable, place)
    if all(key in given for key in _COMPONENTS):
        yield Finding(path, "component and components", "only one of them is wanted")
    yield from _sizes(place)
    nothing = f"missing; the line has no segment {index + 1} to take it from"
    unclear = ranges.is_given(LENGTHS, given) or misspelt(SegmentChoiceTable, LENGTHS.keys, given)
    if line.lacks(index) and not unclear:
        yield Finding((*path, "lengths"), "", nothing)
    named = any(key in given for key in _COMPONENTS)
    if named or misspelt(SegmentChoiceTable, _COMPONENTS, given):
        return
    if line.lacks(index):
        yield Finding((*path, "components"), "", nothing)
    elif any(key in given for key in SIZES) and line.is_clear:
        own = line.at(index) or {}
        if "component" not in own and not misspelt(SegmentTable, ["component"], own):
            why = f"missing; diameters are of a component, and segment {index + 1} of the line"
            yield Finding((*path, "components"), "", f"{why} has none")


def _sizes(place: Place) -> Iterator[Finding]:
    """Find diameters given in two ways, twice, or as a range that is none."""
    path, given = place
    ranged = [key for key in ("diameter_min", "diameter_max") if key in given]
    singly = [key for key in ("diameter", "diameters") if key in given]
    if len(singly) + bool(ranged) > 1:
        wanted = "diameters, diameter, or diameter_min and diameter_max"
        yield Finding(path, " and ".join([*singly, *ranged]), f"only one way is wanted: {wanted}")
    low, high = (number(SegmentChoiceTable, f"diameter_{end}", given) for end in ("min", "max"))
    if low is not None and high is not None and high < low:
        shown = as_written(given["diameter_min"]).strip('"')
        allowed = f"must be diameter_min or more, which is {shown}"
        yield Finding((*path, "diameter_max"), as_written(given["diameter_max"]), allowed)
    yield from duplicates(SegmentChoiceTable, place, "diameters")


def _clump_weight(place: Place) -> Iterator[Finding]:
    """Find a clump weight without mass or place, or with two."""
    path, given = place
    yield from ranges.findings(MASSES, ClumpWeightChoiceTable, place, required=True)
    yield from ranges.findings(POSITIONS, ClumpWeightChoiceTable, place)
    placed = [key for key in POSITIONS.keys if key in given]
    if placed and "joint" in given:
        found = " and ".join([*placed, "joint"])
        yield Finding(path, found, "it hangs either at positions or at a joint")
    misread = misspelt(ClumpWeightChoiceTable, [*POSITIONS.keys, "joint"], given)
    if not placed and "joint" not in given and not misread:
        wanted = f"missing; {ranges.wanted(POSITIONS)}, or a joint is wanted"
        yield Finding((*path, "positions"), "", wanted)


def _positions(segments: list[Place], weights: list[Place], line: _Line) -> Iterator[Finding]:
    """Find clump weights that are beyond the end of the longest line at every position."""
    longest = []
    for index, (_, given) in enumerate(segments):
        if ranges.is_given(LENGTHS, given):
            length = max(ranges.read(LENGTHS, SegmentChoiceTable, given), default=None)
        else:
            length = line.length(index)
        if length is None or misspelt(SegmentChoiceTable, LENGTHS.keys, given):
            return
        longest.append(length)
    total = math.fsum(longest)
    for path, given in weights:
        positions = ranges.read(POSITIONS, ClumpWeightChoiceTable, given)
        if longest and positions and not positions[0] < total:
            key = next(key for key in POSITIONS.keys if key in given)
            which = "one of them " if key == POSITIONS.many else ""
            allowed = f"{which}must be below {total:g} m, the length of the longest line"
            yield Finding((*path, key), as_written(given[key]), allowed)


def _sinker(document: dict[str, Any], place: Place) -> Iterator[Finding]:
    yield from ranges.findings(MASSES, SinkerChoiceTable, place, required=True)
    yield from sinks_findings(document, SinkerChoiceTable, place)


def _as_the_model_has_it(
    document: dict[str, Any], segments: list[Place], weights: list[Place]
) -> Iterator[Finding]:
    """Find objectives too few or too many, joints that are not there, and no fixed segment."""
    design = table(document, "design")
    if not segments:
        return
    objectives = value(DesignTable, "objectives", design)
    joints = [value(ClumpWeightChoiceTable, "joint", given) for _, given in weights]
    problems = refusals(
        Design,
        segments=tuple(
            SegmentChoice((1.0,), optional=s.get("optional") is True) for _, s in segments
        ),
        clump_weights=tuple(
            ClumpWeightChoice((1.0,), 1.0, positions=() if joint else (1.0,), joint=joint)
            for joint in joints
        ),
        objectives=tuple(objectives) if objectives else ("mass", "offset"),
        lines=tuple(value(DesignTable, "lines", design) or ()),
        anchor_radii=(1.0,) if ranges.is_given(RADII, design) else (),
        pretensions=(1.0,) if ranges.is_given(PRETENSIONS, design) else (),
    )
    for problem in problems:
        path = _as_given(("design", *parts(problem.key)), design)
        yield as_in_file(document, Finding(path, problem.found, problem.allowed))


def _of_a_body(document: dict[str, Any]) -> Iterator[Finding]:
    """Find radii given in two ways, and what goes with several lines alone or not with them."""
    design, system = table(document, "design"), table(document, "system")
    yield from ranges.findings(RADII, DesignTable, (("design",), design))
    yield from ranges.findings(PRETENSIONS, DesignTable, (("design",), design))
    has_system = "system" in document
    if not has_system and misspelt(CaseTable, ["system"], document):
        return
    force = value(SystemTable, "force", system) or []
    unclear = not force and ("force" in system or misspelt(SystemTable, ["force"], system))
    given = {key: value(DesignTable, key, design) for key in ("lines", "headings", "objectives")}
    given |= {"line_out": design.get("line_out") is True, "sinker": "sinker" in design}
    given |= {"anchor_radii": ranges.is_given(RADII, design), "loads": "loads" in design}
    given |= {"pretensions": ranges.is_given(PRETENSIONS, design)}
    has_force = bool(unclear or any(force))
    for problem in body_misfits(given, has_system=has_system, has_force=has_force):
        path = _as_given(parts(problem.key), design)
        yield as_in_file(document, Finding(path, problem.found, problem.allowed))


def _as_given(path: Path, design: dict[str, Any]) -> Path:
    """Say which key of the file gives what the model has under one name."""
    for values in (RADII, PRETENSIONS):
        if path[-1] == values.many:
            return ("design", next(key for key in values.keys if key in design))
    return path


def _excursion(document: dict[str, Any]) -> Iterator[Finding]:
    """Find an excursion that has no reference to count from."""
    objectives = value(DesignTable, "objectives", table(document, "design")) or []
    cases = tables(document, "load_cases")
    misread = "load_cases" in document and not cases
    count = sum(state.get("kind") == "reference" for _, state in cases)
    if "excursion" not in objectives or misread or count == 1 or "system" in document:
        return
    if not misspelt(CaseTable, ["load_cases"], document):
        path = ("design", "objectives", objectives.index("excursion"))
        there = f"there are {count}" if count else "there is none"
        allowed = f'counts from the one load case of kind "reference", and {there}'
        yield Finding(path, '"excursion"', allowed)
