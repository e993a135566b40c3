"""What must hold between the keys of ``[design]``, and between them and the line."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

from catopt.casefile import ranges
from catopt.casefile.components import SIZES
from catopt.casefile.consistency import sinks_findings
from catopt.casefile.document import Section, refusals
from catopt.casefile.location import Finding
from catopt.casefile.schema import LENGTHS, MASSES, POSITIONS, PRETENSIONS, RADII
from catopt.errors import Problem
from catopt.model import ClumpWeightChoice, Design, SegmentChoice
from catopt.model.design import body_misfits
from catopt.words import Message

_COMPONENTS = ("components", "component")


def design_findings(case: Section) -> list[Finding]:
    """List what contradicts itself in the design of a document."""
    design, line = case.table("design"), _Line(case.table("line"))
    if not design.given:
        return []
    segments, weights = design.tables("segments"), design.tables("clump_weights")
    sinker = design.table("sinker")
    return [
        *(f for index, each in enumerate(segments) for f in _segment(each, index, line)),
        *(f for weight in weights for f in _clump_weight(weight)),
        *_positions(segments, weights, line),
        *(ranges.findings(MASSES, sinker, required=True) if sinker.given else ()),
        *(sinks_findings(case, sinker) if sinker.given else ()),
        *(_as_the_model_has_it(design, segments, weights) if segments else ()),
        *_excursion(case, design),
        *_of_a_body(case, design),
    ]


class _Line:
    """What the segments of a design may take over from the line."""

    def __init__(self, line: Section) -> None:
        self.segments = line.tables("segments")
        self.is_clear = bool(self.segments) and not line.misspelt("segments")

    def at(self, index: int) -> Section | None:
        """Return the segment at a place, counted from 0; None when there is none."""
        return self.segments[index] if index < len(self.segments) else None

    def lacks(self, index: int) -> bool:
        """Whether there is certainly no segment at a place."""
        return self.is_clear and self.at(index) is None


def _segment(choice: Section, index: int, line: _Line) -> Iterator[Finding]:
    """Find what is given in two ways, and what the line has not got to be taken over."""
    yield from ranges.findings(LENGTHS, choice)
    if all(key in choice for key in _COMPONENTS):
        allowed = Message("refused.only_one")
        yield Finding(
            choice.path,
            Message("refused_file.two_keys", one="component", other="components"),
            allowed,
        )
    yield from _sizes(choice)
    nothing = Message("refused.no_such_segment", number=index + 1)
    if line.lacks(index) and choice.lacks(*LENGTHS.keys):
        yield choice.missing("lengths", nothing)
    if not choice.lacks(*_COMPONENTS):
        return
    own = line.at(index)
    if line.lacks(index):
        yield choice.missing("components", nothing)
    elif any(key in choice for key in SIZES) and line.is_clear and own and own.lacks("component"):
        why = Message("refused.segment_without_component", number=index + 1)
        yield choice.missing("components", why)


def _sizes(choice: Section) -> Iterator[Finding]:
    """Find diameters given in two ways, twice, or as a range that is none."""
    ranged = [key for key in ("diameter_min", "diameter_max") if key in choice]
    singly = [key for key in ("diameter", "diameters") if key in choice]
    if len(singly) + bool(ranged) > 1:
        allowed = Message("refused.diameters_one_way")
        yield Finding(choice.path, " and ".join([*singly, *ranged]), allowed)
    yield from ranges.upside_down(choice, "diameter_min", "diameter_max")
    yield from ranges.duplicates(choice, "diameters")


def _clump_weight(choice: Section) -> Iterator[Finding]:
    """Find a clump weight without mass or place, or with two."""
    yield from ranges.findings(MASSES, choice, required=True)
    yield from ranges.findings(POSITIONS, choice)
    placed = [key for key in POSITIONS.keys if key in choice]
    if placed and "joint" in choice:
        found = " and ".join([*placed, "joint"])
        yield Finding(choice.path, found, Message("refused.positions_or_joint"))
    if choice.lacks(*POSITIONS.keys, "joint"):
        ways = Message("refused.or_a_joint", ways=ranges.wanted(POSITIONS))
        yield choice.missing("positions", ways)


def _positions(segments: list[Section], weights: list[Section], line: _Line) -> Iterator[Finding]:
    """Find clump weights that are beyond the end of the longest line at every position."""
    longest = []
    for index, choice in enumerate(segments):
        own = line.at(index)
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
    design: Section, segments: list[Section], weights: list[Section]
) -> Iterator[Finding]:
    """Find objectives too few or too many, joints that are not there, and no fixed segment."""
    choices = [
        SegmentChoice((1.0,), optional=each.given.get("optional") is True) for each in segments
    ]
    hung = []
    for weight in weights:
        joint = weight.value("joint")
        positions = () if joint else (1.0,)
        hung.append(ClumpWeightChoice((1.0,), 1.0, positions=positions, joint=joint))
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


def _of_a_body(case: Section, design: Section) -> Iterator[Finding]:
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
    given |= {each.many: ranges.is_given(each, design) for each in (RADII, PRETENSIONS)}
    has_force = bool(unclear or any(force))
    problems = body_misfits(given, has_system=has_system, has_force=has_force)
    yield from case.refused(_as_given(design, problems))


def _as_given(design: Section, problems: Iterable[Problem]) -> Iterator[Problem]:
    """Say which key of the file gives what the model has under one name."""
    for problem in problems:
        for values in (RADII, PRETENSIONS):
            if problem.key.endswith(values.many):
                given = next(key for key in values.keys if key in design)
                problem = replace(problem, key=problem.key.replace(values.many, given))
        yield problem


def _excursion(case: Section, design: Section) -> Iterator[Finding]:
    """Find an excursion that has no reference to count from."""
    objectives, states = design.value("objectives") or [], case.tables("load_cases")
    misread = "load_cases" in case and not states
    count = sum(state.given.get("kind") == "reference" for state in states)
    if "excursion" not in objectives or misread or count == 1 or "system" in case:
        return
    if not case.misspelt("load_cases"):
        path = ("design", "objectives", objectives.index("excursion"))
        key = "refused.references" if count else "refused.no_reference"
        allowed = Message(key, found=count)
        yield Finding(path, '"excursion"', allowed)
