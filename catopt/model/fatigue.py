"""Fatigue of a line: the sea states of a year, the curves of its segments and the factor."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from catopt.errors import Problem
from catopt.model.validity import Findings

FATIGUE_CODES: Final = ("DNV-OS-E301-2008", "API-RP-2SK")
"""Codes of which catopt has curves."""

CURVE_NAMES: Final = (
    "E301 stud",
    "E301 studless",
    "E301 six-strand",
    "E301 spiral",
    "E301 polyester",
    "API stud",
    "API studless",
    "API six-strand",
    "API spiral",
)
"""Curves that `catopt.checks.fatigue` has."""

_ROUNDING = 1e-6
"""By which shares that were rounded may exceed the whole year."""

_WAYS: Final = (("name",), ("log_a_D", "m"), ("K", "M"))


@dataclass(frozen=True)
class FatigueSeaState:
    """Waves that last a part of the year.

    Attributes
    ----------
    height, period : float
        Significant height and peak period, m and s; of regular waves their own.
    share : float
        Part of the year.
    direction : float or None
        Where they travel to, rad; None: as the waves of the case.
    """

    height: float
    period: float
    share: float
    direction: float | None = None

    def __post_init__(self) -> None:
        found = Findings("FatigueSeaState", self)
        found.number("height", self.height, "m", above=0.0)
        found.number("period", self.period, "s", above=0.0)
        found.number("share", self.share, "", at_least=0.0, at_most=1.0)
        if self.direction is not None:
            found.number("direction", self.direction, "rad")
        found.raise_if_any()


@dataclass(frozen=True)
class SegmentCurve:
    """Curve of a segment, in place of that which the code has for its component.

    Attributes
    ----------
    segment : int or None
        From 1 at the anchor; None: of every one that is not named.
    name : str
        A key of the table of curves; empty where the numbers are given.
    log_a_D, m : float or None
        N = 10^log_a_D s^-m with the stress range s in MPa.
    K, M : float or None
        N = K R^-M with R the tension range over the reference strength.
    """

    segment: int | None = None
    name: str = ""
    log_a_D: float | None = None
    m: float | None = None
    K: float | None = None
    M: float | None = None

    def __post_init__(self) -> None:
        found = Findings("SegmentCurve", self)
        if self.segment is not None:
            found.count("segment", self.segment)
        if self.name and self.name not in CURVE_NAMES:
            found.add("name", f'"{self.name}"', "one of " + ", ".join(CURVE_NAMES))
        for key in ("log_a_D", "m", "K", "M"):
            if getattr(self, key) is not None:
                found.number(key, getattr(self, key), "", above=0.0)
        found.problems += curve_misfits([key for way in _WAYS for key in way if getattr(self, key)])
        found.raise_if_any()


@dataclass(frozen=True)
class Fatigue:
    """What the damage of a line in motion is found from.

    Attributes
    ----------
    sea_states : tuple of FatigueSeaState
        Each is run as the case's waves are.
    sea_states_file : str
        Path of a CSV file with them instead; empty when not used.
    code : str
        One of `FATIGUE_CODES`, which has curves and a design factor; empty: all is given.
    design_factor : float or None
        By which the damage in the service life is multiplied; None: the code's.
    curves : tuple of SegmentCurve
        Of segments, in place of the code's.
    """

    sea_states: tuple[FatigueSeaState, ...] = ()
    sea_states_file: str = ""
    code: str = ""
    design_factor: float | None = None
    curves: tuple[SegmentCurve, ...] = ()

    def __post_init__(self) -> None:
        found = Findings("Fatigue", self)
        if self.code and self.code not in FATIGUE_CODES:
            found.add("code", f'"{self.code}"', "one of " + ", ".join(FATIGUE_CODES))
        if self.design_factor is not None:
            found.number("design_factor", self.design_factor, "", at_least=1.0)
        given = ("sea_states", "sea_states_file", "code", "design_factor", "curves")
        found.problems += fatigue_misfits([key for key in given if getattr(self, key)])
        found.problems += share_misfits([state.share for state in self.sea_states])
        found.raise_if_any()


def share_misfits(shares: Sequence[float]) -> list[Problem]:
    """List what is wrong in the parts of a year that sea states last: more than all of it."""
    if sum(shares) <= 1.0 + _ROUNDING:
        return []
    allowed = "the shares add up to more than 1, the whole year; lower them"
    return [Problem("sea_states", f"{sum(shares):.6g}", allowed)]


def curve_misfits(given: Collection[str]) -> list[Problem]:
    """List any but exactly one way of giving a curve: a name, log_a_D with m, or K with M."""
    if set(given) - {"segment"} in [set(way) for way in _WAYS]:
        return []
    found = " and ".join(key for key in given if key != "segment") or "none of them"
    return [Problem("", found, "exactly one of name, log_a_D with m, K with M is wanted")]


def fatigue_misfits(given: Collection[str]) -> list[Problem]:
    """List what is missing or double in what is given of `Fatigue`."""
    problems = []
    states = [key for key in ("sea_states", "sea_states_file") if key in given]
    if len(states) != 1:
        found = " and ".join(states) or "none of them"
        allowed = "exactly one of sea_states, sea_states_file is wanted"
        problems.append(Problem("", found, allowed))
    if "code" not in given:
        problems += [
            Problem(key, "", f"missing; give it, or a code: one of {', '.join(FATIGUE_CODES)}")
            for key in ("design_factor", "curves")
            if key not in given
        ]
    return problems


def sections_misfits(
    present: Collection[str], waves: Mapping[str, Any], curves: Sequence[int | None], segments: int
) -> list[Problem]:
    """List what fatigue needs of other sections, and curves of segments that are not there.

    Parameters
    ----------
    present : collection of str
        Which sections a case has.
    waves : mapping
        What is given of its waves.
    curves : sequence of int or None
        Segment of each curve.
    segments : int
        How many the line has; 0: not known.
    """
    problems = []
    for section, why in (
        ("dynamics", "the line is run in time"),
        ("waves", "the sea states take the place of their height and period"),
        ("service", "it has the life"),
    ):
        if section not in present:
            problems.append(Problem("fatigue", "", f"needs [{section}], which is missing: {why}"))
    if "waves" in present and "spectrum" not in waves:
        allowed = "[fatigue] needs waves of one spectrum, whose height and period a sea state gives"
        problems.append(Problem("waves", "no spectrum", allowed))
    for index, segment in enumerate(curves):
        key = f"fatigue.curves[{index}].segment"
        if segment in curves[:index]:
            problems.append(Problem(key, f"{segment or ''}", "another curve is for the same"))
        elif segment is not None and segments and segment > segments:
            problems.append(Problem(key, f"{segment}", f"the line has {segments}"))
    return problems
