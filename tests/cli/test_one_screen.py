"""What each command prints when not all of it is asked for: 24 lines of 80 columns at most."""

from __future__ import annotations

import shutil
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

from catopt.answers.blocks import Answer
from catopt.cli.output import Printer
from catopt.render.card import show_card
from catopt.words import Language

from .conftest import CASES, Run, typed
from .test_every_command import COMMANDS

LINES, WIDTH = 24, 80
TAKEN_BY = {
    "check": "site", "verify": "site", "system": "system", "design": "design",
    "fatigue --once": "fatigue", "verify --dynamic --once": "dynamics",
    "size": "environment", "study --plan": "case", "study --workers 1": "case",
}  # fmt: skip
"""Commands that take a file by what it has; `solve` and `curve` take those of one line."""
SHORTER = {
    "fso-rang-dong-dynamic": ('"1200 s"', '"40 s"'),
    "fso-rang-dong-ship": ('"3 h"', '"20 min"'),
    "dynamic-chain-56m": ('"5 min"', '"40 s"'),
    "study-chain-56m": ("[1, 2]", "[1]"),
}
"""Runs in motion that are cut short, by what of a file: the screen is of the same kind."""
SAMPLED = {"design design-turret-56m": "--method nsga2 --evaluations 200"}
"""Searches that would take a minute, of which some designs are tried."""


def shipped() -> Iterator[tuple[str, str]]:
    """Yield every shipped file with every command that takes it."""
    for path in sorted(CASES.glob("*/*.toml")):
        table = tomllib.loads(path.read_text("utf-8"))
        name = path.relative_to(CASES).as_posix()
        is_case = "size-" not in name and "case" not in table
        for command, key in TAKEN_BY.items():
            rests = command != "verify" or not {"points", "current"} <= table.keys()
            if key in table and rests and is_case != (command.split()[0] in {"size", "study"}):
                yield command, name
        if is_case and "system" not in table:
            yield "solve", name
            yield ("curve" if "points" not in table else "system"), name
        if is_case and not {"system", "bodies"}.isdisjoint(table):
            yield "curve", name


IN_DRAWS = (
    ("study --workers 1", "design-buoy-9.5m/in-draws.toml"),
    (
        "study --plan",
        "design-buoy-9.5m/in-draws.toml",
    ),
)
"""A study whose answer is a front: it has no members to plan, or to share out."""
IN_A_CURRENT = "net-cage/case.toml"
"""Of twenty lines, each gone in turn, in a current: a minute and a half a command."""
TAKEN = [each for each in shipped() if each not in IN_DRAWS and each[1] != IN_A_CURRENT]
LONG = ("design ", "fatigue --once ", "study --workers 1 ", "verify --dynamic --once ")
"""What takes longer than a moment."""
OTHERS = [
    "system FSO --line-out --watch-circle --curve '180 deg' --level '1 m' --stiffness",
    "solve TANKER --profile",
    "find BUOY 'line.segments[0].length' --until 'line.span = 16 m'",
    "size buoy 'pillar 1.8 m' --depth '12 m' --at-rest",
    "size tanker --dwt '50000 t' --depth '20 m' --at-rest",
    "reproduce load_sharing",
    "reproduce tanker_20m_sinker",
    "loads buoy 'pillar 1.8 m' --depth '12 m' --current '1 m/s' --wind '25 m/s'",
    "loads ship --dwt '50000 t' --depth '20 m' --wind '20 m/s'",
    "catalog list",
    "catalog show 'chain studless' R4 --diameter '76 mm'",
    "catalog show nylon",
    "catalog search --mbl '1 MN'",
    "catalog find DN 28 open link chain",
    "catalog anchor stockless --mass '4082 kg'",
    "catalog fittings 'chain open-link 4D Q2' 38",
    "catalog sinker '5 t' --base-area '4 m^2'",
]
in_both = pytest.mark.parametrize("language", ["en", "vi"])


def is_a_screen(run: Run, monkeypatch: pytest.MonkeyPatch, *line: str) -> list[str]:
    """Run a command as it is typed; its lines, of which none is too many or too wide."""
    monkeypatch.setattr("tests.cli.conftest.FULL", "0")
    ran = run(*line)
    assert ran.status == 0, ran.err
    return fit(ran.out)


def fit(said: str) -> list[str]:
    lines = said.splitlines()
    assert 3 < len(lines) <= LINES
    assert max(map(len, lines)) <= WIDTH
    return lines


