"""The arrows between the parts of catopt point down, and every part has its place.

Imports inside functions count: they are as binding as those at the top of a module.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import catopt

PACKAGE = Path(catopt.__file__).parent

BASE = {
    "errors", "constants", "documents", "dimensions", "units",
    "quantities", "words", "tables", "cells",
    "arrays", "compiled", "interrupt", "progress", "threads", "largest", "display", "records",
    "old_names",
}  # fmt: skip
SOLVING = BASE | {"model", "catenary"}
READING = {"catalogue", "casefile", "decks"}
DESIGNING = {"checks", "design"}
ALL_BUT_CLI = (
    SOLVING
    | READING
    | DESIGNING
    | {"mooring", "loads", "schemas", "verify", "reproduce", "sizing", "study", "export", "report"}
    | {"answers", "figures", "notes", "render", "page_api", "web"}
)
MOST_LINES = 600
"""Of one file."""
RESULTS = {
    *("model", "catenary", "mooring", "design", "verify", "reproduce", "study"),
    *("sizing", "loads", "floater"),
}
"""Parts whose results are drawn: only a type checker reads them there."""

MAY_IMPORT: dict[str, set[str]] = {
    "_version": set(),
    "errors": {"words"},
    "constants": set(),
    "arrays": set(),
    "documents": {"errors", "words"},
    "dimensions": {"constants"},
    "units": {"errors", "constants", "dimensions", "words"},
    "quantities": {"constants", "dimensions"},
    "tables": {"errors", "dimensions", "documents", "units", "words"},
    "cells": {"errors", "tables", "words"},
    "words": {"quantities"},
    "compiled": {"errors", "machine_code", "words"},
    "machine_code": {"interrupt", "machine_tuples"},
    "machine_tuples": set(),
    "interrupt": set(),
    "progress": {"words"},
    "threads": set(),
    "largest": set(),
    "display": set(),
    "records": {"_version"},
    "old_names": set(),
    "schemas": {"errors", "documents", "words"},
    "model": BASE,
    "catalogue": BASE | {"model"},
    "decks": SOLVING,
    "casefile": BASE | {"model", "catalogue", "schemas", "decks"},
    "catenary": BASE | {"model"},
    "mooring": SOLVING,
    "waves": BASE | {"model"},
    "hydro": BASE | {"model", "waves"},
    "fem": BASE | {"model", "waves", "hydro"},
    "floater": SOLVING | {"mooring", "waves", "hydro", "fem", "loads"},
    "loads": BASE | {"model", "waves", "catalogue"},
    "checks": SOLVING | {"catalogue", "mooring"},
    "design": SOLVING | {"catalogue", "mooring", "checks"},
    "verify": SOLVING | {"mooring", "checks", "fem", "waves", "hydro", "floater"},
    "sizing": SOLVING
    | DESIGNING
    | {"catalogue", "casefile", "loads", "mooring", "waves", "verify"},
    "study": SOLVING
    | READING
    | {"checks", "design", "mooring", "verify", "sizing", "notes", "_version"},
    "reproduce": SOLVING | READING | {"mooring", "loads", "waves", "fem", "verify"},
    "export": SOLVING | {"mooring", "loads", "decks", "_version"},
    "notes": SOLVING
    | READING
    | DESIGNING
    | {"mooring", "loads", "schemas", "verify", "sizing", "_version"},
    "answers": SOLVING
    | READING
    | DESIGNING
    | {"mooring", "loads", "catalogue", "fem", "verify", "reproduce", "sizing", "study"}
    | {"notes", "figures"},
    "render": BASE | {"answers", "figures", "_version"},
    "figures": BASE | RESULTS,
    "report": SOLVING
    | {"answers"}
    | READING
    | DESIGNING
    | {"mooring", "loads", "schemas", "verify", "reproduce", "sizing", "study", "_version"}
    | {"figures", "notes", "render"},
    "page_api": SOLVING
    | READING
    | DESIGNING
    | {"mooring", "loads", "sizing", "answers", "figures", "notes", "render", "report", "_version"},
    "web": {"errors", "documents", "words", "page_api", "render", "_version"},
    "compile_jobs": SOLVING
    | READING
    | DESIGNING
    | {"mooring", "fem", "waves", "verify", "floater"},
    "cli": ALL_BUT_CLI | {"compile_jobs", "_version"},
    "__main__": {"cli", "errors", "interrupt", "threads", "words", "_version"},
    "__init__": SOLVING
    | READING
    | DESIGNING
    | {"mooring", "loads", "verify", "sizing", "study", "answers", "render", "report"}
    | {"_version"},
}
"""What each part may import beside itself; a part is a module or a folder of catopt."""


def part_of(module: Path, package: Path) -> str:
    """Folder or module of the package to which a file belongs."""
    return module.relative_to(package).with_suffix("").parts[0]


def imported_parts(
    module: Path, package: Path, *, only_run: bool = False
) -> Iterator[tuple[int, str]]:
    """Line and part of every import from the package, wherever it stands in the module."""
    for line, name in imported_names(module, package, only_run=only_run):
        path = name.split(".")
        yield line, path[1] if len(path) > 1 else "__init__"


def imported_names(
    module: Path, package: Path, *, only_run: bool = False
) -> Iterator[tuple[int, str]]:
    """Line and full name of every such import."""
    inside = [package.name, *module.relative_to(package).parent.parts]
    tree = ast.parse(module.read_text(encoding="utf-8"), str(module))
    if only_run:
        tree.body = [node for node in tree.body if not _is_for_types(node)]
    for node in ast.walk(tree):
        for name in _targets(node, inside):
            if name.split(".")[0] == package.name:
                yield getattr(node, "lineno", 0), name


def _is_for_types(node: ast.stmt) -> bool:
    """Whether a statement runs for type checkers alone."""
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def _targets(node: ast.AST, inside: list[str]) -> list[str]:
    """Full dotted names that a node imports; ``from a import b`` gives ``a.b``."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        start = inside[: len(inside) - node.level + 1] if node.level else []
        base = ".".join([*start, *([node.module] if node.module else [])])
        return [f"{base}.{alias.name}" for alias in node.names]
    if isinstance(node, ast.Call) and _called(node) in {"import_module", "__import__"}:
        return [str(arg.value) for arg in node.args[:1] if isinstance(arg, ast.Constant)]
    return []


