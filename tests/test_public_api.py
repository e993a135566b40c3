"""The public interface: which names there are, that each is explained, what loading them costs."""

from __future__ import annotations

import inspect
import json
import subprocess
import sys
from pathlib import Path

import pytest

import catopt
from catopt._version import RELEASE

NAMES = [
    "Case",
    "CatoptError",
    "CheckReport",
    "DesignResult",
    "InputError",
    "Line",
    "LineBetween",
    "LinesAtRest",
    "Load",
    "MooredBody",
    "Network",
    "NoEquilibriumError",
    "NotConvergedError",
    "Point",
    "PointLoad",
    "Segment",
    "Site",
    "Solution",
    "StrainTable",
    "System",
    "SystemSolution",
    "__version__",
    "check_case",
    "component",
    "curve_case",
    "design_case",
    "find_clump_weight",
    "find_length",
    "find_limit_force",
    "find_touchdown_force",
    "load_curve",
    "read_case",
    "read_sizing",
    "run_study",
    "size_buoy",
    "size_tanker",
    "solve",
    "solve_case",
    "solve_many",
    "solve_system",
    "verify_case",
    "verify_dynamic",
]

HEAVY = {"matplotlib", "numba", "numpy", "pandas", "pint", "pydantic", "pyswarms", "xlsxwriter"}


def test_the_public_names_are_exactly_these() -> None:
    assert catopt.__all__ == NAMES


@pytest.mark.parametrize("name", [name for name in NAMES if name != "__version__"])
def test_every_public_name_is_there_and_explained(name: str) -> None:
    assert name in dir(catopt)
    doc = inspect.getdoc(getattr(catopt, name))
    assert doc is not None
    assert doc.splitlines()[0].endswith(".")


@pytest.mark.parametrize("name", NAMES[NAMES.index("__version__") + 1 :])
def test_every_parameter_of_a_public_function_is_explained(name: str) -> None:
    function = getattr(catopt, name)
    doc = inspect.getdoc(function) or ""
    for parameter in inspect.signature(function).parameters:
        assert parameter in doc, f"{name} does not explain {parameter}"


def test_a_wrong_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'slove'"):
        _ = catopt.slove  # type: ignore[attr-defined]


def loaded_by(code: str) -> set[str]:
    """Top-level modules that a fresh interpreter holds after running some code."""
    code += "\nimport json, sys; print(json.dumps(sorted({m.split('.')[0] for m in sys.modules})))"
    command = [sys.executable, "-c", code]
    run = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    return set(json.loads(run.stdout.splitlines()[-1]))


def test_importing_catopt_loads_nothing_heavy() -> None:
    assert loaded_by("import catopt; dir(catopt)") & HEAVY == set()


def test_solving_one_line_loads_nothing_heavy() -> None:
    code = (
        "import catopt\n"
        "line = catopt.Line([catopt.Segment(20, 93.163)])\n"
        "catopt.solve(line, height=9.5, horizontal_force=3363.68).to_dict()"
    )
    assert loaded_by(code) & HEAVY == set()


def test_the_version_to_cite_is_that_of_the_program() -> None:
    cited = (Path(__file__).parents[1] / "CITATION.cff").read_text("utf-8")
    assert f"\nversion: {RELEASE}\n" in cited
