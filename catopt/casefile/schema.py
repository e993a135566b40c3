"""Every section and key of a case file.

The keys of a table carry the names of the model's attributes, and their defaults are the model's:
a key that may be left out is None here, and the model is then built without it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, get_args

from pydantic import BaseModel, ConfigDict, Field

from catopt.casefile.fields import Flag, Kind, Measured, OneOf, Text, Whole
from catopt.model.anchor import ANCHOR_KINDS
from catopt.model.case import BOUNDARY_HANDLINGS
from catopt.model.current_profile import CURRENT_PROFILES
from catopt.model.design import OBJECTIVES, SEARCH_METHODS
from catopt.model.drag_method import DRAG_METHODS
from catopt.model.dynamics import BROKEN_ENDS, INITIAL_FRICTION, TIME_SCHEMES
from catopt.model.fatigue import CURVE_NAMES, FATIGUE_CODES
from catopt.model.find import FIND_QUANTITIES
from catopt.model.line import HIGHEST_COV
from catopt.model.load_case import LOAD_CASE_KINDS, LOAD_CASE_STATES
from catopt.model.motion import RAO_PER, RAO_PHASES, RAO_ROTATIONS
from catopt.model.network import POINT_KINDS
from catopt.model.site import HIGHEST, STEEPEST
from catopt.model.wave_state import STRETCHINGS, WAVE_SPECTRA
from catopt.model.wear import WEAR_TABLES, WEAR_ZONES
from catopt.units import Dimension

MOST_LISTED, MOST_TABLES = 1_000, 200
"""Values that an array may have, and tables that an array of tables may."""

SOME = Field(min_length=1, max_length=MOST_LISTED)
SOME_TABLES = Field(min_length=1, max_length=MOST_TABLES)

Component = Annotated[str, Text(filled=True, example='"chain studless R3"')]
Length = Annotated[float, Measured(Dimension.LENGTH, above=0.0)]
Mass = Annotated[float, Measured(Dimension.MASS, above=0.0)]
Density = Annotated[float, Measured(Dimension.DENSITY, above=0.0)]
Friction = Annotated[float, Measured(Dimension.NUMBER, above=0.0)]
Factor = Annotated[float, Measured(Dimension.NUMBER, at_least=1.0)]
WearRate = Annotated[float, Measured(Dimension.SPEED, at_least=0.0, example='"0.4 mm/year"')]
Code = Annotated[str, Text(filled=True, example='"break/5"')]
Name = Annotated[str, Text()]
Angle = Annotated[float, Measured(Dimension.ANGLE)]
Place = Annotated[float, Measured(Dimension.LENGTH)]
Force = Annotated[float, Measured(Dimension.FORCE)]
Variant = Annotated[str, Text(filled=True)]
Lengths = Annotated[list[Length], SOME]
Masses = Annotated[list[Mass], SOME]
Time = Annotated[float, Measured(Dimension.TIME, above=0.0)]
Height = Annotated[float, Measured(Dimension.LENGTH, at_least=0.0)]
Weight = Annotated[float, Measured(Dimension.FORCE_PER_LENGTH)]
Area = Annotated[float, Measured(Dimension.AREA, at_least=0.0, example='"1.5 m^2"')]
Strength = Annotated[float, Measured(Dimension.FORCE, above=0.0)]
Share = Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=1.0)]
Uplift = Annotated[float, Measured(Dimension.ANGLE, at_least=0.0, at_most=math.pi / 2.0)]
Duration = Annotated[float, Measured(Dimension.TIME, at_least=0.0)]
Seed = Annotated[int, Whole("seed", example=1)]
Yes = Annotated[bool, Flag()]
Exponent = Annotated[float, Measured(Dimension.NUMBER, above=0.0)]
Coefficient = Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, example="1.2")]


class Table(BaseModel):
    """A table of a case file: no other keys than its own.

    Every value is checked by its `Kind`, which converts nothing but units.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)

    later: ClassVar[Mapping[str, str]] = {}
    """Keys that belong to a later version, each with the required key it would stand for."""

    elsewhere: ClassVar[Mapping[str, str]] = {}
    """Keys that belong to another kind of file, each with what that is for."""

    symbols: ClassVar[Mapping[str, str]] = {}
    """The field's symbols for some keys, so that a user who writes one is told the key."""

    def given(self) -> dict[str, Any]:
        """Return what the file gives, by key."""
        return {key: getattr(self, key) for key in self.model_fields_set}