def _called(call: ast.Call) -> str:
    """Last part of the name of the function that is called."""
    if isinstance(call.func, ast.Attribute):
        return call.func.attr
    return call.func.id if isinstance(call.func, ast.Name) else ""


def violations(package: Path, may_import: dict[str, set[str]]) -> list[str]:
    """Every import that the table does not allow, and every part that it lacks."""
    found = []
    for module in sorted(package.rglob("*.py")):
        part = part_of(module, package)
        place = module.relative_to(package.parent).as_posix()
        if part not in may_import:
            found.append(f"{place}: {part} is not in the table")
            continue
        for line, target in imported_parts(module, package):
            name = target if target in may_import else "__init__"
            if name != part and name not in may_import[part]:
                found.append(f"{place}:{line}: {part} may not import {target}")
    return found


def test_no_import_points_up() -> None:
    assert violations(PACKAGE, MAY_IMPORT) == []


def module_name(module: Path, package: Path) -> str:
    """Dotted name of a file; that of its folder for an ``__init__``."""
    parts = module.relative_to(package.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def circles(package: Path) -> list[str]:
    """Files that import each other over any number of steps, also inside functions."""
    files = {module_name(module, package): module for module in package.rglob("*.py")}
    graph = {
        name: {
            target if target in files else target.rpartition(".")[0]
            for _, target in imported_names(module, package, only_run=True)
        }
        & files.keys()
        for name, module in files.items()
    }
    for name in graph:
        graph[name].discard(name)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def test_no_file_imports_in_a_circle() -> None:
    """What only a type checker reads is left out: a document names the result that it is of."""
    assert circles(PACKAGE) == []


def test_a_planted_circle_is_caught(tmp_path: Path) -> None:
    package = tmp_path / "tool"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "a.py").write_text("from tool.b import thing")
    (package / "b.py").write_text("from tool import c")
    (package / "c.py").write_text("def later():\n    import tool.a")
    assert set(circles(package)) == {"tool.a", "tool.b", "tool.c"}
    (package / "c.py").write_text("")
    assert circles(package) == []


LAID_OUT = BASE | {"model", "catalogue", "answers", "figures"}
LAID_OUT -= {"arrays", "compiled", "interrupt", "progress", "largest"}
"""All that runs to lay an answer out; results are read, and nothing is solved."""
SAID = (
    *("catopt.verify.motion_words.", "catopt.verify.comparison."),
    *("catopt.checks.verdict.", "catopt.checks.kinds.", "catopt.design.result."),
    *("catopt.loads.ship.SHORTEST", "catopt.verify.convergence_check.LIMIT"),
    *("catopt.mooring.afloat_words.", "catopt.sizing.quick.MARGIN"),
    "catopt.checks.result.AtLevels",
)
"""What results say of themselves in words, are rounded to or measured in."""


def test_no_file_is_too_long_to_be_read_as_a_whole() -> None:
    lines = {path: path.read_text("utf-8").count("\n") for path in PACKAGE.rglob("*.py")}
    assert {path.name: count for path, count in lines.items() if count > MOST_LINES} == {}


def test_answers_solve_nothing() -> None:
    for module in sorted((PACKAGE / "answers").rglob("*.py")):
        for line, name in imported_names(module, PACKAGE, only_run=True):
            target = name.split(".")[1]
            assert target in LAID_OUT or name.startswith(SAID), f"{module}:{line}: {name}"


