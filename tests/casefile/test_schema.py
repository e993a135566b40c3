"""The schema of the case file against the model and against its documentation."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields
from pathlib import Path
from typing import Any, NamedTuple, get_args

import pytest

from catopt.casefile import parse_case
from catopt.casefile.schema import (
    CaseTable,
    EndMotionTable,
    LineTable,
    TableSchema,
    VariantsTable,
    entries,
    table_of,
)
from catopt.catalogue import ALL
from catopt.catalogue.components import SPECS
from catopt.errors import InputError
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
    Load,
    LoadCase,
    Motion,
    PointLoad,
    Revision,
    Segment,
    SegmentChoice,
    SegmentCurve,
    Service,
    SinkerChoice,
    Site,
    SwarmSettings,
    TitleBlock,
    WaveState,
    WaveTrain,
)
from catopt.model.anchor import ANCHOR_KINDS
from catopt.model.design import OBJECTIVES
from catopt.model.kinds import Flag, Kind, Measured, OneOf, Text, Whole
from catopt.model.line import DragMethod
from catopt.model.plausible_ranges import NAMES, Plausible
from catopt.model.sea import OF_A_BODY
from catopt.units import UNITS, Dimension, implausible

PAGE = (Path(__file__).parents[2] / "docs" / "case-file.md").read_text(encoding="utf-8")


def tables(
    table: type[TableSchema] = CaseTable, path: str = "", header: str = ""
) -> dict[str, type[TableSchema]]:
    """Every table of the schema by the line that opens it; the top of the file by an empty one."""
    found = {header: table}
    for key, entry in entries(table).items():
        if entry.table is not None:
            below = f"{path}.{key}".lstrip(".")
            found |= tables(entry.table, below, f"[[{below}]]" if entry.array else f"[{below}]")
    return found


# The model: the same names, the same ranges, the defaults of the page.

NEEDED: dict[type, dict[str, Any]] = {
    Site: {"water_depth": 9.5},
    Segment: {"length": 20.0, "submerged_weight": 93.0},
    PointLoad: {"position": 7.0, "submerged_weight": 490.0},
    Load: {},
    Find: {"quantity": "length"},
    LoadCase: {"name": "storm", "horizontal_force": 5e4},
    Checks: {},
    Service: {"life": 3e8},
    Buoy: {"reserve_buoyancy": 1e4},
    Anchor: {"kind": "sinker", "submerged_weight": 3e4, "friction": 0.5},
    CatalogueChoice: {},
    Design: {"segments": (SegmentChoice((20.0,)),)},
    DesignLoad: {"name": "storm", "force": 1e6},
    SegmentChoice: {"lengths": (20.0,)},
    ClumpWeightChoice: {"masses": (500.0,), "density": 2400.0, "positions": (7.0,)},
    SinkerChoice: {"masses": (500.0,), "density": 2400.0, "friction": 0.5},
    WaveState: {"spectrum": "jonswap", "height": 2.0, "period": 8.0},
    WaveTrain: {"spectrum": "jonswap", "height": 2.0, "period": 8.0},
    CurrentProfile: {"profile": "power", "speed": 1.0},
    Motion: {"period": 8.0},
    Body: {"mass": 1e5},
    Dynamics: {"duration": 600.0},
    Fatigue: {"sea_states": (FatigueSeaState(2.0, 8.0, 0.5),), "code": "API-RP-2SK"},
    FatigueSeaState: {"height": 2.0, "period": 8.0, "share": 0.5},
    SegmentCurve: {"name": "E301 stud"},
    SwarmSettings: {},
    TitleBlock: {},
    Revision: {"revision": "A"},
}
"""What each part of the model needs at least."""

TABLES: list[type[TableSchema]] = [*map(table_of, NEEDED), EndMotionTable]

RECORDED = {"spectrum": None, "height": None, "period": None, "elevation_file": "e.csv"}
ROUGH = {"drag_method": "roughness", "roughness": 1e-4, "keulegan_carpenter": 8.0}
SPREAD = {"spreading_exponent": 2.0, "components": 12}

BESIDE: dict[tuple[type, str], dict[str, Any]] = {
    (Find, "quantity"): {"anchor_angle": 0.0},
    (Find, "segment"): {"anchor_angle": 0.0},
    (Find, "point_load"): {"quantity": "clump_weight", "anchor_angle": 0.0},
    (Anchor, "factor_source"): {"safety_factor": 1.5},
    (Anchor, "max_slide"): {"mass": 5e3},
    (SinkerChoice, "factor_source"): {"safety_factor": 1.5},
    (Segment, "MBL_mean"): {"MBL_cov": 0.05},
    (Segment, "MBL_cov"): {"MBL_mean": 2e5},
    (Anchor, "holding_capacity"): {
        "kind": "drag",
        "submerged_weight": None,
        "friction": None,
    },
    (ClumpWeightChoice, "joint"): {"positions": ()},
    **{(Segment, k): ROUGH for k in ("roughness", "wake_amplification")},
    (Segment, "keulegan_carpenter"): ROUGH | {"wake_amplification": 1.0},
    (CurrentProfile, "depth"): {"profile": "wind"},
    (CurrentProfile, "depths"): {"profile": "table", "speed": None, "speeds": (1.0,)},
    (CurrentProfile, "speeds"): {"profile": "table", "speed": None, "depths": (1.0,)},
    **{(part, "spreading_directions"): SPREAD for part in (WaveState, WaveTrain)},
    **{(WaveState, key): RECORDED for key in ("elevation_x", "shortest_period")},
    (WaveState, "elevation_file"): RECORDED,
    (CurrentProfile, "directions"): {
        "profile": "table",
        "speed": None,
        "depths": (1.0,),
        "speeds": (1.0,),
    },
    (CurrentProfile, "series_file"): {"speed": None},
    (PointLoad, "drag_area"): {"drag_coefficient": 1.0},
    (PointLoad, "drag_coefficient"): {"drag_area": 1.0},
    (Motion, "file"): {"period": None},
    (Motion, "rao_file"): {"period": None},
    **{(Dynamics, key): {"duration": 1.7e308} for key in ("ramp", "time_step")},
    (Dynamics, "output_interval"): {"duration": 1.7e308},
    (Dynamics, "broken_line"): {"broken_at": 5.0},
    (Dynamics, "broken_at"): {"duration": 1.7e308, "broken_line": 1},
    (Fatigue, "sea_states_file"): {"sea_states": ()},
    (SegmentCurve, "log_a_D"): {"name": "", "m": 3.0},
    (SegmentCurve, "m"): {"name": "", "log_a_D": 10.0},
    (SegmentCurve, "K"): {"name": "", "M": 3.0},
    (SegmentCurve, "M"): {"name": "", "K": 316.0},
    (Dynamics, "broken_end"): {"duration": 9.0, "broken_line": 1, "broken_at": 5.0},
}
"""What some keys need beside them."""

RENAMED: dict[tuple[type, str], str] = {(Segment, "diameter"): "nominal_diameter"}
"""Keys whose attribute has another name."""

NOT_IN_THE_MODEL = {
    (Segment, "drag_axial_area"),  # the coefficient is brought to D when it is read
    (Segment, "strain"),  # with the next the table in the place of EA
    (Segment, "strain_tension"),
    (PointLoad, "density"),
    (PointLoad, "volume"),
    (Anchor, "density"),
    (Checks, "code"),
    (FatigueSeaState, "time_per_year"),
    (SegmentChoice, "component"),
    (SegmentChoice, "diameter"),
    *((SegmentChoice, f"length{end}") for end in ("", "_min", "_max", "_step")),
    *((ClumpWeightChoice, f"mass{end}") for end in ("", "_min", "_max", "_step")),
    *((ClumpWeightChoice, f"position{end}") for end in ("", "_min", "_max", "_step")),
    *((SinkerChoice, f"mass{end}") for end in ("", "_min", "_max", "_step")),
    *(
        (Design, f"{name}{end}")
        for name in ("anchor_radius", "pretension")
        for end in ("", "_min", "_max", "_step")
    ),
}
"""Keys from which the model's own attributes are worked out."""

