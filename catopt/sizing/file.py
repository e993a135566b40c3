"""Reads a file that ``catopt size`` takes: what it gives, and every mistake in it."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path as FilePath
from types import MappingProxyType
from typing import Any, Final

from catopt.casefile.building import title_block
from catopt.casefile.document import (
    Finding,
    as_in_file,
    in_order_of,
    parts,
    read_tables,
    stands_for,
    table,
)
from catopt.casefile.reading import Moored, case_key, moored_in
from catopt.casefile.schema import TableSchema, entries
from catopt.documents import Path, dotted, parse_toml, read_text
from catopt.errors import InputError, Problem
from catopt.loads.calmar_file import SUFFIX
from catopt.model import TitleBlock
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.input_values import ResolvedInputs, Spelling, as_keyword, input_values
from catopt.sizing.inputs import SINKER, Input, inputs_of
from catopt.sizing.kinds import schema_of
from catopt.sizing.requests import request_of, size
from catopt.sizing.result import Sizing
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import Message

_NOTHING: Final[Mapping[str, object]] = MappingProxyType({})
_NOTHING_READ: Final[Mapping[str, str]] = MappingProxyType({})


@dataclass(frozen=True)
class SizingFile:
    """What a file gives."""

    moored: Moored
    source: str  # its name, for messages
    folder: str  # that paths in it count from
    document: dict[str, Any]  # as the TOML reader returns it
    findings: tuple[Finding, ...]  # what is wrong with it in itself
    cells: Mapping[str, str] = field(default_factory=dict)  # of a workbook: where it has each key
    title_block: TitleBlock | None = None  # of the firm's document

    def known(
        self,
        before: Mapping[str, object] = _NOTHING,
        spell: Spelling = as_keyword,
        *,
        defaults: Mapping[str, object] | None = None,
        called: Mapping[str, str] | None = None,
    ) -> ResolvedInputs:
        """Read what the file gives.

        `before`: inputs by name, written as `spell`, that go before those of the file: before their
        own, and before what stands in their place; `defaults`, `called`: as for
        `catopt.sizing.input_values.input_values`.
        """
        inputs = self.inputs(before)

        def spelled(name: str, index: int | None = None) -> str:
            if name in {*before, *(called or {}).values()} or name not in inputs:
                return spell(name, index)
            return dotted((*inputs[name].path, *(() if index is None else (index,))))

        faulty = [finding.path for finding in self.findings]
        told = [*faulty, *self._misspelt()]
        reported = [  # those of which the key, or its table, is told already
            name
            for name, each in inputs.items()
            if name not in before
            and any(each.path[: len(path)] == path[: len(each.path)] for path in told)
        ]
        reported += map(dotted, faulty)
        found = input_values(
            self.moored,
            self.given(before),
            spelled,
            self.source,
            reported=reported,
            defaults=defaults,
            called=called,
        )
        return replace(found, title_block=self.title_block)

    def inputs(self, before: Mapping[str, object] = _NOTHING) -> Mapping[str, Input]:
        """List the inputs that count, by what holds the line."""
        by_sinker = "sinker" in self.document
        if "anchor" in before:
            by_sinker = before["anchor"] == SINKER
        return inputs_of(self.moored, held_by=SINKER if by_sinker else "anchor")

    def given(self, before: Mapping[str, object] = _NOTHING) -> dict[str, object]:
        """Return every input that is given, as the file has it; see `input_values`."""
        found: dict[str, object] = {}
        if "sinker" in self.document and self.moored == "tanker":
            found["anchor"] = SINKER
        for name, each in self.inputs(before).items():
            place = table(self.document, each.section) if each.section else self.document
            is_before = any(other in before for other in (name, *each.not_with))
            if each.path[-1] in place and not is_before:
                value = place[each.path[-1]]
                if isinstance(value, str) and (
                    each.takes == "FILE" or (name == "buoy" and value.lower().endswith(SUFFIX))
                ):
                    value = str(FilePath(self.folder) / value)
                found.setdefault(name, value)
        return {**found, **before}

    @contextmanager
    def reporting(self) -> Iterator[None]:
        """Tell everything that is wrong at once, as it stands in the file and in its order."""
        try:
            yield
        except InputError as error:
            is_of_another = error.source != self.source
            if is_of_another and not self.findings:
                raise
            raise self._error(() if is_of_another else error.problems) from None
        if self.findings:
            raise self._error(())

    def _error(self, problems: tuple[Problem, ...]) -> InputError:
        keys = {each.key for each in self.inputs().values()}
        found, others = list(self.findings), []
        for problem in problems:
            path = parts(problem.key)
            if dotted(tuple(part for part in path if isinstance(part, str))) in keys:
                at = Finding(path, problem.found, problem.allowed)
                found.append(as_in_file(self.document, at))
            else:
                others.append(problem)
        ordered = in_order_of(self.document, list(dict.fromkeys(found)))
        told = (self._in_its_cell(each.as_problem()) for each in ordered)
        return InputError([*told, *others], self.source)

    def _in_its_cell(self, problem: Problem) -> Problem:
        """Put the cell before the key of what a workbook has."""
        cell = self.cells.get(dotted(tuple(p for p in parts(problem.key) if isinstance(p, str))))
        return replace(problem, key=f"{cell} {problem.key}") if cell else problem

    def _misspelt(self) -> Iterator[Path]:
        """List the keys that were meant by unknown ones."""
        top = schema_of(self.moored)
        for finding in self.findings:
            *above, key = finding.path
            schema: type[TableSchema] | None = top
            for part in above:
                entry = None if schema is None else entries(schema).get(str(part))
                schema = None if entry is None else entry.table
            if schema is not None and str(key) not in entries(schema):
                meant = stands_for(schema, str(key), top)
                if meant is not None:
                    yield (*above, meant)


def read_file(path: str | os.PathLike[str], moored: Moored) -> SizingFile:
    """Read a TOML file in UTF-8 for one of the two kinds of moored body.

    One that cannot be read, is no TOML or is for something else is refused. What else is wrong
    stands in its ``findings``.
    """
    source = os.fspath(path)
    text = read_text(FilePath(path), source)
    return parse_file(text, moored, source, folder=str(FilePath(path).parent))


def parse_file(text: str, moored: Moored, source: str = "", *, folder: str = "") -> SizingFile:
    """Read the text of a file, as `read_file` does.

    `source` names the file in messages; `folder` is what paths in it count from, the working
    directory when left out.
    """
    return file_of(parse_toml(text, source), moored, source, folder=folder)


def file_of(
    document: dict[str, Any],
    moored: Moored,
    source: str = "",
    *,
    folder: str = "",
    cells: Mapping[str, str] = _NOTHING_READ,
) -> SizingFile:
    """Take the document of a file, as the TOML reader returns it, as `parse_file` does.

    `cells`: the cell of a workbook that has each key.
    """
    key, other = case_key(document), None
    if moored == "buoy" and "ship" in document:
        allowed = Message("refused_file.for_size_tanker")
        other = Finding(("ship",), Message("refused_file.a_ship"), allowed)
    elif key:
        found = f"[{key[0]}]" if len(key) == 1 else Message("refused_file.segments_of_a_line")
        other = Finding(key, found, Message("refused.is_case_file"))
    if other is not None:
        raise InputError([other.as_problem()], source)
    tables, findings = read_tables(document, schema_of(moored))
    if moored == "tanker" and "anchor" in document and "sinker" in document:
        advice = Message("refused_file.sinker_or_anchor")
        findings.append(Finding(("sinker",), Message("refused_file.anchor_beside"), advice))
    given = tables.given().get("document")
    block = None if given is None or findings else title_block(given, folder)
    return SizingFile(moored, source, folder, document, tuple(findings), cells, block)


def read_sizing(path: str | os.PathLike[str]) -> BuoyRequest | TankerRequest:
    """Read a file for ``catopt size`` as what `size_buoy` or `size_tanker` takes.

    Parameters
    ----------
    path : str or path
        The file, TOML in UTF-8.

    Returns
    -------
    BuoyRequest or TankerRequest
        What the file gives; what it leaves out is taken, and said in ``defaults``.

    Raises
    ------
    InputError
        When it cannot be read, or with every mistake in it, each by its key.

    Examples
    --------
    >>> import catopt
    >>> catopt.read_sizing("cases/size-tanker/sizing.toml").title
    'Tanker of 50,000 DWT in 20 m'
    """
    file = read_file(path, moored_in(path) or "buoy")
    with file.reporting():
        return request_of(file.known())


def sized(file: SizingFile, *, at_rest: bool = False) -> Sizing:
    """Size what a file describes: as ``catopt size`` does, but nothing is asked for.

    `at_rest`: leave motion out, unless the file asks for it in full.

    InputError: every mistake, each by its key; what is required and is not in the file is one. Else
    as for `size_buoy` and `size_tanker`.
    """
    with file.reporting():
        is_still = at_rest and not file.given().get("in_motion")
        return size(file.known({"at_rest": True} if is_still else _NOTHING))
