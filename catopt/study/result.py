"""What came of a study: statistics over its members, the worst of them, and what matters."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from catopt.arrays import Array, Codes
from catopt.documents import figures
from catopt.errors import InputError, Problem, need_package
from catopt.shown import Displayable
from catopt.study.base import Output
from catopt.study.reliability import FirstOrder, counted_interval, first_order
from catopt.study.store import Store
from catopt.study.study import Study
from catopt.words import Message

if TYPE_CHECKING:
    from xarray import Dataset


def study_document(result: StudyResult) -> dict[str, Any]:
    """Build the document (schema catopt.study/1); values in SI, members counted from 1."""
    study = result.study
    return {
        "schema": "catopt.study/1",
        "title": study.title,
        "compute": study.base.compute,
        "members": len(study),
        "done": result.done,
        "without_answer": len(result.reasons),
        "varied": [
            {"keys": list(axis.columns), "values": len(axis), "drawn": axis.is_drawn}
            for axis in study.axes
        ],
        "digest": study.digest,
        "statistics": [_statistic(each, result) for each in result.statistics],
        "by_choice": [
            {
                "name": each.kept.name,
                "member": each.member + 1,
                **figures(each, "beyond count share interval"),
            }
            for each in result.by_choice
        ],
        "influences": [
            {
                "keys": list(each.keys),
                "share_of_variance": each.share,
                "least_mean": each.low,
                "largest_mean": each.high,
            }
            for each in result.influences
        ],
        "counts": [
            {"name": name, "text": text, "members": n}
            for name, counted in result.counted().items()
            for text, n in counted
        ],
        "failures": [
            {"reason": reason, "members": n, "first": first + 1}
            for reason, n, first in result.failures()
        ],
    }


def _statistic(each: Statistic, result: StudyResult) -> dict[str, Any]:
    study = result.study
    order = result.first_orders.get(each.kept.name)
    return {
        "name": each.kept.name,
        "unit": each.kept.measure.si_unit,
        "members": each.count,
        **figures(each, "mean deviation least largest"),
        "levels": [
            {"share": share, "value": value}
            for share, value in zip(result.levels, each.levels, strict=True)
        ],
        "worst": {
            "member": each.worst + 1,
            "values": [
                {"key": key, "value": value} for key, value in study.values_of(each.worst).items()
            ],
        },
        "limit": each.limit,
        "share_beyond": each.beyond,
        "first_beyond": None if each.first_beyond is None else each.first_beyond + 1,
        "interval_beyond": None if each.interval is None else list(each.interval),
        "first_order": None
        if order is None
        else {
            **figures(order, "index probability"),
            "point": [
                {"key": key, "value": value, "importance": order.importance[key]}
                for key, value in order.point.items()
            ],
            "others": [
                {
                    "index": index,
                    "point": [{"key": key, "value": value} for key, value in point.items()],
                }
                for index, point in order.others
            ],
            "sampled": order.sampled,
            "interval_sampled": None if order.interval is None else list(order.interval),
        },
        "no_first_order": result.no_first_orders.get(each.kept.name),
    }


LEVELS: Final = (0.05, 0.5, 0.95, 0.99)
"""Shares of the members below which a value is that is given."""

_BINS = 20
"""Into which values are parted that are drawn, or are too many to be looked at one by one."""

_MOST_SHOWN = 10
"""Reasons, and texts, that are given."""


@dataclass(frozen=True)
class Statistic:
    """One quantity over all members that have it, each by what it counts.

    `count`: members that have it; `mean`, `deviation`: of it, in SI; `least`, `largest`: of all
    members, in SI; `levels`: values that a share of `LEVELS` does not exceed; `worst`: member at
    its bad end, from 0; `limit`, `beyond`: a limit, and the share of the members beyond it;
    `interval`: of the probability to be beyond it, where nothing but draws varies; `first_beyond`:
    the first member beyond it, from 0; None where none is.
    """

    kept: Output
    count: int
    mean: float
    deviation: float
    least: float
    largest: float
    levels: tuple[float, ...]
    worst: int
    limit: float | None = None
    beyond: float | None = None
    interval: tuple[float, float] | None = None
    first_beyond: int | None = None


@dataclass(frozen=True)
class ByChoice:
    """How often a limit is passed by the draws of one choice of what is not drawn.

    `member`: the first of its members, from 0; `beyond`, `count`: draws beyond the limit, of how
    many with an answer.
    """

    kept: Output
    member: int
    beyond: int
    count: int

    @property
    def share(self) -> float:
        """Of the draws."""
        return self.beyond / self.count

    @property
    def interval(self) -> tuple[float, float]:
        """Of the probability."""
        return counted_interval(self.beyond, self.count)


@dataclass(frozen=True)
class Influence:
    """How much of the spread of a quantity one of the things that vary explains.

    `keys`: key paths that vary together; `share`: of the variance, what would go if they were known
    (first-order index, by parts of equal count where there are many values); `low`, `high`: least
    and largest mean of the quantity over their values, in SI.
    """

    keys: tuple[str, ...]
    share: float
    low: float
    high: float


@dataclass(frozen=True, eq=False, repr=False)
class StudyResult(Displayable):
    """A study and what was computed of it, whole or as far as it went."""

    study: Study
    """What was asked."""
    store: Store
    """What was computed."""

    def __repr__(self) -> str:
        return (
            f"StudyResult({self.study.title!r}, members={len(self.study)}, done={self.done}, "
            f"without_answer={len(self.reasons)})"
        )

    @cached_property
    def done(self) -> int:
        """Members that were computed, with an answer or without."""
        start = self.study.piece_start
        return sum(start(k + 1) - start(k) for k in self.store.done())

    @property
    def is_complete(self) -> bool:
        """Whether all were."""
        return self.done == len(self.study)

    @property
    def levels(self) -> tuple[float, ...]:
        """Shares whose values the statistics give."""
        return LEVELS

    @property
    def measured(self) -> tuple[Output, ...]:
        """Numbers that are kept."""
        return tuple(each for each in self.study.base.kept if each.quantity)

    def values(self, name: str) -> Array:
        """Return one quantity of all members in SI, nan where there is no answer.

        Raises InputError where nothing of that name is kept.
        """
        names = [each.name for each in self.measured]
        if name not in names:
            raise InputError(
                [Problem("name", f'"{name}"', Message("refused.one_of", words=", ".join(names)))]
            )
        return self.store.column(names.index(name))

    @cached_property
    def reasons(self) -> dict[int, str]:
        """Why members have no answer, by their numbers from 0."""
        return self.store.reasons()

    @cached_property
    def statistics(self) -> tuple[Statistic, ...]:
        """Of every quantity that any member has."""
        shares = self.study.shares()
        found = (
            self._statistic(each, self.store.column(at), shares)
            for at, each in enumerate(self.measured)
        )
        return tuple(each for each in found if each is not None)

    def _statistic(self, kept: Output, values: Array, shares: Array) -> Statistic | None:
        there = np.flatnonzero(np.isfinite(values) & (shares > 0.0))
        if not there.size:
            return None
        values, shares = values[there], shares[there] / shares[there].sum()
        mean = float(shares @ values)
        order = np.argsort(values, kind="stable")
        reached = np.cumsum(shares[order])
        places = np.searchsorted(reached, np.array(LEVELS) * (1.0 - 1e-12))
        levels = values[order][np.minimum(places, values.size - 1)]
        worst = np.argmax(values) if kept.high_is_worse else np.argmin(values)
        limit = self.study.limits.get(kept.name)
        beyond = interval = first_beyond = None
        if limit is not None:
            is_beyond = kept.beyond(values, limit)
            beyond = float(shares[is_beyond].sum())
            if is_beyond.any():
                first_beyond = int(there[np.argmax(is_beyond)])
            if self.study.distributions:
                interval = counted_interval(int(is_beyond.sum()), int(there.size))
        return Statistic(
            kept,
            int(there.size),
            mean,
            float(np.sqrt(shares @ (values - mean) ** 2)),
            float(values.min()),
            float(values.max()),
            tuple(levels.tolist()),
            int(there[worst]),
            limit,
            beyond,
            interval,
            first_beyond,
        )

    def to_xarray(self) -> Dataset:
        """Return what is kept of the members as a dataset with a dimension for all that varies.

        Numbers are in SI, with their unit among the attributes; nan where there is no answer. Needs
        the package xarray: ``pip install "catopt[tables]"``.
        """
        need_package("xarray", "tables", "to_xarray")
        import xarray

        study = self.study
        names = [axis.name for axis in study.axes]
        sizes = [len(axis) for axis in study.axes]
        kept = {}
        for at, each in enumerate(self.measured):
            column = self.store.column(at).reshape(sizes)
            kept[each.name] = (names, column, {"units": each.measure.si_unit})
        along = {
            key: (axis.name, np.asarray(values))
            for axis in study.axes
            for key, values in axis.columns.items()
        }
        return xarray.Dataset(kept, along, {"title": study.title})

    @cached_property
    def by_choice(self) -> tuple[ByChoice, ...]:
        """How often each limit is passed by the draws of each choice of what is not drawn."""
        drawn = math.prod(len(axis) for axis in self.study.axes if axis.is_drawn)
        choices = len(self.study) // drawn
        if not any(axis.is_drawn for axis in self.study.axes) or choices == 1:
            return ()
        found = []
        for each in self.statistics:
            if each.limit is None:
                continue
            # Draws vary fastest: they are the last axis.
            values = self.values(each.kept.name).reshape(choices, drawn)
            for choice, row in enumerate(values):
                known = row[np.isfinite(row)]
                if known.size:
                    beyond = int(each.kept.beyond(known, each.limit).sum())
                    found.append(ByChoice(each.kept, choice * drawn, beyond, known.size))
        return tuple(found)

    @property
    def first_orders(self) -> dict[str, FirstOrder | None]:
        """Reliability by the first order for each limit, by quantity; None where none is found.

        Empty where anything but draws varies, and of runs in time and sizings, which take too long.
        """
        found = self._first_orders.items()
        return {name: each if isinstance(each, FirstOrder) else None for name, each in found}

    @property
    def no_first_orders(self) -> dict[str, str]:
        """Why there is no reliability by the first order, by quantity."""
        found = self._first_orders.items()
        return {name: each for name, each in found if not isinstance(each, FirstOrder)}

    @cached_property
    def _first_orders(self) -> dict[str, FirstOrder | Message]:
        study = self.study
        if not study.distributions or study.base.compute in ("motion", "sizing"):
            return {}
        return {
            each.kept.name: first_order(study, each.kept, each.limit, self.values(each.kept.name))
            for each in self.statistics
            if each.limit is not None
        }

    @cached_property
    def influences(self) -> tuple[Influence, ...]:
        """What the first quantity hangs on, the most first."""
        if not self.statistics or not self.is_complete:
            return ()
        values, shares = self.values(self.statistics[0].kept.name), self.study.shares()
        there = np.isfinite(values)
        found = [
            _influence(keys, code[there], values[there], shares[there])
            for keys, code in self._groups()
        ]
        return tuple(sorted(found, key=lambda each: -each.share))

    def _groups(self) -> Iterator[tuple[tuple[str, ...], Codes]]:
        """Yield keys with the group of each member by their values."""
        study = self.study
        for axis, places in zip(study.axes, study.places(0, len(study)), strict=True):
            if len(axis) == 1:
                continue
            if not axis.is_drawn and len(axis) <= _BINS:
                yield tuple(axis.columns), places
                continue
            for key, column in axis.columns.items():
                parts = _parted(column)
                if parts.max() + 1 < len(axis):  # else the key only names the members
                    yield (key,), parts[places]

    def counted(self) -> dict[str, list[tuple[str, int]]]:
        """Count the texts that are kept, by name, the most frequent first."""
        names = [each.name for each in self.study.base.kept if not each.quantity]
        if not names:
            return {}
        rows = [row for piece in self.store.pieces() for row in piece.words]
        counts = {name: Counter(row[at] for row in rows) for at, name in enumerate(names)}
        return {
            name: [each for each in count.most_common(_MOST_SHOWN) if each[0]]
            for name, count in counts.items()
        }

    def failures(self) -> list[tuple[str, int, int]]:
        """Return why members have no answer, how many, and the first of them, from 0."""
        counts = Counter(self.reasons.values())
        first = {reason: member for member, reason in reversed(self.reasons.items())}
        return [(why, n, first[why]) for why, n in counts.most_common(_MOST_SHOWN)]

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt study --json`` prints (schema catopt.study/1)."""
        return study_document(self)


def _parted(column: Sequence[Any] | Array) -> Codes:
    """Part values into groups of equal count, or by value where they are few or no numbers."""
    values, code = np.unique(np.asarray(column), return_inverse=True)
    if len(values) <= _BINS or values.dtype.kind != "f":
        return np.asarray(code, dtype=np.int64)
    ranks = np.argsort(np.argsort(np.asarray(column), kind="stable"), kind="stable")
    return np.asarray(ranks * _BINS // len(ranks), dtype=np.int64)


def _influence(keys: tuple[str, ...], code: Codes, values: Array, shares: Array) -> Influence:
    total = shares.sum()
    mean = shares @ values / total
    variance = shares @ (values - mean) ** 2 / total
    weight = np.bincount(code, shares)
    used = weight > 0.0
    means = np.bincount(code, shares * values)[used] / weight[used]
    between = weight[used] @ (means - mean) ** 2 / total
    share = float(between / variance) if variance > 0.0 else 0.0
    return Influence(keys, share, float(means.min()), float(means.max()))
