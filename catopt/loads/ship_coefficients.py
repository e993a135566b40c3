"""Coefficients of wind and current on ships, by several sources."""

from __future__ import annotations

import math
import os
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType
from typing import Final, Literal, NamedTuple, get_args

from catopt.catalogue.components import CONFIDENCES
from catopt.catalogue.table import TomlTable
from catopt.documents import read_text
from catopt.loads.component import BLENDERMANN, Axis, LoadComponent, LoadSource, Number
from catopt.loads.environment import Wind, drag, drag_component, wind_on_ship
from catopt.loads.ship import Condition, Ship
from catopt.model.kinds import Findings
from catopt.words import Cited, Message, term


class WindType(NamedTuple):
    """Coefficients of a kind of ship.

    Of beam wind (CDt, on the lateral area), of wind from ahead and from astern (CDlAF, on the
    frontal area), and the cross-force parameter delta.
    """

    transverse: float
    bow: float
    stern: float
    delta: float


TYPES = MappingProxyType(
    {
        "car carrier": WindType(0.95, 0.55, 0.60, 0.80),
        "cargo loaded": WindType(0.85, 0.65, 0.55, 0.40),
        "cargo containers on deck": WindType(0.85, 0.55, 0.50, 0.40),
        "container ship loaded": WindType(0.90, 0.55, 0.55, 0.40),
        "destroyer": WindType(0.85, 0.60, 0.65, 0.65),
        "diving support vessel": WindType(0.90, 0.60, 0.80, 0.55),
        "ferry": WindType(0.90, 0.45, 0.50, 0.80),
        "fishing vessel": WindType(0.95, 0.70, 0.70, 0.40),
        "LNG tanker": WindType(0.70, 0.60, 0.65, 0.50),
        "offshore supply vessel": WindType(0.90, 0.55, 0.80, 0.55),
        "passenger liner": WindType(0.90, 0.40, 0.40, 0.80),
        "research vessel": WindType(0.85, 0.55, 0.65, 0.60),
        "tanker loaded": WindType(0.70, 0.90, 0.55, 0.40),
        "tanker ballast": WindType(0.70, 0.75, 0.55, 0.40),
        "tender": WindType(0.85, 0.55, 0.55, 0.65),
    }
)
"""Kinds of ship, as the MSS toolbox lists them (C)."""

_SOURCE = LoadSource(BLENDERMANN, "CX and CY", "C")


def coefficients(kind: WindType, angle: float, frontal_over_lateral: float) -> tuple[float, float]:
    """CX on the frontal and CY on the lateral area; CX is negative from ahead.

    D = 1 - (delta/2) (1 - CDl/CDt) sin^2(2 gamma) with CDl = CDlAF AF/AL;
    CX = -CDlAF cos(gamma)/D; CY = CDt sin(gamma)/D. The angle gamma is from the bow to where the
    wind comes from, rad: 0 from ahead.
    """
    along = kind.bow if math.cos(angle) >= 0.0 else kind.stern
    ratio = along * frontal_over_lateral / kind.transverse
    divisor = 1.0 - 0.5 * kind.delta * (1.0 - ratio) * math.sin(2.0 * angle) ** 2
    return -along * math.cos(angle) / divisor, kind.transverse * math.sin(angle) / divisor


def pressure_centre(angle: float, length: float, lateral_centre: float) -> float:
    """Return where the wind across the ship acts, m forward of midships: Loa CN/CY.

    CN = (sL/Loa - 0.18 (gamma - 90 deg)) CY with gamma in rad, from the bow, either side: 0.28 Loa
    forward of the centre of the lateral area, sL, in a head wind, at that centre on the beam.
    """
    return lateral_centre - 0.18 * (abs(angle) - 0.5 * math.pi) * length


def wind_type(kind: str) -> WindType:
    """Look a kind of ship up by its key in `TYPES`; an unknown one is refused."""
    found = Findings("wind after Blendermann")
    found.word("kind", kind, tuple(TYPES))
    found.raise_if_any()
    return TYPES[kind]


def blendermann_loads(
    ship: Ship, wind: Wind, kind: str, *, angle: float, air_density: float
) -> tuple[LoadComponent, LoadComponent]:
    """Wind at 10 m along and across a ship of a kind, a key of `TYPES`; another is refused.

    The angle is from the bow to where the wind comes from, rad; the density in kg/m3.
    """
    cx, cy = coefficients(wind_type(kind), angle, ship.frontal_area / ship.lateral_area)
    note = Message("loads.wind_note", kind=term(kind), angle=math.degrees(angle))
    along, across = ("AF", "CX", cx, _SOURCE), ("AL", "CY", cy, _SOURCE)
    return wind_on_ship(ship, wind, air_density, along, across, note)


