"""What a run in time is given beside lines, motion and sea."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from catopt.fem.newmark import Scheme
from catopt.model.kinds import Findings
from catopt.words import Message


@dataclass(frozen=True)
class StepControls:
    """When a step is closed, and what is done when it does not close."""

    tolerance: float = 1e-6  # largest force left over at a node, over the largest tension or what a
    # line weighs
    max_iterations: int = 30  # of Newton's method before a step is halved
    max_halvings: int = 10  # times that a step may be halved before the run stops
    surprise: float = 0.05  # difference of a bar's tension from what it was heading for in the last
    # step beyond which a step is halved, over the largest tension of the run so far or what a line
    # weighs
    transits: float = 2.0  # longest step in which a bar goes taut, and until the wave of that has
    # passed, over the time in which a wave along the line passes that bar
    max_refinements: int = 16  # times that it may be halved for either; then it is taken as it is
    max_ringing: float = 0.2  # part of the strain energy, over time, that such differences may
    # hold; beyond it the run stops: what it shows is ringing that its steps do not resolve

    def __post_init__(self) -> None:
        found = Findings("StepControls")
        found.number("tolerance", self.tolerance, "", above=0.0)
        found.number("max_iterations", self.max_iterations, "", at_least=1.0)
        found.number("max_halvings", self.max_halvings, "", at_least=0.0)
        found.number("surprise", self.surprise, "", above=0.0)
        found.number("transits", self.transits, "", above=0.0)
        found.number("max_refinements", self.max_refinements, "", at_least=0.0)
        found.number("max_ringing", self.max_ringing, "", at_least=0.0, infinite=True)
        found.raise_if_any()


@dataclass(frozen=True)
class TimeStepping:
    """How long, in which steps, and what is kept."""

    duration: float  # s
    step: float  # s
    ramp_time: float = 0.0  # s over which motion, force and waves grow as (1 - cos(pi t/T))/2
    output_interval: float | None = None  # from sample to sample, s, a multiple of the step; None:
    # every step
    since: float | None = None  # where statistics begin, s; None: after the ramp
    # Generalised-alpha with the spectral radius 0.5; S4's is `Scheme.average_acceleration()`:
    scheme: Scheme = field(default_factory=Scheme.generalised_alpha)
    controls: StepControls = field(default_factory=StepControls)
    nodes: tuple[int, ...] = ()  # counted over all lines, whose places are kept
    energy: bool = False  # whether energies are kept
    tensions: bool = False  # whether the tension of every bar is
    # Blocks on the bed whose slides are found, were they what holds an anchor: mass, kg, weight in
    # water, N, and friction of each
    blocks: tuple[tuple[float, float, float], ...] = ()

    def __post_init__(self) -> None:
        found = Findings("TimeStepping")
        found.number("duration", self.duration, "s", above=0.0)
        found.number("step", self.step, "s", above=0.0)
        found.number("ramp_time", self.ramp_time, "s", at_least=0.0)
        found.numbers(self, "s", "since", at_least=0.0)
        found.numbers(self, "s", "output_interval", above=0.0)
        found.raise_if_any()
        if self.step > self.duration:
            found.add(
                "step",
                f"{self.step:g} s",
                Message("refused_motion.longer_than_run_s", duration=self.duration),
            )
        if (self.since or 0.0) >= self.duration:
            found.add(
                "since",
                f"{self.since:g} s",
                Message("refused_motion.run_ends_at_s", duration=self.duration),
            )
        ratio = (self.output_interval or self.step) / self.step
        if abs(ratio - round(ratio)) > 1e-6 * ratio or round(ratio) < 1:
            wanted = Message("refused_motion.multiple_step_s", step=self.step)
            found.add("output_interval", f"{self.output_interval:g} s", wanted)
        found.raise_if_any()

    @property
    def counted_since(self) -> float:
        """When statistics begin, s."""
        return self.ramp_time if self.since is None else self.since

    @property
    def every(self) -> int:
        """Steps from sample to sample."""
        return round((self.output_interval or self.step) / self.step)

    @property
    def samples(self) -> int:
        """Samples after the first."""
        return math.ceil(self.duration / (self.every * self.step) - 1e-9)


@dataclass(frozen=True)
class BodyInertia:
    """A body without rotation, which moves in x and y and is held in height."""

    mass: float = 0.0  # with its added mass, kg; 0: that of the lines' ends alone
    damping: float = 0.0  # linear, N s/m

    def __post_init__(self) -> None:
        found = Findings("BodyInertia")
        found.number("mass", self.mass, "kg", at_least=0.0)
        found.number("damping", self.damping, "N s/m", at_least=0.0)
        found.raise_if_any()
