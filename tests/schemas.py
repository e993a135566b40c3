"""The JSON schemas of documents, written from the records that lay them out.

``python -m tests.schemas`` brings `catopt/schemas` up to date. Of a record's key its annotation
gives type, unit and bounds, its docstring the meaning (`catopt.records`).
"""

from __future__ import annotations

import ast
import inspect
import json
import math
import re
import sys
import textwrap
import types
from collections.abc import Iterator, Mapping, Sequence
from functools import cache, cached_property
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Any, Literal, NotRequired, Union, get_args, get_origin, get_type_hints

import numpy as np
import numpy.typing as npt

from catopt.catalogue.document import Answer
from catopt.catenary.case_curve import CaseCurve
from catopt.catenary.in_current import SolutionInCurrent
from catopt.catenary.solution import Solution
from catopt.checks.result import CheckReport, ChecksInBrief
from catopt.cli.new import NewFile
from catopt.design.result import DesignResult
from catopt.export.export_result import Exported
from catopt.loads.holding_table import AnchorHolding, SinkerHolding
from catopt.loads.weathervane import ComparedLoads
from catopt.model.kinds import OneOf, Size
from catopt.mooring.case import AtLevel, SystemReport
from catopt.mooring.network_out import NetworkOut
from catopt.mooring.network_rest import NetworkReport
from catopt.mooring.restoring import RestoringCurve, WatchCircle
from catopt.notes.front_in_motion import FrontInMotion
from catopt.notes.note_comparison import NoteAgain
from catopt.notes.report_document import WrittenNote
from catopt.records import From, Key, Matching, OrNull, Record, parts, unit_of
from catopt.reproduce.items import Reproduction
from catopt.sizing.result import Sizing
from catopt.study.finding import FoundValues
from catopt.study.result import StudyResult
from catopt.study.run import Plan
from catopt.verify.case import FrontVerification
from catopt.verify.dynamic_result import DynamicVerification
from catopt.verify.fatigue import FatigueReport
from catopt.verify.result import Verification
from catopt.verify.ship_result import ShipVerification
from catopt.words import Message

FOLDER = Path(str(files("catopt.schemas")))
RECORDS: Mapping[str, tuple[type[Record], ...]] = {
    "catalog": (Answer,),
    "check": (CheckReport,),
    "curve": (CaseCurve,),
    "design": (DesignResult,),
    "export": (Exported,),
    "fatigue": (FatigueReport,),
    "find": (FoundValues,),
    "loads": (ComparedLoads,),
    "network": (NetworkReport,),
    "new": (NewFile,),
    "note_again": (NoteAgain,),
    "report": (WrittenNote,),
    "reproduction": (Reproduction,),
    "size": (Sizing,),
    "system": (SystemReport,),
    "solution": (Solution, SolutionInCurrent),
    "study": (StudyResult,),
    "study_plan": (Plan,),
    "verify": (Verification, FrontVerification),
}
"""Which records lay a document out; what only some of them have may be missing."""
OF_A_CASE = ("check", "curve", "design", "fatigue", "find", "size", "solution", "system", "verify")
"""Documents that a result directory may have."""
PUT_IN: Mapping[str, Mapping[str, tuple[Any, str]]] = {
    "catalog": {
        "anchors": (
            tuple[AnchorHolding, ...],
            "Holding capacity of drag anchors; left out where none was asked for.",
        ),
        "sinkers": (
            tuple[SinkerHolding, ...],
            "Holding capacity of a sinker, by soil; left out where none was asked for.",
        ),
    },
    "design": {
        "messages": (
            Mapping[str, Any],
            "By which key and values texts of the document are said in another language, by their "
            "English; those of the checks are not among them.",
        )
    },
    "system": {"checks": (ChecksInBrief, "")},
    "verify": {
        "dynamic": (
            DynamicVerification | FrontInMotion | None,
            "The line in motion, of --dynamic, or with --all every design of the front; null: at "
            "rest only.",
        ),
        "ship": (
            ShipVerification,
            "A ship on its lines on two time scales, of --dynamic; not there otherwise.",
        ),
    },
    "network": {
        "checks": (ChecksInBrief, ""),
        "one_line_out": (
            tuple[NetworkOut, ...],
            "Only when asked for: each line gone in turn, a body that is held in its place.",
        ),
        "watch_circle": (
            WatchCircle,
            "Only when asked for: a force of the size of that on the one body, from all sides.",
        ),
        "water_levels": (
            tuple[AtLevel, ...],
            "Only when asked for: at other water levels, the one free body under its load.",
        ),
        "restoring_curves": (
            tuple[RestoringCurve, ...],
            "Only when asked for: the one free body, or without one all that is held, at offsets "
            "along a direction.",
        ),
    },
}
"""What a command puts into a document, or a class cannot name, by its key: type and meaning."""
Asked = Literal["may", "must", "never"]
ASKED: Mapping[str, Asked] = {"design": "never", "size": "never"}
"""Of documents whose parts have what is put in on asking never, or always."""


