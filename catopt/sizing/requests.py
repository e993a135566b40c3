"""From what is known to what is to be sized; every mistake at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, Final

from catopt.catalogue.practice import own_cable
from catopt.checks.profiles import profiles_of
from catopt.constants import SEA_WATER_DENSITY, YEAR
from catopt.errors import InputError
from catopt.loads import BuoyShape, SurfaceCurrent, WaterLevels, Wind, buoys, read_buoys
from catopt.loads.buoy import buoy as look_up
from catopt.loads.calmar_file import SUFFIX, read_calmar_buoy
from catopt.loads.ship import (
    BALLAST_SOURCE,
    BARGE,
    MOULDED,
    SHORTEST,
    TAKEN_FOR,
    Condition,
    Ship,
    ballast_draught,
    box_estimates,
    estimated_tanker,
    estimates,
)
from catopt.loads.ship_coefficients import SQUARE_ENDED, ShipCoefficients, read_ship_coefficients
from catopt.loads.sinker import AS_CLAY, soil_named
from catopt.loads.weathervane import Afloat
from catopt.model import Checks
from catopt.model.kinds import Findings
from catopt.sizing.buoy import sized_buoy
from catopt.sizing.buoy_request import BuoyRequest, GivenBuoy
from catopt.sizing.environment import (
    Environment,
    Weathervaning,
    demands,
    left_out,
    period_range,
    weathervaning_of,
)
from catopt.sizing.in_motion import RunsAfloat
from catopt.sizing.input_values import FOUND_BY, ResolvedInputs
from catopt.sizing.inputs import SINKER
from catopt.sizing.kinds import usual
from catopt.sizing.line_choice import LineChoice, sold, unpriced_components
from catopt.sizing.maintenance import UpkeepInputs
from catopt.sizing.pattern import CALMAR_SOIL, SAND, DragGround, SinkerGround
from catopt.sizing.quick import quick_runs
from catopt.sizing.result import Sizing
from catopt.sizing.sea import of_the_fetch, of_the_period, sea_of
from catopt.sizing.tanker import sized_tanker
from catopt.sizing.tanker_request import MooredShip, TankerRequest, note_aground
from catopt.sizing.wind import blowing, of_place, of_the_wind, wind_of_30_s
from catopt.words import Cited, Listed, Message, Several, given_keys, term

_WEATHER: Final = ("wind", "current", "hs")
"""What a return period is of."""


def size(of: ResolvedInputs) -> Sizing:
    """Size what is known; what is wrong is told as the caller spells it.

    Raises what `catopt.size_buoy` and `catopt.size_tanker` raise.
    """
    maker: Callable[..., Sizing] = sized_buoy if of.moored == "buoy" else sized_tanker
    return of.errors.made(maker, request_of(of))


def request_of(of: ResolvedInputs) -> BuoyRequest | TankerRequest:
    """Make the request for a buoy or a tanker; every mistake is told at once."""
    request = _of_a_buoy(of) if of.moored == "buoy" else _of_a_tanker(of)
    known = of.given | {name for name, by in FOUND_BY.items() if by in of.given}
    weather = [] if "force" in of.given else [k for k in _WEATHER if k not in known]
    if of["return_period"] and weather:
        allowed = Message("refused_sizing.period_of_weather", missing=Listed(weather, "and"))
        years = Message("refused_file.years", count=of["return_period"] / YEAR)
        of.errors.add("return_period", years, allowed)
    of.errors.raise_if_any()
    assert request is not None
    return request


def _of_a_buoy(of: ResolvedInputs) -> BuoyRequest | None:
    of.require("depth")
    body = _body(of)
    place = _environment(of, is_pushed=of.given.isdisjoint({"force", "reserve_buoyancy"}))
    line = _line(of, *_sizes_for(of, body))
    ground = _ground(of)
    prices = (of[f"{what}_price"] for what in ("chain", "sinker", "fittings", "visit"))
    maker = partial(
        BuoyRequest,
        marine_growth=of["growth"] or 0.0,
        wave_height=of["wave_height"] or "hs",
        chain_waves=bool(of["chain_waves"]),
        load_method=of["load_method"],
        scope=of["scope"],
        in_motion=_runs(of),
        upkeep=of.errors.make(partial(UpkeepInputs, of["thrash_wear"], *prices))
        or UpkeepInputs(),  # what is wrong is told with the rest
        crane=of["crane"],
        title=of["title"] or "",
        source=of["source"] or "",
        document=of.title_block,
        defaults=_taken(of, place, ground),
        inputs=of.read,
    )
    return of.errors.make(maker, body, place, line, ground)


def _of_a_tanker(of: ResolvedInputs) -> TankerRequest | None:
    of.require("length", "breadth", "draught", "depth")
    ships = _ships(of)
    place = _environment(of, wind=wind_of_30_s(of))
    shape = None if of["buoy"] is None else shape_of(of)
    largest, bound = _largest_chain(of, ships, shape)
    line = _line(of, of["diameter_min"], largest)
    ground = _ground(of)
    vane = weathervaning_of(of, is_turned=turns_by_itself(ships))
    words = _taken(of, place, ground)
    if of.given.isdisjoint({"diameter_min", "diameter_max"}):
        words = (bound, *words) if bound.key == "sizing.sizes_by_her_cable" else (*words, bound)
    maker = partial(
        TankerRequest,
        buoy=shape,
        hawser=0.0 if shape is None else of["hawser"],
        lines=of["lines"],
        pretension=of["pretension"],
        clump_masses=of["clump_weight"] or (),
        load_methods=of["load_method"],
        wave_coefficient=of["wave_coefficient"],
        weathervaning=vane or Weathervaning(),
        title=of["title"] or "",
        source=of["source"] or "",
        document=of.title_block,
        defaults=words,
        service_type=of["service_type"],
        in_motion=_runs(of),
        estimates=(
            *of_the_hull(of),
            *of_the_ballast(of),
            *of_the_wind(of),
            *of_the_service(of, place),
        ),
        inputs=of.read,
    )
    is_found = of["buoy"] is None or shape is not None
    is_made = is_found and vane is not None
    return of.errors.make(maker, ships, place, line, ground) if is_made else None


def _runs(of: ResolvedInputs) -> RunsAfloat | None:
    """Say how lines are run with the buoy or the ship: fast, in full, or not at all."""
    if of["at_rest"]:
        return None
    if not of["in_motion"]:
        return quick_runs(of.moored)
    own: dict[str, Any] = {}
    if of.moored == "buoy":
        keys = ("max_slide", "centre_of_gravity", "max_heel", "pitch_damping")
        own = {key: of[key] for key in keys}
        if of["light_divergence"]:
            own["max_heel"] = 0.5 * of["light_divergence"]
        own["other_lengths"] = of["other_lengths"] or 0
    own["periods"], own["heights"] = of["peak_period"] or (), of["sea_height"] or ()
    sea = of.errors.make(sea_of, of) if of["period_range"] or of["sea_height"] else None
    if of["period_range"] and sea is not None and sea.hs > 0.0:
        own["periods"] = period_range(sea)
    made = of.errors.make(partial(RunsAfloat, **own), of["seeds"], of["run_time"])
    if made is not None and sea is not None:
        of.errors.make(partial(_check_heights, sea.hs), made)
    return made


def _check_heights(most: float, of: RunsAfloat) -> None:
    """Refuse seas higher than that of the place, for which the steady forces are computed."""
    found = Findings("RunsAfloat")
    for k, each in enumerate(of.heights):
        found.number(f"heights[{k}]", each, "m", above=0.0, at_most=most)
    found.raise_if_any()


# ------------------------------------------------------------------ place and weather


def of_the_service(of: ResolvedInputs, place: Environment | None) -> tuple[Message, ...]:
    """Say what the service type asks for, and which motions are left out."""
    if place is None or of["service_type"] is None:
        return ()
    asked = tuple(demands(of["service_type"], place))
    return (*asked, left_out(place)) if of["at_rest"] else asked


def _environment(
    of: ResolvedInputs, *, is_pushed: bool = True, wind: float | None = None
) -> Environment | None:
    """Make depths and weather; where the force is given, wind and current do not count."""
    make, high = of.errors.make, of["depth"]
    levels = make(WaterLevels, of["low_water"] or high, high)
    blows = make(Wind, (wind or blowing(of)) if is_pushed else 0.0)
    current = make(SurfaceCurrent, of["current"] if is_pushed else 0.0)
    maker = partial(Environment, water_density=of["water_density"])
    return make(maker, levels, blows, current, make(sea_of, of))


# ------------------------------------------------------------------ buoy and ship


def _body(of: ResolvedInputs) -> BuoyShape | GivenBuoy | None:
    """Look the buoy up, or take it by its force and its buoyancy."""
    errors, pair = of.errors, ("force", "reserve_buoyancy")
    by_force = [name for name in pair if name in of.given or errors.is_reported(name)]
    if "buoy" in of.given and by_force:
        instead = given_keys(map(errors.spell, by_force))
        errors.add("buoy", f'"{of["buoy"]}"', Message("refused.leave_out_or", other=instead))
        return None
    if "buoy" in of.given:
        return shape_of(of)
    if not by_force:
        keys = {name: errors.spell(name) for name in pair}
        errors.add("buoy", "", Message("refused.buoy_wanted", **keys))
        return None
    of.require(*pair)
    return errors.make(GivenBuoy, of["force"], of["reserve_buoyancy"], of["keel_depth"])


def shape_of(of: ResolvedInputs) -> BuoyShape | None:
    """Look a buoy up by its name, in the library and in a file of one's own; or read CALMAR's."""
    if of["buoy"] is not None and of["buoy"].lower().endswith(SUFFIX):
        return read_calmar_buoy(of["buoy"])
    own = of["buoys"]
    among = (*buoys(), *(() if own is None else read_buoys(own)))
    return of.errors.make(lambda name: look_up(name, among), of["buoy"])


def _ships(of: ResolvedInputs) -> tuple[MooredShip, ...] | None:
    """Make the ship in each condition, as far as its dimensions are known."""
    if None in (of["length"], of["breadth"], of["draught"]):
        return None
    ships = [of.errors.make(_ship, of, condition) for condition in draughts_of(of)]
    made = tuple(ship for ship in ships if ship is not None)
    note_aground(made, of["low_water"] or of["depth"] or math.inf, of.errors.add)
    return made if made and len(made) == len(ships) else None


def draughts_of(of: ResolvedInputs) -> dict[Condition, float]:
    """Take the conditions that count, with their draughts, m; none where something is wrong.

    Both count unless one is named. A draught in ballast that is not given is estimated; where that
    is no less than the loaded one, and of a barge, the ship counts loaded alone.
    """
    loaded, ballast = of["draught"], of["ballast_draught"]
    wanted: tuple[Condition, ...] = of["condition"] or ("loaded", "ballast")
    wrong = None
    if ballast is not None and "ballast" not in wanted:
        key = "refused_sizing.leave_out_or_name_ballast"
        wrong = Message(key, value=of.errors.spell("condition"))
    elif ballast is not None and ballast > loaded:
        wrong = Message("refused_sizing.not_above_loaded_draught_m", loaded=loaded)
    if wrong is not None:
        of.errors.add("ballast_draught", f"{ballast:g} m", wrong)
        return {}
    found: dict[Condition, float] = {"loaded": loaded} if "loaded" in wanted else {}
    if "ballast" in wanted:
        light = ballast_draught(of["length"]) if ballast is None else ballast
        if ballast is not None or (light < loaded and of["ship"] != BARGE):
            found["ballast"] = light
        elif not found:
            allowed = Message("refused_sizing.missing_this_ship_cannot_be")
            of.errors.add("ballast_draught", "", allowed)
    return found


def of_the_ballast(of: ResolvedInputs) -> tuple[Message, ...]:
    """Say which draught in ballast was estimated, or that none could be."""
    if of["ballast_draught"] is not None or None in (of["length"], of["draught"]):
        return ()
    if "ballast" not in (of["condition"] or ("ballast",)):
        return ()
    draught = draughts_of(of).get("ballast")
    if draught is None:
        return (Message("sizing.no_ballast"),)
    source = Cited(BALLAST_SOURCE.text)
    return (Message("sizing.ballast_estimated", draught=draught, source=source),)


_SHORT: Final = 4.5
"""Length over breadth of a hull that may be a barge's; merchant ships have 5 to 7."""