OFFSET = Measured(Dimension.LENGTH, at_least=0.0, at_most=HIGHEST, example='"0.164 m"')
SLOPE = Measured(Dimension.ANGLE, at_least=-STEEPEST, at_most=STEEPEST, example='"3 deg"')


class SiteTable(Table):
    """Water and seabed."""

    symbols: ClassVar[Mapping[str, str]] = {
        "d": "water_depth",
        "mu": "seabed_friction",
        "rho": "water_density",
    }

    water_depth: Length
    seabed_friction: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0)] | None = None
    water_density: Density | None = None
    seabed_slope: Annotated[float, SLOPE] | None = None
    contact_offset: Annotated[float, OFFSET] | None = None


DRAG_AREAS = ("D", "pi D")
"""Area per length with which a coefficient of drag along the line goes."""


class SegmentTable(Table):
    """A uniform stretch of the line."""

    symbols: ClassVar[Mapping[str, str]] = {
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

    name: Name | None = None
    length: Length
    component: Component | None = None
    diameter: Length | None = None
    submerged_weight: Weight | None = None
    mass: Annotated[float, Measured(Dimension.MASS_PER_LENGTH, at_least=0.0)] | None = None
    EA: Strength | None = None
    MBL: Strength | None = None
    MBL_mean: Strength | None = None
    MBL_cov: (
        Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=HIGHEST_COV)] | None
    ) = None
    proof_load: Strength | None = None
    price: Annotated[float, Measured(Dimension.PRICE_PER_LENGTH, at_least=0.0)] | None = None
    wear_rate: WearRate | None = None
    wear_zone: Annotated[str, OneOf(WEAR_ZONES)] | None = None
    drag_diameter: Length | None = None
    drag_normal: Coefficient | None = None
    drag_axial: Coefficient | None = None
    drag_axial_area: Annotated[str, OneOf(DRAG_AREAS)] | None = None
    added_mass_normal: Coefficient | None = None
    added_mass_axial: Coefficient | None = None
    drag_method: Annotated[str, OneOf(DRAG_METHODS)] | None = None
    roughness: Height | None = None
    keulegan_carpenter: Coefficient | None = None
    wake_amplification: Exponent | None = None


class PointLoadTable(Table):
    """A clump weight (sinker) or a buoy on the line."""

    symbols: ClassVar[Mapping[str, str]] = {
        "s": "position",
        "W": "submerged_weight",
        "m": "mass",
        "V": "volume",
        "CdA": "drag_area",
        "Cd": "drag_coefficient",
        "Ca": "added_mass_coefficient",
    }

    name: Name | None = None
    position: Length
    submerged_weight: Force | None = None
    mass: Annotated[float, Measured(Dimension.MASS, at_least=0.0)] | None = None
    density: Density | None = None
    volume: Annotated[float, Measured(Dimension.VOLUME, above=0.0)] | None = None
    friction: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0)] | None = None
    drag_area: Area | None = None
    drag_coefficient: Coefficient | None = None
    added_mass_coefficient: Coefficient | None = None


class LineTable(Table):
    """The mooring line."""

    fairlead_height: Height | None = None
    anchor_height: Height | None = None
    segments: Annotated[list[SegmentTable], SOME_TABLES]
    point_loads: Annotated[list[PointLoadTable], Field(max_length=MOST_TABLES)] = []


