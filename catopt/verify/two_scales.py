"""A case's ship on its lines, on two time scales: what its lines carry, and whether they may."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.checks.criteria import Criteria, criteria_of, motion_profile
from catopt.checks.evaluation import evaluate, of_criteria
from catopt.checks.kinds import Criterion, Place, State
from catopt.checks.profiles import profiles_of
from catopt.checks.result import CheckReport, CheckResult
from catopt.checks.system import (
    checked_states,
    for_line_out,
    lost_results,
    of_line_out,
    state_words,
    strengths_of_lines,
)
from catopt.errors import InputError, NoAnswerError, Problem, refused
from catopt.fem.extremes import weibull_tail
from catopt.floater.scales import scales_of
from catopt.floater.ship_in_weather import ShipInWeather
from catopt.floater.slow_drift import SLOW_STEP
from catopt.floater.stability import period_of
from catopt.floater.tabulated import TabulatedShip
from catopt.floater.two_scales import (
    MooredShip,
    ShipAtRest,
    ShipHistory,
    sample_step,
)
from catopt.largest import largest
from catopt.model import Case, System
from catopt.model.dynamics import Dynamics
from catopt.mooring.zero_load import zero_load_position
from catopt.progress import Progress
from catopt.verify.convergence_check import LIMIT, Change
from catopt.verify.dynamic_setup import Excitation, read_drive
from catopt.verify.ship_result import (
    LineOfShip,
    ShipVerification,
    ShipWithoutLine,
    Swing,
    few_cycles,
    governing_words,
    offset_of,
    remarks_of,
    slow_cycles,
)
from catopt.waves import Waves
from catopt.words import Message

_TO_GROW: Final = 10800.0
"""s, in which a swing that is unstable grows; its second half is measured."""
_LEVELS: Final = 20
"""Over the draught, at which the current is averaged."""
_WAY: Final = 2.5
"""Significant heights that a fairlead rises or falls by at most."""
_SAME: Final = 1e-6
"""By which tensions at rest may differ and are the same."""


def _lines(
    moored: MooredShip, numbers: Sequence[int], runs: tuple[ShipHistory, ...], dynamics: Dynamics
) -> Iterator[LineOfShip]:
    storm, by = dynamics.duration_of_interest, dynamics.judged_by
    for k, (number, leg) in enumerate(zip(numbers, moored.system.legs, strict=True)):
        fairlead, anchor = (
            scales_of(
                [each.slow_tension[:, k, end] for each in runs],
                [each.tension[:, k, end] for each in runs],
                runs[0].time,
                storm,
            )
            for end in (0, 1)
        )
        known = [each.MBL for each in leg.line.segments if each.MBL is not None]
        time = math.fsum(float(each.time[-1] - each.time[0]) for each in runs)
        tail = weibull_tail([each.tension[:, k, 0] for each in runs], time, storm)
        extreme = None if tail is None else tail.extreme
        yield LineOfShip(number, fairlead, anchor, min(known, default=None), extreme, by)


def verify_ship(
    case: Case,
    *,
    ship: ShipInWeather | None = None,
    progress: Progress | None = None,
    on_lines: Callable[..., MooredShip] = MooredShip,
    proven: bool = True,
) -> ShipVerification:
    """Run the ship of a case on its lines, on two time scales.

    Parameters
    ----------
    case : Case
        With `floater.ship`, `system`, `waves` and `dynamics`, whose duration, ramp, runs and
        duration of interest count; with `motion` for RAOs of its own.
    ship : ShipInWeather, optional
        That of an earlier answer (`moored.ship`) in the same weather, whose tables it shares.
    progress : callable, optional
        Told how many runs are done, of how many.
    on_lines : callable
        Puts a ship on lines, such as `catopt.floater.tabulated.TabulatedShip`.
    proven : bool
        Run the seed with the largest tension again at half the step.

    Returns
    -------
    ShipVerification

    Raises
    ------
    InputError
        For a case without such a ship, and what is wrong in its files.
    NoEquilibriumError
        Where the lines do not hold the ship, or one does not reach in motion.
    NotConvergedError

    Examples
    --------
    >>> from dataclasses import replace
    >>> from catopt import read_case
    >>> from catopt.verify.two_scales import verify_ship
    >>> case = read_case("cases/fso-rang-dong-ship/loaded.toml")
    >>> short = replace(case.dynamics, duration=120.0, ramp=20.0)
    >>> found = verify_ship(replace(case, dynamics=short))
    >>> round(found.rest.force[0] / 1e3)
    -1372
    """
    moored, drive = moored_ship(case, ship, on_lines)
    dynamics, legs = drive.dynamics, moored.system.legs
    criteria, damaged = _criteria(case), _line_out_criteria(case)
    strengths_of_lines(criteria, legs, damaged)  # refuses what is not known
    rest = moored.at_rest(_waves(drive, 0))
    missing, needless = _losses(moored, rest) if damaged else ((), ())
    tell = _counted(progress, dynamics.runs * (1 + len(missing)))
    swing, start = _swing(moored, drive, rest)
    histories = _histories(moored, drive, tell, start)
    lines = tuple(_lines(moored, range(1, len(legs) + 1), histories, dynamics))
    lost = tuple(_without(moored, drive, number, tell) for number in missing)
    transient = _as_a_line_parts(moored, drive, histories, start)
    asked = case.own_system.judged_line_out
    remarks: tuple[Message, ...] = (
        swing.words,
        *governing_words(lines, dynamics),
        *few_cycles(slow_cycles(histories, rest)),
        *remarks_of(case, moored, drive.sea(0), rest),
        *_of_losses(lost, needless),
        *_of_transient(transient, drive.dynamics),
        *(
            of_line_out(criteria, damaged, len(legs))
            if asked or len(legs) == 1
            else (Message("checks.line_out_not_asked"),)
        ),
    )
    hanging = hang_under_governing(lines, moored)
    every_loss = (*lost, transient) if transient is not None else lost
    checks, directions = check_hanging(case, hanging, every_loss), _waves(drive, 0).direction
    change = None
    if proven:
        number = hardest_run(histories)
        change = _change(histories[number], moored, drive, start, number)
        checks = with_proof(checks, change)
        remarks = (*remarks, Message("floater.half_step", change=change.size))
    return ShipVerification(
        case,
        moored,
        rest,
        histories,
        lines,
        hanging,
        checks,
        remarks,
        directions,
        swing,
        lost,
        change,
        transient,
    )


def with_proof(checks: CheckReport, change: Change) -> CheckReport:
    """Say of checks what a run at half the step makes of them."""
    is_proven = change.size <= LIMIT
    return replace(checks, is_proven=is_proven, is_doubted=not is_proven)


def _swing(moored: MooredShip, drive: Excitation, rest: ShipAtRest) -> tuple[Swing, Array | None]:
    """Find how the ship swings in the mean weather; a state in the swing, if it grows."""
    waves = _waves(drive, 0)
    mode = moored.mode(waves, rest)
    if mode.rate <= 0.0:
        return Swing(mode.rate, mode.period), None
    try:
        path = moored.swing(waves, rest, _TO_GROW)
    except NoAnswerError:
        return Swing(mode.rate, mode.period), None
    grown = path[path.shape[0] // 2 :]
    yaw = grown[:, 2] - rest.place[2]
    tension = moored.still_tension(np.ascontiguousarray(grown[:, :3]))[:, :, 0]
    period = period_of(yaw, SLOW_STEP) or mode.period
    return Swing(mode.rate, period, float(abs(yaw).max()), float(tension.max())), path[-1]


def _counted(progress: Progress | None, total: int) -> Callable[[], None]:
    """Count runs that are done, of how many."""
    done = itertools.count(1)

    def tell() -> None:
        if progress is not None:
            progress(next(done), total)

    return tell


def _histories(
    moored: MooredShip,
    drive: Excitation,
    tell: Callable[[], None],
    start: Array | None = None,
) -> tuple[ShipHistory, ...]:
    """Run a ship in every seed, from where she rests in it or a state of hers."""
    dynamics = drive.dynamics
    run = partial(_run, moored, drive, start)
    # The first run by itself: whatever has to be compiled then is.
    found = [run(0)]
    tell()
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        later = pool.map if dynamics.runs > 2 else map
        for each in later(run, range(1, dynamics.runs)):
            found.append(each)
            tell()
    return tuple(found)


def _run(
    moored: MooredShip,
    drive: Excitation,
    start: Array | None,
    number: int,
    *,
    finer: bool = False,
    parts: tuple[int, float] | None = None,
) -> ShipHistory:
    """Run a ship in one seed; `finer`: at half the step; `parts`: as `MooredShip.run`."""
    waves, step, until = (
        _waves(drive, number),
        sample_step(_waves(drive, 0)),
        drive.dynamics.duration,
    )
    seed = 0 if drive.case.waves is None else drive.case.waves.seed
    generator = np.random.default_rng([seed, number, 1])
    until = drive.dynamics.duration
    return moored.run(
        waves, until, drive.ramp, generator, step=step, start=start, finer=finer, parts=parts
    )


# ------------------------------------------------------------------ at half the step


def change_at_half_step(
    case: Case,
    number: int,
    *,
    ship: ShipInWeather | None = None,
    on_lines: Callable[..., MooredShip] = MooredShip,
) -> Change:
    """Say by how much the largest tension of one run, from 0, moves at half the step.

    All else as `verify_ship`.
    """
    moored, drive = moored_ship(case, ship, on_lines)
    _, start = _swing(moored, drive, moored.at_rest(_waves(drive, 0)))
    return _change(_run(moored, drive, start, number), moored, drive, start, number)


def _change(
    run: ShipHistory,
    moored: MooredShip,
    drive: Excitation,
    start: Array | None,
    number: int,
) -> Change:
    finer = _run(moored, drive, start, number, finer=True)
    largest = finer.tension.max(axis=(0, 2))
    moved = abs(run.tension.max(axis=(0, 2)) - largest)
    most = int(np.argmax(moved / largest))
    return Change("largest_tension", "step", float(moved[most] / largest[most]), float(moved[most]))


def hardest_run(runs: Sequence[ShipHistory]) -> int:
    """Say in which run, from 0, the largest tension stands."""
    return int(np.argmax([each.tension.max() for each in runs]))


# ------------------------------------------------------------------ with a line out


def run_without(
    case: Case,
    number: int,
    *,
    ship: ShipInWeather | None = None,
    on_lines: Callable[..., MooredShip] = MooredShip,
) -> tuple[ShipWithoutLine, MooredShip]:
    """Run the ship of a case without one of its lines, from 1, alone; as `verify_ship`."""
    moored, drive = moored_ship(case, ship, on_lines)
    return _without(moored, drive, number, _counted(None, 0)), moored


def _without(
    moored: MooredShip, drive: Excitation, number: int, tell: Callable[[], None]
) -> ShipWithoutLine:
    left = replace(moored, system=moored.system.without([number - 1]))
    numbers = [each for each in range(1, len(moored.system.legs) + 1) if each != number]
    storm, neutral = drive.dynamics.duration_of_interest, moored.zero_load.neutral
    try:
        histories = _histories(left, drive, tell)
        lines = tuple(_lines(left, numbers, histories, drive.dynamics))
        hanging = hang_under_governing(lines, left)
    except NoAnswerError as error:
        return ShipWithoutLine(number, refusal=error.args[0])
    offset = offset_of(histories, (neutral.x, neutral.y), storm)
    return ShipWithoutLine(number, lines, hanging, offset)


def _as_a_line_parts(
    moored: MooredShip,
    drive: Excitation,
    intact: tuple[ShipHistory, ...],
    start: Array | None,
) -> ShipWithoutLine | None:
    """Run every seed once more up to where a line parts, and on without it; None without one.

    By its tension it parts at the first sample of a run with all there at which it reaches the MBL.
    """
    dynamics = drive.dynamics
    if dynamics.broken_line is None:
        return None
    line = dynamics.broken_line - 1
    times = dict.fromkeys(range(len(intact)), dynamics.broken_at)
    if dynamics.broken_by == "MBL":
        leg = moored.system.legs[line]
        MBL = min(each.MBL or math.inf for each in leg.line.segments)
        times = {n: _first_at(each, line, MBL) for n, each in enumerate(intact)}
    parted = {n: max(time, SLOW_STEP) for n, time in times.items() if time is not None}
    number = line + 1
    if not parted:
        return ShipWithoutLine(number)
    numbers = [each for each in range(1, len(moored.system.legs) + 1) if each != number]
    storm, neutral = dynamics.duration_of_interest, moored.zero_load.neutral
    left = moored.without(line)
    try:
        runs = tuple(_run(moored, drive, start, n, parts=(line, t)) for n, t in parted.items())
        lines = tuple(
            replace(each, is_transient=True) for each in _lines(left, numbers, runs, dynamics)
        )
        hanging = hang_under_governing(lines, left)
    except NoAnswerError as error:
        return ShipWithoutLine(number, refusal=error.args[0], parted=tuple(parted.values()))
    offset = offset_of(runs, (neutral.x, neutral.y), storm)
    return ShipWithoutLine(number, lines, hanging, offset, parted=tuple(parted.values()))


def _first_at(run: ShipHistory, line: int, MBL: float) -> float | None:
    """Say when a line first reaches its MBL at its fairlead, s; None where it does not."""
    over = np.flatnonzero(run.tension[:, line, 0] >= MBL)
    return float(run.time[over[0]]) if over.size else None


def _of_transient(transient: ShipWithoutLine | None, dynamics: Dynamics) -> Iterator[Message]:
    """Yield what comes of a line that parts: the largest tension and offset from then on."""
    if transient is None:
        return
    number = transient.missing
    if not transient.parted:
        yield Message("floater.does_not_part", number=number)
        return
    said = {"number": number, "time": min(transient.parted), "count": len(transient.parted)}
    yield Message(
        "floater.parts_by_MBL" if dynamics.broken_by == "MBL" else "floater.parts", **said
    )
    if transient.refusal:
        yield Message("floater.line_out_refused", number=number, why=transient.refusal)
        return
    assert transient.offset is not None
    most = largest(transient.lines, lambda each: each.fairlead.seen)
    reached = {"tension": most.fairlead.seen / 1e3, "offset": transient.offset.seen}
    yield Message("floater.transient", line=most.number, number=number, **reached)


def _losses(moored: MooredShip, rest: ShipAtRest) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Find the lines without which another carries more at rest in the mean weather; the others.

    By number, the one whose loss is the hardest first.
    """
    moment = float(np.sum(rest.parts, axis=0)[2]) if moored.system.turns else 0.0

    def most(of: System) -> float:
        try:
            _, lines = zero_load_position(of).under(rest.force, moment if of.turns else 0.0)
        except NoAnswerError:
            return math.inf
        return max(map(math.hypot, lines.H, lines.V))

    whole, count = most(moored.system), len(moored.system.legs)
    left = {k + 1: most(moored.system.without([k])) for k in range(count)}
    harder = [number for number, each in left.items() if each > whole * (1.0 + _SAME)]
    order = sorted(harder, key=lambda number: -left[number])
    return tuple(order), tuple(number for number in left if number not in harder)


