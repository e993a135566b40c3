"""Reading a study file: every error at once, each with its place and the way out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.study.file import read_study
from catopt.study.study import Study

CASES = Path(__file__).parents[2] / "cases"
BUOY = CASES / "buoy-9.5m" / "case.toml"
HEAD = f'case = "{BUOY.as_posix()}"\ncompute = "statics"\n'
FORCE = '[[vary]]\nkey = "load.horizontal_force"\n'


def study(folder: Path, text: str, head: str = HEAD) -> Study:
    (folder / "study.toml").write_text(head + text, encoding="utf-8")
    return read_study(folder / "study.toml")


def refused(folder: Path, text: str, head: str = HEAD) -> str:
    with pytest.raises(InputError) as caught:
        study(folder, text, head)
    return str(caught.value)


def test_values_take_units_and_are_multiplied_last_fastest(tmp_path: Path) -> None:
    text = FORCE + 'values = ["1 tf", 5000.0]\n'
    text += '[[vary]]\nkey = "line.segments[0].length"\nmin = "20 m"\nmax = "22 m"\ncount = 3\n'
    found = study(tmp_path, text)
    assert len(found) == 6
    assert [found.values_of(k)["load.horizontal_force"] for k in (0, 2, 3)] == pytest.approx(
        [9806.65, 9806.65, 5000.0]
    )
    lengths = [found.values_of(k)["line.segments[0].length"] for k in range(6)]
    assert lengths == [20.0, 21.0, 22.0, 20.0, 21.0, 22.0]


def test_rows_of_a_table_go_together_with_their_weights(tmp_path: Path) -> None:
    rows = "load.horizontal_force (kN), depth (m), hours\n3.0, 9.4, 1\n4.0, 9.5, 3\n"
    (tmp_path / "t.csv").write_text(rows)
    text = '[[vary]]\ntable = "t.csv"\nweight = "hours"\ncolumns = { depth = "site.water_depth" }\n'
    found = study(tmp_path, text)
    assert found.values_of(1) == {"load.horizontal_force": 4000.0, "site.water_depth": 9.5}
    assert found.shares().tolist() == [0.25, 0.75]


def test_semicolons_come_with_decimal_commas(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text(
        "load.horizontal_force (tf);line.segments[0].length (m)\n0,343;20,5\n"
    )
    found = study(tmp_path, '[[vary]]\ntable = "t.csv"\n')
    assert found.values_of(0) == pytest.approx(
        {"load.horizontal_force": 343.0 * 9.80665, "line.segments[0].length": 20.5}
    )


@pytest.mark.parametrize(
    ("form", "mean", "deviation"),
    [
        ('distribution = "normal"\nmean = "3 kN"\ndeviation = "0.3 kN"', 3000.0, 300.0),
        ('distribution = "lognormal"\nmean = "3 kN"\ndeviation = "0.3 kN"', 3000.0, 300.0),
        ('distribution = "gumbel"\nmean = "3 kN"\ndeviation = "0.3 kN"', 3000.0, 300.0),
        ('distribution = "uniform"\nmin = "2 kN"\nmax = "4 kN"', 3000.0, 2000.0 / 12.0**0.5),
    ],
)
def test_draws_have_the_mean_and_the_deviation_asked_for(
    tmp_path: Path, form: str, mean: float, deviation: float
) -> None:
    n = 40_000
    head = HEAD + f"samples = {n}\n"
    drawn = study(tmp_path, FORCE + form + "\n", head).axes[0].columns["load.horizontal_force"]
    error = deviation / n**0.5
    assert abs(np.mean(drawn) - mean) < 4.0 * error
    # The standard error of a deviation is below 1.1 times that of a mean for all of them (kurtosis
    # of a Gumbel 5.4: sqrt(4.4 / 4) = 1.05).
    assert abs(np.std(drawn) - deviation) < 4.0 * 1.1 * error
    again = study(tmp_path, FORCE + form + "\n", head).axes[0].columns["load.horizontal_force"]
    assert np.array_equal(drawn, again)
    other = study(tmp_path, FORCE + form + "\n", head + "seed = 2\n")
    assert not np.array_equal(drawn, other.axes[0].columns["load.horizontal_force"])


def test_every_error_of_the_file_is_told_at_once(tmp_path: Path) -> None:
    said = refused(
        tmp_path,
        '[[vary]]\nkey = "load.horizontal_forse"\nvalues = [1.0]\n'
        '[[vary]]\nkey = "line.segments[1].length"\nvalues = [20.0]\n'
        '[[vary]]\nkey = "site.water_depth"\nvalues = ["9 m", "-9 m", "9 kN"]\n'
        '[[vary]]\nkey = "load.span"\nmin = "17 m"\n'
        '[[vary]]\ntable = "none.csv"\n',
        HEAD + 'limits = { tension = "3 kN" }\n',
    )
    assert "6 errors" in said or "7 errors" in said
    assert "did you mean horizontal_force?" in said
    assert "vary[1].key" in said
    assert "the file has 1 of them" in said
    assert "vary[2].values[1]" in said
    assert "vary[2].values[2]" in said
    assert "vary[3]" in said
    assert "key and min and max and count" in said
    assert "there is no such file" in said
    assert "limits.tension" in said
    assert "fairlead_tension" in said


def test_a_table_tells_its_headings_and_its_cells(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text(
        "load.horizontal_force,site.water_depth (kN),nonsense,line.segments[0].length (m)\n"
        "3.0,9.5,1,twenty\n3.0,9.5,1,-2\n"
    )
    said = refused(tmp_path, '[[vary]]\ntable = "t.csv"\n')
    assert "load.horizontal_force (N)" in said  # the unit that is missing
    assert "site.water_depth (kN)" in said
    assert '"nonsense"' in said
    assert "leave the column out" in said
    assert "line.segments[0].length, value 1" in said
    assert "twenty" in said
    (tmp_path / "t.csv").write_text("line.segments[0].length (m)\n20\n-2\n")
    said = refused(tmp_path, '[[vary]]\ntable = "t.csv"\n')
    assert "value 2" in said
    assert "above 0" in said


def test_the_words_of_another_file_are_not_told(tmp_path: Path) -> None:
    (tmp_path / "credentials").write_text("password:hunter2\nTOKEN=hunter2\n")
    said = refused(tmp_path, '[[vary]]\ntable = "credentials"\n')
    assert "headings of" in said
    assert "hunter2" not in said


@pytest.mark.parametrize(
    ("text", "head", "told"),
    [
        (FORCE + "values = [3e3]\n" + FORCE + "values = [4e3]\n", HEAD, "varied already"),
        (FORCE + 'distribution = "normal"\nmean = 3e3\ndeviation = 10.0\n', HEAD, "samples"),
        (FORCE + 'distribution = "normal"\nmin = 3e3\nmax = 4e3\n', HEAD + "samples = 9\n",
         "mean and deviation"),
        (FORCE + 'distribution = "lognormal"\nmean = 3e3\ndeviation = -1.0\n',
         HEAD + "samples = 9\n", "above 0"),
        (FORCE + "values = [3e3]\n", HEAD + "samples = 9\n", "nothing is drawn"),
        (FORCE + "values = [3e3]\n", HEAD + 'proof = "none"\n', 'compute = "motion"'),
        (FORCE + "values = [3e3]\n", HEAD.replace("statics", "sizing"), "file for catopt size"),
        ('[[vary]]\nkey = "line.segments"\nvalues = [3e3]\n', HEAD, "an array"),
        ('[[vary]]\nkey = "title"\nmin = 1\nmax = 2\ncount = 2\n', HEAD, "not a number"),
        (FORCE + "values = [3e3]\ncolour = 1\n", HEAD, "colour"),
    ],
)  # fmt: skip
def test_what_does_not_go_is_refused(tmp_path: Path, text: str, head: str, told: str) -> None:
    assert told in refused(tmp_path, text, head)


def test_a_wrong_case_is_told_by_its_own_name(tmp_path: Path) -> None:
    bad = BUOY.read_text().replace("[site]", "[sight]")
    (tmp_path / "bad.toml").write_text(bad)
    said = refused(tmp_path, FORCE + "values = [3e3]\n", 'case = "bad.toml"\ncompute = "statics"\n')
    assert "bad.toml" in said
    assert "sight" in said


def test_checks_want_something_to_check(tmp_path: Path) -> None:
    said = refused(tmp_path, FORCE + "values = [3e3]\n", HEAD.replace("statics", "checks"))
    assert "nothing to check" in said


def test_the_digest_follows_what_decides_the_numbers(tmp_path: Path) -> None:
    same = study(tmp_path, FORCE + "values = [3e3]\n")
    assert same.digest == study(tmp_path, "# a comment\n" + FORCE + 'values = ["3 kN"]\n').digest
    assert same.digest != study(tmp_path, FORCE + "values = [3001.0]\n").digest
    other = HEAD.replace("buoy-9.5m", "buoy-9.5m-slack")
    assert same.digest != study(tmp_path, FORCE + "values = [3e3]\n", other).digest


def test_a_parquet_file_is_the_same_table(tmp_path: Path) -> None:
    pd = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    rows = pd.DataFrame({"load.horizontal_force (kN)": [3.0, 4.5], "hours": [10, 20]})
    rows.to_csv(tmp_path / "t.csv", index=False)
    rows.to_parquet(tmp_path / "t.parquet")
    read = []
    for name in ("t.csv", "t.parquet"):
        text = f'[[vary]]\ntable = "{name}"\nweight = "hours"\n'
        (axis,) = study(tmp_path, text).axes
        assert axis.weights is not None
        read.append((axis.columns["load.horizontal_force"], axis.weights))
    assert np.array_equal(read[0][0], read[1][0])
    assert np.array_equal(read[0][1], read[1][1])
    (tmp_path / "bad.parquet").write_bytes(b"no table")
    with pytest.raises(InputError, match="it is not a table"):
        study(tmp_path, '[[vary]]\ntable = "bad.parquet"\n')


def test_rows_that_begin_with_a_hash_are_rows(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("# above\ntitle, site.water_depth (m)\n#2 port, 8\n#N/A, 9\n")
    found = study(tmp_path, '[[vary]]\ntable = "t.csv"\n')
    assert found.axes[0].columns["title"] == ["#2 port", "#N/A"]
    assert found.axes[0].counted == "t.csv: 2 rows read, 0 skipped."
    (tmp_path / "t.csv").write_text("site.water_depth (m)\n8\n#9\n")
    assert 'found "#9"; a number is required' in refused(tmp_path, '[[vary]]\ntable = "t.csv"\n')


@pytest.mark.parametrize("cell", ["1_0", "\uff11\uff10", "1e+308", "inf"])
def test_a_cell_that_is_no_number_is_refused(tmp_path: Path, cell: str) -> None:
    (tmp_path / "t.csv").write_text(f"site.water_depth (m)\n8\n{cell}\n", encoding="utf-8")
    assert f"{cell}" in refused(tmp_path, '[[vary]]\ntable = "t.csv"\n')
