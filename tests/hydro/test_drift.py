"""Mean drift: of sections beside limits, a barrier and a flume; of ships beside panels."""

from __future__ import annotations

import csv
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import iv, kv

from catopt.errors import InputError
from catopt.hydro.coefficients import Coefficients
from catopt.hydro.cylinder import HEAVE
from catopt.hydro.drift import HullForm, _InWaves, _Meeting, wave_drift_damping
from catopt.hydro.section import Section
from catopt.waves.random_surface import depth_factor, wave_number

HERE = Path(__file__).parent
RHO, G = 1000.0, 9.80665
ROUNDING = 1e-9
FLUME = Section(0.4, 0.2, 1.0, reference=0.108 - 0.2, density=RHO)
"""About its centre of gravity: KG 0.108 m, draught 0.2 m."""


def rows(name: str) -> list[dict[str, str]]:
    text = (HERE / name).read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in text if not line.startswith("#")))


@pytest.mark.parametrize("omega", [2.0, 5.4, 9.0])
def test_damping_is_what_the_waves_carry_away(omega: float) -> None:
    """B/2 = 2 c_g rho g/2 |a|^2: on two sides, for unit speed."""
    of = FLUME.at(omega)
    group = 0.5 * omega / of.k * depth_factor(of.k, of.of.depth)
    carried = 2.0 * RHO * G * group * np.abs(of.waves) ** 2
    # The roll's moment is summed over the hull, and what truncation leaves shows: 3e-5.
    assert carried == pytest.approx(np.diag(of.damping), rel=1e-4)


def test_excitation_by_the_far_field_and_by_pressure_agree() -> None:
    """Haskind's relation beside the wave's own pressure and what the hull scatters: two routes."""
    of = FLUME.at(5.4)
    assert of.heaved(1.0) == pytest.approx(of.excited(HEAVE), rel=1e-4)


def test_a_thin_section_is_a_barrier() -> None:
    """Ursell (1947), deep water: |R|^2 = pi^2 I1^2/(pi^2 I1^2 + K1^2) of k T."""
    for kT in (0.3, 1.0):
        thin = Section(0.001, 0.1, 10.0, density=RHO)
        reflected, _ = thin.scattered(math.sqrt(G * kT / 0.1))
        over = (math.pi * iv(1, kT)) ** 2
        printed = over / (over + kv(1, kT) ** 2)
        # 40 functions beside the edge's singularity: 2 to 3 %.
        assert abs(reflected) ** 2 == pytest.approx(printed, rel=0.04)


def afloat(roll: float = 0.0, heave: float = 0.0) -> dict[str, np.ndarray]:
    """Give the section of the flume, with dampings as parts of critical."""
    mass = 46.8 / 0.586
    masses = np.array([mass, mass, mass * (0.36 * 0.4) ** 2])
    springs = np.array([59.4 / 0.586, RHO * G * 0.4, mass * G * 0.0629])
    whole = masses + np.diag(FLUME.at(5.4).added_mass.real)
    own = 2.0 * np.array([0.0, heave, roll]) * np.sqrt(springs * whole)
    return {"mass": np.diag(masses), "stiffness": np.diag(springs), "damping": np.diag(own)}


def test_short_waves_are_all_reflected_and_long_ones_pass() -> None:
    unit = 0.5 * RHO * G
    assert FLUME.drift(16.0) == pytest.approx(unit, rel=1e-3)
    assert FLUME.drift(16.0, **afloat()) == pytest.approx(unit, rel=0.02)
    assert FLUME.drift(0.8) < 0.02 * unit
    assert FLUME.drift(2.0, **afloat()) < 1e-3 * unit


def test_nothing_is_lost_but_by_damping() -> None:
    """Afloat without damping |R|^2 + |T|^2 = 1, so that both forms of the drift are one."""
    omega, unit = 5.0, 0.5 * RHO * G
    free = FLUME.drift(omega, **afloat())
    damped = FLUME.drift(omega, **afloat(roll=0.1))
    assert free <= unit * depth_factor(wave_number(omega, 1.0), 1.0) * (1.0 + ROUNDING)
    assert damped != pytest.approx(free, rel=1e-3)


@pytest.mark.parametrize("row", rows("section_drift.csv"), ids=lambda row: " ".join(row.values()))
def test_beside_a_flume(row: dict[str, str]) -> None:
    """Within 17 % of what was measured, which is known to some 10 %; 0.05 where it is small.

    The worst are 16 % above a fixed section in steep waves, of which all are reflected, and 16 %
    below a free one of two measured twice, 0.74 and 0.69.

    Its roll and heave lose more than their waves: by 5 % and 1.5 % of critical it heaves as
    measured, 1.7 times the wave at 1.158 s. The longest wave is one period long.
    """
    omega, measured = 2.0 * math.pi / float(row["period"]), float(row["drift"])
    found = FLUME.drift(omega, **({} if row["held"] == "fixed" else afloat(0.05, 0.015)))
    assert found / (0.5 * RHO * G) == pytest.approx(measured, rel=0.17, abs=0.05)


