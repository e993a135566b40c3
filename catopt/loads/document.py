"""What ``catopt loads --json`` prints."""

from __future__ import annotations

from typing import Any

from catopt.loads.component import LoadComponent, Loads

__all__ = ["SCHEMA", "loads_document"]

SCHEMA = "catopt.loads/1"


def loads_document(of: Loads, *others: Loads) -> dict[str, Any]:
    """Lay loads out for JSON, in SI.

    Parameters
    ----------
    of : Loads
        On a buoy or a ship.
    *others : Loads
        By other methods, for comparison.
    """
    return {
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
