"""What stands beside a line as it is sold: fittings, those of a chain, and drag anchors."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import Final

from catopt.catalogue.components import Confidence, Source
from catopt.catalogue.family import in_mm
from catopt.catalogue.reading import cited, own_sources, own_text
from catopt.catalogue.table import TomlTable
from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Findings, Length, Mass, Positive, Strength
from catopt.model.line import Segment, line_kind
from catopt.records import Record
from catopt.words import Measure, Message, term


def read_own(
    name: str, schema: str, keys: Sequence[str]
) -> tuple[TomlTable, Findings, dict[str, Source]]:
    """Open one of catopt's own data files, with what is wrong with it and the sources by key."""
    document, findings = TomlTable.of_file(own_text(name), f"catopt's {name}", schema, keys)
    return document, findings, own_sources()


_ROUNDING = 1e-9
"""Relative, of sizes."""

SCHEMA: Final = "catopt.fittings/1"

_COLUMNS: Final = {"mass_kg": 1.0, "WLL_t": 1e3, "proof_kN": 1e3, "MBL_kN": 1e3}
"""What a row may have beside its size, and its unit in SI."""

_BY_PIN: Final = frozenset({"bow shackle"})
"""Fittings whose size is that of their pin, which says nothing of the chain."""

OF_A_CHAIN: Final = MappingProxyType(
    {"shackle": "shackle", "swivel": "swivel", "sinker ring": "ring"}
)
"""What a mooring of chain takes, by its use, and of which kind it is."""


@dataclass(frozen=True)
class Fitting:
    """One size of a fitting, in SI; what the source does not give is None."""

    name: str
    """By which it is looked up."""
    kind: str
    """Shackle, link, ring, swivel, plate."""
    title: str
    """What it is."""
    size: Length
    """Of its pin, or of the chain that it is made for; the title or the note says which."""
    MBL: Strength
    """Minimum breaking load."""
    proof_load: Strength | None
    """Proof load."""
    mass: Mass | None
    """In air."""
    WLL: Mass | None
    """Working load limit."""
    price: Positive | None
    """Material only, USD of 2024."""
    sources: tuple[Source, ...]
    place: str
    """Where in the sources."""
    confidence: Confidence
    """How well it was read."""
    also: tuple[str, ...] = ()
    note: str = ""
    """What else to know."""

    @property
    def source_keys(self) -> tuple[str, ...]:
        """Keys of the sources."""
        return tuple(source.key for source in self.sources)


@dataclass(frozen=True)
class UsedFitting(Record):
    """A fitting, and what it is for."""

    DOCUMENT = (
        "use fitting.name fitting.kind fitting.title fitting.size fitting.MBL fitting.proof_load "
        "fitting.mass fitting.WLL fitting.price=price_USD fitting.confidence "
        "fitting.source_keys=sources fitting.place fitting.note"
    )

    fitting: Fitting
    use: str
    """What it is for; empty where it was looked up by name."""


@dataclass(frozen=True)
class FittingSet:
    """What goes with a chain: each at least as strong, or why there is none."""

    component: str
    diameter: float
    MBL: float
    """Of the chain, N."""
    found: Mapping[str, Fitting]
    """By use, a key of `OF_A_CHAIN`."""
    missing: Mapping[str, Message]
    """By use, why none was found."""

    @property
    def weakest(self) -> Fitting | None:
        """The fitting of the lowest MBL; None where there is none."""
        return min(self.found.values(), key=lambda each: each.MBL, default=None)


@cache
def fittings() -> tuple[Fitting, ...]:
    """List every size of every fitting, in the order of the file."""
    document, findings, sources = read_own("fittings.toml", SCHEMA, ("fitting",))
    read = [each for table in document.tables("fitting") for each in _sizes(table, sources)]
    findings.raise_if_any()
    return tuple(read)


def fittings_for(
    component: str, diameter: float, MBL: float, uses: Collection[str] = tuple(OF_A_CHAIN)
) -> FittingSet:
    """Find the shackle, the swivel and the sinker ring that go with a chain.

    Of each kind it is the one of the lowest MBL that is not below the chain's, and that is not made
    for a thinner chain. Proof loads are compared where both are known by whoever has them.

    Parameters
    ----------
    component : str
        Name of the chain, for messages.
    diameter : float
        Nominal diameter of its bar, m.
    MBL : float
        Of the chain, new, N.
    uses : collection of str
        Which of `OF_A_CHAIN`; a line on a drag anchor has no sinker ring.

    Raises
    ------
    InputError
        When the diameter or the MBL is not positive.
    """
    check = Findings("fittings")
    check.number("diameter", diameter, "m", above=0.0)
    check.number("MBL", MBL, "N", above=0.0)
    check.raise_if_any()
    thinnest = diameter * (1.0 - _ROUNDING)
    found: dict[str, Fitting] = {}
    missing: dict[str, Message] = {}
    for use in uses:
        of_kind = [each for each in fittings() if each.kind == OF_A_CHAIN[use]]
        strong = [e for e in of_kind if e.MBL >= MBL and (e.name in _BY_PIN or e.size >= thinnest)]
        if strong:
            found[use] = min(strong, key=lambda each: (each.MBL, each.size))
            continue
        values = {"kind": term(use), "needed": Measure("MBL", MBL)}
        thin = [each.size for each in of_kind if each.MBL >= MBL]
        if thin:
            sizes = {"largest": in_mm(max(thin)), "diameter": in_mm(diameter)}
            missing[use] = Message("catalogue.no_fitting_for", **sizes, **values)
            continue
        strongest = max(each.MBL for each in of_kind)
        missing[use] = Message(
            "catalogue.no_fitting", strongest=Measure("MBL", strongest), **values
        )
    return FittingSet(component, diameter, MBL, MappingProxyType(found), MappingProxyType(missing))