SCHEMA: Final = "catopt.ship-coefficients/1"
"""What a file of coefficients has under its key ``schema``."""

Area = Literal["frontal", "lateral", "breadth x draught", "length x draught"]
"""Of what a coefficient is: seen from ahead or from the side above water; under water by the
breadth or by the length of the waterline."""

_AREAS: Final[dict[str, tuple[Area, ...]]] = {
    "wind": ("frontal", "lateral"),
    "current": ("breadth x draught", "length x draught"),
}
_ROUNDING: Final = 1e-9


@dataclass(frozen=True)
class CoefficientTable:
    """Coefficients of wind, or of current in one depth, by the angle off the bow."""

    angles: tuple[float, ...]  # that it comes from, rad: rising from the bow, 0, to the stern, pi
    along: tuple[float, ...]  # forwards is positive
    across: tuple[float, ...]  # away from where it comes from is positive
    yaw: tuple[float, ...]  # moment over across area and length; empty: not known
    areas: tuple[Area, Area]  # of along, and of across and yaw
    depth_over_draught: float | None = None  # None: in any depth
    density: float | None = None  # kg/m3, that it was made for; None: that of the method
    condition: Condition | None = None  # of the ship; None: in both

    def own_density(self, of_method: float) -> float:
        """Return the density that it goes with, kg/m3, in place of the method's."""
        return of_method if self.density is None else self.density

    def at(self, angle: float) -> tuple[float, float, float]:
        """Interpolate along, across and yaw at an angle off the bow, rad, to either side.

        InputError: an angle beyond those of the table.
        """
        off, side = abs(angle), math.copysign(1.0, angle)
        low, high = self.angles[0], self.angles[-1]
        if not low - _ROUNDING <= off <= high + _ROUNDING:
            found = Findings("ship coefficients")
            ends = {"value": math.degrees(low), "value2": math.degrees(high)}
            spans = Message("refused_sizing.table_has_deg_off_bow", **ends)
            found.add("angles", f"{math.degrees(off):g} deg", spans)
            found.raise_if_any()
        below, above, part = _between(self.angles, off)

        def value(of: Sequence[float]) -> float:
            return of[below] + part * (of[above] - of[below]) if of else 0.0

        return value(self.along), side * value(self.across), side * value(self.yaw)


