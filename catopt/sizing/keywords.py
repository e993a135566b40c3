"""A sizing in one call: what is known as keywords, or as a request that is made already."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from inspect import getdoc
from typing import Final, Never

from catopt.casefile.reading import Moored
from catopt.errors import refused
from catopt.sizing.buoy import sized_buoy
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.input_values import input_values
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.requests import size
from catopt.sizing.result import Sizing
from catopt.sizing.tanker import sized_tanker
from catopt.sizing.tanker_request import TankerRequest
from catopt.units import Dimension
from catopt.words import Message


def size_buoy(
    request: BuoyRequest | str | None = None,
    /,
    *,
    title: str | None = None,
    source: str | None = None,
    max_swing: float | str | None = None,
    buoy: str | None = None,
    buoys: str | None = None,
    force: float | str | None = None,
    reserve_buoyancy: float | str | None = None,
    keel_depth: float | str | None = None,
    depth: float | str | None = None,
    low_water: float | str | None = None,
    water_density: float | str | None = None,
    place: str | None = None,
    wind: float | str | None = None,
    return_period: float | str | None = None,
    current: float | str | None = None,
    hs: float | str | None = None,
    hmax: float | str | None = None,
    period: float | str | None = None,
    fetch: float | str | None = None,
    fetch_depth: float | str | None = None,
    load_method: str | None = None,
    wave_height: str | None = None,
    chain_waves: bool | None = None,
    growth: float | str | None = None,
    chain: str | Sequence[str] | None = None,
    diameter_min: float | str | None = None,
    diameter_max: float | str | None = None,
    length_step: float | str | None = None,
    prefer: str | None = None,
    scope_min: float | str | None = None,
    scope: float | str | None = None,
    scope_max: float | str | None = None,
    swing_price: float | str | None = None,
    sinker: str | None = None,
    sinker_density: float | str | None = None,
    soil: str | None = None,
    friction: float | str | None = None,
    base_area: float | str | None = None,
    embedment: float | str | None = None,
    scour: float | str | None = None,
    crane: float | str | None = None,
    code: str | None = None,
    recalled: bool | None = None,
    life: float | str | None = None,
    wear: float | str | None = None,
    thrash_wear: float | str | None = None,
    chain_price: float | str | None = None,
    sinker_price: float | str | None = None,
    fittings_price: float | str | None = None,
    visit_price: float | str | None = None,
    in_motion: bool | None = None,
    at_rest: bool | None = None,
    seeds: int | None = None,
    run_time: float | str | None = None,
    peak_period: float | str | Sequence[float | str] | None = None,
    sea_height: float | str | Sequence[float | str] | None = None,
    period_range: bool | None = None,
    other_lengths: int | None = None,
    max_slide: float | str | None = None,
    max_heel: float | str | None = None,
    light_divergence: float | str | None = None,
    pitch_damping: float | str | None = None,
    centre_of_gravity: float | str | None = None,
    dynamic_factor: float | str | None = None,
    **misspelt: Never,
) -> Sizing:
    """Size the chain and the sinker of a buoy.

    Parameters
    ----------
    request : str or BuoyRequest, optional
        Name of a buoy; or buoy, place, weather and line as objects, or what `catopt.read_sizing`
        made of a file.
    **misspelt
        Refused, with the nearest keyword. The others, beside a name or nothing, are numbers in the
        unit named or texts with units; what is None is left out, and said in ``defaults``:

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
    >>> sizing = catopt.size_buoy("pillar 1.8 m", depth="12 m", at_rest=True)
    >>> sizing.passes, sizing.chain.segment.name, f"{sizing.own_sinker.mass / 1e3:g} t"
    (True, 'chain open-link 4D Q2 30 mm', '2 t')
    >>> print(str(sizing).splitlines()[1])
    30 mm open-link chain 4D Q2, 38 m, on a concrete sinker of 2 t
    """
    return _sized("buoy", **locals())


def size_tanker(
    request: TankerRequest | None = None,
    /,
    *,
    title: str | None = None,
    source: str | None = None,
    max_swing: float | str | None = None,
    ship: str | None = None,
    dwt: float | str | None = None,
    length: float | str | None = None,
    breadth: float | str | None = None,
    draught: float | str | None = None,
    ballast_draught: float | str | None = None,
    condition: str | Sequence[str] | None = None,
    moulded_depth: float | str | None = None,
    frontal_area: float | str | None = None,
    lateral_area: float | str | None = None,
    fairlead: float | str | None = None,
    coefficients: str | None = None,
    buoy: str | None = None,
    buoys: str | None = None,
    hawser: float | str | None = None,
    depth: float | str | None = None,
    low_water: float | str | None = None,
    water_density: float | str | None = None,
    wind: float | str | None = None,
    wind_mean: float | str | None = None,
    return_period: float | str | None = None,
    current: float | str | None = None,
    hs: float | str | None = None,
    hmax: float | str | None = None,
    period: float | str | None = None,
    fetch: float | str | None = None,
    fetch_depth: float | str | None = None,
    load_method: str | Sequence[str] | None = None,
    wave_coefficient: float | str | None = None,
    wind_angle: float | str | None = None,
    current_angle: float | str | None = None,
    wave_angle: float | str | None = None,
    current_yaw: str | None = None,
    scan: float | str | None = None,
    chain: str | Sequence[str] | None = None,
    diameter_min: float | str | None = None,
    diameter_max: float | str | None = None,
    length_step: float | str | None = None,
    prefer: str | None = None,
    swing_price: float | str | None = None,
    clump_weight: float | str | Sequence[float | str] | None = None,
    lines: int | None = None,
    pretension: float | str | None = None,
    anchor: str | None = None,
    soil: str | None = None,
    sinker: str | None = None,
    sinker_density: float | str | None = None,
    friction: float | str | None = None,
    base_area: float | str | None = None,
    embedment: float | str | None = None,
    code: str | None = None,
    recalled: bool | None = None,
    life: float | str | None = None,
    wear: float | str | None = None,
    service_type: str | None = None,
    in_motion: bool | None = None,
    at_rest: bool | None = None,
    seeds: int | None = None,
    run_time: float | str | None = None,
    peak_period: float | str | Sequence[float | str] | None = None,
    sea_height: float | str | Sequence[float | str] | None = None,
    period_range: bool | None = None,
    dynamic_factor: float | str | None = None,
    **misspelt: Never,
) -> Sizing:
    """Size the chain and the anchor of a tanker's mooring.

    Parameters
    ----------
    request : TankerRequest, optional
        Ship, place, weather and mooring as objects, or what `catopt.read_sizing` made of a file.
    **misspelt
        Refused, with the nearest keyword. The others, in place of a request, are numbers in the
        unit named or texts with units; what is None is left out, and said in ``defaults``:

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

    Examples
    --------
    >>> import catopt
    >>> sizing = catopt.size_tanker(dwt="50000 t", depth="20 m", at_rest=True)
    >>> sizing.passes, f"{sizing.chain.line.length:g} m"
    (True, '206.25 m')
    """
    return _sized("tanker", **locals())


def _sized(
    moored: Moored, /, request: object, misspelt: dict[str, object], **keywords: object
) -> Sizing:
    inputs = {name: value for name, value in keywords.items() if value is not None} | misspelt
    if isinstance(request, str) and moored == "buoy" and "buoy" not in inputs:
        inputs, request = {"buoy": request, **inputs}, None
    if isinstance(request, BuoyRequest) and moored == "buoy" and not inputs:
        return sized_buoy(request)
    if isinstance(request, TankerRequest) and moored == "tanker" and not inputs:
        return sized_tanker(request)
    source = f"size_{moored}"
    if request is None:
        return size(input_values(moored, inputs, source=source))
    allowed = Message("refused_sizing.request_wanted_or_keywords_not", moored=moored)
    raise refused("request", f"a {type(request).__name__}", allowed, source)


def _inputs(moored: Moored) -> str:
    """Write every input of the table as a parameter: its unit, what it is, and what is taken."""
    rows = inputs_of(moored)
    named = {name: name for name in (*inputs_of("tanker"), *rows)}
    return "\n".join(_parameter(each, named) for each in rows.values())


def _parameter(each: Input, named: Mapping[str, str]) -> str:
    kind = {"COUNT": "whole number", "FLAG": "bool"}.get(each.takes, "text")
    kind = Dimension[each.takes].si_unit or "-" if each.is_measure else kind
    said = f"{Message(f'inputs.{each.name}')}{': ' * bool(each.words)}{', '.join(each.words)}"
    taken = Message(each.left_out, **named) if each.left_out else each.default
    said += Message("left_out.if_left_out", taken=taken) if taken else ""
    return f"{each.name} : {kind}, such as {each.example!r}\n    {said}."


_MOORED: Final[dict[Callable[..., Sizing], Moored]] = {size_buoy: "buoy", size_tanker: "tanker"}
for _function, _moored in _MOORED.items():
    _head, _, _tail = (getdoc(_function) or "").partition("\n\nReturns\n")
    _function.__doc__ = f"{_head}\n{_inputs(_moored)}\n\nReturns\n{_tail}"
