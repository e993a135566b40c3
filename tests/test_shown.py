"""Results in Python: a line of text, the tables of the command in a notebook, a data frame."""

from __future__ import annotations

import importlib
import inspect
import io
import json
import pkgutil
from dataclasses import is_dataclass
from functools import cache
from pathlib import Path
from typing import Any, get_args, get_type_hints

import pandas as pd
import pytest

import catopt
import catopt.loads as catopt_loads
import catopt.mooring as catopt_mooring
import catopt.reproduce as catopt_reproduce
from catopt.answers.design import design_answer
from catopt.answers.of_result import answer_of, layouts
from catopt.display import Displayable
from catopt.mooring.restoring import watch_circle
from catopt.render.files import csv_files
from catopt.schemas import schema
from catopt.schemas.validation import inconsistencies
from catopt.verify.case import verify_case
from tests.sizing.at_rest import size_tanker

CASES = Path("cases")
AT_SEA = Path("tests/answers/cases/at-sea.toml")


@cache
def results() -> dict[str, Any]:
    buoy = catopt.read_case(CASES / "buoy-9.5m" / "case.toml")
    body = catopt.read_case(CASES / "fso-rang-dong" / "case.toml")
    assert body.system is not None
    design = catopt.design_case(catopt.read_case(CASES / "design-buoy-9.5m" / "case.toml"))
    return {
        "solution": catopt.solve_case(buoy),
        "curve": catopt.curve_case(buoy),
        "checks": catopt.check_case(body),
        "design": design,
        "point": design.front[0],
        "sizing": size_tanker(dwt="50000 t", depth=20.0),
        "verification": verify_case(buoy, elements=20),
        "system": catopt.solve_system(body.system),
    }


NAMES = ["solution", "curve", "checks", "design", "sizing", "verification"]


def test_a_sizing_is_its_first_screen() -> None:
    sizing = results()["sizing"]
    lines = repr(sizing).splitlines()
    assert lines[0] == sizing.case.title
    assert " ".join(lines[1:3]) == sizing.one_line
    assert len(lines) <= 22
    assert max(map(len, lines)) <= 80


def test_a_sizing_has_what_one_asks_for_first() -> None:
    """Of the tanker at rest: what the first line of its screen says, and whether it passes."""
    sizing = results()["sizing"]
    assert sizing.passes is True
    assert f"{sizing.chain.segment.nominal_diameter * 1e3:.0f} mm" in repr(sizing).splitlines()[1]
    assert sizing.sinker is None  # on a drag anchor
    assert sizing.drag_anchor.mass > 0.0


@pytest.mark.slow
def test_a_notebook_completes_every_result() -> None:
    """As IPython does: by jedi, which must not fail on one attribute, for it then has none."""
    jedi = pytest.importorskip("jedi", reason="optional extra: notebook")
    displayed = [each for each in every_kind(Displayable) if each.__module__ != __name__]
    for each in (*displayed, *returned()):
        code = "x."
        found = jedi.Interpreter(code, [{"x": object.__new__(each)}]).complete(1, len(code))
        assert len(found) > 1, each
    catopt_names = jedi.Interpreter("catopt.size_buoy(wi", [{"catopt": catopt}]).complete()
    assert "wind=" in [each.name_with_symbols for each in catopt_names]


@pytest.mark.parametrize("name", [*(each for each in NAMES if each != "sizing"), "system"])
def test_a_result_is_a_line_or_two(name: str) -> None:
    """They were up to 650,000 letters."""
    said = repr(results()[name])
    assert said.startswith(type(results()[name]).__name__ + "(")
    assert len(said) < 600


def every_kind(of: type) -> set[type]:
    """List the classes that are made from one, over any number of steps."""
    made: list[type] = of.__subclasses__()
    return {kind for each in made for kind in {each} | every_kind(each)}


def test_every_result_is_in_the_registry() -> None:
    """Import all that has results, so that none is passed over."""
    for found in pkgutil.walk_packages(catopt.__path__, "catopt."):
        if not found.name.endswith("__main__"):
            importlib.import_module(found.name)
    assert {each.__name__ for each in every_kind(Displayable)} == set(layouts())


@pytest.mark.parametrize("name", [*NAMES, "system", "point"])
def test_every_kind_of_result_has_all_its_forms(name: str) -> None:
    """Line, table, notebook and document, which its schema accepts.

    A design is part of the document of its search; of a body the report of its case has it.
    """
    result = results()[name]
    assert "<table" in result._repr_html_()
    assert len(result.to_dataframe()) > 0
    if name not in ("point", "system"):
        document = json.loads(json.dumps(result.to_dict()))
        assert list(inconsistencies(document, schema(document["schema"]))) == []


def test_the_line_has_the_numbers() -> None:
    assert "span=17.43" in repr(results()["solution"])
    assert "position=(x=-21.738" in repr(results()["system"])


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("solution", "chain"), ("curve", "kN"), ("checks", "line 1 out"),
        ("design", "sliding of the sinker"), ("sizing", "Stevpris"), ("verification", "agree"),
        ("system", "kyy"),
    ],
)  # fmt: skip
def test_a_notebook_shows_what_the_command_prints(name: str, words: str) -> None:
    html = results()[name]._repr_html_()
    assert "<table" in html
    assert words in html


INPUTS = {"Case", "BuoyRequest", "TankerRequest"}
"""What public functions return to be given to another one."""


