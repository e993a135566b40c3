"""The waves of a case: one train, several of them, or a recorded surface."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, dataclass, fields
from types import MappingProxyType
from typing import Any, Literal, get_args

from catopt.errors import Problem
from catopt.model.validity import Findings

WaveSpectrum = Literal["jonswap", "pierson-moskowitz", "regular"]
WAVE_SPECTRA: tuple[str, ...] = get_args(WaveSpectrum)
Stretching = Literal["none", "wheeler"]
STRETCHINGS: tuple[str, ...] = get_args(Stretching)

WAVE_WAYS = ("spectrum", "elevation_file", "trains")
"""The keys of which one is given."""

COMPONENTS, DIRECTIONS = 200, 20
"""Regular waves of a train, and directions of one that is spread, unless they are given."""

_OF_A_TRAIN = (
    "height", "period", "peak_enhancement", "direction", "components", "spreading_exponent",
    "spreading_directions",
)  # fmt: skip
_TAKES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "spectrum": (*_OF_A_TRAIN, "stretching", "seed"),
        "elevation_file": ("elevation_x", "shortest_period", "direction", "stretching"),
        "trains": ("stretching", "seed"),
    }
)


@dataclass(frozen=True)
class WaveTrain:
    """Waves of one spectrum: the wind sea, or a swell.

    Attributes
    ----------
    spectrum : {"jonswap", "pierson-moskowitz", "regular"}
        How their energy lies over the frequency; one wave, if regular.
    height : float
        Significant height Hs; of a regular wave from trough to crest; m.
    period : float
        Peak period Tp; of a regular wave its own; s.
    peak_enhancement : float or None
        gamma of JONSWAP, 1 to 20; None: by the rule on Tp/sqrt(Hs), docs/waves.md.
    direction : float
        Where they travel to, rad from the x axis, which points from the anchor to the fairlead.
    components : int
        Regular waves that the surface is the sum of.
    spreading_exponent : float or None
        n of the spreading function cos^n about the direction, up to a right angle to either side.
        None: all waves have the one direction.
    spreading_directions : int or None
        Directions of equal energy that the waves are spread over; None: 20. The components are a
        multiple of it.
    """

    spectrum: WaveSpectrum
    height: float
    period: float
    peak_enhancement: float | None = None
    direction: float = 0.0
    components: int = COMPONENTS
    spreading_exponent: float | None = None
    spreading_directions: int | None = None

    def __post_init__(self) -> None:
        found = Findings("WaveTrain", self)
        _check_train(self, found)
        found.raise_if_any()

    @property
    def directions(self) -> int:
        """Of a train that is spread."""
        return self.spreading_directions or DIRECTIONS


@dataclass(frozen=True)
class WaveState:
    """Waves of the sea: as one train, as several `trains`, or as recorded in an `elevation_file`.

    Attributes
    ----------
    spectrum, height, period, peak_enhancement, direction, components
        Of the one train, as `WaveTrain` has them; the direction also of a record.
    stretching : {"none", "wheeler"}
        How far up the motion of the water is taken to go.
    seed : int
        Run k draws from the generator seeded with (seed, k).
    spreading_exponent, spreading_directions
        Of the one train.
    trains : tuple of WaveTrain
        Which add up.
    elevation_file : str
        Path of a CSV file with the columns time and elevation; empty when not used.
    elevation_x : float
        Where it was recorded, along x from the anchor, m.
    shortest_period : float or None
        Of the record's waves that are kept, s; None: the fastest waves with 0.1 % of the variance
        are left out.
    """

    spectrum: WaveSpectrum | None = None
    height: float | None = None
    period: float | None = None
    peak_enhancement: float | None = None
    direction: float = 0.0
    components: int = COMPONENTS
    stretching: Stretching = "none"
    seed: int = 1
    spreading_exponent: float | None = None
    spreading_directions: int | None = None
    trains: tuple[WaveTrain, ...] = ()
    elevation_file: str = ""
    elevation_x: float = 0.0
    shortest_period: float | None = None

    def __post_init__(self) -> None:
        found = Findings("WaveState", self)
        given = {
            field.name: getattr(self, field.name)
            for field in fields(self)
            if field.default is MISSING or getattr(self, field.name) != field.default
        }
        found.problems += wave_misfits(given)
        _check_train(self, found, misfits=False)
        found.number("elevation_x", self.elevation_x, "m")
        found.numbers(self, "s", "shortest_period", above=0.0)
        found.word("stretching", self.stretching, STRETCHINGS)
        found.count("seed", self.seed)
        found.raise_if_any()

    @property
    def all_trains(self) -> tuple[WaveTrain, ...]:
        """The trains, or the one; none of a record."""
        if self.spectrum is None:
            return self.trains
        assert self.height is not None
        assert self.period is not None
        return (
            WaveTrain(
                self.spectrum, self.height, self.period, self.peak_enhancement, self.direction,
                self.components, self.spreading_exponent, self.spreading_directions,
            ),
        )  # fmt: skip

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
        wanted = f"exactly one of {', '.join(WAVE_WAYS)} is wanted"
        return [Problem("waves", " and ".join(ways) if ways else "none of them", wanted)]
    (way,) = ways
    problems = []
    for key, value in given.items():
        if key == way or key in _TAKES[way]:
            continue
        allowed = f"does not go with {way}; leave it out"
        if way == "trains" and key in _OF_A_TRAIN:
            allowed = "stands in each of the trains; leave it out here"
        problems.append(Problem(key, repr(value), allowed))
    if way != "spectrum":
        return problems
    problems += [
        Problem(key, "", "missing; spectrum needs it")
        for key in ("height", "period")
        if key not in given
    ]
    return problems + train_misfits(given)


def train_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List what does not go together in one train; `given` as for `wave_misfits`."""
    problems = []
    spectrum, count = given.get("spectrum"), given.get("components", COMPONENTS)
    if "peak_enhancement" in given and spectrum in WAVE_SPECTRA and spectrum != "jonswap":
        allowed = f"goes with jonswap, not with {spectrum}; leave it out"
        problems.append(Problem("peak_enhancement", repr(given["peak_enhancement"]), allowed))
    if "spreading_exponent" in given and spectrum == "regular":
        allowed = "a regular wave has one direction; leave it out"
        problems.append(Problem("spreading_exponent", repr(given["spreading_exponent"]), allowed))
    if "spreading_directions" in given and "spreading_exponent" not in given:
        allowed = "goes with spreading_exponent, which is missing"
        found = repr(given["spreading_directions"])
        return [*problems, Problem("spreading_directions", found, allowed)]
    directions = given.get("spreading_directions", DIRECTIONS)
    if "spreading_exponent" in given and count and directions and count % directions:
        allowed = (
            f"must be a multiple of the {directions} directions, so that each has the same energy"
        )
        problems.append(Problem("components", repr(count), allowed))
    return problems


def _check_train(train: WaveTrain | WaveState, found: Findings, *, misfits: bool = True) -> None:
    """Find what is out of range in a train."""
    if train.spectrum is not None:
        found.word("spectrum", train.spectrum, WAVE_SPECTRA)
    found.numbers(train, "m", "height", above=0.0)
    found.numbers(train, "s", "period", above=0.0)
    found.numbers(train, "", "spreading_exponent", above=0.0)
    found.numbers(train, "", "peak_enhancement", at_least=1.0, at_most=20.0)
    found.number("direction", train.direction, "rad")
    found.count("components", train.components)
    if train.spreading_directions is not None:
        found.count("spreading_directions", train.spreading_directions)
    if misfits and not found.problems:
        given = {f.name: getattr(train, f.name) for f in fields(train)}
        found.problems += train_misfits({k: v for k, v in given.items() if v is not None})
