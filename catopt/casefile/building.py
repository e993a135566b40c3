"""From the tables of a case file, without fault, to the model."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, fields, replace
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from catopt.casefile.document import FileSection, Finding
from catopt.casefile.motion_consistency import share_of_year
from catopt.casefile.schema import (
    CaseTable,
    FatigueSeaStateTable,
    NetworkTable,
    SegmentChoiceTable,
    SegmentTable,
    TableSchema,
    Values,
    VariantsTable,
    entries,
)
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.documents import Path
from catopt.errors import InputError
from catopt.model import (
    Case,
    CatalogueChoice,
    Checks,
    Line,
    Segment,
    Site,
    System,
    TitleBlock,
)
from catopt.model.kinds import File
from catopt.model.line import StrainTable, weight_in_water
from catopt.model.plausible_ranges import accepting
from catopt.model.title_block import Revision
from catopt.units import as_written
from catopt.words import Message, given_keys
from catopt.words.message import problem_words

if TYPE_CHECKING:
    from catopt.catalogue import Component
    from catopt.catalogue.choice import ChosenCatalogue

MOST_VALUES = 10_000
"""Values that a range may be made of."""

_HITS = 1e-9
"""Part of a step by which the last value may miss the end of its range: rounding, no more."""

_DIGITS = 14
"""Of the values inside a range: one less than double precision holds for certain, so that 0.1 m and
two steps of 0.1 m are 0.3 m."""


def wanted(values: Values) -> str:
    """Say in words in which ways a quantity may be given."""
    low, high, step = values.range
    return f"{values.many}, {values.one}, or {low} with {high} and {step}"


def is_given(values: Values, section: FileSection) -> bool:
    """Whether a table has any of the keys."""
    return any(key in section for key in values.keys)


def values_of(values: Values, given: dict[str, Any]) -> tuple[float, ...]:
    """Return the values, rising; empty where none is given, in SI and without fault."""
    if values.many in given:
        return tuple(sorted(given[values.many]))
    if values.one in given:
        return (given[values.one],)
    low, high, step = (given.get(key) for key in values.range)
    return () if low is None or high is None or step is None else _steps(low, high, step)


def read(values: Values, section: FileSection) -> tuple[float, ...]:
    """Return the values of a table of the document; empty where they are not clear."""
    if not is_given(values, section) or any(findings(values, section)):
        return ()
    given = {key: section.value(key) for key in values.keys if key in section}
    return () if None in given.values() else values_of(values, given)


def findings(values: Values, section: FileSection, *, required: bool = False) -> Iterator[Finding]:
    """Find values given in two ways, in half of one, twice, or (where required) not at all."""
    ranged = [key for key in values.range if key in section]
    singly = [key for key in (values.one, values.many) if key in section]
    if required and section.lacks(*values.keys):
        yield section.missing(values.many, Message("refused.ways_wanted", ways=wanted(values)))
    elif len(singly) + bool(ranged) > 1:
        found = given_keys([*singly, *ranged])
        yield Finding(section.path, found, Message("refused.one_way", ways=wanted(values)))
    elif ranged and not section.misspelt(*values.keys):
        yield from _range_findings(values, section)
    yield from duplicates(section, values.many)


def _range_findings(values: Values, section: FileSection) -> Iterator[Finding]:
    low_key, high_key, step_key = values.range
    keys = {"low": low_key, "high": high_key, "step": step_key}
    together = Message("refused_case.go_together", **keys)
    yield from (section.missing(key, together) for key in values.range if key not in section)
    yield from upside_down(section, low_key, high_key)
    low, high, step = (section.number(key) for key in values.range)
    if low is None or high is None or step is None or high < low:
        return
    if (high - low) / step >= MOST_VALUES - 1 + _HITS:
        count = f"{(high - low) / step + 1.0:.6g}"
        allowed = Message("refused.too_many_values", count=count, most=MOST_VALUES)
        yield section.wrong(step_key, allowed)


def upside_down(section: FileSection, low_key: str, high_key: str) -> Iterator[Finding]:
    """Find an upper bound below the lower one."""
    low, high = section.number(low_key), section.number(high_key)
    if low is not None and high is not None and high < low:
        shown = as_written(section.given[low_key]).strip('"')
        yield section.wrong(high_key, Message("refused.at_least_key", key=low_key, shown=shown))


def duplicates(section: FileSection, key: str) -> Iterator[Finding]:
    """Find values of an array that stand there already, however they are written."""
    read = section.value(key) or []
    for index, one in enumerate(read):
        if one in read[:index]:
            shown = as_written(section.given[key][index])
            path = (*section.path, key, index)
            yield Finding(path, shown, Message("refused.stands_already"))


def _steps(low: float, high: float, step: float) -> tuple[float, ...]:
    """Step from `low` to `high`, which is the last value when a step meets it."""
    count = math.floor((high - low) / step + _HITS)
    inside = [float(f"{low + k * step:.{_DIGITS}g}") for k in range(1, count)]
    if count == 0:
        return (low,)
    last = low + count * step
    meets = abs(last - high) <= _HITS * step
    return (low, *inside, high if meets else float(f"{last:.{_DIGITS}g}"))


SIZES = ("diameters", "diameter", "diameter_min", "diameter_max")
"""Keys that limit the sizes of a segment's components."""