def own_tables(of: ResolvedInputs, condition: str) -> ShipCoefficients | None:
    """Take the coefficients of a ship's own in a condition, or those of square ends."""
    is_barge = of["ship"] == BARGE
    if of["coefficients"] is None:
        return SQUARE_ENDED if is_barge else None
    try:
        own = read_ship_coefficients(of["coefficients"]).in_condition(condition)
    except InputError as error:
        for each in error.problems:
            of.errors.add("coefficients", f"{each.key} {each.found}".strip(), each.allowed)
        return None
    if is_barge and not (own.wind and own.current):
        key = "refused_sizing.barge_wants_tables_wind_current"
        of.errors.add(
            "coefficients", str(of["coefficients"]), Message(key, condition=term(condition))
        )
    return own


def turns_by_itself(ships: Iterable[MooredShip | Afloat] | None) -> bool:
    """Whether the tables of a ship's own have the moment of the current."""
    tables = [each.coefficients for each in ships or ()]
    return bool(tables) and all(each is not None and each.turns for each in tables)


def of_the_hull(of: ResolvedInputs) -> tuple[Message, ...]:
    """Say what was estimated of the hull, and what a square-ended one would have."""
    if of["ship"] == BARGE:
        return box_estimates()
    is_short = None not in (of["length"], of["breadth"]) and of["length"] < _SHORT * of["breadth"]
    if of["coefficients"] is None and (is_short or of["ship"] == "general cargo"):
        return (*estimates(of["length"] or SHORTEST), Message("sizing.not_square_ended"))
    return estimates(of["length"] or SHORTEST)


