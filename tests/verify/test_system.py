"""A moored body by both models."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest

import catopt
from catopt.model import Leg, Line, PointLoad, Segment, System
from catopt.mooring.solution import solve_system
from catopt.schemas import schema
from catopt.verify.line import verify_system
from catopt.verify.result import StaticComparison

FSO = Path(__file__).parents[2] / "cases" / "fso-rang-dong" / "case.toml"
CHAIN = Line([Segment(600.0, 1000.0, EA=8e8)])


def ring(count: int, **further: object) -> System:
    azimuths = [math.radians(20.0 + 360.0 * k / count) for k in range(count)]
    given = {"anchor_radius": 565.0, "fairlead_height": 50.0, "force": (8e5, 2e5)}
    return System.around(CHAIN, azimuths=azimuths, **{**given, **further})  # type: ignore[arg-type]


def verified(system: System) -> StaticComparison:
    return verify_system(system, elements=100, tolerance=1e-4)


def test_the_nine_lines_agree_to_a_hundredth_of_a_percent() -> None:
    found = catopt.verify_case(catopt.read_case(FSO))
    part = found.static
    assert found.verdict == "agrees"
    assert part.worst.gap < 2e-6  # four hundred times less than is asked
    x = part.of("position_x")
    assert x.extrapolated == pytest.approx(-21.738, abs=0.001)
    assert x.order == pytest.approx(2.0, abs=0.1)
    for k in range(9):
        tension = part.of("fairlead_tension", k)
        assert tension.order == pytest.approx(2.0, abs=0.1)
        assert tension.extrapolated == pytest.approx(tension.closed_form, rel=1e-6)


def test_friction_different_lines_and_heights() -> None:
    heavy = Line([Segment(600.0, 2000.0, EA=8e8)], [PointLoad(450.0, 5e4)])
    legs = (
        Leg.between(CHAIN, anchor=(589.0, 30.0), fairlead_height=50.0),
        Leg.between(heavy, anchor=(-320.0, 495.0), fairlead_height=50.0),
        Leg.between(CHAIN, anchor=(-205.0, -553.0), fairlead_height=50.0),
    )
    part = verified(System(legs, (1e5, 1e4), seabed_friction=0.5))
    assert all(pair.closed.regime == "grounded" for pair in part.lines)
    assert part.verdict == "agrees"
    assert part.worst.gap < 1e-5  # 400 bars of the finest mesh in the place of 800


def test_a_slack_line_is_held_to_a_bar() -> None:
    """With the force beyond what the second line gives way to, the first one is slack."""
    part = verified(ring(3, force=(1.5e6, 0.0)))
    slack = [k for k, pair in enumerate(part.lines) if pair.closed.regime == "slack"]
    assert slack == [0]
    assert part.verdict == "agrees"
    tension = part.of("fairlead_tension", 0)
    assert tension.allowed == pytest.approx(1500.0)  # a bar of 1.5 m of 1000 N/m
    assert 50.0 < abs(tension.extrapolated - 50e3) < 1500.0
    assert part.remarks[0].startswith("line 1: the line is slack")


def test_a_body_that_yaws_is_held_in_that_yaw_and_its_moment_compared() -> None:
    system = ring(4, fairlead_radius=10.0, moment=2e6)
    part = verified(system)
    assert solve_system(system).position.yaw != pytest.approx(0.0, abs=1e-3)
    assert part.verdict == "agrees"
    assert len(part.remarks) == 3  # two slack lines, and the yaw
    moment = part.of("moment_of_lines")
    assert moment.closed_form == -2e6
    assert moment.extrapolated == pytest.approx(-2e6, rel=1e-4)
    assert "does not turn" in part.remarks[-1]


def test_a_different_force_in_the_closed_form_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    """One part in a thousand."""
    system = ring(4)
    other = solve_system(system.under((8.008e5, 2e5)))
    monkeypatch.setattr("catopt.verify.line.solve_system", lambda _: other)
    part = verified(system)
    assert part.verdict == "differs"
    assert not part.of("position_x").agrees


def test_lines_that_touch_twice_agree() -> None:
    lifted = Line([Segment(600.0, 1000.0, EA=8e8)], [PointLoad(250.0, -8e4)])
    system = ring(3, force=(1e5, 0.0))
    legs = tuple(replace(leg, line=lifted) for leg in system.legs)
    part = verify_system(replace(system, legs=legs), elements=200, tolerance=1e-4)
    assert part.verdict == "agrees"
    assert part.worst.gap < 1e-6
    assert {pair.closed.regime for pair in part.lines} == {"grounded-in-parts"}
    assert {pair.finest.touchdowns for pair in part.lines} == {2}


@pytest.mark.parametrize("further", [{}, {"fairlead_radius": 10.0, "moment": 2e6}])
def test_the_document_keeps_to_its_schema(further: dict[str, object]) -> None:
    case = catopt.read_case(FSO)
    document = catopt.verify_case(replace(case, system=ring(3, **further)), elements=40).to_dict()
    jsonschema.Draft202012Validator(schema("catopt.verify/1")).validate(document)
    lines = document["static"]["fem"]["lines"]
    assert len(lines) == 3
    assert {"fairlead_tension_N", "anchor_tension_N", "span_m"} <= set(lines[0])
    assert ("moment_of_lines_Nm" in document["static"]["fem"]) == bool(further)
