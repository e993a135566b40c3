"""A line in motion in words and as named columns: the one list behind its tables.

Light on purpose: the terminal shows it without pandas, `frames` alone loads it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.summary import named
from catopt.verify.proof import LIMIT

if TYPE_CHECKING:
    import pandas as pd

    from catopt.report.texts import Words
    from catopt.verify.dynamic_result import (
        DynamicPart,
        DynamicRun,
        DynamicVerification,
        OverRuns,
    )

__all__ = [
    "DYNAMIC_QUANTITY_OF",
    "dynamic_sentences",
    "frames",
    "not_converged_sentence",
    "proof_sentences",
    "stopped_sentence",
    "workbook_frames",
]

DYNAMIC_QUANTITY_OF: Mapping[str, Quantity] = MappingProxyType(
    {
        "fairlead_tension": named("tension", "Fairlead tension"),
        "anchor_tension": named("tension", "Anchor tension", "TA"),
        "grounded_length": QUANTITIES["grounded_length"],
        "offset": named("offset", "Fairlead offset"),
    }
)
"""What each quantity of a line in motion is in tables."""

_HOW = {
    "step": "at half the step",
    "bars": "with twice the bars",
    "both": "at half the step and with twice the bars",
}

_PROOF = {
    "none": "run once",
    "step": "at half the step, and of a slack line with twice the bars",
    "bars": "at half the step and with twice the bars",
}

_LARGEST = {
    "fairlead_tension": "the largest fairlead tension",
    "anchor_tension": "the largest anchor tension",
    "largest_tension": "the largest tension along the line",
    "grounded_length": "the largest grounded length",
    "offset": "the largest offset",
}

_TENSION = DYNAMIC_QUANTITY_OF["fairlead_tension"]

_MOST_ROWS = 100_000
"""Samples that the workbook holds; the CSV file has all of them."""


def dynamic_sentences(part: DynamicPart) -> list[str]:
    """Say what the motion does to the line: amplification, most probable maximum, slack."""
    largest = part.of("fairlead_tension").maximum
    told = f"The fairlead tension reaches {_TENSION.format(largest, unit=True)}"
    still = part.quasi_static_max
    if part.amplification is not None:
        told += (
            f", {part.amplification:.2f} times the quasi-static {_TENSION.format(still, unit=True)}"
        )
    sentences = [f"{told}."]
    probable = part.of("fairlead_tension").most_probable_maximum
    if probable is not None:
        way = "the maxima of the runs" if len(part.runs) > 1 else "its peaks"
        sentences.append(
            f"The most probable maximum of one such run is {_TENSION.format(probable, unit=True)}, "
            f"by {way}."
        )
    if part.slack_time > 0.0:
        sentences.append(
            f"The line goes SLACK: a bar is without tension for {part.slack_time:.2f} s of a run "
            f"in all, and for {part.longest_slack:.2f} s at a stretch."
        )
    else:
        sentences.append("No part of the line goes slack.")
    return [*sentences, *proof_sentences(part)]


def proof_sentences(part: DynamicPart) -> list[str]:
    """Say how far the maxima hang on step and bars, and how much of the work is numerical."""
    sentences = []
    worst, failed = part.worst_change, part.failure
    if failed is not None:
        sentences.append(f"NOT CONVERGED: run again {_HOW[failed.way]}, it has no answer.")
    elif worst is None:
        sentences.append(
            "NOT PROVEN: it was run once, so that nothing says how far its maxima hang on the "
            "step and the bars."
        )
    elif worst.size > LIMIT:
        sentences.append(
            f"NOT CONVERGED: run again {_HOW[worst.way]}, {_LARGEST[worst.quantity]} changes by "
            f"{worst.size:.1%}, more than {LIMIT:.0%}. A shorter time_step, more elements or more "
            "line_damping is wanted."
        )
    else:
        sentences.append(
            f"Run again {_HOW[worst.way]}, no maximum changes by more than {worst.size:.2%}; "
            f"{LIMIT:.0%} is the limit."
        )
    lost = part.numerical_part
    if lost > LIMIT:
        sentences.append(
            f"NOT CONVERGED: {lost:.1%} of the work put in is numerical, more than {LIMIT:.0%}. "
            "A shorter time_step is wanted."
        )
    else:
        sentences.append(f"Of the work put in {lost:.2g} is numerical.")
    return sentences


def not_converged_sentence(found: DynamicVerification) -> str:
    """Say which load case has not converged, and why."""
    part = next(each for each in found.parts if each.verdict == "not converged")
    why = next(each for each in proof_sentences(part) if each.startswith("NOT CONVERGED"))
    return f"load case {part.name}: {why}"


def stopped_sentence(found: DynamicVerification) -> str:
    """Say how far a run came that was stopped."""
    dynamics, part = found.case.dynamics, found.parts[-1]
    assert dynamics is not None
    reached = part.runs[-1].history.time[-1]
    return (
        f"stopped in load case {part.name}, run {len(part.runs)} of {dynamics.runs}, after "
        f"{reached:.1f} s of {dynamics.duration:g} s; what was computed until then is kept"
    )


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


def _statistics_row(part: DynamicPart, each: OverRuns) -> dict[str, object]:
    return {
        "Load case": part.name,
        "Quantity": each.quantity,
        "Unit": each.unit,
        "Mean (unit of the row)": each.mean,
        "Standard deviation (unit of the row)": each.std,
        "Minimum (unit of the row)": each.minimum,
        "Maximum (unit of the row)": each.maximum,
        "Change of the maximum when run again (-)": part.change_of(each.quantity),
        "Most probable maximum (unit of the row)": each.most_probable_maximum,
    }


def _summary_row(part: DynamicPart) -> dict[str, object]:
    return {
        "Load case": part.name,
        "Runs": len(part.runs),
        "Bars": part.elements,
        "Complete": "yes" if part.is_complete else "no",
        "Largest tension anywhere (N)": part.max_tension,
        "Largest quasi-static fairlead tension (N)": part.quasi_static_max,
        "Dynamic amplification (-)": part.amplification,
        "Slack in all (s)": part.slack_time,
        "Longest slack (s)": part.longest_slack,
        "Verdict": part.verdict,
        "Proof": _PROOF[part.proof],
        "Change of the largest tension when run again (-)": part.change_of("largest_tension"),
        "Numerical part of the work (-)": part.numerical_part,
        "Remarks": "; ".join(part.remarks),
    }


def _run_rows(part: DynamicPart) -> Iterable[dict[str, object]]:
    for number, run in enumerate(part.runs, start=1):
        history, tension = run.history, run.statistics("fairlead_tension")
        yield {
            "Load case": part.name,
            "Run": number,
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
            "Load case": part.name,
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
    for number, run in enumerate(part.runs, start=1):
        history = run.history
        place = history.fairlead[:, 0]
        tables.append(
            pd.DataFrame(
                {
                    "Load case": part.name,
                    "Run": number,
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
