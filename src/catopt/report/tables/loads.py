"""Loads as pandas tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pandas as pd

if TYPE_CHECKING:
    from catopt.loads.component import Loads

__all__ = ["SAID", "load_notes", "load_numbers", "loads_table"]

SAID = frozenset({"Force", "Axis", "Meaning", "Note", "Kind", "Text"})
"""Headings of the columns with words; the others hold formulas, numbers and what is cited."""


def loads_table(of: Loads) -> pd.DataFrame:
    """Tabulate the forces, a row each, and their sum."""
    rows = [
        {
            "Force": each.name,
            "Axis": each.axis,
            "Force F (kN)": each.force / 1e3,
            "Formula": each.formula,
            "Numbers": each.numbers_text,
            "Source": each.source.text,
            "Note": each.note,
        }
        for each in of.components
    ]
    total = {"Force": "horizontal force", "Axis": "", "Force F (kN)": of.horizontal_force / 1e3}
    blank = dict.fromkeys(("Formula", "Numbers", "Source", "Note"), "")
    return pd.DataFrame([*rows, {**total, **blank}])


def load_numbers(of: Loads) -> pd.DataFrame:
    """Tabulate every number that was put in, in SI and with all digits."""
    columns = ["Force", "Symbol", "Meaning", "Value (unit of the row)", "Unit"]
    rows = [
        (each.name, number.symbol, number.meaning, number.value, number.unit or "-")
        for each in of.components
        for number in each.numbers
    ]
    return pd.DataFrame(rows, columns=columns)


def load_notes(of: Loads) -> pd.DataFrame:
    """Tabulate assumptions and warnings."""
    kinds = {"assumption": of.assumptions, "warning": of.warnings, "recalled (R)": of.recalled}
    rows = [(kind, text) for kind, texts in kinds.items() for text in texts]
    return pd.DataFrame(rows, columns=["Kind", "Text"])
