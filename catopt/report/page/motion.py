"""The line in motion: what drives it, its model, its tensions, and what is to be known of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from catopt.figures.motion import envelope_chart, exceedance, history
from catopt.notes.line import Note
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.motion_drive import (
    Row,
    drive_rows,
    model_rows,
    rao_table,
    segments_table,
)
from catopt.report.page.motion_extremes import extremes_table
from catopt.report.page.table import Cell, Heading, Table, label_of, measured, number_heading, units
from catopt.report.tables.dynamic import (
    DYNAMIC_QUANTITY_OF,
    dynamic_sentences,
    stopped_sentence,
)
from catopt.report.tables.summary import named
from catopt.units import lasting

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.notes.motion import InMotion, SegmentUse
    from catopt.verify.dynamic_result import DynamicPart, DynamicRun

__all__ = ["STATISTICS", "at_rest", "change_cell", "known_of", "motion", "outcome_rows", "run_rows"]

_TENSION = QUANTITIES["tension"]
_MOST_RUNS = 30
STATISTICS = (
    "in_motion.rest",
    "in_motion.mean",
    "in_motion.std",
    "in_motion.min",
    "in_motion.max",
    "in_motion.most_probable",
    "in_motion.change",
)
"""Keys of the statistics' columns."""


def motion(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the part of the line in motion; None where nobody asked for it."""
    moved = note.motion
    if moved is None:
        return None
    index = moved.governing
    part, uses, solution = moved.found.parts[index], moved.uses[index], moved.solutions[index]
    used = moved.used(index)
    several = bool(moved.found.case.load_cases)
    peaks, allowed = exceedance(part), [use.capacity for use in uses]
    return {
        "stopped": None
        if moved.found.is_complete
        else words.sentence(stopped_sentence(moved.found)),
        "load_case": part.name if several else "",
        "sentences": [words.sentence(each) for each in dynamic_sentences(part)],
        "passes": part.slack_time == 0.0
        and part.verdict == "converged"
        and (used is None or used <= 1.0),
        "verdict": _verdict(used, part, _basis(note, words), words),
        "statistics": _statistics(part, solution, words),
        "outcome": _listed("motion_outcome", outcome_rows(part), words, "in_motion.outcome"),
        "uses": _uses(uses, words),
        "cases": _cases(moved, words) if len(moved.found.parts) > 1 else None,
        "extremes": extremes_table(part, words),
        "exceedance": None if peaks is None else svg(peaks, words.language),
        "history": svg(history(part, solution.fairlead.tension), words.language),
        "envelope": svg(envelope_chart(part, solution, allowed), words.language),
        "drive": _listed("motion_drive", drive_rows(moved, words), words, "in_motion.drive"),
        "raos": rao_table(moved.drive.raos, words),
        "model": _listed(
            "motion_model", model_rows(moved, part.runs[0], words), words,
            "in_motion.model",
        ),
        "segments": segments_table(moved, words),
        "runs": _runs(moved, part, words),
        "left_out": max(0, len(part.runs) - _MOST_RUNS),
        "known": list(known_of(note, part, words)),
        "remarks": [words.sentence(remark) for remark in part.remarks],
    }  # fmt: skip


def _verdict(used: float | None, part: DynamicPart, basis: str, words: Words) -> str:
    largest = _TENSION.format(part.max_tension, unit=True)
    if used is None:
        return words("in_motion.no_limit", T=largest)
    key = "in_motion.within" if used <= 1.0 else "in_motion.beyond"
    return words(key, T=largest, used=f"{used:.3f}", basis=basis)


def _basis(note: Note, words: Words) -> str:
    """Say what the tension is held against."""
    if _is_checked(note):
        return words("in_motion.by_checks")
    return words("in_motion.by_mbl", factor=f"{note.solution.safety_factor:g}")


def _is_checked(note: Note) -> bool:
    return any(check.kind == "tension" for check in note.checks.results)


def at_rest(solution: Solution) -> dict[str, float]:
    """Give each quantity of the statistics its value at rest, in closed form."""
    return {
        "fairlead_tension": solution.fairlead.tension,
        "anchor_tension": solution.anchor.tension,
        "grounded_length": solution.grounded_length,
        "offset": 0.0,
    }


def _statistics(part: DynamicPart, solution: Solution, words: Words) -> Table:
    headings = (Heading(words("workbook.quantity")), *_statistic_headings(part, words))
    rest = at_rest(solution)
    rows = []
    for each in part.quantities:
        quantity = DYNAMIC_QUANTITY_OF[each.quantity]
        numbers = (
            rest[each.quantity], each.mean, each.std, each.minimum, each.maximum,
            each.most_probable_maximum,
        )  # fmt: skip
        label = f"{label_of(words, quantity)} ({quantity.field_unit})"
        cells = (*(measured(quantity, v) for v in numbers), change_cell(part, each.quantity))
        rows.append((Cell(label, style="words"), *cells))
    return Table("motion_statistics", headings, tuple(rows), words("in_motion.statistics"))


def change_cell(part: DynamicPart, quantity: str) -> Cell:
    """Show how far a maximum moved when the runs were made again; a dash where they were not."""
    change = part.change_of(quantity)
    return Cell("–") if change is None else Cell(f"{change:.2%}", change)


def _statistic_headings(part: DynamicPart, words: Words) -> Iterator[Heading]:
    for key in STATISTICS:
        yield Heading(words(key, time=lasting(part.duration_of_interest)), is_number=True)


def outcome_rows(part: DynamicPart) -> list[Row]:
    """List what one load case comes to, beside the statistics."""
    amplification = part.amplification
    return [
        ("in_motion.anywhere", measured(_TENSION, part.max_tension, unit=True)),
        ("in_motion.still_max", measured(_TENSION, part.quasi_static_max, unit=True)),
        (
            "in_motion.amplification",
            Cell("–") if amplification is None else Cell(f"{amplification:.3f}", amplification),
        ),
        ("in_motion.slack_time", Cell(f"{part.slack_time:.2f} s", part.slack_time)),
        ("in_motion.longest_slack", Cell(f"{part.longest_slack:.2f} s", part.longest_slack)),
        *_energy_rows(part.governing),
    ]


def _energy_rows(run: DynamicRun) -> list[Row]:
    """List the energy of a run, in kJ; what is numerical also over what was put in."""
    balance = run.history.balance
    part = balance.numerical_part
    return [
        ("in_motion.energy_put_in", _energy(balance.put_in)),
        ("in_motion.energy_ends", _energy(balance.ends)),
        ("in_motion.energy_water", _energy(balance.water)),
        ("in_motion.energy_kinetic", _energy(balance.kinetic)),
        ("in_motion.energy_elastic", _energy(balance.elastic)),
        ("in_motion.energy_potential", _energy(balance.potential)),
        ("in_motion.energy_by_drag", _energy(balance.drag)),
        ("in_motion.energy_by_bed", _energy(balance.bed)),
        ("in_motion.energy_by_friction", _energy(balance.friction)),
        ("in_motion.energy_by_damping", _energy(balance.damping)),
        ("in_motion.energy_numerical", _energy(balance.numerical)),
        ("in_motion.energy_part", Cell(f"{part:.1e}", part)),
    ]


def _energy(value: float) -> Cell:
    return Cell(f"{value / 1e3 + 0.0:.4g} kJ", value)


def _uses(uses: Sequence[SegmentUse], words: Words) -> Table:
    headings = (
        Heading(words("components.segment"), is_number=True),
        Heading(words("components.name")),
        units(words, named("tension", "Largest tension")),
        number_heading(words("in_motion.rest"), _TENSION),
        number_heading(words("workbook.allowed"), _TENSION),
        Heading(words("checks.utilisation"), is_number=True),
        Heading(words("checks.verdict")),
    )
    rows = tuple(
        (
            Cell(str(use.number), use.number),
            Cell(use.name, style="words"),
            measured(_TENSION, use.largest),
            measured(_TENSION, use.at_rest),
            measured(_TENSION, use.capacity),
            _used(use),
            _passes(use, words),
        )
        for use in uses
    )
    return Table("motion_use", headings, rows, words("in_motion.uses"))


def _used(use: SegmentUse) -> Cell:
    used = use.utilisation
    return Cell("–") if used is None else Cell(f"{used:.3f}", used, bar=used)


def _passes(use: SegmentUse, words: Words) -> Cell:
    if use.utilisation is None:
        return Cell("–")
    passes = use.utilisation <= 1.0
    key = "checks.passes" if passes else "checks.fails"
    return Cell(words(key), style="passes" if passes else "fails")


def _cases(moved: InMotion, words: Words) -> Table:
    headings = (
        Heading(words("identity.load_case")),
        *_statistic_headings(moved.found.parts[0], words),
        Heading(words("in_motion.amplification"), is_number=True),
        Heading(words("checks.utilisation"), is_number=True),
    )
    rows = []
    for index, (part, solution) in enumerate(zip(moved.found.parts, moved.solutions, strict=True)):
        each = part.of("fairlead_tension")
        numbers = (
            solution.fairlead.tension, each.mean, each.std, each.minimum, each.maximum,
            each.most_probable_maximum,
        )  # fmt: skip
        change = change_cell(part, each.quantity)
        used, larger = moved.used(index), part.amplification
        rows.append(
            (
                Cell(part.name),
                *(measured(_TENSION, value) for value in numbers),
                change,
                Cell("–") if larger is None else Cell(f"{larger:.3f}", larger),
                Cell("–") if used is None else Cell(f"{used:.3f}", used),
            )
        )
    caption = words("in_motion.cases", unit=_TENSION.field_unit)
    return Table("motion_cases", headings, tuple(rows), caption, moved.governing)


def run_rows(part: DynamicPart) -> list[tuple[float, float, float | None, float, int, int]]:
    """List for each run: largest tension, when, largest quasi-static one, slack, steps, halvings.

    N and s.
    """
    rows = []
    for run in part.runs:
        found, history = run.statistics("fairlead_tension"), run.history
        rows.append(
            (
                found.maximum, found.time_of_maximum, run.quasi_static_max,
                history.line_slack_time(), history.steps, history.halvings,
            )
        )  # fmt: skip
    return rows


def _runs(moved: InMotion, part: DynamicPart, words: Words) -> Table:
    waves = moved.found.case.waves
    rows = []
    shown = zip(part.runs, run_rows(part)[:_MOST_RUNS], strict=False)
    for run, (largest, when, still, slack, steps, halvings) in shown:
        k = run.number
        seed = f"({waves.seed}, {k})" if part.is_random and waves is not None else "–"
        rows.append(
            (
                Cell(str(k + 1), k + 1), Cell(seed), measured(_TENSION, largest),
                Cell(f"{when:.2f}", when), measured(_TENSION, still), Cell(f"{slack:.2f}", slack),
                Cell(str(steps), steps), Cell(str(halvings), halvings),
            )
        )  # fmt: skip
    headings = (
        Heading(words.name("Run"), is_number=True),
        Heading(words.name("Seed")),
        _unit(words, named("tension", "Largest fairlead tension", "")),
        Heading(words("in_motion.when"), is_number=True),
        _unit(words, named("tension", "Largest quasi-static fairlead tension", "")),
        Heading(f"{words.name('Slack in all')} (s)", is_number=True),
        Heading(words.name("Steps"), is_number=True),
        Heading(words.name("Halvings"), is_number=True),
    )
    index = part.runs.index(part.governing)
    marked = index if index < len(rows) else None
    return Table("motion_runs", headings, tuple(rows), words("in_motion.run_table"), marked)


def _unit(words: Words, quantity: Quantity) -> Heading:
    return number_heading(words.name(quantity.name), quantity)


def known_of(note: Note, part: DynamicPart, words: Words) -> Iterator[str]:
    """Yield what an engineer must know of the figures: what they are of, and what they leave out.

    Parameters
    ----------
    note : Note
        With a line in motion.
    part : DynamicPart
        The load case that is shown.
    words : Words
        Language.
    """
    moved = note.motion
    assert moved is not None
    history = part.runs[0].history
    yield words(
        "in_motion.transient", ramp=f"{moved.drive.ramp:g}", since=f"{history.since:g}",
        end=f"{moved.drive.dynamics.duration:g}",
    )  # fmt: skip
    if part.is_random:
        peaks = sum(run.statistics("fairlead_tension").peaks for run in part.runs)
        key = "in_motion.one_seed" if len(part.runs) == 1 else "in_motion.several_seeds"
        yield words(key, runs=len(part.runs), peaks=peaks)
        yield words("in_motion.in_duration", duration=lasting(part.duration_of_interest))
    else:
        yield words("in_motion.not_random")
    if _is_checked(note):
        yield words("in_motion.allowed_at_rest")
    else:
        yield words("in_motion.allowed_by_mbl", factor=f"{note.solution.safety_factor:g}")
    yield words("in_motion.led")
    yield words("in_motion.ends")
    yield words("in_motion.grounded")


def _listed(key: str, rows: Sequence[Row], words: Words, caption: str) -> Table:
    laid = tuple((Cell(words(name)), cell) for name, cell in rows)
    headings = (Heading(words("table.what")), Heading(words("table.value")))
    return Table(key, headings, laid, words(caption))
