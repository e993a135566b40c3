"""What drag anchors hold, by printed curves, and how they and their chain are laid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal, cast, get_args

from catopt.catalogue.fittings import AnchorType, Holding, anchor_types
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.display import Tabled
from catopt.errors import NoAnswerError
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.component import DTOCEAN, MOORPY, UFC, LoadSource, refuse_recalled
from catopt.loads.ship import NextSize, neighbours, next_size
from catopt.model.kinds import Findings, SomeForce, exceeds
from catopt.records import Record
from catopt.words import Measure, Message, Several, term

Soil = Literal["soft clay", "medium clay", "sand"]
SOILS: Final[tuple[Soil, ...]] = get_args(Soil)

DataSet = Literal["UFC", "DTOcean", "Vryhof"]
DATA_SETS: Final[tuple[DataSet, ...]] = get_args(DataSet)


@dataclass(frozen=True)
class HoldingCurve:
    """Ultimate holding capacity H = HR (m/mR)^b of a kind of anchor in a kind of soil.

    The reference capacity HR is in N, the reference mass mR in kg; b is the exponent, and the
    source that of HR and b. It holds for the masses, kg, and for a horizontal pull.
    """

    anchor: str
    soil: Soil
    data: DataSet
    reference_capacity: float
    reference_mass: float
    exponent: float
    source: LoadSource
    masses: tuple[float, float]
    """Smallest and largest that is sold."""

    def capacity(self, mass: float) -> float:
        """Give what an anchor of a mass in kg holds, N."""
        return float(self.reference_capacity * (mass / self.reference_mass) ** self.exponent)

    def mass(self, capacity: float) -> float:
        """Give the mass that holds a capacity in N, kg."""
        return float(
            self.reference_mass * (capacity / self.reference_capacity) ** (1.0 / self.exponent)
        )


_SOURCES: Final = {
    "UFC": (UFC, "eq. 26, page 105 (read); HR and b of table 5-3 recalled"),
    "DTOcean": (DTOCEAN, "drag anchors"),
    "Vryhof": (MOORPY, "Stevpris Mk6"),
}
"""Documents and clauses by data set."""


def _curve(of: AnchorType, holding: Holding) -> HoldingCurve:
    source = LoadSource(*_SOURCES[holding.data], holding.confidence)
    soil, data = cast("Soil", holding.soil), cast("DataSet", holding.data)
    figures = (holding.capacity, holding.of_mass, holding.exponent)
    return HoldingCurve(of.name, soil, data, *figures, source, of.range)


CURVES: Final = tuple(_curve(each, of) for each in anchor_types() for of in each.holdings)
"""Every curve."""

ANCHORS: Final = tuple(each.name for each in anchor_types())
"""Every kind of anchor."""


def masses_sold(anchor: str) -> tuple[float, ...]:
    """List the masses in which a kind of anchor is sold, kg, rising."""
    return next(each.masses for each in anchor_types() if each.name == anchor)


FACTOR_SOURCE: Final = LoadSource(UFC, "table 3-7, page 26", "A")
"""Of the safety factors."""

_STEEPEST_LIMIT: Final = math.radians(10.0)


@dataclass(frozen=True)
class HoldingCapacity(Tabled):
    """What an anchor holds at the most, by a curve."""

    capacity: SomeForce
    """Ultimate, pulled horizontally."""
    curve: HoldingCurve
    others: tuple[tuple[str, float], ...] = ()
    """What the other data sets say, N."""

    @property
    def note(self) -> Message:
        """Which figures the capacity is from, and what others say."""
        source = self.curve.source
        notes = [Message("loads.capacity_note", data=self.curve.data, source=source.text)]
        if source.recalled:
            notes.append(Message("loads.capacity_recalled"))
        for name, value in self.others:
            capacity = Measure("tension", value)
            notes.append(Message("loads.capacity_other", data=name, capacity=capacity))
        return Several(notes)


@dataclass(frozen=True, kw_only=True)
class DragAnchorSize(NextSize, Record):
    """An anchor that holds a pull."""

    DOCUMENT = (
        "anchor soil mass needed_mass smaller=smaller_mass_kg larger=larger_mass_kg "
        "capacity.capacity=holding_capacity_N capacity.note=capacity_note "
        "safety_factor=wanted_factor factor"
    )

    anchor: str
    """Kind."""
    soil: str
    """Kind."""
    capacity: HoldingCapacity
    """Of the size sold."""
    factor_source: LoadSource | None
    """Of the factor; None for the user's own."""

    @property
    def held(self) -> float:
        """Its capacity, N."""
        return self.capacity.capacity


def default_factor(anchor: str) -> float:
    """Safety factor on the ultimate capacity: 1.5 stockless, 2.0 others (UFC table 3-7, A).

    The table has 1.5 for stockless and balanced-fluke anchors and 2.0 for high-efficiency drag
    anchors; every anchor but the stockless one is taken for one of these, on the safe side.
    """
    return 1.5 if anchor.startswith("stockless") else 2.0