def _line_out_criteria(case: Case) -> tuple[Criterion, ...]:
    """List the criteria for one line out; none where the case does not ask for it."""
    system = case.own_system
    if len(system.legs) == 1 or not system.judged_line_out:
        return ()
    return for_line_out(_criteria(case), len(system.legs))


def _of_losses(lost: tuple[ShipWithoutLine, ...], needless: tuple[int, ...]) -> Iterator[Message]:
    """Yield what was run with a line out, and what was not."""
    if lost:
        yield Message("floater.lines_out", numbers=", ".join(f"{each.missing}" for each in lost))
        for each in lost:
            if each.refusal:
                yield Message("floater.line_out_refused", number=each.missing, why=each.refusal)
    if needless:
        yield Message("floater.lines_out_needless", numbers=", ".join(map(str, needless)))


def on_tables(height: float) -> Callable[..., MooredShip]:
    """Give what puts ships of a search on lines out of tables, in seas up to a height, m."""
    return partial(TabulatedShip, known={}, way=_WAY * height)


def _waves(drive: Excitation, run: int) -> Waves:
    waves = drive.sea(run).waves
    assert waves is not None
    return waves


def moored_ship(
    case: Case,
    ship: ShipInWeather | None = None,
    on_lines: Callable[..., MooredShip] = MooredShip,
) -> tuple[MooredShip, Excitation]:
    """Make the ship of a case on its lines, and what drives it; as `verify_ship`."""
    if case.floater is None or case.floater.ship is None:
        allowed = Message("refused_case.ship_wanted")
        raise refused("floater.ship", "", allowed, "--dynamic")
    floater, of, current = case.floater, case.floater.ship, case.current
    system = case.own_system
    if current is not None and current.series_file:
        allowed = Message("refused_case.ship_steady_current")
        problem = Problem("current.series_file", current.series_file, allowed)
        raise InputError([problem], "--dynamic")
    drive = read_drive(case)
    if ship is not None and drive.vessel is None:
        return on_lines(system, ship), drive
    depth, flow = case.site.water_depth, (0.0, 0.0)
    if current is not None and of.draught < depth:
        at = current.flow(depth)
        levels = (depth - of.draught * (k + 0.5) / _LEVELS for k in range(_LEVELS))
        parts = [at(level) for level in levels]
        flow = (sum(e[0] for e in parts) / _LEVELS, sum(e[1] for e in parts) / _LEVELS)
    speed, way = floater.wind_speed, of.wind_direction
    wind = (speed * math.cos(way), speed * math.sin(way))
    ship = ShipInWeather(of, depth, case.site.water_density, wind, flow)
    ship.ship  # noqa: B018 - refuses what no hull can be
    vessel = drive.vessel
    if vessel is None:
        return on_lines(system, ship), drive
    return on_lines(system, ship, vessel.coefficients, vessel.reference, vessel.crest), drive


