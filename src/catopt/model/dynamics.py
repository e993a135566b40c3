"""How a line is run in time, and what of a case goes with that."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Final, Literal, get_args

from catopt.errors import Problem
from catopt.model.validity import Findings

__all__ = ["LINE_DAMPING", "TIME_SCHEMES", "Dynamics", "dynamics_misfits"]

TimeScheme = Literal["newmark", "generalised-alpha"]
TIME_SCHEMES: tuple[str, ...] = get_args(TimeScheme)

LINE_DAMPING: Final = 1.0
"""Part of critical: bars as short as the mesh's own waves are not to swing. MoorDyn's manual
(Troubleshooting) recommends "approaching the critical value"; benchmarks/results/slack.md shows
where the largest tension of a line that snaps stops to depend on it."""


@dataclass(frozen=True)
class Dynamics:
    """Settings of ``catopt verify --dynamic``.

    Attributes
    ----------
    duration : float
        Of one run, the ramp included, s.
    ramp : float or None
        Over which motion and waves grow from nothing, s; statistics begin after it. None: a tenth
        of the duration.
    time_step : float or None
        s; None: a sixtieth of the shortest period that drives the line.
    output_interval : float or None
        From sample to sample, s, taken as the nearest whole number of steps; None: every step, and
        at most 20 000 samples.
    elements : int
        Bars of the line.
    scheme : {"newmark", "generalised-alpha"}
        Newmark's average acceleration, or with damping of what is much faster than the step.
    spectral_radius : float
        Of generalised-alpha: what is left of such vibrations after a step.
    runs : int
        Runs that differ in their seed.
    seabed_stiffness : float or None
        Force per length of line and depth, N/m2; None: the line's weight presses it 1 cm deep.
    seabed_damping : float or None
        Force per length of line and speed, N s/m2; None: critical.
    line_damping : float or None
        Of the line itself: axial, as a part of what is critical for each bar, l0 sqrt(EA m). None:
        `LINE_DAMPING`, and nothing beside a `damping_time` that is given.
    damping_time : float
        Of the line itself: axial force per rate of strain, over EA, s. Both are added up.
    """

    duration: float
    ramp: float | None = None
    time_step: float | None = None
    output_interval: float | None = None
    elements: int = 100
    scheme: TimeScheme = "generalised-alpha"
    spectral_radius: float = 0.5
    runs: int = 1
    seabed_stiffness: float | None = None
    seabed_damping: float | None = None
    line_damping: float | None = None
    damping_time: float = 0.0

    def __post_init__(self) -> None:
        found = Findings("Dynamics")
        found.number("duration", self.duration, "s", above=0.0)
        if self.ramp is not None:
            found.number("ramp", self.ramp, "s", at_least=0.0)
        for key in ("time_step", "output_interval"):
            if getattr(self, key) is not None:
                found.number(key, getattr(self, key), "s", above=0.0)
        found.number("elements", self.elements, "", at_least=4)
        if self.scheme not in TIME_SCHEMES:
            found.add("scheme", repr(self.scheme), "one of " + ", ".join(TIME_SCHEMES))
        found.number("spectral_radius", self.spectral_radius, "", at_least=0.0, at_most=1.0)
        found.number("runs", self.runs, "", at_least=1)
        if self.seabed_stiffness is not None:
            found.number("seabed_stiffness", self.seabed_stiffness, "N/m2", above=0.0)
        if self.seabed_damping is not None:
            found.number("seabed_damping", self.seabed_damping, "N s/m2", at_least=0.0)
        found.number("line_damping", self.line_damping or 0.0, "", at_least=0.0)
        found.number("damping_time", self.damping_time, "s", at_least=0.0)
        if not found.problems:
            for key in ("ramp", "time_step", "output_interval"):
                value = getattr(self, key)
                if value is not None and not value < self.duration:
                    allowed = f"must be below {self.duration:g} s, the duration"
                    found.add(key, f"{value:g} s", allowed)
        found.raise_if_any()

    @property
    def critical_ratio(self) -> float:
        """Part of each bar's critical damping that the line is run with."""
        if self.line_damping is not None:
            return self.line_damping
        return 0.0 if self.damping_time > 0.0 else LINE_DAMPING


def dynamics_misfits(present: Collection[str], *, has_raos: bool = False) -> list[Problem]:
    """List what does not go together of the parts that are for a line in motion.

    Parameters
    ----------
    present : collection of str
        Which of waves, current, motion, dynamics and system a case has.
    has_raos : bool
        Whether the motion is by RAOs.
    """
    problems = []
    if "dynamics" not in present:
        problems += [
            Problem(key, "", "goes with [dynamics], which is missing: nothing else reads it")
            for key in ("waves", "current", "motion")
            if key in present
        ]
    elif "motion" not in present and "waves" not in present:
        problems.append(Problem("dynamics", "", "nothing moves: [motion] or [waves] is missing"))
    if "dynamics" in present and "system" in present:
        allowed = "does not go with [system]: one line is run, under a [load] or [[load_cases]]"
        problems.append(Problem("dynamics", "", allowed))
    if has_raos and "waves" not in present:
        allowed = "a ship's response needs [waves], which is missing"
        problems.append(Problem("motion.rao_file", "", allowed))
    return problems
