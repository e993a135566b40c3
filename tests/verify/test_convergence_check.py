"""Runs made again: what changes with the step and the bars, and what is said of it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from catopt.answers.motion import lines_of_body, motion_answer
from catopt.errors import NotConvergedError
from catopt.fem import run_dynamics
from catopt.model import (
    Case,
    Checks,
    Dynamics,
    Line,
    Load,
    Motion,
    Segment,
    Site,
    WaveState,
)
from catopt.render.card import card_lines
from catopt.verify import dynamic, dynamic_lines
from catopt.verify.convergence_check import LIMIT, Change, ConvergenceCheck
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
from catopt.verify.dynamic_setup import Excitation
from catopt.verify.motion_words import motion_sentences, proof_sentences
from catopt.verify.verdicts import beyond_MBL, with_verdicts

# 38 mm studless chain, to three digits, in 20 m of water.
CHAIN = Segment(
    60.0, 245.0, EA=1.23e8, mass=28.8, drag_diameter=0.038, drag_normal=2.4, drag_axial=0.4,
    added_mass_normal=1.0, added_mass_axial=0.5,
)  # fmt: skip


def case(force: float, motion: Motion, run: Dynamics) -> Case:
    return Case(
        site=Site(20.0, seabed_friction=0.5),
        line=Line([CHAIN]),
        load=Load(horizontal_force=force),
        fairlead_height=20.0,
        motion=motion,
        dynamics=run,
    )


TAUT = case(60e3, Motion(period=6.0, surge=0.1, heave=0.1), Dynamics(30.0, ramp=12.0, elements=30))
SNAPPING = case(20e3, Motion(period=6.0, heave=3.0), Dynamics(30.0, ramp=12.0, elements=8))


@cache
def proven(of: Case, convergence_check: ConvergenceCheck = "step") -> DynamicPart:
    (part,) = verify_dynamic(of, convergence_check=convergence_check).parts
    return part


def test_a_taut_line_is_run_again_at_half_the_step() -> None:
    part = proven(TAUT)
    assert part.verdict == "converged"
    (again,) = part.runs[0].again
    assert (again.way, again.elements) == ("step", 30)
    assert again.step == part.runs[0].history.step / 2.0
    assert {each.quantity for each in part.changes} == set(part.runs[0].maxima)
    # (2 pi/60)^2/12 of a period is what average acceleration is off by.
    assert all(each.size < 0.005 for each in part.changes)


def test_changes_are_those_of_a_run_with_that_step() -> None:
    """The same as a case that asks for half the step, but for the surprise allowed in each."""
    part = proven(TAUT)
    step = part.runs[0].history.step / 2.0
    of = replace(TAUT, dynamics=replace(TAUT.dynamics, time_step=step))  # type: ignore[type-var]
    assert proven(of, "none").runs[0].maxima == pytest.approx(part.runs[0].again[0].maxima)


def test_twice_the_bars_on_request_and_for_a_slack_line() -> None:
    assert [again.elements for again in proven(TAUT, "bars").runs[0].again] == [30, 60]
    assert [again.way for again in proven(SNAPPING).runs[0].again] == ["step", "bars"]


def test_too_few_bars_for_a_snap_have_not_converged() -> None:
    """4 bars of 15 m, given by the case, and then 8: two of them between surface and bed."""
    assert SNAPPING.dynamics is not None
    part = proven(replace(SNAPPING, dynamics=replace(SNAPPING.dynamics, elements=4)))
    assert part.elements == 8
    assert part.verdict == "not converged"
    worst = part.worst_change
    assert worst is not None
    assert worst.size > LIMIT
    said = "\n".join(proof_sentences(part))
    assert f"changes by {worst.size:.1%}, more than 5%" in said
    assert "A shorter time_step, more elements or more line_damping is required." in said


def test_run_once_proves_nothing_and_says_so() -> None:
    part = proven(TAUT, "none")
    assert part.runs[0].again == ()
    assert part.verdict == "not proven"
    assert part.change_of("fairlead_tension") is None
    assert proof_sentences(part)[0].startswith("NOT PROVEN: it was run once")


def test_a_run_again_that_fails_is_not_converged(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the base run is worth then is not known."""
    own = run_dynamics

    def fails(*args: object, **options: object) -> object:
        if args[1].step < 0.08:  # type: ignore[attr-defined]
            raise NotConvergedError("the step did not converge")
        return own(*args, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(dynamic_lines, "run_dynamics", fails)
    (part,) = verify_dynamic(TAUT).parts
    assert part.verdict == "not converged"
    assert part.failure is not None
    assert part.failure.failure == "the step did not converge"
    assert "run again at half the step, it has no solution" in proof_sentences(part)[0]


@pytest.mark.parametrize(
    ("given", "ratio", "time"),
    [
        ({}, 1.0, 0.0),
        ({"damping_time": 2e-4}, 0.0, 2e-4),
        ({"line_damping": 0.0}, 0.0, 0.0),
        ({"line_damping": 0.4, "damping_time": 1e-3}, 0.4, 1e-3),
    ],
)
def test_line_damping_is_critical_unless_something_is_said(
    given: dict[str, float], ratio: float, time: float
) -> None:
    of = replace(TAUT, dynamics=Dynamics(30.0, **given))  # type: ignore[arg-type]
    damping = Excitation(of).properties.damping
    assert (damping.critical_ratio, damping.stiffness_time) == (ratio, time)


def test_twice_the_bars_go_on_from_where_the_first_run_ended(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    part = proven(TAUT)  # before what runs it is put aside

    def run(*given: Any) -> list[DynamicPart]:
        tell = given[-1]
        for at in (0, 5, 10):
            tell(at, 10)
        return [part]

    monkeypatch.setattr(dynamic, "_parts", run)
    monkeypatch.setattr(dynamic, "_wants_more_bars", lambda _: True)
    of = replace(TAUT, dynamics=Dynamics(30.0, ramp=12.0))
    told: list[float] = []
    verify_dynamic(of, progress=lambda at, end: told.append(at / end))
    assert told == pytest.approx([0.0, 0.5, 1.0, 1 / 3, 2 / 3, 1.0])


def test_nothing_is_run_twice_where_all_is_run_anew_with_twice_the_bars(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The run with twice the bars is that at half the step of the next mesh, to the digit."""
    sixteen = Dynamics(30.0, ramp=12.0, elements=16)
    fresh = proven(replace(SNAPPING, dynamics=sixteen))
    own, made = dynamic._run, []

    def run(lines: Any, number: int, tell: Any, finer: int = 1, elements: int | None = None) -> Any:
        made.append((finer, elements))
        return own(lines, number, tell, finer, elements)

    monkeypatch.setattr(dynamic, "_run", run)
    monkeypatch.setattr(dynamic, "_wants_more_bars", lambda part: part.elements == 8)
    (part,) = verify_dynamic(SNAPPING).parts
    assert made == [(1, None), (2, 8), (2, 16), (1, None), (2, 32), (1, 16), (1, 16)]
    assert part.runs[0].again == fresh.runs[0].again
    assert part.runs[0].damped == fresh.runs[0].damped


def test_changes_by_step_and_bars_are_added() -> None:
    """Errors of step and bars add up, and halving shows three quarters of one that is a square."""
    part = proven(SNAPPING)
    found = {(each.quantity, each.way): each.size for each in part.changes}
    for quantity in part.runs[0].maxima:
        both = [found[quantity, way] for way in ("step", "bars") if (quantity, way) in found]
        if both:
            whole = 4.0 / 3.0 if len(both) == 2 else 1.0
            assert part.change_of(quantity) == pytest.approx(whole * sum(both))


@pytest.mark.parametrize(
    ("size", "amount", "MBL", "decides"),
    [
        (0.04, 90e3, 1000e3, False),  # 5 % of itself
        (0.40, 19e3, 1000e3, False),  # 2 % of the MBL
        (0.40, 21e3, 1000e3, True),
        (0.40, 19e3, None, True),  # none known, or a line that governs
    ],
)
def test_a_change_decides_beyond_5_percent_of_itself_and_2_of_the_MBL(
    size: float, amount: float, MBL: float | None, decides: bool
) -> None:
    assert Change("anchor_tension", "step", size, amount).decides(MBL) == decides
    if size > LIMIT:  # a length has no MBL
        assert Change("offset", "step", size, amount).decides(MBL)


@pytest.mark.parametrize(
    ("size", "amount", "governs", "decides"),
    [
        (0.20, 99e3, False, False),  # other seeds move it as far
        (0.20, 101e3, False, True),
        (0.03, 101e3, False, True),  # 5 % is no measure of what seeds do not explain
        (0.20, 99e3, True, True),  # the line that governs meets 5 % always
        (0.03, 101e3, True, False),
    ],
)
def test_a_most_probable_maximum_is_judged_by_its_interval_over_seeds(
    size: float, amount: float, governs: bool, decides: bool
) -> None:
    change = Change("fairlead_tension", "step", size, amount, chance=100e3)
    assert replace(proven(TAUT), governs=governs).decides(change) == decides
    assert change.decides(10_000e3) is False  # 2 % of the MBL


def test_the_interval_is_that_of_the_runs_as_they_were_asked_for() -> None:
    """Half of what is printed for the seeds; in periodic motion, and for lengths, there is none."""
    sea = WaveState("jonswap", 2.0, 6.0, components=20)
    case = replace(TAUT, motion=None, waves=sea, dynamics=Dynamics(200.0, ramp=10.0, time_step=0.2))
    (part,) = verify_dynamic(case).parts
    tail = part.of("fairlead_tension").tail
    assert tail is not None
    found = {each.quantity: each for each in part.changes}
    half = 0.5 * (tail.extreme.high - tail.extreme.low)
    assert found["fairlead_tension"].chance == pytest.approx(half)
    assert found["grounded_length"].chance is None
    assert all(each.chance is None for each in proven(TAUT).changes)


def test_a_check_that_turns_out_otherwise_is_never_passed_over() -> None:
    """A strength that lies between the maxima of two runs: one passes, and the other does not."""
    plain = proven(TAUT)
    (again,) = plain.runs[0].again
    both = sorted(each["largest_tension"] for each in (plain.runs[0].maxima, again.maxima))
    assert both[0] < both[1]
    line = Line([replace(CHAIN, MBL=2.0 * 0.5 * sum(both), proof_load=1e9)])
    factors = Checks(safety_factor=2.0, proof_load_factor=1.0)  # the second passes both times
    (part,) = verify_dynamic(replace(TAUT, line=line, checks=factors)).parts
    assert all(not part.decides(each) for each in part.added_changes)
    assert part.undecided
    assert part.verdict == "not converged"
    assert "change their verdict" in proof_sentences(part)[0]


def test_a_snapping_line_is_run_with_half_and_twice_its_damping() -> None:
    part = proven(SNAPPING)
    (one,) = part.runs
    assert [each.factor for each in one.damped] == [0.5, 2.0]
    low, high = part.damping_range("fairlead_tension") or (0.0, 0.0)
    found = [one.maxima, *(each.maxima for each in one.damped)]
    assert low == min(each["fairlead_tension"] for each in found)
    assert high == max(each["fairlead_tension"] for each in found)
    told = " ".join(motion_sentences(part))
    assert "With half and twice its damping" in told
    assert "(Lindahl, 1984) the largest tension is 8 % above catopt's" in told
    assert "Lindahl" not in " ".join(motion_sentences(proven(TAUT)))
    assert proven(TAUT).damping_range("fairlead_tension") is None


def strong(MBL: float) -> DynamicVerification:
    """Take the taut line's runs as those of another breaking load; no check is asked."""
    found = verify_dynamic(TAUT, convergence_check="none")
    (part,) = found.parts
    line = replace(TAUT, line=Line([replace(CHAIN, MBL=MBL)]))
    drive = replace(part.drive, case=line)
    part = replace(part, drive=drive, own_line=line.line)
    return replace(found, case=line, parts=tuple(with_verdicts(line, [part])))


def test_a_tension_beyond_the_MBL_is_said_first_though_no_check_is_asked() -> None:
    reached = strong(1.0).parts[0].max_tension
    for times, is_said in ((0.999, True), (1.001, False)):
        found = strong(times * reached)
        beyond = beyond_MBL(found.parts[0])
        assert (beyond is not None) is is_said
        if beyond is not None:
            assert beyond == (1, reached, times * reached)
        answer = motion_answer(found)
        screen = "\n".join(line.text for line in card_lines(answer))
        assert ("THE TENSION EXCEEDS THE MBL" in screen) is is_said


def test_of_a_body_s_lines_both_ends_show_what_hangs_on_damping() -> None:
    """A row each; a line that does not snap has none."""
    parts = [replace(proven(each), line=k) for k, each in enumerate((SNAPPING, TAUT), start=1)]
    columns = {str(each.name): each.values for each in lines_of_body(parts).columns}
    headings = {"fairlead": "Max., {} by damping", "anchor": "At anchor, {} by damping"}
    for end, heading in headings.items():
        ends = parts[0].damping_range(f"{end}_tension")
        assert ends is not None
        for value, which in zip(ends, ("least", "most"), strict=True):
            snaps, taut = columns[heading.format(which)]
            assert (snaps, taut) == (value, None)
