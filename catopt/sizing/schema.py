"""The form of a sizing file: every section and key, made of the table of inputs.

No key is required: what the file leaves out may come as an option or be asked for. Upper limits are
those of the model, which tells them.
"""

from __future__ import annotations

from functools import cache
from typing import Annotated, Any

from catopt.casefile.schema import Table
from catopt.casefile.sizing_file import Moored
from catopt.sizing.inputs import Input, rows_of
from catopt.sizing.kinds import kind_of


@cache
def schema_of(moored: Moored) -> type[Table]:
    """Make the schema of a file."""
    inputs = rows_of(moored)
    sections = dict.fromkeys(each.section for each in inputs)
    tables = {
        name: _table(name, [each for each in inputs if each.section == name]) for name in sections
    }
    annotations = {name: table | None for name, table in tables.items() if name}
    return _made("SizingTable", tables[""], annotations)


def _table(name: str, inputs: list[Input]) -> type[Table]:
    made = _made(
        f"{name.title()}Table", Table, {each.path[-1]: _annotation(each) for each in inputs}
    )
    made.symbols = {alias: each.path[-1] for each in inputs for alias in each.also}
    return made


def _made(name: str, base: type[Table], annotations: dict[str, Any]) -> type[Table]:
    """Make a schema none of whose keys is required."""
    return type(name, (base,), dict.fromkeys(annotations) | {"__annotations__": annotations})


def _annotation(each: Input) -> Any:
    one = Annotated[Any, kind_of(each)]
    return list[one] if each.several else one
