"""How a line is run in time, in one sea or in those of a year for its fatigue."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Final, Literal, get_args

from catopt.errors import Problem
from catopt.model.kinds import (
    Angle,
    Checked,
    Duration,
    Factor,
    File,
    Findings,
    Length,
    Measured,
    NotNegative,
    OneOf,
    OneSegment,
    Positive,
    Share,
    Time,
    Whole,
)
from catopt.model.plausible_ranges import Plausible
from catopt.model.sea import OF_A_BODY, RAO_CONVENTIONS
from catopt.model.system import FLOATERS, floater_kind
from catopt.units import Dimension, as_written
from catopt.words import Message, given_keys

BedStiffness = Annotated[
    float, Measured(Dimension.PRESSURE, above=0.0, example='"30 kN/m^2"', si="N/m^2")
]
BedDamping = Annotated[float, Measured(Dimension.DAMPING_PER_LENGTH, at_least=0.0)]

BrokenEnd = Literal["fairlead", "anchor"]

BrokenBy = Literal["time", "MBL"]

TimeScheme = Literal["newmark", "generalised-alpha"]

InitialFriction = Literal["pulled", "none", "laid"]
INITIAL_FRICTION: tuple[str, ...] = get_args(InitialFriction)

JudgedBy = Literal["largest", "most-probable", "upper"]

FOR_MOTION = (
    *("waves", "current", "motion", "anchor_motion", "body", "floater", "dynamics", "system"),
)
"""Parts of a case that are for a line in motion, or that change what goes with them."""

BARS: Final = 100
"""Bars of a line unless said; damping is a part of what is critical for the line's hundredth."""

LINE_DAMPING: Final = 1.0
"""Part of critical: the bars of the default mesh do not swing. MoorDyn's manual (Troubleshooting)
recommends "approaching the critical value"; benchmarks/results/slack.md shows what the largest
tension of a line that snaps hangs on it."""


@dataclass(frozen=True)
class Dynamics(Plausible):
    """Settings of ``catopt verify --dynamic``."""

    duration: Annotated[float, Measured(Dimension.TIME, above=0.0, example='"20 min"')]
    """Of one run, the ramp included, s."""
    ramp: Duration | None = None
    """Over which motion and waves grow from nothing, s; statistics begin after it. None: a tenth of
    the duration."""
    time_step: Time | None = None
    """s; None: a sixtieth of the shortest period that drives the line."""
    output_interval: Time | None = None
    """From sample to sample, s, taken as the nearest whole number of steps; None: every step, and
    at most 20 000 samples."""
    elements: Annotated[int, Whole("elements", example=100)] | None = None
    """Bars of the line. None: `BARS`. Twice as many are taken where the line goes slack and its
    maxima change too much with twice the bars, unless cycles are counted."""
    scheme: TimeScheme = "generalised-alpha"
    """Newmark's average acceleration, or with damping of what is much faster than the step."""
    spectral_radius: Share = 0.5
    """Of generalised-alpha: what is left of such vibrations after a step."""
    runs: Annotated[int, Whole("runs", example=5)] = 1
    """Runs that differ in their seed."""
    seabed_stiffness: BedStiffness | None = None
    """Force per length of line and depth, N/m2; None: the line's weight presses it 1 cm deep."""
    seabed_damping: BedDamping | None = None
    """Force per length of line and speed, N s/m2; None: critical."""
    line_damping: NotNegative | None = None
    """Of the line itself: axial, as a part of what is critical for a bar of a hundredth of the
    line, L/100 sqrt(EA m), however many bars there are. None: `LINE_DAMPING`, and nothing beside a
    `damping_time` that is given."""
    damping_time: Duration = 0.0
    """Of the line itself: axial force per rate of strain, over EA, s. Both are added up."""
    broken_line: Annotated[int, Whole("broken_line", example=2)] | None = None
    """The line, from 1, that breaks."""
    broken_at: Time | None = None
    """When it does, s."""
    broken_end: BrokenEnd = "fairlead"
    """Where it does at that time: at its fairlead, or at its anchor, so that its lower end is
    free."""
    broken_by: BrokenBy = "time"
    """What breaks it: a time, or the first tension that reaches the MBL of its segment, there."""
    initial_friction: InitialFriction = "pulled"
    """The bed's at rest: of a line last pulled towards the fairlead (as at rest everywhere else),
    none, or of one laid under a greater tension and slackened since."""
    duration_of_interest: Annotated[float, Measured(Dimension.TIME, above=0.0, example='"3 h"')] = (
        10800.0
    )
    """Of the storm for which extremes of a random sea are given, s."""
    judged_by: JudgedBy = "largest"
    """What the checks are held against: the largest values of the runs, the most probable maxima
    of the storm, or the upper ends of their intervals; never less than the largest."""

    def _check(self, found: Findings) -> None:
        found.check("duration", "ramp", "time_step", "output_interval", "elements", "scheme")
        found.check("initial_friction", "broken_end", "spectral_radius", "runs", "judged_by")
        found.check("seabed_stiffness", "seabed_damping", "line_damping", "damping_time")
        found.check("broken_line", "broken_at", "broken_by")
        given = {key: getattr(self, key) for key in ("broken_line", "broken_at")}
        given = {key: value for key, value in given.items() if value is not None}
        given |= {"broken_end": self.broken_end} if self.broken_end != "fairlead" else {}
        given |= {"broken_by": self.broken_by} if self.broken_by != "time" else {}
        found.problems += break_misfits(given)
        found.check("duration_of_interest")
        if not found.problems:
            found.problems += time_misfits(vars(self))

    @property
    def bars(self) -> int:
        """Bars with which the line is run first."""
        return BARS if self.elements is None else self.elements

    @property
    def critical_ratio(self) -> float:
        """Part of critical damping, of a hundredth of the line, that the line is run with."""
        if self.line_damping is not None:
            return self.line_damping
        return 0.0 if self.damping_time > 0.0 else LINE_DAMPING


