"""One member of a study: its file with its own values, and what is computed of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from catopt.casefile.reading import case_of
from catopt.checks.case import check_case
from catopt.errors import CatoptError, InputError
from catopt.model import Case
from catopt.sizing.file import SizingFile, file_of, sized
from catopt.study.base import Base
from catopt.study.keys import in_file, kind_of_key, with_changes
from catopt.ties import largest

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.sizing import Sizing

Values = dict[str, float | str]
"""What is kept of a member by name: numbers in SI, and texts."""

OfSizing = Callable[[int, Mapping[str, Any], "Sizing"], None]
"""Told the number of a member, from 0, its own values by key path, and its sizing."""


def read_member(base: Base, changes: Mapping[str, Any]) -> Case | SizingFile:
    """Read a member's file; InputError with all that is wrong in it.

    `changes`: its own values by key path, numbers in SI.
    """
    written = {key: in_file(kind_of_key(base, key), value) for key, value in changes.items()}
    document = with_changes(base, written)
    if base.moored is None:
        return case_of(document, base.source, folder=base.folder)
    return file_of(document, base.moored, base.source, folder=base.folder)


def compute_member(
    base: Base,
    changes: Mapping[str, Any],
    of_sizing: Callable[[Mapping[str, Any], Sizing], None] | None = None,
) -> Values:
    """Compute a member by itself; errors of the solver that it needs come through.

    `of_sizing` is told the sizing, where that is what is computed.
    """
    read = read_member(base, changes)
    if isinstance(read, SizingFile):
        found = sized(read)
        if of_sizing is not None:
            of_sizing(changes, found)
        return _of_sizing(found)
    if base.compute == "motion":
        return _in_motion(base, read)
    if base.compute == "linear":
        return _linear(read)
    report = check_case(read)
    failing = sum(not each.passes for each in report.results)
    return {**_of_checks(report), "failing": float(failing)}


def reason_of(error: CatoptError) -> str:
    """Say in a line why a member has no answer."""
    if isinstance(error, InputError):
        return "; ".join(str(problem) for problem in error.problems)
    return error.message


def _of_checks(report: CheckReport) -> Values:
    governing = report.governing
    if governing is None:
        return {}
    values: Values = {"governing": str(governing.in_case)}
    used = governing.utilisation
    return values if used is None else {"utilisation": used, **values}


def _in_motion(base: Base, case: Case) -> Values:
    from catopt.checks.criteria import criteria_of
    from catopt.notes.motion import checks_in_motion
    from catopt.verify.dynamic import verify_dynamic

    found = verify_dynamic(case, proof=base.proof, workers=1, compares_at_rest=False)
    if not found.is_complete:
        raise KeyboardInterrupt
    parts = found.parts
    worst = largest(parts, lambda part: part.of("fairlead_tension").maximum)
    tension = worst.of("fairlead_tension")
    values: Values = {
        "fairlead_tension": tension.maximum,
        "fairlead_mean": tension.mean,
        "fairlead_deviation": tension.std,
        "anchor_tension": max(part.of("anchor_tension").maximum for part in parts),
        "offset": max(part.of("offset").maximum for part in parts),
        "grounded_length": min(part.of("grounded_length").minimum for part in parts),
        "verdict": found.verdict,
    }
    changes = [part.worst_change.size for part in parts if part.worst_change is not None]
    if changes:
        values["change"] = max(changes)
    if any(each.check == "tension" for each in criteria_of(case, analysis="dynamic").all):
        used = [each.utilisation for each in checks_in_motion(found).results]
        values["utilisation"] = max(each for each in used if each is not None)
    return values


def _linear(case: Case) -> Values:
    from catopt.verify.linear import linear_lines

    lines = linear_lines(case)
    assert case.dynamics is not None
    storm = case.dynamics.duration_of_interest
    worst = largest(lines, lambda line: line.most_probable(storm))
    return {
        "fairlead_probable": worst.most_probable(storm),
        "fairlead_mean": worst.mean,
        "fairlead_deviation": worst.deviation,
        "zero_crossing_period": worst.period,
        "reserve": min(line.reserve for line in lines),
        "taut": "yes" if all(line.holds for line in lines) else "no",
    }


def _of_sizing(found: Sizing) -> Values:
    line = found.point.line
    values: Values = {
        "line": " + ".join(dict.fromkeys(each.name for each in line.segments)),
        "mass": found.point.objectives["mass_kg"],
        "line_length": line.length,
        "swing_radius": found.swing.total,
        **_of_checks(found.point.checks),
    }
    if found.sinker is not None:
        values |= {"holding": "sinker", "holding_mass": found.sinker.mass}
    elif found.drag_anchor is not None:
        values |= {"holding": found.drag_anchor.anchor, "holding_mass": found.drag_anchor.mass}
    return values
