"""How a fairlead or a body moves: harmonically, as recorded, or as a ship answers to waves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.model.validity import Findings

RaoPhase = Literal["", "lag", "lead"]
RaoRotation = Literal["", "deg/m", "rad/m"]
RaoPer = Literal["", "amplitude", "height"]
RAO_PHASES, RAO_ROTATIONS, RAO_PER = (
    tuple(each for each in get_args(of) if each) for of in (RaoPhase, RaoRotation, RaoPer)
)
RAO_CONVENTIONS = ("rao_phase", "rao_reference", "rao_rotation", "rao_per")
"""What the RAOs of a body do not say themselves: no default would be right for all of them."""
OF_A_BODY = (*RAO_CONVENTIONS, "rao_crest", "drift", "drift_file")
"""The keys that are of a body with several lines alone."""

MOTION_WAYS = ("period", "file", "rao_file")
"""The keys of which one is given."""

HARMONIC = ("surge", "sway", "heave", "surge_phase", "sway_phase", "heave_phase")
"""The keys that go with a period."""


@dataclass(frozen=True)
class Motion:
    """Motion of the fairlead about its place at rest, in one of three ways; of a body, its origin.

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
        used. It goes with waves. Of a body: of its six degrees of freedom, by heading and period.
    rao_phase : {"", "lag", "lead"}
        Of a body's RAOs: whether a phase is how far the motion comes after the crest over the
        reference point, or before it.
    rao_reference : tuple of float
        Of a body's RAOs: the point that they are of, along the body's x and y from its origin, and
        its height above the seabed at rest, m; empty when not used.
    rao_rotation : {"", "deg/m", "rad/m"}
        Of a body's RAOs: unit of roll, pitch and yaw.
    rao_per : {"", "amplitude", "height"}
        Of a body's RAOs: whether they are to 1 m of the waves' amplitude or of their height.
    rao_crest : tuple of float
        Of a body's RAOs: the point over which the crest is where their phases count from, along
        the body's x and y from its origin, m; empty for the reference point.
    drift : tuple of float
        Of a body: how far along x and y it has drifted from where its mean force holds it, m;
        empty for not at all.
    drift_file : str
        Of a body: path of a CSV file with the slow drift over time; empty when not used.
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
    rao_phase: RaoPhase = ""
    rao_reference: tuple[float, ...] = ()
    rao_rotation: RaoRotation = ""
    rao_per: RaoPer = ""
    rao_crest: tuple[float, ...] = ()
    drift: tuple[float, ...] = ()
    drift_file: str = ""

    @property
    def of_a_body(self) -> list[str]:
        """Which of the keys for a body are given."""
        return [key for key in OF_A_BODY if getattr(self, key)]

    def __post_init__(self) -> None:
        found = Findings("Motion", self)
        given = [key for key in MOTION_WAYS if getattr(self, key) not in (None, "")]
        if len(given) != 1:
            wanted = f"exactly one of {', '.join(MOTION_WAYS)} is wanted"
            found.add("motion", " and ".join(given) if given else "none of them", wanted)
        found.numbers(self, "s", "period", above=0.0)
        for key in ("surge", "sway", "heave"):
            found.number(key, getattr(self, key), "m", at_least=0.0)
        for key in ("surge_phase", "sway_phase", "heave_phase"):
            found.number(key, getattr(self, key), "rad")
        self._check_of_a_body(found)
        if given in (["file"], ["rao_file"]):
            for key in (k for k in HARMONIC if getattr(self, k) != 0.0):
                allowed = f"goes with period, not with {given[0]}; leave it out"
                found.add(key, repr(getattr(self, key)), allowed)
        found.raise_if_any()

    def _check_of_a_body(self, found: Findings) -> None:
        for key, names in (
            ("rao_phase", RAO_PHASES), ("rao_rotation", RAO_ROTATIONS), ("rao_per", RAO_PER),
        ):  # fmt: skip
            if getattr(self, key) not in ("", *names):
                found.add(key, repr(getattr(self, key)), "one of " + ", ".join(names))
        for key, size in (("rao_reference", 3), ("rao_crest", 2), ("drift", 2)):
            values = getattr(self, key)
            object.__setattr__(self, key, tuple(values))
            if len(values) not in {0, size}:
                found.add(key, f"{len(values)} numbers", f"{size} are wanted")
            for value in values:
                found.number(key, value, "m")
