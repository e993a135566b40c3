"""A hull of coefficient files, alone and on its lines: beside frequency, and statics."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from catopt import solve_system
from catopt.casefile import parse_case, write_case
from catopt.errors import InputError
from catopt.fem.newmark import Scheme
from catopt.fem.run_settings import TimeStepping
from catopt.floater.alone import run_alone
from catopt.floater.hulls import mass_about_point
from catopt.hydro.build import HullOfCoefficients
from catopt.model import HullAfloat
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_lines import LinesOfAFloater
from catopt.verify.dynamic_setup import read_drive
from catopt.verify.linear import linear_lines
from catopt.waves import Sea, regular_wave
from tests.floater.test_linear_body import hull


@pytest.mark.parametrize("row", [5, 10, 18])
def test_alone_it_answers_regular_waves_as_by_frequency(row: int) -> None:
    """Within 1 % of capytaine's RAOs in oblique waves of 18, 9.5 and 6 s; roll by its largest.

    By the kernel that steps buoys, with the same hull that `LinearBody` steps.
    """
    body, rao = hull()
    assert body.damping is not None
    memory = body.coefficients.memory(120.0)
    laid = HullOfCoefficients(
        body.coefficients,
        body.mass,
        body.stiffness,
        memory,
        body.coefficients.infinite(memory),
        displacement=float(body.mass[0, 0]),
        damping=tuple(np.diag(body.damping)),
        gravity=9.81,
    )
    w = float(body.coefficients.omega[row])
    period = 2.0 * math.pi / w
    wave = regular_wave(0.02, period, direction=math.radians(150.0))
    stepping = TimeStepping(
        80 * period, period / 120, ramp_time=30 * period, scheme=Scheme.average_acceleration()
    )
    sea = Sea(2000.0, wave)
    found = run_alone(laid, stepping, sea=sea)
    assert found.free.all()
    late = found.time >= 70 * period
    time = found.time[late]
    free = [np.ones(time.size), time]  # surge, sway and yaw drift, with nothing to hold them
    basis = np.stack([*free, np.cos(w * time), np.sin(w * time)], axis=1)
    *_, even, odd = np.linalg.lstsq(basis, found.place[late], rcond=None)[0]
    # It meets the wave where it has drifted to.
    x, y = found.place[late, :2].mean(axis=0)
    ahead = x * math.cos(wave.direction[0]) + y * math.sin(wave.direction[0])
    lag = sea.wave_numbers[0] * ahead + wave.phase[0]
    answered = (even + 1j * odd) * np.exp(-1j * lag) / float(wave.amplitude[0])
    scale = np.abs(rao[row])
    scale[3] = np.abs(rao[:, 3]).max()
    assert (np.abs(answered - rao[row]) <= 0.01 * scale).all()
    assert found.numerical_part < 1e-3
    assert found.volume == 0.0


def test_mass_about_the_point_of_the_files() -> None:
    """By the parallel axes, by hand: 2 t at (3, 0, -4) m."""
    matrix = mass_about_point(HullAfloat("", 2000.0, (3.0, 0.0, -4.0), (1.0, 2.0, 3.0)))
    assert matrix == pytest.approx(matrix.T)
    assert np.diag(matrix)[3:] == pytest.approx([2e3 * 17.0, 2e3 * (4.0 + 25.0), 2e3 * (9.0 + 9.0)])
    assert matrix[0, 4] == -8e3  # pitching forwards the centre, 4 m below, goes aft
    assert matrix[2, 4] == -6e3
    assert matrix[1, 5] == 6e3
    assert matrix[3, 5] == 2e3 * 12.0


def written_files(folder: Path) -> None:
    """Write a barge of 40 x 40 m in WAMIT's files, its added mass constant; no panels stand behind.

    ULEN is 1 m: A/rho, B/(rho w), X/(rho g), C/(rho g).
    """
    rho, g = 1025.0, 9.80665
    added, damped = (4e6, 4e6, 8e6, 8e8, 8e8, 8e8), (2e5, 2e5, 1e6, 1e7, 1e7, 1e6)
    radiation, force = [], []
    for period in (4.0, 6.0, 8.0, 12.0, 20.0, 30.0):
        w = 2.0 * math.pi / period
        for i in range(6):
            B = damped[i] * math.exp(-((w - 0.9) ** 2) / 0.1)
            radiation.append(f"{period} {i + 1} {i + 1} {added[i] / rho} {B / (rho * w)}")
        for heading in (0.0, 90.0, 180.0, 270.0, 360.0):
            c, s = math.cos(math.radians(heading)), math.sin(math.radians(heading))
            sizes = (2e6 * c, 2e6 * s, 1.2e7, -1e7 * s, 1e7 * c, 0.0)
            for i, size in enumerate(sizes):
                X = size / (rho * g)
                phase = 0.0 if X >= 0.0 else 180.0
                force.append(f"{period} {heading} {i + 1} {abs(X)} {phase} {X} 0.0")
    water = {3: 1600.0, 4: 2e5, 5: 2e5}
    rows = [f"{i} {j} {water.get(i, 0.0) if i == j else 0.0}"
            for i in range(1, 7) for j in range(1, 7)]  # fmt: skip
    (folder / "barge.1").write_text("\n".join(radiation) + "\n")
    (folder / "barge.3").write_text("\n".join(force) + "\n")
    (folder / "barge.hst").write_text("\n".join(rows) + "\n")


CASE = """
[site]
water_depth = "50 m"
[line]
fairlead_height = "48 m"
[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "400 m"
[system]
anchor_radius = "400 m"
azimuths = ["45 deg", "135 deg", "225 deg", "315 deg"]
fairlead_radius = "20 m"
force = ["300 kN", "100 kN"]
[floater.hull]
file = "@FILE"
ulen = "1 m"
mass = "4000 t"
centre_of_gravity = ["0 m", "0 m", "2 m"]
gyration = ["12 m", "12 m", "15 m"]
damping = ["200 kN*s/m", "200 kN*s/m", "100 kN*s/m"]
roll_damping = 0.05
pitch_damping = 0.05
[waves]
spectrum = "jonswap"
height = "2 m"
period = "8 s"
direction = "30 deg"
components = 60
[checks]
codes = ["API-RP-2SK"]
motion_code = "API-RP-2SK"
[dynamics]
duration = "40 s"
ramp = "8 s"
elements = 12
"""


def case_text(folder: Path) -> str:
    written_files(folder)
    return CASE.replace("@FILE", str(folder / "barge.1"))


@pytest.mark.slow
def test_on_four_lines_by_the_case_file(tmp_path: Path) -> None:
    """At rest it is where the closed form has it, and floats deeper by what its lines pull down."""
    case = parse_case(case_text(tmp_path))
    assert parse_case(write_case(case)) == case
    assert case.system is not None
    rest = LinesOfAFloater.at_rest(read_drive(case)).moored_at_rest()
    closed = solve_system(case.system)
    x, y, z = rest.state.q.tolist()
    assert (x, y) == pytest.approx((closed.position.x, closed.position.y), rel=0.02)
    assert z - 50.0 == pytest.approx(rest.line[2] / (1600.0 * 1025.0 * 9.80665), rel=0.01)
    assert rest.line[:2] == pytest.approx((-3e5, -1e5), abs=100.0)
    found = verify_dynamic(case, convergence_check="none", compares_at_rest=False)
    names = {each.quantity for each in found.body}
    assert names == {f"floater_{key}" for key in ("x", "y", "z", "roll", "pitch", "yaw")}
    (run,) = found.parts[0].runs
    moved = run.hull
    assert moved is not None
    assert moved.numerical_part < 1e-2
    assert moved.scene is None
    assert np.ptp(moved.place[:, 2]) > 0.3
    said = " ".join(str(each) for each in found.parts[0].remarks)
    assert "a hull of 4000 t by the coefficients of barge" in said
    assert "no wind or current on the hull" in said


def test_what_does_not_go_together(tmp_path: Path) -> None:
    text = case_text(tmp_path)
    for change, key in (
        (("[floater.hull]", '[floater]\nwind_speed = "10 m/s"\n[floater.hull]'), "wind_speed"),
        (("[floater.hull]", '[floater]\nbuoy = "pillar 2.4 m"\n[floater.hull]'), "floater.hull"),
        (('gyration = ["12 m", "12 m", "15 m"]\n', ""), "floater.hull.gyration"),
    ):
        with pytest.raises(InputError, match=key):
            parse_case(text.replace(*change))
    for change, key in (
        (('ulen = "1 m"\n', ""), "floater.hull.ulen: missing"),
        (('mass = "4000 t"', 'weightless = true\nmass = "200000 t"'), "roll: .*weightless = true"),
    ):
        with pytest.raises(InputError, match=key):
            verify_dynamic(parse_case(text.replace(*change)))
    with pytest.raises(InputError, match=r"floater\.hull"):
        linear_lines(parse_case(text))
    (tmp_path / "barge.hst").unlink()
    with pytest.raises(InputError, match=r"floater\.hull\.file: found stiffness"):
        verify_dynamic(parse_case(text))
