"""Truss model and motion in notes: what must not be hidden, and what must be known."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from functools import cache
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import openpyxl
import pandas as pd
import pytest

from catopt.__main__ import main
from catopt.casefile import read_case
from catopt.errors import NotConvergedError
from catopt.figures.chart import legend
from catopt.figures.motion import around_the_largest, envelope, history
from catopt.model import Case
from catopt.notes.directory import Asked
from catopt.notes.line import Note, note_of, read_note
from catopt.notes.motion import InMotion, motion_warnings
from catopt.notes.system import SystemNote, read_system_note
from catopt.quantities import QUANTITIES
from catopt.verify import case as verify_module
from catopt.verify.case import verify_case
from catopt.verify.compared import Compared
from catopt.verify.result import StaticComparison
from catopt.verify.truss_words import part_sentence, rough_sentence
from catopt.words import LANGUAGES, Language, Message, say, term
from tests.cli.cases import FORCE, LED, PUSHED, SHIP
from tests.cli.test_json import validate
from tests.verify.cases import TOUCHES_TWICE

from .further_cases import HARMONIC, further_case, further_note, further_page
from .page_cases import CASES, EVERY, case_path, known_note, known_page
from .page_reader import ReadPage, read_page
from .rendered import page_of, workbook_of

BOTH = ("harmonic", "random")


ROUNDING = 1e-10


def document_of(name: str, folder: Path) -> dict[str, Any]:
    """Verify a case as ``catopt verify`` does, in the load case that its note draws."""
    case = read_case(case_path(folder, name))
    document = verify_case(case, load_case=known_note(name).load_case or None).to_dict()
    (part,) = document["load_cases"]
    return dict(part)


@pytest.mark.parametrize("name", EVERY)
def test_numbers_are_those_of_verify_s_document(name: str, tmp_path: Path) -> None:
    document, page = document_of(name, tmp_path), known_page(name)
    rows = page.table("verification").rows
    assert len(rows) == len(document["quantities"])
    for row, each in zip(rows, document["quantities"], strict=True):
        _, closed, truss, before, gap, order, verdict = row
        assert (closed.value, truss.value) == (each["closed_form"], each["extrapolated"])
        over_scale = abs(each["difference"]) / each["scale"]
        assert gap.value == (over_scale if over_scale >= ROUNDING else None)
        assert (gap.text == "<1e-10") == (over_scale < ROUNDING)
        first = abs(each["fem"][-1] - each["closed_form"]) / each["scale"]
        assert before.value == (first if first >= ROUNDING else None)
        assert order.text == ("-" if each["order"] is None else f"{each['order']:.2f}")
        assert verdict.text == ("agrees" if each["agrees"] else "DIFFERS")
    meshes = page.table("meshes").rows
    assert [[row[0].value, row[1].value] for row in meshes] == [
        [mesh["elements"], mesh["residual"]] for mesh in document["meshes"]
    ]
    for number, row in enumerate(meshes):
        largest = max(
            abs(each["fem"][number] - each["closed_form"]) / each["scale"]
            for each in document["quantities"]
        )
        assert row[2].value == (largest if largest >= ROUNDING else None)


def test_what_verify_remarks_is_told(tmp_path: Path) -> None:
    (remark,) = document_of("slack", tmp_path)["remarks"]
    assert remark in known_page("slack").sections["verification"]


def test_the_load_case_that_is_drawn_is_verified() -> None:
    verification = known_note("states").verification
    assert verification is not None
    assert [part.name for part in verification.parts] == ["storm (high water)"]


def seen(note: Note, language: Language = "en") -> tuple[ReadPage, str]:
    """Return the page of a note, and all that its workbook says."""
    book = openpyxl.load_workbook(BytesIO(workbook_of(note, language)))
    cells = (cell.value for sheet in book for row in sheet.iter_rows() for cell in row)
    return read_page(page_of(note, language)), " ".join(str(each) for each in cells if each)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_truss_that_does_not_converge_stands_in_place_of_the_table(
    monkeypatch: pytest.MonkeyPatch, language: Language
) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("Newton's method stopped after 500 iterations")

    monkeypatch.setattr(verify_module, "verify_case", stops)
    note = read_note(CASES / "buoy-9.5m" / "case.toml")
    page, sheet = seen(note, language)
    (loud,) = page.styled("fails", "verification")
    assert loud.text == say(Message("note.verification_no_answer"), language)
    assert page.all("verification") == page.all("meshes") == []
    for said in (page.sections["verification"], page.sections["warnings"], sheet):
        assert "Newton's method stopped after 500 iterations" in said
    assert loud.text in sheet


def off(part: StaticComparison, *quantities: str) -> StaticComparison:
    """Return a comparison whose closed form is off by 1 % in some quantities."""
    return replace(part, quantities=tuple(_off(q, quantities) for q in part.quantities))


def _off(each: Compared, wrong: tuple[str, ...]) -> Compared:
    if each.quantity not in wrong:
        return each
    return replace(each, closed_form=(each.closed_form or 0.0) + 0.01 * each.scale)


@pytest.mark.parametrize("language", LANGUAGES)
def test_models_that_differ_are_told_loudly(
    monkeypatch: pytest.MonkeyPatch, language: Language
) -> None:
    honest = verify_case(read_case(CASES / "buoy-9.5m" / "case.toml"))
    found = replace(honest, parts=(off(honest.static, "span", "fairlead_angle"),))
    monkeypatch.setattr(verify_module, "verify_case", lambda _: found)
    page, sheet = seen(read_note(CASES / "buoy-9.5m" / "case.toml"), language)
    differs = say(term("DIFFERS"), language)
    sentence = say(part_sentence(found.static), language)
    assert sentence in page.sections["verification"]
    assert sentence in sheet
    verdicts = [row[-1].text for row in page.table("verification").rows]
    assert verdicts.count(differs) == 2
    assert [each.tag for each in page.styled("fails", "verification")] == ["p", "td", "td"]
    assert say(Message("notes.models_differ"), language) in page.sections["warnings"]


def test_a_quantity_that_is_not_smooth_is_named() -> None:
    note = known_note("buoy-9.5m")
    assert note.verification is not None
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
    note = note_of(case, known_note("buoy-9.5m").origin.files)
    assert note.solution.regime == "grounded-in-parts"
    page, _ = seen(note)
    verdicts = {row[-1].text for row in page.table("verification").rows}
    assert verdicts == {"agrees"}


def test_of_a_slack_line_the_difference_is_not_said_to_be_of_the_tension() -> None:
    """Its scale is a bar's weight over the tolerance, far above the tension."""
    note = known_note("slack")
    assert note.verification is not None
    part = note.verification.static
    assert part.worst.scale > 10.0 * note.solution.fairlead.tension
    english = part_sentence(part)
    assert "of its scale" in english
    assert "of the tension" not in english
    assert "thang so sánh" in say(english, "vi")


