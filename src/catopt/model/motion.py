"""How the fairlead moves: harmonically, as recorded, or as a ship that answers to the waves."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.model.validity import Findings

__all__ = ["MOTION_WAYS", "Motion"]

MOTION_WAYS = ("period", "file", "rao_file")
"""The keys of which one is given."""

_HARMONIC = ("surge", "sway", "heave", "surge_phase", "sway_phase", "heave_phase")


@dataclass(frozen=True)
class Motion:
    """Motion of the fairlead about its place at rest, in one of three ways.

    Attributes
    ----------
    period : float or None
        Of a harmonic motion a cos(2 pi t/T + phase), s.
    surge, sway, heave : float
        Its amplitudes along x (from the anchor to the fairlead), y and z, m.
    surge_phase, sway_phase, heave_phase : float
        rad.
    file : str
        Path of a CSV file with the columns t (s), x, y, z (m); empty when not used.
    rao_file : str
        Path of a CSV file of the fairlead's response to a wave of 1 m, by period; empty when not
        used. It goes with waves.
    """

    period: float | None = None
    surge: float = 0.0
    sway: float = 0.0
    heave: float = 0.0
    surge_phase: float = 0.0
    sway_phase: float = 0.0
    heave_phase: float = 0.0
    file: str = ""
    rao_file: str = ""

    def __post_init__(self) -> None:
        found = Findings("Motion")
        given = [key for key in MOTION_WAYS if getattr(self, key) not in (None, "")]
        if len(given) != 1:
            wanted = f"exactly one of {', '.join(MOTION_WAYS)} is wanted"
            found.add("motion", " and ".join(given) if given else "none of them", wanted)
        if self.period is not None:
            found.number("period", self.period, "s", above=0.0)
        for key in ("surge", "sway", "heave"):
            found.number(key, getattr(self, key), "m", at_least=0.0)
        for key in ("surge_phase", "sway_phase", "heave_phase"):
            found.number(key, getattr(self, key), "rad")
        if given in (["file"], ["rao_file"]):
            for key in (k for k in _HARMONIC if getattr(self, k) != 0.0):
                allowed = f"goes with period, not with {given[0]}; leave it out"
                found.add(key, repr(getattr(self, key)), allowed)
        found.raise_if_any()
