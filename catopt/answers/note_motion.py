"""Lines in motion, in a note: their tensions, what these come to, and what is to be known."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Block, Column, Figure, Table, Text, measured, named, texts
from catopt.answers.motion import ENERGIES
from catopt.answers.note import column, small
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
    from catopt.notes.motion import InMotion
    from catopt.notes.system import SystemNote
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, OverRuns

_TENSION = QUANTITIES["tension"]
_BARE = named("tension", "")
_FACTOR = fixed("-", 3)
_SLACK = fixed("s", 2)
_PERCENT = replace(fixed("%", 2), si_unit="-", factor=0.01)
_ENERGY = replace(significant("kJ", 4), si_unit="J", factor=1e3)
_PART = replace(named("residual", ""), si_unit="-", field_unit="-", digits=1)
_MOST_RUNS = 30


def motion_blocks(note: Note) -> Iterator[Block]:
    """Lay out the line in motion; nothing where nobody asked for it."""
    moved = note.motion
    if moved is None:
        return
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
    yield blocks.Points((*_known(note, moved, part), *part.remarks), Message("note_motion.to_know"))
    yield from drive_blocks(moved)
    yield from _runs(moved, part)


def _stopped(found: DynamicVerification) -> Iterator[Block]:
    if not found.is_complete:
        yield blocks.Verdict(stopped_sentence(found), passes=False)


def _verdict(note: Note, used: float | None, part: DynamicPart) -> blocks.Verdict:
    largest = Measure("tension", part.max_tension)
    good = part.slack_time == 0.0 and part.verdict == "converged" and (used is None or used <= 1.0)
    if used is None:
        return blocks.Verdict(Message("note_motion.no_limit", T=largest), good)
    basis = Message("note_motion.by_checks")
    if not _is_checked(note):
        basis = Message("note_motion.by_mbl", factor=f"{note.solution.safety_factor:g}")
    key = "note_motion.within" if used <= 1.0 else "note_motion.beyond"
    return blocks.Verdict(Message(key, T=largest, used=f"{used:.3f}", basis=basis), good)


def _is_checked(note: Note) -> bool:
    return any(check.kind == "tension" for check in note.checks.results)


# ------------------------------------------------------------------ statistics


def _statistics(part: DynamicPart, solution: Solution) -> Table:
    """Tabulate each quantity beside its value at rest, in closed form."""
    rest = {
        "fairlead_tension": solution.fairlead.tension,
        "anchor_tension": solution.anchor.tension,
        "grounded_length": solution.grounded_length,
        "offset": 0.0,
    }
    names = [each.quantity for each in part.quantities]
    units = tuple(DYNAMIC_QUANTITY_OF[name] for name in names)
    columns = (
        column("columns.quantity", map(_label, units)),
        *_numbers(part, part.quantities, [rest[name] for name in names], units),
        column("note_motion.change", map(part.change_of, names), _PERCENT),
    )
    return Table("motion_statistics", columns, Message("note_motion.statistics"))


def _numbers(
    part: DynamicPart,
    every: Sequence[OverRuns],
    rest: Sequence[float] | None,
    units: tuple[Quantity, ...],
) -> Iterator[Column]:
    """Yield the columns of statistics; all of one quantity where one is given."""
    listed: list[tuple[Message, Iterable[float | None]]] = [
        (Message("note_motion.mean"), (each.mean for each in every)),
        (Message("note_motion.std"), (each.std for each in every)),
        (Message("note_motion.min"), (each.minimum for each in every)),
        (Message("note_motion.max"), (each.maximum for each in every)),
    ]
    if rest is not None:
        probable = Message("note_motion.most_probable", time=lasting(part.duration_of_interest))
        listed.insert(0, (Message("note_motion.rest"), rest))
        listed.append((probable, (each.most_probable_maximum for each in every)))
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


def _fairleads(parts: Sequence[DynamicPart], rest: Sequence[float]) -> Iterator[Column]:
    """Yield what is known of each part's tension at the fairlead, beside that at rest."""
    every = [part.of("fairlead_tension") for part in parts]
    yield from _numbers(parts[0], every, rest, (_TENSION,))
    changes = (part.change_of("fairlead_tension") for part in parts)
    yield column("note_motion.change", changes, _PERCENT)


def _amplification(parts: Sequence[DynamicPart]) -> Column:
    return column("note_motion.amplification", (part.amplification for part in parts), _FACTOR)


def _cases(moved: InMotion) -> Table:
    parts = moved.found.parts
    columns = (
        texts("load_case", (part.name for part in parts)),
        *_fairleads(parts, [solution.fairlead.tension for solution in moved.solutions]),
        _amplification(parts),
        measured("utilisation", map(moved.used, range(len(parts)))),
    )
    caption = Message("note_motion.cases", unit=Unit(_TENSION))
    return Table("motion_cases", columns, caption, marked=moved.governing)


def _uses(moved: InMotion, shown: int) -> Table:
    """Tabulate what each segment carries; people see the load case that governs."""
    rows = [
        (index, part.name, use)
        for index, (part, uses) in enumerate(zip(moved.found.parts, moved.uses, strict=True))
        for use in uses
    ]
    uses = [use for _, _, use in rows]
    largest = measured("tension", (use.largest for use in uses), "largest_tension", symbol="")
    rest = column("note_motion.rest", (use.at_rest for use in uses), _BARE)
    allowed = column("note.workbook_allowed", (use.capacity for use in uses), _BARE)
    used = measured("utilisation", (use.utilisation for use in uses))
    columns = (
        texts("load_case", (name for _, name, _ in rows), only="files"),
        texts("segment", (use.number for use in uses)),
        texts("name", (use.name for use in uses)),
        largest,
        rest,
        allowed,
        replace(used, formula=(largest, "/", allowed)),
        _passes([use.utilisation for use in uses]),
    )
    rows_shown = tuple(row for row, (index, _, _) in enumerate(rows) if index == shown)
    return Table("motion_use", columns, Message("note_motion.uses"), rows_shown)


