"""Everything that a sizing may be told, in one table.

The options of ``catopt size``, its questions on a terminal, the keys of a sizing file, the keywords
of `catopt.size_buoy` and `catopt.size_tanker`, the places that errors name and the reference in
docs/sizing.md are all made of it. The words are in ``words/texts/inputs.toml``, and in
``left_out.toml`` what is taken where no value can be written down.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from catopt.casefile.reading import Moored

SINKER: Final = "sinker"
"""As the anchor of a tanker: held by its weight."""


@dataclass(frozen=True)
class Input:
    """One thing that a sizing may be told."""

    name: str  # keyword in Python; the option is the same with dashes
    key: str  # in a file, with its section
    takes: str  # name of a `catopt.units.Dimension`, or TEXT, NAME, FILE, WHICH, COUNT or FLAG
    example: object  # as a file has it
    default: str = ""  # what is taken when left out, as a user would write it; empty: no value
    of: tuple[Moored, ...] = ("buoy", "tanker")  # what has to be moored for it to count
    above: float | None = None  # bounds in SI, exclusive and inclusive
    at_least: float | None = None
    most: str = ""  # what the model takes at most; it says why
    words: tuple[str, ...] = ()  # of which WHICH takes one
    several: bool = False  # whether there may be several values
    required: bool = False  # whether it has to be known, or what stands in its place
    asked: bool = False  # on a terminal, when something that is required is missing
    called: tuple[str, ...] = ()  # what the model calls it, if otherwise: the place of its errors
    also: tuple[str, ...] = ()  # what a user may call it in a file, who then reads the key
    not_with: tuple[str, ...] = ()  # inputs that stand in its place, or have it in them
    only_with: str = ""  # input without which it would not be evaluated
    why: str = ""  # text for one who gives it beside those; empty: the model says it
    taken: str = ""  # key of the text that says that the default was taken
    left_out: str = ""  # key of the text that says what is taken, where that is no fixed value
    bare: str = ""  # unit of a bare number; that of SI when empty
    estimated_from: str = ""  # input from which it is estimated, where that is given
    tanker: tuple[tuple[str, object], ...] = ()  # attributes that are others for a tanker

    @property
    def path(self) -> tuple[str, ...]:
        """Where it stands in a file."""
        return tuple(self.key.split("."))

    @property
    def section(self) -> str:
        """Of a file; empty at the top."""
        return self.key.rpartition(".")[0]

    @property
    def one_example(self) -> Any:
        """Its example; the first of several."""
        return self.example[0] if isinstance(self.example, tuple) else self.example

    @property
    def is_measure(self) -> bool:
        """Whether it has a dimension."""
        return self.takes not in ("TEXT", "NAME", "FILE", "WHICH", "COUNT", "FLAG")


_BUOY: Final[tuple[Moored, ...]] = ("buoy",)
_TANKER: Final[tuple[Moored, ...]] = ("tanker",)
_GIVEN: Final = ("force", "reserve_buoyancy")
_FREE: Final = (("required", False), ("asked", False), ("not_with", ()))
_IN_IT: Final = "or_all_in_it"

INPUTS: Final = (
    Input("title", "title", "TEXT", "Pillar buoy in 12 m", left_out="left_out.title"),
    Input("source", "source", "TEXT", "Harbour survey of 2024", left_out="left_out.source"),
    # Asked for last, after buoy or ship, depth and weather.
    Input(
        "max_swing", "line.max_swing", "LENGTH", "60 m", above=0.0, asked=True,
        tanker=(("example", "450 m"),),
    ),
    Input(
        "ship", "ship.kind", "WHICH", "bulk carrier", "tanker", of=_TANKER,
        words=("tanker", "bulk carrier", "general cargo", "barge"), also=("type",),
    ),
    Input(
        "dwt", "ship.deadweight", "MASS", "50000 t", of=_TANKER, above=0.0, asked=True,
        called=("deadweight",), also=("DWT",), bare="t",
    ),
    Input(
        "length", "ship.length", "LENGTH", "234 m", of=_TANKER, above=0.0, most="600 m",
        required=True, asked=True, called=("length_overall",), also=("LOA", "L"),
        estimated_from="dwt", left_out="left_out.by_deadweight",
    ),
    Input(
        "breadth", "ship.breadth", "LENGTH", "31.3 m", of=_TANKER, above=0.0, most="100 m",
        required=True, asked=True, also=("B", "beam"),
        estimated_from="dwt", left_out="left_out.by_deadweight",
    ),
    Input(
        "draught", "ship.draught", "LENGTH", "12.4 m", of=_TANKER, above=0.0,
        required=True, asked=True, also=("T", "draft"),
        estimated_from="dwt", left_out="left_out.by_deadweight",
    ),
    Input(
        "ballast_draught", "ship.ballast_draught", "LENGTH", "3.2 m", of=_TANKER, above=0.0,
        left_out="left_out.ballast_draught",
    ),
    Input(
        "condition", "ship.condition", "WHICH", ("loaded", "ballast"), of=_TANKER, several=True,
        words=("loaded", "ballast"), left_out="left_out.condition",
    ),
    Input(
        "moulded_depth", "ship.moulded_depth", "LENGTH", "16 m", of=_TANKER, above=0.0,
        also=("D", "depth"), left_out="left_out.moulded_depth",
    ),
    Input(
        "frontal_area", "ship.frontal_area", "AREA", "580 m^2", of=_TANKER, above=0.0,
        left_out="left_out.estimated",
    ),
    Input(
        "lateral_area", "ship.lateral_area", "AREA", "1200 m^2", of=_TANKER, above=0.0,
        left_out="left_out.estimated",
    ),
    Input(
        "fairlead", "ship.fairlead_above_water", "LENGTH", "5 m", of=_TANKER, at_least=0.0,
        most="100 m", also=("fairlead_height",), left_out="left_out.fairlead",
    ),
    Input(
        "coefficients", "ship.coefficients", "FILE", "coefficients.toml", of=_TANKER,
        not_with=("load_method",), why="or_in_its_place",
        left_out="left_out.coefficients",
    ),
    Input(
        "buoy", "buoy.name", "NAME", "pillar 1.8 m", required=True, asked=True, not_with=_GIVEN,
        tanker=(("example", "mooring buoy 5.0 m"), *_FREE),
    ),
    Input("buoys", "buoy.file", "FILE", "buoys.toml", only_with="buoy"),
    Input(
        "force", "buoy.horizontal_force", "FORCE", "5 kN", of=_BUOY, above=0.0, required=True,
        asked=True, called=("horizontal_force",), also=("H",), not_with=("buoy",),
    ),
    Input(
        "reserve_buoyancy", "buoy.reserve_buoyancy", "FORCE", "12 kN", of=_BUOY, above=0.0,
        required=True, asked=True, called=("pull",), not_with=("buoy",),
    ),
    Input(
        "keel_depth", "buoy.keel_depth", "LENGTH", "1.2 m", "0 m", of=_BUOY, at_least=0.0,
        also=("draught",), not_with=("buoy",), why="or_by_shape",
    ),
    Input(
        "hawser", "buoy.hawser_length", "LENGTH", "60 m", "50 m", of=_TANKER, at_least=0.0,
        most="1000 m", only_with="buoy",
    ),
    Input(
        "depth", "site.water_depth", "LENGTH", "12 m", above=0.0, most="200 m", required=True,
        asked=True, called=("high", "levels.high"), also=("d", "depth", "high_water"),
        tanker=(("example", "22 m"), ("most", "12000 m")),
    ),
    Input(
        "low_water", "site.low_water", "LENGTH", "10 m", above=0.0, asked=True,
        called=("low", "levels.low"), left_out="left_out.low_water",
    ),
    Input(
        "water_density", "site.water_density", "DENSITY", 1010, "1025 kg/m^3", above=0.0,
        most="1100 kg/m^3", also=("rho",),
    ),
    Input(
        "place", "site.place", "NAME", "Vung Tau", of=_BUOY, not_with=("wind", "force"),
        why="or_in_its_place", left_out="left_out.place",
    ),
    # The wind that IACS UR A1 designs anchoring equipment for; current and Hs are catopt's own.
    Input(
        "wind", "environment.wind", "SPEED", "25 m/s", "25 m/s", at_least=0.0, most="100 m/s",
        asked=True, called=("Wind.speed",), also=("wind_speed",), not_with=("force",), why=_IN_IT,
        taken="sizing.taken_wind",
    ),
    Input(
        "wind_mean", "environment.wind_mean", "TIME", "10 min", "30 s", of=_TANKER, at_least=1.0,
        most="3600 s", called=("wind mean.given",), taken="sizing.taken_wind_mean",
    ),
    Input(
        "return_period", "environment.return_period", "TIME", "100 years", above=0.0,
        left_out="left_out.return_period",
    ),
    Input(
        "current", "environment.current", "SPEED", "1.2 m/s", "1 m/s", at_least=0.0,
        most="10 m/s", asked=True, called=("SurfaceCurrent.speed", "current.speed"),
        also=("current_speed",), not_with=("force",), why=_IN_IT, taken="sizing.taken_current",
    ),
    Input(
        "hs", "environment.hs", "LENGTH", "1.5 m", "2 m", at_least=0.0, most="40 m", asked=True,
        called=("significant_height",), also=("height",), taken="sizing.taken_hs",
        left_out="left_out.hs",
    ),
    Input(
        "hmax", "environment.hmax", "LENGTH", "3.5 m", at_least=0.0, most="40 m",
        called=("maximum_height",), also=("H",), left_out="left_out.hmax",
    ),
    Input(
        "period", "environment.period", "TIME", "8 s", above=0.0, most="30 s", also=("T", "Tp"),
        left_out="left_out.period",
    ),
    Input(
        "fetch", "environment.fetch", "LENGTH", "10 km", above=0.0, most="1000 km",
        not_with=("hs", "hmax", "force"), why="or_in_its_place", left_out="left_out.fetch",
    ),
    Input(
        "fetch_depth", "environment.fetch_depth", "LENGTH", "8 m", above=0.0,
        only_with="fetch", left_out="left_out.fetch_depth",
    ),
    Input(
        "load_method", "environment.load_method", "WHICH", "catopt-buoy", "IALA-CALMAR",
        words=("IALA-CALMAR", "catopt-buoy"),
        tanker=(
            ("example", ("UFC-Blendermann", "22TCN-222-95")), ("default", "UFC-Blendermann"),
            ("words", ("UFC-Blendermann", "UFC-4-159-03", "22TCN-222-95")), ("several", True),
            ("called", ("load_methods",)), ("also", ("load_methods",)),
        ),
    ),
    Input(
        "wave_coefficient", "environment.wave_coefficient", "NUMBER", 0.1, of=_TANKER,
        at_least=0.0, most="1", also=("chi",), left_out="left_out.wave_coefficient",
    ),
    *(
        Input(
            f"{what}_angle", f"environment.{what}_angle", "ANGLE", "30 deg", of=_TANKER,
            most="180 deg", called=(f"Headings.{called}",),
            left_out="left_out.from_ahead",
        )
        for what, called in (("wind", "wind"), ("current", "current"), ("wave", "waves"))
    ),
    Input(
        "current_yaw", "environment.current_yaw", "NAME", "series-60", of=_TANKER,
        left_out="left_out.current_yaw",
    ),
    Input(
        "scan", "environment.scan", "ANGLE", "30 deg", of=_TANKER, above=0.0, most="180 deg",
        left_out="left_out.scan",
    ),
    Input(
        "wave_height", "environment.wave_height", "WHICH", "hmax", "hs", of=_BUOY,
        words=("hs", "hmax"), not_with=("force",), why=_IN_IT,
    ),
    Input(
        "chain_waves", "environment.chain_waves", "FLAG", True, of=_BUOY, not_with=("force",),
        why=_IN_IT,
    ),
    Input(
        "growth", "environment.marine_growth", "LENGTH", "50 mm", "0 mm", of=_BUOY, at_least=0.0,
        most="0.5 m", called=("marine_growth",), not_with=("force",), why=_IN_IT,
    ),
    # Open-link buoy chain of IALA, whose figures were all read in CALMAR's own table (A). The
    # largest size of a ship's chain is catopt's own bound; its step is half a shot.
    Input(
        "chain", "line.components", "NAME", ("chain studless R3", "chain studless R4"),
        "chain open-link 4D Q2", several=True, called=("components", "component"),
        also=("component", "chain"), tanker=(("default", "chain studless R3"),),
    ),
    Input(
        "diameter_min", "line.diameter_min", "LENGTH", "20 mm", above=0.0,
        left_out="left_out.every_size",
    ),
    Input(
        "diameter_max", "line.diameter_max", "LENGTH", "44 mm", above=0.0,
        left_out="left_out.every_size", tanker=(("default", "120 mm"), ("left_out", "")),
    ),
    Input(
        "length_step", "line.length_step", "LENGTH", "1 m", above=0.0,
        left_out="left_out.length_step", tanker=(("default", "13.75 m"), ("left_out", "")),
    ),
    Input(
        "prefer", "line.prefer", "WHICH", "balanced", left_out="left_out.prefer",
        words=("practice", "shortest", "cheapest", "lightest", "balanced", "least-swing"),
    ),
    # Sealite's manual of the Nautilus-2200, page 11: two to three depths (A).
    Input(
        "scope_min", "line.scope_min", "NUMBER", 2.5, "2", of=_BUOY, at_least=0.0, most="20",
    ),
    Input("scope", "line.scope", "NUMBER", 2, "2.5", of=_BUOY, above=0.0, most="20"),
    Input(
        "scope_max", "line.scope_max", "NUMBER", 4, "3", of=_BUOY, above=0.0, most="20",
    ),
    Input("swing_price", "line.swing_price", "NUMBER", 50, at_least=0.0),
    Input(
        "clump_weight", "line.clump_weights", "MASS", ("5 t", "10 t"), of=_TANKER, above=0.0,
        several=True, called=("clump_masses",),
    ),
    Input("lines", "system.lines", "COUNT", 6, "1", of=_TANKER),
    Input(
        "pretension", "system.pretension", "NUMBER", "10 %", "10 %", of=_TANKER, above=0.0,
        most="0.9", only_with="lines",
    ),
    Input(
        "anchor", "anchor.name", "NAME", "Stevpris Mk5", "Stevpris Mk5", of=_TANKER,
        also=("kind", "anchor"),
    ),
    Input("soil", "anchor.soil", "NAME", "mud", "sand", of=_TANKER, left_out="left_out.soil"),
    Input(
        "sinker", "sinker.material", "WHICH", "steel", "concrete", words=("concrete", "steel"),
        called=("material",),
    ),
    Input(
        "sinker_density", "sinker.density", "DENSITY", "2300 kg/m^3", above=0.0,
        most="20000 kg/m^3", called=("density",), left_out="left_out.sinker_density",
    ),
    Input(
        "soil", "sinker.soil", "NAME", "fine or silty sand", asked=True,
        not_with=("friction",), left_out="left_out.sinker_soil", tanker=(("asked", False),),
    ),
    Input(
        "friction", "sinker.friction", "NUMBER", 0.4, above=0.0, most="1.5", also=("mu",),
        not_with=("soil",), left_out="left_out.friction",
    ),
    Input(
        "base_area", "sinker.base_area", "AREA", "2.2 m^2", above=0.0, also=("base",),
        left_out="left_out.base_area",
    ),
    Input(
        "embedment", "sinker.embedment", "LENGTH", "0.3 m", at_least=0.0, most="10 m",
        only_with="soil",
    ),
    Input(
        "scour", "sinker.scour", "LENGTH", "0.2 m", of=_BUOY, at_least=0.0, most="10 m",
        only_with="embedment", left_out="left_out.scour",
    ),
    Input(
        "crane", "sinker.crane", "MASS", "5 t", of=_BUOY, above=0.0, bare="t",
        left_out="left_out.crane",
    ),
    Input(
        "code", "checks.code", "NAME", "break/5", "IALA-CALMAR",
        tanker=(("default", "UFC-4-159-03"),),
    ),
    Input("recalled", "checks.allow_recalled", "FLAG", True),
    Input(
        "life", "service.life", "TIME", "10 years", "5 years", at_least=0.0, most="100 years",
        taken="sizing.taken_life",
    ),
    Input(
        "wear", "service.wear_rate", "SPEED", "0.4 mm/year", "0.4 mm/year", at_least=0.0,
        most="10 mm/year", called=("wear_rate",), taken="sizing.taken_wear",
    ),
    Input(
        "thrash_wear", "service.thrash_wear", "SPEED", "2 mm/year", of=_BUOY, at_least=0.0,
        most="10 mm/year", left_out="left_out.thrash_wear",
    ),
    *(
        Input(
            f"{what}_price", f"service.{what}_price", "NUMBER", example, of=_BUOY, at_least=0.0,
            left_out="left_out.price",
        )
        for what, example in
        (("chain", 1800), ("sinker", 150), ("fittings", 900), ("visit", 6000))
    ),
    Input(
        "service_type", "service.type", "WHICH", "III", "II", of=_TANKER,
        words=("I", "II", "III", "IV"), taken="sizing.taken_service_type",
    ),
    Input("in_motion", "motion.run", "FLAG", True),
    Input(
        "at_rest", "motion.left_out", "FLAG", True, not_with=("in_motion",), why="or_in_its_place"
    ),
    Input("seeds", "motion.seeds", "COUNT", 5, "3", only_with="in_motion"),
    # Slow motions of a ship have periods of minutes: a run of hers is a storm of three hours.
    Input(
        "run_time", "motion.duration", "TIME", "20 min", "10 min", at_least=60.0,
        most="10 h", only_with="in_motion", called=("duration",),
        tanker=(("default", "3 h"), ("example", "6 h")),
    ),
    Input(
        "peak_period", "motion.peak_periods", "TIME", ("6 s", "8 s"), above=0.0, most="30 s",
        several=True, called=("periods",), only_with="in_motion", left_out="left_out.peak_period",
    ),
    Input(
        "sea_height", "motion.sea_heights", "LENGTH", ("2 m", "2.5 m"), above=0.0, most="25 m",
        several=True, called=("heights",), only_with="peak_period",
        left_out="left_out.sea_height",
    ),
    Input(
        "period_range", "motion.period_range", "FLAG", True, not_with=("peak_period",),
        why="or_in_its_place", only_with="in_motion",
    ),
    Input(
        "other_lengths", "motion.other_lengths", "COUNT", 4, "0", of=_BUOY,
        only_with="in_motion",
    ),
    Input(
        "max_slide", "motion.max_slide", "LENGTH", "0.5 m", of=_BUOY, above=0.0,
        only_with="in_motion", left_out="left_out.max_slide",
    ),
    Input(
        "max_heel", "motion.max_heel", "ANGLE", "5 deg", of=_BUOY, above=0.0,
        most="89 deg", only_with="in_motion", left_out="left_out.max_heel",
    ),
    # Two names of one limit: half of the divergence is the heel at half of the light's strength.
    Input(
        "light_divergence", "motion.light_divergence", "ANGLE", "10 deg", of=_BUOY, above=0.0,
        most="90 deg", only_with="in_motion", not_with=("max_heel",), why="or_in_its_place",
        left_out="left_out.max_heel",
    ),
    Input(
        "pitch_damping", "motion.pitch_damping", "NUMBER", 0.1, of=_BUOY, at_least=0.0,
        most="1", only_with="in_motion", left_out="left_out.pitch_damping",
    ),
    Input(
        "centre_of_gravity", "buoy.centre_of_gravity", "LENGTH", "0.4 m", of=_BUOY,
        only_with="in_motion", left_out="left_out.centre_of_gravity",
    ),
    Input(
        "dynamic_factor", "service.dynamic_factor", "NUMBER", 1.5, at_least=1.0, most="10",
        left_out="left_out.dynamic_factor",
    ),
)  # fmt: skip
"""In the order in which they are asked for and listed."""


@cache
def rows_of(moored: Moored) -> tuple[Input, ...]:
    """List the rows of a buoy or a tanker."""
    rows = [each for each in INPUTS if moored in each.of]
    if moored == "buoy":
        return tuple(rows)
    changes: list[dict[str, Any]] = [dict(each.tanker) for each in rows]
    return tuple(replace(each, **other) for each, other in zip(rows, changes, strict=True))


@cache
def inputs_of(moored: Moored, *, held_by: str = "") -> Mapping[str, Input]:
    """List the inputs of a buoy or a tanker by name.

    `held_by`: of a tanker: its anchor, which says what else counts; empty: all that may count.
    """
    is_open = moored == "buoy" or not held_by
    other = "-" if is_open else "anchor" if held_by == SINKER else "sinker"
    found: dict[str, Input] = {}
    for each in rows_of(moored):
        if each.section != other or each.name == "anchor":
            found.setdefault(each.name, each)
    return MappingProxyType(found)
