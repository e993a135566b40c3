"""Commented files to start from; the words that a key takes come from the schema."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from catopt.errors import InputError, Problem
from catopt.units import as_written
from catopt.words import Message


class Template(NamedTuple):
    """What a template is of, and the command that takes its file: ``solve`` for most.

    `needs`: another template whose file it names.
    """

    about: str
    command: str = "solve"
    needs: str = ""


TEMPLATES: Mapping[str, Template] = MappingProxyType(
    {
        "buoy": Template("marker buoy on 20 m of chain, every key with a comment"),
        "tanker": Template("tanker on one chain with a sinker, two load cases", "check"),
        "leg": Template("chain, wire and chain with a clump weight, water levels", "check"),
        "system": Template("body moored by six lines", "system"),
        "design": Template("search for the chain, length and sinker of a buoy", "design"),
        "motion": Template("line in waves, current and motion", "verify --dynamic"),
        "study": Template("a case again and again, with what varies in it", "study", "buoy"),
        "size-buoy": Template("buoy in its weather, in place of options", "size buoy"),
        "size-tanker": Template("tanker in its weather, in place of options", "size tanker"),
    }
)
"""Templates by name."""


def template(name: str) -> str:
    """Return a commented file that its command takes as it stands.

    Parameters
    ----------
    name : str
        One of `TEMPLATES`.

    Returns
    -------
    str
        TOML.

    Raises
    ------
    InputError
        When there is no such template.
    """
    if name not in TEMPLATES:
        from catopt.catalogue.names import meant

        allowed = meant(Message("refused.one_of", words=", ".join(TEMPLATES)), name, TEMPLATES)
        raise InputError([Problem("template", as_written(name), allowed)])
    from importlib.resources import files

    text = (files(__package__) / "templates" / f"{name}.toml").read_text(encoding="utf-8")
    return _with_others(text) if "{others}" in text else text


def _with_others(text: str) -> str:
    """Put the other words that a key takes where a comment has ``{others}``."""
    import re

    from catopt.casefile.schema import CaseTable, Table, entries
    from catopt.model.kinds import OneOf

    table: type[Table] = CaseTable
    lines = []
    for line in text.splitlines(keepends=True):
        if header := re.match(r"(?:# )?\[+([\w.]+)\]+", line):
            table = CaseTable
            for part in header[1].split("."):
                table = entries(table)[part].table or table
        if "{others}" in line:
            key, value = re.findall(r"^(?:# )?(\w+) = (.*?)  +#", line)[0]
            kind = entries(table)[key].kind
            assert isinstance(kind, OneOf)
            others = [word for word in kind.words if f'"{word}"' not in value]
            line = line.replace("{others}", ", ".join(others))
        lines.append(line)
    return "".join(lines)
