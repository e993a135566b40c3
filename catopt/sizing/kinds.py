"""What kind of value each input of a sizing is, what is taken for it, and the form of a file.

A file has every section and key of the table of inputs. None is required: what the file leaves out
may come as an option or be asked for. Upper limits are those of the model, which says them.
"""

from __future__ import annotations

from functools import cache
from typing import Annotated, Any

from catopt.casefile.reading import Moored
from catopt.casefile.schema import TableSchema
from catopt.model import TitleBlock
from catopt.model.kinds import Flag, Kind, Measured, OneOf, Text, Whole
from catopt.model.plausible_ranges import range_of
from catopt.sizing.inputs import Input, inputs_of, rows_of
from catopt.units import Dimension, as_written, bare_number


@cache
def kind_of(each: Input) -> Kind:
    """Make the kind that reads a value of an input, or each of several."""
    example = each.one_example
    match each.takes:
        case "TEXT":
            return Text()
        case "NAME" | "FILE":
            return Text(filled=True, example=as_written(example))
        case "WHICH":
            return OneOf(each.words)
        case "COUNT":
            return Whole(each.name, example)
        case "FLAG":
            return Flag()
    dimension, known = Dimension[each.takes], range_of(each.path)
    at_least, at_most = each.at_least, None
    if known is not None:
        at_least, at_most = max(known.least, each.at_least or known.least), known.most
    return Measured(
        dimension, each.above, at_least, at_most, example=as_written(example), bare=each.bare
    )


def from_text(each: Input, text: str) -> object:
    """Take a text as an option or an answer has it: a number without a unit is one."""
    return bare_number(text) if each.is_measure or each.takes == "COUNT" else text


def choices_of(each: Input) -> tuple[str, ...]:
    """List the texts that an input is chosen from; empty: any."""
    if each.name == "buoy":
        from catopt.loads import buoys

        return tuple(known.name for known in buoys())
    if each.key == "sinker.soil":
        from catopt.loads.sinker import SOIL_FRICTION

        return tuple(SOIL_FRICTION)
    return each.words


@cache
def default_of(each: Input) -> Any:
    """Read what is taken of an input when it is left out; in SI."""
    value = kind_of(each).read(from_text(each, each.default))
    return (value,) if each.several else value


def usual(name: str, moored: Moored = "buoy") -> Any:
    """Return the default of an input by its name; in SI."""
    return default_of(inputs_of(moored)[name])


@cache
def schema_of(moored: Moored) -> type[TableSchema]:
    """Make the schema of a file: every input in its section, and ``[document]``."""
    sections: dict[str, dict[str, Input]] = {}
    for each in rows_of(moored):
        sections.setdefault(each.section, {})[each.path[-1]] = each
    tables: dict[str, type[TableSchema]] = {}
    for name, inputs in sections.items():
        annotations = {key: _annotation(each) for key, each in inputs.items()}
        tables[name] = _made(f"{name.title()}Table", TableSchema, annotations)
        tables[name].symbols = {alias: key for key, each in inputs.items() for alias in each.also}
    top = tables.pop("")
    optional: dict[str, Any] = {name: table | None for name, table in tables.items()}
    return _made("SizingTable", top, optional | {"document": TitleBlock | None})


def _made(name: str, base: type[TableSchema], annotations: dict[str, Any]) -> type[TableSchema]:
    """Make a schema none of whose keys is required."""
    return type(name, (base,), dict.fromkeys(annotations) | {"__annotations__": annotations})


def _annotation(each: Input) -> Any:
    one = Annotated[Any, kind_of(each)]
    return list[one] if each.several else one
