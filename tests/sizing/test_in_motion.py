"""A buoy's line chosen among those that hold in motion: the search, the sinker, the answer."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from importlib.resources import files
from types import SimpleNamespace
from typing import Any

import jsonschema
import numpy as np
import pytest
from scipy.optimize import brentq

import catopt.sizing.motion_search as searching
import catopt.sizing.motion_verdicts as judging
from catopt.answers.size import size_answer
from catopt.casefile import parse_case, write_case
from catopt.checks.case import check_case
from catopt.checks.kinds import CheckSource
from catopt.checks.result import CheckReport, CheckResult
from catopt.design.evaluation import sinker_of
from catopt.errors import InputError
from catopt.notes.line import Given
from catopt.notes.motion import checks_in_motion
from catopt.render.card import card_lines
from catopt.render.files import csv_files
from catopt.report.bundle import size_files
from catopt.sizing.in_motion import (
    Counted,
    InMotion,
    LengthRun,
    LineTried,
    NoLineInMotionError,
    RunsAfloat,
    Storm,
)
from catopt.sizing.input_values import input_values
from catopt.sizing.line_choice import LineChoice, sold
from catopt.sizing.requests import request_of
from catopt.sizing.result import Sizing
from catopt.sizing.ship_afloat import MOST_SLIDE, buoy_afloat, run_in_still_water
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.verdicts import way_of
from catopt.words import Language, Message
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_buoy

PLACE: dict[str, Any] = {"buoy": "pillar 1.8 m", "depth": "12 m"}
FAILS = CheckResult("tension", "tension", "storm", 3.0, 1.0, "N", 2.0, CheckSource("user"))


def searched(
    holds: Callable[[float, float], bool],
    patched: pytest.MonkeyPatch,
    again: Callable[..., Any] = lambda of, *_: of,
    **inputs: Any,
) -> tuple[Any, list[tuple[float, float]]]:
    """Search with runs that are made up: by diameter, mm, and length, m; list what was run."""
    run: list[tuple[float, float]] = []

    def made_up(settled: Any, *_: object, whole: bool = False) -> Any:
        line = settled.point.line
        size = round(1e3 * line.segments[0].nominal_diameter, 6)
        run.append((size, line.length))
        failing = () if holds(size, line.length) else (FAILS,)
        component = line.segments[0].component
        tried = LineTried(
            component, size * 1e-3, line.length, line.mass, 2 if whole else 1, failing
        )
        return SimpleNamespace(
            tried=tried,
            settled=settled,
            parts=(),
            case=settled.case,
            checks="checks",
            seas=(),
            verdict="converged",
        )

    kept: list[Any] = []
    patched.setattr(searching, "_run", made_up)
    patched.setattr(searching, "_again", again)
    patched.setattr(searching, "_storm", lambda *_: None)
    patched.setattr(searching, "_slides", lambda *_: ())
    patched.setattr(
        searching,
        "InMotion",
        lambda *found, seas, heel, proof, changes, **_: SimpleNamespace(
            counted=found[5], by_length=found[7], seas=seas, heel=heel, proof=proof, changes=changes
        ),
    )
    patched.setattr(searching, "_sinker_size", lambda *_: None)
    own = searching.search_in_motion

    def keep(*of: Any) -> Any:
        kept.append(own(*of))
        raise KeyboardInterrupt

    patched.setattr(searching, "search_in_motion", keep)
    with pytest.raises(KeyboardInterrupt):
        size_buoy(**PLACE, in_motion=True, **inputs)
    return kept[0], run


NEEDS = {20.0: 70.0, 22.0: 66.0, 24.0: 60.0, 25.0: 58.0, 26.0: 50.0, 28.0: 46.0, 30.0: 44.0}
"""Length from which each size holds, m."""


@pytest.mark.parametrize("prefer", ["lightest", "practice", "shortest"])
def test_it_finds_what_running_every_line_would(
    prefer: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of all lines that hold the same one is chosen, with fewer runs than there are lines."""

    def holds(size: float, length: float) -> bool:
        return length >= NEEDS[size]

    found, run = searched(holds, monkeypatch, prefer=prefer)
    request: Any = request_of(input_values("buoy", {**PLACE, "prefer": prefer}))
    per_metre = {
        round(1e3 * (each.nominal_diameter or 0.0), 6): each.mass or 0.0
        for each in sold(request.line, request.environment.water_density)
    }
    assert set(per_metre) <= set(NEEDS)
    with alone():
        at_rest = size_buoy(**PLACE, prefer=prefer).point.line.length
    lengths = searching._ladder([float(k) for k in range(24, 161)], 2.0 * at_rest)
    every = [(s, L) for s in per_metre for L in lengths if holds(s, L)]
    if prefer == "lightest":
        wanted = min(every, key=lambda each: per_metre[each[0]] * each[1])
    else:  # 2.5 depths, 30 m and more, are too short for all of them
        wanted = min(every, key=lambda each: (each[1], per_metre[each[0]]))
    line = found.settled.point.line
    assert (round(1e3 * line.segments[0].nominal_diameter, 6), line.length) == wanted
    counted = found.in_motion.counted
    assert counted.considered == len(per_metre) * len(lengths)
    assert counted.run == len(run) == len(set(run)) < counted.considered / 3
    assert counted.considered == counted.at_rest + counted.excluded + counted.run
    # The next shorter one of its size was run and failed, or fails at rest.
    shorter = [L for s, L in run if s == wanted[0] and L < line.length]
    assert shorter or counted.at_rest > 0


