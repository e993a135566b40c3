"""``catopt report``: a truss without an answer, and what ``catopt system`` wrote."""

from __future__ import annotations

import pytest

from tests.report.notes import stop

from .conftest import BUOY, FSO, Run
from .notes import note_of, page_at

pytestmark = pytest.mark.usefixtures("inside")


def test_a_truss_without_an_answer_is_told_and_the_note_written(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    stop(monkeypatch, "catopt.verify.case.verify_case", "it stopped short")
    document, _ = note_of(run, BUOY)
    told = {"verdict": "no answer", "worst": None, "failure": "it stopped short"}
    assert document["verification"] == told
    assert any("not verified" in warning for warning in document["warnings"])


@pytest.mark.slow
def test_what_catopt_system_wrote_has_a_note(run: Run) -> None:
    """The same as that of its case file."""
    assert run("system", FSO, "--out", "fso").status == 0
    assert run("report", "fso", "--no-verify").out == "fso.html\n"
    run("report", FSO, "--no-verify")
    tables = (page_at(name).table("system_lines") for name in ("fso.html", "fso-rang-dong.html"))
    first, second = ([[cell.value for cell in row] for row in table.rows] for table in tables)
    assert first == second
