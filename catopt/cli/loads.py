"""``catopt loads``: the forces of wind, current and waves on a buoy or a ship."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import JsonOption, LangOption, ReportLanguage, TablesOutOption
from catopt.cli.size import is_file
from catopt.cli.size_options import as_option, by_option, typed, with_inputs
from catopt.cli.units_option import in_units

if TYPE_CHECKING:
    from catopt.casefile.sizing_file import Moored
    from catopt.cli.output import Output
    from catopt.loads import Loads, SeaState
    from catopt.sizing.known import Known
    from catopt.sizing.telling import Spelling
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

_TAKEN = {
    "wind": "0 m/s",
    "current": "0 m/s",
    "hs": "",
    "period": "",
    "growth": "0 mm",
    "water_density": "1025 kg/m^3",
}
"""What the loads take when it is left out, in place of what a sizing takes."""

_WEATHER = ("depth", "wind", "current", "hs", "hmax", "period", "water_density")
_BUOY = (*_WEATHER, "low_water", "growth", "buoys")
_SHIP = (
    *(*_WEATHER, "length", "breadth", "draught", "frontal_area", "lateral_area"),
    *("load_method", "wave_coefficient"),
)


def measure(flag: str, dimension: str, text: str) -> Any:
    """Declare an option with a unit that a sizing does not have."""
    return typer.Option(flag, metavar=dimension, help=text)


class ChainSpeed(StrEnum):
    """What moves the water at the chain."""

    SURFACE = "surface"
    CURRENT = "current"


class Drift(StrEnum):
    """Of which waves the mean drift is taken."""

    SEA_STATE = "sea-state"
    LARGEST_WAVE = "largest-wave"


@loads.command()
@in_units
@with_inputs("buoy", _BUOY, _TAKEN)
def buoy(
    context: typer.Context,
    name: Annotated[
        str,
        typer.Argument(
            metavar="BUOY",
            help='Name of the buoy, such as "pillar 1.8 m", or a file (.toml) for catopt size.',
        ),
    ],
    *,
    chain: Annotated[
        str,
        typer.Option(metavar="LENGTH", help="Nominal diameter of the chain; 0 leaves it out."),
    ] = "0 mm",
    pull: Annotated[
        str, measure("--pull", "FORCE", "Vertical pull of the line on the buoy.")
    ] = "0 kN",
    chain_speed: Annotated[
        ChainSpeed,
        typer.Option(
            metavar="WHICH",
            help="Speed of the water along the chain: surface, with the waves, on the safe side; "
            "or current, tide and wind alone.",
        ),
    ] = ChainSpeed.SURFACE,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
    **inputs: Any,
) -> None:
    """Compute the loads on a buoy and its chain, after IALA's CALMAR reference.

    Wind, current and waves come from one side. catopt's buoys are generic ones of its own geometry;
    a name that it lacks is answered with those it has. What a file leaves out is 0, and what is
    given as an option goes before it.
    """
    from catopt.cli.values import in_si
    from catopt.loads import SurfaceCurrent, WaterLevels, Wind, buoy_loads
    from catopt.sizing.requests import shape_of
    from catopt.units import Dimension

    place = name if is_file(name) else None
    options = {"buoy": None if place else name, **inputs}
    with _known("buoy", place, options, by_option, _OF_BUOYS) as of:
        make = of.telling.make
        of.want("buoy", "depth")
        own = make(in_si, {"--chain": (chain, Dimension.LENGTH), "--pull": (pull, Dimension.FORCE)})
        result = make(
            lambda own, *parts: buoy_loads(
                *parts,
                chain_diameter=own["--chain"],
                pull=own["--pull"],
                marine_growth=of["growth"],
                chain_speed=chain_speed.value,
                water_density=of["water_density"],
            ),
            own,
            shape_of(of),
            make(Wind, of["wind"]),
            make(SurfaceCurrent, of["current"]),
            make(_sea, of),
            make(WaterLevels, of["low_water"] or of["depth"], of["depth"]),
        )
        of.telling.raise_if_any()
    assert result is not None
    _give(context.obj, result, lang=lang, as_json=as_json, out=out)


@loads.command()
@in_units
@with_inputs("tanker", _SHIP, _TAKEN)
def ship(
    context: typer.Context,
    file: Annotated[
        str | None,
        typer.Argument(
            metavar="FILE", help="File (.toml) for catopt size tanker; or give options."
        ),
    ] = None,
    *,
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
        measure("--waterline", "LENGTH", "Waterline length; 0.97 of --length when left out."),
    ] = None,
    block: Annotated[
        float, typer.Option(metavar="NUMBER", help="Block coefficient, for the displacement.")
    ] = 0.8,
    midship: Annotated[
        float, typer.Option(metavar="NUMBER", help="Midship coefficient, for the midship area.")
    ] = 0.98,
    wind_angle: Annotated[
        str, measure("--wind-angle", "ANGLE", "From the bow to where the wind comes from.")
    ] = "0 deg",
    current_angle: Annotated[
        str, measure("--current-angle", "ANGLE", "From the bow to where the current comes from.")
    ] = "0 deg",
    wave_angle: Annotated[
        str, measure("--wave-angle", "ANGLE", "From the bow to where the waves come from.")
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
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: TablesOutOption = None,
    **inputs: Any,
) -> None:
    """Compute the loads on a ship, from wind, current and waves.

    Every method that applies stands in one table: UFC-Blendermann (wind after Blendermann, current
    after UFC 4-159-03, mean wave drift of a box that reflects), UFC-4-159-03 alone, 22TCN-222-95.
    The one named, or of several the largest, comes first.

    Without angles the ship is taken for weathervaning, head to everything. Of a file the loaded
    tanker is taken; what it leaves out of wind, current and waves is 0, and what is given as an
    option goes before it.
    """
    from catopt.cli.values import in_si
    from catopt.loads import METHODS, Headings, Ship, SurfaceCurrent, Wind
    from catopt.units import Dimension

    angles = {
        "--wind-angle": (wind_angle, Dimension.ANGLE),
        "--current-angle": (current_angle, Dimension.ANGLE),
        "--wave-angle": (wave_angle, Dimension.ANGLE),
    }
    with _known("tanker", file, inputs, as_option, _OF_SHIPS) as of:
        make = of.telling.make
        areas = () if file else ("frontal_area", "lateral_area")
        of.want("length", "breadth", "draught", "depth", *areas)
        own = make(in_si, angles | {"--waterline": (waterline, Dimension.LENGTH)})
        of.telling.raise_if_any()
        assert own is not None
        if file is not None:
            propeller = propeller or "tanker"
        frontal, lateral, estimated = _areas(of)
        at_waterline = own.pop("--waterline", 0.97 * of["length"])
        section = of["breadth"] * of["draught"]
        body = make(
            lambda: Ship(
                Message("loads.ship_of", length=of["length"]),
                of["length"],
                at_waterline,
                of["breadth"],
                of["draught"],
                block * at_waterline * section,
                midship * section,
                lateral,
                frontal,
                propeller,
            )
        )
        how = {
            "wind_on": kind,
            "reflection": reflection,
            "drift": "sea state" if drift is Drift.SEA_STATE else "largest wave",
            "wave_coefficient": of["wave_coefficient"],
            "water_density": of["water_density"],
        }
        results = make(
            lambda ship, wind, current, sea, headings: _by_methods(
                of["load_method"] or METHODS[:1],
                ship,
                wind,
                current,
                sea,
                of["depth"],
                headings=headings,
                **how,
            ),
            body,
            make(Wind, of["wind"]),
            make(SurfaceCurrent, of["current"]),
            make(_sea, of),
            make(Headings, *(own[angle] for angle in angles)),
        )
        of.telling.raise_if_any()
    assert results is not None
    form = {"length": at_waterline, "block": block, "midship": midship}
    said = (Message("loads.hull_form", **form), *estimated)
    told = [replace(each, assumptions=(*each.assumptions, *said)) for each in results]
    _give(context.obj, *told, lang=lang, as_json=as_json, out=out)


# ------------------------------------------------------------------ parts of the commands

_OF_BUOYS = {"chain_diameter": "chain", "pull": "pull"}
_OF_SHIPS = {
    "length_waterline": "waterline",
    "displacement": "block",
    "midship_area": "midship",
    "kind": "kind",
    "propeller": "propeller",
    "Headings.wind": "wind_angle",
    "Headings.current": "current_angle",
    "Headings.waves": "wave_angle",
    "reflection": "reflection",
    "method": "load_method",
}
"""Options that a sizing does not have, by what they are called in Python."""


@contextmanager
def _known(
    moored: Moored,
    place: str | None,
    options: dict[str, Any],
    spell: Spelling,
    called: dict[str, str],
) -> Iterator[Known]:
    """Read options, and a file if there is one; what is wrong is told as it stands there."""
    from catopt.sizing.file import read_file
    from catopt.sizing.known import known

    given = typed(moored, options)
    if place is None:
        yield known(moored, given, spell, "options", defaults=_TAKEN, called=called)
        return
    file = read_file(place, moored)
    with file.telling():
        yield file.known(given, spell, defaults=_TAKEN, called=called)


def _areas(of: Known) -> tuple[float, float, tuple[str, ...]]:
    """Return frontal and lateral area; a tanker's are estimated where they are not given."""
    from catopt.loads.ship_estimate import MOULDED, estimated_tanker, estimates

    frontal, lateral = of["frontal_area"], of["lateral_area"]
    if frontal is not None and lateral is not None:
        return frontal, lateral, ()
    moulded = of["moulded_depth"] or MOULDED * of["draught"]
    main = (of["length"], of["breadth"], of["draught"])
    ship = of.telling.make(lambda: estimated_tanker("tanker", *main, moulded_depth=moulded))
    of.telling.raise_if_any()
    assert ship is not None
    return frontal or ship.frontal_area, lateral or ship.lateral_area, estimates()[1:]