def test_a_line_that_fails_when_it_is_run_again_is_not_recommended(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Runs say that 44 m hold, their runs again that 50 m do."""
    again: list[float] = []

    def proven(of: Any, *_: object) -> Any:
        again.append(of.tried.length)
        if of.tried.length >= 50.0:
            return of
        failed = replace(of.tried, reason="fails when run again")
        return SimpleNamespace(**{**vars(of), "tried": failed})

    found, run = searched(
        lambda _, length: length >= 44.0, monkeypatch, again=proven, prefer="shortest"
    )
    length = found.settled.point.line.length
    assert length == again[-1] == min(each for each in again if each >= 50.0)
    assert min(again) < 50.0  # others were preferred to it
    assert found.in_motion.proof == "converged"
    assert found.in_motion.counted.run == len(set(run))


def test_where_nothing_holds_the_nearest_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    tried = LineTried("", 0.02, 1.0, 1.0, 2, (FAILS,))

    def fails(settled: Any, *_: object, **__: object) -> Any:
        return SimpleNamespace(settled=settled, tried=tried)

    monkeypatch.setattr(searching, "_run", fails)
    with pytest.raises(NoLineInMotionError) as caught:
        size_buoy(**PLACE, in_motion=True)
    counted = caught.value.counted
    assert caught.value.exit_status == 3
    assert counted.runs == 2 * counted.run
    said = str(caught.value)
    assert "none passes in motion" in said
    assert "tension (storm): 3.00 times the allowable" in said
    assert caught.value.near_miss is not None
    assert caught.value.near_miss.failing == (FAILS,)


def test_the_sinker_is_what_the_pull_in_motion_needs() -> None:
    """The least of those that are cast; it never becomes lighter than at rest."""
    settled = size_buoy(**PLACE).settled
    own = settled.point.anchor
    assert own is not None
    assert own.submerged_weight is not None

    def held(weight: float) -> Any:
        sliding = CheckResult(
            "", "sliding", "storm", weight, own.submerged_weight or 0.0, "N", 0.0, FAILS.source
        )
        return judging._held(settled, CheckReport("", (FAILS, sliding), ()))

    # Concrete of 2400 kg/m3 in water of 1025 weighs 5.618 N a kg: 30 kN are 5.34 t.
    per_kg = 9.80665 * (1.0 - 1025.0 / 2400.0)
    assert held(0.5 * own.submerged_weight) is own
    assert held(30e3).mass == 6000.0
    assert held(6000.0 * per_kg).mass == 6000.0
    assert held(1e7).mass == 60e3


@pytest.mark.parametrize(
    ("inputs", "said"),
    [
        ({"buoy": None, "force": "5 kN", "reserve_buoyancy": "12 kN"}, "a library buoy in"),
        ({"hs": "0 m"}, "only a library buoy in waves can be run"),
        ({"run_time": "5 s"}, "run_time: found"),
        ({"seeds": 0}, "seeds: found"),
    ],
)
def test_what_cannot_be_run_is_refused(inputs: dict[str, Any], said: str) -> None:
    given: dict[str, Any] = {k: v for k, v in {**PLACE, **inputs}.items() if v is not None}
    with pytest.raises(InputError, match=said):
        size_buoy(**given, in_motion=True)


def test_a_buoy_without_its_ballast_is_not_run() -> None:
    """The spar's mass, spread over its hull, lies above what rights it."""
    with pytest.raises(InputError, match="would not float upright") as caught:
        size_buoy("spar 0.8 m", depth=36.0, hs=2.5, in_motion=True)
    assert [each.key for each in caught.value.problems] == ["in_motion"]


def test_runs_want_to_be_in_motion() -> None:
    with pytest.raises(InputError, match="in_motion"):
        size_buoy(**PLACE, seeds=2)


def test_a_buoy_of_the_library_is_one_wherever_its_file_lies() -> None:
    """CALMAR's own file names another origin; another mass is another buoy."""
    place: dict[str, Any] = {"buoy": "T-5000l-2.4m", "depth": "12 m"}
    request: Any = request_of(input_values("buoy", place))
    with alone():
        case = size_buoy(**place).case
    read = replace(request.buoy, origin="T-5000l-2.4m.xmlMB")
    afloat = buoy_afloat(case, replace(request, buoy=read))
    assert afloat is not None
    assert afloat == buoy_afloat(case, request)
    assert buoy_afloat(case, replace(request, buoy=replace(read, mass=read.mass + 1.0))) is None


# ------------------------------------------------------------------ run in time


CALM: dict[str, Any] = {
    "buoy": "pillar 1.8 m",
    "depth": "12 m",
    "hs": "0.3 m",
    "period": "3 s",
    "current": "0.5 m/s",
    "life": 0,
    "code": "break/5",
    "diameter_min": "20 mm",
    "diameter_max": "22 mm",
    "length_step": "8 m",
    "prefer": "lightest",
}
SHORT = RunsAfloat(1, 60.0, 12)


@pytest.fixture(scope="module")
def calm() -> Sizing:
    """Size one in a harbour's waves, with short runs of few bars."""
    request: Any = request_of(input_values("buoy", CALM))
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(searching, "processes_for", lambda *_: 2)
        return size_buoy(replace(request, in_motion=SHORT))


def test_a_sea_that_breaks_is_said_and_no_other(calm: Sizing) -> None:
    """By 0.142 lambda tanh(k d) of Miche at the mean period of the waves that are run.

    m0/m1 of JONSWAP is at 0.834 Tp; of a run's random components it is 2 or 3 % about that.
    """
    of = calm.in_motion
    assert of is not None
    assert of.case.waves is not None
    assert not list(calm.breaking_seas())
    depth, height = of.case.site.water_depth, 3.0
    higher = replace(of.case, waves=replace(of.case.waves, height=height))
    (said,) = replace(calm, in_motion=replace(of, case=higher)).breaking_seas()
    assert isinstance(said, Message)
    period: Any = said.values["period"]
    assert period == pytest.approx(0.834 * 3.0, rel=0.05)
    k = brentq(lambda k: 9.80665 * k * np.tanh(k * depth) - (2.0 * np.pi / period) ** 2, 0.01, 9.0)
    limit = 0.142 * 2.0 * np.pi / k * np.tanh(k * depth)
    assert said.values["limit"] == pytest.approx(limit, rel=1e-9)
    assert said.values["height"] == pytest.approx(height, rel=1e-3)  # tails are cut off
    assert limit < height


def test_what_is_recommended_passes_as_its_case_is_verified(calm: Sizing) -> None:
    """The case that is written is run again, and comes to the same checks to the last digit."""
    of = calm.in_motion
    assert of is not None
    assert of.checks.passes
    case = parse_case(write_case(calm.line_case))
    assert case.dynamics is not None
    assert case.dynamics.judged_by == "upper"
    again = checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1))
    assert again.passes
    for old, new in zip(of.checks.results, again.results, strict=True):
        assert new.demand == pytest.approx(old.demand, rel=1e-9, abs=1e-9)
        assert new.capacity == pytest.approx(old.capacity, rel=1e-9, abs=1e-9)
    # No crest on top of the waves, and no state twice.
    assert [each.water_level for each in case.load_cases] == [0.0]


