"""What is known of a tanker that wants a mooring."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Final, get_args

from catopt.catalogue.practice import laid_cable
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.ship import Condition, Ship
from catopt.loads.ship_coefficients import ShipCoefficients
from catopt.loads.ship_loads import METHODS, TCN
from catopt.model import TitleBlock
from catopt.model.kinds import Findings
from catopt.sizing.environment import SERVICE_TYPES, Environment, ServiceType, Weathervaning
from catopt.sizing.in_motion import RunsAfloat
from catopt.sizing.input_values import ReadInput
from catopt.sizing.kinds import usual
from catopt.sizing.line_choice import LineChoice, unpriced_components
from catopt.sizing.pattern import DragGround, SinkerGround
from catopt.words import Message

_LEAST_CARGO: Final = 0.4
"""Deadweight over displacement of a loaded ship at least; catopt's own. Merchant ships have 0.55 to
0.86."""


@dataclass(frozen=True)
class MooredShip:
    """The ship in one condition."""

    condition: str  # ``"loaded"`` or ``"ballast"``
    ship: Ship  # afloat at its draught
    wind_on: str  # kind of ship for the wind, after Blendermann: ``"tanker loaded"``
    fairlead: float  # height of the bow fairlead above the water, m
    # kg, to hold against the displacement; None where it is not known
    deadweight: float | None = None
    # tables of its own, in place of Blendermann's wind and UFC's current
    coefficients: ShipCoefficients | None = None

    def __post_init__(self) -> None:
        found = Findings("MooredShip")
        found.word("condition", self.condition, get_args(Condition))
        found.number("fairlead", self.fairlead, "m", at_least=0.0, at_most=100.0)
        found.raise_if_any()
        if self.deadweight is not None:
            check_deadweight(self.deadweight, self.ship)


def check_deadweight(deadweight: float, ship: Ship) -> None:
    """Hold a deadweight, kg, against the loaded ship's displacement, from both sides."""
    found = Findings("MooredShip")
    found.number("deadweight", deadweight, "kg", above=0.0)
    displaced = ship.displacement * 1025.0
    of_it = Message("refused_sizing.what_it_displaces", displaced=displaced / 1e3)
    own = f"{deadweight / 1e3:.6g} t"
    if not found.problems and deadweight >= displaced:
        is_box = ship.displacement >= ship.length_waterline * ship.breadth * ship.draught
        key = "refused_sizing.not_below" if is_box else "refused_sizing.not_below_or_barge"
        found.add("deadweight", own, Message(key, of_it=of_it))
    elif not found.problems and deadweight < _LEAST_CARGO * displaced:
        allowed = Message("refused_sizing.below", least_cargo=_LEAST_CARGO, of_it=of_it)
        found.add("deadweight", own, allowed)
    found.raise_if_any()


def note_aground(
    ships: Iterable[MooredShip], low: float, add: Callable[[str, str, str], None]
) -> None:
    """Add a problem of each condition whose draught is all of the water at low water, m."""
    for each in ships:
        if each.ship.draught >= low:
            key = "ballast_draught" if each.condition == "ballast" else "draught"
            allowed = Message("refused_sizing.water_m_deep_at_low_too", low=low)
            add(key, f"{each.ship.draught:g} m", allowed)