def ship_at(
    of: ResolvedInputs, condition: Condition, name: str, propeller: str | None = "tanker"
) -> Ship:
    """Estimate the ship at one of its draughts.

    Areas that are given are those of the loaded ship, which rises by the difference.
    """
    loaded, given = of["draught"], of["ballast_draught"]
    light = ballast_draught(of["length"]) if given is None else given
    draught = loaded if condition == "loaded" else light
    risen = loaded - draught
    frontal, lateral = of["frontal_area"], of["lateral_area"]
    return estimated_tanker(
        name,
        of["length"],
        of["breadth"],
        draught,
        moulded_depth=of["moulded_depth"] or MOULDED * loaded,
        condition=condition,
        frontal_area=None if frontal is None else frontal + of["breadth"] * risen,
        lateral_area=None if lateral is None else lateral + of["length"] * risen,
        propeller=propeller,
        is_square_ended=of["ship"] == BARGE,
    )


def _ship(of: ResolvedInputs, condition: Condition) -> MooredShip:
    dwt, kind = of["dwt"], of["ship"]
    wind_on, propeller = TAKEN_FOR[kind]
    name = term(kind) if dwt is None else Message("sizing.ship_of", kind=term(kind), mass=dwt / 1e3)
    ship = ship_at(of, condition, name, propeller)
    loaded = of["draught"]
    moulded = of["moulded_depth"] or MOULDED * loaded
    fairlead = moulded - loaded if of["fairlead"] is None else of["fairlead"]
    fairlead += loaded - ship.draught
    return MooredShip(
        condition,
        ship,
        wind_on.format(condition),
        fairlead,
        dwt if condition == "loaded" else None,
        own_tables(of, condition),
    )


