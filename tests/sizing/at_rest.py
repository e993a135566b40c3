"""Sizings under steady loads alone: what a test of them asks for, in a second."""

from __future__ import annotations

from typing import Any

import catopt
from catopt.sizing import Sizing


def size_buoy(*request: Any, **inputs: Any) -> Sizing:
    """Size a buoy's mooring as `catopt.size_buoy`, with motion left out."""
    return catopt.size_buoy(*request, **_still(request, inputs))


def size_tanker(*request: Any, **inputs: Any) -> Sizing:
    """Size a tanker's mooring as `catopt.size_tanker`, with motion left out."""
    return catopt.size_tanker(*request, **_still(request, inputs))


def _still(request: tuple[Any, ...], inputs: dict[str, Any]) -> dict[str, Any]:
    is_made = bool(request) and not isinstance(request[0], str)
    return inputs if is_made or "in_motion" in inputs else {**inputs, "at_rest": True}
