"""All criteria of a case, by codes and by its own numbers, and the strengths they are held to."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

from catopt.checks.kinds import (
    OF_LINE,
    STATES,
    USER,
    Analysis,
    CheckKind,
    CheckSource,
    Criterion,
    State,
    StrengthKind,
)
from catopt.checks.profiles import Profile, profiles_of
from catopt.checks.profiles import profiles as all_profiles
from catopt.constants import SEA_WATER_DENSITY, YEAR
from catopt.errors import InputError, Problem, refused
from catopt.model import Anchor, CatalogueChoice, Line, Segment, Service
from catopt.model.line import LineKind, line_kind
from catopt.model.load import Checks, LoadCaseKind
from catopt.model.wear import Condition, end_diameter
from catopt.units import as_written
from catopt.words import Cited, Measure, Message

if TYPE_CHECKING:
    from catopt.catalogue import Component
    from catopt.catalogue.choice import ChosenCatalogue
    from catopt.model import Case
    from catopt.model.network import Network


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
    """Look the component up, if its figures are required beside the segment's own."""
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


HORIZONTAL_PULL = CheckSource(
    "drag anchor", "UFC 4-159-03 Design: Moorings (3 October 2005)", "Table 3-18", "A"
)
"""A drag anchor holds against a horizontal pull, unless the case says how much uplift it takes."""

_INTACT: tuple[State, ...] = ("intact",)

UPLIFT: tuple[CheckKind, ...] = ("uplift_angle", "uplift_force")
"""Checks that limit how far an anchor is lifted."""

SEARCHED: tuple[CheckKind, ...] = (
    "tension",
    "least_tension",
    *UPLIFT,
    "grounded_length",
    "span",
    "buoyancy",
    "sliding",
    "holding",
    "equilibrium",
)
"""Checks that `Limits` and `allowed_tension` carry into the loops of a search."""


class AllowedTension(NamedTuple):
    """Strength at the end of life over the factor, N, and by which criterion.

    Infinite and None when no criterion covers the segment.
    """

    tension: float
    criterion: Criterion | None


class Limits(NamedTuple):
    """The strictest limit of each kind, as plain numbers for compiled code.

    What is not asked for has the number at which the functions of `catopt.checks.kinds` are below
    0 for any line.
    """

    uplift_angle: float = math.inf
    """Largest inclination at the anchor, rad; infinite when not asked for."""
    uplift_force: float = math.inf
    """Largest vertical pull at the anchor, N; infinite when not asked for."""
    grounded_length: float = 0.0
    """Least length on the bed, m; 0 when not asked for."""
    span: float = math.inf
    """Largest distance from the anchor to the fairlead, m; infinite when not asked for."""
    reserve_buoyancy: float = math.inf
    """Largest vertical pull at the fairlead, N; infinite when not asked for."""
    sliding_factor: float = 0.0
    """Of a sinker; 0 when there is none."""
    holding_factor: float = 0.0
    """Of a drag anchor; 0 when there is none."""
    least_tension: float = 0.0
    """At the fairlead, N; 0 when not asked for."""


