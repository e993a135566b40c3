"""What must hold between the keys that are for a line in motion, and for its fatigue."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from catopt.casefile.document import FileSection, Finding, refusals
from catopt.casefile.schema import entries
from catopt.constants import YEAR
from catopt.model import CurrentProfile, Motion
from catopt.model import dynamics as run
from catopt.model.sea import CURRENT_PROFILES, MOTION_WAYS, OF_A_BODY, train_misfits, wave_misfits
from catopt.model.system import floater_misfits, ship_misfits
from catopt.words import Message, given_keys

_FOR_FATIGUE = ("dynamics", "waves", "service")


def motion_findings(case: FileSection) -> list[Finding]:
    """List what contradicts itself in waves, current, motion, settings of a run and fatigue."""
    return [
        *_together(case),
        *_waves(case),
        *_current(case.table("current")),
        *(_motion(case.table("motion")) if "motion" in case else ()),
        *(_motion(case.table("anchor_motion")) if "anchor_motion" in case else ()),
        *(_floater(case.table("floater")) if "floater" in case else ()),
        *_run(case, case.table("dynamics")),
        *(_fatigue(case, case.table("fatigue")) if "fatigue" in case else ()),
    ]


def network_motion_findings(case: FileSection) -> list[Finding]:
    """List what contradicts itself in what points and lines have for motion."""
    dynamics = case.table("dynamics")
    return [
        *_waves(case),
        *_current(case.table("current")),
        *(_motion(case.table("motion")) if "motion" in case else ()),
        *_times(dynamics),
        *dynamics.refused(run.break_misfits(dynamics.given)),
        *(_fatigue(case, case.table("fatigue")) if "fatigue" in case else ()),
    ]


def _together(case: FileSection) -> Iterator[Finding]:
    """Find sections without the one that reads them, as the model has it."""
    if case.misspelt(*run.FOR_MOTION):
        return
    present = [key for key in run.FOR_MOTION if key in case]
    given = {
        f"{part}.{key}": value
        for part in ("motion", "body", "floater", "dynamics")
        for key, value in case.table(part).given.items()
    }
    for problem in run.dynamics_misfits(present, given):
        section, _, key = problem.key.partition(".")
        if section != "motion" or not key or not case.table("motion").misspelt(key):
            yield from case.refused([problem])


def _waves(case: FileSection) -> Iterator[Finding]:
    """Find any but exactly one way of giving waves, and keys that go with another."""
    waves = case.table("waves")
    if "waves" in case:
        misfits = train_misfits if waves.misspelt() else wave_misfits
        for problem in misfits(waves.values()):
            yield from waves.refused([replace(problem, key=problem.key.removeprefix("waves"))])
    for train in waves.tables("trains"):
        yield from train.refused(train_misfits(train.values()))


def _current(current: FileSection) -> Iterator[Finding]:
    """Find keys that the profile lacks or that go with another, and a table out of order."""
    profile: Any = current.given.get("profile")
    if profile not in CURRENT_PROFILES or current.misspelt():
        return
    given = current.values()
    if any(value in (None, []) for value in given.values()):
        return  # wrong in itself
    if "direction" in given and given.get("directions"):
        given["direction"] = 1.0  # whatever it is, it is not read
    yield from current.refused(refusals(CurrentProfile, **given))


def _motion(motion: FileSection) -> Iterator[Finding]:
    """Find any but exactly one way of moving, and keys that go with another."""
    if motion.misspelt():
        return
    known = entries(motion.schema)
    given: dict[str, Any] = {
        key: "file" if key in ("file", "rao_file") else 1.0
        for key in known
        if key in motion and key not in OF_A_BODY
    }
    for problem in refusals(Motion, **given):
        if problem.key != "motion":
            yield from motion.refused([problem])
        else:
            ways = ", ".join(key for key in MOTION_WAYS if key in known)
            yield Finding(motion.path, problem.found, Message("refused.exactly_one", ways=ways))


def _floater(floater: FileSection) -> Iterator[Finding]:
    """Find any but exactly one of buoy and ship, and keys that go with the other."""
    ship = floater.table("ship")
    if not floater.misspelt():
        yield from floater.refused(floater_misfits(floater.given))
    if not ship.misspelt("drift_file", "ulen"):
        yield from ship.refused(ship_misfits(ship.given))


def _run(case: FileSection, dynamics: FileSection) -> Iterator[Finding]:
    """Find times of a run that do not fit into it, and a line that breaks at no time, or is not."""
    yield from _times(dynamics)
    if dynamics.misspelt("broken_line", "broken_at"):
        return
    yield from dynamics.refused(run.break_misfits(dynamics.given))
    azimuths: Any = case.table("system").given.get("azimuths")
    lines = len(azimuths) if isinstance(azimuths, list) else 0 if "system" in case else 1
    if lines:
        yield from case.refused(run.broken_line_misfits(dynamics.value("broken_line"), lines))


def _times(dynamics: FileSection) -> Iterator[Finding]:
    """Find times of a run that do not fit into it."""
    times = ("duration", "ramp", "broken_at", "time_step", "output_interval")
    given = {key: dynamics.number(key) for key in times}
    if given["duration"] is not None:
        yield from dynamics.refused(run.time_misfits(given))


def _fatigue(case: FileSection, fatigue: FileSection) -> Iterator[Finding]:
    """Find what contradicts itself in fatigue, and what it lacks elsewhere."""
    curves = fatigue.tables("curves")
    yield from _shares(fatigue)
    if not fatigue.misspelt():
        yield from fatigue.refused(run.fatigue_misfits(fatigue.given))
    for curve in curves:
        if not curve.misspelt():
            yield from curve.refused(run.curve_misfits(curve.given))
    if case.misspelt(*_FOR_FATIGUE):
        return
    waves = case.table("waves")
    segments = case.table("line").given.get("segments") if "line" in entries(case.schema) else None
    problems = run.sections_misfits(
        [key for key in _FOR_FATIGUE if key in case],
        {"spectrum": True} if waves.misspelt("spectrum") else waves.given,
        [curve.value("segment") for curve in curves],
        len(segments) if isinstance(segments, list) else 0,
    )
    yield from case.refused(problems)


def _shares(fatigue: FileSection) -> Iterator[Finding]:
    """Find sea states without exactly one way of saying how long, and more than a year of them."""
    shares: list[float] = []
    for state in fatigue.tables("sea_states"):
        given = [key for key in ("share", "time_per_year") if key in state]
        if len(given) != 1:
            if not state.misspelt("share", "time_per_year"):
                allowed = Message("refused.exactly_one", ways="share, time_per_year")
                yield Finding(state.path, given_keys(given), allowed)
            continue
        share = share_of_year({key: state.number(key) for key in given})
        if share is not None and share > 1.0 and "time_per_year" in given:
            path = (*state.path, "time_per_year")
            years = Message("refused_file.years", count=share)
            yield Finding(path, years, Message("refused_file.one_year"))
        shares += [] if share is None else [share]
    yield from fatigue.refused(run.share_misfits(shares))


def share_of_year(given: Mapping[str, float | None]) -> float | None:
    """Part of the year by what a sea state gives."""
    time = given.get("time_per_year")
    return given.get("share") if time is None else time / YEAR
