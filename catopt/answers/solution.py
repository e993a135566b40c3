"""What the equilibrium of a line consists of, and its load curve."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from catopt.answers import blocks
from catopt.answers.blocks import (
    Rows,
    answered,
    fact,
    if_known,
    measured,
    section,
    stated,
    tabulate,
    texts,
)
from catopt.model.line import StrainTable
from catopt.words import Measure, Message, Several, is_said, term

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.in_current import SolutionInCurrent
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.model import Case, CurrentProfile, Line, SwarmSettings

_NO_LENGTH = 1e-9
"""Of the line's length: what lies on the bed then is rounding."""
_PROFILE_POINTS, _SHOWN_EVERY = 101, 5


def solution_answer(case: Case, solution: Solution, *, with_profile: bool = False) -> blocks.Answer:
    """Lay out a case and its solution.

    People see the shape, too, `with_profile`.
    """
    inputs = blocks.Facts("inputs", tuple(given_facts(case)), Message("captions.given"))
    results: list[blocks.Block] = []
    closing: list[blocks.Block] = []
    found = solution.found
    if found is not None:  # files have it with the results
        caption = Message("captions.found_for", condition=found.condition)
        results.append(blocks.Facts("found", found_facts(solution), caption, only="people"))
        closing.append(blocks.Text(Message("solution.residual_of_condition", value=found.residual)))
    for key in ("height", "span"):
        value = Measure("residual", getattr(solution.residual, key))
        closing.append(blocks.Text(Message(f"solution.residual_of_{key}", value=value)))
    results += [summary(solution), segments_table(solution)]
    if solution.safety_factor != 1.0 and any(each.MBL is not None for each in solution.segments):
        results.append(blocks.Text(Message("solution.utilisation", factor=solution.safety_factor)))
    if solution.point_loads:
        results.append(point_loads_table(solution))
    method, shape = method_name(solution.method), Message("captions.line_shape")
    hangs = Message("solution.in_air") if case.site.is_in_air else how_it_hangs(solution)
    solved = Message("solution.solved", method=method, hangs=hangs)
    whole = blocks.answered(
        "solution",
        case.title or Message("captions.mooring_line"),
        section("captions.inputs", blocks.Text(solved), inputs, *given_tables(case.line)),
        section("captions.results", *results),
        section(
            shape,
            profile_table(solution, only="all" if with_profile else "files"),
            blocks.Graph(shape, "profile", x=1, y=(2,)),
            blocks.Graph(Message("captions.tension_along_the_line"), "profile", x=0, y=(3,)),
        ),
        *_swarm(case, solution),
        section("captions.residuals", *closing, blocks.Warnings(tuple(solution.warnings))),
    )
    following = "solution_in_current" if solution.method == "shooting" else ""
    card = tuple(_card(case, solution, solved, with_profile=with_profile))
    return replace(whole, card=card, next=following)


_ON_CARD, _BEFORE_DRAG = 8, 5
"""Numbers of a line on one screen: forces, tensions, angles and lengths, the first ones; and how
many of them stand before what a current adds."""


def _card(
    case: Case, solution: Solution, solved: Message, *, with_profile: bool
) -> Iterator[blocks.CardBlock]:
    """Say how the line hangs, what parts, its numbers, what its parts carry, and what was given."""
    yield blocks.Text(solved)
    parting = [each for each in solution.warnings if is_said(each, "catenary.beyond_MBL")]
    if parting:
        yield blocks.Verdict(Message("solution.parts", said=Several(parting)), passes=False)
    on_card = _ON_CARD - bool(parting)
    facts = (
        *found_facts(solution),
        *result_facts(solution)[:_BEFORE_DRAG],
        *_of_current(solution),
        *result_facts(solution)[_BEFORE_DRAG:on_card],
        *(_lowest(solution) if solution.regime == "below-anchor" else ()),
        fact("grounded_length", solution.grounded_length),
        fact("mass", solution.line.mass),
    )
    known = (replace(each, also=()) for each in facts if each.value is not None)
    yield blocks.Facts("summary", tuple(known))
    carried = profile_table(solution) if with_profile else segments_table(solution)
    # Not again in tf what stands beside it in kN.
    once = (e for e in carried.columns if e.quantity is None or e.quantity.field_unit != "tf")
    yield replace(carried, columns=tuple(once))
    if solution.point_loads and not with_profile:
        yield point_loads_table(solution)
    others = (each for each in solution.warnings if each not in parting)
    yield from blocks.briefly(others, blocks.TO_BE_KNOWN, 3)
    if solution.found is not None:
        sought = Message("captions.found_for", condition=solution.found.condition)
        yield blocks.Brief((sought,))
    given = (each for each in given_facts(case) if each.only != "files")
    yield blocks.Brief(tuple(map(blocks.in_words, given)), Message("answers.card_given"), 2)