class LoadTable(Table):
    """The one known quantity at the fairlead."""

    symbols: ClassVar[Mapping[str, str]] = {
        "H": "horizontal_force",
        "S": "span",
        "T": "fairlead_tension",
    }

    horizontal_force: Strength | None = None
    span: Length | None = None
    fairlead_tension: Strength | None = None


class LoadCaseTable(Table):
    """A state of the sea that the line has to meet."""

    symbols: ClassVar[Mapping[str, str]] = {"H": "horizontal_force"}

    name: Annotated[str, Text(filled=True, example='"storm"')]
    horizontal_force: Strength
    water_level: Place | None = None
    fairlead_rise: Place | None = None
    kind: Annotated[str, OneOf(LOAD_CASE_KINDS)] | None = None
    state: Annotated[str, OneOf(LOAD_CASE_STATES)] | None = None


class SystemTable(Table):
    """A body moored by several lines, each like [line], and what pushes it."""

    anchor_radius: Length
    fairlead_radius: Height | None = None
    azimuths: Annotated[list[Angle], SOME]
    force: Annotated[list[Force], Field(min_length=2, max_length=2)] | None = None
    moment: Annotated[float, Measured(Dimension.MOMENT)] | None = None
    yaw_free: Yes | None = None


class FindTable(Table):
    """What is sought, in place of how the line hangs."""

    symbols: ClassVar[Mapping[str, str]] = {"theta0": "anchor_angle"}

    quantity: Annotated[str, OneOf(FIND_QUANTITIES)]
    segment: Annotated[int, Whole("segment", example=1)] | None = None
    point_load: Annotated[int, Whole("point_load", example=1)] | None = None
    anchor_angle: Uplift | None = None
    grounded_length: Length | None = None


class ChecksTable(Table):
    """Limits a design has to keep."""

    symbols: ClassVar[Mapping[str, str]] = {
        "SF": "safety_factor",
        "factor_of_safety": "safety_factor",
    }

    safety_factor: Factor | None = None
    safety_factor_line_out: Factor | None = None
    code: Code | None = None
    codes: Annotated[list[Code], SOME] | None = None
    proof_load_factor: Factor | None = None
    max_anchor_uplift_angle: Uplift | None = None
    max_anchor_uplift_force: Annotated[float, Measured(Dimension.FORCE, at_least=0.0)] | None = None
    min_grounded_length: Height | None = None
    max_span: Length | None = None
    max_offset: Length | None = None
    allow_recalled: Yes | None = None


class ServiceTable(Table):
    """How long the line is to last, and how fast it wears."""

    life: Annotated[float, Measured(Dimension.TIME, at_least=0.0, example='"10 years"')]
    wear_rate: WearRate | None = None
    wear_table: Annotated[str, OneOf(tuple(WEAR_TABLES))] | None = None


class BuoyTable(Table):
    """The floating body that the line pulls down on."""

    reserve_buoyancy: Strength


class AnchorTable(Table):
    """What holds the line at the bed."""

    symbols: ClassVar[Mapping[str, str]] = {
        "W": "submerged_weight",
        "m": "mass",
        "SF": "safety_factor",
    }

    kind: Annotated[str, OneOf(ANCHOR_KINDS)]
    submerged_weight: Strength | None = None
    mass: Mass | None = None
    density: Density | None = None
    friction: Friction | None = None
    holding_capacity: Strength | None = None
    safety_factor: Factor | None = None
    safety_factor_line_out: Factor | None = None
    factor_source: Annotated[str, Text(filled=True)] | None = None


class VariantsTable(Table):
    """Which of disagreeing figures to follow, by quantity of the catalogue."""

    all: Variant | None = None
    mass: Variant | None = None
    volume_diameter: Variant | None = None
    MBL: Variant | None = None
    proof_load: Variant | None = None
    wet_strength_factor: Variant | None = None
    EA: Variant | None = None
    EA_dynamic: Variant | None = None
    drag_normal: Variant | None = None
    drag_axial: Variant | None = None
    added_mass_normal: Variant | None = None
    added_mass_axial: Variant | None = None
    price: Variant | None = None


