"""The fast judgement in motion beside the full model, on random sizings.

    python -m benchmarks.quick [--ships 50] [--buoys 50] [--minutes 15] [--first 0]

Each mooring is drawn as the campaign in motion draws it, on one line, and sized as `catopt size`
does without being told more. What is recommended is then run in full, by `verify_ship` or
`verify_dynamic`, which know nothing of the fast judgement, as many runs and as long as
`--in-motion` makes them, and held against the same checks. A deviation is the utilisation in full
over that of the fast judgement; above 1 the fast one is on the unsafe side. It stops where its
minutes are over, and says how many it ran.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import catopt
from benchmarks.common import page
from catopt.checks.result import CheckReport
from catopt.errors import CatoptError
from catopt.notes.motion import checks_in_motion
from catopt.sizing.in_motion import InMotion
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.two_scales import verify_ship
from tests.campaign.in_motion import drawn

SHOWN = ("tension", "uplift_angle", "sliding", "holding")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    sizes = {"ships": (50, 1), "buoys": (50, 0), "minutes": (15.0, 1.0), "first": (0, 0)}
    page(parser, report, **sizes)


@dataclass(frozen=True)
class Beside:
    """A sizing by the fast judgement, and what the full model makes of it."""

    number: int
    kind: str
    said: str
    seconds: float
    lines: int = 0
    fast: tuple[float | None, ...] = ()
    full: tuple[float | None, ...] = ()

    @property
    def deviation(self) -> float:
        """The largest of full over fast, of what is used by more than a twentieth."""
        pairs = zip(self.fast, self.full, strict=True)
        return max((b / a for a, b in pairs if a and b and max(a, b) > 0.05), default=0.0)

    @property
    def most(self) -> float:
        """The largest utilisation in full."""
        return max((each for each in self.full if each is not None), default=0.0)


def report(of: argparse.Namespace) -> Iterator[str]:
    """Size and run again until the time is over."""
    yield "# The fast judgement in motion beside the full model"
    yield (
        f"`python -m benchmarks.quick --ships {of.ships} --buoys {of.buoys} --minutes "
        f"{of.minutes:g} --first {of.first}`: deviations are utilisations in full over those of "
        "the fast judgement, of the line that it recommends. Seconds are of processor, of the "
        "sizing alone, in one process that has run one before."
    )
    yield ""
    end, rows = time.monotonic() + 60.0 * of.minutes, []
    yield "| no | kind | fast | lines run | s | fast: tension, uplift, sliding, holding | full | |"
    yield "|---|---|---|---|---|---|---|---|"
    numbers = {"ship": iter(range(of.first, 10**6, 2)), "buoy": iter(range(of.first + 1, 10**6, 2))}
    left = {"ship": of.ships, "buoy": of.buoys}
    warm = set()
    while time.monotonic() < end and any(left.values()):
        for kind in ("ship", "buoy"):
            if not left[kind] or time.monotonic() >= end:
                continue
            again = kind not in warm and not of.smoke
            found = beside(next(numbers[kind]), kind, again=again)
            if found is None:
                continue
            warm.add(kind)
            left[kind] -= 1
            rows.append(found)
            both = (found.fast, found.full)
            cells = (" ".join("-" if e is None else f"{e:.3f}" for e in each) for each in both)
            said = f"{found.deviation:.3f}" if found.full else ""
            yield (
                f"| {found.number} | {kind} | {found.said} | {found.lines} | {found.seconds:.1f} | "
                f"{' | '.join(cells)} | {said} |"
            )
    yield ""
    for kind in ("ship", "buoy"):
        yield from _summed(kind, [each for each in rows if each.kind == kind])


def beside(number: int, kind: str, *, again: bool) -> Beside | None:
    """Size a mooring fast and run it in full; None where it is none to be run."""
    given = {key: each for key, each in drawn(number).items() if each is not None}
    given.pop("peak_period", None)
    if kind == "ship":
        given["lines"] = 1
    sizer: Any = catopt.size_buoy if kind == "buoy" else catopt.size_tanker
    seconds = 0.0
    for _ in range(2 if again else 1):
        began = time.process_time()
        try:
            found = sizer(**given)
        except CatoptError as error:
            motion = getattr(error, "in_motion", None) is not None
            seconds = time.process_time() - began
            return Beside(number, kind, "no line passes", seconds) if motion else None
        seconds = time.process_time() - began
    moved = found.in_motion
    if moved is None:
        return Beside(number, kind, "not judged", seconds)
    full = in_full(moved)
    return Beside(
        number, kind, found.one_line.split(",")[0], seconds, len(moved.tried),
        _used(moved.checks), _used(full),
    )  # fmt: skip


def in_full(moved: InMotion) -> CheckReport:
    """Run what is recommended in full."""
    case = moved.case
    assert case.dynamics is not None
    case = replace(case, dynamics=replace(case.dynamics, judged_by=moved.how.judged_by))
    if not moved.is_of_ship:
        return checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1))
    return verify_ship(case).checks


def _used(report: CheckReport) -> tuple[float | None, ...]:
    return tuple(
        max(
            (e.utilisation for e in report.results if e.kind == kind and e.utilisation),
            default=None,
        )
        for kind in SHOWN
    )


def _summed(kind: str, rows: list[Beside]) -> Iterator[str]:
    judged = [each for each in rows if each.full]
    yield ""
    yield f"**{kind}**: {len(rows)} were sized, {len(judged)} recommended and run in full."
    if not judged:
        return
    over = [each for each in judged if each.deviation > 1.05]
    fail = [each for each in judged if each.most > 1.05]
    times = sorted(each.seconds for each in rows)
    yield (
        f"Largest deviation to the unsafe side: {max(e.deviation for e in judged):.3f}; above "
        f"1.05: {len(over)}. Recommended and beyond a limit by more than 5 % in full: {len(fail)}. "
        f"No line passes, or not judged: {len(rows) - len(judged)}. Processor: median "
        f"{times[len(times) // 2]:.1f} s, largest {times[-1]:.1f} s."
    )


if __name__ == "__main__":
    main()
