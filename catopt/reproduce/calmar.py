"""IALA's CALMAR: the test buoy of its manuals, as two of its releases print it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

from catopt.loads.buoy import AIR_DENSITY, buoy_loads
from catopt.loads.buoy_shape import DRAG_COEFFICIENT, BuoyShape, BuoySlice, Floating
from catopt.loads.environment import SeaState, SurfaceCurrent, WaterLevels, Wind, drag
from catopt.loads.sinker import size_sinker
from catopt.model import Line, Segment
from catopt.model.line import weight_in_water
from catopt.reproduce.items import (
    TF,
    Published,
    SideBySide,
    Study,
    compare,
    in_unit,
    published,
    study_of,
)
from catopt.words import Message

NAME: Final = "calmar"

_CLOSE: Final = 1e-10
"""Relative, of the chain's pull on the buoy from one round to the next: far below a print."""

_TONNE: Final = 1e3


@dataclass(frozen=True)
class Release:
    """What two releases of the program have each in its own way: steel, kg/m3, and tide, m/s."""

    name: str
    steel_density: float
    tide: float


@dataclass(frozen=True)
class Moored:
    """The buoy on the shortest chain that is tangent to the bed at the sinker."""

    floating: Floating
    horizontal_force: float
    length: float
    radius: float
    tension: float
    proof_load: float
    sinker: float
    least_depth: float
    depth: float

    @property
    def factor(self) -> float:
        """Proof load over tension."""
        return self.proof_load / self.tension


def releases(source: Published) -> tuple[Release, ...]:
    """List the releases, in the order of the printed tables."""
    steel, tide = (source.series[key] for key in ("steel_density_kg_per_m3", "tide_m_per_s"))
    return tuple(map(Release, source.printed, steel, tide))


def buoy_of(source: Published, *, superstructure: bool = False) -> BuoyShape:
    """Make the buoy of its figures, with its superstructure to the wind or without."""
    given, series = source.inputs, source.series
    slices = zip(*(series[f"float_{key}_m"] for key in ("height", "lower", "upper")), strict=True)
    hole, pole = given["float_hole_m"], given["pole_diameter_m"]
    marks: dict[str, Any] = {}
    if superstructure:
        for key in ("pylon", "topmark"):
            outline = BuoySlice(*series[f"{key}_height_and_widths_m"])
            marks[f"{key}s"] = (outline,)
    return BuoyShape(
        "test buoy",
        mass=sum(series["mass_kg"]),
        hull=tuple(BuoySlice(height, low, up, hole) for height, low, up in slices),
        structure=(BuoySlice(given["pole_length_m"], pole, pole),),
        structure_depth=given["float_above_foot_m"],
        eye_offset=given["ring_below_float_m"],
        ballast_mass=given["ballast_mass_kg"],
        ballast_pieces=int(given["ballast_pieces"]),
        origin=source.source_title,
        **marks,
    )


def moored(
    source: Published,
    release: Release,
    shape: BuoyShape | None = None,
    *,
    left_out: float = 0.0,
    **how: Any,
) -> Moored:
    """Moor the buoy as CALMAR 6.2 does: loads, chain and draught follow from each other.

    `shape`: another than as printed; `left_out`: area, m2, that the wind does not see, of what is
    above water; `how`: of `buoy_loads`.
    """
    from catopt.catalogue import component
    from catopt.catenary.find import find_length

    given = source.inputs
    shape = shape or buoy_of(source)
    chain = component(f"chain open-link 5D Q{given['chain_quality']:.0f}", given["chain_m"])
    assert chain.proof_load is not None
    density = given["water_density_kg_per_m3"]
    weight = weight_in_water(chain.mass, release.steel_density, density)
    sea = SeaState(given["wave_period_s"], given["hs_m"], given["hmax_m"])
    wind = Wind(given["wind_m_per_s"])
    nominal = given["nominal_depth_m"]
    levels = WaterLevels(nominal, nominal + given["tidal_range_m"])
    pull, last = 0.0, -1.0
    while abs(pull - last) > _CLOSE * pull:
        loads = buoy_loads(
            shape,
            wind,
            SurfaceCurrent(release.tide),
            sea,
            levels,
            chain_diameter=given["chain_m"],
            pull=pull,
            water_density=density,
            **how,
        )
        force = loads.horizontal_force
        force -= drag(AIR_DENSITY, wind.speed, left_out, DRAG_COEFFICIENT)
        floating = shape.afloat(pull, density)
        height = levels.deepest(sea) - floating.eye_depth
        line = Line([Segment(2.0 * height, weight)])
        found = find_length(line, height=height, horizontal_force=force, anchor_angle=0.0)
        last, pull = pull, found.solution.fairlead.vertical_force
    sinker = size_sinker(force, soil="IALA default", water_density=density)
    return Moored(
        floating,
        force,
        found.value,
        found.solution.span,
        found.solution.fairlead.tension,
        chain.proof_load,
        sinker.needed_mass,
        nominal - 0.5 * sea.hmax,
        levels.deepest(sea),
    )


