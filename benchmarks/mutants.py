"""How many faults, planted one at a time, the quick tests of a part notice.

    python -m benchmarks.mutants [PART ...] [--count 25] [--seed 1] [--only 3 7] [--out FILE]

A fault is one comparison, operator, number, constant or condition changed in a file of
``catopt/PART``, at random, outside decorators, docstrings and messages. The tests are the quick
ones of ``tests/PART`` by themselves, in plain Python, of a fault those that call its function and
take at most `LONG`: each fault gets a process that is forked when all is imported. Tests that start
another process do not see it. A survivor is either a fault that no test notices or a change that
makes no difference: read it.
"""

from __future__ import annotations

import argparse
import ast
import gc
import json
import os
import random
import resource
import signal
import sys
import tempfile
import types
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from benchmarks.common import stamp

ROOT = Path(__file__).parents[1]
PARTS = ("catenary", "mooring", "fem", "floater", "hydro", "loads", "checks")
"""Those with the physics, taken when none is named."""

BESIDE = {"hydro": ("tests/floater",)}
"""Tests of a part that stand elsewhere: the kernels of a hull are run with a body afloat."""

LONG = 2.0
"""Processor time of a test in plain Python beyond which it is left out, s."""
HANGS = 300.0
"""Processor time of all tests of a fault after which it counts as one that hangs: noticed, s."""

_COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
_COMPUTED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
}  # fmt: skip


class Fault(NamedTuple):
    """A fault: its file, its line, what stood there, what stands there now, and the whole text."""

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


class Score(NamedTuple):
    """What came of a part.

    `possible`: faults that can be planted; `planted`: that were; `survivors`: that no test noticed;
    `tests`, `left_out`: quick tests, and how many of them take too long.
    """

    part: str
    possible: int
    planted: int
    survivors: list[tuple[int, Fault]]
    tests: int
    left_out: int


