"""What catopt's search for a line uses of numpy, in plain Python, for browsers.

No package registry has numpy for a browser. `catopt web` packs this file under the name of numpy,
so that sizing a buoy or a ship is the same code there as everywhere. It has what that code uses and
nothing else: whatever is missing raises AttributeError. Arrays have up to three axes; rows and
slices are views, as in numpy, all else is a copy. Numbers are those of numpy to the last digit.
"""

from __future__ import annotations

import math
import operator
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from contextlib import nullcontext
from functools import reduce
from itertools import accumulate
from typing import Any

inf, nan, pi = math.inf, math.nan, math.pi
float64, int64, bool_ = float, int, bool
float32, int32 = float, int

_ALL = slice(None)


def _turned(what: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    return lambda a, b: what(b, a)


def _by(what: Callable[[Any, Any], Any]) -> Callable[[ndarray, Any], ndarray]:
    """Make the operation that combines number by number."""
    return lambda self, other: self._with(other, what)


def _over(what: Callable[[list[Any]], Any]) -> Callable[..., Any]:
    """Make the operation that puts all numbers together, or those along an axis of a table."""

    def over(self: ndarray, axis: int | None = None) -> Any:
        if axis is None:
            return what(self._flat())
        rows = self.T if axis == 0 else self
        return ndarray([what(list(row)) for row in rows], (len(rows),))

    return over


def _sum(values: list[Any]) -> Any:
    """Add up in the order in which numpy does."""
    count = len(values)
    if count < 8:
        return reduce(operator.add, values, 0)  # sum() keeps what numpy rounds off
    if count > 128:
        half = count // 2 - count // 2 % 8
        return _sum(values[:half]) + _sum(values[half:])
    whole = count - count % 8
    a, b, c, d, e, f, g, h = (reduce(operator.add, values[k:whole:8]) for k in range(8))
    eight = ((a + b) + (c + d)) + ((e + f) + (g + h))
    return reduce(operator.add, values[whole:], eight)


class ndarray:  # noqa: N801 - the name it takes the place of
    """Numbers in a list, from `start` on, row by row."""

    __slots__ = ("data", "shape", "size", "start")

    def __init__(self, data: list[Any], shape: tuple[int, ...], start: int = 0) -> None:
        self.data, self.shape, self.start = data, shape, start
        self.size = math.prod(shape)

    def __class_getitem__(cls, _: Any) -> type:
        return cls

    @property
    def ndim(self) -> int:
        """How many axes there are."""
        return len(self.shape)

    @property
    def T(self) -> ndarray:
        """A table with rows for columns, copied."""
        rows, columns = self.shape
        flat = self._flat()
        turned = [flat[row * columns + column] for column in range(columns) for row in range(rows)]
        return ndarray(turned, (columns, rows))

    def _flat(self) -> list[Any]:
        return self.data[self.start : self.start + self.size]

    def __len__(self) -> int:
        return self.shape[0]

    def __iter__(self) -> Iterator[Any]:
        if len(self.shape) == 1:
            return iter(self._flat())
        return map(self.__getitem__, range(len(self)))

    def __getitem__(self, at: Any) -> Any:
        kind, shape = at.__class__, self.shape
        if kind is int and len(shape) == 1 and 0 <= at < self.size:
            return self.data[self.start + at]
        if kind is tuple:
            row, column = at[0], at[1]
            if row.__class__ is column.__class__ is int and len(at) == len(shape) == 2:
                return self.data[
                    self.start + range(shape[0])[row] * shape[1] + range(shape[1])[column]
                ]
            return self._at(*at)
        if kind is int:
            if not -shape[0] <= at < shape[0]:
                raise IndexError(f"{at} of {shape[0]}")
            at %= shape[0]
            if len(shape) == 1:
                return self.data[self.start + at]
            return ndarray(self.data, shape[1:], self.start + at * (self.size // shape[0]))
        if kind is slice and at.step in (None, 1):
            first, end, _ = at.indices(shape[0])
            width = self.size // shape[0] if shape[0] else 0
            return ndarray(self.data, (max(end - first, 0), *shape[1:]), self.start + first * width)
        return _stacked([self[row] for row in _places(at, shape[0])], shape[1:])

    def _at(self, row: Any, *more: Any) -> Any:
        """Find what two or three indices ask for."""
        if row.__class__ is int:
            return self[row][more[0] if len(more) == 1 else more]
        taken = [self[place][more[0]] for place in _places(row, len(self))]
        width = len(_places(more[0], self.shape[1]))
        return _stacked(taken, () if more[0].__class__ is int else (width,))

    def __setitem__(self, at: Any, value: Any) -> None:
        if at.__class__ is int and len(self.shape) == 1 and 0 <= at < self.size:
            self.data[self.start + at] = value
            return
        row, column = at if at.__class__ is tuple else (at, _ALL)
        if row.__class__ is int and len(self.shape) > 1:
            self[row][column] = value
            return
        many = isinstance(value, (ndarray, list, tuple))
        for number, place in enumerate(_places(row, len(self))):
            own = value[number] if many else value
            if len(self.shape) == 1:
                self.data[self.start + range(self.size)[place]] = own
            else:
                self[place][column] = own

    def _with(self, other: Any, what: Callable[[Any, Any], Any]) -> ndarray:
        """Combine number by number; one row goes with every row of a table."""
        own = self._flat()
        if not isinstance(other, ndarray):
            return ndarray([what(value, other) for value in own], self.shape)
        if self.size < other.size:
            return other._with(self, _turned(what))
        theirs = other._flat()
        if self.shape != other.shape:
            if self.shape[1:] != other.shape:
                raise ValueError(f"shapes {self.shape} and {other.shape}")
            theirs = theirs * len(self)
        return ndarray([what(a, b) for a, b in zip(own, theirs, strict=True)], self.shape)

    def _each(self, what: Callable[[Any], Any]) -> ndarray:
        return ndarray([what(value) for value in self._flat()], self.shape)

    __add__ = _by(operator.add)
    __sub__ = _by(operator.sub)
    __rsub__ = _by(_turned(operator.sub))
    __mul__ = __rmul__ = _by(operator.mul)
    __truediv__ = _by(operator.truediv)
    __rtruediv__ = _by(_turned(operator.truediv))
    __lt__ = _by(operator.lt)
    __le__ = _by(operator.le)
    __gt__ = _by(operator.gt)
    __ge__ = _by(operator.ge)
    __eq__ = _by(operator.eq)  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]

    def __neg__(self) -> ndarray:
        return self._each(operator.neg)

    min = _over(min)
    max = _over(max)
    sum = _over(_sum)
    all = _over(all)
    astype = _each

    def tolist(self) -> list[Any]:
        """List the numbers, row by row."""
        if len(self.shape) == 1:
            return self._flat()
        return [row.tolist() for row in self]


NDArray = ndarray
ArrayLike = Any


def _places(at: Any, count: int) -> list[int]:
    """List the rows that a slice, a mask, some numbers or one number ask for."""
    if at.__class__ is int:
        return [at]
    if at.__class__ is slice:
        return list(range(*at.indices(count)))
    chosen = at.tolist() if isinstance(at, ndarray) else list(at)
    if len(chosen) == count and all(mark is True or mark is False for mark in chosen):
        return [number for number, mark in enumerate(chosen) if mark]
    return chosen


def _stacked(parts: Sequence[Any], shape: tuple[int, ...]) -> ndarray:
    """Put numbers or rows, each of a shape, into one array."""
    if not shape:
        return ndarray(list(parts), (len(parts),))
    flat = [value for part in parts for value in part._flat()]
    return ndarray(flat, (len(parts), *shape))


def array(values: Any, dtype: type | None = None) -> ndarray:
    """Make an array of numbers, rows or rows of rows."""
    if isinstance(values, ndarray):
        return ndarray(values._flat(), values.shape) if dtype is None else values.astype(dtype)
    values = list(values)
    if values and isinstance(values[0], (list, tuple, ndarray)):
        rows = [array(row, dtype) for row in values]
        return _stacked(rows, rows[0].shape)
    if dtype is None and any(isinstance(value, float) for value in values):
        dtype = float
    return ndarray([dtype(value) for value in values] if dtype else values, (len(values),))


def asarray(values: Any, dtype: type | None = None) -> ndarray:
    """Make an array of what is none yet."""
    return values if isinstance(values, ndarray) else array(values, dtype)


ascontiguousarray = asarray


def full(shape: int | tuple[int, ...], value: Any, dtype: type = float) -> ndarray:
    """Make an array of one number."""
    whole = (shape,) if isinstance(shape, int) else shape
    return ndarray([dtype(value)] * math.prod(whole), whole)


def zeros(shape: int | tuple[int, ...], dtype: type = float) -> ndarray:
    """Make an array of zeros."""
    return full(shape, 0, dtype)


empty = zeros


def empty_like(values: ndarray) -> ndarray:
    """Make an array of the same shape."""
    return zeros(values.shape)


def arange(first: int, end: int, dtype: type = int) -> ndarray:  # noqa: ARG001
    """List whole numbers."""
    return ndarray(list(range(first, end)), (max(end - first, 0),))


def linspace(first: float, last: float, count: int) -> ndarray:
    """Divide a range evenly."""
    step = (last - first) / (count - 1) if count > 1 else 0.0
    values = [float(k * step + first) for k in range(count)]
    if count > 1:
        values[-1] = float(last)
    return ndarray(values, (count,))


def concatenate(parts: Sequence[Any]) -> ndarray:
    """Put arrays one after the other."""
    arrays = [asarray(part) for part in parts]
    flat = [value for part in arrays for value in part._flat()]
    return ndarray(flat, (sum(map(len, arrays)), *arrays[0].shape[1:]))


def diff(values: ndarray) -> ndarray:
    """Subtract each number from the next."""
    return asarray(values[1:] - values[:-1])


def where(condition: ndarray, one: Any, other: Any) -> ndarray:
    """Choose number by number."""
    count = condition.size
    ones, others = (
        side._flat() if isinstance(side, ndarray) else [side] * count for side in (one, other)
    )
    chosen = zip(condition._flat(), ones, others, strict=True)
    return ndarray([a if is_so else b for is_so, a, b in chosen], condition.shape)


def divmod(values: ndarray, by: int) -> tuple[ndarray, ndarray]:  # noqa: A001
    """Divide whole numbers with what is left over."""
    return values._with(by, operator.floordiv), values._with(by, operator.mod)


def isfinite(values: ndarray) -> ndarray:
    """Say which are numbers."""
    return values._each(math.isfinite)


def abs(values: ndarray) -> ndarray:  # noqa: A001
    """Take the sizes."""
    return values._each(lambda each: each if each >= 0 else -each)


def ptp(values: ndarray, axis: int | None = None) -> Any:
    """Take the largest less the smallest."""
    return values.max(axis) - values.min(axis)


def _first(which: Callable[[list[Any]], Any]) -> Callable[[ndarray], int]:
    """Make the operation that finds the first of the smallest or of the largest."""
    return lambda values: values._flat().index(which(values._flat()))


argmin, argmax = _first(min), _first(max)


def flatnonzero(values: ndarray) -> ndarray:
    """List where something is true."""
    return array([number for number, value in enumerate(values._flat()) if value])


def argsort(values: ndarray, kind: str = "stable") -> ndarray:  # noqa: ARG001
    """List places by rising number."""
    return array(sorted(range(len(values)), key=values._flat().__getitem__))


def lexsort(keys: Any) -> ndarray:
    """List places by rising last key, then by the one before it."""
    rows = list(zip(*reversed([list(key) for key in keys]), strict=True))
    return array(sorted(range(len(rows)), key=rows.__getitem__))


def searchsorted(values: ndarray, value: float, side: str = "left") -> int:
    """Find where a number belongs."""
    return (bisect_right if side == "right" else bisect_left)(values._flat(), value)


class minimum:  # noqa: N801
    """The smaller of two."""

    @staticmethod
    def accumulate(values: ndarray, out: ndarray | None = None) -> ndarray:
        """Take the smallest so far, number by number."""
        found = list(accumulate(values, min))
        if out is None:
            return array(found)
        out[_ALL] = found
        return out


def errstate(**_: str) -> Any:
    """Do nothing: numbers of Python say themselves what is wrong."""
    return nullcontext()
