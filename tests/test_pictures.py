"""Pictures of README and the guide: each is shown, and is what its script draws today."""

from __future__ import annotations

import importlib.util
import re
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
BY_OTHERS = {"regime-map.svg", *(f"conventions-{e}.svg" for e in ("line", "anchor", "lengths"))}
BY_OTHERS |= {"conventions-diameters.svg"}
"""Drawn by docs/regime_map.py and docs/convention_drawings.py, which have tests of their own."""


def _script() -> Any:
    spec = importlib.util.spec_from_file_location("pictures", DOCS / "readme_pictures.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


DRAWN = _script().PICTURES


def test_every_picture_is_made_by_a_script_and_shown_on_a_page() -> None:
    kept = {path.name for end in ("png", "svg", "jpg") for path in DOCS.glob(f"*.{end}")}
    assert kept == {*DRAWN, *BY_OTHERS}
    pages = [ROOT / "README.md", *DOCS.rglob("*.md")]
    shown = {
        Path(place).name
        for page in pages
        for place in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text("utf-8"))
    }
    assert kept <= shown


@pytest.mark.slow
@pytest.mark.parametrize("name", DRAWN)
def test_a_picture_is_what_its_script_draws(name: str) -> None:
    """To 2 % of the ink: another matplotlib places letters otherwise."""
    kept, drawn = imread(DOCS / name), imread(BytesIO(DRAWN[name]()))
    anew = f"draw it anew: python docs/readme_pictures.py {name}"
    assert kept.shape == drawn.shape, anew
    assert float(np.mean(np.abs(kept - drawn))) < 0.02 * float(np.mean(1.0 - kept[..., :3])), anew
