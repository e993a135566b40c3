"""``catopt loads``: its numbers, and which input counts."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from catopt.loads import METHODS, compare_tanker
from catopt.sizing.headings import DIRECTIONS
from catopt.sizing.inputs import Input, rows_of
from catopt.units import as_written

from .conftest import OWN, Run, document_of, typed

BUOY, TANKER, VANE = typed("LOADS_BUOY"), typed("LOADS_SHIP"), typed("VANE")


def test_a_ship_on_the_beam_and_the_largest_wave(run: Run) -> None:
    beam = [f"--{what}-angle=90 deg" for what in ("wind", "current", "wave")]
    ahead, across = document_of(run, *TANKER), document_of(run, *TANKER, *beam)
    assert across["sway_N"] > 5.0 * ahead["horizontal_force_N"]
    larger = document_of(run, *TANKER, "--drift", "largest-wave")
    assert larger["horizontal_force_N"] > 2.0 * ahead["horizontal_force_N"]


def test_every_method_is_shown_and_the_one_that_is_named_comes_first(run: Run) -> None:
    found = document_of(run, *TANKER)
    assert found["surge_N"] < 0.0
    assert "Collinear" in found["assumptions"][0]
    by_method = [found, *found["others"]]
    # The options say what Python is given in other numbers, such as 0.97 x 234 m.
    assert [each["method"] for each in by_method] == list(METHODS)
    for each in by_method:
        total = compare_tanker(method=each["method"]).loads.horizontal_force
        assert each["horizontal_force_N"] == pytest.approx(total, rel=1e-12)


def test_a_ship_that_weathervanes_under_a_current_that_is_turned_round(run: Run) -> None:
    found = document_of(run, *TANKER, *VANE, "--scan", "90 deg")
    turned = [round(math.degrees(each["current_from_rad"])) for each in found["headings"]]
    assert sorted(set(turned)) == [-90, 0, 90, 180]
    forces = [each["horizontal_force_N"] for each in found["headings"]]
    assert found["horizontal_force_N"] == max(forces) > 2.0 * min(forces)
    assert "Weathervaning: at this heading" in found["assumptions"][0]


def test_a_file_of_a_sizing_is_read_as_the_sizing_reads_it(run: Run) -> None:
    place = OWN / "cargo.toml"
    found = document_of(run, "loads", "ship", place)
    (loaded,) = document_of(run, "size", "tanker", place)["loads"][0]["parts"]
    assert found["components"] == loaded["components"]


PLACE = {
    "buoy": {
        "site.water_depth": "12 m", "environment.current": "1 m/s", "environment.hs": "1.5 m",
        "environment.period": "6 s", "buoy.name": "pillar 1.8 m",
    },
    "ship": {
        "site.water_depth": "22 m", "environment.current": "1 m/s", "environment.wind": "20 m/s",
        "environment.hs": "1.5 m", "environment.period": "6 s", "ship.length": "234 m",
        "ship.breadth": "31.3 m", "ship.draught": "12.4 m",
    },
}  # fmt: skip
"""Of a file that both loads commands take."""

ACROSS = ("--wind-angle", "90 deg", "--current-angle", "90 deg")
LOW = {"buoy": "2.5 m", "ship": "14 m"}
OTHERS = {"water_density": 1010, "load_method": ["22TCN-222-95"]}
"""Values that count where the example of the table would not."""


TURNS = {"environment.current_yaw": "series-60", "environment.current_angle": "60 deg"}
"""Beside the directions of a ship that weathervanes."""


def loads_of(run: Run, folder: Path, body: str, keys: dict[str, Any]) -> tuple[int, Any, str]:
    """Compute the loads of a file with these keys; status, document and what is told."""
    sections: dict[str, str] = {"": ""}
    for key, value in keys.items():
        section, _, name = key.rpartition(".")
        written = as_written(value) if not isinstance(value, (tuple, list)) else None
        written = written or f"[{', '.join(map(as_written, value))}]"
        sections[section] = sections.get(section, "") + f"{name} = {written}\n"
    path = folder / "sizing.toml"
    top = sections.pop("")
    path.write_text(top + "".join(f"[{name}]\n{text}" for name, text in sections.items()))
    across = body == "ship" and "environment.current_yaw" not in keys
    ran = run("loads", body, str(path), "--json", *(ACROSS if across else ()))
    return ran.status, json.loads(ran.out) if ran.out else None, ran.err


@pytest.mark.parametrize(
    ("body", "each"),
    [
        (body, each)
        for body, moored in (("buoy", "buoy"), ("ship", "tanker"))
        for each in rows_of(moored)
        if each.key not in (*PLACE[body], "ship.deadweight")  # held against the displacement, below
    ],
    ids=lambda each: each if isinstance(each, str) else each.key,
)
def test_no_key_of_a_sizing_is_ignored_in_silence(
    run: Run, tmp_path: Path, body: str, each: Input
) -> None:
    """It changes the loads, is refused by its name, or is said to have no part in them."""
    first = {**PLACE[body], **(TURNS if each.name in DIRECTIONS else {})}
    _, without, _ = loads_of(run, tmp_path, body, first)
    value = LOW[body] if each.name == "low_water" else OTHERS.get(each.name, each.example)
    status, found, told = loads_of(run, tmp_path, body, {**first, each.key: value})
    if status == 2:
        assert each.key in told or str(value) in told
        return
    assert status == 0
    named = [said for said in found["assumptions"] if said.startswith("Given, but no part")]
    if any(each.key in said for said in named):
        assert found["components"] == without["components"]
    else:
        assert (found["components"], found["others"]) != (without["components"], without["others"])


def test_low_water_counts_for_a_ship(run: Run) -> None:
    """Of S3's tanker across the current: C = C0 + (3.2 - C0)(T/d)^2, T/d 12.4/20 and 12.4/15."""
    still = ("--current-angle", "90 deg", "--wind", "0 m/s", "--hmax", "0 m")
    found = document_of(run, *TANKER, *still, "--low-water", "15 m")
    assert [each["depth_m"] for each in found["headings"]] == [20.0, 15.0]
    forces = [each["horizontal_force_N"] for each in found["headings"]]
    assert forces[0] == document_of(run, *TANKER, *still)["horizontal_force_N"]
    assert found["horizontal_force_N"] == max(forces) == forces[1]
    length, volume = 0.97 * 234.0, 0.80 * 0.97 * 234.0 * 31.3 * 12.4
    chi = length**2 * 0.98 * 31.3 * 12.4 / (31.3 * volume)
    deep = 0.22 * math.sqrt(chi)
    by_hand = [
        0.5 * 1025.0 * 1.2**2 * length * 12.4 * (deep + (3.2 - deep) * (12.4 / depth) ** 2)
        for depth in (20.0, 15.0)
    ]
    assert forces == pytest.approx(by_hand, rel=1e-9)


@pytest.mark.parametrize(("chain", "governs"), [("25 mm", "12 m"), ("0 mm", "10 m")])
def test_low_water_counts_for_a_buoy(run: Run, chain: str, governs: str) -> None:
    """Waves move the surface faster in less water, (pi H/T)/tanh(k d); a chain is shorter in it."""
    depths = ("12 m", "10 m")
    found = document_of(run, *BUOY, "--chain", chain)
    at = {
        depth: document_of(run, *BUOY, "--chain", chain, "--depth", depth, "--low-water", depth)
        for depth in depths
    }
    forces = {depth: at[depth]["horizontal_force_N"] / 1e3 for depth in depths}
    assert max(forces, key=lambda depth: forces[depth]) == governs
    assert found["horizontal_force_N"] == at[governs]["horizontal_force_N"]
    high, low = (f"{forces[depth]:.2f} kN in {depth}" for depth in depths)
    assert found["assumptions"][0] == f"The larger of both water levels: {high}, {low}."
