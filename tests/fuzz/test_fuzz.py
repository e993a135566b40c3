"""No file, however broken, gets anything but an answer or a refusal with key and reason."""

from __future__ import annotations

import pytest

from tests.fuzz.kinds import Kind, kinds
from tests.fuzz.run import ended_in, fault_of, run
from tests.fuzz.silence import campaign, silent

FILES, IN_ALL, AS_PROCESSES = 600, 1_200, 50


@pytest.mark.parametrize("kind", kinds(), ids=lambda kind: kind.name)
def test_every_file_is_right_before_it_is_broken(kind: Kind) -> None:
    for text in kind.texts:
        ended = ended_in(kind, kind.command, kind.data(text))
        assert (ended.status, fault_of(ended)) == (0, ""), ended.err


@pytest.mark.parametrize(
    ("first", "end"), [(0, FILES), pytest.param(FILES, IN_ALL, marks=pytest.mark.slow)]
)
def test_a_broken_file_is_answered_or_refused(first: int, end: int) -> None:
    assert run(end - first, seed=16, first=first).faults == []


CHANGES, CHANGES_IN_ALL = 220, 1_100


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    ("count", "seed"), [(CHANGES, 3), pytest.param(CHANGES_IN_ALL, 4, marks=pytest.mark.slow)]
)
def test_no_change_changes_nothing_in_silence(count: int, seed: int) -> None:
    """Of 330 such changes 43 did before tables, forms and arrays had one gate."""
    _, changed_nothing = campaign(count, seed)
    assert changed_nothing == []


def test_the_judge_of_silence_sees_what_is_the_same() -> None:
    read = {"motion": lambda _: ([1.0, 2.0], lambda: [1.0, 2.0], "nothing changed")}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("tests.fuzz.silence.KINDS", read)
        assert silent("motion", 0, 1) == "nothing changed"


@pytest.mark.slow
def test_so_it_is_by_processes_of_their_own() -> None:
    assert run(AS_PROCESSES, seed=61, processes=True).faults == []


@pytest.mark.parametrize(
    ("status", "out", "err", "fault"),
    [
        (1, "", "catopt: a fault of catopt's own (TypeError)", "status 1"),
        (2, "", "catopt: case.toml: 1 error\n", "without key and reason"),
        (2, "", "catopt: case.toml: 1 error\n  wrong\n", "without key and reason"),
        (2, "{}", "catopt: case.toml: 1 error\n  key: wrong\n", "prints an answer"),
        (3, "", "", "no message"),
        (3, "", "enumeration of 1,020 designs\n", "no message"),
        (3, "", "enumeration of 1,020 designs\ncatopt: no design passes\n", ""),
        (0, "{}", "RuntimeWarning: overflow\n", "says 'Warning'"),
        (2, "", "catopt: case.toml: 1 error\n  key: found \x1b[31m\n", "control characters"),
        (2, "", "catopt: case.toml: 1 error\n  key: wrong\n", ""),
    ],
)
def test_the_judge_sees_what_is_wrong(status: int, out: str, err: str, fault: str) -> None:
    from tests.fuzz.run import Ended

    found = fault_of(Ended(status, out, err, 0.1))
    assert (fault in found) if fault else found == ""
