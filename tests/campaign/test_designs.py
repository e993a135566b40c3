"""Random spaces of whole moorings with several loads, levels and pretensions.

Each design that is drawn is worth what `check_system` and `one_line_out` say of the body under
every force, and no more or less when the same is said in another way: turned, mirrored, with loads
and lines in another order, with a load from four sides as four loads; one more load makes nothing
better. `python -m tests.campaign.test_designs FIRST COUNT` draws more of them.
"""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from catopt.catenary.solve import solve
from catopt.checks.system import check_system
from catopt.design.mooring import MooringProblem
from catopt.errors import NoAnswerError
from catopt.model import Case, Checks, Design, DesignLoad, Line, SegmentChoice, Site, System
from catopt.mooring.case import one_line_out
from catopt.mooring.solution import solve_system
from tests.design.mooring_cases import LINE

pytestmark = pytest.mark.slow

SAME = 1e-7
"""Relative: a body on nearly slack lines is soft, and both balance to 1e-9 of the force."""


def drawn(seed: int) -> Case:
    """Draw a space: 3 to 6 uneven lines of chain, one to three loads, by radius or pretension."""
    rng = np.random.default_rng([8, seed])
    depth = float(rng.uniform(40.0, 120.0))
    count = int(rng.integers(3, 7))
    azimuths = np.cumsum(rng.uniform(0.7, 1.3, count))
    azimuths *= math.tau / azimuths[-1]
    length = depth * float(rng.uniform(5.0, 9.0))
    arm = float(rng.choice([0.0, 5.0]))
    loads = tuple(
        DesignLoad(
            f"load {number}",
            float(10.0 ** rng.uniform(5.0, 6.6)),
            float(rng.uniform(-math.pi, math.pi)),
            headings=int(rng.choice([1, 2, 4])),
            water_level=float(rng.uniform(-2.0, 3.0)),
            fairlead_rise=float(rng.choice([0.0, 2.0])),
            line_out=bool(rng.random() < 0.6),
        )
        for number in range(int(rng.integers(1, 4)))
    )
    anchors: dict[str, Any]
    if rng.random() < 0.5:
        anchors = {"pretensions": tuple(np.sort(rng.uniform(1e4, 4e5, 2)).tolist())}
    else:
        reach = math.sqrt(length**2 - depth**2)
        anchors = {"anchor_radii": tuple((arm + reach * np.array([0.93, 0.97])).tolist())}
    segments = (
        SegmentChoice(
            (length, 1.04 * length),
            ("chain studless R3", "chain studless R4"),
            tuple(np.sort(rng.choice(np.arange(0.06, 0.13, 0.005), 2, replace=False)).tolist()),
        ),
    )
    friction = float(rng.choice([0.0, 0.6]))
    system = System.around(
        LINE,
        azimuths=azimuths.tolist(),
        anchor_radius=1.2 * length,
        fairlead_height=depth,
        fairlead_radius=arm,
        seabed_friction=friction,
        yaw_free=False,
    )
    uplift = None if rng.random() < 0.5 else 0.0
    checks = Checks(safety_factor=1.67, safety_factor_line_out=1.25, max_anchor_uplift_angle=uplift)
    return Case(
        Site(depth + 5.0, seabed_friction=friction), LINE, None, depth, checks=checks,
        system=system, design=Design(segments, loads=loads, **anchors),
    )  # fmt: skip


def some(problem: MooringProblem, seed: int, count: int) -> np.ndarray:
    """Draw designs of a space."""
    rng = np.random.default_rng([9, seed])
    return np.array([[rng.integers(size) for size in problem.space.sizes] for _ in range(count)])


def worth(case: Case, line: Line, place: int) -> tuple[float, float]:
    """Largest offset (m) and excess of a mooring, a body at a time; nan where one has no rest."""
    design, own = case.design, case.system
    assert design is not None
    assert own is not None
    first = own.legs[0]
    if design.pretensions:
        still = solve(
            line,
            height=first.fairlead_height,
            horizontal_force=design.pretensions[place],
            seabed_friction=own.seabed_friction,
        )
        radius = still.span + first.fairlead_radius
    else:
        radius = design.anchor_radii[place]
    far, worst = 0.0, -math.inf
    for load in design.loads:
        around = System.around(
            line,
            azimuths=[leg.azimuth for leg in own.legs],
            anchor_radius=radius,
            fairlead_height=first.fairlead_height + load.water_level + load.fairlead_rise,
            fairlead_radius=first.fairlead_radius,
            seabed_friction=own.seabed_friction,
            yaw_free=False,
            judged_line_out=load.line_out,
        )
        rest = solve_system(around).position
        for angle in load.directions:
            loaded = around.under(load.towards(angle))
            height = loaded.legs[0].fairlead_height
            it = replace(case, line=line, fairlead_height=height, system=loaded, design=None)
            worst = max(worst, *(each.exceedance for each in check_system(it).results))
            places = [solve_system(loaded).position]
            if load.line_out:
                for out in one_line_out(loaded):
                    if out.solution is None:
                        return math.nan, math.nan
                    places.append(out.solution.position)
            far = max(far, *(math.hypot(at.x - rest.x, at.y - rest.y) for at in places))
    return far, worst