SHIPS = {
    "tanker": HullForm(246.0, 46.0, 10.0, 1000.0, block=92312.0 / (246 * 46 * 10)),
    "fpso": HullForm(200.0, 44.0, 12.0, 1000.0, block=97961.0 / (200 * 44 * 12)),
}


def bretschneider(omega: np.ndarray, peak: float) -> np.ndarray:
    """Shape alone."""
    w = 2.0 * math.pi / peak
    return omega**-5.0 * np.exp(-1.25 * (w / omega) ** 4)


def in_a_sea(ship: str, heading: int, peak: float) -> tuple[np.ndarray, np.ndarray]:
    """Mean over a sea of ours and of the panels', surge and sway over rho g/2."""
    table = [r for r in rows("ship_drift.csv") if (r["ship"], r["heading"]) == (ship, str(heading))]
    omega = np.array([2.0 * math.pi / float(r["period"]) for r in table])[::-1]
    theirs = np.array([[2.0 * float(r[key]) for key in ("surge", "sway")] for r in table])[::-1]
    of = SHIPS[ship]
    ours = np.array([of.mean_drift(w, math.radians(heading))[:2] for w in omega.tolist()])
    ours /= 0.5 * of.density * of.gravity
    weight = bretschneider(omega, peak)
    mean = [np.trapezoid(weight[:, np.newaxis] * each, omega, axis=0) for each in (ours, theirs)]
    return mean[0] / np.trapezoid(weight, omega), mean[1] / np.trapezoid(weight, omega)


@pytest.mark.parametrize("peak", [7.0, 9.0])
@pytest.mark.parametrize(("ship", "heading"), [(s, h) for s in SHIPS for h in (180, 150)])
def test_surge_in_a_sea_ahead(ship: str, heading: int, peak: float) -> None:
    """What a weathervaning ship meets: the method was not fitted to it."""
    ours, theirs = in_a_sea(ship, heading, peak)
    assert 0.95 < ours[0] / theirs[0] < 1.75


@pytest.mark.parametrize("peak", [7.0, 9.0])
@pytest.mark.parametrize(("ship", "heading"), [(s, h) for s in SHIPS for h in (120, 90)])
def test_sway_in_a_sea_aside(ship: str, heading: int, peak: float) -> None:
    ours, theirs = in_a_sea(ship, heading, peak)
    assert 0.75 < ours[1] / theirs[1] < 1.4


def test_the_ship_abeam_is_her_section() -> None:
    """Without ends or waterplane's lack: a box of 400 m, whose ends count for some 1 %."""
    box = HullForm(400.0, 20.0, 8.0, 60.0, block=1.0)
    mass = box.density * 20.0 * 8.0
    spring = np.diag([0.0, box.density * box.gravity * 20.0, 1e15])  # it does not roll
    for omega in (0.7, 1.2):
        alone = Section(20.0, 8.0, 60.0).drift(omega, mass=np.eye(3) * mass, stiffness=spring)
        _, sway, yaw = box.mean_drift(omega, 0.5 * math.pi)
        assert sway == pytest.approx(400.0 * alone, rel=0.03)
        assert yaw == pytest.approx(0.0, abs=1e-6 * sway * 400.0)


def test_a_barge_s_end_reflects_short_waves_whole() -> None:
    """1/2 rho g a^2 B of a flat bow; 2/3 of it for a round one, 1/4 for one of 30 deg, by hand.

    Faltinsen's integral of sin^2. What spreads along her sides comes on top: up to 2 %.
    """
    flat = HullForm(200.0, 20.0, 10.0, 100.0, block=1.0, entrance=0.5 * math.pi)
    unit = 0.5 * flat.density * flat.gravity * 20.0
    assert flat.mean_drift(3.0, math.pi)[0] == pytest.approx(-unit, rel=0.02)
    # An end as long as half the breadth: (1 - C) L/(2 - pi/2) = 10 m.
    shape = 1.0 - 10.0 * (2.0 - 0.5 * math.pi) / 200.0
    round_ = replace(flat, entrance=None, waterplane=shape)
    assert round_.mean_drift(3.0, math.pi)[0] == pytest.approx(-unit * 2.0 / 3.0, rel=0.02)
    wedge = replace(flat, entrance=math.radians(30.0))
    assert wedge.mean_drift(3.0, math.pi)[0] == pytest.approx(-unit * 0.25, rel=0.02)


