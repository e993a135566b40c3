"""The case of a ship's sizing runs in motion as it is written."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from catopt import solve_system
from catopt.casefile import parse_case, write_case
from catopt.checks.result import CheckReport
from catopt.floater import two_scales
from catopt.report.bundle import size_files
from catopt.sizing.result import Sizing
from catopt.sizing.ship_afloat import ship_afloat
from catopt.sizing.tanker_request import TankerRequest
from catopt.verify.convergence_check import LIMIT
from catopt.verify.ship_result import ShipVerification
from catopt.verify.two_scales import verify_ship
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_tanker
from tests.sizing.test_consistency import LOADED, deep
from tests.sizing.test_thresholds import ONE_SIZE

SHIP: dict[str, Any] = {"dwt": "50000 t", "depth": "20 m", "hs": "2 m", "wind": "25 m/s"}


@cache
def sized(lines: int = 1) -> Sizing:
    with alone():
        return size_tanker(**SHIP, lines=lines)


@cache
def run(lines: int) -> ShipVerification:
    """Run what is written for ten minutes."""
    case = sized(lines).ship_case
    assert case is not None
    read = parse_case(write_case(case))
    assert read.dynamics is not None
    return verify_ship(replace(read, dynamics=replace(read.dynamics, duration=600.0, runs=1)))


@pytest.mark.parametrize("lines", [1, 4])
def test_what_is_written_runs_as_it_is(lines: int) -> None:
    """In its own water, about the bow, under the wind's mean of an hour; bow to the weather."""
    case = sized(lines).ship_case
    assert case is not None
    assert case.site.water_depth == 20.0
    assert case.floater is not None
    assert case.floater.ship is not None
    # The bow is the end of the waterline, 0.97 of the length over all, as at rest.
    assert case.floater.ship.mooring_point == pytest.approx(0.485 * case.floater.ship.length)
    # By hand, NPD: 21.2 m/s over an hour are 25 m/s over 30 s.
    hour = case.floater.wind_speed
    gust = 1.0 - 0.41 * 0.06 * (1.0 + 0.043 * hour) * math.log(30.0 / 3600.0)
    assert hour * gust == pytest.approx(25.0)
    found = run(lines)
    assert len(found.lines) == lines
    assert abs(abs(found.heading) - math.pi) < math.radians(15.0)
    assert found.rest.force[0] > 0.0
    made = size_files(sized(lines), "en", None)
    assert made["system.toml"].decode() == write_case(case)


@pytest.mark.parametrize("lines", [1, 4])
def test_the_steady_wind_is_that_of_the_sizing_for_an_hour(lines: int) -> None:
    """On the same hull from ahead, by the square of the speed."""
    of = sized(lines)
    case, found = of.ship_case, run(lines)
    assert case is not None
    assert case.floater is not None
    at = next(e for e in of.settled.posed.loads if case.title.endswith(e.load_case))
    wanted = math.fsum(e.force for part in at.parts for e in part.components if e.kind == "wind")
    wind, _, _ = found.rest.parts
    assert wind[0] == pytest.approx(wanted * (case.floater.wind_speed / 25.0) ** 2, rel=1e-6)


def test_a_code_without_factors_for_motion_leaves_it_to_another() -> None:
    """UFC's factors are on steady forces; in motion API RP 2SK's for quasi-static lines hold."""
    case = sized(4).ship_case
    assert case is not None
    assert case.checks.codes == ("UFC-4-159-03",)
    assert case.checks.motion_code == "API-RP-2SK"
    tensions = [each for each in run(4).checks.results if each.kind == "tension"]
    assert tensions
    assert all("API RP 2SK" in each.source.text for each in tensions)
    line = run(4).lines[0]
    assert tensions[0].demand == pytest.approx(line.fairlead.judged, rel=1e-6)


@pytest.mark.parametrize(
    "other",
    [
        {"hs": "0 m"},
        {"current_angle": "90 deg", "current_yaw": "-0.2, 0.003", "recalled": True},
        {"buoy": "mooring buoy 5.0 m", "hawser": "40 m"},
    ],
)
def test_there_is_none_where_it_would_be_another_ship_or_sea(other: dict[str, Any]) -> None:
    with alone():
        assert size_tanker(**(SHIP | other)).ship_case is None


@pytest.mark.parametrize("lines", [3, 4])
@pytest.mark.parametrize("line_out", [False, True])
def test_the_weather_comes_from_the_side_that_is_hardest_on_a_line(
    lines: int, line_out: bool
) -> None:
    """By the equilibrium under the same force from 36 sides, with all there or without line 1."""
    request = TankerRequest((LOADED,), deep(), lines=lines, line=ONE_SIZE)
    of = size_tanker(request)
    case = ship_afloat(request, of.settled, of.pattern, line_out=line_out)
    assert case is not None
    assert case.system is not None
    system = case.system.without([0]) if line_out else case.system
    force = math.hypot(*system.force)

    def most(angle: float) -> float:
        pushed = (force * math.cos(angle), force * math.sin(angle))
        return max(each.horizontal_force for each in solve_system(system.under(pushed)).lines)

    assert case.system.force == (force, 0.0)
    around = max(most(2.0 * math.pi * k / 36) for k in range(36))
    # Samples 10 deg apart may beat what golden sections stop at by rounding alone.
    assert most(0.0) >= around * (1.0 - 1e-4)


def open_of(checks: CheckReport) -> list[str]:
    """List what was not judged, by those checks alone that pass: else nothing is left open."""
    passing = tuple(each for each in checks.results if each.passes)
    assert passing
    return [each.subject for each in replace(checks, results=passing).judgement.not_judged]


def test_a_step_that_is_too_long_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Green at a step of 1 s, which half the step bears out; in doubt at one of 40 s."""
    found = run(1)
    assert found.change is not None
    assert found.change.size < 1e-3
    assert found.checks.is_proven
    assert "convergence" not in open_of(found.checks)
    monkeypatch.setattr(two_scales, "SLOW_STEP", 40.0)
    coarse = verify_ship(found.case)
    assert coarse.change is not None
    assert coarse.change.size > LIMIT
    assert coarse.checks.is_doubted
    assert coarse.checks.judgement.colour in {"amber", "red"}


def test_what_was_run_once_is_no_green() -> None:
    case = run(1).case
    once = verify_ship(case, proven=False).checks
    assert "convergence" in open_of(once)
