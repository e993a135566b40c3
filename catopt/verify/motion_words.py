"""What is said of the two models at rest, and of a line in motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from catopt.quantities import QUANTITIES, Quantity
from catopt.units import lasting
from catopt.verify.comparison import ORDER, ROUNDING
from catopt.verify.convergence_check import LIMIT, OF_MBL, Change
from catopt.words import Listed, Measure, Message, Several

if TYPE_CHECKING:
    from catopt.fem import Extreme
    from catopt.verify.comparison import Compared
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.result import StaticComparison


def named(key: str, name: str, symbol: str | None = None) -> Quantity:
    """Return a quantity under another name, and symbol where one is given."""
    of = QUANTITIES[key]
    return replace(of, name=name, symbol=of.symbol if symbol is None else symbol)


QUANTITY_OF: Mapping[str, Quantity] = MappingProxyType(
    {
        "span": QUANTITIES["span"],
        "horizontal_force": QUANTITIES["horizontal_force"],
        "fairlead_tension": named("tension", "Fairlead tension"),
        "fairlead_vertical_force": named("vertical_force", "Fairlead vertical force"),
        "fairlead_angle": named("angle", "Fairlead inclination", ""),
        "anchor_tension": named("tension", "Anchor tension", "TA"),
        "anchor_vertical_force": named("vertical_force", "Anchor vertical force", "VA"),
        "anchor_angle": named("angle", "Anchor inclination", ""),
        "grounded_length": QUANTITIES["grounded_length"],
        "shape": named("length", "Distance of the shapes", ""),
        "position_x": named("offset", "Position of the body", "x"),
        "position_y": named("offset", "Position of the body", "y"),
        "moment_of_lines": named("moment", "Moment of the lines", ""),
        "place_x": named("offset", "Position of the joint", "x"),
        "place_y": named("offset", "Position of the joint", "y"),
        "place_z": named("height", "Position of the joint", "z"),
        "from_tension": named("tension", "Tension, from", "T1"),
        "to_tension": named("tension", "Tension, to", "T2"),
    }
)
"""What each compared quantity is in tables."""

_SCALE_WORDS = {
    "N": "truss.of_the_tension",
    "m": "truss.of_the_length",
    "rad": "truss.of_a_rad",
    "Nm": "truss.of_moment",
}

_MOST_NAMED = 4
"""Quantities that a sentence names."""


def in_parts(value: float) -> str:
    """Write a difference over its scale; below the truss's own tolerance even a 0 is chance."""
    return f"{value:.1e}" if value >= ROUNDING else f"<{ROUNDING:.0e}"


def name_of(each: Compared, part: StaticComparison | None = None) -> Message:
    """Name a quantity, with its line in a system: ``"fairlead tension of line 2"``.

    `part`: of which it is, where lines may have names.
    """
    name = Message(f"truss.{each.quantity}")
    if each.point:
        return Message("truss.quantity_of_point", quantity=name, name=each.point)
    if each.line is None or each.quantity.startswith("position"):
        return name
    number = f"{each.line + 1}" if part is None else part.name_of_line(each.line)
    return Message("truss.quantity_of_line", quantity=name, number=number)


def gap_words(each: Compared) -> Message:
    """Say how large a gap is: ``"3.1e-09 of the tension"``."""
    gap = in_parts(each.gap)
    if each.theory != ORDER:
        # Of a slack line the scale may be that of a bar, over the tolerance.
        return Message("truss.of_its_scale", gap=gap)
    if each.quantity.startswith("position"):
        return Message("truss.of_the_offset", gap=gap)
    return Message(_SCALE_WORDS[each.unit], gap=gap)


def part_sentence(part: StaticComparison) -> Message:
    """Say what came of one load case."""
    worst = part.worst
    allowed = f"{part.tolerance:.0e}"
    if part.verdict == "agrees":
        reported = Message("truss.largest", quantity=name_of(worst, part), gap=gap_words(worst))
        if worst.gap < ROUNDING:
            reported = Message("truss.below_scale", limit=f"{ROUNDING:.0e}")
        return Message("truss.agree", largest=reported, allowed=allowed)
    others = [each for each in part.quantities if not each.agrees]
    differences = []
    for each in others[:_MOST_NAMED]:
        of = QUANTITY_OF[each.quantity]
        amount = Measure(of.key, each.difference, digits=of.digits + 1)
        values = {"quantity": name_of(each, part), "amount": amount, "gap": gap_words(each)}
        differences.append(Message("truss.differs_by", **values))
    if len(others) > _MOST_NAMED:
        differences.append(Message("truss.and_more", more=len(others) - _MOST_NAMED))
    key = "truss.not_resolved" if part.verdict == "not resolved" else "truss.differ"
    return Message(key, differences=Several(differences), allowed=allowed)


