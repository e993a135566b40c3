"""Wind, current and waves on a buoy, and the buoys that are known by name."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, Final, Literal, TypeVar, get_args

from catopt.catalogue.family import nearest
from catopt.catalogue.table import TomlTable
from catopt.constants import SEA_WATER_DENSITY
from catopt.documents import read_text
from catopt.errors import InputError, NoAnswerError, Problem
from catopt.loads.buoy_shape import DRAG_COEFFICIENT, BuoyShape, BuoySlice, Floating
from catopt.loads.component import CALMAR, LoadComponent, Loads, LoadSource, Number
from catopt.loads.environment import (
    HMAX_OVER_HS,
    SeaState,
    SurfaceCurrent,
    WaterLevels,
    Wind,
    drag_component,
)
from catopt.model.kinds import Findings, exceeds
from catopt.words import Measure, Message, Several, term, typed_name

Made = TypeVar("Made")

SCHEMA = "catopt.buoys/1"
"""What a file of buoys has under its key ``schema``."""


@cache
def buoys() -> tuple[BuoyShape, ...]:
    """Return the buoys that come with catopt: generic ones of its own geometry, and real ones."""
    data = files("catopt.loads").joinpath("data")
    return tuple(
        shape
        for name in ("buoys.toml", "real_buoys.toml")
        for shape in parse_buoys(data.joinpath(name).read_text("utf-8"), f"catopt's {name}")
    )


def buoy(name: str, among: tuple[BuoyShape, ...] | None = None) -> BuoyShape:
    """Look a buoy up, such as ``"pillar 1.8 m"``, among some or catopt's own.

    Raises
    ------
    InputError
        When there is none of that name.
    """
    known = {each.name: each for each in (buoys() if among is None else among)}
    if (typed := typed_name(name)) in known:
        return known[typed]
    near = nearest(name, tuple(known))
    hint = Message("refused.there_are", names=", ".join(known))
    if near:
        hint = Message("refused.did_you_mean", near=near)
    raise InputError([Problem("buoy", f'"{name}"', hint)], "buoys")


def read_buoys(path: str | os.PathLike[str]) -> tuple[BuoyShape, ...]:
    """Read a file of buoys of one's own (TOML, of the form of catopt's buoys.toml).

    Raises
    ------
    InputError
        With every problem of the file.
    """
    source = os.fspath(path)
    return parse_buoys(read_text(Path(path), source, kind="file of buoys"), source)


def parse_buoys(text: str, source: str = "") -> tuple[BuoyShape, ...]:
    """Read the text of a file of buoys, whose source is named in messages of every problem."""
    file, findings = TomlTable.of_file(text, source, SCHEMA, ("origin", "buoy"))
    origin = file.text("origin", required=False) or "the user's own"
    read = [_read(table, origin, findings) for table in file.tables("buoy")]
    found = tuple(shape for shape in read if shape is not None)
    names = [shape.name for shape in found]
    for name in sorted({name for name in names if names.count(name) > 1}):
        findings.add("buoy", f'"{name}"', Message("refused_sizing.this_name_used_twice"))
    findings.raise_if_any()
    return found


_SLICES: Final = ("hull", "structure", "pylons", "topmarks")
_WORDS: Final = ("name", "origin", "chain_source")


def _read(table: TomlTable, origin: str, findings: Findings) -> BuoyShape | None:
    """Make a buoy; None where something is wrong with it."""
    before = len(findings.problems)
    table.only(*(each.name for each in fields(BuoyShape)))
    for key in _WORDS:
        table.text(key, required=key == "name")
    table.flag("generic")
    short = () if table.has("hull") else ("hull_diameter", "hull_depth")
    for key in ("mass", *short):
        if not table.has(key):
            table.problem(key, Message("refused.number"))
    slices = {key: _slices(table, key, findings) for key in _SLICES if table.has(key)}
    if len(findings.problems) > before:
        return None
    values: dict[str, Any] = {"origin": origin, **table.values, **slices}
    return _made(table, BuoyShape, values, findings)


def _slices(table: TomlTable, key: str, findings: Findings) -> tuple[BuoySlice, ...]:
    """Read an array of slices, from the lowest upwards."""
    made = []
    for each in table.tables(key):
        before = len(findings.problems)
        each.only(*(field.name for field in fields(BuoySlice)))
        for field in fields(BuoySlice):
            if field.default is MISSING and not each.has(field.name):
                each.problem(field.name, Message("refused.number"))
        if len(findings.problems) == before:
            made.append(_made(each, BuoySlice, each.values, findings))
    return tuple(slice_ for slice_ in made if slice_ is not None)


def _made(
    table: TomlTable, maker: Callable[..., Made], values: dict[str, Any], findings: Findings
) -> Made | None:
    try:
        return maker(**values)
    except InputError as error:
        for problem in error.problems:
            findings.add(table.at(problem.key), problem.found, problem.allowed)
        return None


Stream = tuple[float, float]
"""Density, kg/m3, and speed, m/s."""

AIR_DENSITY: Final = 1.29
"""kg/m3; CALMAR prints "129", a misprint."""

CHAIN_WIDTH: Final = 2.65
"""Width of a chain as the current sees it, in nominal diameters (CALMAR 5.2.1, A)."""

DEEPEST: Final = 200.0
"""m: the limit that CALMAR states."""

FASTEST: Final = 7.0
"""m/s: the limit that CALMAR states for the current."""

WaveHeight = Literal["hs", "hmax"]

WHOLE, OURS = "IALA-CALMAR", "catopt-buoy"
"""Methods: CALMAR's as it is, and ours, which has something else somewhere."""
BUOY_METHODS: Final = (WHOLE, OURS)