OLDER: Mapping[str, tuple[str, ...]] = {"design": ("offset",), "size": ("offset",)}
"""Older names of kinds of checks, which documents of catopt 0 have."""
FURTHER: Mapping[str, Mapping[str, Any]] = {
    "solution": {
        "if": {"properties": {"method": {"const": "pso"}}},
        "then": {"required": ["pso"]},
        "else": {"properties": {"pso": False}},
    }
}
"""What depends on another key."""
DIGEST = {
    "type": "string",
    "pattern": "^[0-9a-f]{64}$",
    "description": "Only in a file that --out wrote: SHA-256 of the case that the directory is of.",
}
PROGRAM = {"type": "string", "description": "Version of catopt that wrote it, with its commit."}
"""Documents of 1.0 do not have it."""
SI = "All numbers are SI; the unit is in the key and in the description."
WIDTH = 160
_PLAIN = {str: "string", bool: "boolean", int: "integer", float: "number", type(None): "null"}

Schema = dict[str, Any]


def schema(name: str) -> Schema:
    """Write the schema of a document."""
    records = RECORDS[name]
    of = _Written({}, records[0], ASKED.get(name, "may"))
    whole = [of.object_of(each) for each in records]
    common = set.intersection(*(set(each["required"]) for each in whole))
    properties: Schema = {"schema": {"const": records[0].SCHEMA}, "catopt": PROGRAM}
    if name in OF_A_CASE:
        properties["case_sha256"] = DIGEST
    for each in whole:
        properties |= each["properties"]
    for key, (hint, said) in PUT_IN.get(name, {}).items():
        properties[key] = of.of(hint) | {"description": said or _flat(inspect.getdoc(hint) or "")}
    if name in OLDER:
        of.definitions["check_result"]["properties"]["kind"]["enum"] += OLDER[name]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": "urn:" + records[0].SCHEMA.replace(".", ":").replace("/", ":"),
        "title": records[0].SCHEMA,
        "description": f"{_flat(inspect.getdoc(records[0]) or '')} {SI}",
        "type": "object",
        "additionalProperties": False,
        "required": ["schema", *(key for key in whole[0]["required"] if key in common)],
        "properties": properties,
        **FURTHER.get(name, {}),
        "$defs": dict(sorted(of.definitions.items())),
    }