# ------------------------------------------------------------------ in motion


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


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
def test_more_than_is_allowed_is_told_at_the_top(tmp_path: Path) -> None:
    path = tmp_path / "weak.toml"
    path.write_text(HARMONIC.replace('"3000 kN"', '"1100 kN"'), encoding="utf-8")
    note = read_note(path, motion=True, verify=False)
    assert note.checks.passes, "at rest it passes"
    page = read_page(page_of(note))
    assert "segment 1 carries" in page.sections["warnings"]
    (verdict,) = page.styled("verdict", "in_motion")
    assert "fails" in verdict.attributes["class"]
    assert "MORE THAN IS ALLOWED" in verdict.text
    assert page.table("motion_use").rows[0][6].text == "FAILS"


def test_the_code_whose_factors_judge_a_tension_in_motion_is_named(tmp_path: Path) -> None:
    """API 1.67 on the tension."""
    path = tmp_path / "coded.toml"
    path.write_text(HARMONIC.replace("safety_factor = 3.0", 'codes = ["API-RP-2SK"]'), "utf-8")
    note = read_note(path, motion=True, verify=False)
    assert note.motion is not None
    ((use,),) = note.motion.uses
    assert use.utilisation == pytest.approx(1.67 * use.largest / 3000e3, rel=1e-12)
    told = read_page(page_of(note)).sections["in_motion"]
    assert "factors for dynamic analysis of API-RP-2SK" in told


