"""Changes of single values, units, keys and rows, none of which may change nothing in silence.

Each takes a file, or an array, as it should be, and changes one thing of it that means something.
What is read of the changed one has to differ from what is read of the first, or is refused.
"""

from __future__ import annotations

import io
import math
import random
import re
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

import numpy as np

from catopt.casefile import parse_case, template, write_case
from catopt.errors import CatoptError, InputError
from tests.fuzz.kinds import FLEET, FLOW, FORCE, MOTION, RAOS, STATES, SURFACE, Kind, kinds

__all__ = ["KINDS", "silent"]

UNITS = ("m", "cm", "ft", "km", "s", "min", "kN", "N", "tf", "kn", "m/s", "deg", "rad", "%", "kg")
HEADS = ("t", "x", "y", "time", "speed", "period", "surge", "title", "share", "height", "q")

Change = Callable[[random.Random], tuple[object, Callable[[], object]]]
"""Makes what is read as it should be, and what reads the changed one."""


def silent(kind: str, number: int, seed: int) -> str:
    """Make one change; returns what was changed where it changed nothing in silence, else ''."""
    rng = random.Random(f"{kind} {seed} {number}")
    before, read, said = KINDS[kind](rng)
    try:
        after = read()
    except InputError:
        return ""
    except CatoptError as error:
        return f"{said}: {type(error).__name__}"
    return said if _same(before, after) else ""


def _same(before: Any, after: Any) -> bool:
    """Whether two things that were read are the same in every number and word."""
    return bool(_plain(before) == _plain(after))


