"""A sizing as tables; every heading carries its unit."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import pandas as pd

from catopt.report.tables import loads
from catopt.report.tables.checks import check_rows_in_si
from catopt.report.tables.loads import load_notes, load_numbers, loads_table
from catopt.report.wording.size import SHOTS, candidate_rows, governing_lines, summary

if TYPE_CHECKING:
    from catopt.loads.component import Loads
    from catopt.sizing import Sizing

__all__ = ["SAID", "SHOTS", "size_tables"]

SAID = loads.SAID | {
    "What",
    "In words",
    "Which",
    "Verdict",
    "Load case",
    "Check",
    "Passes",
    "On",
}
"""Headings of the columns with words; the others hold components, numbers and what is cited."""


def size_tables(of: Sizing) -> dict[str, pd.DataFrame]:
    """Tabulate a sizing.

    Parameters
    ----------
    of : Sizing
        Of a buoy or a tanker.

    Returns
    -------
    dict of str to DataFrame
        ``sizing``, ``candidates``, ``checks``, ``forces``, ``numbers``, ``notes`` and, of several
        lines, ``pattern``.
    """
    found = {
        "sizing": _summary(of),
        "candidates": _candidates(of),
        "checks": _checks(of),
        "forces": _of_loads(of, loads_table),
        "numbers": _of_loads(of, load_numbers),
        "notes": _notes(of),
    }
    if of.pattern is not None:
        found["pattern"] = _pattern(of)
    return found


def _summary(of: Sizing) -> pd.DataFrame:
    rows = [(fact.label, fact.value, fact.unit, fact.words) for fact in summary(of)]
    return pd.DataFrame(rows, columns=["What", "Value (unit of the row)", "Unit", "In words"])


def _candidates(of: Sizing) -> pd.DataFrame:
    columns = [
        "Which",
        "Chain",
        "Length L (m)",
        "Mass in air (kg)",
        "Largest span S (m)",
        "Anchor, mass in air (kg)",
        "Verdict",
    ]
    return pd.DataFrame(candidate_rows(of), columns=columns)


def _checks(of: Sizing) -> pd.DataFrame:
    return pd.DataFrame(check_rows_in_si(of.point.checks.results))


def _of_loads(of: Sizing, tabulate: Callable[[Loads], pd.DataFrame]) -> pd.DataFrame:
    """Stack a table of every part of every load case, with the load case in front."""
    frames = [
        tabulate(part).assign(**{"Load case": each.load_case, "On": part.title})
        for each in of.settled.posed.loads
        for part in each.parts
    ]
    if not frames:
        given = [(each.load_case, each.given / 1e3) for each in of.settled.posed.loads]
        return pd.DataFrame(given, columns=["Load case", "Force F, given (kN)"])
    frame: pd.DataFrame = pd.concat(frames, ignore_index=True)
    first = ["Load case", "On"]
    return frame[[*first, *(name for name in frame.columns if name not in first)]]


def _notes(of: Sizing) -> pd.DataFrame:
    kinds = {
        "governs": governing_lines(of),
        "recommendation": [of.why],
        "assumption": of.assumptions,
        "taken, not given": of.defaults,
        "recalled (R)": of.recalled,
        "warning": of.warnings,
    }
    rows = [(kind, text) for kind, texts in kinds.items() for text in texts]
    for each in of.settled.posed.loads:
        for part in each.parts:
            notes = load_notes(part)
            rows += [
                (f"{each.load_case}: {kind}", text)
                for kind, text in notes.itertuples(index=False)
                if kind == "assumption"
            ]
    return pd.DataFrame(rows, columns=["Kind", "Text"]).drop_duplicates()


def _pattern(of: Sizing) -> pd.DataFrame:
    assert of.pattern is not None
    rows = [
        {
            "Load case": state.load_case,
            "Force on the body (kN)": state.force / 1e3,
            "Most loaded line by the rule of S4, H (kN)": (
                None if state.rule_force is None else state.rule_force / 1e3
            ),
            "Most loaded line in equilibrium, H (kN)": state.line_force / 1e3,
            "Its tension T (kN)": state.tension / 1e3,
            "Force off that line (rad)": state.direction,
            "Largest offset of the body, any direction (m)": state.offset,
            "Pull of all lines (kN)": state.pull / 1e3,
        }
        for state in of.pattern.states
    ]
    return pd.DataFrame(rows)
