"""The campaign's table: kinds of lines down, verdicts across, and why lines failed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

from tests.campaign.evaluation import HARMLESS, VERDICTS, Outcome
from tests.campaign.lines import KINDS, KNOWN, Trial

EXAMPLES = 3
"""How many examples are kept of every reason: the simplest."""


@dataclass
class Tally:
    """Counts over many lines.

    Attributes
    ----------
    counts : Counter
        By (kind, known, verdict).
    reasons : Counter
        Of failures, by (verdict, reason).
    examples : dict
        Of every (verdict, reason) the lines with the fewest parts.
    loose : int
        Answers whose place double precision leaves more than 1e-6 of the length open.
    """

    counts: Counter[tuple[str, str, str]] = field(default_factory=Counter)
    reasons: Counter[tuple[str, str]] = field(default_factory=Counter)
    examples: dict[tuple[str, str], list[Trial]] = field(default_factory=dict)
    loose: int = 0

    def add(self, outcomes: Iterable[Outcome]) -> None:
        """Count outcomes."""
        for each in outcomes:
            self.counts[each.trial.kind, each.trial.known, each.verdict] += 1
            self.loose += each.is_loose
            if each.failed:
                key = each.verdict, each.reason
                self.reasons[key] += 1
                self._keep(key, [each.trial])

    def merge(self, other: Tally) -> None:
        """Add the counts of another tally."""
        self.counts += other.counts
        self.reasons += other.reasons
        self.loose += other.loose
        for key, trials in other.examples.items():
            self._keep(key, trials)

    def _keep(self, key: tuple[str, str], trials: list[Trial]) -> None:
        kept = [*self.examples.get(key, []), *trials]
        self.examples[key] = sorted(kept, key=simplicity)[:EXAMPLES]

    @property
    def lines(self) -> int:
        return self.counts.total()

    @property
    def failures(self) -> int:
        return self.reasons.total()

    def of(self, verdict: str) -> int:
        """How many lines had a verdict."""
        return sum(count for (_, _, each), count in self.counts.items() if each == verdict)

    def simplest(self) -> Trial | None:
        """Return the failing line with the fewest parts."""
        failing = [trial for trials in self.examples.values() for trial in trials]
        return min(failing, key=simplicity) if failing else None

    def table(self) -> str:
        """Lay the counts out as text."""
        head = f"{'kind of line':<18}{'known':<18}" + "".join(f"{v:>17}" for v in VERDICTS)
        rows = [head, "-" * len(head)]
        for kind in KINDS:
            for known in KNOWN:
                cells = [self.counts[kind, known, verdict] for verdict in VERDICTS]
                rows.append(f"{kind:<18}{known:<18}" + "".join(f"{n:>17,}" for n in cells))
        rows.append("-" * len(head))
        rows.append(f"{'all':<36}" + "".join(f"{self.of(v):>17,}" for v in VERDICTS))
        if self.reasons:
            rows += ["", "failures by reason (number, verdict, reason, simplest lines by index)"]
        for (verdict, reason), number in self.reasons.most_common():
            indices = ", ".join(str(trial.index) for trial in self.examples[verdict, reason])
            rows.append(f"{number:>9,}  {verdict:<16} {reason:<42} {indices}")
        rows.append(f"answers that double precision leaves open by > 1e-6 L: {self.loose:,}")
        return "\n".join(rows)


def simplicity(trial: Trial) -> tuple[int, int, int]:
    """Order lines by their number of parts."""
    line = trial.line
    return (
        len(line.segments) + len(line.point_loads),
        (trial.friction > 0.0) + (trial.anchor_height > 0.0) + (not trial.is_inextensible),
        trial.index,
    )


assert set(HARMLESS) <= set(VERDICTS)
