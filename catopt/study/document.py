"""The document of a study, as ``catopt study --json`` prints it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.documents import figures

if TYPE_CHECKING:
    from catopt.study.result import Statistic, StudyResult


def study_document(result: StudyResult) -> dict[str, Any]:
    """Build the document (schema catopt.study/1); values in SI, members counted from 1."""
    study = result.study
    return {
        "schema": "catopt.study/1",
        "title": study.title,
        "compute": study.base.compute,
        "members": len(study),
        "done": result.done,
        "without_answer": len(result.reasons),
        "varied": [
            {"keys": list(axis.columns), "values": len(axis), "drawn": axis.is_drawn}
            for axis in study.axes
        ],
        "digest": study.digest,
        "statistics": [_statistic(each, result) for each in result.statistics],
        "by_choice": [
            {
                "name": each.kept.name,
                "member": each.member + 1,
                **figures(each, "beyond count share interval"),
            }
            for each in result.by_choice
        ],
        "influences": [
            {
                "keys": list(each.keys),
                "share_of_variance": each.share,
                "least_mean": each.low,
                "largest_mean": each.high,
            }
            for each in result.influences
        ],
        "counts": [
            {"name": name, "text": text, "members": n}
            for name, counted in result.counted().items()
            for text, n in counted
        ],
        "failures": [
            {"reason": reason, "members": n, "first": first + 1}
            for reason, n, first in result.failures()
        ],
    }


def _statistic(each: Statistic, result: StudyResult) -> dict[str, Any]:
    study = result.study
    order = result.first_orders.get(each.kept.name)
    return {
        "name": each.kept.name,
        "unit": each.kept.measure.si_unit,
        "members": each.count,
        **figures(each, "mean deviation least largest"),
        "levels": [
            {"share": share, "value": value}
            for share, value in zip(result.levels, each.levels, strict=True)
        ],
        "worst": {
            "member": each.worst + 1,
            "values": [
                {"key": key, "value": value} for key, value in study.values_of(each.worst).items()
            ],
        },
        "limit": each.limit,
        "share_beyond": each.beyond,
        "first_beyond": None if each.first_beyond is None else each.first_beyond + 1,
        "interval_beyond": None if each.interval is None else list(each.interval),
        "first_order": None
        if order is None
        else {
            **figures(order, "index probability"),
            "point": [
                {"key": key, "value": value, "importance": order.importance[key]}
                for key, value in order.point.items()
            ],
            "others": [
                {
                    "index": index,
                    "point": [{"key": key, "value": value} for key, value in point.items()],
                }
                for index, point in order.others
            ],
            "sampled": order.sampled,
            "interval_sampled": None if order.interval is None else list(order.interval),
        },
        "no_first_order": result.no_first_orders.get(each.kept.name),
    }
