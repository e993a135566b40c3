"""Water levels and weather that a mooring is sized for, and what a code asks of them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Final, Literal, NamedTuple, get_args

from catopt.constants import SEA_WATER_DENSITY
from catopt.errors import refused
from catopt.loads.environment import HEAD_ON, Headings, SeaState, SurfaceCurrent, WaterLevels, Wind
from catopt.loads.ship import Ship
from catopt.loads.weathervane import CLARKE_LEVER, YAW_TYPES, CurrentYaw, Turning, lever_of
from catopt.model.kinds import Findings
from catopt.sizing.input_values import ResolvedInputs
from catopt.sizing.kinds import usual
from catopt.units import UNITS, Dimension, as_written
from catopt.words import Message

_PERIOD_OF_HEIGHT: Final = 3.6
"""s per root of m: 2 pi Hs/(g T^2) is then 1/20, the steepness of a growing sea; catopt's own."""

LONGEST_MEAN: Final = 3600.0
"""s: the mean that the profile starts from."""

_TURBULENCE, _WITH_SPEED, _GUST = 0.06, 0.043, 0.41
"""Of Iu = 0.06 (1 + 0.043 U0) at 10 m and U(t) = U0 (1 - 0.41 Iu ln(t/3600)), in m and s."""


def usual_period(significant_height: float) -> float:
    """Period of a sea that is still growing: 3.6 sqrt(Hs), s; catopt's own rule. Hs in m."""
    return max(1.0, round(_PERIOD_OF_HEIGHT * math.sqrt(significant_height), 1))


JONSWAP_RANGE: Final = (3.6, 5.0)
"""s per root of m: peak periods over the root of Hs that JONSWAP stands for (DNV-RP-C205, B). At
the first its peak enhancement is 5, at the last 1."""
_IN_RANGE: Final = 5
_ALIKE: Final = 0.02


def period_range(sea: SeaState) -> tuple[float, ...]:
    """List peak periods over the range that JONSWAP stands for, evenly, and the sea's own, s.

    The own one stands in the place of one that is the same within 2 %.

    Examples
    --------
    >>> period_range(SeaState(8.0, 4.0))
    (7.2, 8.0, 8.6, 9.3, 10.0)
    """
    first, last = (each * math.sqrt(sea.hs) for each in JONSWAP_RANGE)
    step = (last - first) / (_IN_RANGE - 1)
    found = (round(first + k * step, 2) for k in range(_IN_RANGE))
    others = (each for each in found if abs(each - sea.period) > _ALIKE * sea.period)
    return tuple(sorted((sea.period, *others)))


WIND_MEAN: Final = 30.0
"""s: the wind that loads on a ship are computed for is a mean over this (UFC 3-8.1, page 42)."""


@dataclass(frozen=True)
class Environment:
    """Depths and weather."""

    levels: WaterLevels  # depth of the still water at low and at high water
    # wind, current and waves come all at once and from one side
    wind: Wind = field(default_factory=lambda: Wind(usual("wind")))
    current: SurfaceCurrent = field(default_factory=lambda: SurfaceCurrent(usual("current")))
    sea: SeaState = field(default_factory=lambda: SeaState(usual_period(usual("hs")), usual("hs")))
    water_density: float = SEA_WATER_DENSITY  # kg/m3

    @property
    def is_calm(self) -> bool:
        """Whether nothing pushes."""
        return self.wind.speed == self.current.speed == self.sea.hmax == 0.0

    @property
    def crest(self) -> float:
        """Height of the largest crest over the still water at high water, Hmax/2, m (CALMAR)."""
        return self.levels.deepest(self.sea) - self.levels.high


def mean_over(speed: float, given: float, wanted: float) -> float:
    """Convert a wind speed at 10 m from one averaging time to another.

    U(t) = U0 [1 - 0.41 Iu ln(t/3600)] with Iu = 0.06 (1 + 0.043 U0), U0 the mean of an hour
    (NPD/ISO 19901-1, B: read in two programs). U0 is the root of a quadratic equation. Speeds are
    in m/s; InputError for averaging times `given` or `wanted` that are not of 1 s to an hour.

    Examples
    --------
    >>> round(mean_over(25.0, 600.0, 30.0), 2)
    28.37
    """
    found = Findings("wind mean")
    for key, time in (("given", given), ("wanted", wanted)):
        found.number(key, time, "s", at_least=1.0, at_most=LONGEST_MEAN)
    found.raise_if_any()
    if given == wanted:
        return speed
    gust = _gust(given)
    a, b = gust * _WITH_SPEED, 1.0 + gust
    hourly = 2.0 * speed / (b + math.sqrt(b * b + 4.0 * a * speed))
    gust = _gust(wanted)
    return hourly * (1.0 + gust * (1.0 + _WITH_SPEED * hourly))


def _gust(time: float) -> float:
    return -_GUST * _TURBULENCE * math.log(time / LONGEST_MEAN)


DIRECTIONS: Final = ("wind_angle", "current_angle", "wave_angle", "scan")
"""Inputs of which any makes a ship turn until it is at rest."""

_LEAST_STEP: Final = math.radians(1.0)


class Weathervaning(NamedTuple):
    """From where a ship is pushed, and what turns it."""

    directions: tuple[Headings, ...] = (HEAD_ON,)  # each is one case
    turning: Turning | None = None  # None: all comes from one side, and the ship lies head to it