def fittings_of(segment: Segment, uses: Collection[str]) -> FittingSet | None:
    """Find those of a segment, as `fittings_for`; None where it is no chain of known strength."""
    diameter, MBL = segment.nominal_diameter, segment.MBL
    if line_kind(segment.component) != "chain" or diameter is None or MBL is None:
        return None
    return fittings_for(segment.component, diameter, MBL, uses)


def _sizes(table: TomlTable, sources: dict[str, Source]) -> list[Fitting]:
    table.only(
        "name", "kind", "also", "title", "columns", "rows", "price_per_N", "source", "place",
        "confidence", "note",
    )  # fmt: skip
    names = table.texts("columns", required=True)
    per_newton = table.number("price_per_N", above=0.0) if table.has("price_per_N") else None
    shared = {
        "name": table.text("name") or "",
        "kind": table.text("kind") or "",
        "title": table.said("title") or "",
        "also": table.texts("also"),
        "note": table.said("note", required=False) or "",
        **cited(table, sources),
    }
    sizes = []
    for row in table.values["rows"]:
        given = dict(zip(names, row, strict=True))
        size = given.pop("size_mm") / 1e3
        of = {name: value * _COLUMNS[name] for name, value in given.items()}
        sizes.append(
            Fitting(
                size=size,
                MBL=of["MBL_kN"],
                proof_load=of.get("proof_kN"),
                mass=of.get("mass_kg"),
                WLL=of.get("WLL_t"),
                price=None if per_newton is None else per_newton * of["MBL_kN"],
                **shared,
            )
        )
    return sizes


ANCHORS_SCHEMA: Final = "catopt.anchors/1"

_UNITS: Final = {"kip": 4448.2216152605, "tf": 1e3 * STANDARD_GRAVITY, "kN": 1e3, "N": 1.0}


@dataclass(frozen=True)
class Holding:
    """Ultimate holding H = HR (m/mR)^b of a horizontal pull in a soil, by one data set."""

    soil: str
    data: str
    capacity: float
    """HR, N."""
    of_mass: float
    """mR, kg."""
    exponent: float
    sources: tuple[Source, ...]
    place: str
    confidence: Confidence


@dataclass(frozen=True)
class AnchorType:
    """A kind of drag anchor in the masses that are sold."""

    name: str
    title: str
    also: tuple[str, ...]
    masses: tuple[float, ...]
    """kg, rising. A list of sizes is no figure of strength: a recalled one is used, and says so."""
    sources: tuple[Source, ...]
    """Of the masses, at `place`."""
    place: str
    confidence: Confidence
    holdings: tuple[Holding, ...]
    price_per_mass: float
    """Material only, USD/kg of 2024."""
    note: str = ""

    @property
    def range(self) -> tuple[float, float]:
        """Smallest and largest mass that is sold, kg: nothing is said of any beyond."""
        return self.masses[0], self.masses[-1]


@cache
def anchor_types() -> tuple[AnchorType, ...]:
    """List the kinds of drag anchor, in the order of the file."""
    document, findings, sources = read_own("anchors.toml", ANCHORS_SCHEMA, ("price", "anchor"))
    price = document.table("price")
    per_mass = (price.number("per_mass", above=0.0) if price else None) or 0.0
    read = tuple(
        AnchorType(
            name=table.text("name") or "",
            title=table.said("title") or "",
            also=table.texts("also"),
            masses=table.rising("masses_kg"),
            **cited(table, sources),
            holdings=tuple(_holding(each, sources) for each in table.tables("holding")),
            price_per_mass=per_mass,
            note=table.said("note", required=False) or "",
        )
        for table in document.tables("anchor")
    )
    findings.raise_if_any()
    return read


def _holding(table: TomlTable, sources: dict[str, Source]) -> Holding:
    unit = table.word("unit", tuple(_UNITS)) or "N"
    return Holding(
        soil=table.text("soil") or "",
        data=table.text("data") or "",
        capacity=(table.number("capacity", above=0.0) or 0.0) * _UNITS[unit],
        of_mass=table.number("of_mass_kg", above=0.0) or 0.0,
        exponent=table.number("exponent", above=0.0) or 0.0,
        **cited(table, sources),
    )
