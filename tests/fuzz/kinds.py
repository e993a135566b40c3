"""The kinds of file that catopt reads: each with files as they should be, and what reads them."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from catopt.casefile import parse_case, template, write_case
from tests.decks.own import C06, MAP, MOORDYN, ONTOLOGY, TWO_SEGMENTS, V1

__all__ = ["Kind", "kinds"]

ROOT = Path(__file__).parents[2]
CASES = ROOT / "cases"
LIBRARY = ROOT / "catopt"

Read = Callable[[Path], object]


@dataclass(frozen=True)
class Kind:
    """A kind of file.

    Attributes
    ----------
    name : str
        Of the kind.
    form : {"toml", "json", "csv", "deck", "xlsx", "bytes"}
        Its form; the text of the last two stands for bytes, each a character of Latin-1.
    texts : tuple of str
        Files as they should be.
    file : str
        Name under which the broken file stands.
    beside : mapping of str to str
        Files that stand beside it as they should be.
    command : tuple of str
        What reads it; the file's folder is the working directory. Empty where `read` does.
    read : callable or None
        A function of catopt's that reads the file, where a command that does takes too long.
    slow : tuple of str
        A command that does much more with it; only now and then.
    """

    name: str
    form: str
    texts: tuple[str, ...]
    file: str
    beside: Mapping[str, str]
    command: tuple[str, ...] = ()
    read: Read | None = None
    slow: tuple[str, ...] = ()

    def data(self, text: str) -> bytes:
        """Return what stands in a file of the kind."""
        return text.encode("latin-1" if self.form in ("xlsx", "bytes") else "utf-8")


OC3_BY_MAP = MAP.format(
    types="0.09 77.7066 384.243e6 0.001 0 0 0 0",
    anchor="853.87 0",
    fairlead="5.2 0 -70",
    length=902.2,
)

CATALOGUE_CASE = """
[site]
water_depth = "56 m"
[line]
[[line.segments]]
component = "own chain G1"
diameter = "40 mm"
length = "200 m"
[load]
horizontal_force = "100 kN"
[catalogue]
file = "own.toml"
"""

FAMILIES = """
schema = "catopt.families/1"
[sources.OWN]
title = "a maker's table"
place = "shelf"
[[family]]
name = "own chain"
title = "Chain of one's own"
grades = ["G1", "G2"]
range_mm = [10, 60]
sizes = { mm = [20, 40, 60], source = "OWN", place = "page 1", confidence = "C" }
[[figure]]
family = "own chain"
quantity = "mass"
formula = { d2 = 19900 }
source = "OWN"
place = "page 1"
confidence = "C"
[[figure]]
family = "own chain"
quantity = "volume_diameter"
formula = { d1 = 1.8 }
source = "OWN"
place = "page 1"
confidence = "C"
[[figure]]
family = "own chain"
quantity = "proof_load"
formula = { rows = [[10, 30], [40, 500], [60, 1100]], unit = "kN" }
source = "OWN"
place = "page 2"
confidence = "C"
[[figure]]
family = "own chain"
grade = "G1"
quantity = "MBL"
formula = { times = 1.4, of = "proof_load" }
source = "OWN"
place = "page 2"
confidence = "C"
[[figure]]
family = "own chain"
grade = "G2"
quantity = "MBL"
formula = { chain_load = 0.0223 }
source = "OWN"
place = "page 2"
confidence = "C"
[[figure]]
family = "own chain"
quantity = "EA"
formula = { chain_modulus = [5.4, -0.004] }
source = "OWN"
place = "page 3"
confidence = "C"
"""

SMALL_DESIGN = """
title = "A small search"
[site]
water_depth = "9.5 m"
[line]
[[line.segments]]
component = "chain stud-link U2"
diameter = "22 mm"
length = "20 m"
[[load_cases]]
name = "storm"
horizontal_force = "3 kN"
[[load_cases]]
name = "everyday"
horizontal_force = "1 kN"
kind = "reference"
[checks]
safety_factor = 3.0
[buoy]
reserve_buoyancy = "12 kN"
[design]
objectives = ["mass", "offset"]
evaluations = 100
population = 8
max_enumerated = 1000
[[design.segments]]
components = ["chain stud-link U1", "chain stud-link U2"]
diameter_min = "16 mm"
diameter_max = "26 mm"
length_min = "18 m"
length_max = "30 m"
length_step = "3 m"
[[design.clump_weights]]
masses = ["100 kg", "200 kg"]
density = "2400 kg/m^3"
positions = ["8 m"]
optional = true
[design.sinker]
mass_min = "1 t"
mass_max = "4 t"
mass_step = "1 t"
density = "2400 kg/m^3"
friction = 0.5
safety_factor = 1.5
"""

MOTION = "t,x,z\n" + "".join(f"{0.5 * k},{0.1 * (k % 5)},{0.05 * (k % 3)}\n" for k in range(60))
FORCE = "t (s),Fx (kN)\n" + "".join(f"{0.5 * k},{10.0 + k % 7}\n" for k in range(60))
SURFACE = "time (s),elevation (m)\n" + "".join(f"{0.5 * k},{0.1 * (k % 7)}\n" for k in range(60))
FLOW = "time (min),speed (m/s),direction (deg)\n0,0.5,10\n1,0.6,15\n2,0.4,20\n"
RAOS = "period,surge,surge_phase,heave\n4,0.1,10,0.1\n8,0.5,80,0.9\n16,1.0,90,1.0\n"

STATES = "height (m),period (s),share (%)\n1,5,60\n2,7,30\n3,9,10\n"
FLEET = "title,site.water_depth (m),environment.current (kn)\n#2 port,8.5,2.0\nKm 7,12.0,2.5\n"
FLEET_STUDY = """
title = "Buoys"
case = "sizing.toml"
compute = "sizing"
[[vary]]
table = "t.csv"
"""
WAMIT = {
    ".1": "".join(
        f"{t} {k} {k} {0.5 + 0.1 * k} {0.1 * k}\n" for t in (5.0, 10.0) for k in range(1, 7)
    ),
    ".3": "".join(f"{t} 0.0 {k} 1.0 0.0 1.0 0.0\n" for t in (5.0, 10.0) for k in range(1, 7)),
    ".hst": "3 3 0.5\n4 4 0.1\n5 5 0.1\n",
}

MOVING = """
title = "In motion"
[site]
water_depth = "56 m"
seabed_friction = 0.5
[line]
[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "300 m"
[load]
horizontal_force = "300 kN"
[waves]
spectrum = "jonswap"
height = "2 m"
period = "9 s"
components = 10
[current]
profile = "power"
speed = "0.4 m/s"
[motion]
period = "10 s"
surge = "0.5 m"
[dynamics]
duration = "12 s"
time_step = "0.2 s"
elements = 12
"""

BODY_IN_MOTION = (
    template("system")
    + """
[body]
mass = "100 t"
force_file = "force.csv"
[dynamics]
duration = "10 s"
elements = 8
"""
)


def _case(name: str) -> str:
    return (CASES / name).read_text("utf-8")


def _of_library(name: str) -> str:
    return (LIBRARY / name).read_text("utf-8")


def _profiles(path: Path) -> object:
    from catopt.checks.profiles import parse_profiles
    from catopt.documents import read_text

    return parse_profiles(read_text(path, str(path)), str(path))


def _numbers(path: Path) -> object:
    """Read a file of numbers as the kind that its first heading says."""
    from catopt.verify.motion_file import (
        read_current,
        read_elevation,
        read_force,
        read_motion,
        read_raos,
    )

    text = path.read_bytes()
    if b"F" in text[:40]:
        return read_force(str(path), 20.0)
    if b"elev" in text[:40]:
        return read_elevation(str(path), 20.0)
    if b"speed" in text[:40]:
        return read_current(str(path), 20.0)
    return read_raos(str(path)) if b"period" in text[:40] else read_motion(str(path), 20.0)


def _states(path: Path) -> object:
    from dataclasses import replace

    from catopt.verify.fatigue import sea_states

    case = parse_case(_case("fatigue-chain-20m/case.toml"))
    assert case.fatigue is not None
    fatigue = replace(case.fatigue, sea_states=(), sea_states_file=str(path))
    return sea_states(replace(case, fatigue=fatigue))


def _study(path: Path) -> object:
    from catopt.study.file import read_study

    return read_study(path.parent / "study.toml").axes


def _wamit(path: Path) -> object:
    from catopt.hydro.coefficient_files import read_wamit

    return read_wamit(path, ulen=1.0, density=1025.0, gravity=9.80665)


def _capytaine(path: Path) -> object:
    from catopt.hydro.coefficient_files import read_capytaine

    return read_capytaine(path)


def _form(path: Path) -> object:
    """Read a form, and what a sizing would take of it."""
    from catopt.sizing.form import read_form

    found = []
    for file in read_form(path):
        with file.reporting():
            found.append(dict(file.known().values))
    return found


@cache
def form_of_a_buoy() -> bytes:
    """Fill a form in, with two moorings in its fleet."""
    from io import BytesIO

    import openpyxl

    from catopt.sizing.form import form

    book = openpyxl.load_workbook(BytesIO(form("buoy")))
    given: dict[str, Any] = {"buoy.name": "pillar 1.8 m", "site.water_depth": 12}
    given["environment.hs"] = 4
    for row in book["Form"].iter_rows(min_row=4):
        row[1].value = given.get(f"{row[4].value}")
    keys = [cell.value for cell in book["Fleet"][3]]
    for at, depth in enumerate((9, 14), start=4):
        book["Fleet"].cell(at, 1 + keys.index("site.water_depth"), depth)
    stream = BytesIO()
    book.save(stream)
    return stream.getvalue()


@cache
def dataset_of_capytaine() -> bytes:
    """Write a small dataset as capytaine does, as netCDF 3."""
    import numpy as np
    import xarray

    dofs = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
    pairs = ("omega", "influenced_dof", "radiating_dof")
    matrix = np.tile(np.eye(6), (2, 1, 1))
    made = xarray.Dataset(
        {
            "added_mass": (pairs, 1e3 * matrix),
            "radiation_damping": (pairs, 1e2 * matrix),
            "hydrostatic_stiffness": (pairs[1:], 1e4 * np.eye(6)),
        },
        {
            "omega": [0.5, 1.0],
            "wave_direction": [0.0],
            "influenced_dof": dofs,
            "radiating_dof": dofs,
        },
    )
    return bytes(made.to_netcdf(engine="scipy"))


def _capytaines() -> tuple[Kind, ...]:
    """Give capytaine's dataset, where the package that writes it is installed."""
    if find_spec("xarray") is None:
        return ()
    text = dataset_of_capytaine().decode("latin-1")
    return (Kind("capytaine", "bytes", (text,), "hull.nc", {}, read=_capytaine),)


def _deck(path: Path) -> object:
    """Read a deck and solve its case; MAP++'s have no gravity, density and depth of their own."""
    from catopt.catenary.case import solve_case
    from catopt.decks.reading import Asked, read_deck
    from catopt.documents import read_text
    from catopt.model.network import Network
    from catopt.mooring.case import report_system

    text = read_text(path, str(path))
    of_map = Asked(gravity=9.80665, density=1025.0, depth=320.0) if "DICTIONARY" in text else None
    case = read_deck(text, str(path), of_map).case
    if isinstance(case, Network):
        return case  # what a command makes of it is for the screen of a system
    return solve_case(case) if case.system is None else report_system(case)


def _result(path: Path) -> object:
    """Read what a result directory says, as ``catopt report`` does before it computes anything."""
    from catopt.casefile.reading import read_case_or_design
    from catopt.notes.origin import asked_in, case_path

    has_front = (path.parent / "design.json").is_file()
    return asked_in(path.parent), read_case_or_design(
        path.parent if has_front else case_path(path.parent), 1 if has_front else None
    )


@cache
def _results() -> tuple[dict[str, str], dict[str, str]]:
    """Make the documents of two result directories: of a line, and of a design search."""
    from catopt.casefile import case_digest
    from catopt.catenary.case import solve_case
    from catopt.design.search import design_case
    from catopt.report.bundle import with_digest

    line = parse_case(_case("buoy-9.5m/case.toml"))
    searched = parse_case(SMALL_DESIGN)
    documents = (
        (line, "solution.json", solve_case(line).to_dict()),
        (searched, "design.json", design_case(searched).to_dict()),
    )
    made = tuple(
        {
            "case.toml": write_case(case),
            name: json.dumps(with_digest(document, case_digest(case)), indent=2) + "\n",
        }
        for case, name, document in documents
    )
    return made[0], made[1]


@cache
def kinds() -> tuple[Kind, ...]:
    """List them all."""
    line, front = _results()
    solved = ("solve", "case.toml", "--json")
    return (
        Kind(
            "line",
            "toml",
            (
                template("buoy"),
                template("leg"),
                template("tanker"),
                *(
                    _case(f"{name}/case.toml")
                    for name in ("tanker-20m-sinker", "tanker-20m-find-length")
                ),
            ),
            "case.toml",
            {},
            solved,
        ),
        Kind(
            "checks",
            "toml",
            (SMALL_DESIGN.split("[design]")[0], _case("design-tanker-20m/case.toml")),
            "case.toml",
            {},
            ("check", "case.toml", "--json"),
        ),
        Kind(
            "design",
            "toml",
            (SMALL_DESIGN, template("design"), _case("design-leg-56m/case.toml")),
            "case.toml",
            {},
            ("check", "case.toml", "--json"),
            slow=("design", "case.toml", "--json", "--evaluations", "60"),
        ),
        Kind(
            "system",
            "toml",
            (template("system"), _case("fso-rang-dong/case.toml")),
            "case.toml",
            {},
            ("system", "case.toml", "--json"),
        ),
        Kind(
            "dynamics",
            "toml",
            (MOVING, BODY_IN_MOTION, template("motion"), _case("fatigue-chain-20m/case.toml")),
            "case.toml",
            {"force.csv": FORCE, "rao.csv": RAOS},
            ("export", "case.toml", "--to", "moordyn", "--json"),
        ),
        Kind(
            "sizing of a buoy",
            "toml",
            (template("size-buoy"), _case("size-buoy/sizing.toml")),
            "sizing.toml",
            {},
            ("loads", "buoy", "sizing.toml", "--json"),
            slow=("size", "buoy", "sizing.toml", "--at-rest", "--json"),
        ),
        Kind(
            "sizing of a tanker",
            "toml",
            (template("size-tanker"), _case("size-tanker/sizing.toml")),
            "sizing.toml",
            {},
            ("loads", "ship", "sizing.toml", "--json"),
            slow=("size", "tanker", "sizing.toml", "--at-rest", "--json"),
        ),
        Kind("families", "toml", (FAMILIES,), "own.toml", {"case.toml": CATALOGUE_CASE}, solved),
        Kind(
            "buoys",
            "toml",
            (_of_library("loads/data/buoys.toml"),),
            "own.toml",
            {},
            ("loads", "buoy", "pillar 1.8 m", "--buoys", "own.toml", "--depth", "12 m", "--json"),
        ),
        Kind(
            "codes",
            "toml",
            (_of_library("checks/data/profiles.toml"),),
            "own.toml",
            {},
            read=_profiles,
        ),
        Kind(
            "table of numbers",
            "csv",
            (MOTION, FORCE, SURFACE, FLOW, RAOS),
            "m.csv",
            {},
            read=_numbers,
        ),
        Kind("sea states", "csv", (STATES,), "states.csv", {}, read=_states),
        Kind(
            "rows of a study",
            "csv",
            (FLEET,),
            "t.csv",
            {"study.toml": FLEET_STUDY, "sizing.toml": template("size-buoy")},
            read=_study,
        ),
        Kind("form", "xlsx", (form_of_a_buoy().decode("latin-1"),), "form.xlsx", {}, read=_form),
        *(
            Kind(
                f"WAMIT {end}",
                "deck",
                (WAMIT[end],),
                f"ship{end}",
                {f"ship{other}": text for other, text in WAMIT.items() if other != end},
                read=_wamit,
            )
            for end in WAMIT
        ),
        *_capytaines(),
        *(
            Kind(f"screen of {command}", "toml", texts, "case.toml", {}, (command, "case.toml"))
            for command, texts in (
                ("solve", (template("buoy"), template("leg"), template("tanker"))),
                ("check", (SMALL_DESIGN.split("[design]")[0],)),
                ("system", (template("system"), template("points"))),
            )
        ),
        Kind(
            "deck",
            "deck",
            (MOORDYN, V1, TWO_SEGMENTS, OC3_BY_MAP, ONTOLOGY, C06.split("  - Name: Loadhose")[0]),
            "deck.txt",
            {},
            read=_deck,
        ),
        Kind("solution", "json", (line["solution.json"],), "solution.json", line, read=_result),
        Kind("front", "json", (front["design.json"],), "design.json", front, read=_result),
        Kind(
            "case of a front",
            "toml",
            (front["case.toml"],),
            "case.toml",
            front,
            ("solve", ".", "--design", "1", "--json"),
        ),
    )
