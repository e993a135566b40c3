"""The table of inputs, and that every face of a sizing is made of it."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Any, get_args

import pytest
import typer.main

import catopt
from catopt.casefile.reading import Moored
from catopt.casefile.schema import entries
from catopt.cli.size import as_option, by_option, typed
from catopt.cli.size import size as size_commands
from catopt.errors import InputError
from catopt.loads import METHODS, WaterLevels
from catopt.loads.buoy import WaveHeight
from catopt.loads.ship import Condition, ShipKind
from catopt.loads.sinker import DENSITIES
from catopt.model.kinds import Measured
from catopt.sizing import Environment, SinkerGround, TankerRequest
from catopt.sizing.environment import SERVICE_TYPES
from catopt.sizing.file import read_file, read_sizing
from catopt.sizing.input_values import ReadInput, ResolvedInputs, input_values
from catopt.sizing.inputs import INPUTS, Input, inputs_of, rows_of
from catopt.sizing.kinds import from_text, kind_of, schema_of, usual
from catopt.sizing.line_choice import PREFERENCES
from catopt.sizing.requests import request_of, size
from catopt.units import as_written
from catopt.words.message import group
from tests.sizing.at_rest import size_buoy, size_tanker
from tests.sizing_page import PAGE, up_to_date

KINDS: tuple[Moored, ...] = ("buoy", "tanker")
ROWS = [(moored, each) for moored in KINDS for each in rows_of(moored)]
IDS = [f"{moored} {each.key}" for moored, each in ROWS]
MOST = [(moored, each) for moored, each in ROWS if each.most]
SPELLED = {"buoy": by_option, "tanker": as_option}

BASE: dict[Moored, dict[str, object]] = {
    "buoy": {"buoy": "pillar 1.8 m", "depth": "12 m"},
    "tanker": {
        "length": "234 m",
        "breadth": "31.3 m",
        "draught": "12.4 m",
        "depth": "22 m",
        "buoy": "mooring buoy 5.0 m",
    },
}
BY_FETCH = ("fetch", "fetch_depth")
"""In place of Hs."""
STILL: dict[str, object] = dict.fromkeys(
    (
        *BY_FETCH,
        *("in_motion", "seeds", "run_time", "peak_period", "sea_height", "period_range"),
        *("other_lengths", "max_slide", "centre_of_gravity", "max_heel"),
        *("light_divergence", "pitch_damping"),
        "place",  # in place of the wind
        *("embedment", "scour"),  # of clay alone, which the example of a soil is not
    )
)
"""Of what is run in time there are tests of their own: it takes minutes."""
SEVERAL: dict[str, object] = {"low_water": "20 m", "max_swing": None, "swing_price": None}
IN_MOTION = ("in_motion", "seeds", "run_time", "peak_period", "sea_height", "period_range")
SEVERAL |= dict.fromkeys((*IN_MOTION, *BY_FETCH, "embedment"))
ONE_LINE: dict[str, object] = {"low_water": "20 m", "prefer": "cheapest"}
ONE_LINE |= dict.fromkeys(("lines", "pretension", "clump_weight", *IN_MOTION, *BY_FETCH))
FULL: dict[str, tuple[Moored, dict[str, object]]] = {
    "a buoy of the library": ("buoy", {"hs": "1.5 m", "swing_price": None, **STILL}),
    "a buoy by its force": (
        "buoy",
        {
            "buoy": None,
            "force": "5 kN",
            "soil": None,
            "friction": 0.4,
            "swing_price": None,
            **STILL,
        },
    ),
    "a tanker on a drag anchor": ("tanker", SEVERAL),
    "a tanker on a sinker": (
        "tanker",
        {**SEVERAL, "anchor": "sinker", "soil": "soft clay", "embedment": "0.3 m"},
    ),
    "a tanker on a sinker, by friction": (
        "tanker",
        {**SEVERAL, "anchor": "sinker", "soil": None, "friction": 0.4},
    ),
    "a tanker on one line, by price": ("tanker", ONE_LINE),
}
"""What is given first, of sizings that are then given every input that may stand beside it."""


def examples(name: str) -> tuple[Moored, dict[str, Any]]:
    """Give everything there is an example for."""
    moored, first = FULL[name]
    held_by = "sinker" if first.get("anchor") == "sinker" else "anchor"
    given: dict[str, Any] = {**first}
    for each in inputs_of(moored, held_by=held_by).values():
        if each.name not in (*given, "buoys", "coefficients") and not any(
            given.get(o) for o in each.not_with
        ):
            given[each.name] = each.example
    return moored, {key: value for key, value in given.items() if value is not None}


def as_file(moored: Moored, given: dict[str, Any]) -> str:
    """Write inputs as a file; what holds a tanker follows from the section."""
    held_by = str(given.get("anchor", "anchor"))
    sections: dict[str, str] = {}
    for name, value in given.items():
        each = inputs_of(moored, held_by=held_by)[name]
        *section, key = each.path
        many = ", ".join(map(as_written, value)) if isinstance(value, tuple) else ""
        if value != "sinker":
            line = f"{key} = {f'[{many}]' if many else as_written(value)}\n"
            sections[".".join(section)] = sections.get(".".join(section), "") + line
    top = sections.pop("", "")
    return top + "".join(f"[{name}]\n{lines}" for name, lines in sections.items())


def by_options(moored: Moored, given: dict[str, Any]) -> ResolvedInputs:
    """Type inputs as options."""
    texts = {
        name: list(value) if isinstance(value, tuple) else value if value is True else str(value)
        for name, value in given.items()
    }
    return input_values(moored, typed(moored, texts), SPELLED[moored], "options")


@pytest.mark.parametrize("name", FULL)
def test_keywords_options_and_a_file_come_to_the_same(name: str, tmp_path: Path) -> None:
    moored, given = examples(name)
    path = tmp_path / "sizing.toml"
    path.write_text(as_file(moored, given), encoding="utf-8")
    request = request_of(input_values(moored, given))
    assert read_sizing(path) == request
    assert request_of(by_options(moored, given)) == request


def test_the_examples_are_all_inputs_but_files() -> None:
    given = {
        "buoy": {"buoys", "swing_price", *STILL},
        "tanker": {"buoys", "coefficients", *IN_MOTION, *BY_FETCH},
    }  # no buoy chain has a price
    for name in FULL:
        moored, examples_of_it = examples(name)
        given[moored] |= set(examples_of_it)
    assert given == {moored: set(inputs_of(moored)) for moored in BASE}


@pytest.mark.parametrize("moored", BASE)
def test_every_face_has_exactly_the_inputs_of_the_table(moored: Moored) -> None:
    group_of_commands: Any = typer.main.get_command(size_commands)
    found = {each.name: each for each in group_of_commands.commands[moored].params}
    for name, each in inputs_of(moored).items():
        if name in ("title", "source") or (moored, name) == ("buoy", "buoy"):
            assert name not in found
        else:
            assert found[name].opts == [as_option(name)]
            assert each.takes in (found[name].metavar, "WHICH", "NAME", "COUNT", "FLAG")
    keys = {each.key for row, each in ROWS if row == moored}
    tables = {key: entry.table for key, entry in entries(schema_of(moored)).items()}
    del tables["document"]  # of the note alone
    inside = {f"{name}.{key}" for name, of in tables.items() if of for key in entries(of)}
    assert inside | {name for name, of in tables.items() if not of} == keys


def told(of: ResolvedInputs) -> dict[str, str]:
    """Return what is wrong, by its place."""
    with pytest.raises(InputError) as caught:
        size(of)
    return {each.key: each.allowed for each in caught.value.problems}


def told_of_a_file(path: Path, moored: Moored) -> dict[str, str]:
    """Return what is wrong with a file, by its place."""
    file = read_file(path, moored)
    with pytest.raises(InputError) as caught, file.reporting():
        size(file.known())
    return {each.key: each.allowed for each in caught.value.problems}


def faults(
    moored: Moored, each: Input, value: object, folder: Path
) -> tuple[dict[str, str], dict[str, str], dict[str, str]]:
    """Give a value that is wrong to each face."""
    given: dict[str, Any] = {**BASE[moored], each.name: value}
    if each.name in ("force", "reserve_buoyancy"):
        given = {"depth": "12 m", "force": "5 kN", "reserve_buoyancy": "12 kN"} | {each.name: value}
    if moored == "tanker" and each.key.startswith("sinker."):
        given["anchor"] = "sinker"
    path = folder / "sizing.toml"
    path.write_text(as_file(moored, given), encoding="utf-8")
    by_keyword, of_file = told(input_values(moored, given)), told_of_a_file(path, moored)
    is_option = each.name not in ("title", "source")
    return by_keyword, told(by_options(moored, given)) if is_option else {}, of_file


@pytest.mark.parametrize(("moored", "each"), ROWS, ids=IDS)
def test_what_is_no_such_value_is_told_by_every_face(
    moored: Moored, each: Input, tmp_path: Path
) -> None:
    """In its own spelling, and with nothing else: what hangs on it goes on with the default."""
    is_text = each.takes in ("TEXT", "NAME", "FILE")
    value: object = 2.4 if is_text else "porridge"
    index = 0 if each.several else None
    if each.several:
        value = (value,)
    by_keyword, option, file = faults(moored, each, value, tmp_path)
    place = "" if index is None else "[0]"
    assert list(by_keyword) == [f"{each.name}{place}"]
    assert list(file) == [f"{each.key}{place}"]
    if not is_text:
        assert list(option) == [SPELLED[moored](each.name, index)]


@pytest.mark.parametrize(("moored", "each"), MOST, ids=[f"{m} {e.key}" for m, e in MOST])
def test_more_than_the_most_is_refused_by_every_face(
    moored: Moored, each: Input, tmp_path: Path
) -> None:
    most: Any = kind_of(each).read(from_text(each, each.most))
    by_keyword, option, file = faults(moored, each, 1.01 * most, tmp_path)
    assert each.name in by_keyword
    assert as_option(each.name) in option
    assert each.key in file


@pytest.mark.parametrize("each", INPUTS, ids=lambda each: each.key)
def test_example_default_and_words_are_right(each: Input) -> None:
    kind = kind_of(each)
    many = each.example if isinstance(each.example, tuple) else (each.example,)
    assert isinstance(each.example, tuple) == each.several
    for value in many:
        kind.read(value)
    if each.default:
        kind.read(from_text(each, each.default))
    assert each.name in group("inputs")
    assert set(each.not_with) <= {other.name for other in INPUTS}
    assert isinstance(kind, Measured) == each.is_measure


def test_one_of_several_words_is_one_of_the_model() -> None:
    words = {each.name: each.words for each in INPUTS if each.words}
    assert {"concrete", "steel"} <= set(DENSITIES)
    assert words == {
        "ship": get_args(ShipKind),
        "condition": get_args(Condition),
        "prefer": PREFERENCES,
        "sinker": ("concrete", "steel"),
        "load_method": ("IALA-CALMAR", "catopt-buoy"),  # of a buoy; a ship's are METHODS
        "wave_height": get_args(WaveHeight),
        "service_type": SERVICE_TYPES,
    }
    assert inputs_of("tanker")["load_method"].words == METHODS


def test_what_requests_take_is_what_the_table_says() -> None:
    """The rest is read from the table (`catopt.sizing.kinds.usual`)."""
    assert SinkerGround().material == usual("sinker")
    assert Environment(WaterLevels.steady(12.0)).water_density == usual("water_density")
    assert {each.name: each.default for each in fields(TankerRequest)}["lines"] == usual(
        "lines", "tanker"
    )


def test_the_page_shows_the_table() -> None:
    """When it does not: python -m tests.sizing_page writes it anew."""
    page = PAGE.read_text("utf-8")
    assert up_to_date(page) == page


def test_what_is_not_evaluated_is_refused_by_its_keyword() -> None:
    given = {"buoy": "pillar 1.8 m", "dept": "12 m", "keel_depth": 1.0, "mu": 0.5}
    assert told(input_values("buoy", given)) == {
        "dept": "did you mean depth?",
        "keel_depth": "leave it out, or buoy: it follows from the shape of the named buoy",
        "mu": "did you mean friction?",
    }
    by_force = {"depth": 12.0, "force": "5 kN", "reserve_buoyancy": 12e3, "wind": "20 m/s"}
    assert told(input_values("buoy", by_force)) == {
        "wind": "leave it out, or force, which includes it"
    }
    alone = {**BASE["tanker"], "pretension": "5 %", "buoy": None, "buoys": "mine.toml"}
    assert told(input_values("tanker", alone)) == {
        "pretension": "leave it out, or give lines with it",
        "buoys": "leave it out, or give buoy with it",
    }
    held = {**BASE["tanker"], "friction": 0.4}
    assert told(input_values("tanker", held, as_option, "options")) == {
        "--friction": 'leave it out, or give --anchor "sinker": it is of a sinker'
    }


def test_a_sizing_by_keywords_is_that_of_its_file() -> None:
    """Of docs/sizing.md, a buoy by hand: 50 mm, 31 m, to the digits that it prints."""
    place: dict[str, Any] = {
        "depth": 12,
        "low_water": "10 m",
        "current": 1.5,
        "hs": 1.5,
        "period": "6 s",
    }
    soil = "clean fine to medium sand"
    by_hand = size_buoy(buoy="pillar 2.4 m", soil=soil, **place)
    assert by_hand.point.line.length == 31.0
    assert by_hand.point.line.segments[0].nominal_diameter == pytest.approx(0.05, abs=1e-12)
    assert "wind 25 m/s" in by_hand.defaults
    sizing = size_buoy(buoy="pillar 2.4 m", soil=soil, prefer="balanced", **place)
    request = catopt.read_sizing(Path(__file__).parents[2] / "cases/size-buoy/sizing.toml")
    assert request.title == "Pillar buoy in 12 m"
    assert size_buoy(request).point.line == sizing.point.line
    with pytest.raises(InputError, match="the request for a tanker is required"):
        size_tanker(request)


def test_what_is_given_comes_back_in_the_unit_that_it_has() -> None:
    given = {"depth": "40 ft", "wind": "50 knots", "current": 1.5, "hs": "1,5 m", "period": "8s"}
    said = {each.keyword: str(each.said) for each in input_values("buoy", given).read}
    shown = {name: said[name] for name in given}
    assert shown == {
        "depth": "40 ft",
        "wind": "50 knots",
        "current": "1.5 m/s",
        "hs": "1.5 m",
        "period": "8 s",
    }


@pytest.mark.parametrize(("seconds", "said"), [(10.0, "10 s"), (60.0, "1 min"), (600.0, "10 min")])
def test_a_duration_is_said_in_the_unit_that_reads_well(seconds: float, said: str) -> None:
    mean = next(each for each in INPUTS if each.name == "wind_mean")
    assert ReadInput(mean, seconds, "given").said == said


def test_a_buoy_may_be_named_before_the_keywords() -> None:
    named = size_buoy("pillar 1.8 m", depth=12.0)
    assert named == size_buoy(buoy="pillar 1.8 m", depth="12 m")
    with pytest.raises(InputError, match="or keywords, not both"):
        size_buoy("pillar 1.8 m", buoy="pillar 2.4 m", depth=12.0)
