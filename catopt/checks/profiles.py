"""Profiles: named sets of criteria, each with its document, place and confidence."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Literal, TypeVar

from catopt.catalogue.components import CONFIDENCES, RECALLED, Confidence
from catopt.catalogue.family import nearest
from catopt.catalogue.table import TomlTable
from catopt.checks.kinds import (
    ANALYSES,
    CHECK_KINDS,
    LOAD_KINDS,
    STATES,
    STRENGTHS,
    CheckKind,
    CheckSource,
    Criterion,
    StrengthKind,
)
from catopt.model.kinds import Findings
from catopt.model.line import LINE_KINDS
from catopt.model.load import Checks
from catopt.units import as_written
from catopt.words import Cited, Message

Word = TypeVar("Word", bound=str)

_OF_TENSION = ("of", "part", "mean_factor", "lines", "analysis")
"""Keys that only a tension check has."""

SCHEMA = "catopt.profiles/1"
"""What the file of profiles has under its key ``schema``."""


@dataclass(frozen=True)
class Method:
    """What a code has beside its criteria, so that it is applied whole in a sizing."""

    dynamic_factor: float
    """Allowance for motion on the steady forces, which every check then sees."""
    motion: str
    """What stands for motion, with its place: for the answer."""
    confidence: Confidence
    """Of the factor."""
    prefer: str
    """Which line a sizing recommends: a preference of `catopt.sizing`."""
    soil: str = ""
    """Friction of a sinker: a soil of `catopt.loads.sinker`; empty: that of the place."""
    loads: str = ""
    """Method of the loads on a buoy that belongs to it; empty: it has none."""


@dataclass(frozen=True)
class Profile:
    """A named set of criteria."""

    name: str
    title: str
    document: str
    """Where it comes from, with the edition."""
    criteria: tuple[Criterion, ...]
    note: str = ""
    """What an engineer should know of it."""
    aliases: tuple[str, ...] = ()
    """Names that it had before."""
    method: Method | None = None
    """What it has beside its criteria; None: nothing."""

    @property
    def is_recalled(self) -> bool:
        """Whether any of it was read in no document."""
        return any(each.source.confidence == RECALLED for each in self.criteria)

    @property
    def is_for_motion(self) -> bool:
        """Whether it has factors for dynamic analysis."""
        return any(each.analysis == "dynamic" for each in self.criteria)


@cache
def profiles() -> tuple[Profile, ...]:
    """List the profiles that come with catopt, those that were read in their documents first."""
    text = files("catopt.checks").joinpath("data", "profiles.toml").read_text(encoding="utf-8")
    return parse_profiles(text, "catopt's profiles.toml")


def profiles_of(checks: Checks) -> tuple[Profile, ...]:
    """Look up the profiles that a case names. Capitals do not matter.

    InputError for every name: there is no such profile, with the nearest and all there are; or it
    was read in no document and the case does not allow that.
    """
    known = {name.casefold(): each for each in profiles() for name in (each.name, *each.aliases)}
    findings = Findings("checks")
    found = []
    for index, name in enumerate(checks.codes):
        each = known.get(name.casefold())
        refused = _refused(name, each, checks.allow_recalled)
        if refused:
            findings.add(f"checks.codes[{index}]", as_written(name), refused)
        elif each is not None and each not in found:
            found.append(each)
    findings.raise_if_any()
    return tuple(found)


def _refused(name: str, found: Profile | None, allow_recalled: bool) -> str:
    """Say why a profile cannot be used; empty when it can."""
    if found is None:
        names = [each.name for each in profiles()]
        begun = (each for each in names if each.casefold().startswith(name.casefold()))
        near = next(begun, None) or nearest(name, names)
        key = "refused.code_meant" if near else "refused.codes_are"
        return Message(key, near=near, names=", ".join(names))
    if found.is_recalled and not allow_recalled:
        return Message("refused_case.recalled_read_no_document_use")
    return ""


def parse_profiles(text: str, source: str = "") -> tuple[Profile, ...]:
    """Read the text of a TOML file of profiles; every problem of it is told at once."""
    document, findings = TomlTable.of_file(text, source, SCHEMA, ("profile",))
    found = tuple(_profile(table) for table in document.tables("profile"))
    findings.raise_if_any()
    return found


def _profile(table: TomlTable) -> Profile:
    table.only("name", "title", "document", "edition", "note", "aliases", "criterion", "method")
    name, edition = table.text("name") or "", table.text("edition", required=False)
    document = table.text("document") or ""
    document += f" ({edition})" if edition else ""
    criteria = (_criterion(each, name, document) for each in table.tables("criterion"))
    return Profile(
        name,
        table.text("title") or "",
        document,
        tuple(each for each in criteria if each is not None),
        table.said("note", required=False) or "",
        tuple(table.texts("aliases")),
        _method(table.table("method")),
    )


def _method(table: TomlTable | None) -> Method | None:
    if table is None:
        return None
    table.only("dynamic_factor", "motion", "confidence", "prefer", "soil", "loads")
    factor, confidence = table.number("dynamic_factor"), table.word("confidence", CONFIDENCES)
    motion, prefer = table.said("motion"), table.text("prefer")
    if factor is None or confidence is None or motion is None or prefer is None:
        return None
    soil, loads = (table.text(key, required=False) or "" for key in ("soil", "loads"))
    return Method(factor, motion, confidence, prefer, soil, loads)


def _criterion(table: TomlTable, code: str, document: str) -> Criterion | None:
    table.only("check", "value", "kinds", "states", "clause", "confidence", "note", *_OF_TENSION)
    check, confidence = table.word("check", CHECK_KINDS), table.word("confidence", CONFIDENCES)
    value = table.number("value")
    clause, of = table.text("clause"), _strength(table, check)
    if check is None or confidence is None or value is None or of is None or clause is None:
        return None
    return Criterion(
        check=check,
        value=value,
        source=CheckSource(code, Cited(document), clause, confidence),
        of=of,
        part=_given(table, "part") or 1.0,
        mean_factor=_given(table, "mean_factor"),
        lines=_words(table, "lines", LINE_KINDS) or LINE_KINDS,
        kinds=_words(table, "kinds", LOAD_KINDS) or LOAD_KINDS,
        states=_words(table, "states", STATES) or ("intact",),
        analysis=(table.has("analysis") and table.word("analysis", ANALYSES)) or "quasi-static",
        note=table.said("note", required=False) or "",
    )


def _given(table: TomlTable, key: str) -> float | None:
    return table.number(key, above=0.0) if table.has(key) else None


def _strength(table: TomlTable, check: CheckKind | None) -> StrengthKind | Literal[""] | None:
    """Read the strength that a tension check is on; no other check has one."""
    if check == "tension":
        return table.word("of", STRENGTHS)
    for key in _OF_TENSION:
        if table.has(key):
            table.problem(key, Message("refused_file.goes_with_tension"))
    return ""


def _words(table: TomlTable, key: str, words: tuple[Word, ...]) -> tuple[Word, ...]:
    """Read some of a few words, in their own order."""
    given = table.texts(key)
    if not set(given) <= set(words):
        table.problem(key, Message("refused_file.some_of", words=", ".join(words)))
    return tuple(each for each in words if each in given)