def test_what_its_document_has(calm: Sizing) -> None:
    of = calm.in_motion
    assert of is not None
    found = calm.to_dict()["in_motion"]
    assert found["lines"]["run"] == len(found["tried"])
    assert found["factor"] == pytest.approx(
        (found["most_probable_tension_N"] or found["largest_tension_N"])
        / found["tension_at_rest_N"]
    )
    assert found["allowance"] == LineChoice(("chain open-link 4D Q2",), "break/5").allowance
    (own,) = [
        each
        for each in found["tried"]
        if each["passes"]
        and each["length_m"] == calm.point.line.length
        and each["nominal_diameter_m"] == calm.point.line.segments[0].nominal_diameter
    ]
    assert own["fails"] == ""


def test_other_seeds_pass_and_a_lighter_sinker_does_not(calm: Sizing) -> None:
    """Ten other seas: nine pass or more. The next lighter sinker fails in its own, or at rest."""
    of = calm.in_motion
    assert of is not None
    assert of.case.waves is not None
    assert of.case.dynamics is not None
    passed = 0
    for seed in range(11, 21):
        waves = replace(of.case.waves, seed=seed)
        dynamics = replace(of.case.dynamics, judged_by="most-probable")
        case = replace(of.case, waves=waves, dynamics=dynamics)
        passed += checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1)).passes
    assert passed >= 9
    anchor, at_rest = of.case.anchor, calm.settled.posed.case
    assert anchor is not None
    assert at_rest.design is not None
    assert at_rest.design.sinker is not None
    masses = at_rest.design.sinker.masses
    lighter = sinker_of(at_rest, at_rest.design.sinker, masses.index(anchor.mass or 0.0) - 1)
    case = replace(of.case, anchor=replace(lighter, max_slide=anchor.max_slide))
    in_motion = checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1))
    still = check_case(replace(calm.settled.case, anchor=lighter, design=None))
    assert not (in_motion.passes and still.passes)


