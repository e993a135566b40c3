"""Lines that go slack and snap: what their largest tension hangs on, and whether the proof sees it.

    python -m benchmarks.slack [--lines 200] [--out benchmarks/results/slack.md]

Three tables: the largest tension over line damping, bars and step; two cases of one line, as they
are run by default, beside a run at a tenth of the step with twice the bars; and random lines that
go slack, each beside such a run: how many the proof lets pass, and how far those are off.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import math
import tempfile
from collections.abc import Iterator
from dataclasses import astuple, dataclass, fields, replace
from pathlib import Path

import numpy as np

from benchmarks.common import page
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model import Case, Dynamics, Line, Load, Motion, Segment, Site, WaveState
from catopt.model.dynamics import BARS
from catopt.verify.convergence_check import LIMIT, OF_MBL, ConvergenceCheck
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicPart

_KEPT = Path(__file__).parent / "results" / "slack-lines.csv"

FIRST = 1000
"""First seed of the random lines: those below 1000 were looked at when the proof was made."""

# Studless chain R3 of 38 mm, to three digits; both drag coefficients on the nominal diameter.
CHAIN = Segment(
    60.0, 245.0, EA=1.23e8, mass=28.8, drag_diameter=0.038, drag_normal=2.4, drag_axial=0.366,
    added_mass_normal=1.0, added_mass_axial=0.5,
)  # fmt: skip


def heaving() -> Case:
    """Heave of 3 m in 6 s of a line of 60 m in 20 m of water."""
    return Case(
        site=Site(20.0, seabed_friction=0.5), line=Line([CHAIN]), fairlead_height=20.0,
        load=Load(horizontal_force=20e3), motion=Motion(period=6.0, heave=3.0),
        dynamics=Dynamics(30.0, ramp=12.0),
    )  # fmt: skip


def at_sea(folder: Path) -> Case:
    """Lead the same line by a buoy that follows waves of Hs 2.5 m, Tp 7 s."""
    raos = folder / "slack-rao.csv"
    raos.write_text(
        "period,surge,surge_phase,heave,heave_phase\n3,0.8,90,0.9,0\n6,1,90,1,0\n12,1.1,90,1,0\n",
        encoding="utf-8",
    )
    return replace(
        heaving(),
        motion=Motion(rao_file=str(raos)),
        waves=WaveState("jonswap", 2.5, 7.0, components=60, direction=math.pi),
        dynamics=Dynamics(120.0, ramp=20.0),
    )


def random_case(seed: int) -> Case:
    """Build a line that is likely to go slack: chain or wire, little pull, much heave.

    Breaking loads are those of studless chain R3 and of 6x19 wire rope.
    """
    rng = np.random.default_rng(seed)
    depth = float(rng.uniform(12.0, 80.0))
    length = depth * float(rng.uniform(1.6, 4.0))
    is_chain = bool(rng.random() < 0.7)
    d = float(rng.uniform(0.02, 0.1))
    mass, EA = (19.9e3 * d**2, 85.4e9 * d**2) if is_chain else (3.99e3 * d**2, 40.4e9 * d**2)
    MBL = 22.3e6 * d**2 * (44.0 - 80.0 * d) if is_chain else 6.33e8 * d**2
    weight = mass * 9.81 * (0.87 if is_chain else 0.83)
    period = float(rng.uniform(4.0, 9.0))
    segment = Segment(
        length, weight, EA=EA, mass=mass, drag_diameter=d, drag_normal=2.4 if is_chain else 1.2,
        drag_axial=0.366 if is_chain else 0.0, added_mass_normal=1.0, MBL=MBL,
    )  # fmt: skip
    heave = float(rng.uniform(0.05, 0.15)) * min(depth, 30.0)
    return Case(
        site=Site(depth, seabed_friction=float(rng.uniform(0.0, 0.8))),
        line=Line([segment]),
        fairlead_height=depth,
        load=Load(horizontal_force=weight * depth * float(rng.uniform(0.3, 2.0))),
        motion=Motion(
            period=period,
            heave=heave,
            surge=heave * float(rng.uniform(0.0, 1.0)),
            surge_phase=float(rng.uniform(0.0, 2.0 * math.pi)),
        ),
        dynamics=Dynamics(4.0 * period, ramp=1.5 * period),
    )


def run(case: Case, convergence_check: ConvergenceCheck, **changes: float) -> DynamicPart:
    """Run a case with other settings."""
    assert case.dynamics is not None
    of = replace(case, dynamics=replace(case.dynamics, **changes))  # type: ignore[arg-type]
    (part,) = verify_dynamic(of, convergence_check=convergence_check).parts
    return part


def finer(case: Case, part: DynamicPart) -> DynamicPart:
    """Run at a tenth of the step, with twice the bars."""
    step = part.runs[0].history.step
    return run(case, "none", time_step=step / 10.0, elements=2 * part.elements)


@dataclass(frozen=True)
class Judged:
    """A default run beside the finer one: how far its tensions are off at most, and its verdict.

    `off`: over the finer one's; `of_MBL`: over the breaking load.
    """

    verdict: str
    off: float
    tension: float
    finer: float
    change: float
    lost: float
    elements: int = BARS
    of_MBL: float = math.nan


def judged(case: Case) -> Judged | None:
    """Judge one case; None where it does not go slack or has no equilibrium."""
    try:
        part = run(case, "step")
    except NotConvergedError:
        return Judged("not converged", math.nan, math.nan, math.nan, math.nan, math.nan)
    except NoAnswerError:
        return None
    if part.slack_time == 0.0:
        return None
    try:
        true = finer(case, part)
    except NotConvergedError:
        return Judged(part.verdict, math.inf, part.max_tension, math.nan, math.nan, math.nan)
    own, other = part.runs[0].maxima, true.runs[0].maxima
    floor = 0.02 * other["largest_tension"]
    keys = ("fairlead_tension", "anchor_tension", "largest_tension")
    off = max(abs(own[key] - other[key]) / max(other[key], floor) for key in keys)
    of_MBL = max(abs(own[key] - other[key]) for key in keys) / (part.MBL or math.nan)
    worst = part.worst_change
    change = math.nan if worst is None else worst.size
    return Judged(
        part.verdict, off, own["largest_tension"], other["largest_tension"], change,
        part.numerical_part, part.elements, of_MBL,
    )  # fmt: skip


def damping_table(case: Case) -> Iterator[str]:
    """Tabulate the largest fairlead tension over damping and bars, in kN."""
    yield "| line_damping | 50 bars | 100 | 200 | 100, a tenth of the step | damping takes |"
    yield "|---|---|---|---|---|---|"
    for ratio in (0.0, 0.25, 0.5, 1.0, 2.0, 4.0):
        cells, part = [], None
        for bars, step in ((50, 0.1), (100, 0.1), (200, 0.1), (100, 0.01)):
            try:
                found = run(case, "none", line_damping=ratio, elements=bars, time_step=step)
            except NotConvergedError:
                cells.append("rings")
                continue
            cells.append(f"{found.of('fairlead_tension').maximum / 1e3:.1f}")
            part = found
        share = "-"
        if part is not None:
            balance = part.runs[0].history.balance
            share = f"{abs(balance.damping) / balance.put_in:.1%}"
        yield f"| {ratio:g} | {' | '.join(cells)} | {share} |"


def two_cases(cases: dict[str, Case]) -> Iterator[str]:
    """Tabulate the default run beside the finer one."""
    yield (
        "| case | largest tension | tenth step, twice the bars | off | change found by the proof "
        "| numerical | verdict |"
    )
    yield "|---|---|---|---|---|---|---|"
    for name, case in cases.items():
        found = judged(case)
        assert found is not None
        yield (
            f"| {name} | {found.tension / 1e3:.1f} kN | {found.finer / 1e3:.1f} kN "
            f"| {found.off:.1%} | {found.change:.1%} | {found.lost:.1e} | {found.verdict} |"
        )


def model_test(period: float, friction: float) -> Case:
    """Build Lindahl's chain (J. Mar. Sci. Eng. 3, 2015), as printed but for the friction."""
    segment = Segment(
        33.0, 0.69958, EA=1e4, mass=0.0818, drag_diameter=0.0022, drag_normal=2.5, drag_axial=0.5,
        added_mass_normal=2.8,
    )  # fmt: skip
    return Case(
        site=Site(3.0, seabed_friction=friction, water_density=1000.0),
        line=Line([segment]),
        fairlead_height=3.3,
        load=Load(span=32.554),
        motion=Motion(period=period, surge=0.2, heave=0.2, heave_phase=0.5 * math.pi),
        dynamics=Dynamics(12.0 * period, ramp=4.0 * period, elements=80, damping_time=2e-4),
    )


