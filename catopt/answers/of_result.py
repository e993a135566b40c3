"""The answer of a result that came by itself, as Python has it: what a notebook shows of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.answers.blocks import Answer, Table, answered, section
from catopt.words import Message

if TYPE_CHECKING:
    import pandas as pd

    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignPoint


def layouts() -> dict[str, Callable[[Any], Answer]]:
    """List what lays a result out, by the name of its class."""
    from catopt.answers.check import check_answer
    from catopt.answers.curve import curve_answer
    from catopt.answers.design import design_answer
    from catopt.answers.motion import motion_answer
    from catopt.answers.size import size_answer
    from catopt.answers.study import study_answer
    from catopt.answers.system import solved_system
    from catopt.answers.verification import verification_answer

    return {
        "CaseCurve": curve_answer,
        "CheckReport": check_answer,
        "DesignPoint": _design,
        "DesignResult": design_answer,
        "DynamicVerification": motion_answer,
        "Sizing": size_answer,
        "Solution": _solution,
        "SolutionInCurrent": _solution,
        "StudyResult": study_answer,
        "SystemReport": lambda report: solved_system(report.solution),
        "SystemSolution": solved_system,
        "Verification": verification_answer,
    }


def answer_of(result: Any) -> Answer:
    """Lay out a result; TypeError for what is none."""
    name, known = type(result).__name__, layouts()
    if name not in known:
        raise TypeError(f"a {name} has no tables; those of {', '.join(known)} are known")
    answer = known[name](result)
    sections = [
        replace(each, name=each.name or f"{name}-{number}")  # those with a name are on a page
        for number, each in enumerate(answer.sections)
    ]
    return replace(answer, sections=tuple(sections))


def table_of(result: Any) -> pd.DataFrame:
    """Return the main table of a result: the one of its kind, or the first."""
    blocks = answer_of(result).blocks
    tables = [each for each in blocks if isinstance(each, Table) and each.only != "workbook"]
    of_its_kind = [each for each in tables if each.name == "sizing"]
    return (of_its_kind or tables)[0].to_dataframe()


def _solution(solution: Solution) -> Answer:
    from catopt.answers.solution import segments_table, summary

    results = section("captions.results", summary(solution), segments_table(solution))
    return answered("solution", Message("captions.mooring_line"), results)


def _design(point: DesignPoint) -> Answer:
    from catopt.answers.check import check_answer
    from catopt.answers.solution import given_tables

    line = section("captions.given", *given_tables(point.line))
    checks = check_answer(point.checks)
    return replace(checks, sections=(line, *checks.sections))
