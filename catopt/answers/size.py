"""What the sizing of a buoy's or a tanker's mooring consists of."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, largest, named, section, tabulate, texts
from catopt.answers.check import (
    check_columns,
    kind_name,
    motion_table,
    tightest_table,
    verdict_column,
)
from catopt.answers.loads import forces_table, notes_table, numbers_table
from catopt.answers.size_card import (
    counted_words,
    heel_words,
    proof_words,
    runs_words,
    size_card,
    slides_words,
)
from catopt.constants import YEAR
from catopt.figures.sizing import tension_by_length
from catopt.model.line import weight_in_water
from catopt.quantities import QUANTITIES, Quantity
from catopt.units import UNITS, Dimension
from catopt.words import Cited, Measure, Message, Sentence, Several, term

if TYPE_CHECKING:
    from catopt.loads.sinker import SinkerSize
    from catopt.model import Line
    from catopt.sizing import Sizing
    from catopt.sizing.floating import FloatsInStorm
    from catopt.sizing.in_motion import InMotion
    from catopt.sizing.maintenance import Upkeep
    from catopt.sizing.pattern import Pattern, PatternState

_FORCE = named("horizontal_force", "")
_HEIGHT = Quantity("length", "Height", "", "m", "m", 1.0, 2)
_YEARS = Quantity("time", "Life", "", "s", "years", YEAR, 1)
_PERIOD = Quantity("time", "Time", "", "s", "s", 1.0, 2)


class _Row(NamedTuple):
    """What was found: its name, its value in SI, and how it is said beside it."""

    name: str
    value: float | None
    quantity: Quantity
    words: str = ""


def size_answer(of: Sizing) -> blocks.Answer:
    """Lay out a sizing."""
    own = tuple(k for k, each in enumerate(of.inputs) if each.origin != "taken")
    why = blocks.Text(Several((*_governing(of), of.why), "\n"), term("What governs"))
    checks = blocks.Table("checks", check_columns(of.point.checks.results), only="files")
    answer = answered(
        "size",
        of.case.title,
        section(
            term("Sizing"),
            blocks.Text(of.one_line),
            blocks.Verdict.of_judgement(of.judgement),
            *map(blocks.Text, _beside(of)),
            summary_table(of),
            why,
            *([alternatives_table(of)] if of.alternatives or of.in_motion is None else []),
        ),
        *([] if of.in_motion is None else [_run_afloat(of.in_motion)]),
        *([section(term("Candidates"), candidates_table(of))] if of.candidates else []),
        section("captions.checks", tightest_table(of.point.checks), checks),
        *(
            []
            if of.pattern is None
            else [section(term("Pattern"), pattern_table(of.pattern), without_line_table(of))]
        ),
        *([] if of.upkeep is None else [section("sizing.upkeep", *upkeep_blocks(of.upkeep))]),
        section(term("Forces"), *_forces(of)),
        section("columns.numbers", _stacked(of, "numbers", numbers_table)),
        section(term("Notes"), _notes_table(of), *_notes(of)),
        *([section("sizing.inputs", replace(read_table(of), shown=own))] if of.inputs else []),
    )
    return replace(answer, card=size_card(of))


def read_table(of: Sizing) -> blocks.Table:
    """Tabulate every input as it was read."""
    read = Rows(of.inputs)
    return tabulate(
        "inputs",
        read.texts("input", "name"),
        read.texts("value", "said"),
        read.texts("origin", "from_where"),
        caption=Message("sizing.inputs"),
    )


# ------------------------------------------------------------------ what was found


def motion_sentence(of: Sizing) -> Message:
    """Say what stands for motion, and where that is from."""
    if of.in_motion is not None:
        return Message("sizing.in_runs", source=of.motion)
    if of.dynamic_factor == 1.0:
        return Message("sizing.no_motion", source=of.motion)
    return Message("sizing.motion", factor=of.dynamic_factor, source=of.motion)


def _beside(of: Sizing) -> Iterator[str]:
    """Yield what goes with the line: what stands for motion, practice, its life, its fittings."""
    yield motion_sentence(of)
    if of.practice:
        yield Sentence(of.practice, capital=True)
    if of.chain_life is not None:
        yield Message("sizing.life", years=of.chain_life / YEAR)
    yield from of.fittings


def summary_table(of: Sizing) -> blocks.Table:
    """Tabulate what was found; people see what is said in words."""
    rows = [*_line(of), *_holding(of), *_positions(of), *_forces_found(of), *_pattern_found(of)]
    found = Rows(rows)
    return tabulate(
        "sizing",
        found.texts("what", "name"),
        found.texts("value", units=tuple(found.read("quantity")), only="files"),
        found.texts("in_words", "words"),
        caption=Message("captions.recommended"),
        shown=tuple(index for index, row in enumerate(rows) if row.words),
    )


def _measured(name: str, key: str, value: float) -> _Row:
    """Make a row of a value that is said with its unit alone."""
    said = Message("sizing.measure", value=Measure(key, value))
    return _Row(term(name), value, QUANTITIES[key], said)


def _line(of: Sizing) -> Iterator[_Row]:
    line = of.point.line
    length, mass = QUANTITIES["length"], QUANTITIES["mass"]
    shots = replace(length, field_unit="shots", factor=UNITS[Dimension.LENGTH]["shot"])
    values = {"component": line.segments[0].name, "length": line.length, "shots": of.shots}
    chain = Message("sizing.chain", **values)
    diameter = line.segments[0].nominal_diameter
    yield _Row(term("Chain"), diameter, QUANTITIES["nominal_diameter"], chain)
    yield _Row(term("Length"), line.length, length)
    yield _Row(term("Length in shots"), line.length, shots)
    if line.mass is not None:
        yield _measured("Mass of the line in air", "mass", line.mass)
    if of.cost is not None:
        yield _measured("Price of the line, material", "cost", of.cost)
    for load in line.point_loads:
        tonnes = None if load.mass is None else load.mass / 1e3
        words = Message("sizing.clump", mass=tonnes, position=load.position)
        yield _Row(Message("columns.clump_weight"), load.mass, mass, words)


def _holding(of: Sizing) -> Iterator[_Row]:
    size = of.drag_anchor or of.sinker
    if size is None:
        return
    anchor = of.point.anchor
    mass = (None if anchor is None else anchor.mass) or size.mass
    values: dict[str, blocks.Value] = {"mass": mass / 1e3, "needed": size.needed_mass / 1e3}
    if of.drag_anchor is not None:
        values |= {"anchor": of.drag_anchor.anchor, "soil": term(of.drag_anchor.soil)}
        name, words = term("Drag anchor"), Message("sizing.drag_anchor", **values)
    else:
        sinker = of.own_sinker
        assert sinker is not None
        values |= {"side": sinker.side, "height": sinker.height}
        words = Message(f"sizing.{sinker.material}_sinker", **values)
        name = term("Sinker")
    yield _Row(name, mass, QUANTITIES["mass"], words)
    if of.lift is not None and of.own_sinker is not None:
        yield _lifting(of.lift, of.own_sinker, of.point.line, of.case.site.water_density)
    other = of.other_sinker
    if other is not None:  # by the other rule: they differ by a factor of two and more
        said = Message(
            "sizing.other_sinker",
            rule=Cited(other.rule),
            mass=other.mass / 1e3,
            friction=other.friction,
        )
        yield _Row(Message("sizing.by_other_rule"), other.mass, QUANTITIES["mass"], said)
    if size.factor is not None:
        wanted = Message("sizing.factor", factor=size.factor, wanted=size.safety_factor)
        yield _Row(term("Factor on holding"), size.factor, QUANTITIES["safety_factor"], wanted)


def _lifting(mass: float, sinker: SinkerSize, line: Line, water_density: float) -> _Row:
    """Say what a tender lifts: the sinker with all of its chain, kg in air."""
    hung = weight_in_water(sinker.mass, sinker.density, water_density)
    hung += math.fsum(each.length * each.submerged_weight for each in line.segments)
    said = Message("sizing.lifted", mass=mass / 1e3, weight=Measure("vertical_force", hung))
    return _Row(Message("sizing.lifting"), mass, QUANTITIES["mass"], said)


def _positions(of: Sizing) -> Iterator[_Row]:
    total, length = of.swing.total, QUANTITIES["length"]
    words = Message("sizing.swing", total=total)
    if len(of.swing.parts) > 1:
        parts = (
            Message("sizing.swing_part", name=name, length=part) for name, part in of.swing.parts
        )
        words = Message("sizing.swing_of", total=total, parts=Several(parts, " + "))
    name = term("Swing radius at low water")
    if of.pattern is not None:
        name = Message("sizing.card_swing_line_out")
    yield _Row(name, total, length, words)
    if of.excursion is not None:
        yield _measured("Excursion", "excursion", of.excursion)


def _forces_found(of: Sizing) -> Iterator[_Row]:
    load_case, solution = of.hardest
    for name, key, force in (
        ("Horizontal force on the line", "horizontal_force", solution.horizontal_force),
        ("Tension at the fairlead", "tension", solution.fairlead.tension),
    ):
        words = Message("sizing.force_in", force=Measure(key, force), load_case=load_case)
        yield _Row(term(name), force, QUANTITIES[key], words)
    for name, factor in (
        ("MBL over tension, new", of.break_factor),
        ("Proof load over tension, new", of.proof_factor),
    ):
        if factor is not None:
            yield _measured(name, "safety_factor", factor)
    pull = max(each.fairlead.vertical_force for _, each in of.intact)
    yield _measured("Pull down at the fairlead", "vertical_force", pull)
    if of.reserve_buoyancy is not None:
        yield _measured("Reserve buoyancy", "vertical_force", of.reserve_buoyancy)
    if of.floats is not None:
        yield from _floating(of.floats)


def _floating(of: FloatsInStorm) -> Iterator[_Row]:
    """Yield draught and freeboard under the line's pull, and the heel under steady forces."""
    values = {"draught": of.draught, "freeboard": of.freeboard, "least": of.least_freeboard}
    said = Message("sizing.floats", load_case=of.load_case, **values)
    yield _Row(Message("sizing.draught"), of.draught, QUANTITIES["length"], said)
    if of.heel is not None and of.edge_freeboard is not None:
        heel = math.degrees(of.heel)
        said = Message("sizing.heel_at_rest", heel=heel, edge=of.edge_freeboard, rise=of.run_up)
        yield _Row(Message("sizing.steady_heel"), of.heel, QUANTITIES["angle"], said)


