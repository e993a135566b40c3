"""The note's part of the line in motion: its numbers, its figures, its words and its sheet."""

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
import pytest

from catopt.errors import InputError
from catopt.figures.chart import legend
from catopt.figures.motion import around_the_largest, envelope, history
from catopt.notes.line import read_note
from catopt.notes.motion import InMotion, motion_warnings
from catopt.quantities import QUANTITIES
from catopt.render.texts import Words
from catopt.report.page.closing import warnings
from catopt.report.page.motion import motion
from catopt.report.page.render import render_page
from catopt.report.workbook.note import note_workbook
from tests.cli.vietnamese import gathered, untranslated

from .further_cases import HARMONIC, further_case, further_note, further_page, same_words
from .page_cases import CASES, known_page
from .page_reader import ReadPage, read_page

ROUNDING = 1e-15
"""Relative: the workbook keeps 16 significant digits."""

BOTH = ("harmonic", "random")


def moved(name: str) -> InMotion:
    found = further_note(name).motion
    assert found is not None
    return found


def points(key: str, page: ReadPage) -> list[str]:
    """Read the words of a figure's points."""
    start = next(
        k for k, each in enumerate(page.elements) if each.attributes.get("data-figure") == key
    )
    words = next(
        e.text for e in page.elements[start:] if e.attributes.get("type") == "application/json"
    )
    found: list[str] = json.loads(words)
    return found


def test_it_is_there_only_where_somebody_asked() -> None:
    assert "in_motion" not in known_page("tanker-20m").sections
    for name in BOTH:
        page = further_page(name)
        assert page.unclosed == []
        assert "in_motion" in page.sections


@pytest.mark.parametrize("name", BOTH)
def test_the_statistics_are_those_of_the_document(name: str) -> None:
    found = moved(name)
    part = found.found.to_dict()["load_cases"][found.governing]
    table = further_page(name).table("motion_statistics")
    for row, each in zip(table.rows, part["quantities"], strict=True):
        keys = ("mean", "std", "min", "max", "most_probable_max")
        assert [cell.value for cell in row[2:7]] == [each[key] for key in keys]
        changes = [c["change"] for c in part["changes"] if c["quantity"] == each["quantity"]]
        # The lines stay taut: by the step alone.
        assert row[7].value == max(changes)
    at_rest = found.solutions[found.governing]
    assert table.rows[0][1].value == at_rest.fairlead.tension
    assert table.rows[1][1].value == at_rest.anchor.tension
    assert table.rows[2][1].value == at_rest.grounded_length
    outcome = [row[1].value for row in further_page(name).table("motion_outcome").rows]
    told = (
        "max_tension_N", "quasi_static_max_tension_N", "amplification", "slack_time_s",
        "longest_slack_s",
    )  # fmt: skip
    assert outcome[:5] == [part[key] for key in told]
    balance = found.found.parts[found.governing].governing.history.balance
    assert outcome[5] == balance.put_in
    assert outcome[-2:] == [balance.numerical, balance.numerical_part]


def test_of_several_load_cases_the_one_that_is_used_most_is_shown() -> None:
    found, page = moved("random"), further_page("random")
    used = [found.used(0), found.used(1)]
    assert used[0] is not None
    assert used[1] is not None
    assert found.governing == (0 if used[0] > used[1] else 1) == 0
    table = page.table("motion_cases")
    assert table.marked == [0]
    assert [row[0].text for row in table.rows] == ["storm", "low water"]
    parts = found.found.to_dict()["load_cases"]
    for row, part, share in zip(table.rows, parts, used, strict=True):
        fairlead = part["quantities"][0]
        assert row[5].value == fairlead["max"]
        assert row[8].value == part["amplification"]
        assert row[9].value == share
    assert not further_page("harmonic").all("motion_cases")


@pytest.mark.parametrize("name", BOTH)
def test_each_segment_is_held_against_what_it_is_allowed(name: str) -> None:
    """MBL over the safety factor of these cases, which have no code."""
    note, found = further_note(name), moved(name)
    table = further_page(name).table("motion_use")
    factor = note.case.checks.safety_factor
    for row, segment in zip(table.rows, note.case.line.segments, strict=True):
        assert segment.MBL is not None
        assert row[4].value == segment.MBL / factor
        assert row[3].value is not None
        assert row[2].value is not None
        assert row[5].value == row[2].value / row[4].value
        assert row[6].text == "passes"
    largest = max(float(row[2].value or 0.0) for row in table.rows)
    assert largest == found.found.parts[found.governing].max_tension


