"""How a line is run in time, and what of a case goes with that."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Final, Literal, get_args

from catopt.errors import Problem
from catopt.model.motion import OF_A_BODY, RAO_CONVENTIONS
from catopt.model.validity import Findings

BrokenEnd = Literal["fairlead", "anchor"]
BROKEN_ENDS: tuple[str, ...] = get_args(BrokenEnd)

TimeScheme = Literal["newmark", "generalised-alpha"]
TIME_SCHEMES: tuple[str, ...] = get_args(TimeScheme)

InitialFriction = Literal["pulled", "none", "laid"]
INITIAL_FRICTION: tuple[str, ...] = get_args(InitialFriction)

BARS: Final = 100
"""Bars of a line unless said; damping is a part of what is critical for the line's hundredth."""

LINE_DAMPING: Final = 1.0
"""Part of critical: the bars of the default mesh do not swing. MoorDyn's manual (Troubleshooting)
recommends "approaching the critical value"; benchmarks/results/slack.md shows what the largest
tension of a line that snaps hangs on it."""


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
    elements : int or None
        Bars of the line. None: `BARS`, and twice as many where the line goes slack and its maxima
        change too much with twice the bars.
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
        Of the line itself: axial, as a part of what is critical for a bar of a hundredth of the
        line, L/100 sqrt(EA m), however many bars there are. None: `LINE_DAMPING`, and nothing
        beside a `damping_time` that is given.
    damping_time : float
        Of the line itself: axial force per rate of strain, over EA, s. Both are added up.
    broken_line : int or None
        The line, from 1, that breaks.
    broken_at : float or None
        When it does, s.
    broken_end : {"fairlead", "anchor"}
        Where: at its fairlead, of a body that moves under forces; or at its anchor, so that its
        lower end is free.
    initial_friction : {"pulled", "none", "laid"}
        The bed's at rest: of a line last pulled towards the fairlead (as at rest everywhere else),
        none, or of one laid under a greater tension and slackened since.
    duration_of_interest : float
        Of the storm for which extremes of a random sea are given, s.
    """

    duration: float
    ramp: float | None = None
    time_step: float | None = None
    output_interval: float | None = None
    elements: int | None = None
    scheme: TimeScheme = "generalised-alpha"
    spectral_radius: float = 0.5
    runs: int = 1
    seabed_stiffness: float | None = None
    seabed_damping: float | None = None
    line_damping: float | None = None
    damping_time: float = 0.0
    broken_line: int | None = None
    broken_at: float | None = None
    broken_end: BrokenEnd = "fairlead"
    initial_friction: InitialFriction = "pulled"
    duration_of_interest: float = 10800.0

    def __post_init__(self) -> None:
        found = Findings("Dynamics", self)
        found.number("duration", self.duration, "s", above=0.0)
        found.numbers(self, "s", "ramp", at_least=0.0)
        found.numbers(self, "s", "time_step", "output_interval", above=0.0)
        found.count("elements", self.bars)
        found.word("scheme", self.scheme, TIME_SCHEMES)
        found.word("initial_friction", self.initial_friction, INITIAL_FRICTION)
        found.word("broken_end", self.broken_end, BROKEN_ENDS)
        found.number("spectral_radius", self.spectral_radius, "", at_least=0.0, at_most=1.0)
        found.count("runs", self.runs)
        found.numbers(self, "N/m2", "seabed_stiffness", above=0.0)
        found.numbers(self, "N s/m2", "seabed_damping", at_least=0.0)
        found.number("line_damping", self.line_damping or 0.0, "", at_least=0.0)
        found.number("damping_time", self.damping_time, "s", at_least=0.0)
        self._check_break(found)
        found.number("duration_of_interest", self.duration_of_interest, "s", above=0.0)
        if not found.problems:
            self._check_times(found)
        found.raise_if_any()

    def _check_times(self, found: Findings) -> None:
        """Find times that do not fit into a run."""
        for key in ("ramp", "broken_at", "time_step", "output_interval"):
            value = getattr(self, key)
            if value is not None and not value < self.duration:
                allowed = f"must be below {self.duration:g} s, the duration"
                found.add(key, f"{value:g} s", allowed)

    def _check_break(self, found: Findings) -> None:
        if self.broken_line is not None:
            found.count("broken_line", self.broken_line)
        found.numbers(self, "s", "broken_at", above=0.0)
        if (self.broken_line is None) != (self.broken_at is None):
            missing = "broken_at" if self.broken_at is None else "broken_line"
            found.add(missing, "", "missing; broken_line and broken_at go together")
        elif self.broken_line is None and self.broken_end != "fairlead":
            found.add("broken_line", "", "missing; broken_end needs it, and broken_at")

    @property
    def bars(self) -> int:
        """Bars with which the line is run first."""
        return BARS if self.elements is None else self.elements

    @property
    def critical_ratio(self) -> float:
        """Part of critical damping, of a hundredth of the line, that the line is run with."""
        if self.line_damping is not None:
            return self.line_damping
        return 0.0 if self.damping_time > 0.0 else LINE_DAMPING


def dynamics_misfits(present: Collection[str], given: Collection[str] = ()) -> list[Problem]:
    """List what does not go together of the parts that are for lines in motion.

    Present are some of waves, current, motion, anchor_motion, body, dynamics and system; given some
    keys of motion and body, such as ``"motion.rao_file"``, with ``"dynamics.broken_end"`` for a
    break at the anchor.
    """
    problems = []
    if "dynamics" not in present:
        problems += [
            Problem(key, "", "goes with [dynamics], which is missing: nothing else reads it")
            for key in ("waves", "current", "motion", "anchor_motion", "body")
            if key in present
        ]
    elif "system" in present:
        problems += _of_a_body(present, given)
    elif not {"motion", "waves", "anchor_motion"} & set(present):
        problems.append(Problem("dynamics", "", "nothing moves: [motion] or [waves] is missing"))
    if "dynamics.broken_line" in given and not (
        {"system", "body"} <= set(present) or "dynamics.broken_end" in given
    ):
        allowed = (
            "goes with [system] and [body]: a body that is led feels nothing of it; a line that "
            'is lost at its anchor has broken_end = "anchor"'
        )
        problems.append(Problem("dynamics.broken_line", "", allowed))
    if "system" not in present:
        if "body" in present:
            problems.append(Problem("body", "", "goes with [system], which is missing"))
        problems += [
            Problem(f"motion.{key}", "", "goes with [system], which is missing")
            for key in OF_A_BODY
            if f"motion.{key}" in given
        ]
    if "waves" not in present:
        for key, what in (
            ("motion.rao_file", "a ship's response"),
            ("body.wave_force", "a force of the waves"),
        ):
            if key in given:
                problems.append(Problem(key, "", f"{what} needs [waves], which is missing"))
    return problems


def _of_a_body(present: Collection[str], given: Collection[str]) -> Iterator[Problem]:
    """Yield what does not go together in how a body with several lines moves."""
    if "anchor_motion" in present:
        yield Problem("anchor_motion", "", "does not go with [system]: of one line alone")
    if "motion" in present and "body" in present:
        allowed = "does not go with [motion]: a body is led, or moves under the forces on it"
        yield Problem("body", "", allowed)
    elif "motion" not in present and "body" not in present:
        allowed = "a moored body in motion needs [motion], which leads it, or [body]"
        yield Problem("dynamics", "", allowed)
    elif "body" in present and "waves" not in present and "body.force_file" not in given:
        yield Problem("body", "", "nothing moves: force_file or [waves] is missing")
    if "motion.drift_file" in given and "motion.file" in given:
        allowed = "does not go with file: add the drift to the motion there"
        yield Problem("motion.drift_file", "", allowed)
    has_raos = "motion.rao_file" in given
    for key in RAO_CONVENTIONS:
        if has_raos and f"motion.{key}" not in given:
            allowed = "missing; the RAOs of a body mean nothing without it (docs/verify.md)"
            yield Problem(f"motion.{key}", "", allowed)
    for key in (*RAO_CONVENTIONS, "rao_crest"):
        if f"motion.{key}" in given and not has_raos:
            yield Problem(f"motion.{key}", "", "goes with rao_file, which is missing")
