"""How likely a limit is passed where values are drawn: by counting, and by the first order.

The first order (Hasofer and Lind) takes the point nearest to the means, in units of standard
deviations, at which the limit is reached: its distance is the reliability index beta, and the
normal probability beyond it the answer, exact where the limit is a plane in those units. It is
looked for from the medians and from draws that pass the limit, for at the medians a quantity may
not change at all; there may be several such points. Where members are solved in bulk, draws around
all of them (importance sampling) say what a limit that is bent makes of the probability.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Flags
from catopt.errors import InputError, NoAnswerError, NotConvergedError
from catopt.model.kinds import Share
from catopt.records import Record
from catopt.study.member import Output, compute_member
from catopt.study.statics import at_rest
from catopt.study.study import Study, StudyPiece
from catopt.words import Message

COVERAGE: Final = 0.95
"""Of the interval of a probability that is counted."""

_STEP: Final = 1e-3
"""Of a difference, in standard deviations."""

_STARTS: Final = 6
"""Draws from which a search begins, beside the medians."""

_HALVINGS: Final = 50
"""Of the way from the medians to a draw, until the limit is reached."""

_APART: Final = 0.1
"""Part of their distance by which two points have to be apart to be two."""

_SAMPLES: Final = 4_000
"""Around the points at which the limit is most likely passed."""

_AT_LIMIT: Final = 1e-6
"""Part of the limit by which the point found may miss it."""


class AtPoint(NamedTuple):
    """A value at a point, by what varies."""

    key: str
    """Key path."""
    value: float
    """In SI."""
    importance: float = 0.0
    """Share in beta squared."""


@dataclass(frozen=True)
class OtherPoint(Record):
    """A further point at which a limit is likely passed."""

    DOCUMENT = "index point(key value)"

    index: float
    """beta."""
    point: tuple[AtPoint, ...]
    """Values there."""


@dataclass(frozen=True)
class FirstOrder(Record):
    """Reliability by the first order."""

    DOCUMENT = (
        "index probability points=point(key value importance) other_points=others sampled "
        "interval=interval_sampled"
    )

    index: float
    """beta; below 0 where the limit is passed at the medians already."""
    probability: Share
    """Of passing the limit."""
    point: Mapping[str, float]  # where it is most likely passed: values in SI by key path
    importance: Mapping[str, float]  # share of each in beta squared
    others: tuple[tuple[float, Mapping[str, float]], ...] = ()  # further points, with their indices
    sampled: Share | None = None
    """Probability by draws around all of these points; None where members are not solved in bulk,
    or where the line has no answer at one of the draws."""
    interval: tuple[float, float] | None = None
    """Of that probability, 95 %."""

    @property
    def points(self) -> tuple[AtPoint, ...]:
        """Where the limit is most likely passed."""
        share = self.importance
        return tuple(AtPoint(key, value, share[key]) for key, value in self.point.items())

    @property
    def other_points(self) -> tuple[OtherPoint, ...]:
        """Further points at which it is likely passed."""
        return tuple(
            OtherPoint(index, tuple(AtPoint(*each) for each in point.items()))
            for index, point in self.others
        )


def counted_interval(beyond: int, count: int) -> tuple[float, float]:
    """Interval of a probability from so many of so many draws (Clopper and Pearson).

    Examples
    --------
    >>> low, high = counted_interval(0, 1000)
    >>> low, round(high, 5)
    (0.0, 0.00368)
    """
    from scipy.stats import beta

    tail = 0.5 * (1.0 - COVERAGE)
    low = 0.0 if beyond == 0 else float(beta.ppf(tail, beyond, count - beyond + 1))
    high = 1.0 if beyond == count else float(beta.ppf(1.0 - tail, beyond + 1, count - beyond))
    return low, high


def first_order(study: Study, kept: Output, limit: float, values: Array) -> FirstOrder | Message:
    """Find the points at which a limit is most likely passed; or say why there is none.

    `study`: one whose keys are drawn, or have one value; `limit`: of the quantity, in SI; `values`:
    of the quantity, of all members, nan where there is none.
    """
    from scipy.special import ndtr

    keys = list(study.distributions)
    sense = 1.0 if kept.high_is_worse else -1.0

    def room(points: Array) -> Array:
        """Part of the limit that is left at points in standard deviations, shape (n, keys)."""
        return sense * (limit - _values(study, kept, points)) / (abs(limit) or 1.0)

    start = float(room(np.zeros((1, len(keys))))[0])
    if not math.isfinite(start):
        return Message("study.no_median")
    starts = _starts(study, room, start, kept.beyond(values, limit) & np.isfinite(values), values)
    found: list[Array] = []
    for at in (_nearest(room, each) for each in starts):
        if at is not None and all(_distance(at, each) > _APART for each in found):
            found.append(at)
    if not found:
        return Message("study.not_reached" if len(starts) == 1 else "study.not_converged")
    found.sort(key=lambda at: float(np.linalg.norm(at)))
    sizes = [math.copysign(float(np.linalg.norm(at)), start) for at in found]
    points = [
        {key: float(column[0]) for key, column in _columns(study, at[np.newaxis]).items()}
        for at in found
    ]
    shares = (found[0] / sizes[0]) ** 2 if sizes[0] else np.zeros(len(keys))
    sampled = interval = None
    if study.base.compute == "statics":
        sampled, interval = _sampled(room, found, start < 0.0)
    return FirstOrder(
        sizes[0],
        float(ndtr(-sizes[0])),
        points[0],
        dict(zip(keys, shares.tolist(), strict=True)),
        tuple(zip(sizes[1:], points[1:], strict=True)),
        sampled,
        interval,
    )


def _distance(one: Array, other: Array) -> float:
    """Say how far two points are apart, as a part of how far the farther one is off."""
    far = max(float(np.linalg.norm(one)), float(np.linalg.norm(other)), 1e-300)
    return float(np.linalg.norm(one - other)) / far


def _starts(
    study: Study, room: Callable[[Array], Array], at_median: float, is_beyond: Flags, values: Array
) -> list[Array]:
    """Begin at the medians, and where the ways from there to draws of the other side reach a limit.

    Of the draws: the likeliest, then those that lie the farthest from all that were taken.
    """
    drawn = study.distributions
    middle = np.zeros(len(drawn))
    members = np.flatnonzero(is_beyond if at_median > 0.0 else ~is_beyond & np.isfinite(values))
    if not members.size:
        return [middle]
    columns = study.values(0, len(study))
    draws = np.column_stack([
        each.normal_of(np.asarray(columns[key], dtype=float)[members])
        for key, each in drawn.items()
    ])  # fmt: skip
    draws = draws[np.isfinite(draws).all(axis=1)]
    sizes = np.linalg.norm(draws, axis=1)
    taken = [int(np.argmin(sizes))]
    while len(taken) < min(_STARTS, len(draws)):
        ways = draws / sizes[:, np.newaxis]
        apart = np.min([1.0 - ways @ ways[k] for k in taken], axis=0)
        taken.append(int(np.argmax(apart * np.exp(-0.5 * (sizes - sizes.min())))))
    ends = draws[taken]
    near, far = np.zeros(len(ends)), np.ones(len(ends))
    for _ in range(_HALVINGS):
        part = 0.5 * (near + far)
        is_near = room(part[:, np.newaxis] * ends) * at_median > 0.0
        near, far = np.where(is_near, part, near), np.where(is_near, far, part)
    return [middle, *(far[:, np.newaxis] * ends)]


def _nearest(room: Callable[[Array], Array], start: Array) -> Array | None:
    """Go to the nearest point to the medians at which the limit is reached; None if it stops short.

    At a point of such a kind what is nearest to the medians lies square to the limit.
    """
    from scipy.optimize import minimize

    steps = _STEP * np.eye(len(start))

    def slope(at: Array) -> Array:
        left = room(np.concatenate([at + steps, at - steps]))
        found: Array = (left[: len(start)] - left[len(start) :]) / (2.0 * _STEP)
        return found

    found = minimize(
        lambda u: 0.5 * float(u @ u),
        start,
        jac=lambda u: u,
        method="SLSQP",
        constraints={"type": "eq", "fun": lambda u: room(u[np.newaxis])[0], "jac": slope},
        options={"ftol": 1e-10, "maxiter": 100},
    )
    at = np.asarray(found.x)
    is_there = found.success and abs(room(at[np.newaxis])[0]) <= _AT_LIMIT
    return at if is_there else None


def _sampled(
    room: Callable[[Array], Array], points: list[Array], is_passed: bool
) -> tuple[float, tuple[float, float]] | tuple[None, None]:
    """Draw around points and weigh each draw by how likely it is; the probability, and `COVERAGE`.

    Half of the draws are of the distribution itself, so that no weight is above 2. None where a
    draw has no answer, which neither keeps nor passes the limit.
    `is_passed`: at the medians, so that what is rare is to keep the limit.
    """
    from scipy.special import ndtri

    rng = np.random.default_rng(0)
    keys = len(points[0])
    middles = np.array([*np.zeros((len(points), keys)), *points])
    draws = rng.normal(size=(_SAMPLES, keys)) + middles[np.arange(_SAMPLES) % len(middles)]
    apart = np.stack([draws @ middle - 0.5 * middle @ middle for middle in middles])
    weights = 1.0 / np.mean(np.exp(apart), axis=0)
    left = room(draws)
    if not np.isfinite(left).all():
        return None, None
    counted = np.where(left > 0.0 if is_passed else left < 0.0, weights, 0.0)
    share = float(counted.mean())
    half = float(ndtri(0.5 * (1.0 + COVERAGE))) * float(counted.std()) / math.sqrt(_SAMPLES)
    low, high = max(share - half, 0.0), min(share + half, 1.0)
    return (1.0 - share, (1.0 - high, 1.0 - low)) if is_passed else (share, (low, high))


def _columns(study: Study, points: Array) -> dict[str, Array]:
    drawn = study.distributions
    return {key: each.at(points[:, k]) for k, (key, each) in enumerate(drawn.items())}


def _values(study: Study, kept: Output, points: Array) -> Array:
    """Compute a quantity at points in standard deviations; nan where there is no answer."""
    drawn = _columns(study, points)
    values = study.values_of(0).items()
    fixed = {key: [value] * len(points) for key, value in values if key not in drawn}
    piece = StudyPiece(0, 0, {**fixed, **drawn})
    if study.base.compute == "statics":
        return at_rest(study.base, piece).values[kept.name]
    found = np.full(len(points), math.nan)
    for member in range(len(points)):
        try:
            computed = compute_member(study.base, piece.changes(member))
        except (InputError, NoAnswerError, NotConvergedError):
            continue
        found[member] = float(computed.get(kept.name, math.nan))
    return found