NARROWER = {
    (Checks, "max_anchor_uplift_angle"),
    (Segment, "component"),
    (SegmentChoice, "components"),
    (DesignLoad, "name"),
    (Checks, "codes"),
    (Checks, "motion_code"),
    (CatalogueChoice, "file"),
    (Anchor, "factor_source"),
    (SinkerChoice, "factor_source"),
    (Fatigue, "code"),
    (Fatigue, "sea_states_file"),
    (Motion, "file"),
    *((Motion, f"rao_{end}") for end in ("file", "phase", "rotation", "per")),
    (Motion, "drift_file"),
    (Body, "force_file"),
    (WaveState, "elevation_file"),
    (CurrentProfile, "series_file"),
    *((TitleBlock, key) for key in ("client", "project", "number", "logo")),
    *((Revision, key) for key in entries(table_of(Revision))),
}
"""An angle is limited to a right one, because a bare 5 is more likely meant in degrees; a name that
is blank is no name."""

SIZES = {
    (Motion, "rao_reference"): 3,
    (Motion, "rao_crest"): 2,
    (Motion, "drift"): 2,
    (Body, "wave_force"): 2,
}
"""Arrays that have so many values."""

WORDS = {
    (Design, "objectives"): OBJECTIVES,
    (Anchor, "kind"): ANCHOR_KINDS,
    (Segment, "drag_method"): get_args(DragMethod),
}
"""Words that need others beside them, or other keys, so that the model refuses them alone."""

