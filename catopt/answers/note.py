"""What notes of every kind share: first page, basis, inputs, parts of a line, the whole file."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.bill import NO_PRICES, Prices, bill
from catopt.answers.blocks import (
    Block,
    Fact,
    Facts,
    Rows,
    Section,
    Table,
    Text,
    Value,
    Verdict,
    rounded,
    tabulate,
)
from catopt.answers.check import first_blocks, governing_sentence, kind_name
from catopt.answers.solution import given_tables
from catopt.answers.verification import closing_in_note, compared_in_note, lines_in_note
from catopt.checks.kinds import QUANTITY_OF, limit_quantity
from catopt.checks.verdict import verdict_of
from catopt.constants import YEAR
from catopt.quantities import QUANTITIES, Quantity
from catopt.verify.motion_words import part_sentence
from catopt.words import Cited, Measure, Message, Several, quantity_name

if TYPE_CHECKING:
    from catopt.catalogue import Component
    from catopt.checks.kinds import Criterion
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.checks.verdict import Judgement
    from catopt.model import Case, Line, Segment
    from catopt.model.network import Network
    from catopt.notes.line import Note
    from catopt.notes.origin import Origin
    from catopt.notes.sheet import AnyNote, Sheet, Stated
    from catopt.notes.system import NetworkNote, SystemNote

_PREFIX = {"note_size": "size_", "note_system": "system_"}
"""Of the keys of sections that only one kind of note has."""


# ------------------------------------------------------------------ making blocks


def section(name: str, parts: Iterable[Block], group: str = "note") -> Section:
    """Make a section of a note, whose heading is in a group of texts."""
    heading = Message(f"{group}.{name}_heading")
    return Section(heading, tuple(parts), _PREFIX.get(group, "") + name)


def note_answer(
    note: AnyNote, kind: str, sections: Iterable[Section], *, untitled: str = "", file: str = ""
) -> blocks.Answer:
    """Lay out a note of those sections in which there is something, and of its first file.

    Where all was given by options there is none. `kind` and `untitled` are keys of texts.
    """
    first = (blocks.FileText(each.name, each.sha256, each.text) for each in note.origin.files[:1])
    every = (*sections, section(file or "case_file", first))
    shown = tuple(each for each in every if each.blocks)
    title = note.case.title or Message(untitled or "captions.mooring_line")
    return blocks.Answer("note", title, shown, Message(kind), head=_head(note))


def _head(note: AnyNote) -> blocks.PageHead | None:
    """Say what every page has of the firm's document."""
    of = note.case.document
    if of is None:
        return None
    named = Message("note_first.revision_of", revision=of.present) if of.present else ""
    firm, number = ((of.client, of.project), (of.number, named))
    return blocks.PageHead(
        Several(filter(None, firm), " \u00b7 "),
        Several(filter(None, number), ", "),
        note.origin.logo,
    )


Cell = Value | tuple[Value, Quantity]
"""What stands in a row: a value, or one with its quantity where the rows have several."""


def from_rows(
    name: str, keys: Sequence[str], rows: Iterable[Sequence[Cell]], caption: str = ""
) -> Table:
    """Make a table from its rows; headings as `column_name` takes them."""
    columns = []
    laid = list(rows)
    for place, key in enumerate(keys):
        cells = [row[place] for row in laid]
        values = tuple(each[0] if isinstance(each, tuple) else each for each in cells)
        units = tuple(each[1] for each in cells if isinstance(each, tuple))
        columns.append(blocks.texts(key, values, units=units))
    return Table(name, tuple(columns), caption)


def small(key: str, **values: Value) -> Text:
    """Say how to read what is above."""
    return Text(Message(key, **values), is_small=True)


# ------------------------------------------------------------------ the first page


Number = tuple[str, str, float]
"""One of the numbers that matter: its name, the key of its quantity, its value in SI."""