def time_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List times of a run, in s, that do not fit into it; one that is not given is None."""
    duration = given["duration"]
    return [
        Problem(key, f"{given[key]:g} s", Message("refused.below_duration", duration=duration))
        for key in ("ramp", "broken_at", "time_step", "output_interval")
        if given[key] is not None and not given[key] < duration
    ]


def break_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List what is missing where a line breaks: which one, or when; or what goes with a time."""
    by_MBL = given.get("broken_by") == "MBL"
    for key in ("broken_at", "broken_end") if by_MBL else ():
        if key in given:
            return [Problem(key, "", Message("refused_case.does_not_go_with_broken_by"))]
    if by_MBL and "broken_line" not in given:
        return [Problem("broken_line", "", Message("refused_case.missing_broken_line_broken_at"))]
    pairs = (("broken_line", "broken_at"), ("broken_at", "broken_line"))
    for key, other in () if by_MBL else pairs:
        if key in given and other not in given:
            return [Problem(other, "", Message("refused_case.missing_broken_line_broken_at"))]
    if "broken_end" in given and "broken_line" not in given:
        return [Problem("broken_line", "", Message("refused_case.missing_broken_end_needs_broken"))]
    return []


def strength_misfits(dynamics: Dynamics, segments: Sequence[float | None]) -> list[Problem]:
    """List segments without an MBL, of a line that breaks by it; given is the MBL of each."""
    if dynamics.broken_by != "MBL" or None not in segments:
        return []
    return [Problem("dynamics.broken_by", "MBL", Message("refused_case.broken_by_needs_MBL"))]


def broken_line_misfits(number: int | None, lines: int) -> list[Problem]:
    """List a line that breaks and is not one of so many."""
    if number is None or number <= lines:
        return []
    allowed = Message("refused_case.there_one_line")
    if lines > 1:
        allowed = Message("refused_case.there_are_lines", lines=lines)
    return [Problem("dynamics.broken_line", f"{number}", allowed)]