# ------------------------------------------------------------------ what was given


def given_facts(case: Case) -> Iterator[blocks.Fact]:
    """List what a case gives beside its line: site, heights, load and limits."""
    yield stated("title", case.title, only="files")
    yield stated("source", case.source, only="files")
    site = case.site
    if not site.is_in_air:
        yield fact("water_depth", site.depth_to_seabed)
    yield fact("fairlead_height", site.height_above_seabed(case.fairlead_height))
    yield fact("anchor_height", site.height_above_seabed(case.anchor_height))
    if site.contact_offset:
        yield fact("contact_offset", site.contact_offset)
    if not site.is_in_air:
        yield fact("friction", case.site.seabed_friction)
        yield fact("density", case.site.water_density, "water_density")
    if (current := case.current_at_rest) is not None:
        yield stated("current", current_in_words(current, site.water_depth))
    load = case.load
    if load is not None:  # there is none where the force itself is sought
        given = (
            _force("horizontal_force", load.horizontal_force, "given_horizontal_force"),
            fact("span", load.span, "given_span"),
            _force("tension", load.fairlead_tension, "given_fairlead_tension"),
        )
        yield from (each for each in given if each.value is not None)
    limit = case.checks.max_anchor_uplift_angle
    for each in (
        fact("safety_factor", case.checks.safety_factor),
        fact("angle", limit, "allowed_inclination_at_the_anchor", symbol=""),
    ):
        yield replace(each, only="files") if each.value is None else each


def current_in_words(current: CurrentProfile, water_depth: float) -> Message:
    """Say a current at rest: its profile, and how it flows at the surface."""
    along, across = current.flow(water_depth)(water_depth)
    return Message(
        "solution.current",
        profile=Message(f"solution.current_{current.profile}"),
        speed=math.hypot(along, across),
        direction=math.degrees(math.atan2(across, along)),
    )


def given_tables(line: Line) -> Iterator[blocks.Table]:
    """Tabulate segments, and clump weights and buoys, as given."""
    segments = Rows(line.segments)
    yield tabulate(
        "segments_given",
        *_named("segment", segments),
        *segments.own("length", "submerged_weight"),
        segments.measured("EA", lambda of: None if isinstance(of.EA, StrainTable) else of.EA),
        segments.measured("mass_per_length", "mass"),
        *segments.own("MBL"),
        caption=Message("captions.segments_from_the_anchor_to_the_fairlead"),
    )
    yield from _strain_tables(line)
    if line.point_loads:
        loads = Rows(line.point_loads)
        yield tabulate(
            "point_loads_given",
            *_named("point_load", loads),
            *loads.own("position"),
            loads.measured("point_weight", "submerged_weight"),
            *loads.own("mass"),
            *if_known(*loads.own("friction")),
            caption=Message("captions.point_loads"),
        )


def _strain_tables(line: Line) -> Iterator[blocks.Table]:
    """Tabulate the strains of ropes that have them by a table."""
    every = enumerate((each.EA for each in line.segments), start=1)
    found = [(k, EA) for k, EA in every if isinstance(EA, StrainTable)]
    rows = [(k, *row) for k, EA in found for row in zip(EA.strain, EA.tension, strict=True)]
    if rows:
        number, strain, tension = zip(*rows, strict=True)
        yield tabulate(
            "strain_given",
            texts("segment", number),
            measured("strain", strain),
            measured("tension", tension),
            caption=Message("captions.strain_given"),
        )