def _criteria(case: Case) -> Criteria:
    """Gather what lines that hang by closed form are to keep: factors for quasi-static analysis.

    In the place of a code without factors for motion those of `checks.motion_code`, if given.
    """
    checks, by = case.checks, motion_profile(case.checks)
    if by is None or checks.motion_code is None:
        return criteria_of(case)
    named = zip(checks.codes, profiles_of(replace(checks, motion_code=None)), strict=True)
    codes = [code for code, each in named if each.is_for_motion]
    if checks.codes and len(codes) == len(checks.codes):
        return criteria_of(case)
    own = replace(checks, codes=tuple(dict.fromkeys((*codes, checks.motion_code))))
    return criteria_of(replace(case, checks=replace(own, motion_code=None)))


def hang_under_governing(lines: tuple[LineOfShip, ...], moored: MooredShip) -> tuple[Solution, ...]:
    """Hang each line under the tension at its fairlead that it is judged by."""
    return tuple(
        solve(
            leg.line,
            height=leg.fairlead_height,
            fairlead_tension=each.judged_tension,
            seabed_friction=moored.system.seabed_friction,
            anchor_height=leg.anchor_height,
        )
        for each, leg in zip(lines, moored.system.legs, strict=True)
    )


def check_hanging(
    case: Case, hanging: tuple[Solution, ...], lost: tuple[ShipWithoutLine, ...] = ()
) -> CheckReport:
    """Check each line as it hangs under its largest tension, by quasi-static factors.

    With all there, unless none hang, and by the factors for one line out with each that was lost,
    or by the transient ones with one that parts.
    """
    legs, criteria, damaged = case.own_system.legs, _criteria(case), _line_out_criteria(case)
    results: list[CheckResult] = []
    reported: list[str] = []
    states: set[State] = {*checked_states(damaged)}
    states |= {"transient" for each in lost if each.parted}
    known = {each.line: criteria.strengths(each.line, {"extreme"}, states) for each in legs}

    def check(place: Place, numbers: Sequence[int], solutions: tuple[Solution, ...]) -> None:
        for number, solution in zip(numbers, solutions, strict=True):
            results.extend(
                evaluate(
                    solution,
                    criteria,
                    known[legs[number - 1].line],
                    case.anchor,
                    load_case=state_words(place),
                    kind="extreme",
                    place=replace(place, line=number),
                )
            )

    check(Place(), range(1, len(hanging) + 1), hanging)
    for each in lost:
        place = Place("transient" if each.parted else "one_line_out", missing=each.missing)
        if each.refusal:
            results += lost_results(place, each.refusal, damaged)
        check(place, [line.number for line in each.lines], each.hanging)
    for line, strengths in known.items():
        reported += of_criteria(criteria, line, strengths)
    return CheckReport(
        case.title,
        tuple(results),
        (),
        tuple(dict.fromkeys(reported)),
        case=case,
        is_in_motion=True,
    )