def opening(
    note: AnyNote,
    facts: Sequence[tuple[str, str]],
    *said: str,
    drawing: Iterable[Block],
    force: Number,
    reach: Number,
    tension: float,
    in_motion: bool = False,
    in_storm: Sequence[Number] = (),
    moved: CheckReport | None = None,
    judgement: Judgement | None = None,
) -> Iterator[Section]:
    """Begin a note: the first page, who answers for it, and what is to be known.

    A fact is the key of what it is called, and what is said; one that says nothing is left out. The
    answer is `said` in sentences, `force` pulls, `reach` is how far the mooring lets go, `tension`
    the largest at a fairlead (N). `in_motion` says whether the lines were run in time, too,
    `in_storm` what they came to there, beside which the others are said to be at rest, and
    `moved` are the checks in motion; `judgement` goes in the place of that of the checks, in words
    of the answer's own.
    """
    sheet, report = note.sheet, note.sheet.report
    if judgement is None:
        own = verdict_of(replace(report.matter, in_motion=moved))
        words = (own.said, governing_sentence(report if moved is None else moved))
        judgement = replace(own, said=Several(filter(None, words), " "))
    largest = (Message("columns.largest_tension"), "tension", tension)
    still: list[Number] = [force, largest, _reserve(sheet)]
    if in_storm:
        still = [(Message("note_first.at_rest", name=each[0]), *each[1:]) for each in still]
    four = (*in_storm, *still[:2], reach, still[2])
    rows = [(name, (value, rounded(key, value))) for name, key, value in four]
    answer = (
        *first_blocks(report),
        *(Text(each) for each in said),
        Verdict.of_judgement(judgement),
        from_rows("four", ("page.what", "value"), rows),
        *drawing,
        blocks.Points(tuple(_not_covered(sheet, in_motion)), Message("note_first.not_covered")),
    )
    yield section("summary", answer, "note_first")
    yield section("identity", _title_block(facts, note))
    others = tuple(each for each in note.warnings if each not in report.first)
    yield section("warnings", [blocks.Warnings(others)] if others else [])


def _reserve(sheet: Stated) -> Number:
    factor = sheet.break_factor
    if factor is None or not math.isfinite(factor):
        least = min(each.grounded_length for each in sheet.intact)
        return Message("note_first.least_grounded"), "grounded_length", least
    return Message("note_first.break_factor"), "safety_factor", factor


def _not_covered(sheet: Stated, in_motion: bool) -> Iterator[str]:
    """Yield what the answer leaves out."""
    for key, is_left_out in (
        ("no_motion", not in_motion),
        ("no_criterion", not sheet.report.results),
        ("no_anchor", sheet.anchor is None),
        ("no_line_out", sheet.lines > 1 and not sheet.with_line_out),
        ("no_wear", sheet.case.service is None),
        ("never", True),
    ):
        if is_left_out:
            yield Message(f"note_first.{key}")


def _title_block(facts: Sequence[tuple[str, str]], note: AnyNote) -> Iterator[Block]:
    """Leave room for who signs, and lay out what is calculated, when, and from what."""
    origin, of = note.origin, note.case.document
    names = ["revision", "date", "changed", "prepared", "checked", "approved"]
    issues = () if of is None else of.revisions
    if not any(each.changed for each in issues):
        names.remove("changed")
    rows = [[Cited(getattr(each, name) or "\u00a0") for name in names] for each in issues]
    keys = [f"note_first.{name}" for name in names]
    yield from_rows("signed", keys, rows or [[Cited("\u00a0")] * len(keys)])
    firm = () if of is None else (("client", of.client), ("project", of.project))
    files = [Cited(f"{each.name}, SHA-256 {each.sha256}") for each in origin.files]
    every = (
        *((f"note_first.{key}", said) for key, said in firm),
        ("note_first.number", "" if of is None else of.number),
        ("note.identity_source", note.case.source),
        *facts,
        ("note.identity_date", origin.date),
        ("note.identity_version", Cited(f"catopt {origin.version}")),
        *(("note.identity_file", said) for said in files),
    )
    yield Facts("identity", tuple(Fact(Message(key), said) for key, said in every if said))


