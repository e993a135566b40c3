"""A verification as the JSON document catopt.verify/1."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from catopt.verify.result import VERDICTS, least_agreeing

if TYPE_CHECKING:
    from catopt.verify.case import DesignVerification, FrontVerification
    from catopt.verify.compared import Compared
    from catopt.verify.result import Mesh, StaticComparison, Verification

_SCHEMA = "catopt.verify/1"


def verification_document(verification: Verification) -> dict[str, Any]:
    """Build the document of a case.

    ``static`` is the load case in which the models agree least, ``load_cases`` has all of them.
    """
    return {
        "schema": _SCHEMA,
        "title": verification.case.title,
        "verdict": verification.verdict,
        "static": static_document(verification.static) if verification.parts else None,
        "dynamic": None,
        "load_cases": [static_document(part) for part in verification.parts],
    }


def front_document(front: FrontVerification) -> dict[str, Any]:
    """Build the document of a front; ``static`` is the design on which they agree least."""
    parts = [each.static for each in front.verified]
    verdicts = [each.verdict for each in front.verified]
    known = [v for v in VERDICTS if v in verdicts]
    return {
        "schema": _SCHEMA,
        "title": front.title,
        "verdict": (known[0] if len(verdicts) == len(front.designs) else "no answer"),
        "static": static_document(least_agreeing(parts)) if parts else None,
        "dynamic": None,
        "designs": [_design(each) for each in front.designs],
    }


def _design(each: DesignVerification) -> dict[str, Any]:
    found = each.verification
    return {
        "design": each.design.number,
        "verdict": "no answer" if found is None else found.verdict,
        "failure": each.failure,
        "load_cases": [] if found is None else [static_document(part) for part in found.parts],
    }


def static_document(part: StaticComparison) -> dict[str, Any]:
    """Build the part of one load case; all in SI, the unit in the key."""
    return {
        "load_case": part.name,
        "kind": part.kind,
        "verdict": part.verdict,
        "tolerance": part.tolerance,
        "closed_form": _by_key(part, lambda each: each.closed_form),
        "fem": _by_key(part, lambda each: each.extrapolated),
        "difference": _by_key(part, lambda each: each.difference),
        "worst": _name(part.worst) | {"gap": part.worst.gap},
        "meshes": [_mesh(mesh) for mesh in part.meshes],
        "quantities": [_quantity(each) for each in part.quantities],
        "remarks": list(part.remarks),
    }


def _by_key(part: StaticComparison, value: Callable[[Compared], float]) -> dict[str, Any]:
    """Lay values out by quantity, those of a system's lines in a list."""
    laid: dict[str, Any] = {each.key: value(each) for each in part.quantities if each.line is None}
    if part.kind == "system":
        laid["lines"] = [
            {each.key: value(each) for each in part.quantities if each.line == k}
            for k in range(len(part.lines))
        ]
    return laid


def _name(each: Compared) -> dict[str, Any]:
    return {
        "quantity": each.quantity,
        "line": None if each.line is None else each.line + 1,
        "unit": each.unit,
    }


def _mesh(mesh: Mesh) -> dict[str, Any]:
    return {
        "elements": mesh.elements,
        "iterations": mesh.iterations,
        "residual": mesh.residual,
        "penetration_m": mesh.penetration,
    }


def _quantity(each: Compared) -> dict[str, Any]:
    return _name(each) | {
        "closed_form": each.closed_form,
        "fem": list(each.fem),
        "order": each.order,
        "is_smooth": each.is_smooth,
        "extrapolated": each.extrapolated,
        "difference_before": each.difference_before,
        "difference": each.difference,
        "scale": each.scale,
        "allowed": each.allowed,
        "agrees": each.agrees,
    }
