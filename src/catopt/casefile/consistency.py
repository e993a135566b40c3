"""What must hold between the keys of a case file.

These checks read the document itself and pass over what is missing or unreadable, so that they
find their mistakes beside those of the single keys, not after them.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Any

from catopt.casefile.location import Finding, Path
from catopt.casefile.names import nearest
from catopt.casefile.schema import (
    LoadTable,
    PointLoadTable,
    SegmentTable,
    Table,
    entries,
)
from catopt.errors import InputError
from catopt.model import Load
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
        *(f for path, load in _array(line, "point_loads") for f in _weight(path, load)),
        *_positions(line),
    ]


def _load(document: dict[str, Any]) -> Iterator[Finding]:
    """Find any but exactly one known quantity at the fairlead, as the model has it."""
    load = document.get("load")
    if not isinstance(load, dict):
        return
    known = [key for key in entries(LoadTable) if key in load]
    if not known and _misspelt(LoadTable, entries(LoadTable), load):
        return
    try:
        Load(**dict.fromkeys(known, 1.0))
    except InputError as error:
        for problem in error.problems:
            yield Finding(("load",), problem.found, problem.allowed)


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
    """Whether one of the keys is there but misspelt, which is reported already."""
    unknown = [key for key in table if key not in entries(schema)]
    return any(nearest(schema, key) in keys for key in unknown)


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
