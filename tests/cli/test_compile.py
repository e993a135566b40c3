"""``catopt compile``: what it runs reaches every function that is compiled anywhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from catopt import compile_jobs
from catopt import compiled as module
from catopt.compile_jobs import JOBS
from tests.test_both_forms import JOBS as OF_EVERY_FUNCTION

from .conftest import Run


@pytest.mark.slow
def test_it_reaches_every_function_that_is_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(module.VARIABLE, "never")
    plain, reached = module._plain, set()

    def note(function: Callable[..., Any]) -> Callable[..., Any]:
        reached.add(function.__name__)
        return plain(function)

    monkeypatch.setattr(module, "_plain", note)
    for job in JOBS.values():
        job()
    assert reached == set().union(*OF_EVERY_FUNCTION.values())


def test_each_part_is_named_and_run_once(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(module.VARIABLE, "never")
    modes = []

    def job() -> None:
        modes.append(module._mode())

    monkeypatch.setattr(compile_jobs, "JOBS", {"many lines": job, "design search": job})
    ran = run("compile")
    assert (ran.status, ran.err) == (0, "")
    assert [each.split(": ")[0] for each in ran.out.splitlines()] == ["many lines", "design search"]
    assert modes == ["always", "always"]
    assert module._mode() == "never"