def test_the_code_at_rest_is_another_in_motion_than_at_rest(calm: Sizing) -> None:
    """A fifth of the breaking load stands for motion; in motion it is 1.67."""
    of = calm.in_motion
    assert of is not None
    assert {each.source.code for each in calm.point.checks.results if each.kind == "tension"} == {
        "break/5"
    }
    assert {each.kind for each in of.checks.results} >= {"tension", "slide"}
    for each in of.checks.results:
        if each.kind == "tension":
            assert each.source.code == "API-RP-2SK"
            assert each.capacity == pytest.approx((calm.point.line.segments[0].MBL or 0.0) / 1.67)
        if each.kind == "slide":
            assert each.demand <= each.capacity
            assert each.capacity == round(MOST_SLIDE * calm.point.line.length, 1)


def test_the_digits_do_not_hang_on_the_number_of_processes(
    calm: Sizing, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(searching, "processes_for", lambda *_: 3)
    request: Any = request_of(input_values("buoy", CALM))
    assert size_buoy(replace(request, in_motion=SHORT)).to_dict() == calm.to_dict()


def test_a_line_passes_in_every_sea_and_what_governs_is_named(calm: Sizing) -> None:
    """Each sea by itself, run as its case is verified, comes to the same checks."""
    request: Any = request_of(input_values("buoy", CALM))
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(searching, "processes_for", lambda *_: 2)
        of = size_buoy(replace(request, in_motion=replace(SHORT, periods=(3.0, 4.0))))
    found = of.in_motion
    assert found is not None
    assert found.checks.passes
    demands: dict[str, dict[float, float]] = {}
    for period in found.how.periods:
        assert found.case.waves is not None
        case = replace(found.case, waves=replace(found.case.waves, period=period))
        again = checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1)).results
        ours = [e for e in found.checks.results if e.load_case.endswith(f"Tp {period:g} s")]
        for old, new in zip(ours, again, strict=True):
            assert old.demand == pytest.approx(new.demand, rel=1e-9, abs=1e-9)
            demands.setdefault(new.kind, {})[period] = new.demand / new.capacity
    assert {each.check.kind for each in found.seas} == set(demands)
    for each in found.seas:
        by_period = demands[each.check.kind]
        assert by_period[each.period] == max(by_period.values())
    governing = found.checks.governing
    assert governing is not None
    assert governing.load_case.endswith(f"Tp {found.case.waves.period:g} s")  # type: ignore[union-attr]
    # In more seas than one no line is lighter than in one of them.
    assert (of.point.line.mass or 0.0) >= (calm.point.line.mass or 0.0)
    document = of.to_dict()
    assert document["in_motion"]["periods_s"] == [3.0, 4.0]
    schema = json.loads(files("catopt.schemas").joinpath("size-1.json").read_text("utf-8"))
    jsonschema.validate(document, schema)
    card = " ".join(each.text for each in card_lines(size_answer(of), "en"))
    assert "Seas: Tp of 3, 4 s: tension governed by" in card
    assert len(csv_files(size_answer(of))["seas.csv"].splitlines()) == 1 + len(found.seas)


