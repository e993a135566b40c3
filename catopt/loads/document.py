"""What ``catopt loads --json`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from catopt.loads.component import LoadComponent, Loads

if TYPE_CHECKING:
    from catopt.loads.weathervane import Lying

SCHEMA = "catopt.loads/1"


def loads_document(of: Loads, *others: Loads, lyings: Sequence[Lying] = ()) -> dict[str, Any]:
    """Lay loads out for JSON, in SI.

    Parameters
    ----------
    of : Loads
        On a buoy or a ship.
    *others : Loads
        By other methods, for comparison.
    lyings : sequence of Lying
        The cases of which the worst is laid out.
    """
    document = {
        "schema": SCHEMA,
        "title": of.title,
        "horizontal_force_N": of.horizontal_force,
        "along_N": of.along("along"),
        "surge_N": of.along("surge"),
        "sway_N": of.along("sway"),
        "components": [_component(each) for each in of.components],
        "assumptions": list(of.assumptions),
        "recalled": list(of.recalled),
        "warnings": list(of.warnings),
        "method": of.method,
        "others": [loads_document(each) for each in others],
    }
    return document | ({"headings": [lying_document(each) for each in lyings]} if lyings else {})


def lying_document(of: Lying) -> dict[str, Any]:
    """Lay out how a ship lies, in SI."""
    return {
        "condition": of.afloat.condition,
        "wind_from_rad": of.directions.wind,
        "current_from_rad": of.directions.current,
        "waves_from_rad": of.directions.waves,
        "heading_rad": of.heading,
        "depth_m": of.depth,
        "horizontal_force_N": of.loads.horizontal_force,
        "method": of.loads.method,
    }


def _component(of: LoadComponent) -> dict[str, Any]:
    return {
        "name": of.name,
        "kind": of.kind,
        "axis": of.axis,
        "force_N": of.force,
        "formula": of.formula,
        "numbers": [
            {"symbol": n.symbol, "value": n.value, "unit": n.unit, "meaning": n.meaning}
            for n in of.numbers
        ],
        "source": {
            "document": of.source.document,
            "clause": of.source.clause,
            "confidence": of.source.confidence,
        },
        "note": of.note,
    }
