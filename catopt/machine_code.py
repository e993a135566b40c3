"""Machine code of kernel functions: numba's compiler, and what of its work is kept on disk.

The cache is a convenience. An entry that cannot be read, is damaged or belongs to something else
is dropped and compiled anew; where nothing can be written, nothing is kept.
"""

from __future__ import annotations

import gc
import hashlib
import os
import pickle
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from glob import escape
from pathlib import Path
from types import FunctionType
from typing import Any

import numba
from numba.core import event, ir, types
from numba.core.caching import FunctionCache
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler
from numba.core.compiler_lock import global_compiler_lock
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.registry import CPUDispatcher
from numba.core.serialize import dumps
from numba.core.typed_passes import NopythonRewrites

from catopt.interrupt import asked_to_stop, uninterrupted
from catopt.machine_tuples import Packed, pack

_PACKAGE = __name__.partition(".")[0] + "."
_A_BYTE = 2.5e-4
"""Time that a byte of bytecode takes to compile, s: 2e-4 of steps in time, 3e-4 at rest."""
_SIZE = hashlib.sha256().digest_size
_FORM = 2
"""Counts up when the same source gives other machine code, so that none of before is taken."""

_dispatchers: dict[Callable[..., Any], Any] = {}
"""The compiled functions that Python calls."""
_tell: dict[str, list[Any]] = {"compiling": [], "damaged": []}


def cost(function: Any) -> float:
    """Seconds of processor time that it takes to compile a function and those it calls, about."""
    return _A_BYTE * sum(len(each.__code__.co_code) for each in _reached(function))


def is_kept(function: Callable[..., Any]) -> bool:
    """Whether machine code of a function that this machine may run lies on disk."""
    kept = _dispatcher(function)._cache
    return isinstance(kept, _Cache) and any(kept._cache_file.all())


