"""Options that the commands of ``catopt size`` share, and what they come to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

if TYPE_CHECKING:
    from catopt.cli.gathered import Gathered
    from catopt.cli.output import Output
    from catopt.loads import SeaState
    from catopt.sizing import Environment, Sizing

__all__ = [
    "DEFAULTS",
    "NAMES",
    "ChainOption",
    "CodeOption",
    "CurrentOption",
    "DensityOption",
    "DepthOption",
    "DiameterMaxOption",
    "DiameterMinOption",
    "FrictionOption",
    "HmaxOption",
    "HsOption",
    "LifeOption",
    "LowWaterOption",
    "PeriodOption",
    "PreferOption",
    "Preference",
    "RecalledOption",
    "SaveOption",
    "StepOption",
    "WearOption",
    "WindOption",
    "check_save",
    "environment",
    "give",
    "missing",
    "sized",
    "taken",
]


Request = TypeVar("Request")


class Preference(StrEnum):
    """Which of the best lines is recommended."""

    BALANCED = "balanced"
    LIGHTEST = "lightest"
    LEAST_SWING = "least-swing"


def _option(flag: str, metavar: str, text: str) -> Any:
    return typer.Option(flag, metavar=metavar, help=text)


DepthOption = Annotated[
    str | None, _option("--depth", "LENGTH", 'Water depth at high water, as "12 m".')
]
LowWaterOption = Annotated[
    str | None,
    _option("--low-water", "LENGTH", "Water depth at low water; --depth when left out."),
]
WindOption = Annotated[
    str | None, _option("--wind", "SPEED", "Wind at 10 m; 25 m/s when left out.")
]
CurrentOption = Annotated[
    str | None, _option("--current", "SPEED", "Tidal current; 1 m/s when left out.")
]
HsOption = Annotated[
    str | None,
    _option("--hs", "LENGTH", "Significant wave height; 2 m when neither it nor --hmax is given."),
]
HmaxOption = Annotated[
    str | None, _option("--hmax", "LENGTH", "Height of the largest wave; 1.85 Hs when left out.")
]
PeriodOption = Annotated[
    str | None,
    _option("--period", "TIME", "Wave period; 3.6 s times the root of Hs in m when left out."),
]
FrictionOption = Annotated[
    str | None,
    _option("--friction", "NUMBER", "Friction of the sinker on its soil, in place of --soil."),
]
ChainOption = Annotated[
    list[str] | None,
    _option("--chain", "NAME", "Family with its grade; may be given several times."),
]
DiameterMinOption = Annotated[
    str | None, _option("--diameter-min", "LENGTH", "Smallest size of chain to look at.")
]
DiameterMaxOption = Annotated[
    str | None, _option("--diameter-max", "LENGTH", "Largest size of chain to look at.")
]
StepOption = Annotated[
    str | None, _option("--length-step", "LENGTH", "Step of the length of the chain.")
]
CodeOption = Annotated[str | None, _option("--code", "NAME", "Profile of criteria to check by.")]
PreferOption = Annotated[
    Preference,
    _option(
        "--prefer",
        "WHICH",
        "Which of the best lines to recommend: balanced, lightest or least-swing.",
    ),
]
LifeOption = Annotated[
    str | None, _option("--life", "TIME", "Service life; 5 years when left out.")
]
WearOption = Annotated[
    str | None,
    _option("--wear", "SPEED", "Loss of nominal diameter; 0.4 mm/year when left out."),
]
DensityOption = Annotated[str, _option("--water-density", "DENSITY", "Density of the water.")]
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

NAMES: Mapping[str, str] = MappingProxyType(
    {
        "buoy": "BUOY",
        "Wind.speed": "--wind",
        "SurfaceCurrent.speed": "--current",
        "current.speed": "--current",
        "wind": "--wind",
        "significant_height": "--hs",
        "maximum_height": "--hmax",
        "period": "--period",
        "low": "--low-water",
        "levels.low": "--low-water",
        "high": "--depth",
        "levels.high": "--depth",
        "keel_depth": "--keel-depth",
        "horizontal_force": "--force",
        "reserve_buoyancy": "--reserve-buoyancy",
        "pull": "--reserve-buoyancy",
        "marine_growth": "--growth",
        "water_density": "--water-density",
        "components": "--chain",
        "component": "--chain",
        "code": "--code",
        "diameter_min": "--diameter-min",
        "diameter_max": "--diameter-max",
        "length_step": "--length-step",
        "life": "--life",
        "wear_rate": "--wear",
        "soil": "--soil",
        "friction": "--friction",
        "material": "--sinker",
        "density": "--sinker-density",
        "anchor": "--anchor",
        "length_overall": "--length",
        "breadth": "--breadth",
        "draught": "--draught",
        "ballast_draught": "--ballast-draught",
        "moulded_depth": "--moulded-depth",
        "deadweight": "--dwt",
        "frontal_area": "--frontal-area",
        "lateral_area": "--lateral-area",
        "fairlead": "--fairlead",
        "hawser": "--hawser",
        "lines": "--lines",
        "pretension": "--pretension",
        "clump_masses[0]": "--clump-weight",
        "displacement": "--block",
    }
)
"""Options by what they are called in Python."""


def taken(given: Mapping[str, str | None], options: tuple[str, ...]) -> dict[str, str]:
    """List the defaults of options that were not given, by option.

    Parameters
    ----------
    given : mapping of str to str or None
        Options as they were given; None: left out.
    options : tuple of str
        Those that count.
    """
    if given.get("--hmax") is not None:
        options = tuple(each for each in options if each != "--hs")
    return {each: DEFAULTS[each] for each in options if given.get(each) is None}


def missing(gathered: Gathered, given: Mapping[str, str | None], wanted: Mapping[str, str]) -> None:
    """Note every option that is wanted and was not given, with an example.

    Parameters
    ----------
    gathered : Gathered
        Where to.
    given : mapping of str to str or None
        Options as they were given.
    wanted : mapping of str to str
        Example by option.
    """
    for option, example in wanted.items():
        if given.get(option) is None:
            gathered.add(option, "", f'missing; it is wanted, such as "{example}"')


def environment(
    gathered: Gathered, values: Mapping[str, float], *, is_pushed: bool = True
) -> Environment | None:
    """Make depths and weather out of options in SI; None, with the problems kept, when wrong.

    Parameters
    ----------
    gathered : Gathered
        Keeps the problems.
    values : mapping of str to float
        Options, in SI.
    is_pushed : bool
        Whether wind and current count; where the force is given, they do not.
    """
    from catopt.loads import SurfaceCurrent, WaterLevels, Wind
    from catopt.sizing import Environment

    high = values.get("--depth")
    levels = gathered.make(
        WaterLevels, None if high is None else values.get("--low-water", high), high
    )
    wind = gathered.make(Wind, values["--wind"] if is_pushed else 0.0)
    current = gathered.make(SurfaceCurrent, values["--current"] if is_pushed else 0.0)
    sea = gathered.make(_sea, values)
    density = values["--water-density"]
    return gathered.make(
        lambda a, b, c, d: Environment(a, b, c, d, density), levels, wind, current, sea
    )


def _sea(values: Mapping[str, float]) -> SeaState:
    """Make the waves; the period follows from the height where it is not given."""
    from catopt.loads import SeaState
    from catopt.loads.environment import HMAX_OVER_HS
    from catopt.sizing.environment import usual_period

    height, largest = values.get("--hs"), values.get("--hmax")
    significant = height if height is not None else (largest or 0.0) / HMAX_OVER_HS
    period = values.get("--period", usual_period(max(significant, 0.0)))
    return SeaState(period, height, largest)


def check_save(place: Path | None) -> None:
    """Make sure, before anything is computed, that a case can be saved.

    Raises
    ------
    InputError
        There is a file already, or no such directory.
    """
    from catopt.errors import InputError, Problem

    if place is None:
        return
    if place.exists():
        allowed = "is there already and is kept; give another path"
        raise InputError([Problem("--save", str(place), allowed)], "options")
    if not place.parent.is_dir():
        allowed = f"there is no directory {place.parent}"
        raise InputError([Problem("--save", str(place), allowed)], "options")


def sized(maker: Callable[[Request], Sizing], request: Request) -> Sizing:
    """Size what is requested; what is wrong with it is told by the options' names.

    Parameters
    ----------
    maker : callable
        `catopt.sizing.size_buoy` or `size_tanker`.
    request : BuoyRequest or TankerRequest
        For it.
    """
    from catopt.cli.gathered import Gathered

    gathered = Gathered(NAMES)
    found = gathered.make(maker, request)
    gathered.raise_if_any()
    assert found is not None
    return found


def give(output: Output, of: Sizing, *, as_json: bool, out: Path | None, save: Path | None) -> None:
    """Write the files, then print the document or the view.

    Parameters
    ----------
    output : Output
        Where to.
    of : Sizing
        What came out.
    as_json : bool
        Whether to print the document.
    out, save : Path or None
        Directory for all files, and place of the case file.
    """
    if out is not None:
        from catopt.report.files import write_files
        from catopt.report.size import size_bundle

        written = write_files(out, size_bundle(of))
        output.note(f"{len(written)} files written to {out}")
    if save is not None:
        from catopt.casefile import write_case
        from catopt.report.files import write_files

        write_files(save.parent, {save.name: write_case(of.case).encode()})
        output.note(f"{save} written; refine it with: catopt design {save}")
    if as_json:
        output.json(of.to_dict())
        return
    from catopt.cli.size_view import show_sizing

    show_sizing(output, of)
