"""A sizing on one screen: the line, its verdict, six numbers; or the nearest miss."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    TO_BE_KNOWN,
    Answer,
    Brief,
    CardBlock,
    Fact,
    Facts,
    Rows,
    Text,
    Value,
    Verdict,
    about,
    answered,
    largest,
    rounded,
    section,
    tabulate,
    texts,
)
from catopt.answers.check import demand_and_capacity
from catopt.catalogue.choice import chosen
from catopt.catalogue.family import chain_words
from catopt.checks.kinds import is_wanted
from catopt.constants import YEAR
from catopt.loads.ship import SHORTEST
from catopt.model import CatalogueChoice
from catopt.sizing.quick import MARGIN
from catopt.units import lasting
from catopt.verify.convergence_check import LIMIT
from catopt.words import Measure, Message, Sentence, Several, is_said, term

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult
    from catopt.checks.verdict import Judgement
    from catopt.design.neighbours import NoFeasibleDesignError
    from catopt.design.result import NearMiss
    from catopt.sizing import Sizing
    from catopt.sizing.alternatives import Alternative
    from catopt.sizing.in_motion import Band, InMotion, LineTried
    from catopt.sizing.input_values import ResolvedInputs


_OTHERS = ("practice", "balanced", "shortest", "least-swing", "lightest", "cheapest")
"""Preferences by how much their lines matter beside the recommended one."""
_MOST_OTHERS = 3
_NUMBERS = 6


def size_card(of: Sizing, *, with_others: bool = True) -> tuple[CardBlock, ...]:
    """Lay out what is recommended on one screen, with other lines in words where wanted."""
    (code, *_) = of.case.checks.codes
    run: tuple[Brief, ...] = ()
    if of.in_motion is not None:
        run = tuple(_of_the_runs(of.in_motion))
    briefs = (
        *run,
        Brief(of.departures, Message("sizing.card_departs", code=code), 2),
        Brief((of.practice,), Message("sizing.card_practice"), 3),
        Brief(of.fittings, Message("sizing.card_fittings")),
        *(_others(of) if with_others else ()),
        Brief(tuple(_assumed(of)), Message("sizing.card_assumed"), 3),
        Brief(tuple(_to_be_known(of)), TO_BE_KNOWN, 2),
    )
    return (
        Text(of.one_line),
        Verdict.of_judgement(of.judgement),
        Facts("size_card", tuple(_numbers(of))[:_NUMBERS]),
        *(each for each in briefs if any(each.said)),
    )


def fleet_answer(every: Sequence[Sizing]) -> Answer:
    """Lay out a fleet, a row a mooring: its line, what it takes, and its verdict."""
    of = Rows(every)
    found = [each.judgement for each in every]
    table = tabulate(
        "fleet",
        texts("no", range(1, len(every) + 1)),
        of.texts("title", lambda each: each.case.title),
        of.texts("line", "one_line"),
        of.measured("length", "swing.total", "sizing.card_swing", symbol=""),
        texts("verdict", map(_in_a_word, found), passes=tuple(_is_green(e) for e in found)),
        texts("not_judged", [Several((e.said for e in each.not_judged), ", ") for each in found]),
    )
    return answered("fleet", Message("sizing.fleet"), section("sizing.fleet", table))


def _in_a_word(of: Judgement) -> Message:
    if of.colour == "amber":
        return Message("answers.passes_in_part")
    return Message("answers.passes" if of.passes else "answers.fails")


def _is_green(of: Judgement) -> bool | None:
    return None if of.colour == "amber" else of.passes


def _numbers(of: Sizing) -> Iterator[Fact]:
    """Yield the numbers that decide, the first ones first."""
    _, solution = of.hardest
    force = largest(each.horizontal_force for _, each in of.intact)
    swing = "swing" if of.pattern is None else "swing_line_out"
    yield _measured(swing, "length", of.swing.total)
    is_still = of.in_motion is None
    if of.pattern is None:
        yield _measured("force" if is_still else "rest_force", "horizontal_force", force)
    else:
        lost = max(each.line_out.line_force for each in of.pattern.states)
        own, without = (about("horizontal_force", each) for each in (force or 0.0, lost))
        said = Message("sizing.and_with_a_line_lost", value=own, lost=without)
        yield _worded("line_force" if is_still else "rest_line_force", said)
    if of.in_motion is not None:
        yield from _in_motion(of.in_motion)
        yield _measured("mass", "mass", of.point.line.mass)
        return
    yield _measured("tension", "tension", solution.fairlead.tension)
    yield from _strength(of)
    if of.reserve_buoyancy is not None:
        pull = largest(each.fairlead.vertical_force for _, each in of.point.checks.solutions)
        if of.pattern is not None:
            pull = of.pattern.largest_pull
        own, most = (about("vertical_force", e) for e in (pull or 0.0, of.reserve_buoyancy))
        yield _worded("pull", Message("sizing.out_of", value=own, most=most))
    size = of.drag_anchor or (of.sinker if of.kind == "tanker" else None)
    if size is not None and size.factor is not None:
        values = {"factor": size.factor, "wanted": size.safety_factor}
        yield _worded("holding", Message("sizing.factor", **values))
    if of.chain_life is not None:
        yield _worded("life", Message("sizing.after_years", years=of.chain_life / YEAR))
    yield _measured("mass", "mass", of.point.line.mass)


def _in_motion(of: InMotion) -> Iterator[Fact]:
    """Yield the tension in the storm beside that at rest, and the factor that this is."""
    storm = of.storm
    probable = about("tension", storm.tension)
    said = Message("sizing.measure", value=probable)
    if storm.low is not None and storm.high is not None:
        ends = {"low": about("tension", storm.low), "high": about("tension", storm.high)}
        said = Message("sizing.from_to", value=probable, **ends)
    yield Fact(Message("sizing.card_tension_in_storm", time=storm_time(of)), said)
    yield _measured("tension_at_rest", "tension", storm.at_rest)
    own = of.own_slide
    if of.is_of_ship:
        factors = {"factor": of.factor, "allowance": of.allowance}
        yield _worded("motion_factor", Message("sizing.in_place_of", **factors))
    elif own is not None and of.case.anchor is not None:
        values = {"way": own.expected, "upper": own.upper, "most": of.case.anchor.max_slide}
        slides = Message("sizing.slides", **values)
        yield Fact(Message("sizing.card_slides", time=storm_time(of)), slides)


def storm_time(of: InMotion) -> str:
    """Say how long the storm lasts in which lines were run."""
    assert of.case.dynamics is not None
    return lasting(of.case.dynamics.duration_of_interest)


def less_words(of: LineTried) -> Message:
    """Say of a line that it fails, and by what."""
    why = Message(f"checks.{of.failing[0].kind}_short") if of.failing else of.reason
    size = round(1e3 * of.diameter, 6)
    return Message("sizing.less_fails", size=size, length=of.length, check=why)


def runs_words(of: InMotion) -> Message:
    """Say how lines were run, and what the checks are held against."""
    said = Message(
        "sizing.runs_of" if of.load_cases > 1 else "sizing.runs_of_one",
        seeds=of.how.seeds,
        time=lasting(of.how.duration),
        states=of.load_cases,
        judged=Message(f"sizing.judged_{of.how.judged_by.replace('-', '_')}", time=storm_time(of)),
    )
    for key, count in (("seas", len(of.how.periods)), ("directions", of.directions)):
        if count > 1:
            said = Message(f"sizing.runs_of_{key}", runs=said, count=count)
    if of.how.quick:
        quick = "ship" if of.is_of_ship else "buoy"
        said = Message(f"sizing.runs_quick_{quick}", runs=said, margin=of.how.margin)
    return said


def counted_words(of: InMotion) -> Message:
    """Say how many lines were run, and how many by the fast judgement before."""
    if not of.fast:
        return of.counted.words
    fast = {"count": len(of.fast), "margin": MARGIN}
    return Message("sizing.lines_run_after", run=of.counted.words, **fast)


def band_words(of: Band) -> Message:
    """Say what a ship's tension is over the ranges of what decides it."""

    def said(tension: float | None) -> Measure | Message:
        return Message("sizing.band_none") if tension is None else about("tension", tension)

    reaches = (
        Message(
            f"sizing.band_{each.cause}", low=said(each.favourable), high=said(each.unfavourable)
        )
        for each in of.reaches
    )
    return Message("sizing.band", middle=said(of.middle), reaches=Several(reaches, ", "))


