"""Fatigue as the JSON document catopt.fatigue/1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.constants import YEAR

if TYPE_CHECKING:
    from catopt.verify.fatigue import FatigueReport, SegmentFatigue

__all__ = ["fatigue_document"]


def fatigue_document(report: FatigueReport) -> dict[str, Any]:
    """Build the document; all in SI, lives in years."""
    return {
        "schema": "catopt.fatigue/1",
        "title": report.case.title,
        "verdict": report.verdict,
        "passes": report.passes,
        "counting": "rainflow, ASTM E1049, what is left over as half cycles",
        "share_of_year": report.share,
        "sea_states": [
            {
                "height_m": state.height,
                "period_s": state.period,
                "share": state.share,
                "direction_rad": state.direction,
                "verdict": run.verdict,
                "runs": len(run.parts[0].runs),
            }
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
        "kind": curve.kind,
        "factor": curve.factor,
        "slope": curve.slope,
        "per_mean": curve.per_mean,
        "source": curve.source.text,
        "diameter_m": each.strength.diameter,
        "area_m2": each.strength.reference if is_stress else None,
        "strength_N": None if is_stress else each.strength.reference,
        "arc_m": each.arc,
        "along": each.along,
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
