"""What a run in time will take, before it begins."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.errors import InputError, Problem
from catopt.verify.dynamic_lines import LinesAtRest
from catopt.verify.proof import Proof, work_of_proof
from catopt.words import Message

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
        return self.words

    @property
    def words(self) -> Message:
        """What is to be run, how long it takes and what it keeps."""
        minutes = self.seconds / 60.0
        key, divisor = ("in_minutes", 1.0) if minutes < 120.0 else ("in_hours", 60.0)
        if minutes > 100.0 * 60.0:
            key, divisor = "in_days", 1440.0
        time = Message(f"refused_motion.{key}", time=minutes / divisor)
        proof = "effort_with_proof" if self.proof else "effort"
        return Message(
            f"refused_motion.{proof}",
            steps=self.steps,
            bars=self.bars,
            often=Message("refused_motion.times", count=self.runs),
            proof=self.proof,
            time=time,
            size=self.bytes / 1e9,
        )

    def check(self, duration: float) -> None:
        """Refuse what would not end or not fit.

        Raises InputError by the keys of ``[dynamics]`` that it hangs on.
        """
        problems = []
        if self.seconds > MOST_SECONDS:
            allowed = Message(
                "refused_motion.days_are_most_shorter_duration",
                effort=self.words,
                most_seconds=MOST_SECONDS / 86400.0,
            )
            problems.append(Problem("dynamics.duration", f"{duration:g} s", allowed))
        if self.bytes > MOST_BYTES:
            allowed = Message(
                "refused_motion.gb_are_most_keep_fewer",
                effort=self.words,
                most_bytes=MOST_BYTES / 1000000000.0,
            )
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
