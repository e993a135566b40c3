"""What must hold between the keys of fatigue."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from catopt.casefile.document import as_in_file, misspelt, number, table, tables, value
from catopt.casefile.location import Finding, parts
from catopt.casefile.schema import (
    CaseTable,
    FatigueCurveTable,
    FatigueSeaStateTable,
    FatigueTable,
    WavesTable,
    entries,
)
from catopt.constants import YEAR
from catopt.documents import Path
from catopt.model.fatigue import curve_misfits, fatigue_misfits, sections_misfits, share_misfits

_NEEDED = ("dynamics", "waves", "service")


def fatigue_findings(document: dict[str, Any]) -> list[Finding]:
    """List what contradicts itself in fatigue, and what it lacks elsewhere.

    Parameters
    ----------
    document : dict
        As the TOML reader returns it.
    """
    fatigue = table(document, "fatigue")
    if "fatigue" not in document:
        return []
    curves = tables(fatigue, "fatigue", "curves")
    found = list(_shares(fatigue))
    if not misspelt(FatigueTable, entries(FatigueTable), fatigue):
        found += [
            Finding(_path("fatigue", each.key), each.found, each.allowed)
            for each in fatigue_misfits(list(fatigue))
        ]
    for path, curve in curves:
        if not misspelt(FatigueCurveTable, entries(FatigueCurveTable), curve):
            found += [Finding(path, p.found, p.allowed) for p in curve_misfits(list(curve))]
    waves = table(document, "waves")
    if misspelt(WavesTable, ["spectrum"], waves):
        waves = {"spectrum": True}
    if not misspelt(CaseTable, _NEEDED, document):
        segments = table(document, "line").get("segments")
        found += [
            as_in_file(document, Finding(parts(each.key), each.found, each.allowed))
            for each in sections_misfits(
                [key for key in _NEEDED if key in document],
                waves,
                [value(FatigueCurveTable, "segment", curve) for _, curve in curves],
                len(segments) if isinstance(segments, list) else 0,
            )
        ]
    return found


def _shares(fatigue: dict[str, Any]) -> Iterator[Finding]:
    """Find sea states without exactly one way of saying how long, and more than a year of them."""
    shares: list[float | None] = []
    for path, state in tables(fatigue, "fatigue", "sea_states"):
        given = [key for key in ("share", "time_per_year") if key in state]
        if len(given) != 1:
            if not misspelt(FatigueSeaStateTable, ("share", "time_per_year"), state):
                allowed = "exactly one of share, time_per_year is wanted"
                yield Finding(path, " and ".join(given) or "none of them", allowed)
            continue
        found = {key: number(FatigueSeaStateTable, key, state) for key in given}
        share = share_of_year(found)
        if share is not None and share > 1.0 and "time_per_year" in given:
            yield Finding((*path, *given), f"{share:.6g} years", "at most one year")
        shares.append(share)
    for problem in share_misfits([each for each in shares if each is not None]):
        yield Finding(("fatigue", "sea_states"), problem.found, problem.allowed)


def share_of_year(given: Mapping[Any, float | None]) -> float | None:
    """Part of the year by what a sea state gives."""
    time = given.get("time_per_year")
    return given.get("share") if time is None else time / YEAR


def _path(section: str, key: str) -> Path:
    return (section, key) if key else (section,)
