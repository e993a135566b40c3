"""Fatigue of a line: the sea states of a year, the curves of its segments and the factor."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Final

from catopt.errors import Problem
from catopt.model.kinds import (
    Angle,
    Checked,
    Factor,
    File,
    Findings,
    Length,
    Measured,
    OneOf,
    OneSegment,
    Positive,
    Share,
    Time,
)
from catopt.units import Dimension
from catopt.words import Message

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
class FatigueSeaState(Checked):
    """Waves that last a part of the year."""

    height: Length
    """Significant, m; of regular waves their own, as the period."""
    period: Time
    """Of the peak, s."""
    share: Share
    """Part of the year."""
    direction: Angle | None = None
    """Where they travel to, rad; None: as the waves of the case."""


@dataclass(frozen=True)
class SegmentCurve(Checked):
    """Curve of a segment, in place of that which the code has for its component.

    By name, or N = 10^log_a_D s^-m with the stress range s in MPa, or N = K R^-M with R the tension
    range over the reference strength.
    """

    segment: OneSegment | None = None
    """From 1 at the anchor; None: of every one that is not named."""
    name: Annotated[str, OneOf(CURVE_NAMES, quoted=True)] = ""
    """A key of the table of curves; empty where the numbers are given."""
    log_a_D: Annotated[float, Measured(Dimension.NUMBER, above=0.0, example="10.78")] | None = None
    m: Positive | None = None
    K: Annotated[float, Measured(Dimension.NUMBER, above=0.0, example="316")] | None = None
    M: Positive | None = None

    def _check(self, found: Findings) -> None:
        found.check()
        found.problems += curve_misfits([key for way in _WAYS for key in way if getattr(self, key)])


@dataclass(frozen=True)
class Fatigue(Checked):
    """What the damage of a line in motion is found from."""

    sea_states: tuple[FatigueSeaState, ...] = ()
    """Each is run as the case's waves are."""
    sea_states_file: Annotated[str, File(example='"sea-states.csv"')] = ""
    """Path of a CSV file with them instead; empty when not used."""
    code: Annotated[str, OneOf(FATIGUE_CODES, quoted=True)] = ""
    """It has curves and a design factor; empty: all is given."""
    design_factor: Factor | None = None
    """By which the damage in the service life is multiplied; None: the code's."""
    curves: tuple[SegmentCurve, ...] = ()
    """Of segments, in place of the code's."""

    def _check(self, found: Findings) -> None:
        found.check()
        given = ("sea_states", "sea_states_file", "code", "design_factor", "curves")
        found.problems += fatigue_misfits([key for key in given if getattr(self, key)])
        found.problems += share_misfits([state.share for state in self.sea_states])


def share_misfits(shares: Sequence[float]) -> list[Problem]:
    """List what is wrong in the parts of a year that sea states last: more than all of it."""
    if sum(shares) <= 1.0 + _ROUNDING:
        return []
    allowed = Message("refused_case.shares_add_up_more_than")
    return [Problem("sea_states", f"{sum(shares):.6g}", allowed)]


def curve_misfits(given: Collection[str]) -> list[Problem]:
    """List any but exactly one way of giving a curve: a name, log_a_D with m, or K with M."""
    if set(given) - {"segment"} in [set(way) for way in _WAYS]:
        return []
    found = " and ".join(key for key in given if key != "segment") or "none of them"
    return [Problem("", found, Message("refused_case.exactly_one_name_log_d"))]


def fatigue_misfits(given: Collection[str]) -> list[Problem]:
    """List what is missing or double in what is given of `Fatigue`."""
    problems = []
    states = [key for key in ("sea_states", "sea_states_file") if key in given]
    if len(states) != 1:
        found = " and ".join(states) or "none of them"
        allowed = Message("refused_case.exactly_one_sea_states_sea")
        problems.append(Problem("", found, allowed))
    if "code" not in given:
        problems += [
            Problem(
                key,
                "",
                Message(
                    "refused_case.missing_give_or_code_one", fatigue_codes=", ".join(FATIGUE_CODES)
                ),
            )
            for key in ("design_factor", "curves")
            if key not in given
        ]
    return problems


def sections_misfits(
    present: Collection[str], waves: Mapping[str, Any], curves: Sequence[int | None], segments: int
) -> list[Problem]:
    """List what fatigue needs of other sections, and curves of segments that are not there.

    Of the sections that a case has, of what is given of its waves, of the segment of each curve,
    and of how many segments the line has; 0: not known.
    """
    problems = []
    for section, why in (
        ("dynamics", "run_in_time"),
        ("waves", "sea_states_in_place"),
        ("service", "has_the_life"),
    ):
        if section not in present:
            problems.append(
                Problem(
                    "fatigue",
                    "",
                    Message(
                        "refused_case.needs_which_missing",
                        section=section,
                        why=Message(f"refused_case.{why}"),
                    ),
                )
            )
    if "waves" in present and "spectrum" not in waves:
        allowed = Message("refused_case.fatigue_needs_waves_one_spectrum")
        problems.append(Problem("waves", Message("refused_file.no_spectrum"), allowed))
    for index, segment in enumerate(curves):
        key = f"fatigue.curves[{index}].segment"
        if segment in curves[:index]:
            problems.append(
                Problem(key, f"{segment or ''}", Message("refused_case.another_curve_same"))
            )
        elif segment is not None and segments and segment > segments:
            problems.append(
                Problem(key, f"{segment}", Message("refused_case.line_has", segments=segments))
            )
    return problems
