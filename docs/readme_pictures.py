"""Draws the two pictures of README: ``python docs/readme_pictures.py`` writes them beside it."""

from __future__ import annotations

from pathlib import Path

import catopt
from catopt.design.document import design_document
from catopt.figures.front import front, front_lines
from catopt.figures.line import line_in_water
from catopt.render.picture import pictures

HERE = Path(__file__).parent
CASES = HERE.parent / "cases"


def main() -> None:
    """Draw the line of S3's tanker, and the front of its design."""
    case = catopt.read_case(CASES / "tanker-20m" / "case.toml")
    line = line_in_water(catopt.solve_case(case), case.site.water_depth)
    found = catopt.design_case(catopt.read_case(CASES / "design-tanker-20m" / "case.toml"))
    document = design_document(found)
    charts = (front(document), front_lines(found, document))
    files = pictures("picture-line", line, case.title)
    files |= pictures("picture-front", charts, found.case.title)
    for name in ("picture-line.png", "picture-front.png"):
        (HERE / name).write_bytes(files[name])


if __name__ == "__main__":
    main()