def _named(what: str, of: Rows) -> Iterator[blocks.Column]:
    yield texts(what, range(1, len(of.rows) + 1))
    yield of.texts("name", only="all" if any(of.read("name")) else "files")


# ------------------------------------------------------------------ what came out


def found_facts(solution: Solution) -> tuple[blocks.Fact, ...]:
    """List what was sought and found; nothing when nothing was."""
    if solution.found is None:
        return ()
    value, number = solution.found.value, solution.found.number
    if solution.found.quantity == "length":
        return (fact("length", value, Message("columns.found_length", number=number)),)
    if solution.found.quantity == "clump_weight":
        return (_force("point_weight", value, Message("columns.found_weight", number=number)),)
    return (_force("horizontal_force", value, "found_horizontal_force"),)


def summary(solution: Solution) -> blocks.Facts:
    """List forces, tensions and lengths of a line."""
    found = solution.found
    opening = [
        stated("title", solution.title),
        stated("method", solution.method),
        stated("regime", term(solution.regime)),
    ]
    closing = list(residual_facts(solution))
    if found is not None:
        opening += [stated("condition", found.condition), *found_facts(solution)]
        closing.append(fact("coefficient", found.residual, "residual_of_the_condition_relative"))
    closing.append(stated("warnings", Several(solution.warnings)))
    before, after = ((replace(each, only="files") for each in own) for own in (opening, closing))
    facts = (*before, *result_facts(solution), *after)
    return blocks.Facts("summary", facts, Message("captions.result"))


def result_facts(solution: Solution) -> tuple[blocks.Fact, ...]:
    """List what was found for the line as a whole."""
    anchor, fairlead = solution.anchor, solution.fairlead
    varies = solution.force_varies  # then both ends stand beside each other
    at_anchor = _force(
        "horizontal_force", anchor.horizontal_force, "anchor_horizontal_force", symbol=""
    )
    return (
        _angle(anchor.angle, "inclination_at_the_anchor", "theta0"),
        fact("span", solution.span),
        _force("tension", fairlead.tension, "fairlead_tension"),
        _force("horizontal_force", solution.horizontal_force, force_name([solution])),
        *([at_anchor] if varies else []),
        _force("vertical_force", fairlead.vertical_force, "fairlead_vertical_force"),
        _angle(fairlead.angle, "inclination_at_the_fairlead", "theta1"),
        _force("tension", anchor.tension, "anchor_tension", symbol=""),
        *([] if varies else [at_anchor]),
        _force("vertical_force", anchor.vertical_force, "anchor_vertical_force", symbol=""),
        fact("grounded_length", solution.grounded_length),
        fact("suspended_length", solution.suspended_length),
        fact("stretched_length", solution.stretched_length),
        *_lowest(solution),
        fact("mass", solution.line.mass, "line_mass_in_air", symbol=""),
        *_of_current(solution),
    )


def _lowest(solution: Solution) -> Iterator[blocks.Fact]:
    """Say where the line is lowest, and its sag below the straight one between its ends."""
    lowest = solution.lowest_point
    yield fact("z", lowest.z, "lowest_point", symbol="")
    yield fact("x", lowest.x, "lowest_point_from_the_anchor", symbol="")
    for each in solution.touchdowns:
        yield fact("x", each.x, "touchdown_from_the_anchor", symbol="")
    yield fact("height", solution.sag, "sag", symbol="")


def force_name(solutions: Iterable[Solution]) -> Message:
    """Name the horizontal force at the fairlead: by its end where it is another at an anchor."""
    if any(each.force_varies for each in solutions):
        return Message("columns.fairlead_horizontal_force")
    return Message("quantities.horizontal_force")


