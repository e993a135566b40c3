"""A moored body as named columns: the one list behind its tables on the terminal and in files.

Light on purpose: the terminal shows it without pandas, `frames` alone loads it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.summary import Entry, columns, named

if TYPE_CHECKING:
    import pandas as pd

    from catopt.mooring.case import SystemReport
    from catopt.mooring.response import Response
    from catopt.mooring.restoring import RestoringCurve

__all__ = [
    "Column",
    "body",
    "circle_columns",
    "curve_columns",
    "frames",
    "level_columns",
    "line_columns",
    "line_out_columns",
]

Column = tuple[str | Quantity, Sequence[float | str | None]]
"""A heading, or a quantity whose values are in SI, and one value a row."""

OFFSET = QUANTITIES["offset"]
DIRECTION = named("angle", "Direction", "")
LARGEST = named("tension", "Largest tension", "")


def body(report: SystemReport) -> tuple[Entry, ...]:
    """List where the body is and how it is held."""
    solution = report.solution
    system = solution.system
    stiffness = solution.stiffness
    entries = [
        Entry(named("horizontal_force", "Force on the body along x", ""), system.force[0]),
        Entry(named("horizontal_force", "Force on the body along y", ""), system.force[1]),
        Entry(named("offset", "Zero-load position x"), solution.neutral.x),
        Entry(named("offset", "Zero-load position y"), solution.neutral.y),
        Entry(named("offset", "Offset along x"), solution.offset[0]),
        Entry(named("offset", "Offset along y"), solution.offset[1]),
        Entry(named("stiffness", "Stiffness", "kxx"), stiffness[0][0]),
        Entry(named("stiffness", "Stiffness", "kxy"), stiffness[0][1]),
        Entry(named("stiffness", "Stiffness", "kyy"), stiffness[1][1]),
    ]
    if system.turns:
        entries[2:2] = [Entry(QUANTITIES["moment"], system.moment)]
        entries += [Entry(named("angle", "Yaw", ""), solution.position.yaw)]
    if report.rule.horizontal_force is not None:
        assert report.rule.line is not None
        own = solution.lines[report.rule.line].horizontal_force
        label = f"Horizontal force of line {report.rule.line + 1}"
        entries += [
            Entry(named("horizontal_force", label, ""), own),
            Entry(
                named("horizontal_force", f"{label} by the rule of practice", ""),
                report.rule.horizontal_force,
            ),
        ]
    return tuple(entries)


def line_columns(report: SystemReport) -> tuple[Column, ...]:
    """List what each line carries."""
    solution = report.solution
    lines = solution.lines
    own = [line.solution for line in lines]
    columns: list[Column] = [
        ("Line", [str(index + 1) for index in range(len(lines))]),
        (named("angle", "Azimuth", ""), [line.leg.azimuth for line in lines]),
        (QUANTITIES["span"], [each.span for each in own]),
        (QUANTITIES["horizontal_force"], [line.horizontal_force for line in lines]),
        (named("tension", "Fairlead tension"), [line.tension for line in lines]),
        (named("tension", "Anchor tension", "TA"), [each.anchor.tension for each in own]),
        (QUANTITIES["grounded_length"], [each.grounded_length for each in own]),
    ]
    used = [line.utilisation(solution.safety_factor) for line in lines]
    if any(value is not None for value in used):
        columns.append((QUANTITIES["utilisation"], used))
    return tuple(columns)


def line_out_columns(report: SystemReport) -> tuple[Column, ...]:
    """List what happens when each line is gone; nothing where there is no equilibrium."""
    return (
        ("Line out", [str(each.missing + 1) for each in report.line_out]),
        *_responses([each.response for each in report.line_out]),
    )


def circle_columns(report: SystemReport) -> tuple[Column, ...]:
    """List where the force takes the body as it goes round."""
    assert report.circle is not None
    return (
        (DIRECTION, report.circle.directions),
        *_responses(report.circle.responses),
    )


def curve_columns(curve: RestoringCurve) -> tuple[Column, ...]:
    """List force and offset along one direction."""
    return (
        (OFFSET, curve.offset),
        (named("horizontal_force", "Force along the direction", ""), curve.force),
        (named("horizontal_force", "Force across it", ""), curve.force_across),
        (LARGEST, [each.largest_tension for each in curve.responses]),
        ("In line", [str(each.most_loaded + 1) for each in curve.responses]),
    )


def level_columns(report: SystemReport) -> tuple[Column, ...]:
    """List what the water level changes."""
    levels = report.levels
    return (
        (named("height", "Water level", ""), [each.level for each in levels]),
        *_responses([each.response for each in levels]),
        (named("stiffness", "Stiffness", "kxx"), [each.stiffness[0][0] for each in levels]),
    )


def _responses(responses: Iterable[Response | None]) -> tuple[Column, ...]:
    rows = list(responses)
    return (
        (named("offset", "Position", "x"), [None if row is None else row.x for row in rows]),
        (named("offset", "Position", "y"), [None if row is None else row.y for row in rows]),
        (OFFSET, [None if row is None else row.offset for row in rows]),
        (LARGEST, [None if row is None else row.largest_tension for row in rows]),
        ("In line", ["-" if row is None else str(row.most_loaded + 1) for row in rows]),
        (
            named("grounded_length", "Shortest grounded length"),
            [None if row is None else row.least_grounded for row in rows],
        ),
    )


def frames(report: SystemReport) -> dict[str, pd.DataFrame]:
    """Make the tables of ``--out``, by the name of their file."""
    import pandas as pd

    from catopt.report.tables.solution import column

    def frame(listed: Iterable[Column]) -> pd.DataFrame:
        laid: dict[str, object] = {}
        for what, values in listed:
            if isinstance(what, str):
                laid[what] = list(values)
            else:
                laid |= column(what, [v if isinstance(v, float) else None for v in values])
        return pd.DataFrame(laid)

    made = {
        "body": pd.DataFrame([{"Title": report.case.title, **columns(body(report))}]),
        "lines": frame(line_columns(report)),
    }
    if report.line_out:
        made["line_out"] = frame(line_out_columns(report))
        made["line_out"]["Refusal"] = [each.refusal for each in report.line_out]
    if report.circle is not None:
        made["watch_circle"] = frame(circle_columns(report))
    for number, curve in enumerate(report.curves, start=1):
        made[f"restoring_{number}"] = frame(curve_columns(curve))
        made[f"restoring_{number}"].insert(
            0, DIRECTION.heading, DIRECTION.to_field(curve.direction)
        )
    if report.levels:
        made["water_levels"] = frame(level_columns(report))
    return made