def main() -> None:
    """Plant faults in parts, print which of them no test notices, and write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--count", type=int, default=25, help="faults of each part")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, nargs="+", help="of the sample, by number from 1")
    parser.add_argument("--out", type=Path, help="file to write the page to, too")
    of = parser.parse_args()
    os.environ["CATOPT_COMPILE"] = "never"
    sys.dont_write_bytecode = True
    scores: list[Score] = []
    for part in of.parts or PARTS:
        with tempfile.TemporaryDirectory() as folder:
            to = Path(folder) / "score"
            if _in_a_child(partial(_score, part, of, to), 1e6):
                sys.exit(f"the tests of {part} were not run")
            found = json.loads(to.read_text("utf-8"))
        possible, planted, tests, left_out, kept = found
        survivors = [
            (number, Fault(Path(file), line, before, after, ""))
            for number, (file, line, before, after) in kept
        ]
        scores.append(Score(part, possible, planted, survivors, tests, left_out))
    text = "\n".join(_page(scores, of.seed)) + "\n"
    print(text)
    if of.out is not None:
        of.out.write_text(text, encoding="utf-8")


def _page(scores: Sequence[Score], seed: int) -> Iterator[str]:
    yield "# Faults that the quick tests of a part notice"
    yield ""
    yield stamp()
    yield ""
    yield (
        f"Faults are planted one at a time, drawn at random with the seed {seed}. Tests are those "
        "of the part's own folder (of hydro also those of floater) that take at most "
        f"{LONG:g} s of processor time in plain Python."
    )
    yield ""
    yield "| part | can be planted | planted | noticed | % | tests | left out |"
    yield "|---|---|---|---|---|---|---|"
    for of in scores:
        noticed = of.planted - len(of.survivors)
        yield f"| {of.part} | {of.possible:,} | {of.planted} | {noticed} | " + (
            f"{100.0 * noticed / of.planted:.0f} | {of.tests} | {of.left_out} |"
        )
    yield ""
    yield "| survivor | where | was | is |"
    yield "|---|---|---|---|"
    for of in scores:
        for number, fault in of.survivors:
            was, now = (" ".join(each.split()) for each in (fault.before, fault.after))
            place = f"{fault.file.parent.name}/{fault.file.name}:{fault.line}"
            yield f"| {of.part} {number} | {place} | `{was}` | `{now}` |"


def _in_a_child(do: Callable[[], int], longest: float) -> int:
    """Do something in a process of its own; 0 if it returns 0 within its processor time, s."""
    child = os.fork()
    if child:
        return os.waitpid(child, 0)[1]
    code = 1
    try:
        resource.setrlimit(resource.RLIMIT_CPU, (int(longest), int(longest)))
        code = do()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def _score(part: str, of: argparse.Namespace, to: Path) -> int:
    """Collect the tests of a part, and plant the faults; write what came of it."""
    planter = _Planter(part, of, to)
    words = ["-q", "-n", "0", "-p", "no:cacheprovider", "-m", "not slow"]
    words += [f"tests/{part}", *BESIDE.get(part, ())]
    return int(pytest.main(words, plugins=[planter]))


class _Planter:
    """Has faults planted where pytest would run its tests."""

    def __init__(self, part: str, of: argparse.Namespace, to: Path) -> None:
        self.part, self.of, self.to = part, of, to
        self.functions: list[types.FunctionType] = []

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Look which test calls what; then plant one fault after the other."""
        session.config.option.maxfail = 1
        functions = [e for e in gc.get_objects() if isinstance(e, types.FunctionType)]
        self.functions = [e for e in functions if e.__code__.co_filename.startswith(str(ROOT))]
        gc.freeze()
        notes = self.to.with_suffix(".calls")
        if _in_a_child(lambda: _look(session.items, notes), 3600.0):
            raise RuntimeError("tests fail without any fault")
        long, calls = json.loads(notes.read_text("utf-8"))
        files = sorted((ROOT / "catopt" / self.part).glob("*.py"))
        every = [fault for file in files for fault in faults(file)]
        chosen = random.Random(self.of.seed).sample(every, min(self.of.count, len(every)))
        numbered = [(k, fault) for k, fault in enumerate(chosen, 1) if k in (self.of.only or [k])]
        survivors = []
        for number, fault in numbered:
            where = _function(fault)
            called = calls.get(where, ()) if where else range(len(session.items))
            items = [session.items[k] for k in called if k not in long]
            if not _in_a_child(partial(self._noticed, session, fault, items), HANGS):
                survivors.append((number, fault))
                place = f"{fault.file.name}:{fault.line} ({len(items)} tests)"
                print(f"\n{number}: {place}: {fault.before} -> {fault.after}", flush=True)
            print(f"{self.part} {number} of {len(chosen)}, {len(survivors)}", file=sys.stderr)
        kept = [(k, (str(f.file), *f[1:4])) for k, f in survivors]
        counts = (len(every), len(numbered), len(session.items), len(long))
        self.to.write_text(json.dumps([*counts, kept]), "utf-8")
        return True

    def _noticed(self, session: pytest.Session, fault: Fault, items: Sequence[pytest.Item]) -> int:
        """Plant a fault in this process and run tests until one fails; 1 if one does."""
        _quiet()
        _plant(fault, self.functions)
        for number in range(len(items)):
            _run(items, [number])
            if session.testsfailed:
                return 1
        return 0


def _look(items: Sequence[pytest.Item], to: Path) -> int:
    """Write which tests take too long, and of each function of catopt which tests call it."""
    calls: dict[str, list[int]] = {}
    long: list[int] = []
    package = str(ROOT / "catopt")
    known: dict[types.CodeType, str] = {}
    _quiet()
    for number in range(len(items)):
        seen: set[types.CodeType] = set()

        def note(frame: types.FrameType, event: str, _: object, add: Any = seen.add) -> None:
            if event == "call":
                add(frame.f_code)

        def ring(*_: object, number: int = number) -> None:
            long.append(number)
            raise pytest.fail.Exception("too long")

        signal.signal(signal.SIGPROF, ring)
        signal.setitimer(signal.ITIMER_PROF, 2.0 * LONG)  # being looked at takes as long again
        sys.setprofile(note)
        try:
            _run(items, [number])
        finally:
            sys.setprofile(None)
            signal.setitimer(signal.ITIMER_PROF, 0.0)
        for code in seen:
            if code.co_filename.startswith(package):
                name = known.setdefault(code, _name_of(code))
                calls.setdefault(name, []).append(number)
    to.write_text(json.dumps([long, calls]), "utf-8")
    return 0


