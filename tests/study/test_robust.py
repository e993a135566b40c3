"""Designs judged by draws, beside every design and draw checked by itself in plain closed form."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from catopt.__main__ import main
from catopt.casefile import read_case
from catopt.checks.case import check_line
from catopt.design.evaluation import DesignProblem, sinker_of
from catopt.design.neighbours import NoFeasibleDesignError
from catopt.design.search import design_case
from catopt.errors import InputError, NoAnswerError
from catopt.model import Case
from catopt.study.file import read_study
from catopt.study.member import read_member
from catopt.study.robust import design_in_draws, drawn_problem
from catopt.study.run import run_study

CASE = Path("cases/design-buoy-9.5m/case.toml")
SAMPLES, SHARE = 8, 0.75

SMALL = """
[design]
objectives = ["mass", "offset"]

[[design.segments]]
name = "chain"
components = ["chain stud-link U1"]
diameters = ["16 mm", "24 mm", "30 mm"]
lengths = ["20 m", "28 m", "36 m", "44 m"]

[design.sinker]
masses = ["1 t", "2 t", "3 t", "4 t"]
density = "2400 kg/m^3"
friction = 0.5
"""

STUDY = f"""
case = "case.toml"
compute = "design"
samples = {SAMPLES}
share = {SHARE}
seed = 3

[[vary]]
key = "load_cases[0].horizontal_force"
distribution = "gumbel"
mean = "0.5 tf"
deviation = "0.15 tf"

