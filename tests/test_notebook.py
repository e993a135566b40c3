"""The notebook in docs/ runs from its first cell to its last."""

from __future__ import annotations

import ast
import json
from pathlib import Path
from typing import Any

import pytest

NOTEBOOK = Path("docs") / "for-moorpy-users.ipynb"


def cells() -> list[str]:
    document = json.loads(NOTEBOOK.read_text("utf-8"))
    found = [each for each in document["cells"] if each["cell_type"] == "code"]
    assert all(each["outputs"] == [] for each in found)  # outputs are made by who opens it
    return ["".join(each["source"]) for each in found]


def run(code: str, names: dict[str, Any]) -> Any:
    """Run a cell; the value of its last line is what a notebook shows."""
    tree = ast.parse(code)
    *before, last = tree.body
    if not isinstance(last, ast.Expr):
        exec(compile(tree, "cell", "exec"), names)
        return None
    exec(compile(ast.Module(before, []), "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names)


def test_the_notebook_runs(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, Any] = {}
    shown = [run(code, names) for code in cells()]
    printed = capsys.readouterr().out
    # What MoorPy prints for this leg of VolturnUS-S at 9.80665 m/s2.
    assert "H 1349.55 kN, T 2435.56 kN, 502.96 m on the bed" in printed
    assert "(1001,) True" in printed
    assert sum(hasattr(each, "savefig") for each in shown) == 2
    assert hasattr(names["case"], "line")
    assert len(shown[-1]) > 3