class BreakingSeaError(NoAnswerError):
    """The largest wave breaks, where CALMAR gives no answer (6.3.1)."""

    def __init__(self, sea: SeaState, levels: WaterLevels, option: str = "load_method") -> None:
        self.sea, self.levels, limit = sea, levels, sea.breaking_at(levels)
        said = Message(
            "loads.calmar_refuses",
            height=sea.hmax,
            depth=levels.high,
            period=sea.period,
            limit=limit,
            hs=limit / HMAX_OVER_HS,
            option=option,
            ours=OURS,
        )
        super().__init__(said)

    def __reduce__(self) -> tuple[type[BreakingSeaError], tuple[SeaState, WaterLevels]]:
        """Give what builds the same error in another process."""
        return type(self), (self.sea, self.levels)

    def spelt(self, option: str) -> BreakingSeaError:
        """Name the way out as whoever asked writes it."""
        return BreakingSeaError(self.sea, self.levels, option)


def check_breaking(sea: SeaState, levels: WaterLevels, method: str) -> None:
    """Refuse a sea in which CALMAR gives no answer, unless the method is ours."""
    if method == WHOLE and sea.breaks(levels):
        raise BreakingSeaError(sea, levels)


_FORCES = LoadSource(CALMAR, "section 5", "A")
_CHAIN = LoadSource(CALMAR, "5.2.1", "A")
_OWN = LoadSource(OURS, "docs/loads.md", "C")
"""Of a force by CALMAR's formula with a speed or a width of our own."""


def surface_speed(
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    wave_height: WaveHeight = "hs",
) -> float:
    """Speed of the water at the surface, m/s: tide + 0.015 wind + wave (CALMAR, A).

    All are from one side. The wave is CALMAR's, pi Hs/T, or catopt's own: the largest that does not
    break, in water of a depth, m (`SeaState.surface_velocity`).
    """
    from catopt.waves.sea import wind_driven_speed

    driven = wind_driven_speed(wind.speed, "CALMAR")
    return current.speed + driven + _wave_speed(sea, depth, wave_height)


def _wave_speed(sea: SeaState, depth: float, wave_height: WaveHeight) -> float:
    return sea.surface_velocity(depth) if wave_height == "hmax" else sea.deep_water_velocity