def holding_capacity(
    anchor: str,
    soil: str,
    mass: float,
    *,
    data: DataSet | Literal["lower"] = "lower",
    allow_recalled: bool = False,
) -> HoldingCapacity:
    """Ultimate holding capacity HR (m/mR)^b (UFC eq. 26, page 105, A; the figures C or R).

    The anchor is one of `ANCHORS` in one of `SOILS`; the mass is in air, kg, and within the range
    of those that are sold, beyond which no source says anything. Of the data sets that
    have it the lowest counts unless one is named: a recalled figure (R) is used so only to lower a
    figure that was read, and stands alone only where that is allowed.

    Raises
    ------
    InputError
        For an anchor, soil or data set without figures, or with recalled ones only; for a mass
        outside the range of those that are sold.
    """
    curves = _curves(anchor, soil, data, allow_recalled)
    found = Findings("holding_capacity")
    found.number("mass", mass, "kg", above=0.0)
    found.raise_if_any()
    _check_masses("mass", (mass,), curves)
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
    series: Sequence[float] | None = None,
    allow_recalled: bool = False,
) -> DragAnchorSize:
    """Pick the next size sold that holds a pull at the anchor, N.

    The rest is as of `holding_capacity`.

    Parameters
    ----------
    safety_factor : float, optional
        On the ultimate capacity; `default_factor` when left out.
    uplift_angle : float
        Of the line at the anchor, rad.
    uplift_limit : float
        Largest allowed, rad; 0, for UFC keeps the pull horizontal (table 3-18, A). At most 10 deg
        (TU Delft, C).
    series : sequence of float, optional
        Rising masses to choose from, kg, within the range of those that are sold; all that are
        sold when left out.

    Raises
    ------
    InputError
        For wrong input, or masses of which no source says anything.
    NoAnswerError
        When the line lifts the anchor by more than the limit, or no size holds.
    """
    curves = _curves(anchor, soil, data, allow_recalled)
    factor = default_factor(anchor) if safety_factor is None else safety_factor
    _check(horizontal_force, factor, uplift_angle, uplift_limit)
    sizes = masses_sold(anchor) if series is None else tuple(series)
    _check_masses("series", sizes, curves)
    needed = max(
        curve.mass(factor * horizontal_force) if horizontal_force > 0.0 else 0.0 for curve in curves
    )
    mass = next_size(needed, sizes, Message("loads.anchor_in", anchor=anchor, soil=term(soil)))
    smaller, larger = neighbours(mass, sizes)
    return DragAnchorSize(
        anchor=anchor,
        soil=soil,
        needed_mass=needed,
        mass=mass,
        smaller=smaller,
        larger=larger,
        capacity=_lowest(curves, mass),
        horizontal_force=horizontal_force,
        safety_factor=factor,
        factor_source=FACTOR_SOURCE if safety_factor is None else None,
    )


def _curves(anchor: str, soil: str, data: str, allow_recalled: bool) -> tuple[HoldingCurve, ...]:
    """Gather the curves to be used."""
    found = Findings("holding capacity")
    if anchor not in ANCHORS:
        found.add("anchor", repr(anchor), Message("refused.of_these", words="; ".join(ANCHORS)))
    found.word("soil", soil, SOILS)
    found.word("data", data, ("lower", *DATA_SETS))
    found.raise_if_any()
    of_anchor = [curve for curve in CURVES if curve.anchor == anchor]
    own = [curve for curve in of_anchor if curve.soil == soil and data in ("lower", curve.data)]
    if not own:
        there = ", ".join(f"{curve.data} in {curve.soil}" for curve in of_anchor)
        values = {"anchor": anchor, "data": data, "there": there}
        lacks = Message("refused_sizing.no_figures_data_there_are", **values)
        found.add("soil", repr(soil), lacks)
        found.raise_if_any()
    if all(curve.source.recalled for curve in own):
        what = f"the figures of {anchor} in {soil} after {own[0].data}"
        instead = "take another anchor or data set"
        refuse_recalled("holding capacity", "data", what, instead, allowed=allow_recalled)
    return tuple(own)


def _check_masses(key: str, masses: Sequence[float], curves: Sequence[HoldingCurve]) -> None:
    """Refuse masses of which no source says anything, with the nearest that is sold."""
    found = Findings("holding capacity")
    low, high = curves[0].masses
    values = {"anchor": curves[0].anchor, "low": low, "high": high}
    for mass in masses:
        if exceeds(low, mass) or exceeds(mass, high):
            nearest = min(max(mass, low), high)
            allowed = Message("loads.anchor_sold", nearest=nearest, **values)
            found.add(key, f"{mass:g} kg", allowed)
    found.raise_if_any()


