"""The questions turned round on random ordinary lines: every outcome is checked by putting it back.

An answer meets its condition in the line solved anew, and none smaller does; where none is said to
exist, the line is solved over the whole range of the unknown and never comes there.
"""

from __future__ import annotations

import contextlib
import math
from dataclasses import replace

import numpy as np
import pytest

from catopt.catenary.find import (
    find_clump_weight,
    find_length,
    find_limit_force,
    find_touchdown_force,
    with_segment_length,
)
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.errors import NoAnswerError, NoEquilibriumError, NotConvergedError
from catopt.model import Line, PointLoad, Segment
from tests.catenary.random_lines import RandomLine, moderate_setting

LINES = 120
PLACES = np.random.default_rng(5).uniform(0.05, 0.95, 10_000)
"""Of the clump weight sought, over the line's length."""


def _hung(drawn: RandomLine, line: Line, load: dict[str, float]) -> Solution:
    return solve(line, height=drawn.height, seabed_friction=drawn.seabed_friction, **load)


def _load(drawn: RandomLine, line: Line, kind: str) -> dict[str, float]:
    """Return what is known of a line: its force, or its span or tension under that force."""
    by_force = {"horizontal_force": drawn.horizontal_force}
    if kind == "horizontal_force":
        return by_force
    there = _hung(drawn, line, by_force)
    return {kind: there.span if kind == "span" else there.fairlead.tension}


_SLOW = pytest.param("fairlead_tension", marks=pytest.mark.slow)
"""Every trial solves for the force first."""


@pytest.mark.parametrize("kind", ["horizontal_force", "span", _SLOW])
def test_a_clump_weight_or_none(kind: str) -> None:
    """Each outcome of a search over 150 lines, and that all three occur where they can."""
    lines = LINES if kind != "fairlead_tension" else LINES // 3
    outcomes = [_of_a_clump_weight(seed, kind) for seed in range(lines)]
    assert outcomes.count("found") > lines // 20
    if kind != "fairlead_tension":  # under a known tension the line comes down with its force
        assert outcomes.count("none suffices") > LINES // 20


def _of_a_clump_weight(seed: int, kind: str) -> str:
    drawn = moderate_setting(seed)
    place = float(PLACES[seed]) * drawn.line.length
    loads = (*drawn.line.point_loads, PointLoad(place, 0.0, name="sought"))
    line = Line(drawn.line.segments, loads)
    index = next(k for k, load in enumerate(line.point_loads) if load.name == "sought")
    load = _load(drawn, line, kind)

    def angle(weight: float) -> float:
        weights = [
            replace(each, submerged_weight=weight) if each.name == "sought" else each
            for each in line.point_loads
        ]
        return _hung(drawn, Line(line.segments, weights), load).anchor.angle

    wanted = math.radians(3.0 * (seed % 3))
    try:
        found = find_clump_weight(
            line,
            height=drawn.height,
            seabed_friction=drawn.seabed_friction,
            point_load=index,
            anchor_angle=wanted,
            **load,
        )
    except NoAnswerError as refusal:
        said = str(refusal)
    except NotConvergedError:
        # Only where the line above the clump weight would have to stretch beyond all use.
        EA = min(segment.EA for segment in line.segments)
        assert math.isfinite(EA)
        assert angle(0.05 * EA) > wanted
        return "beyond use"
    else:
        # Digits of the anchor angle: rounding of forces of the size of the clump weight over H.
        digits = 1e-12 * max(1.0, found.value / found.solution.horizontal_force)
        assert angle(found.value) == pytest.approx(wanted, abs=digits), seed
        assert angle(0.9 * found.value) > wanted, seed
        return "found"
    if "is needed" in said:
        assert angle(0.0) <= wanted
        return "none needed"
    tried = [angle(factor * line.submerged_weight) for factor in np.geomspace(1e-3, 1e3, 25)]
    assert min(tried) > wanted, (seed, said)
    return "none suffices"


def test_no_clump_weight_of_the_issue() -> None:
    """29 m hang straight down from 46 m: 43 m rise to 17 m under 130 kN, at asinh(V / H).

    h = (hypot(H, V + w L) - hypot(H, V)) / w with w L = 26.66 kN and w h = 10.54 kN gives
    V = 42.871 kN by hand, an angle of 18.25 deg.
    """
    line = Line([Segment(72.0, 620.0)], [PointLoad(43.0, 1e3)])
    with pytest.raises(NoAnswerError) as refused:
        find_clump_weight(line, height=46.0, horizontal_force=130e3)
    assert str(refused.value) == (
        "no clump weight gives inclination at the anchor 0 deg: however heavy, it only pulls "
        "the 29 m of line above it straight down, hangs 17 m above the bed and leaves 18.25 deg at "
        "the anchor. Move it towards the anchor, or give a longer line."
    )
    V = 42.8715e3
    rise = (math.hypot(130e3, V + 26.66e3) - math.hypot(130e3, V)) / 620.0
    assert rise == pytest.approx(17.0, abs=5e-4)
    assert math.degrees(math.atan2(V, 130e3)) == pytest.approx(18.25, abs=5e-3)


