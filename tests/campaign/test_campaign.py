"""The campaign over random lines, and that each of its parts catches what it is there to catch."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from catopt import read_case, solve, solve_case, solve_many
from catopt.errors import NoEquilibriumError, NotConvergedError
from catopt.model import Line, PointLoad, Segment
from tests.campaign.__main__ import main, write_simplest
from tests.campaign.evaluation import BAD, Outcome, evaluate
from tests.campaign.lines import KINDS, KNOWN, Trial, draw
from tests.campaign.refusals import (
    RIGHT,
    UNEXPLAINED,
    WRONG,
    hung_without_force,
    is_too_short,
    judge,
    larger_force,
)
from tests.campaign.run import run
from tests.campaign.shrinking import shrunk
from tests.campaign.tally import Tally

pytestmark = pytest.mark.slow  # the harness of the long campaigns, with them


def test_no_line_fails() -> None:
    tally = run(1_000, seed=2)
    assert tally.failures == 0, tally.table()
    assert tally.lines == 1_000


def test_the_number_of_processes_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.campaign.run.BLOCK", 7)
    assert run(20, seed=3, workers=2) == run(20, seed=3)


def test_a_line_comes_from_its_seed_and_index_alone() -> None:
    assert draw(1, 17) == draw(1, 17)
    assert draw(1, 17) != draw(2, 17)
    assert draw(1, 17) != draw(1, 18)


def test_lines_are_of_every_kind() -> None:
    """What issue and manual promise of the lines, and every kind with every known quantity."""
    trials = [draw(1, index) for index in range(11_000)]
    parts = [segment for trial in trials for segment in trial.line.segments]
    assert {(t.kind, t.known) for t in trials} == {(a, b) for a in KINDS for b in KNOWN}
    assert {len(t.line.segments) for t in trials} == set(range(1, 7))
    assert {len(t.line.point_loads) for t in trials} == set(range(5))
    assert min(t.line.length for t in trials) < 0.11
    assert max(t.line.length for t in trials) > 10e3
    assert min(p.EA for p in parts) < 1.1e3
    assert any(math.isinf(p.EA) for p in parts)
    assert any(p.submerged_weight == 0.0 for p in parts)
    assert any(p.submerged_weight < 0.0 for p in parts)
    assert max(t.friction for t in trials) > 1.9
    assert any(t.friction == 0.0 for t in trials)
    assert any(t.rise > 0.0 == t.anchor_height for t in trials)
    assert any(t.rise < 0.0 for t in trials)
    assert any(t.rise == 0.0 < t.anchor_height for t in trials)
    assert any(t.height == 0.0 for t in trials)
    for kind, ratio in (("plain", 5e3), ("extreme weights", 1e8)):
        weights = [[s.submerged_weight for s in t.line.segments] for t in trials if t.kind == kind]
        assert max(max(each) / min(each) for each in weights if min(each) > 0.0) > ratio


# --- what is refused -----------------------------------------------------------------------------

CHAIN = Line([Segment(100.0, 500.0)])


def known(line: Line, quantity: str, value: float, height: float = 40.0, **more: float) -> Trial:
    return Trial(line, height, more.get("anchor", 0.0), more.get("friction", 0.0), quantity, value)


@pytest.mark.parametrize(
    ("trial", "error", "verdict"),
    [
        (known(CHAIN, "span", 95.0), NoEquilibriumError("", "length", 1.0), RIGHT),
        (known(CHAIN, "span", 90.0), NoEquilibriumError("", "length", 1.0), WRONG),
        (
            known(Line([Segment(100.0, 500.0, EA=1e9)]), "span", 95.0),
            NoEquilibriumError("", "length", 1.0),
            WRONG,
        ),
        (known(CHAIN, "fairlead_tension", 19e3), NoEquilibriumError("", "force", 1.0), RIGHT),
        (
            known(CHAIN, "fairlead_tension", 20e3 * (1 + 1e-6)),
            NoEquilibriumError("", "force", 1.0),
            WRONG,
        ),
        (known(CHAIN, "fairlead_tension", 1e5), NotConvergedError(), UNEXPLAINED),
    ],
)
def test_a_refusal_is_looked_into(trial: Trial, error: Exception, verdict: str) -> None:
    assert judge(trial, error)[0] == verdict  # type: ignore[arg-type]


def test_too_short_is_decided_exactly() -> None:
    """A triangle of 3, 4 and 5: as long as the way is too short, a millionth of a millionth not."""
    assert is_too_short(known(Line([Segment(5.0, 1.0)]), "span", 4.0, height=3.0))
    longer = Line([Segment(5.0 + 1e-12, 1.0)])
    assert not is_too_short(known(longer, "span", 4.0, height=3.0))


def test_what_hangs_upright_by_hand() -> None:
    """A chain of 500 N/m, 40 m of it off the bed; a rope of 100 N/m that stretches above it."""
    assert hung_without_force(known(CHAIN, "span", 1.0)) == pytest.approx(20e3, rel=1e-12)
    line = Line([Segment(50.0, 500.0), Segment(30.0, 100.0, EA=1e5)], [PointLoad(50.0, 700.0)])
    # From the rope's lower end up V = T: a m of chain, the clump weight, the rope.
    lower = 5.0 * 500.0 + 700.0
    height = 5.0 + 30.0 + (lower * 30.0 + 0.5 * 100.0 * 30.0**2) / 1e5
    hung = hung_without_force(known(line, "span", 1.0, height=height))
    assert hung == pytest.approx(lower + 3000.0, rel=1e-12)


BUOYED = Line([Segment(1.5, 20.0), Segment(0.2, 600.0)], [PointLoad(1.14, -500.0)])


def test_the_smaller_of_two_forces_is_found_out() -> None:
    """The tension of 200 N at 0.5 m stands at 159 N, too: a lesser force is not the answer."""
    case = known(BUOYED, "fairlead_tension", 200.0, height=0.5)
    larger = solve(BUOYED, height=0.5, horizontal_force=159.02310897590084)
    assert larger.fairlead.tension == pytest.approx(200.0, rel=1e-9)
    assert larger_force(case, larger.horizontal_force * (1 + 1e-9)) is None
    assert larger_force(case, 1.0) is not None


# --- how failures are kept -----------------------------------------------------------------------


def test_a_failing_line_is_made_simple() -> None:
    """Whatever has a heavy last segment fails: the rest goes, and the digits with it."""
    trial = next(t for t in (draw(1, i) for i in range(999)) if len(t.line.segments) == 6)
    heavy = 0.5 * trial.line.segments[-1].submerged_weight
    small = shrunk(trial, lambda each: each.line.segments[-1].submerged_weight > heavy)
    assert len(small.line.segments) == 1
    assert small.line.point_loads == ()
    assert small.friction == small.anchor_height == 0.0
    assert math.isinf(small.line.segments[0].EA)
    assert len(f"{small.line.segments[0].length:g}".replace(".", "").strip("0")) == 1


def test_the_simplest_failing_line_is_a_case_file(tmp_path: Path) -> None:
    tally = Tally()
    trials = [replace(draw(1, index), known="horizontal_force", value=1e6) for index in (5, 40)]
    tally.add([Outcome(trial, BAD, "planted") for trial in trials])
    path = write_simplest(tally, tmp_path)
    assert path is not None
    assert solve_case(read_case(path)).horizontal_force > 0.0


def test_a_clean_campaign_writes_nothing(tmp_path: Path) -> None:
    assert write_simplest(Tally(), tmp_path) is None
    assert list(tmp_path.iterdir()) == []


def test_table_and_exit_status(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Ordinary lines only: they were right from the start."""
    assert main(["--lines", "3", "--first", "48", "--out", str(tmp_path)]) == 0
    printed = capsys.readouterr().out
    assert "3 lines, seed 1" in printed
    assert "lines a second" in printed


def test_solve_many_is_held_against_solve(monkeypatch: pytest.MonkeyPatch) -> None:
    """A solve_many that is off by a millionth, or that answers what solve refuses, is found out."""
    import tests.campaign.evaluation as evaluation

    trial = known(CHAIN, "horizontal_force", 1e4)
    true = solve_many

    def off(*args: object, **given: object) -> object:
        found = true(*args, **given)  # type: ignore[arg-type]
        return replace(found, vertical_force=found.vertical_force * (1 + 1e-6))

    assert not evaluate([trial])[0].failed
    monkeypatch.setattr(evaluation, "solve_many", off)
    assert evaluate([trial])[0].reason == "solve_many: V"

    def answers(*args: object, **given: object) -> object:
        found = true(*args, **given)  # type: ignore[arg-type]
        return replace(found, status=found.status * 0)

    monkeypatch.setattr(evaluation, "solve_many", answers)
    short = known(CHAIN, "span", 99.0)
    assert evaluate([short])[0].reason == "solve_many: status 0, solve 1"