def _pattern_found(of: Sizing) -> Iterator[_Row]:
    found = of.pattern
    if found is None:
        return
    count = QUANTITIES["coefficient"]
    yield _Row(term("Lines, evenly spaced"), found.lines, count, f"{found.lines}")
    yield _measured("Anchor radius", "length", found.anchor_radius)
    yield _measured("Pretension, horizontal", "horizontal_force", found.pretension)
    hardest = found.hardest
    if hardest.rule_force is not None:
        yield _measured("Most loaded line by S4's rule", "horizontal_force", hardest.rule_force)
    yield _measured("Most loaded line in equilibrium", "horizontal_force", hardest.line_force)
    yield _measured("Pull of all lines on the body", "vertical_force", found.largest_pull)


def _governing(of: Sizing) -> Iterator[Message]:
    """Say what each step to less runs into, and which check is nearest to its limit."""
    for each in of.limits:
        yield Message("sizing.step_fails", change=each.change, check=each.words)
    still, moved = of.point.governing, of.in_motion
    for key, governing in (
        ("nearest" if moved is None else "nearest_at_rest", still),
        ("moved_nearest", None if moved is None else moved.checks.governing),
    ):
        if governing is not None and governing.utilisation is not None:
            values = {"check": governing.in_case, "used": governing.utilisation}
            yield Message(f"sizing.{key}", **values)


