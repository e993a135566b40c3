"""From a Case to a case file: each part of the model under the keys of its table."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from hashlib import sha256
from typing import Any, Final

from catopt.casefile.fields import Measured
from catopt.casefile.schema import (
    AnchorMotionTable,
    AnchorTable,
    BodyTable,
    BuoyTable,
    CaseTable,
    CatalogueTable,
    ChecksTable,
    ClumpWeightChoiceTable,
    CurrentTable,
    DesignLoadTable,
    DesignTable,
    DynamicsTable,
    FatigueCurveTable,
    FatigueSeaStateTable,
    FatigueTable,
    FindTable,
    LineBetweenTable,
    LineTable,
    LoadCaseTable,
    LoadTable,
    MotionTable,
    NetworkLoadTable,
    NetworkSegmentTable,
    NetworkTable,
    PointLoadTable,
    PointTable,
    PsoTable,
    SegmentChoiceTable,
    SegmentTable,
    ServiceTable,
    SinkerChoiceTable,
    SiteTable,
    SystemTable,
    Table,
    VariantsTable,
    WavesTable,
    WaveTrainTable,
    entries,
)
from catopt.documents import unfit
from catopt.errors import InputError, Problem
from catopt.model import (
    Case,
    CatalogueChoice,
    CurrentProfile,
    Design,
    Dynamics,
    LoadCase,
    Motion,
    PointLoad,
    Segment,
    Service,
    Site,
    System,
    WaveState,
)
from catopt.model.motion import HARMONIC
from catopt.model.network import Network, Point
from catopt.units import UNITS, Dimension

_UNITS = {"seabed_stiffness": "N/m^2"}
"""Of keys that are not written in the unit of their dimension."""

_ESCAPES = {
    '"': '\\"',
    "\\": "\\\\",
    "\t": "\\t",
    "\n": "\\n",
}

_WIDTH = 100

Blocks = Iterator[list[str]]
"""Tables of a file, each as its lines, the one that opens it first."""


def case_digest(case: Case) -> str:
    """Return the SHA-256 of a case: of the very text that `write_case` gives it."""
    return sha256(write_case(case).encode()).hexdigest()


def write_case(case: Case | Network) -> str:
    """Write a case as TOML, in SI with its units.

    Parameters
    ----------
    case : Case or Network
        What to write.

    Returns
    -------
    str
        Text that `parse_case` reads back as an equal case, to the last digit. What has no value
        (an EA of an inextensible segment, an unknown mass) is left out; a segment of a component
        takes it from the catalogue again. Paths are absolute.
    """
    blocks = _of_network(case) if isinstance(case, Network) else _blocks(case)
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def _blocks(case: Case) -> Blocks:
    if head := list(_lines(CaseTable, _given(case))):
        yield head
    site = case.site
    yield ["[site]", *_lines(SiteTable, _given(site) | {"water_depth": site.depth_to_seabed})]
    ends = ("fairlead_height", "anchor_height")
    heights = {key: site.height_above_seabed(getattr(case, key)) for key in ends}
    yield ["[line]", *_lines(LineTable, heights)]
    yield from _tables("[[line.segments]]", SegmentTable, *case.line.segments)
    yield from _tables("[[line.point_loads]]", PointLoadTable, *case.line.point_loads)
    yield from _tables("[load]", LoadTable, case.load)
    yield from _tables("[[load_cases]]", LoadCaseTable, *case.load_cases)
    if case.system is not None:
        yield ["[system]", *_lines(SystemTable, _around(case, case.system))]
    yield from _tables("[find]", FindTable, case.find)
    yield from _tables("[checks]", ChecksTable, case.checks)
    yield from _tables("[service]", ServiceTable, case.service)
    yield from _tables("[buoy]", BuoyTable, case.buoy)
    yield from _tables("[anchor]", AnchorTable, case.anchor)
    yield from _catalogue(case.catalogue)
    if case.design is not None:
        yield from _design(case.design)
    if case.waves is not None:
        yield from _waves(case.waves)
    yield from _tables("[current]", CurrentTable, case.current)
    yield from _tables("[motion]", MotionTable, case.motion)
    yield from _tables("[anchor_motion]", AnchorMotionTable, case.anchor_motion)
    yield from _tables("[body]", BodyTable, case.body)
    yield from _tables("[dynamics]", DynamicsTable, case.dynamics)
    if case.fatigue is not None:
        yield from _tables("[fatigue]", FatigueTable, case.fatigue)
        yield from _tables("[[fatigue.sea_states]]", FatigueSeaStateTable, *case.fatigue.sea_states)
        yield from _tables("[[fatigue.curves]]", FatigueCurveTable, *case.fatigue.curves)
    yield from _tables("[pso]", PsoTable, case.swarm)


def _of_network(network: Network) -> Blocks:
    if head := list(_lines(NetworkTable, _given(network))):
        yield head
    yield from _tables("[site]", SiteTable, network.site)
    yield from _tables("[[points]]", PointTable, *network.points)
    for each in network.lines:
        yield from _tables("[[lines]]", LineBetweenTable, each)
        yield from _tables("[[lines.segments]]", NetworkSegmentTable, *each.line.segments)
        yield from _tables("[[lines.point_loads]]", NetworkLoadTable, *each.line.point_loads)


def _catalogue(choice: CatalogueChoice) -> Blocks:
    if own := list(_lines(CatalogueTable, _given(choice))):
        yield ["[catalogue]", *own]
    if choice.variants:
        yield [
            "[catalogue.variants]",
            *(_line(VariantsTable, quantity, name) for quantity, name in choice.variants),
        ]


def _design(design: Design) -> Blocks:
    yield from _tables("[design]", DesignTable, design)
    yield from _tables("[[design.segments]]", SegmentChoiceTable, *design.segments)
    yield from _tables("[[design.clump_weights]]", ClumpWeightChoiceTable, *design.clump_weights)
    yield from _tables("[design.sinker]", SinkerChoiceTable, design.sinker)
    yield from _tables("[[design.loads]]", DesignLoadTable, *design.loads)


def _waves(waves: WaveState) -> Blocks:
    given = _given(waves)
    keys = ["stretching", "seed"]
    if waves.elevation_file:
        keys = ["stretching", "elevation_file", "elevation_x", "shortest_period", "direction"]
    train = () if waves.spectrum is None else _lines(WaveTrainTable, given)
    sea = (_line(WavesTable, key, given[key]) for key in keys if key in given)
    yield ["[waves]", *train, *sea]
    yield from _tables("[[waves.trains]]", WaveTrainTable, *waves.trains)


def _around(case: Case, system: System) -> dict[str, Any]:
    """Say what a system of equal lines, each like the case's, is; InputError for any other."""
    first, *_ = system.legs
    arrangement: dict[str, Any] = {
        "azimuths": [leg.azimuth for leg in system.legs],
        "anchor_radius": first.anchor_radius,
        "fairlead_radius": first.fairlead_radius,
        "force": system.force,
        "moment": system.moment,
        "yaw_free": system.yaw_free,
    }
    around = System.around(
        case.line,
        fairlead_height=case.fairlead_height,
        anchor_height=case.anchor_height,
        seabed_friction=case.site.seabed_friction,
        **arrangement,
    )
    if around != system:
        allowed = "a case file holds equal lines, each like the case's own, around the body"
        raise InputError([Problem("system", "lines of their own", allowed)], "write_case")
    return {key: value for key, value in arrangement.items() if value is not None}