def _run(items: Sequence[pytest.Item], numbers: Iterable[int]) -> None:
    for number in numbers:
        item = items[number]
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=None)


def _quiet() -> None:
    void = os.open(os.devnull, os.O_WRONLY)
    os.dup2(void, 1)
    os.dup2(void, 2)


# ------------------------------------------------------------------ functions with another code


def _name_of(code: types.CodeType) -> str:
    return f"{code.co_filename}:{code.co_qualname}:{code.co_firstlineno}"


def _codes(code: types.CodeType) -> Iterator[types.CodeType]:
    """Yield a code and all that stand in it."""
    yield code
    for each in code.co_consts:
        if isinstance(each, types.CodeType):
            yield from _codes(each)


def _pairs(fault: Fault) -> list[tuple[types.CodeType, types.CodeType]]:
    """Codes of a file without a fault and with it, those that differ, from within outwards."""
    name = str(fault.file)
    both = (
        [*_codes(compile(text, name, "exec"))]
        for text in (fault.file.read_text("utf-8"), fault.text)
    )
    differ = [(a, b) for a, b in zip(*both, strict=True) if a != b]
    return differ[::-1]


def _function(fault: Fault) -> str:
    """Name of the innermost function that a fault stands in; empty for a module or a class."""
    inner, _ = _pairs(fault)[0]
    is_function = bool(inner.co_flags & 0x2)  # CO_NEWLOCALS
    if is_function and inner.co_name.startswith("<"):  # a comprehension: what it stands in
        for outer, _ in _pairs(fault)[1:]:
            if not outer.co_name.startswith("<"):
                inner = outer
                break
        is_function = inner.co_name != "<module>" and bool(inner.co_flags & 0x2)
    return _name_of(inner) if is_function and inner.co_flags & 0x1 else ""


def _plant(fault: Fault, functions: Iterable[types.FunctionType]) -> None:
    """Give functions that exist the code with the fault; of a module or a class, its values."""
    by_name = {_name_of(old): new for old, new in _pairs(fault) if old.co_flags & 0x1}
    for function in functions:
        new = by_name.get(_name_of(function.__code__))
        if new is not None:
            function.__code__ = new
    if not _function(fault):
        _set_values(fault)


def _set_values(fault: Fault) -> None:
    """Make a module once more, and put its values wherever the old ones stand."""
    name = ".".join(fault.file.relative_to(ROOT).with_suffix("").parts)
    old = sys.modules[name]
    new = types.ModuleType(name)
    new.__file__ = old.__file__
    sys.modules[name] = new
    exec(compile(fault.text, str(fault.file), "exec"), new.__dict__)
    sys.modules[name] = old
    for module in [m for n, m in sys.modules.items() if n.split(".")[0] in ("catopt", "tests")]:
        for key, value in list(vars(module).items()):
            if key in vars(new) and value is vars(old).get(key):
                _put_value(module, key, value, vars(new)[key])


def _put_value(owner: Any, key: str, old: Any, new: Any) -> None:
    if isinstance(old, type) and isinstance(new, type):
        for name, value in list(vars(new).items()):
            if name in vars(old) and not name.startswith("__weakref") and name != "__dict__":
                _put_value(old, name, vars(old)[name], value)
    elif isinstance(old, types.FunctionType) and isinstance(new, types.FunctionType):
        old.__defaults__, old.__kwdefaults__ = new.__defaults__, new.__kwdefaults__
    elif not callable(old) and not isinstance(old, types.ModuleType) and key[:2] != "__":
        setattr(owner, key, new)


if __name__ == "__main__":
    main()
