"""The waves of a case: one train, several of them, or a recorded surface."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from types import MappingProxyType
from typing import Annotated, Any, Literal, get_args

from catopt.errors import Problem
from catopt.model.kinds import Angle, File, Length, Measured, Place, Positive, Seed, Time, Whole
from catopt.model.validity import Checked, Findings
from catopt.units import Dimension
from catopt.words import Message

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
class WaveTrain(Checked):
    """Waves of one spectrum: the wind sea, or a swell."""

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
            given = {key: value for key, value in vars(self).items() if value is not None}
            found.problems += train_misfits(given)

    @property
    def directions(self) -> int:
        """Of a train that is spread."""
        return self.spreading_directions or DIRECTIONS


@dataclass(frozen=True)
class WaveState(Checked):
    """Waves of the sea: as one train, as several `trains`, or as recorded in an `elevation_file`.

    What a `WaveTrain` has is of the one train; the direction is also of a record.
    """

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
        given = {
            field.name: getattr(self, field.name)
            for field in fields(self)
            if getattr(self, field.name) != field.default
        }
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
        return [
            Problem(
                "waves",
                " and ".join(ways) if ways else Message("refused_file.none_of_them"),
                wanted,
            )
        ]
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
        allowed: str = Message("refused.with_not_with", way="jonswap", other=spectrum)
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
