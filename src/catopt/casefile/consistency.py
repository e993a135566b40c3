"""What must hold between the keys of a case file.

These checks read the document itself and pass over what is missing or unreadable, so that they
find their mistakes beside those of the single keys, not after them.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Any

from catopt.casefile.location import Finding, Path, parts
from catopt.casefile.names import stands_for
from catopt.casefile.schema import (
    CaseTable,
    FindTable,
    LineTable,
    LoadTable,
    PointLoadTable,
    SegmentTable,
    Table,
    entries,
)
from catopt.errors import InputError
from catopt.model import Find, Load
from catopt.model.find import FIND_QUANTITIES, FORCES, misfits
from catopt.units import as_written

__all__ = ["consistency_findings"]


def consistency_findings(document: dict[str, Any]) -> list[Finding]:
    """List what contradicts itself in a document.

    Parameters
    ----------
    document : dict
        As the TOML reader returns it.
    """
    line = _table(document, "line")
    return [
        *_load(document),
        *_find(document),
        *_misfits(document, line),
        *(f for path, load in _array(line, "point_loads") for f in _weight(path, load)),
        *_positions(line),
    ]


def _load(document: dict[str, Any]) -> Iterator[Finding]:
    """Find any but exactly one known quantity at the fairlead, as the model has it."""
    load, sought = document.get("load"), _sought(document)
    if not isinstance(load, dict) or (sought is not None and sought.seeks_force):
        return
    known = [key for key in entries(LoadTable) if key in load]
    if not known and _misspelt(LoadTable, entries(LoadTable), load):
        return
    try:
        Load(**dict.fromkeys(known, 1.0))
    except InputError as error:
        for problem in error.problems:
            yield Finding(("load",), problem.found, problem.allowed)


def _find(document: dict[str, Any]) -> Iterator[Finding]:
    """Find conditions too few or too many, and keys that go with another quantity."""
    find = _table(document, "find")
    if _sought(document) is None or _misspelt(FindTable, entries(FindTable), find):
        return
    given: dict[str, Any] = {key: 1 for key in entries(FindTable) if key in find}
    try:
        Find(**given | {"quantity": find["quantity"]})
    except InputError as error:
        for problem in error.problems:
            path = ("find", problem.key) if problem.key in find else ("find",)
            yield _as_written(document, Finding(path, problem.found, problem.allowed))


def _misfits(document: dict[str, Any], line: dict[str, Any]) -> Iterator[Finding]:
    """Find what does not fit between what is sought, the load and the line, as the model has it."""
    sought, load = _sought(document), document.get("load")
    if sought is None and ("find" in document or _misspelt(CaseTable, ["find"], document)):
        return
    segments, loads = _array(line, "segments"), _array(line, "point_loads")
    problems = misfits(
        sought,
        load=None if load is None else list(_table(document, "load")),
        MBL_known=["MBL" in s or _misspelt(SegmentTable, ["MBL"], s) for _, s in segments],
        point_loads=len(loads),
        anchor_height=_number(LineTable, "anchor_height", line) or 0.0,
    )
    unsure = _misspelt(LineTable, entries(LineTable), line) or ("point_loads" in line and not loads)
    for problem in problems:
        about_load = problem.key.startswith("load")
        if about_load and load is None and _misspelt(CaseTable, ["load"], document):
            continue
        if about_load or (segments and not unsure):
            finding = Finding(parts(problem.key), problem.found, problem.allowed)
            yield _as_written(document, finding)


def _sought(document: dict[str, Any]) -> Find | None:
    """Return what is sought, with a condition that fits; None when nothing is or it is unclear."""
    find = _table(document, "find")
    quantity: Any = find.get("quantity")
    if quantity not in FIND_QUANTITIES:
        return None
    sought = Find(quantity, anchor_angle=None if quantity in FORCES else 0.0)
    with suppress(InputError):  # wrong in itself, or goes with another quantity
        sought = replace(sought, segment=find.get("segment"))
    with suppress(InputError):
        sought = replace(sought, point_load=find.get("point_load"))
    return sought


def _as_written(document: dict[str, Any], finding: Finding) -> Finding:
    """Show what the file has at the place of a finding, where that is a single value."""
    place: Any = document
    for part in finding.path:
        inside = part in place if isinstance(place, dict) else isinstance(part, int)
        place = place[part] if inside else None
    if place is None or isinstance(place, dict):
        return finding
    return finding._replace(found=as_written(place))


def _weight(path: Path, load: dict[str, Any]) -> Iterator[Finding]:
    """Find a point load whose weight is not given, or given both itself and by its density."""
    keys = ("submerged_weight", "mass", "density")
    if _misspelt(PointLoadTable, keys, load):
        return
    weight, mass, density = (key in load for key in keys)
    wanted = "submerged_weight, or mass with density, is wanted"
    if density and not mass:
        found = as_written(load["density"])
        yield Finding((*path, "density"), found, "density goes with mass, which is missing")
    elif weight and density:
        found = "submerged_weight, mass and density"
        yield Finding(path, found, "leave out submerged_weight or density")
    elif mass and not weight and not density:
        yield Finding(path, "mass without density", wanted)
    elif not weight and not mass:
        yield Finding((*path, "submerged_weight"), "", f"missing; {wanted}")


def _positions(line: dict[str, Any]) -> Iterator[Finding]:
    """Find point loads beyond the end of the line."""
    lengths = [_number(SegmentTable, "length", s) for _, s in _array(line, "segments")]
    known = [length for length in lengths if length is not None]
    if not known or len(known) < len(lengths):
        return
    total = math.fsum(known)
    for path, load in _array(line, "point_loads"):
        position = _number(PointLoadTable, "position", load)
        if position is not None and not position < total:
            found = as_written(load["position"])
            yield Finding(
                (*path, "position"), found, f"must be below {total:g} m, the length of the line"
            )


def _misspelt(schema: type[Table], keys: Collection[str], table: dict[str, Any]) -> bool:
    """Whether one of the keys is there under another name, which is reported already."""
    unknown = [key for key in table if key not in entries(schema)]
    return any(stands_for(schema, key) in keys for key in unknown)


def _table(document: dict[str, Any], key: str) -> dict[str, Any]:
    table = document.get(key)
    return table if isinstance(table, dict) else {}


def _array(line: dict[str, Any], key: str) -> list[tuple[Path, dict[str, Any]]]:
    """Tables of an array of ``[line]``, each with its path; empty when one of them is no table."""
    array = line.get(key)
    if not isinstance(array, list) or not all(isinstance(table, dict) for table in array):
        return []
    return [(("line", key, index), table) for index, table in enumerate(array)]


def _number(schema: type[Table], key: str, table: dict[str, Any]) -> float | None:
    """Return a value in SI; None when it is missing or wrong in itself."""
    kind = entries(schema)[key].kind
    if kind is None or key not in table:
        return None
    try:
        value = kind.read(table[key])
    except InputError:
        return None
    return value if isinstance(value, float) else None
