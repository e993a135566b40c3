"""Mark as slow what stands in longer.txt; `python -m tests.longer` writes that list."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt.threads import one_thread

from .longer import LONGER, names_of, read

ROOT = Path(__file__).parents[1]

one_thread()  # as the command does, or the last digits of a run are another's than its worker's


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave a whole file out where the quick tests are asked for: reading it takes time, too."""
    is_quick = config.option.markexpr == "not slow"
    name = collection_path.relative_to(ROOT).as_posix()
    return True if is_quick and name in read(LONGER) else None


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what is longer, and therefore slow, of what is not marked slow where it stands."""
    names = read(LONGER)
    for item in items:
        is_slow = item.get_closest_marker("slow") is not None
        if not is_slow and not names.isdisjoint(names_of(item.nodeid)):
            item.add_marker("longer")
            item.add_marker("slow")
