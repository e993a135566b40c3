"""Names that look like references: in charts they are text."""

from __future__ import annotations

import warnings
import zipfile
from pathlib import Path

from catopt.__main__ import main

HARD = Path(__file__).parents[1] / "hard_cases" / "xlsx_series_name.toml"


def test_a_name_with_a_reference_in_it_stays_a_name(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert main(["report", str(HARD), "--out", str(tmp_path)]) == 0
    (book,) = tmp_path.glob("*.xlsx")
    with zipfile.ZipFile(book) as parts:
        charts = [parts.read(each).decode() for each in parts.namelist() if "charts/chart" in each]
    assert any("<c:v>clump weight: W=!A1" in each for each in charts)
    assert not any("<c:f>clump weight" in each for each in charts)
