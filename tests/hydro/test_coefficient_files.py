"""Coefficients out of WAMIT's and capytaine's files: figures by hand, and what is refused."""

from __future__ import annotations

import contextlib
import math
import random
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

from catopt.errors import InputError, Problem
from catopt.hydro.coefficient_files import read_capytaine, read_wamit, wamit_rows
from catopt.hydro.coefficients import Coefficients
from catopt.words import say

HERE = Path(__file__).parent
OF = {"ulen": 2.0, "density": 1025.0, "gravity": 9.81}


def by_wave(period: float, heading: float, freedom: int, mod: float, lead: float) -> str:
    angle = math.radians(lead)
    tail = f"{mod:.6E} {lead:.6E} {mod * math.cos(angle):.6E} {mod * math.sin(angle):.6E}\n"
    return f" {period:.6E} {heading:.6E} {freedom} {tail}"


def ship(folder: Path, **files: str) -> Path:
    for end, text in files.items():
        (folder / f"ship.{end.strip('_')}").write_text(text)
    return folder / "ship"


RADIATION = (
    " -1.0 3 3 0.5\n 0.0 3 3 0.25\n 8.0 3 3 0.4 0.1\n 8.0 3 5 0.2 0.05\n 8.0 5 3 0.2 0.05\n"
    " 8.0 5 5 3.0 0.3\n 4.0 3 3 0.3D+00 0.2\n 4.0 3 5 0.1 0.01\n 4.0 5 3 0.1 0.01\n"
    " 4.0 5 5 2.0 0.4\n"
)


def test_every_file_by_hand(tmp_path: Path) -> None:
    """Factors of WAMIT's manual: rho L^k, omega, rho g L^m, and a lead that becomes a lag."""
    path = ship(
        tmp_path,
        _1=RADIATION,
        _3="WAMIT headings of a run\n"
        + "".join(by_wave(p, b, i, 0.5, 30.0) for p in (8, 4) for b in (0, 180) for i in (1, 5)),
        _8="".join(
            f"{p} {b} {b} 1 0.2 180. -0.2 0.\n" + f"{p} {b} {b} 6 0.1 0. 0.1 0.\n"
            for p in (8, 4)
            for b in (0, 180)
        )
        + "8 0 180 1 9 0 9 0\n",
        hst="3 3 2.0\n3 5 1.0\n5 3 1.0\n5 5 4.0\n",
    )
    found = read_wamit(path, **OF)
    assert found.omega == pytest.approx([2 * math.pi / 8, 2 * math.pi / 4])
    assert found.heading == pytest.approx([0.0, math.pi])
    assert found.added_mass is not None
    assert found.damping is not None
    assert found.added_mass_zero is not None
    assert found.added_mass_infinite is not None
    assert found.added_mass[0, 2, 2] == pytest.approx(0.4 * 1025 * 2**3)
    assert found.added_mass[1, 2, 4] == pytest.approx(0.1 * 1025 * 2**4)
    assert found.damping[1, 4, 4] == pytest.approx(0.4 * 1025 * 2**5 * 2 * math.pi / 4)
    assert found.added_mass_zero[2, 2] == pytest.approx(0.5 * 1025 * 8)
    assert found.added_mass_infinite[2, 2] == pytest.approx(0.25 * 1025 * 8)
    assert found.added_mass[:, 0, 0].tolist() == [0.0, 0.0]
    assert found.excitation is not None
    size, angle = 0.5 * 1025 * 9.81 * 2**2, math.radians(-30.0)
    assert found.excitation[0, 1, 0] == pytest.approx(
        complex(size * math.cos(angle), size * math.sin(angle)), rel=1e-5
    )
    assert abs(found.excitation[1, 0, 4]) == pytest.approx(0.5 * 1025 * 9.81 * 2**3, rel=1e-5)
    assert found.mean_drift is not None
    assert found.mean_drift[0, 0, 0] == pytest.approx(-0.2 * 1025 * 9.81 * 2)
    assert found.mean_drift[1, 1, 5] == pytest.approx(0.1 * 1025 * 9.81 * 2**2)
    assert found.stiffness is not None
    assert found.stiffness[4, 4] == pytest.approx(4.0 * 1025 * 9.81 * 2**4)
    assert found.remarks == ()
    assert read_wamit(f"{path}.3", **OF).source == "ship.1, ship.3, ship.8, ship.hst"


