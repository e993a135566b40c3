"""Truss model and motion in notes: what must not be hidden, and what must be known."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pandas as pd
import pytest

from catopt.casefile import read_case
from catopt.figures import motion as figures
from catopt.figures.chart import legend
from catopt.figures.motion import around_the_largest
from catopt.model import Case
from catopt.notes.line import note_of, read_note
from catopt.notes.motion import motion_warnings
from catopt.notes.origin import Asked
from catopt.notes.system import read_system_note
from catopt.quantities import QUANTITIES
from catopt.verify.case import verify_case
from catopt.verify.motion_words import part_sentence, rough_sentence
from catopt.words import LANGUAGES, Language, Message, say, term
from tests.cli.conftest import OWN as FILES
from tests.cli.conftest import Run, document_of, inside, read_document, run
from tests.verify.cases import TOUCHES_TWICE

from .notes import IN_MOTION, LINES, case_path, note_named, page_named, shown, stop, workbook_of
from .page_reader import ReadPage

__all__ = ["inside", "run"]

BUOY = case_path("buoy-9.5m")
VERIFY = "catopt.verify.case.verify_case"
ROUNDING = 1e-10


def gap_of(difference: float, each: dict[str, Any]) -> float | None:
    """Return a difference in parts of its scale; None for what rounding leaves."""
    found = abs(difference) / each["scale"]
    return found if found >= ROUNDING else None


@pytest.mark.parametrize("name", LINES)
def test_numbers_are_those_of_verify_s_document(name: str) -> None:
    page, load_case = page_named(name), note_named(name).load_case or None
    verified = verify_case(read_case(case_path(name)), load_case=load_case)
    (document,) = verified.to_dict()["load_cases"]
    quantities = document["quantities"]
    for row, each in zip(page.table("verification").rows, quantities, strict=True):
        _, closed, truss, before, gap, order, verdict = row
        assert (closed.value, truss.value) == (each["closed_form"], each["extrapolated"])
        assert gap.value == gap_of(each["difference"], each)
        assert (gap.text == "<1e-10") == (gap.value is None)
        assert before.value == gap_of(each["fem"][-1] - each["closed_form"], each)
        assert order.text == ("-" if each["order"] is None else f"{each['order']:.2f}")
        assert verdict.text == ("agrees" if each["agrees"] else "DIFFERS")
    meshes = page.table("meshes").rows
    for number, (row, mesh) in enumerate(zip(meshes, document["meshes"], strict=True)):
        assert [cell.value for cell in row[:2]] == [mesh["elements"], mesh["residual"]]
        gaps = [gap_of(each["fem"][number] - each["closed_form"], each) for each in quantities]
        assert row[2].value == max((each for each in gaps if each is not None), default=None)
    for remark in document["remarks"]:
        assert remark in page.sections["verification"]
    assert len(document["remarks"]) == 1 or name != "slack"


def seen(note: Any, language: Language = "en") -> tuple[ReadPage, str]:
    """Return the page of a note, and all that its workbook says."""
    book = openpyxl.load_workbook(BytesIO(workbook_of(note, language)))
    cells = (cell.value for sheet in book for row in sheet.iter_rows() for cell in row)
    return shown(note, language), " ".join(str(each) for each in cells if each)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(
    ("name", "words", "section"),
    [("buoy-9.5m", "note", "verification"), ("idle", "note_system", "system_verification")],
)
def test_a_truss_that_does_not_converge_stands_in_place_of_the_table(
    monkeypatch: pytest.MonkeyPatch, name: str, words: str, section: str, language: Language
) -> None:
    why = "Newton's method stopped after 500 iterations"
    stop(monkeypatch, VERIFY, why)
    page, sheet = seen(note_named.__wrapped__(name), language)
    (loud,) = page.styled("fails", section)
    assert loud.text == say(Message(f"{words}.verification_no_answer"), language)
    assert page.all(section) == page.all("meshes") == []
    for said in (page.sections[section], page.sections["warnings"], sheet):
        assert why in said
    assert loud.text in sheet


@pytest.mark.parametrize("language", LANGUAGES)
def test_models_that_differ_are_told_loudly(
    monkeypatch: pytest.MonkeyPatch, language: Language
) -> None:
    honest = verify_case(read_case(BUOY))
    quantities = []
    for each in honest.static.quantities:
        off = 0.01 * each.scale if each.quantity in ("span", "fairlead_angle") else 0.0
        quantities.append(replace(each, closed_form=each.closed_form + off))
    part = replace(honest.static, quantities=tuple(quantities))
    found = replace(honest, parts=(part,))
    monkeypatch.setattr(VERIFY, lambda _: found)
    page, sheet = seen(read_note(BUOY), language)
    sentence = say(part_sentence(found.static), language)
    assert sentence in page.sections["verification"]
    assert sentence in sheet
    verdicts = [row[-1].text for row in page.table("verification").rows]
    assert verdicts.count(say(term("DIFFERS"), language)) == 2
    assert [each.tag for each in page.styled("fails", "verification")] == ["p", "td", "td"]
    assert say(Message("notes.models_differ"), language) in page.sections["warnings"]


def test_a_quantity_that_is_not_smooth_is_named() -> None:
    note = note_named("buoy-9.5m")
    part = note.verification.static
    first, *others = part.quantities
    rough = replace(first, fem=(first.fem[2], first.fem[0], first.fem[2]))
    broken = replace(note.verification, parts=(replace(part, quantities=(rough, *others)),))
    page, sheet = seen(replace(note, verification=broken))
    told = rough_sentence(broken.static)
    assert "span" in told
    assert told in page.sections["verification"]
    assert told in sheet


@pytest.mark.parametrize("case", TOUCHES_TWICE.values(), ids=TOUCHES_TWICE)
def test_the_note_of_a_line_that_touches_twice_shows_that_the_models_agree(case: Case) -> None:
    note = note_of(case, note_named("buoy-9.5m").origin.files)
    assert note.solution.regime == "grounded-in-parts"
    assert {row[-1].text for row in shown(note).table("verification").rows} == {"agrees"}


def test_of_a_slack_line_the_difference_is_not_said_to_be_of_the_tension() -> None:
    """Its scale is a bar's weight over the tolerance, far above the tension."""
    note = note_named("slack")
    part = note.verification.static
    assert part.worst.scale > 10.0 * note.solution.fairlead.tension
    english = part_sentence(part)
    assert "of its scale" in english
    assert "of the tension" not in english
    assert "thang so sánh" in say(english, "vi")


