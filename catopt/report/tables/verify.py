"""A verification in words and as named columns: the one list behind its tables.

Light on purpose: the terminal shows it without pandas, `frames` alone loads it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from catopt.report.tables.summary import named
from catopt.verify.truss_words import (
    QUANTITY_OF,
    gap_words,
    in_parts,
    name_of,
    part_sentence,
    rough_sentence,
)

if TYPE_CHECKING:
    import pandas as pd

    from catopt.render.texts import Words
    from catopt.verify.compared import Compared
    from catopt.verify.front import FrontVerification
    from catopt.verify.result import StaticComparison, Verification
from catopt.words import Message, Several, say

__all__ = [
    "QUANTITY_OF",
    "frames",
    "gap_words",
    "in_parts",
    "name_of",
    "part_sentence",
    "rough_sentence",
    "said_frames",
    "title_of",
    "verdict_sentence",
]


def verdict_sentence(found: Verification | FrontVerification) -> str:
    """Say in one line what came of a case or a front."""
    from catopt.verify.front import FrontVerification

    if isinstance(found, FrontVerification):
        return _front_sentence(found)
    count = len(found.parts)
    settled = sum(part.is_settled for part in found.parts)
    if count == 1:
        return part_sentence(found.parts[0])
    if settled == count:
        return Message("truss.all_cases_agree", count=count)
    return Message("truss.cases_differ", differing=count - settled, count=count)


def _front_sentence(front: FrontVerification) -> str:
    count = len(front.designs)
    settled = sum(each.is_settled for each in front.verified)
    failed = count - len(front.verified)
    if settled == count:
        return Message("truss.all_designs_agree", count=count)
    differing = count - settled - failed
    if not failed:
        return Message("truss.designs_differ", count=count, differing=differing)
    if not differing:
        return Message("truss.designs_fail", count=count, failed=failed)
    values = {"count": count, "differing": differing, "failed": failed}
    return Message("truss.designs_differ_and_fail", **values)


def title_of(found: Verification | FrontVerification) -> str:
    """Title of the case, or of the search."""
    from catopt.verify.front import FrontVerification

    return found.title if isinstance(found, FrontVerification) else found.case.title


# ------------------------------------------------------------------ tables for files


def frames(found: Verification | FrontVerification) -> dict[str, pd.DataFrame]:
    """Make the tables of ``--out``, by the name of their file."""
    import pandas as pd

    from catopt.verify.front import FrontVerification

    if isinstance(found, FrontVerification):
        parts = [
            (_of_design(each.design.number, part.name), part)
            for each in found.designs
            if each.verification is not None
            for part in each.verification.parts
        ]
        made = {"designs": pd.DataFrame(_design_rows(found))}
    else:
        parts = [(part.name, part) for part in found.parts]
        made = {}
    made["verdicts"] = pd.DataFrame([_verdict_row(name, part) for name, part in parts])
    made["quantities"] = pd.DataFrame(
        [_quantity_row(name, each) for name, part in parts for each in part.quantities]
    )
    made["meshes"] = pd.DataFrame([row for name, part in parts for row in _mesh_rows(name, part)])
    if not isinstance(found, FrontVerification):
        made["shapes"] = _shapes(parts)
    return made


def _of_design(number: int, load_case: str) -> str:
    return Message("truss.design_in_case", number=number, name=load_case)


def said_frames(frames: Mapping[str, pd.DataFrame], words: Words) -> dict[str, pd.DataFrame]:
    """Put words for what the code writes by a key of its own, where the tables are translated.

    Parameters
    ----------
    frames : mapping of str to DataFrame
        As `frames` makes them.
    words : Words
        Language of the workbook; in English the tables stay as they are.
    """
    if words.language == "en":
        return dict(frames)
    names = {key: quantity.name for key, quantity in QUANTITY_OF.items()}
    names["position_x"], names["position_y"] = (
        Message(key) for key in ("truss.position_x", "truss.position_y")
    )
    told = {}
    for sheet, frame in frames.items():
        said = frame.replace({"Quantity": names})
        if "designs" in frames and "Load case" in said:
            # The design's number is ours, the name of its load case is the user's.
            said["Load case"] = [say(each, words.language) for each in said["Load case"]]
        told[sheet] = said
    return told


def _design_rows(front: FrontVerification) -> Iterable[dict[str, object]]:
    for each in front.designs:
        found = each.verification
        worst = None if found is None else found.static.worst
        yield {
            "Design": each.design.number,
            "Governing load case": each.design.load_case or "",
            "Verdict": "no answer" if found is None else found.verdict,
            "Worst quantity": "" if worst is None else name_of(worst),
            "Largest difference over its scale (-)": None if worst is None else worst.gap,
            "Failure": each.failure,
        }


def _verdict_row(name: str, part: StaticComparison) -> dict[str, object]:
    return {
        "Load case": name,
        "Verdict": part.verdict,
        "Worst quantity": name_of(part.worst),
        "Largest difference over its scale (-)": part.worst.gap,
        "Tolerance (-)": part.tolerance,
        "Residual of the truss over its tension (-)": part.residual,
        "Remarks": Several(part.remarks),
    }


def _quantity_row(name: str, each: Compared) -> dict[str, object]:
    return {
        "Load case": name,
        "Line": "" if each.line is None else str(each.line + 1),
        "Quantity": each.quantity,
        "Unit": each.unit,
        "Closed form (unit of the row)": each.closed_form,
        **{
            f"Truss on mesh {number} (unit of the row)": value
            for number, value in enumerate(each.fem, start=1)
        },
        "Truss extrapolated (unit of the row)": each.extrapolated,
        "Observed order (-)": each.order,
        "Smooth": "yes" if each.is_smooth else "no",
        "Difference of the finest mesh (unit of the row)": each.difference_before,
        "Difference after extrapolation (unit of the row)": each.difference,
        "Scale (unit of the row)": each.scale,
        "Difference over the scale (-)": each.gap,
        "Agrees": "yes" if each.agrees else "no",
    }


def _mesh_rows(name: str, part: StaticComparison) -> Iterable[dict[str, object]]:
    for number, mesh in enumerate(part.meshes, start=1):
        yield {
            "Load case": name,
            "Mesh": number,
            "Bars": mesh.elements,
            "Newton iterations": mesh.iterations,
            "Residual over the largest tension (-)": mesh.residual,
            "Penetration (m)": mesh.penetration,
        }


def _shapes(parts: Iterable[tuple[str, StaticComparison]]) -> pd.DataFrame:
    """Tabulate the nodes of the finest mesh beside the closed form at the same arc length."""
    import pandas as pd

    from catopt.report.tables.solution import column
    from catopt.verify.shape import closed_form_at, flat

    made = []
    for name, part in parts:
        for number, pair in enumerate(part.lines, start=1):
            truss = pair.finest
            shape = flat(truss)
            exact = closed_form_at(pair.closed, truss.arc)
            laid: dict[str, object] = {
                "Load case": [name] * len(shape),
                "Line": [number] * len(shape),
                **column("s", truss.arc),
                **column(named("x", "Truss", "x"), shape[:, 0]),
                **column(named("z", "Truss", "z"), shape[:, 1]),
                **column(named("x", "Closed form", "x"), exact[:, 0]),
                **column(named("z", "Closed form", "z"), exact[:, 1]),
                **column(named("tension", "Closed form", "T"), exact[:, 2]),
            }
            made.append(pd.DataFrame(laid))
    return pd.concat(made, ignore_index=True)
