"""How a fairlead or a body moves: harmonically, as recorded, or as a ship answers to waves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from catopt.model.kinds import Angle, File, Height, Place, Size, Time
from catopt.model.validity import Checked, Findings
from catopt.words import Message

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
            found.add(
                "motion",
                " and ".join(given) if given else Message("refused_file.none_of_them"),
                wanted,
            )
        found.check("period", *HARMONIC, "rao_phase", "rao_rotation", "rao_per")
        found.check("rao_reference", "rao_crest", "drift")
        if given in (["file"], ["rao_file"]):
            for key in (k for k in HARMONIC if getattr(self, k) != 0.0):
                allowed = Message("refused.with_not_with", way="period", other=given[0])
                found.add(key, repr(getattr(self, key)), allowed)