def test_slack_is_told_at_the_top() -> None:
    found = moved("harmonic")
    (part,) = found.found.parts
    (run,) = part.runs
    history = replace(run.history, slack_time=np.full(20, 1.5))
    slack = replace(part, runs=(replace(run, history=history),))
    changed = replace(found, found=replace(found.found, parts=(slack,)))
    (said,) = motion_warnings(changed)
    assert said == "in motion: the line goes slack, a bar for 1.50 s of a run in all"


@pytest.mark.slow
def test_what_drives_it_with_its_figures() -> None:
    page = further_page("random")
    drive = {row[0].text: row[1] for row in page.table("motion_drive").rows}
    assert drive["Significant wave height Hs"].value == 2.0
    assert drive["Peak period Tp"].value == 7.0
    assert drive["Waves travel to (from the axis anchor to fairlead)"].value == math.pi
    assert drive["Seeds of the runs"].text == "(11, 0), (11, 1)"
    # S4's rule: x = Tp/sqrt(Hs) = 4.95, and gamma = exp(5.75 - 1.15 x) between 3.6 and 5.
    gamma = drive["Peak enhancement γ, by the rule on Tp/√Hs"]
    assert gamma.value == pytest.approx(math.exp(5.75 - 1.15 * 7.0 / math.sqrt(2.0)), rel=1e-12)
    assert drive["Speeds by depth"].text == "1 m/s at 0 m; 0.2 m/s at 20 m"
    assert "rao.csv" in drive["Motion of the fairlead"].text
    raos = page.table("motion_raos")
    assert [[cell.text for cell in row] for row in raos.rows] == [
        ["3", "0", "-", "0.02", "40"],  # where nothing moves there is no lag
        ["8", "0.3", "90", "0.6", "10"],
        ["20", "0.9", "90", "1", "0"],
    ]  # fmt: skip
    harmonic = {row[0].text: row[1] for row in further_page("harmonic").table("motion_drive").rows}
    assert harmonic["Surge: amplitude"].value == 0.5
    assert harmonic["Heave: phase"].text == "90 deg"


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
            "Current flows to (from the axis anchor to fairlead)": "45 deg",
        }),
        (RECORDED, {
            "Waves": "random, Pierson-Moskowitz spectrum", "Exponent": "0.2",
            "Motion of the fairlead": "as recorded in record.csv",
            "Length of the record": "40 s", "Recorded surge": "-0.3 to 0.3 m",
        }),
    ],
    ids=["regular", "recorded"],
)  # fmt: skip
def test_every_way_of_driving_it_is_told(tmp_path: Path, driven: str, told: dict[str, str]) -> None:
    swings = (0.0, 0.3, 0.0, -0.3)
    rows = [f"{t},{swings[t // 2 % 4]}" for t in range(0, 41, 2)]
    (tmp_path / "record.csv").write_text("\n".join(["t,x", *rows]), encoding="utf-8")
    path = tmp_path / "driven.toml"
    path.write_text(HARMONIC.replace(HARMONIC_MOTION, driven), encoding="utf-8")
    note = read_note(path, motion=True, verify=False)
    page = read_page(page_of(note))
    drive = {row[0].text: row[1].text for row in page.table("motion_drive").rows}
    assert drive | told == drive


@pytest.mark.slow
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
    assert model["Bars of the line"] == 12
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


@pytest.mark.slow
def test_a_safety_factor_that_nobody_gave_is_not_said_to_be_the_case_files(tmp_path: Path) -> None:
    path = further_case(tmp_path, "random")
    text = path.read_text("utf-8").replace("[checks]\nsafety_factor = 2.0\n", "")
    assert "safety_factor" not in text
    path.write_text(text, encoding="utf-8")
    told = read_page(page_of(read_note(path, motion=True, verify=False))).sections["in_motion"]
    assert "the MBL over a safety factor of 1, and nothing more" in told
    assert "safety factor of the case file" not in told


