"""Arrays get the checks that scalars get: a unit is converted or refused, never dropped.

The span of the marker buoy under 3363.68 N, 17.43105514 m with EA = 80 MN, is that of
tests/catenary; what is tested here is that every spelling of that force gives it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import numpy as np
import pandas as pd
import pint
import pytest

from catopt import InputError, Line, Segment, System, solve, solve_many
from catopt.fem.series import Harmonic, Sampled
from catopt.mooring.batch import solve_system_many
from catopt.waves import CurrentSeries, ElevationRecord

U: Any = pint.UnitRegistry()
LINE = Line([Segment(20, 93.163, EA=8e7)])
FORCE, SPAN = 3363.68, 17.43105514


class OfAstropy:
    """A quantity as astropy and unyt have it: `unit` and ``to_value(unit)``."""

    def __init__(self, value: Any, unit: str) -> None:
        self.value, self.unit = value, unit

    def to_value(self, unit: str) -> Any:
        sizes = {"kN": ("N", 1e3), "m": ("m", 1.0)}
        base, size = sizes[self.unit]
        if unit != base:
            raise ValueError(f"'{self.unit}' and '{unit}' are not convertible")
        return np.asarray(self.value) * size


@pytest.mark.parametrize(
    "force",
    [
        [FORCE],
        np.array([3.36368]) * U.kN,
        3.36368 * U.kN,
        [3.36368 * U.kN],
        [3.36368e-3 * U.MN],
        OfAstropy([3.36368], "kN"),
        ["3.36368 kN"],
        np.array(["3.36368 kN"]),
        np.array([3.36368 * U.kN], dtype=object),
        pd.Series([FORCE]),
        np.ma.array([FORCE], mask=[False]),
    ],
    ids=lambda force: type(force).__name__,
)
def test_a_unit_is_converted(force: Any) -> None:
    assert solve_many(LINE, height=9.5, horizontal_force=force).span == pytest.approx(SPAN)


NOT_FORCES: list[tuple[Any, str]] = [
    (np.array([3.3]) * U.m, "a quantity in meter; a force is required"),
    (np.array([343.0]) * U.kg, "a quantity in kilogram; a force is required"),
    (OfAstropy([3.3], "m"), "a quantity in m; a force is required"),
    (np.ma.array([1000.0, FORCE], mask=[False, True]), "1 masked value"),
    (np.ma.array([3.3], mask=[True]) * U.kN, "1 masked value"),
    ([np.ma.masked], "1 masked value"),
    ([True], "True"),
    (np.array([True]), "bool"),
    (pd.Series([True]), "bool"),
    (np.array(["2026-11-29"], dtype="M8[D]"), "datetime64"),
    (pd.to_timedelta([1], unit="s"), "timedelta64"),
    ([1.0 + 2.0j], r"\(1\+2j\)"),
    ([None], "None"),
    ([[1.0], [1.0, 2.0]], "rows of several lengths"),
]


@pytest.mark.parametrize(("force", "said"), NOT_FORCES)
def test_what_is_no_force_is_refused(force: Any, said: str) -> None:
    with pytest.raises(InputError, match=said):
        solve_many(LINE, height=9.5, horizontal_force=force)


def test_a_unit_among_the_attributes_of_xarray_counts() -> None:
    xarray = pytest.importorskip("xarray")
    force = xarray.DataArray([3.36368], attrs={"units": "kN"})
    assert solve_many(LINE, height=9.5, horizontal_force=force).span == pytest.approx(SPAN)
    force.attrs["units"] = "m"
    with pytest.raises(InputError, match="a length; a force is required"):
        solve_many(LINE, height=9.5, horizontal_force=force)


@pytest.mark.parametrize(
    "given",
    [
        {"height": np.array([950.0]) * U.cm},
        {"lengths": np.array([2000.0]) * U.cm},
        {"submerged_weights": np.array([0.093163]) * U.kN / U.m},
        {"submerged_weights": np.array([9.5]) * U.kg / U.m},  # 9.5 g0 = 93.163175 N/m
        {"EA": ["80 MN"]},
        {"seabed_friction": np.array([50.0]) * U.percent},
    ],
    ids=lambda given: next(iter(given)),
)
def test_every_argument_is_converted(given: dict[str, Any]) -> None:
    wanted = {"height": 9.5, "horizontal_force": FORCE}
    assert solve_many(LINE, **(wanted | given)).span == pytest.approx(SPAN, abs=2e-5)


def test_a_force_beyond_all_is_no_answer() -> None:
    answers = solve_many(LINE, height=9.5, horizontal_force=[FORCE, 1e308])
    assert answers.converged.tolist() == [True, False]


def test_a_scalar_takes_quantities_too() -> None:
    height, force = 9.5 * U.m, 3.36368 * U.kN
    assert solve(LINE, height=height, horizontal_force=force).span == pytest.approx(SPAN)
    assert Segment(20 * U.m, 9.5 * U.kg / U.m).submerged_weight == pytest.approx(9.5 * 9.80665)
    with pytest.raises(InputError, match="a quantity in meter"):
        solve(LINE, height=9.5, horizontal_force=3.36368 * U.m)


TIMES = np.arange(8.0)
THREE = np.zeros((8, 3))
SERIES: list[Callable[[], object]] = [
    lambda: Sampled(np.ma.array(TIMES, mask=TIMES == 1.0), THREE),
    lambda: Sampled(pd.to_timedelta(TIMES, unit="s"), THREE),
    lambda: Sampled(TIMES, THREE.astype(bool)),
    lambda: Sampled(TIMES * U.m, THREE),
    lambda: Harmonic(True, (1.0, 0.0, 0.0)),
    lambda: Harmonic(8.0 * U.m, (1.0, 0.0, 0.0)),
    lambda: CurrentSeries(TIMES, TIMES * U.kN),
    lambda: CurrentSeries(TIMES, np.ma.array(TIMES, mask=TIMES == 0.0)),
    lambda: ElevationRecord(TIMES, TIMES * U.s),
    lambda: ElevationRecord(TIMES, cast(Any, TIMES > 3.0)),
]


@pytest.mark.parametrize("make", SERIES)
def test_series_refuse_the_same(make: Callable[[], object]) -> None:
    with pytest.raises(InputError):
        make()


def test_series_are_converted() -> None:
    assert Sampled((TIMES / 60.0) * U.min, THREE).times == pytest.approx(TIMES)
    assert Harmonic(8.0 * U.s, (1.0, 0.0, 0.0)).rows[0, 0] == pytest.approx(np.pi / 4.0)
    record = ElevationRecord(TIMES, 100.0 * np.sin(TIMES) * U.cm)
    assert record.elevation == pytest.approx(np.sin(TIMES))
    assert CurrentSeries(TIMES, TIMES * U.knot).speeds == pytest.approx(TIMES * 1852 / 3600)


@pytest.fixture(scope="module")
def system() -> System:
    return System.around(
        Line([Segment(60, 1000.0, EA=1e9)]),
        azimuths=[0.0, 2.1, 4.2],
        anchor_radius=50.0,
        fairlead_height=20.0,
    )


def test_systems_take_and_refuse_the_same(system: System) -> None:
    plain = solve_system_many(system, force=[[1e4, 0.0]])
    united = solve_system_many(system, force=np.array([[10.0, 0.0]]) * U.kN)
    assert united.tension == pytest.approx(plain.tension, rel=1e-12)
    for force in (
        [[True, False]],
        np.ma.array([[1e4, 0.0]], mask=[[False, True]]),
        [[1e4, 0.0], [1.0]],
        np.array([[10.0, 0.0]]) * U.m,
    ):
        with pytest.raises(InputError):
            solve_system_many(system, force=force)
