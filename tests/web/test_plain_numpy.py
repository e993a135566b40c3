"""What a browser has for numpy: every operation is numpy's, and answers are the same."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt.page_api import ask
from catopt.page_api.fields import START
from catopt.web import plain_numpy

ROW = [3.0, -1.0, 2.5, -1.0, math.pi, 0.1, 7.0, 1e9, 0.3]
WHOLE = [4, 0, 7, 7, 2]
TABLE = [[3.0, -1.0, 2.5], [1.0, 0.1, 0.2], [3.0, -2.0, 9.0], [3.0, -1.0, 0.5]]
MANY = [math.sin(17.0 * k) * 10.0 ** (k % 5) for k in range(1000)]

OPERATIONS = {
    "row": lambda n: n.array(ROW)[2],
    "from the end": lambda n: n.array(ROW)[-2],
    "part": lambda n: n.array(ROW)[1:4],
    "backwards": lambda n: n.array(ROW)[::-1],
    "part of a part": lambda n: n.array(ROW)[2:][1:3],
    "mask": lambda n: n.array(ROW)[n.array(ROW) > 0.2],
    "places": lambda n: n.array(ROW)[n.array([4, 0, 0])],
    "list of places": lambda n: n.array(TABLE)[[2, 0]],
    "row of a table": lambda n: n.array(TABLE)[1],
    "cell": lambda n: n.array(TABLE)[2, 1],
    "cell from the end": lambda n: n.array(TABLE)[-1, -1],
    "cell of a block": lambda n: n.array([TABLE, TABLE])[1, 2, 0],
    "column": lambda n: n.array(TABLE)[:, 1],
    "columns": lambda n: n.array(TABLE)[:, [2, 0]],
    "columns from one on": lambda n: n.array(TABLE)[:, 1:],
    "rows of a mask": lambda n: n.array(TABLE)[n.array(TABLE)[:, 0] == 3.0],
    "turned": lambda n: n.array(TABLE).T,
    "keys of a sort": lambda n: n.array(TABLE).T[::-1],
    "sum": lambda n: n.array(ROW) + n.array(ROW),
    "sum with one": lambda n: n.array(ROW) + 1.5,
    "one less": lambda n: 1.0 - n.array(ROW),
    "one over": lambda n: 1.0 / n.array(ROW),
    "product": lambda n: 2.0 * n.array(ROW) * 3.0,
    "table less a row": lambda n: n.array(TABLE) - n.array(TABLE[0]),
    "table over a row": lambda n: n.array(TABLE) / n.array([3.0, 7.0, 0.1]),
    "below a row": lambda n: n.array(TABLE) < n.array([3.0, 0.0, 1.0]),
    "not above": lambda n: n.array(ROW) <= 2.5,
    "not below": lambda n: n.array(ROW) >= 2.5,
    "less": lambda n: -n.array(ROW),
    "least": lambda n: n.array(ROW).min(),
    "least of columns": lambda n: n.array(TABLE).min(axis=0),
    "largest of columns": lambda n: n.array(TABLE).max(axis=0),
    "whole": lambda n: n.array(MANY).sum(),
    "whole of some": lambda n: n.array(MANY[:107]).sum(),
    "whole of few": lambda n: n.array(ROW[:5]).sum(),
    "whole of rows": lambda n: n.array(TABLE).sum(axis=1),
    "all of rows": lambda n: (n.array(TABLE) > 0.0).all(axis=1),
    "kind": lambda n: n.array(ROW).astype(n.int64),
    "numbers, written as floats": lambda n: n.array([1, 2.5]),
    "whole numbers": lambda n: n.array(WHOLE, dtype=n.int64),
    "full": lambda n: n.full((2, 3), n.inf),
    "zeros": lambda n: n.zeros(3, dtype=n.int64),
    "count": lambda n: n.arange(3, 8, dtype=n.int64),
    "even": lambda n: n.linspace(0, 4143, 100).astype(n.int64),
    "even floats": lambda n: n.linspace(0.1, 7.3, 13),
    "one after another": lambda n: n.concatenate((n.array(TABLE), n.array(TABLE)[:2])),
    "after nothing": lambda n: n.concatenate((n.empty((0, 3)), n.array(TABLE))),
    "steps": lambda n: n.diff(n.array(ROW)),
    "choice": lambda n: n.where(n.array(ROW) > 0.0, n.array(ROW), 1.0),
    "parts": lambda n: n.divmod(n.array(WHOLE), 3),
    "finite": lambda n: n.isfinite(n.array([1.0, n.nan, n.inf, -n.inf])),
    "sizes": lambda n: n.abs(n.array(ROW)),
    "range": lambda n: n.ptp(n.array(TABLE), axis=0),
    "where least": lambda n: n.argmin(n.array(ROW)),
    "where largest": lambda n: n.argmax(n.array(ROW)),
    "where first true": lambda n: n.argmax(n.array(ROW) < 0.2),
    "where true": lambda n: n.flatnonzero(n.array(ROW) < 0.2),
    "order": lambda n: n.argsort(n.array(ROW), kind="stable"),
    "order by two": lambda n: n.lexsort(n.array(TABLE).T[::-1]),
    "place": lambda n: n.searchsorted(n.array(sorted(ROW)), -1.0),
    "place after": lambda n: n.searchsorted(n.array(sorted(ROW)), -1.0, side="right"),
    "least so far": lambda n: n.minimum.accumulate(n.array(ROW)),
}


def plain(value: Any) -> Any:
    """Make lists and numbers of what an operation gives."""
    if isinstance(value, tuple):
        return [plain(each) for each in value]
    return value.tolist() if hasattr(value, "tolist") else value


@pytest.mark.parametrize("name", OPERATIONS)
def test_an_operation_gives_what_numpy_gives(name: str) -> None:
    found = OPERATIONS[name](plain_numpy)
    wanted = OPERATIONS[name](np)
    assert plain(found) == plain(wanted)
    assert getattr(found, "shape", ()) == getattr(wanted, "shape", ())


@pytest.mark.parametrize(
    ("at", "value"),
    [
        ((1, 2), 5.0),
        ((slice(None), 0), [9.0, 8.0, 7.0, 6.0]),
        ((slice(None), 0), 0.5),
        (-1, [9.0, 8.0, 7.0]),
        ((0, slice(None, 2)), 1.5),
    ],
)
def test_a_change_reaches_what_numpy_lets_it_reach(at: Any, value: Any) -> None:
    made, known = plain_numpy.array(TABLE), np.array(TABLE)
    many = isinstance(value, list)
    made[at] = plain_numpy.array(value) if many else value
    known[at] = np.array(value) if many else value
    assert made.tolist() == known.tolist()


def test_rows_and_parts_are_views_and_masks_choose_what_is_changed() -> None:
    found: list[Any] = []
    for n in (plain_numpy, np):
        made: Any = n.array(TABLE)
        made[made[:, 0] == 3.0, 1] = 0.5
        made[2][1:][0] = 4.0
        n.minimum.accumulate(n.array([3.0, 4.0, 1.0]), out=made[1])
        found.append(made.tolist())
    assert found[0] == found[1] != TABLE


@pytest.mark.parametrize(
    "wrong",
    [
        lambda n: n.array(ROW)[len(ROW)],
        lambda n: n.array(ROW)[:3][3],
        lambda n: n.array(TABLE)[0, 3],
        lambda n: n.array(TABLE)[4],
        lambda n: n.array(ROW) + n.array(ROW[:3]),
        lambda n: n.polynomial.legendre,
    ],
)
def test_what_is_not_there_is_an_error(wrong: Any) -> None:
    with pytest.raises((IndexError, ValueError, AttributeError)):
        wrong(plain_numpy)


IN_PLACE_OF_NUMPY = """
import json, sys
from importlib.util import module_from_spec, spec_from_file_location
for name in ("matplotlib", "numba", "pandas", "pint", "pymoo", "pyswarms", "scipy", "typer"):
    sys.modules[name] = None
spec = spec_from_file_location("numpy", sys.argv[1])
sys.modules["numpy"] = sys.modules["numpy.typing"] = module_from_spec(spec)
spec.loader.exec_module(sys.modules["numpy"])
from catopt.page_api import ask
print(json.dumps([ask(call, question) for call, question in json.loads(sys.argv[2])]))
"""


@pytest.mark.parametrize(
    "calls",
    [
        (("line", "note"), ("line", "curve"), ("tanker", "size")),
        pytest.param(
            (("buoy", "note"), ("buoy", "size"), ("tanker", "note"), ("body", "note")),
            marks=pytest.mark.slow,
        ),
    ],
)
def test_answers_are_those_with_numpy(calls: tuple[tuple[Any, str], ...]) -> None:
    asked = [(call, {"door": door, "values": START[door], "lang": "vi"}) for door, call in calls]
    ran = subprocess.run(
        [sys.executable, "-c", IN_PLACE_OF_NUMPY, plain_numpy.__file__, json.dumps(asked)],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=True,
    )
    wanted = json.loads(json.dumps([ask(call, question) for call, question in asked]))
    assert json.loads(ran.stdout) == wanted
    assert all("status" not in each or each["status"] == "converged" for each in wanted)
