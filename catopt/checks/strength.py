"""Strength of a segment at the end of its service life."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING

from catopt.checks.kinds import StrengthKind
from catopt.constants import SEA_WATER_DENSITY, YEAR
from catopt.errors import InputError, refused
from catopt.model import CatalogueChoice, Segment, Service
from catopt.model.line import LineKind, line_kind
from catopt.model.wear import end_diameter
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catalogue import Component
    from catopt.catalogue.choice import ChosenCatalogue


@dataclass(frozen=True)
class Strength:
    """What a segment withstands when its service life ends."""

    kind: LineKind | None
    """By its component; None when that is not known."""
    MBL: float | None
    proof_load: float | None
    """At the end of the service life, as it hangs in water, N; None when not known."""
    diameter: float | None = None
    end_diameter: float | None = None
    """Nominal, new and at the end of the service life, m; None when not known."""
    tested: float | None = None
    """Characteristic strength by break tests, at the end of the service life, N; None without
    tests."""
    note: str = ""
    """The wear in words; empty when there is none."""
    missing: tuple[tuple[str, str], ...] = ()
    """Why a strength is not known, by its name, where there is more to say than that."""

    def of(self, kind: StrengthKind) -> float | None:
        """Return the MBL or the proof load."""
        return self.MBL if kind == "MBL" else self.proof_load

    def need(self, kind: StrengthKind, key: str, wanted_by: str) -> float:
        """Return the MBL or the proof load, which a criterion needs.

        InputError when it is not known; it names the segment by the key, which criterion wants it,
        and the way out.
        """
        value = self.of(kind)
        if value is None:
            allowed = Message("refused_case.no_strength")
            if why := dict(self.missing).get(kind):
                allowed = Message("refused_case.reason_give_it", why=why)
            needs = Message("refused_case.needs", allowed=allowed, wanted_by=wanted_by)
            raise refused(f"{key}.{kind}", "", needs, "checks")
        return value


def strength_of(
    segment: Segment,
    service: Service | None = None,
    catalogue: CatalogueChoice | None = None,
    *,
    key: str = "segment",
) -> Strength:
    """Find the strength of a segment at the end of its service life.

    The wear is taken off the nominal diameter. A component's strength is then the catalogue's at
    that diameter; figures of the segment's own are scaled in the same proportion. Without a
    component, or where the catalogue ends, strength goes with the square of the diameter; that is
    on the safe side for chain, whose formula c d^2 (44 - 0.08 d) falls more slowly. A fibre rope
    does not corrode: it keeps its strength unless the segment has a wear rate of its own. The MBL
    of a segment is that in water already.

    Without a service the line stays as new; without a catalogue components are catopt's own. The
    key is that of the segment, for messages. InputError when there is wear but no diameter, or no
    zone for the table of wear, or the wear takes all of it, or the catalogue has no such component.
    """
    kind = line_kind(segment.component)
    new = segment.nominal_diameter
    try:
        end = end_diameter(segment, service)
    except InputError as error:
        problems = [replace(each, key=f"{key}.{each.key}") for each in error.problems]
        raise InputError(problems, "checks") from None
    component = _component(segment, catalogue, is_worn=end != new)
    MBL, proof_load = segment.MBL, segment.proof_load
    if component is not None:
        MBL = component.MBL_in_water if MBL is None else MBL
        proof_load = component.proof_load if proof_load is None else proof_load
    lacks = () if component is None else tuple(component.missing.items())
    return Strength(
        kind=kind,
        MBL=_worn(MBL, "MBL", component, new, end),
        proof_load=_worn(proof_load, "proof_load", component, new, end),
        diameter=new,
        end_diameter=end,
        tested=_worn(segment.tested_strength, "MBL", component, new, end),
        note=_note(new, end, segment, service),
        missing=tuple(each for each in lacks if each[0] in ("MBL", "proof_load")),
    )


def _component(
    segment: Segment, choice: CatalogueChoice | None, *, is_worn: bool
) -> Component | None:
    """Look the component up, if its figures are wanted beside the segment's own."""
    known = segment.MBL is not None and segment.proof_load is not None and not is_worn
    if known or not segment.component or segment.nominal_diameter is None:
        return None
    return _looked_up(segment.component, segment.nominal_diameter, choice or CatalogueChoice())


@cache
def _looked_up(name: str, diameter: float, choice: CatalogueChoice) -> Component:
    """Look a component up once: a search checks the same few sizes at many lengths."""
    return _families(choice).component(name, diameter)


@cache
def _families(choice: CatalogueChoice) -> ChosenCatalogue:
    from catopt.catalogue.choice import chosen

    return chosen(choice, SEA_WATER_DENSITY)  # strength does not depend on the water


def _worn(
    strength: float | None,
    quantity: StrengthKind,
    component: Component | None,
    new: float | None,
    end: float | None,
) -> float | None:
    """Strength at the end diameter; N."""
    if strength is None or new is None or end is None or end == new:
        return strength
    if component is not None and quantity in component.provenance:
        low, _ = component.provenance[quantity].range
        if end >= low:
            at = component.MBL_at if quantity == "MBL" else component.proof_load_at
            then, now = at(end), at(new)
            assert then is not None
            assert now is not None
            return strength * then / now
    return strength * (end / new) ** 2


def _note(new: float | None, end: float | None, segment: Segment, service: Service | None) -> str:
    if new is None or end is None or end == new:
        return ""
    was, is_now = Measure("nominal_diameter", new), Measure("nominal_diameter", end)
    worn = Message("checks.worn", new=was, worn=is_now)
    if service is None or service.table is None or not segment.wear_zone:
        return worn
    table, zone = service.table, segment.wear_zone
    key = "checks.wear_recalled" if table.confidence == "R" else "checks.wear_by_table"
    return Message(
        key,
        worn=worn,
        source=table.source,
        confidence=table.confidence,
        zone=Message(f"checks.zone_{zone}"),
        rate=table.rates[zone] * YEAR * 1e3,
    )
