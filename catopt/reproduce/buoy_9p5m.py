"""S1: the marker buoy on 20 m of chain in 9.5 m of water, Tables 1 to 3."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from catopt.model import Line, Segment, SwarmSettings
from catopt.progress import Progress
from catopt.reproduce.items import (
    TF,
    Drawn,
    Interval,
    Item,
    Printed,
    Published,
    Study,
    by_order,
    compare,
    interval,
    item_of,
    not_reproducible,
    published,
    study_of,
)
from catopt.units import UNITS, Dimension
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution

NAME = "buoy_9p5m"

ZERO = 1e-12
"""m: below it S1's objective, a sum of two lengths of about 10 m, is zero but for rounding."""

_RESULTS = ("theta0_rad", "offset_m", "tension_tf")
_KGF_PER_M = UNITS[Dimension.FORCE_PER_LENGTH]["kgf/m"]
_WEIGHTS = (9.0, 10.5)  # kgf/m, where the intervals of the weight are looked for


def study(progress: Progress | None = None) -> Study:
    """Recompute the buoy by swarm and in closed form and judge every printed number."""
    source = published(NAME)
    solution = _solve_by_swarm(source, progress)
    by_swarm = _results(solution)
    in_closed_form = _results(_hang(source.inputs["submerged_weight_kgf_per_m"]))
    values: dict[str, object] = {"weight": source.inputs["submerged_weight_kgf_per_m"]}
    for name, key in zip(("angle", "offset", "tension"), _RESULTS, strict=True):
        printed = source.printed["pso"][key]
        values[name] = printed.text
        values[f"{name}_low"], values[f"{name}_high"] = _weights_for(key, printed).ends(3)
    return study_of(
        source,
        items=(
            *_swarm_items(source, by_swarm),
            *compare(source, "fem", in_closed_form),
            *compare(source, "analytic", in_closed_form),
            *_error_items(source, "fem", by_swarm),
            *_error_items(source, "analytic", by_swarm),
        ),
        findings=(
            Message("reproduce.results_by_finite_elements_analytic"),
            Message("reproduce.weight", **values),
            _about_the_tension(source),
            Message("reproduce.printed_objective_3_55e_15", limit=ZERO),
        ),
        drawn=(Drawn("20 m of chain under 0.343 tf", solution),),
        by_swarm=solution,
    )


# ------------------------------------------------------------------ solving


def _line(weight: float) -> Line:
    """Build the buoy's line; weight in kgf/m."""
    length = published(NAME).inputs["line_length_m"]
    return Line([Segment(length, weight * _KGF_PER_M)])


@cache
def _hang(weight: float) -> Solution:
    """Solve in closed form; weight in kgf/m."""
    from catopt.catenary.solve import solve

    given = published(NAME).inputs
    force = given["horizontal_force_tf"] * TF
    return solve(_line(weight), height=given["water_depth_m"], horizontal_force=force)


def _solve_by_swarm(source: Published, progress: Progress | None) -> Solution:
    from catopt.catenary.swarm import solve_swarm

    given = source.inputs
    particles, iterations, runs = (int(given[key]) for key in ("particles", "iterations", "runs"))
    return solve_swarm(
        _line(given["submerged_weight_kgf_per_m"]),
        height=given["water_depth_m"],
        horizontal_force=given["horizontal_force_tf"] * TF,
        settings=SwarmSettings(particles=particles, iterations=iterations, runs=runs),
        progress=None if progress is None else lambda done: progress(done, runs),
    )


def _results(solution: Solution) -> dict[str, float]:
    """Pick what S1 prints, in its units."""
    results = {
        "theta0_rad": solution.anchor.angle,
        "offset_m": solution.span,
        "tension_tf": solution.fairlead.tension / TF,
    }
    if solution.swarm is not None:
        results["objective_m"] = solution.swarm.objective
    return results


# ------------------------------------------------------------------ judging


def _swarm_items(source: Published, ours: dict[str, float]) -> tuple[Item, ...]:
    table = source.printed["pso"]
    zero, wall_time = table["objective_m"], table["wall_time_s"]
    objective = by_order(zero, ours["objective_m"], ZERO, "m")
    other_machine = not_reproducible(Message("reproduce.authors_machine"))
    results = {key: table[key] for key in _RESULTS}
    return (
        *compare(source, "pso", ours, computed_by="pso", printed=results),
        item_of(source, "pso", "objective_m", zero, objective, ours["objective_m"], "pso"),
        item_of(source, "pso", "wall_time_s", wall_time, other_machine),
    )


_FROM_DIGITS = {
    "theta0_rad": "reproduce.theta0_from_digits",
    "offset_m": "reproduce.offset_from_digits",
    "tension_tf": "reproduce.tension_from_digits",
}


def _error_items(source: Published, method: str, ours: dict[str, float]) -> tuple[Item, ...]:
    """Judge Table 3: how far the swarm is from a method of reference [4], in percent.

    Only the numbers as printed give Table 3: |0.446 - 0.450| / 0.450 is 0.89 %, from the
    unrounded tension of the swarm it would be 0.82 %. So ours is rounded likewise.
    """
    table, errors, remarks = {}, {}, {}
    for key, printed in source.printed["error_percent"].items():
        quantity = f"{key.rpartition('_')[0]}_error_percent"
        reference = source.printed[method][key]
        rounded = source.printed["pso"][key].rounding(ours[key])
        table[quantity] = printed
        errors[quantity] = _percent(float(rounded), reference.value)
        unrounded = printed.rounding(_percent(ours[key], reference.value))
        if unrounded != printed.text:
            from_digits = f"|{rounded} - {reference.text}| / {reference.text}"
            remarks[quantity] = Message(
                _FROM_DIGITS[key], computed=from_digits, unrounded=unrounded
            )
    return compare(source, f"pso against {method}", errors, remarks, "pso", table)


def _percent(value: float, reference: float) -> float:
    return 100.0 * abs(value - reference) / reference


# ------------------------------------------------------------------ findings


def _weights_for(key: str, printed: Printed) -> Interval:
    """Find the weights, kgf/m, for which a quantity prints so."""
    return interval(lambda weight: _results(_hang(weight))[key], printed, _WEIGHTS)


def _about_the_tension(source: Published) -> str:
    printed = source.printed["analytic"]["tension_tf"]
    weights = _weights_for("tension_tf", printed)
    ends = [_results(_hang(weight)) for weight in (weights.least, weights.largest)]
    values: dict[str, object] = {}
    for name, key in (("angle", "theta0_rad"), ("offset", "offset_m")):
        table = source.printed["analytic"][key]
        values[f"{name}_low"], values[f"{name}_high"] = sorted(
            table.rounding(end[key]) for end in ends
        )
    tension = _results(_hang(source.inputs["submerged_weight_kgf_per_m"]))["tension_tf"]
    force = source.inputs["horizontal_force_tf"]
    low, high = weights.ends(3)
    return Message(
        "reproduce.tension",
        tension=printed.text,
        low=low,
        high=high,
        ratio=tension / force,
        same=printed.text,
        force=force * printed.value / tension,
        printed=force,
        ours=tension,
        rounded=tension,
        again=printed.text,
        **values,
    )
