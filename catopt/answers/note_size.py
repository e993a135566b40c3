"""What the note of a sizing consists of."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Points,
    Section,
    Step,
    Table,
    Text,
    Trail,
    Value,
    exact,
    measured,
    texts,
)
from catopt.answers.note import (
    column,
    components_section,
    file_section,
    inputs_table,
    note_section,
)
from catopt.answers.note_first import FirstPage, Number, opening
from catopt.answers.note_hold import hold_blocks, what_holds
from catopt.answers.note_line import drawn, of_the_front, of_the_line
from catopt.answers.note_sheet import basis_section, described, sheet_sections
from catopt.answers.note_system import near_blocks, plan_blocks
from catopt.answers.size import (
    alternatives_table,
    candidates_table,
    pattern_table,
    read_table,
    steady_sentence,
    without_line_table,
)
from catopt.checks.kinds import QUANTITY_OF
from catopt.constants import STANDARD_GRAVITY, YEAR
from catopt.quantities import GREEK, QUANTITIES, Quantity
from catopt.words import Cited, Measure, Message, Several, Told, say, term

if TYPE_CHECKING:
    from catopt.loads.component import LoadComponent, Loads
    from catopt.mooring.solution import SystemSolution
    from catopt.notes.size import SizeNote
    from catopt.sizing.pattern import Pattern
    from catopt.sizing.posed import LoadsAt

_DIGITS = 5
"""Of the numbers of loads: more than any of them is known to."""

_FORCE = replace(QUANTITIES["horizontal_force"], symbol="")


def size_note_answer(note: SizeNote) -> Answer:
    """Lay out the note of a sizing."""
    line = note.line
    return Answer(
        "note",
        note.title or Message("note.untitled"),
        (
            *opening(_first(note), note.sheet, _facts(note), note.origin, note.warnings),
            basis_section(note.sheet, *_combined(note), _levels(note)),
            _section("identity", _identity(note)),
            _section("loads", _loads(note)),
            _section("candidates", _candidates(note)),
            *_if_any("front", _front(note)),
            *of_the_line(line, "checks", "load_cases"),
            *sheet_sections(note.sheet, what_holds(note)),
            *_if_any("hold", hold_blocks(note)),
            _section("swing", _swing(note)),
            *_if_any("pattern", _pattern(note)),
            _section("assumptions", _assumptions(note)),
            _section("inputs", _inputs(note)),
            *of_the_line(line, "results", "tension", "curve"),
            components_section(line.case, line.solution.line),
            *of_the_line(line, "equations", "verification", "swarm"),
            *file_section(note.origin, "size_file", "note_size.file_heading"),
        ),
        Message("note_size.kind_size"),
    )


def _section(name: str, blocks: Iterable[Block]) -> Section:
    return note_section(f"size_{name}", blocks, f"note_size.{name}_heading")


def _if_any(name: str, blocks: Iterable[Block]) -> Iterator[Section]:
    section = _section(name, blocks)
    if section.blocks:
        yield section


# ------------------------------------------------------------------ what is recommended


def _first(note: SizeNote) -> FirstPage:
    of = note.sizing
    return FirstPage(
        _recommendation(note),
        drawn(note.line),
        Number(Message("note_size.identity_force"), "horizontal_force", _hardest(note)[0]),
        Number(Message("note_size.identity_radius"), "length", of.swing.total),
        of.largest_tension,
        also=(steady_sentence(of),),
        reserve=_fails_in_motion(note),
    )


def _fails_in_motion(note: SizeNote) -> str:
    """Name the checks that fail with the allowance for motion; empty where none does."""
    of = note.sizing
    kinds = [kind for kind, used in of.in_motion.items() if used > 1.0]
    names = [
        *(Message(f"checks.{kind}_in_motion") for kind in kinds),
        *(each.name for each in of.fails_in_motion),
    ]
    if not names:
        return ""
    return Message("sizing.fails_beyond", factor=of.dynamic_factor, names=Several(names))


def _facts(note: SizeNote) -> tuple[tuple[str, str], ...]:
    return (("note.identity_source", note.line.case.source),)


def _combined(note: SizeNote) -> tuple[str, str]:
    """Say how the loads are combined, and how often they return, where that is known."""
    has_parts = any(each.parts for each in note.sizing.settled.posed.loads)
    years = {each.of.name: each.value for each in note.sizing.inputs}.get("return_period")
    combined = Message("note_sheet.combined_at_once") if has_parts else ""
    if years is None:
        return combined, ""
    return combined, Message("note_sheet.return_period_is", years=years / YEAR)


def _levels(note: SizeNote) -> tuple[float, ...]:
    """Water levels above that of the depth, m; those of load cases go with the draught, too."""
    still = note.sheet.case.site.water_depth
    return tuple(each.depth - still for each in note.sizing.settled.posed.loads)


def _hardest(note: SizeNote) -> tuple[float, str]:
    """Return the largest horizontal force on a line, N, and its load case."""
    return max(
        ((each.horizontal_force, at) for at, each in note.sizing.intact),
        key=lambda found: found[0],
    )


def _identity(note: SizeNote) -> Iterator[Block]:
    governs = []
    for each in note.sizing.limits:
        values = {"change": each.change, "check": each.words}
        governs.append(Message("note_size.identity_step", **values))
    caption = Message("note_size.identity_governs")
    yield Points(tuple(governs), caption)
    yield _found(note)


def _recommendation(note: SizeNote) -> Message:
    """Say what is recommended in a sentence."""
    of = note.sizing
    line, pattern = of.point.line, of.pattern
    first = line.segments[0]
    code = first.name or first.component
    weights = Several(
        (
            Message("note_size.identity_weight", mass=f"{load.mass / 1e3:g}", place=load.position)
            for load in line.point_loads
            if load.mass is not None
        ),
        "",
    )
    values = {
        "chain": Told({"en": code, "vi": f"{code} ({say(described(of.case, first), 'vi')})"}),
        "length": f"{line.length:g}",
        "shots": f"{of.shots:.2f}",
        "weights": weights,
        "held": what_holds(note) or "-",
        "swing": f"{of.swing.total:.1f}",
    }
    if pattern is None:
        return Message("note_size.identity_one", **values)
    return Message("note_size.identity_several", lines=pattern.lines, **values)


def _found(note: SizeNote) -> Table:
    """Tabulate what came out, each with the load case that it is of."""
    rows = list(_found_rows(note))
    return Table(
        "size_found",
        (
            texts("what", (name for name, *_ in rows)),
            Column(
                Message("columns.value"),
                tuple(value for _, _, value, _ in rows),
                units=tuple(quantity for _, quantity, _, _ in rows),
            ),
            texts("load_case", (term(at) for *_, at in rows)),
        ),
    )


def _found_rows(note: SizeNote) -> Iterator[tuple[str, Quantity, float | None, str]]:
    of = note.sizing
    line, (name, solution) = of.point.line, of.hardest
    length, force, mass, factor = (
        QUANTITIES[key] for key in ("length", "tension", "mass", "safety_factor")
    )
    diameter = QUANTITIES["nominal_diameter"]
    yield Message("quantities.nominal_diameter"), diameter, line.segments[0].nominal_diameter, ""
    yield Message("quantities.length"), length, line.length, ""
    yield Message("columns.line_mass_in_air"), mass, line.mass, ""
    radius = Message("note_size.identity_radius")
    yield radius, length, of.swing.total, of.swing.load_case
    if of.excursion is not None:
        yield Message("quantities.excursion"), length, of.excursion, ""
    H, at = _hardest(note)
    yield Message("note_size.identity_force"), force, H, at
    yield Message("columns.fairlead_tension"), force, solution.fairlead.tension, name
    yield Message("columns.largest_tension"), force, of.largest_tension, ""
    pull, at = max(
        ((each.fairlead.vertical_force, at) for at, each in of.point.checks.solutions),
        key=lambda found: found[0],
    )
    yield Message("columns.fairlead_vertical_force"), force, pull, at
    if of.reserve_buoyancy is not None:
        yield Message("columns.reserve_buoyancy"), force, of.reserve_buoyancy, ""
    for key, over in (("mbl", of.break_factor), ("proof", of.proof_factor)):
        if over is not None:
            yield Message(f"note_size.identity_{key}"), factor, over, ""


# ------------------------------------------------------------------ loads


def _loads(note: SizeNote) -> Iterator[Block]:
    settled = note.sizing.settled
    cases, assumed = settled.posed.loads, settled.assumed
    has_parts = any(each.parts for each in cases)
    yield Text(Message("note_size.loads_about" if has_parts else "note_size.loads_about_given"))
    if assumed.diameter and has_parts:
        values = {
            "diameter": Measure("nominal_diameter", assumed.diameter),
            "pull": Measure("horizontal_force", assumed.pull),
        }
        yield Text(Message("note_size.loads_assumed", rounds=settled.rounds, **values))
    yield _sums(note)
    common = _common(cases)
    for at in cases:
        for part in at.parts:
            yield from _part(at, part, common)
    yield Points(tuple(common), Message("note_size.loads_common"))
    if has_parts:
        yield Text(Message("note_size.loads_legend"), is_small=True)


def _common(cases: Sequence[LoadsAt]) -> list[str]:
    """List what is assumed in every load case: it is said once."""
    assumed = [[text for part in each.parts for text in part.assumptions] for each in cases]
    first = dict.fromkeys(assumed[0])
    return [text for text in first if all(text in texts for texts in assumed)]


def _sums(note: SizeNote) -> Table:
    """Tabulate the sum of each load case, and what of it one of several lines is sized for."""
    posed = note.sizing.settled.posed
    cases = posed.loads
    pushed = ["note_size.loads_on_buoy"]
    if note.sizing.kind == "tanker":
        pushed.insert(0, "note_size.loads_on_ship")
    columns = [
        texts("load_case", (term(each.load_case) for each in cases)),
        column("note_size.loads_depth", (each.depth for each in cases), _depth()),
        *(
            column(key, (each.parts[index].horizontal_force for each in cases), _FORCE)
            for index, key in enumerate(pushed[: len(cases[0].parts)])
        ),
    ]
    if any(each.given for each in cases):
        columns.append(column("note_size.loads_given", (each.given for each in cases), _FORCE))
    total = [each.horizontal_force for each in cases]
    columns.append(column("note_size.loads_sum", total, _FORCE))
    if note.sizing.pattern is not None:
        forces = {state.name: state.horizontal_force for state in posed.case.load_cases}
        own = (forces[each.load_case] for each in cases)
        columns.append(column("note_size.loads_line", own, _FORCE))
    caption = Message("note_size.loads_sums")
    return Table("size_sums", tuple(columns), caption, marked=total.index(max(total)))


def _depth() -> Quantity:
    return replace(QUANTITIES["water_depth"], symbol="")


def _part(at: LoadsAt, of: Loads, common: Sequence[str]) -> Iterator[Block]:
    """Follow each force on the ship or on the buoy in a load case, and their sum."""
    forces = _forces(of)
    steps = (*(_step(component, force) for component, force in forces), *_total(of, forces))
    under = Message("note_size.loads_under", load_case=term(at.load_case), title=of.title)
    yield Trail("size_load", steps, caption=under)
    rows = [(each.name, number) for each in of.components for number in each.numbers]
    yield Table(
        "size_numbers",
        (
            texts("force", (name for name, _ in rows)),
            texts("symbol", (Cited(GREEK.get(number.symbol, number.symbol)) for _, number in rows)),
            Column(
                Message("columns.value"),
                tuple(number.value for _, number in rows),
                units=tuple(replace(exact(number.unit), digits=_DIGITS) for _, number in rows),
            ),
            texts("meaning", (number.meaning for _, number in rows)),
        ),
        Message("columns.numbers"),
    )
    yield Points(tuple(each for each in of.assumptions if each not in common))


def _total(of: Loads, forces: Sequence[tuple[LoadComponent, float]]) -> Iterator[Step]:
    """Add the forces up: along the ship, and where there are any across it, both."""
    sums = [
        tuple((force,) for each, force in forces if (each.axis == "sway") == across)
        for across in (False, True)
    ]
    along, across = (math.fsum(force for (force,) in terms) for terms in sums)
    if not sums[1]:
        yield Step(Message("note_size.loads_total"), along, _FORCE, terms=sums[0])
        return
    yield Step(Message("note_size.loads_along"), along, _FORCE, terms=sums[0])
    yield Step(Message("note_size.loads_across"), across, _FORCE, terms=sums[1])
    yield Step(
        Message("note_size.loads_total"),
        of.horizontal_force,
        _FORCE,
        formula="√({X:()}² + {Y:()}²)",
        numbers={"X": along, "Y": across},
        digits=_DIGITS,
    )


def _forces(of: Loads) -> list[tuple[LoadComponent, float]]:
    """List each force with its size along the pull of all, N: against it, negative."""
    surge, along = of.along("surge"), of.along("along")
    signs = {"surge": math.copysign(1.0, surge), "along": math.copysign(1.0, along), "sway": 1.0}
    return [(each, signs[each.axis] * each.force) for each in of.components]


def _step(of: LoadComponent, force: float) -> Step:
    numbers = {number.symbol: number.value for number in of.numbers} | {"g": STANDARD_GRAVITY}
    name = Several((of.name, of.note), "; ") if of.note else of.name
    return Step(
        name,
        force,
        _FORCE,
        formula=of.factors,
        numbers=numbers,
        digits=_DIGITS,
        source=of.source.text,
    )


# ------------------------------------------------------------------ the choice


def _candidates(note: SizeNote) -> Iterator[Block]:
    """Tabulate the recommended size between its neighbours, and the steps to less that fail."""
    of = note.sizing
    yield Text(Message("note_size.candidates_about"))
    table = candidates_table(of)
    points = [None if each.settled is None else each.settled.point for each in of.candidates]
    hardest = [
        None if point is None else max(each.horizontal_force for _, each in point.checks.solutions)
        for point in points
    ]
    which, chain, *others = table.columns
    diameters = measured("nominal_diameter", [each.diameter for each in of.candidates])
    verdict = replace(others[-1], passes=tuple(point is not None for point in points))
    columns = (
        which,
        chain,
        diameters,
        *others[:-1],
        measured("horizontal_force", hardest),
        verdict,
    )
    marked = [each.role for each in of.candidates].index("recommended")
    yield replace(table, columns=columns, marked=marked)
    if of.limits:
        yield _limits(note)
    yield alternatives_table(of)
    if len(of.settled.result.front) < 2 and of.why:
        yield Text(of.why)


def _limits(note: SizeNote) -> Table:
    every = note.sizing.limits
    checks = [each.check for each in every]
    units = tuple(_FORCE if each is None else QUANTITY_OF[each.kind] for each in checks)

    def of(name: str, values: Iterable[float | None]) -> Column:
        return Column(Message(f"columns.{name}"), tuple(values), units=units)

    return Table(
        "size_limits",
        (
            column("note.front_change", (each.change for each in every)),
            column("note_size.candidates_fails_by", (each.words for each in every)),
            of("demand", (None if each is None else each.demand for each in checks)),
            of("capacity", (None if each is None else each.capacity for each in checks)),
        ),
        Message("note_size.candidates_limits"),
    )


def _front(note: SizeNote) -> Iterator[Block]:
    """Lay out the front that the line is from; nothing where one design alone passes."""
    chosen = note.line.chosen
    if chosen is not None and len(chosen.document["front"]) > 1:
        yield from of_the_front(chosen, "note_size.front_left_out")


def _swing(note: SizeNote) -> Iterator[Block]:
    found, length = note.sizing.swing, replace(QUANTITIES["length"], symbol="")
    names = [*(term(name) for name, _ in found.parts), Message("note_size.swing_total")]
    values = [*(value for _, value in found.parts), found.total]
    under = Message("note.checks_under", name=term(found.load_case))
    yield Text(Message("note_size.swing_about"))
    yield Table(
        "size_swing",
        (
            column("note_size.swing_part", names),
            column("note_size.swing_length", values, length),
        ),
        under,
        marked=len(found.parts),
    )
    if note.sizing.excursion is not None:
        key = "excursion" if note.sizing.pattern is None else "offset"
        way = Measure("length", note.sizing.excursion)
        yield Text(Message(f"note_size.swing_{key}", length=way))


# ------------------------------------------------------------------ several lines


def _pattern(note: SizeNote) -> Iterator[Block]:
    """Tabulate load cases and lines of a body on several; nothing where there is one line."""
    of, around = note.sizing.pattern, note.around
    if of is None or around is None:
        return
    yield Text(
        Message(
            "note_size.pattern_about",
            lines=of.lines,
            radius=Measure("length", of.anchor_radius),
            pretension=Measure("horizontal_force", of.pretension),
        )
    )
    table = pattern_table(of)
    pull = replace(table.columns[-1], name=Message("note_size.pattern_pull"))
    yield replace(
        table,
        columns=(*table.columns[:-1], pull),
        caption=Message("note_size.pattern_states"),
        marked=of.states.index(of.hardest),
    )
    yield from _rule(of)
    yield without_line_table(note.sizing)
    yield from (*plan_blocks(around), *near_blocks(around))
    yield _lines(around, of.hardest.load_case)
    force = f"{around.residual.force:.1e} N"
    yield Text(Message("note_size.pattern_residual", force=force), is_small=True)


def _rule(of: Pattern) -> Iterator[Text]:
    """Put the rule of practice beside the equilibrium."""
    hardest = of.hardest
    rule = hardest.rule_force
    if rule is not None:
        values = {
            "force": Measure("horizontal_force", hardest.force),
            "rule": Measure("horizontal_force", rule),
            "found": Measure("horizontal_force", hardest.line_force),
            "ratio": f"{hardest.line_force / rule:.3f}",
        }
        yield Text(Message("note_size.pattern_rule", lines=of.lines, **values))


def _lines(of: SystemSolution, load_case: str) -> Table:
    """Tabulate what each line pulls with, their sum, and the load."""
    lines, force = of.lines, of.system.force
    pulls = [
        (line.horizontal_force * math.cos(line.direction),
         line.horizontal_force * math.sin(line.direction))
        for line in lines
    ]  # fmt: skip
    total = tuple(math.fsum(pull[axis] for pull in pulls) for axis in (0, 1))
    ends = (Message("note_size.pattern_total"), Message("note_size.pattern_load"))
    numbers: list[Value] = [*map(str, range(1, len(lines) + 1)), *ends]
    angle = replace(QUANTITIES["angle"], symbol="")
    H, tension = QUANTITIES["horizontal_force"], QUANTITIES["tension"]
    rest, directions = (None, None), [line.direction for line in lines]
    return Table(
        "size_lines",
        (
            column("columns.line", numbers),
            column("note_size.pattern_towards", (*directions, *rest), angle),
            column(
                "quantities.horizontal_force",
                (*(each.horizontal_force for each in lines), *rest),
                H,
            ),
            column("quantities.tension", (*(each.tension for each in lines), *rest), tension),
            *(
                column(
                    "quantities.horizontal_force",
                    (*(pull[axis] for pull in pulls), total[axis], force[axis]),
                    replace(H, symbol=symbol),
                )
                for axis, symbol in ((0, "Hx"), (1, "Hy"))
            ),
        ),
        Message("note_size.pattern_lines", load_case=term(load_case)),
    )


# ------------------------------------------------------------------ what it rests on


def _assumptions(note: SizeNote) -> Iterator[Block]:
    of = note.sizing
    yield Points(tuple(of.assumptions))
    yield Points(tuple(of.defaults), Message("note_size.assumptions_defaults"))
    yield Points(tuple(of.recalled), Message("note_size.assumptions_recalled"))


def _inputs(note: SizeNote) -> Iterator[Block]:
    """Tabulate all inputs as read, the keys of the file, and the options that were typed."""
    if note.sizing.inputs:
        yield replace(read_table(note.sizing), name="size_inputs")
    if note.origin.files:
        yield Text(Message("note_size.inputs_about"))
        yield inputs_table(note.origin)
    if note.options:
        if note.origin.files:
            yield Text(Message("note_size.inputs_before"))
        yield Table(
            "size_options",
            (
                column("note_size.inputs_option", (Cited(name) for name, _ in note.options)),
                column("note.inputs_given", (Cited(value) for _, value in note.options)),
            ),
            Message("note_size.inputs_typed"),
        )
