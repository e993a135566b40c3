"""The loads of each load case: every force with its formula, its numbers put in and its source."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES
from catopt.render.texts import Phrase, Words
from catopt.report.page.sizing.load_case import load_case_words
from catopt.report.page.sizing.put_in import put_in, typeset_formula, typeset_unit
from catopt.report.page.table import Cell, Heading, Table, measured
from catopt.ties import first_largest

if TYPE_CHECKING:
    from catopt.loads.component import LoadComponent, Loads, Number
    from catopt.sizing.posed import LoadsAt

__all__ = ["ForceRow", "Part", "PutIn", "forces", "loads", "sums", "what_is_pushed"]

FORCE = QUANTITIES["horizontal_force"]


@dataclass(frozen=True)
class PutIn:
    """A number of a formula: how it is written, its value in SI, and what it is."""

    text: str
    si: float
    meaning: Phrase


@dataclass(frozen=True)
class ForceRow:
    """One force.

    Attributes
    ----------
    name, note : Phrase
        What pushes on what, and what else to know.
    formula, put_in : str
        In symbols, and with the numbers; the latter is empty where the formula is no product.
    numbers : tuple of PutIn
        What was put in.
    force : Cell
        Along the pull on the mooring.
    source, confidence : str
        Of the formula and its coefficients.
    """

    name: Phrase
    note: Phrase
    formula: str
    put_in: str
    numbers: tuple[PutIn, ...]
    force: Cell
    source: str
    confidence: str


@dataclass(frozen=True)
class Part:
    """The forces on the ship or on the buoy in a load case, and their sum."""

    caption: str
    rows: tuple[ForceRow, ...]
    adding: str
    total: Cell
    assumptions: tuple[Phrase, ...]


def loads(note: SizeNote, words: Words) -> dict[str, Any]:
    """Build the table of sums, and for each load case those of its forces."""
    sizing = note.sizing
    cases = sizing.settled.posed.loads
    assumed = sizing.settled.assumed
    common = _common(cases)
    computed_for = (
        words(
            "size_loads.assumed",
            diameter=QUANTITIES["nominal_diameter"].format(assumed.diameter, unit=True),
            pull=FORCE.format(assumed.pull, unit=True),
            rounds=sizing.settled.rounds,
        )
        if assumed.diameter and any(each.parts for each in cases)
        else ""
    )
    return {
        "sums": sums(note, words),
        "assumed": computed_for,
        "parts": [_part(each, part, words, common) for each in cases for part in each.parts],
        "common": [words.sentence(text) for text in common],
        "force": f"{words.name(FORCE.name)} ({FORCE.field_unit})",
        "shared": sizing.pattern is not None,
    }


def _common(cases: Sequence[LoadsAt]) -> list[str]:
    """List what is assumed in every load case: it is said once."""
    assumed = [[text for part in each.parts for text in part.assumptions] for each in cases]
    first = dict.fromkeys(assumed[0])
    return [text for text in first if all(text in texts for texts in assumed)]


def what_is_pushed(note: SizeNote, words: Words) -> list[str]:
    """Name the bodies that the parts of the loads are on: the ship, the buoy."""
    names = [words("size_loads.on_buoy")]
    if note.sizing.kind == "tanker":
        names.insert(0, words("size_loads.on_ship"))
    return names[: len(note.sizing.settled.posed.loads[0].parts)]


def sums(note: SizeNote, words: Words) -> Table:
    """Tabulate the sum of each load case, and what of it one of several lines is sized for."""
    sizing = note.sizing
    cases = sizing.settled.posed.loads
    pushed = what_is_pushed(note, words)
    has_given = any(each.given for each in cases)
    is_shared = sizing.pattern is not None
    unit = FORCE.field_unit
    headings = [
        Heading(words("identity.load_case")),
        Heading(f"{words('size_loads.depth')} (m)", is_number=True),
        *(Heading(f"{name} ({unit})", is_number=True) for name in pushed),
        *([Heading(f"{words('size_loads.given')} ({unit})", is_number=True)] if has_given else []),
        Heading(f"{words('size_loads.sum')} ({unit})", is_number=True),
        *([Heading(f"{words('size_loads.line')} ({unit})", is_number=True)] if is_shared else []),
    ]
    forces = {state.name: state.horizontal_force for state in sizing.settled.posed.case.load_cases}
    rows = tuple(
        (
            Cell(load_case_words(each.load_case, words)),
            measured(QUANTITIES["water_depth"], each.depth),
            *(measured(FORCE, part.horizontal_force) for part in each.parts),
            *((measured(FORCE, each.given),) if has_given else ()),
            measured(FORCE, each.horizontal_force),
            *((measured(FORCE, forces[each.load_case]),) if is_shared else ()),
        )
        for each in cases
    )
    hardest = first_largest([each.horizontal_force for each in cases])
    return Table("size_sums", tuple(headings), rows, words("size_loads.sums"), hardest)


def _part(at: LoadsAt, of: Loads, words: Words, common: Sequence[str]) -> Part:
    rows = tuple(_row(component, force, words) for component, force in forces(of))
    title = words.sentence(of.title).text
    return Part(
        caption=words(
            "size_loads.under", load_case=load_case_words(at.load_case, words), title=title
        ),
        rows=rows,
        adding=" + ".join(FORCE.format(force) for _, force in forces(of)),
        total=measured(FORCE, of.horizontal_force),
        assumptions=tuple(words.sentence(each) for each in of.assumptions if each not in common),
    )


def forces(of: Loads) -> list[tuple[LoadComponent, float]]:
    """List each force with its size along the pull of all, N: against it, negative.

    Wind, current and waves of a sizing come from one side, so that all act along one axis.
    """
    surge, along = of.along("surge"), of.along("along")
    signs = {"surge": math.copysign(1.0, surge), "along": math.copysign(1.0, along), "sway": 1.0}
    return [(each, signs[each.axis] * each.force) for each in of.components]


def _row(of: LoadComponent, force: float, words: Words) -> ForceRow:
    return ForceRow(
        name=words.sentence(of.name),
        note=_note(of.note, words),
        formula=typeset_formula(of.formula),
        put_in=put_in(of.formula, of.numbers),
        numbers=tuple(_number(each, words) for each in of.numbers),
        force=measured(FORCE, force),
        source=f"{of.source.document}, {of.source.clause}",
        confidence=of.source.confidence,
    )


def _note(text: str, words: Words) -> Phrase:
    """Say what else to know of a force."""
    return words.sentence(text)


def _number(of: Number, words: Words) -> PutIn:
    value = f"{of.value:.9g} {typeset_unit(of.unit)}".rstrip()
    return PutIn(f"{typeset_formula(of.symbol)} = {value}", of.value, words.sentence(of.meaning))