OF_MOTION: Final = (("checks", "motion_code"), ("anchor", "max_slide"))
"""Keys of other parts that lines in motion alone are judged by."""


def of_motion_misfits(of: object, allowed: Message) -> list[Problem]:
    """List what lines in motion alone are judged by and a case, or a network, at rest has."""
    given = {f"{part}.{key}": getattr(getattr(of, part), key, None) for part, key in OF_MOTION}
    return [Problem(k, as_written(v), allowed) for k, v in given.items() if v is not None]


def dynamics_misfits(present: Collection[str], given: Mapping[str, Any]) -> list[Problem]:
    """List what does not go together of the parts that are for lines in motion.

    Present are some of `FOR_MOTION`; given what motion, body and dynamics have, such as
    ``"motion.rao_file"``.
    """
    problems: list[Problem] = []
    if "dynamics" not in present:
        problems += [
            Problem(key, "", Message("refused.with_dynamics"))
            for key in ("waves", "current", "motion", "anchor_motion", "body", "floater")
            if key in present and {*present} != {"current"}  # alone it acts on one line at rest
        ]
    elif "system" in present:
        problems += _of_a_body(present, given)
    elif not {"motion", "waves", "anchor_motion"} & set(present):
        problems.append(Problem("dynamics", "", Message("refused.nothing_moves")))
    if "floater" in present:
        problems += _of_a_floater(present, given)
    if "system" not in present:
        keys = ["body"] if "body" in present else []
        keys += [f"motion.{key}" for key in OF_A_BODY if f"motion.{key}" in given]
        problems += [
            Problem(key, "", Message("refused_case.goes_with_system_which_missing")) for key in keys
        ]
    if "waves" not in present:
        for key, what in (
            ("motion.rao_file", "a ship's response"),
            ("body.wave_force", "a force of the waves"),
        ):
            if key in given:
                problems.append(Problem(key, "", Message("refused.needs_waves", what=what)))
    return problems


def network_motion_misfits(present: Collection[str], *, has_fairlead: bool) -> Iterator[Problem]:
    """Yield what does not go together of the parts that points and lines have for motion."""
    if "dynamics" not in present:
        yield from (Problem(key, "", Message("refused.with_dynamics")) for key in present)
    elif not {"motion", "waves"} & set(present):
        yield Problem("dynamics", "", Message("refused.nothing_moves"))
    if "motion" in present and not has_fairlead:
        yield Problem("motion", "", Message("refused_case.motion_wants_a_fairlead"))


