"""S1, Tables 1 to 3, beside the article's closed form written out here once more."""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

import jsonschema
import pytest

import catopt
from catopt.errors import InputError
from catopt.reproduce import Item, Reproduction, book, reproduce
from catopt.schemas import schema

ROOT = Path(__file__).parents[2]

DEPTH, LENGTH, FORCE, WEIGHT = 9.5, 20.0, 343.0, 9.5  # m, m, kgf, kgf/m


@dataclass(frozen=True)
class Hung:
    """What S1 prints: rad, m, tf."""

    theta0: float
    offset: float
    tension: float


def hang(weight: float) -> Hung:
    """S1 (4) by bisection for t = tan(theta0), then S1 (5) and (7); weight in kgf/m."""
    a = FORCE / weight
    low, high = 0.0, 10.0
    for _ in range(200):
        t = 0.5 * (low + high)
        height = a * math.sqrt(1.0 + (LENGTH / a + t) ** 2) - a * math.sqrt(1.0 + t * t)
        low, high = (t, high) if height < DEPTH else (low, t)
    return Hung(
        math.atan(t),
        a * (math.asinh(LENGTH / a + t) - math.asinh(t)),
        FORCE / 1000.0 * math.sqrt(1.0 + (LENGTH / a + t) ** 2),
    )


@pytest.fixture(scope="module")
def reproduction() -> Reproduction:
    return reproduce("buoy_9p5m")


def pick(reproduction: Reproduction, method: str, quantity: str) -> Item:
    (item,) = [i for i in reproduction.items if (i.method, i.quantity) == (method, quantity)]
    return item


@pytest.mark.parametrize("method", ["pso", "fem", "analytic"])
def test_each_computed_number_is_that_of_the_closed_form(
    reproduction: Reproduction, method: str
) -> None:
    expected = hang(WEIGHT)
    # The objective ends below 1e-12 m and shifts theta0, S and T by no more than a few times that.
    for quantity, value in [
        ("theta0_rad", expected.theta0),
        ("offset_m", expected.offset),
        ("tension_tf", expected.tension),
    ]:
        assert pick(reproduction, method, quantity).computed == pytest.approx(value, abs=1e-11)


@pytest.mark.parametrize(
    ("method", "quantity", "published", "computed", "verdict"),
    [
        ("pso", "theta0_rad", "0.272", "0.272", "reproduces"),
        ("pso", "offset_m", "17.430", "17.430", "reproduces"),
        ("pso", "tension_tf", "0.446", "0.446", "reproduces"),
        ("pso", "objective_m", "3.55e-15", "below 1e-12", "reproduces"),
        ("pso", "wall_time_s", "31", "", "not reproducible"),
        ("fem", "theta0_rad", "0.272", "0.272", "reproduces"),
        ("fem", "offset_m", "17.430", "17.430", "reproduces"),
        ("fem", "tension_tf", "0.450", "0.446", "differs"),
        ("analytic", "theta0_rad", "0.272", "0.272", "reproduces"),
        ("analytic", "offset_m", "17.430", "17.430", "reproduces"),
        ("analytic", "tension_tf", "0.450", "0.446", "differs"),
        ("pso against fem", "theta0_error_percent", "0.00", "0.00", "reproduces"),
        ("pso against fem", "offset_error_percent", "0.00", "0.00", "reproduces"),
        ("pso against fem", "tension_error_percent", "0.89", "0.89", "reproduces"),
        ("pso against analytic", "theta0_error_percent", "0.00", "0.00", "reproduces"),
        ("pso against analytic", "offset_error_percent", "0.00", "0.00", "reproduces"),
        ("pso against analytic", "tension_error_percent", "0.89", "0.89", "reproduces"),
    ],
)
def test_every_printed_number_has_its_verdict(
    reproduction: Reproduction,
    method: str,
    quantity: str,
    published: str,
    computed: str,
    verdict: str,
) -> None:
    item = pick(reproduction, method, quantity)
    assert item.printed.text == published
    assert item.judgement.computed_text == computed
    assert item.verdict == verdict
    assert len(reproduction.items) == 17


def test_what_differs_or_cannot_be_reproduced_says_why(reproduction: Reproduction) -> None:
    for item in reproduction.items:
        if item.verdict != "reproduces":
            assert item.note
    assert "differs by -0.0037 tf (-0.82 %)" in pick(reproduction, "fem", "tension_tf").note


def test_only_the_printed_digits_give_table_3(reproduction: Reproduction) -> None:
    """|0.446 - 0.450| / 0.450 = 0.89 %; from the unrounded tension it would be 0.82 %."""
    assert 100.0 * abs(0.446 - 0.450) / 0.450 == pytest.approx(0.89, abs=0.005)  # as printed
    assert 100.0 * abs(0.446 - 0.450) / 0.446 == pytest.approx(0.90, abs=0.005)  # the other base
    assert 100.0 * abs(hang(WEIGHT).tension - 0.450) / 0.450 == pytest.approx(0.82, abs=0.005)
    note = pick(reproduction, "pso against fem", "tension_error_percent").note
    assert note == (
        "|0.446 - 0.450| / 0.450 from the printed digits; "
        "from the unrounded tension of the swarm it would be 0.82 %"
    )


