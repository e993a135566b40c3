"""The column of a quantity."""

from __future__ import annotations

import math
from collections.abc import Iterable

import pandas as pd

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.summary import heading_of

__all__ = ["column"]


def column(quantity: Quantity | str, values: Iterable[float | None]) -> dict[str, pd.Series[float]]:
    """Give values in SI the heading and the unit of a quantity; what is not known stays empty."""
    known = QUANTITIES[quantity] if isinstance(quantity, str) else quantity
    in_field = [math.nan if value is None else known.to_field(value) for value in values]
    return {heading_of(known): pd.Series(in_field, dtype="float64")}
