"""Old names are read for one version, and say what they are now."""

from __future__ import annotations

from typing import Any, cast

import pytest

import catopt
from catopt.errors import InputError
from catopt.fem import HeldBed, RestrainedBed
from catopt.mooring.fixed_body import held_body
from catopt.mooring.restoring import network_curve
from catopt.old_names import OldName, renamed
from catopt.verify.dynamic import verify_dynamic

CHAIN = catopt.Line([catopt.Segment(length=110.0, submerged_weight=1000.0)])


def test_an_old_keyword_is_the_new_one_with_a_warning() -> None:
    @renamed(weight="mass")
    def doubled(*, mass: float = 0.0) -> float:
        return 2.0 * mass

    untyped: Any = doubled
    with pytest.warns(DeprecationWarning, match="weight of doubled is mass now"):
        assert untyped(weight=3.0) == 6.0
    assert doubled(mass=3.0) == 6.0


def test_an_old_attribute_is_the_new_one_with_a_warning() -> None:
    class Body:
        mass = 3.0
        weight = OldName("mass")

    with pytest.warns(DeprecationWarning, match="weight of Body is mass now"):
        assert Body().weight == 3.0


def test_the_proof_of_a_run_is_its_convergence_check_now() -> None:
    still, run = catopt.read_case("cases/buoy-9.5m/case.toml"), cast("Any", verify_dynamic)
    with pytest.warns(DeprecationWarning, match="convergence_check"), pytest.raises(InputError):
        run(still, proof="none")  # it has no motion


def test_an_old_function_is_the_new_one_with_a_warning() -> None:
    with pytest.warns(DeprecationWarning, match="held_body is at_displacement now"):
        body = held_body(
            catopt.System.around(
                CHAIN, azimuths=[0.0, 3.0], anchor_radius=100.0, fairlead_height=20.0
            ),
            origin_height=20.0,
        )
    assert len(body.lines) == 2


def test_the_curve_of_a_network_is_that_of_any_mooring() -> None:
    with pytest.warns(DeprecationWarning, match="network_curve is restoring_curve now"):
        curve = network_curve(
            catopt.System.around(
                CHAIN, azimuths=[0.0, 3.0], anchor_radius=100.0, fairlead_height=20.0
            ),
            direction=0.0,
            offsets=[0.0],
        )
    assert curve.offset == (0.0,)


def test_the_bed_of_s4_is_restrained_now() -> None:
    with pytest.warns(DeprecationWarning, match="HeldBed is RestrainedBed now"):
        bed = HeldBed(0.1)
    assert bed == RestrainedBed(0.1)