def rough_sentence(part: StaticComparison) -> str:
    """Name what does not close up smoothly; empty where everything does."""
    if not part.rough:
        return ""
    rough = (
        Message("truss.rough_quantity", quantity=name_of(each, part), order=each.order)
        for each in part.rough[:_MOST_NAMED]
    )
    reported: Message = Several(rough, ", ")
    if len(part.rough) > _MOST_NAMED:
        more = len(part.rough) - _MOST_NAMED
        reported = Message("truss.rough_more", quantities=reported, more=more)
    return Message("truss.rough", quantities=reported)


DYNAMIC_QUANTITY_OF: Mapping[str, Quantity] = MappingProxyType(
    {
        **QUANTITY_OF,
        "offset": named("offset", "Fairlead offset"),
        "body_x": named("offset", "Body x", ""),
        "body_y": named("offset", "Body y", ""),
        "body_offset": named("offset", "Body's way from rest", ""),
        "floater_x": named("offset", "Floater's way along x", ""),
        "floater_y": named("offset", "Floater's way along y", ""),
        "floater_z": named("offset", "Floater's centre over still water", ""),
        "floater_roll": named("angle", "Floater's roll", ""),
        "floater_pitch": named("angle", "Floater's pitch", ""),
        "floater_yaw": named("angle", "Floater's yaw", ""),
        "floater_wet": Quantity("part", "Part of the buoy under water", "", "", "-", 1.0, 2),
    }
)
"""What each quantity of a line in motion is in tables."""

SLACK_PEAK: Final = 8.0
"""Per cent by which the measured peaks of the only chain that goes slack are above ours
(tests/fem/test_dyn_published.py)."""

_NOT_CONVERGED = (
    "motion.no_answer_again",
    "motion.changes",
    "motion.changes_beyond_chance",
    "motion.minutes_beyond_chance",
    "motion.undecided",
    "motion.scattered",
    "motion.too_numerical",
)
"""Keys of what is wrong."""


def dynamic_sentences(part: DynamicPart) -> list[str]:
    """Say what the motion does to the line, and how far that hangs on step and bars."""
    return [*motion_sentences(part), *proof_sentences(part)]


def motion_sentences(part: DynamicPart) -> list[str]:
    """Say what the motion does to the line: amplification, most probable maximum, slack."""
    reached = Measure("tension", part.of("fairlead_tension").maximum)
    reported = Message("motion.reaches", tension=reached)
    if part.dynamic_amplification is not None and part.quasi_static_max is not None:
        still = Measure("tension", part.quasi_static_max)
        values = {"tension": reached, "times": part.dynamic_amplification, "still": still}
        reported = Message("motion.reaches_times", **values)
    slack = [Message("motion.no_slack")]
    if part.slack_time > 0.0:
        slack = [
            Message("motion.goes_slack", time=part.slack_time, longest=part.longest_slack),
            Message("motion.slack_measured", share=SLACK_PEAK),
        ]
    sentences = [reported, *_extremes(part), *slack, *_by_damping(part)]
    if part.anchor_at_rest:
        at_rest = {state: Measure("tension", N) for state, N in part.anchor_at_rest.items()}
        sentences.append(Message("motion.friction_at_rest", **at_rest))
    return sentences


def _by_damping(part: DynamicPart) -> Iterator[str]:
    """Say what of a line that snaps hangs on its damping."""
    fairlead, anchor = (part.damping_range(f"{end}_tension") for end in ("fairlead", "anchor"))
    if fairlead is not None and anchor is not None:
        ends = (*fairlead, *anchor)
        keys = ("low", "high", "anchor_low", "anchor_high")
        tensions = {key: Measure("tension", N) for key, N in zip(keys, ends, strict=True)}
        yield Message("motion.by_damping", **tensions)


def _extremes(part: DynamicPart) -> Iterator[str]:
    """Say what the largest values are in the duration of interest, and how far that is known."""
    if not part.drive.is_random:
        yield Message("motion.not_random")
        error = part.scatter_of("fairlead_tension")
        if error is not None:
            peaks = part.cycle_peaks("fairlead_tension")
            values = {"mean": Measure("tension", peaks.mean()), "error": Measure("tension", error)}
            yield Message("motion.mean_peak", cycles=peaks.size, **values)
        return
    for each in part.quantities:
        quantity, tail, runs = DYNAMIC_QUANTITY_OF[each.quantity], each.tail, each.gumbel
        if not part.varies_at_random(each.quantity):
            continue
        what = Message(f"motion.of_{each.quantity}")
        if tail is None:
            yield Message("motion.few_peaks", what=what)
            continue
        yield Message(
            "motion.weibull",
            duration=lasting(tail.extreme.duration),
            what=what,
            interval=interval(quantity, tail.extreme),
            expected=Measure(quantity.key, tail.extreme.expected),
            count=len(tail.clusters),
            threshold=Measure(quantity.key, tail.threshold),
            time=lasting(tail.time),
        )
        judged = each.storm or tail.extreme
        if judged is not tail.extreme:
            yield Message("motion.by_minute", what=what, interval=interval(quantity, judged))
        if each.maximum > judged.most_probable:
            yield Message("motion.above_probable", largest=Measure(quantity.key, each.maximum))
        if runs is not None:
            found = interval(quantity, runs.extreme)
            yield Message("motion.gumbel", runs=runs.runs, interval=found)