class CatalogueTable(Table):
    """Where components come from."""

    file: Annotated[str, Text(filled=True)] | None = None
    allow_recalled: Yes | None = None
    variants: VariantsTable | None = None


class SegmentChoiceTable(Table):
    """What one segment of a design may be."""

    name: Name | None = None
    component: Component | None = None
    components: Annotated[list[Component], SOME] | None = None
    diameter: Length | None = None
    diameters: Lengths | None = None
    diameter_min: Length | None = None
    diameter_max: Length | None = None
    length: Length | None = None
    lengths: Lengths | None = None
    length_min: Length | None = None
    length_max: Length | None = None
    length_step: Length | None = None
    optional: Yes | None = None


class ClumpWeightChoiceTable(Table):
    """What one clump weight of a design may be."""

    name: Name | None = None
    mass: Mass | None = None
    masses: Masses | None = None
    mass_min: Mass | None = None
    mass_max: Mass | None = None
    mass_step: Mass | None = None
    density: Density
    position: Length | None = None
    positions: Lengths | None = None
    position_min: Length | None = None
    position_max: Length | None = None
    position_step: Length | None = None
    joint: Annotated[int, Whole("joint", example=1)] | None = None
    friction: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0)] | None = None
    optional: Yes | None = None


class SinkerChoiceTable(Table):
    """Sinkers at the anchor to choose from."""

    mass: Mass | None = None
    masses: Masses | None = None
    mass_min: Mass | None = None
    mass_max: Mass | None = None
    mass_step: Mass | None = None
    density: Density
    friction: Friction
    safety_factor: Factor | None = None
    factor_source: Annotated[str, Text(filled=True)] | None = None


class DesignLoadTable(Table):
    """A force on a moored body that every design has to meet."""

    symbols: ClassVar[Mapping[str, str]] = {"horizontal_force": "force"}

    name: Annotated[str, Text(filled=True, example='"storm"')]
    force: Strength
    direction: Angle | None = None
    headings: Annotated[int, Whole("headings", example=12)] | None = None
    water_level: Place | None = None
    fairlead_rise: Place | None = None
    line_out: Yes | None = None


class DesignTable(Table):
    """What may vary, and what it is to be best in."""

    objectives: Annotated[list[Annotated[str, OneOf(OBJECTIVES)]], SOME] | None = None
    method: Annotated[str, OneOf(SEARCH_METHODS)] | None = None
    evaluations: Annotated[int, Whole("evaluations", example=10_000)] | None = None
    population: Annotated[int, Whole("population", example=100)] | None = None
    seed: Seed | None = None
    max_enumerated: Annotated[int, Whole("max_enumerated", example=5_000_000)] | None = None
    segments: Annotated[list[SegmentChoiceTable], SOME_TABLES]
    clump_weights: Annotated[list[ClumpWeightChoiceTable], Field(max_length=MOST_TABLES)] = []
    sinker: SinkerChoiceTable | None = None
    lines: Annotated[list[Annotated[int, Whole("lines", example=6)]], SOME] | None = None
    anchor_radius: Length | None = None
    anchor_radii: Lengths | None = None
    anchor_radius_min: Length | None = None
    anchor_radius_max: Length | None = None
    anchor_radius_step: Length | None = None
    pretension: Strength | None = None
    pretensions: Annotated[list[Strength], SOME] | None = None
    pretension_min: Strength | None = None
    pretension_max: Strength | None = None
    pretension_step: Strength | None = None
    headings: Annotated[int, Whole("headings", example=12)] | None = None
    line_out: Yes | None = None
    loads: Annotated[list[DesignLoadTable], SOME_TABLES] | None = None


