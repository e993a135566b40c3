"""What can go wrong, as one tree of exceptions.

CatoptError                 exit status 1: a fault of ours, when nothing below fits
├── InputError              2: the input is wrong; every problem at once
├── NoAnswerError           3: the input is right, but nothing satisfies it
│   ├── NoEquilibriumError      no line hangs so: says what is missing and by how much
│   └── FloatsUpError           a buoy would float above the water surface
└── NotConvergedError       4: a solver stopped short; never a result
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from catopt.words.message import on_one_line


class CatoptError(Exception):
    """Any failure that catopt announces."""

    exit_status = 1

    @property
    def message(self) -> str:
        """What is wrong; a message that can be said in other languages where the error has one."""
        return str(self) if not self.args else self.args[0]


@dataclass(frozen=True)
class Problem:
    """One thing wrong with an input."""

    key: str
    """Where: a key path such as ``line.segments[0].length`` or an argument's name."""
    found: str
    """What is there, as the user wrote it; empty when it is missing."""
    allowed: str
    """What would be right, with the way out."""

    def __str__(self) -> str:
        what = f"found {self.found}; " if self.found else ""
        return on_one_line(f"{self.key}: {what}{self.allowed}")


class InputError(CatoptError):
    """The input is wrong.

    `problems` has every one, in the order of the input; `source` is the file or the function that
    was given the input, and may be empty.
    """

    exit_status = 2

    def __init__(self, problems: Sequence[Problem], source: str = "") -> None:
        self.problems = tuple(problems)
        self.source = source
        count = len(self.problems)
        head = f"{source}: " if source else ""
        noun = "error" if count == 1 else "errors"
        super().__init__("\n".join([f"{head}{count} {noun}", *(f"  {p}" for p in self.problems)]))

    def __reduce__(self) -> tuple[type[InputError], tuple[tuple[Problem, ...], str]]:
        """Give what builds the same error in another process."""
        return type(self), (self.problems, self.source)


def refused(key: str, found: str, allowed: str, source: str = "") -> InputError:
    """Return the error of one thing that is wrong: where, what was found, and what is allowed."""
    return InputError([Problem(key, found, allowed)], source)


class NoAnswerError(CatoptError):
    """The input is right, but no answer exists."""

    exit_status = 3


class NoEquilibriumError(NoAnswerError):
    """No line can hang as asked.

    `quantity` is what is missing: ``"length"`` (m), ``"force"`` (N) or ``"span"`` (m); `missing`
    how much of it, in SI; 0 when it is met exactly but must be exceeded.
    """

    def __init__(self, message: str, quantity: str, missing: float) -> None:
        self.quantity = quantity
        self.missing = missing
        super().__init__(message)

    def __reduce__(self) -> tuple[type[NoEquilibriumError], tuple[str, str, float]]:
        """Give what builds the same error in another process."""
        return type(self), (self.message, self.quantity, self.missing)


class TableEndsError(NoEquilibriumError):
    """A rope has a tension beyond the last row of its table of strains."""


class FloatsUpError(NoAnswerError):
    """A buoy would float above the water surface, where nothing lifts it."""


class NotConvergedError(CatoptError):
    """A solver stopped before its residual was small enough."""

    exit_status = 4


def need_package(name: str, extra: str, source: str, module: str = "") -> None:
    """Refuse what needs a package that is not there: InputError with how to install it.

    `extra` of catopt brings the package, `source` needs it; `module` is what is imported, where it
    has another name.
    """
    from importlib.util import find_spec

    if find_spec(module or name) is None:
        from catopt.words import Message

        allowed = Message("refused_case.not_installed_pip_install_catopt", extra=extra)
        raise InputError([Problem(name, "", allowed)], source)
