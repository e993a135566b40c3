"""S3: the force of wind, current and waves on its tanker, printed without a way to it."""

from __future__ import annotations

from catopt.loads.tanker_20m import TankerComparison, compare_tanker
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, Study
from catopt.reproduce.published import published
from catopt.units import UNITS, Dimension
from catopt.words import Message, Several

__all__ = ["NAME", "study"]

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
    return study_of(
        source,
        inputs=inputs,
        items=compare(
            source,
            "environment",
            {"horizontal_force_kN": loaded.loads.horizontal_force / _KN},
            {"horizontal_force_kN": loaded.statement.words},
            computed_by="open formulas",
        ),
        findings=(_parts(loaded), _spread(), *loaded.estimates),
    )


def _parts(loaded: TankerComparison) -> str:
    components = loaded.loads.components
    parts = Several(
        Message("reproduce.force_part", name=each.name, force=abs(each.force) / _KN)
        for each in components
    )
    return Message("reproduce.no_way", parts=parts)


def _spread() -> str:
    ballast = compare_tanker("ballast").loads.horizontal_force / _KN
    regular = compare_tanker(drift="largest wave").loads.horizontal_force / _KN
    return Message("reproduce.ballast_kn_what_least_sure", ballast=ballast, regular=regular)
