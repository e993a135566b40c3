"""How a line is run in time, and with which step."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from catopt.fem.newmark import Scheme
from catopt.fem.sampling import Rules
from catopt.model.kinds import Findings
from catopt.waves import Sea, breaking_warning, repetition_warning
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
    # water, N, friction, and what the soil holds at most, N (infinite: friction alone) of each
    blocks: tuple[tuple[float, float, float, float], ...] = ()

    def __post_init__(self) -> None:
        found = Findings("TimeStepping")
        found.number("duration", self.duration, "s", above=0.0)
        found.number("step", self.step, "s", above=0.0)
        found.number("ramp_time", self.ramp_time, "s", at_least=0.0)
        found.numbers(self, "s", "since", at_least=0.0)
        found.numbers(self, "s", "output_interval", above=0.0)
        found.raise_if_any()
        if self.step > self.duration:
            allowed = Message("refused_motion.longer_than_run_s", duration=self.duration)
            found.add("step", f"{self.step:g} s", allowed)
        if (self.since or 0.0) >= self.duration:
            allowed = Message("refused_motion.run_ends_at_s", duration=self.duration)
            found.add("since", f"{self.since:g} s", allowed)
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

    def rules(self, rounding: float = 0.0) -> Rules:
        """Return them as the kernels take them; their tolerance is no less than the rounding."""
        how, ways = self.scheme, self.controls
        return Rules(
            alpha_m=float(how.alpha_m),
            alpha_f=float(how.alpha_f),
            beta=float(how.beta),
            gamma=float(how.gamma),
            step=float(self.step),
            every=self.every,
            limit=int(ways.max_iterations),
            halvings=int(ways.max_halvings),
            refinements=int(ways.max_refinements),
            surprise=float(ways.surprise),
            transits=float(ways.transits),
            tolerance=float(max(ways.tolerance, rounding)),
            since=float(self.counted_since),
            until=float(self.duration),
        )


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


_FEWEST: Final = 4.0
"""Steps in a period below which nothing is left of it."""
_WANTED: Final = 20.0
"""Steps in a period: average acceleration then lengthens it by 0.8 %, (omega h)^2/12."""
_FEWEST_SAMPLES: Final = 4.0
"""Samples in a period below which a cubic spline makes its own acceleration of it."""
_FASTEST_PART: Final = 0.01
"""Part of the waves' energy that may be faster than what the steps are compared with."""


def step_warnings(
    step: float, duration: float, periods: dict[str, float], sea: Sea | None
) -> list[str]:
    """Words about a step too long for what drives the run, and about its waves.

    `step`, `duration`: s; `periods`: what drives the run, with its shortest period, s. Raises
    InputError when a period has fewer than four steps.
    """
    driven = dict(periods)
    warnings = []
    if sea is not None and sea.waves is not None:
        driven[Message("motion.wave_energy")] = _shortest_period(sea)
        about = (breaking_warning(sea), repetition_warning(sea.waves, duration))
        warnings += [words for words in about if words is not None]
    found = Findings("TimeStepping")
    for name, period in driven.items():
        if step > period / _FEWEST:
            values = {"name": name, "period": period, "period2": period / _WANTED}
            found.add(
                "step", f"{step:g} s", Message("refused_motion.has_periods_down_s_s", **values)
            )
        elif step > period / _WANTED * (1.0 + 1e-9):
            values = {"step": step, "count": period / step, "what": name, "period": period}
            warnings.append(Message("motion.long_step", **values, wanted=_WANTED))
    found.raise_if_any()
    return warnings


def record_warnings(period: float, step: float) -> list[str]:
    """Words about a record whose samples do not resolve its own acceleration.

    `period`: that 99 % of its acceleration's variance exceeds, s; `step`: from sample to sample, s.
    """
    if period >= _FEWEST_SAMPLES * step * (1.0 - 1e-9):
        return []
    return [Message("motion.noisy_record", period=_FEWEST_SAMPLES * step, step=step)]


def _shortest_period(sea: Sea) -> float:
    """Return the period that 99 % of the waves' energy exceeds, s."""
    assert sea.waves is not None
    order = np.argsort(sea.waves.omega)[::-1]
    energy = np.cumsum(sea.waves.amplitude[order] ** 2)
    at = int(np.searchsorted(energy, _FASTEST_PART * energy[-1]))
    return float(2.0 * np.pi / sea.waves.omega[order[min(at, order.size - 1)]])
