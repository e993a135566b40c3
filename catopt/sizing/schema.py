"""The form of a sizing file: every section and key, made of the table of inputs.

No key is required: what the file leaves out may come as an option or be asked for. Upper limits are
those of the model, which tells them.
"""

from __future__ import annotations

from functools import cache
from typing import Annotated, Any

from pydantic import create_model

from catopt.casefile.schema import SOME, Table
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
    fields: dict[str, Any] = {name: (table | None, None) for name, table in tables.items() if name}
    return create_model("SizingTable", __base__=tables[""], **fields)


def _table(name: str, inputs: list[Input]) -> type[Table]:
    fields: dict[str, Any] = {each.path[-1]: (_annotation(each) | None, None) for each in inputs}
    made = create_model(f"{name.title()}Table", __base__=Table, **fields)
    made.symbols = {alias: each.path[-1] for each in inputs for alias in each.also}
    return made


def _annotation(each: Input) -> Any:
    one = Annotated[Any, kind_of(each)]
    return Annotated[list[one], SOME] if each.several else one
