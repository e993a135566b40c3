"""A component of a load, with where its formula is from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from catopt.catalogue.components import RECALLED, Confidence
from catopt.display import Tabled
from catopt.errors import refused
from catopt.model.kinds import Force, SomeForce
from catopt.records import Record
from catopt.words import Message
from catopt.words.message import number

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
        raise refused(key, what, out, where)


Axis = Literal["along", "surge", "sway"]
"""Along the one direction of everything; along a ship, positive forwards; across it, positive away
from the side that wind, current and waves come from."""


@dataclass(frozen=True)
class Number(Record):
    """A number that goes into a formula, in SI: its unit is empty for a pure number."""

    DOCUMENT = "symbol value unit meaning"

    symbol: str
    """As the formula has it."""
    value: float
    """In its unit."""
    unit: str
    """SI; empty for a pure number."""
    meaning: str
    """What it is."""

    @property
    def text(self) -> str:
        """``"V = 2.1 m/s"``, to four digits."""
        return f"{self.symbol} = {number(self.value, '.4g')} {self.unit}".rstrip()


class _Symbol(str):
    """A symbol, with its power where it has one."""

    __slots__ = ()

    def __format__(self, spec: str) -> str:
        return f"{self}^{spec}" if spec else str(self)


@dataclass(frozen=True)
class LoadComponent(Record):
    """One force: what pushes on what, such as ``"current on the hull"``."""

    DOCUMENT = "name kind axis force formula numbers source note"

    name: str
    """What pushes on what."""
    kind: Literal["wind", "current", "wave drift", "wave"]
    """Its cause; a wave is the maximum of an oscillating force. The current on a buoy includes the
    motion of the water in waves."""
    axis: Axis
    """Direction, as of the sums."""
    factors: tuple[str, ...]
    """What is multiplied, the symbols of `numbers` in braces and a power behind a colon:
    ``("1/2", "{rho}", "{V:2}", "{A}", "{Cd}")``; g is gravity."""
    numbers: tuple[Number, ...]
    """What was put in."""
    force: Force
    """With the sign of its axis."""
    source: LoadSource
    """Of the formula and its coefficients, as sure as the weakest of them."""
    note: str = ""
    """What else to know; may be empty."""

    @property
    def formula(self) -> str:
        """In the symbols of the numbers: ``"1/2 rho V^2 A Cd"``."""
        symbols = {symbol: _Symbol(symbol) for symbol in ("g", *(n.symbol for n in self.numbers))}
        return " ".join(self.factors).format(**symbols)

    @property
    def numbers_text(self) -> str:
        """The numbers on one line."""
        return ", ".join(number.text for number in self.numbers)


@dataclass(frozen=True)
class Loads(Tabled):
    """All horizontal forces of wind, current and waves on a buoy or a ship in some weather."""

    title: str
    """On what, and in what weather."""
    components: tuple[LoadComponent, ...]
    """The forces, in the order of the computation."""
    assumptions: tuple[str, ...] = ()
    """What the answer rests on."""
    warnings: tuple[str, ...] = ()
    """What an engineer should know: a wave cut by breaking, figures out of their range."""
    method: str = ""
    """By which the forces were computed: 22TCN-222-95."""

    def along(self, axis: Axis) -> float:
        """Sum of the forces along an axis, N."""
        return math.fsum(each.force for each in self.components if each.axis == axis)

    def of(self, kind: str) -> float:
        """Size of the sum of the forces of a kind, N."""
        own = [each for each in self.components if each.kind == kind]
        return Loads(self.title, tuple(own)).horizontal_force

    @property
    def all_along(self) -> Force:
        """Sum along the one direction of everything; of a buoy."""
        return self.along("along")

    @property
    def all_surge(self) -> Force:
        """Sum along a ship, positive forwards."""
        return self.along("surge")

    @property
    def all_sway(self) -> Force:
        """Sum across a ship, positive away from the side of positive angles."""
        return self.along("sway")

    @property
    def horizontal_force(self) -> SomeForce:
        """Size of the sum of all forces: what the mooring has to hold."""
        return math.hypot(self.along("along") + self.along("surge"), self.along("sway"))

    @property
    def recalled(self) -> tuple[str, ...]:
        """Names of the forces that rest on figures read in no document."""
        return tuple(each.name for each in self.components if each.source.recalled)
