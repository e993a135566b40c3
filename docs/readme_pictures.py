"""Draws README's and the home page's pictures: ``python docs/readme_pictures.py``."""

from __future__ import annotations

from pathlib import Path

import catopt
from catopt.figures.line import line_in_water
from catopt.figures.sizing import elevation, front, front_lines, swing_circle
from catopt.render.picture import pictures

HERE = Path(__file__).parent
CASES = HERE.parent / "cases"


def main() -> None:
    """Draw the mooring of README's first command, S3's tanker with a front, and a buoy."""
    case = catopt.read_case(CASES / "tanker-20m" / "case.toml")
    line = line_in_water(catopt.solve_case(case), case.site.water_depth)
    found = catopt.design_case(catopt.read_case(CASES / "design-tanker-20m" / "case.toml"))
    document = found.to_dict()
    charts = (front(document), front_lines(found, document))
    files = pictures("picture-line", line, case.title)
    files |= pictures("picture-front", charts, found.case.title)
    buoy = catopt.size_buoy("pillar 1.8 m", depth="12 m")
    title = "Pillar 1.8 m, 12 m of water"
    files |= pictures("picture-buoy", (elevation(buoy), swing_circle(buoy)), title)
    ship = catopt.size_tanker(dwt="50000 t", depth="20 m")
    title = "Tanker of 50,000 DWT, 20 m of water"
    files |= pictures("picture-ship", elevation(ship), title)
    for name in ("picture-line.png", "picture-front.png", "picture-buoy.png", "picture-ship.png"):
        (HERE / name).write_bytes(files[name])


if __name__ == "__main__":
    main()
