"""RAOs out of WAMIT's .4 files: by hand, and beside the same ship as a table."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.model import Motion
from catopt.verify.motion_file import read_vessel_raos

GIVEN = Motion(
    rao_file="ship.4",
    rao_phase="lead",
    rao_reference=(0.0, 0.0, 20.0),
    rao_rotation="rad/m",
    rao_per="amplitude",
    rao_crest=(0.0, 0.0),
)
SHIP = {  # period, heading: surge, heave, pitch as (size, lead in deg)
    (8.0, 0.0): ((0.4, 90.0), (0.5, -10.0), (0.010, 80.0)),
    (8.0, 180.0): ((0.4, -90.0), (0.6, -20.0), (0.012, 100.0)),
    (12.0, 0.0): ((0.8, 90.0), (0.9, -5.0), (0.016, 85.0)),
    (12.0, 180.0): ((0.8, -90.0), (0.95, -7.0), (0.018, 95.0)),
}


def row(per: float, beta: float, freedom: int, mod: float, phs: float) -> str:
    """Write a row as WAMIT prints it."""
    z = cmath.rect(mod, math.radians(phs))
    return (
        f"{per:14.6E}{beta:14.6E}{freedom:6d}{mod:14.6E}{phs:14.6E}{z.real:14.6E}{z.imag:14.6E}\n"
    )


def written() -> str:
    return "".join(
        row(per, beta, freedom, *value)
        for (per, beta), values in SHIP.items()
        for freedom, value in zip((1, 3, 5), values, strict=True)
    )


def given(folder: Path, text: str, **other: object) -> Motion:
    path = folder / "ship.4"
    path.write_text(text)
    return replace(GIVEN, rao_file=str(path), **other)  # type: ignore[arg-type]


def test_a_fairlead_by_hand(tmp_path: Path) -> None:
    """Bow fairlead 100 m ahead and 10 m up: heave - pitch x, surge + pitch z."""
    raos = read_vessel_raos(given(tmp_path, written())).of_point(math.pi, (100.0, 0.0, 30.0))
    assert raos.omega == pytest.approx([2.0 * math.pi / 12.0, 2.0 * math.pi / 8.0])

    def lag(size: float, lead: float) -> complex:
        return cmath.rect(size, -math.radians(lead))

    surge, heave, pitch = (lag(*value) for value in SHIP[8.0, 180.0])
    assert raos.response[1, 0] == pytest.approx(surge + 10.0 * pitch, rel=1e-6)
    assert raos.response[1, 1] == 0.0
    assert raos.response[1, 2] == pytest.approx(heave - 100.0 * pitch, rel=1e-6)


def test_the_same_ship_as_a_table(tmp_path: Path) -> None:
    heads = "heading (deg),period (s),surge (m/m),surge_phase (deg),heave (m/m),heave_phase (deg),"
    lines = [heads + "pitch (rad/m),pitch_phase (deg)"]
    for (per, beta), values in SHIP.items():
        lines.append(",".join(map(str, (beta, per, *(x for value in values for x in value)))))
    table = tmp_path / "ship.csv"
    table.write_text("\n".join(lines) + "\n")
    ours = read_vessel_raos(given(tmp_path, " header of a run\n" + written()))
    other = read_vessel_raos(replace(GIVEN, rao_file=str(table)))
    assert np.array_equal(ours.heading, other.heading)
    assert np.array_equal(ours.omega, other.omega)
    assert ours.response == pytest.approx(other.response, rel=1e-6)


def test_a_phase_that_lags_is_the_conjugate(tmp_path: Path) -> None:
    lead = read_vessel_raos(given(tmp_path, written())).response
    lag = read_vessel_raos(given(tmp_path, written(), rao_phase="lag")).response
    assert np.array_equal(lag, lead.conj())


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (row(8, 0, 1, 0.4, 90).replace("4.000000E-01", "0.4") + "8 0 3 0.5\n", "line 2"),
        (row(8, 0, 1, 0.4, 90) + "8 0 3 0.5 ten 0.5 0\n", "numbers are required"),
        (row(8, 0, 1, 0.4, 90) + row(-1, 0, 1, 1.0, 0), "remove the rows of zero and infinite"),
        (row(8, 0, 1, 0.4, 90) + row(8, 0, 7, 0.4, 90), "no generalised modes"),
        (row(8, 0, 1, 0.4, 90) * 2, "twice"),
        (row(8, 0, 1, 0.4, 90) + row(9, 0, 3, 0.4, 90), "given at other periods"),
        ("8 0 1 0.4 90 0.4 0.0\n", "another kind of file"),
        ("words\n", "rows of PER BETA I MOD PHS RE IM"),
        (row(8, 0, 1, 0.4, 90) + row(9, 30, 1, 0.4, 90), "every heading has the same ones"),
    ],
)
def test_what_is_wrong_in_a_file_is_told(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(InputError) as caught:
        read_vessel_raos(given(tmp_path, text))
    assert told in str(caught.value)


def test_conventions_that_no_such_file_has(tmp_path: Path) -> None:
    motion = given(tmp_path, written(), rao_rotation="deg/m", rao_per="height", rao_crest=())
    with pytest.raises(InputError) as caught:
        read_vessel_raos(motion)
    assert len(caught.value.problems) == 3
    assert "ULEN" in str(caught.value)
    assert "motion.rao_crest: missing" in str(caught.value)
