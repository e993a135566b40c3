"""A solution makes its shape when it is read: the same one, whole when it is copied or kept."""

from __future__ import annotations

import copy
import pickle
from dataclasses import fields, replace

import pytest

import catopt.catenary.solve as solver
from catopt import Line, PointLoad, Segment, Solution, solve
from catopt.catenary.pieces import cut

LINE = Line([Segment(80.0, 900.0, EA=1e8), Segment(120.0, 400.0)], [PointLoad(70.0, 5e3)])


def solved() -> Solution:
    """Solve a line of two segments with a clump weight, partly on the bed."""
    return solve(LINE, height=60.0, horizontal_force=3e4)


def test_forces_need_no_shape(monkeypatch: pytest.MonkeyPatch) -> None:
    """A loop that reads forces and spans lays nothing out."""
    laid = []
    monkeypatch.setattr(solver, "lay_out", lambda *given: laid.append(given))
    solution = solved()
    assert solution.span > 0.0
    assert solution.fairlead.tension > 3e4
    assert abs(solution.residual.height) < 1e-9
    assert not laid
    with pytest.raises(TypeError):
        _ = solution.segments  # of which the shape is one that is not laid out
    assert laid


def test_a_copy_is_whole() -> None:
    """What is pickled, copied or changed has every field, and equals what it was made from."""
    for other in (
        pickle.loads(pickle.dumps(solved())),
        copy.copy(solved()),
        copy.deepcopy(solved()),
        replace(solved()),
    ):
        assert {each.name for each in fields(other)} <= {*other.__dict__, *dir(Solution)}
        assert "_later" not in other.__dict__
        assert other == solved()
        assert other.stretches[0].length == solved().stretches[0].length > 0.0


def test_what_is_no_field_is_missed() -> None:
    """A misspelt attribute is told as Python tells it, and `hasattr` works."""
    with pytest.raises(AttributeError, match="'Solution' has no 'tensoin'"):
        _ = solved().tensoin  # type: ignore[attr-defined]
    assert not hasattr(solved(), "tensoin")


def test_pieces_of_a_line_are_cut_once() -> None:
    """They are kept on the line, which is frozen; an equal line has its own."""
    line = Line([Segment(80.0, 900.0)])
    assert cut(line) is cut(line)
    assert cut(line) == cut(Line([Segment(80.0, 900.0)]))
    assert pickle.loads(pickle.dumps(line)) == line
