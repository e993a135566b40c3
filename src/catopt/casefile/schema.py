"""Every section and key of a case file.

The keys of a table carry the names of the model's attributes, and their defaults are the model's:
a key that may be left out is None here, and the model is then built without it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, get_args

from pydantic import BaseModel, ConfigDict, Field

from catopt.casefile.fields import Kind, Measured, OneOf, Text, Whole
from catopt.model.case import BOUNDARY_HANDLINGS
from catopt.model.find import FIND_QUANTITIES
from catopt.units import Dimension

__all__ = [
    "CaseTable",
    "ChecksTable",
    "Entry",
    "FindTable",
    "LineTable",
    "LoadTable",
    "PointLoadTable",
    "PsoTable",
    "SegmentTable",
    "SiteTable",
    "Table",
    "entries",
]


class Table(BaseModel):
    """A table of a case file: no other keys than its own.

    Every value is checked by its `Kind`, which converts nothing but units.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)

    later: ClassVar[Mapping[str, str]] = {}
    """Keys that belong to a later version, each with the required key it would stand for."""

    symbols: ClassVar[Mapping[str, str]] = {}
    """The field's symbols for some keys, so that a user who writes one is told the key."""

    def given(self) -> dict[str, Any]:
        """Return what the file gives, by key."""
        return {key: getattr(self, key) for key in self.model_fields_set}


class SiteTable(Table):
    """Water and seabed."""

    symbols: ClassVar[Mapping[str, str]] = {
        "d": "water_depth",
        "mu": "seabed_friction",
        "rho": "water_density",
    }

    water_depth: Annotated[float, Measured(Dimension.LENGTH, above=0.0)]
    seabed_friction: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0)] | None = None
    water_density: Annotated[float, Measured(Dimension.DENSITY, above=0.0)] | None = None


class SegmentTable(Table):
    """A uniform stretch of the line."""

    later: ClassVar[Mapping[str, str]] = {"component": "submerged_weight", "diameter": ""}
    symbols: ClassVar[Mapping[str, str]] = {"L": "length", "w": "submerged_weight", "m": "mass"}

    name: Annotated[str, Text()] | None = None
    length: Annotated[float, Measured(Dimension.LENGTH, above=0.0)]
    submerged_weight: Annotated[float, Measured(Dimension.FORCE_PER_LENGTH)]
    mass: Annotated[float, Measured(Dimension.MASS_PER_LENGTH, at_least=0.0)] | None = None
    EA: Annotated[float, Measured(Dimension.FORCE, above=0.0)] | None = None
    MBL: Annotated[float, Measured(Dimension.FORCE, above=0.0)] | None = None


class PointLoadTable(Table):
    """A clump weight (sinker) or a buoy on the line."""

    symbols: ClassVar[Mapping[str, str]] = {"s": "position", "W": "submerged_weight", "m": "mass"}

    name: Annotated[str, Text()] | None = None
    position: Annotated[float, Measured(Dimension.LENGTH, above=0.0)]
    submerged_weight: Annotated[float, Measured(Dimension.FORCE)] | None = None
    mass: Annotated[float, Measured(Dimension.MASS, at_least=0.0)] | None = None
    density: Annotated[float, Measured(Dimension.DENSITY, above=0.0)] | None = None


class LineTable(Table):
    """The mooring line."""

    fairlead_height: Annotated[float, Measured(Dimension.LENGTH, at_least=0.0)] | None = None
    anchor_height: Annotated[float, Measured(Dimension.LENGTH, at_least=0.0)] | None = None
    segments: Annotated[list[SegmentTable], Field(min_length=1)]
    point_loads: list[PointLoadTable] = []


