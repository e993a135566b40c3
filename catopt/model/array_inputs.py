"""Arrays as they are given, of any library, to arrays of numbers in SI."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.errors import InputError
from catopt.model.kinds import DIMENSIONS, Findings, number_wanted
from catopt.units import is_quantity, of_quantity
from catopt.words import Message

_NUMBERS: Final = {float, int, np.float64, np.float32, np.int64, np.int32}
_SHOWN: Final = 10
"""Problems after which no more of one array are looked for."""


def array_in_si(found: Findings, key: str, values: Any, unit: str) -> Array:
    """Return numbers, alone or in arrays or sequences of any depth, in SI.

    Text with a unit is read, alone or in a sequence. Quantities of pint, astropy and unyt are
    converted, and xarray's and pandas' whose attributes have ``units``. Masked and missing values,
    true and false, dates and complex numbers are problems. Whether numbers are finite and in range
    is for the caller.

    Parameters
    ----------
    found : Findings
        Where problems are noted; a number or more of the result is then nan.
    key : str
        What is given, for messages.
    values : object
        As above.
    unit : str
        Of SI, as messages about arguments write it: ``"N/m"``; empty for pure numbers.

    Examples
    --------
    >>> from catopt.model.kinds import Findings
    >>> array_in_si(Findings("doc"), "force", [1000.0, "2 kN"], "N")
    array([1000., 2000.])
    """
    is_array = type(values) is np.ndarray and values.dtype.kind in "iuf"
    if is_array or type(values) is float:
        return np.asarray(values, dtype=np.float64)
    if isinstance(values, str):
        return np.asarray(found.taken(key, values, unit))
    if is_quantity(values):
        try:
            values = of_quantity(values, DIMENSIONS[unit], key)
        except InputError as error:
            found.problems += error.problems
            return np.array(math.nan)
    if isinstance(values, list | tuple) and not set(map(type, values)) <= _NUMBERS:
        return _each(found, key, values, unit)
    try:
        plain = np.asarray(values)
    except (TypeError, ValueError):
        found.add(key, type(values).__name__, number_wanted(unit))
        return np.array(math.nan)
    masked = np.count_nonzero(np.ma.getmaskarray(values)) if np.ma.isMaskedArray(values) else 0
    if masked:
        found.add(key, Message("refused.masked", count=masked), number_wanted(unit))
    elif plain.dtype.kind in "iuf":
        return plain.astype(np.float64) * _label(found, key, values, unit)
    elif plain.dtype.kind in "OUS" and plain.ndim > 0:
        return _each(found, key, plain.tolist(), unit)
    else:
        shown = repr(values) if plain.ndim == 0 else f"{plain.dtype}"
        found.add(key, shown, number_wanted(unit))
    return np.array(math.nan)


def _each(found: Findings, key: str, values: list[Any] | tuple[Any, ...], unit: str) -> Array:
    """Read the items of a sequence; rows of several lengths are a problem."""
    read, before = [], len(found.problems)
    for k, each in enumerate(values):
        read.append(array_in_si(found, f"{key}[{k}]", each, unit))
        if len(found.problems) >= before + _SHOWN:
            break
    if len({each.shape for each in read}) > 1:
        if len(found.problems) == before:
            found.add(key, Message("refused.rows_of_lengths"), number_wanted(unit))
        return np.array(math.nan)
    return np.array(read, dtype=np.float64)


def _label(found: Findings, key: str, values: Any, unit: str) -> float:
    """SI units in one of the unit that xarray or pandas has among its attributes."""
    label = getattr(values, "attrs", {}).get("units", "")
    if label in ("", unit):
        return 1.0
    return found.taken(f"{key}.attrs", f"1 {label}", unit)
