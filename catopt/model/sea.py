"""The sea of a case: waves, current, and how a fairlead or a body moves."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from itertools import pairwise
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, Literal, get_args

from catopt.errors import Problem
from catopt.model.kinds import (
    Angle,
    Checked,
    File,
    Findings,
    Height,
    Length,
    Measured,
    Place,
    Positive,
    Seed,
    Size,
    SomeSpeed,
    Speed,
    Time,
    Whole,
)
from catopt.model.plausible_ranges import Plausible
from catopt.units import Dimension
from catopt.words import Message, given_keys

WaveSpectrum = Literal["jonswap", "pierson-moskowitz", "regular"]
WAVE_SPECTRA: tuple[str, ...] = get_args(WaveSpectrum)
Stretching = Literal["none", "wheeler"]

WAVE_WAYS = ("spectrum", "elevation_file", "trains")
"""The keys of which one is given."""

COMPONENTS, DIRECTIONS = 200, 20
"""Regular waves of a train, and directions of one that is spread, unless they are given."""

Gamma = Annotated[float, Measured(Dimension.NUMBER, at_least=1.0, at_most=20.0, example="3.3")]
Components = Annotated[int, Whole("components", example=200)]
Directions = Annotated[int, Whole("spreading_directions", example=20)]

_OF_A_TRAIN: tuple[str, ...] = ("height", "period", "spreading_exponent", "peak_enhancement")
_OF_A_TRAIN += ("direction", "components", "spreading_directions")
_TAKES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "spectrum": (*_OF_A_TRAIN, "stretching", "seed"),
        "elevation_file": ("elevation_x", "shortest_period", "direction", "stretching"),
        "trains": ("stretching", "seed"),
    }
)


@dataclass(frozen=True)
class WaveTrain(Plausible):
    """Waves of one spectrum: the wind sea, or a swell."""

    TABLE: ClassVar[str] = "trains"

    spectrum: WaveSpectrum
    """How their energy lies over the frequency; one wave, if regular."""
    height: Length
    """Significant height Hs; of a regular wave from trough to crest; m."""
    period: Time
    """Peak period Tp; of a regular wave its own; s."""
    peak_enhancement: Gamma | None = None
    """gamma of JONSWAP, 1 to 20; None: by the rule on Tp/sqrt(Hs), docs/waves.md."""
    direction: Angle = 0.0
    """Where they travel to, rad from the x axis, which points from the anchor to the fairlead."""
    components: Components = COMPONENTS
    """Regular waves that the surface is the sum of."""
    spreading_exponent: Positive | None = None
    """n of the spreading function cos^n about the direction, up to a right angle to either side.
    None: all waves have the one direction."""
    spreading_directions: Directions | None = None
    """Directions of equal energy that the waves are spread over; None: 20. The components are a
    multiple of it."""

    def _check(self, found: Findings) -> None:
        found.check("spectrum", *_OF_A_TRAIN)
        if not found.problems:
            own = vars(self).items()
            given = {key: value for key, value in own if value is not None and key != "accept"}
            found.problems += train_misfits(given)

    @property
    def directions(self) -> int:
        """Of a train that is spread."""
        return self.spreading_directions or DIRECTIONS


@dataclass(frozen=True)
class WaveState(Plausible):
    """Waves of the sea: as one train, as several `trains`, or as recorded in an `elevation_file`.

    What a `WaveTrain` has is of the one train; the direction is also of a record.
    """

    TABLE: ClassVar[str] = "waves"

    spectrum: WaveSpectrum | None = None
    height: Length | None = None
    period: Time | None = None
    peak_enhancement: Gamma | None = None
    direction: Angle = 0.0
    components: Components = COMPONENTS
    stretching: Stretching = "none"
    """How far up the motion of the water is taken to go."""
    seed: Seed = 1
    """Run k draws from the generator seeded with (seed, k)."""
    spreading_exponent: Positive | None = None
    spreading_directions: Directions | None = None
    trains: tuple[WaveTrain, ...] = ()
    """Which add up."""
    elevation_file: Annotated[str, File(example='"elevation.csv"')] = ""
    """Path of a CSV file with the columns time and elevation; empty when not used."""
    elevation_x: Place = 0.0
    """Where it was recorded, along x from the anchor, m."""
    shortest_period: Time | None = None
    """Of the record's waves that are kept, s; None: the fastest waves with 0.1 % of the variance
    are left out."""

    def _check(self, found: Findings) -> None:
        default = {field.name: field.default for field in fields(self) if field.compare}
        given = {key: vars(self)[key] for key in default if vars(self)[key] != default[key]}
        found.problems += wave_misfits(given)
        found.check(
            "spectrum", *_OF_A_TRAIN, "elevation_x", "shortest_period", "stretching", "seed"
        )

    @property
    def all_trains(self) -> tuple[WaveTrain, ...]:
        """The trains, or the one; none of a record."""
        if self.spectrum is None:
            return self.trains
        own = {field.name: getattr(self, field.name) for field in fields(WaveTrain)}
        return (WaveTrain(**own),)

    @property
    def is_random(self) -> bool:
        """Whether one of the trains is drawn from a spectrum."""
        return any(train.spectrum != "regular" for train in self.all_trains)


def wave_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List what does not go together in the waves of a case.

    By its name in `WaveState`, what is given; a value that cannot be read is None.
    """
    ways = [key for key in WAVE_WAYS if key in given]
    if len(ways) != 1:
        wanted = Message("refused.exactly_one", ways=", ".join(WAVE_WAYS))
        return [Problem("waves", given_keys(ways), wanted)]
    (way,) = ways
    problems = []
    for key, value in given.items():
        if key == way or key in _TAKES[way]:
            continue
        allowed = Message("refused.not_with", way=way)
        if way == "trains" and key in _OF_A_TRAIN:
            allowed = Message("refused.in_each_train")
        problems.append(Problem(key, repr(value), allowed))
    if way != "spectrum":
        return problems
    problems += [
        Problem(key, "", Message("refused.missing_needs", what="spectrum"))
        for key in ("height", "period")
        if key not in given
    ]
    return problems + train_misfits(given)