def _sea(of: Known) -> SeaState:
    """Make the waves; none when no height is given."""
    from catopt.errors import InputError, Problem
    from catopt.loads import SeaState

    if of["hs"] is None and of["hmax"] is None:
        return SeaState(of["period"] or 1.0, 0.0)
    if of["period"] is None:
        raise InputError([Problem("period", "", 'missing; waves need it, such as "8 s"')], "waves")
    return SeaState(of["period"], of["hs"], of["hmax"])


def _by_methods(named: tuple[str, ...], *on: Any, **how: Any) -> tuple[Loads, ...]:
    """Compute by every method, the one that is named first; of several, the largest."""
    from catopt.loads import every_method, governing_loads

    governs = governing_loads(named, *on, **how)
    others = (each for each in every_method(*on, **how) if each.method != governs.method)
    return (governs, *others)


def _give(
    output: Output, *results: Loads, lang: ReportLanguage, as_json: bool, out: Path | None
) -> None:
    """Write the files, then print the document or the answer."""
    from catopt.answers.loads import loads_answer
    from catopt.loads.document import loads_document
    from catopt.render.terminal import show

    answer = loads_answer(*results)
    if out is not None:
        from catopt.render.files import files_of
        from catopt.report.files import check_directory, write_files

        check_directory(out)
        written = write_files(out, files_of(answer, loads_document(*results), lang.value))
        output.note(f"{len(written)} files written to {out}")
    if as_json:
        output.json(loads_document(*results))
    else:
        show(output, answer, lang.value)