# ------------------------------------------------------------------ line, and what holds it


def _sizes_for(
    of: ResolvedInputs, body: BuoyShape | GivenBuoy | None
) -> tuple[float | None, float | None]:
    """Bound a buoy's chain, m: by what is given, or by what the buoy is made for."""
    least, most = of["diameter_min"], of["diameter_max"]
    if not isinstance(body, BuoyShape):
        return least, most
    made_from, made_to = body.chain_min, body.chain_max
    # One bound that is given may lie beyond the other that the buoy has.
    if least is None and made_from is not None and made_from <= (most or math.inf):
        least = made_from
    if most is None and made_to is not None and made_to >= (least or 0.0):
        most = made_to
    return least, most


def _line(of: ResolvedInputs, least: float | None, most: float | None) -> LineChoice | None:
    """Make what the line may be; its components have to be known."""
    choice: dict[str, Any] = {
        "diameter_min": least,
        "diameter_max": most,
        "length_step": of["length_step"],
        "max_swing": of["max_swing"],
        "life": of["life"],
        "wear_rate": of["wear"],
        "dynamic_factor": of["dynamic_factor"],
        "allow_recalled": bool(of["recalled"]),
    }
    make = of.errors.make
    if of.moored == "buoy":
        choice["scope"] = _scope(of)
    # With the usual code, so that a wrong code and a wrong chain are reported at once.
    usual_code = usual("code", of.moored)
    usual_line = make(lambda: LineChoice(of["chain"], usual_code, **choice))
    is_known = make(lambda each: bool(sold(each, of["water_density"])), usual_line)
    choice |= _preference(of, usual_line if is_known else None)
    line = make(lambda: LineChoice(of["chain"], of["code"], **choice))
    return line if is_known else None


