"""``catopt new`` writes a case that solves and never touches what is there."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt.casefile import TEMPLATES, template

from .conftest import Run, refused

EACH = [pytest.param(name, marks=[pytest.mark.slow] * (name == "motion")) for name in TEMPLATES]


@pytest.mark.parametrize("name", EACH)
def test_what_it_says_to_type_next_works(run: Run, name: str, inside: Path) -> None:
    """And the answer passes what is checked: an example that fails teaches nothing."""
    ran = run("new", name)
    assert (ran.status, ran.err) == (0, "")
    assert (inside / f"{name}.toml").read_bytes() == template(name).encode("utf-8")
    said, _, command = ran.out.strip().partition("; try it with: catopt ")
    files = [name, TEMPLATES[name].needs] if TEMPLATES[name].needs else [name]
    assert said == " and ".join(f"{each}.toml" for each in files) + " written"
    answer = run(*command.split())
    assert answer.status == 0
    assert "FAIL" not in answer.out


def test_a_disk_that_fills_leaves_no_half_a_file(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.toml"
    opened = Path.open

    def full(self: Path, *arguments: str, **options: str) -> object:
        stream = opened(self, *arguments, **options)  # type: ignore[call-overload]
        if self == path:
            stream.close()
            raise OSError(28, "No space left on device")
        return stream

    monkeypatch.setattr(Path, "open", full)
    ran = refused(run, "new", "buoy", path)
    assert "No space left on device" in ran.err
    assert not path.exists()


def test_help_names_every_template(run: Run) -> None:
    shown = run("new", "--help").out
    assert [name for name in TEMPLATES if name not in shown] == []
