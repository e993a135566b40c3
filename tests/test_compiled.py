"""Kernel functions plain or compiled: which, when it is told, and what a damaged cache leads to."""

from __future__ import annotations

import errno
import gc
import operator
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import numpy as np
import pytest

from catopt.compiled import VARIABLE, compiled
from catopt.errors import InputError

KERNEL = '''
def twice(x):
    """Not compiled anywhere before."""
    return 2.0 * x


def four_times(x):
    """The same, by another kernel."""
    return 4.0 * x
'''
RUN = """
from catopt.compiled import compiled, when_cache_is_damaged, when_compiling
from kernel import four_times, twice

told, damaged = [], []
when_compiling(lambda: told.append("compiling"))
when_cache_is_damaged(damaged.append)
assert compiled(twice)(1.5) == 3.0
assert compiled(four_times)(1.5) == 6.0
print(len(told), len(damaged))
"""


def ran(folder: Path, script: str, **variables: str) -> str:
    """Run a script in a new process, in a folder with the kernel above and a cache."""
    (folder / "kernel.py").write_text(KERNEL)
    (folder / "run.py").write_text(script)
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(folder / "cache"), **variables}
    command = [sys.executable, "run.py"]
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def test_compiling_is_told_once_and_only_where_it_happens(tmp_path: Path) -> None:
    """Every process is new; the second finds what the first one kept."""
    assert [ran(tmp_path, RUN) for _ in range(2)] == ["1 0", "0 0"]


def twice(x: float) -> float:
    return 2.0 * x


def four_times(x: float) -> float:
    return 4.0 * x


class Fresh:
    """Compiles and runs as a new process with a cache of its own would, and counts what is told."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder = folder
        self._patch = monkeypatch
        monkeypatch.setattr("numba.config.CACHE_DIR", str(folder / "cache"))
        # numba reads its settings anew when it sees that another test has changed the environment.
        monkeypatch.setenv("NUMBA_CACHE_DIR", str(folder / "cache"))

    def told(self) -> tuple[int, int]:
        """How often it is said that something is compiled, and that the cache is damaged."""
        from catopt import machine_code

        compiling: list[str] = []
        damaged: list[str] = []
        self._patch.setattr(machine_code, "_dispatchers", {})
        machine_code.listen([lambda: compiling.append("")], [damaged.append])
        assert machine_code.dispatcher(twice)(1.5) == 3.0
        assert machine_code.dispatcher(four_times)(1.5) == 6.0
        return len(compiling), len(damaged)

    def entries(self) -> list[Path]:
        return sorted((self.folder / "cache").rglob("*.nbc"))


@pytest.fixture
def fresh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Fresh:
    return Fresh(tmp_path, monkeypatch)


def cut_short(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-100])


def one_bit_wrong(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)


def of_another_function(path: Path) -> None:
    (other,) = (each for each in path.parent.glob("*.nbc") if each != path)
    path.write_bytes(other.read_bytes())


def a_folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


DAMAGES: dict[str, Callable[[Path], object]] = {
    "empty": lambda path: path.write_bytes(b""),
    "truncated": cut_short,
    "bit": one_bit_wrong,
    "foreign": of_another_function,
    "text": lambda path: path.write_bytes(b"not ours at all"),
    "unreadable": a_folder,
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_entry_is_compiled_anew_and_mentioned_once(fresh: Fresh, damage: str) -> None:
    assert fresh.told() == (1, 0)
    (path,) = (each for each in fresh.entries() if "twice" in each.name)
    DAMAGES[damage](path)
    assert fresh.told() == (1, 1)
    if path.is_file():  # else there is something that no program should remove
        assert fresh.told() == (0, 0)


def test_without_a_folder_to_write_to_there_is_no_cache_and_an_answer(
    fresh: Fresh, monkeypatch: pytest.MonkeyPatch
) -> None:
    from numba.core.caching import CacheImpl, UserProvidedCacheLocator

    (fresh.folder / "cache").write_text("a file, where a folder would have to be")
    # Nor beside the source, where an earlier run may have left something.
    monkeypatch.setattr(CacheImpl, "_locator_classes", [UserProvidedCacheLocator])
    assert fresh.told() == (1, 0)
    assert fresh.entries() == []


def test_a_full_disk_is_no_error(fresh: Fresh, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    assert fresh.told() == (1, 0)
    assert fresh.entries() == []


FORM = """
import sys
from catopt.compiled import compiled
from kernel import twice

compiled(twice, float(sys.argv[1]) if len(sys.argv) > 1 else {work})(1.5)
print("numba" in sys.modules)
"""


@pytest.mark.parametrize(
    ("mode", "work", "loads_numba"),
    [
        ("auto", 0.1, "False"),
        ("auto", 100.0, "True"),
        ("", 0.1, "False"),
        ("never", 100.0, "False"),
        ("always", 0.1, "True"),
    ],
)
def test_small_work_is_plain(tmp_path: Path, mode: str, work: float, loads_numba: str) -> None:
    script = FORM.format(work=work)
    assert ran(tmp_path, script, **{VARIABLE: mode}) == loads_numba


MIDDLING = """
from catopt.compiled import compiled, when_compiling
from kernel import twice

told = []
when_compiling(lambda: told.append("compiling"))
function = compiled(twice, {work})
function(1.5)
print(len(told), hasattr(getattr(function, "__wrapped__", None), "overloads"))
"""


def test_work_that_is_not_worth_compiling_takes_what_is_kept(tmp_path: Path) -> None:
    """1.0025 s: to load machine code pays, to compile it takes 0.005 s more."""
    assert ran(tmp_path, MIDDLING.format(work=1.0025)) == "0 False"
    ran(tmp_path, MIDDLING.format(work=1e3))
    assert ran(tmp_path, MIDDLING.format(work=1.0025)) == "0 True"


MANY = """
import time
from catopt.compiled import compiled
from kernel import twice