@dataclass
class FromCatalogue:
    """What was found in the catalogue, and what was not."""

    findings: list[Finding] = field(default_factory=list)
    """Names, diameters and variants that it has not got."""
    segments: dict[Path, Component] = field(default_factory=dict)
    """Components of the line's segments, by the segment's path."""
    names: dict[Path, str] = field(default_factory=dict)
    """Families with their grades, as the catalogue writes them, by the path in the file."""


def catalogue_choice(given: dict[str, Any], folder: str) -> CatalogueChoice:
    """Build the choice of a catalogue from the keys of ``[catalogue]``, which are without fault.

    The path of the user's families counts from the folder of the case file.
    """
    file = given.get("file")
    return CatalogueChoice(
        file=str(FilePath(folder).absolute() / file) if file else "",
        allow_recalled=given.get("allow_recalled", False),
        variants=tuple(sorted(given.get("variants", {}).items())),
    )


def from_catalogue(case: FileSection, folder: str) -> FromCatalogue:
    """Look up every component that a document names."""
    found = FromCatalogue()
    lines = case.tables("lines") if "lines" in entries(case.schema) else [case.table("line")]
    of_line = [segment for line in lines for segment in line.tables("segments")]
    design = case.table("design")
    of_design = design.tables("groups" if "groups" in entries(design.schema) else "segments")
    named = list(_named([*of_line, *of_design]))
    if not named and "file" not in case.table("catalogue"):
        return found
    catalogue = _catalogue(found, case, folder)
    if catalogue is None:
        return found
    for path, name in named:
        _resolve(found, catalogue, path, name)
    if found.names and len(found.names) == len(named):
        for problem in catalogue.variants_of_none(found.names.values()):
            if problem.key in entries(VariantsTable):
                path = ("catalogue", "variants", problem.key)
                found.findings.append(Finding(path, problem.found, problem.allowed))
    for segment in of_line:
        name = found.names.get((*segment.path, "component"), "")
        for component in _looked_up(found, catalogue, segment, "diameter", name):
            found.segments[segment.path] = component
    for segment in of_design:
        _sizes(found, catalogue, segment)
    return found


def _named(segments: list[FileSection]) -> Iterator[tuple[Path, str]]:
    """List the names of components with their places."""
    for segment in segments:
        name = segment.value("component")
        if name is not None:
            yield (*segment.path, "component"), name
        if "components" in entries(segment.schema):
            for index, family in enumerate(segment.value("components") or []):
                yield (*segment.path, "components", index), family


