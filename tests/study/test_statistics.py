"""Statistics over members, with numbers put in by hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from catopt.figures.studies import share_worse
from catopt.study.member import Base
from catopt.study.result import StudyResult
from catopt.study.store import Computed, Store
from catopt.study.study import Axis, Distribution, Study

DOCUMENT = {"site": {"water_depth": 9.5}, "line": {"segments": [{"length": 20.0}]}, "load": {}}
DRAWN = {
    "site.water_depth": Distribution("uniform", -1.0, 1.0),
    "load.horizontal_force": Distribution("uniform", -1.0, 1.0),
}
BASE = Base(DOCUMENT, "case.toml", "", "statics")


def result(axes: list[Axis], values: np.ndarray, limits: dict[str, float] | None = None,
           reasons: dict[int, str] | None = None) -> StudyResult:  # fmt: skip
    """Members whose fairlead tension is given; grounded length is its negative plus 100."""
    study = Study("by hand", BASE, tuple(axes), limits or {})
    store = Store(study)
    numbers = np.column_stack([values, values, values, 100.0 - values, values])
    store.put(Computed(0, numbers, (), reasons or {}))
    return StudyResult(study, store)


def forces(n: int, weights: np.ndarray | None = None) -> Axis:
    return Axis({"load.horizontal_force": np.arange(1.0, n + 1.0)}, weights)


def test_members_of_equal_weight() -> None:
    of = result([forces(100)], np.arange(1.0, 101.0)).statistics[0]
    assert of.kept.name == "fairlead_tension"
    assert (of.count, of.least, of.largest, of.worst) == (100, 1.0, 100.0, 99)
    assert of.mean == pytest.approx(50.5)
    assert of.deviation == pytest.approx(((100**2 - 1) / 12) ** 0.5)  # of 1 to n
    assert of.levels == (5.0, 50.0, 95.0, 99.0)  # 5 of 100 are 5 or less


def test_weights_count() -> None:
    # Ten hours of 1, one of 2, one of 3: two thirds are 1 though it is a third of the rows.
    of = result([forces(3, np.array([10.0, 1.0, 1.0]))], np.array([1.0, 2.0, 3.0])).statistics[0]
    assert of.mean == pytest.approx(15.0 / 12.0)
    assert of.levels == (1.0, 1.0, 3.0, 3.0)  # 10/12 = 83 % are 1; 11/12 = 92 % are 2 or less


def test_the_bad_end_of_a_grounded_length_is_the_least() -> None:
    found = result([forces(10)], np.arange(10.0), {"grounded_length": 93.5, "span": 7.5})
    by_name = {each.kept.name: each for each in found.statistics}
    assert by_name["grounded_length"].worst == 9
    assert by_name["grounded_length"].beyond == pytest.approx(0.3)  # 93, 92 and 91
    assert by_name["span"].beyond == pytest.approx(0.2)  # 8 and 9
    assert by_name["fairlead_tension"].limit is None
    assert (by_name["grounded_length"].first_beyond, by_name["span"].first_beyond) == (7, 8)
    assert by_name["fairlead_tension"].first_beyond is None


def test_members_without_an_answer_are_left_out_and_told() -> None:
    values = np.array([1.0, np.nan, 3.0, np.nan])
    found = result([forces(4)], values, reasons={1: "too short", 3: "too short"})
    assert found.statistics[0].count == 2
    assert found.statistics[0].mean == 2.0
    assert found.failures() == [("too short", 2, 1)]


def test_influences_of_a_sum() -> None:
    # y = a + 3 b over a 2 x 2 grid of -1 and 1: variances 1 and 9.
    two = np.array([-1.0, 1.0])
    axes = [Axis({"site.water_depth": two}), Axis({"load.horizontal_force": two})]
    y = np.add.outer(two, 3.0 * two).ravel()
    first, second = result(axes, y).influences
    assert first.keys == ("load.horizontal_force",)
    assert (first.share, second.share) == pytest.approx((0.9, 0.1))
    assert (first.low, first.high) == (-3.0, 3.0)


def test_influences_of_what_is_drawn() -> None:
    # y = a + 2 b of uniform draws: variances 1 to 4. Parts of a twentieth lose 1/400 of each.
    rng = np.random.default_rng(5)
    n = 20_000
    a, b = rng.uniform(-1.0, 1.0, (2, n))
    axis = Axis({"site.water_depth": a, "load.horizontal_force": b}, distributions=DRAWN)
    first, second = result([axis], a + 2.0 * b).influences
    assert first.share == pytest.approx(0.8, abs=0.01)
    assert second.share == pytest.approx(0.2, abs=0.01)


def test_what_is_not_computed_yet_is_nowhere_and_the_rest_in_its_place() -> None:
    study = Study("", BASE, (forces(50_000),), {})
    store = Store(study)
    assert StudyResult(study, store).statistics == ()
    assert StudyResult(study, store).done == 0
    values = np.arange(40_000.0, 50_000.0)
    store.put(Computed(2, np.column_stack([values] * 5), (), {5: "too short"}))
    found = StudyResult(study, store)
    of = found.statistics[0]
    assert (found.done, found.is_complete, of.count) == (10_000, False, 10_000)
    assert (of.least, of.largest, of.worst) == (40_000.0, 49_999.0, 49_999)
    assert found.reasons == {40_005: "too short"}
    assert found.influences == ()


def test_another_study_does_not_get_the_pieces(tmp_path: Path) -> None:
    from catopt.errors import InputError

    study = Study("", BASE, (forces(3),))
    Store(study, tmp_path).close()
    Store(study, tmp_path).close()
    with pytest.raises(InputError, match="another study"):
        Store(Study("", BASE, (forces(4),)), tmp_path)


def test_the_drawing_has_the_share_at_or_above_each_value() -> None:
    found = result([forces(10)], np.arange(1.0, 11.0), {"fairlead_tension": 7.5})
    chart = share_worse(found, found.statistics[0])
    (curve,) = chart.series
    assert dict(zip(curve.x, curve.y, strict=True)) == pytest.approx(
        {value: (11.0 - value) / 10.0 for value in range(1, 11)}
    )
    assert [level.at for level in chart.levels] == [7.5]


def test_of_what_is_bad_when_it_is_small_the_share_at_or_below() -> None:
    found = result([forces(4, np.array([5.0, 3.0, 1.0, 1.0]))], np.arange(4.0))
    grounded = next(each for each in found.statistics if each.kept.name == "grounded_length")
    (curve,) = share_worse(found, grounded).series  # 100, 99, 98 and 97 m
    assert dict(zip(curve.x, curve.y, strict=True)) == pytest.approx(
        {100.0: 1.0, 99.0: 0.5, 98.0: 0.2, 97.0: 0.1}
    )


@pytest.mark.slow
def test_a_dataset_has_a_dimension_for_all_that_varies() -> None:
    pytest.importorskip("xarray")
    two, three = np.array([9.0, 9.5]), np.array([1.0, 2.0, 4.0])
    axes = [Axis({"site.water_depth": two}), Axis({"load.horizontal_force": three})]
    values = np.arange(6.0)
    values[4] = np.nan
    found = result(axes, values).to_xarray()
    assert found.sizes == {"site.water_depth": 2, "load.horizontal_force": 3}
    tension = found["fairlead_tension"]
    assert tension.attrs["units"] == "N"
    at = tension.sel({"site.water_depth": 9.5, "load.horizontal_force": 4.0})
    assert float(at) == 5.0
    assert int(tension.isnull().sum()) == 1
    drawn = Axis({"site.water_depth": two, "load.horizontal_force": two}, distributions=DRAWN)
    assert result([drawn], np.arange(2.0)).to_xarray()["span"].dims == ("draw",)


def test_the_largest_weights_make_shares() -> None:
    """Their sum is no float: they count by what they are of the largest."""
    axis = Axis({"load.span": np.array([1.0, 2.0, 3.0])}, np.array([1e308, 1e308, 0.5e308]))
    assert axis.shares.tolist() == pytest.approx([0.4, 0.4, 0.2])
