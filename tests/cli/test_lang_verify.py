"""``catopt verify --lang vi``: at rest, over a front and in motion; and its messages."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from io import BytesIO
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest

from catopt import read_case, verify_case
from catopt.answers.verification import verification_answer
from catopt.catenary.line_problem import LineProblem
from catopt.catenary.pieces import cut
from catopt.catenary.refusal import refusal
from catopt.catenary.state import NOT_CONVERGED, TOO_HEAVY, TOO_SHORT
from catopt.catenary.surface import check_buoys, named_line
from catopt.cli.output import Output
from catopt.errors import CatoptError, FloatsUpError, NotConvergedError
from catopt.fem.plausible_step import record_warnings, step_warnings
from catopt.fem.settle import Controls
from catopt.fem.solve import solve_line
from catopt.model import Case, Line, Load, PointLoad, Segment, System
from catopt.render.terminal import show
from catopt.render.workbook import workbook
from catopt.verify.compared import Compared, Unit
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.result import StaticComparison, Verification
from catopt.verify.truss_words import part_sentence, rough_sentence
from catopt.waves import Sea, jonswap, random_waves
from catopt.words import Message, Several, say

from .conftest import BUOY, CASES, CHAIN_IN_MOTION, SLACK, Run
from .vietnamese import in_vietnamese, numbers, said_alike

DESIGN = CASES / "design-buoy-9.5m" / "case.toml"
FSO = CASES / "fso-rang-dong" / "case.toml"
TWICE = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "300 m"
submerged_weight = "1000 N/m"
EA = "500 MN"
[[line.point_loads]]
name = "float"
position = "150 m"
submerged_weight = "-50 kN"
[load]
horizontal_force = "20 kN"
"""

BIGHTS = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "80 m"
submerged_weight = "1000 N/m"
[load]
span = "10 m"
"""

TENSION_KNOWN = BIGHTS.replace('span = "10 m"', 'fairlead_tension = "80 kN"')

AT_SEA = (
    CHAIN_IN_MOTION.replace("[load]\n", '[[load_cases]]\nname = "storm"\n').replace(
        "elements = 20", "elements = 10\nruns = 2"
    )
    + """
[waves]
spectrum = "jonswap"
height = "4 m"
period = "9 s"
components = 20
[current]
profile = "power"
speed = "0.8 m/s"
"""
)

EXAMPLE = CASES / "dynamic-chain-56m"

RAOS = (
    (EXAMPLE / "case.toml")
    .read_text("utf-8")
    .replace('"5 min"', '"20 s"\nelements = 10')
    .replace('period = "9 s"', 'period = "4 s"')
)
"""Waves of the example that are shorter than its table of RAOs goes."""

TWICE_IN_MOTION = (
    TWICE.replace('EA = "500 MN"', 'EA = "500 MN"\nmass = "120 kg/m"\ndrag_normal = 0').replace(
        '"-50 kN"', '"-50 kN"\nmass = "1 t"'
    )
    + CHAIN_IN_MOTION[CHAIN_IN_MOTION.index("[motion]") :]
)

LED = (
    AT_SEA[: AT_SEA.index("[[load_cases]]")]
    + """
[system]
anchor_radius = "117 m"
fairlead_radius = "4 m"
azimuths = ["180 deg", "60 deg", "-60 deg"]
force = ["30 kN", "0 kN"]
"""
    + AT_SEA[AT_SEA.index("[waves]") :]
    + """
[motion]
rao_file = "ship.csv"
rao_phase = "lag"
rao_reference = ["0 m", "0 m", "22 m"]
rao_rotation = "deg/m"
rao_per = "amplitude"
[dynamics]
duration = "24 s"
elements = 10
"""
)
SHIP = """heading (deg),period (s),surge (m/m),surge_phase (deg),heave (m/m),pitch (deg/m)
0,5,0.2,-90,0.3,0.5
0,10,0.6,-90,0.8,1.5
"""
PUSHED = (
    LED[: LED.index("[waves]")]
    + """
