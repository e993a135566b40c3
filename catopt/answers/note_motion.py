"""Lines in motion, in a note: their tensions, what these come to, and what is to be known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Block,
    Column,
    Fact,
    Facts,
    Figure,
    Points,
    Section,
    Table,
    Text,
    Value,
    Verdict,
    measured,
    texts,
)
from catopt.answers.motion import ENERGIES
from catopt.answers.note import column, note_section
from catopt.answers.note_drive import COUNT, SECONDS, drive_blocks, fixed, significant
from catopt.figures.motion import envelope_chart, exceedance, history, track
from catopt.quantities import QUANTITIES, Quantity
from catopt.units import lasting
from catopt.verify.motion_words import (
    DYNAMIC_QUANTITY_OF,
    dynamic_sentences,
    motion_sentences,
    proof_sentences,
    stopped_sentence,
)
from catopt.words import Listed, Measure, Message, Several, Unit, term

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.notes.line import Note
    from catopt.notes.motion import InMotion, SegmentUse
    from catopt.notes.system import SystemNote
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, OverRuns

_TENSION = QUANTITIES["tension"]
_FACTOR = fixed("-", 3)
_PERCENT = replace(fixed("%", 2), si_unit="-", factor=0.01)
_ENERGY = replace(significant("kJ", 4), si_unit="J", factor=1e3)
_PART = replace(QUANTITIES["residual"], si_unit="-", field_unit="-", digits=1)
_MOST_RUNS = 30


def motion_section(note: Note) -> Iterator[Section]:
    """Lay out the line in motion; nothing where nobody asked for it."""
    if note.motion is not None:
        yield note_section("in_motion", _motion(note, note.motion), "note_motion.heading")


def _motion(note: Note, moved: InMotion) -> Iterator[Block]:
    index = moved.governing
    part, uses, solution = moved.found.parts[index], moved.uses[index], moved.solutions[index]
    yield from _stopped(moved.found)
    about = [Message("note_motion.about")]
    if moved.found.case.load_cases:
        about.append(Message("note_motion.shown", name=part.name))
    yield Text(Several(about, " "))
    yield _verdict(note, moved.used(index), part)
    yield Text(Several(dynamic_sentences(part), " "))
    if len(moved.found.parts) > 1:
        yield _cases(moved)
    yield _statistics(part, solution)
    yield _uses(moved, index)
    yield _outcome(part)
    yield from _extremes(part)
    peaks = exceedance(part)
    if peaks is not None:
        yield Figure(peaks, Message("note_motion.exceedance"))
    drawn = history(part, solution.fairlead.tension)
    yield Figure(drawn, Message("note_motion.history"))
    allowed = [use.capacity for use in uses]
    yield Figure(envelope_chart(part, solution, allowed), Message("note_motion.envelope"))
    known = (*_known(note, moved, part), *part.remarks)
    yield Points(known, Message("note_motion.to_know"))
    yield from drive_blocks(moved)
    yield from _runs(moved, part)


def _stopped(found: DynamicVerification) -> Iterator[Block]:
    if not found.is_complete:
        yield Verdict(stopped_sentence(found), passes=False)


def _verdict(note: Note, used: float | None, part: DynamicPart) -> Verdict:
    largest = Measure("tension", part.max_tension)
    good = part.slack_time == 0.0 and part.verdict == "converged" and (used is None or used <= 1.0)
    if used is None:
        return Verdict(Message("note_motion.no_limit", T=largest), good)
    basis = Message("note_motion.by_checks")
    if not _is_checked(note):
        basis = Message("note_motion.by_mbl", factor=f"{note.solution.safety_factor:g}")
    key = "note_motion.within" if used <= 1.0 else "note_motion.beyond"
    return Verdict(Message(key, T=largest, used=f"{used:.3f}", basis=basis), good)


def _is_checked(note: Note) -> bool:
    return any(check.kind == "tension" for check in note.checks.results)


# ------------------------------------------------------------------ statistics


def _rest(solution: Solution) -> dict[str, float]:
    """Give each quantity of the statistics its value at rest, in closed form."""
    return {
        "fairlead_tension": solution.fairlead.tension,
        "anchor_tension": solution.anchor.tension,
        "grounded_length": solution.grounded_length,
        "offset": 0.0,
    }


def _statistics(part: DynamicPart, solution: Solution) -> Table:
    rest, every = _rest(solution), part.quantities
    units = tuple(DYNAMIC_QUANTITY_OF[each.quantity] for each in every)
    changes = [part.change_of(each.quantity) for each in every]
    still = [rest[each.quantity] for each in every]
    return Table(
        "motion_statistics",
        (
            column("columns.quantity", map(_label, units)),
            *_numbers(part, every, still, units),
            column("note_motion.change", changes, _PERCENT),
        ),
        Message("note_motion.statistics"),
        only="not csv",
    )


def _numbers(
    part: DynamicPart,
    every: Sequence[OverRuns],
    rest: Sequence[float] | None,
    units: tuple[Quantity, ...],
) -> Iterator[Column]:
    """Yield the columns of statistics; all of one quantity where one is given."""
    listed: list[tuple[Message, list[float | None]]] = [
        (Message("note_motion.mean"), [each.mean for each in every]),
        (Message("note_motion.std"), [each.std for each in every]),
        (Message("note_motion.min"), [each.minimum for each in every]),
        (Message("note_motion.max"), [each.maximum for each in every]),
    ]
    if rest is not None:
        listed.insert(0, (Message("note_motion.rest"), list(rest)))
        probable = Message("note_motion.most_probable", time=lasting(part.duration_of_interest))
        listed.append((probable, [each.most_probable_maximum for each in every]))
    for name, values in listed:
        if len(units) == 1:
            yield Column(name, tuple(values), replace(units[0], symbol=""))
        else:
            yield Column(name, tuple(values), units=units)


def _label(quantity: Quantity) -> str:
    name = term(quantity.name)
    if not quantity.symbol:
        return name
    return Message("words.label", name=name, symbol=quantity.symbol)


def _cases(moved: InMotion) -> Table:
    parts = moved.found.parts
    every = [part.of("fairlead_tension") for part in parts]
    rest = [solution.fairlead.tension for solution in moved.solutions]
    return Table(
        "motion_cases",
        (
            texts("load_case", (part.name for part in parts)),
            *_numbers(parts[0], every, rest, (_TENSION,)),
            _changes(parts),
            column("note_motion.amplification", (part.amplification for part in parts), _FACTOR),
            measured("utilisation", (moved.used(index) for index in range(len(parts)))),
        ),
        Message("note_motion.cases", unit=Unit(_TENSION)),
        marked=moved.governing,
        only="not csv",
    )


def _changes(parts: Sequence[DynamicPart]) -> Column:
    changes = (part.change_of("fairlead_tension") for part in parts)
    return column("note_motion.change", changes, _PERCENT)


def _uses(moved: InMotion, shown: int) -> Table:
    """Tabulate what each segment carries; people see the load case that governs."""
    rows = [
        (index, part.name, use)
        for index, (part, uses) in enumerate(zip(moved.found.parts, moved.uses, strict=True))
        for use in uses
    ]
    uses = [use for _, _, use in rows]
    largest = measured("tension", (use.largest for use in uses), "largest_tension", symbol="")
    allowed = replace(
        measured("tension", (use.capacity for use in uses), symbol=""),
        name=Message("note.workbook_allowed"),
    )
    rest = measured("tension", (use.at_rest for use in uses), symbol="")
    used = measured("utilisation", (use.utilisation for use in uses))
    return Table(
        "motion_use",
        (
            texts("load_case", (name for _, name, _ in rows), only="files"),
            texts("segment", (use.number for use in uses)),
            texts("name", (use.name for use in uses)),
            largest,
            replace(rest, name=Message("note_motion.rest")),
            allowed,
            replace(used, formula=(largest, "/", allowed)),
            _passes(uses),
        ),
        Message("note_motion.uses"),
        tuple(row for row, (index, _, _) in enumerate(rows) if index == shown),
        only="not csv",
    )


def _passes(uses: Sequence[SegmentUse]) -> Column:
    passes = tuple(None if use.utilisation is None else use.utilisation <= 1.0 for use in uses)
    words = (
        None if each is None else Message("answers.passes" if each else "answers.fails")
        for each in passes
    )
    return Column(Message("columns.verdict"), tuple(words), passes=passes)


# ------------------------------------------------------------------ what it comes to


def _outcome(part: DynamicPart) -> Facts:
    slack, balance = fixed("s", 2), part.governing.history.balance
    tension = replace(_TENSION, symbol="")
    listed: list[tuple[str, Value, Quantity]] = [
        ("anywhere", part.max_tension, tension),
        ("still_max", part.quasi_static_max, tension),
        ("amplification", part.amplification, _FACTOR),
        ("slack_time", part.slack_time, slack),
        ("longest_slack", part.longest_slack, slack),
    ]
    facts = (
        *(Fact(Message(f"note_motion.{key}"), value, of) for key, value, of in listed),
        *(
            Fact(Message("note_motion.energy", what=term(name)), getattr(balance, energy), _ENERGY)
            for name, energy in ENERGIES.items()
        ),
        Fact(Message("note_motion.energy_part"), balance.numerical_part, replace(_PART, symbol="")),
    )
    return Facts("motion_outcome", facts, Message("note_motion.outcome"), only="not csv")


def _extremes(part: DynamicPart) -> Iterator[Table]:
    """List what extremes are and what they rest on, a column each random quantity."""
    every = [each for each in part.quantities if each.tail is not None]
    if not every:
        return
    found = [_extreme(each) for each in every]
    columns = [
        Column(
            _label(DYNAMIC_QUANTITY_OF[each.quantity]),
            tuple(of[key][0] for key in found[0]),
            units=tuple(of[key][1] for key in found[0]),
        )
        for each, of in zip(every, found, strict=True)
    ]
    names = (Message(f"note_motion.{key}") for key in found[0])
    caption = Message("note_motion.extremes", time=lasting(part.duration_of_interest))
    yield Table(
        "motion_extremes",
        (texts("what", names), *columns),
        caption,
        only="not csv",
    )


def _extreme(each: OverRuns) -> dict[str, tuple[float, Quantity]]:
    quantity, tail, runs = DYNAMIC_QUANTITY_OF[each.quantity], each.tail, each.gumbel
    assert tail is not None
    found = {
        "probable": (tail.extreme.most_probable, quantity),
        "interval_from": (tail.extreme.low, quantity),
        "interval_to": (tail.extreme.high, quantity),
        "expected": (tail.extreme.expected, quantity),
        "threshold": (tail.threshold, quantity),
        "peaks_above": (len(tail.clusters), COUNT),
        "weibull_scale": (tail.scale, quantity),
        "weibull_shape": (tail.shape, _FACTOR),
    }
    if runs is None:
        return found
    return found | {
        "by_gumbel": (runs.extreme.most_probable, quantity),
        "gumbel_from": (runs.extreme.low, quantity),
        "gumbel_to": (runs.extreme.high, quantity),
    }


def _runs(moved: InMotion, part: DynamicPart) -> Iterator[Block]:
    waves, every = moved.found.case.waves, part.runs
    found = [run.statistics("fairlead_tension") for run in every]
    seeds = [
        f"({waves.seed}, {run.number})" if part.is_random and waves is not None else "-"
        for run in every
    ]
    tension = replace(_TENSION, symbol="")
    histories = [run.history for run in every]
    slack = (each.line_slack_time() for each in histories)
    yield Table(
        "motion_runs",
        (
            texts("run", (run.number + 1 for run in every)),
            texts("seed", seeds),
            column("columns.largest_fairlead_tension", (each.maximum for each in found), tension),
            column("columns.at", (each.time_of_maximum for each in found), fixed("s", 2)),
            column(
                "columns.largest_quasi_static_fairlead_tension",
                (run.quasi_static_max for run in every),
                tension,
            ),
            column("columns.slack_in_all", slack, fixed("s", 2)),
            texts("steps", (each.steps for each in histories)),
            texts("halvings", (each.halvings for each in histories)),
        ),
        Message("note_motion.run_table"),
        tuple(range(min(len(every), _MOST_RUNS))),
        every.index(part.governing),
        only="not csv",
    )
    if len(every) > _MOST_RUNS:
        yield Text(Message("note_motion.left_out", count=len(every) - _MOST_RUNS), is_small=True)


# ------------------------------------------------------------------ what is to be known


def _known(note: Note, moved: InMotion, part: DynamicPart) -> Iterator[Message]:
    """Yield what an engineer must know of the figures: what they are of, what they leave out."""
    yield Message(
        "note_motion.transient",
        ramp=f"{moved.drive.ramp:g}",
        since=f"{part.runs[0].history.since:g}",
        end=f"{moved.drive.dynamics.duration:g}",
    )
    if part.is_random:
        peaks = sum(run.statistics("fairlead_tension").peaks for run in part.runs)
        if len(part.runs) == 1:
            yield Message("note_motion.one_seed", peaks=peaks)
        else:
            yield Message("note_motion.several_seeds", runs=len(part.runs), peaks=peaks)
        yield Message("note_motion.in_duration", duration=lasting(part.duration_of_interest))
    else:
        yield Message("note_motion.not_random")
    if moved.codes:
        yield Message("note_motion.allowed_dynamic", codes=Listed(moved.codes, "and"))
    elif _is_checked(note):
        yield Message("note_motion.allowed_at_rest")
    else:
        factor = f"{note.solution.safety_factor:g}"
        yield Message("note_motion.allowed_by_mbl", factor=factor)
    yield Message("note_motion.led")
    yield Message("note_motion.ends")
    yield Message("note_motion.grounded")


# ------------------------------------------------------------------ a body's lines


def body_motion_section(note: SystemNote) -> Iterator[Section]:
    """Lay out all lines of a body in motion; nothing where nobody asked for it."""
    if note.motion is not None:
        blocks = _body_motion(note, note.motion)
        yield note_section("system_motion", blocks, "note_system.motion_heading")


def _body_motion(note: SystemNote, found: DynamicVerification) -> Iterator[Block]:
    governing = found.governing
    assert governing.line is not None
    yield from _stopped(found)
    yield Text(Message("note_system.motion_about"))
    yield Verdict(Several(_said(found), " "), found.verdict == "converged")
    yield _lines(note, found)
    units = tuple(DYNAMIC_QUANTITY_OF[each.quantity] for each in found.body)
    yield Table(
        "system_motion_body",
        (
            column("columns.quantity", map(_label, units)),
            *_numbers(governing, found.body, None, units),
        ),
        Message("note_motion.body"),
        only="not csv",
    )
    yield Figure(track(found), Message("note_system.motion_track"))
    at_rest = note.solution.lines[governing.line - 1].tension
    caption = Message("note_system.motion_history", line=governing.line)
    yield Figure(history(governing, at_rest), caption)
    remarks = dict.fromkeys(each for part in found.parts for each in part.remarks)
    yield Points((Message("note_motion.ends"), *remarks), Message("note_motion.to_know"))


def _said(found: DynamicVerification) -> Iterator[Message]:
    """Yield what is said of the governing line, and of the one that is proven least."""
    for part, sentences in (
        (found.governing, motion_sentences(found.governing)),
        (found.least_proven, proof_sentences(found.least_proven)),
    ):
        for sentence in sentences:
            yield Message("note_motion.of_line", number=part.line, said=sentence)


def _lines(note: SystemNote, found: DynamicVerification) -> Table:
    """Tabulate the fairlead tension of every line, the governing one marked."""
    parts = found.parts
    every = [part.of("fairlead_tension") for part in parts]
    rest = [line.tension for line in note.solution.lines]
    still = (part.quasi_static_max for part in parts)
    return Table(
        "system_motion_lines",
        (
            texts("line", (part.line for part in parts)),
            *_numbers(parts[0], every, rest, (_TENSION,)),
            _changes(parts),
            column("columns.quasi_static_fairlead_tension", still, replace(_TENSION, symbol="")),
            column("note_motion.amplification", (part.amplification for part in parts), _FACTOR),
            column("columns.slack_in_all", (part.slack_time for part in parts), SECONDS),
        ),
        Message("note_motion.lines", unit=Unit(_TENSION)),
        marked=parts.index(found.governing),
        only="not csv",
    )
