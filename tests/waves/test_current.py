"""Current profiles alone, added up, and in the kernel."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest

from catopt.errors import InputError
from catopt.waves import (
    Current,
    CurrentSeries,
    Kinematics,
    PowerLawCurrent,
    Sea,
    TableCurrent,
    WindCurrent,
    fill_kinematics,
    regular_wave,
    wind_driven_speed,
)

DEPTH = 56.0


def at(heights: list[float], *profiles: Current) -> npt.NDArray[np.float64]:
    """Velocity at heights above the bed."""
    points = np.column_stack([np.zeros((len(heights), 2)), heights])
    motion = Sea(DEPTH, None, profiles).kinematics(0.0, points)
    assert not motion.acceleration.any()
    return motion.velocity


def test_power_law() -> None:
    """V0 (z/d)^(1/7), S4 [2.77]: half the depth leaves 2^(-1/7) = 0.9057."""
    u = at([0.0, 28.0, 56.0], PowerLawCurrent(2.0))
    np.testing.assert_allclose(u[:, 0], [0.0, 2.0 * 0.5 ** (1.0 / 7.0), 2.0], rtol=1e-14)
    assert not u[:, 1:].any()


def test_wind_current() -> None:
    """Linear to 0 at d0 below still water, S4 [2.78], and 0 from there on."""
    u = at([56.0, 46.0, 36.0, 35.0, 0.0], WindCurrent(0.5, 20.0))
    np.testing.assert_allclose(u[:, 0], [0.5, 0.25, 0.0, 0.0, 0.0], atol=1e-15)


def test_wind_current_deeper_than_the_water() -> None:
    """At the bed (100 - 56)/100 of the surface's is left."""
    np.testing.assert_allclose(at([0.0], WindCurrent(1.0, 100.0))[0, 0], 0.44, rtol=1e-14)


def test_table_of_s4() -> None:
    """1.47, 1.43, 1.00 m/s at 0, 30, 56 m towards 180 deg; 15 m down is halfway between two."""
    table = TableCurrent([0.0, 30.0, 56.0], [1.47, 1.43, 1.00], math.pi)
    u = at([56.0, 41.0, 26.0, 13.0, 0.0], table)
    np.testing.assert_allclose(u[:, 0], [-1.47, -1.45, -1.43, -1.215, -1.00], rtol=1e-14)
    assert np.abs(u[:, 1]).max() < 1e-15


def test_table_holds_its_ends() -> None:
    u = at([56.0, 50.0, 5.0, 0.0, -0.5], TableCurrent([10.0, 40.0], [1.0, -0.5]))
    np.testing.assert_allclose(u[:, 0], [1.0, 1.0, -0.5, -0.5, -0.5], rtol=1e-14)


def test_table_that_goes_deeper_than_the_water() -> None:
    """Rows below the bed still shape the last stretch: 1 - 0.01 · 56 at the bed."""
    np.testing.assert_allclose(at([0.0], TableCurrent([0.0, 100.0], [1.0, 0.0]))[0, 0], 0.44)


def test_profiles_add_up_as_vectors() -> None:
    profiles = (
        PowerLawCurrent(1.2, 0.4),
        PowerLawCurrent(0.3, -1.0, 0.5),
        WindCurrent(0.4, 17.0, 2.2),
        TableCurrent([0.0, 12.0, 33.0], [0.2, 0.5, 0.1], -2.0),
    )
    heights = [0.0, 3.0, 23.0, 38.9, 39.0, 44.0, 50.0, 56.0]
    wanted = sum(at(heights, profile) for profile in profiles)
    np.testing.assert_allclose(at(heights, *profiles), wanted, atol=1e-15)


def test_a_single_profile_needs_no_list() -> None:
    assert Sea(DEPTH, None, PowerLawCurrent(1.0)).current == (PowerLawCurrent(1.0),)  # type: ignore[arg-type]


def test_above_still_water_the_surface_speed_holds() -> None:
    sea = Sea(DEPTH, regular_wave(6.0, 12.0), [TableCurrent([0.0, 56.0], [1.0, 0.0])], "wheeler")
    still = Sea(DEPTH, regular_wave(6.0, 12.0), stretching="wheeler")
    crest = [[0.0, 0.0, DEPTH + 2.0]]
    difference = sea.kinematics(0.0, crest).velocity - still.kinematics(0.0, crest).velocity
    np.testing.assert_allclose(difference, [[1.0, 0.0, 0.0]], atol=1e-15)


def test_wind_driven_speed() -> None:
    assert wind_driven_speed(37.4) == pytest.approx(0.374)
    assert wind_driven_speed(20.0, "CALMAR") == pytest.approx(0.3)
    with pytest.raises(InputError) as caught:
        wind_driven_speed(-1.0, "DNV")  # type: ignore[arg-type]
    assert [p.key for p in caught.value.problems] == ["wind_speed", "rule"]


@pytest.mark.parametrize(
    ("profile", "arguments", "keys"),
    [
        (PowerLawCurrent, (-1.0, math.nan, 0.0), ["surface_speed", "direction", "exponent"]),
        (WindCurrent, (math.inf, 0.0), ["surface_speed", "depth"]),
        (TableCurrent, ([], []), ["speeds"]),
        (TableCurrent, ([0.0, 1.0], [1.0]), ["speeds"]),
        (TableCurrent, ([-1.0, 2.0], [1.0, math.nan]), ["depths[0]", "speeds[1]"]),
        (TableCurrent, ([0.0, 5.0, 5.0], [1.0, 1.0, 1.0]), ["depths[2]"]),
        (TableCurrent, ([0.0, 5.0], [1.0, 1.0], 0.0, [1.0]), ["directions"]),
        (TableCurrent, ([0.0, 5.0], [1.0, 1.0], 0.0, [1.0, math.inf]), ["directions[1]"]),
    ],
)
def test_wrong_input_is_named_all_at_once(
    profile: type[Current], arguments: tuple[object, ...], keys: list[str]
) -> None:
    with pytest.raises(InputError) as caught:
        profile(*arguments)  # type: ignore[arg-type]
    assert [p.key for p in caught.value.problems] == keys


