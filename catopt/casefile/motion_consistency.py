"""What must hold between the keys that are for a line in motion, and for its fatigue."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from catopt.casefile.document import (
    in_file,
    misspelt,
    number,
    refusals,
    table,
    tables,
    value,
    values,
)
from catopt.casefile.location import Finding
from catopt.casefile.schema import (
    AnchorMotionTable,
    CaseTable,
    CurrentTable,
    DynamicsTable,
    FatigueCurveTable,
    FatigueSeaStateTable,
    FatigueTable,
    MotionTable,
    Table,
    WavesTable,
    WaveTrainTable,
    entries,
)
from catopt.constants import YEAR
from catopt.errors import Problem
from catopt.model import CurrentProfile, Motion
from catopt.model.current_profile import CURRENT_PROFILES
from catopt.model.dynamics import (
    FOR_MOTION,
    break_misfits,
    broken_line_misfits,
    dynamics_misfits,
    time_misfits,
)
from catopt.model.fatigue import curve_misfits, fatigue_misfits, sections_misfits, share_misfits
from catopt.model.motion import MOTION_WAYS, OF_A_BODY
from catopt.model.wave_state import train_misfits, wave_misfits

_FOR_FATIGUE = ("dynamics", "waves", "service")


def motion_findings(document: dict[str, Any]) -> list[Finding]:
    """List what contradicts itself in waves, current, motion, settings of a run and fatigue."""
    return [
        *_together(document),
        *_waves(document),
        *_current(document),
        *_motion(document, "motion", MotionTable),
        *_motion(document, "anchor_motion", AnchorMotionTable),
        *_run(document),
        *(_fatigue(document) if "fatigue" in document else ()),
    ]


def _together(document: dict[str, Any]) -> Iterator[Finding]:
    """Find sections without the one that reads them, as the model has it."""
    if misspelt(CaseTable, FOR_MOTION, document):
        return
    present = [key for key in FOR_MOTION if key in document]
    motion = table(document, "motion")
    given = {
        f"{part}.{key}": each
        for part in ("motion", "body", "dynamics")
        for key, each in table(document, part).items()
    }
    for problem in dynamics_misfits(present, given):
        section, _, key = problem.key.partition(".")
        if section != "motion" or not misspelt(MotionTable, [key], motion):
            yield from in_file(document, [problem])


def _waves(document: dict[str, Any]) -> Iterator[Finding]:
    """Find any but exactly one way of giving waves, and keys that go with another."""
    waves = table(document, "waves")
    if "waves" in document:
        is_misspelt = misspelt(WavesTable, entries(WavesTable), waves)
        misfits = train_misfits if is_misspelt else wave_misfits
        for problem in misfits(values(WavesTable, waves)):
            at = () if problem.key == "waves" else ("waves",)
            yield from in_file(document, [problem], *at)
    for path, train in tables(waves, "waves", "trains"):
        yield from in_file(document, train_misfits(values(WaveTrainTable, train)), *path)


def _current(document: dict[str, Any]) -> Iterator[Finding]:
    """Find keys that the profile lacks or that go with another, and a table out of order."""
    current = table(document, "current")
    profile: Any = current.get("profile")
    if profile not in CURRENT_PROFILES or misspelt(CurrentTable, entries(CurrentTable), current):
        return
    given = values(CurrentTable, current)
    if any(each in (None, []) for each in given.values()):
        return  # wrong in itself
    if "direction" in given and given.get("directions"):
        given["direction"] = 1.0  # whatever it is, it is not read
    yield from in_file(document, refusals(CurrentProfile, **given), "current")


def _motion(document: dict[str, Any], section: str, schema: type[Table]) -> Iterator[Finding]:
    """Find any but exactly one way of moving, and keys that go with another."""
    motion, known = table(document, section), entries(schema)
    if section not in document or misspelt(schema, known, motion):
        return
    given: dict[str, Any] = {
        key: "file" if key in ("file", "rao_file") else 1.0
        for key in known
        if key in motion and key not in OF_A_BODY
    }
    for problem in refusals(Motion, **given):
        if problem.key == "motion":
            ways = ", ".join(key for key in MOTION_WAYS if key in known)
            problem = Problem("", problem.found, f"exactly one of {ways} is wanted")
        yield from in_file(document, [problem], section)


def _run(document: dict[str, Any]) -> Iterator[Finding]:
    """Find times of a run that do not fit into it, and a line that breaks at no time, or is not."""
    dynamics = table(document, "dynamics")
    times = {
        key: number(DynamicsTable, key, dynamics)
        for key in ("duration", "ramp", "broken_at", "time_step", "output_interval")
    }
    if times["duration"] is not None:
        yield from in_file(document, time_misfits(times), "dynamics")
    if misspelt(DynamicsTable, ("broken_line", "broken_at"), dynamics):
        return
    yield from in_file(document, break_misfits(dynamics), "dynamics")
    azimuths: Any = table(document, "system").get("azimuths")
    lines = len(azimuths) if isinstance(azimuths, list) else 0 if "system" in document else 1
    if lines:
        broken = value(DynamicsTable, "broken_line", dynamics)
        yield from in_file(document, broken_line_misfits(broken, lines))


def _fatigue(document: dict[str, Any]) -> Iterator[Finding]:
    """Find what contradicts itself in fatigue, and what it lacks elsewhere."""
    fatigue = table(document, "fatigue")
    curves = tables(fatigue, "fatigue", "curves")
    yield from _shares(document, fatigue)
    if not misspelt(FatigueTable, entries(FatigueTable), fatigue):
        yield from in_file(document, fatigue_misfits(fatigue), "fatigue")
    for path, curve in curves:
        if not misspelt(FatigueCurveTable, entries(FatigueCurveTable), curve):
            yield from in_file(document, curve_misfits(curve), *path)
    if misspelt(CaseTable, _FOR_FATIGUE, document):
        return
    waves = table(document, "waves")
    if misspelt(WavesTable, ["spectrum"], waves):
        waves = {"spectrum": True}
    segments = table(document, "line").get("segments")
    problems = sections_misfits(
        [key for key in _FOR_FATIGUE if key in document],
        waves,
        [value(FatigueCurveTable, "segment", curve) for _, curve in curves],
        len(segments) if isinstance(segments, list) else 0,
    )
    yield from in_file(document, problems)


def _shares(document: dict[str, Any], fatigue: dict[str, Any]) -> Iterator[Finding]:
    """Find sea states without exactly one way of saying how long, and more than a year of them."""
    shares: list[float] = []
    for path, state in tables(fatigue, "fatigue", "sea_states"):
        given = [key for key in ("share", "time_per_year") if key in state]
        if len(given) != 1:
            if not misspelt(FatigueSeaStateTable, ("share", "time_per_year"), state):
                allowed = "exactly one of share, time_per_year is wanted"
                yield Finding(path, " and ".join(given) or "none of them", allowed)
            continue
        share = share_of_year({key: number(FatigueSeaStateTable, key, state) for key in given})
        if share is not None and share > 1.0 and "time_per_year" in given:
            yield Finding((*path, *given), f"{share:.6g} years", "at most one year")
        shares += [] if share is None else [share]
    yield from in_file(document, share_misfits(shares), "fatigue")


def share_of_year(given: Mapping[Any, float | None]) -> float | None:
    """Part of the year by what a sea state gives."""
    time = given.get("time_per_year")
    return given.get("share") if time is None else time / YEAR
