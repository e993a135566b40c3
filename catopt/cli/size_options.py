"""Options of ``catopt size`` and ``catopt loads``: what they are called and what they take."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Any

import typer

__all__ = [
    "DEFAULTS",
    "MEASURES",
    "BreadthOption",
    "BuoysOption",
    "ChainOption",
    "CodeOption",
    "CurrentOption",
    "DensityOption",
    "DepthOption",
    "DiameterMaxOption",
    "DiameterMinOption",
    "FrictionOption",
    "GrowthOption",
    "HmaxOption",
    "HsOption",
    "LengthOption",
    "LifeOption",
    "LowWaterOption",
    "Material",
    "PeriodOption",
    "PreferOption",
    "Preference",
    "RecalledOption",
    "SaveOption",
    "SinkerDensityOption",
    "SinkerOption",
    "StepOption",
    "WearOption",
    "WindOption",
    "measure",
]

MEASURES: Mapping[str, str] = MappingProxyType(
    {
        "--depth": "LENGTH",
        "--low-water": "LENGTH",
        "--wind": "SPEED",
        "--current": "SPEED",
        "--hs": "LENGTH",
        "--hmax": "LENGTH",
        "--period": "TIME",
        "--wind-angle": "ANGLE",
        "--current-angle": "ANGLE",
        "--wave-angle": "ANGLE",
        "--friction": "NUMBER",
        "--sinker-density": "DENSITY",
        "--diameter-min": "LENGTH",
        "--diameter-max": "LENGTH",
        "--length-step": "LENGTH",
        "--life": "TIME",
        "--wear": "SPEED",
        "--water-density": "DENSITY",
        "--force": "FORCE",
        "--reserve-buoyancy": "FORCE",
        "--keel-depth": "LENGTH",
        "--growth": "LENGTH",
        "--pull": "FORCE",
        "--length": "LENGTH",
        "--waterline": "LENGTH",
        "--breadth": "LENGTH",
        "--draught": "LENGTH",
        "--ballast-draught": "LENGTH",
        "--moulded-depth": "LENGTH",
        "--dwt": "MASS",
        "--frontal-area": "AREA",
        "--lateral-area": "AREA",
        "--fairlead": "LENGTH",
        "--hawser": "LENGTH",
        "--pretension": "NUMBER",
        "--clump-weight": "MASS",
    }
)
"""Options with a unit, each with the name of its dimension."""

DEFAULTS: Mapping[str, str] = MappingProxyType(
    {
        "--wind": "25 m/s",
        "--current": "1 m/s",
        "--hs": "2 m",
        "--life": "5 years",
        "--wear": "0.4 mm/year",
    }
)
"""What is taken when it is not given, as a user would write it."""


class Preference(StrEnum):
    """Which of the best lines is recommended."""

    BALANCED = "balanced"
    LIGHTEST = "lightest"
    LEAST_SWING = "least-swing"


class Material(StrEnum):
    """Of a sinker."""

    CONCRETE = "concrete"
    STEEL = "steel"


def measure(flag: str, text: str) -> Any:
    """Declare an option with a unit.

    Parameters
    ----------
    flag : str
        One of `MEASURES`, which says what it takes.
    text : str
        Of its help.
    """
    return typer.Option(flag, metavar=MEASURES[flag], help=text)


def _option(flag: str, metavar: str, text: str) -> Any:
    return typer.Option(flag, metavar=metavar, help=text)


# ------------------------------------------------------------------ place and weather

DepthOption = Annotated[str | None, measure("--depth", 'Water depth at high water, as "12 m".')]
LowWaterOption = Annotated[
    str | None, measure("--low-water", "Water depth at low water; --depth when left out.")
]
WindOption = Annotated[str | None, measure("--wind", "Wind at 10 m; 25 m/s when left out.")]
CurrentOption = Annotated[str | None, measure("--current", "Tidal current; 1 m/s when left out.")]
HsOption = Annotated[
    str | None,
    measure("--hs", "Significant wave height; 2 m when neither it nor --hmax is given."),
]
HmaxOption = Annotated[
    str | None, measure("--hmax", "Height of the largest wave; 1.85 Hs when left out.")
]
PeriodOption = Annotated[
    str | None,
    measure("--period", "Wave period; 3.6 s times the root of Hs in m when left out."),
]
DensityOption = Annotated[str, measure("--water-density", "Density of the water.")]

# ------------------------------------------------------------------ buoy and ship

BuoysOption = Annotated[
    Path | None, _option("--buoys", "FILE", "File of buoys of your own (TOML).")
]
GrowthOption = Annotated[str, measure("--growth", "Thickness of marine growth on hull and chain.")]
LengthOption = Annotated[str | None, measure("--length", "Length over all.")]
BreadthOption = Annotated[str | None, measure("--breadth", "Breadth.")]

# ------------------------------------------------------------------ line and sinker

FrictionOption = Annotated[
    str | None,
    measure("--friction", "Friction of the sinker on its soil, in place of --soil."),
]
SinkerOption = Annotated[
    Material, _option("--sinker", "MATERIAL", "Of the sinker: concrete or steel.")
]
SinkerDensityOption = Annotated[
    str | None, measure("--sinker-density", "Of the sinker; 2400 or 7850 kg/m^3 if left out.")
]
ChainOption = Annotated[
    list[str] | None,
    _option("--chain", "NAME", "Family with its grade; may be given several times."),
]
DiameterMinOption = Annotated[
    str | None, measure("--diameter-min", "Smallest size of chain to look at.")
]
DiameterMaxOption = Annotated[
    str | None, measure("--diameter-max", "Largest size of chain to look at.")
]
StepOption = Annotated[str | None, measure("--length-step", "Step of the length of the chain.")]
CodeOption = Annotated[str | None, _option("--code", "NAME", "Profile of criteria to check by.")]
PreferOption = Annotated[
    Preference,
    _option(
        "--prefer",
        "WHICH",
        "Which of the best lines to recommend: balanced, lightest or least-swing.",
    ),
]
LifeOption = Annotated[str | None, measure("--life", "Service life; 5 years when left out.")]
WearOption = Annotated[
    str | None,
    measure("--wear", "Loss of nominal diameter; 0.4 mm/year when left out."),
]
RecalledOption = Annotated[
    bool,
    typer.Option("--recalled", help="Allow figures that were read in no document (R)."),
]
SaveOption = Annotated[
    Path | None,
    _option(
        "--save",
        "CASE",
        "Write a case file of the recommended line here, which design, check and solve take. A "
        "file that is already there is never overwritten.",
    ),
]