def buoy_loads(
    shape: BuoyShape,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    levels: WaterLevels,
    *,
    chain_diameter: float,
    pull: float = 0.0,
    marine_growth: float = 0.0,
    wave_height: WaveHeight = "hs",
    chain_waves: bool = False,
    water_density: float = SEA_WATER_DENSITY,
    method: str = WHOLE,
) -> Loads:
    """Add up the forces of wind, current and waves on a buoy and its chain.

    All are from one side, at the same time, and so are the loads. Static: no motion of the buoy, no
    vortex shedding. The method is CALMAR's; with growth, largest wave or waves on the chain it is
    `"catopt-buoy"`, and its assumptions say what departs.

    Parameters
    ----------
    levels : WaterLevels
        The waves and the height of the chain are those of high water.
    chain_diameter : float
        Nominal, m; 0 leaves the chain out.
    pull : float
        Vertical, of the line on the buoy, N: it adds to the draught.
    marine_growth : float
        Thickness on hull and chain, m. CALMAR has none; the rule D + 2 t is catopt's own.
    wave_height : {"hs", "hmax"}
        Velocity of the waves: CALMAR's pi Hs/T in deep water; or catopt's own, of the largest wave
        that does not break, in the depth of high water.
    chain_waves : bool
        Whether the chain is in the speed of the surface, over its whole height, and not in the tide
        alone as CALMAR has it.
    water_density : float
        kg/m3.
    method : {"IALA-CALMAR", "catopt-buoy"}
        CALMAR stops where the largest wave breaks; ours goes on, with the crest of one as high as
        it can be and without the force of the breaking.

    Raises
    ------
    InputError
        Deeper than 200 m, faster than 7 m/s, a pull above the reserve buoyancy, a draught deeper
        than the water.
    BreakingSeaError
        The largest wave breaks, and the method is CALMAR's.
    """
    _check(current, levels, chain_diameter, marine_growth, wave_height, method)
    check_breaking(sea, levels, method)
    floating = shape.afloat(pull, water_density)
    keel = floating.keel_depth
    if keel >= levels.low:
        refused = Message("refused_sizing.buoy_reaches_m_below_water", keel=keel)
        raise InputError([Problem("levels.low", f"{levels.low:g} m", refused)], "buoy loads")
    speed = surface_speed(wind, current, sea, levels.high, wave_height)
    at_chain = speed if chain_waves else current.speed
    water, air = (water_density, speed), (AIR_DENSITY, wind.speed)
    is_grown, is_own = marine_growth > 0.0, wave_height == "hmax"
    source = _OWN if is_own or is_grown else _FORCES
    components = list(_above_and_on_hull(floating, water, air, marine_growth, source))
    in_what: tuple[str, ...] = ()
    if chain_diameter > 0.0:
        height = levels.deepest(sea) - floating.eye_depth
        stream, source = (water_density, at_chain), _OWN if chain_waves or is_grown else _CHAIN
        components.append(_chain(stream, chain_diameter, height, marine_growth, source))
        in_what = (Message("loads.chain_in_surface" if chain_waves else "loads.chain_in_tide"),)
    weather = {"wind": wind.speed, "tide": current.speed, "height": sea.hmax}
    departures = tuple(
        Message(f"loads.departs_{key}")
        for key, departs in (
            ("hmax", is_own),
            ("chain_waves", chain_waves and chain_diameter > 0.0),
            ("growth", is_grown),
            ("breaking", sea.breaks(levels)),
        )
        if departs
    )
    return Loads(
        Message("loads.buoy_in", buoy=shape.name, **weather),
        tuple(components),
        (
            Message("loads.one_side"),
            _speeds(speed, wind, current, sea, levels.high, wave_height),
            *in_what,
            *departures,
            _afloat(floating),
        ),
        _warnings(sea, levels, wave_height),
        OURS if departures else WHOLE,
    )


def _above_and_on_hull(
    of: Floating, water: Stream, air: Stream, growth: float, source: LoadSource
) -> Iterator[LoadComponent]:
    """Make the current on the hull, and the wind on what of the buoy is above the water."""
    wet, note = of.hull_area_in_water(growth), _grown(growth)
    shape, in_air = of.shape, of.shape.drag_in_air
    in_water = shape.drag_in_water
    what = "loads.hull_in_water"
    yield _drag("loads.current_on_hull", water, wet, what, in_water, source, note)
    yield _drag("loads.wind_on_hull", air, of.hull_area_in_air, "loads.hull_in_air", in_air)
    if shape.tower_area > 0.0:
        yield _drag("loads.wind_on_tower", air, shape.tower_area, "loads.tower", in_air)
    if shape.marks_area > 0.0:
        yield _drag("loads.wind_on_topmark", air, shape.marks_area, "loads.topmark", in_air)


