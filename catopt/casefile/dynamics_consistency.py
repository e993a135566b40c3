"""What must hold between the keys that are for a line in motion."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from catopt.casefile.document import as_in_file, misspelt, number, table, tables, value
from catopt.casefile.location import Finding, parts
from catopt.casefile.schema import (
    AnchorMotionTable,
    CaseTable,
    CurrentTable,
    DynamicsTable,
    MotionTable,
    Table,
    WavesTable,
    WaveTrainTable,
    entries,
)
from catopt.documents import Path
from catopt.errors import InputError, Problem
from catopt.model import CurrentProfile, Motion
from catopt.model.current_profile import CURRENT_PROFILES
from catopt.model.dynamics import dynamics_misfits
from catopt.model.motion import MOTION_WAYS, OF_A_BODY
from catopt.model.wave_state import train_misfits, wave_misfits
from catopt.units import as_written

_SECTIONS = ("waves", "current", "motion", "anchor_motion", "body", "dynamics", "system")


def dynamics_findings(document: dict[str, Any]) -> list[Finding]:
    """List what contradicts itself in waves, current, motion and settings of a run."""
    return [
        *_together(document),
        *_waves(document),
        *_current(document),
        *_motion(document, "motion", MotionTable),
        *_motion(document, "anchor_motion", AnchorMotionTable),
        *_times(document),
        *_break(document),
    ]


def _together(document: dict[str, Any]) -> Iterator[Finding]:
    """Find sections without the one that reads them, as the model has it."""
    if misspelt(CaseTable, _SECTIONS, document):
        return
    present = [key for key in _SECTIONS if key in document]
    motion = table(document, "motion")
    given = [
        f"{key}.{each}" for key in ("motion", "body", "dynamics") for each in table(document, key)
    ]
    if table(document, "dynamics").get("broken_end") != "anchor":
        given = [each for each in given if each != "dynamics.broken_end"]
    for problem in dynamics_misfits(present, given):
        section, _, key = problem.key.partition(".")
        if section == "motion" and misspelt(MotionTable, [key], motion):
            continue
        yield as_in_file(document, Finding(parts(problem.key), problem.found, problem.allowed))


def _waves(document: dict[str, Any]) -> Iterator[Finding]:
    """Find any but exactly one way of giving waves, and keys that go with another."""
    waves = table(document, "waves")
    if "waves" in document:
        is_misspelt = misspelt(WavesTable, entries(WavesTable), waves)
        misfits = train_misfits if is_misspelt else wave_misfits
        yield from _in_waves(document, ("waves",), misfits(_read(WavesTable, waves)))
    for path, train in tables(waves, "waves", "trains"):
        yield from _in_waves(document, path, train_misfits(_read(WaveTrainTable, train)))


def _read(schema: type[Table], given: dict[str, Any]) -> dict[str, Any]:
    """Values of what is given; None of what cannot be read."""
    return {key: value(schema, key, given) for key in entries(schema) if key in given}


def _in_waves(
    document: dict[str, Any], path: Path, problems: Iterable[Problem]
) -> Iterator[Finding]:
    for problem in problems:
        at = path if problem.key == "waves" else (*path, problem.key)
        yield as_in_file(document, Finding(at, problem.found, problem.allowed))


def _current(document: dict[str, Any]) -> Iterator[Finding]:
    """Find keys that the profile lacks or that go with another, and a table out of order."""
    current = table(document, "current")
    profile: Any = current.get("profile")
    if profile not in CURRENT_PROFILES or misspelt(CurrentTable, entries(CurrentTable), current):
        return
    given = {key: value(CurrentTable, key, current) for key in entries(CurrentTable)}
    for key in ("depths", "speeds", "directions"):
        given[key] = tuple(given[key] or ())
    if any(key in current and given[key] in (None, ()) for key in given):
        return  # wrong in itself
    if "direction" in current and given["directions"]:
        given["direction"] = 1.0  # whatever it is, it is not read
    try:
        CurrentProfile(**{key: v for key, v in given.items() if v is not None})
    except InputError as error:
        for problem in error.problems:
            finding = Finding(("current", *parts(problem.key)), problem.found, problem.allowed)
            yield as_in_file(document, finding)


def _motion(document: dict[str, Any], section: str, schema: type[Table]) -> Iterator[Finding]:
    """Find any but exactly one way of moving, and keys that go with another."""
    motion = table(document, section)
    if section not in document or misspelt(schema, entries(schema), motion):
        return
    ways = {"period": 1.0, "file": "file", "rao_file": "file"}
    given: dict[str, Any] = {
        key: ways.get(key, 1.0) for key in entries(schema) if key in motion and key not in OF_A_BODY
    }
    try:
        Motion(**given)
    except InputError as error:
        for problem in error.problems:
            path: Path = (section, problem.key)
            allowed = problem.allowed
            if problem.key == "motion":
                known = [each for each in MOTION_WAYS if each in entries(schema)]
                path, allowed = (section,), f"exactly one of {', '.join(known)} is wanted"
            yield as_in_file(document, Finding(path, problem.found, allowed))


def _times(document: dict[str, Any]) -> Iterator[Finding]:
    """Find times of a run that do not fit into it."""
    dynamics = table(document, "dynamics")
    duration = number(DynamicsTable, "duration", dynamics)
    for key in ("ramp", "broken_at", "time_step", "output_interval"):
        time = number(DynamicsTable, key, dynamics)
        if time is not None and duration is not None and not time < duration:
            allowed = f"must be below {duration:g} s, the duration"
            yield Finding(("dynamics", key), as_written(dynamics[key]), allowed)


def _break(document: dict[str, Any]) -> Iterator[Finding]:
    """Find a line that breaks without a time, or the other way round, or that is not there."""
    dynamics, pair = table(document, "dynamics"), ("broken_line", "broken_at")
    if misspelt(DynamicsTable, pair, dynamics):
        return
    for key, other in (pair, pair[::-1]):
        if key in dynamics and other not in dynamics:
            allowed = "missing; broken_line and broken_at go together"
            yield Finding(("dynamics", other), "", allowed)
    if "broken_end" in dynamics and not {*pair} & set(dynamics):
        allowed = "missing; broken_end needs it, and broken_at"
        yield Finding(("dynamics", "broken_line"), "", allowed)
    azimuths: Any = table(document, "system").get("azimuths")
    lines = len(azimuths) if isinstance(azimuths, list) else 0 if "system" in document else 1
    line = value(DynamicsTable, "broken_line", dynamics)
    if lines and line is not None and line > lines:
        allowed = f"there are {lines} lines" if lines > 1 else "there is one line"
        yield Finding(("dynamics", "broken_line"), as_written(line), allowed)
