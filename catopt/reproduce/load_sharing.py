"""S4: how many times the force of its most loaded line a ring of lines carries."""

from __future__ import annotations

from catopt.mooring.sharing_rule import load_sharing_factor
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, Study
from catopt.reproduce.published import published
from catopt.words import Message

NAME = "load_sharing"


def study() -> Study:
    """Add up the lines of the loaded half and judge the printed factors."""
    source = published(NAME)
    numbers = [int(lines) for lines in source.series["lines"]]
    return study_of(
        source,
        inputs=(
            Input("number of lines, evenly spaced", ", ".join(map(str, numbers)), ""),
            Input("direction of the force", "along one of the lines", ""),
        ),
        items=compare(
            source,
            "N/4 rule",
            {f"FT_over_F_{lines}_lines": load_sharing_factor(lines) for lines in numbers},
            computed_by="the rule's sum",
        ),
        findings=(_about_the_sum(), _about_what_is_left_out()),
    )


def _about_the_sum() -> str:
    return Message("reproduce.line_force_ft_points_along")


def _about_what_is_left_out() -> str:
    return Message("reproduce.rule_holds_for_equal_lines")