def test_all_round_by_symmetry_and_by_the_table() -> None:
    of = replace(SHIPS["fpso"], depth=60.0)
    table = of.coefficients()
    omega = table.omega[20]
    for degrees in (20.0, 160.0, 200.0, 340.0):
        heading = math.radians(degrees)
        found = table.at("mean_drift", np.array([omega]), np.array([heading]))[0, [0, 1, 5]].real
        assert found == pytest.approx(of.mean_drift(float(omega), heading), rel=1e-6, abs=1.0)
        surge, sway, _ = found
        assert surge * math.cos(heading) > 0.0
        assert sway * math.sin(heading) > 0.0


def test_waves_damp_slow_surge_ahead_as_by_hand() -> None:
    """Head seas: B = omega/g (4 F + omega dF/domega), of a drift in proportion to omega squared.

    Then it is 6 omega F/g: 6 x 0.8 x 0.64/9.80665 = 0.3133 for F = omega^2, from astern, too. Aside
    it is 2 omega F/g of a drift that keeps along the waves.
    """
    omega = np.linspace(0.2, 2.0, 2001)
    headings = np.linspace(0.0, 2.0 * math.pi, 37)
    table = np.zeros((omega.size, headings.size, 6))
    table[:, :, 0] = np.outer(omega**2, np.cos(headings))
    table[:, :, 1] = np.outer(omega**2, np.sin(headings))
    of = Coefficients(omega, headings, mean_drift=table)
    ahead, astern = (
        wave_drift_damping(of, np.array([0.8]), np.array([each]))[0] for each in (math.pi, 0.0)
    )
    assert ahead[0, 0] == pytest.approx(0.3133, rel=1e-3)
    assert astern[0, 0] == pytest.approx(0.3133, rel=1e-3)
    assert ahead[0, 1] == pytest.approx(0.0, abs=1e-6)
    # Chords of 10 deg in the table: 0.5 %.
    assert ahead[1, 1] == pytest.approx(2.0 * 0.8 / 9.80665 * 0.64, rel=0.02)


def meeting(hull: HullForm, omega: float, heading: float) -> _Meeting:
    section = Section(hull.breadth, hull.draught, hull.depth, 0.0, hull.density, hull.gravity)
    return _Meeting(_InWaves(hull, section.at(omega)), math.cos(heading), math.sin(heading))


def test_long_waves_carry_the_ship_whose_drift_is_sought() -> None:
    """She goes where the surface goes; starboard is where they come from, pitch is bow down."""
    found = meeting(HullForm(200.0, 40.0, 12.0, 60.0, block=1.0), 0.02, 0.5)
    k, c, s = wave_number(0.02, 60.0), math.cos(0.5), math.sin(0.5)
    level = 1j / math.tanh(k * 60.0)  # way of the water along a crest of 1 m
    assert found.heave == pytest.approx(1.0, abs=0.01)
    assert found.pitch == pytest.approx(-1j * k * c, rel=0.01)
    assert found.sway == pytest.approx(-level * s, rel=0.01)
    assert found._surge() == pytest.approx(level * c, rel=0.01)


def test_she_surges_with_the_water_in_her_place() -> None:
    """Beside quadrature of the water's own way over her length and her draught."""
    found = meeting(HullForm(200.0, 40.0, 12.0, 60.0, block=0.8), 0.5, 2.6)
    k, c = wave_number(0.5, 60.0), math.cos(2.6)
    down = quad(lambda z: math.cosh(k * (z + 60.0)) / math.sinh(k * 60.0), -12.0, 0.0)[0] / 12.0
    along = quad(lambda x: math.cos(k * c * x), -100.0, 100.0)[0] / 200.0
    assert found._surge() == pytest.approx(1j * c * along * down, rel=1e-9)


def test_rolling_changes_the_drift_abeam() -> None:
    still, omega = SHIPS["fpso"], 2.0 * math.pi / 14.0
    rolls = replace(still, roll_period=14.0)
    a, b = (of.mean_drift(omega, 0.5 * math.pi)[1] for of in (still, rolls))
    assert b > 1.2 * a > 0.0


def test_all_that_is_wrong_is_said_at_once() -> None:
    with pytest.raises(InputError) as caught:
        HullForm(0.0, 46.0, 10.0, 1000.0, block=1.2)
    assert {each.key for each in caught.value.problems} == {"length", "block"}
    with pytest.raises(InputError):
        HullForm(246.0, 46.0, 10.0, 9.0, block=0.8)
    with pytest.raises(InputError):
        Section(1.0, 2.0, 1.0)
