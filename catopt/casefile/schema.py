"""Every section and key of a case file.

The keys of a table are the attributes of a part of the model, by the same names: with their kinds
(`catopt.model.kinds`) and their defaults. Here is only what a file has otherwise. A key that may be
left out and is left out is not there, and the model is then built without it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, fields, is_dataclass
from types import MappingProxyType
from typing import Annotated, Any, ClassVar

from catopt import model
from catopt.model import ClumpWeightChoice, Load, PointLoad, Site, SwarmSettings
from catopt.model.design import Component
from catopt.model.kinds import (
    Angle,
    Density,
    File,
    Force,
    Height,
    Kind,
    Length,
    Measured,
    NotNegative,
    OneOf,
    Share,
    Size,
    SomeForce,
    Source,
    Weight,
    annotated,
)
from catopt.model.load import Code
from catopt.model.network import LineBetween, Network
from catopt.units import Dimension

MOST_LISTED, MOST_TABLES = 1_000, 200
"""Values that an array may have, and tables that an array of tables may; at least one, unless said
otherwise."""

MOST_FINDINGS = 200
"""Findings of one file: a file with more has one fault, that it is another kind of file."""


@dataclass(frozen=True)
class Values:
    """The keys that give the values of one quantity, of which one way is chosen.

    One has the key `one`; several have that of the model's attribute, `many`; a range has keys that
    begin with `one`.
    """

    one: str
    many: str

    @property
    def range(self) -> tuple[str, str, str]:
        """Keys of a range: smallest, largest, step."""
        return f"{self.one}_min", f"{self.one}_max", f"{self.one}_step"

    @property
    def keys(self) -> tuple[str, ...]:
        """All of them."""
        return self.many, self.one, *self.range


LENGTHS = Values("length", "lengths")
MASSES = Values("mass", "masses")
POSITIONS = Values("position", "positions")
RADII = Values("anchor_radius", "anchor_radii")
PRETENSIONS = Values("pretension", "pretensions")


class TableSchema:
    """A table of a file: its keys, and of one that was read what the file gives."""

    model: ClassVar[Any] = None
    """Part of the model whose attributes the keys are, beside those annotated in the class."""

    keys: ClassVar[str] = ""
    """The keys in their order, where it is not that of the model; ``...``: the rest of these."""

    choices: ClassVar[tuple[Values, ...]] = ()
    """Attributes of the model whose values a file may give in several ways."""

    elsewhere: ClassVar[Mapping[str, str]] = {}
    """Keys of another kind of file or of a later version, each with what is said of it."""

    symbols: ClassVar[Mapping[str, str]] = {}
    """The field's symbols for some keys, so that a user who writes one is told the key."""

    def __init_subclass__(cls) -> None:
        if cls.model is not None:
            _OF_MODEL.setdefault(cls.model, cls)

    def __init__(self, given: Mapping[str, Any]) -> None:
        vars(self).update(given)

    def __getattr__(self, key: str) -> Any:
        if key not in entries(type(self)):
            raise AttributeError(key)
        return None  # left out

    def given(self) -> dict[str, Any]:
        """Return what the file gives, by key."""
        return dict(vars(self))


_OF_MODEL: dict[type, type[TableSchema]] = {}


def table_of(part: type, **symbols: str) -> type[TableSchema]:
    """Return the table of a part of the model, the first; made where a file has it as the model."""
    if part not in _OF_MODEL:
        type(f"{part.__name__}Table", (TableSchema,), {"model": part, "symbols": symbols})
    return _OF_MODEL[part]


table_of(model.Site, d="water_depth", mu="seabed_friction", rho="water_density")
LoadTable = table_of(model.Load, H="horizontal_force", S="span", T="fairlead_tension")
table_of(model.Find, theta0="anchor_angle")
table_of(model.DesignLoad, horizontal_force="force")
table_of(model.SwarmSettings, c1="cognitive", c2="social", w="inertia")
WaveTrainTable = table_of(
    model.WaveTrain, Hs="height", H="height", Tp="period", T="period", gamma="peak_enhancement"
)
table_of(model.Motion, T="period", RAO="rao_file")
table_of(model.Body, m="mass")
table_of(model.Dynamics, step="time_step", seeds="runs")
table_of(model.SegmentCurve, a_D="log_a_D")

DRAG_AREAS = ("D", "pi D")
"""Area per length with which a coefficient of drag along the line goes."""


class SegmentTable(TableSchema):
    """A uniform stretch of the line."""

    model = model.Segment
    keys = """name length component diameter submerged_weight mass EA strain strain_tension MBL
        MBL_mean MBL_cov proof_load price wear_rate wear_zone drag_diameter drag_normal drag_axial
        drag_axial_area added_mass_normal added_mass_axial drag_method roughness keulegan_carpenter
        wake_amplification"""
    symbols: ClassVar = {
        "L": "length",
        "w": "submerged_weight",
        "m": "mass",
        "d": "diameter",
        "nominal_diameter": "diameter",
        "Cd": "drag_normal",
        "Ca": "added_mass_normal",
        "drag_tangential": "drag_axial",
        "added_mass_tangential": "added_mass_axial",
    }

    diameter: Length | None = None
    submerged_weight: Weight | None = None
    strain: Annotated[list[NotNegative], Size(2, MOST_TABLES)] | None = None
    strain_tension: Annotated[list[SomeForce], Size(2, MOST_TABLES)] | None = None
    drag_axial_area: Annotated[str, OneOf(DRAG_AREAS)] | None = None


