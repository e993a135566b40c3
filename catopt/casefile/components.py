"""What a case file takes from the catalogue, which is read only if it takes something."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from catopt.casefile.document import number, table, tables, text, value
from catopt.casefile.location import Finding
from catopt.casefile.schema import (
    SegmentChoiceTable,
    SegmentTable,
    SiteTable,
    VariantsTable,
    entries,
)
from catopt.constants import SEA_WATER_DENSITY
from catopt.documents import Path
from catopt.errors import InputError
from catopt.model import CatalogueChoice
from catopt.units import as_written

if TYPE_CHECKING:
    from catopt.catalogue import Component
    from catopt.catalogue.choice import ChosenCatalogue

SIZES = ("diameters", "diameter", "diameter_min", "diameter_max")
"""Keys that limit the sizes of a segment's components."""


@dataclass
class FromCatalogue:
    """What was found in the catalogue, and what was not.

    Attributes
    ----------
    findings : list of Finding
        Names, diameters and variants that it has not got.
    segments : dict of Path to Component
        Components of the line's segments, by the segment's path.
    names : dict of Path to str
        Families with their grades, as the catalogue writes them, by the path of what the file has.
    """

    findings: list[Finding] = field(default_factory=list)
    segments: dict[Path, Component] = field(default_factory=dict)
    names: dict[Path, str] = field(default_factory=dict)


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


def from_catalogue(document: dict[str, Any], folder: str) -> FromCatalogue:
    """Look up every component that a document names."""
    found = FromCatalogue()
    given = table(document, "catalogue")
    named = list(_named(document))
    if not named and "file" not in given:
        return found
    catalogue = _catalogue(found, document, folder)
    if catalogue is None:
        return found
    for path, name in named:
        _resolve(found, catalogue, path, name)
    if len(found.names) == len(named):
        _check_variants(found, catalogue)
    for path, segment in tables(table(document, "line"), "line", "segments"):
        _segment(found, catalogue, path, segment)
    for path, segment in tables(table(document, "design"), "design", "segments"):
        _sizes(found, catalogue, path, segment)
    return found


def _named(document: dict[str, Any]) -> Iterator[tuple[Path, str]]:
    """List the names of components with their places."""
    for path, segment in tables(table(document, "line"), "line", "segments"):
        name = text(SegmentTable, "component", segment)
        if name is not None:
            yield (*path, "component"), name
    for path, segment in tables(table(document, "design"), "design", "segments"):
        name = text(SegmentChoiceTable, "component", segment)
        if name is not None:
            yield (*path, "component"), name
        for index, each in enumerate(value(SegmentChoiceTable, "components", segment) or []):
            yield (*path, "components", index), each


def _catalogue(
    found: FromCatalogue, document: dict[str, Any], folder: str
) -> ChosenCatalogue | None:
    """Read the catalogue; None, and findings if they are new, when the choice is faulty."""
    from catopt.catalogue.choice import chosen

    given = dict(table(document, "catalogue"))
    if not isinstance(given.get("file", ""), str):
        return None
    variants = table(given, "variants")
    given["variants"] = {key: name for key, name in variants.items() if isinstance(name, str)}
    site = table(document, "site")
    water = number(SiteTable, "water_density", site)
    try:
        return chosen(catalogue_choice(given, folder), water or SEA_WATER_DENSITY)
    except InputError as error:
        path = ("catalogue", "file")
        shown = as_written(given.get("file"))
        for problem in error.problems:
            found.findings.append(Finding(path, shown, _inside(problem.key, str(problem))))
    return None


def _inside(key: str, problem: str) -> str:
    """Say what is wrong inside the file of families."""
    from catopt.catalogue.reading import KIND

    unread = key == KIND
    return problem.removeprefix(f"{key}: ") if unread else f"in it, {problem}"


def _resolve(found: FromCatalogue, catalogue: ChosenCatalogue, path: Path, name: str) -> None:
    """Note what a name stands for, or that it stands for nothing."""
    families = catalogue.families
    try:
        parsed = families.parse_name(name)
    except InputError as error:
        found.findings += [Finding(path, p.found, p.allowed) for p in error.problems]
        return
    grades = families.family(parsed.family).grades
    if grades and parsed.grade is None:
        example = f'"{parsed.family} {grades[0]}"'
        allowed = f"the grade is missing: one of {', '.join(grades)}, such as {example}"
        found.findings.append(Finding(path, as_written(name), allowed))
        return
    full = " ".join(part for part in parsed if part)
    beside = [p for p, other in found.names.items() if other == full and p[:-1] == path[:-1]]
    if beside and isinstance(path[-1], int):
        allowed = "stands there already; leave it out"
        found.findings.append(Finding(path, as_written(name), allowed))
        return
    found.names[path] = full


