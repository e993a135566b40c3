"""What people come with is answered within three clicks of the site's home page."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from tests.snippets import ROOT

DOCS = ROOT / "docs"
LINK = re.compile(r"\]\(([\w./-]+\.md)(?:#[\w-]*)?\)")
CLICKS = 3

QUESTIONS = [
    ("which chain for my buoy", "how-to/size-a-buoy.md", r"catopt size buoy"),
    ("which sinker", "how-to/size-a-buoy.md", r"[Ss]inker"),
    ("how far does my buoy swing", "how-to/size-a-buoy.md", r"[Ss]wing"),
    ("xích neo cho phao", "cach-lam/neo-phao.md", r"[Xx]ích"),
    ("dây neo cho tàu", "cach-lam/neo-tau.md", r"tàu"),
    ("chọn phương án nào", "cach-lam/doc-tap-phuong-an.md", r"khuyến nghị"),
    ("which chain for my ship", "how-to/size-a-tanker-line.md", r"catopt size tanker"),
    ("which anchor for my ship", "sizing.md", r"[Dd]rag anchor"),
    ("what is the force of the wind on my ship", "loads.md", r"Blendermann"),
    ("by Vietnamese practice", "loads.md", r"22TCN"),
    ("which codes are there", "checks.md", r"API-RP-2SK"),
    ("which factor with one line broken", "checks.md", r"one.line.(out|damaged)"),
    ("why is my line refused", "regimes.md", r"too short"),
    ("what is theta0", "conventions.md", r"theta0"),
    ("which tension is it", "conventions.md", r"[Ee]ffective"),
    ("which diameter is it", "conventions.md", r"[Nn]ominal"),
    ("which units may I write", "case-file.md", r"tf"),
    ("how do I add my chain", "catalogue.md", r"[Ff]amilies of your own"),
    ("where does a breaking load come from", "catalogue.md", r"[Cc]onfidence"),
    ("what does the checker get", "report.md", r"[Cc]alculation note"),
    ("which design shall I take", "how-to/read-the-front.md", r"knee"),
    ("is the closed form right", "how-to/verify-with-the-truss-model.md", r"truss"),
    ("what was it compared with", "validation.md", r"MoorPy"),
    ("all the buoys of my channel", "study.md", r"fleet of buoys"),
    ("forty years of weather", "study.md", r"forty years"),
    ("what do waves add", "dynamics.md", r"[Ww]aves"),
    ("how long must a run be", "waves.md", r"how many waves|[Ss]eeds?"),
    ("several lines on a body", "system.md", r"one line out|[Ll]ine out"),
    ("a bridle or a joint of lines", "system.md", r"[Bb]ridle|joints?"),
    ("read my MoorDyn or OrcaFlex file", "import.md", r"OrcaFlex"),
    ("write a drawing", "export.md", r"CAD"),
    ("does the published buoy reproduce", "reproduction.md", r"buoy_9p5m"),
    ("how do I do it in Python", "api.md", r"catopt\.solve|`solve`"),
    ("without a terminal", "page.md", r"catopt app"),
    ("what changed", "../CHANGELOG.md", r"Unreleased"),
    ("how do I change catopt itself", "architecture.md", r"parts"),
]  # fmt: skip


@cache
def _reached() -> dict[Path, int]:
    """Walk the links from home; clicks to each page."""
    clicks = {DOCS / "index.md": 0}
    todo = [DOCS / "index.md"]
    for page in todo:
        if clicks[page] == CLICKS or not page.is_file():
            continue
        for link in LINK.findall(page.read_text("utf-8")):
            goal = (page.parent / link).resolve()
            if goal not in clicks:
                clicks[goal] = clicks[page] + 1
                todo.append(goal)
    return clicks


@pytest.mark.parametrize(("question", "page", "answer"), QUESTIONS, ids=[q[0] for q in QUESTIONS])
def test_a_question_is_answered_within_three_clicks(question: str, page: str, answer: str) -> None:
    goal = (DOCS / page).resolve()
    assert _reached().get(goal, CLICKS + 1) <= CLICKS, question
    assert re.search(answer, goal.read_text("utf-8")), question
