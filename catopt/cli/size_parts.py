"""What the options of ``catopt size`` and ``catopt loads`` come to: depths, weather, defaults."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from catopt.cli.size_options import DEFAULTS, MEASURES

if TYPE_CHECKING:
    from catopt.cli.gathered import Gathered
    from catopt.loads import SeaState
    from catopt.sizing import Environment

__all__ = ["NAMES", "environment", "measured", "missing", "taken"]

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


def measured(options: Mapping[str, Any], also: Mapping[str, str] | None = None) -> dict[str, float]:
    """Read every option with a unit that was given, in SI.

    Parameters
    ----------
    options : mapping of str
        As they were given, by name; of several values each is read as ``--clump-weight (2)``.
    also : mapping of str to str, optional
        Further options with a unit, each with the name of its dimension.

    Raises
    ------
    InputError
        With every one that is wrong.
    """
    from catopt.cli.values import in_si
    from catopt.units import Dimension

    wanted: dict[str, tuple[str | None, Dimension]] = {}
    for option, name in {**MEASURES, **(also or {})}.items():
        given = options.get(option)
        if isinstance(given, list):
            for number, text in enumerate(given, start=1):
                wanted[f"{option} ({number})"] = text, Dimension[name]
        else:
            wanted[option] = given, Dimension[name]
    return in_si(wanted)


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
