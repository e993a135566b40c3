"""Load cases, questions, fronts, and the document."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest

import catopt
from catopt.errors import InputError, NotConvergedError
from catopt.model import LoadCase
from catopt.schemas import schema
from catopt.verify import case as front_module
from catopt.verify.case import Design, verify_case, verify_front
from catopt.verify.comparison import ROUNDING
from catopt.verify.result import Verification

from .cases import CASES

ROOT = Path(__file__).parents[2]


def read(name: str) -> catopt.Case:
    found: catopt.Case = catopt.read_case(ROOT / "cases" / name / "case.toml")
    return found


STATES = (
    LoadCase("storm", 3e5, water_level=2.0),
    LoadCase("everyday", 5e4, kind="reference"),
)
WITH_STATES = replace(CASES["on the bed"], load=None, load_cases=STATES)


def validated(found: object) -> dict[str, object]:
    document: dict[str, object] = found.to_dict()  # type: ignore[attr-defined]
    jsonschema.Draft202012Validator(schema("catopt.verify/1")).validate(document)
    json.dumps(document, allow_nan=False)
    return document


def test_every_load_case_is_verified_at_its_own_water_level() -> None:
    told: list[tuple[int, int]] = []
    found = verify_case(WITH_STATES, progress=lambda *step: told.append(step))
    assert [part.name for part in found.parts] == ["storm", "everyday"]
    assert told == [(0, 2), (1, 2)]
    closed = found.parts[0].lines[0].closed
    assert (closed.fairlead_height, closed.horizontal_force) == (52.0, 3e5)
    assert found.verdict == "agrees"


def test_one_load_case_by_name() -> None:
    found = verify_case(WITH_STATES, load_case="everyday")
    assert [part.name for part in found.parts] == ["everyday"]
    with pytest.raises(InputError, match="one of storm, everyday is required"):
        verify_case(WITH_STATES, load_case="strom")
    with pytest.raises(InputError, match="no \\[\\[load_cases\\]\\]"):
        verify_case(CASES["on the bed"], load_case="load")


def test_a_case_that_seeks_something_is_verified_with_what_was_found() -> None:
    found = verify_case(read("tanker-20m-find-length"))
    closed = found.static.lines[0].closed
    assert closed.line.length != read("tanker-20m-find-length").line.length
    assert found.verdict == "agrees"


@pytest.mark.parametrize(
    "name",
    sorted(
        path.parent.name
        for path in (ROOT / "cases").glob("*/case.toml")
        # In a current, which the truss refuses:
        if path.parent.name not in {"instrument-mooring", "hanging-instrument", "net-cage"}
    ),
)
def test_every_case_of_the_project_agrees(name: str) -> None:
    assert verify_case(read(name)).verdict == "agrees"


@pytest.mark.parametrize(
    "case", [CASES["friction"], WITH_STATES, CASES["touches twice"]], ids=["load", "states", "two"]
)
def test_the_document_keeps_to_its_schema(case: catopt.Case) -> None:
    validated(verify_case(case))


def test_the_document_says_what_was_found() -> None:
    found = verify_case(CASES["friction"])
    document = validated(found)
    static = document["static"]
    assert isinstance(static, dict)
    assert (document["dynamic"], document["verdict"]) == (None, "agrees")
    span = found.static.of("span")
    assert static["closed_form"]["span_m"] == span.closed_form
    assert static["fem"]["span_m"] == span.extrapolated
    assert static["difference"]["span_m"] == span.difference
    assert len(static["meshes"]) == 3
    assert document["load_cases"] == [static]
    # Only lines between points have joints and bodies.
    assert not any("point" in each for each in (static["worst"], *static["quantities"]))


def test_static_is_the_load_case_that_agrees_least() -> None:
    found = verify_case(WITH_STATES)
    gaps = [part.worst.gap for part in found.parts]
    assert found.static.worst.gap == pytest.approx(max(gaps), abs=ROUNDING)
    part = found.parts[0]
    wrong = replace(
        part, quantities=tuple(replace(q, fem=(q.fem[0],) * 3) for q in part.quantities)
    )
    tampered = Verification(found.case, (found.parts[1], wrong))
    assert tampered.static is wrong


def test_verdicts_of_several_load_cases_add_up() -> None:
    good = verify_case(CASES["on the bed"]).parts[0]
    bad = replace(
        good,
        quantities=tuple(replace(q, closed_form=q.closed_form + 1.0) for q in good.quantities),
    )
    # Meshes that change by more than half a metre do not tell a metre.
    changing = replace(
        bad, quantities=tuple(replace(q, fem=(*q.fem[:2], q.fem[1] + 0.5)) for q in bad.quantities)
    )
    case = CASES["on the bed"]
    assert Verification(case, (good, good)).verdict == "agrees"
    assert Verification(case, (good, good)).is_settled
    assert Verification(case, (good, changing)).verdict == "not resolved"
    assert Verification(case, (changing, bad, good)).verdict == "differs"
    assert not Verification(case, (good, bad)).is_settled


# ------------------------------------------------------------------ fronts


def test_a_front_goes_on_after_a_design_that_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(case: catopt.Case, **settings: object) -> Verification:
        if case is CASES["friction"]:
            raise NotConvergedError("stopped short")
        return verify_case(case, **settings)  # type: ignore[arg-type]

    monkeypatch.setattr(front_module, "verify_case", fails)
    designs = [Design(1, CASES["on the bed"]), Design(2, CASES["friction"]),
               Design(3, WITH_STATES, "storm")]  # fmt: skip
    found = verify_front("Front", designs)
    assert [each.failure for each in found.designs] == ["", "stopped short", ""]
    assert (found.is_settled, found.has_converged) == (False, False)
    document = validated(found)
    assert document["verdict"] == "no answer"
    designs_ = document["designs"]
    assert isinstance(designs_, list)
    assert [each["verdict"] for each in designs_] == ["agrees", "no answer", "agrees"]
    assert designs_[2]["load_cases"][0]["load_case"] == "storm"


def test_a_front_without_any_answer_has_no_static_part() -> None:
    too_short = replace(CASES["hanging"], fairlead_height=30.0)
    found = verify_front("Front", [Design(1, too_short)])
    assert validated(found)["static"] is None
    assert "too short" in found.designs[0].failure
    assert found.has_converged
    assert not found.is_settled


# ------------------------------------------------------------------ what is asked of many lines


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(120))
def test_random_lines_agree(seed: int) -> None:
    from tests.fem.lines import moored_line

    drawn = moored_line(seed)
    setting = drawn.setting
    case = catopt.Case(
        catopt.Site(setting["height"], setting["seabed_friction"]),
        drawn.line,
        catopt.Load(horizontal_force=drawn.horizontal_force),
        setting["height"],
        anchor_height=setting["anchor_height"],
    )
    found = verify_case(case)
    assert found.verdict == "agrees"
    assert found.static.worst.gap < 1e-6
    assert all(math.isfinite(each.extrapolated) for each in found.static.quantities)
