"""The reference of docs/sizing.md: every input of a sizing with its key, keyword and range.

``python -m tests.sizing_page`` brings the page up to date with the table of inputs.
"""

from __future__ import annotations

from pathlib import Path

from catopt.model.kinds import Measured
from catopt.sizing.inputs import INPUTS, Input, rows_of
from catopt.sizing.kinds import kind_of
from catopt.units import as_written
from catopt.words import Message
from tests.casefile.test_schema import range_of

PAGE = Path(__file__).parents[1] / "docs" / "sizing.md"

BEGIN = "<!-- inputs: python -m tests.sizing_page -->\n"
END = "<!-- end -->"

_COLUMNS = ("key", "in Python", "SI", "default", "range", "meaning", "example")
_HEAD = f"| {' | '.join(_COLUMNS)} |\n{'|---' * len(_COLUMNS)}|\n"
_KEYS = {each.name: f"`{each.path[-1]}`" for each in INPUTS}


def up_to_date(page: str) -> str:
    """Put the real tables in the place of what the page shows."""
    head, _, rest = page.partition(BEGIN)
    return f"{head}{BEGIN}{reference()}{END}{rest.partition(END)[2]}"


def reference() -> str:
    """Write a table for each section of a file."""
    text = ""
    for section in dict.fromkeys(each.section for each in INPUTS):
        rows: dict[str, list[Input]] = {}
        for each in INPUTS:
            if each.section == section:
                both = (*rows_of("buoy"), *rows_of("tanker"))
                rows[each.key] = [row for row in both if row.key == each.key]
        text += f"\n### {f'`[{section}]`' if section else 'Top of the file'}\n\n{_HEAD}"
        text += "".join(map(_row, rows.values()))
    return f"{text}\n"


def _row(rows: list[Input]) -> str:
    """Write the row of a key; a buoy's and a tanker's may differ in default, limit and example."""
    each = rows[0]
    only = f"{each.of[0]}: " if len(each.of) == 1 else ""
    words = str(Message(f"inputs.{each.name}"))
    kind = kind_of(each)
    unit = kind.dimension.si_unit if isinstance(kind, Measured) else ""
    cells = (
        f"`{each.path[-1]}`",
        f"`{each.name}`",
        unit or "-",
        "; ".join(dict.fromkeys(map(_left_out, rows))),
        "; ".join(dict.fromkeys(map(_range, rows))),
        only + words[0].lower() + words[1:],
        ", ".join(f"`{_example(row)}`" for row in _distinct(rows)),
    )
    return f"| {' | '.join(cells)} |\n"


def _distinct(rows: list[Input]) -> list[Input]:
    return list({repr(row.example): row for row in rows}.values())


def _example(each: Input) -> str:
    if isinstance(each.example, tuple):
        return f"[{', '.join(map(as_written, each.example))}]"
    return as_written(each.example)


def _left_out(each: Input) -> str:
    if each.left_out:
        return Message(each.left_out, **_KEYS)
    if each.takes == "FLAG":
        return "false"
    if each.required and each.not_with:
        return f"wanted, or {' and '.join(_KEYS[name] for name in each.not_with)}"
    return each.default or ("wanted" if each.required else "none")


def _range(each: Input) -> str:
    """Write the range of an input, with the limit of the model."""
    most = f", to {each.most}" if each.most else ""
    return range_of(kind_of(each)) + most + (", each" if each.several else "")


if __name__ == "__main__":
    PAGE.write_text(up_to_date(PAGE.read_text("utf-8")), encoding="utf-8")