def alternatives_table(of: Sizing) -> blocks.Table:
    """Tabulate what another preference would recommend, and what it gives for what."""
    every, points = Rows(of.alternatives), Rows(Rows(of.alternatives).read("settled.point"))
    return tabulate(
        "alternatives",
        every.texts("which", lambda each: term(each.prefer)),
        points.texts("chain", lambda point: point.line.segments[0].name),
        points.measured("length", "line.length"),
        points.measured("mass", "line.mass", "mass_in_air", symbol=""),
        *(every.own("cost") if of.cost is not None else ()),
        every.texts("verdict", lambda each: each.trade or each.reason),
        caption=Message("sizing.alternatives"),
    )


def candidates_table(of: Sizing) -> blocks.Table:
    """Tabulate the recommended size between its neighbours."""
    every, points = Rows(of.candidates), Rows(Rows(of.candidates).read("settled.point"))
    verdicts = (
        each.reason
        if each.settled is None
        else Message("sizing.passes", check=each.settled.point.checks.nearest)
        for each in of.candidates
    )
    return tabulate(
        "candidates",
        every.texts("which", lambda each: term(each.role)),
        every.texts("chain", lambda each: f"{each.component} {each.diameter * 1e3:g} mm"),
        points.measured("length", "line.length"),
        points.measured("mass", "line.mass", "mass_in_air", symbol=""),
        points.measured("offset", "largest_span", "largest_span", symbol="S"),
        points.measured("mass", "anchor.mass", "anchor_mass_in_air", symbol=""),
        texts("verdict", verdicts),
        caption=Message("captions.candidates"),
    )


