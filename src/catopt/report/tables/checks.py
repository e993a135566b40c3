"""Checks as pandas tables: a row each check, with its own unit."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import pandas as pd

from catopt.quantities import QUANTITIES
from catopt.report.tables.solution import column
from catopt.report.tables.summary import named
from catopt.report.wording.checks import QUANTITY_OF, governing_sentence, verdict_sentence

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport, CheckResult

__all__ = ["check_rows", "check_rows_in_si", "check_summary", "checks", "load_cases"]


def checks(report: CheckReport) -> pd.DataFrame:
    """Tabulate every check, a row each by load case."""
    return pd.DataFrame(check_rows(report.results), columns=list(_HEADINGS))


_HEADINGS = (
    "Load case",
    "Check",
    "Demand (unit of the row)",
    "Capacity (unit of the row)",
    "Unit",
    "Utilisation (-)",
    "Passes",
    "Code",
    "Source",
    "Note",
)


def check_rows(results: Iterable[CheckResult]) -> list[dict[str, Any]]:
    """Lay checks out as rows, in the field's units.

    Parameters
    ----------
    results : iterable of CheckResult
        Of one report or of several.

    Returns
    -------
    list of dict
        By heading.
    """
    rows = []
    for result in results:
        quantity = QUANTITY_OF[result.kind]
        values = (
            result.load_case,
            result.name,
            quantity.to_field(result.demand),
            quantity.to_field(result.capacity),
            quantity.field_unit,
            result.utilisation,
            "yes" if result.passes else "no",
            result.source.code,
            result.source.text,
            result.note,
        )
        rows.append(dict(zip(_HEADINGS, values, strict=True)))
    return rows


def check_rows_in_si(results: Iterable[CheckResult]) -> list[dict[str, Any]]:
    """Lay checks out as rows, in SI: those of the searches and the sizings."""
    return [
        {
            "Load case": result.load_case,
            "Check": result.name,
            "Demand (unit of the row)": result.demand,
            "Capacity (unit of the row)": result.capacity,
            "Unit": result.unit,
            "Utilisation (-)": result.utilisation,
            "Passes": "yes" if result.passes else "no",
            "Source": result.source.text,
            "Note": result.note,
        }
        for result in results
    ]


def load_cases(report: CheckReport) -> pd.DataFrame:
    """Tabulate how the line hangs in each load case, a row each."""
    names = [name for name, _ in report.solutions]
    solved = [solution for _, solution in report.solutions]
    states = report.load_cases
    return pd.DataFrame(
        {
            "Load case": names,
            "Kind": [state.kind for state in states] or ["extreme"] * len(names),
            **column("fairlead_height", (each.fairlead_height for each in solved)),
            **column("horizontal_force", (each.horizontal_force for each in solved)),
            **column("span", (each.span for each in solved)),
            **column(
                named("tension", "Fairlead tension"), (each.fairlead.tension for each in solved)
            ),
            **column(
                named("vertical_force", "Fairlead vertical force"),
                (each.fairlead.vertical_force for each in solved),
            ),
            **column(
                named("horizontal_force", "Anchor horizontal force"),
                (each.anchor.horizontal_force for each in solved),
            ),
            **column(
                named("vertical_force", "Anchor vertical force"),
                (each.anchor.vertical_force for each in solved),
            ),
            **column(
                named("angle", "Inclination at the anchor"),
                (each.anchor.angle for each in solved),
            ),
            **column("grounded_length", (each.grounded_length for each in solved)),
        }
    )


def check_summary(report: CheckReport) -> pd.DataFrame:
    """Tabulate the verdict, in one row."""
    governing = report.governing
    utilisation = None if governing is None else governing.utilisation
    return pd.DataFrame(
        [
            {
                "Title": report.title,
                "Verdict": verdict_sentence(report),
                "Governing": governing_sentence(report),
                QUANTITIES["utilisation"].heading: utilisation,
                "Warnings": "; ".join(report.warnings),
            }
        ]
    )
