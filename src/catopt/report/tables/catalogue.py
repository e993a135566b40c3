"""Components and families as pandas tables; every heading of a number carries its unit."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import pandas as pd

from catopt.quantities import QUANTITIES
from catopt.report.tables.summary import named
from catopt.report.wording.catalogue import said_cited, said_formula, said_text

if TYPE_CHECKING:
    from catopt.catalogue import Component, Family, Figure, Hydrodynamic, Source
    from catopt.catalogue.document import Answer
    from catopt.report.texts import Words

__all__ = ["catalogue_tables", "said_tables"]


def catalogue_tables(answer: Answer) -> dict[str, pd.DataFrame]:
    """Tabulate an answer.

    Returns
    -------
    dict of str to DataFrame
        ``components`` (where there are any), ``figures`` with their sources, ``families`` and
        ``sources``.
    """
    tables = {
        "components": _components(answer.components),
        "figures": pd.DataFrame(
            [_figure(family, figure) for family in answer.families for figure in family.figures]
        ),
        "families": pd.DataFrame([_family(family) for family in answer.families]),
        "sources": pd.DataFrame(
            [
                {"Source": source.key, "Title": source.title, "Place": source.place}
                for source in answer.sources
            ]
        ),
    }
    return {name: frame for name, frame in tables.items() if len(frame)}


_SAID: Mapping[str, Mapping[str, Callable[[Words, str], str]]] = {
    "figures": {
        "Default": said_text,
        "Formula": said_formula,
        "Place": said_cited,
        "Reason": said_text,
        "Note": said_text,
    },
    "families": {"Title": said_text, "Note": said_text},
    "sources": {"Title": said_cited, "Place": said_cited},
}
"""Columns of texts that are not names, keys or cited, by table, and how they are said."""


def said_tables(words: Words, tables: Mapping[str, pd.DataFrame]) -> dict[str, pd.DataFrame]:
    """Say the texts of an answer's tables in a language; headings stay English.

    Parameters
    ----------
    words : Words
        Language.
    tables : mapping of str to DataFrame
        As `catalogue_tables` makes them.
    """
    return {
        name: frame.assign(
            **{
                heading: [say(words, text) for text in frame[heading]]
                for heading, say in _SAID.get(name, {}).items()
            }
        )
        for name, frame in tables.items()
    }


_OF_COMPONENTS: dict[str, tuple[str, Callable[[Component], float | None]]] = {
    "Nominal diameter": ("nominal_diameter", lambda c: c.nominal_diameter),
    "Mass in air per length": ("mass_per_length", lambda c: c.mass),
    "Submerged weight per length": ("submerged_weight", lambda c: c.submerged_weight),
    "Volume-equivalent diameter": ("volume_diameter", lambda c: c.volume_diameter),
    "Minimum breaking load": ("MBL", lambda c: c.MBL),
    "Minimum breaking load in water": ("MBL", lambda c: c.MBL_in_water),
    "Proof load": ("proof_load", lambda c: c.proof_load),
    "Axial stiffness": ("EA", lambda c: c.EA),
    "Drag coefficient across the line": ("coefficient", lambda c: _number(c.drag_normal)),
    "Drag diameter across the line": ("drag_diameter", lambda c: _reference(c.drag_normal)),
    "Drag coefficient along the line": ("coefficient", lambda c: _number(c.drag_axial)),
    "Drag diameter along the line": ("drag_diameter", lambda c: _reference(c.drag_axial)),
    "Added-mass coefficient across the line": (
        "coefficient",
        lambda c: _number(c.added_mass_normal),
    ),
    "Added-mass coefficient along the line": (
        "coefficient",
        lambda c: _number(c.added_mass_axial),
    ),
    "Price": ("price", lambda c: c.price),
}
"""Columns of numbers: their quantity and how they are read off a component."""


def _components(components: Sequence[Component]) -> pd.DataFrame:
    """Tabulate components, a row each; added mass is on the volume-equivalent diameter."""
    if not components:
        return pd.DataFrame()
    columns: dict[str, Any] = {
        "Component": [component.name for component in components],
        "Family": [component.family for component in components],
        "Grade": [component.grade or "" for component in components],
    }
    for heading, (key, read) in _OF_COMPONENTS.items():
        quantity = named(key, heading, "")
        values = [read(component) for component in components]
        field = [None if value is None else quantity.to_field(value) for value in values]
        columns[quantity.heading] = pd.Series(field, dtype=float)
    columns["Confidence of MBL"] = [_confidence(component) for component in components]
    columns["Recalled, read in no document"] = [", ".join(c.recalled) for c in components]
    return pd.DataFrame(columns)


def _number(value: Hydrodynamic | None) -> float | None:
    return None if value is None else value.coefficient


def _reference(value: Hydrodynamic | None) -> float | None:
    return None if value is None else value.diameter


def _confidence(component: Component) -> str:
    origin = component.provenance.get("MBL")
    return origin.confidence if origin else ""


def _figure(family: Family, figure: Figure) -> dict[str, Any]:
    return {
        "Family": family.name,
        "Quantity": figure.quantity,
        "Grades": ", ".join(figure.grades),
        "Variant": figure.variant,
        "Default": "yes" if figure.default else "no",
        "Formula": figure.text,
        **_range(figure.range),
        "Confidence": figure.confidence,
        "Sources": _keys(figure.sources),
        "Place": figure.place,
        "Reason": figure.reason,
        "Note": figure.note,
    }


def _family(family: Family) -> dict[str, Any]:
    return {
        "Family": family.name,
        "Title": family.title,
        "Also": ", ".join(family.also),
        "Grades": ", ".join(family.grades),
        **_range(family.range),
        "Sizes": len(family.sizes.diameters),
        "Confidence of the sizes": family.sizes.confidence,
        "Sources of the sizes": _keys(family.sizes.sources),
        "Note": family.note,
    }


def _range(ends: tuple[float, float]) -> dict[str, float]:
    quantity = QUANTITIES["nominal_diameter"]
    names = ("Smallest nominal diameter", "Largest nominal diameter")
    headings = (named(quantity.key, name, "").heading for name in names)
    return {
        heading: round(quantity.to_field(end), 6)
        for heading, end in zip(headings, ends, strict=True)
    }


def _keys(sources: Sequence[Source]) -> str:
    return ", ".join(source.key for source in sources)
