"""The notebook in docs/ runs from its first cell to its last, and has what it gives.

``python -m tests.test_notebook`` puts the outputs in.
"""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.snippets import FENCE, PAGES

NOTEBOOK = Path("docs") / "for-moorpy-users.ipynb"


def cells() -> list[str]:
    document = json.loads(NOTEBOOK.read_text("utf-8"))
    found = [each for each in document["cells"] if each["cell_type"] == "code"]
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


def executed() -> Any:
    """Run it by Jupyter's own client, whose front ends show what it gets."""
    client = pytest.importorskip("nbclient", reason="optional extra: notebook")
    pytest.importorskip("ipykernel", reason="optional extra: notebook")
    formats = pytest.importorskip("nbformat", reason="optional extra: notebook")
    notebook = formats.read(NOTEBOOK, as_version=4)
    places = {"metadata": {"path": str(Path.cwd())}}
    run = client.NotebookClient(notebook, timeout=None, resources=places, record_timing=False)
    return run.execute()


def said_in(cell: Any) -> str:
    """Give the text of a cell's outputs; of a figure there is none but its size."""
    shown = ["".join(each.get("data", {}).get("text/plain", "")) for each in cell["outputs"]]
    return "".join((*shown, *("".join(each.get("text", "")) for each in cell["outputs"])))


@pytest.mark.slow
def test_a_notebook_has_its_outputs_and_a_picture_at_each_plot() -> None:
    notebook = executed()
    shipped = json.loads(NOTEBOOK.read_text("utf-8"))["cells"]
    for cell, kept in zip(notebook.cells, shipped, strict=True):
        if cell.cell_type == "code":
            assert said_in(cell) == said_in(kept), "write it anew: python -m tests.test_notebook"
            assert kept["outputs"], cell.source  # every cell ends with something to show
    plots = [each for each in notebook.cells if ".plot()" in each.source]
    assert len(plots) == 2
    for cell in plots:
        shown = [each.get("data", {}) for each in cell.outputs]
        assert any("image/png" in each for each in shown), cell.source


def test_a_figure_has_a_picture_of_its_own_whatever_the_backend() -> None:
    """A PNG file by its first bytes: no backend is asked."""
    import catopt

    line = catopt.Line([catopt.Segment(length="20 m", submerged_weight="9.5 kgf/m")])
    figure: Any = catopt.solve(line, height="9.5 m", horizontal_force="343 kgf").plot()
    assert figure._repr_png_().startswith(b"\x89PNG\r\n\x1a\n")


def python_of(page: Path) -> Iterator[tuple[int, str]]:
    """Yield what a page shows as Python, run or not, with its place among the page's blocks.

    The page for those who change catopt has lines of its source, which are not run, too.
    """
    for number, block in enumerate(FENCE.finditer(page.read_text("utf-8"))):
        is_source = page.stem == "architecture" and block["info"] == "python"
        if block["info"].split()[:1] == ["python"] and not is_source:
            yield number, block["body"]


@pytest.mark.slow
def test_a_type_checker_passes_what_the_pages_show(tmp_path: Path) -> None:
    """Every block of every page a file, and the notebook, whose last lines are shown, one."""
    code = {f"{page.stem}_{k}": body for page in PAGES for k, body in python_of(page)}
    code["notebook"] = "\n".join(cells())
    assert {"README", "quick-start", "dynamics", "truss", "export"} <= {
        name.rpartition("_")[0] for name in code
    }
    for name, body in code.items():
        (tmp_path / f"{name.replace('-', '_')}.py").write_text(body, "utf-8")
    command = [sys.executable, "-m", "mypy", "--ignore-missing-imports", str(tmp_path)]
    cache = ["--cache-dir", str(tmp_path / "cache")]
    checked = subprocess.run([*command, *cache], capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout


if __name__ == "__main__":
    pytest.importorskip("nbformat").write(executed(), NOTEBOOK)
