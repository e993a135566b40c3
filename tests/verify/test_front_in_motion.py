"""A front of designs in motion: which seeds are run, which design is proven, and where."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from catopt.model import Case
from catopt.notes.front_in_motion import FrontInMotion, front_in_motion
from catopt.notes.motion import checks_in_motion
from catopt.verify.dynamic import verify_dynamic
from tests.chain_in_a_sea import chain_in_a_sea, raos_in

DESIGNS = [(40, (1.0, 3.0)), (60, (2.0, 2.0)), (84, (3.0, 1.0))]


@pytest.fixture(scope="module")
def raos(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return raos_in(tmp_path_factory.mktemp("raos"))


def designs(raos: Path, factor: float) -> list[tuple[int, Case, tuple[float, ...]]]:
    return [
        (k, chain_in_a_sea(raos, size, 120, 3, factor), own)
        for k, (size, own) in enumerate(DESIGNS, start=1)
    ]


def utilisations(cases: Sequence[tuple[int, Case, tuple[float, ...]]]) -> list[float]:
    """Run every design in all of its seeds by itself."""
    found = [verify_dynamic(case, convergence_check="none", workers=1) for _, case, _ in cases]
    every = (max(each.utilisation or 0.0 for each in checks_in_motion(e).results) for e in found)
    return list(every)


def by_front(found: FrontInMotion) -> list[float]:
    return [each.tightest.utilisation or 0.0 for each in found.designs if each.tightest]


@pytest.mark.slow
def test_a_design_that_fails_in_its_first_seed_is_run_in_no_other(raos: Path) -> None:
    whole = [0.5 * each for each in utilisations(designs(raos, 2.0))]
    assert whole == sorted(whole, reverse=True)  # the thicker, the less it is used
    assert 0.8 / whole[0] > 1.0
    # A factor with which the thickest alone passes, and one with which all do.
    for factor, passing in ((1.0 / (1.1 * whole[2]), [3]), (0.8 / whole[0], [1, 2, 3])):
        cases = designs(raos, factor)
        found = front_in_motion(cases, 3, convergence_check="none", workers=1)
        assert [each.number for each in found.designs if each.passes] == passing
        for each, own in zip(found.designs, whole, strict=True):
            assert each.found is not None
            assert each.tightest is not None
            (part,) = each.found.parts
            assert len(part.runs) == (3 if each.passes else 1)
            if each.passes:
                assert each.tightest.utilisation == pytest.approx(own * factor, rel=1e-12)
            else:
                assert 1.0 < (each.tightest.utilisation or 0.0) <= own * factor * (1.0 + 1e-12)


@pytest.mark.slow
def test_the_recommended_design_is_proven(raos: Path) -> None:
    cases = designs(raos, 1.01)
    for check, proven in (("step", [2]), ("bars", [1, 2, 3])):
        found = front_in_motion(cases, 2, convergence_check=check, workers=1)  # type: ignore[arg-type]
        assert found.recommended == 2
        assert found.has_converged
        assert [each.number for each in found.designs if not each.is_run_once] == proven


@pytest.mark.slow
def test_an_executor_gives_the_same(raos: Path) -> None:
    cases = designs(raos, 1.01)
    with ThreadPoolExecutor(1) as executor:
        there = front_in_motion(cases, 2, executor=executor)
    here = front_in_motion(cases, 2, workers=2)
    assert there.to_dict() == here.to_dict()
    assert by_front(there) == by_front(here)
