"""What is drawn of each kind of result: for the pictures of --out, and for ``plot()``."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from catopt.ties import first_largest
from catopt.words import Message

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignResult
    from catopt.figures.chart import Chart
    from catopt.mooring.solution import SystemSolution
    from catopt.sizing import Sizing
    from catopt.study.result import StudyResult
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.result import StaticComparison, Verification


class Drawing(NamedTuple):
    """Charts that stand together, their heading, and in how many columns they stand."""

    charts: tuple[Chart, ...]
    title: str
    columns: int = 1


def of_tension(solution: Solution) -> Drawing:
    """Draw the tension along a line beside what its segments may carry."""
    from catopt.figures.line import tension_along

    factor = solution.safety_factor
    allowed = [each.MBL and each.MBL / factor for each in solution.segments]
    basis = Message("figures.MBL_over", factor=factor)
    return Drawing((tension_along(solution, allowed, basis),), solution.title)


def of_line(solution: Solution, depth: float, title: str) -> Drawing:
    """Draw a line in water of a depth (m)."""
    from catopt.figures.line import line_in_water

    return Drawing((line_in_water(solution, depth),), title)


def of_curve(result: CaseCurve) -> Drawing:
    """Draw a load curve."""
    from catopt.figures.curve import load_curve

    return Drawing((load_curve(result),), result.case.title)


def of_front(result: DesignResult) -> Drawing:
    """Draw a front, and of single lines three of them."""
    from catopt.design.document import design_document
    from catopt.figures.front import front, front_lines

    document = design_document(result)
    is_line = result.front[result.recommended].mooring is None
    lines = (front_lines(result, document),) if is_line else ()
    return Drawing((front(document), *lines), result.case.title)


def of_plan(solution: SystemSolution, title: str) -> Drawing:
    """Draw a body on its lines from above, and near the body where that shows more."""
    from catopt.figures.mooring import near, plan

    around = near(solution)
    return Drawing((plan(solution), *(() if around is None else (around,))), title)


def of_sizing(of: Sizing) -> Drawing:
    """Draw the recommended line in the load case that is hardest on it."""
    name, solution = of.hardest
    state = next(each for each in of.case.load_cases if each.name == name)
    return of_line(solution, of.case.site.water_depth + state.water_level, of.case.title)


def of_comparison(found: Verification, part: StaticComparison) -> Drawing:
    """Draw a line by both models; of a body the most loaded one."""
    from catopt.figures.verification import comparison

    titles = [found.case.title, part.name if found.case.load_cases else ""]
    line = first_largest([pair.finest.fairlead.tension for pair in part.lines])
    if part.kind == "system":
        titles.append(Message("figures.most_loaded", line=line + 1))
    return Drawing(comparison(part.lines[line]), ", ".join(filter(None, titles)), 2)


def of_motion(part: DynamicPart, title: str) -> Drawing:
    """Draw a line in motion: its history, spectrum, envelope and peaks."""
    from catopt.figures import motion

    peaks = motion.exceedance(part)
    charts = (motion.whole_history(part), motion.spectrum(part), motion.envelope_chart(part))
    return Drawing(charts if peaks is None else (*charts, peaks), title)


def _of_solution(solution: Solution) -> Drawing:
    """Draw a line that came without its case: the water reaches up to its fairlead."""
    tension = of_tension(solution)
    in_water = of_line(solution, solution.fairlead_height, solution.title)
    return Drawing((*in_water.charts, *tension.charts), solution.title)


def _of_moved(found: DynamicVerification) -> Drawing:
    part = found.governing
    return of_motion(part, ", ".join(filter(None, (found.case.title, part.where))))


def of_study(result: StudyResult) -> Drawing:
    """Draw how often values are exceeded: of the quantities with limits, or else of the first."""
    from catopt.figures.study import exceedance

    known = [each for each in result.statistics if each.least < each.largest]
    drawn = [each for each in known if each.limit is not None] or known[:1]
    return Drawing(tuple(exceedance(result, each) for each in drawn), result.study.title)


_DRAWN: dict[str, Callable[[Any], Drawing]] = {
    "CaseCurve": of_curve,
    "DesignResult": of_front,
    "DynamicVerification": _of_moved,
    "Sizing": of_sizing,
    "Solution": _of_solution,
    "StudyResult": of_study,
    "SystemSolution": lambda found: of_plan(found, found.title),
    "Verification": lambda found: of_comparison(found, found.parts[0]),
}
"""What draws a result, by the name of its class."""


def figure_of(result: Any) -> Figure:
    """Draw a result; TypeError for what has no drawing."""
    from catopt.render.picture import picture

    name = type(result).__name__
    if name not in _DRAWN:
        raise TypeError(f"a {name} has no drawing; those of {', '.join(_DRAWN)} have one")
    charts, title, columns = _DRAWN[name](result)
    return picture(charts, title, columns=columns)
