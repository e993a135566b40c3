"""Names and numbers as other programs take them."""

from __future__ import annotations

import re
import unicodedata
from textwrap import wrap

_WITHOUT_MARKS = str.maketrans({"đ": "d", "Đ": "D"})


def plain(text: str) -> str:
    """Return a text in one line of ASCII: letters lose their marks, the rest becomes ``?``."""
    apart = unicodedata.normalize("NFKD", text.translate(_WITHOUT_MARKS))
    kept = "".join(letter for letter in apart if not unicodedata.combining(letter))
    return " ".join(kept.encode("ascii", "replace").decode("ascii").split())


def word(text: str, instead: str) -> str:
    """Return a text as one word of letters, digits and underscores that begins with a letter.

    `instead`: taken where nothing is left, and put before what does not begin with a letter.
    """
    kept = re.sub(r"[^A-Za-z0-9.]+", "_", plain(text).replace("?", " ")).strip("_.")
    kept = kept.replace(".", "p")
    if not kept:
        return instead
    return kept if kept[0].isalpha() else f"{instead}_{kept}"


def exact(value: float) -> str:
    """Return a number that reads back as the same double, for YAML 1.1 too: ``1.0e-07``."""
    digits = repr(float(value) + 0.0)
    return digits if "." in digits else digits.replace("e", ".0e")


def folded(text: str) -> list[str]:
    """Fold to 100 columns; nothing in it looks like the head of a section."""
    indent = " " * (len(text) - len(text.lstrip()))
    safe = plain(text)
    while "---" in safe:
        safe = safe.replace("---", "--")
    return wrap(
        safe, 100, initial_indent=indent, subsequent_indent=indent + "  ", break_on_hyphens=False
    )


def significant(value: float) -> str:
    """Return a number with ten significant digits; what is below 1e-9 is rounding and 0."""
    return f"{value:.10g}" if abs(value) > 1e-9 else "0"
