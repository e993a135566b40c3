"""A line in motion in words and as named columns: the one list behind its tables.

Light on purpose: the terminal shows it without pandas, `frames` alone loads it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from catopt.verify.motion_words import (
    DYNAMIC_QUANTITY_OF,
    doubts,
    dynamic_sentences,
    interval,
    motion_sentences,
    not_converged_sentence,
    proof_sentences,
    stopped_sentence,
    stopped_words,
)

if TYPE_CHECKING:
    import pandas as pd

    from catopt.render.texts import Words
    from catopt.verify.dynamic_result import (
        DynamicPart,
        DynamicRun,
        DynamicVerification,
        OverRuns,
    )
from catopt.words import Message, Several

__all__ = [
    "DYNAMIC_QUANTITY_OF",
    "doubts",
    "dynamic_sentences",
    "frames",
    "interval",
    "motion_sentences",
    "not_converged_sentence",
    "proof_sentences",
    "stopped_sentence",
    "stopped_words",
    "workbook_frames",
]

_PROOF = {
    "none": "motion.proof_none",
    "step": "motion.proof_step",
    "bars": "motion.how_both",
}

_MOST_ROWS = 100_000
"""Samples that the workbook holds; the CSV file has all of them."""


def frames(found: DynamicVerification) -> dict[str, pd.DataFrame]:
    """Make the tables of ``--out``, by the name of their file."""
    import pandas as pd

    return {
        "dynamic_statistics": pd.DataFrame(
            [_statistics_row(part, each) for part in found.parts for each in part.quantities]
        ),
        "dynamic_summary": pd.DataFrame([_summary_row(part) for part in found.parts]),
        "dynamic_runs": pd.DataFrame([row for part in found.parts for row in _run_rows(part)]),
        "dynamic_envelope": pd.concat([_envelope(part) for part in found.parts], ignore_index=True),
        "dynamic_series": pd.concat([_series(part) for part in found.parts], ignore_index=True),
        **({"dynamic_body": _track(found.parts[0])} if found.body else {}),
    }


def workbook_frames(tables: Mapping[str, pd.DataFrame], words: Words) -> dict[str, pd.DataFrame]:
    """Name the sheets of the workbook; of very long series it has the first rows.

    Parameters
    ----------
    tables : mapping of str to DataFrame
        As `frames` makes them.
    words : Words
        Language of the workbook; what is translated is named in words in place of by its key.
    """
    names = {key: quantity.name for key, quantity in DYNAMIC_QUANTITY_OF.items()}
    sheets = {}
    for name, table in tables.items():
        shown = table.head(_MOST_ROWS)
        if words.language != "en":
            shown = shown.replace({"Quantity": names})
        sheets[name.removeprefix("dynamic_")] = shown
    return sheets


def _of(part: DynamicPart) -> dict[str, object]:
    """Say what a row is of: a load case, or a line of a body."""
    return {"Load case": part.name} if part.line is None else {"Line": part.line}


def _statistics_row(part: DynamicPart, each: OverRuns) -> dict[str, object]:
    return {
        **_of(part),
        "Quantity": each.quantity,
        "Unit": each.unit,
        "Mean (unit of the row)": each.mean,
        "Standard deviation (unit of the row)": each.std,
        "Minimum (unit of the row)": each.minimum,
        "Maximum (unit of the row)": each.maximum,
        "Change of the maximum when run again (-)": part.change_of(each.quantity),
        **_extreme_cells(each),
    }


def _extreme_cells(each: OverRuns) -> dict[str, object]:
    """Tabulate what the extremes are, and what they rest on."""
    tail, runs = each.tail, each.gumbel
    of_tail = None if tail is None else tail.extreme
    of_runs = None if runs is None else runs.extreme
    return {
        "Duration of interest (s)": of_tail and of_tail.duration,
        "Most probable maximum (unit of the row)": of_tail and of_tail.most_probable,
        "Interval from (unit of the row)": of_tail and of_tail.low,
        "Interval to (unit of the row)": of_tail and of_tail.high,
        "Part of draws that the interval holds (-)": of_tail and of_tail.confidence,
        "Expected maximum (unit of the row)": of_tail and of_tail.expected,
        "Threshold of the tail (unit of the row)": tail and tail.threshold,
        "Peaks above the threshold": tail and len(tail.clusters),
        "Weibull scale (unit of the row)": tail and tail.scale,
        "Weibull shape (-)": tail and tail.shape,
        "Gumbel: most probable maximum (unit of the row)": of_runs and of_runs.most_probable,
        "Gumbel: interval from (unit of the row)": of_runs and of_runs.low,
        "Gumbel: interval to (unit of the row)": of_runs and of_runs.high,
    }


def _summary_row(part: DynamicPart) -> dict[str, object]:
    return {
        **_of(part),
        "Runs": len(part.runs),
        "Bars": part.elements,
        "Complete": "yes" if part.is_complete else "no",
        "Largest tension anywhere (N)": part.max_tension,
        "Largest quasi-static fairlead tension (N)": part.quasi_static_max,
        "Dynamic amplification (-)": part.amplification,
        "Slack in all (s)": part.slack_time,
        "Longest slack (s)": part.longest_slack,
        "Verdict": part.verdict,
        "Proof": Message(_PROOF[part.proof]),
        "Change of the largest tension when run again (-)": part.change_of("largest_tension"),
        **{
            f"Anchor tension at rest, {state} (N)": part.anchor_at_rest.get(state)
            for state in ("pulled", "none", "laid")
        },
        "Numerical part of the work (-)": part.numerical_part,
        "Remarks": Several(part.remarks),
    }


def _run_rows(part: DynamicPart) -> Iterable[dict[str, object]]:
    for run in part.runs:
        history, tension = run.history, run.statistics("fairlead_tension")
        yield {
            **_of(part),
            "Run": run.number + 1,
            "Reached (s)": float(history.time[-1]),
            "Statistics since (s)": history.since,
            "Time step (s)": history.step,
            "Shortest step (s)": history.shortest_step,
            "Steps": history.steps,
            "Newton iterations": history.iterations,
            "Halvings": history.halvings,
            "Largest fairlead tension (N)": tension.maximum,
            "at (s)": tension.time_of_maximum,
            "Largest quasi-static fairlead tension (N)": run.quasi_static_max,
            "Slack in all (s)": history.line_slack_time(),
            "Longest slack (s)": history.line_longest_slack(),
            **{f"{name} (J)": value for name, value in _energies(run)},
            "Numerical part of the work (-)": history.balance.numerical_part,
        }


def _energies(run: DynamicRun) -> list[tuple[str, float]]:
    """List what the energy balance of a run consists of, by name, J."""
    balance = run.history.balance
    return [
        ("Work put in", balance.put_in),
        ("Work of the ends", balance.ends),
        ("Work of the water's pressure", balance.water),
        ("Kinetic energy gained", balance.kinetic),
        ("Strain energy gained", balance.elastic),
        ("Potential energy gained", balance.potential),
        ("Taken by drag", balance.drag),
        ("Taken by the bed", balance.bed),
        ("Taken by friction", balance.friction),
        ("Taken by line damping", balance.damping),
        ("Numerical", balance.numerical),
    ]


def _envelope(part: DynamicPart) -> pd.DataFrame:
    """Tabulate the largest and the smallest tension of each bar over all runs."""
    import numpy as np
    import pandas as pd

    histories = [run.history for run in part.runs]
    return pd.DataFrame(
        {
            **_of(part),
            "Arc length s (m)": histories[0].arc,
            "Largest tension (N)": np.fmax.reduce([each.max_tension for each in histories]),
            "Smallest tension (N)": np.fmin.reduce([each.min_tension for each in histories]),
            "Slack in all (s)": np.max([each.slack_time for each in histories], axis=0),
            "Longest slack (s)": np.max([each.longest_slack for each in histories], axis=0),
        }
    )


def _series(part: DynamicPart) -> pd.DataFrame:
    import pandas as pd

    tables = []
    for run in part.runs:
        history = run.history
        place = history.fairlead[:, 0]
        tables.append(
            pd.DataFrame(
                {
                    **_of(part),
                    "Run": run.number + 1,
                    "Time (s)": history.time,
                    "Fairlead tension T (N)": history.fairlead_tension[:, 0],
                    "Quasi-static fairlead tension (N)": run.quasi_static,
                    "Anchor tension TA (N)": history.anchor_tension[:, 0],
                    "Grounded length (m)": history.grounded_length[:, 0],
                    "Fairlead x (m)": place[:, 0],
                    "Fairlead y (m)": place[:, 1],
                    "Fairlead z (m)": place[:, 2],
                    "Fairlead offset (m)": history.offset[:, 0],
                }
            )
        )
    return pd.concat(tables, ignore_index=True)


def _track(part: DynamicPart) -> pd.DataFrame:
    """Tabulate where the origin of a moored body was."""
    import pandas as pd

    return pd.concat(
        [
            pd.DataFrame(
                {
                    "Run": number,
                    "Time (s)": run.history.time,
                    "Body x (m)": run.track[:, 0],
                    "Body y (m)": run.track[:, 1],
                    "Body z (m)": run.track[:, 2],
                }
            )
            for number, run in enumerate(part.runs, start=1)
            if run.track is not None
        ],
        ignore_index=True,
    )
