"""What else a note shows of its line, as parts of the document catopt.report/1."""

from __future__ import annotations

from typing import Any

from catopt.notes.line import Note
from catopt.notes.motion import InMotion
from catopt.notes.system import SystemNote


def swarm_document(note: Note) -> dict[str, Any] | None:
    """Say what came of the particle swarm, in SI; None where nobody asked for it."""
    report = None if note.swarm is None else note.swarm.swarm
    if report is None:
        return None
    return {
        "objective": report.objective,
        "evaluations": report.evaluations,
        "runs": report.runs,
        "converged_runs": report.converged_runs,
        "closed_form_difference": dict(report.closed_form_difference),
    }


def motion_document(note: Note | SystemNote) -> dict[str, Any] | None:
    """Say what came of the line in motion that governs; None where nobody asked for it."""
    moved = note.motion
    if moved is None:
        return None
    if isinstance(moved, InMotion):
        part, used = moved.found.parts[moved.governing], moved.used(moved.governing)
    else:
        part, used = moved.governing, None
    fairlead = part.of("fairlead_tension")
    extreme = None if fairlead.tail is None else fairlead.tail.extreme
    return {
        "load_case": part.name,
        "line": part.line,
        "runs": len(part.runs),
        "max_tension_N": part.max_tension,
        "max_fairlead_tension_N": fairlead.maximum,
        "most_probable_max_N": fairlead.most_probable_maximum,
        "duration_of_interest_s": part.duration_of_interest,
        "most_probable_low_N": None if extreme is None else extreme.low,
        "most_probable_high_N": None if extreme is None else extreme.high,
        "amplification": part.amplification,
        "slack_time_s": part.slack_time,
        "utilisation": used,
    }