def forces_at_ends(of: Rows, first: str, second: str) -> Iterator[blocks.Column]:
    """Yield the horizontal force of lines; where it varies along one that at both ends, named."""
    if not any(each.force_varies for each in of.rows):
        yield from of.own("horizontal_force")
        return
    for name, end in ((first, "anchor"), (second, "fairlead")):
        both = f"{end}.horizontal_force"
        yield of.measured("horizontal_force", both, name, symbol="", only="files")
        yield of.measured("horizontal_force", both, f"{name}_short", symbol="", only="people")


def _of_current(solution: Solution) -> Iterator[blocks.Fact]:
    """Say what a current does to the whole line, and what holds its fairlead across."""
    if solution.method != "shooting":
        return
    found = cast("SolutionInCurrent", solution)
    for k, name in enumerate(("drag_along_x", "drag_along_y")):
        yield fact("horizontal_force", found.drag[k], name, symbol="")
    side = found.fairlead_force[1]
    yield fact("horizontal_force", side, "force_across_at_the_fairlead", symbol="")


def residual_facts(solution: Solution) -> tuple[blocks.Fact, ...]:
    """List by how much the line misses its fairlead, and what rounding leaves of its forces."""
    residual = solution.residual
    return (
        fact("residual", residual.height, "residual_of_the_height"),
        fact("residual", residual.span, "residual_of_the_span"),
        _force("tension", residual.force_uncertainty, "force_left_open", symbol=""),
    )


def segments_table(solution: Solution) -> blocks.Table:
    """Tabulate the segments under load, from the anchor to the fairlead."""
    of, factor = Rows(solution.segments), solution.safety_factor
    files, largest = (
        of.measured("tension", "max_tension", "largest_tension", only=only)
        for only in ("files", "people")
    )
    return tabulate(
        "segments",
        *_named("segment", of),
        *of.own("length"),
        files,
        _in_tf(files),
        largest,
        _in_tf(largest),
        *of.own("MBL"),
        measured("safety_factor", [factor] * len(of.rows), only="files"),
        of.measured("utilisation", lambda each: each.utilisation(factor)),
        caption=Message("captions.segments_under_load"),
    )


def point_loads_table(solution: Solution) -> blocks.Table:
    """Tabulate clump weights and buoys under load."""
    of = Rows(solution.point_loads)
    return tabulate(
        "point_loads",
        *_named("point_load", of),
        *of.own("position", "x", "z", "seabed_reaction"),
        caption=Message("captions.point_loads_under_load"),
    )


def profile_table(solution: Solution, *, only: blocks.For = "all") -> blocks.Table:
    """Tabulate shape and tension along the line, from the anchor to the fairlead."""
    shape = solution.profile(_PROFILE_POINTS)
    tension = measured("tension", shape.tension)
    rows = len(tension.values)
    return tabulate(
        "profile",
        measured("s", shape.s),
        measured("x", shape.x),
        measured("z", shape.z),
        tension,
        replace(_in_tf(tension), only="people"),
        caption=Message("captions.along_the_line"),
        shown=tuple(sorted({*range(0, rows, _SHOWN_EVERY), rows - 1})),
        only=only,
    )


def how_it_hangs(solution: Solution) -> Message:
    """Say how the line hangs; with the touchdown at its anchor nothing of it lies on the bed."""
    at_anchor = solution.grounded_length <= _NO_LENGTH * solution.line.length
    level = abs(solution.anchor.vertical_force) <= _NO_LENGTH * solution.fairlead.tension
    hangs = solution.regime == "suspended" and solution.anchor_height == 0.0
    if (solution.regime == "grounded" and at_anchor) or (hangs and level):
        return Message("solution.just_level")
    return Message(f"solution.{solution.regime.replace('-', '_')}")


def method_name(method: str) -> Message:
    """Name how a line was solved."""
    keys = {"closed-form": "closed_form", "pso": "swarm", "shooting": "shooting"}
    return Message(f"solution.{keys[method]}")


# ------------------------------------------------------------------ the swarm