def test_renderers_know_no_kind() -> None:
    for module in sorted((PACKAGE / "render").rglob("*.py")):
        for node in ast.walk(ast.parse(module.read_text("utf-8"))):
            for name in _targets(node, ["catopt", "render"]):
                if name.startswith("catopt.answers"):
                    assert name.startswith("catopt.answers.blocks"), f"{module}: {name}"


def test_every_part_of_the_table_exists() -> None:
    present = {part_of(module, PACKAGE) for module in PACKAGE.rglob("*.py")}
    assert set(MAY_IMPORT) == present


def test_the_table_has_no_circle() -> None:
    """A part that may import another may not be imported by it, over any number of steps."""
    below: dict[str, set[str]] = {}
    for part in MAY_IMPORT:
        reached: set[str] = set()
        front = set(MAY_IMPORT[part])
        while front:
            reached |= front
            front = set().union(*(MAY_IMPORT[each] for each in front)) - reached
        below[part] = reached
    assert [part for part, reached in below.items() if part in reached] == []


def of_type_checkers(module: Path) -> set[int]:
    """Lines that only a type checker reads."""
    return {
        node.lineno
        for block in ast.walk(ast.parse(module.read_text(encoding="utf-8")))
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
        for node in ast.walk(block)
        if isinstance(node, ast.Import | ast.ImportFrom)
    }


def test_drawings_import_no_solver() -> None:
    """Not when they run: results are their arguments, and only a type checker reads their types."""
    found = [
        f"{module.name}:{line}: {part}"
        for module in (PACKAGE / "figures").glob("*.py")
        for line, part in imported_parts(module, PACKAGE)
        if part not in BASE | {"figures"} and line not in of_type_checkers(module)
    ]
    assert found == []


def test_renderers_know_no_kind_of_drawing() -> None:
    """They import the description of a chart, and no chart."""
    found = {
        target
        for module in (PACKAGE / "render").glob("*.py")
        for node in ast.walk(ast.parse(module.read_text(encoding="utf-8")))
        for target in _targets(node, ["catopt", "render"])
        if target.startswith("catopt.figures") and not target.startswith("catopt.figures.chart.")
    }
    assert found == set()


TABLE = {"low": set[str](), "high": {"low"}, "__init__": {"low", "high"}}


@pytest.mark.parametrize(
    ("text", "caught"),
    [
        ("from tool.high import thing", True),
        ("from tool import high", True),
        ("import tool.high", True),
        ("from ..high import thing", True),
        ("from .. import high", True),
        ("from tool import thing", True),
        ("import tool", True),
        ("def later():\n    from tool.high.inner import thing", True),
        ("from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import tool.high as t", True),
        ("import importlib\nimportlib.import_module('tool.high')", True),
        ("from tool.low.other import thing", False),
        ("from .other import thing", False),
        ("import json", False),
        ("import toolbox.high", False),
    ],
)
def test_a_planted_import_is_caught(tmp_path: Path, text: str, caught: bool) -> None:
    package = tmp_path / "tool"
    for folder in ("low", "high"):
        (package / folder).mkdir(parents=True)
        (package / folder / "__init__.py").write_text("")
    (package / "__init__.py").write_text("")
    (package / "low" / "module.py").write_text(text)
    found = violations(package, TABLE)
    assert len(found) == (1 if caught else 0), found
    assert all(entry.startswith("tool/low/module.py:") for entry in found)


def test_the_allowed_direction_and_a_folder_without_place(tmp_path: Path) -> None:
    package = tmp_path / "tool"
    (package / "high").mkdir(parents=True)
    (package / "high" / "a.py").write_text("from tool.low import thing")
    assert violations(package, TABLE) == []
    (package / "attic").mkdir()
    (package / "attic" / "b.py").write_text("")
    assert violations(package, TABLE) == ["tool/attic/b.py: attic is not in the table"]


NAMES_A_HULL = re.compile(
    r"FloatingHull|HullOfCoefficients|HullAfloat|ShipAfloat|floater\.(ship|hull|buoy)\b"
)
ASKS_WHICH_HULL = re.compile(
    r"isinstance\([^)]*(FloatingHull|HullOfCoefficients)|floater\.(ship|hull|buoy) is|"
    r'"floater\.(ship|hull|buoy)" in|floater\.(ship|hull|buoy)[:)]'
)


def test_few_files_know_the_kinds_of_hulls() -> None:
    """Before there was a protocol 23 named one and 9 asked which; a new one touches none."""
    texts = {
        path.relative_to(PACKAGE).as_posix(): path.read_text("utf-8")
        for path in PACKAGE.rglob("*.py")
    }
    named = [name for name, text in texts.items() if NAMES_A_HULL.search(text)]
    asking = {name for name, text in texts.items() if ASKS_WHICH_HULL.search(text)}
    assert len(named) <= 17, named
    # Linear motion takes one of revolution alone; a ship is run on two time scales.
    assert asking <= {"verify/linear.py", "verify/two_scales.py", "sizing/ship_band.py"}
