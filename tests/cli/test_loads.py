"""``catopt loads``: its methods, and which input counts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from catopt.loads import METHODS, compare_tanker
from catopt.sizing.environment import DIRECTIONS
from catopt.sizing.inputs import Input, rows_of

from .conftest import OWN, Run, document_of, typed


def test_every_method_is_shown_and_the_one_that_is_named_comes_first(run: Run) -> None:
    found = document_of(run, *typed("LOADS_SHIP"))
    by_method = [found, *found["others"]]
    # The options say what Python is given in other numbers, such as 0.97 x 234 m.
    assert [each["method"] for each in by_method] == list(METHODS)
    for each in by_method:
        total = compare_tanker(method=each["method"]).loads.horizontal_force
        assert each["horizontal_force_N"] == pytest.approx(total, rel=1e-12)


PLACE = {body: (OWN / f"loads-{body}.toml").read_text("utf-8") for body in ("buoy", "ship")}
ACROSS = ("--wind-angle", "90 deg", "--current-angle", "90 deg")
LOW = {"buoy": "2.5 m", "ship": "14 m"}
OTHERS = {"water_density": 1010, "load_method": ["22TCN-222-95"]}
"""Values that count where the example of the table would not."""
TURNS = {"environment.current_yaw": "series-60", "environment.current_angle": "60 deg"}
"""Beside the directions of a ship that weathervanes."""


def loads_of(run: Run, folder: Path, body: str, keys: dict[str, Any]) -> tuple[int, Any, str]:
    """Compute the loads of a file with these keys, too; status, document and what is told."""
    path = folder / "sizing.toml"
    further = "".join(f"{key} = {json.dumps(value)}\n" for key, value in keys.items())
    path.write_text(PLACE[body] + further)
    across = body == "ship" and "environment.current_yaw" not in keys
    ran = run("loads", body, path, "--json", *(ACROSS if across else ()))
    return ran.status, json.loads(ran.out) if ran.out else None, ran.err


@pytest.mark.parametrize(
    ("body", "each"),
    [
        (body, each)
        for body, moored in (("buoy", "buoy"), ("ship", "tanker"))
        for each in rows_of(moored)
        if f"{each.key} = " not in PLACE[body]
        and each.key != "ship.deadweight"  # held against the displacement, in mistakes.txt
    ],
    ids=lambda each: each if isinstance(each, str) else each.key,
)
def test_no_key_of_a_sizing_is_ignored_in_silence(
    run: Run, tmp_path: Path, body: str, each: Input
) -> None:
    """It changes the loads, is refused by its name, or is said to have no part in them."""
    beside = TURNS if each.name in DIRECTIONS else {}
    _, without, _ = loads_of(run, tmp_path, body, beside)
    value = LOW[body] if each.name == "low_water" else OTHERS.get(each.name, each.example)
    status, found, told = loads_of(run, tmp_path, body, {**beside, each.key: value})
    if status == 2:
        assert each.key in told or str(value) in told
        return
    assert status == 0
    named = [said for said in found["assumptions"] if said.startswith("Given, but not used")]
    if any(each.key in said for said in named):
        assert found["components"] == without["components"]
    elif (body, each.name) == ("buoy", "low_water"):
        # By CALMAR the depth changes the chain alone, which is longer at high water.
        said = "The larger of both water levels: "
        assert any(text.startswith(said) for text in found["assumptions"])
    else:
        assert (found["components"], found["others"]) != (without["components"], without["others"])


SAVED = """<Calmar version="1.0.0.0">
<Buoy Name="Drum" ChaineMin="20" ChaineMax="30" MasseLestUnitaire="0" NombreLestMin="0"
  NombreLestMax="0">
<Structure Name="" Masse="0" OffsetFlotteur="0" OffsetOrganeau="0" />
<Flotteur Name="Drum" Masse="1025">
<ElementDimItem H="2" D0="2" D1="2" DI="0" Volume="4" />
</Flotteur></Buoy></Calmar>"""
"""2 m3 a metre: 1025 kg float at half a metre."""


def test_a_buoy_that_calmar_saved_takes_the_place_of_a_name(run: Run, tmp_path: Path) -> None:
    """1/2 x 1025 x 1 x (2 m x 0.5 m) x 1.2 = 615 N."""
    path = tmp_path / "drum.xmlMB"
    path.write_text(SAVED)
    found = document_of(run, "loads", "buoy", path, "--depth", "9 m", "--current", "1 m/s")
    assert found["horizontal_force_N"] == pytest.approx(615.0, rel=1e-12)
    path.write_text(SAVED.replace("Volume", "Volumen"))
    ran = run("loads", "buoy", path, "--depth", "9 m", "--current", "1 m/s")
    assert ran.status == 2
    assert "Buoy.Flotteur.ElementDimItem[0].Volume: missing" in ran.err
    assert "drum.xmlMB: 2 errors" in ran.err


@pytest.mark.parametrize("moored", [("buoy", "pillar 1.8 m"), ("ship", "--dwt", "5000 t")])
def test_a_fetch_raises_a_sea_for_the_loads_too(run: Run, moored: tuple[str, ...]) -> None:
    """The waves of a fetch count and are told; nothing says that they are no part of it."""
    weather = ("--depth", "12 m", "--wind", "20 m/s", "--fetch", "20 km")
    calm, found = (run("loads", *moored, *given) for given in (weather[:-2], weather))
    said = " ".join(found.out.split())
    assert "over 20 km of water 12 m deep" in said
    assert "no part" not in said
    assert found.out != calm.out


@pytest.mark.parametrize(
    ("moored", "height", "period"),
    [
        (("buoy", "pillar 1.8 m"), ("--hs", "2 m"), "5.1 s"),  # 3.6 sqrt(2) = 5.09
        (("ship", "--dwt", "5000 t"), ("--hmax", "3.7 m"), "5.1 s"),  # Hs = 3.7 m / 1.85
    ],
)
def test_a_period_that_is_left_out_is_that_of_a_sizing(
    run: Run, moored: tuple[str, ...], height: tuple[str, ...], period: str
) -> None:
    asked = ("loads", *moored, "--depth", "12 m", "--wind", "20 m/s", *height)
    taken, given = (document_of(run, *asked, *own) for own in ((), ("--period", period)))
    assert taken["horizontal_force_N"] == given["horizontal_force_N"]
    words = f"wave period {period}, 3.6 s times the square root of Hs in m"
    assert any(each.startswith(words) for each in taken["assumptions"])
    assert not any(each.startswith("wave period") for each in given["assumptions"])
