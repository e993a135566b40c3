"""What each command prints when not all of it is asked for: 24 lines of 80 columns at most."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from .conftest import CASES, Run, typed
from .test_every_command import COMMANDS

LINES, WIDTH = 24, 80
_STATIC = {
    "solve": ("buoy-9.5m", "buoy-9.5m-slack", "tanker-20m", "ship-200m-sinker", "fatigue-chain-20m",
              "tanker-20m-find-length"),
    "check": ("buoy-9.5m", "design-buoy-9.5m", "design-tanker-20m", "design-leg-56m",
              "fso-rang-dong", "design-mooring-30m", "ship-200m"),
    "system": ("fso-rang-dong", "design-turret-56m", "design-mooring-30m"),
    "curve": ("buoy-9.5m", "tanker-20m", "ship-200m-sinker", "tanker-20m-find-length"),
    "verify": ("design-buoy-9.5m", "buoy-9.5m-slack", "fso-rang-dong", "tanker-20m-sinker"),
}  # fmt: skip
SHIPPED = [
    *(f"{command} CASES/{name}/case.toml" for command, names in _STATIC.items() for name in names),
    "system FSO --line-out --watch-circle --curve '180 deg' --level '1 m' --stiffness",
    "solve TANKER --profile",
    "size buoy CASES/size-buoy/sizing.toml",
    "size tanker CASES/size-tanker/sizing.toml",
    "reproduce load_sharing",
    "reproduce tanker_20m_sinker",
    "study FLEET --workers 1",
    "study STUDY --plan",
    "design DESIGN",
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
SLOW = [
    "verify CASES/dynamic-chain-56m/case.toml --dynamic --once",
    "fatigue FATIGUE --once",
    "design CASES/design-tanker-20m/case.toml",
    "design CASES/design-leg-56m/case.toml",
    "design CASES/design-mooring-30m/case.toml --evaluations 400",
    "study CASES/study-buoy-9.5m/study.toml --workers 1",
    "reproduce",
]
in_both = pytest.mark.parametrize("language", ["en", "vi"])


def is_a_screen(run: Run, monkeypatch: pytest.MonkeyPatch, line: str, language: str) -> list[str]:
    """Run a command as it is typed; its lines, of which none is too many or too wide."""
    monkeypatch.setattr("tests.cli.conftest.FULL", "0")
    ran = run(*typed(line), "--lang", language)
    lines = ran.out.splitlines()
    assert ran.status == 0, ran.err
    assert 3 < len(lines) <= LINES
    assert max(map(len, lines)) <= WIDTH
    return lines


@in_both
@pytest.mark.parametrize("line", SHIPPED)
def test_an_answer_is_one_screen(
    run: Run, monkeypatch: pytest.MonkeyPatch, inside: Path, line: str, language: str
) -> None:
    assert inside
    lines = is_a_screen(run, monkeypatch, line, language)
    assert any("--full" in each for each in lines[-2:])


@pytest.mark.slow
@in_both
@pytest.mark.parametrize("line", SLOW)
def test_a_long_answer_is_one_screen(
    run: Run, monkeypatch: pytest.MonkeyPatch, inside: Path, line: str, language: str
) -> None:
    shutil.copytree(CASES, inside / "cases")
    is_a_screen(run, monkeypatch, line, language)


@pytest.mark.parametrize("line", ["check FSO", "check DESIGN", "system FSO"])
def test_verdict_and_what_governs_stand_below_the_title(
    run: Run, monkeypatch: pytest.MonkeyPatch, line: str
) -> None:
    """They are the full answer's own, in its words."""
    whole = " ".join(run(*typed(line)).out.split())
    _, verdict, governs, *_ = is_a_screen(run, monkeypatch, line, "en")
    assert verdict in whole
    assert governs in whole
    assert governs.startswith("Governing: ")


def test_a_screen_says_how_many_rows_it_leaves_out(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of nine lines of the turret as many are missing as are not there."""
    lines = is_a_screen(run, monkeypatch, "system FSO", "en")
    rows = [each for each in lines if each[:4].strip().isdigit()]
    (said,) = (int(each.split()[1]) for each in lines if each.startswith("and "))
    assert len(rows) + said == 9


def test_the_environment_may_ask_for_all_of_it(run: Run) -> None:
    """CATOPT_FULL=1 and --full print the same; these tests set the first."""
    assert run("check", *typed("FSO")).out == run("check", *typed("FSO"), "--full").out


def test_commands_of_every_kind_are_tried() -> None:
    tried = {line.split()[0] for line in (*SHIPPED, *SLOW)}
    assert {command.line.split()[0] for command in COMMANDS} - {"SIZE_BUOY"} <= tried