class PsoTable(Table):
    """Settings of the particle swarm."""

    symbols: ClassVar[Mapping[str, str]] = {"c1": "cognitive", "c2": "social", "w": "inertia"}

    particles: Annotated[int, Whole("particles", example=200)] | None = None
    iterations: Annotated[int, Whole("iterations", example=200)] | None = None
    runs: Annotated[int, Whole("runs", example=200)] | None = None
    seed: Seed | None = None
    cognitive: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=4.0)] | None = None
    social: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=4.0)] | None = None
    inertia: Share | None = None
    boundary: Annotated[str, OneOf(BOUNDARY_HANDLINGS)] | None = None


Gamma = Annotated[float, Measured(Dimension.NUMBER, at_least=1.0, at_most=20.0, example="3.3")]


class _OneTrainTable(Table):
    symbols: ClassVar[Mapping[str, str]] = {
        "Hs": "height",
        "H": "height",
        "Tp": "period",
        "T": "period",
        "gamma": "peak_enhancement",
    }

    spectrum: Annotated[str, OneOf(WAVE_SPECTRA)] | None = None
    height: Length | None = None
    period: Time | None = None
    peak_enhancement: Gamma | None = None
    direction: Angle | None = None
    components: Annotated[int, Whole("components", example=200)] | None = None
    spreading_exponent: Exponent | None = None
    spreading_directions: Annotated[int, Whole("spreading_directions", example=20)] | None = None


class WaveTrainTable(_OneTrainTable):
    """Waves of one spectrum among several."""

    spectrum: Annotated[str, OneOf(WAVE_SPECTRA)]
    height: Length
    period: Time


class WavesTable(_OneTrainTable):
    """The waves of the sea, for a line in motion."""

    elevation_file: Annotated[str, Text(filled=True, example='"elevation.csv"')] | None = None
    elevation_x: Place | None = None
    shortest_period: Time | None = None
    stretching: Annotated[str, OneOf(STRETCHINGS)] | None = None
    seed: Seed | None = None
    trains: Annotated[list[WaveTrainTable], SOME_TABLES] | None = None


class CurrentTable(Table):
    """A current over the depth, for a line in motion."""

    profile: Annotated[str, OneOf(CURRENT_PROFILES)]
    speed: Annotated[float, Measured(Dimension.SPEED, at_least=0.0)] | None = None
    exponent: Exponent | None = None
    depth: Length | None = None
    depths: Annotated[list[Height], SOME] | None = None
    speeds: Annotated[list[Annotated[float, Measured(Dimension.SPEED)]], SOME] | None = None
    direction: Angle | None = None
    directions: Annotated[list[Angle], SOME] | None = None
    series_file: Annotated[str, Text(filled=True, example='"current.csv"')] | None = None


class AnchorMotionTable(Table):
    """How the lower end of a line moves."""

    symbols: ClassVar[Mapping[str, str]] = {"T": "period"}

    period: Time | None = None
    surge: Height | None = None
    sway: Height | None = None
    heave: Height | None = None
    surge_phase: Angle | None = None
    sway_phase: Angle | None = None
    heave_phase: Angle | None = None
    file: Annotated[str, Text(filled=True, example='"lower-end.csv"')] | None = None


class MotionTable(AnchorMotionTable):
    """How the fairlead moves."""

    symbols: ClassVar[Mapping[str, str]] = {"T": "period", "RAO": "rao_file"}

    file: Annotated[str, Text(filled=True, example='"motion.csv"')] | None = None
    rao_file: Annotated[str, Text(filled=True, example='"rao.csv"')] | None = None
    rao_phase: Annotated[str, OneOf(RAO_PHASES)] | None = None
    rao_reference: Annotated[list[Place], Field(min_length=3, max_length=3)] | None = None
    rao_rotation: Annotated[str, OneOf(RAO_ROTATIONS)] | None = None
    rao_per: Annotated[str, OneOf(RAO_PER)] | None = None
    rao_crest: Annotated[list[Place], Field(min_length=2, max_length=2)] | None = None
    drift: Annotated[list[Place], Field(min_length=2, max_length=2)] | None = None
    drift_file: Annotated[str, Text(filled=True, example='"drift.csv"')] | None = None


