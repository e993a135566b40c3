"""``catopt loads``: the forces of wind, current and waves on a buoy or a ship."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

import typer

from catopt.cli.answering import Asked, answering
from catopt.cli.help_words import WithWords, group
from catopt.cli.options import LengthOption, TablesOutOption
from catopt.cli.size import BuoyArgument, as_option, by_option, is_file, typed, with_inputs
from catopt.cli.values import given_ones, in_si
from catopt.largest import largest
from catopt.units import Dimension
from catopt.words import Cited, Measure, Message, term

if TYPE_CHECKING:
    from catopt.casefile.reading import Moored
    from catopt.loads import Afloat, Loads, SeaState, ShipHeading, Turning
    from catopt.loads.ship import Condition
    from catopt.sizing.input_values import ResolvedInputs, Spelling

loads = group("loads")

_TAKEN = {
    "wind": "0 m/s",
    "current": "0 m/s",
    "hs": "",
    "growth": "0 mm",
    "water_density": "1025 kg/m^3",
}
"""What the loads take when it is left out, in place of what a sizing takes."""

_WEATHER = (
    "depth",
    "low_water",
    "wind",
    "current",
    "hs",
    "hmax",
    "period",
    "fetch",
    "fetch_depth",
    "water_density",
)
_BUOY = (*_WEATHER, "place", "growth", "buoys", "load_method")
_SHIP = (
    *(*_WEATHER, "length", "breadth", "draught", "ballast_draught"),
    *("frontal_area", "lateral_area", "condition", "coefficients"),
    *("load_method", "wave_coefficient", "wind_mean", "ship", "dwt"),
    *("wind_angle", "current_angle", "wave_angle", "current_yaw", "scan"),
)
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

KindOption = Annotated[str | None, typer.Option(metavar="KIND")]


WaveHeight = Literal["hs", "hmax"]
Drift = Literal["sea-state", "largest-wave"]


@loads.command(cls=WithWords)
@answering(TablesOutOption)
@with_inputs("buoy", _BUOY, _TAKEN)
def buoy(
    asked: Asked,
    name: Annotated[str, BuoyArgument],
    *,
    chain: Annotated[str, typer.Option(metavar="LENGTH")] = "0 mm",
    pull: Annotated[str, typer.Option(metavar="FORCE")] = "0 kN",
    wave_height: Annotated[WaveHeight, typer.Option(metavar="WHICH")] = "hs",
    chain_waves: Annotated[bool, typer.Option("--chain-waves")] = False,
    **inputs: Any,
) -> None:
    """Compute the loads on a buoy and its chain, after IALA's CALMAR reference."""
    from catopt.loads import WaterLevels, buoy_loads
    from catopt.loads.buoy import BUOY_METHODS
    from catopt.sizing.requests import shape_of
    from catopt.sizing.sea import of_the_fetch, of_the_period
    from catopt.sizing.wind import blowing

    place = name if is_file(name) else None
    options = {"buoy": None if place else name, **inputs}
    with _known("buoy", place, options, by_option, _OF_BUOYS) as of:
        make = of.errors.make
        of.require("buoy", "depth")
        for option in ("force", "reserve_buoyancy"):
            if option in of.given:
                wanted = Message("refused_command.leave_out_these_loads_are")
                of.errors.add(option, f"{of[option]:g} N", wanted)
        own = make(in_si, {"--chain": (chain, Dimension.LENGTH), "--pull": (pull, Dimension.FORCE)})
        body = shape_of(of)
        weather = _weather(of, blowing(of))
        levels = make(WaterLevels, of["low_water"] or of["depth"], of["depth"])
        every = of.errors.made(
            lambda own, levels, body, wind, current, sea: tuple(
                buoy_loads(
                    body,
                    wind,
                    current,
                    sea,
                    at_level,
                    chain_diameter=own["--chain"],
                    pull=own["--pull"],
                    marine_growth=of["growth"],
                    wave_height=wave_height,
                    chain_waves=chain_waves,
                    water_density=of["water_density"],
                    method=of["load_method"] or BUOY_METHODS[0],
                )
                for at_level in dict.fromkeys((levels, WaterLevels.steady(levels.low)))
            ),
            own,
            levels,
            body,
            *weather,
        )
    result = largest(every, lambda each: each.horizontal_force)
    assert own is not None
    # CALMAR takes Hmax for the height of the chain alone.
    by_hs = wave_height == "hs" and of["hs"] is not None and not own["--chain"]
    counted = {*_BUOY, "buoy"} - ({"hmax"} if by_hs else set())
    said: list[Message] = []
    if len(every) > 1:  # the force at each of two levels
        high, low = (Measure("horizontal_force", computed.horizontal_force) for computed in every)
        depths = {"deep": of["depth"], "shallow": of["low_water"]}
        said.append(Message("loads.at_both_levels", high=high, low=low, **depths))
    said += [*of_the_period(of, "loads.taken_period"), *of_the_fetch(of), *_no_part(of, counted)]
    _give(asked, replace(result, assumptions=(*said, *result.assumptions)))


