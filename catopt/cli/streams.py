"""The standard streams of the process, where one is missing, full or closed."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any, NoReturn, TextIO, cast

from catopt.errors import InputError, Problem
from catopt.words import Message


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
            _refuse(
                Message(
                    "refused_command.answer_not_written",
                    reason=self._failure.strerror or self._failure,
                )
            )


def _refuse(why: Message) -> NoReturn:
    raise InputError([Problem("standard output", "", why)])