class _Written:
    """Schemas of types; those of records stand among `definitions`."""

    def __init__(
        self,
        definitions: dict[str, Schema],
        whole: type[Record] | None = None,
        asked: Asked = "may",
    ) -> None:
        self.definitions = definitions
        self._whole = whole
        self._asked = asked

    def object_of(self, record: type[Record]) -> Schema:
        """Write the schema of a record, by its own document."""
        found = parts(record, record.DOCUMENT)
        found = tuple(part for part in found if self._asked != "never" or part.mark != "*")
        written = self._object(record, found, ("", "*") if self._asked == "must" else ("",))
        if record.SCHEMA and record is not self._whole:
            written["required"].insert(0, "schema")
            own = {"schema": {"const": record.SCHEMA}, "catopt": PROGRAM}
            written["properties"] = own | written["properties"]
        return written

    def _object(self, of: type, found: tuple[Key, ...], needed: tuple[str, ...]) -> Schema:
        return {
            "type": "object",
            "additionalProperties": False,
            "required": [part.key for part in found if part.mark in needed],
            "properties": {part.key: self._described(of, part) for part in found},
        }

    def _described(self, of: type, part: Key) -> Schema:
        unit = "" if part.inner else unit_of(part.hint)
        if isinstance(getattr(part.owner, part.path[-1], None), types.FunctionType) and (
            isinstance(part.hint, type) and issubclass(part.hint, Record)
        ):
            said = _flat(inspect.getdoc(part.hint) or "")
        elif part.key == part.path[0] and part.key in _docstrings(of):
            said = meaning(of, part.key)
        else:
            said = meaning(part.owner, part.path[-1])
        plain = unit.replace("_per_", "/").replace("Nm", "N m")
        said = re.sub(rf", {plain}(?=[.;])", "", said, count=1) if plain else said
        # What is left out is never null.
        hint = _without_none(part.hint) if part.mark == "?" else part.hint
        found = self.of(hint, part.inner) | ({"minimum": 1} if part.is_counted else {})
        return found | {"description": f"{plain}: {lower(said)}" if plain else said}

    def of(self, hint: Any, document: str = "") -> Schema:
        """Write the schema of a type; of one that is laid out by a document, by that."""
        origin, inner = get_origin(hint), get_args(hint)
        if hint is Any:
            return {}
        if origin is not None:
            return self._made(origin, inner, document)
        if isinstance(hint, type) and issubclass(hint, Record) and not document:
            if hint is self._whole:
                return {"$ref": "#"}
            if _snake(hint) not in self.definitions:
                self.definitions[_snake(hint)] = {}
                self.definitions[_snake(hint)] = self.object_of(hint)
            return {"$ref": f"#/$defs/{_snake(hint)}"}
        if document and hint is not type(None):
            found = self._object(hint, parts(hint, document), ("",))
            # The name of a record is that of its own document.
            is_named = issubclass(hint, Record) and hint.DOCUMENT
            return found if is_named else self._defined(hint, found)
        return {"type": _PLAIN[str if hint is Message else hint]}

    def _defined(self, hint: type, found: Schema) -> Schema:
        """Put it among the definitions, where no other one has its name."""
        if self.definitions.setdefault(_snake(hint), found) != found:
            return found
        return {"$ref": f"#/$defs/{_snake(hint)}"}

    def _made(self, origin: Any, inner: tuple[Any, ...], document: str) -> Schema:
        """Write the schema of a type that is made of others."""
        if origin is Annotated:
            return self._bounded(inner[0], inner[1:], document)
        if origin in (Union, types.UnionType):
            return _any_of([self.of(each, document) for each in inner])
        if origin is Literal:
            return {"const": inner[0]} if len(inner) == 1 else {"enum": list(inner)}
        if origin in (tuple, list, Sequence):
            sized = (
                {} if inner[-1] is ... or origin is not tuple else _items(len(inner), len(inner))
            )
            return {"type": "array", **sized, "items": self.of(inner[0], document)}
        if origin in (np.ndarray, npt.NDArray):  # numpy 2.5 has an alias of its own
            return {"type": "array", "items": {"type": "number"}}
        assert issubclass(origin, Mapping), origin
        return {"type": "object", "additionalProperties": self.of(inner[1], document)}

    def _bounded(self, hint: Any, kinds: tuple[Any, ...], document: str = "") -> Schema:
        found = self.of(hint, document)
        for kind in kinds:
            if isinstance(kind, From):
                found |= {"minItems" if found["type"] == "array" else "minimum": kind.least}
            elif isinstance(kind, Size):
                found |= _items(kind.fewest, kind.most)
            elif isinstance(kind, Matching):
                found |= {"pattern": kind.pattern}
            elif kind is OrNull:
                found["items"] = {"type": ["number", "null"]}
            elif isinstance(kind, OneOf):
                found = {"enum": list(kind.words)}
            elif isinstance(kind, type):
                found = self._defined(kind, self._typed(kind))
            elif hasattr(kind, "si_unit"):
                bounds = {"minimum": kind.at_least, "exclusiveMinimum": kind.above,
                          "maximum": kind.at_most}  # fmt: skip
                at = found["items"] if found["type"] == "array" else found
                at |= {key: _number(value) for key, value in bounds.items() if value is not None}
                if kind.infinite:  # which documents write as null
                    at["type"] = ["number", "null"]
        return found

    def _typed(self, keys: Any) -> Schema:
        """Write the schema of a dictionary whose keys a TypedDict has."""
        said = _docstrings(keys)
        hints = get_type_hints(keys, include_extras=True)
        kept = {key: get_args(hint)[0] for key, hint in hints.items() if _may_lack(hint)}
        return {
            "type": "object",
            "additionalProperties": False,
            "required": [key for key in hints if key not in kept],
            "properties": {
                key: self.of(hint) | {"description": said[key]}
                for key, hint in (hints | kept).items()
            },
        }