def _swarm(case: Case, solution: Solution) -> Iterator[blocks.Section]:
    swarm = solution.swarm
    if swarm is None:
        return
    history, runs = swarm_tables(swarm)
    _, objective, tension, *_ = (each.name for each in history.columns)
    decades, caption = _decades(swarm.best_objective_history), Message("captions.particle_swarm")
    yield section(
        "captions.swarm",
        history,
        runs,
        swarm_settings(case.swarm),
        blocks.Facts("swarm", tuple(flown_facts(swarm)), caption, only="people"),
        blocks.Graph(objective, "swarm_history", x=0, y=(1,), log=decades),
        blocks.Graph(tension, "swarm_history", x=0, y=(2,)),
    )


def swarm_settings(settings: SwarmSettings) -> blocks.Facts:
    """List the settings of a swarm, in workbooks."""
    counts = ("particles", "iterations", "runs", "seed")
    facts = (
        *(stated(key, getattr(settings, key)) for key in counts),
        fact("coefficient", settings.cognitive, "cognitive_coefficient_c1"),
        fact("coefficient", settings.social, "social_coefficient_c2"),
        fact("coefficient", settings.inertia, "inertia_w"),
        stated("boundary_handling", settings.boundary),
    )
    return blocks.Facts("swarm_settings", facts, Message("captions.swarm"), only="workbook")


def swarm_tables(swarm: SwarmReport) -> tuple[blocks.Table, blocks.Table]:
    """Tabulate the best run by iteration, and where each run ended."""
    tension = measured("tension", swarm.tension_history, "fairlead_tension")
    history = tabulate(
        "swarm_history",
        texts("iteration", range(1, len(tension.values) + 1)),
        measured("objective", swarm.best_objective_history, "best_objective"),
        tension,
        _in_tf(tension),
        only="files",
    )
    count = len(swarm.objectives)
    best = [Message("answers.yes") if k + 1 == swarm.best_run else "" for k in range(count)]
    runs = tabulate(
        "swarm_runs",
        texts("run", range(1, count + 1)),
        measured("objective", swarm.objectives),
        texts("iterations_flown", swarm.iterations_flown or [swarm.iterations] * count),
        texts("best_run", best),
        only="files",
    )
    return history, runs


def flown_facts(swarm: SwarmReport) -> Iterator[blocks.Fact]:
    """List what came of a swarm, and how far it is from the closed form."""
    of_runs = Message("solution.of_runs", run=swarm.best_run, runs=swarm.runs, seed=swarm.seed)
    converged = Message("solution.part_of", part=swarm.converged_runs, whole=swarm.runs)
    yield fact("objective", swarm.objective, "best_objective")
    yield stated("best_run", of_runs)
    yield stated("runs_converged", converged)
    yield stated("evaluations_of_f", swarm.evaluations)
    yield stated("iterations_a_run_at_most", swarm.iterations)
    yield fact("residual", swarm.span_consistency, "span_by_equation_5")
    names = {
        "angle_rad": ("solution.less_angle", "angle_difference"),
        "grounded_length_m": ("solution.less_grounded", "residual"),
        "span_m": ("solution.less_span", "residual"),
        "tension_N": ("solution.less_tension", "force_difference"),
    }
    for key, difference in swarm.closed_form_difference.items():
        name, quantity = names[key]
        said = Message("solution.swarm_less_closed_form", what=Message(name))
        yield fact(quantity, difference, said)


def _decades(values: Sequence[float]) -> tuple[float, float] | None:
    """Find the powers of ten around the positive values; None when there are none."""
    positive = [value for value in values if value > 0.0]
    if not positive:
        return None
    low, high = math.floor(math.log10(min(positive))), math.ceil(math.log10(max(positive)))
    return 10.0**low, 10.0 ** max(high, low + 1)


# ------------------------------------------------------------------ quantities in two units


def _force(key: str, value: float | None, name: str = "", **how: Any) -> blocks.Fact:
    return fact(
        key, value, name, also=(blocks.named(key, how.get("symbol")).in_units("tf"),), **how
    )


def _angle(value: float, name: str, symbol: str) -> blocks.Fact:
    return fact("angle", value, name, symbol=symbol, also=(blocks.named("angle_rad", symbol),))


def _in_tf(column: blocks.Column) -> blocks.Column:
    assert column.quantity is not None
    return replace(column, quantity=column.quantity.in_units("tf"))