def test_a_table_that_turns_with_depth() -> None:
    """Towards x at the surface and y at 20 m: halfway both halves, so that 0.71 m/s are left."""
    table = TableCurrent([0.0, 20.0], [1.0, 1.0], directions=[0.0, 0.5 * math.pi])
    u = at([56.0, 46.0, 36.0, 0.0], table)
    wanted = [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
    np.testing.assert_allclose(u, wanted, atol=1e-15)


def test_directions_all_alike_are_one_direction() -> None:
    depths, speeds = [0.0, 12.0, 33.0], [0.2, 0.5, 0.1]
    one = at([3.0, 30.0, 51.0], TableCurrent(depths, speeds, -2.0))
    several = at([3.0, 30.0, 51.0], TableCurrent(depths, speeds, directions=[-2.0] * 3))
    np.testing.assert_allclose(several, one, atol=1e-16)


SERIES = CurrentSeries([0.0, 100.0, 300.0], [1.0, 2.0, 0.5], [0.0, 0.0, 0.5 * math.pi])


@pytest.mark.parametrize("is_compiled", [False, True])
def test_a_series_scales_and_turns_the_profile(is_compiled: bool) -> None:
    """Linear in x and y between its times, held beyond; the profile's own speed is a shape."""
    for profile in (PowerLawCurrent(7.0, 1.3), TableCurrent([0.0, 56.0], [3.0, 1.0], -0.4)):
        sea = Sea(DEPTH, None, profile, current_series=SERIES)  # type: ignore[arg-type]
        shape = at([28.0], profile)[0, :2] @ [1.0, 1.0j]
        shape /= at([56.0], profile)[0, :2] @ [1.0, 1.0j]
        for t, top in ((-5.0, 1.0), (50.0, 1.5), (200.0, 1.0 + 0.25j), (999.0, 0.5j)):
            motion = Kinematics(np.empty((2, 3)), np.empty((2, 3)), np.empty(2))
            points = np.array([[0.0, 0.0, 56.0], [0.0, 0.0, 28.0]])
            if is_compiled:
                motion = sea.kinematics(t, points)
            else:
                fill_kinematics(t, points, sea.flow, *motion)
            found = motion.velocity[:, 0] + 1j * motion.velocity[:, 1]
            np.testing.assert_allclose(found, top * np.array([1.0, shape]), atol=1e-14)


def test_a_series_without_directions_keeps_those_of_the_profile() -> None:
    series = CurrentSeries([0.0, 10.0], [1.0, -1.0])
    sea = Sea(DEPTH, None, [PowerLawCurrent(2.0, 0.3)], current_series=series)
    for t, speed in ((0.0, 1.0), (5.0, 0.0), (10.0, -1.0)):
        u = sea.kinematics(t, [[0.0, 0.0, DEPTH]]).velocity[0]
        np.testing.assert_allclose(
            u[:2], [speed * math.cos(0.3), speed * math.sin(0.3)], atol=1e-15
        )


def test_water_that_changes_its_speed_accelerates() -> None:
    """Straight between the times, so that a central difference is exact to rounding."""
    sea = Sea(DEPTH, None, [PowerLawCurrent(2.0, 0.3)], current_series=SERIES)
    points = [[0.0, 0.0, 40.0]]
    ahead, back = (sea.kinematics(220.0 + h, points).velocity for h in (5.0, -5.0))
    found = sea.kinematics(220.0, points).acceleration
    np.testing.assert_allclose(found, (ahead - back) / 10.0, atol=1e-16)
    assert np.abs(found).max() > 1e-3


def test_before_the_run_the_current_is_that_of_its_start_and_steady() -> None:
    shifted = CurrentSeries([-50.0, 50.0], [1.0, 2.0])
    sea = Sea(DEPTH, regular_wave(4.0, 9.0), [PowerLawCurrent(1.0)], current_series=shifted)
    motion = Kinematics(np.empty((1, 3)), np.empty((1, 3)), np.empty(1))
    fill_kinematics(777.0, np.array([[0.0, 0.0, DEPTH]]), sea.flow_at_rest, *motion)
    np.testing.assert_allclose(motion.velocity, [[1.5, 0.0, 0.0]], atol=1e-15)
    assert not motion.acceleration.any()


def test_a_series_needs_a_current_to_scale() -> None:
    for current in ([], [TableCurrent([0.0, 10.0], [0.0, 1.0])]):
        with pytest.raises(InputError, match="a current with speed at the surface is required"):
            Sea(DEPTH, None, current, current_series=SERIES)


@pytest.mark.parametrize(
    ("arguments", "keys"),
    [
        (([], []), ["times", "speeds"]),
        (([0.0, 1.0], [1.0]), ["speeds"]),
        (([0.0, 1.0], [1.0, math.nan], [0.0]), ["speeds", "directions"]),
        (([0.0, 1.0, 1.0], [1.0, 1.0, 1.0]), ["times"]),
    ],
)
def test_a_wrong_series_is_refused(arguments: tuple[list[float], ...], keys: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        CurrentSeries(*arguments)
    assert [p.key for p in caught.value.problems] == keys