def slow(x):
    began = time.thread_time()
    while time.thread_time() - began < 0.3:
        pass
    return x

import kernel
slow.__module__ = "kernel"
forms = []
for _ in range(8):
    function = compiled(slow, 0.3)
    forms.append(hasattr(function, "__wrapped__"))
    if not forms[-1]:
        function(1.0)
print("".join("c" if form else "p" for form in forms))
"""


def test_many_small_jobs_are_a_large_one(tmp_path: Path) -> None:
    """Plain until what was done and what is to do is more than loading and compiling take."""
    forms = ran(tmp_path, MANY)
    assert forms.startswith("ppp")
    assert forms.endswith("cc")


def test_an_unknown_mode_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "sometimes")
    with pytest.raises(
        InputError, match="found 'sometimes'; one of auto, always, never is required"
    ):
        compiled(twice)


INTERRUPTED = """
import os, signal, threading, time
from catopt.compiled import compiled, when_compiling

def sums(n):
    total = 0.0
    for k in range(n):
        total += k % 7
    return total

def press_twice():
    os.kill(os.getpid(), signal.SIGINT)
    os.kill(os.getpid(), signal.SIGINT)  # it must not end the process either

when_compiling(lambda: print("compiling", flush=True))
fast = compiled(sums)
try:
    fast(10)
    threading.Timer(0.2, press_twice).start()
    began = time.monotonic()
    while time.monotonic() - began < 20.0:
        for _ in range(10):
            fast(1_000_000)
except KeyboardInterrupt:
    print("stopped")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="a process cannot send itself Ctrl-C there")
def test_ctrl_c_in_compiled_code_comes_at_its_end(tmp_path: Path) -> None:
    assert ran(tmp_path, INTERRUPTED).split() == ["compiling", "stopped"]


WHILE_COMPILING = """
import os, signal
from catopt.compiled import compiled, when_compiling
from kernel import four_times, twice

def both(x):
    return twice(x) + four_times(x)

import kernel, sys
sys.modules["catopt.kernel"] = kernel  # where a kernel function's own functions are compiled, too
both.__module__ = twice.__module__ = four_times.__module__ = "catopt.kernel"
when_compiling(lambda: os.kill(os.getpid(), signal.SIGINT))
try:
    compiled(both)(1.5)
except KeyboardInterrupt:
    print("stopped")
signal.signal(signal.SIGINT, signal.default_int_handler)
print(compiled(both)(1.5))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="a process cannot send itself Ctrl-C there")
def test_ctrl_c_while_compiling_leaves_a_compiler_that_works(tmp_path: Path) -> None:
    assert ran(tmp_path, WHILE_COMPILING).split() == ["stopped", "9.0"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def made(values: np.ndarray) -> np.ndarray:
    """Own an array, and hand it on: its references are to be counted."""
    return values.copy()


def passed_on(values: np.ndarray, times: int) -> float:
    """Own nothing: what it is given lasts until it ends."""
    total = 0.0
    for _ in range(times):
        total += turned_over(values[::-1])
    return total


def turned_over(values: np.ndarray) -> float:
    return float(last_of(values) - values[-1])


def last_of(values: np.ndarray) -> float:
    copy = made(values)
    return float(copy[0])


for each in (made, last_of, turned_over):
    each.__module__ = "catopt.compiled"  # so that they are taken for kernel functions


def test_arrays_are_freed_once_whether_their_references_are_counted_or_not() -> None:
    """1e4 copies of 1e3 numbers pass through functions with and without counting."""
    from numba.core.runtime._nrt_python import memsys_enable_stats
    from numba.core.runtime.nrt import rtsys

    memsys_enable_stats()
    values = np.arange(1000.0)
    run = compiled(passed_on)
    run(values, 1)
    before = rtsys.get_allocation_stats()  # type: ignore[no-untyped-call]
    assert run(values, 10_000) == 10_000 * 999.0
    after = rtsys.get_allocation_stats()  # type: ignore[no-untyped-call]
    assert after.alloc - before.alloc >= 10_000
    assert after.alloc - before.alloc == after.free - before.free
    assert values.tolist() == list(map(float, range(1000)))


def test_a_line_is_solved_without_counting_references() -> None:
    """Locked additions took two thirds of the time of a line of a few pieces."""
    from catopt.catenary.equilibrium import given_force
    from catopt.catenary.pieces import LineProblem, Pieces
    from catopt.machine_code import _inner

    pieces = Pieces(*(np.array(each) for each in ([600.0], [1e3], [1e-9], [0.0, 0.0, -1.0, -1.0])))
    inner = _inner(given_force)
    signature = tuple(map(numba.typeof, (1e5, LineProblem(pieces, 0.0, 200.0, 0.0))))
    inner.compile(signature)
    code = inner.inspect_llvm(signature)  # another test may have compiled it for other arrays
    assert "call void @NRT_incref" not in code


def sum_of_five(x: float) -> float:
    return x + 1.0 + x + 2.0 + x


def test_numba_is_asked_once_what_a_sum_is_and_is_then_as_it_was(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Four sums of numbers, whose types are found once and used again where code is written."""
    from numba.core import types

    plainly, asked = types.functions.BaseFunction.get_call_type, []

    def counted(self: Any, *arguments: Any) -> Any:
        asked.append(self.typing_key)
        return plainly(self, *arguments)

    monkeypatch.setattr(types.functions.BaseFunction, "get_call_type", counted)
    looks = gc.get_threshold()
    assert compiled(sum_of_five)(1.5) == 7.5
    assert asked.count(operator.add) <= 1
    assert "get_call_type" not in vars(types.Function)
    assert gc.get_threshold() == looks
