"""Sessions as they are typed, in transcripts/*.txt, and what each command says.

Sessions have an empty line between them; ``# slow`` goes before one that takes long. ``$`` begins
a command; words in capitals are those of conftest.py, other files those of cases.py. The lines
below it are found in what it prints, whatever the breaks of lines are; those after ``2>`` in what
it says beside the answer, and those after ``!`` are not found. A command ends with 0 unless
``exit N`` stands below it; then it has no answer, and all lines are of what it says of that.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from .cases import write_files
from .conftest import NAMED, Run, fits, typed, words

TRANSCRIPTS = Path(__file__).parent / "transcripts"


def sessions() -> Iterator[Any]:
    """Yield every session, with the name of its file and its first command."""
    for path in sorted(TRANSCRIPTS.glob("*.txt")):
        for text in path.read_text("utf-8").split("\n\n"):
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            if lines:
                marks = [pytest.mark.slow] if "# slow" in text else []
                yield pytest.param(lines, marks=marks, id=lines[0].removeprefix("$ "))


def steps(session: list[str]) -> Iterator[tuple[str, int, list[str]]]:
    """Yield each command, how it ends, and what it says."""
    for part in "\n".join(session).removeprefix("$ ").split("\n$ "):
        command, *said = part.splitlines()
        ends = [line for line in said if line.startswith("exit ")]
        yield (
            command,
            int(ends[0].split()[1]) if ends else 0,
            [each for each in said if each not in ends],
        )


@pytest.mark.parametrize("session", list(sessions()))
def test_what_is_said(run: Run, inside: Path, session: list[str]) -> None:
    write_files(inside)
    for command, status, said in steps(session):
        before = contents(inside)
        ran = run(*typed(command))
        assert ran.status == status, ran.err
        assert "Traceback" not in ran.err
        out, err = words(ran.out), words(ran.err)
        if status:
            assert (ran.out, bool(said)) == ("", True)
            assert contents(inside) == before
            assert ran.err.startswith("catopt: ") or "--json" not in command
        elif not any(word in command for word in ("--json", "export", "import")):
            assert fits(ran.out) or not ran.out
        for line in said:
            for name, path in NAMED.items():
                line = line.replace(f"{{{name}}}", str(path))
            if line.startswith("! "):
                assert line[2:] not in out + err
            elif line.startswith("2> "):
                assert line[3:] in err
            else:
                assert line in (err if status else out)
        assert not ran.err or status or "--out" in command or "\n2> " in "\n".join(session)


def contents(folder: Path) -> dict[Path, bytes]:
    """Read all files of a folder and of those in it; the folders stand there, too."""
    return {path: path.read_bytes() if path.is_file() else b"" for path in folder.rglob("*")}
