"""docs/loads.md: every number of its two worked examples is what catopt computes."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from catopt.loads import (
    YAW_TYPES,
    Afloat,
    Headings,
    Loads,
    SeaState,
    SurfaceCurrent,
    Turning,
    WaterLevels,
    Wind,
    buoy,
    buoy_loads,
    compare_tanker,
    every_lying,
    size_sinker,
    surface_speed,
)
from catopt.loads.ship import Condition
from catopt.loads.ship_loads import depth_factor
from catopt.loads.tanker_20m import CURRENT, SEA, WATER_DEPTH, WIND, tanker
from catopt.loads.ufc import propeller_area, wetted_surface

PAGE = Path(__file__).parents[2] / "docs" / "loads.md"
UNITS = {"m": 1.0, "m2": 1.0, "m3": 1.0, "m/s": 1.0, "1/m": 1.0, "N": 1.0, "kN": 1e3, "kg": 1.0}
NUMBER = re.compile(r"(?P<value>[\d.]+(?:e[+-]\d+)?)(?: (?P<unit>\S+))?")


def printed(heading: str) -> dict[str, str]:
    """Rows of the worked table below a heading."""
    _, _, below = PAGE.read_text("utf-8").partition(f"## {heading}\n")
    section = below.partition("\n## ")[0]
    rows = re.findall(r"^\| ([^|]+) \| [^|]* \| ([^|]+) \|$", section, re.MULTILINE)
    return {what: value for what, value in rows if what not in {"what", "---"}}


def agrees(text: str, value: float) -> bool:
    """Whether a value, rounded to the digits of a print, is that print."""
    match = NUMBER.fullmatch(text)
    assert match is not None, text
    scale = UNITS[match["unit"]] if match["unit"] else 1.0
    digits, _, exponent = match["value"].partition("e")
    decimals = len(digits.partition(".")[2])
    unit_of_last = 10.0 ** (int(exponent or 0) - decimals) * scale
    # Half a unit of the last printed digit, and a little for ties in double precision.
    return abs(float(match["value"]) * scale - value) <= 0.5001 * unit_of_last


def forces(of: Loads) -> dict[str, float]:
    return {each.name: abs(each.force) for each in of.components}


def worked_buoy() -> dict[str, float]:
    shape, wind, tide = buoy("pillar 1.8 m"), Wind(25.0), SurfaceCurrent(1.5)
    sea, levels = SeaState(6.0, 2.0), WaterLevels(10.0, 12.0)
    afloat = shape.afloat()
    of = buoy_loads(shape, wind, tide, sea, levels, chain_diameter=0.025)
    sinker = size_sinker(of.horizontal_force, 3e3, soil="clean fine to medium sand")
    return {
        "waterline": shape.waterplane_area,
        "draught": afloat.draught,
        "freeboard": afloat.freeboard,
        "reserve buoyancy": shape.reserve_buoyancy(),
        "Hmax": sea.hmax,
        "breaking height": sea.breaking_at(levels),
        "wave velocity": sea.deep_water_velocity,
        "surface speed": surface_speed(wind, tide, sea, 12.0),
        **forces(of),
        "chain height": levels.deepest(sea) - afloat.eye_depth,
        "horizontal force": of.horizontal_force,
        "sinker weight in water": sinker.needed_mass * 9.80665 * (1.0 - 1025.0 / 2400.0),
        "sinker, concrete": sinker.needed_mass,
        "sinker, next size": sinker.mass,
    }


def worked_tanker() -> dict[str, float]:
    ship, of = tanker(), compare_tanker().loads
    parts = forces(of)
    wave_number = SEA.wave_number(WATER_DEPTH)
    return {
        "frontal area": ship.frontal_area,
        "wind": parts["wind along the ship"],
        "current, form": parts["current along the ship, form"],
        "waterline length": ship.length_waterline,
        "volume": ship.displacement,
        "wetted surface": wetted_surface(ship.draught, ship.length_waterline, ship.displacement),
        "Reynolds number": 1.2 * ship.length_waterline / 1.19e-6,
        "current, friction": parts["current along the ship, friction"],
        "propeller area": propeller_area(ship.length_waterline, ship.breadth, 270.0),
        "current, propeller": parts["current along the ship, propeller"],
        "Hs": SEA.hs,
        "wave number": wave_number,
        "depth factor": depth_factor(wave_number, WATER_DEPTH),
        "wave drift": parts["wave drift along the ship"],
        "horizontal force": of.horizontal_force,
    }


EXAMPLES = [("A buoy by hand", worked_buoy()), ("A tanker by hand: S3's", worked_tanker())]


@pytest.mark.parametrize(("heading", "computed"), EXAMPLES)
def test_every_number_of_a_worked_example(heading: str, computed: dict[str, float]) -> None:
    rows = printed(heading)
    assert list(rows) == sorted(computed, key=list(rows).index)
    wrong = {what: (text, computed[what]) for what, text in rows.items()}
    assert {w: pair for w, pair in wrong.items() if not agrees(*pair)} == {}


def test_a_wrong_digit_is_noticed() -> None:
    assert agrees("0.4984 m", 0.49841)
    assert not agrees("0.4985 m", 0.49841)
    assert agrees("2.289e+08", 2.28887e8)
    assert not agrees("2.288e+08", 2.28887e8)
    assert agrees("128.0 kN", 127952.0)


def test_the_sentences_about_s3() -> None:
    """The area that 450 kN would want, and the drift of the largest wave."""
    text = PAGE.read_text("utf-8")
    loaded, largest = compare_tanker(), compare_tanker(drift="largest wave")
    wind = loaded.loads.of("wind")
    times = (450e3 - loaded.loads.horizontal_force + wind) / wind
    assert f"{times:.1f} times as large" in text
    for words in (
        f"{100.0 * (1.0 - loaded.ratio):.0f} % below",
        f"{compare_tanker('ballast').loads.horizontal_force / 1e3:.0f} kN",
        f"drift is {largest.loads.of('wave drift') / 1e3:.0f} kN",
        f"{largest.loads.horizontal_force / 1e3:.0f} kN, is {100.0 * (largest.ratio - 1.0):.0f} %",
    ):
        assert words in text.replace("\n", " ")


def test_the_sentences_about_headings() -> None:
    """Head on, and with the current 45 and 135 deg off wind and waves."""
    text = PAGE.read_text("utf-8").replace("\n", " ")
    conditions: tuple[Condition, ...] = ("loaded", "ballast")
    ships = [Afloat(each, tanker(each), f"tanker {each}") for each in conditions]
    for degrees, words in (
        (0, "{} kN head on, in ballast"),
        (45, "{} kN, loaded"),
        (135, "{} kN at"),
    ):
        found = every_lying(
            ships,
            WIND,
            CURRENT,
            SEA,
            [WATER_DEPTH],
            [Headings(current=math.radians(degrees))],
            methods=["UFC-Blendermann"],
            turning=Turning(YAW_TYPES["series-60"]),
        )
        worst = max(each.loads.horizontal_force for each in found)
        assert words.format(f"{worst / 1e3:.0f}") in text
