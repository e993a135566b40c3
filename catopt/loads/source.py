"""Where a formula or a coefficient comes from, and how well it was read."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.catalogue.components import RECALLED, Confidence
from catopt.errors import InputError, Problem
from catopt.records import Record
from catopt.words import Message

CALMAR = "IALA CALMAR technical reference, 27 February 2014"
UFC = "UFC 4-159-03 Design: Moorings, 3 October 2005 (superseded by the edition of 12 March 2020)"
TCN_222_95 = "22TCN 222-95, after SNiP 2.06.04-82, section 5"
BLENDERMANN = "Blendermann 1994, as the MSS toolbox has it (blendermann94.m)"
MARPOL = "MARPOL 73/78, Annex I, regulation 18, in secondary copies"
DTOCEAN = "DTOcean moorings, loads.py and its database"
MOORPY = "MoorPy, fit to Vryhof's figures"
NAVFAC = "NAVFAC DM 7.02 (1986), table 1 of chapter 3"


@dataclass(frozen=True)
class LoadSource(Record):
    """A document to open and the clause in it, with the confidence of what stands there."""

    DOCUMENT = "document clause confidence"

    document: str
    """What to open."""
    clause: str
    """Where in it."""
    confidence: Confidence
    """A read in the primary document; B in two secondary ones, or in one and checked by numbers; C
    in one secondary one; R recalled, read in none."""

    @property
    def recalled(self) -> bool:
        """Whether it was read in no document."""
        return self.confidence == RECALLED

    @property
    def text(self) -> str:
        """One line for tables: ``"IALA CALMAR technical reference, ..., 5.2.1 [A]"``."""
        return f"{self.document}, {self.clause} [{self.confidence}]"


def refuse_recalled(where: str, key: str, what: str, instead: str, *, allowed: bool) -> None:
    """Raise InputError unless the caller asked for recalled figures.

    The message names function and argument, what was read in no document, and the way out.
    """
    if not allowed:
        out = Message("refused_sizing.recalled_r_read_no_document", instead=instead)
        raise InputError([Problem(key, what, out)], where)