PROBES: list[float | str] = [
    -1,
    -5e-324,
    0,
    5e-324,
    0.5,
    1,
    2,
    3,
    4,
    math.nextafter(4.0, 5.0),
    400,
    10**8 + 1,
    2**63,
    1e300,
]
PROBES += ["", "nearest", "length", "drag", "sinker", "reference", "mass", "auto"]


def accepts(function: Callable[..., object], *args: object, **kwargs: object) -> bool:
    try:
        function(*args, **kwargs)
    except InputError:
        return False
    return True


def keys_with_a_value() -> Iterator[tuple[type[TableSchema], str, Kind]]:
    for table in TABLES:
        for key, entry in entries(table).items():
            if entry.kind is not None and (table.model, key) not in NOT_IN_THE_MODEL:
                yield table, key, entry.kind


@pytest.mark.parametrize(("table", "key", "kind"), list(keys_with_a_value()))
def test_the_ranges_are_those_of_the_model(table: type[TableSchema], key: str, kind: Kind) -> None:
    part = table.model
    needed = NEEDED[part] | BESIDE.get((part, key), {})
    attribute = RENAMED.get((part, key), key)
    textual = isinstance(kind, Text | OneOf)
    whole = isinstance(kind, Whole)
    if (part, key) in WORDS:
        assert kind == OneOf(WORDS[part, key])
        return
    if isinstance(kind, Flag):
        assert (accepts(kind.read, True), accepts(kind.read, 1)) == (True, False)
        return
    probes = [p for p in PROBES if isinstance(p, str) == textual]
    for probe in (p for p in probes if not whole or isinstance(p, int)):
        by_file = accepts(kind.read, probe)
        if isinstance(kind, Measured) and kind.infinite and 0.0 < float(probe) <= 1e20:
            assert by_file, probe  # an EA so large says that nothing stretches
        elif isinstance(kind, Measured) and implausible(kind.dimension, float(probe)):
            assert not by_file, probe  # from Python anything goes that the formulas take
            continue
        value = (probe,) * SIZES.get((part, key), 1) if entries(table)[key].array else probe
        beyond = {"accept": NAMES} if issubclass(part, Plausible) else {}
        by_model = accepts(part, **{**needed, attribute: value}, **beyond)
        if (part, key) in NARROWER:
            assert by_model or not by_file, probe
        else:
            assert by_file == by_model, probe


def test_the_heights_have_the_ranges_of_the_model() -> None:
    for key in ("fairlead_height", "anchor_height"):
        kind = entries(LineTable)[key].kind
        assert isinstance(kind, Measured)
        assert (kind.above, kind.at_least, kind.at_most) == (None, 0.0, None)


def test_every_attribute_of_the_model_has_its_key() -> None:
    for table in TABLES:
        attributes = {f.name for f in fields(table.model)} - {"accept"}  # at the top of a file
        if table is EndMotionTable:
            attributes -= {"rao_file", *OF_A_BODY}  # refused there
        keys = {k for k in entries(table) if (table.model, k) not in NOT_IN_THE_MODEL}
        assert {RENAMED.get((table.model, k), k) for k in keys} == attributes
    renamed = {"pso": "swarm"}
    lifted = {"fairlead_height", "anchor_height"}
    assert {renamed.get(k, k) for k in entries(CaseTable)} == {
        f.name for f in fields(Case)
    } - lifted


def test_the_variants_are_of_the_quantities_of_the_catalogue() -> None:
    assert list(entries(VariantsTable)) == [ALL, *SPECS]


# The page: every key, and none that is not there.


class Row(NamedTuple):
    si: str
    default: str
    range: str
    meaning: str
    example: str


def documented() -> dict[str, dict[str, Row]]:
    """Rows of the page's tables of keys, by the line that opens the section."""
    sections: dict[str, dict[str, Row]] = {}
    for part in PAGE.split("\n## ")[1:]:
        title = part.splitlines()[0]
        if title == "Top of the file" or title.startswith("`["):
            rows = re.findall(r"^\| `([^`]+)` \| (.+) \|$", part, re.MULTILINE)
            header = title.strip("`") if title.startswith("`") else ""
            sections[header] = {key: Row(*cells.split(" | ")) for key, cells in rows}
    return sections