def assessed(case: Case, genes: np.ndarray) -> np.ndarray:
    """Offsets and excesses by the compiled search."""
    found = MooringProblem.of(case).assess(genes)
    return np.column_stack([found.objectives[:, 1], found.exceedance])


def turned(case: Case, angle: float, mirror: float = 1.0) -> Case:
    """Turn a mooring and its loads, after mirroring them at the x axis (mirror -1)."""
    assert case.system is not None
    assert case.design is not None
    legs = tuple(
        replace(leg, azimuth=angle + mirror * leg.azimuth, fairlead_azimuth=math.nan)
        for leg in case.system.legs
    )
    loads = tuple(
        replace(load, direction=math.remainder(angle + mirror * load.direction, math.tau))
        for load in case.design.loads
    )
    return replace(
        case,
        system=replace(case.system, legs=legs),
        design=replace(case.design, loads=loads),
    )


def with_loads(case: Case, loads: tuple[DesignLoad, ...]) -> Case:
    """Return the space under other loads."""
    assert case.design is not None
    return replace(case, design=replace(case.design, loads=loads))


def one_by_one(load: DesignLoad) -> tuple[DesignLoad, ...]:
    """Say a load from several sides as several loads."""
    return tuple(
        replace(load, name=f"{load.name} {k}", direction=angle, headings=1)
        for k, angle in enumerate(load.directions)
    )


def same(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether offsets and excesses agree, those of no rest, too."""
    return bool(np.isclose(one, other, rtol=SAME, atol=1e-8, equal_nan=True).all())


def faults(seed: int) -> list[str]:
    """Say what is wrong with the designs of a space."""
    case = drawn(seed)
    assert case.design is not None
    assert case.system is not None
    problem = MooringProblem.of(case)
    genes = some(problem, seed, 3)
    due = assessed(case, genes)
    found = []
    for each, (far, exceedance) in zip(genes, due, strict=True):
        line = problem.space.line(tuple(each))
        try:
            own = worth(case, line, int(each[-1]))
        except NoAnswerError as error:
            if not (math.isnan(far) or exceedance > 0.0):
                found.append(f"{each}: {error}, but the search has {far}, {exceedance}")
            continue
        if math.isnan(own[0]) and not math.isfinite(far):
            continue
        if not same(np.array([far, exceedance]), np.array(own)):
            found.append(
                f"{each}: {far!r}, {exceedance!r} by the search, {own} by checking the body"
            )
    loads = case.design.loads
    legs = case.system.legs[1:] + case.system.legs[:1]
    permuted = replace(case, system=replace(case.system, legs=legs))
    others = {
        "turned": turned(case, 0.7),
        "mirrored": turned(case, 0.0, -1.0),
        "lines in another order": permuted,
        "loads in another order": with_loads(case, loads[::-1]),
        "loads one by one": with_loads(case, tuple(o for load in loads for o in one_by_one(load))),
    }
    for name, other in others.items():
        again = assessed(other, genes)
        if not same(again, due):
            found.append(f"{name}: {again.tolist()} for {due.tolist()}")
    more = replace(loads[0], name="more", force=1.3 * loads[0].force, direction=0.4, headings=1)
    again = assessed(with_loads(case, (*loads, more)), genes)
    if (again < due - 1e-9 * np.abs(due)).any():
        found.append(f"one more load makes it better: {again.tolist()} for {due.tolist()}")
    return found


@pytest.mark.parametrize("seed", range(8))
def test_a_design_is_worth_the_same_by_every_way(seed: int) -> None:
    assert faults(seed) == []


def test_a_wrong_worth_is_seen() -> None:
    due = np.array([[10.0, -0.2]])
    assert not same(due * (1.0 + 1e-6), due)
    assert not same(np.array([[math.nan, -0.2]]), due)


if __name__ == "__main__":
    begin, number = map(int, sys.argv[1:])
    for each in range(begin, begin + number):
        for said in faults(each):
            sys.stdout.write(f"{each}: {said}\n")
    sys.stdout.write(f"{number} spaces, {3 * number} designs\n")