def test_the_weight_is_confined_as_the_findings_say(reproduction: Reproduction) -> None:
    finding = reproduction.studies[0].findings[1]
    assert "theta0 0.272 rad needs 9.468 to 9.509" in finding
    assert "offset 17.430 m needs 9.485 to 9.513" in finding
    assert "tension 0.446 tf needs 9.386 to 9.526" in finding
    # Bounds hold, and a thousandth beyond them the print changes.
    assert all(f"{hang(w).theta0:.3f}" == "0.272" for w in (9.468, 9.509))
    assert all(f"{hang(w).theta0:.3f}" != "0.272" for w in (9.467, 9.510))
    assert all(f"{hang(w).offset:.3f}" == "17.430" for w in (9.485, 9.513))
    assert all(f"{hang(w).offset:.3f}" != "17.430" for w in (9.484, 9.514))
    assert all(f"{hang(w).tension:.3f}" == "0.446" for w in (9.386, 9.526))
    assert all(f"{hang(w).tension:.3f}" != "0.446" for w in (9.385, 9.527))


def test_no_weight_gives_the_tension_of_reference_4_with_its_shape(
    reproduction: Reproduction,
) -> None:
    finding = reproduction.studies[0].findings[2]
    assert "needs 9.945 to 10.082 kgf/m" in finding
    assert "theta0 is 0.258 to 0.261 rad and the offset 17.409 to 17.414 m" in finding
    for weight in (9.945, 10.082):
        assert f"{hang(weight).tension:.3f}" == "0.450"
        assert f"{hang(weight).offset:.3f}" in {"17.409", "17.414"}
        assert f"{hang(weight).theta0:.3f}" in {"0.258", "0.261"}
    assert all(f"{hang(w).tension:.3f}" != "0.450" for w in (9.944, 10.083))


def test_the_printed_shape_alone_fixes_the_ratio_of_the_forces(reproduction: Reproduction) -> None:
    """T/H from theta0, S and h, whatever the weight: S1 (1) gives a, its slope at S the ratio."""
    ratios = []
    for theta0 in (0.2715, 0.2725):
        for span in (17.4295, 17.4305):
            start = math.asinh(math.tan(theta0))
            low, high = 10.0, 100.0
            for _ in range(200):
                a = 0.5 * (low + high)
                height = a * (math.cosh(span / a + start) - math.cosh(start))
                low, high = (a, high) if height > DEPTH else (low, a)
            ratios.append(math.cosh(span / a + start))
    assert {f"{ratio:.3f}" for ratio in ratios} == {"1.301"}
    finding = reproduction.studies[0].findings[2]
    assert "ratio of tension to horizontal force at 1.301" in finding
    assert all(f"{0.450 / ratio:.3f}" == "0.346" for ratio in ratios)
    assert "0.450 tf would take 0.346 tf instead of 0.343 tf" in finding


def test_the_printed_objective_is_one_step_of_double_precision() -> None:
    assert f"{math.ulp(LENGTH):.2e}" == "3.55e-15"


def test_the_document_keeps_to_its_schema(reproduction: Reproduction) -> None:
    document = reproduction.to_dict()
    jsonschema.validate(document, schema("catopt.reproduction/1"))
    offset = next(item for item in document["items"] if item["quantity"] == "offset_m")
    assert (offset["source"], offset["name"]) == ("S1", "buoy_9p5m")
    assert (offset["published"], offset["printed_digits"]) == (17.43, 5)
    assert (offset["unit"], offset["verdict"]) == ("m", "reproduces")


@pytest.mark.slow
def test_the_committed_page_is_fresh() -> None:
    committed = (ROOT / "reports" / "reproduction.md").read_text(encoding="utf-8")
    assert committed == book(reproduce()), "write it anew: catopt reproduce --out reports"


def test_a_bar_in_a_note_does_not_break_the_table(reproduction: Reproduction) -> None:
    for line in book(reproduction).splitlines():
        if line.startswith("| theta0_error_percent"):
            assert line.replace(r"\|", "").count("|") == 9


def test_an_unknown_name_is_refused() -> None:
    with pytest.raises(InputError) as caught:
        reproduce("bouy_9p5m")
    assert "'bouy_9p5m'" in str(caught.value)
    assert "did you mean buoy_9p5m?" in str(caught.value)
    with pytest.raises(InputError) as caught:
        reproduce("x")
    assert "did you mean" not in str(caught.value)


def test_the_case_file_is_the_published_case() -> None:
    case = catopt.read_case(ROOT / "cases" / "buoy-9.5m" / "case.toml")
    path = ROOT / "catopt" / "reproduce" / "published.toml"
    table = tomllib.loads(path.read_text(encoding="utf-8"))["buoy_9p5m"]
    given = table["inputs"]
    kgf = 9.80665  # N
    (segment,) = case.line.segments
    assert case.site.water_depth == case.fairlead_height == given["water_depth_m"]
    assert segment.length == given["line_length_m"]
    assert math.isinf(segment.EA)
    # Two products of the same decimal numbers, in either order: one step of double precision.
    weight = given["submerged_weight_kgf_per_m"] * kgf
    assert segment.submerged_weight == pytest.approx(weight, rel=3e-16)
    force = given["horizontal_force_tf"] * 1000.0 * kgf
    assert case.load is not None
    assert case.load.horizontal_force == pytest.approx(force, rel=3e-16)
    assert (case.swarm.particles, case.swarm.iterations) == (200, 200)


def test_the_tally_counts_every_number(reproduction: Reproduction) -> None:
    assert reproduction.tally == (
        "Of 17 printed numbers 14 reproduce, 2 differ and 1 cannot be reproduced."
    )