def test_more_than_is_allowed_is_told_at_the_top(tmp_path: Path) -> None:
    path = tmp_path / "weak.toml"
    path.write_text(HARMONIC.replace('"3000 kN"', '"1100 kN"'), encoding="utf-8")
    note = read_note(path, motion=True, verify=False)
    assert note.checks.passes, "at rest it passes"
    page = read_page(render_page(note))
    assert "segment 1 carries" in page.sections["warnings"]
    (verdict,) = page.styled("verdict", "in_motion")
    assert "fails" in verdict.attributes["class"]
    assert "MORE THAN IS ALLOWED" in verdict.text
    assert page.table("motion_use").rows[0][6].text == "FAILS"


def test_slack_is_told_at_the_top() -> None:
    found = moved("harmonic")
    (part,) = found.found.parts
    (run,) = part.runs
    history = replace(run.history, slack_time=np.full(20, 1.5))
    slack = replace(part, runs=(replace(run, history=history),))
    changed = replace(found, found=replace(found.found, parts=(slack,)))
    (said,) = motion_warnings(changed)
    assert said == "in motion: the line goes slack, a bar for 1.50 s of a run in all"


def test_what_drives_it_with_its_figures() -> None:
    page = further_page("random")
    drive = {row[0].text: row[1] for row in page.table("motion_drive").rows}
    assert drive["Significant wave height Hs"].value == 2.0
    assert drive["Peak period Tp"].value == 7.0
    assert drive["Waves travel to (from the axis anchor to fairlead)"].value == math.pi
    assert drive["Seeds of the runs"].text == "(11, 0), (11, 1)"
    # S4's rule: x = Tp/sqrt(Hs) = 4.95, and gamma = exp(5.75 - 1.15 x) between 3.6 and 5.
    gamma = drive["Peak enhancement γ"]
    assert gamma.value == pytest.approx(math.exp(5.75 - 1.15 * 7.0 / math.sqrt(2.0)), rel=1e-12)
    assert "by the rule" in gamma.text
    assert drive["Speeds by depth"].text == "1 m/s at 0 m; 0.2 m/s at 20 m"
    assert "rao.csv" in drive["Motion of the fairlead"].text
    raos = page.table("motion_raos")
    assert [[cell.text for cell in row] for row in raos.rows] == [
        ["3", "0", "–", "0.02", "40"],  # where nothing moves there is no lag
        ["8", "0.3", "90", "0.6", "10"],
        ["20", "0.9", "90", "1", "0"],
    ]  # fmt: skip
    harmonic = {row[0].text: row[1] for row in further_page("harmonic").table("motion_drive").rows}
    assert harmonic["Surge: amplitude and phase"].value == 0.5
    assert harmonic["Heave: amplitude and phase"].text == "0.2 m, 90°"


HARMONIC_MOTION = HARMONIC[HARMONIC.index("[motion]") : HARMONIC.index("[dynamics]")]
REGULAR = """
[waves]
spectrum = "regular"
height = "1.5 m"
period = "6 s"
stretching = "wheeler"
[current]
profile = "wind"
speed = "0.5 m/s"
depth = "10 m"
direction = "45 deg"
"""
RECORDED = """
[waves]
spectrum = "pierson-moskowitz"
height = "1 m"
period = "6 s"
components = 20
[current]
profile = "power"
speed = "0.7 m/s"
exponent = 0.2
[motion]
file = "record.csv"
"""