class PointLoadTable(TableSchema):
    """A clump weight (sinker) or a buoy on the line."""

    model = model.PointLoad
    keys = """name position submerged_weight mass density volume friction drag_area
        drag_coefficient added_mass_coefficient"""
    symbols: ClassVar = {
        "s": "position",
        "W": "submerged_weight",
        "m": "mass",
        "V": "volume",
        "CdA": "drag_area",
        "Cd": "drag_coefficient",
        "Ca": "added_mass_coefficient",
    }

    submerged_weight: Force | None = None
    density: Density | None = None
    volume: Annotated[float, Measured(Dimension.VOLUME, above=0.0)] | None = None


class LineTable(TableSchema):
    """The mooring line."""

    model = model.Line
    keys = "fairlead_height anchor_height segments point_loads"

    fairlead_height: Height | None = None
    anchor_height: Height | None = None
    point_loads: Annotated[list[PointLoad], Size(0, MOST_TABLES)] | None = None


class LoadCaseTable(TableSchema):
    """A state of the sea that the line has to meet."""

    model = model.LoadCase
    keys = "name horizontal_force water_level fairlead_rise kind state condition"
    symbols: ClassVar = {"H": "horizontal_force"}


class SystemTable(TableSchema):
    """A body moored by several lines, each like [line], and what pushes it."""

    model = model.System
    keys = "anchor_radius fairlead_radius azimuths force moment yaw_free judged_line_out"

    anchor_radius: Length
    fairlead_radius: Height | None = None
    azimuths: list[Angle]
    force: Annotated[list[Force], Size(2, 2)] | None = None


class ChecksTable(TableSchema):
    """Limits a design has to keep."""

    model = model.Checks
    keys = """safety_factor safety_factor_line_out code codes proof_load_factor
        max_anchor_uplift_angle max_anchor_uplift_force min_grounded_length max_span max_offset
        min_tension allow_recalled motion_code ..."""
    symbols: ClassVar = {"SF": "safety_factor", "factor_of_safety": "safety_factor"}

    code: Code | None = None


class AnchorTable(TableSchema):
    """What holds the line at the bed."""

    model = model.Anchor
    keys = """kind submerged_weight mass density friction holding_capacity safety_factor
        safety_factor_line_out factor_source max_slide base_holding"""
    symbols: ClassVar = {"W": "submerged_weight", "m": "mass", "SF": "safety_factor"}

    density: Density | None = None


class VariantsTable(TableSchema):
    """Which of disagreeing figures to follow, by quantity of the catalogue."""

    all: Source | None = None
    mass: Source | None = None
    volume_diameter: Source | None = None
    MBL: Source | None = None
    proof_load: Source | None = None
    wet_strength_factor: Source | None = None
    EA: Source | None = None
    EA_dynamic: Source | None = None
    drag_normal: Source | None = None
    drag_axial: Source | None = None
    added_mass_normal: Source | None = None
    added_mass_axial: Source | None = None
    price: Source | None = None


class CatalogueTable(TableSchema):
    """Where components come from."""

    model = model.CatalogueChoice

    variants: VariantsTable | None = None


class SegmentChoiceTable(TableSchema):
    """What one segment of a design may be."""

    model = model.SegmentChoice
    keys = """name component components diameter diameters diameter_min diameter_max lengths
        optional"""
    choices = (LENGTHS,)

    component: Component | None = None
    diameter: Length | None = None


class GroupChoiceTable(SegmentChoiceTable):
    """What one segment of several lines between points may be."""

    model = model.GroupChoice
    keys = """name lines segment component components diameter diameters diameter_min
        diameter_max lengths"""


class ClumpWeightChoiceTable(TableSchema):
    """What one clump weight of a design may be."""

    model = model.ClumpWeightChoice
    keys = "name masses density positions joint friction optional"
    choices = (MASSES, POSITIONS)


class SinkerChoiceTable(TableSchema):
    """Sinkers at the anchor to choose from."""

    model = model.SinkerChoice
    choices = (MASSES,)


class DesignTable(TableSchema):
    """What may vary, and what it is to be best in."""

    model = model.Design
    keys = """objectives method evaluations population seed max_enumerated segments clump_weights
        sinker lines anchor_radii pretensions headings line_out loads in_motion max_run"""
    choices = (RADII, PRETENSIONS)

    clump_weights: Annotated[list[ClumpWeightChoice], Size(0, MOST_TABLES)] | None = None


class GroupDesignTable(TableSchema):
    """What of lines between points may vary, and what it is to be best in."""

    model = model.GroupDesign
    keys = "objectives method evaluations population seed max_enumerated groups"


