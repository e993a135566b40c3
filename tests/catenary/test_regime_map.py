"""The regime map of docs/regimes.md against the solver, and the picture against its formulas."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType
from typing import get_args

import pytest

from catopt.catenary.solve import solve
from catopt.catenary.state import Regime
from catopt.errors import NoEquilibriumError
from catopt.model import Line, Segment

DOCS = Path(__file__).parents[2] / "docs"
LENGTH, WEIGHT = 55.0, 2100.0
LINE = Line([Segment(LENGTH, WEIGHT)])


def load(path: Path) -> ModuleType:
    """Import a script that is in no package."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


MAP = load(DOCS / "regime_map.py")


def solved(force: float, height: float, anchor: float) -> str:
    try:
        return solve(
            LINE,
            height=height * LENGTH,
            horizontal_force=force * WEIGHT * LENGTH,
            anchor_height=anchor * LENGTH,
        ).regime
    except NoEquilibriumError:
        return "none"


@pytest.mark.parametrize("anchor", [0.0, 0.05, 0.2, 0.6])
def test_the_solver_has_the_regimes_of_the_map(anchor: float) -> None:
    found = set()
    for power in range(-8, 9):
        force = 10.0 ** (power / 4.0)
        for step in range(1, 34):
            height = 0.05 * step
            name = solved(force, height, anchor)
            assert name == MAP.regime(force, height, anchor), (force, height)
            found.add(name)
    raised = {"grounded-between", "below-anchor"}
    assert found == {"suspended", "none"} | (raised if anchor else {"grounded"})


def closed_in(force: float, anchor: float, low: float, high: float) -> float:
    """Height of the map between two regimes, by bisection."""
    below = MAP.regime(force, low, anchor)
    while high - low > 1e-15 * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if MAP.regime(force, middle, anchor) == below else (low, middle)
    return low


@pytest.mark.parametrize("anchor", [0.0, 0.2])
def test_the_boundaries_are_met_from_both_sides(anchor: float) -> None:
    """To 1e-6 of the length, far more than either side's rounding."""
    for force in (0.03, 0.3, 1.0, 3.0):
        heights = [0.001 + 0.002 * k for k in range(700)]
        names = [MAP.regime(force, height, anchor) for height in heights]
        places = [k for k in range(699) if names[k] != names[k + 1]]
        assert len(places) == (3 if anchor and names[0] == "grounded-between" else 2)
        for k in places:
            edge = closed_in(force, anchor, heights[k], heights[k + 1])
            assert solved(force, edge - 1e-6, anchor) == names[k]
            assert solved(force, edge + 1e-6, anchor) == names[k + 1]


def test_on_the_bed_and_slack() -> None:
    assert solved(1.0, 0.0, 0.0) == "on-bed"
    for anchor in (0.0, 0.2):
        reach = LENGTH * (1.0 - 0.4 - anchor)
        for span, name in ((reach - 1e-6, "slack"), (reach + 1e-6, None)):
            regime = solve(
                LINE, height=0.4 * LENGTH, span=span, anchor_height=anchor * LENGTH
            ).regime
            assert (regime == "slack") == (name == "slack")


def test_every_regime_is_on_the_page_and_the_picture_is_there() -> None:
    page = (DOCS / "regimes.md").read_text(encoding="utf-8")
    table = page.split("## Which regime, when")[1]
    assert all(f"| {name} |" in table for name in get_args(Regime))
    assert "![Regimes over force and height](regime-map.svg)" in page
    assert "</svg>" in (DOCS / "regime-map.svg").read_text(encoding="utf-8")


def test_the_picture_can_be_drawn_anew() -> None:
    left, right = MAP.draw().axes
    words = {text.get_text() for axes in (left, right) for text in axes.texts}
    assert {"grounded", "suspended", "grounded-between", "below-anchor"} <= words