def seas_words(of: InMotion) -> Message:
    """Say in which seas lines were run, and which decides each kind of check."""
    governs = "sizing.governs_in_sea_of_height" if of.how.heights else "sizing.governs_in_sea"
    kinds = (
        Message(
            governs,
            check=Message(f"checks.{each.check.kind}_short"),
            height=each.height,
            period=each.period,
        )
        for each in of.seas
    )
    if of.how.heights:
        pairs = zip(of.how.heights, of.how.periods, strict=True)
        seas = "; ".join(f"{height:.3g} m, {period:.3g} s" for height, period in pairs)
        return Message("sizing.seas_of_heights", seas=seas, kinds=Several(kinds, "; "))
    periods = ", ".join(f"{each:.3g}" for each in of.how.periods)
    return Message("sizing.seas", periods=periods, kinds=Several(kinds, "; "))


def _strength(of: Sizing) -> Iterator[Fact]:
    """Yield the factor of strength that a buoy's codes, or a ship's, have a criterion on."""
    factors = {"proof": of.proof_factor, "mbl": of.break_factor}
    for key in sorted(factors, reverse=of.kind == "buoy"):
        if factors[key] is not None:
            yield _measured(key, "safety_factor", factors[key])
            return


def _measured(name: str, key: str, value: float | None) -> Fact:
    return Fact(Message(f"sizing.card_{name}"), value, rounded(key, value or 0.0))


