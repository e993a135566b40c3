"""What came of a study: statistics over its members, the worst of them, and what matters."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Codes
from catopt.display import Displayable
from catopt.errors import need_package, refused
from catopt.model.kinds import Share
from catopt.records import Counted, FromZero, Record
from catopt.study.member import Output
from catopt.study.reliability import FirstOrder, counted_interval, first_order
from catopt.study.store import Store
from catopt.study.study import Study
from catopt.words import Message

if TYPE_CHECKING:
    from xarray import Dataset


LEVELS: Final = (0.05, 0.5, 0.95, 0.99)
"""Shares of the members below which a value is that is given."""

_BINS = 20
"""Into which values are parted that are drawn, or are too many to be looked at one by one."""

_MOST_SHOWN = 10
"""Reasons, and texts, that are given."""


class Level(NamedTuple):
    """A value that a share of the members does not exceed."""

    share: Share
    """Of the members, by what they count."""
    value: float
    """In the SI unit."""


class Varied(NamedTuple):
    """What varies, with its value for one member."""

    key: str
    """Key path."""
    value: float | str | bool
    """Of the member; a number with a dimension is in SI."""


class Count(NamedTuple):
    """How often a text that is kept came."""

    name: str
    """Of what it is the text."""
    text: str
    """The text."""
    members: Counted
    """How many have it."""


class Failure(NamedTuple):
    """Why members have no answer."""

    reason: str
    """In words."""
    members: Counted
    """How many have it."""
    first: int
    """The first of them, in Python from 0."""


@dataclass(frozen=True)
class Statistic:
    """One quantity over all members that have it, each by what it counts; values in SI."""

    kept: Output
    count: Counted
    """How many members have it."""
    mean: float
    """Weighted mean."""
    deviation: float
    """Weighted standard deviation."""
    least: float
    """Smallest of all."""
    largest: float
    """Largest of all."""
    levels: tuple[float, ...]  # that a share of `LEVELS` does not exceed
    worst: int
    """Its number, in Python from 0."""
    limit: float | None = None
    """Limit that was given; None where none was."""
    beyond: Share | None = None
    """Share of the members beyond it."""
    interval: tuple[float, float] | None = None
    """Of the probability to be beyond it, 95 %, where nothing but draws varies."""
    first_beyond: int | None = None
    """First member beyond it, in Python from 0; None where none is."""

    @property
    def by_share(self) -> tuple[Level, ...]:
        """Smallest values that at least a share of the members does not exceed."""
        return tuple(map(Level, LEVELS, self.levels))


@dataclass(frozen=True)
class WorstMember(Record):
    """The member at the bad end: the largest, of a grounded length the least."""

    DOCUMENT = "of.worst+1=member values(key value)"

    of: Statistic
    values: tuple[Varied, ...]
    """What varies, with its value there."""


@dataclass(frozen=True)
class FullStatistic(Record):
    """A statistic with the member at its bad end, and its reliability by the first order."""

    DOCUMENT = (
        "of.kept.name of.kept.measure.si_unit=unit of.count=members of.mean of.deviation of.least "
        "of.largest of.by_share=levels(share value) worst of.limit of.beyond=share_beyond "
        "of.first_beyond+1=first_beyond of.interval=interval_beyond first_order no_first_order"
    )

    of: Statistic
    worst: WorstMember
    """The member at the bad end: the largest, of a grounded length the least."""
    first_order: FirstOrder | None
    """Reliability by the first order; None where it was not looked for or not found."""
    no_first_order: str | None
    """Why none was found; None where one was, or none was looked for."""


@dataclass(frozen=True)
class ByChoice(Record):
    """How often a limit is passed by the draws of one choice of what is not drawn."""

    DOCUMENT = "kept.name member+1=member beyond count share interval"

    kept: Output
    member: int
    """First member of the choice, in Python from 0."""
    beyond: FromZero
    """Draws beyond the limit."""
    count: Counted
    """Draws with an answer."""

    @property
    def share(self) -> Share:
        """Of the draws."""
        return self.beyond / self.count

    @property
    def interval(self) -> tuple[float, float]:
        """Of the probability, 95 %."""
        return counted_interval(self.beyond, self.count)


@dataclass(frozen=True)
class Influence(Record):
    """How much of the spread of a quantity one of the things that vary explains."""

    DOCUMENT = "keys share=share_of_variance low=least_mean high=largest_mean"

    keys: tuple[str, ...]
    """Key paths that vary together."""
    share: float
    """First-order index, what of the variance would go if they were known; by parts of equal count
    where there are many values."""
    low: float
    """Least mean over the values, in the SI unit."""
    high: float
    """Largest mean over the values, in the SI unit."""


@dataclass(frozen=True, eq=False, repr=False)
class StudyResult(Displayable, Record):
    """What came of a study over its members, whole or as far as it went.

    Members count from 1. What a member counts comes from the weights of its tables, else all count
    the same.
    """

    SCHEMA = "catopt.study/1"
    DOCUMENT = (
        "study.title study.base.compute members done without_answer "
        "study.axes=varied(keys size=values is_drawn=drawn) study.digest full=statistics by_choice "
        "influences counts(name text members) failed=failures(reason members first+1=first)"
    )

    study: Study
    """What was asked."""
    store: Store
    """What was computed."""

    def __repr__(self) -> str:
        return (
            f"StudyResult({self.study.title!r}, members={len(self.study)}, done={self.done}, "
            f"without_answer={len(self.reasons)})"
        )

    @property
    def members(self) -> Counted:
        """How many there are."""
        return len(self.study)

    @cached_property
    def done(self) -> FromZero:
        """How many are computed by now, with an answer or without."""
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
            raise refused("name", f'"{name}"', Message("refused.one_of", words=", ".join(names)))
        return self.store.column(names.index(name))

    @property
    def without_answer(self) -> FromZero:
        """How many of those have none."""
        return len(self.reasons)

    @cached_property
    def reasons(self) -> dict[int, str]:
        """Why members have no answer, by their numbers from 0."""
        return self.store.reasons()

    @cached_property
    def statistics(self) -> tuple[Statistic, ...]:
        """Of each quantity that any member has."""
        shares = self.study.shares()
        found = (
            self._statistic(each, self.store.column(at), shares)
            for at, each in enumerate(self.measured)
        )
        return tuple(each for each in found if each is not None)

    @cached_property
    def fails_unused(self) -> FromZero:
        """How many members fail by a check without a utilisation, and are not in its statistic."""
        names = {each.name for each in self.measured}
        if not {"utilisation", "failing"} <= names:
            return 0
        is_missing = np.isnan(self.values("utilisation"))
        return int((is_missing & (self.values("failing") > 0.0)).sum())

    @property
    def full(self) -> tuple[FullStatistic, ...]:
        """Of each quantity that any member has."""
        orders, none = self.first_orders, self.no_first_orders
        return tuple(
            FullStatistic(
                each,
                WorstMember(each, tuple(Varied(*one) for one in varied.items())),
                orders.get(each.kept.name),
                none.get(each.kept.name),
            )
            for each in self.statistics
            for varied in [self.study.values_of(each.worst)]
        )

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
        """What the first quantity hangs on, the most first; only of a whole study."""
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

    @property
    def counts(self) -> tuple[Count, ...]:
        """How often each text that is kept came, the most frequent first."""
        return tuple(Count(name, *each) for name, of in self.counted().items() for each in of)

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

    @property
    def failed(self) -> tuple[Failure, ...]:
        """Why members have no answer, the most frequent first."""
        return tuple(self.failures())

    def failures(self) -> list[Failure]:
        """Return why members have no answer, how many, and the first of them, from 0."""
        counts = Counter(self.reasons.values())
        first = {reason: member for member, reason in reversed(self.reasons.items())}
        return [Failure(why, n, first[why]) for why, n in counts.most_common(_MOST_SHOWN)]


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