def _catalogue(found: FromCatalogue, case: FileSection, folder: str) -> ChosenCatalogue | None:
    """Read the catalogue; None, and findings if they are new, when the choice is faulty."""
    from catopt.catalogue.choice import chosen

    given = dict(case.table("catalogue").given)
    if not isinstance(given.get("file", ""), str):
        return None
    variants = case.table("catalogue").table("variants").given
    given["variants"] = {key: name for key, name in variants.items() if isinstance(name, str)}
    water = case.table("site").number("water_density")
    try:
        return chosen(catalogue_choice(given, folder), water or SEA_WATER_DENSITY)
    except InputError as error:
        from catopt.catalogue.reading import KIND

        shown = as_written(given.get("file"))
        for problem in error.problems:
            inside = Message("refused.in_it", problem=problem_words(problem))
            allowed = problem.allowed if problem.key == KIND else inside  # the former: unread
            found.findings.append(Finding(("catalogue", "file"), shown, allowed))
    return None


def _resolve(found: FromCatalogue, catalogue: ChosenCatalogue, path: Path, name: str) -> None:
    """Note what a name stands for, or that it stands for nothing."""
    families = catalogue.families
    try:
        parsed = families.parse_name(name)
    except InputError as error:
        found.findings += [Finding(path, p.found, _or_own(path, p.allowed)) for p in error.problems]
        return
    grades = families.family(parsed.family).grades
    if grades and parsed.grade is None:
        example = f'"{parsed.family} {grades[0]}"'
        allowed = Message("refused.grade_missing", grades=", ".join(grades), example=example)
        found.findings.append(Finding(path, as_written(name), allowed))
        return
    full = " ".join(part for part in parsed if part)
    beside = [p for p, other in found.names.items() if other == full and p[:-1] == path[:-1]]
    if beside and isinstance(path[-1], int):
        allowed = Message("refused.stands_already")
        found.findings.append(Finding(path, as_written(name), allowed))
    else:
        found.names[path] = full


def _looked_up(
    found: FromCatalogue, catalogue: ChosenCatalogue, segment: FileSection, key: str, name: str
) -> list[Component]:
    """Look a component up in the sizes that a key has; what is not made is a finding there."""
    sizes = segment.value(key) if name else None
    places: list[tuple[Path, float, object]] = []
    if isinstance(sizes, list):
        written = segment.given[key]
        places = [((*segment.path, key, k), size, written[k]) for k, size in enumerate(sizes)]
    elif sizes is not None:
        places = [((*segment.path, key), sizes, segment.given[key])]
    made = []
    for path, size, shown in places:
        try:
            made.append(catalogue.component(name, size))
        except InputError as error:
            found.findings += _refusals(error, path, name, as_written(shown))
    return made


def _refusals(error: InputError, path: Path, name: str, shown: str) -> Iterator[Finding]:
    """Place the catalogue's problems with a component: at its diameter, or at the variant."""
    for problem in error.problems:
        quantity = problem.key.removeprefix("variants.")
        if quantity != problem.key:
            yield Finding(("catalogue", "variants", quantity), problem.found, problem.allowed)
        else:
            allowed = problem.allowed
            if quantity != "diameter":
                values = {"quantity": quantity, "name": name}
                allowed = Message("refused.of_component", allowed=allowed, **values)
            yield Finding(path, shown, _or_own(path, allowed))


def _or_own(path: Path, allowed: str) -> str:
    """Add that a line may do without the catalogue; not to a slip, and a design may not."""
    if path[0] not in ("line", "lines") or allowed.endswith("?"):
        return allowed
    return Message("refused.own_figures", said=allowed)


