"""Over a study: what share of its members is beyond each value."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from catopt.figures.chart import Axis, Chart, Level, Series, span_of
from catopt.quantities import Quantity
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.study.result import Statistic, StudyResult

_SHARE = Quantity("share", "Share", "", "-", "-", 1.0, 4)
_MOST = 400
"""Places of a curve, at equal shares and closer at its rare end."""


def share_worse(result: StudyResult, of: Statistic) -> Chart:
    """Draw the share of the members that are worse than each value of a quantity."""
    values, shares = result.values(of.kept.name), result.study.shares()
    there = np.isfinite(values) & (shares > 0.0)
    order = np.argsort(values[there] if of.kept.high_is_worse else -values[there], kind="stable")
    sorted_values, weights = values[there][order], shares[there][order]
    worse = 1.0 - np.cumsum(weights) / weights.sum() + weights / weights.sum()
    rare = float(worse.min())
    wanted = np.geomspace(1.0, rare, _MOST)
    at = np.unique(np.searchsorted(-worse, -wanted, side="right") - 1)
    x, y = sorted_values[at].tolist(), worse[at].tolist()
    key = "worse_above" if of.kept.high_is_worse else "worse_below"
    limits = [] if of.limit is None else [of.limit]
    return Chart(
        "study",
        Message("study.exceedance"),
        Axis(of.kept.words, replace(of.kept.measure, symbol=""), *span_of([*x, *limits])),
        Axis(Message(f"study.{key}"), _SHARE, 0.6 * rare, 1.4, foot=0.6 * rare),
        series=(Series("first", x, y, Message(f"study.{key}")),),
        levels=tuple(Level("capacity", "x", each, Message("study.limit")) for each in limits),
    )