def _tables(opening: str, schema: type[Table], *parts: object) -> Blocks:
    """Write parts of the model, each as a table; nothing for None."""
    for part in parts:
        if part is not None:
            yield [opening, *_lines(schema, _given(part))]


_UNSAID: Final[Mapping[type, Mapping[str, object]]] = {
    Site: {"seabed_slope": 0.0, "contact_offset": 0.0},
    PointLoad: {"added_mass_coefficient": 0.0},
    LoadCase: {"state": "intact", "fairlead_rise": 0.0},
    Service: {"wear_rate": 0.0},
    Design: {"headings": 1},
    Point: {"submerged_weight": 0.0},
}
"""Keys that go unsaid at their default."""


def _given(part: object) -> dict[str, Any]:
    """Return what a part of the model has to say, by key; what is its default goes unsaid."""
    given = {key: value for key, value in vars(part).items() if not _is_nothing(value)}
    unsaid: tuple[str, ...] = ()
    match part:
        case Segment():
            if part.nominal_diameter is not None:
                given["diameter"] = part.nominal_diameter
            if part.component:  # which would give its own name to a segment without one
                given["name"] = part.name
            unsaid = ("EA",) if math.isinf(part.EA) else ()
            unsaid += ("drag_method",) if part.drag_method == "given" else ()
        case CurrentProfile() if part.directions:
            unsaid = ("direction",)
        case Motion(period=None):
            unsaid = HARMONIC
        case Dynamics(broken_line=None):
            unsaid = ("broken_end",)
        case Site() | PointLoad() | LoadCase() | Service() | Design() | Point():
            defaults = _UNSAID[type(part)].items()
            unsaid = tuple(key for key, default in defaults if given.get(key) == default)
    return {key: value for key, value in given.items() if key not in unsaid}


