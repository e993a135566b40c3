"""Drag anchors: ultimate holding capacity, and the next size that holds a pull."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Final, Literal

from catopt.errors import NoAnswerError
from catopt.loads.holding_data import ANCHORS, CURVES, DATA_SETS, SOILS, DataSet, HoldingCurve
from catopt.loads.sizes import ANCHOR_MASSES, neighbours, next_size
from catopt.loads.source import UFC, LoadSource, refuse_recalled
from catopt.model.validity import Findings
from catopt.words import Measure, Message, Several, term

FACTOR_SOURCE: Final = LoadSource(UFC, "table 3-7, page 26", "A")
"""Of the safety factors."""

_STEEPEST_LIMIT: Final = math.radians(10.0)


@dataclass(frozen=True)
class HoldingCapacity:
    """What an anchor holds at the most, pulled horizontally.

    Attributes
    ----------
    capacity : float
        N.
    curve : HoldingCurve
        That it is from.
    others : tuple of (str, float)
        What the other data sets say, N.
    """

    capacity: float
    curve: HoldingCurve
    others: tuple[tuple[str, float], ...] = ()

    @property
    def note(self) -> Message:
        """Which figures were used, and which not."""
        source = self.curve.source
        notes = [Message("loads.capacity_note", data=self.curve.data, source=source.text)]
        if source.recalled:
            notes.append(Message("loads.capacity_recalled"))
        for name, value in self.others:
            notes.append(
                Message("loads.capacity_other", data=name, capacity=Measure("tension", value))
            )
        return Several(notes)


@dataclass(frozen=True)
class DragAnchorSize:
    """An anchor that holds a pull.

    Attributes
    ----------
    anchor, soil : str
        Kinds.
    needed_mass, mass : float
        The least, and the next size sold, kg.
    capacity : HoldingCapacity
        Of the size sold.
    horizontal_force : float
        Pull, N.
    safety_factor : float
        That was wanted.
    factor_source : LoadSource or None
        Of the factor; None for the user's own.
    smaller, larger : float or None
        Its neighbours in the series, kg.
    """

    anchor: str
    soil: str
    needed_mass: float
    mass: float
    capacity: HoldingCapacity
    horizontal_force: float
    safety_factor: float
    factor_source: LoadSource | None
    smaller: float | None
    larger: float | None

    @property
    def factor(self) -> float | None:
        """Capacity over pull; None without a pull."""
        if self.horizontal_force == 0.0:
            return None
        return self.capacity.capacity / self.horizontal_force


def default_factor(anchor: str) -> float:
    """Safety factor on the ultimate capacity: 1.5 stockless, 2.0 others (UFC table 3-7, A).

    The table has 1.5 for stockless and balanced-fluke anchors and 2.0 for high-efficiency drag
    anchors; every anchor but the stockless one is taken for one of these, on the safe side.

    Parameters
    ----------
    anchor : str
        Kind.
    """
    return 1.5 if anchor == "stockless" else 2.0


def holding_capacity(
    anchor: str,
    soil: str,
    mass: float,
    *,
    data: DataSet | Literal["lower"] = "lower",
    allow_recalled: bool = False,
) -> HoldingCapacity:
    """Ultimate holding capacity HR (m/mR)^b (UFC eq. 26, page 105, A; the figures C or R).

    Parameters
    ----------
    anchor, soil : str
        One of `ANCHORS` and of `SOILS`.
    mass : float
        In air, kg.
    data : {"lower", "UFC", "DTOcean", "Vryhof"}
        Data set; the lowest of those that have the anchor when left out. A recalled figure (R) is
        used so only to lower a figure that was read.
    allow_recalled : bool
        Whether recalled figures may stand alone.

    Raises
    ------
    InputError
        For an anchor, soil or data set without figures, or with recalled ones only.
    """
    curves = _curves(anchor, soil, data, allow_recalled)
    found = Findings("holding_capacity")
    found.number("mass", mass, "kg", above=0.0, at_most=100e3)
    found.raise_if_any()
    return _lowest(curves, mass)


def size_drag_anchor(
    anchor: str,
    soil: str,
    horizontal_force: float,
    *,
    safety_factor: float | None = None,
    uplift_angle: float = 0.0,
    uplift_limit: float = 0.0,
    data: DataSet | Literal["lower"] = "lower",
    series: Sequence[float] = ANCHOR_MASSES,
    allow_recalled: bool = False,
) -> DragAnchorSize:
    """Pick the next size that holds a pull.

    Parameters
    ----------
    anchor, soil, data, allow_recalled
        As of `holding_capacity`.
    horizontal_force : float
        At the anchor, N.
    safety_factor : float, optional
        On the ultimate capacity; `default_factor` when left out.
    uplift_angle : float
        Of the line at the anchor, rad.
    uplift_limit : float
        Largest allowed, rad; 0, for UFC keeps the pull horizontal (table 3-18, A). At most 10 deg
        (TU Delft, C).
    series : sequence of float
        Masses sold, rising, kg.

    Raises
    ------
    NoAnswerError
        When the line lifts the anchor by more than the limit, or no size holds.
    """
    curves = _curves(anchor, soil, data, allow_recalled)
    factor = default_factor(anchor) if safety_factor is None else safety_factor
    _check(horizontal_force, factor, uplift_angle, uplift_limit)
    needed = max(
        curve.mass(factor * horizontal_force) if horizontal_force > 0.0 else 0.0 for curve in curves
    )
    mass = next_size(needed, series, Message("loads.anchor_in", anchor=anchor, soil=term(soil)))
    smaller, larger = neighbours(mass, series)
    return DragAnchorSize(
        anchor,
        soil,
        needed,
        mass,
        _lowest(curves, mass),
        horizontal_force,
        factor,
        FACTOR_SOURCE if safety_factor is None else None,
        smaller,
        larger,
    )


def _curves(anchor: str, soil: str, data: str, allow_recalled: bool) -> tuple[HoldingCurve, ...]:
    """Gather the curves to be used."""
    _check_names(anchor, soil, data)
    of_anchor = [curve for curve in CURVES if curve.anchor == anchor]
    own = [curve for curve in of_anchor if curve.soil == soil and data in ("lower", curve.data)]
    if not own:
        _refuse(anchor, soil, data, of_anchor)
    if all(curve.source.recalled for curve in own):
        what = f"the figures of {anchor} in {soil} after {own[0].data}"
        instead = "take another anchor or data set"
        refuse_recalled("holding capacity", "data", what, instead, allowed=allow_recalled)
    return tuple(own)


def _check_names(anchor: str, soil: str, data: str) -> None:
    found = Findings("holding capacity")
    if anchor not in ANCHORS:
        found.add("anchor", repr(anchor), "one of " + "; ".join(ANCHORS))
    if soil not in SOILS:
        found.add("soil", repr(soil), "one of " + ", ".join(SOILS))
    if data not in ("lower", *DATA_SETS):
        found.add("data", repr(data), "one of lower, " + ", ".join(DATA_SETS))
    found.raise_if_any()


def _refuse(anchor: str, soil: str, data: str, known: Iterable[HoldingCurve]) -> None:
    there = ", ".join(f"{curve.data} in {curve.soil}" for curve in known)
    found = Findings("holding capacity")
    found.add("soil", repr(soil), f"no figures of {anchor} for data {data!r}; there are: {there}")
    found.raise_if_any()


def _lowest(curves: Sequence[HoldingCurve], mass: float) -> HoldingCapacity:
    by_capacity: Callable[[HoldingCurve], float] = lambda curve: curve.capacity(mass)  # noqa: E731
    lowest = min(curves, key=by_capacity)
    others = tuple((c.data, c.capacity(mass)) for c in curves if c is not lowest)
    return HoldingCapacity(lowest.capacity(mass), lowest, others)


def _check(horizontal: float, factor: float, angle: float, limit: float) -> None:
    found = Findings("drag anchor")
    found.number("horizontal_force", horizontal, "N", at_least=0.0)
    found.number("safety_factor", factor, "", at_least=1.0)
    found.number("uplift_angle", angle, "rad", at_least=0.0)
    found.number("uplift_limit", limit, "rad", at_least=0.0, at_most=_STEEPEST_LIMIT)
    found.raise_if_any()
    if angle > limit:
        raise NoAnswerError(
            Message(
                "loads.pulled_up",
                angle=math.degrees(angle),
                above=math.degrees(angle - limit),
                limit=math.degrees(limit),
            )
        )