@pytest.mark.slow
def test_one_draw_of_the_sea_is_told_to_be_one(tmp_path: Path) -> None:
    path = further_case(tmp_path, "random")
    path.write_text(path.read_text("utf-8").replace("runs = 2", "runs = 1"), encoding="utf-8")
    page = read_page(page_of(read_note(path, motion=True, verify=False)))
    assert "this is a single draw of it" in page.sections["in_motion"]


def test_a_run_that_was_stopped_says_so() -> None:
    note = further_note("harmonic")
    found = moved("harmonic")
    (part,) = found.found.parts
    (run,) = part.runs
    short = replace(part, runs=(replace(run, history=replace(run.history, is_complete=False)),))
    stopped = replace(found, found=replace(found.found, parts=(short,), is_complete=False))
    page = read_page(page_of(replace(note, motion=stopped)))
    first, _ = page.styled("verdict", "in_motion")
    assert first.text.startswith("stopped in load case load, run 1 of 1")
    assert next(motion_warnings(stopped)).startswith("the line in motion is not complete")


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


# ------------------------------------------------------------------ a body in motion


FILES = {"led.toml": LED, "ship.csv": SHIP, "pushed.toml": PUSHED, "force.csv": FORCE}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    return written(tmp_path, monkeypatch)


def written(folder: Path, monkeypatch: pytest.MonkeyPatch | None = None) -> Path:
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
    if monkeypatch is not None:
        monkeypatch.chdir(folder)
    return folder


@cache
def body_note(name: str) -> SystemNote:
    with TemporaryDirectory() as place:
        path = written(Path(place)) / f"{name}.toml"
        return read_system_note(path, asked=Asked(verify=False, motion=True))


@pytest.mark.parametrize("name", ["led", "pushed"])
def test_every_line_has_its_row_and_the_governing_one_is_marked(name: str) -> None:
    note = body_note(name)
    assert note.motion is not None
    page = read_page(page_of(note))
    assert page.unclosed == []
    rows = page.table("system_motion_lines").rows
    assert len(rows) == 3
    for row, part in zip(rows, note.motion.parts, strict=True):
        each = part.of("fairlead_tension")
        assert row[5].value == each.maximum
        assert row[1].value == note.solution.lines[(part.line or 0) - 1].tension
    assert len(page.table("system_motion_body").rows) == 3
    names = [file.name for file in note.origin.files]
    assert names[-1] == {"led": "ship.csv", "pushed": "force.csv"}[name]


def run(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str, str]:
    status = main([str(each) for each in arguments])
    said = capsys.readouterr()
    return status, said.out, said.err


@pytest.mark.slow
def test_the_document_and_the_note_of_a_result_directory(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    options = ("--dynamic", "--once", "--elements", "40", "--out", "out")
    assert run(capsys, "verify", folder / "led.toml", *options)[0] == 0
    table = pd.read_csv(folder / "out" / "dynamic_statistics.csv")
    assert list(table["Line"]) == [k for k in (1, 2, 3) for _ in range(4)]
    verified = json.loads((folder / "out" / "verify.json").read_text("utf-8"))
    validate(verified)
    way = pd.read_csv(folder / "out" / "dynamic_body.csv")
    assert way["Body x (m)"].max() == verified["dynamic"]["body"][0]["max"]
    figures = [path.name for path in (folder / "out").glob("dynamic*.png")]
    assert figures == ["dynamic.png"]
    status, out, err = run(capsys, "report", "out", "--no-verify", "--out", "note", "--json")
    assert status == 0, err
    document = json.loads(out)
    validate(document)
    assert "system_motion" in document["sections"]
    assert document["motion"]["line"] == 1
    assert any("NOT PROVEN" in warning for warning in document["warnings"])


def test_a_body_without_dynamics_is_told_what_is_missing(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    text = LED[: LED.index("[waves]")]
    (folder / "still.toml").write_text(text, encoding="utf-8")
    status, out, err = run(capsys, "report", "still.toml", "--dynamic", "--no-verify")
    assert (status, out) == (2, "")
    assert "write [dynamics] with a duration" in " ".join(err.split())