[body]
mass = "200 t"
force_file = "force.csv"
[dynamics]
duration = "24 s"
elements = 10
"""
)
FORCE = "t (s),Fx (kN),Fz (kN)\n" + "".join(f"{t},{2 * t * (24 - t)},1\n" for t in range(25))

FILES = {
    "led.toml": LED,
    "ship.csv": SHIP,
    "pushed.toml": PUSHED,
    "force.csv": FORCE,
    "twice.toml": TWICE,
    "slack.toml": BIGHTS,
    "tension-known.toml": TENSION_KNOWN,
    "moving.toml": CHAIN_IN_MOTION,
    "raos.toml": RAOS,
    "rao.csv": (EXAMPLE / "rao.csv").read_text("utf-8"),
    "twice-in-motion.toml": TWICE_IN_MOTION,
    "at-sea.toml": AT_SEA,
    "slack-in-motion.toml": CHAIN_IN_MOTION.replace('surge = "0.5 m"', 'heave = "3 m"')
    .replace("300 kN", "20 kN")
    .replace("24 s", "12 s"),
}

VERIFIED: list[list[object]] = [
    [DESIGN, "--elements", "40"],
    [FSO, "--elements", "60"],
    ["twice.toml", "--elements", "40", "--tolerance", "1e-9"],
    ["slack.toml"],
    ["at-sea.toml", "--dynamic"],
    ["led.toml", "--dynamic", "--elements", "40", "--once"],
]
FURTHER: list[list[object]] = [
    [BUOY],
    [SLACK],
    [CASES / "ship-200m-sinker" / "case.toml"],
    [CASES / "tanker-20m-sinker" / "case.toml"],
    ["twice.toml", "--elements", "40"],
    ["tension-known.toml"],
    ["moving.toml", "--dynamic"],
    ["raos.toml", "--dynamic"],
    ["twice-in-motion.toml", "--dynamic", "--elements", "40"],
    ["slack-in-motion.toml", "--dynamic"],
    ["pushed.toml", "--dynamic", "--elements", "40"],
]


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Work where the cases of this module are, on a terminal of 80 columns."""
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    # Figures are the same in every language and take most of the time.
    monkeypatch.setattr("catopt.render.picture.pictures", lambda *_, **__: {})


def fits(text: str) -> bool:
    return max(map(len, text.splitlines())) <= 80 and "…" not in text


# ------------------------------------------------------------------ every regime


@pytest.mark.parametrize(
    "arguments",
    [*VERIFIED, *(pytest.param(each, marks=pytest.mark.slow) for each in FURTHER)],
    ids=lambda arguments: " ".join(map(str, arguments)),
)
def test_no_text_is_missing_and_it_fits(run: Run, arguments: list[object]) -> None:
    ran = run("verify", *arguments, "--lang", "vi", "--out", "out")
    # 20 bars are too few for the lines that go slack.
    assert ran.status == (4 if "KHÔNG HỘI TỤ" in ran.out else 0)
    assert fits(ran.out)
    english = run("verify", *arguments).out
    assert said_alike(english, ran.out) <= {english.splitlines()[0]}


@pytest.mark.parametrize("arguments", [["twice.toml"], ["at-sea.toml", "--dynamic"]], ids=str)
def test_the_document_is_the_same_in_both_languages(run: Run, arguments: list[object]) -> None:
    command = ["verify", *arguments, "--json"]
    assert run(*command, "--lang", "vi").out == run(*command).out


@pytest.mark.slow
@pytest.mark.parametrize(
    ("case", "sheets"),
    [
        ("twice.toml", {"verify": ["Kết luận", "Các đại lượng", "Các lưới", "Hình dạng"]}),
        (
            "at-sea.toml",
            {
                "verify": ["Kết luận", "Các đại lượng", "Các lưới", "Hình dạng"],
                "dynamic": [
                    "Thống kê", "Tóm tắt", "Các lần chạy", "Đường bao", "Chuỗi thời gian",
                ],
            },
        ),
    ],
)  # fmt: skip
def test_the_files_differ_in_the_words_of_the_workbooks_alone(
    run: Run, tmp_path: Path, case: str, sheets: dict[str, list[str]]
) -> None:
    options = ["--dynamic"] if "dynamic" in sheets else []
    for lang in ("en", "vi"):
        run("verify", case, *options, "--lang", lang, "--out", tmp_path / lang)
    for path in (tmp_path / "en").iterdir():
        if path.suffix in {".csv", ".json"}:
            assert (tmp_path / "vi" / path.name).read_bytes() == path.read_bytes()
    for name, expected in sheets.items():
        english, said = ((tmp_path / lang / f"{name}.xlsx").read_bytes() for lang in ("en", "vi"))
        assert openpyxl.load_workbook(BytesIO(said)).sheetnames == expected
        assert numbers(english) == numbers(said) != []