def test_faults_of_all_files_come_at_once(tmp_path: Path) -> None:
    path = ship(
        tmp_path,
        _1=" 8.0 3 3 0.4 0.1\n 8.0 3 3 x 0.1\n 8.0 7 3 0.4 0.1\n",
        _3=by_wave(8, 0, 1, 0.5, 30.0) + " 8.0 0.0 1 0.5 30.0 0.5 0.0\n -1.0 0 1 1 0 1 0\n",
    )
    with pytest.raises(InputError) as error:
        read_wamit(path, **OF)
    places = [say(each.key, "en") for each in error.value.problems]
    assert places == ["ship.1, line 2", "ship.1, line 3", "ship.3, line 2", "ship.3, line 3"]
    assert "ship.1, dòng 2" in say(error.value.problems[0].key, "vi")


def test_the_words_of_another_file_are_not_told(tmp_path: Path) -> None:
    other = tmp_path / "credentials"
    other.write_text("token 1\nhunter2\n")
    problems: list[Problem] = []
    wamit_rows(other, ".4", problems)
    assert [each.found for each in problems] == ["", ""]


def test_rows_that_lack_or_stand_twice(tmp_path: Path) -> None:
    twice = RADIATION + " 8.0 3 3 0.4 0.1\n"
    with pytest.raises(InputError, match="PER 8, I 3, J 3"):
        read_wamit(ship(tmp_path, _1=twice), **OF)
    lacking = RADIATION.replace(" 4.0 3 5 0.1 0.01\n", "")
    with pytest.raises(InputError, match="PER 4, I 3, J 5"):
        read_wamit(ship(tmp_path, _1=lacking), **OF)
    other = "".join(by_wave(p, 0, 1, 0.5, 30.0) for p in (8, 5))
    with pytest.raises(InputError, match="same periods"):
        read_wamit(ship(tmp_path, _1=RADIATION, _3=other), **OF)


def test_rotations_of_another_length_are_refused(tmp_path: Path) -> None:
    path = ship(tmp_path, _4=by_wave(8, 0, 5, 0.02, 30.0))
    with pytest.raises(InputError, match="ULEN"):
        read_wamit(path, **OF)
    found = read_wamit(path, **OF | {"ulen": 1.0})
    assert found.response is not None
    assert abs(found.response[0, 0, 4]) == pytest.approx(0.02, rel=1e-5)
    with pytest.raises(InputError, match=r"ulen|density") as error:
        read_wamit(path, ulen=0.0, density=-1.0, gravity=9.81)
    assert len(error.value.problems) == 2
    with pytest.raises(InputError, match=r"files: found none; \.1"):
        read_wamit(tmp_path / "other", **OF)


def test_remarks_on_what_no_body_has(tmp_path: Path) -> None:
    tilted = RADIATION.replace(" 8.0 5 3 0.2 0.05", " 8.0 5 3 -0.2 0.05")
    keys = [each.key for each in read_wamit(ship(tmp_path, _1=tilted), **OF).remarks]
    assert keys == ["floater.added_mass_unsymmetrical"]
    driven = RADIATION.replace("8.0 3 3 0.4 0.1", "8.0 3 3 0.4 -0.1")
    keys = [each.key for each in read_wamit(ship(tmp_path, _1=driven), **OF).remarks]
    assert keys == ["floater.damping_drives"]


def test_shapes() -> None:
    with pytest.raises(InputError) as error:
        Coefficients(np.array([2.0, 1.0]), np.zeros(1), damping=np.zeros((2, 3, 3)))
    assert [each.key for each in error.value.problems] == ["omega", "damping"]


