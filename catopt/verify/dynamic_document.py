"""Lines in motion as the part ``dynamic`` of the document catopt.verify/1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.fem.energy_balance import EnergyBalance
    from catopt.fem.extremes import Extreme
    from catopt.verify.dynamic_result import (
        DynamicPart,
        DynamicRun,
        DynamicVerification,
        OverRuns,
    )
    from catopt.verify.proof import Again


def dynamic_document(found: DynamicVerification) -> dict[str, Any]:
    """Build the part of a case in motion; all in SI. Series are in the files of ``--out``."""
    return {
        "is_complete": found.is_complete,
        "verdict": found.verdict,
        "drag_axial_area": "D",
        "body": [_quantity(each) for each in found.body],
        "initial_friction": found.case.dynamics.initial_friction if found.case.dynamics else None,
        "load_cases": [_part(part) for part in found.parts],
    }


def _part(part: DynamicPart) -> dict[str, Any]:
    return {
        "load_case": part.name,
        "line": part.line,
        "is_complete": part.is_complete,
        "elements": part.elements,
        "quantities": [_quantity(each) for each in part.quantities],
        "max_tension_N": part.max_tension,
        "quasi_static_max_tension_N": part.quasi_static_max,
        "amplification": part.amplification,
        "slack_time_s": part.slack_time,
        "longest_slack_s": part.longest_slack,
        "verdict": part.verdict,
        "proof": part.proof,
        "changes": [
            {"quantity": each.quantity, "way": each.way, "change": each.size}
            for each in part.changes
        ],
        "anchor_at_rest": {f"{key}_N": value for key, value in part.anchor_at_rest.items()} or None,
        "numerical_part": part.numerical_part,
        "runs": [_run(run) for run in part.runs],
        "remarks": list(part.remarks),
    }


def _quantity(each: OverRuns) -> dict[str, Any]:
    return {
        "quantity": each.quantity,
        "unit": each.unit,
        "mean": each.mean,
        "std": each.std,
        "max": each.maximum,
        "min": each.minimum,
        "most_probable_max": each.most_probable_maximum,
        "tail": _tail(each),
        "gumbel": _gumbel(each),
    }


def _tail(each: OverRuns) -> dict[str, Any] | None:
    tail = each.tail
    if tail is None:
        return None
    return _extreme(tail.extreme) | {
        "mean": tail.mean,
        "threshold": tail.threshold,
        "scale": tail.scale,
        "shape": tail.shape,
        "peaks": tail.peaks,
        "peaks_above": len(tail.clusters),
        "time_s": tail.time,
    }


def _gumbel(each: OverRuns) -> dict[str, Any] | None:
    found = each.gumbel
    if found is None:
        return None
    return _extreme(found.extreme) | {
        "mode": found.mode,
        "scale": found.scale,
        "runs": found.runs,
        "run_s": found.run,
    }


def _extreme(extreme: Extreme) -> dict[str, Any]:
    return {
        "duration_s": extreme.duration,
        "most_probable_max": extreme.most_probable,
        "low": extreme.low,
        "high": extreme.high,
        "confidence": extreme.confidence,
        "expected_max": extreme.expected,
    }


def _run(run: DynamicRun) -> dict[str, Any]:
    history = run.history
    tension = run.statistics("fairlead_tension")
    return {
        "run": run.number + 1,
        "is_complete": history.is_complete,
        "reached_s": float(history.time[-1]),
        "since_s": history.since,
        "time_step_s": history.step,
        "shortest_step_s": history.shortest_step,
        "steps": history.steps,
        "iterations": history.iterations,
        "halvings": history.halvings,
        "max_fairlead_tension_N": tension.maximum,
        "time_of_max_s": tension.time_of_maximum,
        "slack_time_s": history.line_slack_time(),
        "longest_slack_s": history.line_longest_slack(),
        "refinements": history.refinements,
        "energy": _energy(history.balance),
        "again": [_again(each) for each in run.again],
    }


def _energy(balance: EnergyBalance) -> dict[str, Any]:
    return {
        "put_in_J": balance.put_in,
        "ends_J": balance.ends,
        "water_J": balance.water,
        "kinetic_J": balance.kinetic,
        "elastic_J": balance.elastic,
        "potential_J": balance.potential,
        "drag_J": balance.drag,
        "bed_J": balance.bed,
        "friction_J": balance.friction,
        "line_damping_J": balance.damping,
        "numerical_J": balance.numerical,
    }


def _again(again: Again) -> dict[str, Any]:
    return {
        "way": again.way,
        "time_step_s": again.step,
        "elements": again.elements,
        "maxima": dict(again.maxima),
        "failure": again.failure,
    }
