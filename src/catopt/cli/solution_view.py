"""How a solution looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.summary import (
    Entry,
    found,
    given,
    in_tonne_force,
    named,
    residuals,
    results,
)
from catopt.report.texts import Words
from catopt.report.wording.names import METHODS, how_it_hangs

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.cli.output import Output
    from catopt.model import Case

__all__ = ["show_solution"]

_PROFILE_POINTS = 21


def show_solution(
    output: Output,
    case: Case,
    solution: Solution,
    *,
    with_profile: bool,
    words: Words | None = None,
) -> None:
    """Print a solution for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    case : Case
        What was given.
    solution : Solution
        What came out.
    with_profile : bool
        Whether to add a table of the shape.
    words : Words, optional
        Language; English when left out.
    """
    words = words or Words()
    output.text(case.title or words.name("Mooring line"), bold=True)
    solved = f"Solved by {METHODS[solution.method]}; {how_it_hangs(solution)}."
    output.text(words.sentence(solved).text)
    output.line()
    _list(output, words, "Given", [entry for entry in given(case) if entry.value is not None])
    _segments_given(output, words, case)
    if solution.found is not None:
        _list(output, words, f"Found for the {solution.found.condition}", found(solution))
    _list(output, words, "Result", results(solution))
    _segments(output, words, solution)
    _point_loads(output, words, solution)
    if solution.swarm is not None:
        _swarm(output, words, solution.swarm)
    if with_profile:
        _profile(output, words, solution)
    if solution.found is not None:
        left = f"Residual of the condition, relative: {solution.found.residual:.2e}"
        output.text(words.sentence(left).text)
    for name, entry in zip(("height", "span"), residuals(solution), strict=False):
        value = entry.quantity.format(entry.value, unit=True)
        left = f"Residual of the {name}, laid out from the anchor: {value}"
        output.text(words.sentence(left).text)
    for warning in solution.warnings:
        output.text(words.sentence(f"Warning: {warning}.").text, bold=True)


def _list(output: Output, words: Words, title: str, entries: Iterable[Entry]) -> None:
    rows = [
        (
            words.heading(entry.quantity.label),
            *(
                quantity.format(entry.value, unit=entry.value is not None)
                for quantity in (entry.quantity, *entry.also)
            ),
        )
        for entry in entries
    ]
    width = max(len(row) for row in rows)
    padded = [(*row, *[""] * (width - len(row))) for row in rows]
    said = words.sentence(title).text
    output.table([""] * width, padded, title=said, numbers=range(1, width))


def _segments_given(output: Output, words: Words, case: Case) -> None:
    keys = ("length", "submerged_weight", "EA", "mass_per_length", "MBL")
    rows = [
        (each.length, each.submerged_weight, each.EA, each.mass, each.MBL)
        for each in case.line.segments
    ]
    names = [segment.name for segment in case.line.segments]
    quantities = [QUANTITIES[key] for key in keys]
    _numbered(output, words, "Segments, from the anchor", names, quantities, rows)
    loads = case.line.point_loads
    _numbered(
        output,
        words,
        "Point loads",
        [load.name for load in loads],
        [QUANTITIES[key] for key in ("position", "point_weight", "mass")],
        [(load.position, load.submerged_weight, load.mass) for load in loads],
    )


def _segments(output: Output, words: Words, solution: Solution) -> None:
    tension, factor = named("tension", "Largest tension", "max. T"), solution.safety_factor
    use = QUANTITIES["utilisation"]
    _numbered(
        output,
        words,
        "Segments under load",
        [segment.name for segment in solution.segments],
        [QUANTITIES["length"], tension, in_tonne_force(tension), QUANTITIES["MBL"], use],
        [
            (each.length, each.max_tension, each.max_tension, each.MBL, each.utilisation(factor))
            for each in solution.segments
        ],
    )
    if factor != 1.0 and any(segment.MBL is not None for segment in solution.segments):
        output.text(words.sentence(f"Utilisation: largest tension times {factor:g} over MBL.").text)
        output.line()


def _point_loads(output: Output, words: Words, solution: Solution) -> None:
    loads = solution.point_loads
    _numbered(
        output,
        words,
        "Point loads under load",
        [load.name for load in loads],
        [QUANTITIES[key] for key in ("position", "x", "z", "seabed_reaction")],
        [(load.position, load.x, load.z, load.seabed_reaction) for load in loads],
    )


def _swarm(output: Output, words: Words, swarm: SwarmReport) -> None:
    rows = [
        ("Best objective f", QUANTITIES["objective"].format(swarm.objective, unit=True)),
        (
            "Best run",
            words("terminal.run", run=swarm.best_run, runs=swarm.runs, seed=swarm.seed),
        ),
        (
            "Runs that reached f < 1e-9 m",
            words("terminal.of", part=swarm.converged_runs, whole=swarm.runs),
        ),
        ("Evaluations of f", f"{swarm.evaluations}"),
        ("Iterations a run, at most", f"{swarm.iterations}"),
        ("Span against equation (5) of S1", f"{swarm.span_consistency:.2e} m"),
    ]
    differences = {
        "angle_rad": ("inclination at the anchor", "rad"),
        "grounded_length_m": ("grounded length", "m"),
        "span_m": ("span", "m"),
        "tension_N": ("fairlead tension", "N"),
    }
    for key, difference in swarm.closed_form_difference.items():
        name, unit = differences[key]
        rows.append((f"Swarm less closed form, {name}", f"{difference:.2e} {unit}"))
    said = [(words.heading(name), value) for name, value in rows]
    output.table(["", ""], said, title=words.name("Particle swarm"), numbers=[1])


def _profile(output: Output, words: Words, solution: Solution) -> None:
    shape = solution.profile(_PROFILE_POINTS)
    tension = QUANTITIES["tension"]
    quantities = [*(QUANTITIES[key] for key in ("s", "x", "z")), tension, in_tonne_force(tension)]
    columns = (shape.s, shape.x, shape.z, shape.tension, shape.tension)
    rows = [
        [quantity.format(value) for quantity, value in zip(quantities, row, strict=True)]
        for row in zip(*columns, strict=True)
    ]
    headings = [_heading(words, quantity) for quantity in quantities]
    title = words.name("Along the line")
    output.table(headings, rows, title=title, numbers=range(len(headings)))


def _numbered(
    output: Output,
    words: Words,
    title: str,
    names: Sequence[str],
    quantities: Sequence[Quantity],
    rows: Sequence[Sequence[float | None]],
) -> None:
    """Print a table with a numbered row for each part of the line; nothing when there is none."""
    if not rows:
        return
    shown = any(names)
    cells = [
        [
            str(number),
            *([name] if shown else []),
            *(
                _cell(words, quantity, value)
                for quantity, value in zip(quantities, row, strict=True)
            ),
        ]
        for number, (name, row) in enumerate(zip(names, rows, strict=True), start=1)
    ]
    first = [words.name(name) for name in (["No.", "Name"] if shown else ["No."])]
    headings = [*first, *(_heading(words, quantity) for quantity in quantities)]
    said = words.name(title)
    output.table(headings, cells, title=said, numbers=range(len(first), len(headings)))


def _heading(words: Words, quantity: Quantity) -> str:
    """Say what a column holds in few characters, for 80 of them carry the whole table."""
    return f"{quantity.symbol or words.name(quantity.name)}\n({quantity.field_unit})"


def _cell(words: Words, quantity: Quantity, value: float | None) -> str:
    return words.name("inextensible") if value == float("inf") else quantity.format(value)
