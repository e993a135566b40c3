"""What the two models say as JSON documents: catopt.verify/1, at rest and in motion.

All in SI, the unit in the key; lives in years.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from catopt.documents import figures

if TYPE_CHECKING:
    from catopt.fem.extremes import Extreme
    from catopt.floater.two_scales import Scales
    from catopt.model.dynamics import JudgedBy
    from catopt.verify.case import DesignVerification, FrontVerification
    from catopt.verify.compared import Compared
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, JointInMotion
    from catopt.verify.dynamic_run import DynamicRun, OverRuns
    from catopt.verify.result import StaticComparison, Verification
    from catopt.verify.two_scales import LineOfShip, ShipVerification

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
        **({"joints": [_joint(each) for each in found.joints]} if found.joints else {}),
        "initial_friction": found.case.dynamics.initial_friction if found.case.dynamics else None,
        "load_cases": [_part(part) for part in found.parts],
    }


def _joint(each: JointInMotion) -> dict[str, Any]:
    places = {"rest_m": each.rest, "least_m": each.least, "largest_m": each.largest}
    return {"name": each.name, **{key: list(at) for key, at in places.items()}, "way_m": each.way}


def _part(part: DynamicPart) -> dict[str, Any]:
    of = part.between
    return {
        "load_case": part.name,
        **figures(part, "line is_complete elements"),
        **({} if of is None else {"name": of.name, "from": of.start, "to": of.end}),
        "quantities": [_quantity(each) for each in part.quantities],
        "max_tension_N": part.max_tension,
        "quasi_static_max_tension_N": part.quasi_static_max,
        "amplification": part.dynamic_amplification,
        **figures(part, "slack_time_s longest_slack_s verdict"),
        "proof": part.convergence_check,
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


# ------------------------------------------------------------------ a ship on two time scales


def ship_document(found: ShipVerification) -> dict[str, Any]:
    """Lay a ship in motion out as ``catopt verify --dynamic --json`` has it, in SI."""
    rest, dynamics = found.rest, found.case.dynamics
    assert dynamics is not None
    names = ("wind", "current", "drift")
    return {
        "runs": len(found.runs),
        "duration_s": dynamics.duration,
        "since_s": float(found.runs[0].time[0]),
        "storm_s": dynamics.duration_of_interest,
        "mean_force_N": list(rest.force),
        "mean_loads": {name: part.tolist() for name, part in zip(names, rest.parts, strict=True)},
        "rest": {"x_m": rest.place[0], "y_m": rest.place[1], "yaw_rad": rest.place[2]},
        "heading_rad": found.heading,
        "offset_m": _scales(found.offset),
        "yaw_rad": _scales(found.yaw),
        "lines": [_line_document(each, dynamics.judged_by) for each in found.lines],
        "lines_out": [
            {
                "missing_line": each.missing,
                "refusal": str(each.refusal),
                "offset_m": None if each.offset is None else _scales(each.offset),
                "lines": [_line_document(line, dynamics.judged_by) for line in each.lines],
            }
            for each in found.lost
        ],
        "checks": found.checks.motion_document(),
        "remarks": [str(each) for each in found.remarks],
    }


def _line_document(of: LineOfShip, by: JudgedBy) -> dict[str, Any]:
    storm = None
    if of.storm is not None:
        ends = [of.storm.low, of.storm.high]
        storm = {"most_probable_tension_N": of.storm.most_probable, "interval_N": ends}
    return {
        "line": of.number,
        "fairlead_tension_N": _scales(of.fairlead),
        "anchor_tension_N": _scales(of.anchor),
        "MBL_N": of.MBL,
        "storm": storm,
        "judged_tension_N": of.judged(by),
    }


def _scales(of: Scales) -> dict[str, float]:
    return vars(of) | {"combined": of.combined}