def test_the_page_has_exactly_the_sections_and_keys_of_the_schema() -> None:
    schema = {
        header: [key for key, entry in entries(table).items() if entry.kind is not None]
        for header, table in tables().items()
    }
    assert {header: list(rows) for header, rows in documented().items()} == schema


def documented_keys() -> Iterator[tuple[type[TableSchema], str, Row]]:
    for header, rows in documented().items():
        for key, row in rows.items():
            yield tables()[header], key, row


@pytest.mark.parametrize(("table", "key", "row"), list(documented_keys()))
def test_unit_range_default_and_example_are_right(
    table: type[TableSchema], key: str, row: Row
) -> None:
    entry = entries(table)[key]
    assert entry.kind is not None
    assert row.si == (
        entry.kind.dimension.si_unit or "-" if isinstance(entry.kind, Measured) else "-"
    )
    assert row.range == range_of(entry.kind) + (", each" if entry.array else "")
    assert (row.default == "required") == entry.required
    assert row.meaning
    example = parse_value(row.example)
    assert isinstance(example, list) == entry.array
    for value in example if isinstance(example, list) else [example]:
        assert accepts(entry.kind.read, value)


def parse_value(text: str) -> object:
    return tomllib.loads(f"value = {text.strip('`')}")["value"]


def range_of(kind: Kind) -> str:
    """Write a range as the page does."""
    if isinstance(kind, Text):
        return "text, not empty" if kind.filled else "text"
    if isinstance(kind, Flag):
        return "true or false"
    if isinstance(kind, OneOf):
        return "one of " + ", ".join(kind.words)
    if isinstance(kind, Whole):
        return "{} to {}".format(*kind.bounds)
    assert isinstance(kind, Measured)
    if kind.at_most is not None:
        top = "pi/2" if kind.at_most == math.pi / 2.0 else f"{kind.at_most:g}"
        if kind.at_least is None:
            return f"above {kind.above:g}, to {top}"
        return f"{kind.at_least:g} to {top}"
    if kind.above is not None:
        return f"above {kind.above:g}"
    return "any" if kind.at_least is None else f"{kind.at_least:g} or more"


def test_the_defaults_on_the_page_are_those_of_the_model() -> None:
    compared = 0
    for header, rows in documented().items():
        table = tables()[header]
        if table not in TABLES:
            continue
        for field in fields(table.model):
            if field.default in (MISSING, None, math.inf, "", ()):
                continue
            assert rows[field.name].default == default_of(field.default), field.name
            compared += 1
    # segments, site, point loads, load cases, checks, service, catalogue, design with its segments,
    # clump weights and loads, waves with trains, current, motion of both ends, body, dynamics, pso
    assert (
        compared == 1 + 4 + 1 + 4 + 2 + 1 + 1 + (10 + 1 + 1 + 5) + (5 + 2) + 1 + 6 + 6 + 2 + 9 + 8
    )


def default_of(default: object) -> str:
    """Write a default as the page does."""
    if isinstance(default, bool):
        return str(default).lower()
    return ", ".join(default) if isinstance(default, tuple) else str(default)


def test_the_units_on_the_page_are_those_of_the_table() -> None:
    top = PAGE.split("## Top of the file")[0]
    rows = re.findall(r"^\| ([a-z ]+) \| (`.+) \| (\S+) to (\S+) \|$", top, re.MULTILINE)
    used = {
        kind.dimension
        for table in tables().values()
        for kind in (entry.kind for entry in entries(table).values())
        if isinstance(kind, Measured)
    }
    on_page = {name: re.findall(r"`([^`]+)`", units) for name, units, _, _ in rows}
    plausible = {name: (float(low), float(high)) for name, _, low, high in rows}
    expected = {d.noun.split(" ", 1)[1]: list(UNITS[d]) for d in Dimension if d in used}
    assert on_page == expected
    assert plausible == {d.noun.split(" ", 1)[1]: (d.smallest, d.largest) for d in used}


def test_the_example_on_the_page_is_a_case_and_its_mistakes_are_told_as_shown() -> None:
    example, design, moving = re.findall(r"^```toml\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    assert parse_case(example).title == "Marker buoy, 9.5 m"
    assert parse_case(design).design is not None
    assert parse_case(moving).dynamics is not None
    shown = re.findall(r"^```text\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    wrong = (
        example.replace("water_depth", "watr_depth")
        .replace('"20 m"', '"20 kg"')
        .replace('kgf/m"', 'kgf/m"\nEA = 0')
        .replace("0.343 tf", "0.343 t")
    )
    for text, message in zip((wrong, example.replace('"20 m"', "20 m")), shown, strict=True):
        with pytest.raises(InputError) as caught:
            parse_case(text, "case.toml")
        assert f"{caught.value}\n" == message
