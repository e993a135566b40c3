"""What a run in time will take, before it begins."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.errors import InputError, Problem
from catopt.verify.dynamic_lines import LinesAtRest
from catopt.verify.proof import Proof, work_of_proof

SECONDS_PER_BAR_AND_STEP = 6e-6
"""On one core: 4 million bars times steps take 15 to 30 s."""

BYTES_PER_SAMPLE = 160.0
"""Of one line: time, forces and tensions at both ends, the fairlead's place and what lies down."""

MOST_SECONDS, MOST_BYTES = 30.0 * 86400.0, 8e9


@dataclass(frozen=True)
class Effort:
    """Time and memory of a load case.

    `steps`, `bars`, `runs`: of one run, of all lines together, and how many runs; `proof`: how
    often the work of a run its proof takes at most: where a line goes slack; `samples`: that are
    kept of each line in each run.
    """

    steps: float
    bars: int
    runs: int
    proof: int
    samples: float
    lines: int

    @property
    def work(self) -> float:
        """Bars times steps of all runs, with the most that proves them."""
        return self.steps * self.bars * self.runs * (1 + self.proof)

    @property
    def seconds(self) -> float:
        """Roughly, on one core."""
        return self.work * SECONDS_PER_BAR_AND_STEP

    @property
    def bytes(self) -> float:
        """Of the samples."""
        return self.samples * self.lines * self.runs * BYTES_PER_SAMPLE

    def __str__(self) -> str:
        time = self.seconds / 60.0
        words = f"{time:.0f} min" if time < 120.0 else f"{time / 60.0:.0f} h"
        if time > 100.0 * 60.0:
            words = f"{time / 1440.0:,.0f} days"
        often = f"{self.runs} time{'s' if self.runs > 1 else ''}"
        proof = f" and up to {self.proof} times that for the proof" if self.proof else ""
        return (
            f"{self.steps:,.0f} steps of {self.bars} bars, {often}{proof}: some {words} on one "
            f"core, {self.bytes / 1e9:.2g} GB for the samples"
        )

    def check(self, duration: float) -> None:
        """Refuse what would not end or not fit.

        Raises InputError by the keys of ``[dynamics]`` that it hangs on.
        """
        problems = []
        if self.seconds > MOST_SECONDS:
            allowed = (
                f"{self}; {MOST_SECONDS / 86400.0:.0f} days are the most: a shorter duration, a "
                "longer time_step, fewer elements or runs"
            )
            problems.append(Problem("dynamics.duration", f"{duration:g} s", allowed))
        if self.bytes > MOST_BYTES:
            allowed = f"{self}; {MOST_BYTES / 1e9:g} GB are the most: keep fewer samples"
            problems.append(Problem("dynamics.output_interval", "", allowed))
        if problems:
            raise InputError(problems)


def effort_of(lines: LinesAtRest, proof: Proof) -> Effort:
    """Estimate what the runs of a load case take, with those that prove them."""
    drive = lines.drive
    dynamics, sea = drive.dynamics, drive.sea(0)
    stepping = drive.stepping(sea, lines.driven_by(sea))
    return Effort(
        steps=dynamics.duration / stepping.step,
        bars=dynamics.bars * len(lines.legs),
        runs=dynamics.runs,
        proof=work_of_proof(proof),
        samples=dynamics.duration / (stepping.output_interval or stepping.step),
        lines=len(lines.legs),
    )
