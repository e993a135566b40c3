"""The waves of a case: a spectrum with its height and period, or one regular wave."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.model.validity import Findings

__all__ = ["STRETCHINGS", "WAVE_SPECTRA", "WaveState"]

WaveSpectrum = Literal["jonswap", "pierson-moskowitz", "regular"]
WAVE_SPECTRA: tuple[str, ...] = get_args(WaveSpectrum)
Stretching = Literal["none", "wheeler"]
STRETCHINGS: tuple[str, ...] = get_args(Stretching)


@dataclass(frozen=True)
class WaveState:
    """Waves from one direction.

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
    stretching : {"none", "wheeler"}
        How far up the motion of the water is taken to go.
    seed : int
        Run k draws from the generator seeded with (seed, k).
    """

    spectrum: WaveSpectrum
    height: float
    period: float
    peak_enhancement: float | None = None
    direction: float = 0.0
    components: int = 200
    stretching: Stretching = "none"
    seed: int = 1

    def __post_init__(self) -> None:
        found = Findings("WaveState")
        if self.spectrum not in WAVE_SPECTRA:
            found.add("spectrum", repr(self.spectrum), "one of " + ", ".join(WAVE_SPECTRA))
        found.number("height", self.height, "m", above=0.0)
        found.number("period", self.period, "s", above=0.0)
        if self.peak_enhancement is not None:
            found.number("peak_enhancement", self.peak_enhancement, "", at_least=1.0, at_most=20.0)
            if self.spectrum != "jonswap":
                allowed = f"goes with jonswap, not with {self.spectrum}; leave it out"
                found.add("peak_enhancement", repr(self.peak_enhancement), allowed)
        found.number("direction", self.direction, "rad")
        found.number("components", self.components, "", at_least=1)
        if self.stretching not in STRETCHINGS:
            found.add("stretching", repr(self.stretching), "one of " + ", ".join(STRETCHINGS))
        found.number("seed", self.seed, "", at_least=0)
        found.raise_if_any()
