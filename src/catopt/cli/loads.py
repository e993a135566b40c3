"""``catopt loads``: the forces of wind, current and waves on a buoy or a ship."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import JsonOption

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.errors import Problem
    from catopt.loads import Loads, SeaState

__all__ = ["loads"]

loads = typer.Typer(
    name="loads",
    rich_markup_mode=None,
    no_args_is_help=True,
    help="Compute what wind, current and waves do to a buoy or a ship.",
    epilog="Each force comes with its formula, its numbers and its source. Confidence: A read in "
    "the primary document; B in two secondary ones, or in one and checked by numbers; C in one "
    "secondary one; R recalled, read in none.",
)

OutOption = Annotated[
    Path | None,
    typer.Option(
        "--out",
        metavar="DIR",
        help="Also write tables (CSV and one .xlsx) and the JSON document here. Files of the same "
        "name are replaced.",
    ),
]
DepthOption = Annotated[
    str | None,
    typer.Option("--depth", metavar="LENGTH", help='Water depth at high water, as "12 m".'),
]
WindOption = Annotated[
    str, typer.Option("--wind", metavar="SPEED", help='Wind at 10 m, such as "25 m/s".')
]
CurrentOption = Annotated[
    str, typer.Option("--current", metavar="SPEED", help='Tidal current, such as "3 kn".')
]
HsOption = Annotated[
    str | None,
    typer.Option("--hs", metavar="LENGTH", help="Significant wave height; or give --hmax."),
]
HmaxOption = Annotated[
    str | None,
    typer.Option(
        "--hmax", metavar="LENGTH", help="Height of the largest wave; 1.85 Hs when left out."
    ),
]
PeriodOption = Annotated[
    str | None, typer.Option("--period", metavar="TIME", help='Wave period, such as "8 s".')
]
WaterOption = Annotated[
    str, typer.Option("--water-density", metavar="DENSITY", help="Density of the water.")
]


class ChainSpeed(StrEnum):
    """What moves the water at the chain."""

    SURFACE = "surface"
    CURRENT = "current"


class Drift(StrEnum):
    """Of which waves the mean drift is taken."""

    SEA_STATE = "sea-state"
    LARGEST_WAVE = "largest-wave"


@loads.command()
def buoy(
    context: typer.Context,
    name: Annotated[
        str,
        typer.Argument(
            metavar="BUOY",
            help='Name of the buoy, such as "pillar 1.8 m", or a file (.toml) for catopt size.',
        ),
    ],
    depth: DepthOption = None,
    low_water: Annotated[
        str | None,
        typer.Option(metavar="LENGTH", help="Water depth at low water; --depth when left out."),
    ] = None,
    wind: WindOption = "0 m/s",
    current: CurrentOption = "0 m/s",
    hs: HsOption = None,
    hmax: HmaxOption = None,
    period: PeriodOption = None,
    chain: Annotated[
        str,
        typer.Option(metavar="LENGTH", help="Nominal diameter of the chain; 0 leaves it out."),
    ] = "0 mm",
    pull: Annotated[
        str, typer.Option(metavar="FORCE", help="Vertical pull of the line on the buoy.")
    ] = "0 kN",
    growth: Annotated[
        str, typer.Option(metavar="LENGTH", help="Thickness of marine growth on hull and chain.")
    ] = "0 mm",
    chain_speed: Annotated[
        ChainSpeed,
        typer.Option(
            metavar="WHICH",
            help="Speed of the water along the chain: surface, with the waves, on the safe side; "
            "or current, tide and wind alone.",
        ),
    ] = ChainSpeed.SURFACE,
    buoys: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="File of buoys of your own (TOML), beside catopt's."),
    ] = None,
    water_density: WaterOption = "1025 kg/m^3",
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Compute the loads on a buoy and its chain, after IALA's CALMAR reference.

    Wind, current and waves come from one side. catopt's buoys are generic ones of its own geometry;
    a name that it lacks is answered with those it has. What a file leaves out is 0, and what is
    given as an option goes before it.
    """
    from catopt.cli.size_file import fill, is_file
    from catopt.loads import SurfaceCurrent, WaterLevels, Wind, buoy_loads
    from catopt.loads import buoys as library
    from catopt.loads.buoy_library import buoy as look_up
    from catopt.loads.buoy_library import read_buoys

    options = {
        "BUOY": None if is_file(name) else name,
        "--depth": depth,
        "--low-water": low_water,
        "--wind": wind,
        "--current": current,
        "--hs": hs,
        "--hmax": hmax,
        "--period": period,
        "--growth": growth,
        "--buoys": buoys,
        "--water-density": water_density,
    }
    filled = fill(context, options, name if is_file(name) else None, "buoy")
    given = filled.options
    with filled.telling():
        values = _values(given | {"--chain": chain, "--pull": pull}, _OF_BUOY)
        own = given["--buoys"]
        known = (*library(), *(read_buoys(own) if own is not None else ()))
        shape, air, stream, sea, levels = _all(
            lambda: look_up(_wanted(given, {"BUOY": "pillar 1.8 m"})["BUOY"], known),
            lambda: Wind(values["--wind"]),
            lambda: SurfaceCurrent(values["--current"]),
            lambda: _sea(values),
            lambda: WaterLevels(
                values.get("--low-water", _wanted(values, {"--depth": "12 m"})["--depth"]),
                values["--depth"],
            ),
        )
        (result,) = _all(
            lambda: buoy_loads(
                shape,
                air,
                stream,
                sea,
                levels,
                chain_diameter=values["--chain"],
                pull=values["--pull"],
                marine_growth=values["--growth"],
                chain_speed=chain_speed.value,
                water_density=values["--water-density"],
            )
        )
    _give(context.obj, result, as_json, out)


