"""Sessions as they are typed, in transcripts/*.txt, and what each command says.

Sessions have an empty line between them; ``# slow`` goes before one that takes long. ``$`` begins
a command, with ``NAME=value`` before it for the environment; words in capitals are those of
conftest.py, other files those of cases.py.
``$ edit FILE OLD NEW`` writes changed.toml, that file with some of its text replaced; ``$ write``,
``$ copy`` and ``$ mkdir`` make others. A command ends with 0; where ``exit N`` stands below it, it
has no answer, unless ``with an answer`` stands there, too. Each other line below it is one of

======================== ==========================================================================
``text``                 found in its answer, whatever the breaks of lines are; in what it says of
                         its failure where it has no answer
``! text``               not found in all that it says
``2> text``              found in what it says beside the answer
``2= text``              all of what it says beside the answer
``1= text``              a line of its answer, which has no other lines than these
``< text``               what is answered at a terminal, all of it; ``< nobody`` where nobody does
``= path: value``        a value of its document, as Python writes it and other keys of it; ``abs``
                         or ``rel`` and a tolerance may follow. ``[*]`` is every item,
                         ``[key=text]`` those that have it; ``told[0]`` is the first document of
                         the session, ``told[-1]`` this one; ``digest(file)`` is what it says
                         of a file
``? expression``         true of its document, in the same words
``== command``           prints the same answer, to the byte
``+ files``              all that it made and no other
``@ files: text``        found in each of the files that it wrote
``@! files: pattern``    a regular expression that is found in none of them
``@= file: other``       a file that is the same as another one, to the byte
======================== ==========================================================================
"""

from __future__ import annotations

import math
import os
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from .cases import write_files
from .conftest import NAMED, Ran, Run, changed, fits, read_document, sheets, typed, words
from .notes import compare_files, digest

TRANSCRIPTS = Path(__file__).parent / "transcripts"
MARKS = ["exit", "!", "2>", "2=", "1=", "<", "=", "?", "==", "+", "@", "@!", "@="]


def sessions() -> Iterator[Any]:
    """Yield every session, with the name of its file and its first command."""
    for path in sorted(TRANSCRIPTS.glob("*.txt")):
        for text in path.read_text("utf-8").split("\n\n"):
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            if lines:
                marks = [pytest.mark.slow] if "# slow" in text else []
                yield pytest.param(lines, marks=marks, id=f"{path.stem}: {lines[0][2:]}")


def steps(session: list[str]) -> Iterator[tuple[list[str], dict[str, list[str]]]]:
    """Yield the words of each command, and the lines below it by their mark."""
    for part in "\n".join(session).removeprefix("$ ").split("\n$ "):
        command, *lines = part.splitlines()
        said: dict[str, list[str]] = {mark: [] for mark in ("", *MARKS)}
        for line in lines:
            for name, path in NAMED.items():
                line = line.replace(f"{{{name}}}", str(path))
            mark, _, rest = line.partition(" ")
            if mark in MARKS:
                said[mark].append(rest)
            else:
                said[""].append(line)
        yield typed(command), said


class Terminal:
    """Standard input of somebody who gives these answers and no other."""

    def __init__(self, answers: list[str]) -> None:
        self.answers = [] if answers == ["nobody"] else answers.copy()

    def isatty(self) -> bool:
        return True

    def readline(self) -> str:
        return self.answers.pop(0) + "\n" if self.answers else ""


def run_as(run: Run, command: list[str], answers: list[str]) -> Ran:
    """Run a command with the environment before it, and with answers where there are any."""
    terminal = Terminal(answers)
    with pytest.MonkeyPatch.context() as patch:
        if answers:
            patch.setattr(sys, "stdin", terminal)
        while re.match("[A-Z_]+=", command[0]):
            patch.setenv(*command.pop(0).split("="))
        ran = run(*command)
    assert terminal.answers == []
    return ran


