"""From the tables of a case file, without fault, to the model."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields, replace
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from catopt.casefile.components import SIZES, FromCatalogue, catalogue_choice
from catopt.casefile.fatigue_consistency import share_of_year
from catopt.casefile.ranges import LENGTHS, MASSES, POSITIONS, PRETENSIONS, RADII, Values
from catopt.casefile.schema import (
    BodyTable,
    CaseTable,
    CatalogueTable,
    ChecksTable,
    CurrentTable,
    DesignTable,
    FatigueTable,
    LineTable,
    MotionTable,
    SegmentChoiceTable,
    SegmentTable,
    WavesTable,
)
from catopt.constants import STANDARD_GRAVITY
from catopt.model import (
    Anchor,
    Body,
    Buoy,
    Case,
    CatalogueChoice,
    Checks,
    ClumpWeightChoice,
    CurrentProfile,
    Design,
    DesignLoad,
    Dynamics,
    Fatigue,
    FatigueSeaState,
    Find,
    Line,
    Load,
    LoadCase,
    Motion,
    PointLoad,
    Segment,
    SegmentChoice,
    SegmentCurve,
    Service,
    SinkerChoice,
    Site,
    SwarmSettings,
    System,
    WaveState,
    WaveTrain,
)
from catopt.model.immersion import weight_in_water

if TYPE_CHECKING:
    from catopt.catalogue import Component


def build_case(table: CaseTable, catalogue: FromCatalogue, folder: str) -> Case:
    """Build a case."""
    site = Site(**table.site.given())
    line = _line(table.line, site, catalogue)
    fairlead_height = _or_else(table.line.fairlead_height, site.water_depth)
    anchor_height = _or_else(table.line.anchor_height, 0.0)
    if lift := site.contact_offset:  # a bed higher by it; an end on the bed stays on it
        site = replace(site, water_depth=site.water_depth - lift)
        fairlead_height = fairlead_height - lift if fairlead_height else 0.0
        anchor_height = anchor_height - lift if anchor_height else 0.0
    return Case(
        site=site,
        line=line,
        load=Load(**table.load.given()) if table.load else None,
        fairlead_height=fairlead_height,
        anchor_height=anchor_height,
        checks=_checks(table.checks) if table.checks else Checks(),
        swarm=SwarmSettings(**table.pso.given()) if table.pso else SwarmSettings(),
        title=table.title or "",
        source=table.source or "",
        find=Find(**table.find.given()) if table.find else None,
        load_cases=tuple(LoadCase(**state.given()) for state in table.load_cases or ()),
        service=Service(**table.service.given()) if table.service else None,
        buoy=Buoy(**table.buoy.given()) if table.buoy else None,
        anchor=Anchor(**_weighed(table.anchor.given(), site)) if table.anchor else None,
        catalogue=_catalogue(table.catalogue, folder) if table.catalogue else CatalogueChoice(),
        design=_design(table.design, table.line, catalogue) if table.design else None,
        system=(
            System.around(
                line,
                fairlead_height=fairlead_height,
                anchor_height=anchor_height,
                seabed_friction=site.seabed_friction,
                **table.system.given(),
            )
            if table.system
            else None
        ),
        waves=_waves(table.waves, folder) if table.waves else None,
        current=_current(table.current, folder) if table.current else None,
        motion=_motion(table.motion, folder) if table.motion else None,
        anchor_motion=(
            Motion(**_found_from(folder, table.anchor_motion.given(), ("file",)))
            if table.anchor_motion
            else None
        ),
        body=_body(table.body, folder) if table.body else None,
        dynamics=Dynamics(**table.dynamics.given()) if table.dynamics else None,
        fatigue=_fatigue(table.fatigue, folder) if table.fatigue else None,
    )


def _waves(table: WavesTable, folder: str) -> WaveState:
    given = _found_from(folder, table.given(), ("elevation_file",))
    if table.trains is not None:
        given["trains"] = tuple(WaveTrain(**train.given()) for train in table.trains)
    return WaveState(**given)


def _current(table: CurrentTable, folder: str) -> CurrentProfile:
    given = table.given()
    arrays = [key for key in ("depths", "speeds", "directions") if key in given]
    given |= {key: tuple(given[key]) for key in arrays}
    return CurrentProfile(**_found_from(folder, given, ("series_file",)))


def _motion(table: MotionTable, folder: str) -> Motion:
    given = table.given()
    for key in ("rao_reference", "rao_crest", "drift"):
        given[key] = tuple(given.get(key, ()))
    return Motion(**_found_from(folder, given, ("file", "rao_file", "drift_file")))


def _body(table: BodyTable, folder: str) -> Body:
    given = table.given()
    given["wave_force"] = tuple(given.get("wave_force", ()))
    return Body(**_found_from(folder, given, ("force_file",)))


def _fatigue(table: FatigueTable, folder: str) -> Fatigue:
    given = table.given()
    given["curves"] = tuple(SegmentCurve(**curve.given()) for curve in table.curves or ())
    states = [state.given() for state in table.sea_states or ()]
    given["sea_states"] = tuple(
        FatigueSeaState(
            **{key: state[key] for key in state if key not in ("share", "time_per_year")},
            share=share_of_year(state) or 0.0,
        )
        for state in states
    )
    return Fatigue(**_found_from(folder, given, ("sea_states_file",)))


def _found_from(folder: str, given: dict[str, Any], files: Sequence[str]) -> dict[str, Any]:
    """Let the paths of files count from the folder of the case file."""
    base = FilePath(folder).absolute()
    return given | {key: str(base / given[key]) for key in files if key in given}


def _line(table: LineTable, site: Site, catalogue: FromCatalogue) -> Line:
    segments = [
        _segment(segment, catalogue.segments.get(("line", "segments", index)))
        for index, segment in enumerate(table.segments)
    ]
    loads = [PointLoad(**_weighed(each.given(), site)) for each in table.point_loads]
    return Line(segments, loads)


def _segment(table: SegmentTable, component: Component | None) -> Segment:
    """Build a segment; what the file gives goes before what the catalogue has."""
    given = table.given()
    given.pop("component", None)
    if "diameter" in given:
        given["nominal_diameter"] = given.pop("diameter")
    if given.pop("drag_axial_area", "D") == "pi D":
        given["drag_axial"] *= math.pi
    made = component.segment(1.0) if component else None
    figures = {each.name: getattr(made, each.name) for each in fields(made)} if made else {}
    if table.drag_method == "roughness":
        figures |= dict.fromkeys(("drag_normal", "drag_axial", "added_mass_normal"))
    return Segment(**figures | given)


def _checks(table: ChecksTable) -> Checks:
    given = table.given()
    code = given.pop("code", None)
    codes = given.pop("codes", [])
    return Checks(**given, codes=tuple(codes) if code is None else (code,))


def _weighed(given: dict[str, Any], site: Site) -> dict[str, Any]:
    """Put the weight in water in the place of a body's density or volume."""
    density, volume = given.pop("density", None), given.pop("volume", None)
    if volume is not None:
        lift = site.water_density * volume
        given["submerged_weight"] = (given["mass"] - lift) * STANDARD_GRAVITY
    if density is not None:
        given["submerged_weight"] = weight_in_water(given["mass"], density, site.water_density)
    return given