def test_seas_along_a_contour_have_heights_of_their_own() -> None:
    """Each sea by itself, run as its case is verified, comes to the same checks."""
    request: Any = request_of(input_values("buoy", CALM))
    height = request.environment.sea.hs
    heights, periods = (0.6 * height, height), (3.0, 4.0)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(searching, "processes_for", lambda *_: 2)
        how = replace(SHORT, periods=periods, heights=heights)
        of = size_buoy(replace(request, in_motion=how))
    found = of.in_motion
    assert found is not None
    assert found.checks.passes
    assert found.case.waves is not None
    for own, period in zip(heights, periods, strict=True):
        waves = replace(found.case.waves, height=own, period=period)
        case = replace(found.case, waves=waves)
        again = checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1)).results
        end = f"Hs {own:.3g} m, Tp {period:g} s"
        ours = [e for e in found.checks.results if e.load_case.endswith(end)]
        assert ours
        for old, new in zip(ours, again, strict=True):
            assert old.demand == pytest.approx(new.demand, rel=1e-9, abs=1e-9)
    for each in found.seas:
        assert (each.height, each.period) in set(zip(heights, periods, strict=True))
    document = of.to_dict()["in_motion"]
    assert document["heights_m"] == list(heights)
    card = " ".join(each.text for each in card_lines(size_answer(of), "en"))
    assert f"Hs, Tp of {heights[0]:.3g} m, 3 s; {height:.3g} m, 4 s: tension governed by" in card


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"peak_period": "4 s", "sea_height": ("1 m", "2 m")}, "as many as there are peak periods"),
        ({"peak_period": "4 s", "sea_height": "9 m"}, "sea_height"),
        ({"sea_height": "1 m"}, "peak_period"),
    ],
)
def test_heights_that_go_with_no_sea_are_refused(given: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        size_buoy(**PLACE, hs="2 m", in_motion=True, **given)


def test_the_range_that_jonswap_stands_for() -> None:
    """3.6 to 5 roots of Hs, at 4 m 7.2 to 10 s; the sea's own period in the place of one alike."""
    place = {**PLACE, "hs": "4 m", "in_motion": True, "period_range": True}
    request: Any = request_of(input_values("buoy", {**place, "period": "8 s"}))
    assert request.in_motion.periods == (7.2, 8.0, 8.6, 9.3, 10.0)
    request = request_of(input_values("buoy", {**place, "period": "12 s"}))
    assert request.in_motion.periods == (7.2, 7.9, 8.6, 9.3, 10.0, 12.0)
    listed = {**place, "period_range": None, "peak_period": ("9 s", "7 s")}
    request = request_of(input_values("buoy", {k: v for k, v in listed.items() if v is not None}))
    assert request.in_motion.periods == (9.0, 7.0)


def test_periods_that_are_none_are_refused() -> None:
    with pytest.raises(InputError, match="peak_period"):
        size_buoy(**PLACE, in_motion=True, peak_period="0 s")
    with pytest.raises(InputError, match="peak_period"):
        size_buoy(**PLACE, in_motion=True, peak_period="8 s", period_range=True)
    with pytest.raises(InputError, match="in_motion"):
        size_buoy(**PLACE, peak_period="8 s")


@pytest.mark.parametrize(
    ("judged_by", "slides", "way"),
    [
        # Of 0.2 and 0.4 m in 10 min each: 0.6 m in 20, nine times that in three hours.
        ("largest", [0.2, 0.4], 0.4),
        ("most-probable", [0.2, 0.4], 5.4),
        # Slides of 0.1 m: 1.645 sqrt(6 x 0.01); Student's 6.314 x 0.1414 sqrt(2) is more.
        ("upper", [0.2, 0.4], 9.0 * (0.6 + 6.3138 * 0.2)),
        ("upper", [0.3, 0.3], 9.0 * (0.6 + 1.645 * 0.06**0.5)),
    ],
)
def test_how_far_a_sinker_slides_in_the_storm(
    judged_by: str, slides: list[float], way: float
) -> None:
    anchor = object()
    runs: Any = [
        SimpleNamespace(
            history=SimpleNamespace(
                slides=np.array([[[each, 0.1 * each, 10.0 * each]]]),
                course=lambda _: SimpleNamespace(duration=600.0),
            )
        )
        for each in slides
    ]
    dynamics = SimpleNamespace(judged_by=judged_by, duration_of_interest=10800.0)
    part: Any = SimpleNamespace(drive=SimpleNamespace(sinkers=(anchor,), dynamics=dynamics))
    assert way_of(anchor, part, runs) == pytest.approx(way, rel=1e-4)  # type: ignore[arg-type]


# ------------------------------------------------------------------ how it is said


def made_up_answer() -> Sizing:
    """Take a line at rest for one that was run, with round numbers."""
    with alone():
        at_rest = size_buoy(**PLACE)
    tried = LineTried("chain open-link 4D Q2", 0.03, 38.0, 660.0, 7, ())
    case = run_in_still_water(at_rest.settled.case, request_of(input_values("buoy", PLACE)))  # type: ignore[arg-type]
    assert case is not None
    return replace(
        at_rest,
        dynamic_factor=1.0,
        motion=Message("sizing.motion_by_runs"),
        chain_life=None,
        in_motion=InMotion(
            RunsAfloat(),
            case,
            at_rest.point.checks,
            Storm("storm, high water", 90e3, 120e3, 100e3, 150e3, 8e3),
            1.2,
            Counted(70, 30, 28, 12, 40),
            (tried,),
            load_cases=2,
        ),
    )


def by_length() -> tuple[LengthRun, ...]:
    """Make three lengths up: one that fails, one that passes, one without an answer."""
    lines = [LineTried("chain open-link 4D Q2", 0.03, L, 17.4 * L, 6, ()) for L in (30.0, 38.0)]
    lost = replace(lines[0], length=50.0, runs=2, reason="does not converge")
    return (
        LengthRun(
            replace(lines[0], failing=(FAILS,)), Storm("storm", 240e3, None, None, None, 8e3), 20e3
        ),
        LengthRun(lines[1], Storm("storm", 90e3, 120e3, 100e3, 150e3, 8e3), 8e3),
        LengthRun(lost, None, None),
    )


@pytest.mark.parametrize("language", ["en", "vi"])
def test_the_screen_says_what_the_runs_come_to(language: Language) -> None:
    of = made_up_answer()
    lines = [each.text for each in card_lines(size_answer(of), language)]
    assert len(lines) <= 22
    assert max(map(len, lines)) <= 80
    said = " ".join(" ".join(lines).split())
    for what in ("120.0 kN", "100.0", "150.0", "8.000 kN", "10 min", "70", "12"):
        assert what in said
    if language == "en":
        assert "in motion, new and worn" in said
        assert "3 of 10 min in each of 2 load cases" in said
        assert "most probable maximum in 3 h" in said
        assert "70 lines: 12 run in motion (40 runs), 30 fail at rest, 28 not needed" in said


@pytest.mark.parametrize("language", ["en", "vi"])
def test_lengths_that_were_run_stand_on_the_screen_in_tables_and_in_a_picture(
    language: Language,
) -> None:
    of = made_up_answer()
    assert of.in_motion is not None
    of = replace(of, in_motion=replace(of.in_motion, by_length=by_length()))
    lines = [each.text for each in card_lines(size_answer(of), language)]
    assert len(lines) <= 24
    assert "30 m 240.0 kN; 38 m 120.0 kN" in " ".join(lines)
    head, short, own, lost = csv_files(size_answer(of))["by_length.csv"].decode().splitlines()
    assert head.startswith("Length L (m),Mass in air (t),Tension at rest (kN)")
    assert short.startswith("30.0,0.522,8.0,240.0,,,20.0,FAILS")
    assert own.startswith("38.0,0.6612,8.0,120.0,100.0,150.0,8.0,passes")
    assert lost.startswith("50.0,0.522,,,,,,FAILS")
    made = size_files(of, language, Given())
    assert {"by_length.png", "by_length.svg"} <= set(made)
    schema = json.loads(files("catopt.schemas").joinpath("size-1.json").read_text("utf-8"))
    jsonschema.validate(of.to_dict(), schema)


def test_other_lengths_are_run_with_all_seeds_whether_they_pass_or_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The shortest and the longest that pass at rest are among them, and so is the own line."""
    found, run = searched(
        lambda _, length: length >= 40.0,
        monkeypatch,
        diameter_min="30 mm",
        diameter_max="30 mm",
        other_lengths=3,
    )
    own = found.settled.point.line.length
    by_length = found.in_motion.by_length
    lengths = [each.tried.length for each in by_length]
    assert lengths == sorted({own, *(length for _, length in run[-3:])})
    assert len(lengths) == 4
    assert lengths[0] < 40.0 <= own
    assert lengths[-1] == max(length for _, length in run)
    assert [each.tried.runs for each in by_length] == [1 if L == own else 2 for L in lengths]


def test_the_answer_as_files_and_as_a_document() -> None:
    of = made_up_answer()
    tables = csv_files(size_answer(of))
    assert "lines_in_motion.csv" in tables
    assert "by_length.csv" not in tables
    assert set(size_files(of, "en", Given())) >= {"case.toml", "note.html"}
    schema = json.loads(files("catopt.schemas").joinpath("size-1.json").read_text("utf-8"))
    jsonschema.validate(of.to_dict(), schema)