def weathervaning_of(of: ResolvedInputs, *, is_turned: bool = False) -> Weathervaning | None:
    """Make the directions that are known; None where something is wrong with them.

    `is_turned`: whether the ship's own tables have the moment of the current.
    """
    make = of.errors.make
    if of.given.isdisjoint(DIRECTIONS):
        if "current_yaw" in of.given:
            allowed = Message(
                "refused_sizing.leave_out_or_give_one",
                spell=", ".join(map(of.errors.spell, DIRECTIONS)),
            )
            of.errors.add("current_yaw", as_written(of["current_yaw"]), allowed)
        return Weathervaning()
    if of.values.keys().isdisjoint(DIRECTIONS):
        return None  # what is wrong with them is told
    turning = make(partial(read_turning, of["current_yaw"] or "", is_known=is_turned))
    directions = make(partial(directions_of, of))
    turned = make(current_headings, directions, of["scan"] or math.inf)
    return make(Weathervaning, turned, turning)


def directions_of(of: ResolvedInputs) -> Headings:
    """Make where wind, current and waves come from: ahead where that is not given."""
    return Headings(*(of[name] or 0.0 for name in DIRECTIONS[:3]))


def read_turning(
    current_yaw: str, mooring_point: float | None = None, *, is_known: bool = False
) -> Turning:
    """Read what turns a ship; anything else is refused.

    `is_known`: whether the moment of the current is in tables of the ship's own.

    `current_yaw` is `CLARKE_LEVER`, a key of `catopt.loads.YAW_TYPES`, or "a, b" of UFC's table
    4-10, b per degree; the mooring point is in m forward of midships, the bow when left out.
    """
    kinds = ", ".join(YAW_TYPES)
    allowed = Message("refused_sizing.one_recalled_r_or_b", own=CLARKE_LEVER, yaw_types=kinds)
    if is_known:
        if current_yaw:
            own = Message("refused_sizing.leave_out_ship_s_own")
            raise refused("current_yaw", f'"{current_yaw}"', own, "heading")
        return Turning(None, mooring_point)
    if not current_yaw:
        missing = Message("refused.missing", wanted=allowed)
        raise refused("current_yaw", "", missing, "heading")
    if current_yaw == CLARKE_LEVER:
        return Turning(CLARKE_LEVER, mooring_point)
    if current_yaw in YAW_TYPES:
        return Turning(YAW_TYPES[current_yaw], mooring_point)
    try:
        intercept, slope = (float(each) for each in current_yaw.split(","))
    except ValueError:
        raise refused("current_yaw", f'"{current_yaw}"', allowed, "heading") from None
    return Turning(CurrentYaw(intercept, slope), mooring_point)


def current_headings(directions: Headings, step: float) -> tuple[Headings, ...]:
    """Turn the current right round from where it is, in steps of 1 to 180 deg, in rad.

    A step of infinity gives the beginning alone; any other is refused.
    """
    if step == math.inf:
        return (directions,)
    if not _LEAST_STEP <= step <= math.pi:
        allowed = Message("refused_sizing.step_1_180_deg_wanted")
        raise refused("scan", f"{math.degrees(step):g} deg", allowed, "heading")
    count = math.ceil(2.0 * math.pi / step - 1e-9)
    turned = (math.remainder(directions.current + k * step, 2.0 * math.pi) for k in range(count))
    return tuple(replace(directions, current=each) for each in turned)


def turning_words(turning: Turning, ship: Ship) -> Message:
    """Say what turns a ship."""
    held = {"point": turning.lever(ship), "centre": ship.lateral_centre}
    if turning.yaw is None:
        return Message("loads.turning_own", **held)
    if isinstance(turning.yaw, str):
        return Message("loads.turning_by_hull", **held, lever=lever_of(ship).at_the_bow)
    return Message(
        "loads.turning_recalled" if turning.yaw.recalled else "loads.turning",
        **held,
        intercept=turning.yaw.intercept,
        slope=turning.yaw.slope,
    )


ServiceType = Literal["I", "II", "III", "IV"]
"""I: in mild weather; II: left before a storm; III: up to two years, not left; IV: longer."""

SERVICE_TYPES: Final[tuple[ServiceType, ...]] = get_args(ServiceType)

DYNAMIC: Final = ("III", "IV")
"""Types that dynamic methods are required for."""

_KNOT: Final = UNITS[Dimension.SPEED]["kn"]
_MILD_WIND: Final = 34.0 * _KNOT
_MILD_CURRENT: Final = 2.0 * _KNOT
"""m/s: type I is for less than these."""

_GUST_MEAN: Final = 3.0
"""s: over which a gust is a mean."""


def demands(of: ServiceType, env: Environment) -> Iterator[Message]:
    """Say what the code asks for: whether a steady calculation is enough."""
    name = Message(f"sizing.service_{of}")
    key = "sizing.service_dynamic" if of in DYNAMIC else "sizing.service_steady"
    yield Message(key, type=of, name=name)
    is_mild = env.wind.speed < _MILD_WIND and env.current.speed < _MILD_CURRENT
    if of == "I" and not is_mild:
        yield Message("sizing.service_beyond", wind=env.wind.speed, current=env.current.speed)
    yield Message("sizing.fishtailing")


def left_out(env: Environment) -> Message:
    """Say which motions no allowance here stands for, with what a gust adds to the wind's part."""
    speed = env.wind.speed
    gust = (mean_over(speed, WIND_MEAN, _GUST_MEAN) / speed) ** 2 - 1.0 if speed else 0.0
    return Message("sizing.motions_left_out", share=100.0 * gust)