def _check_variants(found: FromCatalogue, catalogue: ChosenCatalogue) -> None:
    """Note variants that none of the components has."""
    if not found.names:
        return
    for problem in catalogue.variants_of_none(found.names.values()):
        if problem.key in entries(VariantsTable):
            path = ("catalogue", "variants", problem.key)
            found.findings.append(Finding(path, problem.found, problem.allowed))


def _segment(
    found: FromCatalogue, catalogue: ChosenCatalogue, path: Path, segment: dict[str, Any]
) -> None:
    """Look up the component of a segment of the line."""
    name = found.names.get((*path, "component"))
    diameter = number(SegmentTable, "diameter", segment)
    if name is None or diameter is None:
        return
    shown = as_written(segment["diameter"])
    component = _look_up(found, catalogue, (*path, "diameter"), name, diameter, shown)
    if component is not None:
        found.segments[path] = component


def _look_up(
    found: FromCatalogue,
    catalogue: ChosenCatalogue,
    path: Path,
    name: str,
    diameter: float,
    shown: str,
) -> Component | None:
    """Look a component up; None, with a finding at the diameter's path, where it is not made."""
    try:
        return catalogue.component(name, diameter)
    except InputError as error:
        found.findings += _refusals(error, path, name, shown)
    return None


def _refusals(error: InputError, path: Path, name: str, shown: str) -> Iterator[Finding]:
    """Place the catalogue's problems with a component: at its diameter, or at the variant."""
    for problem in error.problems:
        quantity = problem.key.removeprefix("variants.")
        if quantity != problem.key:
            yield Finding(("catalogue", "variants", quantity), problem.found, problem.allowed)
        else:
            what = "" if quantity == "diameter" else f"{quantity} of {name} is "
            yield Finding(path, shown, what + problem.allowed)


def _sizes(
    found: FromCatalogue, catalogue: ChosenCatalogue, path: Path, segment: dict[str, Any]
) -> None:
    """Check that what a segment of a design may be made of is made in the sizes that are asked."""
    names = [name for place, name in found.names.items() if place[:3] == path]
    own = ("line", *path[1:], "component")
    if not names and own in found.names and any(key in segment for key in SIZES):
        names = [found.names[own]]
    listed = value(SegmentChoiceTable, "diameters", segment) or []
    places: list[tuple[Path, float, object]] = [
        ((*path, "diameters", index), each, segment["diameters"][index])
        for index, each in enumerate(listed)
    ]
    single = number(SegmentChoiceTable, "diameter", segment)
    if single is not None:
        places.append(((*path, "diameter"), single, segment["diameter"]))
    for name in names:
        for place, diameter, written in places:
            _look_up(found, catalogue, place, name, diameter, as_written(written))
        if not ("diameter" in segment or "diameters" in segment):
            _sold(found, catalogue, path, segment, name)


def _sold(
    found: FromCatalogue,
    catalogue: ChosenCatalogue,
    path: Path,
    segment: dict[str, Any],
    name: str,
) -> None:
    """Check that a component is sold in a size between the bounds, if there are any."""
    low = number(SegmentChoiceTable, "diameter_min", segment)
    high = number(SegmentChoiceTable, "diameter_max", segment)
    if low is not None and high is not None and high < low:
        return  # reported already
    try:
        sizes = [component.nominal_diameter for component in catalogue.sold(name)]
    except InputError as error:
        found.findings += _refusals(error, path, name, "")
        return
    if not sizes:
        allowed = f"missing; no list of sizes of {name} is known"
        found.findings.append(Finding((*path, "diameters"), "", allowed))
    elif not any((low or 0.0) <= size <= (high or size) for size in sizes):
        key = "diameter_min" if low is not None else "diameter_max"
        sold = f"{name} is sold from {sizes[0] * 1e3:g} mm to {sizes[-1] * 1e3:g} mm"
        between = "" if low is None or high is None else ", with no size between the two bounds"
        found.findings.append(Finding((*path, key), as_written(segment[key]), sold + between))