def _plain(value: Any) -> Any:
    """Take a value apart into numbers and words."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if isinstance(value, str | int | float | bool | complex | type(None)):
        return value
    return [_plain(each) for each in vars(value).values()] if hasattr(value, "__dict__") else value


# ------------------------------------------------------------------ tables


def _kind(name: str) -> Kind:
    return next(each for each in kinds() if each.name == name)


def _read(kind: Kind, data: bytes) -> object:
    """Read a file of a kind, with what stands beside it."""
    assert kind.read is not None
    with TemporaryDirectory() as folder:
        for name, text in kind.beside.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        path = Path(folder) / kind.file
        path.write_bytes(data)
        return kind.read(path)


def _table(kind: str, text: str) -> Callable[[random.Random], Any]:
    def change(rng: random.Random) -> Any:
        rows = [line.split(",") for line in text.strip().split("\n")]
        k, j = rng.randrange(len(rows[0])), rng.randrange(1, len(rows))
        way = rng.randrange(5)
        if way == 0:  # the unit of a heading
            name, _, unit = rows[0][k].partition("(")
            other = rng.choice([each for each in UNITS if f"{each})" != unit])
            rows[0][k] = f"{name.strip()} ({other})"
        elif way == 1:  # the name of a heading
            name, mark, unit = rows[0][k].partition("(")
            rows[0][k] = rng.choice([h for h in HEADS if h != name.strip()]) + mark + unit
        elif way == 2:  # a cell
            rows[j][k] = rng.choice(("7.25", "1_0", "#N/A", "x", "1e308", "-3.5", "1e-3"))
        elif way == 3:  # a row that begins with #
            rows[j][0] = "#" + rows[j][0]
        elif k or kind != "rows of a study":  # a row is gone
            del rows[j]
        changed = "\n".join(",".join(row) for row in rows) + "\n"
        said = f"{kind}: {rows[0]} {rows[min(j, len(rows) - 1)]}, way {way}"
        if changed.split() == text.split():
            return None, lambda: 0, said
        if way == 0 and _means_the_same(text, changed):
            return None, lambda: 0, said
        read = _kind(kind)
        return _read(read, text.encode()), lambda: _read(read, changed.encode()), said

    return change


def _means_the_same(text: str, changed: str) -> bool:
    """Whether a heading without a unit got the one that it has anyway; m and zero are no change."""
    bare = {"t": "s", "x": "m", "y": "m", "z": "m", "period": "s", "surge_phase": "deg"}
    for old, new in zip(
        text.split("\n")[0].split(","), changed.split("\n")[0].split(","), strict=True
    ):
        if old != new and bare.get(old.strip()) == new.partition("(")[2].rstrip(")"):
            return True
    return False


# ------------------------------------------------------------------ forms


def _form(rng: random.Random) -> Any:
    import openpyxl

    kind = _kind("form")
    data = kind.data(kind.texts[0])
    book = openpyxl.load_workbook(io.BytesIO(data))
    form, fleet = book["Form"], book["Fleet"]
    filled = [row for row in form.iter_rows(min_row=4) if row[1].value is not None]
    row, way = rng.choice(filled), rng.randrange(8)
    keys = [each[4].value for each in form.iter_rows(min_row=4)]
    column = next(c for c in fleet[3] if c.value == "site.water_depth").column
    if way == 0:  # a key
        row[4].value = rng.choice((*keys, None, "", f"{row[4].value}x", 5))
    elif way == 1:  # a value, of what the fleet does not give itself
        row[1].value = rng.choice(("pillar 2.4 m", 3.5, "3,5", True, "x"))
    elif way == 2:  # a unit
        row[2].value = rng.choice((*UNITS, None, "furlong"))
    elif way == 3:
        fleet.cell(3, column).value = rng.choice((*keys, None, "site.water_dpth"))
    elif way == 4:
        fleet.cell(2, column).value = f"Depth ({rng.choice(UNITS)})"
    elif way == 5:
        fleet.cell(rng.choice((4, 5)), column).value = rng.choice((11, "11", "x", None))
    elif way == 6:
        form.cell(rng.choice((4, 30, 200, 9000)), rng.choice((6, 9, 40))).value = 5
    else:
        book.create_sheet("Fleet (2)")["B5"] = rng.choice((5, "x"))
    stream = io.BytesIO()
    book.save(stream)
    said = f"form: way {way}, row {row[0].row}: {[cell.value for cell in row]}"
    same = _values(data) == _values(stream.getvalue())
    given_by_fleet = way in (1, 2) and row[4].value == "site.water_depth"
    if same or given_by_fleet or (way == 4 and "(m)" in f"{fleet.cell(2, column).value}"):
        return None, lambda: 0, said
    return _read(kind, data), lambda: _read(kind, stream.getvalue()), said


def _values(data: bytes) -> object:
    import openpyxl

    book = openpyxl.load_workbook(io.BytesIO(data))
    return {
        sheet.title: {c.coordinate: c.value for r in sheet for c in r if c.value not in (None, "")}
        for sheet in book
    }


# ------------------------------------------------------------------ case files, coefficients


_MEASURE: Final = re.compile(r'((?!-?0+(?:\.0+)? )(?<=")-?[\d.]+) [a-zA-Z/^0-9]+"')
"""Number and unit of a text; zero is the same in any."""


def _case(rng: random.Random) -> Any:
    """Change a number, a unit or a key of a case file; all of them are read or refused."""
    text = template(rng.choice(("buoy", "tanker", "leg", "system", "motion")))
    lines = text.split("\n")
    places = [k for k, line in enumerate(lines) if re.match(r"\s*\w+ = ", line)]
    k, way = rng.choice(places), rng.randrange(3)
    before = lines[k]
    head, _, rest = before.partition(" = ")
    value, mark, comment = rest.partition("#")
    number = re.search(r"\d+\.?\d*", value)
    if way == 0 and number:
        value = value[: number.start()] + f"{float(number[0]) * 1.5 + 1:g}" + value[number.end() :]
    elif way == 1 and _MEASURE.search(value):
        value = _MEASURE.sub(rf'\1 {rng.choice(UNITS)}"', value, count=1)
    else:
        head += rng.choice("xs")
    lines[k] = f"{head} = {value}{mark}{comment}"
    said = f"case: {before.strip()} -> {lines[k].strip()}"
    if lines[k] == before:
        return None, lambda: 0, said
    changed = "\n".join(lines)
    # Motion files stand beside nothing here: what a case says is compared as it is written.
    return write_case(parse_case(text)), lambda: write_case(parse_case(changed)), said


def _coefficients(rng: random.Random) -> Any:
    kind = _kind(f"WAMIT {rng.choice(('.1', '.3', '.hst'))}")
    rows = [line.split() for line in kind.texts[0].strip().split("\n")]
    j = rng.randrange(len(rows))
    k = rng.randrange(len(rows[j]))
    before = rows[j][k]
    if rng.random() < 0.2:
        del rows[j]
    else:
        rows[j][k] = rng.choice(("7.25", "2", "1_0", "x", "1e308", "-3.5"))
        if float(before) == _number(rows[j][k]):
            return None, lambda: 0, "the same"
    changed = "\n".join(" ".join(row) for row in rows) + "\n"
    said = f"{kind.name}: row {j + 1}, column {k + 1}: {before}"
    return _read(kind, kind.texts[0].encode()), lambda: _read(kind, changed.encode()), said


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return float("nan")


# ------------------------------------------------------------------ arrays


def _array(rng: random.Random) -> Any:
    """Give one force of two in another unit, or as what is no force."""
    import pandas as pd
    import pint
    import xarray as xr

    from catopt import Line, Segment, solve_many

    line = Line([Segment(20, 93.163, EA=8e7)])
    u = _REGISTRY.setdefault("units", pint.UnitRegistry())
    plain = np.array([3000.0, 3363.68])
    unit = rng.choice(("kN", "MN", "kgf", "m", "kg", "s", "N*m"))
    ways: dict[str, Any] = {
        "pint": plain * u.Unit(unit),
        "list of pint": [each * u.Unit(unit) for each in plain],
        "object array": np.array([each * u.Unit(unit) for each in plain], dtype=object),
        "text": [f"{each} {unit}" for each in plain],
        "text array": np.array([f"{each} {unit}" for each in plain]),
        "xarray": xr.DataArray(plain, attrs={"units": unit}),
        "masked": np.ma.array(plain, mask=[rng.random() < 0.5, True]),
        "booleans": plain > 3100.0,
        "series of booleans": pd.Series(plain > 3100.0),
        "dates": pd.to_datetime(plain, unit="s"),
        "durations": pd.to_timedelta(plain, unit="s"),
        "complex": plain + 1j,
        "missing": pd.Series([3000.0, None]),
        "nullable": pd.Series([3000.0, None], dtype="Float64"),
        "none": [3000.0, None],
        "categories": pd.Series(plain).astype("category").cat.codes.astype(bool),
        "changed": plain * np.array([1.0, 1.01]),
    }
    name = rng.choice(sorted(ways))

    def spans(force: Any) -> object:
        # A unit such as MN takes the line beyond what is solved: marked, and no span.
        return solve_many(line, height=9.5, horizontal_force=force).span.tolist()

    return spans(plain), lambda: spans(ways[name]), f"array: {name} in {unit}"


_REGISTRY: dict[str, Any] = {}

KINDS: dict[str, Callable[[random.Random], Any]] = {
    "motion": _table("table of numbers", MOTION),
    "force": _table("table of numbers", FORCE),
    "surface": _table("table of numbers", SURFACE),
    "current": _table("table of numbers", FLOW),
    "fairlead": _table("table of numbers", RAOS),
    "sea states": _table("sea states", STATES),
    "rows of a study": _table("rows of a study", FLEET),
    "form": _form,
    "case": _case,
    "coefficients": _coefficients,
    "array": _array,
}


def campaign(count: int, seed: int, seconds: float = math.inf) -> tuple[Counter[str], list[str]]:
    """Make so many changes, the kinds in turn; returns how many of each, and the silent ones.

    None is begun after so many seconds.
    """
    until = time.monotonic() + seconds
    names = list(KINDS)
    made: Counter[str] = Counter()
    faults = []
    for number in range(count):
        if time.monotonic() > until:
            break
        name = names[number % len(names)]
        made[name] += 1
        try:
            said = silent(name, number, seed)
        except Exception as error:  # a fault of catopt's own, or of this campaign
            said = f"{name} {number}: {type(error).__name__}: {error}"
        if said:
            faults.append(f"number {number}, {said}")
    return made, faults