@loads.command(cls=WithWords)
@answering(TablesOutOption)
@with_inputs("tanker", _SHIP, {**_TAKEN, "ballast_draught": "", "condition": "loaded"})
def ship(
    asked: Asked,
    file: Annotated[str | None, typer.Argument(metavar="FILE")] = None,
    *,
    kind: KindOption = None,
    propeller: KindOption = None,
    waterline: LengthOption = None,
    block: Annotated[float | None, typer.Option(metavar="NUMBER")] = None,
    midship: Annotated[float | None, typer.Option(metavar="NUMBER")] = None,
    weathervane: Annotated[bool, typer.Option("--weathervane")] = False,
    mooring_point: LengthOption = None,
    wind_centre: LengthOption = None,
    reflection: Annotated[float, typer.Option(metavar="NUMBER")] = 1.0,
    drift: Annotated[Drift, typer.Option(metavar="WAVES")] = "sea-state",
    **inputs: Any,
) -> None:
    """Compute the loads on a ship, from wind, current and waves."""
    from catopt.loads import METHODS, WaterLevels, every_lying, every_method
    from catopt.loads.ship import BARGE, MIDSHIP, TAKEN_FOR, WATERLINE, box_estimates, estimates
    from catopt.sizing.environment import DIRECTIONS, current_headings, directions_of, read_turning
    from catopt.sizing.input_values import estimated_dimensions, small_craft
    from catopt.sizing.requests import turns_by_itself
    from catopt.sizing.sea import of_the_fetch, of_the_period
    from catopt.sizing.wind import of_the_wind, wind_of_30_s

    lengths = {
        "--waterline": waterline,
        "--mooring-point": mooring_point,
        "--wind-centre": wind_centre,
    }
    with _known("tanker", file, inputs, as_option, _OF_SHIPS) as of:
        make = of.errors.make
        of.require("length", "breadth", "draught", "depth")
        own = make(in_si, {name: (text, Dimension.LENGTH) for name, text in lengths.items()})
        turns = weathervane or any(inputs[name] is None for name in of.given & {*DIRECTIONS})
        if not turns:
            needless = {name: inputs[name] or of[name] for name in ("current_yaw", "scan")}
            needless = {name: text for name, text in needless.items() if name in of.given}
            needless |= given_ones(mooring_point=mooring_point, wind_centre=wind_centre)
            wanted = Message("refused_command.leave_out_or_give_weathervane")
            for name, text in needless.items():
                of.errors.add(name, str(text), wanted)
        of.errors.raise_if_any()
        assert own is not None
        if file is not None:
            propeller = propeller or TAKEN_FOR[of["ship"] or "tanker"][1]
        is_square = of["ship"] == BARGE
        form = _Form(
            own.get("--waterline", (1.0 if is_square else WATERLINE) * of["length"]),
            1.0 if is_square and block is None else block,
            (1.0 if is_square else MIDSHIP) if midship is None else midship,
            kind,
            propeller,
            own.get("--wind-centre"),
        )
        ships = list(_ships_afloat(of, form))
        is_known = turns_by_itself(ships)
        point, yaw = own.get("--mooring-point"), of["current_yaw"] or ""
        turned = partial(read_turning, yaw, point, is_known=is_known)
        turning = of.errors.made(turned) if turns else None
        how = {
            "reflection": reflection,
            "drift": drift.replace("-", " "),
            "wave_coefficient": of["wave_coefficient"],
            "water_density": of["water_density"],
        }
        weather = _weather(of, wind_of_30_s(of))
        levels = make(WaterLevels, of["low_water"] or of["depth"], of["depth"])
        lyings = of.errors.made(
            lambda levels, turned, wind, current, sea: every_lying(
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
            levels,
            make(current_headings, make(directions_of, of), of["scan"] or math.inf),
            *weather,
        )
        worst = largest(lyings, lambda each: each.loads.horizontal_force)
        every = of.errors.made(
            lambda: every_method(
                worst.afloat.ship,
                *weather,
                worst.depth,
                wind_on=worst.afloat.wind_on,
                headings=worst.headings,
                is_balanced=turns,
                **how,
            )
        )
    others = [computed for computed in every if computed.method != worst.loads.method]
    by_hs = drift == "sea-state" and of["hs"] is not None
    has_areas = of["frontal_area"] is not None and of["lateral_area"] is not None
    said = (
        *_what_is_taken(form, worst, turning),
        *(() if has_areas else box_estimates() if is_square else estimates(of["length"])[1:]),
        *of_the_wind(of),
        *of_the_fetch(of),
        *_no_part(of, {*_SHIP, "moulded_depth"} - ({"hmax"} if by_hs else set())),
    )
    taken = of_the_period(of, "loads.taken_period")
    warned = (*estimated_dimensions(of.read), *small_craft(of.read))
    reported = [
        replace(
            computed,
            assumptions=(*taken, *computed.assumptions, *said),
            warnings=(*computed.warnings, *warned),
        )
        for computed in (worst.loads, *others)
    ]
    _give(asked, *reported, lyings=lyings if turns or len(lyings) > 1 else ())


# ------------------------------------------------------------------ parts of the commands


@contextmanager
def _known(
    moored: Moored,
    place: str | None,
    options: dict[str, Any],
    spell: Spelling,
    called: dict[str, str],
) -> Iterator[ResolvedInputs]:
    """Read options, and a file if there is one; what is wrong is told as it stands there."""
    from catopt.sizing.file import read_file
    from catopt.sizing.input_values import input_values

    given = typed(moored, options)
    if place is None:
        yield input_values(moored, given, spell, "options", defaults=_TAKEN, called=called)
        return
    file = read_file(place, moored)
    with file.reporting():
        yield file.known(given, spell, defaults=_TAKEN, called=called)


def _no_part(of: ResolvedInputs, counted: Collection[str]) -> Iterator[Message]:
    """Say what was given, mostly by a sizing's file, that is no part of the loads."""
    from catopt.sizing.inputs import inputs_of

    names = [
        of.errors.spell(name) if name in (*_BUOY, *_SHIP) else row.key
        for name, row in inputs_of(of.moored).items()
        if name in of.given - set(counted)
    ]
    if names:
        yield Message("loads.no_part", names=Cited(", ".join(names)))


def _weather(of: ResolvedInputs, wind: float | None) -> tuple[Any, ...]:
    """Make wind, in m/s, current and waves; None of what is wrong."""
    from catopt.loads import SurfaceCurrent, Wind

    make = of.errors.make
    return make(Wind, wind), make(SurfaceCurrent, of["current"]), make(_sea, of)


def _sea(of: ResolvedInputs) -> SeaState | None:
    """Make the waves; none when neither a height nor a fetch is given."""
    from catopt.loads import SeaState
    from catopt.sizing.sea import has_waves, sea_of

    return sea_of(of) if has_waves(of) else SeaState(of["period"] or 1.0, 0.0)


class _Form(NamedTuple):
    """What makes a ship of its main dimensions, beside them; lengths in m."""

    waterline: float
    block: float | None
    midship: float
    kind: str | None
    propeller: str | None
    wind_centre: float | None


def _ships_afloat(of: ResolvedInputs, form: _Form) -> Iterator[Afloat]:
    """Make the ship at each draught that is known."""
    from catopt.loads import Afloat, Ship
    from catopt.loads.ship import BLOCK, TAKEN_FOR
    from catopt.sizing.requests import draughts_of, own_tables, ship_at
    from catopt.sizing.tanker_request import check_deadweight

    wind_on, _ = TAKEN_FOR[of["ship"] or "tanker"]
    is_named = of["ballast_draught"] is not None or of["condition"] is not None
    draughts: dict[Condition, float] = {"loaded": of["draught"]}
    if is_named:
        draughts = draughts_of(of)
    of.errors.raise_if_any()
    key = "loads.ship_in_condition" if "ballast" in draughts else "loads.ship_of"
    for condition, draught in draughts.items():
        windage = of.errors.made(partial(ship_at, of, condition, "tanker"))
        section = of["breadth"] * draught
        block = BLOCK[condition] if form.block is None else form.block
        centre = windage.lateral_centre if form.wind_centre is None else form.wind_centre
        make_ship = partial(
            Ship,
            Message(key, length=of["length"], condition=term(condition)),
            length_overall=of["length"],
            length_waterline=form.waterline,
            breadth=of["breadth"],
            draught=draught,
            displacement=block * form.waterline * section,
            midship_area=form.midship * section,
            lateral_area=windage.lateral_area,
            frontal_area=windage.frontal_area,
            propeller=form.propeller,
            lateral_centre=centre,
        )
        body = of.errors.made(make_ship)
        if condition == "loaded" and of["dwt"] is not None:
            of.errors.make(check_deadweight, of["dwt"], body)
            of.errors.raise_if_any()
        own = own_tables(of, condition)
        if form.kind and own is not None:
            of.errors.add("kind", form.kind, Message("refused_command.leave_out_this_ship_has"))
        of.errors.raise_if_any()
        yield Afloat(condition, body, form.kind or wind_on.format(condition), own)


def _what_is_taken(form: _Form, worst: ShipHeading, turning: Turning | None) -> Iterator[Message]:
    """Say what the ship was taken for."""
    ship = worst.afloat.ship
    block = ship.displacement / (ship.length_waterline * ship.breadth * ship.draught)
    yield Message("loads.hull_form", length=form.waterline, block=block, midship=form.midship)
    if turning is not None:
        from catopt.sizing.environment import turning_words

        yield turning_words(turning, ship)


def _give(asked: Asked, *results: Loads, lyings: Sequence[ShipHeading] = ()) -> None:
    from catopt.answers.loads import loads_answer
    from catopt.loads.weathervane import loads_document

    asked.check_place()
    document = partial(loads_document, *results, lyings=lyings)
    asked.give(loads_answer(*results, lyings=lyings), document)