def _worded(name: str, said: Value) -> Fact:
    return Fact(Message(f"sizing.card_{name}"), said)


def _of_the_runs(of: InMotion) -> Iterator[Brief]:
    """Yield how lines were run, and how many."""
    yield Brief((runs_words(of),), Message("sizing.card_runs"), 2)
    if of.band is not None:
        yield Brief((band_words(of.band),), Message("sizing.card_band"), 4)
    yield Brief((counted_words(of),), Message("sizing.card_in_motion"), 2)
    proof = proof_words(of)
    is_expected = of.is_of_ship and of.proof == "converged"  # of her smooth slow motion
    if proof is not None and not is_expected:
        yield Brief((proof,), Message("sizing.card_rerun"), 3)
    if of.seas:
        yield Brief((seas_words(of),), Message("sizing.card_seas"), 3)
    if of.own is not None:
        said = less_words(of.own)
        if of.own.passes:
            size = round(1e3 * of.own.diameter, 6)
            said = Message("sizing.own_passes", size=size, length=of.own.length)
        yield Brief((said,), Message("sizing.card_own"), 2)
    if of.less:
        failing = (less_words(each) for each in of.less)
        yield Brief((Several(failing, "; "),), Message("sizing.card_less"), 2)
    lengths = [
        Message(
            "sizing.card_at_length",
            length=each.tried.length,
            tension=about("tension", each.storm.tension),
        )
        for each in of.by_length
        if each.storm is not None
    ]
    if lengths:
        yield Brief((Several(lengths, "; "),), Message("sizing.card_by_length"), 2)


def _others(of: Sizing) -> Iterator[Brief]:
    """Yield the lines of other preferences, of those alike one."""
    by_line: dict[str, list[str]] = {}
    every = sorted(of.alternatives, key=lambda each: _OTHERS.index(each.prefer))
    for each in every[:_MOST_OTHERS]:
        by_line.setdefault(other_words(of, each), []).append(term(each.prefer))
    for said, names in by_line.items():
        yield Brief((said,), Several(names, ", "))


def other_words(of: Sizing, each: Alternative) -> str:
    """Say in a line what another preference would recommend."""
    if each.settled is None or each.swing is None:
        no_less = is_said(each.reason, "sizing.swings_no_less")
        return each.reason if no_less else Message("sizing.card_none")
    point, own = each.settled.point, of.point
    if (each.swing, point.line.mass) == (of.swing.total, own.line.mass):
        return Message("sizing.same_line")
    (first, *_), anchor = point.line.segments, point.anchor
    chain: str = chain_words(first.component, first.nominal_diameter)
    if first.component == own.line.segments[0].component:
        chain = Message("sizing.card_size", size=1e3 * (first.nominal_diameter or 0.0))
    held = ""
    if anchor is not None and anchor.mass is not None:
        key = "sizing.card_held_sinker" if of.drag_anchor is None else "sizing.card_held_anchor"
        held = Message(key, mass=Measure("mass", anchor.mass))
    return Message(
        "sizing.card_other",
        chain=chain,
        length=point.line.length,
        held=held,
        swing=about("length", each.swing),
    )