_CARRIED: Final = 2.0
"""Times her own cable: the thickest chain that is looked at for a ship's bow; catopt's own."""


def _largest_chain(
    of: ResolvedInputs, ships: tuple[MooredShip, ...] | None, shape: BuoyShape | None
) -> tuple[float, Message]:
    """Bound a ship's chain, m, and say by what.

    A bound that is given counts. At her bow the chain is no thicker than her own gear takes, but of
    the smallest size that is sold at least; a smallest size that is given moves the usual bound.
    """
    usual_most, least = float(of["diameter_max"]), float(of["diameter_min"] or 0.0)
    said = Message("sizing.sizes_up_to", most=usual_most * 1e3)
    if "diameter_max" in of.given:
        return usual_most, said
    cable = None
    if ships and shape is None:
        ship = ships[0].ship  # loaded, where she counts so
        mass = ship.displacement * SEA_WATER_DENSITY
        cable = own_cable(mass, ship.frontal_area, ship.lateral_area)
    if cable is None or _CARRIED * cable >= usual_most:
        return max(least, usual_most), said
    choice = LineChoice(of["chain"], usual("code", of.moored), allow_recalled=bool(of["recalled"]))
    try:
        sizes = [each.nominal_diameter or 0.0 for each in sold(choice, of["water_density"])]
    except InputError:  # which is told of the chain
        sizes = []
    bound = max(_CARRIED * cable, min(sizes, default=0.0))
    values = {"most": bound * 1e3, "cable": cable * 1e3, "times": _CARRIED}
    return max(least, bound), Message("sizing.sizes_by_her_cable", **values)


def _scope(of: ResolvedInputs) -> tuple[float, float]:
    """Bound a buoy's line, in depths; one bound that is given moves the usual other one."""
    least, most = of["scope_min"] or 0.0, of["scope_max"] or math.inf
    if "scope_max" not in of.given:
        return least, max(least, most)
    return (least if "scope_min" in of.given else min(least, most)), most


def _preference(of: ResolvedInputs, line: LineChoice | None) -> dict[str, Any]:
    """Say which design is required: as asked for, or a buoy's by practice, a ship's balanced."""
    prefer, swing_price = of["prefer"], of["swing_price"] or 0.0
    # What is laid, of a buoy and of a ship whose lines are run.
    is_run = of["in_motion"] or not (of["at_rest"] or of["buoy"])
    own = "practice" if of.moored == "buoy" or is_run else "balanced"
    if (of["lines"] or 1) > 1:
        own = "lightest"  # several lines hold the ship in its place: swing decides nothing
    if line is None:
        return {"prefer": prefer or own}
    unpriced = list(unpriced_components(line, of["water_density"]))
    if of["clump_weight"]:
        unpriced.append(term("clump weights"))
    if unpriced:
        why = Message("refused_sizing.no_price_known", names=Several(unpriced, ", "))
        if prefer == "cheapest":
            allowed = Message("refused_sizing.take_lightest", allowed=why)
            of.errors.add("prefer", '"cheapest"', allowed)
        if swing_price:
            allowed = Message("refused_sizing.leave_out", allowed=why)
            of.errors.add("swing_price", f"{swing_price:g}", allowed)
        return {"prefer": own if prefer in (None, "cheapest") else prefer}
    return {"prefer": prefer or ("cheapest" if swing_price else own), "swing_price": swing_price}


