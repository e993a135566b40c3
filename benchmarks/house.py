"""The package by part: lines, files, functions, what is not code, and what is named but once.

    python -m benchmarks.house [--beside REV] [--smoke] [--out FILE]

Counts the Python files of `catopt` as they are here and, where asked, as they were in a commit of
git, each as "then → now". Imports, signatures (a function's lines above its body) and blanks are
shares of all lines. A private function is named once where its file has its name at one place
outside its definition: its one caller may be where it belongs. The catalogues, schemas and texts
beside the code are counted apart, by their lines.

Statements are counted without imports and docstrings. A fork is a place that asks which kind a
mooring is, a line, a body on lines or lines between points: a test of a type, of `system` or of
`network` that may be None, or a question for `several_lines`. Solvers are listed by what they find.
"""

from __future__ import annotations

import argparse
import ast
import io
import subprocess
import tarfile
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields

from benchmarks.common import ROOT, page

PACKAGE = "catopt"
DATA = (".json", ".toml")
Tree = Mapping[str, str]
"""Texts by their path from the root."""

KINDS = {"Network", "System"}
"""Types that are kinds of a mooring."""
MAYBE = {"network", "system"}
"""Names of what is None for a mooring of another kind."""
ASKED = "several_lines"
"""What says which of two kinds it is."""

SOLVERS = {
    "what a line between two points pulls with, and how stiffly": (
        "mooring/net.py:hang",
        "mooring/balance.py:pull_at",
        "mooring/line_ends.py:ends_of",
    ),
    "step of Newton's method": (
        "mooring/rest.py:_step",
        "mooring/descent.py:_newton_step",
        "mooring/joints.py:step",
    ),
    "place of rest": (
        "mooring/rest.py:rest",
        "mooring/descent.py:newton",
        "mooring/joints.py:rest",
    ),
    "heading at rest": (
        "mooring/heading.py:settle",
        "mooring/static_equilibrium.py:static_equilibrium",
        "mooring/joints.py:nudge",
    ),
    "restoring curve": (
        "mooring/restoring.py:restoring_curve",
        "mooring/restoring.py:network_curve",
    ),
    "watch circle": ("mooring/restoring.py:watch_circle", "mooring/restoring.py:network_circle"),
    "one line out": ("mooring/case.py:one_line_out", "mooring/network_out.py:each_line_out"),
    "search that tries lines in motion": (
        "sizing/motion_search.py:search_in_motion",
        "sizing/ship_search.py:search_ship_in_motion",
        "study/design_in_motion.py:design_in_motion",
    ),
}
"""Functions by what they find, those of this tree and those before."""


@dataclass(frozen=True)
class Counts:
    """What was counted of a part."""

    lines: int = 0
    statements: int = 0
    files: int = 0
    functions: int = 0
    imports: int = 0
    signatures: int = 0
    blanks: int = 0
    alone: int = 0
    """Private functions that their file names once outside their definition."""
    forks: int = 0
    asking: int = 0
    """Files with a fork."""

    def __add__(self, other: Counts) -> Counts:
        return Counts(
            *(getattr(self, each.name) + getattr(other, each.name) for each in fields(self))
        )