def dataset() -> Any:
    xarray = pytest.importorskip("xarray")
    names = ["Heave", "Surge", "Sway", "Roll", "Pitch", "Yaw"]
    omega, ways = [math.inf, 0.0, 2.0, 1.0], [math.pi, 0.0]
    added = np.zeros((4, 6, 6))
    added[:, 0, 0] = [25.0, 50.0, 30.0, 40.0]
    added[3, 0, 4] = 7.0  # radiating heave, influenced pitch
    force = np.zeros((2, 4, 2, 6))
    force[0, 2, 0, 0], force[1, 2, 0, 0] = 3.0, 4.0
    pairs = ("radiating_dof", "influenced_dof")
    return xarray.Dataset(
        {
            "added_mass": (("omega", *pairs), added),
            "radiation_damping": (("omega", *pairs), 0.1 * added),
            "diffraction_force": (("complex", "omega", "wave_direction", "influenced_dof"), force),
            "Froude_Krylov_force": (
                ("complex", "omega", "wave_direction", "influenced_dof"),
                2.0 * force,
            ),
            "hydrostatic_stiffness": (("influenced_dof", "radiating_dof"), 5.0 * np.eye(6)),
        },
        {
            "omega": omega,
            "wave_direction": ways,
            "complex": ["re", "im"],
            "radiating_dof": names,
            "influenced_dof": names,
        },
    )


@pytest.mark.parametrize("engine", ["scipy", "h5netcdf"])
def test_capytaine_by_hand(tmp_path: Path, engine: Literal["scipy", "h5netcdf"]) -> None:
    path = tmp_path / "ship.nc"
    dataset().to_netcdf(path, engine=engine)
    found = read_capytaine(path)
    assert found.omega.tolist() == [1.0, 2.0]
    assert found.heading == pytest.approx([0.0, math.pi])
    assert found.added_mass is not None
    assert found.added_mass[:, 2, 2].tolist() == [40.0, 30.0]
    assert found.added_mass[0, 4, 2] == 7.0
    assert found.added_mass_zero is not None
    assert found.added_mass_infinite is not None
    assert (found.added_mass_zero[2, 2], found.added_mass_infinite[2, 2]) == (50.0, 25.0)
    assert found.excitation is not None
    assert found.excitation[1, 1, 2] == 9.0 + 12.0j
    assert found.stiffness is not None
    assert found.mass is None


def test_capytaine_refused(tmp_path: Path) -> None:
    path = tmp_path / "ship.nc"
    data = dataset().drop_vars(["added_mass", "omega"])
    data.to_netcdf(path, engine="scipy")
    with pytest.raises(InputError) as error:
        read_capytaine(path)
    assert [each.key for each in error.value.problems] == ["omega", "added_mass"]
    fewer = dataset().isel(radiating_dof=[0, 1], influenced_dof=[0, 1])
    fewer.to_netcdf(path, engine="scipy")
    with pytest.raises(InputError, match="six degrees of freedom"):
        read_capytaine(path)
    path.write_text("no netCDF")
    with pytest.raises(InputError, match=r"netCDF4 or h5netcdf"):
        read_capytaine(path)
    with pytest.raises(InputError, match="no such file"):
        read_capytaine(tmp_path / "other.nc")


def test_a_damaged_dataset_is_refused(tmp_path: Path) -> None:
    """Of 158 damaged ones 44 ended as a fault of catopt's own."""
    whole = tmp_path / "hull.nc"
    dataset().to_netcdf(whole, engine="scipy")
    rng, path, answers = random.Random(4), tmp_path / "damaged.nc", 0
    for _ in range(60):
        data = bytearray(whole.read_bytes())
        for _ in range(rng.choice((1, 3, 30))):
            data[rng.randrange(len(data))] = rng.randrange(256)
        path.write_bytes(bytes(data))
        with contextlib.suppress(InputError):
            answers += read_capytaine(path) is not None
    assert answers < 60