def test_a_clump_weight_that_only_makes_it_worse() -> None:
    """Between fixed ends of a taut line a heavier one draws the line below it ever straighter.

    The angle at the anchor rises with it, up to that of a triangle of two straight parts.
    """
    line = Line([Segment(55.0, 1000.0)], [PointLoad(30.0, 1e3)])
    side, height, span = math.hypot(45.0, 30.0), 30.0, 45.0
    corner = math.acos((30.0**2 + side**2 - 25.0**2) / (2.0 * 30.0 * side))
    triangle = math.atan2(height, span) - corner

    def angle(weight: float) -> float:
        heavier = Line(line.segments, [PointLoad(30.0, weight)])
        return solve(heavier, height=height, span=span).anchor.angle

    assert angle(1e9) == pytest.approx(triangle, abs=1e-4)
    assert angle(0.0) < angle(1e4) < angle(1e6) < triangle
    without = math.degrees(angle(0.0))
    with pytest.raises(NoAnswerError, match=f"at 0 N it is {without:.4g} deg, with the clump"):
        find_clump_weight(line, height=height, span=span)


@pytest.mark.parametrize("kind", ["horizontal_force", _SLOW])
@pytest.mark.parametrize("asked", ["anchor_angle", "grounded_length"])
def test_a_length_or_none(kind: str, asked: str) -> None:
    outcomes = [_of_a_length(seed, kind, asked) for seed in range(LINES)]
    assert outcomes.count("found") > LINES // 2


def _of_a_length(seed: int, kind: str, asked: str) -> str:
    drawn = moderate_setting(seed)
    load = _load(drawn, drawn.line, kind)
    segment = seed % len(drawn.line.segments)
    wanted = 0.1 if asked == "anchor_angle" else drawn.height * (0.1 + 0.01 * (seed % 100))

    def has(length: float) -> float:
        there = _hung(drawn, with_segment_length(drawn.line, segment, length), load)
        return there.anchor.angle if asked == "anchor_angle" else there.grounded_length

    try:
        found = find_length(
            drawn.line,
            height=drawn.height,
            seabed_friction=drawn.seabed_friction,
            segment=segment,
            **{asked: wanted},
            **load,
        )
    except NoAnswerError as refusal:
        said = str(refusal)
    else:
        assert has(found.value) == pytest.approx(wanted, rel=1e-6), seed
        return "found"
    readings = []
    for factor in np.geomspace(1e-2, 1e2, 30):
        length = factor * drawn.line.segments[segment].length
        with contextlib.suppress(NoEquilibriumError):  # too short, or too heavy for the tension
            readings.append(has(max(length, (1.0 + 1e-9) * _held(drawn.line, segment))))
    short = [reading < wanted for reading in readings]
    assert all(short) or not any(short), (seed, said)
    return "none"


def _held(line: Line, segment: int) -> float:
    """Return the length up to a segment's uppermost point load, m: the least it can have."""
    start = math.fsum(each.length for each in line.segments[:segment])
    end = start + line.segments[segment].length
    return max(
        (q.position - start for q in line.point_loads if start < q.position <= end), default=0.0
    )


def test_forces_of_touchdown_and_limit() -> None:
    """Both exist for every line that reaches up, unless what hangs is too heavy by itself."""
    found = 0
    for seed in range(LINES):
        drawn = moderate_setting(seed)
        height, friction = drawn.height, drawn.seabed_friction
        touchdown = find_touchdown_force(drawn.line, height=height, seabed_friction=friction)
        lifted = _hung(drawn, drawn.line, {"horizontal_force": 1.01 * touchdown.value})
        lying = _hung(drawn, drawn.line, {"horizontal_force": 0.99 * touchdown.value})
        assert lifted.anchor.vertical_force > 0.0
        assert lying.anchor.vertical_force == 0.0
        MBL = 2.0 * drawn.line.submerged_weight
        rated = Line([replace(s, MBL=MBL) for s in drawn.line.segments], drawn.line.point_loads)
        try:
            limit = find_limit_force(
                rated, safety_factor=2.0, height=height, seabed_friction=friction
            )
        except NoAnswerError:
            nearly_none = _hung(drawn, rated, {"horizontal_force": 1e-6 * MBL})
            assert nearly_none.fairlead.tension > MBL / 2.0
            continue
        found += 1
        largest = max(state.max_tension for state in limit.solution.segments)
        assert largest == pytest.approx(MBL / 2.0, rel=1e-8)
    assert found > LINES // 2


def test_a_length_that_the_line_jumps_over() -> None:
    """Friction above 1 and a raised anchor: the grounded length jumps, and both sides are named."""
    segments = [
        Segment(24.210997507670793, 230.80734453267004),
        Segment(38.2298791634807, 1480.1381581149521),
    ]
    with pytest.raises(NoAnswerError, match=r"the line jumps from 113\.901 m to 120\.301 m"):
        find_length(
            Line(segments),
            height=49.41962231700608,
            horizontal_force=201365.33644632265,
            grounded_length=116.05787358361208,
            seabed_friction=1.2,
            anchor_height=16.00028443995963,
        )


def test_a_length_beyond_which_the_tension_is_too_small() -> None:
    """The longer the line, the more of it hangs from the fairlead, up to all of the tension."""
    line = Line([Segment(200.0, 100.0), Segment(60.0, 1000.0)])
    with pytest.raises(NoAnswerError, match=r"beyond that the fairlead tension of 80000 N is"):
        find_length(line, height=100.0, fairlead_tension=8e4, segment=1, grounded_length=300.0)
