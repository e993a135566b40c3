"""Names of the interface that have changed keep their old spelling for one version."""

from __future__ import annotations

import pytest

import catopt.loads


def test_the_old_name_is_the_new_class_and_warns() -> None:
    with pytest.warns(DeprecationWarning, match="catopt.loads.Lying is ShipHeading now"):
        old = catopt.loads.Lying
    assert old is catopt.loads.ShipHeading
    with pytest.raises(AttributeError, match="no attribute 'Lain'"):
        _ = catopt.loads.Lain