def friction_table() -> Iterator[str]:
    """Tabulate the model test's largest tensions over the friction of the bed."""
    yield (
        "| T (s) | friction | fairlead (N) | anchor (N) | change, run again | slack, longest (s) "
        "| friction takes | numerical |"
    )
    yield "|---|---|---|---|---|---|---|---|"
    for period in (3.5, 1.25):
        for friction in (0.0, 0.1, 0.3, 0.5, 1.0):
            part = run(model_test(period, friction), "step")
            balance = part.runs[0].history.balance
            yield (
                f"| {period:g} | {friction:g} | {part.of('fairlead_tension').maximum:.1f} "
                f"| {part.of('anchor_tension').maximum:.1f} "
                f"| {part.change_of('largest_tension') or 0.0:.1%} | {part.longest_slack:.2f} "
                f"| {abs(balance.friction) / balance.put_in:.1%} | {part.numerical_part:.1e} |"
            )


def judged_lines(count: int, kept: Path) -> Iterator[tuple[int, Judged | None]]:
    """Judge random lines until so many go slack; the row of each seed is kept and not redone."""
    rows = list(csv.reader(kept.open(encoding="utf-8")))[1:] if kept.exists() else []
    if not rows:
        kept.write_text(f"seed,{','.join(f.name for f in fields(Judged))}\n", encoding="utf-8")
    slack = 0
    for seed in itertools.count(FIRST):
        if slack == count:
            return
        if seed - FIRST < len(rows):
            row = rows[seed - FIRST]
            one = _read(row[1:]) if row[1] else None
        else:
            one = judged(random_case(seed))
            cells = astuple(one) if one is not None else ("",) * len(fields(Judged))
            with kept.open("a", encoding="utf-8", newline="") as file:
                csv.writer(file, lineterminator="\n").writerow([seed, *cells])
        slack += one is not None
        yield seed, one