class WavesTable(TableSchema):
    """The waves of the sea, for a line in motion."""

    model = model.WaveState
    keys = """spectrum height period peak_enhancement direction components spreading_exponent
        spreading_directions elevation_file elevation_x shortest_period stretching seed trains"""
    symbols: ClassVar = WaveTrainTable.symbols


class EndMotionTable(TableSchema):
    """How the lower end of a line moves, or fairleads of lines between points."""

    model = model.Motion
    keys = "period surge sway heave surge_phase sway_phase heave_phase file"
    symbols: ClassVar = {"T": "period"}

    file: Annotated[str, File(example='"motion.csv"')] | None = None


class FatigueSeaStateTable(TableSchema):
    """Waves that last a part of the year."""

    model = model.FatigueSeaState
    keys = "height period share time_per_year direction"
    symbols: ClassVar = WaveTrainTable.symbols

    share: Share | None = None
    time_per_year: (
        Annotated[float, Measured(Dimension.TIME, above=0.0, example='"2190 h"')] | None
    ) = None


class FatigueTable(TableSchema):
    """What the damage of a line in motion is found from."""

    model = model.Fatigue
    keys = "code design_factor curves sea_states sea_states_file"
    symbols: ClassVar = {"DFF": "design_factor"}


class CaseTable(TableSchema):
    """A whole case file."""

    model = model.Case
    keys = """title source document accept site line load load_cases system find checks service
        buoy anchor catalogue design waves current motion anchor_motion body floater dynamics
        fatigue pso"""
    elsewhere: ClassVar = {"verify": "refused.later", "environment": "refused.belongs_to_size"}
    symbols: ClassVar = {"catalog": "catalogue"}

    site: Site | None = None
    load: Load | None = None
    anchor_motion: EndMotionTable | None = None
    pso: SwarmSettings | None = None


class NetworkSegmentTable(TableSchema):
    """A uniform stretch of a line between points."""

    model = model.Segment
    keys = """name length component diameter submerged_weight mass EA MBL MBL_mean MBL_cov
        proof_load wear_rate drag_diameter drag_normal drag_axial added_mass_normal
        added_mass_axial"""
    symbols: ClassVar = {
        "L": "length",
        "w": "submerged_weight",
        "d": "diameter",
        "nominal_diameter": "diameter",
    }

    diameter: Length | None = None
    submerged_weight: Weight | None = None


class NetworkLoadTable(TableSchema):
    """A clump weight or a buoy on a line between points."""

    model = model.PointLoad
    keys = """name position submerged_weight mass drag_area drag_coefficient
        added_mass_coefficient"""


class LineBetweenTable(TableSchema):
    """A line from one point to another."""

    model = LineBetween
    keys = "name start end segments point_loads"

    segments: list[NetworkSegmentTable]
    point_loads: list[NetworkLoadTable] | None = None


class NetworkTable(TableSchema):
    """A whole file of points, lines between them and bodies."""

    model = Network
    keys = """title source document accept site points lines bodies waves current motion dynamics
        checks service anchor catalogue fatigue design"""

    motion: EndMotionTable | None = None


@dataclass(frozen=True)
class Entry:
    """What a key of a table holds: a single value, or a table; or an array of either.

    The kind is that of each value of an array.
    """

    kind: Kind | None
    table: type[TableSchema] | None
    array: bool
    required: bool
    size: Size


_KNOWN: dict[type[TableSchema], Mapping[str, Entry]] = {}


def entries(table: type[TableSchema]) -> Mapping[str, Entry]:
    """List the keys of a table, in order, with what each holds."""
    if table not in _KNOWN:
        _KNOWN[table] = MappingProxyType(dict(_entries(table)))
    return _KNOWN[table]


def _entries(table: type[TableSchema]) -> Iterator[tuple[str, Entry]]:
    own = annotated(table)
    of_model = dict(annotated(table.model)) if table.model else {}
    if "accept" not in table.keys:
        of_model.pop("accept", None)  # it stands at the top of a file
    of_part = fields(table.model) if table.model else ()
    needed = {part.name for part in of_part if part.default is part.default_factory is MISSING}
    several = {values.many: values for values in table.choices}
    named = table.keys.split() or [*of_model, *own]
    if named[-1] == "...":
        named[-1:] = [name for name in of_model if name not in named and name not in several]
    for key in named:
        kind, array, size, classes = own[key] if key in own else of_model[key]
        if key in several:
            ways = several[key]
            for way in (ways.one, ways.many, *ways.range):
                yield way, Entry(kind, None, way == key, False, Size(1, MOST_LISTED))
            continue
        parts = (part for part in classes if issubclass(part, TableSchema) or is_dataclass(part))
        inner = next((p if issubclass(p, TableSchema) else table_of(p) for p in parts), None)
        required = not hasattr(table, key) if key in own else key in needed
        most = MOST_LISTED if inner is None else MOST_TABLES
        yield key, Entry(kind, inner, array, required, size or Size(1, most))
