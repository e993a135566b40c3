"""Title block of a moored body: what is calculated, and what decides."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from catopt.answers.check import verdict_sentence
from catopt.notes.rounding import heading_of
from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES
from catopt.render.texts import Phrase, Words
from catopt.report.page.identity import made_from, title_block
from catopt.report.page.table import Cell
from catopt.report.wording.names import METHODS
from catopt.ties import first_largest

__all__ = ["deciding", "force_words", "identity"]


def identity(note: SystemNote, words: Words) -> dict[str, Any]:
    """Build the title block."""
    system = note.solution.system
    moment = QUANTITIES["moment"].format(system.moment, unit=True) if system.turns else ""
    freedom = "system_identity.turns" if system.turns else "system_identity.held"
    rows = [
        ("identity.source", Cell(note.case.source)),
        ("identity.date", Cell(note.origin.date)),
        ("system_identity.lines", Cell(str(len(system.legs)))),
        ("system_identity.freedom", Cell(words(freedom))),
        ("system_identity.force", Cell(force_words(note, words))),
        ("system_identity.moment", Cell(moment)),
        ("identity.method", Cell(words.name(METHODS["closed-form"]))),
        *made_from(note.origin),
    ]
    return {"table": title_block(rows, words), "verdicts": list(deciding(note, words))}


def force_words(note: SystemNote, words: Words) -> str:
    """Say how large the force is and where it acts to: ``"4281.000 kN towards 180.00 deg"``."""
    force = note.solution.system.force
    size = QUANTITIES["horizontal_force"].format(math.hypot(*force), unit=True)
    if not any(force):
        return size
    towards = QUANTITIES["angle"].format(heading_of(*force), unit=True)
    return words("system_identity.towards", force=size, angle=towards)


def deciding(note: SystemNote, words: Words) -> Iterator[tuple[Phrase, str]]:
    """Yield what decides, each with the class that it is shown in.

    Checks where the case asks for some, how far the most loaded line is used, where the body goes,
    and what comes of it when a line is gone.
    """
    if note.checks.results:
        said = words.sentence(verdict_sentence(note.checks))
        yield said, "passes" if note.checks.passes else "fails"
    yield Phrase(_intact(note, words)), _style(_largest(note))
    yield Phrase(_offset(note, words)), ""
    yield from _one_out(note, words)


def _largest(note: SystemNote) -> float | None:
    """Find how far the strongest used line is used; None where no breaking load is known."""
    solution = note.solution
    used = [line.utilisation(solution.safety_factor) for line in solution.lines]
    return max((each for each in used if each is not None), default=None)


def _style(used: float | None) -> str:
    return "fails" if used is not None and used > 1.0 else ""


def _intact(note: SystemNote, words: Words) -> str:
    told = words(
        "system_identity.loaded",
        line=note.solution.most_loaded + 1,
        tension=QUANTITIES["tension"].format(note.loaded.tension, unit=True),
    )
    return f"{told} {_used(note, _largest(note), words)}".rstrip()


def _used(note: SystemNote, used: float | None, words: Words) -> str:
    if used is None:
        return ""
    factor = QUANTITIES["safety_factor"].format(note.solution.safety_factor)
    return words("system_identity.used", used=QUANTITIES["utilisation"].format(used), factor=factor)


def _offset(note: SystemNote, words: Words) -> str:
    x, y = note.solution.offset
    distance = QUANTITIES["offset"].format(math.hypot(x, y), unit=True)
    if math.hypot(x, y) == 0.0 or not any(note.solution.system.force):
        return words("system_identity.stays", offset=distance)
    angle = QUANTITIES["angle"].format(heading_of(x, y), unit=True)
    return words("system_identity.goes", offset=distance, angle=angle)


def _one_out(note: SystemNote, words: Words) -> Iterator[tuple[Phrase, str]]:
    """Say what the worst missing line does, and which lines the body cannot do without."""
    for each in note.report.line_out:
        if each.response is None:
            said = words("system_line_out.refused", line=each.missing + 1)
            yield Phrase(f"{said}."), "fails"
    there = [each for each in note.report.line_out if each.response is not None]
    if not there:
        return
    responses = [each.response for each in there if each.response is not None]
    hardest = first_largest([each.largest_tension for each in responses])
    farthest = first_largest([each.offset for each in responses])
    used = max((each for each in note.left if each is not None), default=None)
    told = words(
        "system_identity.one_out",
        tension=QUANTITIES["tension"].format(responses[hardest].largest_tension, unit=True),
        line=responses[hardest].most_loaded + 1,
        missing=there[hardest].missing + 1,
        offset=QUANTITIES["offset"].format(responses[farthest].offset, unit=True),
        farthest=there[farthest].missing + 1,
    )
    yield Phrase(f"{told} {_used(note, used, words)}".rstrip()), _style(used)