def dispatcher(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compiled form of a kernel function, to be called from Python; Ctrl-C waits meanwhile."""
    with global_compiler_lock:
        call: Callable[..., Any] = uninterrupted(_dispatcher(function))
    return call


def listen(compiling: list[Callable[[], None]], damaged: list[Callable[[str], None]]) -> None:
    """Take over what is to be called, once, when something is compiled or found damaged."""
    _tell["compiling"], _tell["damaged"] = compiling, damaged
    _listen()


@cache
def _listen() -> None:
    """Hear of compilations: between two functions is a place where Ctrl-C does no harm."""

    class Listener(event.Listener):
        def on_start(self, event: object) -> None:  # noqa: ARG002 - as numba calls it
            if asked_to_stop():
                raise KeyboardInterrupt
            while _tell["compiling"]:
                _tell["compiling"].pop()()

        def on_end(self, event: object) -> None:
            """Nothing is said at the end."""

    event.register("numba:compile", Listener())  # type: ignore[no-untyped-call]


def _dispatcher(function: Callable[..., Any]) -> Any:
    """Compile on call, and keep the machine code."""
    if function not in _dispatchers:
        for each in _tuples({reached.__module__ for reached in _reached(function)}):
            if hasattr(each, "is_packed"):
                pack(each)
        made = _compiling_into(JITCodeLibrary, numba.njit(_twin(function), **_options(function)))
        with suppress(RuntimeError, OSError):  # no folder to keep the machine code in
            made._cache = _Cache(made.py_func)
        _dispatchers[function] = made
    return _dispatchers[function]


@cache
def _inner(function: Callable[..., Any]) -> Any:
    """Compile for compiled callers alone, without what Python would need to call it."""
    if function in _dispatchers:
        return _dispatchers[function]
    options = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "pipeline_class": _Borrowing}
    return _compiling_into(_Part, numba.njit(_twin(function), **_options(function) | options))


class _Part(JITCodeLibrary):
    """Code of a function that is linked into its callers and nothing else.

    What optimises a caller optimises it, too, and its machine code is the caller's. numba does both
    for every function with all that it calls, of the innermost ones eight times.
    """

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()  # type: ignore[no-untyped-call]
        self._finalized = True


class _Borrowing(Compiler):
    """Compiler of inner functions, of which those that only read and write count no references.

    Of each array that passes through a function numba counts up and down who holds it, by locked
    additions: of a line of a few pieces two thirds of the time. What a function was given lasts
    until it ends.
    """

    def define_pipelines(self) -> Any:
        pipelines = super().define_pipelines()  # type: ignore[no-untyped-call]
        for each in pipelines:
            each.add_pass_after(_LeaveUncounted, NopythonRewrites)
            each.finalize()
        return pipelines


@register_pass(mutates_CFG=False, analysis_only=False)  # type: ignore[no-untyped-call]
class _LeaveUncounted(FunctionPass):
    """Do without counting in a function that makes nothing, and is handed nothing, that is counted.

    Whatever it is not sure of is counted as before.
    """

    _name = "catopt_leave_uncounted"

    def __init__(self) -> None:
        super().__init__()  # type: ignore[no-untyped-call]

    def run_pass(self, state: Any) -> bool:
        kinds = state.typemap
        if _is_counted(state.return_type) or not all(map(_is_known, kinds.values())):
            return False
        for block in state.func_ir.blocks.values():
            for assign in block.find_insts(ir.Assign):
                if _is_counted(kinds[assign.target.name]) and _may_own(assign.value, kinds):
                    return False
        state.targetctx = state.targetctx.subtarget(enable_nrt=False)
        return True


_PLAIN = (types.Number, types.Boolean, types.NoneType, types.Omitted, types.StringLiteral)
_NAMES = (types.Callable, types.Module, types.RangeType, types.RangeIteratorType)


_HANDING_ON = ("build_tuple", "cast", "exhaust_iter", "getattr", "phi", "static_getitem")
"""Operations that give what is there, or a part of it."""


def _fields(kind: Any) -> tuple[Any, ...]:
    """Types of the values of a tuple."""
    return tuple(kind)


def _is_counted(kind: Any) -> bool:
    """Whether a value of a type is or holds an array."""
    if isinstance(kind, types.BaseTuple):
        return any(map(_is_counted, _fields(kind)))
    return isinstance(kind, types.Array)


def _is_known(kind: Any) -> bool:
    """Whether a type holds nothing that is counted but arrays."""
    if isinstance(kind, types.BaseTuple):
        return all(map(_is_known, _fields(kind)))
    if isinstance(kind, types.Pair):
        return _is_known(kind.first_type) and _is_known(kind.second_type)
    if isinstance(kind, types.UniTupleIter):
        return _is_known(kind.container)
    return isinstance(kind, (types.Array, Packed, *_PLAIN, *_NAMES))


def _may_own(value: Any, kinds: dict[str, Any]) -> bool:
    """Whether an expression with arrays in it may be more than those given, or parts of them."""
    if not isinstance(value, ir.Expr):
        return not isinstance(value, (ir.Arg, ir.Var))
    if value.op == "call":
        return not isinstance(kinds[value.func.name], types.NamedTupleClass)
    if value.op == "getitem":
        return _is_counted(kinds[value.index.name])
    return value.op not in _HANDING_ON


def _compiling_into(library: Any, made: Any) -> Any:
    """Have a function compile into a kind of library; there is no address to give to a part's."""
    compile_plainly = made.compile

    def compile_so(signature: Any) -> Any:
        codegen = CPUDispatcher.targetdescr.target_context.codegen()
        # One thread at a time, from here on: what another compiles would go into the wrong kind.
        with global_compiler_lock:
            before = dict(vars(codegen))
            codegen._library_class = library
            if library is _Part:
                codegen.set_env = lambda *_: None
            else:
                vars(codegen).pop("set_env", None)
            try:
                with _remembering():
                    return compile_plainly(signature)
            finally:
                for key in ("_library_class", "set_env"):
                    vars(codegen).pop(key, None)
                    if key in before:
                        setattr(codegen, key, before[key])

    made.compile = compile_so
    return made


_GARBAGE = 100_000
"""Objects between two looks for those that nothing holds, while numba makes millions that last."""
_KNOWN_TYPES = (types.Number, types.Boolean, types.Array, types.BaseTuple)
_results: dict[Any, Any] = {}
"""What an operation of numba's own gives on types, as numba found it."""


@contextmanager
def _remembering() -> Iterator[None]:
    """Have numba ask once what an operation gives on some types, and not at every place.

    For each + it tries some thirty ways, those of strings, dates and arrays before that of numbers,
    when it finds the types and again when it writes the code: a quarter of all time.
    """
    plainly = types.Function.get_call_type

    def recall(self: Any, context: Any, args: Any, kws: Any) -> Any:
        if kws or not all(isinstance(each, _KNOWN_TYPES) for each in args):
            return plainly(self, context, args, kws)
        key = self, context, tuple(args)
        if key not in _results:
            _results[key] = plainly(self, context, args, kws)
        return _results[key]

    if plainly.__name__ == recall.__name__:  # a function that another one calls
        yield
        return
    types.Function.get_call_type = recall  # type: ignore[method-assign]
    looks = gc.get_threshold()
    gc.set_threshold(max(looks[0], _GARBAGE) if looks[0] else 0, *looks[1:])
    try:
        yield
    finally:
        del types.Function.get_call_type
        gc.set_threshold(*looks)


def _options(function: Callable[..., Any]) -> dict[str, Any]:
    inline = hasattr(function, "is_inlined")
    return {"error_model": "numpy", "nogil": True, "forceinline": inline}


class _Cache(FunctionCache):
    """Machine code of one function on disk, of which nothing is needed."""

    def __init__(self, function: FunctionType) -> None:
        super().__init__(function)  # type: ignore[no-untyped-call]
        codegen = CPUDispatcher.targetdescr.target_context.codegen()
        machine = _digest_of((numba.__version__, codegen.magic_tuple(), _FORM))
        name = f"{self._impl.filename_base}.{machine}"
        self._cache_file: Any = _Files(Path(self._cache_path), name)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Read an entry; None where there is none, or none of any use."""
        try:
            return super().load_overload(sig, target_context)  # type: ignore[no-untyped-call]
        except Exception:  # whatever a damaged file may lead to
            self._drop()
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep an entry, if that is possible."""
        with suppress(OSError):
            super().save_overload(sig, data)  # type: ignore[no-untyped-call]

    def _drop(self) -> None:
        """Remove what is kept of the function, and say so once."""
        for path in self._cache_file.all():
            with suppress(OSError):
                path.unlink()
        while _tell["damaged"]:
            _tell["damaged"].pop()(str(self._cache_file.folder))


class _Files:
    """Entries of a cache, a file each, with a digest: damaged machine code would crash."""

    def __init__(self, folder: Path, name: str) -> None:
        self.folder = folder
        self._name = name

    def all(self) -> Iterator[Path]:
        """All entries."""
        return self.folder.glob(f"{escape(self._name)}.*.nbc")

    def load(self, key: Any) -> Any:
        """Read an entry; None where there is none."""
        try:
            content = self._path(key).read_bytes()
        except FileNotFoundError:
            return None
        digest, data = content[:_SIZE], content[_SIZE:]
        if hashlib.sha256(data).digest() != digest:
            raise ValueError("damaged")
        name, of_key, entry = pickle.loads(data)
        if (name, of_key) != (self._name, key):
            raise ValueError("of something else")
        return entry

    def save(self, key: Any, entry: Any) -> None:
        """Write an entry, whole or not at all."""
        data = dumps((self._name, key, entry))  # type: ignore[no-untyped-call]
        path = self._path(key)
        new = path.with_suffix(f".{os.getpid()}.new")
        try:
            new.write_bytes(hashlib.sha256(data).digest() + data)
            new.replace(path)
        except OSError:
            new.unlink(missing_ok=True)
            raise

    def _path(self, key: Any) -> Path:
        return self.folder / f"{self._name}.{_digest_of(key)}.nbc"


def _digest_of(value: object) -> str:
    return hashlib.sha256(repr(value).encode()).hexdigest()[:12]


def _twin(function: Callable[..., Any]) -> FunctionType:
    """Copy of a function whose globals hold compiled functions where it names kernel functions."""
    assert isinstance(function, FunctionType)
    names = {
        name: _inner(value) if _is_kernel(value) else value
        for name, value in _named(function).items()
    }
    module = {"__name__": function.__module__, "__builtins__": __builtins__, **names}
    twin = FunctionType(
        function.__code__, module, function.__name__, function.__defaults__, function.__closure__
    )
    twin.__qualname__ = f"{function.__qualname__}_{_digest(function)}"
    twin.__module__ = function.__module__
    return twin


def _named(function: FunctionType) -> dict[str, Any]:
    """Globals of its module that a function names."""
    names = function.__code__.co_names
    return {name: function.__globals__[name] for name in names if name in function.__globals__}


def _is_kernel(value: object) -> bool:
    return isinstance(value, FunctionType) and value.__module__.startswith(_PACKAGE)


def _digest(function: FunctionType) -> str:
    """Digest of the source files of a function, of what it reaches and of the tuples it handles."""
    reached = _reached(function)
    sources = {each.__code__.co_filename for each in reached}
    sources |= _tuple_sources({each.__module__ for each in reached})
    total = hashlib.sha256()
    for source in sorted(sources):
        total.update(Path(source).read_bytes())
    return total.hexdigest()[:12]


def _tuple_sources(modules: set[str]) -> set[str]:
    """Source files of the named tuples that modules know, and of those that these hold in turn.

    Machine code is kept under the layout of its tuples, which is none of the functions' sources.
    """
    return {str(sys.modules[each.__module__].__file__) for each in _tuples(modules)}


def _tuples(modules: set[str]) -> Iterator[type]:
    """Yield the named tuples of the package that modules know, and that those modules know."""
    waiting = set(modules)
    known: set[str] = set()
    while waiting:
        module = sys.modules[waiting.pop()]
        known.add(module.__name__)
        for value in vars(module).values():
            if not isinstance(value, type) or not issubclass(value, tuple):
                continue
            if value.__module__.startswith(_PACKAGE):
                yield value
                waiting |= {value.__module__} - known


@cache
def _reached(function: FunctionType) -> list[FunctionType]:
    """List a function and every kernel function that it calls, over any number of steps."""
    known: dict[FunctionType, None] = {}
    waiting = [function]
    while waiting:
        each = waiting.pop()
        if each not in known:
            known[each] = None
            waiting += [value for value in _named(each).values() if _is_kernel(value)]
    return list(known)