_ROWS = 20


def curve_answer(result: CaseCurve) -> blocks.Answer:
    """Lay out a load curve, its marks, and the case that it belongs to."""
    case, reference = result.case, result.reference
    inputs = blocks.Facts("inputs", tuple(given_facts(case)), only="workbook")
    summary = blocks.Facts("summary", result_facts(reference), only="workbook")
    points, marks = points_table(result), marks_table(result)
    graph = blocks.Graph(case.title, points.name, x=0, y=(2, 3))
    carried = [segments_table(reference)]
    if reference.point_loads:
        carried.append(point_loads_table(reference))
    none = () if result.curve.marks else (blocks.Text(Message("curve.no_marks")),)
    return answered(
        "curve",
        case.title or Message("captions.mooring_line"),
        section("captions.curve", *_opening(result), points, graph),
        section("captions.marks", marks, *none, blocks.Warnings(reference.warnings)),
        section("captions.inputs", inputs, *map(_for_files, given_tables(case.line))),
        section("captions.results", summary, *map(_for_files, carried)),
    )


def _for_files(table: blocks.Table) -> blocks.Table:
    return replace(table, name=f"{table.name}_of_case", only="workbook")


def _opening(result: CaseCurve) -> Iterator[blocks.Text]:
    curve, reference = result.curve, result.reference
    yield blocks.Text(Message(f"curve.over_{result.over}", points=len(curve.span)))
    yield blocks.Text(Message("curve.range", range=result.range_words))
    found = reference.found
    if found is not None:
        (each,), condition = found_facts(reference), found.condition
        assert each.quantity is not None
        value = Measure(each.quantity.key, found.value)
        yield blocks.Text(Message("curve.found", name=each.name, value=value, condition=condition))
    if result.over == "offset":
        yield blocks.Text(Message("curve.zero", span=Measure("span", reference.span)))
    regime = Message(f"solution.{curve.regime[0].replace('-', '_')}")
    yield blocks.Text(Message("curve.lower_end", regime=regime))


def points_table(result: CaseCurve) -> blocks.Table:
    """Tabulate the points of a load curve, by rising span."""
    curve = result.curve
    count = len(curve.span)
    shown = tuple(sorted({round(k * (count - 1) / (_ROWS - 1)) for k in range(_ROWS)}))
    caption = Message("captions.some_points", shown=len(shown), points=count)
    return tabulate(
        "curve",
        *_places(result, curve.span.tolist()),
        measured("horizontal_force", curve.horizontal_force, force_name([result.reference])),
        measured("tension", curve.fairlead_tension, "fairlead_tension"),
        measured("tension", curve.anchor_tension, "anchor_tension", symbol="TA"),
        measured("angle", curve.anchor_angle, "inclination_at_the_anchor", symbol="theta0"),
        measured("grounded_length", curve.grounded_length),
        measured("stiffness", curve.stiffness),
        texts("regime", map(term, curve.regime), only="files"),
        caption=caption if len(shown) < count else Message("captions.curve_points"),
        shown=shown,
    )


def marks_table(result: CaseCurve) -> blocks.Table:
    """Tabulate where something changes along a load curve, by rising span."""
    of = Rows(result.curve.marks)
    return tabulate(
        "curve_marks",
        of.texts("kind", lambda mark: Message(f"curve.{mark.kind}"), only="files"),
        of.texts("what_happens", "event"),
        *_places(result, of.read("span")),
        of.measured("horizontal_force", "horizontal_force", force_name([result.reference])),
        of.measured("tension", "fairlead_tension", "fairlead_tension"),
        caption=Message("captions.marks"),
    )


def _places(result: CaseCurve, spans: Sequence[float]) -> tuple[blocks.Column, blocks.Column]:
    """List span and offset; people see the one that was not left out by what is stepped."""
    zero, of_offset = result.reference.span, result.over == "offset"
    return (
        measured("span", spans, only="files" if of_offset else "all"),
        measured("offset", [each - zero for each in spans], only="all" if of_offset else "files"),
    )
