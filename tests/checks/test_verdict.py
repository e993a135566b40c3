"""One function gives word and colour of any answer: never green by what was not looked at."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from catopt import check_case, read_case
from catopt.checks.result import CheckReport
from catopt.checks.verdict import SUBJECTS, Matter, not_judged, verdict_of
from catopt.model import Service
from catopt.words import Message, say
from catopt.words.message import group


@cache
def report(case: str = "fso-rang-dong-ship/loaded.toml") -> CheckReport:
    """Check a case with a ship afloat that is to last; every check of it passes."""
    return check_case(replace(read_case(f"cases/{case}"), service=Service(0.0)))


def subjects(of: Matter) -> list[str]:
    return [each.subject for each in verdict_of(of).not_judged]


def in_motion(**own: Any) -> Matter:
    """Take the checks at rest for those of its runs, which were proven."""
    runs = {"is_in_motion": True, "is_proven": True, **own}
    return replace(report().matter, in_motion=replace(report(), **runs))


def test_what_moves_and_was_not_run_is_amber_and_says_what_to_type() -> None:
    """`verify --dynamic` fails 64 of 264 checks of this case."""
    found = report().judgement
    assert (found.colour, found.passes) == ("amber", True)
    assert found.said.startswith("All 648 checks pass at rest. Not judged: motion (catopt verify")
    assert report().to_dict()["verdict"]["not_judged"][0]["subject"] == "motion"


def test_what_was_run_and_passes_is_green() -> None:
    matter = replace(in_motion(), case=replace(read_case_of_ship(), current=None))
    assert subjects(matter) == []
    assert verdict_of(matter).colour == "green"
    assert [each.state for each in verdict_of(matter).judged] == ["at_rest", "in_motion"]


def read_case_of_ship() -> Any:
    case = report().case
    assert case is not None
    return case


def test_a_current_turns_a_ship_whatever_is_left_out() -> None:
    """No run has a current without a moment: there is nothing of it that is not judged."""
    assert subjects(in_motion()) == []


def test_runs_that_were_made_once_are_amber() -> None:
    assert "convergence" in subjects(in_motion(is_proven=False))


def test_what_fails_is_red_at_rest_or_in_motion() -> None:
    first, *others = report().results
    broken = (replace(first, exceedance=0.5), *others)
    at_rest = replace(report(), results=broken)
    assert at_rest.judgement.colour == "red"
    assert "1 of 648 checks fails." in at_rest.judgement.said
    moved = verdict_of(in_motion(results=broken))
    assert (moved.colour, moved.not_judged) == ("red", ())
    assert moved.governing == first.in_case


def test_what_makes_it_invalid_stands_first_and_is_red() -> None:
    why = Message("checks.motion_doubted")
    found = verdict_of(replace(report().matter, invalid=(why,)))
    assert found.colour == "red"
    assert found.said.startswith(f"No answer: {why}")


def test_runs_in_doubt_are_red() -> None:
    assert verdict_of(in_motion(is_doubted=True)).colour == "red"


def test_chain_that_is_not_said_to_last_is_not_judged_for_wear() -> None:
    found = report()
    assert subjects(replace(found.matter, case=replace(read_case_of_ship(), service=None))) == [
        "motion",
        "wear",
    ]


def test_nothing_that_was_checked_is_no_colour() -> None:
    empty = replace(report(), results=())
    assert (empty.judgement.colour, empty.judgement.passes) == ("none", None)
    assert empty.judgement.said == "Nothing was checked."


@pytest.mark.parametrize(
    ("friction", "is_amber"), [(0.7, False), (1.0, True)]
)  # NAVFAC's table ends at 0.70
def test_a_sinker_with_more_friction_than_any_soil_has_is_not_judged(
    friction: float, is_amber: bool
) -> None:
    whole = report("tanker-20m-sinker/case.toml")
    case = replace(read_case("cases/tanker-20m-sinker/case.toml"), service=Service(0.0))
    from catopt.model import Anchor

    anchor = Anchor(kind="sinker", submerged_weight=2e5, friction=friction)
    matter = replace(whole.matter, case=replace(case, anchor=anchor))
    assert ("soil" in subjects(matter)) is is_amber


def test_every_subject_has_its_words_in_both_languages() -> None:
    texts = group("verdict")
    for name, subject in SUBJECTS.items():
        assert set(texts[name]) == {"en", "vi"}
        for who in subject.ways:
            assert set(texts[f"{name}_how_{who}"]) == {"en", "vi"}


def test_the_verdict_is_said_in_vietnamese() -> None:
    assert "Chưa xét: chuyển động" in say(report().judgement.said, "vi")


def test_what_has_no_case_lists_nothing() -> None:
    assert not_judged(Matter()) == ()


def test_what_is_accepted_beyond_its_range_is_said() -> None:
    case = replace(read_case("cases/tanker-20m/case.toml"), service=Service(0.0))
    assert "plausible" not in subjects(check_case(case).matter)
    site = replace(case.site, seabed_friction=2.5, accept=("friction",))
    said = check_case(replace(case, site=site)).judgement
    assert said.colour == "amber"
    assert said.said.endswith("accepted as asked for: friction.")
