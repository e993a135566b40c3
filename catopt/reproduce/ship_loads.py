"""S3 and S4: wind, current and waves on a tanker and on FSO Rang Dong, beside the prints."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product
from typing import Final

from catopt.catalogue.components import weakest
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.largest import largest
from catopt.loads.component import Loads
from catopt.loads.environment import Headings, SeaState, SurfaceCurrent, Wind
from catopt.loads.ship import BLOCK, MIDSHIP, Ship
from catopt.loads.ship_loads import METHODS, TCN, ship_loads
from catopt.loads.tanker_20m import compare_tanker
from catopt.loads.tcn_222_95 import wave_height
from catopt.loads.weathervane import YAW_TYPES, Afloat, ShipHeading, Turning, every_lying
from catopt.reproduce.items import (
    KN,
    Published,
    SideBySide,
    Study,
    compare,
    in_unit,
    published,
    study_of,
)
from catopt.words import Message, Several, term

CONDITIONS: Final = ("loaded", "ballast")

_FORCE = "horizontal_force_kN"
_PLACE = "Table 4.7"


def _by_parts(title: str, rows: Iterator[tuple[str, ...]], source: Published) -> SideBySide:
    """Set the parts of the force by our methods beside the one that a source printed."""
    (printed,) = (number for table in source.printed.values() for number in table.values())
    columns = (in_unit(name, "kN") for name in ("wind", "current", "waves", "sum"))
    last = (source.source, "-", "-", "-", printed.text, "-")
    return SideBySide(title, ("method", *columns, "grade"), (*rows, last))


def _row(of: Loads, *condition: str) -> tuple[str, ...]:
    """Write the parts of a force by its method, kN, with the grade of the least sure of them."""
    kinds = {component.kind for component in of.components}
    waves = [of.of(kind) for kind in ("wave drift", "wave") if kind in kinds]
    return (
        Several((of.method, *map(term, condition)), ", ") if condition else of.method,
        f"{of.of('wind') / KN:.1f}",
        f"{of.of('current') / KN:.1f}",
        f"{waves[0] / KN:.1f}" if waves else "-",
        f"{of.horizontal_force / KN:.1f}",
        weakest(component.source.confidence for component in of.components),
    )


# ------------------------------------------------------------------ S3: the tanker


def tanker_20m_loads() -> Study:
    """Compute the force by open formulas and judge the printed one."""
    source = published("tanker_20m_loads")
    loaded, by_tcn = compare_tanker(), compare_tanker(method=TCN)
    near = Message(
        "reproduce.by_tcn",
        force=by_tcn.loads.horizontal_force / KN,
        current=by_tcn.loads.of("current") / KN,
        wind=by_tcn.loads.of("wind") / KN,
        share=100.0 * (1.0 - by_tcn.ratio),
    )
    spread = Message(
        "reproduce.ballast_kn_what_least_sure",
        ballast=compare_tanker("ballast").loads.horizontal_force / KN,
        regular=compare_tanker(drift="largest wave").loads.horizontal_force / KN,
    )
    rows = (_row(compare_tanker(method=method).loads) for method in METHODS)
    return study_of(
        source,
        items=compare(
            source,
            "environment",
            {_FORCE: loaded.loads.horizontal_force / KN},
            {_FORCE: loaded.statement.words},
            computed_by="open formulas",
        ),
        findings=(near, spread, *loaded.estimates),
        side_by_side=(_by_parts("The force by each method", rows, source),),
    )


# ------------------------------------------------------------------ S4: FSO Rang Dong


def fso_rang_dong_loads() -> Study:
    """Compute the force by every method at both draughts, and judge the printed one."""
    source = published("fso_rang_dong_loads")
    ours = {condition: fso_loads(source, condition, METHODS[0]) for condition in CONDITIONS}
    condition = largest(CONDITIONS, lambda each: ours[each].horizontal_force)
    governs = ours[condition]
    remark = Message("reproduce.fso_beside", condition=term(condition), method=governs.method)
    rows = (
        _row(fso_loads(source, condition, method), condition)
        for condition, method in product(CONDITIONS, METHODS)
    )
    about_the_ship = Message(
        "reproduce.fso_ship",
        misprint=source.inputs["lateral_area_loaded_m2"],
        lateral=fso(source, "loaded").lateral_area,
    )
    return study_of(
        source,
        items=compare(
            source,
            _PLACE,
            {_FORCE: governs.horizontal_force / KN},
            {_FORCE: remark},
            computed_by="open formulas",
        ),
        findings=(_differs(source, condition, governs), about_the_ship),
        side_by_side=(
            _by_parts("The force by each method and draught", rows, source),
            _not_collinear(source),
        ),
    )


def fso(source: Published, condition: str) -> Ship:
    """Make the ship of Table 4.1 afloat.

    `condition`: one of `CONDITIONS`. The lateral area is that in ballast less what lies deeper:
    the print for the loaded ship is wrong.
    """
    given = source.inputs
    length, breadth = given["length_m"], given["breadth_m"]
    draught = given[f"draught_{condition}_m"]
    section = breadth * draught
    sunk = draught - given["draught_ballast_m"]
    return Ship(
        "FSO",
        length,
        length,
        breadth,
        draught,
        BLOCK[condition] * length * section,
        MIDSHIP * section,
        given["lateral_area_ballast_m2"] - length * sunk,
        given[f"frontal_area_{condition}_m2"],
        "tanker",
    )


def fso_loads(source: Published, condition: str, method: str) -> Loads:
    """Compute the forces, all from ahead.

    `condition`: one of `CONDITIONS`; `method`: one of `catopt.loads.METHODS`.
    """
    ship, wind_on = fso(source, condition), f"tanker {condition}"
    return ship_loads(ship, *_weather(source), wind_on=wind_on, method=method)


def _weather(source: Published) -> tuple[Wind, SurfaceCurrent, SeaState, float]:
    """Wind, current and sea of Table 4.2, all from one side, and the water depth, m."""
    given = source.inputs
    sea = SeaState(given["wave_period_s"], given["wave_height_significant_m"])
    current = SurfaceCurrent(given["current_speed_m_per_s"])
    return Wind(given["wind_speed_m_per_s"]), current, sea, given["water_depth_m"]


def fso_lyings(
    source: Published, degrees: float, speed: float | None = None
) -> tuple[ShipHeading, ...]:
    """Find how the ship lies on its external turret when the current comes from another side.

    `speed`: of the current, m/s; without, that of the weather from one side.
    """
    wind, current, sea, depth = _weather(source)
    if speed is not None:
        current = SurfaceCurrent(speed)
    return every_lying(
        [
            Afloat(condition, fso(source, condition), f"tanker {condition}")
            for condition in CONDITIONS
        ],
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
    for degrees in source.series["current_off_deg"]:
        for lying in fso_lyings(source, degrees, source.inputs["current_off_m_per_s"]):
            condition = term(lying.afloat.condition)
            words = Message("reproduce.current_off", condition=condition, angle=degrees)
            lies = (_degrees(lying.heading), _degrees(lying.headings.current))
            rows.append((words, *lies, f"{lying.loads.horizontal_force / KN:.0f}"))
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


def _most_off(source: Published) -> tuple[float, ShipHeading]:
    """Give the largest force of Table 4.2's second weather, and from where the current comes."""
    speed = source.inputs["current_off_m_per_s"]
    every = [
        (degrees, lying)
        for degrees in source.series["current_off_deg"]
        for lying in fso_lyings(source, degrees, speed)
    ]
    return largest(every, lambda each: each[1].loads.horizontal_force)


def _differs(source: Published, condition: str, governs: Loads) -> Message:
    degrees, off = _most_off(source)
    printed = source.printed[_PLACE][_FORCE].value
    tcn = fso_loads(source, condition, TCN).horizontal_force
    hull = source.inputs["breadth_m"] * source.inputs[f"draught_{condition}_m"]
    _, _, sea, _ = _weather(source)
    weight = SEA_WATER_DENSITY * STANDARD_GRAVITY * wave_height(sea) * hull
    return Message(
        "reproduce.fso_differs",
        printed=printed,
        drift=governs.of("wave drift") / KN,
        force=governs.horizontal_force / KN,
        tcn=tcn / KN,
        chi=(printed * KN - tcn) / weight,
        speed=source.inputs["current_off_m_per_s"],
        most=off.loads.horizontal_force / KN,
        angle=degrees,
    )