# ------------------------------------------------------------------ the case file


def case_sections(
    note: AnyNote, case: Case, line: Line, design: int | None = None
) -> Iterator[Section]:
    """Tabulate the parts of a line, and the values of its case file, in whose place is a design."""
    yield section("components", components(case, line))
    said = [Text(Message("note.inputs_about"))]
    if design is not None:
        said.append(Text(Message("note.inputs_design", number=design)))
    yield section("inputs", [*said, inputs_table(note.origin)])


def inputs_table(origin: Origin) -> Table:
    """Tabulate every value of a file, as it stands there and in SI.

    With the digits of a hand calculation; wear in mm a year, not 1e-11 m/s.
    """
    rows = []
    for each in origin.inputs:
        is_wear = each.key.rpartition(".")[2] == "wear_rate"
        si = each.si if isinstance(each.si, float) else Cited(each.si or "")
        quantity = QUANTITIES["wear_rate"] if is_wear else blocks.exact(each.unit)
        rows.append((Cited(each.key), Cited(each.given), (si, quantity)))
    return from_rows("inputs", ("study.key", "note.inputs_given", "page.si"), rows)


# ------------------------------------------------------------------ parts of a line


def components(case: Case, line: Line) -> Iterator[Block]:
    """Tabulate the parts of a line, and where each figure of those of its case comes from."""
    segments, *loads = given_tables(line)
    known = [each for each in segments.columns if any(each.values)]
    own = blocks.if_known(*Rows(line.segments).own("nominal_diameter", "proof_load"))
    yield replace(segments, columns=(*known, *own))
    yield from loads
    if any(not each.component for each in line.segments):
        yield small("note.components_own")
    parts = list(_looked_up(case))
    names = ("quantity", "value", "formula", "confidence", "source")
    for segment, component in parts:
        shown = (key for key in _SHOWN if key in component.provenance)
        rows = (_figure(key, segment, component) for key in shown)
        yield from_rows("component", names, rows, Cited(component.name))
    if parts:
        yield small("note.components_legend")
        yield _sources(component for _, component in parts)


_WET = "wet_strength_factor"
_SHOWN = {
    "mass": "mass_per_length",
    "volume_diameter": "volume_diameter",
    "MBL": "MBL",
    _WET: "coefficient",
    "proof_load": "proof_load",
    "EA": "EA",
    "price": "price",
}
"""Quantities of the catalogue that a note rests on, and what each is printed as."""
_OWN = ("mass", "MBL", "proof_load", "EA", "price")
"""Of these, what a segment of a case file may have of its own."""


def _looked_up(case: Case) -> Iterator[tuple[Segment, Component]]:
    """Look every segment's component up; segments with the same figures once."""
    from catopt.catalogue.choice import chosen

    seen = set()
    for segment in case.line.segments:
        own = (getattr(segment, each) for each in _OWN)
        key = (segment.component, segment.nominal_diameter, *own)
        if segment.component and segment.nominal_diameter is not None and key not in seen:
            seen.add(key)
            catalogue = chosen(case.catalogue, case.site.water_density)
            yield segment, catalogue.component(segment.component, segment.nominal_diameter)


def _figure(key: str, segment: Segment, component: Component) -> Sequence[Cell]:
    """Take a figure of the catalogue, or the case file's in its place, which has no source."""
    quantity, value = QUANTITIES[_SHOWN[key]], getattr(component, key)
    wet = Message("columns.strength_in_water_over_dry")
    name = wet if key == _WET else quantity_name(quantity.key)
    own = getattr(segment, key) if key in _OWN else None
    expected = component.MBL_in_water if key == "MBL" else value
    if own is not None and expected is not None and not math.isclose(own, expected, rel_tol=1e-12):
        return name, (own, quantity), "", "", Message("checks.case_file")
    origin = component.provenance[key]
    source = Cited(f"{', '.join(source.key for source in origin.sources)}: {origin.place}")
    return name, (value, quantity), origin.formula, origin.confidence, source


