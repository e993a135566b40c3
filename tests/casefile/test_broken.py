"""Case files as users break them, each with its whole message.

Beside every ``broken/NAME.toml`` stands ``broken/NAME.txt``, the message word for word.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt.casefile import read_case
from catopt.errors import InputError

BROKEN = Path(__file__).parent / "broken"
NAMES = sorted(path.stem for path in BROKEN.glob("*.toml"))


@pytest.mark.parametrize("name", NAMES)
def test_the_message_is_exactly_this(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(BROKEN)
    with pytest.raises(InputError) as caught:
        read_case(f"{name}.toml")
    expected = (BROKEN / f"{name}.txt").read_text(encoding="utf-8")
    assert f"{caught.value}\n" == expected


def test_every_broken_file_has_its_message() -> None:
    assert sorted(path.stem for path in BROKEN.glob("*.txt")) == NAMES
    assert len(NAMES) >= 20