def study() -> Study:
    """Moor the test buoy by both releases and judge every printed number."""
    source = published(NAME)
    items = [
        item
        for release in releases(source)
        for item in compare(source, release.name, _figures(moored(source, release)))
    ]
    return study_of(
        source, items, _findings(source), side_by_side=(_readings(source, releases(source)[0]),)
    )


def _figures(of: Moored) -> Mapping[str, float]:
    floating = of.floating
    return {
        "least_depth_m": of.least_depth,
        "depth_m": of.depth,
        "catenary_length_m": of.length,
        "swing_radius_m": of.radius,
        "tension_tf": of.tension / TF,
        "proof_load_over_tension": of.factor,
        "sinker_t": of.sinker / _TONNE,
        "horizontal_drag_tf": of.horizontal_force / TF,
        "reserve_percent": 100.0 * floating.reserve_share,
        "displacement_t": floating.displacement / _TONNE,
        "freeboard_m": floating.freeboard,
        "draught_m": floating.keel_depth,
        "area_in_water_m2": floating.hull_area_in_water(),
        "area_in_air_m2": floating.windage,
    }


def _pole_in_air(of: Moored) -> float:
    """Area of the pole above the water, inside the float, m2."""
    (pole,) = of.floating.shape.structure
    return pole.outline(low=of.floating.keel_depth)


def _findings(source: Published) -> tuple[str, ...]:
    newer, older = releases(source)
    printed, full = moored(source, newer), buoy_of(source, superstructure=True)
    whole, (without, _) = moored(source, newer, full), _without_pole(source, newer, full)
    return (
        Message("reproduce.calmar_reading", force=printed.horizontal_force),
        Message(
            "reproduce.calmar_releases",
            steel=newer.steel_density,
            old_steel=older.steel_density,
            tide=newer.tide,
            old_tide=older.tide,
        ),
        Message(
            "reproduce.calmar_air",
            above=full.tower_area + full.marks_area,
            pole=_pole_in_air(printed),
            other=without.factor,
            factor=whole.factor,
            area=whole.floating.windage,
        ),
    )


def _readings(source: Published, release: Release) -> SideBySide:
    """Set the readings of what is above water, and catopt's own wave, beside the print."""
    full = buoy_of(source, superstructure=True)
    printed = source.printed[release.name]
    rows: list[tuple[str, ...]] = []
    own_wave = moored(source, release, wave_height="hmax", chain_waves=True)
    for what, part, area in (
        ("float and pole", *_seen(moored(source, release))),
        ("float, pylon and topmark", *_without_pole(source, release, full)),
        ("float, pole, pylon and topmark", *_seen(moored(source, release, full))),
        ("catopt's own wave, also on the chain", *_seen(own_wave)),
    ):
        cells = (part.horizontal_force, part.length, part.radius, part.factor, area)
        formats = ("{:.1f}", "{:.2f}", "{:.2f}", "{:.2f}", "{:.3f}")
        rows.append((what, *(f.format(cell) for f, cell in zip(formats, cells, strict=True))))
    keys = ("catenary_length_m", "swing_radius_m", "proof_load_over_tension", "area_in_air_m2")
    rows.append((release.name, "-", *(printed[key].text for key in keys)))
    header = (
        "reading",
        in_unit("horizontal force", "N"),
        in_unit("length", "m"),
        in_unit("swing radius", "m"),
        "proof load over tension",
        in_unit("area in air", "m2"),
    )
    return SideBySide("What stands open, and what departs", header, tuple(rows))


def _seen(of: Moored) -> tuple[Moored, float]:
    return of, of.floating.windage


def _without_pole(source: Published, release: Release, full: BuoyShape) -> tuple[Moored, float]:
    """Leave out what of the pole is hidden in the float above water, by its own draught."""
    left_out, last = 0.0, -1.0
    while abs(left_out - last) > _CLOSE:
        found = moored(source, release, full, left_out=left_out)
        last, left_out = left_out, _pole_in_air(found)
    return found, found.floating.windage - left_out