def _is_nothing(value: object) -> bool:
    return value is None or value is False or value in ("", ())


def _lines(schema: type[Table], given: Mapping[str, Any]) -> Iterator[str]:
    """Write the keys of a table that are given, in the order of the table."""
    for key, entry in entries(schema).items():
        if entry.kind is not None and key in given:
            yield _line(schema, key, given[key])


def _line(schema: type[Table], key: str, value: Any) -> str:
    """Write a key with its value, or with its array on as many lines as it needs."""
    entry = entries(schema)[key]
    unit = None
    if isinstance(entry.kind, Measured):
        unit = _UNITS.get(key, entry.kind.dimension.si_unit)
    if key == "wear_rate":
        return f"{key} = {_wear(value)}"
    if not entry.array:
        return f"{key} = {_written(value, unit)}"
    return _array(key, [_written(each, unit) for each in value])


def _wear(rate: float) -> str:
    """Write a rate of wear (m/s) in mm a year, where that reads back as the same number."""
    unit = UNITS[Dimension.SPEED]["mm/year"]
    per_year = float(f"{rate / unit:.15g}")
    if per_year * unit == rate:
        return _written(per_year, "mm/year")
    return _written(rate, "m/s")


def _written(value: Any, unit: str | None) -> str:
    """Write a value; `unit` is that of a number, empty for a pure one, and None for all else."""
    if unit is not None:
        digits = repr(float(value))  # the shortest text that reads back as the same number
        return f'"{digits} {unit}"' if unit else digits
    if isinstance(value, str):
        return _quoted(value)
    return str(value).lower() if isinstance(value, bool) else str(int(value))


def _array(key: str, values: Sequence[str]) -> str:
    line = f"{key} = [{', '.join(values)}]"
    if len(line) <= _WIDTH:
        return line
    lines, row = [f"{key} = ["], ""
    for value in values:
        if row and len(f"  {row}{value},") > _WIDTH:
            lines.append(f"  {row.rstrip()}")
            row = ""
        row += f"{value}, "
    return "\n".join([*lines, f"  {row.rstrip()}", "]"])


def _quoted(value: str) -> str:
    if unfit(value):
        raise InputError([Problem("text", unfit(value), f"take it out of {value[:40]!r}")])
    return f'"{"".join(_ESCAPES.get(character, character) for character in value)}"'
