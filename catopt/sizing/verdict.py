"""What a sizing comes to, in its own words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.checks.verdict import Judgement, Matter, Who, report_sentence, verdict_of
from catopt.loads.buoy import OURS
from catopt.words import Message, is_said

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult
    from catopt.sizing.result import Sizing


def judgement_of(of: Sizing, who: Who = "size") -> Judgement:
    """Say what the recommended line comes to, what governs, and what was not judged.

    The same words stand on the screen, in the note and in the document; on the page, which has no
    options, `who` is told otherwise what to type.
    """
    matter = Matter(
        case=of.whole_case,
        at_rest=of.point.checks,
        in_motion=None if of.in_motion is None else of.in_motion.checks,
        who=who,
        motion_by=_motion_by(of),
        moves=True,
        remarks=(*of.assumptions, *of.warnings),
        deck=_deck(of),
        no_way=("motion",) if of.afloat is None and of.ship_case is None else (),
    )
    return verdict_of(matter, _checks(of))


def _deck(of: Sizing) -> Message | None:
    """Say what a buoy's deck does under steady forces; of a large heel where nothing judges it."""
    if of.floats is None:
        return None
    moved = () if of.in_motion is None else of.in_motion.checks.results
    is_judged = any(each.kind == "heel" for each in moved)
    return of.floats.awash or (None if is_judged else of.floats.heeled)


def _motion_by(of: Sizing) -> str:
    """Say how it was judged in motion, where not by runs in full."""
    moved = of.in_motion
    if moved is None or not moved.how.quick:
        return ""
    return Message("sizing.quick_ship" if moved.is_of_ship else "sizing.quick_buoy")


def _checks(of: Sizing) -> Message:
    """Say what the checks come to and what governs; steady forces are said first."""
    moved = of.in_motion
    report = of.point.checks if moved is None else moved.checks
    said = report_sentence(report)
    if report.results and report.passes:
        is_worn = any(each.condition == "worn" for each in of.case.load_cases)
        by = None if moved is None else moved.case.checks.motion_code
        met = "sizing.all_met" if moved is None else "sizing.motion_met"
        said = Message(
            met if by is None else "sizing.motion_met_by_other",
            codes=_codes(of),
            **({} if by is None else {"code": by}),
            states=Message("sizing.new_and_worn" if is_worn else "sizing.as_new_alone"),
            governs=_governs(report.governing),
        )
    # Of the codes some have no allowance for motion, and say why: that is another thing.
    if of.dynamic_factor == 1.0 and is_said(of.motion, "sizing.factor_given"):
        said = Message("sizing.steady_first", verdict=said)
    return said


def _codes(of: Sizing) -> str:
    """Name the codes that are checked, and the method of the loads where it is not the code's."""
    codes = ", ".join(of.case.checks.codes)
    parts = (part for each in of.settled.posed.loads for part in each.parts)
    if any(each.method == OURS for each in parts):
        return Message("sizing.codes_under_own_loads", codes=codes, method=OURS)
    return codes


def _governs(check: CheckResult | None) -> str:
    """Name the check that governs, and how far it is used; empty where there is none."""
    if check is None:
        return ""
    name = Message(f"checks.{check.kind}_short")
    if check.place.missing is not None:
        name = Message("sizing.with_a_line_lost", check=name)
    if check.utilisation is None:
        return Message("sizing.governs", check=name)
    return Message("sizing.governs_at", check=name, percent=100.0 * check.utilisation)
