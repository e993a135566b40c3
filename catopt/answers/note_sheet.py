"""What every note states beside its answer: basis, parts, anchor, wear, damage, fatigue."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from catopt.answers.blocks import Block, Fact, Facts, Rows, Section, Table, Text, tabulate, texts
from catopt.answers.check import kind_name
from catopt.answers.note import Cell, from_rows, section
from catopt.checks.kinds import limit_quantity
from catopt.constants import YEAR
from catopt.words import Cited, Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.checks.criterion import Criterion
    from catopt.model import Case, Segment
    from catopt.model.network import Network
    from catopt.notes.sheet import Sheet, Stated


def basis_section(
    sheet: Sheet,
    combined: str = "",
    return_period: str = "",
    levels: Sequence[float] | None = None,
) -> Section:
    """State what the mooring is judged by, and under what.

    `combined`, a message, says how wind, current and waves are combined (as the user gave the force
    when empty), `return_period` is theirs (not stated when empty); `levels` are water levels in m,
    of the load cases when left out.
    """
    case, site = sheet.case, sheet.case.site
    if levels is None:
        levels = [each.water_level for each in sheet.report.load_cases]
    depth = Measure("water_depth", site.depth_to_seabed)
    fairlead = Measure("height", site.height_above_seabed(case.fairlead_height))
    density = Measure("density", site.water_density)
    rows = {
        "analysis": Message("note_sheet.quasi_static"),
        "return_period": return_period or Message("note_sheet.not_stated"),
        "combination": combined or Message("note_sheet.combined_by_user"),
        "datum": Message("note_sheet.datum_is", depth=depth),
        "tide": _tide(levels),
        "fairlead": Message("sizing.measure", value=fairlead),
        "friction": Message("sizing.about", value=site.seabed_friction),
        "density": Message("sizing.measure", value=density),
        "life": _life(case),
        "pretension": _pretension(sheet),
    }
    facts = (Fact(Message(f"note_sheet.{key}"), said) for key, said in rows.items())
    limits = [_limit_states(sheet)] if sheet.criteria.all else []
    return section("basis", [Facts("basis", tuple(facts)), *limits], "note_sheet")


def network_basis_section(sheet: Stated) -> Section:
    """State what lines between points are judged by, and under what."""
    site = sheet.case.site
    rows = {
        "analysis": Message("note_sheet.quasi_static"),
        "datum": Message("note_sheet.datum_is", depth=Measure("water_depth", site.depth_to_seabed)),
        "friction": Message("sizing.about", value=site.seabed_friction),
        "density": Message("sizing.measure", value=Measure("density", site.water_density)),
        "life": _life(sheet.case),
    }
    facts = (Fact(Message(f"note_sheet.{key}"), said) for key, said in rows.items())
    limits = [_limit_states(sheet)] if sheet.criteria.all else []
    return section("basis", [Facts("basis", tuple(facts)), *limits], "note_sheet")


def damaged_section(sheet: Stated) -> Section:
    """Say what comes of the loss of a line."""
    return section("damaged", [Text(_damaged(sheet))], "note_sheet")


def sheet_sections(sheet: Sheet, held: str = "") -> Iterator[Section]:
    """State parts, tolerance of the anchor's place, wear, damage and fatigue.

    `held`, a message, says what holds a line where more is known of it than the case has.
    """
    yield section("bill", _bill(sheet, held), "note_sheet")
    yield section("anchor_place", _anchor_place(sheet), "note_sheet")
    yield section("wear", _wear(sheet), "note_sheet")
    yield damaged_section(sheet)
    yield section("fatigue", [Text(Message("note_sheet.fatigue_not_asked"))], "note_sheet")


# ------------------------------------------------------------------ design basis


def _tide(levels: Sequence[float]) -> Message:
    if not any(levels):
        return Message("note_sheet.no_tide")
    low, high = (Measure("height", level) for level in (min(levels), max(levels)))
    return Message("note_sheet.tide_is", low=low, high=high)


def _life(case: Case | Network) -> Message:
    service = case.service
    if service is None:
        return Message("note_sheet.not_stated")
    years = service.life / YEAR
    if service.wear_table is not None:
        return Message("note_sheet.life_by_table", years=years, table=Cited(service.wear_table))
    return Message("note_sheet.life_is", years=years, rate=service.wear_rate * YEAR * 1e3)


def _pretension(sheet: Sheet) -> Message:
    if sheet.pretension is None:
        return Message("note_sheet.no_pretension")
    key = "of_body" if sheet.system is not None else "of_line"
    tension = Measure("tension", sheet.pretension)
    return Message(f"note_sheet.pretension_{key}", tension=tension)


def _limit_states(sheet: Stated) -> Table:
    """Tabulate criteria by limit state: state of the mooring and kind of load case."""
    kinds = {each.kind for each in sheet.report.load_cases} or {"extreme"}
    states: list[str] = [kind for kind in ("extreme", "reference") if kind in kinds]
    if sheet.judges_line_out:
        states.append("one_line_out")
    rows: list[Sequence[Cell]] = []
    for each in dict.fromkeys(sheet.criteria.all):
        found = [Message(f"note_sheet.{name}") for name in states if _is_in(name, each)]
        if found:
            of, source = each.of, each.source
            limit = (each.value, limit_quantity(each.check))
            on = Message(f"note_sheet.on_{of}") if of else ""
            by = source.text if source.document else Message("note_sheet.by_user")
            rows.append((Several(found, "; "), kind_name(each.check), limit, on, by))
    keys = (
        "note_sheet.limit_state",
        "check",
        "note_sheet.factor_or_limit",
        "note_sheet.on",
        "source",
    )
    return from_rows("limit_states", keys, rows, Message("note_sheet.limit_states"))


def _is_in(name: str, criterion: Criterion) -> bool:
    """Whether a criterion is for a limit state: a kind of load case, or one line out."""
    if name == "one_line_out":
        return name in criterion.states
    return "intact" in criterion.states and name in criterion.kinds


# ------------------------------------------------------------------ bill of materials


class _Item(NamedTuple):
    code: str
    what: str
    nominal_diameter: float | None = None
    length: float | None = None
    mass: float | None = None


def _bill(sheet: Sheet, held: str) -> Iterator[Block]:
    items, count = Rows(_items(sheet, held)), sheet.lines
    together = Rows(items.read("mass"))
    yield tabulate(
        "bill",
        texts("no", range(1, len(items.rows) + 1)),
        items.texts("note_sheet.item", "what"),
        items.texts("note_sheet.code", "code"),
        *items.own("nominal_diameter", "length"),
        texts("note_sheet.count", [count] * len(items.rows)),
        items.measured("mass", "mass", "mass_in_air", symbol=""),
        together.measured("mass", lambda mass: count * mass, "note_sheet.mass_together"),
    )
    joints = len(sheet.line.segments) + 1
    yield Text(Message("note_sheet.fittings", each=joints, every=joints * count))


def _items(sheet: Sheet, held: str) -> Iterator[_Item]:
    """Yield what one line is made of; mass in kg."""
    for segment in sheet.line.segments:
        mass = None if segment.mass is None else segment.mass * segment.length
        code, what = Cited(segment.name or segment.component), described(sheet.case, segment)
        yield _Item(code, what, segment.nominal_diameter, segment.length, mass)
    for load in sheet.line.point_loads:
        key = "clump" if load.submerged_weight > 0.0 else "float"
        yield _Item("", Message(f"note_sheet.{key}_at", place=load.position), mass=load.mass)
    if sheet.anchor is not None:
        name = {"drag": "Drag anchor", "sinker": "Sinker"}[sheet.anchor.kind]
        yield _Item(held, term(name), mass=sheet.anchor.mass)


def described(case: Case, segment: Segment) -> str:
    """Say in words what a segment is made of, as its family of the catalogue is called."""
    if not segment.component:
        return Message("note_sheet.no_component")
    from catopt.catalogue.choice import chosen

    families = chosen(case.catalogue, case.site.water_density).families
    family, grade = families.family(segment.component), families.parse_name(segment.component).grade
    return Several((family.title, Cited(grade)), " ") if grade else family.title


# ------------------------------------------------------------------ the anchor's place


def _anchor_place(sheet: Sheet) -> Iterator[Block]:
    moved = Rows(sheet.moved)
    if not moved.rows:
        yield Text(Message("note_sheet.anchor_free"))
        return
    about = "of_body" if sheet.system is not None else "of_line"
    yield Text(Message(f"note_sheet.anchor_{about}"))
    planned = max(each.fairlead.tension for each in sheet.intact)
    tensions = Rows(moved.read("tension"))
    yield tabulate(
        "anchor_place",
        moved.measured("span", "way", "note_sheet.farther"),
        moved.measured("tension", "tension", "largest_tension"),
        tensions.measured("tension", lambda tension: tension - planned, "note_sheet.change"),
        *(moved.own("offset") if sheet.system is not None else ()),
    )
    yield from (Text(each.refusal) for each in moved.rows if each.refusal)


# ------------------------------------------------------------------ wear, damage


def _wear(sheet: Sheet) -> Iterator[Block]:
    found, diameter = Rows(sheet.least), "nominal_diameter"
    if not found.rows:
        yield Text(Message("note_sheet.wear_unknown"))
        return
    yield Text(Message("note_sheet.wear_about"))
    yield tabulate(
        "wear",
        found.texts("segment"),
        found.measured(diameter, "diameter", "note_sheet.wear_new"),
        found.measured(diameter, "end_diameter", "note_sheet.wear_end"),
        found.measured(diameter, "least", "note_sheet.wear_least"),
        found.measured(diameter, "room", "note_sheet.wear_room"),
    )


def _damaged(sheet: Stated) -> Message:
    if sheet.lines == 1:
        return Message("note_sheet.damaged_one")
    if not sheet.judges_line_out:
        return Message("note_sheet.damaged_not_judged")
    states = [each for each in sheet.report.results if each.place.state != "intact"]
    worst = max(states, key=lambda each: each.excess)
    key = "damaged_passes" if all(each.passes for each in states) else "damaged_fails"
    values = {"check": worst.name, "state": worst.where, "source": worst.source.text}
    return Message(f"note_sheet.{key}", **values)
