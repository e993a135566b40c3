"""Ctrl-C in a search within a sizing: there is no half of a sizing, whatever had been found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from catopt.__main__ import main
from catopt.design.result import DesignResult
from catopt.design.search import design_case
from catopt.model import Case
from catopt.sizing import converge


def _stop(*_: object) -> None:
    raise KeyboardInterrupt


def _pressed(case: Case) -> DesignResult:
    """Search with Ctrl-C after the first designs."""
    return design_case(case, progress=_stop)


def _pressed_before_any_passes(case: Case) -> DesignResult:
    strict = replace(case.checks, safety_factor=1e6, accept=("safety_factor",))
    return _pressed(replace(case, checks=strict))


@pytest.mark.parametrize("search", [_pressed, _pressed_before_any_passes])
def test_a_sizing_stopped_in_its_search_is_stopped(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, search: Callable[[Case], DesignResult]
) -> None:
    monkeypatch.setattr(converge, "design_case", search)
    asked = ["size", "tanker", "--dwt", "50000t", "--depth", "20m", "--at-rest", "--out"]
    assert main([*asked, str(tmp_path / "out")]) == 130
    assert not list(tmp_path.glob("out/*"))
