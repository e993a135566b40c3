"""From the tables of a case file, without fault, to the model."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from catopt.casefile.components import SIZES, FromCatalogue, catalogue_choice
from catopt.casefile.motion_consistency import share_of_year
from catopt.casefile.ranges import values_of
from catopt.casefile.schema import (
    CaseTable,
    FatigueSeaStateTable,
    SegmentChoiceTable,
    SegmentTable,
    Table,
    entries,
)
from catopt.constants import STANDARD_GRAVITY
from catopt.documents import Path
from catopt.model import Case, Checks, Line, SegmentChoice, Site, System
from catopt.model.immersion import weight_in_water
from catopt.model.kinds import File
from catopt.model.strain_table import StrainTable

if TYPE_CHECKING:
    from catopt.catalogue import Component


def build_case(table: CaseTable, catalogue: FromCatalogue, folder: str) -> Case:
    """Build a case."""
    site = Site(**table.site.given())
    build = _Builder(catalogue, FilePath(folder).absolute(), site, table)
    line = Line(
        [build.part(each, ("line", "segments", k)) for k, each in enumerate(table.line.segments)],
        [build.part(each) for each in table.line.point_loads or ()],
    )
    heights = {
        "fairlead_height": _or_else(table.line.fairlead_height, site.water_depth),
        "anchor_height": _or_else(table.line.anchor_height, 0.0),
    }
    if lift := site.contact_offset:  # a bed higher by it; an end on the bed stays on it
        site = replace(site, water_depth=site.water_depth - lift)
        heights = {key: height - lift if height else 0.0 for key, height in heights.items()}
    given = {
        {"pso": "swarm"}.get(key, key): build.value(each, (key,))
        for key, each in table.given().items()
        if key not in ("site", "line", "system", "catalogue")
    }
    if table.catalogue:
        given["catalogue"] = catalogue_choice(build.given(table.catalogue), folder)
    if table.system:
        around = {"seabed_friction": site.seabed_friction, **heights, **table.system.given()}
        given["system"] = System.around(line, **around)
    return Case(**{"load": None, **heights, **given, "site": site, "line": line})


@dataclass(frozen=True)
class _Builder:
    """Makes parts of the model out of tables, with what they take from elsewhere."""

    catalogue: FromCatalogue
    folder: FilePath
    site: Site
    case: CaseTable

    def value(self, value: Any, path: Path) -> Any:
        """Return a value as the model has it: a table as its part, an array as a tuple."""
        if isinstance(value, list):
            return tuple(self.value(each, (*path, k)) for k, each in enumerate(value))
        return self.part(value, path) if isinstance(value, Table) else value

    def given(self, table: Table, path: Path = ()) -> dict[str, Any]:
        """Return what a table gives, as the model has it; paths of files count from the folder."""
        given = {key: self.value(each, (*path, key)) for key, each in table.given().items()}
        for key in given:
            if isinstance(entries(type(table))[key].kind, File):
                given[key] = str(self.folder / given[key])
        for values in table.choices:
            own = {key: given.pop(key) for key in values.keys if key in given}
            given[values.many] = values_of(values, own)
        return given

    def part(self, table: Table, path: Path = ()) -> Any:
        """Build what a table holds; of variants of figures, a mapping."""
        if isinstance(table, SegmentTable):
            return _segment(table, self.catalogue.segments.get(path))
        given = self.given(table, path)
        if isinstance(table, SegmentChoiceTable):
            return self._segment_choice(given, path)
        if isinstance(table, FatigueSeaStateTable):
            given["share"] = share_of_year(given) or 0.0
            given.pop("time_per_year", None)
        return made_of(table, given, self.site)

    def _segment_choice(self, given: dict[str, Any], path: Path) -> SegmentChoice:
        """Build what a segment may be; what is left out is as the line has it at the same place."""
        own: Path = ("line", "segments", path[-1])
        names = self.catalogue.names
        if not given["lengths"]:
            given["lengths"] = (self.case.line.segments[int(path[-1])].given()["length"],)
        single, several = given.pop("component", None), given.pop("components", None)
        components: tuple[str, ...] = ()
        if several is not None:
            components = tuple(names[*path, "components", k] for k in range(len(several)))
        elif single is not None:
            components = (names[*path, "component"],)
        elif any(key in given for key in SIZES):  # of the component of the line
            components = (names[*own, "component"],)
        one, many = given.pop("diameter", None), given.pop("diameters", ())
        diameters = tuple(sorted(many)) if one is None else (one,)
        return SegmentChoice(**given, components=components, diameters=diameters)


def made_of(table: Table, given: dict[str, Any], site: Site) -> Any:
    """Make the part of the model of what a table gives; of variants of figures, a mapping."""
    if table.model is Checks and "code" in given:
        given["codes"] = (given.pop("code"),)
    if {"density", "volume"} & set(given) and not table.choices:
        given = _weighed(given, site.water_density)
    return given if table.model is None else table.model(**given)


def _weighed(given: dict[str, Any], water: float) -> dict[str, Any]:
    """Put the weight in water in the place of a body's density or volume."""
    density, volume = given.pop("density", None), given.pop("volume", None)
    if volume is not None:
        weight = (given["mass"] - water * volume) * STANDARD_GRAVITY
    else:
        weight = weight_in_water(given["mass"], density, water)
    return given | {"submerged_weight": weight}


def _segment(table: SegmentTable, component: Component | None) -> Any:
    """Build a segment; what the file gives goes before what the catalogue has."""
    given = table.given()
    given.pop("component", None)
    if "diameter" in given:
        given["nominal_diameter"] = given.pop("diameter")
    if given.pop("drag_axial_area", "D") == "pi D":
        given["drag_axial"] *= math.pi
    made = component.segment(1.0) if component else None
    figures = {each.name: getattr(made, each.name) for each in fields(made)} if made else {}
    if "strain" in given:
        given["EA"] = StrainTable(given.pop("strain"), given.pop("strain_tension"))
    if given.get("drag_method") == "roughness":
        figures |= dict.fromkeys(("drag_normal", "drag_axial", "added_mass_normal"))
    return table.model(**figures | given)


def _or_else(value: float | None, default: float) -> float:
    return default if value is None else value
