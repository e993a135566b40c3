"""What holds the line at the bed: the soil, and what is laid on it or dug into it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Final, Literal

from catopt.errors import NoAnswerError
from catopt.loads.drag_anchor import DragAnchorSize, size_drag_anchor
from catopt.loads.holding_data import DataSet
from catopt.loads.sinker import (
    DENSITIES,
    FACTOR_SOURCE,
    SAFETY_FACTOR,
    Material,
    SinkerSize,
    friction_of,
    size_sinker,
)
from catopt.loads.sizes import SINKER_MASSES
from catopt.model import Anchor, SinkerChoice
from catopt.model.validity import Findings
from catopt.sizing.kinds import usual

HEAVY_SINKERS: Final = (
    *SINKER_MASSES,
    *(1e3 * tonnes for tonnes in (80, 100, 125, 150, 200, 250, 300, 400, 500, 600, 800, 1000)),
)
"""kg, in air: `SINKER_MASSES` and what is cast for ships; catopt's own list."""

CALMAR_SOIL: Final = "IALA default"
"""The friction of IALA's CALMAR, 1.0 on any ground."""

SAND: Final = "fine or silty sand"
"""Taken of a ground of which nothing is said, by a code that has no friction of its own."""


@dataclass(frozen=True)
class SinkerGround:
    """A sinker on a soil."""

    # a key of `catopt.loads.sinker.SOIL_FRICTION`; None where `friction` is given
    soil: str | None = CALMAR_SOIL
    friction: float | None = None  # tan(delta) of one's own
    material: Material = "concrete"  # of the sinker
    density: float | None = None  # kg/m3; None: that of the material
    safety_factor: float = SAFETY_FACTOR  # on sliding; used where the code has none of its own

    def __post_init__(self) -> None:
        self.sized(0.0, 0.0, 1025.0)

    @property
    def mu(self) -> float:
        """Friction on the soil."""
        if self.friction is not None:
            return self.friction
        assert self.soil is not None
        return friction_of(self.soil, self.material)[0]

    @property
    def rho(self) -> float:
        """Density of the sinker, kg/m3."""
        return DENSITIES[self.material] if self.density is None else self.density

    @property
    def is_usual_factor(self) -> bool:
        """Whether the factor on sliding is IALA's, which is taken unless another is given."""
        return self.safety_factor == SAFETY_FACTOR

    def choice(self, *, coded: bool, heavy: bool = False) -> SinkerChoice:
        """Make the sinkers that a design chooses from, with those for ships where `heavy`.

        `coded`: the code that is checked has a factor on sliding, which then holds.
        """
        return SinkerChoice(
            masses=HEAVY_SINKERS if heavy else SINKER_MASSES,
            density=self.rho,
            friction=self.mu,
            safety_factor=None if coded else self.safety_factor,
            factor_source="" if coded or not self.is_usual_factor else FACTOR_SOURCE.text,
        )

    def by_other_rule(self, of: SinkerSize, water_density: float) -> SinkerSize | None:
        """Size it for the same pull by the rule that was not chosen; None beyond what is cast.

        One rule takes the friction of the soil (NAVFAC), the other phi = 45 deg whatever the soil
        (IALA CALMAR). They differ by a factor of two and more.
        """
        soil = SAND if self.soil == CALMAR_SOIL else CALMAR_SOIL
        try:
            other = replace(self, soil=soil, friction=None)
            return other.sized(of.horizontal_force, of.vertical_force, water_density)
        except NoAnswerError:
            return None

    def sized(
        self, horizontal_force: float, vertical_force: float, water_density: float
    ) -> SinkerSize:
        """Size a sinker for a pull of the line on it, N, with its sources and notes."""
        return size_sinker(
            horizontal_force,
            vertical_force,
            soil=self.soil,
            friction=self.friction,
            material=self.material,
            density=self.density,
            safety_factor=self.safety_factor,
            water_density=water_density,
            series=HEAVY_SINKERS,
        )


@dataclass(frozen=True)
class DragGround:
    """A drag anchor in a soil."""

    # one of `catopt.loads.holding_data.ANCHORS` and of `SOILS`
    anchor: str = field(default_factory=lambda: usual("anchor", "tanker"))
    soil: str = field(default_factory=lambda: usual("soil", "tanker"))
    # data set, or "lower": the lowest of those that have the anchor
    data: DataSet | Literal["lower"] = "lower"
    # on the ultimate capacity; None: that of UFC table 3-7 for its kind
    safety_factor: float | None = None
    allow_recalled: bool = False  # whether recalled figures (R) may stand alone

    def __post_init__(self) -> None:
        found = Findings("DragGround")
        found.numbers(self, "", "safety_factor", at_least=1.0)
        found.raise_if_any()
        self.sized(0.0)

    def sized(self, horizontal_force: float) -> DragAnchorSize:
        """Size an anchor for a horizontal pull, N."""
        return size_drag_anchor(
            self.anchor,
            self.soil,
            horizontal_force,
            safety_factor=self.safety_factor,
            data=self.data,
            allow_recalled=self.allow_recalled,
        )

    def held(self, size: DragAnchorSize) -> Anchor:
        """Make the anchor of a case out of what `sized` gave."""
        return Anchor(
            kind="drag",
            holding_capacity=size.capacity.capacity,
            safety_factor=size.safety_factor,
            factor_source="" if size.factor_source is None else size.factor_source.text,
            mass=size.mass,
        )
