"""A run in time, as a value: tensions, forces, places, and what the steps took."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from catopt.fem.energy_balance import EnergyBalance
from catopt.fem.statistics import SeriesStatistics, series_statistics

STOPPED = "motion.stopped_at"
"""Key of the warning of a run that was stopped."""

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class History:
    """Lines in motion, sampled.

    Attributes
    ----------
    time : ndarray, shape (samples,)
        s, from 0.
    fairlead_force, anchor_force : ndarray, shape (samples, lines, 3)
        Force of each line on what holds its end, N: nodal, half a bar's weight and inertia
        included.
    bar_tension : ndarray, shape (samples, lines, 2)
        Of each line's first and last bar, N; 0 when slack.
    fairlead : ndarray, shape (samples, lines, 3)
        Place of each line's end, m.
    grounded_length : ndarray, shape (samples, lines)
        Unstretched length carried by the nodes on the bed, m.
    nodes : ndarray, shape (samples, chosen nodes, 3)
        Places of the nodes asked for, m.
    at_rest : ndarray, shape (all nodes, 3)
        Where they start, m; of each line from its anchor.
    energy : ndarray, shape (samples or 0, 4)
        When asked for: kinetic with added mass, and of strain, weight and bed over the state at
        rest, J.
    tension : ndarray, shape (samples or 0, bars)
        When asked for, of every bar, N.
    first_bar : ndarray of int, shape (lines + 1,)
        First bar of each line in the one before and the next four.
    arc : ndarray, shape (bars,)
        Unstretched arc length of the bars' middles from their anchor, m.
    max_tension, min_tension : ndarray, shape (bars,)
        From `since` on, at every step, N.
    slack_time, longest_slack : ndarray, shape (bars,)
        s without tension from `since` on: in all, and at a stretch.
    max_end_force, time_of_max_end_force : ndarray, shape (lines, 2)
        Largest size of the force at the anchor and at the fairlead from `since` on, at every step,
        N, and when it was reached, s.
    balance : EnergyBalance
        What was put in from the first moment on, and where it went.
    since : float
        Where statistics begin, s.
    step, shortest_step : float
        As asked for, and after halving, s.
    steps, iterations, halvings : int
        Steps taken, Newton iterations, and times that a step was halved because it did not close.
    refinements, unresolved : int
        Times that a step was halved because a tension surprised, and steps as short as allowed in
        which one still did.
    is_complete : bool
        False when the run was stopped from outside (Ctrl-C).
    warnings : tuple of str
        What about the run is to be doubted, with numbers.
    """

    time: Array
    fairlead_force: Array
    anchor_force: Array
    bar_tension: Array
    fairlead: Array
    grounded_length: Array
    nodes: Array
    at_rest: Array
    energy: Array
    tension: Array
    first_bar: npt.NDArray[np.int64]
    arc: Array
    max_tension: Array
    min_tension: Array
    slack_time: Array
    longest_slack: Array
    max_end_force: Array
    time_of_max_end_force: Array
    balance: EnergyBalance
    since: float
    step: float
    shortest_step: float
    steps: int
    iterations: int
    halvings: int
    refinements: int
    unresolved: int
    is_complete: bool
    warnings: tuple[str, ...]

    def of_line(self, line: int) -> History:
        """Return one line of it by itself; counts, energy and warnings stay those of all."""
        only, bars = slice(line, line + 1), self._bars(line)
        by_line = ("fairlead_force", "anchor_force", "bar_tension", "fairlead", "grounded_length")
        by_bar = ("arc", "max_tension", "min_tension", "slack_time", "longest_slack")
        ends = ("max_end_force", "time_of_max_end_force")
        return replace(
            self,
            first_bar=np.array([0, bars.stop - bars.start]),
            tension=self.tension[:, bars],
            at_rest=self.at_rest[bars.start + line : bars.stop + line + 1],
            **{key: getattr(self, key)[:, only] for key in by_line},
            **{key: getattr(self, key)[bars] for key in by_bar},
            **{key: getattr(self, key)[only] for key in ends},
        )

    @property
    def fairlead_tension(self) -> Array:
        """Size of the force at the fairlead, N, shape (samples, lines)."""
        size: Array = np.linalg.norm(self.fairlead_force, axis=2)
        return size

    @property
    def anchor_tension(self) -> Array:
        """Size of the force at the anchor, N, shape (samples, lines)."""
        size: Array = np.linalg.norm(self.anchor_force, axis=2)
        return size

    @property
    def offset(self) -> Array:
        """Horizontal distance of the fairlead from its place at rest, m, shape (samples, lines)."""
        away = self.fairlead[:, :, :2] - self.fairlead[0, :, :2]
        size: Array = np.linalg.norm(away, axis=2)
        return size

    @property
    def counted(self) -> npt.NDArray[np.bool_]:
        """Which samples count in the statistics, shape (samples,)."""
        return self.time >= self.since - 1e-9 * self.step

    def tension_statistics(self, line: int = 0) -> SeriesStatistics:
        """Statistics of the tension at a fairlead from `since` on."""
        at = self.counted
        return series_statistics(self.time[at], self.fairlead_tension[at, line])

    def line_max_tension(self, line: int = 0) -> float:
        """Largest tension of any bar of a line from `since` on, N."""
        return float(self.max_tension[self._bars(line)].max())

    def line_slack_time(self, line: int = 0) -> float:
        """Time that a bar of a line was without tension from `since` on, in all, at most, s."""
        return float(self.slack_time[self._bars(line)].max())

    def line_longest_slack(self, line: int = 0) -> float:
        """Longest time at a stretch that a bar of a line was without tension from `since` on, s."""
        return float(self.longest_slack[self._bars(line)].max())

    def amplification(self, quasi_static_max: float, line: int = 0) -> float:
        """Largest tension at a fairlead over the largest at rest at the same places of it, N."""
        return self.tension_statistics(line).maximum / quasi_static_max

    def _bars(self, line: int) -> slice:
        return slice(int(self.first_bar[line]), int(self.first_bar[line + 1]))
