"""An answer out of the catalogue as a document: what ``catopt catalog --json`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from catopt.catalogue.components import Component, Source
from catopt.catalogue.family import Family
from catopt.catalogue.fittings import Fitting, UsedFitting
from catopt.records import Record


@dataclass(frozen=True)
class Answer(Record):
    """Families and components of the catalogue that a question gave.

    Confidence is A (read in the primary or official document), B (in two independent secondary
    sources, or in one and checked by numbers), C (in one secondary source) or R (recalled, read in
    no document).
    """

    SCHEMA = "catopt.catalog/1"
    DOCUMENT = (
        "question families components anchors? used_fittings=fittings? missing=missing_fittings? "
        "sinkers? sources(key title place)"
    )

    question: Literal["list", "show", "search", "find", "anchor", "fittings", "sinker"]
    """What was asked."""
    families: tuple[Family, ...]
    """Families that were listed, or that the components are of."""
    components: tuple[Component, ...] = ()
    """Components that were found; none for list."""
    anchors: Sequence[Any] = ()
    """What drag anchors hold, `catopt.loads.sinker.AnchorHolding`."""
    fittings: tuple[Fitting, ...] = ()
    uses: tuple[str, ...] = ()
    """What the fittings are for, beside each; empty where they were looked up by name."""
    missing: Sequence[str] = ()
    """Why what goes with the chain has no fitting; left out where all have one."""
    sinkers: Sequence[Any] = ()
    """What sinkers hold, `catopt.loads.sinker.SinkerHolding`."""

    @property
    def sources(self) -> tuple[Source, ...]:
        """Documents that the answer rests on."""
        cited = [
            *(s for family in self.families for s in family.sizes.sources),
            *(s for family in self.families for f in family.figures for s in f.sources),
            *(s for c in self.components for p in c.provenance.values() for s in p.sources),
            *(s for each in (*self.anchors, *self.fittings) for s in each.sources),
        ]
        return tuple(sorted(set(cited), key=lambda source: source.key))

    @property
    def used_fittings(self) -> tuple[UsedFitting, ...]:
        """Fittings that were found, each with what it is for; left out where none was."""
        uses = self.uses or ("",) * len(self.fittings)
        return tuple(map(UsedFitting, self.fittings, uses))