def upkeep_blocks(of: Upkeep) -> tuple[blocks.Block, ...]:
    """Tabulate a chain by zone, say how often to look at it, and what it costs."""
    zones = Rows(of.zones)
    table = tabulate(
        "zones",
        zones.texts("sizing.zone", lambda each: Message(f"sizing.zone_{each.name}")),
        zones.measured("length", "start", "sizing.zone_from", symbol=""),
        zones.measured("length", "end", "sizing.zone_to", symbol=""),
        zones.measured("nominal_diameter", "diameter"),
        zones.measured("wear_rate", "wear_rate"),
        zones.measured("nominal_diameter", "limit", "sizing.zone_limit", symbol=""),
        zones.measured(_YEARS, "life", "sizing.zone_life"),
        zones.measured(_YEARS, "shortest_life", "sizing.zone_shortest"),
        zones.measured(_YEARS, "longest_life", "sizing.zone_longest", priority=1),
        caption=Message("sizing.upkeep"),
    )
    said = [Message("sizing.zone_rates")]
    if of.inspection is not None:
        said.append(Message("sizing.inspection", years=of.inspection / YEAR))
    if of.passes_by_zone is not None:
        passes = "passes" if of.passes_by_zone else "fails"
        said.append(Message(f"sizing.by_zone_{passes}"))
    if of.cost is not None:
        keys = ("chain", "sinker", "fittings", "visit", "renewals", "renewed", "total")
        values = {key: getattr(of.cost, key) for key in keys}
        said.append(Message("sizing.whole_cost", years=of.cost.duration / YEAR, **values))
    return (table, *map(blocks.Text, said))


def _run_afloat(of: InMotion) -> blocks.Section:
    """Say how lines were run, what the recommended one came to, and which were tried."""
    return section(
        "captions.checks_in_motion",
        tightest_table(of.checks),
        replace(checks_of(of), only="files"),
        *tried_blocks(of),
        blocks.Warnings(of.checks.warnings, "people"),
    )


