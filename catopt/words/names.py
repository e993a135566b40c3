"""Names of components and buoys as they are shown: keys of the catalogues stay as they are."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

from catopt.words.texts import Language, group

_SIZE = re.compile(r"(?P<grade>.*?) ?\b(?P<size>[\d.]+ mm)")


def shown_name(name: str, language: Language) -> str:
    """Say a buoy of the library, or a component with its size; any other text stays as it is.

    A family without a size stays, too: so it is typed.

    Examples
    --------
    >>> shown_name("chain studless R3 76 mm", "vi"), shown_name("chain studless R3", "vi")
    ('xích không ngáng R3 76 mm', 'chain studless R3')
    """
    names = _names(language)
    if name in names and name[-1:] == "m":
        return names[name]
    if not name.endswith(" mm"):
        return name
    for english in names:
        if name.startswith(f"{english} ") and _SIZE.fullmatch(name[len(english) + 1 :]):
            return names[english] + name[len(english) :]
    return name


@cache
def _names(language: Language) -> Mapping[str, str]:
    """Names by their English, the longer ones first."""
    found = {str(each["en"]): str(each[language]) for each in group("names").values()}
    return dict(sorted(found.items(), key=lambda each: -len(each[0])))
