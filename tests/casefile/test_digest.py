"""The digest of a case: by what its files hold, not where they are."""

from __future__ import annotations

from pathlib import Path

from catopt.casefile import case_digest, parse_case, write_case
from catopt.casefile.writing import text_digest
from tests.casefile.test_waves import CASE

CURRENT = """
[motion]
period = "8 s"
surge = "1 m"
[current]
profile = "power"
direction = "0 deg"
series_file = "current.csv"
"""


def digest_in(folder: Path, content: str) -> str:
    folder.mkdir(exist_ok=True)
    (folder / "current.csv").write_text(content, encoding="utf-8")
    return case_digest(parse_case(CASE + CURRENT, folder=str(folder)))


def test_the_same_files_elsewhere_are_the_same_case(tmp_path: Path) -> None:
    here = digest_in(tmp_path / "here", "time (s),speed (m/s)\n0,1\n")
    assert digest_in(tmp_path / "there", "time (s),speed (m/s)\n0,1\n") == here
    assert digest_in(tmp_path / "there", "time (s),speed (m/s)\n0,2\n") != here


def test_a_written_case_has_the_digest_of_the_case(tmp_path: Path) -> None:
    """Files of a result directory carry that of its text, which is read back."""
    digest = digest_in(tmp_path / "here", "x\n")
    case = parse_case(CASE + CURRENT, folder=str(tmp_path / "here"))
    assert text_digest(write_case(case)) == digest
