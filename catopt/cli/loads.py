"""``catopt loads``: the forces of wind, current and waves on a buoy or a ship."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from enum import StrEnum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.completion import buoys, completed
from catopt.cli.options import JsonOption, LangOption, ReportLanguage, TablesOutOption
from catopt.cli.ship_form import (
    Form,
    needs_turning,
    refuse_needless,
    ships_afloat,
    what_is_taken,
)
from catopt.cli.size import is_file
from catopt.cli.size_options import as_option, by_option, typed, with_inputs
from catopt.cli.units_option import in_units

if TYPE_CHECKING:
    from catopt.casefile.sizing_file import Moored
    from catopt.cli.output import Output
    from catopt.loads import Loads, Lying, SeaState
    from catopt.sizing.known import Known
    from catopt.sizing.telling import Spelling
    from catopt.words import Message

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

_WEATHER = ("depth", "low_water", "wind", "current", "hs", "hmax", "period", "water_density")
_BUOY = (*_WEATHER, "growth", "buoys")
_SHIP = (
    *(*_WEATHER, "length", "breadth", "draught", "ballast_draught"),
    *("frontal_area", "lateral_area"),
    *("load_method", "wave_coefficient", "wind_mean", "ship", "dwt"),
    *("wind_angle", "current_angle", "wave_angle", "current_yaw", "scan"),
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
            autocompletion=completed(buoys),
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

    Wind, current and waves come from one side; with --low-water both levels are computed, and the
    largest force is shown. catopt's buoys are generic ones of its own geometry;
    a name that it lacks is answered with those it has. What a file leaves out is 0, and what is
    given as an option goes before it.
    """
    from catopt.cli.values import in_si
    from catopt.loads import SurfaceCurrent, WaterLevels, Wind
    from catopt.sizing.requests import shape_of
    from catopt.ties import largest
    from catopt.units import Dimension

    place = name if is_file(name) else None
    options = {"buoy": None if place else name, **inputs}
    with _known("buoy", place, options, by_option, _OF_BUOYS) as of:
        make = of.telling.make
        of.want("buoy", "depth")
        for each in ("force", "reserve_buoyancy"):
            if each in of.given:
                of.telling.add(each, f"{of[each]:g} N", "leave it out: these loads are computed")
        own = make(in_si, {"--chain": (chain, Dimension.LENGTH), "--pull": (pull, Dimension.FORCE)})
        every = make(
            lambda own, *parts: _at_each_level(
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
    assert every is not None
    result = largest(every, lambda each: each.horizontal_force)
    said = (*_of_levels(every, of), *_no_part(of, {*_BUOY, "buoy"}))
    result = replace(result, assumptions=(*said, *result.assumptions))
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
        str | None,
        typer.Option(
            metavar="KIND",
            help='Kind for the wind, such as "cargo loaded"; if left out, that of --ship, "tanker '
            'loaded", and in ballast "tanker ballast".',
        ),
    ] = None,
    propeller: Annotated[
        str | None,
        typer.Option(
            metavar="KIND",
            help="Kind for a locked propeller: destroyer, cruiser, carrier, cargo, tanker or "
            "submarine; none when left out, with a file that of its ship.",
        ),
    ] = None,
    waterline: Annotated[
        str | None,
        measure("--waterline", "LENGTH", "Waterline length; 0.97 of --length when left out."),
    ] = None,
    block: Annotated[
        float | None,
        typer.Option(
            metavar="NUMBER",
            help="Block coefficient, for the displacement; if left out, 0.80, and in ballast 0.72.",
        ),
    ] = None,
    midship: Annotated[
        float, typer.Option(metavar="NUMBER", help="Midship coefficient, for the midship area.")
    ] = 0.98,
    weathervane: Annotated[
        bool,
        typer.Option(
            "--weathervane",
            help="The ship lies on one point and turns until the moments of wind, current and "
            "waves cancel: the angles are then counted from any one line, not from the bow. So it "
            "does where a file has directions.",
        ),
    ] = False,
    mooring_point: Annotated[
        str | None,
        measure(
            "--mooring-point", "LENGTH", "Forward of midships; if left out, half the waterline."
        ),
    ] = None,
    wind_centre: Annotated[
        str | None,
        measure(
            "--wind-centre",
            "LENGTH",
            "Centre of the lateral area, forward of midships; if left out, that of the estimated "
            "area with its deckhouse at the stern, and midships of an area that is given.",
        ),
    ] = None,
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

    Without angles the ship is taken for weathervaning, head to everything. With a ballast draught
    both conditions are computed, with --low-water at both depths, and the worst is shown. What a
    file leaves out of wind, current and waves is 0, and what is given as an option goes before it.
    """
    from catopt.cli.values import in_si
    from catopt.loads import METHODS, SurfaceCurrent, WaterLevels, Wind, every_lying
    from catopt.sizing.headings import DIRECTIONS, directions_of, read_turning, turned_round
    from catopt.sizing.read_input import estimated_dimensions
    from catopt.sizing.requests import TAKEN_FOR, of_the_wind, wind_of_30_s
    from catopt.ties import largest
    from catopt.units import Dimension

    given = {
        "--waterline": (waterline, Dimension.LENGTH),
        "--mooring-point": (mooring_point, Dimension.LENGTH),
        "--wind-centre": (wind_centre, Dimension.LENGTH),
    }
    needless = {
        "mooring_point": mooring_point,
        "wind_centre": wind_centre,
    }
    with _known("tanker", file, inputs, as_option, _OF_SHIPS) as of:
        make = of.telling.make
        of.want("length", "breadth", "draught", "depth")
        own = make(in_si, given)
        turns = weathervane or any(inputs[name] is None for name in of.given & {*DIRECTIONS})
        for name in () if turns else ("current_yaw", "scan"):
            if name in of.given:
                of.telling.add(name, str(inputs[name] or of[name]), needs_turning())
        make(refuse_needless, {} if turns else needless)
        of.telling.raise_if_any()
        assert own is not None
        point = own.get("--mooring-point")
        turning = make(lambda: read_turning(of["current_yaw"] or "", point)) if turns else None
        of.telling.raise_if_any()
        if file is not None:
            propeller = propeller or TAKEN_FOR[of["ship"] or "tanker"][1]
        form = Form(
            own.get("--waterline", 0.97 * of["length"]),
            block,
            midship,
            kind,
            propeller,
            own.get("--wind-centre"),
        )
        ships, estimated = ships_afloat(of, form)
        how = {
            "reflection": reflection,
            "drift": "sea state" if drift is Drift.SEA_STATE else "largest wave",
            "wave_coefficient": of["wave_coefficient"],
            "water_density": of["water_density"],
        }
        weather = (
            make(Wind, wind_of_30_s(of)),
            make(SurfaceCurrent, of["current"]),
            make(_sea, of),
        )
        lyings = make(
            lambda wind, current, sea, levels, turned: every_lying(
                ships,
                wind,
                current,
                sea,
                tuple(dict.fromkeys((levels.high, levels.low))),
                turned,
                methods=of["load_method"] or METHODS[:1],
                turning=turning,
                **how,
            ),
            *weather,
            make(WaterLevels, of["low_water"] or of["depth"], of["depth"]),
            make(turned_round, make(directions_of, of), of["scan"] or math.inf),
        )
        of.telling.raise_if_any()
        assert lyings is not None
        worst = largest(lyings, lambda each: each.loads.horizontal_force)
        others = make(lambda: _others(worst, weather, how, is_balanced=turns))
        of.telling.raise_if_any()
    by_hs = drift is Drift.SEA_STATE and of["hs"] is not None
    no_part = _no_part(of, {*_SHIP, "moulded_depth"} - ({"hmax"} if by_hs else set()))
    said = (*what_is_taken(form, worst, turning), *estimated, *of_the_wind(of), *no_part)
    warned = estimated_dimensions(of.read)
    told = [
        replace(
            each,
            assumptions=(*each.assumptions, *said),
            warnings=(*each.warnings, *warned),
        )
        for each in (worst.loads, *(others or ()))
    ]
    shown = lyings if turns or len(lyings) > 1 else ()
    _give(context.obj, *told, lyings=shown, lang=lang, as_json=as_json, out=out)


# ------------------------------------------------------------------ parts of the commands

_OF_BUOYS = {"chain_diameter": "chain", "pull": "pull"}
_OF_SHIPS = {
    "length_waterline": "waterline",
    "displacement": "block",
    "midship_area": "midship",
    "kind": "kind",
    "propeller": "propeller",
    "reflection": "reflection",
    "method": "load_method",
    "mooring_point": "mooring_point",
    "wind_centre": "wind_centre",
    "lateral_centre": "wind_centre",
    "MooredShip.deadweight": "dwt",
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


def _at_each_level(
    body: Any, wind: Any, current: Any, sea: Any, levels: Any, **how: Any
) -> tuple[Loads, ...]:
    """Compute the loads on a buoy at high water, and at low water where that is another."""
    from catopt.loads import WaterLevels, buoy_loads

    every = (levels,) if levels.low == levels.high else (levels, WaterLevels.steady(levels.low))
    return tuple(buoy_loads(body, wind, current, sea, each, **how) for each in every)


def _of_levels(every: Sequence[Loads], of: Known) -> Iterator[Message]:
    """Say what the force is at each level, where there are two."""
    from catopt.words import Measure, Message

    if len(every) > 1:
        high, low = (Measure("horizontal_force", each.horizontal_force) for each in every)
        depths = {"deep": of["depth"], "shallow": of["low_water"]}
        yield Message("loads.at_both_levels", high=high, low=low, **depths)


def _no_part(of: Known, counted: Collection[str]) -> Iterator[Message]:
    """Say what was given, mostly by a sizing's file, that is no part of the loads."""
    from catopt.sizing.inputs import inputs_of
    from catopt.words import Cited, Message

    names = [
        of.telling.spell(name) if name in (*_BUOY, *_SHIP) else each.key
        for name, each in inputs_of(of.moored).items()
        if name in of.given - set(counted)
    ]
    if names:
        yield Message("loads.no_part", names=Cited(", ".join(names)))


def _sea(of: Known) -> SeaState:
    """Make the waves; none when no height is given."""
    from catopt.errors import InputError, Problem
    from catopt.loads import SeaState

    if of["hs"] is None and of["hmax"] is None:
        return SeaState(of["period"] or 1.0, 0.0)
    if of["period"] is None:
        raise InputError([Problem("period", "", 'missing; waves need it, such as "8 s"')], "waves")
    return SeaState(of["period"], of["hs"], of["hmax"])


def _others(
    worst: Lying, weather: tuple[Any, ...], how: dict[str, Any], *, is_balanced: bool
) -> list[Loads]:
    from catopt.loads import every_method

    ship = worst.afloat
    every = every_method(
        ship.ship,
        *weather,
        worst.depth,
        wind_on=ship.wind_on,
        headings=worst.headings,
        is_balanced=is_balanced,
        **how,
    )
    return [each for each in every if each.method != worst.loads.method]


def _give(
    output: Output,
    *results: Loads,
    lyings: Sequence[Lying] = (),
    lang: ReportLanguage,
    as_json: bool,
    out: Path | None,
) -> None:
    from catopt.answers.loads import loads_answer
    from catopt.cli.result_files import Asked
    from catopt.loads.document import loads_document

    asked = Asked(output, lang, as_json, out)
    document = partial(loads_document, *results, lyings=lyings)
    asked.give(loads_answer(*results, lyings=lyings), document)
