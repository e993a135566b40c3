"""What a factor is made for: the state of a mooring and the analysis of its tensions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

State = Literal["intact", "one_line_out", "transient"]
STATES: tuple[State, ...] = get_args(State)
"""Whole, at rest anew without a line, and on the way there after it parted."""

Analysis = Literal["quasi-static", "dynamic"]
ANALYSES: tuple[Analysis, ...] = get_args(Analysis)
"""Tensions of lines at rest, or of lines run in time."""


@dataclass(frozen=True)
class Place:
    """Of which line a check is, and in which state of the mooring.

    Attributes
    ----------
    state : {"intact", "one_line_out", "transient"}
        Of the mooring.
    line : int or None
        Of a body with several lines, from 1; None where the check is of the body, or of a line by
        itself.
    missing : int or None
        The line that is gone, from 1.
    segment : int or None
        Of a tension: from 1 at the anchor.
    """

    state: State = "intact"
    line: int | None = None
    missing: int | None = None
    segment: int | None = None
