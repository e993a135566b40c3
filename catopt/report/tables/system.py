"""Quantities of a moored body under their names in its figures."""

from __future__ import annotations

from catopt.quantities import QUANTITIES
from catopt.report.tables.summary import named

__all__ = ["LARGEST", "OFFSET"]

OFFSET = QUANTITIES["offset"]
LARGEST = named("tension", "Largest tension", "")
