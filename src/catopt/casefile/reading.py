"""From a case file to a Case."""

from __future__ import annotations

import os
from pathlib import Path

from pydantic import ValidationError

from catopt.casefile.consistency import consistency_findings
from catopt.casefile.location import Finding, in_order_of
from catopt.casefile.schema import CaseTable, LineTable, PointLoadTable, SegmentTable, SiteTable
from catopt.casefile.structure import structure_findings
from catopt.casefile.syntax import parse_toml, read_text
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError
from catopt.model import Case, Checks, Find, Line, Load, PointLoad, Segment, Site, SwarmSettings

__all__ = ["parse_case", "read_case"]


def read_case(path: str | os.PathLike[str]) -> Case:
    """Read a case file.

    Parameters
    ----------
    path : str or path
        The file, TOML in UTF-8.

    Returns
    -------
    Case
        In SI.

    Raises
    ------
    InputError
        When the file cannot be read, or with every problem of what it says.
    """
    source = os.fspath(path)
    return parse_case(read_text(Path(path), source), source)


def parse_case(text: str, source: str = "") -> Case:
    """Read the text of a case file.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        Name of the file, for messages.

    Returns
    -------
    Case
        In SI.

    Raises
    ------
    InputError
        With every problem of the text, in its order.
    """
    document = parse_toml(text, source)
    findings: list[Finding] = []
    table: CaseTable | None = None
    try:
        table = CaseTable.model_validate(document)
    except ValidationError as error:
        findings += structure_findings(error.errors(include_url=False))
    findings += consistency_findings(document)
    if table is None or findings:
        problems = [finding.as_problem() for finding in in_order_of(document, findings)]
        raise InputError(problems, source)
    return _case(table)


def _case(table: CaseTable) -> Case:
    site = _site(table.site)
    return Case(
        site=site,
        line=_line(table.line, site),
        load=Load(**table.load.given()) if table.load else None,
        fairlead_height=_or_else(table.line.fairlead_height, site.water_depth),
        anchor_height=_or_else(table.line.anchor_height, 0.0),
        checks=Checks(**table.checks.given()) if table.checks else Checks(),
        swarm=SwarmSettings(**table.pso.given()) if table.pso else SwarmSettings(),
        title=table.title or "",
        source=table.source or "",
        find=Find(**table.find.given()) if table.find else None,
    )


def _site(table: SiteTable) -> Site:
    return Site(**table.given())


def _line(table: LineTable, site: Site) -> Line:
    segments = [_segment(segment) for segment in table.segments]
    return Line(segments, [_point_load(load, site.water_density) for load in table.point_loads])


def _segment(table: SegmentTable) -> Segment:
    return Segment(**table.given())


def _point_load(table: PointLoadTable, water_density: float) -> PointLoad:
    given = table.given()
    density = given.pop("density", None)
    if density is not None:
        given["submerged_weight"] = _weight_in_water(given["mass"], density, water_density)
    return PointLoad(**given)


def _weight_in_water(mass: float, density: float, water_density: float) -> float:
    """Submerged weight of a solid body.

    Parameters
    ----------
    mass : float
        In air, kg.
    density, water_density : float
        Of the body and of the water, kg/m3.

    Returns
    -------
    float
        N; negative when the body floats. S2, equation (24), with W = m g0.
    """
    return mass * STANDARD_GRAVITY * (1.0 - water_density / density)


def _or_else(value: float | None, default: float) -> float:
    return default if value is None else value
