"""What the page has of catopt answers every button and every field: no part is missed."""

from __future__ import annotations

import io
import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import jinja2
import markupsafe
import pytest

from catopt.page_api import shell
from catopt.page_api.fields import DOORS, START, fields_of
from catopt.web.build import site

ASKING = """
import json, sys, traceback
from catopt.page_api import ask

found = []
for call, question in json.load(sys.stdin):
    try:
        found.append(ask(call, question))
    except BaseException:
        found.append({"traceback": traceback.format_exc(limit=-3)})
print(json.dumps(found))
"""
OF_DOOR = {
    "line": ("solve", "check", "curve"),
    "body": ("system",),
    "buoy": ("size",),
    "tanker": ("size",),
}
FOR_ALL = ("open", "file", "live", "whole", "note")


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Unpack what a browser is given: catopt without some parts, and a small numpy."""
    folder = tmp_path_factory.mktemp("site")
    with zipfile.ZipFile(io.BytesIO(site([]))) as packed:
        packed.extractall(folder)
    for each in (jinja2, markupsafe):
        place = Path(str(each.__file__)).parent
        shutil.copytree(place, folder / place.name)
    assert not (folder / "catopt" / "fem").exists()
    return folder


def answers(page: Path, asked: list[tuple[str, dict[str, Any]]]) -> list[dict[str, Any]]:
    ran = subprocess.run(
        [sys.executable, "-S", "-c", ASKING],  # without what else is installed
        input=json.dumps(asked),
        env={**os.environ, "PYTHONPATH": str(page)},
        cwd=page,
        capture_output=True,
        text=True,
        check=True,
    )
    found: list[dict[str, Any]] = json.loads(ran.stdout)
    return found


def test_every_button_of_every_door_in_both_languages(page: Path) -> None:
    asked = [
        (call, {"door": door, "values": START[door], "lang": language})
        for door in DOORS
        for call in (*OF_DOOR[door], *FOR_ALL)
        for language in ("en", "vi")
    ]
    for (call, question), reply in zip(asked, answers(page, asked), strict=True):
        where = f"{question['door']} {call} {question['lang']}"
        assert "traceback" not in reply, f"{where}: {reply['traceback']}"
        assert "problems" not in reply, f"{where}: {reply}"
        if call == "size":
            assert reply["schema"] == "catopt.size/1"
            assert reply["verdict"]["colour"] == "amber"


def test_a_sizing_on_the_page_is_amber_and_says_that_motion_was_not_judged(page: Path) -> None:
    """A ship of 50,000 t had 1.5 t in green, where her own motion asks for 8."""
    asked = [("live", {"door": door, "values": START[door]}) for door in ("buoy", "tanker")]
    for reply in answers(page, asked):
        assert 'class="verdict in-part"' in reply["card"]
        assert (
            "Not judged: motion (on a computer catopt app, or save the file: catopt size FILE)"
            in reply["card"]
        )


def test_what_asks_for_runs_is_refused_with_the_way_out(page: Path) -> None:
    text = '[site]\nwater_depth = "12 m"\n[buoy]\nname = "pillar 1.8 m"\n[motion]\nrun = true\n'
    (reply,) = answers(page, [("live", {"text": text})])
    (problem,) = reply["problems"]
    assert (problem["key"], problem["found"]) == ("motion.run", "true")
    assert "catopt size buoy FILE" in problem["allowed"]


def test_the_page_has_no_field_that_it_cannot_honour() -> None:
    for door in ("buoy", "tanker"):
        own, of_app = ({each.key for each in fields_of(door, runs=k)} for k in (False, True))
        assert not any(key.startswith("motion.") for key in own)
        assert "buoy.centre_of_gravity" not in own
        assert "motion.run" in of_app
    assert "motion.run" not in shell(runs=False)
    assert "motion.run" in shell(runs=True)


def test_a_run_is_refused_where_no_python_stands_behind_the_page(page: Path) -> None:
    question = {"door": "tanker", "values": START["tanker"]}
    asked: list[tuple[str, dict[str, Any]]]
    asked = [("run", question), ("progress", {}), ("stop", {})]
    refused, *others = answers(page, asked)
    assert [each["key"] for each in refused["problems"]] == ["motion.run"]
    assert others == [{}, {}]
    assert 'data-do="run"' not in shell(runs=False)


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "vi"])
@pytest.mark.parametrize("door", DOORS)
def test_every_field_takes_its_own_placeholder(page: Path, door: Any, language: str) -> None:
    """Of what is refused beside other inputs the reason is said; nothing ends in a traceback."""
    fields = [each for each in fields_of(door, runs=False) if each.example]
    asked = [
        (
            "live",
            {"door": door, "values": START[door] | {each.key: each.example}, "lang": language},
        )
        for each in fields
    ]
    for field, reply in zip(fields, answers(page, asked), strict=True):
        assert "traceback" not in reply, f"{field.key}: {reply['traceback']}"
        for problem in reply.get("problems", ()):
            assert "quotes" not in problem["allowed"], f"{field.key} = {field.example}: {problem}"
