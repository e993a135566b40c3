"""How likely a limit is passed where values are drawn: by counting, and by the first order.

The first order (Hasofer and Lind) takes the point nearest to the means, in units of standard
deviations, at which the limit is reached: its distance is the reliability index beta, and the
normal probability beyond it the answer, exact where the limit is a plane in those units.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.errors import InputError, NoAnswerError, NotConvergedError
from catopt.study.base import Kept
from catopt.study.member import compute_member
from catopt.study.statics import at_rest
from catopt.study.study import Piece, Study

COVERAGE: Final = 0.95
"""Of the interval of a probability that is counted."""

_STEP: Final = 1e-3
"""Of a difference, in standard deviations."""

_AT_LIMIT: Final = 1e-6
"""Part of the limit by which the point found may miss it."""


@dataclass(frozen=True)
class FirstOrder:
    """Reliability by the first order.

    `index`: beta; below 0 where the limit is passed at the medians already; `probability`: of
    passing the limit; `point`: where it is most likely passed: values in SI by key path;
    `importance`: share of each in beta squared.
    """

    index: float
    probability: float
    point: Mapping[str, float]
    importance: Mapping[str, float]


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


def first_order(study: Study, kept: Kept, limit: float) -> FirstOrder | None:
    """Find the point at which a limit is most likely passed; None where there is none to be found.

    `study`: one whose keys are drawn, or have one value; `limit`: of the quantity, in SI.
    """
    from scipy.optimize import minimize
    from scipy.special import ndtr

    keys = list(study.distributions)
    sense = 1.0 if kept.high_is_worse else -1.0

    def room(points: Array) -> Array:
        """Part of the limit that is left at points in standard deviations, shape (n, keys)."""
        return sense * (limit - _values(study, kept, points)) / (abs(limit) or 1.0)

    def slope(at: Array) -> Array:
        steps = _STEP * np.eye(len(keys))
        left = room(np.concatenate([at + steps, at - steps]))
        found: Array = (left[: len(keys)] - left[len(keys) :]) / (2.0 * _STEP)
        return found

    start = room(np.zeros((1, len(keys))))[0]
    if not math.isfinite(start):
        return None
    found = minimize(
        lambda u: 0.5 * float(u @ u),
        np.zeros(len(keys)),
        jac=lambda u: u,
        method="SLSQP",
        constraints={"type": "eq", "fun": lambda u: room(u[np.newaxis])[0], "jac": slope},
        options={"ftol": 1e-10, "maxiter": 100},
    )
    at = np.asarray(found.x)
    if not found.success or not abs(room(at[np.newaxis])[0]) <= _AT_LIMIT:
        return None
    size = float(np.linalg.norm(at))
    index = math.copysign(size, start)
    shares = (at / size) ** 2 if size > 0.0 else np.zeros(len(keys))
    return FirstOrder(
        index,
        float(ndtr(-index)),
        {key: float(values[0]) for key, values in _columns(study, at[np.newaxis]).items()},
        dict(zip(keys, shares.tolist(), strict=True)),
    )


def _columns(study: Study, points: Array) -> dict[str, Array]:
    drawn = study.distributions
    return {key: each.at(points[:, k]) for k, (key, each) in enumerate(drawn.items())}


def _values(study: Study, kept: Kept, points: Array) -> Array:
    """Compute a quantity at points in standard deviations; nan where there is no answer."""
    fixed = {
        key: value for key, value in study.values_of(0).items() if key not in study.distributions
    }
    columns = _columns(study, points)
    every = {key: [value] * len(points) for key, value in fixed.items()}
    piece = Piece(0, 0, {**every, **columns})
    if study.base.compute == "statics":
        return at_rest(study.base, piece).values[kept.name]
    found = np.full(len(points), math.nan)
    for member in range(len(points)):
        try:
            values = compute_member(study.base, piece.changes(member))
        except (InputError, NoAnswerError, NotConvergedError):
            continue
        found[member] = float(values.get(kept.name, math.nan))
    return found