def main() -> None:
    """Count and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--beside", metavar="REV", help="commit to stand beside this tree")
    page(parser, _report)


def tree_here() -> Tree:
    """Read the package as it is in this tree."""
    paths = (path for path in sorted((ROOT / PACKAGE).rglob("*")) if path.suffix in (".py", *DATA))
    return {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in paths}


def tree_of(revision: str) -> Tree:
    """Read the package out of a commit."""
    archive = subprocess.run(
        ["git", "-C", str(ROOT), "archive", revision, PACKAGE], check=True, capture_output=True
    ).stdout
    found = {}
    with tarfile.open(fileobj=io.BytesIO(archive)) as members:
        for member in members:
            if member.name.endswith((".py", *DATA)) and (file := members.extractfile(member)):
                found[member.name] = file.read().decode("utf-8")
    return found


def part_of(path: str) -> str:
    """Folder of the package in which a file is; files beside the folders are one part."""
    inside = path.split("/")[1:]
    return inside[0] if len(inside) > 1 else "(top)"


def counted(tree: Tree) -> dict[str, Counts]:
    """Count the Python files of each part."""
    found: dict[str, Counts] = {}
    for path, text in sorted(tree.items()):
        if path.endswith(".py"):
            part = part_of(path)
            found[part] = found.get(part, Counts()) + counts_of(text)
    return found


def counts_of(text: str) -> Counts:
    """Count one file."""
    lines = text.splitlines()
    nodes = list(ast.walk(ast.parse(text)))
    functions = [node for node in nodes if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]
    imports = [node for node in nodes if isinstance(node, ast.Import | ast.ImportFrom)]
    named = Counter(
        node.id if isinstance(node, ast.Name) else node.attr
        for node in nodes
        if isinstance(node, ast.Name | ast.Attribute)
    )
    forks = sum(map(_is_fork, nodes))
    return Counts(
        lines=len(lines),
        statements=sum(map(_is_statement, nodes)),
        files=1,
        functions=len(functions),
        imports=sum((node.end_lineno or node.lineno) - node.lineno + 1 for node in imports),
        signatures=sum(max(1, node.body[0].lineno - node.lineno) for node in functions),
        blanks=sum(not line.strip() for line in lines),
        alone=sum(named[name] == 1 for name in map(_private, functions) if name),
        forks=forks,
        asking=forks > 0,
    )


def _is_statement(node: ast.AST) -> bool:
    is_text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return (
        isinstance(node, ast.stmt)
        and not isinstance(node, ast.Import | ast.ImportFrom)
        and not is_text
    )


def _is_fork(node: ast.AST) -> bool:
    """Whether a node asks which kind a mooring is."""
    if isinstance(node, ast.Attribute) and node.attr == ASKED:
        return True
    if isinstance(node, ast.Call) and _name(node.func) in {"isinstance", "issubclass"}:
        return any(_name(each) in KINDS for each in ast.walk(node.args[-1]))
    if isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.Is | ast.IsNot):
        return _name(node.left) in MAYBE and ast.unparse(node.comparators[0]) == "None"
    if isinstance(node, ast.If | ast.IfExp):
        return _name(node.test) in MAYBE
    return isinstance(node, ast.UnaryOp) and _name(node.operand) in MAYBE


def _name(node: ast.AST) -> str:
    return getattr(node, "attr", getattr(node, "id", ""))


def solvers(tree: Tree) -> dict[str, list[str]]:
    """List the solvers that a tree has, by what they find."""
    found = {}
    for concept, names in SOLVERS.items():
        there = (name.split(":") for name in names)
        found[concept] = [
            f"{path}:{name}"
            for path, name in there
            if f"def {name}(" in tree.get(f"{PACKAGE}/{path}", "")
        ]
    return found


def _private(function: ast.FunctionDef | ast.AsyncFunctionDef) -> str:
    name = function.name
    return name if name.startswith("_") and not name.startswith("__") else ""


HEAD = (
    *("part", "lines", "statements", "files", "functions", "imports %", "signatures %", "blanks %"),
    *("private functions named once", "forks", "files that ask"),
)


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# The house"
    yield ""
    here = tree_here()
    trees = [tree_of(of.beside), here] if of.beside else [here]
    yield f"Each cell: {of.beside} → this tree." if of.beside else "Lines of Python by part."
    yield ""
    every = [counted(tree) for tree in trees]
    yield f"| {' | '.join(HEAD)} |"
    yield "|---" * len(HEAD) + "|"
    for part in sorted(set().union(*every)):
        yield _row(part, [_cells(counts.get(part, Counts())) for counts in every])
    yield _row("all", [_cells(sum(counts.values(), Counts())) for counts in every])
    yield ""
    yield "| what is found | solvers | which |"
    yield "|---|---|---|"
    for concept in SOLVERS:
        there = [solvers(tree)[concept] for tree in trees]
        named = [", ".join(f"`{name}`" for name in each) for each in there]
        yield _row(
            concept, [[f"{len(each)}", name] for each, name in zip(there, named, strict=True)]
        )
    yield ""
    yield "| beside the code | files | lines |"
    yield "|---|---|---|"
    for ending in DATA:
        kept = [[text for path, text in tree.items() if path.endswith(ending)] for tree in trees]
        yield _row(
            f"*{ending}",
            [[f"{len(each):,}", f"{sum(text.count(chr(10)) for text in each):,}"] for each in kept],
        )


def _cells(of: Counts) -> list[str]:
    shares = (100 * part / (of.lines or 1) for part in (of.imports, of.signatures, of.blanks))
    counts = [f"{count:,}" for count in (of.lines, of.statements, of.files, of.functions)]
    last = (f"{count:,}" for count in (of.alone, of.forks, of.asking))
    return [*counts, *(f"{share:.1f}" for share in shares), *last]


def _row(name: str, sides: list[list[str]]) -> str:
    cells = (" → ".join(dict.fromkeys(cell)) for cell in zip(*sides, strict=True))
    return f"| {name} | {' | '.join(cells)} |"


if __name__ == "__main__":
    main()
