"""How many faults, planted one at a time, the tests of a part notice.

    python -m benchmarks.mutants checks [--count 30] [--seed 1]

A fault is one comparison, operator, number, constant or condition changed in a file of
``catopt/PART``, at random, outside decorators, docstrings and messages; the tests are those of
``tests/PART``, the quick ones with those named beside it below and then the longer ones, stopped
at the first failure. It works on a copy of the checkout. A survivor is either a fault
that no test notices or a change that makes no difference: read it.
"""

from __future__ import annotations

import argparse
import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
_COMMANDS = ("tests/cli/test_transcripts.py", "tests/cli/test_every_command.py")
BESIDE = {
    "checks": _COMMANDS,
    "sizing": ("tests/cli/test_size.py", *_COMMANDS),
    "loads": ("tests/cli/test_loads.py", *_COMMANDS),
    "design": ("tests/cli/test_design.py", *_COMMANDS),
    "mooring": ("tests/cli/test_json.py", *_COMMANDS),
    "study": ("tests/cli/test_study.py", *_COMMANDS),
}
"""Tests of a part that stand elsewhere."""

SLOWEST = 5.0
"""Times as long as without a fault, after which a run counts as one that hangs: noticed."""

_COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
_COMPUTED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
}  # fmt: skip


class Fault(NamedTuple):
    """A fault: its file, its line, what stood there and what stands there now."""

    file: Path
    line: int
    before: str
    after: str
    text: str


def faults(file: Path) -> Iterator[Fault]:
    """Yield every fault that can be planted in a file."""
    source = file.read_text("utf-8")
    tree = ast.parse(source)
    decorators = {
        id(inner)
        for node in ast.walk(tree)
        for decorator in getattr(node, "decorator_list", ())
        for inner in ast.walk(decorator)
    }
    for node in (each for each in ast.walk(tree) if id(each) not in decorators):
        for after in _changed(node):
            before = ast.get_source_segment(source, node)
            if before is not None and isinstance(node, ast.expr):
                text = _put(source, node, ast.unparse(after))
                yield Fault(file, node.lineno, before, ast.unparse(after), text)


def _changed(node: ast.AST) -> Iterator[ast.expr]:
    """Yield what may stand in the place of a node."""
    if isinstance(node, ast.Compare) and type(node.ops[0]) in _COMPARED:
        other = _COMPARED[type(node.ops[0])]()
        yield ast.Compare(node.left, [other, *node.ops[1:]], node.comparators)
    elif isinstance(node, ast.BinOp) and type(node.op) in _COMPUTED and not _is_words(node):
        yield _in_brackets(ast.BinOp(node.left, _COMPUTED[type(node.op)](), node.right))
    elif isinstance(node, ast.BoolOp):
        other_op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield _in_brackets(ast.BoolOp(other_op, node.values))
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield ast.Constant(not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        yield ast.Constant(
            node.value + 1 if isinstance(node.value, int) else 1.1 * node.value + 0.1
        )
    elif isinstance(node, ast.Call) and _name(node) in ("max", "min"):
        other_name = "min" if _name(node) == "max" else "max"
        yield ast.Call(ast.Name(other_name), node.args, node.keywords)


def _in_brackets(node: ast.expr) -> ast.expr:
    """Keep an expression together wherever it is put."""
    return ast.parse(f"({ast.unparse(node)})", mode="eval").body


def _is_words(node: ast.BinOp) -> bool:
    """Whether texts or types are put together, not numbers."""
    parts = (node.left, node.right)
    return any(
        isinstance(part, ast.JoinedStr | ast.List | ast.Tuple)
        or (isinstance(part, ast.Constant) and isinstance(part.value, str))
        for part in parts
    )


def _name(node: ast.Call) -> str:
    return node.func.id if isinstance(node.func, ast.Name) else ""


def _put(source: str, node: ast.expr, after: str) -> str:
    """Write a source with another text in the place of a node."""
    lines = source.encode().split(b"\n")
    first, last = node.lineno - 1, (node.end_lineno or node.lineno) - 1
    head, tail = lines[first][: node.col_offset], lines[last][node.end_col_offset :]
    put = head + f"({after})".encode() + tail
    return b"\n".join([*lines[:first], put, *lines[last + 1 :]]).decode()


def main() -> None:
    """Plant faults in a part and print which of them no test notices."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("part", choices=sorted(BESIDE))
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "copy"
        ignored = shutil.ignore_patterns(".git", "__pycache__", ".*_cache", "site", ".venv")
        shutil.copytree(ROOT, copy, ignore=ignored)
        _report(copy, arguments.part, arguments.count, arguments.seed)


def _report(copy: Path, part: str, count: int, seed: int) -> None:
    began = time.monotonic()
    if not _passes(copy, part, 3600.0):
        raise SystemExit(f"the tests of {part} fail without any fault")
    alone = time.monotonic() - began
    files = sorted((copy / "catopt" / part).glob("*.py"))
    every = [fault for file in files for fault in faults(file)]
    chosen = random.Random(seed).sample(every, min(count, len(every)))
    survivors = []
    for number, fault in enumerate(chosen, start=1):
        whole = fault.file.read_text("utf-8")
        fault.file.write_text(fault.text, "utf-8")
        if _passes(copy, part, SLOWEST * alone + 60.0):
            survivors.append(fault)
            place = fault.file.relative_to(copy)
            print(f"survives: {place}:{fault.line}: {fault.before} -> {fault.after}", flush=True)
        fault.file.write_text(whole, "utf-8")
        print(f"{number} of {len(chosen)}, {len(survivors)} survive", file=sys.stderr, flush=True)
    noticed = len(chosen) - len(survivors)
    print(f"{part}: {noticed} of {len(chosen)} noticed, of {len(every):,} that can be planted")


def _passes(copy: Path, part: str, longest: float) -> bool:
    """Whether the tests of a part pass: the quick ones, with those beside it, and the longer."""
    own = f"tests/{part}"
    quick = _pass(copy, [own, *BESIDE[part]], "not slow", longest)
    return quick and _pass(copy, [own], "slow", longest)


def _pass(copy: Path, tests: list[str], mark: str, longest: float) -> bool:
    words = [sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "-m", mark]
    words += ["-p", "no:cacheprovider"]
    environment = {**os.environ, "PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        ran = subprocess.run(
            [*words, *tests],
            cwd=copy,
            env=environment,
            capture_output=True,
            timeout=longest,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return False
    return ran.returncode == 0


if __name__ == "__main__":
    main()