def _sources(components: Iterable[Component]) -> Table:
    """List the documents that the shown figures of components rest on, by their keys."""
    found = {
        source.key: f"{source.title}{f'. {source.place}' if source.place else ''}"
        for component in components
        for key, origin in component.provenance.items()
        if key in _SHOWN
        for source in origin.sources
    }
    rows = [(Cited(key), Cited(title)) for key, title in sorted(found.items())]
    return from_rows("sources", ("source", "title"), rows)


# ------------------------------------------------------------------ the truss model


def by_both(
    note: Note | NetworkNote | SystemNote, group: str, loaded: int | None = None
) -> Iterator[Block]:
    """Lay a line, or a body with its most loaded line, out by both models, in texts of a group.

    That there is no answer is said; there is nothing where the truss model was left out.
    """
    if note.verification_failure:
        yield Verdict(Message(f"{group}.verification_no_answer"), passes=False)
        yield Text(note.verification_failure)
    if note.verification is None:
        return
    part = note.verification.static
    yield Text(Message(f"{group}.verification_about"))
    yield Verdict(part_sentence(part), part.is_settled)
    captions: dict[int | None, str] = {None: ""}
    if loaded is not None:
        own = Message(f"{group}.verification_line", line=loaded + 1)
        captions = {None: Message(f"{group}.verification_body"), loaded: own}
    for line, caption in captions.items():
        found = [each for each in part.quantities if loaded is None or each.line == line]
        yield compared_in_note(found, caption)
    if loaded is not None:
        yield lines_in_note(part, Message(f"{group}.verification_lines"))
    yield from closing_in_note(part)
    yield small(f"{group}.verification_legend")


def basis_section(
    sheet: Sheet,
    combined: str = "",
    return_period: str = "",
    levels: Sequence[float] | None = None,
    *,
    analysis: str = "",
) -> Section:
    """State what the mooring is judged by, and under what.

    `combined`, a message, says how wind, current and waves are combined (as the user gave the force
    when empty), `return_period` is theirs (not stated when empty); `levels` are water levels in m,
    of the load cases when left out; `analysis` is at rest alone when empty.
    """
    if levels is None:
        levels = [each.water_level for each in sheet.report.load_cases]
    height = sheet.case.site.height_above_seabed(sheet.case.fairlead_height)
    own = {
        "return_period": return_period or Message("note_sheet.not_stated"),
        "combination": combined or Message("note_sheet.combined_by_user"),
        "tide": _tide(levels),
        "fairlead": Message("sizing.measure", value=Measure("height", height)),
        "pretension": _pretension(sheet),
    }
    return stated_section(sheet, own, analysis)


_BASIS = "analysis return_period combination datum tide fairlead friction density life pretension"
"""What may be stated of a mooring, in its order on the page."""


def stated_section(sheet: Stated, own: Mapping[str, str], analysis: str = "") -> Section:
    """State what is known of any mooring, lines between points, too, and what is `own` to one."""
    site = sheet.case.site
    known = {
        **own,
        "analysis": analysis or Message("note_sheet.quasi_static"),
        "datum": Message("note_sheet.datum_is", depth=Measure("water_depth", site.depth_to_seabed)),
        "friction": Message("sizing.about", value=site.seabed_friction),
        "density": Message("sizing.measure", value=Measure("density", site.water_density)),
        "life": _life(sheet.case),
    }
    facts = (
        Fact(Message(f"note_sheet.{key}"), known[key]) for key in _BASIS.split() if key in known
    )
    limits = [_limit_states(sheet)] if sheet.criteria.all or sheet.report.results else []
    return section("basis", [Facts("basis", tuple(facts)), *limits], "note_sheet")


