"""S4: how many times the force of its most loaded line a ring of lines carries."""

from __future__ import annotations

from catopt.mooring.load_sharing import load_sharing_factor
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, Study
from catopt.reproduce.published import published

__all__ = ["NAME", "study"]

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
    return (
        "The line that the force FT points along carries F, the others less than a quarter turn "
        "away F cos(angle), each along itself. Their sum along FT is F times the sum of "
        "cos(angle) squared, N/4 for even N from 4 on; across FT they cancel."
    )


def _about_what_is_left_out() -> str:
    return (
        "The rule holds for equal lines without pretension whose pull grows in proportion to how "
        "far they are drawn out. It is no equilibrium of catenaries: those stiffen as they are "
        "drawn out, start from a pretension, and the lines on the other side still pull on the "
        "body. What they carry together depends on the line, its pretension and the offset, and "
        "can lie on either side of N/4."
    )
