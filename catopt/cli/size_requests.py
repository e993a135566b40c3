"""From the options of ``catopt size`` to what is to be sized; every mistake at once."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from catopt.cli.size_questions import Given

if TYPE_CHECKING:
    from catopt.cli.gathered import Gathered
    from catopt.cli.size_file import Filled
    from catopt.loads import BuoyShape
    from catopt.sizing import (
        BuoyRequest,
        DragGround,
        Environment,
        GivenBuoy,
        LineChoice,
        MooredShip,
        SinkerGround,
        TankerRequest,
    )
from catopt.words import Message, term

__all__ = ["SINKER", "Wishes", "buoy_request", "tanker_request", "titled"]

SINKER = "sinker"
"""As an anchor of a tanker: held by its weight."""


class Wishes(NamedTuple):
    """What is not a number.

    Attributes
    ----------
    chains : list of str or None
        Families with their grades; None: the default.
    code : str or None
        Profile of criteria; None: the default.
    prefer : str
        Which of the best lines is recommended.
    material : str
        Of a sinker.
    own_buoys : Path or None
        File of buoys of the user's own.
    recalled : bool
        Whether figures that were read in no document may be used.
    anchor : str
        Kind of drag anchor, or "sinker".
    lines : int
        Of a tanker's mooring.
    """

    chains: list[str] | None
    code: str | None
    prefer: str
    material: str
    own_buoys: Path | None
    recalled: bool
    anchor: str = SINKER
    lines: int = 1

    @classmethod
    def among(cls, options: Given) -> Wishes:
        """Take them out of all options."""
        return cls(
            chains=options["--chain"],
            code=options["--code"],
            prefer=options["--prefer"],
            material=options["--sinker"],
            own_buoys=options["--buoys"],
            recalled=options["--recalled"],
            anchor=options.get("--anchor", SINKER),
            lines=options.get("--lines", 1),
        )


_HAWSER = 50.0
"""m."""


Request = TypeVar("Request", "BuoyRequest", "TankerRequest")


def titled(request: Request, filled: Filled) -> Request:
    """Give a request the title and the source of the file that it came from.

    Parameters
    ----------
    request : BuoyRequest or TankerRequest
        Without them.
    filled : Filled
        Options and the file.
    """
    if filled.file is None:
        return request
    return replace(request, title=filled.file.text("title"), source=filled.file.text("source"))


def buoy_request(given: Given, wishes: Wishes) -> BuoyRequest:
    """Make the request for a buoy.

    Parameters
    ----------
    given : dict of str to str or None
        Options by name, and ``BUOY``.
    wishes : Wishes
        The rest.

    Raises
    ------
    InputError
        With every mistake, by the option.
    """
    from catopt.cli.gathered import Gathered
    from catopt.cli.size_parts import NAMES, environment, measured, missing, taken
    from catopt.sizing import BuoyRequest
    from catopt.sizing.buoy_request import BUOY_CHAIN, BUOY_CODE

    is_given = given["--force"] is not None or given["--reserve-buoyancy"] is not None
    counted = ("--hs",) if is_given else ("--wind", "--current", "--hs")
    defaults = taken(given, (*counted, "--life", "--wear"))
    values = measured(given | defaults)
    gathered = Gathered(NAMES)
    missing(gathered, given, {"--depth": "12 m"})
    body = _body(gathered, given, values, wishes.own_buoys)
    place = environment(gathered, values, is_pushed=not is_given)
    line = _line(gathered, values, wishes, (BUOY_CHAIN, BUOY_CODE))
    ground = _sinker_ground(gathered, given, values, wishes)
    words = _taken_words(given, defaults, place, ground, wishes, (BUOY_CHAIN, BUOY_CODE))
    request = gathered.make(
        lambda a, b, c, d: BuoyRequest(a, b, c, d, values["--growth"], defaults=words),
        body,
        place,
        line,
        ground,
    )
    gathered.raise_if_any()
    assert request is not None
    return request


def _body(
    gathered: Gathered, given: Given, values: dict[str, float], own_buoys: Path | None
) -> BuoyShape | GivenBuoy | None:
    """Look the buoy up, or take it by its force and its buoyancy."""
    from catopt.cli.size_parts import missing
    from catopt.sizing import GivenBuoy

    pair = {"--force": "5 kN", "--reserve-buoyancy": "12 kN"}
    name, by_force = given["BUOY"], [each for each in pair if given[each] is not None]
    if name is not None and by_force:
        gathered.add("BUOY", f'"{name}"', f"leave it out, or {' and '.join(by_force)}")
        return None
    if name is not None:
        return gathered.make(_look_up(own_buoys), name)
    if not by_force:
        gathered.add(
            "BUOY",
            "",
            'missing; the name of a buoy is wanted, such as "pillar 1.8 m", or --force and '
            "--reserve-buoyancy of one of your own",
        )
        return None
    missing(gathered, given, pair)
    force, reserve = values.get("--force"), values.get("--reserve-buoyancy")
    keel = values.get("--keel-depth", 0.0)
    return gathered.make(GivenBuoy, force, reserve, keel)


def _look_up(own_buoys: Path | None) -> Callable[[str], BuoyShape]:
    from catopt.loads import buoys as library
    from catopt.loads.buoy_library import buoy as look_up
    from catopt.loads.buoy_library import read_buoys

    known = (*library(), *(read_buoys(own_buoys) if own_buoys is not None else ()))
    return lambda name: look_up(name, known)


def _line(
    gathered: Gathered,
    values: dict[str, float],
    wishes: Wishes,
    usual: tuple[str, str],
    **bounds: float,
) -> LineChoice | None:
    """Make what the line may be; its components have to be known."""
    from catopt.sizing import LineChoice
    from catopt.sizing.components import sold

    chain, code = usual
    choice: Any = {
        "diameter_min": values.get("--diameter-min", bounds.get("diameter_min")),
        "diameter_max": values.get("--diameter-max", bounds.get("diameter_max")),
        "length_step": values.get("--length-step", bounds.get("length_step")),
        "prefer": wishes.prefer,
        "life": values["--life"],
        "wear_rate": values["--wear"],
        "allow_recalled": wishes.recalled,
    }
    chains = tuple(wishes.chains or [chain])
    # With the usual code, so that a wrong code and a wrong chain are told at once.
    usual_line = gathered.make(lambda: LineChoice(chains, code, **choice))
    is_known = gathered.make(lambda each: bool(sold(each, values["--water-density"])), usual_line)
    line = gathered.make(lambda: LineChoice(chains, wishes.code or code, **choice))
    return line if is_known else None


def _sinker_ground(
    gathered: Gathered, given: Given, values: dict[str, float], wishes: Wishes
) -> SinkerGround | None:
    from catopt.sizing import SinkerGround

    friction = values.get("--friction")
    soil = given["--soil"] or (SinkerGround.soil if friction is None else None)
    known: Any = {"material": wishes.material, "density": values.get("--sinker-density")}
    return gathered.make(
        lambda: SinkerGround(soil, friction, allow_recalled=wishes.recalled, **known)
    )


_TAKEN = {
    "--wind": "sizing.taken_wind",
    "--current": "sizing.taken_current",
    "--hs": "sizing.taken_hs",
    "--life": "sizing.taken_life",
    "--wear": "sizing.taken_wear",
}


def _taken_words(
    given: Given,
    defaults: dict[str, str],
    place: Environment | None,
    ground: DragGround | SinkerGround | None,
    wishes: Wishes,
    usual: tuple[str, str],
) -> tuple[str, ...]:
    """Say what was taken because it was not given."""
    chain, code = usual
    words = [Message(_TAKEN[option], value=text) for option, text in defaults.items()]
    if given["--period"] is None and place is not None:
        words.append(Message("sizing.taken_period", period=place.sea.period))
    if given["--low-water"] is None:
        words.append(Message("sizing.no_tide"))
    if given["--soil"] is None and given["--friction"] is None and ground is not None:
        words.append(Message("sizing.taken_soil", soil=term(str(ground.soil))))
    taken_chain = () if wishes.chains else (chain,)
    if wishes.code is None:
        return (*words, *taken_chain, Message("sizing.taken_code", code=code))
    return (*words, *taken_chain)


def tanker_request(given: Given, wishes: Wishes) -> TankerRequest:
    """Make the request for a tanker.

    Parameters
    ----------
    given : dict of str to str or None
        Options by name.
    wishes : Wishes
        The rest.

    Raises
    ------
    InputError
        With every mistake, by the option.
    """
    from catopt.cli.gathered import Gathered
    from catopt.cli.size_parts import NAMES, environment, measured, missing, taken
    from catopt.loads.ship_estimate import estimates
    from catopt.sizing import TankerRequest
    from catopt.sizing.tanker_request import HALF_A_SHOT, SHIP_CHAIN, SHIP_CODE, SHIP_SIZES

    defaults = taken(given, ("--wind", "--current", "--hs", "--life", "--wear"))
    values = measured(given | defaults)
    gathered = Gathered(NAMES)
    missing(
        gathered,
        given,
        {"--length": "234 m", "--breadth": "31.3 m", "--draught": "12.4 m", "--depth": "22 m"},
    )
    ships = _ships(gathered, values)
    place = environment(gathered, values)
    name = given["--buoy"]
    shape = None if name is None else gathered.make(_look_up(wishes.own_buoys), name)
    least, most = SHIP_SIZES
    usual = (SHIP_CHAIN, SHIP_CODE)
    line = _line(
        gathered,
        values,
        wishes,
        usual,
        diameter_min=min(least, values.get("--diameter-max", least)),
        diameter_max=max(most, values.get("--diameter-min", most)),
        length_step=HALF_A_SHOT,
    )
    ground = _ground(gathered, given, values, wishes)
    words = _taken_words(given, defaults, place, ground, wishes, usual)
    if "--diameter-min" not in values and "--diameter-max" not in values:
        sizes = {"least": least * 1e3, "most": most * 1e3}
        words = (*words, Message("sizing.sizes_from_to", **sizes))
    hawser = values.get("--hawser", _HAWSER if name is not None else 0.0)
    request = gathered.make(
        lambda a, b, c, d, _: TankerRequest(
            a,
            b,
            c,
            d,
            buoy=shape,
            hawser=hawser,
            lines=wishes.lines,
            pretension=values["--pretension"],
            clump_masses=tuple(
                value for option, value in values.items() if option.startswith("--clump-weight")
            ),
            defaults=words,
            estimates=estimates(),
        ),
        ships,
        place,
        line,
        ground,
        name is None or shape,
    )
    gathered.raise_if_any()
    assert request is not None
    return request


def _ships(gathered: Gathered, values: dict[str, float]) -> tuple[MooredShip, ...] | None:
    """Make the ship in each condition, as far as its dimensions are given."""
    wanted = ("--length", "--breadth", "--draught")
    if any(each not in values for each in wanted):
        return None
    conditions = {"loaded": "--draught", "ballast": "--ballast-draught"}
    ships = [
        gathered.make(lambda c=condition: _ship(values, c))
        for condition, option in conditions.items()
        if option in values
    ]
    made = tuple(ship for ship in ships if ship is not None)
    low = values.get("--low-water", values.get("--depth", math.inf))
    for ship in made:
        if ship.ship.draught >= low:
            gathered.add(
                conditions[ship.condition],
                f"{ship.ship.draught:g} m",
                f"the water is {low:g} m deep at low water: the ship would be aground",
            )
    return made if len(made) == len(ships) else None


def _ship(values: dict[str, float], condition: str) -> MooredShip:
    from catopt.loads.ship_estimate import MOULDED, estimated_tanker
    from catopt.sizing import MooredShip

    loaded = values["--draught"]
    draught = loaded if condition == "loaded" else values["--ballast-draught"]
    moulded = values.get("--moulded-depth", MOULDED * loaded)
    # Where the areas are given, they are those of the loaded ship: it rises by the difference.
    risen = loaded - draught
    areas = {"--frontal-area": values["--breadth"], "--lateral-area": values["--length"]}
    frontal, lateral = (
        values[option] + side * risen if option in values else None
        for option, side in areas.items()
    )
    dwt = values.get("--dwt")
    name = term("tanker") if dwt is None else Message("loads.tanker_of", mass=dwt / 1e3)
    ship = estimated_tanker(
        name,
        values["--length"],
        values["--breadth"],
        draught,
        moulded_depth=moulded,
        condition="loaded" if condition == "loaded" else "ballast",
        frontal_area=frontal,
        lateral_area=lateral,
    )
    fairlead = values.get("--fairlead", moulded - loaded) + risen
    return MooredShip(
        condition,
        ship,
        f"tanker {condition}",
        fairlead,
        dwt if condition == "loaded" else None,
    )


def _ground(
    gathered: Gathered, given: Given, values: dict[str, float], wishes: Wishes
) -> DragGround | SinkerGround | None:
    """Make what holds the line: a sinker, or a drag anchor by its kind."""
    from catopt.sizing import DragGround

    if wishes.anchor == SINKER:
        return _sinker_ground(gathered, given, values, wishes)
    soil = given["--soil"] or DragGround.soil
    return gathered.make(lambda: DragGround(wishes.anchor, soil, allow_recalled=wishes.recalled))