def _sizes(found: FromCatalogue, catalogue: ChosenCatalogue, segment: FileSection) -> None:
    """Check that what a segment of a design may be made of is made in the sizes that are asked."""
    names = [name for place, name in found.names.items() if place[:3] == segment.path]
    own = ("line", *segment.path[1:], "component")
    if not names and own in found.names and any(key in segment for key in SIZES):
        names = [found.names[own]]
    for name in names:
        _looked_up(found, catalogue, segment, "diameters", name)
        _looked_up(found, catalogue, segment, "diameter", name)
        if not ("diameter" in segment or "diameters" in segment):
            _sold(found, catalogue, segment, name)


def _sold(
    found: FromCatalogue, catalogue: ChosenCatalogue, segment: FileSection, name: str
) -> None:
    """Check that a component is sold in a size between the bounds, if there are any."""
    low, high = segment.number("diameter_min"), segment.number("diameter_max")
    if low is not None and high is not None and high < low:
        return  # reported already
    try:
        sizes = [component.nominal_diameter for component in catalogue.sold(name)]
    except InputError as error:
        found.findings += _refusals(error, segment.path, name, "")
        return
    if not sizes:
        found.findings.append(segment.missing("diameters", Message("refused.no_sizes", name=name)))
    elif not any((low or 0.0) <= size <= (high or size) for size in sizes):
        key = "diameter_min" if low is not None else "diameter_max"
        one_end = low is None or high is None
        said = Message(
            "refused.sold" if one_end else "refused.none_between",
            name=name,
            least=sizes[0] * 1e3,
            most=sizes[-1] * 1e3,
        )
        found.findings.append(segment.wrong(key, said))


def build_case(table: CaseTable, catalogue: FromCatalogue, folder: str) -> Case:
    """Build a case, whose parts go as far beyond their ranges as the file accepts."""
    with accepting(table.accept or ()):
        return _built(table, catalogue, folder)


def _built(table: CaseTable, catalogue: FromCatalogue, folder: str) -> Case:
    place = table.given().get("site")
    site = Site.in_air() if place is None else Site(**place.given())
    build = _Builder(catalogue, FilePath(folder).absolute(), site, table)
    line = Line(
        [build.part(part, ("line", "segments", k)) for k, part in enumerate(table.line.segments)],
        [build.part(load) for load in table.line.point_loads or ()],
    )
    heights = {
        "fairlead_height": _or_else(table.line.fairlead_height, site.water_depth),
        "anchor_height": _or_else(table.line.anchor_height, 0.0),
    }
    if lift := site.contact_offset:  # a bed higher by it; an end on the bed stays on it
        site = replace(site, water_depth=site.water_depth - lift)
        heights = {key: height - lift if height else 0.0 for key, height in heights.items()}
    given = {
        {"pso": "swarm"}.get(key, key): build.value(value, (key,))
        for key, value in table.given().items()
        if key not in ("site", "line", "system", "catalogue")
    }
    if table.catalogue:
        given["catalogue"] = catalogue_choice(build.given(table.catalogue), folder)
    if table.system:
        around = {"seabed_friction": site.seabed_friction, **heights, **table.system.given()}
        given["system"] = System.around(line, **around)
    return Case(**{"load": None, **heights, **given, "site": site, "line": line})


def network_parts(
    table: NetworkTable, catalogue: FromCatalogue, site: Site, folder: str
) -> dict[str, Any]:
    """Build what a file has beside its points, lines and bodies."""
    build = _Builder(catalogue, FilePath(folder).absolute(), site)
    given = table.given()
    keys = (
        *("document", "waves", "current", "motion", "dynamics", "checks", "service", "anchor"),
        *("fatigue", "design"),
    )
    found = {key: build.part(given[key], (key,)) for key in keys if key in given}
    found["accept"] = tuple(given.get("accept") or ())
    if table.catalogue:
        found["catalogue"] = catalogue_choice(build.given(table.catalogue), folder)
    return found


