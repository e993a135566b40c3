"""Kinds of check and their units in the schemas of documents: `python -m tests.checks.schemas`."""

from __future__ import annotations

import json
import re
from importlib.resources import files
from pathlib import Path

from catopt.checks.kinds import CHECK_KINDS, QUANTITY_OF

SCHEMAS = Path(str(files("catopt.schemas")))
OLD = {"design-1.json": ("offset",), "size-1.json": ("offset",)}
"""Older names of kinds, which documents of catopt 0 have."""
KIND = re.compile(r'("kind": \{\s*"enum": )\[[^]]*\](,\s*"description": "Which kind of check)')
UNIT = re.compile(r'("unit": \{\s*"enum": )\[[^]]*\](,\s*"description": "SI unit of demand and)')


def up_to_date(name: str, text: str) -> str:
    """Give the text of a schema with every kind of check, and the SI unit of each."""
    units = sorted({QUANTITY_OF[kind].si_unit.strip("-") for kind in CHECK_KINDS})
    kinds = json.dumps([*CHECK_KINDS, *OLD.get(name, ())])
    text = KIND.sub(lambda found: found[1] + kinds + found[2], text)
    return UNIT.sub(lambda found: found[1] + json.dumps(units) + found[2], text)


def of_checks() -> list[Path]:
    """List the schemas of documents with checks."""
    return [each for each in sorted(SCHEMAS.glob("*.json")) if KIND.search(each.read_text("utf-8"))]


if __name__ == "__main__":
    for path in of_checks():
        path.write_text(up_to_date(path.name, path.read_text("utf-8")), "utf-8")