[[vary]]
key = "site.water_depth"
distribution = "uniform"
min = "9 m"
max = "11 m"
"""


def written(folder: Path, study: str = STUDY, design: str = SMALL) -> Path:
    text = CASE.read_text("utf-8")
    (folder / "case.toml").write_text(text[: text.index("[design]")] + design, "utf-8")
    (folder / "study.toml").write_text(study, "utf-8")
    return folder / "study.toml"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("robust"))


def judged(file: Path) -> dict[tuple[int, ...], tuple[list[float], float]]:
    """Of each design that passes: its objectives, and in what part of the draws it fails."""
    study, case = read_study(file), read_case(file.parent / "case.toml")
    problem = DesignProblem.of(case)
    assert case.design is not None
    assert case.design.sinker is not None
    sinkers = [sinker_of(case, case.design.sinker, k) for k in range(4)]
    draws = [read_member(study.base, study.values_of(k)) for k in range(SAMPLES)]
    needed, found = math.ceil(SHARE * SAMPLES), {}
    for genes in problem.space.genes_between(0, problem.space.count):
        line = problem.space.line(tuple(genes.tolist()))

        def spans(of: Any, anchor: Any, line: Any = line) -> tuple[bool, float]:
            report = check_line(line, of, anchor)
            return report.passes, max(each.span for _, each in report.solutions)

        for sinker in sinkers:
            offsets, passing = [], 0
            for draw in draws:
                try:
                    passes, offset = spans(draw, sinker)
                except NoAnswerError:
                    passes, offset = False, math.inf
                passing += passes
                offsets.append(offset)
            if passing >= needed:
                own, _ = spans(case, sinker)
                if own:
                    worth = [line.mass or 0.0, sorted(offsets)[needed - 1]]
                    found[tuple(genes.tolist())] = worth, 1.0 - passing / SAMPLES
                break
    return found


def test_the_front_is_that_of_every_design_checked_in_every_draw(file: Path) -> None:
    known = judged(file)
    best = {
        genes
        for genes, (worth, _) in known.items()
        if not any(
            all(a <= b for a, b in zip(other, worth, strict=True)) and other != worth
            for other, _ in known.values()
        )
    }
    result = design_in_draws(file)
    assert {point.genes for point in result.front} == best
    assert 0 < len(best) < len(known)
    for point in result.front:
        worth, failing = known[point.genes]
        assert point.draws is not None
        assert point.draws.failing == pytest.approx(failing, abs=1e-12)
        assert point.objectives["mass_kg"] == pytest.approx(worth[0], rel=1e-12)
        assert point.objectives["offset_m"] == pytest.approx(worth[1], rel=1e-8)
        low, high = point.draws.interval
        assert low <= failing <= high
        assert point.passes


def test_some_designs_pass_by_the_values_of_the_case_alone(file: Path) -> None:
    """Or the draws would decide nothing."""
    problem = DesignProblem.of(read_case(file.parent / "case.toml"))
    genes = problem.space.genes_between(0, problem.space.count)
    passing = int((problem.assess(genes).exceedance <= 1e-9).sum())
    assert len(judged(file)) < passing


def test_a_design_that_fails_in_too_many_draws_says_in_how_many(file: Path) -> None:
    """On the heaviest sinker, each draw checked by itself; some pass in a few of the draws."""
    study, case = read_study(file), read_case(file.parent / "case.toml")
    problem, known = drawn_problem(study), judged(file)
    assert case.design is not None
    assert case.design.sinker is not None
    heaviest = sinker_of(case, case.design.sinker, 3)
    seen = set()
    for row in problem.space.genes_between(0, problem.space.count):
        genes = tuple(row.tolist())
        line, failing = problem.space.line(genes), 0
        if genes in known:
            continue
        for draw in (read_member(study.base, study.values_of(k)) for k in range(SAMPLES)):
            try:
                assert isinstance(draw, Case)
                failing += not check_line(line, draw, heaviest).passes
            except NoAnswerError:
                failing += 1
        point = problem.point(genes)
        assert point.draws is not None
        assert point.draws.failing * SAMPLES == failing
        seen.add(failing)
    assert seen - {SAMPLES}


def test_draws_without_spread_change_nothing(tmp_path: Path) -> None:
    """Uniform within a millionth of the case's own force."""
    study = (
        STUDY[: STUDY.index("[[vary]]")]
        + """
[[vary]]
key = "load_cases[0].horizontal_force"
distribution = "uniform"
min = "0.34299999 tf"
max = "0.34300001 tf"
"""
    )
    file = written(tmp_path, study)
    plain, drawn = design_case(read_case(tmp_path / "case.toml")), design_in_draws(file)
    assert [each.genes for each in drawn.front] == [each.genes for each in plain.front]
    assert [each.anchor for each in drawn.front] == [each.anchor for each in plain.front]
    for one, other in zip(drawn.front, plain.front, strict=True):
        assert one.objectives["offset_m"] == pytest.approx(other.objectives["offset_m"], rel=1e-6)


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ('key = "site.water_depth"', 'key = "design.seed"', "vary[1].key"),
        ('compute = "design"', 'compute = "statics"', "share"),
        ("seed = 3", 'seed = 3\nlimits = { span = "20 m" }', "limits"),
        (
            'distribution = "uniform"\nmin = "9 m"\nmax = "11 m"',
            'values = ["9 m", "10 m"]',
            "vary[1]",
        ),
    ],
)
def test_what_is_no_design_in_draws_is_refused(
    tmp_path: Path, old: str, new: str, key: str
) -> None:
    file = written(tmp_path, STUDY.replace(old, new))
    with pytest.raises(InputError) as caught:
        design_in_draws(file)
    assert key in {each.key for each in caught.value.problems}


def test_a_study_of_members_refuses_it(file: Path) -> None:
    with pytest.raises(InputError, match="design_in_draws"):
        run_study(file)


def test_none_passes(tmp_path: Path) -> None:
    file = written(tmp_path, STUDY.replace('mean = "0.5 tf"', 'mean = "9 tf"'))
    with pytest.raises(NoFeasibleDesignError):
        design_in_draws(file)


def test_the_command_says_in_how_many_draws_a_design_fails(
    file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["study", str(file)]) == 0
    assert "Fails in" in capsys.readouterr().out
    assert main(["study", str(file), "--full"]) == 0
    assert "75 % of 8 draws" in " ".join(capsys.readouterr().out.split())
    assert main(["study", str(file), "--plan"]) == 2
    assert "--plan" in capsys.readouterr().err


def test_the_same_file_gives_the_same_answer(file: Path) -> None:
    assert design_in_draws(file).to_dict() == design_in_draws(read_study(file)).to_dict()