@loads.command()
def ship(
    context: typer.Context,
    file: Annotated[
        str | None,
        typer.Argument(
            metavar="FILE", help="File (.toml) for catopt size tanker; or give options."
        ),
    ] = None,
    length: Annotated[str | None, typer.Option(metavar="LENGTH", help="Length over all.")] = None,
    breadth: Annotated[str | None, typer.Option(metavar="LENGTH", help="Breadth.")] = None,
    draught: Annotated[str | None, typer.Option(metavar="LENGTH", help="Draught.")] = None,
    frontal_area: Annotated[
        str | None,
        typer.Option(
            metavar="AREA", help="Above water, seen from ahead; estimated if a file has none."
        ),
    ] = None,
    lateral_area: Annotated[
        str | None,
        typer.Option(metavar="AREA", help="Above water, seen from the side; the same."),
    ] = None,
    depth: DepthOption = None,
    kind: Annotated[
        str,
        typer.Option(metavar="KIND", help='Kind for the wind, such as "tanker ballast".'),
    ] = "tanker loaded",
    propeller: Annotated[
        str | None,
        typer.Option(
            metavar="KIND",
            help="Kind for a locked propeller: destroyer, cruiser, carrier, cargo, tanker or "
            "submarine; none when left out, with a file tanker.",
        ),
    ] = None,
    waterline: Annotated[
        str | None,
        typer.Option(metavar="LENGTH", help="Waterline length; 0.97 of --length when left out."),
    ] = None,
    block: Annotated[
        float, typer.Option(metavar="NUMBER", help="Block coefficient, for the displacement.")
    ] = 0.8,
    midship: Annotated[
        float, typer.Option(metavar="NUMBER", help="Midship coefficient, for the midship area.")
    ] = 0.98,
    wind: WindOption = "0 m/s",
    current: CurrentOption = "0 m/s",
    hs: HsOption = None,
    hmax: HmaxOption = None,
    period: PeriodOption = None,
    wind_angle: Annotated[
        str, typer.Option(metavar="ANGLE", help="From the bow to where the wind comes from.")
    ] = "0 deg",
    current_angle: Annotated[
        str, typer.Option(metavar="ANGLE", help="From the bow to where the current comes from.")
    ] = "0 deg",
    wave_angle: Annotated[
        str, typer.Option(metavar="ANGLE", help="From the bow to where the waves come from.")
    ] = "0 deg",
    reflection: Annotated[
        float,
        typer.Option(
            metavar="NUMBER", help="Part of the wave height that the hull reflects; at most 1."
        ),
    ] = 1.0,
    drift: Annotated[
        Drift,
        typer.Option(
            metavar="WAVES",
            help="Mean wave drift over the sea (sea-state), or under regular waves of the height "
            "Hmax (largest-wave).",
        ),
    ] = Drift.SEA_STATE,
    water_density: WaterOption = "1025 kg/m^3",
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Compute the loads on a ship, from wind, current and waves.

    Wind after Blendermann, current after UFC 4-159-03, mean wave drift of a box that reflects.

    Without angles the ship is taken for weathervaning, head to everything. Of a file the loaded
    tanker is taken; what it leaves out of wind, current and waves is 0, and what is given as an
    option goes before it.
    """
    from catopt.cli.size_file import fill
    from catopt.loads import Headings, Ship, SurfaceCurrent, Wind, ship_loads

    options = {
        "--length": length,
        "--breadth": breadth,
        "--draught": draught,
        "--moulded-depth": None,
        "--frontal-area": frontal_area,
        "--lateral-area": lateral_area,
        "--depth": depth,
        "--wind": wind,
        "--current": current,
        "--hs": hs,
        "--hmax": hmax,
        "--period": period,
        "--water-density": water_density,
        "--buoys": None,
    }
    filled = fill(context, options, file, "tanker")
    given = filled.options
    estimated: tuple[str, ...] = ()
    with filled.telling():
        angles = {
            "--wind-angle": wind_angle,
            "--current-angle": current_angle,
            "--wave-angle": wave_angle,
        }
        values = _values(given | {"--waterline": waterline} | angles, _OF_SHIP)
        _wanted(values, _SHIP if file is None else _SHIP_IN_A_FILE)
        if file is not None:
            propeller = propeller or "tanker"
            values, estimated = _with_areas(values)
        at_waterline = values.get("--waterline", 0.97 * values["--length"])
        section = values["--breadth"] * values["--draught"]
        body, air, stream, sea, headings = _all(
            lambda: Ship(
                f"ship of {values['--length']:g} m",
                values["--length"],
                at_waterline,
                values["--breadth"],
                values["--draught"],
                block * at_waterline * section,
                midship * section,
                values["--lateral-area"],
                values["--frontal-area"],
                propeller,
            ),
            lambda: Wind(values["--wind"]),
            lambda: SurfaceCurrent(values["--current"]),
            lambda: _sea(values),
            lambda: Headings(
                values["--wind-angle"], values["--current-angle"], values["--wave-angle"]
            ),
        )
        (result,) = _all(
            lambda: ship_loads(
                body,
                air,
                stream,
                sea,
                values["--depth"],
                wind_on=kind,
                headings=headings,
                reflection=reflection,
                drift="sea state" if drift is Drift.SEA_STATE else "largest wave",
                water_density=values["--water-density"],
            )
        )
    hull = (
        f"Waterline {at_waterline:.5g} m, block coefficient {block:g}, midship coefficient "
        f"{midship:g}."
    )
    result = replace(result, assumptions=(*result.assumptions, hull, *estimated))
    _give(context.obj, result, as_json, out)


# ------------------------------------------------------------------ parts of the commands

_OPTIONS = {
    "buoy": "BUOY",
    "Wind.speed": "--wind",
    "SurfaceCurrent.speed": "--current",
    "current.speed": "--current",
    "significant_height": "--hs",
    "maximum_height": "--hmax",
    "period": "--period",
    "low": "--low-water",
    "levels.low": "--low-water",
    "high": "--depth",
    "levels.high": "--depth",
    "depth": "--depth",
    "chain_diameter": "--chain",
    "marine_growth": "--growth",
    "pull": "--pull",
    "water_density": "--water-density",
    "length_overall": "--length",
    "length_waterline": "--waterline",
    "breadth": "--breadth",
    "draught": "--draught",
    "displacement": "--block",
    "midship_area": "--midship",
    "frontal_area": "--frontal-area",
    "lateral_area": "--lateral-area",
    "moulded_depth": "--moulded-depth",
    "kind": "--kind",
    "propeller": "--propeller",
    "wind": "--wind-angle",
    "current": "--current-angle",
    "waves": "--wave-angle",
    "reflection": "--reflection",
}
"""Options by what they are called in Python."""


_WEATHER = {
    "--depth": "LENGTH",
    "--low-water": "LENGTH",
    "--wind": "SPEED",
    "--current": "SPEED",
    "--hs": "LENGTH",
    "--hmax": "LENGTH",
    "--period": "TIME",
    "--water-density": "DENSITY",
}
_OF_BUOY = _WEATHER | {"--chain": "LENGTH", "--pull": "FORCE", "--growth": "LENGTH"}
_OF_SHIP = _WEATHER | {
    "--length": "LENGTH",
    "--waterline": "LENGTH",
    "--breadth": "LENGTH",
    "--draught": "LENGTH",
    "--moulded-depth": "LENGTH",
    "--frontal-area": "AREA",
    "--lateral-area": "AREA",
    "--wind-angle": "ANGLE",
    "--current-angle": "ANGLE",
    "--wave-angle": "ANGLE",
}
"""What each option is, by the name of its dimension."""


def _values(options: dict[str, Any], dimensions: dict[str, str]) -> dict[str, float]:
    from catopt.cli.values import in_si
    from catopt.units import Dimension

    return in_si({each: (options.get(each), Dimension[of]) for each, of in dimensions.items()})


_SHIP_IN_A_FILE = {
    "--length": "234 m",
    "--breadth": "31.3 m",
    "--draught": "12.4 m",
    "--depth": "20 m",
}
_SHIP = _SHIP_IN_A_FILE | {"--frontal-area": "580 m^2", "--lateral-area": "1200 m^2"}
"""What is wanted of a ship, with examples."""


def _wanted(given: dict[str, Any], wanted: dict[str, str]) -> dict[str, Any]:
    """Return what is given, once all that is wanted is there; examples by option."""
    from catopt.errors import InputError, Problem

    missing = [
        Problem(option, "", f'missing; it is wanted, such as "{example}"')
        for option, example in wanted.items()
        if given.get(option) is None
    ]
    if missing:
        raise InputError(missing, "options")
    return given


def _with_areas(values: dict[str, float]) -> tuple[dict[str, float], tuple[str, ...]]:
    """Estimate a tanker's windage where it is not given; say so."""
    from catopt.loads.ship_estimate import ESTIMATES, MOULDED, estimated_tanker

    if "--frontal-area" in values and "--lateral-area" in values:
        return values, ()
    moulded = values.get("--moulded-depth", MOULDED * values["--draught"])
    main = (values[option] for option in ("--length", "--breadth", "--draught"))
    (ship,) = _all(lambda: estimated_tanker("tanker", *main, moulded_depth=moulded))
    areas = {"--frontal-area": ship.frontal_area, "--lateral-area": ship.lateral_area}
    return areas | values, ESTIMATES[1:]


def _sea(values: dict[str, float]) -> SeaState:
    """Make the waves; none when no height is given."""
    from catopt.errors import InputError, Problem
    from catopt.loads import SeaState

    height, largest = values.get("--hs"), values.get("--hmax")
    if height is None and largest is None:
        return SeaState(values.get("--period", 1.0), 0.0)
    if "--period" not in values:
        raise InputError([Problem("period", "", 'missing; waves need it, such as "8 s"')], "waves")
    return SeaState(values["--period"], height, largest)


def _all(*makers: Callable[[], Any]) -> list[Any]:
    """Make every value; what is wrong with any of them is told at once, by the options' names."""
    from catopt.errors import InputError

    made, problems = [], []
    for maker in makers:
        try:
            made.append(maker())
        except InputError as error:
            problems += _by_option(error.source, error.problems)
    if problems:
        raise InputError(problems, "options")
    return made


def _by_option(source: str, problems: Iterable[Problem]) -> list[Problem]:
    def option(key: str) -> str:
        return _OPTIONS.get(f"{source}.{key}", _OPTIONS.get(key, key))

    return [replace(each, key=option(each.key)) for each in problems]


def _give(output: Output, result: Loads, as_json: bool, out: Path | None) -> None:
    """Write the files, then print the document or the view."""
    if out is not None:
        from catopt.report.bundle import loads_bundle
        from catopt.report.files import check_directory, write_files

        check_directory(out)
        written = write_files(out, loads_bundle(result))
        output.note(f"{len(written)} files written to {out}")
    if as_json:
        from catopt.loads.document import loads_document

        output.json(loads_document(result))
        return
    from catopt.cli.loads_view import show_loads

    show_loads(output, result)
