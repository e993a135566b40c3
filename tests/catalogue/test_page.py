"""docs/catalogue.md says what the data say, and its example of a user's file is right."""

from __future__ import annotations

import re

from catopt import catalogue
from catopt.catalogue.reading import parse_families

from .page import PAGE, PARTS, VERDICTS_PAGE, parts, up_to_date, verdicts_page


def test_the_tables_are_those_of_the_data() -> None:
    """When they are not: python -m tests.catalogue.page writes them anew."""
    page = PAGE.read_text("utf-8")
    assert parts(page) == list(PARTS)
    assert up_to_date(page) == page


def test_the_verdicts_are_those_that_were_found() -> None:
    assert VERDICTS_PAGE.read_text("utf-8") == verdicts_page()


def test_a_changed_number_is_noticed() -> None:
    page = PAGE.read_text("utf-8")
    changed = page.replace("0.0223 d^2 (44 - 0.08 d) kN", "0.0233 d^2 (44 - 0.08 d) kN", 1)
    assert changed != page
    assert up_to_date(changed) == page


def test_every_variant_and_source_is_on_the_page() -> None:
    text = PAGE.read_text("utf-8")
    for family in catalogue.families():
        assert f"### {family.name}\n" in text
        for figure in family.figures:
            assert figure.variant in text
            assert figure.place in text


def test_the_example_of_one_s_own_families_is_right() -> None:
    (example,) = re.findall(r"```toml\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)
    (family,) = parse_families(example).families
    assert family.sizes.diameters
    for quantity in ("mass", "volume_diameter", "MBL", "EA"):
        assert family.default(quantity, None) is not None