def _assumed(of: Sizing) -> Iterator[str]:
    """Yield what was taken because it was not given, but for what the lines above say."""
    said_above = {each.component for each in of.point.line.segments}
    if of.dynamic_factor > 1.0:
        yield Message("sizing.card_motion", factor=of.dynamic_factor)
    for each in of.defaults:
        is_above = each in said_above or is_said(each, "sizing.taken_code")
        if not is_above and not is_said(each, "sizing.beyond_scope"):
            yield each


def heel_words(moved: InMotion | None) -> Iterator[Message]:
    """Say how far the buoy heels in its runs, and whether its centre of gravity is assumed."""
    if moved is not None and moved.heel is not None:
        is_given = moved.how.centre_of_gravity is not None
        key = "sizing.heels_by_own" if is_given else "sizing.heels"
        mean = math.degrees(moved.mean_heel or 0.0)
        yield Message(key, heel=math.degrees(moved.heel), mean=mean)
        if moved.worst_change is None:
            yield Message("sizing.runs_made_once")


def proof_words(of: InMotion) -> Message | None:
    """Say what its runs came to when they were made again; None where they were not."""
    worst = of.worst_change
    if worst is None:
        return None
    values = {"how": Message(f"motion.how_{worst.way}"), "change": worst.size}
    values["what"] = Message(f"motion.largest_{worst.quantity.removeprefix('largest_')}")
    key = f"sizing.proof_{of.proof.replace(' ', '_')}"
    if of.proof == "converged" and worst.size > LIMIT and not worst.is_by_chance:
        key = "sizing.proof_small"
    if worst.chance is None:
        return Message(key, **values, chance="")
    by = Message("sizing.proof_chance", chance=worst.by_chance)
    return Message(key, **values, chance=by)


def slides_words(of: InMotion) -> Iterator[Message]:
    """Say how far the sinker slides in the storm, and the sizes beside it."""
    every = (
        Message("sizing.slides_of", mass=s.mass / 1e3, way=s.expected, upper=s.upper)
        for s in of.slides
    )
    if of.slides:
        yield Message("sizing.slides_by_mass", time=storm_time(of), slides=Several(every, "; "))


def _to_be_known(of: Sizing) -> Iterator[str]:
    """Yield what decides whether the answer may be used; what decides most comes first."""
    yield from of.breaking_seas()
    yield from heel_words(of.in_motion)
    yield from (each for each in of.defaults if is_said(each, "sizing.beyond_scope"))
    if any(is_said(each, "sizing.estimated_dimensions") for each in of.warnings):
        yield Message("sizing.card_estimated")
    if any(is_said(each, "sizing.small_craft") for each in of.warnings):
        yield Message("sizing.card_small_craft", shortest=SHORTEST)
    yield from of.advice
    said = [Sentence(each, capital=True) for each in of.breaking_seas()]
    shorter = ("sizing.estimated_dimensions", "sizing.small_craft")
    for each in of.warnings:
        if each not in said and not any(is_said(each, key) for key in shorter):
            yield each
    if of.recalled:
        yield Message("loads.recalled", names=Several(of.recalled, ", "))


_SAME_SIZE = 1e-6


def miss_answer(error: NoFeasibleDesignError, of: ResolvedInputs) -> Answer:
    """Lay out on one screen why nothing passes; `of` is what was asked for."""
    miss = error.near_miss
    card: list[Text | Brief] = []
    if error.in_motion is not None:
        card += [Text(Message("sizing.none_in_motion")), Text(error.in_motion)]
    if miss is not None:
        (first, *_) = miss.line.segments
        chain = chain_words(first.component, first.nominal_diameter)
        card.append(Text(Message("sizing.miss_nearest", chain=chain, length=miss.line.length)))
        card += [Brief((said,), name, 2) for name, said in _worst(miss)]
        thin = first.nominal_diameter or 0.0
        helping = [said for kind in _kinds(miss) for said in _helps(kind, of, thin)]
        if error.in_motion is not None and not of["in_motion"]:
            option = of.errors.spell("in_motion")
            helping.insert(0, Message("sizing.miss_helps_quick", in_motion=option))
        if error.in_motion is not None and of.moored == "tanker":
            options = {"lines": _several_lines(of), "seeds": of.errors.spell("seeds")}
            helping.append(Message("sizing.miss_helps_ship", **options))
        elif error.in_motion is not None:
            options = {"scope": of.errors.spell("scope_max"), "code": of.errors.spell("code")}
            helping.append(Message("sizing.miss_helps_motion", **options))
        advice = dict.fromkeys(helping)
        if advice:
            helps = Message("sizing.miss_helps", advice=Several(advice))
            card.append(Text(helps))
    return Answer("size", Message("sizing.miss"), (), card=tuple(card))


