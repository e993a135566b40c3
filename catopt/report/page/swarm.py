"""The same line by the particle swarm: its settings, what it found, and how its runs ended."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.figures.swarm import fitness
from catopt.notes.line import Note
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.svg import svg
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, label_of, measured
from catopt.report.tables.summary import named, results

if TYPE_CHECKING:
    from catopt.catenary.solution import SwarmReport
    from catopt.model import SwarmSettings

__all__ = ["CONVERGED", "MOST_RUNS", "result_rows", "setting_rows", "swarm"]

CONVERGED = 1e-9
"""m: a run that ends with f below it counts as converged."""
MOST_RUNS = 30
"""Runs that the page shows; the workbook has all."""

_OBJECTIVE = named("objective", "Best objective")


def swarm(note: Note, words: Words) -> dict[str, Any] | None:
    """Build the swarm's part; None where nobody asked for it."""
    if note.swarm is None or note.swarm.swarm is None:
        return None
    report = note.swarm.swarm
    return {
        "load_case": note.load_case,
        "converged": report.converged_runs > 0,
        "verdict": _verdict(report, words),
        "settings": _settings(note.case.swarm, words),
        "outcome": _outcome(report, words),
        "results": _results(note, words),
        "figure": svg(fitness(report), words.language),
        "runs": _runs(report, words),
        "left_out": max(0, len(report.objectives) - MOST_RUNS),
    }


def _verdict(report: SwarmReport, words: Words) -> str:
    return words(
        "swarm.verdict",
        converged=report.converged_runs,
        runs=report.runs,
        best=report.best_run,
        f=_OBJECTIVE.format(report.objective, unit=True),
    )


def setting_rows(settings: SwarmSettings) -> list[tuple[str, float | str]]:
    """List the settings of a swarm by their names in English.

    Parameters
    ----------
    settings : SwarmSettings
        Of the case.
    """
    return [
        ("Particles", settings.particles),
        ("Iterations a run, at most", settings.iterations),
        ("Runs", settings.runs),
        ("Seed", settings.seed),
        ("Inertia w", settings.inertia),
        ("Cognitive coefficient c1", settings.cognitive),
        ("Social coefficient c2", settings.social),
        ("Boundary handling", settings.boundary),
    ]


def _settings(settings: SwarmSettings, words: Words) -> Table:
    rows = tuple(
        (Cell(words.heading(name)), Cell(value) if isinstance(value, str) else _plain(value))
        for name, value in setting_rows(settings)
    )
    headings = (Heading(words("swarm.setting")), Heading(words("table.value")))
    return Table("swarm_settings", headings, rows, words("swarm.settings"))


def _outcome(report: SwarmReport, words: Words) -> Table:
    flown = len(report.best_objective_history)
    of = words("terminal.of", part=report.converged_runs, whole=report.runs)
    rows = (
        ("Best objective f", measured(_OBJECTIVE, report.objective, unit=True)),
        ("Best run", _plain(report.best_run)),
        ("Iterations flown", _plain(flown)),
        ("Runs that reached f < 1e-9 m", Cell(of, report.converged_runs)),
        ("Evaluations of f", _plain(report.evaluations)),
        ("Span against equation (5) of S1", _small(QUANTITIES["span"], report.span_consistency)),
    )
    headings = (Heading(words("table.what")), Heading(words("table.value")))
    laid = tuple((Cell(words.heading(name)), cell) for name, cell in rows)
    return Table("swarm_outcome", headings, laid, words("swarm.outcome"))


def result_rows(note: Note) -> list[tuple[Quantity, float, float]]:
    """List each result by the swarm and in closed form, in SI."""
    assert note.swarm is not None
    pairs = zip(results(note.swarm), results(note.solution), strict=True)
    return [
        (one.quantity, one.value, other.value)
        for one, other in pairs
        if one.value is not None and other.value is not None
    ]


def _results(note: Note, words: Words) -> Table:
    headings = (
        Heading(words("workbook.quantity")),
        Heading(words("swarm.by_swarm"), is_number=True),
        Heading(words("verification.closed_form"), is_number=True),
        Heading(words("swarm.difference"), is_number=True),
    )
    rows = tuple(
        (
            Cell(label_of(words, quantity), style="words"),
            measured(quantity, found, unit=True),
            measured(quantity, exact, unit=True),
            _small(quantity, found - exact),
        )
        for quantity, found, exact in result_rows(note)
    )
    return Table("swarm_results", headings, rows, words("swarm.results"))


def _runs(report: SwarmReport, words: Words) -> Table:
    flown = report.iterations_flown or (report.iterations,) * len(report.objectives)
    rows = tuple(
        (
            _plain(number),
            measured(_OBJECTIVE, f, unit=True),
            _plain(iterations),
            Cell(words.name("yes" if f < CONVERGED else "no")),
        )
        for number, (f, iterations) in enumerate(
            zip(report.objectives[:MOST_RUNS], flown, strict=False), start=1
        )
    )
    headings = (
        Heading(words.name("Run"), is_number=True),
        Heading(words("swarm.ended"), is_number=True),
        Heading(words.name("Iterations flown"), is_number=True),
        Heading(words("swarm.converged")),
    )
    best = report.best_run - 1
    marked = best if best < len(rows) else None
    return Table("swarm_runs", headings, rows, words("swarm.runs"), marked)


def _plain(value: float) -> Cell:
    return Cell(f"{value:g}" if isinstance(value, float) else str(value), value)


def _small(quantity: Quantity, si: float) -> Cell:
    """Show what is next to nothing in the unit of its quantity."""
    shown = "0" if si == 0.0 else f"{quantity.to_field(si):.1e}"
    return Cell(f"{shown} {quantity.field_unit}", si)