def walk(
    run: Run,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    command: str,
    path: Path,
) -> None:
    """Answer once, and see both languages' screens of it."""
    kept: list[tuple[Answer, str]] = []

    def keep(output: Printer, answer: Answer, language: Language, further: str) -> None:
        kept.append((answer, further))
        show_card(output, answer, language, further)

    monkeypatch.setattr("catopt.render.card.show_card", keep)
    said = is_a_screen(run, monkeypatch, *command.split()[:1], str(path), *command.split()[1:])
    ((answer, further),) = kept
    show_card(Printer(), answer, "vi", further)
    other = fit(capsys.readouterr().out)
    assert said != other
    assert all(any("--full" in each for each in lines[-2:]) for lines in (said, other))


@pytest.mark.parametrize(
    ("command", "name"), [each for each in TAKEN if not " ".join(each).startswith(LONG)]
)
def test_every_shipped_case_is_one_screen_of_every_command(
    run: Run,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    command: str,
    name: str,
) -> None:
    walk(run, monkeypatch, capsys, command, CASES / name)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "name"), [each for each in TAKEN if " ".join(each).startswith(LONG)]
)
def test_every_long_answer_to_a_shipped_case_is_one_screen(
    run: Run,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    inside: Path,
    command: str,
    name: str,
) -> None:
    shutil.copytree(CASES, inside / "cases")
    path = inside / "cases" / name
    for folder, (old, new) in SHORTER.items():
        for each in (inside / "cases" / folder).glob("*.toml"):
            text = each.read_text("utf-8")
            assert old in text
            each.write_text(text.replace(old, new), "utf-8")
    sampled = SAMPLED.get(f"{command} {name.partition('/')[0]}", "")
    walk(run, monkeypatch, capsys, f"{command} {sampled}", path)


@pytest.mark.parametrize("command", ["curve", *TAKEN_BY])
def test_every_other_case_is_refused(run: Run, command: str) -> None:
    """So that none is left out above; `solve` takes bodies as `system` does."""
    first, *options = command.split()
    for path in sorted(CASES.glob("*/*.toml")):
        name = path.relative_to(CASES).as_posix()
        if (command, name) not in TAKEN and name != IN_A_CURRENT:
            ran = run(first, path, *options)
            assert (ran.status, ran.out) == (2, ""), path


@in_both
@pytest.mark.parametrize("line", OTHERS)
def test_an_answer_without_a_case_is_one_screen(
    run: Run, monkeypatch: pytest.MonkeyPatch, inside: Path, line: str, language: str
) -> None:
    assert inside
    lines = is_a_screen(run, monkeypatch, *typed(line), "--lang", language)
    assert any("--full" in each for each in lines[-2:])


@pytest.mark.slow
@in_both
def test_the_whole_book_is_one_screen(
    run: Run, monkeypatch: pytest.MonkeyPatch, inside: Path, language: str
) -> None:
    assert inside
    is_a_screen(run, monkeypatch, "reproduce", "--lang", language)


@pytest.mark.parametrize("line", ["check FSO", "check DESIGN", "system FSO"])
def test_verdict_and_what_governs_stand_below_the_title(
    run: Run, monkeypatch: pytest.MonkeyPatch, line: str
) -> None:
    """They are the full answer's own, in its words."""
    whole = " ".join(run(*typed(line)).out.split())
    _, verdict, governs, *_ = is_a_screen(run, monkeypatch, *typed(line))
    assert verdict in whole
    assert governs in whole
    assert governs.startswith("Governing: ")


def test_a_screen_says_how_many_rows_it_leaves_out(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of nine lines of the turret as many are missing as are not there."""
    lines = is_a_screen(run, monkeypatch, *typed("system FSO"))
    rows = [each for each in lines if each[:4].strip().isdigit()]
    (said,) = (int(each.split()[1]) for each in lines if each.startswith("and "))
    assert len(rows) + said == 9


def test_the_environment_may_ask_for_all_of_it(run: Run) -> None:
    """CATOPT_FULL=1 and --full print the same; these tests set the first."""
    assert run("check", *typed("FSO")).out == run("check", *typed("FSO"), "--full").out


def test_commands_of_every_kind_are_tried() -> None:
    tried = {line.split()[0] for line in (*OTHERS, *(command for command, _ in TAKEN))}
    assert {command.line.split()[0] for command in COMMANDS} - {"SIZE_BUOY"} <= tried