def interval(quantity: Quantity, extreme: Extreme) -> Message:
    """Write a most probable maximum with its interval, in the unit of the field."""
    return Message(
        "motion.interval",
        value=Measure(quantity.key, extreme.most_probable),
        part=extreme.confidence,
        low=Measure(quantity.key, extreme.low),
        high=Measure(quantity.key, extreme.high),
    )


def _change_sentence(part: DynamicPart, worst: Change) -> Message:
    """Say how far the maxima moved in runs again, and whether that decides."""
    values = {"how": Message(f"motion.how_{worst.way}"), "change": worst.size, "limit": LIMIT}
    what = Message(f"motion.largest_{worst.quantity.removeprefix('largest_')}")
    said = Message("motion.converged", **values)
    if part.decides(worst):
        by_chance = worst.chance is not None and not part.governs
        key = "motion.changes_beyond_chance" if by_chance else "motion.changes"
        if worst.is_paired:
            key, values = "motion.minutes_beyond_chance", values | {"chance": worst.by_chance}
        said = Message(key, what=what, **values)
    elif part.undecided:
        said = Message("motion.undecided", names=Listed(part.undecided, "and"))
    elif part.is_scattered:
        error = max(part.scatter_of(f"{end}_tension") or 0.0 for end in ("fairlead", "anchor"))
        cycles = part.cycle_peaks("fairlead_tension").size
        said = Message("motion.scattered", error=Measure("tension", error), cycles=cycles)
    elif worst.size > LIMIT and worst.is_by_chance and worst.is_paired:
        key = "motion.minutes_too_few" if part.is_unclear else "motion.minutes_by_chance"
        said = Message(key, what=what, chance=worst.by_chance, **values)
    elif worst.size > LIMIT and worst.is_by_chance:
        said = Message("motion.converged_by_chance", what=what, **values)
    elif worst.size > LIMIT:
        said = Message("motion.converged_by_MBL", what=what, of_MBL=OF_MBL, **values)
    return said


def proof_sentences(part: DynamicPart) -> list[Message]:
    """Say how far the maxima hang on step and bars, and how much of the work is numerical."""
    worst, failed, lost = part.worst_change, part.failure, part.numerical_part
    if failed is not None:
        said = Message("motion.no_answer_again", how=Message(f"motion.how_{failed.way}"))
    elif worst is None:
        said = Message("motion.not_proven")
    else:
        said = _change_sentence(part, worst)
    if lost > LIMIT:
        return [said, Message("motion.too_numerical", part=lost, limit=LIMIT)]
    return [said, Message("motion.numerical", part=lost)]


def doubts(part: DynamicPart) -> list[Message]:
    """Say what of a run has not converged, or is not proven."""
    doubtful = (*_NOT_CONVERGED, "motion.not_proven", "motion.minutes_too_few")
    return [each for each in proof_sentences(part) if each.key in doubtful]


def not_converged_sentence(found: DynamicVerification) -> Message:
    """Say which load case or line has not converged, and why."""
    part = found.least_proven
    why = next(each for each in proof_sentences(part) if each.key in _NOT_CONVERGED)
    return Message("motion.why_of", where=part.where, why=why)


def stopped_sentence(found: DynamicVerification) -> Message:
    """Say how far a run came that was stopped, and that it is kept."""
    return Several((stopped_words(found), Message("motion.kept")))


def stopped_words(found: DynamicVerification) -> Message:
    """Say how far a run came that was stopped."""
    dynamics, part = found.case.dynamics, found.parts[-1]
    assert dynamics is not None
    done, runs = len(part.runs), dynamics.runs
    if part.is_complete:
        return Message("motion.stopped_case", name=part.name, done=done, runs=runs)
    return Message(
        "motion.stopped_run",
        name=part.name,
        run=done,
        runs=runs,
        reached=float(part.runs[-1].history.time[-1]),
        duration=dynamics.duration,
    )
