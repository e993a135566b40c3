"""What ``catopt size`` says of mistakes in a file: broken_sizing/NAME.txt, word for word.

Beside it stands ``NAME.toml``, whose name begins with the command.
"""

from __future__ import annotations

import pytest

from .conftest import BROKEN, Run, refused

NAMES = sorted({path.stem for path in BROKEN.iterdir()})
assert len(NAMES) >= 20


@pytest.mark.parametrize("name", NAMES)
def test_the_message_is_exactly_this(run: Run, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(BROKEN)
    ran = refused(run, "size", name.partition("-")[0], f"{name}.toml")
    assert ran.err == (BROKEN / f"{name}.txt").read_text(encoding="utf-8")
