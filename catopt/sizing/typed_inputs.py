"""The keywords of `catopt.size_buoy` and `catopt.size_tanker`, for type checkers and completion.

They are those of `catopt.sizing.inputs`, which a test compares them with.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypedDict


class _Inputs(TypedDict, total=False):
    """What any sizing may be told: numbers in SI, or texts with units."""

    title: str
    source: str
    max_swing: float | str
    buoy: str
    buoys: str
    depth: float | str
    low_water: float | str
    water_density: float | str
    wind: float | str
    return_period: float | str
    current: float | str
    hs: float | str
    hmax: float | str
    period: float | str
    chain: str | Sequence[str]
    diameter_min: float | str
    diameter_max: float | str
    length_step: float | str
    prefer: str
    swing_price: float | str
    sinker: str
    sinker_density: float | str
    soil: str
    friction: float | str
    code: str
    recalled: bool
    life: float | str
    wear: float | str
    dynamic_factor: float | str
    in_motion: bool


class BuoyInputs(_Inputs, total=False):
    """What the sizing of a buoy may be told."""

    force: float | str
    reserve_buoyancy: float | str
    keel_depth: float | str
    wave_height: str
    chain_waves: bool
    seeds: int
    run_time: float | str
    other_lengths: int
    max_slide: float | str
    growth: float | str
    scope_min: float | str
    scope: float | str
    scope_max: float | str


class TankerInputs(_Inputs, total=False):
    """What the sizing of a tanker may be told."""

    ship: str
    dwt: float | str
    length: float | str
    breadth: float | str
    draught: float | str
    ballast_draught: float | str
    condition: str | Sequence[str]
    moulded_depth: float | str
    frontal_area: float | str
    lateral_area: float | str
    fairlead: float | str
    coefficients: str
    hawser: float | str
    wind_mean: float | str
    load_method: str | Sequence[str]
    wave_coefficient: float | str
    wind_angle: float | str
    current_angle: float | str
    wave_angle: float | str
    current_yaw: str
    scan: float | str
    clump_weight: float | str | Sequence[float | str]
    lines: int
    pretension: float | str
    anchor: str
    service_type: str
