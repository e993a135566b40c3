"""Every section and key of the files that ``catopt size`` takes.

No key is required here: what the file leaves out may come as an option or be asked for. Upper
limits are those of the model, which tells them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar

from catopt.casefile.fields import Flag, Measured, OneOf, Text, Whole
from catopt.casefile.schema import SOME, Table
from catopt.units import Dimension

__all__ = [
    "BuoyOfShipTable",
    "BuoySizingTable",
    "DragAnchorTable",
    "EnvironmentTable",
    "FloatTable",
    "MooringTable",
    "ShipLineTable",
    "ShipTable",
    "SizedChecksTable",
    "SizedLineTable",
    "SizedServiceTable",
    "SizedSinkerTable",
    "TankerSizingTable",
    "TidalSiteTable",
    "WeatherTable",
]

Above = Annotated[float, Measured(Dimension.LENGTH, above=0.0)]
AtLeast = Annotated[float, Measured(Dimension.LENGTH, at_least=0.0)]
Speed = Annotated[float, Measured(Dimension.SPEED, at_least=0.0)]
Area = Annotated[float, Measured(Dimension.AREA, above=0.0, example='"580 m^2"')]
Density = Annotated[float, Measured(Dimension.DENSITY, above=0.0)]
Pull = Annotated[float, Measured(Dimension.FORCE, above=0.0)]
Mass = Annotated[float, Measured(Dimension.MASS, above=0.0)]
BuoyName = Annotated[str, Text(filled=True, example='"mooring buoy 5.0 m"')]
Soil = Annotated[str, Text(filled=True, example='"fine or silty sand"')]
Chain = Annotated[str, Text(filled=True, example='"chain studless R3"')]


class TidalSiteTable(Table):
    """Water and its levels."""

    symbols: ClassVar[Mapping[str, str]] = {
        "d": "water_depth",
        "depth": "water_depth",
        "high_water": "water_depth",
        "rho": "water_density",
    }

    water_depth: Above | None = None
    low_water: Above | None = None
    water_density: Density | None = None


class WeatherTable(Table):
    """Wind, current and waves, all from one side."""

    symbols: ClassVar[Mapping[str, str]] = {
        "H": "hmax",
        "T": "period",
        "Tp": "period",
        "height": "hs",
        "wind_speed": "wind",
        "current_speed": "current",
    }

    wind: Speed | None = None
    current: Speed | None = None
    hs: AtLeast | None = None
    hmax: AtLeast | None = None
    period: Annotated[float, Measured(Dimension.TIME, above=0.0)] | None = None


class EnvironmentTable(WeatherTable):
    """The same at a buoy, with what grows on it."""

    marine_growth: (
        Annotated[float, Measured(Dimension.LENGTH, at_least=0.0, example='"50 mm"')] | None
    ) = None


class BuoyOfShipTable(Table):
    """A buoy by its name in the library, with the hawser to the ship."""

    name: BuoyName | None = None
    file: Annotated[str, Text(filled=True, example='"buoys.toml"')] | None = None
    hawser_length: AtLeast | None = None


class FloatTable(Table):
    """A buoy by its name in the library, or by what pulls on it."""

    symbols: ClassVar[Mapping[str, str]] = {"H": "horizontal_force", "draught": "keel_depth"}

    name: Annotated[str, Text(filled=True, example='"pillar 1.8 m"')] | None = None
    file: Annotated[str, Text(filled=True, example='"buoys.toml"')] | None = None
    horizontal_force: Pull | None = None
    reserve_buoyancy: Pull | None = None
    keel_depth: AtLeast | None = None


class ShipTable(Table):
    """A tanker by its main dimensions."""

    symbols: ClassVar[Mapping[str, str]] = {
        "LOA": "length",
        "L": "length",
        "B": "breadth",
        "beam": "breadth",
        "T": "draught",
        "draft": "draught",
        "D": "moulded_depth",
        "depth": "moulded_depth",
        "DWT": "deadweight",
        "fairlead_height": "fairlead_above_water",
    }

    length: Above | None = None
    breadth: Above | None = None
    draught: Above | None = None
    ballast_draught: Above | None = None
    moulded_depth: Above | None = None
    deadweight: (
        Annotated[float, Measured(Dimension.MASS, above=0.0, example='"50000 t"')] | None
    ) = None
    frontal_area: Area | None = None
    lateral_area: Area | None = None
    fairlead_above_water: AtLeast | None = None


class SizedLineTable(Table):
    """What the line may be."""

    symbols: ClassVar[Mapping[str, str]] = {"component": "components", "chain": "components"}

    components: Annotated[list[Chain], SOME] | None = None
    diameter_min: Above | None = None
    diameter_max: Above | None = None
    length_step: Above | None = None
    prefer: Annotated[str, OneOf(("balanced", "lightest", "least-swing"))] | None = None


class ShipLineTable(SizedLineTable):
    """The same with a clump weight on it."""

    clump_weights: Annotated[list[Mass], SOME] | None = None


class MooringTable(Table):
    """Several lines around buoy or turret."""

    lines: Annotated[int, Whole("lines", example=6)] | None = None
    pretension: Annotated[float, Measured(Dimension.NUMBER, above=0.0, example='"10 %"')] | None = (
        None
    )


class DragAnchorTable(Table):
    """A drag anchor by its kind."""

    symbols: ClassVar[Mapping[str, str]] = {"kind": "name", "anchor": "name"}

    name: Annotated[str, Text(filled=True, example='"Stevpris Mk5"')] | None = None
    soil: Annotated[str, Text(filled=True, example='"sand"')] | None = None


class SizedSinkerTable(Table):
    """A sinker and what it lies on."""

    symbols: ClassVar[Mapping[str, str]] = {"mu": "friction"}

    material: Annotated[str, OneOf(("concrete", "steel"))] | None = None
    density: Density | None = None
    soil: Soil | None = None
    friction: Annotated[float, Measured(Dimension.NUMBER, above=0.0)] | None = None


class SizedChecksTable(Table):
    """What the line is checked by."""

    code: Annotated[str, Text(filled=True, example='"IALA-CALMAR"')] | None = None
    allow_recalled: Annotated[bool, Flag()] | None = None


class SizedServiceTable(Table):
    """How long the line is to last, and how fast it wears."""

    life: Annotated[float, Measured(Dimension.TIME, at_least=0.0, example='"10 years"')] | None = (
        None
    )
    wear_rate: (
        Annotated[float, Measured(Dimension.SPEED, at_least=0.0, example='"0.4 mm/year"')] | None
    ) = None


class BuoySizingTable(Table):
    """A file for ``catopt size buoy``."""

    title: Annotated[str, Text()] | None = None
    source: Annotated[str, Text()] | None = None
    site: TidalSiteTable | None = None
    environment: EnvironmentTable | None = None
    buoy: FloatTable | None = None
    line: SizedLineTable | None = None
    sinker: SizedSinkerTable | None = None
    checks: SizedChecksTable | None = None
    service: SizedServiceTable | None = None


class TankerSizingTable(Table):
    """A file for ``catopt size tanker``."""

    title: Annotated[str, Text()] | None = None
    source: Annotated[str, Text()] | None = None
    site: TidalSiteTable | None = None
    environment: WeatherTable | None = None
    ship: ShipTable | None = None
    buoy: BuoyOfShipTable | None = None
    line: ShipLineTable | None = None
    system: MooringTable | None = None
    anchor: DragAnchorTable | None = None
    sinker: SizedSinkerTable | None = None
    checks: SizedChecksTable | None = None
    service: SizedServiceTable | None = None