def _lowest(curves: Sequence[HoldingCurve], mass: float) -> HoldingCapacity:
    lowest = min(curves, key=lambda curve: curve.capacity(mass))
    others = tuple((c.data, c.capacity(mass)) for c in curves if c is not lowest)
    return HoldingCapacity(lowest.capacity(mass), lowest, others)


def _check(horizontal: float, factor: float, angle: float, limit: float) -> None:
    found = Findings("drag anchor")
    found.number("horizontal_force", horizontal, "N", at_least=0.0)
    found.number("safety_factor", factor, "", at_least=1.0)
    found.number("uplift_angle", angle, "rad", at_least=0.0)
    found.number("uplift_limit", limit, "rad", at_least=0.0, at_most=_STEEPEST_LIMIT)
    found.raise_if_any()
    if exceeds(angle, limit):
        ends = {"angle": angle, "above": angle - limit, "limit": limit}
        degrees = {name: math.degrees(each) for name, each in ends.items()}
        raise NoAnswerError(Message("loads.pulled_up", **degrees))


_DDJ = LoadSource(
    "D. Djokic, Mooring-Line-Properties at 703fd47", "friction.md, starting and sliding", "C"
)
_DTO = LoadSource("DTOcean moorings", "sample_data/soilprops.txt, seaflrfriccoef of clays", "C")


@dataclass(frozen=True)
class BedFriction:
    """Friction of chain on a bed: to start it, and of chain that slides, which counts."""

    bed: str
    starting: float
    sliding: float
    source: LoadSource
    """Of the sliding one."""


CHAIN_ON_BED: Final = MappingProxyType(
    {
        each.bed: each
        for each in (
            BedFriction("sand", 0.98, 0.74, _DDJ),
            BedFriction("mud with sand", 0.92, 0.69, _DDJ),
            BedFriction("firm mud", 1.01, 0.62, _DDJ),
            BedFriction("soft mud", 0.90, 0.56, _DDJ),
            # Djokic has 0.81 for clay that slides; DTOcean's 0.5 is the lower.
            BedFriction("clay", 1.25, 0.50, _DTO),
        )
    }
)
"""Beds by name; of two sources the lower sliding friction."""


def chain_holding(bed: str, submerged_weight: float) -> tuple[float, LoadSource]:
    """Horizontal pull that chain on a bed holds, N, by its weight in water there, N.

    The sliding friction counts: an anchor that gives takes the chain with it.
    """
    found = Findings("chain on the bed")
    found.word("bed", bed, tuple(CHAIN_ON_BED))
    found.number("submerged_weight", submerged_weight, "N", at_least=0.0)
    found.raise_if_any()
    row = CHAIN_ON_BED[bed]
    return row.sliding * submerged_weight, row.source


Medium = Literal["water", "air"]

LAYING_SOURCE: Final = LoadSource(
    "worked example of a navigation buoy on 110 m of 32 mm chain (Indonesia)",
    "it floats with all chain and the sinker hung on it",
    "C",
)


@dataclass(frozen=True)
class LayingCheck(Tabled):
    """Weight of buoy, chain and sinker beside the buoyancy that the buoy has, N."""

    name: str
    demand: float
    capacity: float
    chain_in: Medium
    """In what the chain is weighed: water, or air as the worked example does, on the safe side."""
    source: LoadSource = LAYING_SOURCE

    @property
    def utilisation(self) -> float:
        """Demand over capacity: it floats at 1 or below."""
        return self.demand / self.capacity


def laying_check(
    shape: BuoyShape,
    chain_weight: float,
    sinker_weight: float,
    *,
    chain_in: Medium = "water",
    freeboard: float = 0.0,
    water_density: float = SEA_WATER_DENSITY,
) -> LayingCheck:
    """Hang the whole chain and the sinker on a buoy.

    Parameters
    ----------
    chain_weight : float
        Of the whole chain, in the medium of `chain_in`, N.
    sinker_weight : float
        In water, N.
    chain_in : {"water", "air"}
        In what the chain is weighed; the worked example takes it in air.
    freeboard : float
        That the buoy is to keep, m.
    water_density : float
        kg/m3.
    """
    found = Findings("laying check")
    found.number("chain_weight", chain_weight, "N", at_least=0.0)
    found.number("sinker_weight", sinker_weight, "N", at_least=0.0)
    found.word("chain_in", chain_in, get_args(Medium))
    found.number("freeboard", freeboard, "m", at_least=0.0, at_most=shape.deck)
    found.number("water_density", water_density, "kg/m3", at_least=900.0, at_most=1100.0)
    found.raise_if_any()
    return LayingCheck(
        Message(f"loads.laying_chain_in_{chain_in}"),
        STANDARD_GRAVITY * shape.total_mass + chain_weight + sinker_weight,
        STANDARD_GRAVITY * water_density * shape.displaced_at(freeboard),
        chain_in,
    )