def checks_of(of: InMotion) -> blocks.Table:
    """Tabulate every check of the recommended line in motion."""
    report = of.checks
    lines = {each.place.line for each in report.results}
    every = tuple(range(len(report.results)))
    return motion_table("checks_in_motion", report, every, of_a_body=len(lines) > 1)


def tried_blocks(of: InMotion) -> tuple[blocks.Block, ...]:
    """Say how lines were run, and tabulate them."""
    lines = (*of.fast, *of.tried)
    every = Rows(lines)
    tried = tabulate(
        "lines_in_motion",
        every.texts("chain", lambda each: f"{each.component} {each.diameter * 1e3:g} mm"),
        every.measured("length", "length"),
        every.measured("mass", "mass", "mass_in_air", symbol=""),
        every.texts("runs"),
        verdict_column(each.passes for each in lines),
        every.texts("fails", "words"),
        caption=Message(f"sizing.{'ship_' if of.is_of_ship else ''}lines_tried"),
    )
    heels = (Sentence(each, capital=True) for each in (*heel_words(of), *slides_words(of)))
    proof = proof_words(of)
    proven = () if proof is None else (Sentence(proof, capital=True),)
    said = map(blocks.Text, (runs_words(of), counted_words(of), *proven, *heels))
    seas = [_seas(of)] if of.seas else []
    return (*said, tried, *seas, *(_by_length(of) if of.by_length else ()))


def _seas(of: InMotion) -> blocks.Table:
    """Tabulate which of several seas decides each kind of check."""
    seas, checks = Rows(of.seas), Rows(each.check for each in of.seas)
    return tabulate(
        "seas",
        checks.texts("check", lambda each: kind_name(each.kind)),
        seas.measured(_HEIGHT, "height", "sizing.significant_height"),
        seas.measured(_PERIOD, "period", "sizing.peak_period"),
        checks.texts("load_case", "where"),
        *checks.own("utilisation"),
        verdict_column(checks.read("passes")),
        caption=Message("sizing.seas_that_decide"),
    )


def _by_length(of: InMotion) -> tuple[blocks.Block, ...]:
    """Draw and tabulate the tension in the storm by the length of the line."""
    every = Rows(of.by_length)
    storm = Rows(every.read("storm"))
    table = tabulate(
        "by_length",
        every.measured("length", "tried.length"),
        every.measured("mass", "tried.mass", "mass_in_air", symbol=""),
        storm.measured("tension", "at_rest", "sizing.length_at_rest", symbol=""),
        storm.measured("tension", "tension", "sizing.length_in_storm", symbol=""),
        storm.measured("tension", "low", "sizing.length_low", symbol=""),
        storm.measured("tension", "high", "sizing.length_high", symbol=""),
        every.measured("mass", "sinker", "sizing.length_sinker", symbol=""),
        verdict_column(each.tried.passes for each in of.by_length),
        every.texts("fails", "tried.words"),
        caption=Message("sizing.by_length"),
    )
    drawn = blocks.Figure(tension_by_length(of))
    return blocks.Text(Message("sizing.by_length_about")), drawn, table


def pattern_table(of: Pattern) -> blocks.Table:
    """Tabulate the body on its lines in each load case."""
    states = Rows(of.states)
    return tabulate(
        "pattern",
        states.texts("load_case"),
        states.measured(_FORCE, "force", "force_on_the_body"),
        states.measured(_FORCE, "rule_force", "most_loaded_line_by_rule"),
        *_most_loaded(states),
        *_where(states, "force_off_that_line"),
        caption=Message("captions.pattern"),
    )