def returned() -> set[type]:
    """List the classes of catopt that public functions return, themselves or several of them."""
    found = set()
    for module in (catopt, catopt_loads, catopt_mooring, catopt_reproduce):
        for name in module.__all__:
            function = getattr(module, name)
            if not inspect.isfunction(function):
                continue
            whole = get_type_hints(function).get("return")
            for each in (whole, *get_args(whole)):
                if inspect.isclass(each) and is_dataclass(each) and each.__name__ not in INPUTS:
                    found.add(each)
    return {each for each in found if not each.__name__.startswith(("Ship", "BuoyShape"))}


def test_every_result_has_a_table_for_a_notebook() -> None:
    every = {each.__name__ for each in returned()}
    assert {"Solution", "Found", "Curve", "Component", "WatchCircle", "Loads"} <= every
    assert [each for each in returned() if not hasattr(each, "_repr_html_")] == []


def plain_results() -> list[Any]:
    """Give one of every other result, by the functions that return it."""
    line = catopt.Line([catopt.Segment(100.0, 900.0)])
    compared = catopt_loads.compare_tanker()
    afloat: Any = None
    network: Any = catopt.read_case(CASES / "raft-four-lines" / "case.toml")
    curve: Any = results()["curve"].curve
    return [
        catopt.component("chain studless R3", "76 mm"),
        catopt.solve_many(line, height=60, span=[75, 79]),
        curve,
        catopt.find_length(line, height=60.0, horizontal_force=1e5, anchor_angle=0.0),
        compared,
        compared.loads,
        catopt_loads.holding_capacity("Stevpris Mk5", "sand", 1500.0),
        catopt_loads.size_drag_anchor("Stevpris Mk5", "sand", 4e5),
        catopt_loads.laying_check(catopt_loads.buoy("T-5000l-2.4m"), 8e3, 15e3, chain_in="air"),
        catopt_loads.size_sinker(1e4, soil="hard clay"),
        catopt_loads.ShipHeading(afloat, catopt_loads.HEAD_ON, 0.0, compared.loads, 20.0),
        results()["system"].watch_circle(force=1e6, directions=4),
        catopt.solve_system(network),
        catopt_reproduce.reproduce("load_sharing"),
        catopt.run_study(CASES / "study-fleet" / "study.toml", workers=1),
        catopt.verify_dynamic(catopt.read_case(AT_SEA)),
    ]


def test_every_result_shows_a_table() -> None:
    """Each is made by its own function, and asked as a notebook asks it."""
    every = [*results().values(), *plain_results()]
    assert returned() <= {type(each) for each in every}
    for each in every:
        assert "<table" in each._repr_html_(), type(each)


def test_a_plain_result_shows_its_numbers() -> None:
    """The figures of the catalogue stand in the table as they are kept."""
    chain = catopt.component("chain studless R3", "76 mm")
    html = chain._repr_html_()
    assert "<td>nominal_diameter</td><td>0.076</td>" in html
    assert f"{chain.mass:.6g}" in html
    buoy = catopt.read_case(CASES / "buoy-9.5m" / "case.toml")
    curve: Any = catopt.curve_case(buoy).curve
    assert "array (" in curve._repr_html_()


def test_the_data_frame_is_that_of_the_files() -> None:
    found = results()["design"].to_dataframe()
    written = csv_files(design_answer(results()["design"]))["front.csv"]
    read = pd.read_csv(io.BytesIO(written))
    assert list(found.columns) == list(read.columns)
    assert len(found) == len(results()["design"].front) == len(read)


@pytest.mark.parametrize(
    ("name", "frames"),
    [
        ("solution", 2), ("curve", 1), ("design", 2), ("sizing", 1), ("verification", 4),
        ("system", 2),
    ],
)  # fmt: skip
def test_a_result_draws_itself(name: str, frames: int) -> None:
    figure: Any = results()[name].plot()
    axes = [each for each in figure.get_axes() if each.has_data()]
    assert len(axes) >= frames
    assert figure._repr_png_().startswith(b"\x89PNG")  # what a notebook asks of it, by any backend


def test_what_has_no_drawing_says_which_have() -> None:
    with pytest.raises(TypeError, match="a CheckReport has no drawing; those of CaseCurve"):
        results()["checks"].plot()


@pytest.mark.parametrize("name", NAMES)
def test_every_result_has_a_data_frame(name: str) -> None:
    assert len(results()[name].to_dataframe())


def test_a_body_has_its_lines_and_its_circle() -> None:
    solved = results()["system"]
    frame = solved.to_dataframe()
    tensions = [each.tension / 1e3 for each in solved.lines]
    assert list(frame["Fairlead tension T (kN)"]) == pytest.approx(tensions, rel=1e-12)
    circle = solved.watch_circle(force=1e6, directions=4)
    assert circle == watch_circle(solved.system, force=1e6, directions=4)


def test_many_lines_are_a_data_frame() -> None:
    line = catopt.Line([catopt.Segment(100.0, 900.0)])
    many = catopt.solve_many(line, height=60, span=[75, 79])
    frame = many.to_dataframe()
    ones = [catopt.solve(line, height=60, span=span).fairlead.tension for span in (75, 79)]
    assert list(frame["fairlead tension (N)"]) == pytest.approx(ones, rel=1e-9)
    assert "<table" in many._repr_html_()
    assert catopt.solve_many(line, height=60, span=120).to_dataframe()["reason"][0]


def test_what_has_no_tables_says_which_have() -> None:
    with pytest.raises(TypeError, match="a Line has no tables; those of CaseCurve"):
        answer_of(catopt.Line([catopt.Segment(100.0, 900.0)]))