def damaged_section(sheet: Stated) -> Section:
    """Say what comes of the loss of a line."""
    return section("damaged", [Text(_damaged(sheet))], "note_sheet")


def sheet_sections(sheet: Sheet, held: str = "", prices: Prices = NO_PRICES) -> Iterator[Section]:
    """State parts, tolerance of the anchor's place, wear, damage and fatigue.

    `held`, a message, says what holds a line where more is known of it than the case has.
    """
    yield section("bill", bill(sheet, held, prices), "note_sheet")
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
    tension = Measure("tension", sheet.pretension)
    return Message(f"note_sheet.pretension_of_{sheet.about}", tension=tension)


def _limit_states(sheet: Stated) -> Table:
    """Tabulate criteria by limit state: state of the mooring and kind of load case."""
    kinds = {each.kind for each in sheet.report.load_cases} or {"extreme"}
    states: list[str] = [kind for kind in ("extreme", "reference") if kind in kinds]
    if sheet.with_line_out:
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
    rows += _own_limits(sheet, states[0])
    keys = (
        "note_sheet.limit_state",
        "check",
        "note_sheet.factor_or_limit",
        "note_sheet.on",
        "source",
    )
    return from_rows("limit_states", keys, rows, Message("note_sheet.limit_states"))


def _own_limits(sheet: Stated, intact: str) -> Iterator[Sequence[Cell]]:
    """Yield what counts beside the criteria: a reserve of each body, and that there is a rest."""
    known = {each.check for each in sheet.criteria.all}
    states: dict[CheckResult, dict[str, None]] = {}
    for each in sheet.report.results:
        if each.kind not in known:
            name = intact if each.place.state == "intact" else "one_line_out"
            alike = (of for of in states if of.name == each.name)
            states.setdefault(next(alike, each), {})[name] = None
    for each, names in states.items():
        found = Several((Message(f"note_sheet.{name}") for name in names), "; ")
        kind, quantity = kind_name(each.kind), QUANTITY_OF[each.kind]
        if each.kind == "equilibrium":
            yield found, kind, (None, quantity), "", ""
            continue
        by = each.source.text if each.source.document else Message("note_sheet.by_user")
        yield found, kind, (each.capacity, quantity), each.name, by


def _is_in(name: str, criterion: Criterion) -> bool:
    """Whether a criterion is for a limit state: a kind of load case, or one line out."""
    if name == "one_line_out":
        return name in criterion.states
    return "intact" in criterion.states and name in criterion.kinds


# ------------------------------------------------------------------ the anchor's place


def _anchor_place(sheet: Sheet) -> Iterator[Block]:
    moved = Rows(sheet.moved)
    if not moved.rows:
        yield Text(Message("note_sheet.anchor_free"))
        return
    yield Text(Message(f"note_sheet.anchor_of_{sheet.about}"))
    planned = max(each.fairlead.tension for each in sheet.intact)
    tensions = Rows(moved.read("tension"))
    yield tabulate(
        "anchor_place",
        moved.measured("span", "way", "note_sheet.farther"),
        moved.measured("tension", "tension", "largest_tension"),
        tensions.measured("tension", lambda tension: tension - planned, "note_sheet.change"),
        *blocks.if_known(*moved.own("offset")),
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
        found.measured(diameter, "limit", "note_sheet.wear_limit"),
        found.texts("note_sheet.wear_by", "reason"),
        found.measured(diameter, "room", "note_sheet.wear_room"),
    )


def _damaged(sheet: Stated) -> Message:
    if sheet.lines == 1:
        return Message("note_sheet.damaged_one")
    worst = sheet.nearest_with_line_out
    if worst is None:
        return Message("note_sheet.damaged_not_judged")
    passes = all(each.passes for each in sheet.with_line_out)
    key = "damaged_passes" if passes else "damaged_fails"
    values = {"check": worst.name, "state": worst.where, "source": worst.source.text}
    return Message(f"note_sheet.{key}", **values)
