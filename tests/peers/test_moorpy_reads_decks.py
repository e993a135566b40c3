"""The same deck read by MoorPy 1.3 and by catopt: the same forces."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import pytest

from catopt import read_case, solve_case
from catopt.mooring.case import report_system
from tests.decks.own import MOORDYN, TWO_SEGMENTS
from tests.decks.public import PUBLIC, deck_text

moorpy = pytest.importorskip("moorpy", reason="optional extra: peers")


@pytest.mark.parametrize("of", PUBLIC, ids=lambda of: of["file"].rsplit("/", 1)[-1])
def test_it_still_finds_what_is_kept_of_public_decks(of: dict[str, Any], tmp_path: Path) -> None:
    """Fairlead forces to 1e-9, about what was printed of them."""
    place = tmp_path / "deck.dat"
    place.write_text(deck_text(of))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        theirs = moorpy.System(file=str(place))
        for point in theirs.pointList:
            point.zTol = 1e-3
        theirs.initialize()
        theirs.solveEquilibrium(DOFtype="free", tol=1e-7)
    fx, fy, fz = theirs.pointList[-1].getForces()
    size = math.hypot(of["H"], of["V"])
    assert math.hypot(fx, fy) == pytest.approx(of["H"], abs=1e-8 * size)
    assert -fz == pytest.approx(of["V"], abs=1e-8 * size)


SMOOTH = MOORDYN.replace("0.001 FrictionCoefficient\n", "")


@pytest.mark.parametrize("text", [SMOOTH, TWO_SEGMENTS], ids=["oc3", "two segments"])
def test_forces_at_the_fairleads(text: str, tmp_path: Path) -> None:
    """MoorPy solves free points to 1e-6 m of their place: 1e-6 of the forces here."""
    place = tmp_path / "deck.dat"
    place.write_text(text)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        theirs = moorpy.System(file=str(place))
        theirs.initialize()
        theirs.solveEquilibrium(tol=1e-7)
    case = read_case(place)
    lines = (
        [leg.solution for leg in report_system(case).solution.lines]
        if case.system
        else [solve_case(case)]
    )
    coupled = [point for point in theirs.pointList if point.type == -1]
    assert len(lines) == len(coupled)
    for ours, point in zip(lines, coupled, strict=True):
        fx, fy, fz = point.getForces()
        assert ours.horizontal_force == pytest.approx(math.hypot(fx, fy), rel=1e-6)
        assert ours.fairlead.vertical_force == pytest.approx(-fz, rel=1e-6)
