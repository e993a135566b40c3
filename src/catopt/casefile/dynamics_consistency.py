"""What must hold between the keys that are for a line in motion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from catopt.casefile.document import as_in_file, misspelt, number, table, value
from catopt.casefile.location import Finding, parts
from catopt.casefile.schema import (
    CaseTable,
    CurrentTable,
    DynamicsTable,
    MotionTable,
    entries,
)
from catopt.errors import InputError
from catopt.model import CurrentProfile, Motion
from catopt.model.current_profile import CURRENT_PROFILES
from catopt.model.dynamics import dynamics_misfits
from catopt.model.wave_state import WAVE_SPECTRA
from catopt.units import as_written

__all__ = ["dynamics_findings"]

_SECTIONS = ("waves", "current", "motion", "dynamics", "system")


def dynamics_findings(document: dict[str, Any]) -> list[Finding]:
    """List what contradicts itself in waves, current, motion and settings of a run.

    Parameters
    ----------
    document : dict
        As the TOML reader returns it.
    """
    return [
        *_together(document),
        *_waves(document),
        *_current(document),
        *_motion(document),
        *_times(document),
    ]


def _together(document: dict[str, Any]) -> Iterator[Finding]:
    """Find sections without the one that reads them, as the model has it."""
    if misspelt(CaseTable, _SECTIONS, document):
        return
    present = [key for key in _SECTIONS if key in document]
    for problem in dynamics_misfits(present, has_raos="rao_file" in table(document, "motion")):
        yield as_in_file(document, Finding(parts(problem.key), problem.found, problem.allowed))


def _waves(document: dict[str, Any]) -> Iterator[Finding]:
    waves = table(document, "waves")
    spectrum: Any = waves.get("spectrum")
    if "peak_enhancement" in waves and spectrum in WAVE_SPECTRA and spectrum != "jonswap":
        allowed = f"goes with jonswap, not with {spectrum}; leave it out"
        found = as_written(waves["peak_enhancement"])
        yield Finding(("waves", "peak_enhancement"), found, allowed)


def _current(document: dict[str, Any]) -> Iterator[Finding]:
    """Find keys that the profile lacks or that go with another, and a table out of order."""
    current = table(document, "current")
    profile: Any = current.get("profile")
    if profile not in CURRENT_PROFILES or misspelt(CurrentTable, entries(CurrentTable), current):
        return
    given = {key: value(CurrentTable, key, current) for key in entries(CurrentTable)}
    for key in ("depths", "speeds"):
        given[key] = tuple(given[key] or ())
    if any(key in current and given[key] in (None, ()) for key in given):
        return  # wrong in itself
    try:
        CurrentProfile(**{key: v for key, v in given.items() if v is not None})
    except InputError as error:
        for problem in error.problems:
            finding = Finding(("current", *parts(problem.key)), problem.found, problem.allowed)
            yield as_in_file(document, finding)


def _motion(document: dict[str, Any]) -> Iterator[Finding]:
    """Find any but exactly one way of moving, and keys that go with another."""
    motion = table(document, "motion")
    if "motion" not in document or misspelt(MotionTable, entries(MotionTable), motion):
        return
    ways = {"period": 1.0, "file": "file", "rao_file": "file"}
    given: dict[str, Any] = {
        key: ways.get(key, 1.0) for key in entries(MotionTable) if key in motion
    }
    try:
        Motion(**given)
    except InputError as error:
        for problem in error.problems:
            path = ("motion",) if problem.key == "motion" else ("motion", problem.key)
            yield as_in_file(document, Finding(path, problem.found, problem.allowed))


def _times(document: dict[str, Any]) -> Iterator[Finding]:
    """Find times of a run that do not fit into it."""
    dynamics = table(document, "dynamics")
    duration = number(DynamicsTable, "duration", dynamics)
    for key in ("ramp", "time_step", "output_interval"):
        time = number(DynamicsTable, key, dynamics)
        if time is not None and duration is not None and not time < duration:
            allowed = f"must be below {duration:g} s, the duration"
            yield Finding(("dynamics", key), as_written(dynamics[key]), allowed)
