"""Begins another language: ``python -m tests.new_language fr`` puts the English where its words go.

Every text of catopt stands beside its English in a TOML file; each gets a line for the language,
with the English until it is translated.
"""

from __future__ import annotations

import re
import sys
from importlib.resources import files
from pathlib import Path

PACKAGE = Path(str(files("catopt")))
_TEXT = r'"(?:[^"\\\n]|\\.)*"'
_WORDS = rf'(?:"""(?:[^"]|"(?!""))*"""|{_TEXT}|\{{(?:[^{{}}"\n]|{_TEXT})*\}})'
_LINE = re.compile(rf"^en(?P<form>(?:\.\w+)?) = (?P<words>{_WORDS})$", re.M)
_INLINE = re.compile(rf"(?P<head>\ben = (?P<words>{_WORDS}), vi = {_WORDS})")


def begun(text: str, language: str) -> str:
    """Put the English beside the texts of a file as those of another language."""
    text = _LINE.sub(
        lambda found: f"{found[0]}\n{language}{found['form']} = {found['words']}", text
    )
    return _INLINE.sub(lambda found: f"{found['head']}, {language} = {found['words']}", text)


if __name__ == "__main__":
    for path in PACKAGE.rglob("*.toml"):
        path.write_text(begun(path.read_text("utf-8"), sys.argv[1]), "utf-8")