class BodyTable(Table):
    """The body that several lines moor, where it moves under forces."""

    symbols: ClassVar[Mapping[str, str]] = {"m": "mass"}

    mass: Mass
    added_mass: Annotated[float, Measured(Dimension.MASS, at_least=0.0)] | None = None
    damping: Annotated[float, Measured(Dimension.DAMPING, at_least=0.0)] | None = None
    force_file: Annotated[str, Text(filled=True, example='"force.csv"')] | None = None
    wave_force: Annotated[list[Weight], Field(min_length=2, max_length=2)] | None = None


Storm = Annotated[float, Measured(Dimension.TIME, above=0.0, example='"3 h"')]
BedStiffness = Annotated[float, Measured(Dimension.PRESSURE, above=0.0, example='"30 kN/m^2"')]
BedDamping = Annotated[float, Measured(Dimension.DAMPING_PER_LENGTH, at_least=0.0)]


class DynamicsTable(Table):
    """How the line is run in time."""

    symbols: ClassVar[Mapping[str, str]] = {"step": "time_step", "seeds": "runs"}

    duration: Annotated[float, Measured(Dimension.TIME, above=0.0, example='"20 min"')]
    ramp: Duration | None = None
    time_step: Time | None = None
    output_interval: Time | None = None
    elements: Annotated[int, Whole("elements", example=100)] | None = None
    scheme: Annotated[str, OneOf(TIME_SCHEMES)] | None = None
    spectral_radius: Share | None = None
    runs: Annotated[int, Whole("runs", example=5)] | None = None
    seabed_stiffness: BedStiffness | None = None
    seabed_damping: BedDamping | None = None
    line_damping: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0)] | None = None
    damping_time: Duration | None = None
    broken_line: Annotated[int, Whole("broken_line", example=2)] | None = None
    broken_at: Time | None = None
    broken_end: Annotated[str, OneOf(BROKEN_ENDS)] | None = None
    initial_friction: Annotated[str, OneOf(INITIAL_FRICTION)] | None = None
    duration_of_interest: Storm | None = None


class FatigueSeaStateTable(Table):
    """Waves that last a part of the year."""

    symbols = _OneTrainTable.symbols

    height: Length
    period: Time
    share: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=1.0)] | None = None
    time_per_year: (
        Annotated[float, Measured(Dimension.TIME, above=0.0, example='"2190 h"')] | None
    ) = None
    direction: Angle | None = None


class FatigueCurveTable(Table):
    """Curve of a segment, in place of the code's."""

    symbols: ClassVar[Mapping[str, str]] = {"a_D": "log_a_D"}

    segment: Annotated[int, Whole("segment", example=1)] | None = None
    name: Annotated[str, OneOf(CURVE_NAMES)] | None = None
    log_a_D: Annotated[float, Measured(Dimension.NUMBER, above=0.0, example="10.78")] | None = None
    m: Exponent | None = None
    K: Annotated[float, Measured(Dimension.NUMBER, above=0.0, example="316")] | None = None
    M: Exponent | None = None


class FatigueTable(Table):
    """What the damage of a line in motion is found from."""

    symbols: ClassVar[Mapping[str, str]] = {"DFF": "design_factor"}

    code: Annotated[str, OneOf(FATIGUE_CODES)] | None = None
    design_factor: Factor | None = None
    curves: Annotated[list[FatigueCurveTable], SOME_TABLES] | None = None
    sea_states: Annotated[list[FatigueSeaStateTable], SOME_TABLES] | None = None
    sea_states_file: Annotated[str, Text(filled=True, example='"sea-states.csv"')] | None = None