@dataclass(frozen=True)
class ShipCoefficients:
    """Tables of a ship: what they lack is taken by UFC's current and Blendermann's wind."""

    name: str
    source: LoadSource
    wind: tuple[CoefficientTable, ...] = ()  # one for a condition
    current: tuple[CoefficientTable, ...] = ()  # of a condition by rising depth over draught
    # whether the current across is no less than UFC's, which has shallow water in it
    is_least_ufc: bool = False
    # that they were read from; empty: made otherwise
    file: str = field(default="", compare=False)

    def in_condition(self, condition: str) -> ShipCoefficients:
        """Keep the tables of a condition."""

        def own(of: Sequence[CoefficientTable]) -> tuple[CoefficientTable, ...]:
            return tuple(each for each in of if each.condition in (None, condition))

        return replace(self, wind=own(self.wind), current=own(self.current))

    @property
    def turns(self) -> bool:
        """Whether they have the moment of the current."""
        return bool(self.current) and all(each.yaw for each in self.current)

    def wind_at(self, angle: float) -> tuple[CoefficientTable, tuple[float, float, float]]:
        """Return the table of the wind, and along, across and yaw at an angle off the bow, rad."""
        (table,) = self.wind
        return table, table.at(angle)

    def current_at(
        self, angle: float, depth_over_draught: float
    ) -> tuple[CoefficientTable, tuple[float, float, float]]:
        """Return a table of the current, and along, across and yaw in water of a depth.

        The angle is off the bow, rad; between two depths it is interpolated. InputError: a depth
        beyond those of the tables.
        """
        if len(self.current) == 1 and self.current[0].depth_over_draught is None:
            return self.current[0], self.current[0].at(angle)
        ratios = [each.depth_over_draught or 0.0 for each in self.current]
        low, high = ratios[0], ratios[-1]
        if not low * (1.0 - _ROUNDING) <= depth_over_draught <= high * (1.0 + _ROUNDING):
            found = Findings("ship coefficients")
            spans = Message("refused_sizing.there_are_tables_depths_draughts", low=low, high=high)
            found.add("depth_over_draught", f"{depth_over_draught:.4g}", spans)
            found.raise_if_any()
        below, above, part = _between(ratios, depth_over_draught)
        shallow, deep = self.current[below].at(angle), self.current[above].at(angle)
        along, across, yaw = (a + part * (b - a) for a, b in zip(shallow, deep, strict=True))
        return self.current[above], (along, across, yaw)

    def loads(
        self,
        kind: Literal["wind", "current"],
        ship: Ship,
        speed: float,
        density: float,
        angle: float,
        depth: float,
    ) -> tuple[LoadComponent, LoadComponent]:
        """Compute wind or current along and across a ship: 1/2 rho V^2 A C.

        Speed in m/s, density of the method in kg/m3, angle off the bow in rad, depth in m.
        """
        table, (along, across, _) = self._at(kind, ship, angle, depth)
        stream = (table.own_density(density), speed)
        note = Message("loads.own_note", name=self.name, angle=math.degrees(angle))

        def component(key: str, axis: Axis, of: Area, coefficient: float) -> LoadComponent:
            return drag_component(
                Message(key),
                kind,
                stream,
                area_of(ship, of),
                Number("C", coefficient, "", Message("loads.coefficient_here")),
                self.source,
                axis=axis,
                note=note,
            )

        first, second = table.areas
        return (
            component(f"loads.{kind}_along", "surge", first, along),
            component(f"loads.{kind}_across", "sway", second, across),
        )

    def push(
        self,
        kind: Literal["wind", "current"],
        ship: Ship,
        speed: float,
        density: float,
        angle: float,
        depth: float,
    ) -> tuple[float, float | None]:
        """Return the force across, N, and its moment about midships, N m; None: not known.

        The moment is positive where the force acts forward of midships. The rest is as of `loads`.
        """
        table, (_, across, yaw) = self._at(kind, ship, angle, depth)
        area = area_of(ship, table.areas[1]).value
        pressure = drag(table.own_density(density), speed, area, 1.0)
        return pressure * across, pressure * yaw * ship.length_waterline if table.yaw else None

    def _at(
        self, kind: Literal["wind", "current"], ship: Ship, angle: float, depth: float
    ) -> tuple[CoefficientTable, tuple[float, float, float]]:
        if kind == "wind":
            return self.wind_at(angle)
        return self.current_at(angle, depth / ship.draught)


def _between(rising: Sequence[float], at: float) -> tuple[int, int, float]:
    """Find the entries on both sides of a value, and its part of the way between them."""
    above = min(max(bisect_left(rising, at), 1), len(rising) - 1)
    below = max(above - 1, 0)
    way = rising[above] - rising[below]
    return below, above, min(max((at - rising[below]) / way, 0.0), 1.0) if way else 0.0


def area_of(ship: Ship, of: Area) -> Number:
    """Return the area that a coefficient is referred to."""
    match of:
        case "frontal":
            return Number("AF", ship.frontal_area, "m2", Message("loads.frontal_area"))
        case "lateral":
            return Number("AL", ship.lateral_area, "m2", Message("loads.lateral_area"))
        case "breadth x draught":
            area = ship.breadth * ship.draught
            return Number("B T", area, "m2", Message("loads.breadth_draught"))
    area = ship.length_waterline * ship.draught
    return Number("LwL T", area, "m2", Message("loads.length_times_draught"))


# ------------------------------------------------------------------ square-ended hulls

_ROUND: Final = tuple(math.radians(each) for each in range(181))


def _square(areas: tuple[Area, Area]) -> CoefficientTable:
    """Take a coefficient of 1.00 on what is seen from ahead and from the side."""
    along = tuple(-math.cos(each) for each in _ROUND)
    across = tuple(math.sin(each) for each in _ROUND)
    return CoefficientTable(_ROUND, along, across, (), areas)


SQUARE_ENDED: Final = ShipCoefficients(
    Cited("square-ended, Cd 1.00"),
    LoadSource("Worked example of a barge's buoy mooring", "Cd 1.00 for wind and for current", "C"),
    wind=(_square(("frontal", "lateral")),),
    current=(_square(("breadth x draught", "length x draught")),),
    is_least_ufc=True,
)
"""Barges and pontoons: Cd 1.00 (C), by cosine and sine off the bow; the current across is no less
than UFC's, for the example's is that of deep water."""


# ------------------------------------------------------------------ files


