"""Every table passes one gate: unit, heading, cell, count."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from catopt import InputError
from catopt.dimensions import Dimension
from catopt.tables import Column, heading, number, read_numbers, read_sheet
from catopt.verify.motion_file import read_current, read_force, read_motion, read_raos

HALVES = [0.5 * k for k in range(8)]


def written(folder: Path, text: str) -> str:
    path = folder / "table.csv"
    path.write_text(text, encoding="utf-8")
    return str(path)


def motion(folder: Path, heads: str, size: float = 1.0, time: float = 1.0) -> np.ndarray:
    rows = "".join(f"{t * time!r},{math.sin(t) * size!r}\n" for t in HALVES)
    found = read_motion(written(folder, f"{heads}\n{rows}"), 0.0)
    return np.column_stack([found.times, found.values[:, 0]])


@pytest.mark.parametrize(
    ("heads", "size", "time"),
    [
        ("t (s),x (m)", 1.0, 1.0),
        ("t (s),x (cm)", 100.0, 1.0),
        ("t (s),x [mm]", 1000.0, 1.0),
        ("t (s),x (ft)", 1.0 / 0.3048, 1.0),
        ("t (min),x (m)", 1.0, 1.0 / 60.0),
        ("T [ms],X (km)", 1e-3, 1e3),
    ],
)
def test_a_heading_in_any_unit_is_the_same_motion(
    tmp_path: Path, heads: str, size: float, time: float
) -> None:
    wanted = np.column_stack([HALVES, np.sin(HALVES)])
    assert motion(tmp_path, heads, size, time) == pytest.approx(wanted, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("heads", ["t (s),x (kN)", "t (m),x", "t,x (metre ton)", "t,x (m) y"])
def test_a_unit_of_something_else_is_refused(tmp_path: Path, heads: str) -> None:
    with pytest.raises(InputError, match="headings: found"):
        motion(tmp_path, heads)


def test_phases_of_a_fairlead_are_in_the_unit_of_their_heading(tmp_path: Path) -> None:
    rows = "period,surge,surge_phase{}\n4,0.1,{}\n8,0.5,{}\n"
    degrees = read_raos(written(tmp_path, rows.format(" (deg)", 30, 90)))
    radians = read_raos(written(tmp_path, rows.format(" (rad)", math.pi / 6, math.pi / 2)))
    assert radians.response == pytest.approx(degrees.response, rel=1e-12)
    minutes = written(tmp_path, "period (min),surge\n0.1,0.5\n0.2,0.5\n")
    assert read_raos(minutes).omega == pytest.approx([2 * math.pi / 12, 2 * math.pi / 6])


@pytest.mark.parametrize("bad", ["1e308", "1_0", "\uff11\uff12", "nan", "inf", "", "0x1", "#N/A"])
def test_what_is_no_plausible_number_is_refused(tmp_path: Path, bad: str) -> None:
    rows = "".join(f"{t},{bad if t == 1.0 else t}\n" for t in HALVES)
    with pytest.raises(InputError, match="line 4, x"):
        read_motion(written(tmp_path, "t,x\n" + rows), 0.0)


def test_a_row_that_begins_with_a_hash_is_a_row(tmp_path: Path) -> None:
    rows = "".join(f"{'#' if t == 1.0 else ''}{t},1\n" for t in HALVES)
    with pytest.raises(InputError, match=r"line 5, t: found #1\.0"):
        read_force(written(tmp_path, "# above\nt (s),Fx (kN)\n" + rows), 0.0)


def test_comments_are_above_the_headings_or_have_no_cells(tmp_path: Path) -> None:
    text = "# a, b\n\ntime (min),speed (kn)\n0,1\n# it turns here\n\n,\n1,2\n"
    path = written(tmp_path, text)
    sheet = read_sheet(Path(path), path)
    assert [row.line for row in sheet.rows] == [4, 8]
    assert sheet.skipped == 1
    found = read_current(path, 60.0)
    assert found.times == pytest.approx([0.0, 60.0])
    assert found.speeds == pytest.approx([1852 / 3600, 2 * 1852 / 3600])


def test_the_decimal_comma_of_a_table_parted_by_semicolons(tmp_path: Path) -> None:
    path = written(tmp_path, "time (s);speed (m/s)\n0,5;1.25\n1;0,125\n")
    sheet = read_sheet(Path(path), path)
    columns = {"time": Column(Dimension.TIME), "speed": Column(Dimension.SPEED)}
    found = read_numbers(sheet, columns, needed=("time", "speed"))
    assert found == {"time": [0.5, 1.0], "speed": [1.25, 0.125]}


@pytest.mark.parametrize("text", ['t,x\n0,"1\n2,3\n', 't,x\n0,"1" 2\n', "t,x\n0,1,2\n", "t,x\n0\n"])
def test_a_row_of_other_cells_is_refused(tmp_path: Path, text: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(InputError, match="line 2"):
        read_sheet(Path(path), path)


def test_a_table_has_a_budget_of_cells(tmp_path: Path) -> None:
    path = written(tmp_path, "t,x\n" + "1,2\n" * 1_500_001)
    with pytest.raises(InputError, match="at most 3,000,000 are allowed"):
        read_sheet(Path(path), path)


def test_headings_and_numbers() -> None:
    assert heading(" hs [m] ") == ("hs", "m")
    assert math.isnan(number("1,5"))
    assert number("1.234,5", is_decimal_comma=True) == 1234.5
