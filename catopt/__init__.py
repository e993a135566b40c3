"""Mooring lines: equilibrium in closed form and by particle swarm, beside published figures.

Everything of the public interface is found here and loaded when it is first used, so that
``import catopt`` costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module

from catopt import display

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import pandas as pd
    from matplotlib.figure import Figure

    from catopt._version import __version__ as __version__
    from catopt.casefile import read_case as read_case
    from catopt.catalogue import component as component
    from catopt.catenary.batch import solve_many as solve_many
    from catopt.catenary.case import solve_case as solve_case
    from catopt.catenary.case_curve import curve_case as curve_case
    from catopt.catenary.curve import load_curve as load_curve
    from catopt.catenary.find import find_clump_weight as find_clump_weight
    from catopt.catenary.find import find_length as find_length
    from catopt.catenary.find import find_limit_force as find_limit_force
    from catopt.catenary.find import find_touchdown_force as find_touchdown_force
    from catopt.catenary.solution import Solution as Solution
    from catopt.catenary.solve import solve as solve
    from catopt.checks.case import check_case as check_case
    from catopt.checks.result import CheckReport as CheckReport
    from catopt.design.result import DesignResult as DesignResult
    from catopt.design.search import design_case as design_case
    from catopt.errors import CatoptError as CatoptError
    from catopt.errors import InputError as InputError
    from catopt.errors import NoEquilibriumError as NoEquilibriumError
    from catopt.errors import NotConvergedError as NotConvergedError
    from catopt.model import Case as Case
    from catopt.model import Line as Line
    from catopt.model import Load as Load
    from catopt.model import PointLoad as PointLoad
    from catopt.model import Segment as Segment
    from catopt.model import Site as Site
    from catopt.model import StrainTable as StrainTable
    from catopt.model import System as System
    from catopt.model.network import LineBetween as LineBetween
    from catopt.model.network import MooredBody as MooredBody
    from catopt.model.network import Network as Network
    from catopt.model.network import Point as Point
    from catopt.mooring.network_rest import LinesAtRest as LinesAtRest
    from catopt.mooring.solution import SystemSolution as SystemSolution
    from catopt.mooring.solution import solve_system as solve_system
    from catopt.sizing.file import read_sizing as read_sizing
    from catopt.sizing.keywords import size_buoy as size_buoy
    from catopt.sizing.keywords import size_tanker as size_tanker
    from catopt.study.run import run_study as run_study
    from catopt.verify.case import verify_case as verify_case
    from catopt.verify.dynamic import verify_dynamic as verify_dynamic

_HOMES = {
    "catopt._version": "__version__",
    "catopt.catalogue": "component",
    "catopt.casefile": "read_case",
    "catopt.catenary.batch": "solve_many",
    "catopt.catenary.case_curve": "curve_case",
    "catopt.catenary.curve": "load_curve",
    "catopt.catenary.find": "find_clump_weight find_length find_limit_force find_touchdown_force",
    "catopt.catenary.solution": "Solution",
    "catopt.catenary.case": "solve_case",
    "catopt.catenary.solve": "solve",
    "catopt.checks.case": "check_case",
    "catopt.checks.result": "CheckReport",
    "catopt.design.result": "DesignResult",
    "catopt.design.search": "design_case",
    "catopt.errors": "CatoptError InputError NoEquilibriumError NotConvergedError",
    "catopt.model": "Case Line Load PointLoad Segment Site StrainTable System",
    "catopt.model.network": "LineBetween MooredBody Network Point",
    "catopt.mooring.network_rest": "LinesAtRest",
    "catopt.mooring.solution": "SystemSolution solve_system",
    "catopt.sizing.file": "read_sizing",
    "catopt.sizing.keywords": "size_buoy size_tanker",
    "catopt.study.run": "run_study",
    "catopt.verify.case": "verify_case",
    "catopt.verify.dynamic": "verify_dynamic",
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names.split()}
__all__ = sorted(_HOME_OF)


if not TYPE_CHECKING:  # so that a type checker still finds a misspelt name

    def __getattr__(name: str) -> Any:
        """Load a public name on first use (PEP 562)."""
        if name not in _HOME_OF:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        value = getattr(import_module(_HOME_OF[name]), name)
        globals()[name] = value
        return value


def _as_html(result: object) -> str:
    from catopt.answers.of_result import answer_of
    from catopt.render.page import fragment

    return fragment(answer_of(result))


def _as_table(result: object) -> pd.DataFrame:
    from catopt.answers.of_result import table_of

    return table_of(result)


def _as_figure(result: object) -> Figure:
    from catopt.report.bundle import figure_of

    return figure_of(result)


def _as_screen(result: object) -> str:
    from catopt.answers.of_result import answer_of
    from catopt.render.card import card_lines

    return "\n".join(line.text for line in card_lines(answer_of(result)))


display.renderers |= {
    "html": _as_html,
    "screen": _as_screen,
    "table": _as_table,
    "figure": _as_figure,
}


def __dir__() -> list[str]:
    return list(__all__)
