"""A sizing in one call: what is known as keywords, or as a request that is made already."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypedDict, Unpack

from catopt.casefile.reading import Moored
from catopt.errors import refused
from catopt.sizing.buoy import sized_buoy
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.known import known
from catopt.sizing.requests import size
from catopt.sizing.result import Sizing
from catopt.sizing.tanker import sized_tanker
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import Message


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
    base_area: float | str
    embedment: float | str
    code: str
    recalled: bool
    life: float | str
    wear: float | str
    dynamic_factor: float | str
    in_motion: bool
    at_rest: bool
    seeds: int
    run_time: float | str
    peak_period: float | str | Sequence[float | str]
    sea_height: float | str | Sequence[float | str]
    period_range: bool


class BuoyInputs(_Inputs, total=False):
    """What the sizing of a buoy may be told."""

    force: float | str
    reserve_buoyancy: float | str
    keel_depth: float | str
    wave_height: str
    chain_waves: bool
    load_method: str
    other_lengths: int
    max_slide: float | str
    centre_of_gravity: float | str
    max_heel: float | str
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


def size_buoy(request: BuoyRequest | str | None = None, /, **inputs: Unpack[BuoyInputs]) -> Sizing:
    """Size the chain and the sinker of a buoy.

    Parameters
    ----------
    request : str or BuoyRequest, optional
        Name of a buoy; or buoy, place, weather and line as objects, or what `catopt.read_sizing`
        made of a file.
    **inputs
        Beside a name or nothing, what is known, by the names in docs/sizing.md: numbers in SI, or
        texts with units. What is left out is taken, and said in ``defaults``.

    Returns
    -------
    Sizing
        With the case that `catopt.design_case` and `catopt.check_case` take.

    Raises
    ------
    InputError
        With every mistake, each by its keyword.
    NoFeasibleDesignError
        Nothing that is sold passes every check.

    Examples
    --------
    >>> import catopt
    >>> sizing = catopt.size_buoy("pillar 1.8 m", depth="12 m")
    >>> [segment.name for segment in sizing.point.line.segments]
    ['chain open-link 4D Q2 30 mm']
    """
    if isinstance(request, str) and "buoy" not in inputs:
        return _sized("buoy", None, {"buoy": request, **inputs})
    return _sized("buoy", request, inputs)


def size_tanker(request: TankerRequest | None = None, /, **inputs: Unpack[TankerInputs]) -> Sizing:
    """Size the chain and the anchor of a tanker's mooring.

    Parameters
    ----------
    request : TankerRequest, optional
        Ship, place, weather and mooring as objects, or what `catopt.read_sizing` made of a file.
    **inputs
        In place of it, what is known, by the names in docs/sizing.md: numbers in SI, or texts with
        units. What is left out is taken or estimated, and said in ``defaults``.

    Returns
    -------
    Sizing
        With the case of one line that `catopt.design_case` and `catopt.check_case` take.

    Raises
    ------
    InputError
        With every mistake, each by its keyword.
    NoAnswerError
        Nothing that is sold passes every check; the buoy does not carry all lines.
    """
    return _sized("tanker", request, inputs)


def _sized(moored: Moored, request: object, inputs: Mapping[str, object]) -> Sizing:
    if isinstance(request, BuoyRequest) and moored == "buoy" and not inputs:
        return sized_buoy(request)
    if isinstance(request, TankerRequest) and moored == "tanker" and not inputs:
        return sized_tanker(request)
    source = f"size_{moored}"
    if request is None:
        return size(known(moored, inputs, source=source))
    allowed = Message("refused_sizing.request_wanted_or_keywords_not", moored=moored)
    raise refused("request", f"a {type(request).__name__}", allowed, source)