def read_ship_coefficients(path: str | os.PathLike[str]) -> ShipCoefficients:
    """Read a file of coefficients of one's own.

    Raises
    ------
    InputError
        With every problem of the file.
    """
    source = os.fspath(path)
    text = read_text(Path(path), source, kind="file of coefficients")
    return replace(parse_ship_coefficients(text, source), file=os.fspath(Path(source).resolve()))


def parse_ship_coefficients(text: str, source: str = "") -> ShipCoefficients:
    """Read the text of a file of coefficients; the source names it in messages."""
    keys = ("name", "source", "confidence", "angles_from", "wind", "current")
    file, findings = TomlTable.of_file(text, source, SCHEMA, keys)
    name, document = file.text("name"), file.text("source")
    confidence = file.word("confidence", CONFIDENCES)
    start = file.word("angles_from", ("bow", "stern"))
    wind = [_read(each, "wind", start) for each in file.tables("wind", required=False)]
    current = [_read(each, "current", start) for each in file.tables("current", required=False)]
    if not wind and not current:
        file.problem("wind", Message("refused_file.wind_or_current"))
    findings.raise_if_any()
    made = ShipCoefficients(
        name or "",
        LoadSource(document or "", name or "", confidence or CONFIDENCES[-1]),
        tuple(each for each in wind if each),
        tuple(sorted((e for e in current if e), key=lambda each: each.depth_over_draught or 0.0)),
    )
    _check_conditions(findings, made)
    findings.raise_if_any()
    return made


def _read(
    table: TomlTable, kind: Literal["wind", "current"], start: str | None
) -> CoefficientTable | None:
    """Read one table; None where something is wrong with it."""
    own = ("depth_over_draught",) if kind == "current" else ()
    split = ("across_fore", "across_aft")
    columns = ("along", "across", "yaw", *split)
    table.only("condition", "density", "along_area", "across_area", "angles", *columns, *own)
    first, second = (table.word(f"{axis}_area", _AREAS[kind]) for axis in ("along", "across"))
    conditions: tuple[Condition, ...] = get_args(Condition)
    condition = table.word("condition", conditions) if table.has("condition") else None
    density = table.number("density", above=0.0) if table.has("density") else None
    ratio = table.number(own[0], above=1.0) if own and table.has(own[0]) else None
    count = len(table.values["angles"]) if isinstance(table.values.get("angles"), list) else 1
    angles = table.numbers("angles", max(count, 1))
    is_split = any(map(table.has, split))
    if is_split and (table.has("across") or table.has("yaw")):
        table.problem(split[0], Message("refused_file.either_across", other="across_aft"))
        return None
    wanted = ("along", *(split if is_split else ("across", *(["yaw"] if table.has("yaw") else []))))
    read = {key: table.numbers(key, max(count, 1)) for key in wanted}
    if angles is not None and any(not a < b for a, b in pairwise(angles)):
        table.problem("angles", Message("refused_motion.must_rise"))
        return None
    if angles is not None and not 0.0 <= angles[0] <= angles[-1] <= 180.0:
        table.problem("angles", Message("refused_file.half_circle"))
        return None
    if angles is None or not first or not second or None in read.values() or start is None:
        return None
    values = {key: list(each or ()) for key, each in read.items()}
    if is_split:
        both = list(zip(values.pop(split[0]), values.pop(split[1]), strict=True))
        # The forces are at the perpendiculars, half a length off midships.
        values |= {"across": [f + a for f, a in both], "yaw": [0.5 * (f - a) for f, a in both]}
    off = [math.radians(each) for each in angles]
    if start == "stern":
        off = [math.pi - each for each in reversed(off)]
        values = {key: each[::-1] for key, each in values.items()}
    return CoefficientTable(
        tuple(off),
        along=tuple(values["along"]),
        across=tuple(values["across"]),
        yaw=tuple(values.get("yaw", ())),
        areas=(first, second),
        depth_over_draught=ratio,
        density=density,
        condition=condition,
    )


def _check_conditions(findings: Findings, of: ShipCoefficients) -> None:
    """Note tables between which there is no telling."""
    for condition in get_args(Condition):
        own = of.in_condition(condition)
        if len(own.wind) > 1:
            allowed = Message("refused_sizing.one_ship", condition=term(condition))
            tables = Message("refused_sizing.tables", count=len(own.wind))
            findings.add("wind", tables, allowed)
        ratios = [each.depth_over_draught for each in own.current]
        if len(ratios) > 1 and (None in ratios or len(set(ratios)) < len(ratios)):
            key = "refused_sizing.each_ship_wants_depth_over"
            allowed = Message(key, condition=term(condition))
            tables = Message("refused_sizing.tables", count=len(ratios))
            findings.add("current", tables, allowed)
