"""A run in time, as a value: tensions, forces, places, and what the steps took."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from catopt.arrays import Array, Codes, Flags
from catopt.fem.energy_balance import EnergyBalance
from catopt.fem.extremes import FOLLOWED, Course, SeriesStatistics
from catopt.fem.simulation import Parted
from catopt.model.kinds import Duration, Time
from catopt.old_names import OldName
from catopt.records import FromZero

STOPPED = "motion.stopped_at"
"""Key of the warning of a run that was stopped."""


@dataclass(frozen=True, eq=False)
class History:
    """Lines in motion, sampled."""

    time: Array  # (samples,): s, from 0
    fairlead_force: Array  # (samples, lines, 3): of each line on what holds its end, N: nodal, half
    # a bar's weight and inertia included
    anchor_force: Array  # likewise
    bar_tension: Array  # (samples, lines, 2): of each line's first and last bar, N; 0 when slack
    fairlead: Array  # (samples, lines, 3): place of each line's end, m
    grounded_length: Array  # (samples, lines): unstretched, of the nodes on the bed, m
    nodes: Array  # (samples, chosen nodes, 3): places of the nodes asked for, m
    at_rest: Array  # (all nodes, 3): where they start, m; of each line from its anchor
    energy: Array  # (samples or 0, 4), when asked for: kinetic with added mass, and of strain,
    # weight and bed over the state at rest, J
    tension: Array  # (samples or 0, bars), when asked for, N
    first_bar: Codes  # (lines + 1,): first bar of each line
    arc: Array  # (bars,): unstretched arc length of the bars' middles from their anchor, m
    # From `since` on, at every step:
    max_tension: Array  # (bars,), N
    min_tension: Array
    slack_time: Array  # (bars,): s without tension in all
    longest_slack: Array  # and at a stretch
    courses: tuple[tuple[Course, ...], ...]  # of each line what `FOLLOWED` names, at every step
    bar_courses: tuple[Course, ...]  # of each bar's tension, when asked for, N
    slides: Array  # (lines, blocks, 3): of each block that was asked for, were it what holds the
    # anchor: way that it slides in all, m, sum of the squares of its slides, m2, and their count
    balance: EnergyBalance
    """J, from the first moment to the last: what was put in, where it is and who took it."""
    since: Duration
    """Where its statistics begin, s."""
    step: Time
    """As asked for, s."""
    shortest_step: Time
    """After halving, s."""
    steps: FromZero
    """Taken, halved ones as often."""
    iterations: FromZero
    """Of Newton's method, in all steps."""
    halvings: FromZero
    """Times that a step did not close and was halved."""
    refinements: FromZero
    """Times that a step was halved because a tension surprised."""
    unresolved: int  # steps as short as allowed in which one still did
    is_complete: bool
    """Whether it was not stopped from outside (Ctrl-C)."""
    warnings: tuple[str, ...]  # what about the run is to be doubted, with numbers
    parted: Parted | None = None  # the line that parted, where one was to, and did

    def of_line(self, line: int) -> History:
        """Return one line of it by itself; counts, energy and warnings stay those of all."""
        only, bars = slice(line, line + 1), self._bars(line)
        by_line = ("fairlead_force", "anchor_force", "bar_tension", "fairlead", "grounded_length")
        by_bar = ("arc", "max_tension", "min_tension", "slack_time", "longest_slack")
        return replace(
            self,
            first_bar=np.array([0, bars.stop - bars.start]),
            tension=self.tension[:, bars],
            at_rest=self.at_rest[bars.start + line : bars.stop + line + 1],
            **{key: getattr(self, key)[:, only] for key in by_line},
            **{key: getattr(self, key)[bars] for key in by_bar},
            courses=self.courses[only],
            slides=self.slides[only],
            bar_courses=self.bar_courses[bars],
        )

    def course(self, quantity: str, line: int = 0) -> Course:
        """Return what one of `FOLLOWED` does at every step from `since` on."""
        return self.courses[line][FOLLOWED.index(quantity)]

    @property
    def max_end_force(self) -> Array:
        """Largest size of the force at each anchor and fairlead of every step, N, (lines, 2)."""
        return np.array([[each[1].maximum, each[0].maximum] for each in self.courses])

    @property
    def time_of_max_end_force(self) -> Array:
        """When that was, s, shape (lines, 2)."""
        return np.array([[each[k].time_of_maximum for k in (1, 0)] for each in self.courses])

    @property
    def fairlead_tension(self) -> Array:
        """Size of the force at the fairlead, N, shape (samples, lines)."""
        return np.asarray(np.linalg.norm(self.fairlead_force, axis=2))

    @property
    def anchor_tension(self) -> Array:
        """Size of the force at the anchor, N, shape (samples, lines)."""
        return np.asarray(np.linalg.norm(self.anchor_force, axis=2))

    @property
    def offset(self) -> Array:
        """Horizontal distance of the fairlead from its place at rest, m, shape (samples, lines)."""
        away = self.fairlead[:, :, :2] - self.fairlead[0, :, :2]
        return np.asarray(np.linalg.norm(away, axis=2))

    @property
    def counted(self) -> Flags:
        """Which samples count in the statistics, shape (samples,)."""
        return self.time >= self.since - 1e-9 * self.step

    @property
    def counts(self) -> bool:
        """Whether two samples or more count, so that there are statistics."""
        return bool(self.counted.sum() > 1)

    def tension_statistics(self, line: int = 0) -> SeriesStatistics:
        """Statistics of the tension at a fairlead at every step from `since` on."""
        return self.course("fairlead_tension", line).statistics()

    def line_max_tension(self, line: int = 0) -> float:
        """Largest tension of any bar of a line from `since` on, N."""
        return float(self.max_tension[self._bars(line)].max())

    def line_slack_time(self, line: int = 0) -> float:
        """Time that a bar of a line was without tension from `since` on, in all, at most, s."""
        return float(self.slack_time[self._bars(line)].max())

    def line_longest_slack(self, line: int = 0) -> float:
        """Longest time at a stretch that a bar of a line was without tension from `since` on, s."""
        return float(self.longest_slack[self._bars(line)].max())

    amplification = OldName("dynamic_amplification")

    def dynamic_amplification(self, quasi_static_max: float, line: int = 0) -> float:
        """Largest tension at a fairlead over the largest at rest at the same places of it, N."""
        return self.tension_statistics(line).maximum / quasi_static_max

    def _bars(self, line: int) -> slice:
        return slice(int(self.first_bar[line]), int(self.first_bar[line + 1]))
