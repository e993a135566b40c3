"""The one place through which a command speaks, and the standard streams below it."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TextIO, cast

from catopt.compiled import when_cache_is_damaged, when_compiling
from catopt.decks.remarks import when_read
from catopt.errors import InputError, refused
from catopt.progress import Progress
from catopt.words import Message, say

if TYPE_CHECKING:
    from rich.console import Console, RenderableType

    from catopt.errors import CatoptError
    from catopt.words import Language


def guard_streams() -> None:
    """Put guards in the place of this process's standard output and standard error.

    An answer that cannot be written is refused; a message that cannot be is dropped, so that a
    service without standard error, or with a full disk behind it, gets the same answer. Raises
    InputError where standard output is closed.
    """
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:  # or the next file that is opened would take its place
            os.open(os.devnull, os.O_RDWR)
    messages: Any = sys.stderr
    if messages is None:
        messages = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 - to the very end
    sys.stderr = cast(TextIO, _Messages(messages))
    answer: Any = sys.stdout
    if answer is None:
        _refuse(Message("refused_command.closed"))
    sys.stdout = cast(TextIO, _Answer(answer))


class _Messages:
    """Standard error: what cannot be written is dropped."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._failure: OSError | None = None

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write a text; the first failure is for good."""
        try:
            return self._stream.write(text)
        except OSError as error:
            self._fail(error)
        finally:
            self._answer_for_it()
        return len(text)

    def flush(self) -> None:
        """Write what is buffered."""
        try:
            self._stream.flush()
        except OSError as error:
            self._fail(error)
            self._answer_for_it()

    def _fail(self, error: OSError) -> None:
        """Let what is still buffered go nowhere, so that it does not fail once more at the end."""
        self._failure = error
        os.dup2(os.open(os.devnull, os.O_WRONLY), self._stream.fileno())

    def _answer_for_it(self) -> None:
        """Do nothing: the answer is what counts."""


class _Answer(_Messages):
    """Standard output: every text that cannot be written is refused."""

    def _answer_for_it(self) -> None:
        if isinstance(self._failure, BrokenPipeError):
            raise self._failure
        if self._failure is not None:
            reason = self._failure.strerror or self._failure
            _refuse(Message("refused_command.answer_not_written", reason=reason))


def _refuse(why: Message) -> NoReturn:
    raise refused("standard output", "", why)


LEAST_WIDTH, MOST_WIDTH = 60, 140
"""Columns that answers are laid out for; a narrower terminal folds the lines itself."""

BROKEN_PIPE_STATUS = 141
"""128 + SIGPIPE: what a shell reports of a program whose reader went away."""


PATIENCE = 1.0
"""s: before it is said what is done."""


class Printer:
    """Where the answer of a command, its notes and its progress go."""

    def __init__(self) -> None:
        self.debug = False  # whether a fault of ours shows its traceback
        self.language: Language = "en"  # of what is wrong; answers are told theirs
        self._consoles: dict[TextIO, Console] = {}

    def json(self, document: dict[str, Any]) -> None:
        """Print a document, and nothing else, on standard output."""
        ascii_only = not _encoding(sys.stdout).startswith("utf")
        text = json.dumps(document, indent=2, ensure_ascii=ascii_only, allow_nan=False)
        _write(sys.stdout, text + "\n")

    def refusal(self, error: CatoptError) -> None:
        """Say why there is no answer, in the language that was asked for."""
        from catopt.words.message import say_refusal

        said = str(error)
        if self.language != "en":
            said = say(error.message, self.language)
            if isinstance(error, InputError):
                said = say_refusal(error.source, error.problems, self.language)
        self.note(f"catopt: {said}")

    def text(self, text: str, *, bold: bool = False) -> None:
        """Print a paragraph, or a message, on standard output, folded to its width."""
        from rich.text import Text

        self._print(Text(say(text, self.language), style="bold" if bold else ""))

    def file(self, text: str) -> None:
        """Print what would stand in a file, as it is, on standard output."""
        _write(sys.stdout, text)

    def line(self) -> None:
        """Print an empty line on standard output."""
        _write(sys.stdout, "\n")

    def table(
        self,
        columns: Sequence[str],
        rows: Sequence[Sequence[str]],
        *,
        title: str = "",
        numbers: Sequence[int] = (),
    ) -> None:
        """Print a table and an empty line on standard output.

        Columns of `numbers` are set flush right and never folded; a table whose `columns` are empty
        has no heading row.
        """
        from rich import box
        from rich.table import Table
        from rich.text import Text

        table = Table(
            box=box.SIMPLE_HEAD, show_header=any(columns), show_edge=False, pad_edge=False
        )
        for index, heading in enumerate(columns):
            number = index in numbers
            table.add_column(
                Text(heading),
                justify="right" if number else "left",
                no_wrap=number,
                overflow="fold",  # a name without a space is longer than its column
            )
        for row in rows:
            table.add_row(*(Text(cell) for cell in row))
        if title:
            self.text(title, bold=True)
        self._print(table)
        self.line()

    def note(self, message: str) -> None:
        """Say a text, or a message, on standard error; folded only on a terminal."""
        message = say(message, self.language)
        if sys.stderr.isatty() and not self.debug:
            message = "\n".join(_folded(line) for line in message.splitlines())
        _write(sys.stderr, message + "\n")

    def listen(self) -> None:
        """Pass on what is told: to a terminal that a part has to be compiled, and of read decks."""
        if sys.stderr.isatty():
            when_compiling(lambda: self.note(Message("beside.compiling")))
        when_cache_is_damaged(lambda folder: self.note(Message("beside.damaged", folder=folder)))
        when_read(lambda remarks: self.note("\n".join(f"note: {remark}" for remark in remarks)))

    @contextmanager
    def progress(self, what: str) -> Iterator[Progress | None]:
        """Show a bar with the time left on standard error while the body runs, on a terminal.

        While nobody says how many steps there are, it shows that and how long something runs.

        Yields what is to be called with steps done and wanted; None when nobody watches.
        """
        if not sys.stderr.isatty():
            yield None
            return
        from catopt.cli.progress_bar import progress_bar

        with progress_bar(self._console(sys.stderr)) as bar:
            task = bar.add_task(say(what, self.language), total=None)
            yield lambda done, total: bar.update(task, completed=done, total=total)

    @contextmanager
    def working(self, what: str) -> Iterator[None]:
        """Say on standard error what is done while the body runs, on a terminal.

        Once that has taken a second; it is gone when the body ends.
        """
        if not sys.stderr.isatty():
            yield
            return
        from threading import Event, Thread

        is_done = Event()

        def wait() -> None:
            if not is_done.wait(PATIENCE):
                with self.progress(what):
                    is_done.wait()

        waiting = Thread(target=wait, daemon=True)
        waiting.start()
        try:
            yield
        finally:
            is_done.set()
            waiting.join()

    def _print(self, part: RenderableType) -> None:
        console = self._console(sys.stdout)
        with console.capture() as captured:
            console.print(part)
        lines = captured.get().splitlines()
        _write(sys.stdout, "".join(line.rstrip() + "\n" for line in lines))

    def _console(self, stream: TextIO) -> Console:
        """Make the console of a stream, once; without any codes where NO_COLOR is set."""
        if stream in self._consoles:
            return self._consoles[stream]
        from rich.console import Console, detect_legacy_windows

        plain = bool(os.environ.get("NO_COLOR")) or detect_legacy_windows()
        console = Console(
            file=stream,
            markup=False,
            emoji=False,
            highlight=False,
            legacy_windows=False,
            color_system=None if plain else "auto",
        )
        console.width = terminal_width()
        self._consoles[stream] = console
        return console


def _folded(line: str) -> str:
    """Fold a line to the terminal, its later lines set in; paths and numbers stay whole."""
    from textwrap import fill

    margin = " " * (len(line) - len(line.lstrip()) + 4)
    return fill(
        line,
        terminal_width(),
        subsequent_indent=margin,
        break_long_words=False,
        break_on_hyphens=False,
    )


def terminal_width() -> int:
    """Return the columns to fill: those of the terminal within limits, 80 where there is none.

    What goes to a pager or a file is no wider than the terminal that the command is typed in.
    """
    from shutil import get_terminal_size

    columns = get_terminal_size().columns
    if not (os.environ.get("COLUMNS") or sys.stdout.isatty()):
        with suppress(OSError, ValueError):  # no terminal there, or no file below the stream
            columns = min(os.get_terminal_size(sys.stderr.fileno()).columns or columns, columns)
    return min(max(columns, LEAST_WIDTH), MOST_WIDTH)


def _encoding(stream: TextIO) -> str:
    return (getattr(stream, "encoding", None) or "ascii").lower()


def _write(stream: TextIO, text: str) -> None:
    """Write and flush; end quietly when the reader has gone."""
    encoding = _encoding(stream)
    try:
        stream.write(text.encode(encoding, "replace").decode(encoding))
        stream.flush()
    except BrokenPipeError:
        raise SystemExit(BROKEN_PIPE_STATUS) from None
