"""Every JSON document against its schema, and nothing beside it on standard output."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import jsonschema
import pytest

import catopt
from catopt import schemas
from catopt.errors import InputError
from catopt.model import Case

from .conftest import BUOY, FSO, OWN, Run, document_of
from .conftest import validate as validate


@pytest.mark.parametrize(
    ("command", "computed"),
    [
        (["solve", BUOY], catopt.solve_case),
        (["check", OWN / "strength.toml"], catopt.check_case),
        (["verify", BUOY], catopt.verify_case),
        (["curve", BUOY, "--over", "span", "--points", 9],
         partial(catopt.curve_case, over="span", points=9)),
    ],
)  # fmt: skip
def test_a_command_prints_what_python_gives(
    run: Run, command: list[object], computed: Callable[[Case], Any]
) -> None:
    assert document_of(run, *command) == computed(catopt.read_case(str(command[1]))).to_dict()


def test_a_body_rests_where_python_has_it(run: Run) -> None:
    """With what the case says beside it, and nothing that was not asked for."""
    document = document_of(run, "system", FSO)
    system = catopt.read_case(FSO).system
    assert system is not None
    of_case = {key: document[key] for key in ("title", "sharing_rule", "checks")}
    (said,) = document["warnings"]
    assert said.startswith("the fairlead is 15.4 m above the water")
    assert document == catopt.solve_system(system).to_dict() | of_case | {"warnings": [said]}


def test_a_case_is_solved_under_its_first_load_case() -> None:
    case = catopt.read_case(OWN / "bed-chain.toml")
    first = catopt.solve_case(case)
    assert first.span == catopt.solve_case(case.under(case.load_cases[0])).span
    assert len(first.warnings) == 1


# What scripts hang on: names that may be added to and never dropped.
PROMISED = {
    "": "schema title method status horizontal_force_N span_m fairlead_height_m fairlead anchor "
    "grounded_length_m suspended_length_m stretched_length_m line_mass_kg segments point_loads "
    "residual warnings",
    "fairlead": "tension_N vertical_force_N angle_rad",
    "anchor": "tension_N horizontal_force_N vertical_force_N angle_rad",
    "residual": "height_m span_m force_uncertainty_N",
    "profile": "s_m x_m z_m tension_N",
    "pso": "objective evaluations iterations runs seed converged_runs",
}


def test_promised_keys_are_there(run: Run) -> None:
    document = document_of(run, "solve", BUOY, "--method", "pso", "--profile")
    for part, keys in PROMISED.items():
        assert set(keys.split()) <= set(document[part] if part else document)


def test_promised_keys_of_parts_and_items(run: Run) -> None:
    document = document_of(run, "solve", OWN / "chain-and-wire.toml")
    assert {"name", "length_m", "max_tension_N", "utilisation"} <= set(document["segments"][0])
    assert {"position_m", "x_m", "z_m", "seabed_reaction_N"} <= set(document["point_loads"][0])
    item = "source name quantity published computed unit printed_digits verdict note"
    assert set(item.split()) <= set(document_of(run, "reproduce", "ship_200m")["items"][0])


# ------------------------------------------------------------------ the schemas themselves


def objects(node: object, path: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """Every schema of an object with its properties, and where it stands."""
    if isinstance(node, dict):
        if node.get("type") == "object" and not isinstance(node.get("additionalProperties"), dict):
            yield path, node  # not what has the document's own texts, or names, as keys
        for key, value in node.items():
            yield from objects(value, f"{path}/{key}")


@pytest.mark.parametrize("name", schemas.names())
def test_schemas_are_strict_and_described(name: str) -> None:
    schema = schemas.schema(name)
    jsonschema.Draft202012Validator.check_schema(schema)
    assert schema["properties"]["schema"] == {"const": name}
    for path, node in objects(schema):
        assert node["additionalProperties"] is False, path
        for key, property_ in node["properties"].items():
            assert "const" in property_ or property_["description"], f"{path}/{key}"


UNITS = {
    "_N_per_m": "N/m", "_kg_per_m": "kg/m", "_USD_per_m": "USD/m", "_N": "N", "_m": "m",
    "_rad": "rad", "_kg": "kg",
}  # fmt: skip
"""Units by the ends of keys; the first that fits."""


@pytest.mark.parametrize("name", schemas.names())
def test_units_of_keys_stand_in_the_descriptions(name: str) -> None:
    for path, node in objects(schemas.schema(name)):
        for key, property_ in node["properties"].items():
            unit = next((unit for end, unit in UNITS.items() if key.endswith(end)), None)
            if unit is not None:
                first = property_["description"].replace(",", " ").replace(":", " ").rstrip(".")
                assert first.split()[0] == unit, f"{path}/{key}"


def test_a_document_that_strays_is_rejected(run: Run) -> None:
    document = document_of(run, "solve", BUOY)
    changes: list[dict[str, Any]] = [
        {"span": 17.43}, {"span_m": "17.43"}, {"regime": "flying"}, {"status": "stalled"},
        {"method": "pso"},  # without its block
        {"pso": {}},  # without its method
    ]  # fmt: skip
    for change in changes:
        with pytest.raises(jsonschema.ValidationError):
            validate({**document, **change})
    with pytest.raises(jsonschema.ValidationError):
        validate({key: value for key, value in document.items() if key != "warnings"})


def test_an_unknown_schema_is_an_input_error() -> None:
    with pytest.raises(InputError, match=r"catopt\.solution/1"):
        schemas.schema("catopt.nothing/1")
