"""What else a note shows of its line, as parts of the document catopt.report/1."""

from __future__ import annotations

from typing import Any

from catopt.report.page.note import Note

__all__ = ["motion_document", "swarm_document"]


def swarm_document(note: Note) -> dict[str, Any] | None:
    """Say what came of the particle swarm, in SI; None where nobody asked for it.

    Parameters
    ----------
    note : Note
        Of one line.
    """
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


def motion_document(note: Note) -> dict[str, Any] | None:
    """Say what came of the line in motion in the load case shown; None where nobody asked for it.

    Parameters
    ----------
    note : Note
        Of one line.
    """
    moved = note.motion
    if moved is None:
        return None
    index = moved.governing
    part = moved.found.parts[index]
    fairlead = part.of("fairlead_tension")
    return {
        "load_case": part.name,
        "runs": len(part.runs),
        "max_tension_N": part.max_tension,
        "max_fairlead_tension_N": fairlead.maximum,
        "most_probable_max_N": fairlead.most_probable_maximum,
        "amplification": part.amplification,
        "slack_time_s": part.slack_time,
        "utilisation": moved.used(index),
    }