@pytest.mark.parametrize(
    ("driven", "told"),
    [
        (REGULAR, {
            "Waves": "regular", "Wave height H": "1.5 m", "Wave period T": "6 s",
            "Water's motion above still water": "Wheeler's stretching",
            "Current": "driven by wind, linear down to a depth",
            "Speed at the surface": "0.5 m/s", "Depth to which it reaches": "10 m",
            "Current flows to (from the axis anchor to fairlead)": "45°",
        }),
        (RECORDED, {
            "Waves": "random, Pierson-Moskowitz spectrum", "Exponent": "0.2",
            "Motion of the fairlead": "as recorded in record.csv",
            "Length of the record": "40 s", "Recorded surge": "-0.3 to 0.3 m",
        }),
    ],
    ids=["regular", "recorded"],
)  # fmt: skip
def test_every_way_of_driving_it_is_told(
    tmp_path: Path, driven: str, told: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    swings = (0.0, 0.3, 0.0, -0.3)
    rows = [f"{t},{swings[t // 2 % 4]}" for t in range(0, 41, 2)]
    (tmp_path / "record.csv").write_text("\n".join(["t,x", *rows]), encoding="utf-8")
    path = tmp_path / "driven.toml"
    path.write_text(HARMONIC.replace(HARMONIC_MOTION, driven), encoding="utf-8")
    note = read_note(path, motion=True, verify=False)
    page = read_page(render_page(note))
    drive = {row[0].text: row[1].text for row in page.table("motion_drive").rows}
    assert drive | told == drive
    missing = gathered(monkeypatch)
    assert motion(note, Words("vi")) is not None
    assert untranslated(missing - {"chain"}) == []


def test_the_file_of_the_motion_is_among_the_sources() -> None:
    names = [file.name for file in further_note("random").origin.files]
    assert names == ["random.toml", "rao.csv"]
    digests = [row[1].text for row in further_page("random").table("identity").rows]
    assert any(text.startswith("rao.csv, SHA-256 ") for text in digests)


def test_the_model_with_drag_and_added_mass_on_their_diameters() -> None:
    note, page = further_note("random"), further_page("random")
    table = page.table("motion_segments")
    for row, segment in zip(table.rows, note.case.line.segments, strict=True):
        assert segment.mass is not None
        displaced = segment.mass - segment.submerged_weight / 9.80665
        diameter = math.sqrt(4.0 * displaced / (math.pi * 1025.0))
        assert row[4].value == segment.drag_diameter
        assert row[5].value == segment.drag_normal
        assert row[7].value == pytest.approx(diameter, rel=1e-12)  # rounding
        assert row[8].value == 1.0
    model = {row[0].text: row[1].value for row in page.table("motion_model").rows}
    run = moved("random").found.parts[0].runs[0]
    assert model["Bars of the line"] == 24
    assert model["Ramp, over which motion and waves grow"] == 15.0
    assert model["Statistics begin at"] == run.history.since == 15.0
    assert model["Time step"] == run.history.step


@pytest.mark.parametrize("name", BOTH)
def test_the_series_is_around_the_largest_value(name: str) -> None:
    found = moved(name)
    part = found.found.parts[found.governing]
    run = part.governing
    chosen = around_the_largest(run)
    tension = run.history.fairlead_tension[:, 0]
    assert tension[chosen].max() == part.of("fairlead_tension").maximum
    assert run.history.time[chosen[0]] >= run.history.since - 1e-9
    assert len(around_the_largest(run, 50)) <= 52
    assert tension[around_the_largest(run, 50)].max() == tension[chosen].max()
    texts = points("motion", further_page(name))
    assert len(texts) == len(chosen)
    for text, k in zip(texts, chosen, strict=True):
        t, shown = f"{run.history.time[k]:.2f}", QUANTITIES["tension"].format(tension[k], unit=True)
        assert text.startswith(f"t = {t} s, T = {shown}, quasi-static ")
    largest = QUANTITIES["tension"].format(part.of("fairlead_tension").maximum, unit=True)
    assert any(largest in entry.label for entry in legend(history(part, 1.0)))


@pytest.mark.parametrize("name", BOTH)
def test_the_envelope_holds_what_the_runs_reached(name: str) -> None:
    found = moved(name)
    part = found.found.parts[found.governing]
    arc, high, low = envelope(part)
    for k in range(len(arc)):
        assert high[k] == max(run.history.max_tension[k] for run in part.runs)
        assert low[k] == min(run.history.min_tension[k] for run in part.runs)
    texts = points("envelope", further_page(name))
    shown = [QUANTITIES["tension"].format(value, unit=True) for value in high]
    assert [re.search(r"to (.*?), at rest", text)[1] for text in texts] == shown  # type: ignore[index]


def test_what_must_be_known_of_it() -> None:
    random, harmonic = (further_page(name).sections["in_motion"] for name in ("random", "harmonic"))
    assert "statistics, envelope and the largest values are of 15 s to 150 s" in random
    assert "2 runs with seeds of their own" in random
    assert "the quasi-static tension is without the current" in random
    assert "The most probable maximum is that of 3 h of this sea" in random
    assert "the most probable maximum of the fairlead tension is " in random
    assert "The grounded length in motion is known to the length of a bar" in random
    assert "Nothing is random here" in harmonic
    assert "two" not in harmonic


def test_extremes_with_their_interval_and_what_they_rest_on() -> None:
    part = moved("random").found.parts[moved("random").governing]
    page = further_page("random")
    assert page.table("motion_statistics").headings[6] == "Most probable maximum in 3 h"
    table = page.table("motion_extremes")
    found = [each for each in part.quantities if each.tail is not None]
    assert [each.quantity for each in found] == ["fairlead_tension", "anchor_tension", "offset"]
    rows = {row[0].text: [cell.value for cell in row[1:]] for row in table.rows}
    for k, each in enumerate(found):
        tail = each.tail
        assert tail is not None
        assert rows["90 % interval of it, from"][k] == tail.extreme.low
        assert rows["to"][k] == tail.extreme.high
        assert rows["Threshold of the tail"][k] == tail.threshold
        assert rows["Weibull shape"][k] == tail.shape
    assert not any("Gumbel" in key for key in rows)  # two runs
    told = points("exceedance", page)
    tail = found[0].tail
    assert tail is not None
    assert len(told) == len(tail.clusters)
    often = tail.extreme.duration / tail.time
    largest = QUANTITIES["tension"].format(tail.clusters[0], unit=True)
    assert told[0] == f"T = {largest}: {often:.3g} peaks in 3 h above or at it"
    harmonic = further_page("harmonic")
    assert not harmonic.all("motion_extremes")
    assert not any(e.attributes.get("data-figure") == "exceedance" for e in harmonic.elements)


def test_a_safety_factor_that_nobody_gave_is_not_said_to_be_the_case_files(tmp_path: Path) -> None:
    path = further_case(tmp_path, "random")
    text = path.read_text("utf-8").replace("[checks]\nsafety_factor = 2.0\n", "")
    assert "safety_factor" not in text
    path.write_text(text, encoding="utf-8")
    told = read_page(render_page(read_note(path, motion=True, verify=False))).sections["in_motion"]
    assert "the MBL over a safety factor of 1, and nothing more" in told
    assert "safety factor of the case file" not in told


def test_one_draw_of_the_sea_is_told_to_be_one(tmp_path: Path) -> None:
    path = further_case(tmp_path, "random")
    path.write_text(path.read_text("utf-8").replace("runs = 2", "runs = 1"), encoding="utf-8")
    page = read_page(render_page(read_note(path, motion=True, verify=False)))
    assert "this is a single draw of it" in page.sections["in_motion"]


def test_a_run_that_was_stopped_says_so() -> None:
    note = further_note("harmonic")
    found = moved("harmonic")
    (part,) = found.found.parts
    (run,) = part.runs
    short = replace(part, runs=(replace(run, history=replace(run.history, is_complete=False)),))
    stopped = replace(found, found=replace(found.found, parts=(short,), is_complete=False))
    page = read_page(render_page(replace(note, motion=stopped)))
    first, _ = page.styled("verdict", "in_motion")
    assert first.text.startswith("stopped in load case load, run 1 of 1")
    assert next(motion_warnings(stopped)).startswith("the line in motion is not complete")


def test_a_case_at_rest_says_what_it_lacks() -> None:
    with pytest.raises(InputError, match=r"write \[dynamics\] with a duration"):
        read_note(CASES / "buoy-9.5m" / "case.toml", motion=True)


def test_what_was_sought_is_put_in_its_place(tmp_path: Path) -> None:
    """The length that just lies down at the anchor, not the one in the file, is run."""
    path = tmp_path / "found.toml"
    path.write_text(
        HARMONIC + '[find]\nquantity = "length"\nsegment = 1\nanchor_angle = "0 deg"\n', "utf-8"
    )
    note = read_note(path, motion=True, verify=False)
    assert note.motion is not None
    arc, *_ = envelope(note.motion.found.parts[0])
    length = note.solution.line.length
    assert length < 119.0
    assert arc[-1] == pytest.approx(length * (1.0 - 0.5 / 20), rel=1e-12)  # the last bar's middle


@pytest.mark.parametrize("name", BOTH)
def test_vietnamese_lacks_nothing(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    missing = gathered(monkeypatch)
    note, words = further_note(name), Words("vi")
    assert motion(note, words) is not None
    warnings(note, words)
    assert untranslated(missing - {"chain", "wire"}) == []
    monkeypatch.undo()
    page = further_page(name, "vi")
    assert page.styled("verdict", "in_motion")[0].text.startswith("Lực căng lớn nhất")
    langs = {each.attributes.get("lang") for each in page.elements if each.section == "in_motion"}
    assert langs <= {None}


@pytest.mark.slow
def test_the_same_case_gives_the_same_bytes(tmp_path: Path) -> None:
    path = further_case(tmp_path, "random")
    first, second = (render_page(read_note(path, motion=True, verify=False)) for _ in range(2))
    assert first == second
    assert str(tmp_path).encode() not in first


# ------------------------------------------------------------------ the workbook


@pytest.mark.parametrize("name", BOTH)
def test_the_sheet_in_vietnamese(name: str) -> None:
    same = same_words(name, "Motion", "Chuyển động")
    of_the_user = {"storm", "low water", "load", "chain", "wire", "(11, 0), (11, 1)"}
    assert same <= {"kN", "m", "MBL"} | of_the_user


def found_below(sheet: Any, heading: str, column: int) -> list[Any]:
    """Read a column of numbers below a heading, down to the first empty cell."""
    top = next(
        cell.row
        for (cell,) in sheet.iter_rows(min_col=column, max_col=column)
        if cell.value == heading
    )
    values: list[Any] = []
    while (value := sheet.cell(top + 1 + len(values), column).value) is not None:
        values.append(value)
    return values


@pytest.mark.parametrize("name", BOTH)
def test_the_sheet(name: str) -> None:
    found = moved(name)
    part = found.found.parts[found.governing]
    book: Any = openpyxl.load_workbook(BytesIO(note_workbook(further_note(name))), data_only=True)
    sheet = book["Motion"]
    assert len(sheet._charts) == 2
    quantities = [
        [cell.value for cell in row[2:8]]
        for row in sheet.iter_rows(max_col=8)
        if row[0].value == "Fairlead tension"
    ]
    for values, each, solution in zip(quantities, found.found.parts, found.solutions, strict=True):
        told = each.of("fairlead_tension")
        wanted = (
            solution.fairlead.tension, told.mean, told.std, told.minimum, told.maximum,
            told.most_probable_maximum,
        )  # fmt: skip
        for value, si in zip(values, wanted, strict=True):
            assert (value is None) == (si is None)
            assert si is None or math.isclose(value, si / 1e3, rel_tol=ROUNDING)
    found_extremes = [
        [cell.value for cell in row[1:4]]
        for row in sheet.iter_rows(max_col=4)
        if row[0].value == "90 % interval of it, from"
    ]
    tails = [each.tail for each in part.quantities if each.tail is not None]
    assert len(found_extremes) == (1 if tails else 0)
    for row in found_extremes:
        for value, tail, size in zip(row, tails, (1e3, 1e3, 1.0), strict=True):
            assert math.isclose(value, tail.extreme.low / size, rel_tol=ROUNDING)
    arc, high, _ = envelope(part)
    assert found_below(sheet, "Arc length s (m)", 5) == pytest.approx(arc, rel=ROUNDING)
    tensions = found_below(sheet, "largest in motion (kN)", 6)
    assert tensions == pytest.approx([value / 1e3 for value in high], rel=ROUNDING)
    series = found_below(sheet, "Fairlead tension (kN)", 2)
    assert math.isclose(max(series), part.of("fairlead_tension").maximum / 1e3, rel_tol=ROUNDING)
