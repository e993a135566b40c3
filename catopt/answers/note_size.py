"""What the note of a sizing consists of, and how what holds the line was sized."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers import size as sized
from catopt.answers.bill import Prices, described
from catopt.answers.blocks import (
    Block,
    Figure,
    Rows,
    Section,
    Step,
    Table,
    Text,
    Trail,
    exact,
    measured,
    named,
    texts,
)
from catopt.answers.check import failing_checks, tightest_table
from catopt.answers.note import (
    Number,
    basis_section,
    components,
    from_rows,
    inputs_table,
    note_answer,
    opening,
    section,
    sheet_sections,
    small,
)
from catopt.answers.note_line import of_the_front, of_the_line
from catopt.answers.note_system import near_blocks, plan_blocks, pull_of
from catopt.answers.size_card import band_words, storm_time
from catopt.answers.trail import step_of
from catopt.checks.kinds import QUANTITY_OF
from catopt.constants import STANDARD_GRAVITY, YEAR
from catopt.figures.sizing import elevation, swing_circle
from catopt.model.anchor import sinker_needed
from catopt.model.line import weight_in_water
from catopt.quantities import GREEK, QUANTITIES
from catopt.words import (
    LANGUAGES,
    Cited,
    Language,
    Measure,
    Message,
    Sentence,
    Several,
    Translated,
    say,
    term,
)

if TYPE_CHECKING:
    from catopt.loads.component import Loads
    from catopt.loads.drag_anchor import DragAnchorSize
    from catopt.loads.sinker import SinkerSize
    from catopt.mooring.solution import SystemSolution
    from catopt.notes.line import SizeNote
    from catopt.sizing import Sizing
    from catopt.sizing.converge import LoadsAt

_DIGITS = 5
"""Of the numbers of loads: more than any of them is known to."""

_FORCE = named("horizontal_force", "")
_section = partial(section, group="note_size")


def size_note_answer(note: SizeNote) -> blocks.Answer:
    """Lay out the note of a sizing."""
    line, of = note.line, note.sizing
    analysis = "" if of.in_motion is None else Message(f"note_size.analysis_{of.kind}")
    # Of the water above the depth, m; those of load cases go with the draught, too.
    levels = [each.depth - of.case.site.water_depth for each in of.settled.posed.loads]
    front: Iterable[Block] = ()
    if line.chosen is not None and len(line.chosen.document["front"]) > 1:
        front = of_the_front(line.chosen, "note_size.front_left_out")
    sections = (
        *_opening(note),
        basis_section(note.sheet, *_combined(of), levels, analysis=analysis),
        _section("in_motion", _in_motion(note)),
        *of_the_line(line, "checks", "load_cases"),
        _section("identity", _identity(note)),
        _section("candidates", _candidates(note)),
        _section("front", front),
        _section("loads", _loads(note)),
        *sheet_sections(note.sheet, what_holds(note), _prices(note.sizing)),
        _section("hold", hold_blocks(note)),
        _section("swing", _swing(note)),
        _section("pattern", _pattern(note)),
        _section("assumptions", _assumptions(note)),
        _section("inputs", _inputs(note)),
        *of_the_line(line, "results", "tension", "curve"),
        section("components", components(line.case, line.solution.line)),
        *of_the_line(line, "equations", "verification", "swarm"),
    )
    return note_answer(note, "note_size.kind_size", sections, file="size_file")


def _prices(of: Sizing) -> Prices:
    """Take those that were given."""
    return Prices(of.prices.chain_price, of.prices.sinker_price, of.prices.fittings_price)


# ------------------------------------------------------------------ what is recommended


def _opening(note: SizeNote) -> Iterator[Section]:
    of = note.sizing
    force = max(each.horizontal_force for _, each in of.intact)
    return opening(
        note,
        (),
        _recommendation(note),
        sized.motion_sentence(of),
        *((Sentence(of.practice, capital=True),) if of.practice else ()),
        drawing=(
            Text(Message("note.line_scale")),
            Figure(elevation(of, failing_checks(of.point.checks))),
            Figure(swing_circle(of)),
        ),
        force=(Message("note_size.identity_force"), "horizontal_force", force),
        reach=(Message("note_size.identity_radius"), "length", of.swing.total),
        tension=of.largest_tension,
        in_motion=of.in_motion is not None,
        in_storm=tuple(_in_storm(of)),
        judgement=of.judgement,
    )


def _in_storm(of: Sizing) -> Iterator[Number]:
    """Yield what the recommended line comes to in motion."""
    if of.in_motion is None:
        return
    storm, time = of.in_motion.storm, storm_time(of.in_motion)
    yield Message("sizing.card_tension_in_storm", time=time), "tension", storm.tension
    if storm.high is not None:
        yield Message("note_size.upper_end"), "tension", storm.high
    worst = of.in_motion.checks.governing
    if worst is not None and worst.utilisation is not None:
        yield Message("note_size.used_in_motion"), "safety_factor", worst.utilisation


def _in_motion(note: SizeNote) -> Iterator[Block]:
    """Say how lines were run, and check the recommended one in motion."""
    of = note.sizing.in_motion
    if of is None:
        return
    yield tightest_table(of.checks)
    yield sized.checks_of(of)
    yield from sized.tried_blocks(of)
    if of.band is not None:
        yield Text(band_words(of.band))
    if of.basis:
        yield blocks.Points(of.basis, Message("note_size.motion_basis"))
    if of.checks.warnings:
        yield blocks.Warnings(of.checks.warnings)


def _combined(of: Sizing) -> tuple[str, str]:
    """Say how the loads are combined, and how often they return, where that is known."""
    has_parts = any(each.parts for each in of.settled.posed.loads)
    years = {each.of.name: each.value for each in of.inputs}.get("return_period")
    combined = Message("note_sheet.combined_at_once") if has_parts else ""
    if not isinstance(years, float):
        return combined, ""
    return combined, Message("note_sheet.return_period_is", years=years / YEAR)


def _identity(note: SizeNote) -> Iterator[Block]:
    """List what governs, and tabulate what came out."""
    governs = [
        Message("note_size.identity_step", change=each.change, check=each.words)
        for each in note.sizing.limits
    ]
    yield blocks.Points(tuple(governs), Message("note_size.identity_governs"))
    table = sized.summary_table(note.sizing)
    columns = tuple(replace(each, only="all") for each in table.columns)
    yield replace(table, columns=columns)
    if note.sizing.upkeep is not None:
        yield from sized.upkeep_blocks(note.sizing.upkeep)


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
        "chain": Translated(
            {each: _chain(code, described(of.case, first), each) for each in LANGUAGES}
        ),
        "length": f"{line.length:g}",
        "shots": f"{of.shots:.2f}",
        "weights": weights,
        "held": what_holds(note) or "-",
        "swing": f"{of.swing.total:.1f}",
    }
    if pattern is None:
        return Message("note_size.identity_one", **values)
    return Message("note_size.identity_several", lines=pattern.lines, **values)


def _chain(code: str, said: str, language: Language) -> str:
    """Name a chain as the catalogue does; where that is English, with what it is behind it."""
    return code if language == "en" else f"{code} ({say(said, language)})"


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
    # What is assumed in every load case is said once.
    said = [dict.fromkeys(text for part in at.parts for text in part.assumptions) for at in cases]
    common = [text for text in said[0] if all(text in of_case for of_case in said)]
    for at in cases:
        for part in at.parts:
            yield from _part(at, part, common)
    yield blocks.Points(tuple(common), Message("note_size.loads_common"))
    if has_parts:
        yield small("note_size.loads_legend")


def _sums(note: SizeNote) -> Table:
    """Tabulate the sum of each load case, and what of it one of several lines is sized for."""
    posed = note.sizing.settled.posed
    cases = Rows(posed.loads)
    pushed = ["loads_on_ship", "loads_on_buoy"][note.sizing.kind != "tanker" :]
    given = cases.measured(_FORCE, "given", "note_size.loads_given")
    total = cases.read("horizontal_force")
    columns = [
        cases.texts("load_case", lambda each: term(each.load_case)),
        cases.measured("water_depth", "depth", "note_size.loads_depth", symbol=""),
        *(
            Rows(parts).measured(_FORCE, "horizontal_force", f"note_size.{key}")
            for key, parts in zip(pushed, zip(*cases.read("parts"), strict=True), strict=False)
        ),
        *([given] if any(given.values) else []),
        measured(_FORCE, total, "note_size.loads_sum"),
    ]
    several = note.sizing.pattern is not None
    if several or note.sizing.dynamic_factor != 1.0:
        forces = {state.name: state.horizontal_force for state in posed.case.load_cases}
        name = f"note_size.loads_{'line' if several else 'moving'}"
        columns.append(cases.measured(_FORCE, lambda each: forces[each.load_case], name))
    caption = Message("note_size.loads_sums")
    return Table("size_sums", tuple(columns), caption, marked=total.index(max(total)))


def _part(at: LoadsAt, of: Loads, common: Sequence[str]) -> Iterator[Block]:
    """Follow each force on the ship or on the buoy in a load case, and their sum."""
    under = Message("note_size.loads_under", load_case=term(at.load_case), title=of.title)
    yield Trail("size_load", tuple(_steps(of)), caption=under)
    rows = (
        (
            force.name,
            Cited(GREEK.get(each.symbol, each.symbol)),
            (each.value, replace(exact(each.unit), digits=_DIGITS)),
            each.meaning,
        )
        for force in of.components
        for each in force.numbers
    )
    keys = ("force", "symbol", "value", "meaning")
    yield from_rows("size_numbers", keys, rows, Message("columns.numbers"))
    yield blocks.Points(tuple(each for each in of.assumptions if each not in common))


def _steps(of: Loads) -> Iterator[Step]:
    """Follow each force, then add up those along the ship, and where there are any across it, both.

    Along the ship what acts against the pull of all is negative.
    """
    signs = {axis: math.copysign(1.0, of.along(axis)) for axis in ("surge", "along")}
    along: list[tuple[float, ...]] = []
    across: list[tuple[float, ...]] = []
    for each in of.components:
        force = signs.get(each.axis, 1.0) * each.force
        (across if each.axis == "sway" else along).append((force,))
        numbers = {number.symbol: number.value for number in each.numbers} | {"g": STANDARD_GRAVITY}
        name = Several((each.name, each.note), "; ") if each.note else each.name
        source = each.source.text
        yield Step(name, force, _FORCE, "", each.factors, numbers, source=source, digits=_DIGITS)
    X, Y = (math.fsum(force for (force,) in terms) for terms in (along, across))
    total = Message("note_size.loads_total")
    named_along = Message("note_size.loads_along") if across else total
    yield Step(named_along, X, _FORCE, terms=tuple(along))
    if across:
        yield Step(Message("note_size.loads_across"), Y, _FORCE, terms=tuple(across))
        root, numbers, both = "√({X:()}² + {Y:()}²)", {"X": X, "Y": Y}, of.horizontal_force
        yield Step(total, both, _FORCE, formula=root, numbers=numbers, digits=_DIGITS)


# ------------------------------------------------------------------ the choice


def _candidates(note: SizeNote) -> Iterator[Block]:
    """Tabulate the recommended size between its neighbours, and the steps to less that fail."""
    of = note.sizing
    if of.in_motion is not None:  # others at rest say nothing beside those that were run
        return
    yield Text(Message("note_size.candidates_about"))
    table = sized.candidates_table(of)
    every = Rows(of.candidates)
    solutions = Rows(every.read("settled.point.checks.solutions"))
    which, chain, *others, verdict = table.columns
    diameters = every.measured("nominal_diameter", "diameter")
    forces = solutions.measured(
        "horizontal_force", lambda found: max(each.horizontal_force for _, each in found)
    )
    verdict = replace(verdict, passes=tuple(each.settled is not None for each in of.candidates))
    columns = (which, chain, diameters, *others, forces, verdict)
    yield replace(table, columns=columns, marked=every.read("role").index("recommended"))
    if of.limits:
        yield _limits(note)
    yield sized.alternatives_table(of)
    if len(of.settled.result.front) < 2 and of.why:
        yield Text(of.why)


def _limits(note: SizeNote) -> Table:
    """Tabulate the steps to less that fail, each with what it asks for and what there is."""
    of = Rows(note.sizing.limits)
    kinds = of.read("check.kind")
    units = tuple(_FORCE if kind is None else QUANTITY_OF[kind] for kind in kinds)
    return blocks.tabulate(
        "size_limits",
        of.texts("note.front_change", "change"),
        of.texts("note_size.candidates_fails_by", "words"),
        of.texts("demand", "check.demand", units=units),
        of.texts("capacity", "check.capacity", units=units),
        caption=Message("note_size.candidates_limits"),
    )


def _swing(note: SizeNote) -> Iterator[Block]:
    found = note.sizing.swing
    names = [*(term(name) for name, _ in found.parts), Message("note_size.swing_total")]
    values = [*(value for _, value in found.parts), found.total]
    parts = texts("note_size.swing_part", names)
    lengths = measured("length", values, "note_size.swing_length", symbol="")
    under = Message("captions.load_case", name=term(found.load_case))
    yield Text(Message("note_size.swing_about"))
    yield Table("size_swing", (parts, lengths), under, marked=len(found.parts))
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
    about = Message(
        "note_size.pattern_about",
        lines=of.lines,
        radius=Measure("length", of.anchor_radius),
        pretension=Measure("horizontal_force", of.pretension),
    )
    yield Text(about)
    table = sized.pattern_table(of)
    pull = replace(table.columns[-1], name=Message("note_size.pattern_pull"))
    yield replace(
        table,
        columns=(*table.columns[:-1], pull),
        caption=Message("note_size.pattern_states"),
        marked=of.states.index(of.hardest),
    )
    hardest = of.hardest
    if hardest.rule_force is not None:  # the rule of practice beside the equilibrium
        values = {
            "force": Measure("horizontal_force", hardest.force),
            "rule": Measure("horizontal_force", hardest.rule_force),
            "found": Measure("horizontal_force", hardest.line_force),
            "ratio": f"{hardest.line_force / hardest.rule_force:.3f}",
        }
        yield Text(Message("note_size.pattern_rule", lines=of.lines, **values))
    yield sized.without_line_table(note.sizing)
    yield from (*plan_blocks(around), *near_blocks(around))
    yield _lines(around, of.hardest.load_case)
    force = f"{around.residual.force:.1e} N"
    yield small("note_size.pattern_residual", force=force)


def _lines(of: SystemSolution, load_case: str) -> Table:
    """Tabulate what each line pulls with, their sum, and the load."""
    lines, force = Rows((*of.lines, None, None)), "horizontal_force"
    names = [str(number) for number in range(1, len(of.lines) + 1)]
    names += [Message("note_size.pattern_total"), Message("note_size.pattern_load")]
    along, across = (
        (*pulls, math.fsum(pulls), load)
        for *pulls, load in zip(*map(pull_of, of.lines), of.system.force, strict=True)
    )
    return blocks.tabulate(
        "size_lines",
        texts("line", names),
        lines.measured("angle", "direction", "note_size.pattern_towards", symbol=""),
        *lines.own("horizontal_force", "tension"),
        measured(force, along, symbol="Hx"),
        measured(force, across, symbol="Hy"),
        caption=Message("note_size.pattern_lines", load_case=term(load_case)),
    )


# ------------------------------------------------------------------ what it rests on


def _assumptions(note: SizeNote) -> Iterator[Block]:
    of = note.sizing
    yield blocks.Points(tuple(of.advice), Message("note_size.assumptions_advice"))
    yield blocks.Points(tuple(of.assumptions))
    yield blocks.Points(tuple(of.defaults), Message("note_size.assumptions_defaults"))
    yield blocks.Points(tuple(of.recalled), Message("note_size.assumptions_recalled"))


def _inputs(note: SizeNote) -> Iterator[Block]:
    """Tabulate all inputs as read, the keys of the file, and the options that were typed."""
    if note.sizing.inputs:
        yield replace(sized.read_table(note.sizing), name="size_inputs")
    if note.origin.files:
        yield Text(Message("note_size.inputs_about"))
        yield inputs_table(note.origin)
    if note.options:
        if note.origin.files:
            yield Text(Message("note_size.inputs_before"))
        rows = ((Cited(name), Cited(value)) for name, value in note.options)
        keys, typed = ("note_size.inputs_option", "note.inputs_given"), "note_size.inputs_typed"
        yield from_rows("size_options", keys, rows, Message(typed))


_PULL, _LIFT, _MASS, _NUMBER, _DENSITY = (
    QUANTITIES[key]
    for key in ("horizontal_force", "vertical_force", "mass", "coefficient", "density")
)


def hold_blocks(note: SizeNote) -> Iterator[Block]:
    """Follow how what holds the line was sized; nothing where that was not."""
    sinker, drag = note.sizing.sinker, note.sizing.drag_anchor
    size: SinkerSize | DragAnchorSize
    if drag is not None:
        size, key, steps = drag, "note_size.hold_about_drag", _drag_anchor(drag, note)
    elif sinker is not None:
        size, key, steps = sinker, "note_size.hold_about_sinker", _sinker(sinker, note)
    else:
        return
    yield Text(Message(key, held=what_holds(note)))
    yield Trail("size_hold", tuple(steps))
    smaller, larger = (
        "-" if mass is None else Message("sizing.measure", value=Measure("mass", mass))
        for mass in (size.smaller, size.larger)
    )
    yield small("note_size.hold_series", smaller=smaller, larger=larger)
    if drag is not None and drag.capacity.others:
        yield Text(Cited(drag.capacity.note), is_small=True)


def what_holds(note: SizeNote) -> str:
    """Say in a few words what holds the line; empty where nothing was sized."""
    of = note.sizing
    if of.drag_anchor is not None:
        size = of.drag_anchor
        values = {"name": size.anchor, "mass": f"{size.mass / 1e3:g}", "soil": term(size.soil)}
        return Message("note_size.hold_drag", **values)
    if of.sinker is None:
        return ""
    key = "note_size.hold_steel" if of.sinker.material == "steel" else "note_size.hold_concrete"
    mass = of.sinker.mass if of.point.anchor is None else of.point.anchor.mass or of.sinker.mass
    return Message(key, mass=f"{mass / 1e3:g}")


def _sinker(of: SinkerSize, note: SizeNote) -> Iterator[Step]:
    H, V, mu, SF = of.horizontal_force, of.vertical_force, of.friction, of.safety_factor
    water, rho, g = note.sizing.case.site.water_density, of.density, STANDARD_GRAVITY
    sources, needed = note.sources, sinker_needed(H, V, mu, SF)
    numbers = {"H": H, "V": V, "μ": mu, "SF": SF, "ρ": rho, "ρw": water, "g": g, "W₁": needed}
    step = partial(step_of, numbers | {"m": of.mass, "W": of.submerged_weight})
    yield step("note_size.hold_pull", "H", _PULL, H)
    yield step("note_size.hold_lift", "V", _LIFT, V)
    yield step("note_size.hold_friction", "μ", _NUMBER, mu, source=sources["friction"])
    yield step("note_size.hold_factor", "SF", _NUMBER, SF, source=sources["factor"])
    yield step("note_size.hold_density", "ρ", _DENSITY, rho, source=sources["density"])
    yield step("note_size.hold_water", "ρw", _DENSITY, water)
    yield step("note_size.hold_needed_weight", "W₁", _LIFT, needed, "{V} + {SF} · {H}/{μ}")
    formula = "{W₁}/({g} · (1 − {ρw}/{ρ}))"
    by_weight = needed / weight_in_water(1.0, rho, water)
    formula = formula if math.isclose(of.needed_mass, by_weight) else ""  # what the base needs
    yield step("note_size.hold_needed_mass", "m₁", _MASS, of.needed_mass, formula)
    yield step("note_size.hold_next", "m", _MASS, of.mass)
    formula = "{g} · {m} · (1 − {ρw}/{ρ})"
    yield step("note_size.hold_weight", "W", _LIFT, of.submerged_weight, formula)
    formula = "{μ} · ({W} − {V})/{H}"
    if of.bond is not None and of.base_holding is not None:
        c, A, B = of.bond.adhesion, of.base_area, of.base_holding
        step = partial(step_of, numbers | {"m": of.mass, "W": of.submerged_weight, "B": B})
        adhesion = Cited(of.bond.source.text)
        yield step("note_size.hold_adhesion", "c", QUANTITIES["adhesion"], c, source=adhesion)
        yield step("note_size.hold_base", "A", QUANTITIES["base_area"], A)
        yield step("note_size.hold_on_base", "B", _PULL, B)
        formula = formula if of.held < B else "{B}/{H}"
    if of.factor is not None:
        yield step("note_size.hold_reached", "", _NUMBER, of.factor, formula)
    own = None if note.sizing.point.anchor is None else note.sizing.point.anchor.mass
    if own is not None and not math.isclose(own, of.mass):
        yield step("note_size.hold_own", "m", _MASS, own)


def _drag_anchor(of: DragAnchorSize, note: SizeNote) -> Iterator[Step]:
    H, SF, curve = of.horizontal_force, of.safety_factor, of.capacity.curve
    HR, mR, b = curve.reference_capacity, curve.reference_mass, curve.exponent
    Q, wanted, cited = of.capacity.capacity, SF * H, Cited(curve.source.text)
    numbers = {"H": H, "SF": SF, "HR": HR, "mR": mR, "b": b, "Q₁": wanted, "m": of.mass, "Q": Q}
    step = partial(step_of, numbers)
    yield step("note_size.hold_pull", "H", _PULL, H)
    yield step("note_size.hold_factor", "SF", _NUMBER, SF, source=note.sources["factor"])
    yield step("note_size.hold_wanted", "Q₁", _PULL, wanted, "{SF} · {H}")
    yield step("note_size.hold_reference", "HR", _PULL, HR, source=cited)
    yield step("note_size.hold_reference_mass", "mR", _MASS, mR, source=cited)
    yield step("note_size.hold_exponent", "b", _NUMBER, b, source=cited)
    is_by_curve = H > 0.0 and math.isclose(curve.mass(wanted), of.needed_mass)
    formula = "{mR} · ({Q₁}/{HR})^(1/{b})" if is_by_curve else ""
    yield step("note_size.hold_needed_mass", "m₁", _MASS, of.needed_mass, formula)
    yield step("note_size.hold_next", "m", _MASS, of.mass)
    yield step("note_size.hold_capacity", "Q", _PULL, Q, "{HR} · ({m}/{mR})^{b}")
    if of.factor is not None:
        yield step("note_size.hold_reached", "", _NUMBER, of.factor, "{Q}/{H}")
