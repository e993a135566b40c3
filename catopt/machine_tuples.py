# mypy: disable-error-code="no-untyped-call,import-untyped,override"
"""Named tuples of many arrays as compiled functions pass them on: by their address.

numba passes a named tuple to a function as all numbers of all its arrays, and counts references to
every one of them, through some seventy functions. A tuple marked `packed` is written to memory
once, where Python calls, and handed on as an address. Its arrays live as long as the call, so that
nothing is counted. A packed tuple is read, never made, returned or unpacked by a compiled function.
"""

from __future__ import annotations

import hashlib
from functools import cache
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.datamodel import models
from numba.core.extending import NativeValue, register_model, typeof_impl, unbox
from numba.core.imputils import lower_getattr_generic
from numba.core.typing.templates import AttributeTemplate, infer_getattr
from numba.np.arrayobj import make_array


class Packed(types.Type):
    """A named tuple by its address; its fields with their types."""

    def __init__(self, of: str, fields: tuple[tuple[str, Any], ...]) -> None:
        self.of = of
        self.fields = fields
        digest = hashlib.sha256(repr(fields).encode()).hexdigest()[:12]
        super().__init__(name=f"{of}_{digest}")


@register_model(Packed)
class PackedModel(models.OpaqueModel):
    """An address."""


@cache
def pack(of: type[Any]) -> None:
    """Have compiled functions take a class of named tuples by address."""

    @typeof_impl.register(of)
    def _(value: Any, context: Any) -> Packed:
        kinds = [typeof_impl(each, context) for each in value]
        return Packed(of.__name__, tuple(zip(of._fields, kinds, strict=True)))


@infer_getattr
class PackedAttribute(AttributeTemplate):
    """A field by its name."""

    key = Packed

    def generic_resolve(self, packed: Packed, name: str) -> Any:
        """Return the type of a field."""
        return dict(packed.fields).get(name)


def _layout(context: Any, packed: Packed) -> Any:
    return ir.LiteralStructType([context.get_value_type(kind) for _, kind in packed.fields])


@lower_getattr_generic(Packed)  # type: ignore[untyped-decorator]
def _field(context: Any, builder: Any, packed: Packed, value: Any, name: str) -> Any:
    """Read a field: of an array all but what counts its references."""
    row = [each for each, _ in packed.fields].index(name)
    kind = packed.fields[row][1]
    address = builder.bitcast(value, _layout(context, packed).as_pointer())
    read = builder.load(cgutils.gep_inbounds(builder, address, 0, row))
    # What it points to is written before the call and not again.
    read.set_metadata("invariant.load", builder.module.add_metadata([]))
    if not isinstance(kind, types.Array):
        return read
    array = make_array(kind)(context, builder, value=read)
    array.meminfo = cgutils.get_null_value(array.meminfo.type)
    array.parent = cgutils.get_null_value(array.parent.type)
    return array._getvalue()


@unbox(Packed)  # type: ignore[untyped-decorator]
def _unbox(packed: Packed, given: Any, c: Any) -> NativeValue:
    """Write all fields to memory that lasts for the call."""
    layout = _layout(c.context, packed)
    place = cgutils.alloca_once(c.builder, layout)
    failed = cgutils.alloca_once_value(c.builder, cgutils.false_bit)
    held = []
    for row, (_, kind) in enumerate(packed.fields):
        found = c.unbox(kind, c.pyapi.tuple_getitem(given, row))
        c.builder.store(found.value, cgutils.gep_inbounds(c.builder, place, 0, row))
        bad = c.builder.or_(c.builder.load(failed), found.is_error)
        c.builder.store(bad, failed)
        held.append((kind, found))

    def let_go() -> None:
        for kind, found in held:
            if found.cleanup is not None:
                found.cleanup()
            c.context.nrt.decref(c.builder, kind, found.value)

    address = c.builder.bitcast(place, cgutils.voidptr_t)
    return NativeValue(address, is_error=c.builder.load(failed), cleanup=let_go)