def without_line_table(of: Sizing) -> blocks.Table:
    """Tabulate the body of several lines with the worst of them gone, in each load case."""
    assert of.pattern is not None
    states = Rows(of.pattern.states)
    gone = Rows(states.read("line_out"))
    of_lines = [each for each in of.point.checks.results if each.kind == "tension"]

    def tension_used(state: PatternState) -> float | None:
        name = Message("sizing.one_line_out", load_case=state.load_case)
        return largest(each.utilisation for each in of_lines if each.load_case == name)

    return tabulate(
        "pattern_line_out",
        states.texts("load_case"),
        gone.texts("line_out", "missing"),
        *_most_loaded(gone),
        states.measured("utilisation", tension_used, symbol=""),
        *_where(gone, "force_off_line_1"),
        caption=Message("captions.pattern_line_out"),
    )


def _most_loaded(of: Rows) -> Iterator[blocks.Column]:
    yield of.measured(_FORCE, "line_force", "most_loaded_line")
    yield of.measured(_FORCE, "tension", "its_tension")


def _where(of: Rows, off: str) -> Iterator[blocks.Column]:
    yield of.measured("angle", "direction", off, symbol="", priority=2)
    yield of.measured("offset", "offset", "largest_offset_of_the_body", symbol="")
    yield of.measured(_FORCE, "pull", "pull_of_all_lines", priority=1)


# ------------------------------------------------------------------ loads and notes


def _forces(of: Sizing) -> Iterator[blocks.Block]:
    """Tabulate the forces of every load case, by load case for people."""
    every = of.settled.posed.loads
    if not every[0].parts:
        cases = Rows(every)
        given = cases.measured("horizontal_force", "given", "force_f_given", symbol="")
        yield tabulate("forces", cases.texts("load_case"), given, caption=term("Loads"))
        return
    table = _stacked(of, "forces", forces_table)
    of_rows = table.columns[0].values
    parts = []
    for each in every:
        force = Measure("horizontal_force", each.horizontal_force)
        methods = " + ".join(part.method for part in each.parts)
        values = {"load_case": each.load_case, "force": force, "methods": methods}
        rows = tuple(k for k, name in enumerate(of_rows) if name == each.load_case)
        parts.append((Message("captions.loads_in", **values), rows))
    yield replace(table, parts=tuple(parts))
    yield blocks.Text(Message("answers.confidence"), only="people")


def _stacked(of: Sizing, name: str, table_of: Callable[..., blocks.Table]) -> blocks.Table:
    """Stack a table of every part of every load case, with load case and part in front.

    It has no rows where the force was given.
    """
    parts = [(each.load_case, part) for each in of.settled.posed.loads for part in each.parts]
    tables, none = [table_of(part) for _, part in parts], table_of()
    rows = [place for place, table in zip(parts, tables, strict=True) for _ in range(table.length)]
    return tabulate(
        name,
        texts("load_case", (load_case for load_case, _ in rows), only="files"),
        texts("on", (part.title for _, part in rows), only="files"),
        *blocks.stacked((none, *tables)),
        only=none.only,
    )


def _notes_table(of: Sizing) -> blocks.Table:
    kinds = {
        "governs": _governing(of),
        "practice": filter(None, (of.practice,)),
        "departs from the code": of.departures,
        "fitting": of.fittings,
        "advice": of.advice,
        "recommendation": (of.why,),
        "assumption": of.assumptions,
        "taken, not given": of.defaults,
        "recalled (R)": of.recalled,
        "warning": of.warnings,
    }
    rows = [(term(kind), said) for kind, every in kinds.items() for said in every]
    for each in of.settled.posed.loads:
        kind = Message("sizing.note_in", load_case=each.load_case, kind=term("assumption"))
        rows += [(kind, said) for part in each.parts for said in part.assumptions]
    return notes_table(rows)


def _notes(of: Sizing) -> Iterator[blocks.Block]:
    for said in (*of.advice, *of.assumptions):
        yield blocks.Text(said, only="people")
    if of.defaults:
        yield blocks.Text(Message("sizing.taken", items=Several(of.defaults)), only="people")
    warnings = list(of.warnings)
    if of.recalled:
        warnings.append(Message("loads.recalled", names=Several(of.recalled, ", ")))
    yield blocks.Warnings(tuple(warnings), "people")
