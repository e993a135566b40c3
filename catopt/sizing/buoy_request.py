"""What is known of a buoy that wants a mooring."""

from __future__ import annotations

from dataclasses import dataclass, field

from catopt.loads.buoy import BUOY_METHODS, DEEPEST, WHOLE, WaveHeight
from catopt.loads.buoy_shape import BuoyShape
from catopt.model import TitleBlock
from catopt.model.kinds import Findings, exceeds
from catopt.sizing.environment import Environment
from catopt.sizing.in_motion import RunsAfloat
from catopt.sizing.input_values import ReadInput
from catopt.sizing.kinds import usual
from catopt.sizing.line_choice import MOST_DEPTHS, LineChoice, unpriced_components
from catopt.sizing.maintenance import UpkeepInputs
from catopt.sizing.pattern import SinkerGround
from catopt.words import Message


@dataclass(frozen=True)
class GivenBuoy:
    """A buoy of which only the load and the buoyancy are known."""

    horizontal_force: float  # of wind, current and waves on the buoy and its chain, N
    reserve_buoyancy: float  # vertical pull that takes it to its allowed draught, N
    keel_depth: float = 0.0  # from the water to where the chain is made fast, m

    def __post_init__(self) -> None:
        found = Findings("GivenBuoy")
        found.number("horizontal_force", self.horizontal_force, "N", above=0.0)
        found.number("reserve_buoyancy", self.reserve_buoyancy, "N", above=0.0)
        found.number("keel_depth", self.keel_depth, "m", at_least=0.0)
        found.raise_if_any()

    @property
    def name(self) -> str:
        """For titles."""
        return "buoy"


@dataclass(frozen=True)
class BuoyRequest:
    """A buoy, its place and its weather."""

    buoy: BuoyShape | GivenBuoy  # by its geometry, or by what it pulls
    # depths and weather. Where the force is given, only its depths and waves count
    environment: Environment
    # what the chain may be
    line: LineChoice = field(default_factory=lambda: LineChoice(usual("chain"), usual("code")))
    ground: SinkerGround = field(default_factory=SinkerGround)  # soil and sinker
    marine_growth: float = 0.0  # thickness on hull and chain, m
    # departures from the code's own loads: see `catopt.loads.buoy_loads`
    wave_height: WaveHeight = "hs"
    chain_waves: bool = False
    # of the loads: CALMAR's, which stops where the largest wave breaks, or ours, which goes on
    load_method: str = WHOLE
    # length that practice keeps to where it can, in depths under the largest crest
    scope: float = field(default_factory=lambda: usual("scope"))
    # how lines are run with the buoy before one is recommended; None: at rest alone
    in_motion: RunsAfloat | None = None
    # wear of the thrash section, and prices
    upkeep: UpkeepInputs = field(default_factory=UpkeepInputs)
    crane: float | None = None  # what the tender's crane lifts, kg
    title: str = ""  # of the case; made of the buoy and the depth when left out
    source: str = ""  # of the case: where its figures come from; the command when left out
    document: TitleBlock | None = None  # of the note
    defaults: tuple[str, ...] = ()  # what was not given and was taken, in words; for the answer
    inputs: tuple[ReadInput, ...] = ()

    def __post_init__(self) -> None:
        found = Findings("BuoyRequest")
        found.number("scope", self.scope, "", above=0.0, at_most=MOST_DEPTHS)
        found.word("load_method", self.load_method, BUOY_METHODS)
        low, high = self.environment.levels.low, self.environment.levels.high
        if isinstance(self.buoy, BuoyShape) and exceeds(high, DEEPEST):
            allowed = Message("refused_sizing.calmar_holds_down_m_water", deepest=DEEPEST)
            found.add("levels.high", f"{high:g} m", allowed)
        keel = self.keel_depth(0.0)
        if keel >= low:
            allowed = Message("refused_sizing.water_m_deep_at_low", low=low)
            if isinstance(self.buoy, BuoyShape):
                key = "refused_sizing.reaches_m_under_water"
                allowed = Message(key, keel=keel, allowed=allowed)
                found.add("buoy", f'"{self.buoy.name}"', allowed)
            else:
                found.add("keel_depth", f"{keel:.3g} m", allowed)
        if isinstance(self.buoy, BuoyShape) and self.environment.is_calm:
            allowed = Message("refused_sizing.something_has_push_buoy")
            found.add("wind", Message("refused_sizing.calm"), allowed)
        found.raise_if_any()

    @property
    def is_priced(self) -> bool:
        """Whether a price is known of everything that the line may have."""
        return not unpriced_components(self.line, self.environment.water_density)

    @property
    def reserve_buoyancy(self) -> float:
        """Of the buoy, N."""
        if isinstance(self.buoy, GivenBuoy):
            return self.buoy.reserve_buoyancy
        return self.buoy.reserve_buoyancy(self.environment.water_density)

    def eye_depth(self, pull: float) -> float:
        """From the water to where the chain is made fast, under a pull of the chain in N; m."""
        if isinstance(self.buoy, GivenBuoy):
            return self.buoy.keel_depth
        return self.buoy.afloat(pull, self.environment.water_density).eye_depth

    def keel_depth(self, pull: float) -> float:
        """From the water to the buoy's lowest point, under a pull of the chain in N; m."""
        if isinstance(self.buoy, GivenBuoy):
            return self.buoy.keel_depth
        return self.buoy.afloat(pull, self.environment.water_density).keel_depth
