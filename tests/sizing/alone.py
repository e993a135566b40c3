"""Sizings without what stands beside a recommended line: it takes most of the time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest


@contextmanager
def alone() -> Iterator[None]:
    """Size lines alone: without neighbouring sizes, other preferences and steps that fail."""
    with pytest.MonkeyPatch.context() as patched:
        for beside in ("candidates", "alternatives", "limits"):
            patched.setattr(f"catopt.sizing.answer.{beside}", lambda *_, **__: ())
        yield
