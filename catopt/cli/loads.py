"""``catopt loads``: the forces of wind, current and waves on a buoy or a ship."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import JsonOption, LangOption, ReportLanguage, TablesOutOption
from catopt.cli.size_options import (
    BreadthOption,
    DensityOption,
    DepthOption,
    GrowthOption,
    HmaxOption,
    LengthOption,
    LowWaterOption,
    measure,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.loads import Loads, SeaState
from catopt.words import Message

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

WindOption = Annotated[str, measure("--wind", 'Wind at 10 m, such as "25 m/s".')]
CurrentOption = Annotated[str, measure("--current", 'Tidal current, such as "3 kn".')]
HsOption = Annotated[str | None, measure("--hs", "Significant wave height; or give --hmax.")]
PeriodOption = Annotated[str | None, measure("--period", 'Wave period, such as "8 s".')]


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
    low_water: LowWaterOption = None,
    wind: WindOption = "0 m/s",
    current: CurrentOption = "0 m/s",
    hs: HsOption = None,
    hmax: HmaxOption = None,
    period: PeriodOption = None,
    chain: Annotated[
        str,
        typer.Option(metavar="LENGTH", help="Nominal diameter of the chain; 0 leaves it out."),
    ] = "0 mm",
    pull: Annotated[str, measure("--pull", "Vertical pull of the line on the buoy.")] = "0 kN",
    growth: GrowthOption = "0 mm",
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
    water_density: DensityOption = "1025 kg/m^3",
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """Compute the loads on a buoy and its chain, after IALA's CALMAR reference.

    Wind, current and waves come from one side. catopt's buoys are generic ones of its own geometry;
    a name that it lacks is answered with those it has. What a file leaves out is 0, and what is
    given as an option goes before it.
    """
    from catopt.cli.size_file import fill, is_file
    from catopt.cli.size_parts import measured
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
        values = measured(given | {"--chain": chain, "--pull": pull}, {"--chain": "LENGTH"})
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
    _give(context.obj, result, lang, as_json=as_json, out=out)


@loads.command()
def ship(
    context: typer.Context,
    file: Annotated[
        str | None,
        typer.Argument(
            metavar="FILE", help="File (.toml) for catopt size tanker; or give options."
        ),
    ] = None,
    length: LengthOption = None,
    breadth: BreadthOption = None,
    draught: Annotated[str | None, measure("--draught", "Draught.")] = None,
    frontal_area: Annotated[
        str | None,
        measure("--frontal-area", "Above water, seen from ahead; estimated if a file has none."),
    ] = None,
    lateral_area: Annotated[
        str | None,
        measure("--lateral-area", "Above water, seen from the side; the same."),
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
        measure("--waterline", "Waterline length; 0.97 of --length when left out."),
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
        str, measure("--wind-angle", "From the bow to where the wind comes from.")
    ] = "0 deg",
    current_angle: Annotated[
        str, measure("--current-angle", "From the bow to where the current comes from.")
    ] = "0 deg",
    wave_angle: Annotated[
        str, measure("--wave-angle", "From the bow to where the waves come from.")
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
    water_density: DensityOption = "1025 kg/m^3",
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
) -> None:
    """Compute the loads on a ship, from wind, current and waves.

    Wind after Blendermann, current after UFC 4-159-03, mean wave drift of a box that reflects.

    Without angles the ship is taken for weathervaning, head to everything. Of a file the loaded
    tanker is taken; what it leaves out of wind, current and waves is 0, and what is given as an
    option goes before it.
    """
    from catopt.cli.size_file import fill
    from catopt.cli.size_parts import measured
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
        values = measured(given | {"--waterline": waterline} | angles)
        _wanted(values, _SHIP if file is None else _SHIP_IN_A_FILE)
        if file is not None:
            propeller = propeller or "tanker"
            values, estimated = _with_areas(values)
        at_waterline = values.get("--waterline", 0.97 * values["--length"])
        section = values["--breadth"] * values["--draught"]
        body, air, stream, sea, headings = _all(
            lambda: Ship(
                Message("loads.ship_of", length=values["--length"]),
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
    form = {"length": at_waterline, "block": block, "midship": midship}
    hull = Message("loads.hull_form", **form)
    result = replace(result, assumptions=(*result.assumptions, hull, *estimated))
    _give(context.obj, result, lang, as_json=as_json, out=out)


# ------------------------------------------------------------------ parts of the commands

_NAMES = {
    "depth": "--depth",
    "chain_diameter": "--chain",
    "pull": "--pull",
    "length_waterline": "--waterline",
    "midship_area": "--midship",
    "kind": "--kind",
    "propeller": "--propeller",
    "wind": "--wind-angle",
    "current": "--current-angle",
    "waves": "--wave-angle",
    "reflection": "--reflection",
}
"""Options by what they are called in Python, beside those of a sizing or in place of them."""

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
    from catopt.cli.gathered import Gathered
    from catopt.cli.size_parts import missing

    gathered = Gathered({})
    missing(gathered, given, wanted)
    gathered.raise_if_any()
    return given


def _with_areas(values: dict[str, float]) -> tuple[dict[str, float], tuple[str, ...]]:
    """Estimate a tanker's windage where it is not given; say so."""
    from catopt.loads.ship_estimate import MOULDED, estimated_tanker, estimates

    if "--frontal-area" in values and "--lateral-area" in values:
        return values, ()
    moulded = values.get("--moulded-depth", MOULDED * values["--draught"])
    main = (values[option] for option in ("--length", "--breadth", "--draught"))
    (ship,) = _all(lambda: estimated_tanker("tanker", *main, moulded_depth=moulded))
    areas = {"--frontal-area": ship.frontal_area, "--lateral-area": ship.lateral_area}
    return areas | values, estimates()[1:]


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
    from catopt.cli.gathered import Gathered
    from catopt.cli.size_parts import NAMES

    gathered = Gathered({**NAMES, **_NAMES})
    made = [gathered.make(maker) for maker in makers]
    gathered.raise_if_any()
    return made


def _give(
    output: Output, result: Loads, lang: ReportLanguage, *, as_json: bool, out: Path | None
) -> None:
    """Write the files, then print the document or the answer."""
    from catopt.answers.loads import loads_answer
    from catopt.loads.document import loads_document
    from catopt.render.terminal import show

    answer = loads_answer(result)
    if out is not None:
        from catopt.render.files import files_of
        from catopt.report.files import check_directory, write_files

        check_directory(out)
        written = write_files(out, files_of(answer, loads_document(result), lang.value))
        output.note(f"{len(written)} files written to {out}")
    if as_json:
        output.json(loads_document(result))
    else:
        show(output, answer, lang.value)
