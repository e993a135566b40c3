"""Bodies on lines of their own by the kernel of lines between points, and by the one before it."""

from __future__ import annotations

import math
import random
import re
from pathlib import Path

import pytest

from catopt import System, read_case
from catopt.errors import CatoptError
from catopt.mooring import static_equilibrium as before
from catopt.mooring import zero_load
from tests.mooring.test_random_systems import EA, drawn

ROOT = Path(__file__).parents[2]
FILES = sorted(
    path
    for folder in ("cases", "tests")
    for path in (ROOT / folder).rglob("*.toml")
    if "[system]" in path.read_text("utf-8", errors="replace")
)
FORCES = ("H", "V", "H_anchor", "V_anchor")


def of_file(path: Path) -> System | None:
    try:
        return read_case(path).system
    except CatoptError:
        return None


SYSTEMS = {path.relative_to(ROOT).as_posix(): found for path in FILES if (found := of_file(path))}


def test_there_are_systems_to_compare() -> None:
    assert len(SYSTEMS) > 25


def alike(system: System) -> None:
    """Both refuse in the same words, or rest at one place under the same forces, to 1e-9."""
    try:
        old = before.zero_load_position(system)
        rest, lines = old.under(system.force, system.moment)
    except CatoptError as error:
        with pytest.raises(type(error), match=f"^{re.escape(str(error))}$"):
            zero_load.zero_load_position(system).under(system.force, system.moment)
        return
    new = zero_load.zero_load_position(system)
    found, hung = new.under(system.force, system.moment)
    length = max(leg.line.length for leg in system.legs)
    assert math.dist((rest.x, rest.y), (found.x, found.y)) <= 1e-9 * length
    assert abs(math.remainder(rest.yaw - found.yaw, math.tau)) <= 1e-9
    tension = max(map(math.hypot, lines.H, lines.V))
    unloaded = zero_load.lines_of(new.net, new.known)
    for one, other in ((lines, hung), (old.lines, unloaded)):
        for name in FORCES:
            pairs = zip(getattr(one, name), getattr(other, name), strict=True)
            assert max(abs(a - b) for a, b in pairs) <= 1e-9 * tension, name
    pull, arm = rest.pull, new.net.scale[2]
    stiffness = (
        (pull.xx, pull.xy, pull.xm),
        (pull.xy, pull.yy, pull.ym),
        (pull.xm, pull.ym, pull.mm),
    )
    scale = (1.0, 1.0, arm)
    for i in range(3):
        for j in range(3):
            off = abs(stiffness[i][j] - found.stiffness[i][j]) / (scale[i] * scale[j])
            assert off <= 1e-6 * max(pull.xx, pull.yy), (i, j)  # a slope of what is right to 1e-9
    assert new.is_held(found) == before.is_held(pull, old.freedom)


@pytest.mark.parametrize("name", SYSTEMS)
def test_shipped(name: str) -> None:
    alike(SYSTEMS[name])


@pytest.mark.parametrize("count", [10, pytest.param(200, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", EA)
def test_drawn(kind: str, count: int) -> None:
    draw = random.Random(58)
    for _ in range(count):
        alike(drawn(kind, draw))