def _of_a_floater(present: Collection[str], given: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield what does not go together with a buoy that floats at the end of its lines."""
    kind = FLOATERS[floater_kind([key.removeprefix("floater.") for key in given])]
    if kind.on_two_scales:
        yield from _of_a_ship(present, given)
        return
    for key in ("motion", "anchor_motion", "body"):
        if key in present:
            yield Problem(key, "", Message("refused_case.does_not_go_with_floater_too"))
    if "waves" not in present:
        yield Problem("waves", "", Message("refused_case.missing_nothing_moves_floater_but"))
    if kind.needs_system and "system" not in present:
        yield Problem("system", "", Message("refused_case.ship_needs_system"))


def _of_a_ship(present: Collection[str], given: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield what does not go together with a ship on its lines."""
    if "system" not in present:
        yield Problem("system", "", Message("refused_case.ship_needs_system"))
    if "waves" not in present:
        yield Problem("waves", "", Message("refused_case.missing_nothing_moves_floater_but"))
    if "body" in present:
        yield Problem("body", "", Message("refused_case.does_not_go_with_ship"))
    if "motion" in present and "motion.rao_file" not in given:
        yield Problem("motion", "", Message("refused_case.ship_motion_is_raos"))
    for key in ("motion.drift", "motion.drift_file"):
        if key in given:
            yield Problem(key, "", Message("refused_case.does_not_go_with_ship"))
    if given.get("dynamics.broken_end") == "anchor":
        yield Problem("dynamics.broken_end", "", Message("refused_case.does_not_go_with_ship"))


def _of_a_body(present: Collection[str], given: Collection[str]) -> Iterator[Problem]:
    """Yield what does not go together in how a body with several lines moves."""
    if "anchor_motion" in present:
        yield Problem("anchor_motion", "", Message("refused_case.does_not_go_with_system"))
    if "motion" in present and "body" in present:
        yield Problem("body", "", Message("refused_case.does_not_go_with_motion"))
    elif not {"motion", "body", "floater"} & set(present):
        yield Problem("dynamics", "", Message("refused_case.moored_body_motion_needs_motion"))
    elif "body" in present and "waves" not in present and "body.force_file" not in given:
        yield Problem("body", "", Message("refused_case.nothing_moves_force_file_or"))
    if "motion.drift_file" in given and "motion.file" in given:
        yield Problem("motion.drift_file", "", Message("refused_case.does_not_go_with_file"))
    has_raos = "motion.rao_file" in given
    for key in RAO_CONVENTIONS:
        if has_raos and f"motion.{key}" not in given:
            yield Problem(
                f"motion.{key}", "", Message("refused_case.missing_raos_body_mean_nothing")
            )
    for key in (*RAO_CONVENTIONS, "rao_crest"):
        if f"motion.{key}" in given and not has_raos:
            yield Problem(f"motion.{key}", "", Message("refused_case.goes_with_rao_file_which"))


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
class FatigueSeaState(Plausible):
    """Waves that last a part of the year."""

    TABLE: ClassVar[str] = "sea_states"

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
    found = given_keys(key for key in given if key != "segment")
    return [Problem("", found, Message("refused_case.exactly_one_name_log_d"))]


def fatigue_misfits(given: Collection[str]) -> list[Problem]:
    """List what is missing or double in what is given of `Fatigue`."""
    problems = []
    states = [key for key in ("sea_states", "sea_states_file") if key in given]
    if len(states) != 1:
        allowed = Message("refused_case.exactly_one_sea_states_sea")
        problems.append(Problem("", given_keys(states), allowed))
    if "code" not in given:
        codes = ", ".join(FATIGUE_CODES)
        allowed = Message("refused_case.missing_give_or_code_one", fatigue_codes=codes)
        lacks = (key for key in ("design_factor", "curves") if key not in given)
        problems += [Problem(key, "", allowed) for key in lacks]
    return problems


def fatigue_needs(case: Any, segments: int) -> list[Problem]:
    """List what the fatigue of a case, of so many segments in a line, lacks elsewhere."""
    if case.fatigue is None:
        return []
    return sections_misfits(
        [key for key in ("dynamics", "waves", "service") if getattr(case, key) is not None],
        {"spectrum": True} if case.waves and case.waves.spectrum else {},
        [curve.segment for curve in case.fatigue.curves],
        segments,
    )


def sections_misfits(
    present: Collection[str], waves: Mapping[str, Any], curves: Sequence[int | None], segments: int
) -> list[Problem]:
    """List what fatigue needs of other sections, and curves of segments that are not there.

    Of the sections that a case has, of what is given of its waves, of the segment of each curve,
    and of how many segments the line has; 0: not known.
    """
    found = Findings()
    for section, why in (
        ("dynamics", "run_in_time"),
        ("waves", "sea_states_in_place"),
        ("service", "has_the_life"),
    ):
        if section not in present:
            reason = Message(f"refused_case.{why}")
            allowed = Message("refused_case.needs_which_missing", section=section, why=reason)
            found.add("fatigue", "", allowed)
    if "waves" in present and "spectrum" not in waves:
        allowed = Message("refused_case.fatigue_needs_waves_one_spectrum")
        found.add("waves", Message("refused_file.no_spectrum"), allowed)
    for index, segment in enumerate(curves):
        key = f"fatigue.curves[{index}].segment"
        if segment in curves[:index]:
            found.add(key, f"{segment or ''}", Message("refused_case.another_curve_same"))
        elif segment is not None and segments and segment > segments:
            found.add(key, f"{segment}", Message("refused_case.line_has", segments=segments))
    return found.problems