def train_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List what does not go together in one train; `given` as for `wave_misfits`."""
    problems = []
    spectrum, count = given.get("spectrum"), given.get("components", COMPONENTS)
    if "peak_enhancement" in given and spectrum in WAVE_SPECTRA and spectrum != "jonswap":
        allowed = Message("refused.with_not_with", way="jonswap", other=spectrum)
        problems.append(Problem("peak_enhancement", repr(given["peak_enhancement"]), allowed))
    if "spreading_exponent" in given and spectrum == "regular":
        allowed = Message("refused_case.regular_wave_has_one_direction")
        problems.append(Problem("spreading_exponent", repr(given["spreading_exponent"]), allowed))
    if "spreading_directions" in given and "spreading_exponent" not in given:
        allowed = Message("refused_case.goes_with_spreading_exponent_which")
        found = repr(given["spreading_directions"])
        return [*problems, Problem("spreading_directions", found, allowed)]
    directions = given.get("spreading_directions", DIRECTIONS)
    if "spreading_exponent" in given and count and directions and count % directions:
        allowed = Message("refused_case.must_be_multiple_directions_so", directions=directions)
        problems.append(Problem("components", repr(count), allowed))
    return problems


ProfileKind = Literal["power", "wind", "table"]
CURRENT_PROFILES: tuple[str, ...] = get_args(ProfileKind)

_NEEDS = MappingProxyType(
    {"power": ("speed",), "wind": ("speed", "depth"), "table": ("depths", "speeds")}
)
_CURRENT_TAKES = MappingProxyType(
    {**_NEEDS, "power": ("speed", "exponent"), "table": ("depths", "speeds", "directions")}
)
_TURN = 0.5 * math.pi * (1.0 + 1e-12)
"""Most by which a current may turn from row to row: its speeds along x and y are interpolated."""


@dataclass(frozen=True)
class CurrentProfile(Plausible):
    """A current over the depth, steady or over time; docs/waves.md has the formulas."""

    TABLE: ClassVar[str] = "current"

    profile: ProfileKind
    """How the speed depends on the depth."""
    speed: SomeSpeed | None = None
    """At the surface, m/s; of a power law or of a current that is driven by wind. None where a file
    gives it."""
    exponent: Positive | None = None
    """Of a power law; None: 1/7."""
    depth: Length | None = None
    """Below still water, where a current that is driven by wind ends, m."""
    depths: tuple[Height, ...] = ()
    """Of a table: below still water, m, each greater than the one before."""
    speeds: tuple[Speed, ...] = ()
    """Of a table, m/s."""
    direction: Angle = 0.0
    """Where it flows to, rad from the x axis, which points from the anchor to the fairlead."""
    directions: tuple[Angle, ...] = ()
    """Of a table that turns with depth, one for each of the depths, in place of `direction`."""
    series_file: Annotated[str, File(example='"current.csv"')] = ""
    """Path of a CSV file of the current at the surface over time, by which the profile is scaled
    and turned; empty for a steady one."""

    def flow(self, water_depth: float) -> Callable[[float], tuple[float, float]]:
        """Return the velocity of the water along x and y, m/s, by the height above the bed, m.

        There is none above the water; that of a steady profile.
        """
        rows = [(water_depth - depth, *self._row(k)) for k, depth in enumerate(self.depths)][::-1]
        heights = [height for height, *_ in rows]
        way = (math.cos(self.direction), math.sin(self.direction))
        exponent = 1.0 / 7.0 if self.exponent is None else self.exponent
        speed, reach = self.speed or 0.0, self.depth or water_depth

        def of_table(z: float) -> tuple[float, float]:
            k = bisect_left(heights, z)
            if k == 0 or k == len(rows):
                return rows[min(k, len(rows) - 1)][1:]
            (low, u, v), (high, more, aside) = rows[k - 1], rows[k]
            part = (z - low) / (high - low)
            return u + part * (more - u), v + part * (aside - v)

        def velocity(z: float) -> tuple[float, float]:
            if z > water_depth * (1.0 + 1e-12):
                return 0.0, 0.0
            if rows:
                return of_table(z)
            if self.profile == "wind":
                share = min(max((reach - water_depth + z) / reach, 0.0), 1.0)
            else:
                share = min(max(z / water_depth, 0.0), 1.0) ** exponent
            return share * speed * way[0], share * speed * way[1]

        return velocity

    def _row(self, k: int) -> tuple[float, float]:
        """Velocity of a row of the table along x and y, m/s."""
        direction = self.directions[k] if self.directions else self.direction
        return self.speeds[k] * math.cos(direction), self.speeds[k] * math.sin(direction)

    def _check(self, found: Findings) -> None:
        found.check("profile")
        found.raise_if_any()
        found.check("depths")
        found.each("speeds", "m/s", at_least=0.0 if self.directions else None)
        found.check("directions")
        self._check_keys(found)
        found.check("speed", "exponent", "depth", "direction")
        self._check_table(found)

    def _check_keys(self, found: Findings) -> None:
        """Find what is missing for the profile, and what goes with another."""
        for key in ("speed", "exponent", "depth", "depths", "speeds", "directions"):
            given = getattr(self, key)
            is_given = given is not None and given != ()
            if key == "speed" and self.series_file and self.profile != "table":
                if is_given:
                    allowed = Message("refused_case.stands_series_file_leave_out")
                    found.add(key, repr(given), allowed)
            elif is_given and key not in _CURRENT_TAKES[self.profile]:
                allowed = Message("refused.not_with_profile", profile=self.profile)
                found.add(key, repr(given), allowed)
            elif not is_given and key in _NEEDS[self.profile]:
                found.add(key, "", Message("refused.profile_needs", profile=self.profile))
        if self.directions and self.direction != 0.0:
            allowed = Message("refused_case.goes_with_one_all_depths")
            found.add("direction", repr(self.direction), allowed)
        if self.series_file and self.speeds and self.speeds[0] <= 0.0:
            allowed = Message("refused_case.must_be_above_0_m")
            found.add("speeds[0]", f"{self.speeds[0]:g} m/s", allowed)

    def _check_table(self, found: Findings) -> None:
        self._check_length("speeds", found)
        for index, (above, depth) in enumerate(pairwise(self.depths), start=1):
            if depth <= above:
                allowed = Message("refused.more_than_before", above=above)
                found.add(f"depths[{index}]", f"{depth:g} m", allowed)
        self._check_length("directions", found)
        for index, turn in enumerate(turns(self.directions), start=1):
            if turn > _TURN:
                allowed = Message("refused_case.more_than_right_angle_from")
                shown = Message("refused_case.a_turn", turn=math.degrees(turn))
                found.add(f"directions[{index}]", shown, allowed)

    def _check_length(self, key: str, found: Findings) -> None:
        depths, others = len(self.depths), len(getattr(self, key))
        if depths and others and depths != others:
            allowed = Message("refused.as_many_as_depths", what=key)
            sizes = Message("refused_case.depths_beside", depths=depths, count=others, key=key)
            found.add(key, sizes, allowed)


def turns(directions: tuple[float, ...]) -> list[float]:
    """List by how much each direction differs from the one before, rad, up to half a turn."""
    return [abs(math.remainder(b - a, 2.0 * math.pi)) for a, b in pairwise(directions)]


RaoPhase = Literal["", "lag", "lead"]
RaoRotation = Literal["", "deg/m", "rad/m"]
RaoPer = Literal["", "amplitude", "height"]
RAO_CONVENTIONS = ("rao_phase", "rao_reference", "rao_rotation", "rao_per")
"""What the RAOs of a body do not say themselves: no default would be right for all of them."""
OF_A_BODY = (*RAO_CONVENTIONS, "rao_crest", "drift", "drift_file")
"""The keys that are of a body with several lines alone."""

MOTION_WAYS = ("period", "file", "rao_file")
"""The keys of which one is given."""

HARMONIC = ("surge", "sway", "heave", "surge_phase", "sway_phase", "heave_phase")
"""The keys that go with a period."""


@dataclass(frozen=True)
class Motion(Checked):
    """Motion of the fairlead about its place at rest, in one of three ways; of a body, its origin.

    RAOs and drift, but for `rao_file`, are of a body with several lines alone.
    """

    period: Time | None = None
    """Of a harmonic motion a cos(2 pi t/T + phase), s."""
    surge: Height = 0.0
    """Amplitude along x, from the anchor to the fairlead, m; sway along y and heave along z."""
    sway: Height = 0.0
    heave: Height = 0.0
    surge_phase: Angle = 0.0
    """rad."""
    sway_phase: Angle = 0.0
    heave_phase: Angle = 0.0
    file: Annotated[str, File(example='"motion.csv"')] = ""
    """Path of a CSV file with the columns t (s), x, y, z (m); empty when not used."""
    rao_file: Annotated[str, File(example='"rao.csv"')] = ""
    """Path of a CSV file of the fairlead's response to a wave of 1 m, by period; empty when not
    used. It goes with waves. Of a body: of its six degrees of freedom, by heading and period."""
    rao_phase: RaoPhase = ""
    """Whether a phase is how far the motion comes after the crest over the reference point, or
    before it."""
    rao_reference: Annotated[tuple[Place, ...], Size(3, 3)] = ()
    """The point that the RAOs are of, along the body's x and y from its origin, and its height
    above the seabed at rest, m; empty when not used."""
    rao_rotation: RaoRotation = ""
    """Unit of roll, pitch and yaw."""
    rao_per: RaoPer = ""
    """Whether the RAOs are to 1 m of the waves' amplitude or of their height."""
    rao_crest: Annotated[tuple[Place, ...], Size(2, 2)] = ()
    """The point over which the crest is where phases count from, along the body's x and y from its
    origin, m; empty for the reference point."""
    drift: Annotated[tuple[Place, ...], Size(2, 2)] = ()
    """How far along x and y the body has drifted from where its mean force holds it, m; empty for
    not at all."""
    drift_file: Annotated[str, File(example='"drift.csv"')] = ""
    """Path of a CSV file with the slow drift over time; empty when not used."""

    @property
    def of_a_body(self) -> list[str]:
        """Which of the keys for a body are given."""
        return [key for key in OF_A_BODY if getattr(self, key)]

    def _check(self, found: Findings) -> None:
        given = [key for key in MOTION_WAYS if getattr(self, key) not in (None, "")]
        if len(given) != 1:
            wanted = Message("refused.exactly_one", ways=", ".join(MOTION_WAYS))
            found.add("motion", given_keys(given), wanted)
        found.check("period", *HARMONIC, "rao_phase", "rao_rotation", "rao_per")
        found.check("rao_reference", "rao_crest", "drift")
        if given in (["file"], ["rao_file"]):
            for key in (k for k in HARMONIC if getattr(self, k) != 0.0):
                allowed = Message("refused.with_not_with", way="period", other=given[0])
                found.add(key, repr(getattr(self, key)), allowed)
