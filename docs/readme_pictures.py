"""Draws the two pictures of README: ``python docs/readme_pictures.py`` writes them beside it."""

from __future__ import annotations

from pathlib import Path

import catopt
from catopt.report.plots.common import render
from catopt.report.plots.design import design_front
from catopt.report.plots.line import line_in_water

HERE = Path(__file__).parent
CASES = HERE.parent / "cases"


def main() -> None:
    """Draw the line of S3's tanker, and the front of its design."""
    case = catopt.read_case(CASES / "tanker-20m" / "case.toml")
    line = line_in_water(catopt.solve_case(case), case.site.water_depth)
    (HERE / "picture-line.png").write_bytes(render(line, "png"))
    design = catopt.design_case(catopt.read_case(CASES / "design-tanker-20m" / "case.toml"))
    (HERE / "picture-front.png").write_bytes(render(design_front(design), "png"))


if __name__ == "__main__":
    main()