def _catalogue(table: CatalogueTable, folder: str) -> CatalogueChoice:
    given = table.given()
    if table.variants is not None:
        given["variants"] = table.variants.given()
    return catalogue_choice(given, folder)


def _design(table: DesignTable, line: LineTable, catalogue: FromCatalogue) -> Design:
    given = _with_values(table.given(), RADII, PRETENSIONS)
    given |= {key: tuple(given[key]) for key in ("objectives", "lines") if key in given}
    given["segments"] = tuple(
        _segment_choice(segment, index, line, catalogue)
        for index, segment in enumerate(table.segments)
    )
    given["clump_weights"] = tuple(
        ClumpWeightChoice(**_with_values(each.given(), MASSES, POSITIONS))
        for each in table.clump_weights
    )
    given["loads"] = tuple(DesignLoad(**each.given()) for each in table.loads or ())
    if table.sinker is not None:
        given["sinker"] = SinkerChoice(**_with_values(table.sinker.given(), MASSES))
    return Design(**given)


def _segment_choice(
    table: SegmentChoiceTable, index: int, line: LineTable, catalogue: FromCatalogue
) -> SegmentChoice:
    """Build what a segment may be; what is left out is as the line has it at the same place."""
    given = _with_values(table.given(), LENGTHS)
    given["lengths"] = given["lengths"] or (line.segments[index].length,)
    components = _component_names(given, index, catalogue)
    single, several = given.pop("diameter", None), given.pop("diameters", [])
    diameters = several if single is None else [single]
    return SegmentChoice(**given, components=components, diameters=tuple(sorted(diameters)))


def _component_names(
    given: dict[str, Any], index: int, catalogue: FromCatalogue
) -> tuple[str, ...]:
    """Take the components out of what is given, as the catalogue names them.

    Sizes without a component are sizes of that of the line; neither is the line's own segment.
    """
    path = ("design", "segments", index)
    single, several = given.pop("component", None), given.pop("components", None)
    if several is not None:
        return tuple(catalogue.names[*path, "components", k] for k in range(len(several)))
    if single is not None:
        return (catalogue.names[*path, "component"],)
    if any(key in given for key in SIZES):
        return (catalogue.names["line", "segments", index, "component"],)
    return ()


def _with_values(given: dict[str, Any], *quantities: Values) -> dict[str, Any]:
    """Put all values of quantities in the place of the keys that give them."""
    for values in quantities:
        own = {key: given.pop(key) for key in values.keys if key in given}
        given[values.many] = values.of(own)
    return given


def _or_else(value: float | None, default: float) -> float:
    return default if value is None else value
