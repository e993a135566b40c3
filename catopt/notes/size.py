"""What the note of a sizing is made of: the sizing, and the note of the line that it recommends."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from catopt.casefile import write_case
from catopt.casefile.design_directory import DESIGN_CASE
from catopt.design.document import design_document
from catopt.loads.sinker import DENSITIES, FACTOR_SOURCE, SAFETY_FACTOR
from catopt.loads.source import CALMAR, LoadSource
from catopt.mooring.solve import solve_system
from catopt.notes.directory import Asked, Chosen
from catopt.notes.line import Note, note_of
from catopt.notes.origin import Origin, SourceFile, origin_of
from catopt.notes.sheet import AnyNote, sheet_of
from catopt.sizing.kinds import schema_of
from catopt.words import Cited, Message, term

if TYPE_CHECKING:
    from catopt.loads.sinker import SinkerSize
    from catopt.model import Case
    from catopt.mooring.solution import SystemSolution
    from catopt.notes.sheet import Sheet
    from catopt.sizing import Sizing


@dataclass(frozen=True)
class Given:
    """What a sizing was asked for: by a file, None where there is none, and by options before it.

    `options` are what was typed, or answered on a terminal.
    """

    file: SourceFile | None = None
    options: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, kw_only=True)
class SizeNote(AnyNote):
    """Everything that the page of a sizing shows.

    `line` is the note of the recommended line, `options` are what was typed, and `around` is the
    equilibrium of several lines under the load case that is hardest on one of them.
    """

    case: Case
    sheet: Sheet
    sizing: Sizing
    line: Note
    options: tuple[tuple[str, str], ...] = ()
    around: SystemSolution | None = None

    @property
    def sources(self) -> dict[str, str]:
        """Where friction, safety factor and density of what holds the line are from."""
        sinker, drag = self.sizing.sinker, self.sizing.drag_anchor
        given = term("this note")
        if drag is not None:
            return {"factor": given if drag.factor_source is None else drag.factor_source.text}
        if sinker is None:
            return {}
        is_usual = math.isclose(sinker.safety_factor, SAFETY_FACTOR)
        friction = sinker.friction_source
        return {
            "friction": given if friction is None else Cited(friction.text),
            "factor": Cited(FACTOR_SOURCE.text) if is_usual else given,
            "density": _density_source(sinker),
        }


def size_note(sizing: Sizing, given: Given, asked: Asked | None = None) -> SizeNote:
    """Compute the note of a sizing, by what was asked for, and of its recommended line.

    Raises NoAnswerError and NotConvergedError as `note_of` does.
    """
    asked = asked or Asked()
    # The case of the recommended line, as ``catopt size --save`` writes it.
    text = write_case(sizing.line_case)
    file = SourceFile(DESIGN_CASE, text, hashlib.sha256(text.encode()).hexdigest())
    chosen = Chosen(_front(sizing), sizing.settled.index + 1)
    line = note_of(sizing.case, (file,), asked, chosen)
    origin = Origin((), (), asked.date)
    if given.file is not None:
        origin = origin_of((given.file,), asked.date, schema_of(sizing.kind))
    around = None if sizing.pattern is None else solve_system(sizing.pattern.system)
    fitted, point = _fitted(line), sizing.point
    return SizeNote(
        case=sizing.case,
        sizing=sizing,
        line=fitted,
        origin=origin,
        sheet=sheet_of(sizing.case, point.line, fitted.checks, around, point.anchor),
        options=given.options,
        warnings=tuple(_warnings(sizing, line)),
        around=around,
    )


def _density_source(of: SinkerSize) -> str:
    """Cite where the density of a sinker is from."""
    if not math.isclose(of.density, DENSITIES[of.material]):
        return term("this note")
    if of.material == "steel":
        return Cited(LoadSource(CALMAR, "7.2", "A").text)
    return Message("note_size.own_recalled")


def _fitted(line: Note) -> Note:
    """Fit a line's note into that of its sizing.

    Its load cases, which no user named, are said in every language; and a limit that no document
    has is from this note: of a sizing there is no case file.
    """
    of = line.checks
    names = {state.name: term(state.name) for state in of.load_cases}
    this_note = term("this note")
    results = []
    for each in of.results:
        source = each.source
        if source.confidence is None:
            source = replace(source, document=this_note)
        results.append(replace(each, load_case=names[each.load_case], source=source))
    checks = replace(
        of,
        results=tuple(results),
        solutions=tuple((names[name], solution) for name, solution in of.solutions),
        load_cases=tuple(replace(each, name=names[each.name]) for each in of.load_cases),
    )
    return replace(line, checks=checks, load_case=names.get(line.load_case, line.load_case))


def _front(sizing: Sizing) -> dict[str, Any]:
    """Lay out the front that the recommended line is from.

    The line that the search was given is none of an engineer's: it only has the place of one. Where
    another design than the knee was preferred, the knee's neighbours are none of the line's.
    """
    settled = sizing.settled
    document = design_document(settled.result) | {"present": None}
    if settled.index != settled.result.recommended - 1:
        document |= {"recommended": settled.index, "neighbours": []}
    return document | {"recommendation": sizing.why}


def _warnings(sizing: Sizing, line: Note) -> Iterator[str]:
    """Yield what is to be known of the sizing, then what more there is of its line."""
    yield from sizing.warnings
    known = {_bare(warning) for warning in sizing.warnings}
    for warning in line.warnings:
        if _bare(warning) not in known:
            yield warning


def _bare(warning: str) -> str:
    return warning.rstrip(".").casefold()
