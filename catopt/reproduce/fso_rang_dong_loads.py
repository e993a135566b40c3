"""S4: the static force on FSO Rang Dong by our methods, loaded and in ballast, beside the print."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product
from typing import Final

from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.loads.component import Loads
from catopt.loads.environment import SeaState, SurfaceCurrent, Wind
from catopt.loads.heading import Headings
from catopt.loads.ship import Ship
from catopt.loads.ship_estimate import BLOCK, MIDSHIP
from catopt.loads.ship_loads import METHODS, TCN, ship_loads
from catopt.loads.tcn_222_95 import wave_height
from catopt.loads.weathervane import YAW_TYPES, Afloat, Lying, Turning, every_lying
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, SideBySide, Study, in_unit
from catopt.reproduce.published import Published, published
from catopt.reproduce.tanker_20m_loads import load_row
from catopt.ties import largest
from catopt.units import UNITS, Dimension
from catopt.words import Message, Several, term

NAME = "fso_rang_dong_loads"

CONDITIONS: Final = ("loaded", "ballast")

_KN = UNITS[Dimension.FORCE]["kN"]
_CURRENT_OFF = (0.0, 30.0, 60.0, 90.0)
"""deg: S4's own directions for what is not collinear are not at hand."""


def fso(source: Published, condition: str) -> Ship:
    """Make the ship of Table 4.1 afloat.

    `condition`: one of `CONDITIONS`.
    """
    given = source.inputs
    length, breadth = given["length_m"], given["breadth_m"]
    draught = given[f"draught_{condition}_m"]
    section = breadth * draught
    return Ship(
        "FSO",
        length,
        length,
        breadth,
        draught,
        BLOCK[condition] * length * section,
        MIDSHIP * section,
        _lateral_area(source, draught),
        given[f"frontal_area_{condition}_m2"],
        "tanker",
    )


def _lateral_area(source: Published, draught: float) -> float:
    """Take the area in ballast less what lies deeper: the print for the loaded ship is wrong."""
    given = source.inputs
    sunk = draught - given["draught_ballast_m"]
    return given["lateral_area_ballast_m2"] - given["length_m"] * sunk


def fso_loads(source: Published, condition: str, method: str) -> Loads:
    """Compute the forces, all from ahead.

    `condition`: one of `CONDITIONS`; `method`: one of `catopt.loads.METHODS`.
    """
    return ship_loads(
        fso(source, condition),
        *_weather(source),
        wind_on=f"tanker {condition}",
        method=method,
    )


def _weather(source: Published) -> tuple[Wind, SurfaceCurrent, SeaState, float]:
    given = source.inputs
    wind = Wind(given["wind_speed_m_per_s"])
    current = SurfaceCurrent(given["current_speed_m_per_s"])
    return wind, current, _sea(source), given["water_depth_m"]


def _sea(source: Published) -> SeaState:
    given = source.inputs
    return SeaState(given["wave_period_s"], given["wave_height_significant_m"])


def study() -> Study:
    """Compute the force by every method at both draughts, and judge the printed one."""
    source = published(NAME)
    ours = {condition: fso_loads(source, condition, METHODS[0]) for condition in CONDITIONS}
    condition = largest(CONDITIONS, lambda each: ours[each].horizontal_force)
    governs = ours[condition]
    remark = Message("reproduce.fso_beside", condition=term(condition), method=governs.method)
    made = study_of(
        source,
        inputs=_inputs(source),
        items=compare(
            source,
            "Table 4.2",
            {"horizontal_force_kN": governs.horizontal_force / _KN},
            {"horizontal_force_kN": remark},
            computed_by="open formulas",
        ),
        findings=(_differs(source, condition, governs), _about_the_ship(source)),
    )
    return replace(made, side_by_side=(_side_by_side(source), _not_collinear(source)))