def _chain(
    water: Stream, diameter: float, height: float, growth: float, source: LoadSource
) -> LoadComponent:
    area = (CHAIN_WIDTH * diameter + 2.0 * growth) * height
    said = Message("loads.chain_note", diameter=diameter * 1e3, height=height)
    note = Several(filter(None, (said, _grown(growth))))
    what = "loads.chain_area"
    return _drag("loads.current_on_chain", water, area, what, source=source, note=note)


def _grown(growth: float) -> str:
    return Message("loads.growth") if growth > 0.0 else ""


def _drag(
    name: str,
    stream: Stream,
    area: float,
    what: str,
    coefficient: float = DRAG_COEFFICIENT,
    source: LoadSource = _FORCES,
    note: str = "",
) -> LoadComponent:
    """Make a force by a coefficient of drag; what the area, m2, is of has a key."""
    of = Number("A", area, "m2", Message(what))
    said = "loads.drag_coefficient" if coefficient == DRAG_COEFFICIENT else "loads.own_coefficient"
    drag = Number("Cd", coefficient, "", Message(said))
    kind: Literal["wind", "current"] = "wind" if ".wind_" in name else "current"
    return drag_component(Message(name), kind, stream, of, drag, source, note=note)


def _check(
    current: SurfaceCurrent,
    levels: WaterLevels,
    diameter: float,
    growth: float,
    wave_height: str,
    method: str,
) -> None:
    found = Findings("buoy loads")
    found.number("chain_diameter", diameter, "m", at_least=0.0, at_most=0.2)
    found.number("marine_growth", growth, "m", at_least=0.0, at_most=0.5)
    found.word("wave_height", wave_height, get_args(WaveHeight))
    found.word("method", method, BUOY_METHODS)
    if exceeds(levels.high, DEEPEST):
        limit = Message("refused_sizing.calmar_holds_down_m_water", deepest=DEEPEST)
        found.add("levels.high", f"{levels.high:g} m", limit)
    if exceeds(current.speed, FASTEST):
        limit = Message("refused_sizing.calmar_holds_up_m_s", fastest=FASTEST)
        found.add("current.speed", f"{current.speed:g} m/s", limit)
    found.raise_if_any()


def _speeds(
    speed: float,
    wind: Wind,
    current: SurfaceCurrent,
    sea: SeaState,
    depth: float,
    wave_height: WaveHeight,
) -> str:
    """Say what the speed of the surface, m/s, consists of."""
    orbital = _wave_speed(sea, depth, wave_height)
    driven = speed - current.speed - orbital
    values = {"speed": speed, "tide": current.speed, "wind": wind.speed, "driven": driven}
    if wave_height == "hmax":
        return Message("loads.surface_speed", orbital=orbital, depth=depth, **values)
    waves = {"orbital": orbital, "height": sea.hs, "period": sea.period}
    return Message("loads.surface_speed_hs", **waves, **values)


def _afloat(floating: Floating) -> str:
    reserve = floating.shape.reserve_buoyancy(floating.water_density)
    return Message(
        "loads.afloat",
        pull=Measure("vertical_force", floating.pull),
        draught=floating.draught,
        freeboard=floating.freeboard,
        reserve=Measure("vertical_force", reserve),
        origin=term(floating.shape.origin),
    )


def _warnings(sea: SeaState, levels: WaterLevels, wave_height: WaveHeight) -> tuple[str, ...]:
    values = {"height": sea.hmax, "depth": levels.high, "period": sea.period}
    limit = sea.breaking_height(levels.high)
    warned = []
    if sea.breaks(levels):
        warned.append(Message("loads.calmar_stops", limit=sea.breaking_at(levels), **values))
    if wave_height == "hmax" and sea.hmax > limit:
        warned.append(Message("loads.breaks", limit=limit, **values))
    return tuple(warned)