@dataclass(frozen=True)
class Criteria:
    """What a line has to keep."""

    all: tuple[Criterion, ...]
    """The case's own numbers first, then those of its codes in the order it names them."""
    service: Service | None
    catalogue: CatalogueChoice
    warnings: tuple[str, ...] = ()
    """What an engineer should know of the codes."""

    def of(
        self, check: CheckKind, kind: LoadCaseKind, state: State = "intact"
    ) -> Iterator[Criterion]:
        """Yield the criteria of one check for one kind of load case in one state."""
        return (
            each
            for each in self.all
            if each.check == check and kind in each.kinds and state in each.states
        )

    def in_condition(self, condition: Condition | None) -> Criteria:
        """Return the criteria for the line in a condition: a new one has all its strength."""
        return replace(self, service=None) if condition == "new" else self

    def strength(self, segment: Segment, key: str = "segment") -> Strength:
        """Find the strength of a segment at the end of the service life; see `strength_of`."""
        return strength_of(segment, self.service, self.catalogue, key=key)

    def strengths(
        self,
        line: Line,
        kinds: Collection[LoadCaseKind],
        states: Collection[State] = _INTACT,
    ) -> tuple[Strength, ...]:
        """Find the strength of every segment of a line, from the anchor to the fairlead.

        InputError names at once all strengths and diameters that a criterion needs and that are not
        known.
        """
        problems: dict[Problem, None] = {}
        found = []
        for index, segment in enumerate(line.segments):
            key = f"line.segments[{index}]"
            try:
                strength = self.strength(segment, key)
            except InputError as error:
                problems |= dict.fromkeys(error.problems)
                continue
            found.append(strength)
            if strength.tested is not None and not any(each.takes_tests for each in self.all):
                allowed = Message("refused_case.leave_out_or_name_code")
                problems[Problem(f"{key}.MBL_mean", f"{segment.MBL_mean:g} N", allowed)] = None
            problems |= dict.fromkeys(self.lacking(strength, kinds, key, states))
        if problems:
            raise InputError(tuple(problems), "checks")
        return tuple(found)

    def allowed_tension(
        self,
        segment: Segment | Strength,
        kind: LoadCaseKind,
        state: State = "intact",
        *,
        key: str = "segment",
    ) -> AllowedTension:
        """Find the largest tension that a segment is allowed.

        It is the least of strength over factor.

        Its length does not matter. A catalogue option is asked as
        ``allowed_tension(component.segment(1.0), "extreme")``; looking it up once by `strength`
        and passing that on saves the look-up for the other kind of load case. The key is that of
        the segment, for messages. InputError when a criterion needs an MBL or a proof load that is
        not known, or there is wear but no diameter.
        """
        strength = segment if isinstance(segment, Strength) else self.strength(segment, key)
        least = AllowedTension(math.inf, None)
        for criterion in self.of("tension", kind, state):
            if criterion.is_for(strength.kind):
                allowed = allowed_by(criterion, strength, key)
                if allowed < least.tension:
                    least = AllowedTension(allowed, criterion)
        return least

    def lacking(
        self,
        strength: Strength,
        kinds: Collection[LoadCaseKind],
        key: str,
        states: Collection[State] = _INTACT,
    ) -> Iterator[Problem]:
        """Yield a problem for every strength of a segment that is required and not known.

        The key is that of the segment: ``line.segments[0]``.
        """
        reported = set()
        for criterion in self.all:
            wanted = (
                criterion.is_for(strength.kind)
                and not set(kinds).isdisjoint(criterion.kinds)
                and not set(states).isdisjoint(criterion.states)
            )
            if criterion.of and wanted and criterion.of not in reported:
                reported.add(criterion.of)
                try:
                    allowed_by(criterion, strength, key)
                except InputError as error:
                    yield from error.problems

    def limits(self, kind: LoadCaseKind, state: State = "intact") -> Limits:
        """Find the strictest limit of each kind for a mooring in one state.

        InputError where a criterion is of a kind that no search keeps.
        """
        unknown = {
            each: Message("refused_case.asked_for_by", code=each.source.code)
            for each in self.all
            if each.check not in SEARCHED
        }
        if unknown:
            allowed = Message("refused_case.no_search_keeps_this_check")
            problems = [
                Problem(f"checks: {each.check}", found, allowed) for each, found in unknown.items()
            ]
            raise InputError(problems, "checks")

        def values(check: CheckKind) -> list[float]:
            return [criterion.value for criterion in self.of(check, kind, state)]

        return Limits(
            uplift_angle=min(values("uplift_angle"), default=math.inf),
            uplift_force=min(values("uplift_force"), default=math.inf),
            grounded_length=max(values("grounded_length"), default=0.0),
            span=min(values("span"), default=math.inf),
            reserve_buoyancy=min(values("buoyancy"), default=math.inf),
            sliding_factor=max(values("sliding"), default=0.0),
            holding_factor=max(values("holding"), default=0.0),
            least_tension=max(values("least_tension"), default=0.0),
        )


def allowed_by(
    criterion: Criterion, strength: Strength, key: str, mean_share: float = 1.0
) -> float:
    """Tension that one criterion allows: strength at the end of life over its factor; N.

    `mean_share` is the mean tension over the whole, from 0 to 1, where the criterion has a factor
    on the mean; the key is that of the segment, for messages. Refused when the strength is not
    known.
    """
    assert criterion.of != ""
    wanted_by = "safety_factor" if criterion.of == "MBL" else "proof_load_factor"
    if criterion.source.confidence is not None:
        wanted_by = criterion.source.code
    factor = criterion.value
    if criterion.mean_factor is not None:
        factor = criterion.mean_factor * mean_share + criterion.value * (1.0 - mean_share)
    if criterion.takes_tests and strength.tested is not None:
        return strength.tested / factor
    return criterion.part * strength.need(criterion.of, key, wanted_by) / factor


