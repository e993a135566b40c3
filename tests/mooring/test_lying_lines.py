"""Bodies whose fairleads lie on the bed: a line there is taut or slack, with a kink between."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from catopt import Line, Segment, read_case, solve
from catopt.mooring.case import report_system

HARD = Path(__file__).parents[1] / "hard_cases"


@pytest.mark.parametrize("name", ["fuzz7_11808", "fuzz7_18993"])
def test_six_lines_on_the_bed(name: str) -> None:
    """Line 4 alone comes taut: 195 m to its anchor, 5 m to its length, then 400 kN by EA."""
    case = read_case(HARD / f"{name}.toml")
    assert case.system is not None
    (segment,) = case.system.legs[3].line.segments
    start = time.process_time()
    found = report_system(case, with_line_out=True)
    assert time.process_time() - start < 1.0
    offset = 5.0 + 400e3 * 200.0 / segment.EA
    assert found.solution.offset[0] == pytest.approx(offset, rel=1e-9)
    # Without it those at 60 deg to either side hold the body.
    without = [each.response for each in found.line_out]
    assert all(each is not None for each in without)
    assert without[3].offset > without[0].offset == pytest.approx(offset, rel=1e-9)  # type: ignore[union-attr]


@pytest.mark.parametrize("friction", [0.0, 0.7])
def test_a_line_on_the_bed_stretches(friction: float) -> None:
    """100 m of 500 N/m, EA 1 MN: with friction 35 N/m of the tension are lost on the way."""
    line = Line([Segment(100.0, 500.0, EA=1e6)])
    force = 50e3
    tight = min(100.0, force / (friction * 500.0)) if friction else 100.0
    span = 100.0 + (force * tight - 0.5 * friction * 500.0 * tight**2) / 1e6
    found = solve(line, height=0.0, span=span, seabed_friction=friction)
    assert found.horizontal_force == pytest.approx(force, rel=1e-8)
