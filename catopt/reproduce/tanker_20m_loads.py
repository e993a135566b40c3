"""S3: the force of wind, current and waves on its tanker, by three methods beside the print."""

from __future__ import annotations

from dataclasses import replace

from catopt.catalogue.figure import weakest
from catopt.loads.component import Loads
from catopt.loads.ship_loads import METHODS, TCN
from catopt.loads.tanker_20m import compare_tanker
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, SideBySide, Study, in_unit
from catopt.reproduce.published import Published, published
from catopt.units import UNITS, Dimension
from catopt.words import Message

NAME = "tanker_20m_loads"

_KN = UNITS[Dimension.FORCE]["kN"]


def study() -> Study:
    """Compute the force by open formulas and judge the printed one."""
    source = published(NAME)
    loaded = compare_tanker()
    given = source.inputs
    inputs = [
        Input("wind speed", f"{given['wind_speed_m_per_s']:g}", "m/s"),
        Input("current speed", f"{given['current_speed_m_per_s']:g}", "m/s"),
        Input("largest wave height", f"{given['wave_height_max_m']:g}", "m"),
        Input("wave period", f"{given['wave_period_s']:g}", "s"),
        Input("length of the ship", f"{given['length_m']:g}", "m"),
        Input("breadth", f"{given['breadth_m']:g}", "m"),
        Input("draught, loaded", f"{given['draught_m']:g}", "m"),
        Input("water depth", f"{given['water_depth_m']:g}", "m"),
    ]
    made = study_of(
        source,
        inputs=inputs,
        items=compare(
            source,
            "environment",
            {"horizontal_force_kN": loaded.loads.horizontal_force / _KN},
            {"horizontal_force_kN": loaded.statement.words},
            computed_by="open formulas",
        ),
        findings=(_found(), _spread(), *loaded.estimates),
    )
    return replace(made, side_by_side=(_methods(source),))


def _found() -> str:
    """Say which method comes near the print."""
    found = compare_tanker(method=TCN)
    loads = found.loads
    return Message(
        "reproduce.by_tcn",
        force=loads.horizontal_force / _KN,
        current=loads.of("current") / _KN,
        wind=loads.of("wind") / _KN,
        share=100.0 * (1.0 - found.ratio),
    )


def _methods(source: Published) -> SideBySide:
    """Set the parts of the force by each method side by side."""
    (printed,) = source.printed["environment"].values()
    every = (compare_tanker(method=method) for method in METHODS)
    return SideBySide(
        "The force by each method",
        ("method", *(in_unit(name, "kN") for name in ("wind", "current", "waves", "sum")), "grade"),
        (*map(load_row, (each.loads for each in every)), ("S3", "-", "-", "-", printed.text, "-")),
    )


def load_row(of: Loads) -> tuple[str, ...]:
    """Write the parts of a force by its method, kN, with the grade of the least sure of them."""
    kinds = {each.kind for each in of.components}
    waves = [of.of(kind) for kind in ("wave drift", "wave") if kind in kinds]
    return (
        of.method,
        f"{of.of('wind') / _KN:.1f}",
        f"{of.of('current') / _KN:.1f}",
        f"{waves[0] / _KN:.1f}" if waves else "-",
        f"{of.horizontal_force / _KN:.1f}",
        weakest(each.source.confidence for each in of.components),
    )


def _spread() -> str:
    ballast = compare_tanker("ballast").loads.horizontal_force / _KN
    regular = compare_tanker(drift="largest wave").loads.horizontal_force / _KN
    return Message("reproduce.ballast_kn_what_least_sure", ballast=ballast, regular=regular)
