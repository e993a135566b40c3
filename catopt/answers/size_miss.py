"""What a sizing says where no line passes: the nearest miss, and what would help."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from catopt.answers.blocks import Answer, Brief, Text
from catopt.answers.check import demand_and_capacity
from catopt.catalogue.choice import chosen
from catopt.catalogue.family import chain_words
from catopt.checks.kinds import is_wanted
from catopt.model import CatalogueChoice
from catopt.words import Message, Several

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult
    from catopt.design.neighbours import NoFeasibleDesignError
    from catopt.design.result import NearMiss
    from catopt.sizing.known import ResolvedInputs

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
        if error.in_motion is not None and of.moored == "tanker":
            options = {name: of.errors.spell(name) for name in ("lines", "seeds")}
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
        "sliding": ("anchor", "soil", "sinker"),
    }
    for name in ways.get(kind, ()):
        is_thinnest = kind == "buoyancy" and name == "chain" and size <= _thinnest(of) + _SAME_SIZE
        if _is_open(name, of) and not is_thinnest:
            yield Message(f"sizing.try_{name}", option=of.errors.spell(name))


def _is_open(name: str, of: ResolvedInputs) -> bool:
    """Whether an input is one of those that count here, and has room left in the wanted way."""
    match name:
        case "diameter_max":
            return _is_sold_above(of)
        case "chain":
            return _has_higher_grade(of)
        case "life":
            return bool(of["life"] and of["wear"])
        case "max_swing" | "reserve_buoyancy":
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


def _is_sold_above(of: ResolvedInputs) -> bool:
    """Whether a larger size is sold than those that were tried."""
    most: float = of["diameter_max"] or of.made_for[1]
    return max(_sold(of)) > most + _SAME_SIZE


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