def _kinds(miss: NearMiss) -> dict[str, CheckResult]:
    """Take the worst check of each kind."""
    found: dict[str, CheckResult] = {}
    for each in miss.failing:
        found.setdefault(each.kind, each)
    return found


def _worst(miss: NearMiss) -> Iterator[tuple[str, str]]:
    if not miss.failing:
        yield "", miss.reason
    for kind, check in _kinds(miss).items():
        values = {"load_case": check.load_case, **demand_and_capacity(check)}
        wants = "wanted" if is_wanted(check.kind) else "allowed"
        yield Message(f"checks.{kind}_short"), Message(f"sizing.miss_{wants}", **values)


# ------------------------------------------------------------------ what would help


def _helps(kind: str, of: ResolvedInputs, size: float) -> Iterator[Message]:
    """Yield what would help against a kind of check, of inputs that are not at their end.

    A higher grade is lighter only where the nearest line, of a size in m, might be thinner.
    """
    weight = ("clump_weight",) if of.moored == "tanker" else ()
    ways = {
        "tension": ("diameter_max", "chain", "life"),
        "uplift_angle": ("diameter_max", *weight),
        "grounded_length": ("diameter_max",),
        "span": ("max_swing", "diameter_max", *weight, "lines"),
        "buoyancy": ("buoy", "reserve_buoyancy", "chain"),
        "sliding": ("anchor", "soil", "sinker", "base_area"),
    }
    for name in ways.get(kind, ()):
        is_thinnest = kind == "buoyancy" and name == "chain" and size <= _thinnest(of) + _SAME_SIZE
        if _is_open(name, of) and not is_thinnest:
            option = _several_lines(of) if name == "lines" else of.errors.spell(name)
            yield Message(f"sizing.try_{name}", option=option)


def _several_lines(of: ResolvedInputs) -> str:
    """Say how several lines are asked for: in place of a limit on the swing, which is of one."""
    option = of.errors.spell("lines")
    if "max_swing" not in of.given:
        return option
    return Message("sizing.lines_for_swing", lines=option, swing=of.errors.spell("max_swing"))


def _is_open(name: str, of: ResolvedInputs) -> bool:
    """Whether an input is one of those that count here, and has room left in the wanted way."""
    match name:
        case "diameter_max":
            largest_tried = of["diameter_max"] or of.made_for[1]
            return bool(max(_sold(of)) > largest_tried + _SAME_SIZE)
        case "chain":
            return _has_higher_grade(of)
        case "life":
            return bool(of["life"] and of["wear"])
        case "max_swing" | "reserve_buoyancy" | "base_area":
            return name in of.given
        case "buoy":
            return of["buoy"] is not None
        case "anchor":
            return of.moored == "tanker" and of["sinker"] is not None
        case "lines":
            return of.moored == "tanker" and bool(of["lines"] == 1)
        case "soil":
            # A code's own friction is no less than that of any soil.
            return of["friction"] is None and ("soil" in of.given or of.moored == "tanker")
        case "sinker":
            return bool(of["sinker"] == "concrete")
    return True


def _sold(of: ResolvedInputs) -> list[float]:
    catalogue = chosen(CatalogueChoice(allow_recalled=bool(of["recalled"])), of["water_density"])
    return [each.nominal_diameter for name in of["chain"] for each in catalogue.sold(name)]


def _thinnest(of: ResolvedInputs) -> float:
    """Return the least size that was tried, m."""
    least: float = of["diameter_min"] or of.made_for[0]
    return min(each for each in _sold(of) if each >= least - _SAME_SIZE)


def _has_higher_grade(of: ResolvedInputs) -> bool:
    """Whether a higher grade is made of a chain than those that were tried."""
    families = chosen(CatalogueChoice(), of["water_density"]).families
    for name in of["chain"]:
        parsed = families.parse_name(name)
        grades = list(families.family(parsed.family).grades)
        if parsed.grade in grades and parsed.grade != grades[-1]:
            return True
    return False
