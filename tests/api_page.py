"""The tables of docs/api.md and docs/api-parts.md: each name with its docstring's first words.

``python -m tests.api_page`` brings the pages up to date. On the site the tables give way to the
docstrings themselves (docs/site/hooks.py).
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import catopt

DOCS = Path(__file__).parents[1] / "docs"
PAGES = (DOCS / "api.md", DOCS / "api-parts.md")

_TABLE = re.compile(
    r"(?P<head><!-- (?P<module>catopt[a-z_.]*)(?P<names>(?: \w+)*): "
    r"python -m tests\.api_page -->\n)"
    r".*?(?P<tail>^<!-- end -->$)",
    re.DOTALL | re.MULTILINE,
)


def up_to_date(page: str) -> str:
    """Put the real tables in the place of what a page shows."""
    return _TABLE.sub(lambda found: f"{found['head']}\n{_table(found)}\n{found['tail']}", page)


def names(page: str) -> Iterator[tuple[str, str]]:
    """Yield module and name of everything that a page describes, in its order."""
    for found in _TABLE.finditer(page):
        for name in _named(found):
            yield found["module"], name


def _named(found: re.Match[str]) -> list[str]:
    """Names of one table: those after the module, or all of the module's that are not catopt's."""
    if found["names"]:
        return found["names"].split()
    module = import_module(found["module"])
    return [
        name
        for name in module.__all__
        if name not in catopt.__all__ and _is_described(getattr(module, name))
    ]


def _is_described(thing: object) -> bool:
    return inspect.isclass(thing) or inspect.isroutine(thing)


def _table(found: re.Match[str]) -> str:
    module = import_module(found["module"])
    lines = ["| name | what it is |", "|---|---|"]
    for name in _named(found):
        thing = getattr(module, name)
        words = (inspect.getdoc(thing) or "").partition("\n\n")[0].replace("\n", " ")
        lines.append(f"| [`{name}`]({_source(thing)}) | {words.replace('|', chr(92) + '|')} |")
    return "".join(f"{line}\n" for line in lines)


def _source(thing: object) -> str:
    """Link to where a thing is defined, also when the installed package is elsewhere."""
    module = Path(import_module(str(thing.__module__)).__file__ or "")
    return f"../catopt/{module.relative_to(Path(catopt.__file__).parent).as_posix()}"


if __name__ == "__main__":
    for each in PAGES:
        each.write_text(up_to_date(each.read_text("utf-8")), encoding="utf-8")