def criteria_of(
    case: Case | Network, *, anchor_key: str = "anchor", analysis: Analysis = "quasi-static"
) -> Criteria:
    """Gather all that a case asks a line to keep.

    The factors on sliding and holding are there when the case has such an anchor. A search that
    chooses sinkers passes the case with one of them as its anchor.

    `anchor_key` says where its anchor stands, for messages; `analysis`, from which the tensions
    are: a code's factors for the other are not among the criteria, unless tensions are dynamic and
    it has none for them; those for lines at rest then hold, or `checks.motion_code` in its place.
    InputError when a code is not known, or was read in no document and the case does not allow
    that, or an anchor has no factor.
    """
    profiles, by = profiles_of(case.checks), motion_profile(case.checks)
    is_lacking = not profiles or any(not each.is_for_motion for each in profiles)
    if analysis == "dynamic" and by is not None and is_lacking:
        others = (each for each in profiles if each.is_for_motion)
        profiles = tuple(dict.fromkeys((*others, by)))
    # A code without factors for motion gives those for lines at rest.
    coded = [
        criterion
        for each in profiles
        for criterion in each.criteria
        if criterion.check != "tension"
        or criterion.analysis == (analysis if each.is_for_motion else "quasi-static")
    ]
    found = (
        *_own(case),
        *_of_buoy(case, analysis),
        *_of_anchor(case.anchor, coded, anchor_key, analysis),
        *(each for each in coded if each.check not in ("sliding", "holding")),
    )
    notes: list[str] = []
    if case.checks.max_offset is not None:
        notes.append(Message("checks.max_offset_is_max_span", limit=case.checks.max_offset))
    notes += [Message("checks.code_note", code=e.name, note=e.note) for e in profiles if e.note]
    return Criteria(
        all=(*found, *_no_uplift(case.anchor, found)),
        service=case.service,
        catalogue=case.catalogue,
        warnings=tuple(notes),
    )


def motion_profile(checks: Checks) -> Profile | None:
    """Look up the code that judges lines in motion; None where none is named.

    InputError: there is none of that name, it was read in no document, or it has no factors for
    dynamic analysis.
    """
    if checks.motion_code is None:
        return None
    key = "checks.motion_code"
    try:
        (found,) = profiles_of(replace(checks, codes=(checks.motion_code,), motion_code=None))
    except InputError as error:
        raise InputError([replace(each, key=key) for each in error.problems], "checks") from None
    if not found.is_for_motion:
        have = ", ".join(each.name for each in all_profiles() if each.is_for_motion)
        allowed = Message("refused_case.motion_code_has_no_factors", names=have)
        raise refused(key, as_written(checks.motion_code), allowed, "checks")
    return found


def _own(case: Case | Network) -> Iterator[Criterion]:
    """List the numbers of the case itself; they hold in every state that has none of its own."""
    checks = case.checks
    damaged = checks.safety_factor_line_out
    whole = tuple(state for state in STATES if damaged is None or state != "one_line_out")
    factors: tuple[tuple[float | None, StrengthKind, tuple[State, ...]], ...] = (
        (checks.safety_factor if checks.safety_factor > 1.0 else None, "MBL", whole),
        (damaged, "MBL", ("one_line_out",)),
        (checks.proof_load_factor, "proof_load", STATES),
    )
    for factor, strength, states in factors:
        if factor is not None:
            yield Criterion("tension", factor, USER, of=strength, states=states)
    for check, row in OF_LINE.items():
        limit = None if row.own is None else row.own(case)
        if limit is not None:
            yield Criterion(check, limit, USER)


def _of_buoy(case: Case | Network, analysis: Analysis) -> Iterator[Criterion]:
    """List the limit on a buoy's mean heel, which is known in motion."""
    limit = None if case.floater is None else case.floater.max_heel
    if limit is not None and analysis == "dynamic":
        yield Criterion("heel", limit, USER)


def _of_anchor(
    anchor: Anchor | None, coded: list[Criterion], key: str, analysis: Analysis
) -> Iterator[Criterion]:
    """List the factors on what holds the line: its own, or else those of the codes.

    In motion a sinker may have a way that it may slide in their place.
    """
    if anchor is None:
        return
    if analysis == "dynamic" and anchor.max_slide is not None:
        yield Criterion("slide", anchor.max_slide, USER)
        return
    check: CheckKind = "sliding" if anchor.kind == "sinker" else "holding"
    damaged = anchor.safety_factor_line_out
    if damaged is not None:
        yield Criterion(check, damaged, USER, states=("one_line_out",))
    whole = tuple(state for state in STATES if damaged is None or state != "one_line_out")
    if anchor.safety_factor is not None:
        own = CheckSource("anchor", Cited(anchor.factor_source))
        source = own if anchor.factor_source else USER
        yield Criterion(check, anchor.safety_factor, source, states=whole)
        return
    factors = [
        replace(each, states=tuple(state for state in each.states if state in whole))
        for each in coded
        if each.check == check
    ]
    if not factors:
        allowed = Message("refused_case.missing_give_factor_on_or", check=check)
        raise refused(f"{key}.safety_factor", "", allowed, "checks")
    yield from factors


def _no_uplift(anchor: Anchor | None, found: tuple[Criterion, ...]) -> Iterator[Criterion]:
    """Keep the pull on a drag anchor horizontal in the states where nothing limits its uplift."""
    if anchor is not None and anchor.kind == "drag":
        limited = {state for each in found if each.check in UPLIFT for state in each.states}
        states = tuple(state for state in STATES if state not in limited)
        if states:
            yield Criterion("uplift_angle", 0.0, HORIZONTAL_PULL, states=states)