@pytest.mark.parametrize("session", list(sessions()))
def test_what_is_said(run: Run, inside: Path, session: list[str]) -> None:
    write_files(inside)
    told: list[dict[str, Any]] = []
    for command, said in steps(session):
        if make := MAKES.get(command[0]):
            make(*(text.replace("\\n", "\n") for text in command[1:]))
            continue
        before = contents(inside)
        ran = run_as(run, command, said["<"])
        status, _, answered = (said["exit"] or ["0"])[0].partition(" ")
        assert ran.status == int(status), ran.err
        assert "Traceback" not in ran.err
        if ran.status and not answered:
            assert (ran.out, bool(said[""])) == ("", True)
            assert contents(inside) == before
            assert ran.err.startswith("catopt: ") or "--json" not in command
            ran = Ran(0, ran.err, ran.err)
        elif said["="] or said["?"] or ("--json" in command and "import" not in command):
            told.append(read_document(ran.out))
            compare_document(told, said)
        elif not {"export", "import", "--json"} & set(command):
            assert fits(ran.out) or not ran.out
        compare_words(ran, said)
        assert not ran.err or status != "0" or "--out" in command or said["2>"] or said["2="]
        made = [path for path in contents(inside).keys() - before.keys() if path.is_file()]
        names = sorted(path.relative_to(inside).as_posix() for path in made)
        assert said["+"] in ([], [" ".join(names)])
        compare_written(said)
        for line in said["=="]:
            assert run(*typed(line)).out == ran.out != ""


def edit(file: str, *texts: str) -> None:
    changed(Path(file), Path(), *zip(texts[::2], texts[1::2], strict=True))


def write(file: str, text: str) -> None:
    Path(file).parent.mkdir(exist_ok=True)
    Path(file).write_text(text, encoding="utf-8")


def copy(file: str, to: str) -> None:
    Path(to).write_bytes(Path(file).read_bytes())


MAKES: dict[str, Callable[..., None]] = {
    "edit": edit,
    "write": write,
    "copy": copy,
    "mkdir": os.mkdir,
}


def compare_words(ran: Ran, said: dict[str, list[str]]) -> None:
    out, err = words(ran.out), words(ran.err)
    assert [text for text in said[""] if text not in out] == [], out
    assert [text for text in said["!"] if text in out + err] == []
    assert [text for text in said["2>"] if text not in err] == [], err
    assert said["2="] in ([], [err])
    assert said["1="] in ([], ran.out.splitlines())


def compare_written(said: dict[str, list[str]]) -> None:
    for line in said["@"]:
        files, text = line.split(": ", 1)
        assert set(found(files, re.escape(text))) == {True}, line
    for line in said["@!"]:
        assert set(found(*line.split(": ", 1))) == {False}, line
    for line in said["@="]:
        one, other = map(Path, line.split(": "))
        assert one.read_bytes() == other.read_bytes(), line


def found(files: str, text: str) -> list[bool]:
    """Whether a regular expression is found in each of the files."""
    return [bool(re.search(text, contents_in_words(path))) for path in Path().glob(files)]


def compare_document(told: list[dict[str, Any]], said: dict[str, list[str]]) -> None:
    """Compare the last of the documents of a session with what is said of it."""
    document = told[-1]
    if document["schema"] == "catopt.report/1":
        compare_files(document)
    known = vars(math) | {"told": told, "digest": digest} | document
    for line in said["="]:
        compare(document, line, known)
    for line in said["?"]:
        assert eval(line, known), line


def compare(document: dict[str, Any], line: str, known: dict[str, Any]) -> None:
    """Compare one value of a document with what a line says of it."""
    path, _, rest = line.partition(": ")
    value, *tolerance = re.split(r" (abs|rel) (?=\S+$)", rest)
    wanted = eval(value, known)
    if tolerance:
        size = float(tolerance[1])
        absolute = size if tolerance[0] == "abs" else None
        wanted = pytest.approx(wanted, abs=absolute, rel=None if absolute else size)
    assert at(document, re.findall(r"[^.\[\]]+", path)) == wanted, line


def at(node: Any, keys: list[str]) -> Any:
    """Follow keys into a document."""
    if not keys:
        return node
    key, *rest = keys
    if isinstance(node, dict):
        return at(node[key], rest)
    if key.lstrip("-").isdigit():
        return at(node[int(key)], rest)
    name, _, value = key.partition("=")
    return [at(each, rest) for each in node if key == "*" or each[name] == value]


def contents(folder: Path) -> dict[Path, bytes]:
    """Read all files of a folder and of those in it; the folders stand there, too."""
    return {path: path.read_bytes() if path.is_file() else b"" for path in folder.rglob("*")}


def contents_in_words(path: Path) -> str:
    """Read a file; of a workbook its sheets with all their cells."""
    if path.suffix != ".xlsx":
        return words(path.read_text("utf-8"))
    return words(str(sheets(path)))
