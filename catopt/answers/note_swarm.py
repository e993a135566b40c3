"""The same line by the particle swarm, in a note."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Block,
    Column,
    Facts,
    Figure,
    Section,
    Table,
    Text,
    Verdict,
)
from catopt.answers.note import column, note_section
from catopt.answers.solution import flown_facts, result_facts, swarm_settings, swarm_tables
from catopt.figures.swarm import fitness, swarm_tension
from catopt.words import Measure, Message, Several

if TYPE_CHECKING:
    from catopt.catenary.solution import SwarmReport
    from catopt.notes.line import Note

_CONVERGED = 1e-9
"""m: a run that ends with f below it counts as converged."""
_MOST_RUNS = 30
"""Runs that people see; the workbook has all."""


def swarm_section(note: Note) -> Iterator[Section]:
    """Lay out the swarm's part; nothing where nobody asked for it."""
    report = None if note.swarm is None else note.swarm.swarm
    if report is not None:
        yield note_section("swarm", _swarm(note, report), "note.swarm_heading")


def _swarm(note: Note, report: SwarmReport) -> Iterator[Block]:
    about = [Message("note.swarm_about")]
    if note.load_case:
        about.append(Message("note.swarm_load_case", name=note.load_case))
    yield Text(Several(about, " "))
    verdict = Message(
        "note.swarm_verdict",
        converged=report.converged_runs,
        runs=report.runs,
        best=report.best_run,
        f=Measure("objective", report.objective),
    )
    yield Verdict(verdict, report.converged_runs > 0)
    yield _results(note)
    yield Figure(fitness(report))
    outcome, caption = tuple(flown_facts(report)), Message("note.swarm_outcome")
    yield Facts("swarm_outcome", outcome, caption, only="not csv")
    yield from _runs(report)
    caption = Message("note.swarm_settings")
    yield replace(swarm_settings(note.case.swarm), caption=caption, only="not csv")
    yield Text(Message("note.swarm_legend"), is_small=True)
    history, _ = swarm_tables(report)
    yield replace(history, only="workbook")
    yield Figure(swarm_tension(report, note.solution.fairlead.tension))


def _results(note: Note) -> Table:
    assert note.swarm is not None
    pairs = [
        (one, one.value, other.value)
        for one, other in zip(result_facts(note.swarm), result_facts(note.solution), strict=True)
        if isinstance(one.value, float) and isinstance(other.value, float)
    ]
    units = tuple(one.quantity for one, _, _ in pairs if one.quantity is not None)
    found = Column(Message("note.swarm_by_swarm"), tuple(a for _, a, _ in pairs), units=units)
    exact = Column(Message("columns.closed_form"), tuple(b for _, _, b in pairs), units=units)
    return Table(
        "swarm_results",
        (
            column("columns.quantity", (one.name for one, _, _ in pairs)),
            found,
            exact,
            Column(
                Message("note.swarm_difference"),
                tuple(a - b for _, a, b in pairs),
                units=tuple(replace(each, notation="scientific", digits=1) for each in units),
                formula=(found, "-", exact),
            ),
        ),
        Message("note.swarm_results"),
        only="not csv",
    )


def _runs(report: SwarmReport) -> Iterator[Block]:
    _, runs = swarm_tables(report)
    met = ("answers.yes" if f < _CONVERGED else "answers.no" for f in report.objectives)
    yield replace(
        runs,
        columns=(*runs.columns[:3], column("note.swarm_converged", map(Message, met))),
        caption=Message("note.swarm_runs"),
        shown=tuple(range(min(runs.length, _MOST_RUNS))),
        marked=report.best_run - 1,
        only="not csv",
    )
    if runs.length > _MOST_RUNS:
        left = Message("note.swarm_left_out", count=runs.length - _MOST_RUNS)
        yield Text(left, is_small=True)