class LoadTable(Table):
    """The one known quantity at the fairlead."""

    later: ClassVar[Mapping[str, str]] = {"code": ""}
    symbols: ClassVar[Mapping[str, str]] = {
        "H": "horizontal_force",
        "S": "span",
        "T": "fairlead_tension",
    }

    horizontal_force: Annotated[float, Measured(Dimension.FORCE, above=0.0)] | None = None
    span: Annotated[float, Measured(Dimension.LENGTH, above=0.0)] | None = None
    fairlead_tension: Annotated[float, Measured(Dimension.FORCE, above=0.0)] | None = None


class FindTable(Table):
    """What is sought, in place of how the line hangs."""

    symbols: ClassVar[Mapping[str, str]] = {"theta0": "anchor_angle"}

    quantity: Annotated[str, OneOf(FIND_QUANTITIES)]
    segment: Annotated[int, Whole(at_least=1, example=1)] | None = None
    point_load: Annotated[int, Whole(at_least=1, example=1)] | None = None
    anchor_angle: (
        Annotated[float, Measured(Dimension.ANGLE, at_least=0.0, at_most=math.pi / 2.0)] | None
    ) = None
    grounded_length: Annotated[float, Measured(Dimension.LENGTH, above=0.0)] | None = None


class ChecksTable(Table):
    """Limits a design has to keep."""

    later: ClassVar[Mapping[str, str]] = {"code": ""}

    safety_factor: Annotated[float, Measured(Dimension.NUMBER, at_least=1.0)] | None = None
    max_anchor_uplift_angle: (
        Annotated[float, Measured(Dimension.ANGLE, at_least=0.0, at_most=math.pi / 2.0)] | None
    ) = None


class PsoTable(Table):
    """Settings of the particle swarm."""

    symbols: ClassVar[Mapping[str, str]] = {"c1": "cognitive", "c2": "social", "w": "inertia"}

    particles: Annotated[int, Whole(at_least=2, example=200)] | None = None
    iterations: Annotated[int, Whole(at_least=1, example=200)] | None = None
    runs: Annotated[int, Whole(at_least=1, example=200)] | None = None
    seed: Annotated[int, Whole(at_least=0, example=1)] | None = None
    cognitive: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=4.0)] | None = None
    social: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=4.0)] | None = None
    inertia: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=1.0)] | None = None
    boundary: Annotated[str, OneOf(BOUNDARY_HANDLINGS)] | None = None


class CaseTable(Table):
    """A whole case file."""

    later: ClassVar[Mapping[str, str]] = {
        "system": "load",
        "design": "",
        "waves": "",
        "current": "",
        "dynamics": "",
        "verify": "",
        "environment": "",
    }

    title: Annotated[str, Text()] | None = None
    source: Annotated[str, Text()] | None = None
    site: SiteTable
    line: LineTable
    load: LoadTable | None = None
    find: FindTable | None = None
    checks: ChecksTable | None = None
    pso: PsoTable | None = None


@dataclass(frozen=True)
class Entry:
    """What a key of a table holds.

    Attributes
    ----------
    kind : Kind or None
        For a single value.
    table : type of Table or None
        For a table or an array of tables.
    array : bool
        Whether it is an array of tables.
    required : bool
        Whether it has to be there.
    """

    kind: Kind | None
    table: type[Table] | None
    array: bool
    required: bool


def entries(table: type[Table]) -> dict[str, Entry]:
    """List the keys of a table, in order, with what each holds."""
    listed = {}
    for key, field in table.model_fields.items():
        parts = [*field.metadata, *_parts(field.annotation)]
        kind = next((part for part in parts if isinstance(part, Kind)), None)
        inner = next((p for p in parts if isinstance(p, type) and issubclass(p, Table)), None)
        listed[key] = Entry(kind, inner, list in parts, field.is_required())
    return listed


def _parts(annotation: Any) -> list[Any]:
    """Take an annotation apart: ``Annotated[float, k] | None`` gives ``float``, ``k`` and None."""
    origin = getattr(annotation, "__origin__", None)
    parts = [annotation] if origin is None else [origin]
    for inner in (*get_args(annotation), *getattr(annotation, "__metadata__", ())):
        parts += _parts(inner)
    return parts