def test_what_is_said_of_a_line_in_motion_and_of_a_slack_one(run: Run) -> None:
    shown = " ".join(run("verify", "at-sea.toml", "--dynamic", "--lang", "vi").out.split())
    for part in (
        "Trường hợp tải trọng storm: dây chuyển động",
        "2 lần chạy, mỗi lần 24 s",
        "Lực căng tại điểm treo đạt",
        "Quá ít đỉnh để tính cực đại khả dĩ nhất của lực căng tại điểm treo.",
        "Lưu ý: lực căng tựa tĩnh không kể dòng chảy.",
    ):
        assert part in shown
    shown = " ".join(run("verify", "slack.toml", "--lang", "vi").out.split())
    assert "Lưu ý: dây chùng: mô hình dàn chỉ xác định dây đến một thanh" in shown
    shown = " ".join(run("verify", "slack-in-motion.toml", "--dynamic", "--lang", "vi").out.split())
    assert "Dây bị CHÙNG: có thanh không chịu lực căng trong" in shown


def test_a_run_that_was_stopped_says_so_in_vietnamese(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def tell(done: int, total: int) -> None:
        if done > total / 14:
            raise KeyboardInterrupt

    def stops(*args: Any, **options: Any) -> Any:
        return verify_dynamic(*args, **options | {"progress": tell})

    monkeypatch.setattr("catopt.verify.dynamic.verify_dynamic", stops)
    ran = run("verify", "moving.toml", "--dynamic", "--lang", "vi", "--out", "out")
    assert ran.status == 130
    assert "catopt: bị ngắt ở trường hợp tải trọng load, lần chạy 1 trên 1, sau " in ran.err
    assert "Lưu ý: bị ngắt ở lần chạy 1 trên 1." in ran.out


# ------------------------------------------------------------------ systems


def turning() -> Verification:
    """Verify a body with a yaw and two slack lines."""
    chain = Line([Segment(600.0, 1000.0, EA=8e8)])
    system = System.around(
        chain,
        azimuths=[math.radians(20.0 + 90.0 * k) for k in range(4)],
        anchor_radius=565.0,
        fairlead_radius=10.0,
        fairlead_height=50.0,
        force=(8e5, 2e5),
        moment=2e6,
    )
    return verify_case(replace(read_case(FSO), system=system), elements=40)


def test_a_system_with_every_remark(capsys: pytest.CaptureFixture[str]) -> None:
    found = turning()
    assert len(found.static.remarks) == 3
    answer = verification_answer(found)
    show(Output(), answer, "vi")
    assert fits(capsys.readouterr().out)
    said = workbook(answer, "vi")
    assert numbers(workbook(answer)) == numbers(said) != []
    remarks = str(openpyxl.load_workbook(BytesIO(said))["Kết luận"].cell(2, 7).value)
    assert remarks.startswith("dây 1: dây chùng: mô hình dàn")
    assert remarks.count("dây chùng") == 2
    assert "góc xoay của nghiệm giải tích" in remarks


# ------------------------------------------------------------------ models that differ


@pytest.fixture
def off(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the closed form be wrong: its line weighs one part in a hundred more."""
    from catopt.catenary.case import solve_case

    def wrong(case: Case) -> object:
        heavier = [replace(s, submerged_weight=1.01 * s.submerged_weight)
                   for s in case.line.segments]  # fmt: skip
        return solve_case(replace(case, line=Line(heavier, case.line.point_loads)))

    monkeypatch.setattr("catopt.verify.case.solve_case", wrong)


@pytest.mark.usefixtures("off")
@pytest.mark.parametrize("case", [BUOY, DESIGN], ids=str)
def test_models_that_differ(run: Run, case: Path) -> None:
    ran = run("verify", case, "--elements", "20", "--lang", "vi", "--strict", "--out", "out")
    assert ran.status == 3
    assert "Hai mô hình KHÔNG KHỚP: độ dạt ngang lệch" in " ".join(ran.out.split())
    assert ran.err.splitlines()[-1].startswith("catopt: The two models")
    assert fits(ran.out)


@cache
def plain() -> StaticComparison:
    return verify_case(read_case(BUOY), elements=40).static


UNITS: list[tuple[Unit, str]] = [
    ("N", "fairlead_tension"),
    ("m", "span"),
    ("m", "position_x"),
    ("rad", "anchor_angle"),
    ("Nm", "moment_of_lines"),
]


@pytest.mark.parametrize(("unit", "quantity"), UNITS)
@pytest.mark.parametrize("closed_form", [1.0, 1.0001, 2.0])
def test_every_verdict_is_said_in_vietnamese(unit: Unit, quantity: str, closed_form: float) -> None:
    """Near and far, settled and not, of a slack line and not."""
    for theory, finest in product((1.0, 2.0), (1.0, 1.1)):
        fem = (1.0, 1.0, finest)
        each = Compared(quantity, unit, closed_form, fem, 1.0, 1e-3, line=1, theory=theory)
        part = replace(plain(), quantities=(each,))
        for english in filter(None, (part_sentence(part), rough_sentence(part))):
            said = in_vietnamese(english)
            assert not any(word in said for word in (" by ", " of ", "change", "allowed"))


@pytest.mark.parametrize("count", range(1, 7))
def test_however_much_is_not_smooth_is_said_in_vietnamese(count: int) -> None:
    quantities = plain().quantities
    rough = [replace(each, fem=(1.0, 2.0, 1.0), scale=1.0) for each in quantities[:count]]
    english = rough_sentence(replace(plain(), quantities=(*rough, *quantities[count:])))
    said = in_vietnamese(english)
    assert said.startswith("Không hội tụ đều nên lấy giá trị của lưới mịn nhất")
    assert said.count("(") == 1 + min(count, 4)
    assert not any(word in said for word in ("tension", "span", "inclination", "more"))


# ------------------------------------------------------------------ fronts


@pytest.fixture(scope="module")
def front(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Search a small front once, and keep its directory."""
    from catopt.__main__ import main

    directory = tmp_path_factory.mktemp("front")
    options = ["--method", "nsga2", "--evaluations", "200", "--seed", "3", "--out"]
    assert main(["design", str(DESIGN), *options, str(directory)]) == 0
    return directory


def test_a_front(run: Run, front: Path, tmp_path: Path) -> None:
    command = ["verify", front, "--all", "--elements", "40"]
    ran = run(*command, "--lang", "vi", "--out", tmp_path / "vi")
    assert ran.status == 0
    assert fits(ran.out)
    assert "Hai mô hình khớp nhau với cả" in ran.out
    english = run(*command, "--out", tmp_path / "en").out
    loads = {line for line in said_alike(english, ran.out) if line.split() in (["water"],)}
    assert said_alike(english, ran.out) - loads <= {english.splitlines()[0]}
    books = [(tmp_path / lang / "verify.xlsx").read_bytes() for lang in ("en", "vi")]
    assert numbers(books[0]) == numbers(books[1]) != []
    said = openpyxl.load_workbook(BytesIO(books[1]))
    assert said.sheetnames == ["Các phương án", "Kết luận", "Các đại lượng", "Các lưới"]
    assert said["Kết luận"].cell(2, 1).value == "phương án 1, storm, high water"


@pytest.mark.parametrize("differing", [False, True])
def test_designs_without_an_answer(
    run: Run, front: Path, monkeypatch: pytest.MonkeyPatch, differing: bool
) -> None:
    seen: list[Case] = []

    def first_fails(case: Case, **settings: Any) -> Verification:
        seen.append(case)
        if len(seen) == 1:
            raise stuck()
        found = verify_case(case, **settings)
        if len(seen) > 2 or not differing:
            return found
        worse = [replace(each, closed_form=each.closed_form + each.scale)
                 for each in found.static.quantities]  # fmt: skip
        return replace(found, parts=(replace(found.static, quantities=tuple(worse)),))

    monkeypatch.setattr("catopt.verify.front.verify_case", first_fails)
    ran = run("verify", front, "--all", "--elements", "20", "--lang", "vi", "--out", "out")
    assert ran.status == 4
    shown = " ".join(ran.out.split())
    assert "Phương án 1: mô hình dàn không đạt cân bằng: sau 1 vòng lặp" in shown
    assert "KHÔNG CÓ" in shown
    assert ("KHÔNG KHỚP" in shown) == differing
    assert "1 phương án không có kết quả." in shown
    assert fits(ran.out)


def stuck() -> CatoptError:
    """Stop Newton's method after its first step."""
    line = Line([Segment(120.0, 1000.0)])
    with pytest.raises(NotConvergedError) as stopped:
        solve_line(line, height=50.0, span=100.0, controls=Controls(max_iterations=1))
    return stopped.value


# ------------------------------------------------------------------ messages


def refusals() -> Iterator[str]:
    """Make every message for a line that cannot hang as asked."""
    plain_line = Line([Segment(100.0, 1000.0)])
    buoyed = Line([Segment(100.0, 1000.0)], [PointLoad(50.0, -9e4, name="float")])
    floating = Line([Segment(100.0, 1000.0), Segment(50.0, -500.0, name="rope")])
    for line in (plain_line, buoyed, floating):
        setting = LineProblem(cut(line)[0], 0.0, 120.0, 0.5)
        level = LineProblem(cut(line)[0], 0.0, 60.0, 0.5)
        span = Load(span=80.0)
        for load in (span, Load(fairlead_tension=100.0)):
            yield refusal(TOO_SHORT, line, load, setting).message
        yield refusal(TOO_SHORT, plain_line, span, level).message  # 60, 80, 100: just as long
    straight_up = LineProblem(cut(plain_line)[0], 0.0, 100.0, 0.5)
    yield refusal(TOO_SHORT, plain_line, Load(fairlead_tension=1.0), straight_up).message
    yield refusal(TOO_HEAVY, plain_line, Load(fairlead_tension=100.0), level).message
    yield refusal(NOT_CONVERGED, plain_line, span, setting).message
    yield stuck().message
    with pytest.raises(CatoptError) as stopped:
        solve_line(plain_line, height=60.0, span=90.0)
    yield stopped.value.message
    for name in ("", "float"):
        high = Line([Segment(100.0, 1000.0)], [PointLoad(50.0, -9e4, name=name)])
        with pytest.raises(FloatsUpError) as afloat:
            check_buoys(high, [25.0], 20.0)
        yield afloat.value.message
        with pytest.raises(FloatsUpError) as afloat, named_line(2):
            check_buoys(high, [25.0], 20.0)
        yield afloat.value.message


def test_every_refusal_is_said_in_vietnamese() -> None:
    told = list(refusals())
    for english in told:
        said = in_vietnamese(english)
        assert not any(word in said for word in (" the ", " is ", " of ", " Give "))
    assert len(set(told)) >= 9


def test_warnings_of_a_run_are_said_in_vietnamese() -> None:
    """Waves that break and nearly repeat themselves, and a step that is rather long."""
    sea = Sea(8.0, random_waves(jonswap(7.0, 9.0), 12, np.random.default_rng(1)))
    told = step_warnings(0.5, 600.0, {"the motion or force": 8.0}, sea)
    assert [part.split()[0] for part in told] == ["the", "12", "the", "the"]
    told += record_warnings(0.2, 0.1)
    told += [Message("motion.sets_off", speed=1.57, jump=380.0)]
    assert say(Several(told), "vi") == "; ".join(map(in_vietnamese, told))