@dataclass(frozen=True)
class TankerRequest:
    """A tanker, its place and its weather."""

    ships: tuple[MooredShip, ...]  # one for each condition
    environment: Environment  # depths and weather
    # what the chain may be
    line: LineChoice = field(
        default_factory=lambda: LineChoice(
            usual("chain", "tanker"),
            usual("code", "tanker"),
            diameter_max=usual("diameter_max", "tanker"),
            length_step=usual("length_step", "tanker"),
        )
    )
    ground: DragGround | SinkerGround = field(default_factory=DragGround)  # what holds the line
    # that the ship lies at with a hawser; None: the line goes to the ship's bow
    buoy: BuoyShape | None = None
    hawser: float = 0.0  # its length, m
    lines: int = 1  # 1, or 3 and more around the body
    # of several lines, as a part of the largest horizontal force of one
    pretension: float = field(default_factory=lambda: usual("pretension", "tanker"))
    # clump weights of which the line has one, in air, kg; none when empty
    clump_masses: tuple[float, ...] = ()
    # where it may hang, from the anchor, m; empty: in parts of the height that the line spans
    clump_places: tuple[float, ...] = ()
    clump_density: float = 2400.0  # kg/m3
    # of the loads on the ship; of several the largest force governs
    load_methods: tuple[str, ...] = (METHODS[0],)
    wave_coefficient: float | None = None  # chi of 22TCN 222-95, which that method wants in waves
    # where wind, current and waves come from, and what turns the ship; of all directions and
    # stable headings the one of the largest force governs. All from one side when left out
    weathervaning: Weathervaning = field(default_factory=Weathervaning)
    # of UFC 4-159-03: III and IV want dynamic methods
    service_type: ServiceType = field(default_factory=lambda: usual("service_type", "tanker"))
    # how lines are run with the ship before one is recommended; None: at rest alone
    in_motion: RunsAfloat | None = None
    title: str = ""  # of the case; made of the ship and the depth when left out
    source: str = ""  # of the case: where its figures come from; the command when left out
    document: TitleBlock | None = None  # of the note
    defaults: tuple[str, ...] = ()  # what was not given and was taken, in words; for the answer
    inputs: tuple[ReadInput, ...] = ()  # all that is known, as it was read; for the answer
    estimates: tuple[str, ...] = ()  # what was estimated, in words; for the answer

    def __post_init__(self) -> None:
        found = Findings("TankerRequest")
        if not self.ships:
            allowed = Message("refused_sizing.ship_one_condition_at_least")
            found.add("ships", Message("refused.none"), allowed)
        found.number("hawser", self.hawser, "m", at_least=0.0, at_most=1000.0)
        found.number("pretension", self.pretension, "", above=0.0, at_most=0.9)
        if not isinstance(self.lines, int) or self.lines not in (1, *range(3, 25)):
            found.add("lines", str(self.lines), Message("refused_sizing.n_1_or_3_24_around"))
        if self.hawser > 0.0 and self.buoy is None:
            allowed = Message("refused_sizing.goes_buoy_give_one_or")
            found.add("hawser", f"{self.hawser:g} m", allowed)
        for index, mass in enumerate(self.clump_masses):
            found.number(f"clump_masses[{index}]", mass, "kg", above=0.0)
        found.number("clump_density", self.clump_density, "kg/m3", above=1100.0, at_most=20e3)
        if self.environment.is_calm:
            allowed = Message("refused_sizing.something_has_push_ship")
            found.add("wind", Message("refused_sizing.calm"), allowed)
        found.word("service_type", self.service_type, SERVICE_TYPES)
        self._check_methods(found)
        if self.ships:
            self._check_swing(found)
        note_aground(self.ships, self.environment.levels.low, found.add)
        found.raise_if_any()

    def _check_methods(self, found: Findings) -> None:
        """Note a method that is unknown, or that would leave the waves out."""
        words = ", ".join(METHODS)
        for index, method in enumerate(self.load_methods):
            if method not in METHODS:
                allowed = Message("refused.of_these", words=words)
                found.add(f"load_methods[{index}]", repr(method), allowed)
        if not self.load_methods:
            allowed = Message("refused_sizing.one_at_least_of", words=words)
            found.add("load_methods", "none", allowed)
        is_tcn = TCN in self.load_methods
        if self.wave_coefficient is not None:
            found.number("wave_coefficient", self.wave_coefficient, "", at_least=0.0, at_most=1.0)
            if not is_tcn:
                allowed = Message("refused_sizing.leave_out_or_name_among", tcn=TCN)
                found.add("wave_coefficient", f"{self.wave_coefficient:g}", allowed)
        elif is_tcn and self.environment.sea.hmax > 0.0:
            allowed = Message("refused_sizing.missing_wants_chi_waves_or", tcn=TCN)
            found.add("wave_coefficient", "", allowed)

    def _check_swing(self, found: Findings) -> None:
        """Note a bound on the swing radius that no line keeps, or that nothing evaluates."""
        most, rest = self.line.max_swing, self.beyond_the_line
        if self.lines > 1:
            allowed = Message("refused_sizing.leave_out_one_line_several")
            if most is not None:
                found.add("max_swing", f"{most:g} m", allowed)
            if self.line.swing_price:
                found.add("swing_price", f"{self.line.swing_price:g} USD/m", allowed)
            if self.line.prefer == "least-swing":
                found.add("prefer", '"least-swing"', allowed)
        elif most is not None and most <= rest:
            allowed = Message("refused_sizing.ship_hawser_alone_are_m", rest=rest)
            found.add("max_swing", f"{most:g} m", allowed)

    @property
    def is_priced(self) -> bool:
        """Whether a price is known of everything that the line may have."""
        density = self.environment.water_density
        return not self.clump_masses and not unpriced_components(self.line, density)

    @property
    def own_cable(self) -> float:
        """Nominal diameter of the cable that the ship would be laid on, m, by her equipment."""
        each = next((e for e in self.ships if e.condition == "loaded"), self.ships[0])
        ship, density = each.ship, self.environment.water_density
        return laid_cable(density * ship.displacement, ship.frontal_area, ship.lateral_area)

    @property
    def reserve_buoyancy(self) -> float | None:
        """Of the buoy, N; None without one."""
        density = self.environment.water_density
        return None if self.buoy is None else self.buoy.reserve_buoyancy(density)

    @property
    def beyond_the_line(self) -> float:
        """Part of the swing radius that is hawser and ship, m."""
        return self.hawser + self.longest

    @property
    def longest(self) -> float:
        """Length of the ship over all, m."""
        return max(each.ship.length_overall for each in self.ships)
