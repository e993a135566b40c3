"""Small pieces of work that between them need every compiled kernel function."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING

from catopt.compiled import VARIABLE
from catopt.threads import environment

if TYPE_CHECKING:
    from catopt.model import Case


@contextmanager
def compile_always() -> Iterator[None]:
    """Have every kernel function compiled while the body runs, however little it has to do."""
    with environment({VARIABLE: "always"}):
        yield


def _template(name: str, more: str = "") -> Case:
    from catopt.casefile import parse_case
    from catopt.casefile.writing import template

    return parse_case(template(name) + more)


_ONE_MOORING = """
[design]
lines = [6]

[[design.segments]]
component = "chain studless R3"
diameter = "76 mm"
lengths = ["200 m"]
"""


def _lines() -> None:
    """Many lines of one kind."""
    from catopt.catenary.batch import solve_many

    case = _template("buoy")
    solve_many(case.line, height=case.fairlead_height, horizontal_force=[3e3, 4e3])


def _bodies() -> None:
    """Many loads on one body: what brings joints to rest, too."""
    from catopt.mooring.batch import solve_system_many

    system = _template("system").own_system
    solve_system_many(system, force=[[0.0, 0.0], [1e4, 0.0]])


def _designs() -> None:
    """Designs of a line and of a mooring, and the front of two and of three objectives."""
    import numpy as np

    from catopt.design.front import hypervolume, non_dominated
    from catopt.design.search import design_case

    design_case(_template("design"))
    design_case(_template("system", _ONE_MOORING))
    front = np.array([[1.0, 2.0, 3.0], [2.0, 1.0, 3.0], [3.0, 2.0, 1.0]])
    non_dominated(front)
    hypervolume(front, np.full(3, 4.0))


def _waves() -> None:
    """Water of random waves, and a motion from a series."""
    import numpy as np

    from catopt.fem import Harmonic
    from catopt.fem.series import series_rows, series_values
    from catopt.waves import Sea, jonswap, random_waves

    sea = Sea(50.0, random_waves(jonswap(4.0, 9.0), 3, np.random.default_rng(1)))
    sea.kinematics(0.0, np.zeros((1, 3)))
    sea.elevation(0.0)
    rows = series_rows(np.zeros((1, 3)), [Harmonic(8.0, (2.0, 0.5, 1.0))], 5.0)
    series_values(rows, np.linspace(0.0, 1.0, 2))


def _at_rest() -> None:
    """Put the truss model beside a line at rest."""
    from catopt.verify.case import verify_case

    verify_case(_template("buoy"))


def _moved(**dynamics: float) -> Case:
    case = _template("motion")
    assert case.dynamics is not None
    return replace(case, dynamics=replace(case.dynamics, elements=8, **dynamics))  # type: ignore[arg-type]


def _in_motion() -> None:
    """Run the truss model in waves, current and motion."""
    from catopt.verify.dynamic import verify_dynamic

    verify_dynamic(_moved(duration=0.2))


def _afloat() -> None:
    """Run a buoy with its line, and by itself."""
    from catopt.fem import TimeStepping
    from catopt.floater.alone import run_alone
    from catopt.floater.hulls import buoy_hull
    from catopt.model import Floater, WaveState
    from catopt.verify.dynamic import verify_dynamic
    from catopt.waves import Sea, regular_wave

    of, waves = Floater("mooring buoy 2.5 m"), WaveState("regular", 0.5, 6.0)
    case = replace(_moved(duration=0.2), motion=None, anchor_motion=None, floater=of, waves=waves)
    light = tuple(replace(each, submerged_weight=200.0) for each in case.line.segments)
    case = replace(case, line=replace(case.line, segments=light))
    verify_dynamic(case, convergence_check="none")
    hull = buoy_hull(of, 20.0, 1025.0, 0.0)
    run_alone(hull, TimeStepping(0.1, 0.05), sea=Sea(20.0, regular_wave(0.5, 6.0)))


def _ship() -> None:
    """Step a ship on its lines, by closed form and out of tables."""
    import numpy as np

    from catopt.floater.ship_in_weather import ShipInWeather
    from catopt.floater.tabulated import TabulatedShip
    from catopt.floater.two_scales import MooredShip
    from catopt.model import ShipAfloat
    from catopt.waves import regular_wave

    system = _template("system").own_system
    depth = max(leg.fairlead_height for leg in system.legs)
    of = ShipInWeather(ShipAfloat(30.0, 8.0, 0.2 * depth, 0.5 * depth), depth, 1025.0, (5.0, 0.0))
    for on_lines in (MooredShip, TabulatedShip):
        on_lines(system, of).run(regular_wave(0.2, 5.0), 4.0, 1.0, np.random.default_rng(1))


def _linear() -> None:
    """Move the truss model in a sea linearly."""
    from catopt.model import WaveState
    from catopt.verify.linear import linear_lines

    waves = WaveState("jonswap", 2.0, 8.0, components=4)
    linear_lines(replace(_moved(), waves=waves, motion=None))


JOBS: Mapping[str, Callable[[], None]] = MappingProxyType(
    {
        "many lines": _lines,
        "bodies of several lines": _bodies,
        "design search": _designs,
        "waves": _waves,
        "truss model at rest": _at_rest,
        "truss model in motion": _in_motion,
        "buoy afloat": _afloat,
        "ship on its lines": _ship,
        "truss model in linear motion": _linear,
    }
)
"""What is compiled, in the order in which it is."""
