"""Every command in both languages: every text is there and fits, and the numbers are the same."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt import catalogue, read_case, verify_case
from catopt.catenary.line_problem import LineProblem
from catopt.catenary.pieces import cut
from catopt.catenary.refusal import refusal
from catopt.catenary.state import NOT_CONVERGED, TOO_HEAVY, TOO_SHORT
from catopt.catenary.surface import check_buoys, named_line
from catopt.errors import CatoptError, FloatsUpError
from catopt.fem.plausible_step import record_warnings, step_warnings
from catopt.loads.blendermann import TYPES
from catopt.loads.holding_data import SOILS
from catopt.loads.ship import PROPELLER_AREA_RATIOS
from catopt.loads.sinker import SOIL_FRICTION
from catopt.model import Line, Load, PointLoad, Segment, System
from catopt.mooring.balance import Pull
from catopt.mooring.descent import TURNS_OVER, Rest
from catopt.mooring.line_out import one_line_out
from catopt.mooring.refusal import refusal as refusal_of_a_body
from catopt.mooring.refusal import turns_over
from catopt.mooring.sharing_rule import sharing_rule
from catopt.verify.compared import Compared, Unit
from catopt.verify.truss_words import part_sentence, rough_sentence
from catopt.waves import Sea, jonswap, random_waves
from catopt.words import Message, is_term, say, term

from .cases import CASE_TEXTS, FILES
from .conftest import BUOY, CASES, SLACK, Run
from .test_catalog import QUESTIONS
from .vietnamese import numbers, said_alike

DESIGN = CASES / "design-buoy-9.5m" / "case.toml"
TANKER = CASES / "tanker-20m-sinker" / "case.toml"
SOUGHT = CASES / "tanker-20m-find-length" / "case.toml"
FSO = CASES / "fso-rang-dong" / "case.toml"
FAMILIES = [family.name for family in catalogue.families()]
SEA = ("--wind", "25 m/s", "--current", "1 m/s", "--hs", "7 m", "--period", "12 s")
SHIP = (
    *("--length", "234 m", "--breadth", "31.3 m", "--draught", "12.4 m"),
    *("--frontal-area", "580 m^2", "--lateral-area", "1200 m^2", "--depth", "14 m"),
)
SMALL = (
    *("size", "tanker", "--length", "120 m", "--breadth", "18 m", "--draught", "7 m"),
    *("--depth", "22 m"),
)
EVERYTHING = (
    "--line-out", "--watch-circle", "--curve", "180 deg", "--curve", "1.0", "--level", "-2 m",
    "--level", "2",
)  # fmt: skip

COMMANDS: list[Sequence[object]] = [
    ["solve", BUOY, "--profile"],
    ["solve", BUOY, "--method", "pso", "--runs", "2", "--iterations", "50"],
    ["solve", SLACK],
    ["solve", SOUGHT],
    ["solve", TANKER],
    ["check", TANKER],
    ["check", DESIGN],
    ["design", DESIGN],
    *(["catalog", *question] for question in QUESTIONS),
    ["catalog", "show", "chain stud-link U2", "--diameter", "60 mm"],
    ["catalog", "search", "--mbl", "500 kN", "--recalled"],
    *(["catalog", "show", name] for name in FAMILIES if name != "chain stud-link"),
    ["curve", SOUGHT, "--over", "offset"],
    ["curve", BUOY, "--to", "1 kN", "--points", "4"],
    ["curve", SLACK, "--over", "offset"],
    ["curve", CASES / "ship-200m-sinker" / "case.toml"],
    ["curve", DESIGN],
    ["curve", "chain-and-wire.toml"],
    ["curve", "buoyed.toml", "--to", "400 kN"],
    ["curve", "bights.toml"],
    [
        *("loads", "buoy", "pillar 1.8 m", "--depth", "12 m", *SEA),
        *("--chain", "25 mm", "--growth", "20 mm", "--pull", "3 kN"),
    ],
    ["loads", "ship", *SHIP, *SEA, "--propeller", "tanker"],
    [
        *("loads", "ship", *SHIP, *SEA, "--current", "2 m/s", "--kind", "tanker ballast"),
        *("--drift", "largest-wave", "--wind-angle", "30 deg", "--current-angle", "45 deg"),
    ],
    ["loads", "ship", "known-ship.toml"],
    *(["system", case, *EVERYTHING] for case in (FSO, *(f"{name}.toml" for name in CASE_TEXTS))),
    [
        *("size", "buoy", "--depth", "12 m", "--low-water", "10 m", "--force", "8 kN"),
        *("--reserve-buoyancy", "25 kN", "--hs", "1.5 m", "--period", "6 s", "--life", "3 years"),
        *("--wear", "0.2 mm/year", "--soil", "gravel or coarse sand", "--prefer", "lightest"),
        *("--chain", "chain open-link 4D Q2", "--code", "IALA-CALMAR"),
    ],
    ["size", "buoy", "pillar 1.8 m", "--depth", "12 m"],
    [*SMALL, "--ballast-draught", "4 m", "--dwt", "9000 t"],
    [*SMALL, "--low-water", "7.5 m", "--anchor", "stockless", "--soil", "soft clay"],
    [*SMALL, "--anchor", "sinker", "--clump-weight", "5 t", "--clump-weight", "10 t"],
    [*SMALL, "--buoy", "mooring buoy 5.0 m", "--lines", "4", "--low-water", "20 m"],
    ["verify", DESIGN, "--elements", "40"],
    ["verify", FSO, "--elements", "60"],
    ["verify", SLACK],
    ["verify", "twice.toml", "--elements", "40", "--tolerance", "1e-9"],
    ["verify", "tension-known.toml"],
    ["verify", "bights.toml"],
    ["verify", "at-sea.toml", "--dynamic"],
    ["verify", "moving.toml", "--dynamic"],
    ["verify", "raos.toml", "--dynamic"],
    ["verify", "twice-in-motion.toml", "--dynamic", "--elements", "40"],
    ["verify", "slack-in-motion.toml", "--dynamic"],
    ["verify", "led.toml", "--dynamic", "--elements", "40", "--once"],
    ["verify", "pushed.toml", "--dynamic", "--elements", "40"],
    ["reproduce", "load_sharing"],
]


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Work where the cases are, on a terminal of 80 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    # Figures are drawn from the English in every language and take most of the time.
    monkeypatch.setattr("catopt.render.picture.pictures", lambda *_, **__: {})


def written(command: Sequence[object]) -> None:
    """Write the files that a command names, and those that they name."""
    if any(str(each) in FILES for each in command):
        for name, text in FILES.items():
            Path(name).write_text(text, encoding="utf-8")


def first_of_each() -> Iterator[Any]:
    """Yield them all, with all but the first of each command among the slow ones."""
    seen = set()
    for command in COMMANDS:
        marks = [pytest.mark.slow] if command[0] in seen else []
        seen.add(command[0])
        yield pytest.param(command, marks=marks, id=" ".join(map(str, command)))


@pytest.mark.slow
@pytest.mark.parametrize("command", list(first_of_each()))
def test_languages_differ_in_words_alone(
    run: Run, command: Sequence[object], tmp_path: Path
) -> None:
    written(command)
    english, said = (run(*command, "--lang", each, "--out", each) for each in ("en", "vi"))
    # Two of the lines that go slack in motion do not converge, which is an answer.
    assert english.status == said.status == (4 if "NOT CONVERGED" in english.out else 0), said.err
    assert "…" not in said.out
    assert max(map(len, said.out.splitlines())) <= 80
    if command[0] in {"curve", "verify"}:
        assert said_alike(english.out, said.out) <= {english.out.splitlines()[0]}
    files = {path.name: path.read_bytes() for path in (tmp_path / "en").iterdir()}
    assert files.keys() == {path.name for path in (tmp_path / "vi").iterdir()}
    for name, content in files.items():
        other = (tmp_path / "vi" / name).read_bytes()
        if name.endswith(".xlsx"):
            assert content != other
            assert numbers(content) == numbers(other) != []
        elif name != "note.html":
            assert content == other


SAID: list[tuple[Sequence[object], tuple[str, ...]]] = [
    (
        ["solve", BUOY],
        (
            "Giải bằng nghiệm giải tích; toàn bộ dây treo, không chạm đáy.",
            "Góc nghiêng dây neo tại đáy theta0 15.57 deg",
            "Độ dạt ngang S 17.430 m",
            "Lực căng tại điểm treo T 4.377 kN 0.4463 tf",
        ),
    ),
    (["check", TANKER], ("Kiểm tra duy nhất đạt.",)),
    (
        ["catalog", "show", "nylon", "--diameter", "60 mm"],
        (
            "Cáp nylon: nylon 60 mm",
            "Lực kéo đứt tối thiểu MBL 794.9 kN C MP",
            "585 d^2 kg/m, d tính bằng m; 20 mm đến 200 mm. C, MP: nylon.mass_d2",
            "Lực cản dọc dây: chưa biết; danh mục không có số liệu.",
            "MP: NREL MoorPy, fits to makers' catalogues.",
        ),
    ),
    (
        ["curve", SOUGHT, "--over", "offset"],
        (
            "50 điểm cách đều theo độ dạt so với trạng thái gốc.",
            "từ 1 % đến 105 % của 1334.544 kN, lực ngang khi một đoạn đạt lực kéo đứt / 5.",
            "Chiều dài tìm được của đoạn 1: 47.208 m, với điều kiện góc nghiêng dây neo tại đáy",
            "khối gia tải 1 bắt đầu nhấc (sinker)",
            "nằm một phần trên đáy → treo hoàn toàn 0.000 450.000 540.354",
        ),
    ),
    (
        ["loads", "buoy", "pillar 1.8 m", "--depth", "12 m", *SEA, "--chain", "25 mm"],
        (
            "pillar 1.8 m, gió 25 m/s, dòng triều 1 m/s, Hmax 13 m",
            "dòng chảy lên xích: 1/2 rho V^2 A Cd",
            "IALA CALMAR technical reference, 27 February 2014, 5.2.1 [A]",
            "Cảnh báo: Sóng lớn nhất 12.95 m vỡ ở độ sâu 12 m với chu kỳ 12 s",
        ),
    ),
    (
        ["system", FSO, *EVERYTHING],
        (
            "Giải bằng nghiệm giải tích; 9 dây, vật nổi tự do theo x và y.",
            "Độ dạt theo phương x -21.738 m",
            "Lực 4281.000 kN tác dụng theo mọi hướng",
            "Giữ tại các độ dạt theo hướng 180.00 deg",
            "cần số dây chẵn, từ 4 trở lên; hệ này có 9 dây",
        ),
    ),
    (
        ["size", "buoy", "pillar 1.8 m", "--depth", "12 m"],
        (
            "Neo pillar 1.8 m ở độ sâu nước 12 m",
            "chain open-link 4D Q2 20 mm, 87 m = 3.16 đường lỉn",
            "Rùa neo rùa neo bê tông 15 t (cần 14 t)",
            "xích: 86 m thay cho 87 m: không đạt về góc nghiêng dây neo tại đáy (bão",
            "Lấy theo mặc định vì không cho trước: gió 25 m/s;",
        ),
    ),
    (["verify", "bights.toml"], ("Lưu ý: dây chùng: mô hình dàn chỉ xác định dây đến một thanh",)),
    (
        ["verify", "at-sea.toml", "--dynamic"],
        (
            "Trường hợp tải trọng storm: dây chuyển động",
            "2 lần chạy, mỗi lần 24 s",
            "Quá ít đỉnh để tính cực đại khả dĩ nhất của lực căng tại điểm treo.",
            "Lưu ý: lực căng tựa tĩnh không kể dòng chảy.",
        ),
    ),
]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "parts"), [pytest.param(*each, id=str(each[0][0])) for each in SAID]
)
def test_the_answer_in_vietnamese_and_the_document_in_english(
    run: Run, command: Sequence[object], parts: tuple[str, ...]
) -> None:
    written(command)
    shown = " ".join(run(*command, "--lang", "vi").out.split())
    for part in parts:
        assert part in shown
    if "--dynamic" not in command:
        assert run(*command, "--json", "--lang", "vi").out == run(*command, "--json").out


def test_another_language_is_refused(run: Run) -> None:
    ran = run("solve", BUOY, "--lang", "fr")
    assert ran.status == 2
    assert "'fr' is not one of" in ran.err


def test_what_is_not_there_is_said_in_vietnamese(run: Run) -> None:
    written(["no force.toml"])
    ran = run("system", "no force.toml", "--watch-circle", "--lang", "vi")
    assert "không có vòng dịch chuyển" in ran.err


# ------------------------------------------------------------------ what data files say


@pytest.mark.parametrize("name", FAMILIES)
def test_all_that_the_data_say_of_a_family_is_said(name: str) -> None:
    """Its title and notes, and formula, reason and note of every figure, recalled ones included."""
    family = catalogue.standard().family(name)
    told = [family.title, family.note]
    told += [text for figure in family.figures for text in (figure.reason, figure.note)]
    assert [text for text in told if text and say(text, "vi") == text] == []
    formulas = [say(figure.text, "vi") for figure in family.figures]
    english = re.compile(r"d in mm?|both legs|table of|times|volume-equivalent|tension")
    assert [text for text in formulas if english.search(text)] == []


def test_what_is_cited_is_in_no_table() -> None:
    """Titles of documents and places in them; what is reckoned or recalled is in no document."""
    standard = catalogue.standard()
    figures = [figure for family in standard.families for figure in family.figures]
    cited = {figure.place for figure in figures if figure.confidence != "R"}
    cited |= {s.title for figure in figures for s in figure.sources if s.key != "RECALLED"}
    assert cited
    assert not [text for text in cited if is_term(text) or isinstance(text, Message)]


@pytest.mark.parametrize(
    "name", sorted({*TYPES, *PROPELLER_AREA_RATIOS, *SOIL_FRICTION, *SOILS, "sea state"})
)
def test_kinds_of_ship_and_soil_have_their_vietnamese(name: str) -> None:
    assert is_term(name)
    assert say(term(name), "vi") != name


# ------------------------------------------------------------------ sentences of no answer above


def refusals() -> Iterator[str]:
    """Make every message for a line that cannot hang as asked."""
    plain_line = Line([Segment(100.0, 1000.0)])
    buoyed = Line([Segment(100.0, 1000.0)], [PointLoad(50.0, -9e4, name="float")])
    floating = Line([Segment(100.0, 1000.0), Segment(50.0, -500.0, name="rope")])
    for line in (plain_line, buoyed, floating):
        setting = LineProblem(cut(line)[0], 0.0, 120.0, 0.5)
        for load in (Load(span=80.0), Load(fairlead_tension=100.0)):
            yield refusal(TOO_SHORT, line, load, setting).message
    level = LineProblem(cut(plain_line)[0], 0.0, 60.0, 0.5)
    straight_up = LineProblem(cut(plain_line)[0], 0.0, 100.0, 0.5)
    yield refusal(TOO_SHORT, plain_line, Load(span=80.0), level).message  # 60, 80, 100: as long
    yield refusal(TOO_SHORT, plain_line, Load(fairlead_tension=1.0), straight_up).message
    yield refusal(TOO_HEAVY, plain_line, Load(fairlead_tension=100.0), level).message
    yield refusal(NOT_CONVERGED, plain_line, Load(span=80.0), level).message
    for name in ("", "float"):
        high = Line([Segment(100.0, 1000.0)], [PointLoad(50.0, -9e4, name=name)])
        with pytest.raises(CatoptError) as afloat, named_line(2):
            check_buoys(high, [25.0], 20.0)
        assert isinstance(afloat.value, FloatsUpError)
        yield afloat.value.message


def ring(
    azimuths: list[float], force: float = 2e5, EA: float = 8e8, length: float = 600.0
) -> System:
    """Lines around a body, azimuths in degrees."""
    return System.around(
        Line([Segment(length, 1000.0, EA=EA)]),
        azimuths=[math.radians(azimuth) for azimuth in azimuths],
        anchor_radius=570.0,
        fairlead_radius=10.0,
        fairlead_height=50.0,
        force=(force, 0.0),
    )


def of_bodies() -> Iterator[str]:
    """Make every reason against the rule of practice, and what a line that is gone leaves."""
    even = ring([0.0, 90.0, 180.0, 270.0])
    for system in (
        ring([0.0, 120.0, 240.0]),
        replace(even, legs=(*even.legs[:3], ring([270.0], length=610.0).legs[0])),
        ring([0.0, 80.0, 180.0, 270.0]),
        ring([0.0, 90.0, 180.0, 270.0], force=0.0),
        ring([45.0, 135.0, 225.0, 315.0]),
    ):
        yield sharing_rule(system).why_not
    pull = Pull(0, -1, *([0.0] * (len(Pull._fields) - 2)))
    rest = Rest(TOO_SHORT, 1, 30.0, 0.0, 0.0, 3, 1.0, 0.0, pull)
    yield refusal_of_a_body(rest, ring([0.0, 180.0], EA=math.inf, length=563.0)).args[0]
    yield turns_over(9e8, Rest(TURNS_OVER, -1, 30.0, 0.0, 0.0, 3, 1.0, 8e8, pull)).args[0]
    yield from (each.refusal for each in one_line_out(ring([180.0])))


UNITS: list[tuple[Unit, str]] = [
    ("N", "fairlead_tension"), ("m", "span"), ("m", "position_x"), ("rad", "anchor_angle"),
    ("Nm", "moment_of_lines"),
]  # fmt: skip


def of_models() -> Iterator[str]:
    """Say every verdict: near and far, settled and not, of a slack line and not."""
    plain = verify_case(read_case(BUOY), elements=40).static
    for (unit, quantity), closed_form in product(UNITS, (1.0, 1.0001, 2.0)):
        for theory, finest in product((1.0, 2.0), (1.0, 1.1)):
            fem = (1.0, 1.0, finest)
            each = Compared(quantity, unit, closed_form, fem, 1.0, 1e-3, line=1, theory=theory)
            part = replace(plain, quantities=(each,))
            yield from filter(None, (part_sentence(part), rough_sentence(part)))
    for count in range(1, 7):
        others = plain.quantities[count:]
        rough = [replace(q, fem=(1.0, 2.0, 1.0), scale=1.0) for q in plain.quantities[:count]]
        yield rough_sentence(replace(plain, quantities=(*rough, *others)))
        off = [replace(q, closed_form=9.0 * (q.scale + 1.0)) for q in plain.quantities[:count]]
        yield part_sentence(replace(plain, quantities=(*off, *others)))


def of_runs() -> Iterator[str]:
    """Warn of waves that break and nearly repeat themselves, and of a step that is rather long."""
    sea = Sea(8.0, random_waves(jonswap(7.0, 9.0), 12, np.random.default_rng(1)))
    yield from step_warnings(0.5, 600.0, {"the motion or force": 8.0}, sea)
    yield from record_warnings(0.2, 0.1)
    yield Message("motion.sets_off", speed=1.57, jump=380.0)


@pytest.mark.parametrize(
    ("sentences", "least"), [(refusals, 9), (of_bodies, 8), (of_models, 9), (of_runs, 4)]
)
def test_sentences_hold_nothing_english(sentences: Any, least: int) -> None:
    """What a message holds is said with it: joined to a plain text it would stay English."""
    told = set(sentences())
    assert len(told) >= least
    english = re.compile(r" (the|is|of|by|Give|change|allowed|tension|span|inclination|more) ")
    for each in told:
        assert isinstance(each, Message)
        assert not english.search(say(each, "vi"))