def _passes(used: Sequence[float | None]) -> Column:
    passes = tuple(None if each is None else each <= 1.0 for each in used)
    verdict = {None: None, True: Message("answers.passes"), False: Message("answers.fails")}
    return Column(
        Message("columns.verdict"), tuple(verdict[each] for each in passes), passes=passes
    )


# ------------------------------------------------------------------ what it comes to


def _outcome(part: DynamicPart) -> blocks.Facts:
    balance = part.governing.history.balance
    listed: list[tuple[str, float | None, Quantity]] = [
        (Message("note_motion.anywhere"), part.max_tension, _BARE),
        (Message("note_motion.still_max"), part.quasi_static_max, _BARE),
        (Message("note_motion.amplification"), part.amplification, _FACTOR),
        (Message("note_motion.slack_time"), part.slack_time, _SLACK),
        (Message("note_motion.longest_slack"), part.longest_slack, _SLACK),
    ]
    for name, energy in ENERGIES.items():
        listed.append(
            (Message("note_motion.energy", what=term(name)), getattr(balance, energy), _ENERGY)
        )
    listed.append((Message("note_motion.energy_part"), balance.numerical_part, _PART))
    facts = tuple(blocks.Fact(*each) for each in listed)
    return blocks.Facts("motion_outcome", facts, Message("note_motion.outcome"))


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
    yield Table("motion_extremes", (texts("what", names), *columns), caption)


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
    if runs is not None:
        found["by_gumbel"] = (runs.extreme.most_probable, quantity)
        found["gumbel_from"] = (runs.extreme.low, quantity)
        found["gumbel_to"] = (runs.extreme.high, quantity)
    return found


def _runs(moved: InMotion, part: DynamicPart) -> Iterator[Block]:
    waves, every = moved.found.case.waves, part.runs
    found = [run.statistics("fairlead_tension") for run in every]
    histories = [run.history for run in every]
    seed = waves.seed if part.is_random and waves is not None else None
    seeds = ("-" if seed is None else f"({seed}, {run.number})" for run in every)
    still = (run.quasi_static_max for run in every)
    slack = (each.line_slack_time() for each in histories)
    columns = (
        texts("run", (run.number + 1 for run in every)),
        texts("seed", seeds),
        column("columns.largest_fairlead_tension", (each.maximum for each in found), _BARE),
        column("columns.at", (each.time_of_maximum for each in found), _SLACK),
        column("columns.largest_quasi_static_fairlead_tension", still, _BARE),
        column("columns.slack_in_all", slack, _SLACK),
        texts("steps", (each.steps for each in histories)),
        texts("halvings", (each.halvings for each in histories)),
    )
    shown = tuple(range(min(len(every), _MOST_RUNS)))
    caption, marked = Message("note_motion.run_table"), every.index(part.governing)
    yield Table("motion_runs", columns, caption, shown, marked)
    if len(every) > _MOST_RUNS:
        yield small("note_motion.left_out", count=len(every) - _MOST_RUNS)


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


def body_motion_blocks(note: SystemNote) -> Iterator[Block]:
    """Lay out all lines of a body in motion; nothing where nobody asked for it."""
    found = note.motion
    if found is None:
        return
    governing = found.governing
    assert governing.line is not None
    yield from _stopped(found)
    yield Text(Message("note_system.motion_about"))
    yield blocks.Verdict(Several(_said(found), " "), found.verdict == "converged")
    yield _lines(note, found)
    units = tuple(DYNAMIC_QUANTITY_OF[each.quantity] for each in found.body)
    names = column("columns.quantity", map(_label, units))
    columns = (names, *_numbers(governing, found.body, None, units))
    yield Table("system_motion_body", columns, Message("note_motion.body"))
    yield Figure(track(found), Message("note_system.motion_track"))
    at_rest = note.solution.lines[governing.line - 1].tension
    caption = Message("note_system.motion_history", line=governing.line)
    yield Figure(history(governing, at_rest), caption)
    remarks = dict.fromkeys(each for part in found.parts for each in part.remarks)
    yield blocks.Points((Message("note_motion.ends"), *remarks), Message("note_motion.to_know"))


def _said(found: DynamicVerification) -> Iterator[Message]:
    """Yield what is said of the governing line, and of the one that is proven least."""
    for part, sentences in (
        (found.governing, motion_sentences),
        (found.least_proven, proof_sentences),
    ):
        for sentence in sentences(part):
            yield Message("note_motion.of_line", number=part.line, said=sentence)


def _lines(note: SystemNote, found: DynamicVerification) -> Table:
    """Tabulate the fairlead tension of every line, the governing one marked."""
    parts = found.parts
    still = (part.quasi_static_max for part in parts)
    columns = (
        texts("line", (part.line for part in parts)),
        *_fairleads(parts, [line.tension for line in note.solution.lines]),
        column("columns.quasi_static_fairlead_tension", still, _BARE),
        _amplification(parts),
        column("columns.slack_in_all", (part.slack_time for part in parts), SECONDS),
    )
    caption, marked = (
        Message("note_motion.lines", unit=Unit(_TENSION)),
        parts.index(found.governing),
    )
    return Table("system_motion_lines", columns, caption, marked=marked)