def _inputs(source: Published) -> tuple[Input, ...]:
    given = source.inputs
    areas = f"{given['frontal_area_loaded_m2']:g}, {given['frontal_area_ballast_m2']:g}"
    return (
        Input("wind speed", f"{given['wind_speed_m_per_s']:g}", "m/s"),
        Input("current speed at the surface", f"{given['current_speed_m_per_s']:g}", "m/s"),
        Input("significant wave height", f"{given['wave_height_significant_m']:g}", "m"),
        Input("wave period", f"{given['wave_period_s']:g}", "s"),
        Input("water depth", f"{given['water_depth_m']:g}", "m"),
        Input("length between perpendiculars", f"{given['length_m']:g}", "m"),
        Input("breadth", f"{given['breadth_m']:g}", "m"),
        Input("draught, loaded", f"{given['draught_loaded_m']:g}", "m"),
        Input("draught, in ballast", f"{given['draught_ballast_m']:g}", "m"),
        Input("frontal wind area, loaded and in ballast", areas, "m2"),
        Input("lateral wind area, in ballast", f"{given['lateral_area_ballast_m2']:g}", "m2"),
    )


def _side_by_side(source: Published) -> SideBySide:
    (printed,) = source.printed["Table 4.2"].values()
    rows = []
    for condition, method in product(CONDITIONS, METHODS):
        row = load_row(fso_loads(source, condition, method))
        rows.append((Several((row[0], term(condition)), ", "), *row[1:]))
    header = ("method", *(in_unit(name, "kN") for name in ("wind", "current", "waves", "sum")))
    last = ("S4", "-", "-", "-", printed.text, "-")
    return SideBySide("The force by each method and draught", (*header, "grade"), (*rows, last))


def fso_lyings(source: Published, degrees: float) -> tuple[Lying, ...]:
    """Find how the ship lies on its external turret when the current comes from another side."""
    wind, current, sea, depth = _weather(source)
    return every_lying(
        [Afloat(each, fso(source, each), f"tanker {each}") for each in CONDITIONS],
        wind,
        current,
        sea,
        [depth],
        [Headings(current=math.radians(degrees))],
        methods=METHODS[:1],
        turning=Turning(YAW_TYPES["series-60"]),
    )


def _not_collinear(source: Published) -> SideBySide:
    """Tabulate headings and forces with the current off wind and waves."""
    rows = []
    for degrees in _CURRENT_OFF:
        for each in fso_lyings(source, degrees):
            lies = (_degrees(each.heading), _degrees(each.headings.current))
            force = f"{each.loads.horizontal_force / _KN:.0f}"
            words = Message(
                "reproduce.current_off", condition=term(each.afloat.condition), angle=degrees
            )
            rows.append((words, *lies, force))
    return SideBySide(
        "Weathervaning by UFC-Blendermann, yaw of the current recalled (R)",
        (
            "current off wind and waves",
            in_unit("heading", "deg"),
            in_unit("current off the bow", "deg"),
            in_unit("sum", "kN"),
        ),
        tuple(rows),
    )


def _degrees(angle: float) -> str:
    """Write an angle to a tenth, without the sign of a zero."""
    return f"{round(math.degrees(angle), 1) + 0.0:.1f}"


def _differs(source: Published, condition: str, governs: Loads) -> Message:
    (printed,) = source.printed["Table 4.2"].values()
    tcn = fso_loads(source, condition, TCN).horizontal_force
    hull = source.inputs["breadth_m"] * source.inputs[f"draught_{condition}_m"]
    weight = SEA_WATER_DENSITY * STANDARD_GRAVITY * wave_height(_sea(source)) * hull
    return Message(
        "reproduce.fso_differs",
        printed=printed.value,
        drift=governs.of("wave drift") / _KN,
        force=governs.horizontal_force / _KN,
        tcn=tcn / _KN,
        chi=(printed.value * _KN - tcn) / weight,
    )


def _about_the_ship(source: Published) -> Message:
    given = source.inputs
    lateral = _lateral_area(source, given["draught_loaded_m"])
    return Message("reproduce.fso_ship", misprint=given["lateral_area_loaded_m2"], lateral=lateral)