def _read(row: list[str]) -> Judged:
    off, tension, finer, change, lost = map(float, row[1:6])
    return Judged(row[0], off, tension, finer, change, lost, int(row[6]), float(row[7]))


def random_lines(count: int, kept: Path) -> Iterator[str]:
    """Tabulate random lines by their verdict."""
    drawn = list(judged_lines(count, kept))
    found = [(seed, one) for seed, one in drawn if one is not None]
    yield f"{len(found)} lines that go slack, of {len(drawn)} drawn."
    yield ""
    yield "| verdict | lines | within 5 % | beyond | furthest off | numerical, at most |"
    yield "|---|---|---|---|---|---|"
    for verdict in ("converged", "not converged"):
        of = [one for _, one in found if one.verdict == verdict]
        known = [one.off for one in of if not math.isnan(one.off)]
        good = sum(off <= LIMIT for off in known)
        lost = max((one.lost for one in of if not math.isnan(one.lost)), default=math.nan)
        yield (
            f"| {verdict} | {len(of)} | {good} | {len(known) - good} | "
            f"{max(known, default=math.nan):.1%} | {lost:.1e} |"
        )
    fewer = sum(one.elements == 2 * BARS for _, one in found)
    yield ""
    yield f"{fewer} of them were run with {2 * BARS} bars, because {BARS} were too few."
    silent = [
        (s, one)
        for s, one in found
        if one.verdict == "converged" and one.off > LIMIT and not one.of_MBL <= OF_MBL
    ]
    yield ""
    yield f"Wrong in silence, beyond 5 % of the tension and 2 % of the MBL: {len(silent)}."
    for seed, one in silent:
        yield f"- seed {seed}: off {one.off:.1%}, change found {one.change:.1%}"


def main() -> None:
    """Print the tables; write them, too, where --out says."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kept", type=Path, default=_KEPT, help="a row a line, to go on from")
    page(parser, _report, lines=(200, 1))


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# Lines that go slack and snap"
    yield ""
    yield (
        "60 m of 38 mm studless chain in 20 m of water, 20 kN at rest, friction 0.5, "
        "generalised-alpha, steps that follow the snap. `line_damping` is a part of what is "
        "critical for a hundredth of the line, however many bars there are."
    )
    yield ""
    if of.smoke:
        part = run(heaving(), "none", duration=7.0, ramp=6.0, elements=4)
        yield f"Seven seconds of four bars: {len(part.runs)} run."
        return
    yield "## Damping of the line: largest fairlead tension (kN), heave of 3 m in 6 s"
    yield ""
    yield from damping_table(heaving())
    yield ""
    yield "## As run by default"
    yield ""
    with tempfile.TemporaryDirectory() as folder:
        yield from two_cases(
            {"heave 3 m, 6 s": heaving(), "Hs 2.5 m, Tp 7 s": at_sea(Path(folder))}
        )
    yield ""
    yield "## Lindahl's model test, measured 51.4 N at 3.5 s and slack in every cycle at 1.25 s"
    yield ""
    yield "Friction as printed is 0.3; damping of the line as printed, 2 N s."
    yield ""
    yield from friction_table()
    yield ""
    yield "## Random lines"
    yield ""
    yield from random_lines(of.lines, of.kept)


if __name__ == "__main__":
    main()
