"""What ``catopt loads --json`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, get_args

from catopt.documents import figures
from catopt.loads.component import Axis, LoadComponent, Loads

if TYPE_CHECKING:
    from catopt.loads.weathervane import Lying

SCHEMA = "catopt.loads/1"


def loads_document(of: Loads, *others: Loads, lyings: Sequence[Lying] = ()) -> dict[str, Any]:
    """Lay loads out for JSON, in SI: others are by other methods, of the lyings it is the worst."""
    document = {
        "schema": SCHEMA,
        **figures(of, "title horizontal_force_N"),
        **{f"{axis}_N": of.along(axis) for axis in get_args(Axis)},
        "components": [_component(each) for each in of.components],
        **figures(of, "assumptions recalled warnings method"),
        "others": [loads_document(each) for each in others],
    }
    return document | ({"headings": [lying_document(each) for each in lyings]} if lyings else {})


def lying_document(of: Lying) -> dict[str, Any]:
    """Lay out how a ship lies, in SI."""
    return {
        "condition": of.afloat.condition,
        **{f"{name}_from_rad": angle for name, angle in vars(of.directions).items()},
        **figures(of, "heading_rad depth_m"),
        **figures(of.loads, "horizontal_force_N method"),
    }


def _component(of: LoadComponent) -> dict[str, Any]:
    return {
        **figures(of, "name kind axis force_N formula"),
        "numbers": [dict(vars(each)) for each in of.numbers],
        "source": dict(vars(of.source)),
        "note": of.note,
    }
