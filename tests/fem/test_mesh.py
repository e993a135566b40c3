"""Where nodes lie along a line."""

from __future__ import annotations

import numpy as np
import pytest

from catopt.errors import InputError
from catopt.fem import mesh_line
from catopt.model import Line, PointLoad, Segment

LINE = Line([Segment(30.0, 100.0), Segment(10.0, 200.0)],
            [PointLoad(7.0, 500.0), PointLoad(30.0, 300.0), PointLoad(33.3, -50.0)])  # fmt: skip


@pytest.mark.parametrize("elements", [1, 7, 40, 400])
def test_every_joint_and_point_load_is_on_a_node(elements: int) -> None:
    mesh = mesh_line(LINE, elements)
    assert mesh.joints == pytest.approx((0.0, 7.0, 30.0, 33.3, 40.0), rel=1e-14)
    assert mesh.arc[mesh.load_node] == pytest.approx([7.0, 30.0, 33.3], rel=1e-14)
    assert np.diff(mesh.arc) == pytest.approx(mesh.length, rel=1e-11)
    assert elements <= mesh.elements <= elements + 4
    assert mesh.length.max() <= 40.0 / elements * (1 + 1e-5)


def test_bars_know_their_segment() -> None:
    mesh = mesh_line(LINE, [6, 5])
    middles = 0.5 * (mesh.arc[1:] + mesh.arc[:-1])
    assert np.array_equal(mesh.segment, (middles > 30.0).astype(int))
    assert np.count_nonzero(mesh.segment == 0) >= 6


def test_refinement_keeps_every_node() -> None:
    mesh = mesh_line(LINE, 11)
    fine = mesh.refined(3)
    assert fine.elements == 3 * mesh.elements
    assert fine.arc[::3] == pytest.approx(mesh.arc, rel=1e-13)
    assert mesh_line(LINE, element_length=0.5).length.max() <= 0.5


@pytest.mark.parametrize(
    ("elements", "length", "key"),
    [(0, None, "elements"), ([3], None, "elements"), (10, 0.0, "element_length")],
)
def test_wrong_numbers_are_named(elements: int, length: float | None, key: str) -> None:
    with pytest.raises(InputError, match=key):
        mesh_line(LINE, elements, element_length=length)


def test_a_line_that_all_but_hangs_slack_has_no_million_bars() -> None:
    """Its bend has a radius of H / w = 1e-12 m: rings twice as wide each, of some bars."""
    line = Line([Segment(300.0, 500.0)])
    assert mesh_line(line, 60, bends=[(120.0, 1e-12)]).elements < 60 + 4 * 2 * 25
