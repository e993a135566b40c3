"""Which tests are quick: the list of the others names only tests that there are."""

from __future__ import annotations

import re

import pytest

from .conftest import ROOT
from .longer import KEPT, LIMIT, LIMIT_OF_FILE, LIMIT_OF_ONE, LONGER, ONE_BY_ONE, longer, read


@pytest.mark.parametrize("name", sorted({*read(LONGER), *KEPT, *ONE_BY_ONE}))
def test_every_name_is_that_of_a_test(name: str) -> None:
    file, _, function = name.partition("[")[0].partition("::")
    text = (ROOT / file).read_text("utf-8")
    assert not function or re.search(rf"^def {function}\(", text, re.MULTILINE)


def test_longer_are_files_functions_and_single_sessions() -> None:
    session = ONE_BY_ONE[0]
    times = [
        ("tests/a.py::test_b", LIMIT_OF_FILE),
        ("tests/a.py::test_c[1]", 0.1),
        ("tests/d.py::test_e[1]", 0.6 * LIMIT),
        ("tests/d.py::test_e[2]", 0.6 * LIMIT),
        ("tests/d.py::test_f", 0.9 * LIMIT),
        (f"{session}[short]", 0.9 * LIMIT_OF_ONE),
        (f"{session}[long]", 1.1 * LIMIT_OF_ONE),
        (KEPT[0], 100.0),
    ]
    assert longer(times) == ["tests/a.py", f"{session}[long]", "tests/d.py::test_e"]
