"""How a solution looks on a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.summary import Entry, found, given, in_tonne_force, named, residuals, results
from catopt.report.words import METHODS, REGIMES

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.cli.output import Output
    from catopt.model import Case

__all__ = ["show_solution"]

_PROFILE_POINTS = 21
_NO_LENGTH = 1e-9
"""Part of the line below which what lies on the bed is rounding."""


def show_solution(output: Output, case: Case, solution: Solution, *, with_profile: bool) -> None:
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
    """
    output.text(case.title or "Mooring line", bold=True)
    output.text(f"Solved by {METHODS[solution.method]}; {_hangs(solution)}.")
    output.line()
    _list(output, "Given", [entry for entry in given(case) if entry.value is not None])
    _segments_given(output, case)
    if solution.found is not None:
        _list(output, f"Found for the {solution.found.condition}", found(solution))
    _list(output, "Result", results(solution))
    _segments(output, solution)
    _point_loads(output, solution)
    if solution.swarm is not None:
        _swarm(output, solution.swarm)
    if with_profile:
        _profile(output, solution)
    if solution.found is not None:
        output.text(f"Residual of the condition, relative: {solution.found.residual:.2e}")
    for name, entry in zip(("height", "span"), residuals(solution), strict=True):
        value = entry.quantity.format(entry.value, unit=True)
        output.text(f"Residual of the {name}, laid out from the anchor: {value}")
    for warning in solution.warnings:
        output.text(f"Warning: {warning}.", bold=True)


def _hangs(solution: Solution) -> str:
    """Say how the line hangs; with the touchdown at its anchor nothing of it lies on the bed."""
    at_anchor = solution.grounded_length <= _NO_LENGTH * solution.line.length
    if solution.regime == "grounded" and at_anchor:
        return "the whole line hangs, just level at its anchor"
    return REGIMES[solution.regime]


def _list(output: Output, title: str, entries: Iterable[Entry]) -> None:
    rows = [
        (
            entry.quantity.label,
            *(
                quantity.format(entry.value, unit=entry.value is not None)
                for quantity in (entry.quantity, *entry.also)
            ),
        )
        for entry in entries
    ]
    width = max(len(row) for row in rows)
    padded = [(*row, *[""] * (width - len(row))) for row in rows]
    output.table([""] * width, padded, title=title, numbers=range(1, width))


def _segments_given(output: Output, case: Case) -> None:
    keys = ("length", "submerged_weight", "EA", "mass_per_length", "MBL")
    rows = [
        (each.length, each.submerged_weight, each.EA, each.mass, each.MBL)
        for each in case.line.segments
    ]
    names = [segment.name for segment in case.line.segments]
    _numbered(output, "Segments, from the anchor", names, [QUANTITIES[key] for key in keys], rows)
    loads = case.line.point_loads
    _numbered(
        output,
        "Point loads",
        [load.name for load in loads],
        [QUANTITIES[key] for key in ("position", "point_weight", "mass")],
        [(load.position, load.submerged_weight, load.mass) for load in loads],
    )


def _segments(output: Output, solution: Solution) -> None:
    tension, factor = named("tension", "Largest tension", "max. T"), solution.safety_factor
    use = QUANTITIES["utilisation"]
    _numbered(
        output,
        "Segments under load",
        [segment.name for segment in solution.segments],
        [QUANTITIES["length"], tension, in_tonne_force(tension), QUANTITIES["MBL"], use],
        [
            (each.length, each.max_tension, each.max_tension, each.MBL, each.utilisation(factor))
            for each in solution.segments
        ],
    )
    if factor != 1.0 and any(segment.MBL is not None for segment in solution.segments):
        output.text(f"Utilisation: largest tension times {factor:g} over MBL.")
        output.line()


def _point_loads(output: Output, solution: Solution) -> None:
    loads = solution.point_loads
    _numbered(
        output,
        "Point loads under load",
        [load.name for load in loads],
        [QUANTITIES[key] for key in ("position", "x", "z", "seabed_reaction")],
        [(load.position, load.x, load.z, load.seabed_reaction) for load in loads],
    )


def _swarm(output: Output, swarm: SwarmReport) -> None:
    rows = [
        ("Best objective f", QUANTITIES["objective"].format(swarm.objective, unit=True)),
        ("Best run", f"{swarm.best_run} of {swarm.runs}, seed {swarm.seed}"),
        ("Runs that reached f < 1e-9 m", f"{swarm.converged_runs} of {swarm.runs}"),
        ("Evaluations of f", f"{swarm.evaluations}"),
        ("Iterations a run, at most", f"{swarm.iterations}"),
        ("Span against equation (5) of S1", f"{swarm.span_consistency:.2e} m"),
    ]
    words = {
        "angle_rad": ("inclination at the anchor", "rad"),
        "grounded_length_m": ("grounded length", "m"),
        "span_m": ("span", "m"),
        "tension_N": ("fairlead tension", "N"),
    }
    for key, difference in swarm.closed_form_difference.items():
        name, unit = words[key]
        rows.append((f"Swarm less closed form, {name}", f"{difference:.2e} {unit}"))
    output.table(["", ""], rows, title="Particle swarm", numbers=[1])


def _profile(output: Output, solution: Solution) -> None:
    shape = solution.profile(_PROFILE_POINTS)
    tension = QUANTITIES["tension"]
    quantities = [*(QUANTITIES[key] for key in ("s", "x", "z")), tension, in_tonne_force(tension)]
    columns = (shape.s, shape.x, shape.z, shape.tension, shape.tension)
    rows = [
        [quantity.format(value) for quantity, value in zip(quantities, row, strict=True)]
        for row in zip(*columns, strict=True)
    ]
    headings = [_heading(quantity) for quantity in quantities]
    output.table(headings, rows, title="Along the line", numbers=range(len(headings)))


def _numbered(
    output: Output,
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
            *(_cell(quantity, value) for quantity, value in zip(quantities, row, strict=True)),
        ]
        for number, (name, row) in enumerate(zip(names, rows, strict=True), start=1)
    ]
    headings = ["No.", *(["Name"] if shown else []), *map(_heading, quantities)]
    output.table(
        headings, cells, title=title, numbers=range(len(headings) - len(quantities), len(headings))
    )


def _heading(quantity: Quantity) -> str:
    """Say what a column holds in few characters, for 80 of them carry the whole table."""
    return f"{quantity.symbol or quantity.name}\n({quantity.field_unit})"


def _cell(quantity: Quantity, value: float | None) -> str:
    return "inextensible" if value == float("inf") else quantity.format(value)