def _snake(of: type) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", of.__name__).lower()


def _items(fewest: int, most: int) -> Schema:
    return {"minItems": fewest, "maxItems": most}


def _may_lack(hint: Any) -> bool:
    return get_origin(hint) is NotRequired


def _number(value: float) -> float:
    return int(value) if value == math.floor(value) else value


def _without_none(hint: Any) -> Any:
    if get_origin(hint) in (Union, types.UnionType):
        (kept,) = [each for each in get_args(hint) if each is not type(None)]
        return kept
    return hint


def _any_of(schemas: list[Schema]) -> Schema:
    """Join schemas: types of plain values, words with null, or any of several."""
    *others, last = sorted(schemas, key=lambda each: each == {"type": "null"})
    if last != {"type": "null"} or len(others) != 1:
        return {"anyOf": schemas}
    (found,) = others
    if "enum" in found:
        return {"enum": [*found["enum"], None]}
    if "type" in found and found["type"] != "object":
        return found | {"type": [found["type"], "null"]}
    return {"anyOf": [found, last]}


def meaning(of: type, name: str) -> str:
    """Say what an attribute is: the first paragraph of its docstring."""
    for each in of.__mro__:
        if name in _docstrings(each):
            return _docstrings(each)[name]
    raise AssertionError(f"{of.__name__}.{name} has no docstring, so that no schema can say it")


@cache
def _docstrings(of: Any) -> Mapping[str, str]:
    """Docstrings of a class' own attributes and methods, by name."""
    if of is object or not hasattr(sys.modules.get(of.__module__), "__file__"):
        return {}
    tree = ast.parse(textwrap.dedent(inspect.getsource(of))).body[0]
    assert isinstance(tree, ast.ClassDef)
    found = {}
    for before, node in zip(tree.body, tree.body[1:], strict=False):
        match before, node:
            case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(value=said)):
                found[name] = _flat(str(said))
    for name, each in vars(of).items():
        function = each.fget if isinstance(each, property) else each
        function = function.func if isinstance(function, cached_property) else function
        if isinstance(function, types.FunctionType) and function.__doc__:
            found[name] = _flat(function.__doc__.partition("\n\n")[0])
    return found


def _flat(text: str) -> str:
    """Put a text into one line; JSON has null where Python has None."""
    return re.sub(r"\bNone\b", "null", " ".join(text.split()))


def lower(text: str) -> str:
    """Begin in small letters, save for a symbol."""
    return text if text[1:2].isupper() or text[1:2] in ", " else text[:1].lower() + text[1:]


def written(found: Any, indent: int = 0) -> str:
    """Write JSON: what fits into a line is one."""
    line = json.dumps(found, ensure_ascii=False)
    if len(line) + indent <= WIDTH or not isinstance(found, dict | list) or not found:
        return line
    pad = " " * (indent + 2)
    if isinstance(found, dict):
        rows = [f"{json.dumps(key)}: {written(each, indent + 2)}" for key, each in found.items()]
    elif all(isinstance(each, str) for each in found):
        rows = textwrap.wrap(line[1:-1], 100)
        return "[\n" + "\n".join(pad + row for row in rows) + "\n" + " " * indent + "]"
    else:
        rows = [written(each, indent + 2) for each in found]
    inside = ",\n".join(pad + row for row in rows)
    left, right = "{}" if isinstance(found, dict) else "[]"
    return f"{left}\n{inside}\n{' ' * indent}{right}"


def up_to_date() -> Iterator[tuple[Path, str]]:
    """Yield every schema, and its text."""
    for name in RECORDS:
        yield FOLDER / f"{name}-1.json", written(schema(name)) + "\n"


if __name__ == "__main__":
    for path, text in up_to_date():
        path.write_text(text, "utf-8")