class CaseTable(Table):
    """A whole case file."""

    later: ClassVar[Mapping[str, str]] = {
        "verify": "",
    }
    elsewhere: ClassVar[Mapping[str, str]] = {
        "environment": "belongs to a file for catopt size and catopt loads (docs/sizing.md), "
        "which finds the force; a case file gives it",
    }
    symbols: ClassVar[Mapping[str, str]] = {"catalog": "catalogue"}

    title: Name | None = None
    source: Name | None = None
    site: SiteTable
    line: LineTable
    load: LoadTable | None = None
    load_cases: Annotated[list[LoadCaseTable], SOME_TABLES] | None = None
    system: SystemTable | None = None
    find: FindTable | None = None
    checks: ChecksTable | None = None
    service: ServiceTable | None = None
    buoy: BuoyTable | None = None
    anchor: AnchorTable | None = None
    catalogue: CatalogueTable | None = None
    design: DesignTable | None = None
    waves: WavesTable | None = None
    current: CurrentTable | None = None
    motion: MotionTable | None = None
    anchor_motion: AnchorMotionTable | None = None
    body: BodyTable | None = None
    dynamics: DynamicsTable | None = None
    fatigue: FatigueTable | None = None
    pso: PsoTable | None = None


_PointName = Annotated[str, Text(filled=True, example='"joint 1"')]


class PointTable(Table):
    """An anchor, a fairlead or a free joint."""

    name: _PointName
    kind: Annotated[str, OneOf(POINT_KINDS)]
    x: Place | None = None
    y: Place | None = None
    height: Height | None = None
    submerged_weight: Force | None = None


class NetworkSegmentTable(Table):
    """A uniform stretch of a line between points."""

    name: Name | None = None
    length: Length
    submerged_weight: Weight
    EA: Strength | None = None
    MBL: Strength | None = None


class NetworkLoadTable(Table):
    """A clump weight or a buoy on a line between points."""

    name: Name | None = None
    position: Length
    submerged_weight: Force


class LineBetweenTable(Table):
    """A line from one point to another."""

    name: Name | None = None
    start: _PointName
    end: _PointName
    segments: Annotated[list[NetworkSegmentTable], SOME_TABLES]
    point_loads: Annotated[list[NetworkLoadTable], SOME_TABLES] | None = None


class NetworkTable(Table):
    """A whole file of lines that meet in joints."""

    title: Name | None = None
    source: Name | None = None
    site: SiteTable
    points: Annotated[list[PointTable], SOME_TABLES]
    lines: Annotated[list[LineBetweenTable], SOME_TABLES]


@dataclass(frozen=True)
class Entry:
    """What a key of a table holds.

    Attributes
    ----------
    kind : Kind or None
        For a single value, and for each of an array of values.
    table : type of Table or None
        For a table or an array of tables.
    array : bool
        Whether it is an array, of values or of tables.
    required : bool
        Whether it has to be there.
    """

    kind: Kind | None
    table: type[Table] | None
    array: bool
    required: bool


@cache
def entries(table: type[Table]) -> Mapping[str, Entry]:
    """List the keys of a table, in order, with what each holds."""
    listed = {}
    for key, field in table.model_fields.items():
        parts = [*field.metadata, *_parts(field.annotation)]
        kind = next((part for part in parts if isinstance(part, Kind)), None)
        inner = next((p for p in parts if isinstance(p, type) and issubclass(p, Table)), None)
        listed[key] = Entry(kind, inner, list in parts, field.is_required())
    return MappingProxyType(listed)


def _parts(annotation: Any) -> list[Any]:
    """Take an annotation apart: ``Annotated[float, k] | None`` gives ``float``, ``k`` and None."""
    origin = getattr(annotation, "__origin__", None)
    parts = [annotation] if origin is None else [origin]
    for inner in (*get_args(annotation), *getattr(annotation, "__metadata__", ())):
        parts += _parts(inner)
    return parts
