"""What a person sees: width, colour, encoding, progress."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from io import StringIO
from pathlib import Path
from time import monotonic, sleep

import pytest
from rich.console import Console
from rich.progress import Progress

from catopt.cli.output import PATIENCE, Printer
from catopt.cli.progress_bar import progress_bar

from .conftest import BUOY, DESIGN, Run, changed

ESCAPE = "\x1b"
TITLE = "Phao luồng số 1, θ = 15° [x]"

needs_pty = pytest.mark.skipif(sys.platform == "win32", reason="no pseudo-terminals there")


def in_terminal(*arguments: str, **environment: str) -> tuple[int, str]:
    """Run catopt with a pseudo-terminal as standard output and error; return what it shows."""
    import pty

    ours, theirs = pty.openpty()
    base = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "COLUMNS")}
    command = subprocess.Popen(
        [sys.executable, "-m", "catopt", *arguments],
        stdin=subprocess.DEVNULL,
        stdout=theirs,
        stderr=theirs,
        env={**base, "TERM": "xterm-256color", **environment},
    )
    os.close(theirs)
    shown = b""
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:  # Linux reports the end of a pseudo-terminal so
            part = b""
        if not part:
            break
        shown += part
    os.close(ours)
    return command.wait(), shown.decode("utf-8").replace("\r\n", "\n")


@needs_pty
def test_a_terminal_gets_bold_headings_and_NO_COLOR_none() -> None:
    status, shown = in_terminal("solve", str(BUOY))
    assert status == 0
    assert ESCAPE in shown
    status, plain = in_terminal("solve", str(BUOY), NO_COLOR="1")
    assert status == 0
    assert ESCAPE not in plain
    assert "17.430 m" in plain


@needs_pty
def test_progress_is_for_terminals_only(run: Run) -> None:
    further = ("--method", "pso", "--runs", "2")
    status, shown = in_terminal("solve", str(BUOY), *further)
    assert status == 0
    assert "Swarm runs" in shown
    ran = run("solve", BUOY, *further)
    assert (ran.status, ran.err) == (0, "")
    assert "Swarm runs" not in ran.out


def test_the_bar_tells_how_long_the_rest_will_take() -> None:
    """Steps of 2 s each: after 4 of 100 another 192 s, 3 min 12 s."""
    now = 0.0
    bar = progress_bar(Console(file=StringIO(), width=80), lambda: now)
    task = bar.add_task("Designs of a front", total=None)
    assert ESCAPE not in drawn(bar)
    assert drawn(bar).endswith("0:00")
    for done in range(5):
        now = 2.0 * done
        bar.update(task, completed=done, total=100)
    assert drawn(bar).startswith("Designs of a front ")
    assert drawn(bar).endswith("4 of 100, 0:08 3:12 left")
    now = 7300.0
    bar.update(task, completed=100)
    assert drawn(bar).endswith("100 of 100, 2:01:40")


def drawn(bar: Progress) -> str:
    """Draw a bar as plain text on a line of 80 columns."""
    console = Console(file=StringIO(), width=80, color_system=None)
    with console.capture() as captured:
        console.print(bar.get_renderable())
    (line,) = captured.get().splitlines()
    return line.rstrip()


@pytest.mark.slow
@needs_pty
@pytest.mark.parametrize("no_color", ["", "1"])
def test_a_search_shows_its_progress_and_clears_it_away(no_color: str) -> None:
    environment = {"NO_COLOR": no_color} if no_color else {}
    status, shown = in_terminal("design", str(DESIGN), COLUMNS="80", **environment)
    assert status == 0
    bars = [line for line in re.split(r"[\r\n]", shown) if "Designs " in plain(line)]
    assert bars
    assert all(len(plain(line)) <= 80 for line in bars)
    colours = [code for code in re.findall(r"\x1b\[([0-9;]*)m", shown) if code not in {"", "0"}]
    assert bool(colours) == (not no_color)


def plain(text: str) -> str:
    """Take the escape codes out."""
    return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", text)


@pytest.mark.slow
@pytest.mark.parametrize("encoding", ["cp1252", "ascii", "utf-8"])
def test_a_console_without_the_letters_does_not_stop_the_answer(
    tmp_path: Path, encoding: str
) -> None:
    path = changed(BUOY, tmp_path, ("Marker buoy, 9.5 m", TITLE))
    environment = {**os.environ, "PYTHONIOENCODING": encoding}
    answers = {}
    for further in ((), ("--json",)):
        command = [sys.executable, "-m", "catopt", "solve", str(path), *further]
        ran = subprocess.run(command, capture_output=True, env=environment, check=False)
        assert (ran.returncode, ran.stderr) == (0, b"")
        answers[further] = ran.stdout.decode(encoding)
    assert "17.430 m" in answers[()]
    assert "lu" in answers[()].splitlines()[0]
    assert json.loads(answers["--json",])["title"] == TITLE


def test_brackets_and_codes_in_a_title_are_plain_text(run: Run, tmp_path: Path) -> None:
    title = "[red]R3[/red] :warning: 100 %"
    path = changed(BUOY, tmp_path, ("Marker buoy, 9.5 m", title))
    assert run("solve", path).out.splitlines()[0] == title


class Screen(StringIO):
    """A terminal for what is said beside an answer."""

    def isatty(self) -> bool:
        return True


def worked(monkeypatch: pytest.MonkeyPatch, stream: StringIO, patience: float) -> tuple[str, str]:
    """Work until something is shown, or a while; return what is shown meanwhile and afterwards."""
    monkeypatch.setattr("catopt.cli.output.PATIENCE", patience)
    monkeypatch.setattr(sys, "stderr", stream)
    meanwhile = ""
    with Printer().working("Sizing the line"):
        ends = monotonic() + (5.0 if stream.isatty() and patience < 1.0 else 0.3)
        while "Sizing the line" not in meanwhile and monotonic() < ends:
            sleep(0.01)
            meanwhile = stream.getvalue()
    return meanwhile, stream.getvalue()


def test_what_is_done_is_said_after_a_while_and_is_gone_with_the_answer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("TERM", "xterm")
    meanwhile, afterwards = worked(monkeypatch, Screen(), 0.02)
    assert "Sizing the line" in meanwhile
    assert afterwards.rstrip().endswith(f"{ESCAPE}[2K")  # the line is wiped, the cursor on it


def test_nothing_is_said_of_short_work_nor_into_a_pipe(monkeypatch: pytest.MonkeyPatch) -> None:
    assert PATIENCE == 1.0
    assert worked(monkeypatch, Screen(), 1000.0) == ("", "")
    assert worked(monkeypatch, StringIO(), 0.0) == ("", "")


SIZES = (
    ("buoy", "pillar 1.8 m", "--depth", "12 m", "--at-rest"),
    ("tanker", "--dwt", "50000 t", "--depth", "20 m", "--at-rest"),
)


@pytest.mark.parametrize("typed", SIZES)
@pytest.mark.parametrize("language", ["en", "vi"])
def test_a_sizing_is_one_screen_and_the_rest_is_asked_for(
    run: Run, typed: tuple[str, ...], language: str
) -> None:
    ran = run("size", *typed, "--lang", language, "--units", "tf")
    assert (ran.status, ran.err) == (0, "")
    assert len(ran.out.splitlines()) <= 22
    assert max(map(len, ran.out.splitlines())) <= 80
    full = run("size", *typed, "--lang", language, "--units", "tf", "--full").out
    assert "--full" not in full
    assert len(full.splitlines()) > 80
    assert ran.out.splitlines()[1] in full  # the line that is recommended


@needs_pty
def test_a_terminal_shows_of_a_sizing_what_a_pipe_gets(run: Run) -> None:
    status, shown = in_terminal("size", *SIZES[0], NO_COLOR="1", COLUMNS="80")
    assert status == 0
    assert shown.endswith(run("size", *SIZES[0]).out)


@needs_pty
@pytest.mark.parametrize("width", [60, 140])
def test_a_terminal_is_used_from_60_to_140_columns(width: int) -> None:
    status, shown = in_terminal("size", *SIZES[0], NO_COLOR="1", COLUMNS=f"{width}")
    assert status == 0
    card = shown[shown.index("\nPasses") :].splitlines()
    assert width - 12 <= max(map(len, card)) <= width


@needs_pty
def test_a_pipe_is_no_wider_than_the_terminal_it_is_typed_in() -> None:
    """Such as to a pager: standard error is the terminal, 60 columns wide."""
    import fcntl
    import pty
    import struct
    import termios

    ours, theirs = pty.openpty()
    environment = {key: value for key, value in os.environ.items() if key != "COLUMNS"}
    widths = {}
    for columns in (60, 120):
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
        ran = subprocess.run(
            [sys.executable, "-m", "catopt", "solve", str(BUOY)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=theirs,
            env=environment,
            check=True,
        )
        widths[columns] = max(map(len, ran.stdout.decode("utf-8").splitlines()))
    os.close(theirs)
    os.close(ours)
    assert 48 <= widths[60] <= 60
    assert 60 < widths[120] <= 80


def test_a_short_help_is_cut_at_the_width(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    lines = run("system", "--help").out.splitlines()
    assert max(map(len, lines)) <= 60
    assert any(line.endswith("...") for line in lines)