# ------------------------------------------------------------------ in motion


def moved(name: str) -> Any:
    return note_named(name).motion


def points(key: str, page: ReadPage) -> list[str]:
    """Read the words of a figure's points."""
    elements = iter(page.elements)
    next(each for each in elements if each.attributes.get("data-figure") == key)
    words = next(e for e in elements if e.attributes.get("type") == "application/json")
    return list(json.loads(words.text))


@pytest.mark.slow
def test_of_several_load_cases_the_one_that_is_used_most_is_shown() -> None:
    found, page = moved("random"), page_named("random")
    used = [found.used(0), found.used(1)]
    assert min(used) > 0.0
    assert found.governing == (0 if used[0] > used[1] else 1) == 0
    table = page.table("motion_cases")
    assert table.marked == [0]
    assert [row[0].text for row in table.rows] == ["storm", "low water"]
    parts = found.found.to_dict()["load_cases"]
    for row, part, share in zip(table.rows, parts, used, strict=True):
        wanted = (part["quantities"][0]["max"], part["amplification"], share)
        assert (row[5].value, row[9].value, row[13].value) == wanted
    assert not page_named("harmonic").all("motion_cases")


@pytest.mark.slow
@pytest.mark.parametrize("name", IN_MOTION)
def test_each_segment_is_held_against_what_it_is_allowed(name: str) -> None:
    """MBL over the safety factor of these cases, which have no code."""
    note, found = note_named(name), moved(name)
    table = page_named(name).table("motion_use")
    for row, segment in zip(table.rows, note.case.line.segments, strict=True):
        largest, quasi_static, allowed, utilisation = (cell.value for cell in row[2:6])
        assert allowed == segment.MBL / note.case.checks.safety_factor
        assert quasi_static is not None
        assert utilisation == largest / allowed
        assert row[6].text == "passes"
    worst = max(row[2].value for row in table.rows)
    assert worst == found.found.parts[found.governing].max_tension


def test_factors_of_a_code_for_dynamic_analysis_judge_a_tension_in_motion() -> None:
    """API 1.67 on the tension."""
    ((use,),) = moved("by-code").uses
    assert use.utilisation == pytest.approx(1.67 * use.largest / 3000e3, rel=1e-12)


@pytest.mark.slow
def test_more_than_is_allowed_in_motion_may_pass_at_rest() -> None:
    assert note_named("overloaded").checks.passes


def with_history(**changes: Any) -> Any:
    """Change the history of the only run of the harmonic case, and say whether it is complete."""
    found = moved("harmonic")
    (part,) = found.found.parts
    (run,) = part.runs
    part = replace(part, runs=(replace(run, history=replace(run.history, **changes)),))
    complete = changes.get("is_complete", True)
    return replace(found, found=replace(found.found, parts=(part,), is_complete=complete))


def test_slack_is_told_at_the_top() -> None:
    (said,) = motion_warnings(with_history(slack_time=np.full(20, 1.5)))
    assert said == "in motion: the line goes slack, a bar for 1.50 s of a run in total"


def test_a_run_that_was_stopped_says_so() -> None:
    stopped = with_history(is_complete=False)
    page = shown(replace(note_named("harmonic"), motion=stopped))
    first, _ = page.styled("verdict", "in_motion")
    assert first.text.startswith("stopped in load case load, run 1 of 1")
    assert next(motion_warnings(stopped)).startswith("the line in motion is not complete")