def title_block(table: TableSchema, folder: str) -> TitleBlock:
    """Build ``[document]`` of a file of a sizing; the path of its logo counts from the folder."""
    given = table.given()
    revisions = tuple(Revision(**revision.given()) for revision in given.pop("revisions", ()))
    if "logo" in given:
        given["logo"] = str(FilePath(folder).absolute() / given["logo"])
    return TitleBlock(**given, revisions=revisions)


@dataclass(frozen=True)
class _Builder:
    """Makes parts of the model out of tables, with what they take from elsewhere."""

    catalogue: FromCatalogue
    folder: FilePath
    site: Site
    case: CaseTable | None = None

    def value(self, value: Any, path: Path) -> Any:
        """Return a value as the model has it: a table as its part, an array as a tuple."""
        if isinstance(value, list):
            return tuple(self.value(item, (*path, k)) for k, item in enumerate(value))
        return self.part(value, path) if isinstance(value, TableSchema) else value

    def given(self, table: TableSchema, path: Path = ()) -> dict[str, Any]:
        """Return what a table gives, as the model has it; paths of files count from the folder."""
        given = {key: self.value(value, (*path, key)) for key, value in table.given().items()}
        for key in given:
            if isinstance(entries(type(table))[key].kind, File):
                given[key] = str(self.folder / given[key])
        for values in table.choices:
            own = {key: given.pop(key) for key in values.keys if key in given}
            given[values.many] = values_of(values, own)
        return given

    def part(self, table: TableSchema, path: Path = ()) -> Any:
        """Build what a table holds; of variants of figures, a mapping."""
        if isinstance(table, SegmentTable):
            component = self.catalogue.segments.get(path)
            return made_segment(table, component, in_air=self.site.is_in_air)
        given = self.given(table, path)
        if isinstance(table, SegmentChoiceTable):
            # What is left out is as the line has it at the same place.
            own: Path = ("line", "segments", path[-1])
            names = self.catalogue.names
            if not given["lengths"]:
                assert self.case is not None
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
            assert table.model is not None
            return table.model(**given, components=components, diameters=diameters)
        if isinstance(table, FatigueSeaStateTable):
            given["share"] = share_of_year(given) or 0.0
            given.pop("time_per_year", None)
        return made_of(table, given, self.site)


def made_of(table: TableSchema, given: dict[str, Any], site: Site) -> Any:
    """Make the part of the model of what a table gives; of variants of figures, a mapping."""
    if table.model is Checks and "code" in given:
        given["codes"] = (given.pop("code"),)
    if {"density", "volume"} & set(given) and not table.choices:
        # Put the weight in water in the place of a body's density or volume.
        density, volume = given.pop("density", None), given.pop("volume", None)
        if volume is not None:
            weight = (given["mass"] - site.water_density * volume) * STANDARD_GRAVITY
        else:
            weight = weight_in_water(given["mass"], density, site.water_density)
        given = given | {"submerged_weight": weight}
    return given if table.model is None else table.model(**given)


def made_segment(table: TableSchema, component: Component | None, *, in_air: bool = False) -> Any:
    """Build a segment; what the file gives goes before what the catalogue has.

    In air nothing is taken off the weight of a component.
    """
    given = table.given()
    given.pop("component", None)
    if "diameter" in given:
        given["nominal_diameter"] = given.pop("diameter")
    if given.pop("drag_axial_area", "D") == "pi D":
        given["drag_axial"] *= math.pi
    made = component.segment(1.0) if component else None
    figures = {part.name: getattr(made, part.name) for part in fields(made)} if made else {}
    if made is not None and in_air and made.mass is not None:
        figures["submerged_weight"] = made.mass * STANDARD_GRAVITY
    if "strain" in given:
        given["EA"] = StrainTable(given.pop("strain"), given.pop("strain_tension"))
    if given.get("drag_method") == "roughness":
        figures |= dict.fromkeys(("drag_normal", "drag_axial", "added_mass_normal"))
    return Segment(**figures | given)


def _or_else(value: float | None, default: float) -> float:
    return default if value is None else value
