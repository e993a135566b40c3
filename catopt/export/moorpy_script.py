"""A Python script that builds the lines in MoorPy, solves them and prints the forces."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from catopt.decks.deck import Deck
from catopt.export.exported import exact

_KINDS = {"fixed": 1, "coupled": -1, "free": 0}

_SOLVED = """\
for name, d_vol, m, EA, Cd, CdAx, Ca, CaAx in LINE_TYPES:
    kind = {"name": name, "material": name, "d_vol": d_vol, "m": m, "EA": EA, "cost": 0.0}
    kind["w"] = (m - np.pi / 4 * d_vol**2 * system.rho) * system.g
    system.lineTypes[name] = kind | {"Cd": Cd, "CdAx": CdAx, "Ca": Ca, "CaAx": CaAx}
for kind, place, m, v, CdA, Ca in POINTS:
    point = system.addPoint(kind, np.array(place), m=m, v=v)
    point.CdA, point.Ca = CdA, Ca
    point.zTol = 0.001  # its own 2 m take weight off what hangs near the bed
for length, name, anchor_side, fairlead_side in LINES:
    system.addLine(length, name, pointA=anchor_side, pointB=fairlead_side)
system.initialize()
system.solveEquilibrium(DOFtype="free", tol=1e-7)

for point in system.pointList:
    if point.type == -1:
        fx, fy, fz = point.getForces(xyz=True)
        print(f"fairlead {point.number}: H {np.hypot(fx, fy):.1f} N, V {-fz:.1f} N")"""


def moorpy_lines(deck: Deck, said: Iterable[str]) -> Iterator[str]:
    """Yield the lines of the script; `said`: what it says of itself."""
    for line in said:
        yield f"# {line}".rstrip()
    yield ""
    yield "import moorpy"
    yield "import numpy as np"
    yield ""
    place = ", ".join(
        f"{key}={exact(value)}"
        for key, value in (("depth", deck.depth), ("rho", deck.density), ("g", deck.gravity))
    )
    yield f"system = moorpy.System({place})"
    yield "LINE_TYPES = [  # name, volume-equivalent diameter (m), kg/m, N, Cd, CdAx, Ca, CaAx"
    for name, kind in deck.types.items():
        assert kind.drag is not None
        numbers = (kind.diameter, kind.mass, kind.EA, *kind.drag)
        yield f'    ("{name}", {", ".join(map(exact, numbers))}),'
    yield "]"
    yield "POINTS = [  # 1 fixed, -1 held on the body, 0 free; place (m), kg, m3, Cd A (m2), Ca"
    for point in deck.points.values():
        at = ", ".join(map(exact, (point.x, point.y, point.z)))
        body = (point.mass, point.volume, point.drag_area, point.added_mass)
        yield f"    ({_KINDS[point.end]}, ({at}), {', '.join(map(exact, body))}),"
    yield "]"
    yield "LINES = [  # unstretched length (m), type, points at its ends"
    for piece in deck.pieces:
        yield f'    ({exact(piece.length)}, "{piece.type}", {", ".join(piece.ends)}),'
    yield "]"
    yield _SOLVED