@pytest.mark.slow
def test_what_drives_it_with_its_figures() -> None:
    # S4's rule: x = Tp/sqrt(Hs) = 4.95, and gamma = exp(5.75 - 1.15 x) between 3.6 and 5.
    drive = page_named("random").table("motion_drive")
    gamma = drive.row("Peak enhancement γ, by the rule on Tp/√Hs")[1].value
    assert gamma == pytest.approx(math.exp(5.75 - 1.15 * 7.0 / math.sqrt(2.0)), rel=1e-12)
    # Its file is among the sources.
    assert [file.name for file in note_named("random").origin.files] == ["random.toml", "rao.csv"]


def test_the_model_with_drag_and_added_mass_on_their_diameters() -> None:
    note, page = note_named("random"), page_named("random")
    table = page.table("motion_segments")
    for row, segment in zip(table.rows, note.case.line.segments, strict=True):
        displaced = segment.mass - segment.submerged_weight / 9.80665
        diameter = math.sqrt(4.0 * displaced / (math.pi * 1025.0))
        assert row[4].value == segment.drag_diameter
        assert row[5].value == segment.drag_normal
        assert row[7].value == pytest.approx(diameter, rel=1e-12)  # rounding
        assert row[8].value == 1.0
    history = moved("random").found.parts[0].runs[0].history
    assert history.since == 15.0
    assert page.table("motion_model").row("Time step")[1].value == history.step


@pytest.mark.parametrize("name", IN_MOTION)
def test_the_series_is_around_the_largest_value(name: str) -> None:
    found = moved(name)
    part = found.found.parts[found.governing]
    run, most = part.governing, part.of("fairlead_tension").maximum
    chosen, few = around_the_largest(run), around_the_largest(run, 50)
    tension = run.history.fairlead_tension[:, 0]
    assert tension[chosen].max() == tension[few].max() == most
    assert run.history.time[chosen[0]] >= run.history.since - 1e-9
    assert len(few) <= 52
    written = [QUANTITIES["tension"].format(each, unit=True) for each in tension]
    # Turning points between the samples stand among them.
    texts = points("motion", page_named(name))
    assert len(texts) > len(chosen)
    for k in chosen:
        begins = f"t = {run.history.time[k]:.2f} s, T = {written[k]}, quasi-static "
        assert any(text.startswith(begins) for text in texts)
    largest = QUANTITIES["tension"].format(most, unit=True)
    assert any(f"T = {largest}, " in text for text in texts)
    assert any(largest in label for _, label in legend(figures.history(part, 1.0)))


@pytest.mark.parametrize("name", IN_MOTION)
def test_the_envelope_holds_what_the_runs_reached(name: str) -> None:
    found = moved(name)
    part = found.found.parts[found.governing]
    high, low = part.envelope.largest, part.envelope.smallest
    for k in range(len(part.envelope.arc)):
        assert high[k] == max(run.history.max_tension[k] for run in part.runs)
        assert low[k] == min(run.history.min_tension[k] for run in part.runs)
    texts = points("envelope", page_named(name))
    written = [QUANTITIES["tension"].format(value, unit=True) for value in high]
    assert [re.search(r"to (.*?), at rest", text)[1] for text in texts] == written  # type: ignore[index]


def test_what_was_sought_is_put_in_its_place() -> None:
    """The length that just lies down at the anchor, not the one in the file, is run."""
    arc = moved("sought").found.parts[0].envelope.arc
    length = note_named("sought").solution.line.length
    assert length < 119.0
    assert arc[-1] == pytest.approx(length * (1.0 - 0.5 / 20), rel=1e-12)  # the last bar's middle


# ------------------------------------------------------------------ a body in motion


@pytest.mark.parametrize(("name", "file"), [("led", "ship.csv"), ("pushed", "force.csv")])
def test_every_line_has_its_row_and_the_governing_one_is_marked(name: str, file: str) -> None:
    case = FILES / f"{name}.toml"
    note: Any = read_system_note(case, asked=Asked(verify=False, motion=True))
    page = shown(note)
    assert page.unclosed == []
    rows = page.table("system_motion_lines").rows
    assert len(rows) == 3
    for row, part in zip(rows, note.motion.parts, strict=True):
        assert row[5].value == part.of("fairlead_tension").maximum
        assert row[1].value == note.solution.lines[part.line - 1].tension
    assert len(page.table("system_motion_body").rows) == 3
    assert note.origin.files[-1].name == file


@pytest.mark.slow
def test_the_document_and_the_note_of_a_result_directory(run: Run, inside: Path) -> None:
    out = inside / "out"
    options = ("--dynamic", "--once", "--elements", 40, "--out", out)
    assert run("verify", FILES / "led.toml", *options).status == 0
    verified = read_document((out / "verify.json").read_text("utf-8"))
    table = pd.read_csv(out / "dynamic_statistics.csv")
    assert list(table["Line"]) == [k for k in (1, 2, 3) for _ in range(4)]
    way = pd.read_csv(out / "dynamic_body.csv")
    assert way["Body x (m)"].max() == verified["dynamic"]["body"][0]["max"]
    assert [path.name for path in out.glob("dynamic*.png")] == ["dynamic.png"]
    document = document_of(run, "report", out, "--no-verify", "--out", "note")
    assert "system_motion" in document["sections"]
    assert document["motion"]["line"] == 1
    assert any("NOT PROVEN" in warning for warning in document["warnings"])