_NO_DRAG: Final = ("gravel or coarse sand", "clean sound rock")
"""Soils in which no drag anchor has figures: it does not bite."""


def _ground(of: ResolvedInputs) -> DragGround | SinkerGround | None:
    """Make what holds the line: a sinker, or of a tanker a drag anchor by its kind."""
    if of.moored == "tanker" and of["anchor"] != SINKER:
        soil = AS_CLAY.get(of["soil"], of["soil"])
        recalled = bool(of["recalled"])
        if soil_named(soil or "") in _NO_DRAG:
            said = Message("refused_sizing.no_drag_anchor", anchor=of.errors.spell("anchor"))
            of.errors.add("soil", f"'{of['soil']}'", said)
            return None
        return of.errors.make(partial(DragGround, of["anchor"], soil, allow_recalled=recalled))
    soil = soil_named(of["soil"]) if of["soil"] else None
    if soil is None and of["friction"] is None:
        soil = _soil_of(of["code"])
    figures = soil, of["friction"], of["sinker"], of["sinker_density"]
    # What scour may take away of the soil beside it holds nothing.
    block = of["base_area"], max(0.0, (of["embedment"] or 0.0) - (of["scour"] or 0.0))
    return of.errors.make(partial(SinkerGround, *figures, *block))


def _soil_taken(of: ResolvedInputs, ground: DragGround | SinkerGround) -> Iterator[Message]:
    """Say which soil a word was taken for, and which base of a sinker on clay."""
    if ground.soil not in (None, of["soil"]):
        key = "sizing.mud_as_clay" if isinstance(ground, DragGround) else "sizing.soil_taken_for"
        word = term(of["soil"]) if of["soil"] in AS_CLAY else of["soil"]
        yield Message(key, soil=word, taken=term(str(ground.soil)))
    if isinstance(ground, SinkerGround) and ground.bond is not None and of["base_area"] is None:
        yield Message("sizing.taken_base")


def _soil_of(code: str) -> str:
    """Name the soil whose friction a sinker has that nothing is said of: the code's, or sand."""
    try:
        (profile,) = profiles_of(Checks(codes=(code,), allow_recalled=True))
    except InputError:  # which is told of the code
        return SAND
    return (profile.method.soil if profile.method else "") or SAND


def _taken(
    of: ResolvedInputs, place: Environment | None, ground: DragGround | SinkerGround | None
) -> tuple[str, ...]:
    """Say what was taken because it was not given."""
    words: list[str] = [
        Message(each.of.taken, value=each.said)
        for each in of.read
        if each.origin == "taken" and each.of.taken
    ]
    words += of_the_fetch(of)
    if place is not None:
        words += of_the_period(of, "sizing.taken_period")
    if "low_water" not in of.given:
        words.append(Message("sizing.no_tide"))
    if of.given.isdisjoint({"soil", "friction"}) and ground is not None:
        key = "sizing.taken_friction" if ground.soil == CALMAR_SOIL else "sizing.taken_soil"
        words.append(Message(key, soil=term(str(ground.soil))))
    if of["soil"] and ground is not None:
        words += _soil_taken(of, ground)
    words += _weather_taken(of)
    if "chain" not in of.given:
        words += of["chain"]
    if "code" not in of.given:
        words.append(Message("sizing.taken_code", code=of["code"]))
    return tuple(words)


def _weather_taken(of: ResolvedInputs) -> Iterator[Message]:
    """Say by what the wind was found, and of which return period the weather is."""
    blows = of_place(of)
    if blows is not None:
        values = {"place": of["place"], "zone": blows.zone, "confidence": blows.confidence}
        years = blows.period / YEAR
        yield Message("sizing.of_place", speed=blows.speed, years=years, **values)
    elif "return_period" not in of.given:
        yield Message("sizing.no_return_period")
    if of["life"] and of["return_period"]:
        years, life = of["return_period"], of["life"]
        chance = -math.expm1(life * math.log1p(-min(1.0 - 1e-12, YEAR / years)) / YEAR)
        values = {"years": years / YEAR, "life": life / YEAR, "chance": chance}
        yield Message("sizing.exceeded_in_life", **values)
