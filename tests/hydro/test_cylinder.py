"""Floating cylinders against panels, and against what holds whatever the frequency.

`cylinders.csv`: ten cylinders at four frequencies each, computed with capytaine 3.0.0 (direct
method, Green's function of finite depth, density 1000 kg/m3, g 9.81 m/s2) on 760 to 2,352 panels,
48 around, closer at the edge, of the circle's area; pitch is about the waterline. Its added mass
falls with finer panels towards ours: by 0.3 % from 32 to 48 around in surge.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from scipy.special import h1vp, h2vp

from catopt.errors import InputError
from catopt.hydro.cylinder import HEAVE, PITCH, SURGE, FloatingCylinder, Matched

TABLE = pd.read_csv(Path(__file__).with_name("cylinders.csv"))
CYLINDERS = [
    pytest.param(rows, id="-".join(f"{each:g}" for each in key))
    for key, rows in TABLE.groupby(["radius_m", "draught_m", "depth_m"])
]
PER_CENT = 0.02
SMALL = 0.2
"""Part of the largest of a cylinder's frequencies below which that stands for the value: panels
find what is exponentially small to some tenths of a per cent of what is not, 24, 48 around:
5,968, 6,058 N s/m of 54,300; our series has 6,264 with 60 terms and 6,249 with 240."""


@pytest.mark.parametrize("rows", CYLINDERS)
def test_ten_cylinders_within_two_per_cent_of_panels(rows: pd.DataFrame) -> None:
    """Coupling and excitation beside the size of what they couple: some pass through zero."""
    first = rows.iloc[0]
    cylinder = FloatingCylinder(
        first.radius_m, first.draught_m, first.depth_m, density=1000.0, gravity=9.81
    )
    found = cylinder.at(rows.omega_rad_s.to_numpy())
    for part, names in (
        (found.added_mass, ("A11", "A33_kg", "A55_kgm2", "A15_kgm")),
        (found.damping, ("B11", "B33_kg_s", "B55", "B15")),
    ):
        surge, heave, pitch, both = (rows[name].to_numpy() for name in names)
        for of, theirs in ((SURGE, surge), (HEAVE, heave)):
            off = np.abs(part[:, of, of] - theirs)
            assert (off <= PER_CENT * np.maximum(theirs, SMALL * theirs.max())).all()
        # Damping in pitch of a disc is a small difference of side and bottom.
        least = 0.02 * first.draught_m**2 * surge
        off = np.abs(part[:, PITCH, PITCH] - pitch)
        assert (off <= PER_CENT * np.maximum(pitch, least / PER_CENT)).all()
        size = np.sqrt(surge * np.maximum(pitch, least / PER_CENT))
        assert (np.abs(part[:, SURGE, PITCH] - both) <= PER_CENT * size).all()
    for of, name in ((SURGE, "X1"), (HEAVE, "X3")):
        re = rows[f"{name}_re_N_m" if of == HEAVE else f"{name}_re"]
        theirs = re.to_numpy() + 1j * rows[f"{name}_im"].to_numpy()
        off = np.abs(found.excitation[:, of] - theirs)
        assert (off <= PER_CENT * np.maximum(np.abs(theirs), SMALL * np.abs(theirs).max())).all()


def test_figures_of_the_brief_cylinder() -> None:
    """80 terms gave 1.458 and 0.479 elsewhere, capytaine with 1,056 panels 1.442 and 0.471."""
    found = FloatingCylinder(0.9, 0.5, 12.0, density=1.0, gravity=9.81).at([2.0])
    assert found.added_mass[0, HEAVE, HEAVE] == pytest.approx(1.458, rel=0.01)
    assert found.damping[0, HEAVE, HEAVE] / 2.0 == pytest.approx(0.479, rel=0.01)


@pytest.mark.parametrize(("radius", "draught", "depth"), [(0.9, 0.5, 12.0), (5.0, 2.5, 20.0)])
def test_damping_is_that_of_the_waves_that_excite(
    radius: float, draught: float, depth: float
) -> None:
    """Haskind: B = k/(8 pi rho g c_g) times the mean square of the excitation over headings.

    The damping is an integral over the hull, the excitation the wave far away: they differ by what
    the series leaves out.
    """
    cylinder = FloatingCylinder(radius, draught, depth, density=1000.0, gravity=9.81)
    omega = np.array([0.8, 1.5, 2.2])
    found = cylinder.at(omega)
    for w, B, X in zip(omega, found.damping, found.excitation, strict=True):
        k = w * w / 9.81
        for _ in range(200):
            k = w * w / (9.81 * math.tanh(k * depth))
        group = 0.5 * w / k * (1.0 + 2.0 * k * depth / math.sinh(2.0 * k * depth))
        for of, headings in ((SURGE, 0.5), (HEAVE, 1.0), (PITCH, 0.5)):
            by_waves = k / (4.0 * 1000.0 * 9.81 * group) * headings * abs(X[of]) ** 2
            assert B[of, of] == pytest.approx(by_waves, rel=1e-3)


def test_long_waves_lift_by_the_waterplane_and_push_by_the_slope() -> None:
    cylinder = FloatingCylinder(1.2, 0.8, 10.0, density=1000.0, gravity=9.81)
    w = 0.02
    found = cylinder.at([w])
    k = w / math.sqrt(9.81 * 10.0)
    area = math.pi * 1.2**2
    assert found.excitation[0, HEAVE].real == pytest.approx(9810.0 * area, rel=1e-3)
    # Weight of the water displaced times the slope, and as much again on the added mass.
    displaced, added = 1000.0 * area * 0.8, found.added_mass[0, SURGE, SURGE]
    push = -1j * 9.81 * k * (displaced + added)
    assert found.excitation[0, SURGE] == pytest.approx(push, rel=1e-2)


def test_pressure_of_the_wave_alone_is_the_force_on_a_slender_cylinder() -> None:
    """Of a radius that scatters nothing: twice it in surge, by added mass as large as displaced."""
    thin = FloatingCylinder(0.05, 3.0, 20.0, density=1000.0, gravity=9.81)
    found = thin.at([1.5])
    both = found.excitation[0, SURGE] / found.froude_krylov[0, SURGE]
    assert both == pytest.approx(2.0, rel=0.02)
    assert found.excitation[0, HEAVE] == pytest.approx(found.froude_krylov[0, HEAVE], rel=0.02)


def test_fast_motion_is_the_limit() -> None:
    cylinder = FloatingCylinder(1.0, 1.0, 5.0, density=1000.0)
    fast = cylinder.at([60.0]).added_mass[0]
    limit = cylinder.at_infinite_frequency()
    # The surface is felt to the order of g/(omega^2 a) = 0.003 and its logarithm.
    assert fast[HEAVE, HEAVE] == pytest.approx(limit[HEAVE, HEAVE], rel=0.01)
    assert fast[SURGE, SURGE] == pytest.approx(limit[SURGE, SURGE], rel=0.03)


def test_refusals() -> None:
    with pytest.raises(InputError, match="draught"):
        FloatingCylinder(1.0, 5.0, 5.0)
    with pytest.raises(InputError, match="radius"):
        FloatingCylinder(0.0, 1.0, 5.0)


def _bottom_mounted(ka: float) -> np.ndarray:
    """S_m of a cylinder to the bed: MacCamy and Fuchs (1954), by hand."""
    m = np.arange(int(ka) + 12)
    return np.asarray(-h2vp(m, ka) / h1vp(m, ka))


def _drift(sent: np.ndarray, k: float, factor: float) -> float:
    """Over rho g a^2, of waves that go out: momentum far away."""
    return float(0.5 * factor / k * (1.0 - (sent[:-1] * sent[1:].conj()).real).sum())


@pytest.mark.parametrize("ka", [0.2, 0.5, 1.0, 2.0, 4.0])
def test_drift_of_a_cylinder_nearly_to_the_bed(ka: float) -> None:
    """10 cm of gap under 19.9 m: within 1 % of a cylinder without one, whose series is closed."""
    radius, depth = 5.0, 20.0
    k = ka / radius
    omega = math.sqrt(9.81 * k * math.tanh(k * depth))
    cylinder = FloatingCylinder(radius, 19.9, depth, density=1000.0, gravity=9.81)
    closed = _drift(_bottom_mounted(ka), k, 1.0 + 2.0 * k * depth / math.sinh(2.0 * k * depth))
    assert cylinder.drift(omega) / (1000.0 * 9.81) == pytest.approx(closed, rel=0.011)


def test_drift_of_long_and_of_short_waves() -> None:
    """Printed: 5 pi^2/16 (k a)^3 in deep water for long waves, 2/3 for short, over rho g a."""
    ka = 0.02
    long = _drift(_bottom_mounted(ka), ka, 1.0)
    assert long == pytest.approx(5.0 * math.pi**2 / 16.0 * ka**3, rel=0.01)
    whole = FloatingCylinder(5.0, 8.0, 40.0, density=1000.0, gravity=9.81)
    assert whole.drift(math.sqrt(9.81 * 12.0 / 5.0)) / (1000.0 * 9.81 * 5.0) == pytest.approx(
        2.0 / 3.0, rel=0.03
    )


def _afloat(cylinder: FloatingCylinder) -> tuple[np.ndarray, np.ndarray]:
    """Mass and stiffness of a cylinder with its centre of gravity where that of buoyancy is."""
    a, T = cylinder.radius, cylinder.draught
    mass = cylinder.density * math.pi * a * a * T
    z = -0.5 * T
    turning = mass * (0.25 * a * a + T * T / 12.0 + z * z)
    masses = np.array([[mass, 0.0, mass * z], [0.0, mass, 0.0], [mass * z, 0.0, turning]])
    weight = cylinder.density * cylinder.gravity * math.pi * a * a
    return masses, np.diag([0.0, weight, weight * 0.25 * a * a])


def test_drift_of_a_cylinder_afloat() -> None:
    """It follows long waves, which then pass; damping, which takes energy, pushes it the more."""
    cylinder = FloatingCylinder(5.0, 5.0, 200.0, density=1000.0, gravity=9.81)
    mass, stiffness = _afloat(cylinder)
    slow, fast = (math.sqrt(9.81 * ka / 5.0) for ka in (0.1, 0.7))
    assert cylinder.drift(slow, mass, stiffness) < 1e-4 * cylinder.drift(slow)
    damping = np.diag([0.0, 3e5, 0.0])
    free = cylinder.drift(slow, mass, stiffness)
    assert cylinder.drift(slow, mass, stiffness, damping) > 10.0 * free
    assert 0.2 < cylinder.drift(fast, mass, stiffness) / (1000.0 * 9.81 * 5.0) < 2.0


def test_a_cylinder_afloat_sends_out_what_comes_in() -> None:
    """Of each wave round it, to what truncation leaves: two thousandths of a per cent."""
    cylinder = FloatingCylinder(5.0, 5.0, 200.0, density=1000.0, gravity=9.81)
    mass, stiffness = _afloat(cylinder)
    for ka in (0.1, 0.8, 1.5):
        omega = math.sqrt(9.81 * ka / 5.0)
        of = Matched(cylinder, omega)
        own = stiffness - omega**2 * (mass + of.added_mass)
        speeds = -1j * omega * np.linalg.solve(own, of.excitation())
        assert np.abs(of.sent(speeds.tolist())) == pytest.approx(1.0, abs=2e-5)


def test_a_cylinder_three_times_as_large_follows_by_froude() -> None:
    """In waves three times as long: no length may stand by itself."""
    small = FloatingCylinder(0.8, 0.5, 4.0, 0.2, density=1000.0, gravity=9.81)
    large = FloatingCylinder(2.4, 1.5, 12.0, 0.6, density=1000.0, gravity=9.81)
    ours, theirs = small.at([1.5, 3.0]), large.at(np.array([1.5, 3.0]) / math.sqrt(3.0))
    lever = np.array([1.0, 1.0, 3.0])  # pitch has a length more than surge and heave
    turns = np.outer(lever, lever)
    assert theirs.added_mass == pytest.approx(27.0 * turns * ours.added_mass, rel=1e-9)
    per_time = 27.0 / math.sqrt(3.0)
    assert theirs.damping == pytest.approx(per_time * turns * ours.damping, rel=1e-9)
    assert theirs.excitation == pytest.approx(9.0 * lever * ours.excitation, rel=1e-9)
    assert theirs.froude_krylov == pytest.approx(9.0 * lever * ours.froude_krylov, rel=1e-9)
    assert large.at_infinite_frequency() == pytest.approx(
        27.0 * turns * small.at_infinite_frequency(), rel=1e-9
    )
