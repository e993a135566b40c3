"""How much a study asks for, before any of it is run."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter
from typing import Any

from catopt.study.run import compute_piece
from catopt.study.study import Piece, Study

_TIMED = 3
"""Members that are timed: the first, one in the middle, the last."""

_BYTES = 3
"""On disk beside a number in the store: its digits in the table of members."""


@dataclass(frozen=True, eq=False)
class Plan:
    """What a study asks for.

    Attributes
    ----------
    study : Study
        Which.
    timed : int
        Members that were computed to know it.
    seconds : float
        Processor time that all members take, by those.
    size : float
        Bytes that they take on disk.
    """

    study: Study
    timed: int
    seconds: float
    size: float

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt study --plan --json`` prints."""
        return {
            "schema": "catopt.study_plan/1",
            "title": self.study.title,
            "members": len(self.study),
            "timed": self.timed,
            "processor_time_s": self.seconds,
            "disk_bytes": self.size,
        }


def plan_study(study: Study) -> Plan:
    """Time a few members of a study; of those at rest, a whole piece after a first one."""
    kept = study.base.kept
    width = 8.0 * (len(kept) + len(study.keys)) * (1 + _BYTES)
    if study.base.compute == "statics":
        piece = study.piece(0)
        compute_piece(study.base, piece)
        began = perf_counter()
        compute_piece(study.base, piece)
        timed = len(piece)
    else:
        members = sorted({0, len(study) // 2, len(study) - 1})[:_TIMED]
        compute_piece(study.base, _alone(study, members[0]))
        began = perf_counter()
        for member in members:
            compute_piece(study.base, _alone(study, member))
        timed = len(members)
    seconds = (perf_counter() - began) / timed * len(study)
    return Plan(study, timed, seconds, width * len(study))


def _alone(study: Study, member: int) -> Piece:
    return Piece(0, member, study.values(member, member + 1))
