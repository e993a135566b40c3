"""What the two models say as JSON documents: catopt.verify/1, at rest and in motion, and fatigue.

All in SI, the unit in the key; lives in years.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from catopt.constants import YEAR
from catopt.documents import figures

if TYPE_CHECKING:
    from catopt.fem.extremes import Extreme
    from catopt.verify.case import DesignVerification, FrontVerification
    from catopt.verify.compared import Compared
    from catopt.verify.dynamic_result import (
        DynamicPart,
        DynamicRun,
        DynamicVerification,
        OverRuns,
    )
    from catopt.verify.fatigue import FatigueReport, SegmentFatigue
    from catopt.verify.result import StaticComparison, Verification

_SCHEMA = "catopt.verify/1"
_ENERGIES = "put_in_J ends_J water_J kinetic_J elastic_J potential_J drag_J bed_J friction_J"


# ------------------------------------------------------------------ at rest


def verification_document(verification: Verification) -> dict[str, Any]:
    """Build the document of a case.

    ``static`` is the load case in which the models agree least, ``load_cases`` has all of them.
    """
    return {
        "schema": _SCHEMA,
        "title": verification.case.title,
        "verdict": verification.verdict,
        "static": _static(verification.static) if verification.parts else None,
        "dynamic": None,
        "load_cases": [_static(part) for part in verification.parts],
    }


def front_document(front: FrontVerification) -> dict[str, Any]:
    """Build the document of a front; ``static`` is the design on which they agree least."""
    return {
        "schema": _SCHEMA,
        "title": front.title,
        "verdict": front.verdict,
        "static": None if front.static is None else _static(front.static),
        "dynamic": None,
        "designs": [_design(each) for each in front.designs],
    }


def _design(each: DesignVerification) -> dict[str, Any]:
    found = each.verification
    return {
        "design": each.design.number,
        "verdict": "no answer" if found is None else found.verdict,
        "failure": each.failure,
        "load_cases": [] if found is None else [_static(part) for part in found.parts],
    }


def _static(part: StaticComparison) -> dict[str, Any]:
    """Build the part of one load case."""
    return {
        "load_case": part.name,
        **figures(part, "kind verdict tolerance"),
        "closed_form": _by_key(part, lambda each: each.closed_form),
        "fem": _by_key(part, lambda each: each.extrapolated),
        "difference": _by_key(part, lambda each: each.difference),
        "worst": _name(part.worst) | {"gap": part.worst.gap},
        "meshes": [
            figures(mesh, "elements iterations residual penetration_m") for mesh in part.meshes
        ],
        "quantities": [_compared(each) for each in part.quantities],
        "remarks": list(part.remarks),
    }


def _by_key(part: StaticComparison, value: Callable[[Compared], float]) -> dict[str, Any]:
    """Lay values out by quantity, those of lines in a list, those of joints and bodies by name."""
    alone = [each for each in part.quantities if each.line is None]
    found: dict[str, Any] = {each.key: value(each) for each in alone if not each.point}
    if part.kind == "network":
        named: dict[str, dict[str, float]] = {}
        for each in alone:
            named.setdefault(each.point, {})[each.key] = value(each)
        found["points"] = named
    if part.kind != "line":
        found["lines"] = [
            {each.key: value(each) for each in part.quantities if each.line == k}
            for k in range(len(part.lines))
        ]
    return found


def _name(each: Compared) -> dict[str, Any]:
    line = None if each.line is None else each.line + 1
    point = {"point": each.point} if each.point else {}
    return {"quantity": each.quantity, "line": line, **point, "unit": each.unit}


def _compared(each: Compared) -> dict[str, Any]:
    own = "closed_form fem order is_smooth extrapolated difference_before difference scale"
    return _name(each) | figures(each, f"{own} allowed agrees")


# ------------------------------------------------------------------ in motion


def dynamic_document(found: DynamicVerification) -> dict[str, Any]:
    """Build the part ``dynamic`` of a case in motion. Series are in the files of ``--out``."""
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
        **figures(part, "line is_complete elements"),
        "quantities": [_quantity(each) for each in part.quantities],
        "max_tension_N": part.max_tension,
        "quasi_static_max_tension_N": part.quasi_static_max,
        **figures(part, "amplification slack_time_s longest_slack_s verdict proof"),
        "changes": [figures(each, "quantity way") | {"change": each.size} for each in part.changes],
        "anchor_at_rest": {f"{key}_N": value for key, value in part.anchor_at_rest.items()} or None,
        "numerical_part": part.numerical_part,
        "runs": [_run(run) for run in part.runs],
        "remarks": list(part.remarks),
    }


def _quantity(each: OverRuns) -> dict[str, Any]:
    tail, runs = each.tail, each.gumbel
    found = figures(each, "quantity unit mean std") | {
        "max": each.maximum,
        "min": each.minimum,
        "most_probable_max": each.most_probable_maximum,
        "tail": None,
        "gumbel": None,
    }
    if tail is not None:
        fit = figures(tail, "mean threshold scale shape peaks")
        above = {"peaks_above": len(tail.clusters), "time_s": tail.time}
        found["tail"] = _extreme(tail.extreme) | fit | above
    if runs is not None:
        found["gumbel"] = _extreme(runs.extreme) | figures(runs, "mode scale runs run_s")
    return found


def _extreme(extreme: Extreme) -> dict[str, Any]:
    return {
        "duration_s": extreme.duration,
        "most_probable_max": extreme.most_probable,
        **figures(extreme, "low high confidence"),
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
        **figures(history, "shortest_step_s steps iterations halvings"),
        "max_fairlead_tension_N": tension.maximum,
        "time_of_max_s": tension.time_of_maximum,
        "slack_time_s": history.line_slack_time(),
        "longest_slack_s": history.line_longest_slack(),
        "refinements": history.refinements,
        "energy": {
            **figures(history.balance, _ENERGIES),
            "line_damping_J": history.balance.damping,
            "numerical_J": history.balance.numerical,
        },
        "again": [
            {
                "way": again.way,
                "time_step_s": again.step,
                **figures(again, "elements maxima failure"),
            }
            for again in run.again
        ],
    }


# ------------------------------------------------------------------ fatigue


def fatigue_document(report: FatigueReport) -> dict[str, Any]:
    """Build the document catopt.fatigue/1."""
    return {
        "schema": "catopt.fatigue/1",
        "title": report.case.title,
        "verdict": report.verdict,
        "passes": report.passes,
        "counting": "rainflow, ASTM E1049, what is left over as half cycles",
        "share_of_year": report.share,
        "sea_states": [
            figures(state, "height_m period_s share direction_rad")
            | {"verdict": run.verdict, "runs": len(run.parts[0].runs)}
            for state, run in zip(report.states, report.runs, strict=True)
        ],
        "segments": [_segment(each) for each in report.segments],
        "remarks": list(report.remarks),
    }


def _segment(each: SegmentFatigue) -> dict[str, Any]:
    curve = each.strength.curve
    is_stress = curve.kind == "S-N"
    return {
        "line": each.line,
        "segment": each.number,
        "component": each.segment.component,
        "curve": curve.source.code,
        **figures(curve, "kind factor slope per_mean"),
        "source": curve.source.text,
        "diameter_m": each.strength.diameter,
        "area_m2": each.strength.reference if is_stress else None,
        "strength_N": None if is_stress else each.strength.reference,
        **figures(each, "arc_m along"),
        "damage_per_year": each.damage,
        "life_years": each.years,
        "wanted_years": each.life / YEAR,
        "design_factor": each.factor,
        "design_factor_source": each.factor_source.text,
        "utilisation": each.utilisation,
        "change_of_ranges": each.change,
        "worst_sea_state": each.worst + 1,
        "sea_states": [
            {
                "damage_per_year": state.damage,
                "mean_tension_N": state.mean,
                "cycles_per_year": state.cycles,
                "damage_per_year_at_half_step": state.at_half_step,
                "damage_per_year_by_spectrum": state.by_spectrum,
            }
            for state in each.states
        ],
    }
