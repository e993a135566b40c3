"""Reads the open sources of the catalogue again and compares every entry with them.

``python -m tests.catalogue.reread DIR`` looks in a folder for clones of the repositories that
`PLACES` names (``owner+name``, a work tree or a bare one), compares, and writes what it found to
``verdicts.toml``, from which ``python -m tests.catalogue.page`` makes the table of the page. A
source that is not at hand leaves its verdicts as they were. It ends with status 1 where an entry
contradicts a source.

A verdict is of one entry by one source: ``agrees`` within the digits printed, or ``differs``, which
a test refuses. The entry's value is kept with it, so that a changed figure asks to be read again.
"""

from __future__ import annotations

import ast
import csv
import io
import math
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from catopt import catalogue
from catopt.catalogue.components import Figure
from catopt.catalogue.fittings import anchor_types, fittings
from catopt.catalogue.formula import (
    ChainLoad,
    ChainModulus,
    Coefficient,
    Constant,
    Density,
    MeanLoad,
    Multiple,
    Polynomial,
    Rows,
)
from catopt.constants import STANDARD_GRAVITY

VERDICTS = Path(__file__).with_name("verdicts.toml")

PLACES = {
    "CALCH": (
        "IALA-CALMAR+CALMAR", "70235bf8731c3666a06f238ab2f0a469ec46d6a6",
        "Application Files/Calmar_0_2_4_7/WorkingDirectory/Chains.xmlMB",
    ),
    "DTO": ("DTOcean+dtocean-moorings", "HEAD", "sample_data/dummycompdb.txt"),
    "VRY": ("Chris-Wave+Selkie-MooringV2", "HEAD", "src/autoSolver/data/MoorLine.csv"),
    "VRY chain": ("Chris-Wave+Selkie-MooringV2", "HEAD", "src/autoSolver/data/VrhofTable.csv"),
    "MP": ("NREL+MoorPy", "HEAD", "moorpy/library/MoorProps_default.yaml"),
    "MPCOST": ("NREL+MoorPy", "HEAD", "moorpy/library/MoorProps_newCosts.yaml"),
    "MPO": ("NREL+MoorPy", "HEAD", "moorpy/MoorProps.py"),
    "DDJ": ("ddjokic+Mooring-Line-Properties", "HEAD", "moorchain.py"),
    "DDJR": ("ddjokic+Mooring-Line-Properties", "HEAD", "moorwire.py"),
    "BEM": ("BEMRosetta+BEMRosetta", "HEAD", "BEMRosetta/toolsWaveInfo.cpp"),
}  # fmt: skip
"""Where a source is read: clone, commit, file."""

TF = 1e3 * STANDARD_GRAVITY


@dataclass(frozen=True)
class Entry:
    """One figure of the catalogue, or one row of a fitting or an anchor."""

    name: str
    sources: tuple[str, ...]
    confidence: str
    origins: int
    values: tuple[float, ...]
    """What it says, in the order in which its formula has it: changed, it is read again."""


def entries() -> Iterator[Entry]:
    """List every entry, in the order of the files."""
    for family in catalogue.families():
        for figure in family.figures:
            name = " / ".join(
                part
                for part in (family.name, figure.quantity, ",".join(figure.grades), figure.variant)
                if part
            )
            sources = tuple(source.key for source in figure.sources)
            yield Entry(name, sources, figure.confidence, len(figure.origins), _values(figure))
    for kind in anchor_types():
        keys = tuple(s.key for s in kind.sources)
        yield Entry(f"{kind.name} / masses", keys, kind.confidence, 1, kind.masses)
        for of in kind.holdings:
            keys = tuple(s.key for s in of.sources)
            values = (of.capacity, of.of_mass, of.exponent)
            name = f"{kind.name} / holding / {of.soil} / {of.data}"
            yield Entry(name, keys, of.confidence, 1, values)
    for name in dict.fromkeys(each.name for each in fittings()):
        own = [each for each in fittings() if each.name == name]
        loads = tuple(v for e in own for v in (e.size, e.MBL, e.proof_load or 0.0, e.mass or 0.0))
        keys = tuple(s.key for s in own[0].sources)
        yield Entry(f"{name} / sizes", keys, own[0].confidence, len(keys), loads)


def _values(figure: Figure) -> tuple[float, ...]:
    match figure.formula:
        case Polynomial(terms):
            return tuple(v for term in terms for v in term)
        case Rows(diameters, values):
            return (*diameters, *values)
        case ChainLoad(c) | Density(c) | Constant(c):
            return (c,)
        case ChainModulus(a, b) | MeanLoad(a, b):
            return (a, b)
        case Multiple(factor, _):
            return (factor,)
        case Coefficient(c, ratio, _):
            return (c, ratio or 0.0)


# ------------------------------------------------------------------ what a source prints


def _yaml(text: str) -> dict[str, dict[str, float]]:
    """Read the two levels of MoorPy's files that the catalogue uses."""
    found: dict[str, dict[str, float]] = {}
    kind = ""
    for line in text.splitlines():
        head = re.match(r"  ([\w-]+)\s*:\s*(#.*)?$", line)
        own = re.match(r"    (\w+)\s*:\s*([-+.\deE]+)", line)
        if head:
            kind = head[1]
        elif own and kind:
            found.setdefault(kind, {})[own[1]] = float(own[2])
    return found


_MP_KINDS = {
    "chain stud-link": "chain_studlink", "chain studless": "chain", "wire spiral-strand": "wire",
    "polyester": "polyester", "polyester 8-strand": "polyester", "nylon": "nylon", "HMPE": "hmpe",
}  # fmt: skip


def _of_moorpy(text: str, entry: Entry) -> list[tuple[float, float]]:
    """Pairs of what the catalogue and what MoorPy's file has."""
    family, quantity, *_ = entry.name.split(" / ")
    of = _yaml(text).get(_MP_KINDS.get(family, ""), {})
    if family.startswith("chain") and quantity == "price" and "R3" in entry.name.split(" / "):
        of = _yaml(text).get("chainR3", {})
    v = entry.values
    if not of:
        return []
    match quantity:
        case "mass" | "MBL" | "price" | "EA" if len(v) in (2, 4):
            keys = [
                f"{_KEYS[quantity]}_d{int(n)}" if n > 1 else f"{_KEYS[quantity]}_d" for n in v[::2]
            ]
            return [(c, of[key]) for key, c in zip(keys, v[1::2], strict=True) if key in of]
        case "EA" if len(v) == 1 and "EA_MBL" in of:
            return [(v[0], of["EA_MBL"])]
        case "EA_dynamic":
            return [(v[0], of["EAd_MBL"]), (v[1], of["EAd_MBL_Lm"])]
        case "price" if len(v) == 1:
            key = "cost_MBL" if "cost_MBL" in of else "cost_mass"
            return [(v[0], of[key])] if key in of else []
        case "volume_diameter" if family in ("polyester", "polyester 8-strand", "nylon", "HMPE"):
            return [(v[0], of["density"])]
        case "volume_diameter" if len(v) == 2 and "dvol_dnom" in of:
            return [(v[1], of["dvol_dnom"])]
        case "added_mass_normal" | "added_mass_axial":
            return [(v[0], of["Ca" if quantity.endswith("normal") else "Ca_ax"])]
    return []


_KEYS = {"mass": "mass", "MBL": "MBL", "price": "cost", "EA": "EA"}


def _of_calmar(text: str, entry: Entry) -> list[tuple[float, float]]:
    family, quantity, *rest = entry.name.split(" / ")
    kind = "Stud" if family == "chain stud-link" else family.removeprefix("chain open-link ")
    column = {"mass": "MasseLin"}.get(quantity)
    if (quantity == "proof_load" and "calmar" in rest) or family.endswith("9D"):
        grade = rest[0][-1] if rest and rest[0][0] in "QU" else "1"
        column = column or (f"Q{grade}_CE" if quantity == "proof_load" else None)
    if column is None or len(entry.values) < 8:
        return []
    printed = {
        float(m[1].replace(",", ".")): float(m[2])
        for m in re.finditer(
            rf'Type="{re.escape(kind)}" DN="([\d,]+)"[^>]*?{column}="([\d.]+)"', text
        )
    }
    half = len(entry.values) // 2
    unit = 1.0 if quantity == "mass" else TF
    return [
        (value, printed[round(d * 1e3, 6)] * unit)
        for d, value in zip(entry.values[:half], entry.values[half:], strict=True)
    ]


def _database(text: str) -> list[dict[str, Any]]:
    return list(ast.literal_eval(text).values())


_DTO_ANCHORS = {
    "stockless": "Navy Stockless", "stockless, fixed flukes": "Navy Stockless",
    "Danforth, LWT, AC-14": "Danforth", "Stevin": "Stevin Mk3",
}  # fmt: skip


def _of_dtocean(text: str, entry: Entry) -> list[tuple[float, float]]:
    rows = _database(text)
    name, what, *rest = entry.name.split(" / ")
    v = entry.values
    if what in ("masses", "holding"):
        own = [r for r in rows if r["item3"] == _DTO_ANCHORS.get(name, name)]
        if what == "masses":
            return list(zip(v, sorted({r["item7"][0] for r in own}), strict=True))
        holds = own[0]["item9"]["soft" if rest[0] == "soft clay" else "sand"]
        return [(v[0], holds[0] * TF), (v[2], holds[1])]
    if what == "sizes":
        kind = "Bow shackle safety" if name == "bow shackle" else "swivel"
        by_size = {round(r["item6"][0] * 1e3, 1): r for r in rows if r["item3"] == kind}
        pairs = []
        for size, load, _, mass in zip(*(v[k::4] for k in range(4)), strict=True):
            row = by_size[round(size * 1e3, 1)]
            pairs.append((load, row["item5"][0]))
            if mass:
                pairs.append((mass, row["item7"][0]))
        return pairs
    if what in ("mass", "MBL") and len(v) > 8:
        kind = "hmpe" if name == "HMPE" else name
        of_size = {
            round(r["item6"][0], 6): (r["item7"][0], r["item5"][0])
            for r in rows
            if r["item2"] == "rope" and r["item4"][0] == kind
        }
        half, column = len(v) // 2, 0 if what == "mass" else 1
        return [(b, of_size[round(a, 6)][column]) for a, b in zip(v[:half], v[half:], strict=True)]
    return []


def _of_vryhof(text: str, entry: Entry) -> list[tuple[float, float]]:
    name, what, *rest = entry.name.split(" / ")
    v = entry.values
    table = list(csv.reader(io.StringIO(text)))[1:]
    if name == "polyester" and what in ("mass", "MBL") and len(v) > 8:
        own = {round(float(r[0]), 6): float(r[1 if what == "mass" else 3]) for r in table}
        half = len(v) // 2
        return [(b, own[round(a, 6)]) for a, b in zip(v[:half], v[half:], strict=True)]
    if name == "polyester" and what == "EA":
        column = {"moorline-10": 5, "moorline-20": 6}.get(rest[-1], 8)
        return [(v[0], float(r[column]) / float(r[3])) for r in table]
    return []


_VRY_COLUMNS = {"R4": 1, "R3S": 2, "R3": 3, "ORQ": 4, "R5": 5}


def _of_vryhof_chain(text: str, entry: Entry) -> list[tuple[float, float]]:
    name, what, *rest = entry.name.split(" / ")
    table = list(csv.reader(io.StringIO(text)))[1:]
    pairs = []
    for row in table:
        d = float(row[0])
        if what == "MBL" and rest and rest[0] in _VRY_COLUMNS:
            if (rest[0], d) == ("R5", 0.132):
                continue  # a misprint, as the entry says
            load = ChainLoad(entry.values[0]).value(d, lambda _: 0.0)
            pairs.append((load, float(row[_VRY_COLUMNS[rest[0]]])))
        if what == "mass" and len(entry.values) == 2 and d > 0.04:
            printed = float(row[6 if name == "chain stud-link" else 7])
            pairs.append((entry.values[1] * d**2, printed))
    return pairs


def _numbers(text: str) -> set[float]:
    """Every number that a program has: what it prints is compared with what the catalogue has."""
    return {float(n) for n in re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?:[eE]\d+)?", text)}


def _in_program(text: str, entry: Entry) -> list[tuple[float, float]]:
    """Look for each number of an entry among those of a program, which is in kN, t and mm or m."""
    printed = _numbers(text) - {0.0}
    pairs = []
    for value in _coefficients(entry):
        scaled = [n * 10.0**k for n in printed for k in range(-7, 11)]
        near = min(scaled, key=lambda n: abs(n / value - 1.0))
        pairs.append((value, near))
    return pairs


def _coefficients(entry: Entry) -> list[float]:
    """List what is looked up of an entry: of a polynomial its coefficients, without the powers."""
    v = entry.values
    quantity = entry.name.split(" / ")[1]
    if quantity in ("mass", "MBL", "price", "EA", "volume_diameter") and len(v) in (2, 4):
        if quantity == "EA" and v[0] > 5.0:
            return [abs(each) for each in v if each]  # modulus: a and b
        return [abs(each) for each in v[1::2]]
    if quantity.startswith(("drag", "added_mass")):
        return [v[0]]
    return [abs(each) for each in v if each]


Reader = Callable[[str, Entry], list[tuple[float, float]]]

READERS: dict[str, Reader] = {
    "CALCH": _of_calmar, "DTO": _of_dtocean, "VRY": _of_vryhof, "VRY chain": _of_vryhof_chain,
    "MP": _of_moorpy, "MPCOST": _of_moorpy, "MPO": _in_program, "DDJ": _in_program,
    "DDJR": _in_program, "BEM": _in_program,
}  # fmt: skip

CLOSE = {"VRY chain": 0.013, "VRY": 0.006}
"""How near is near, by the digits printed, such as whole kg of 42 mm chain; else 0.05 %."""

ROUNDED = {"chain stud-link / MBL / U2 / formula", "chain stud-link / MBL / U3 / formula"}
"""Entries of which MPO has three digits printed: 0.3 %."""


def text_of(folder: Path, key: str) -> str | None:
    """Read a source from its clone; None where that is not at hand."""
    clone, commit, file = PLACES[key]
    for place in (folder / clone, folder / clone / "repo", folder / clone / "repo" / ".git"):
        run = subprocess.run(
            ["git", "-C", str(place), "show", f"{commit}:{file}"], capture_output=True, check=False
        )
        if run.returncode == 0:
            return run.stdout.decode("utf-8", "replace")
    return None


def near(entry: Entry, key: str) -> float:
    """Give how far an entry may be from what a source prints."""
    return 0.003 if key == "MPO" and entry.name in ROUNDED else CLOSE.get(key, 5e-4)


def compare(folder: Path) -> dict[tuple[str, str], str]:
    """Give a verdict on every entry by every source of it that is at hand."""
    texts = {key: text for key in READERS if (text := text_of(folder, key)) is not None}
    found = {}
    for entry in entries():
        for key in entry.sources:
            keys = [key, "VRY chain"] if key == "VRY" else [key]
            pairs = [
                (mine, printed, near(entry, k))
                for k in keys
                if k in texts
                for mine, printed in READERS[k](texts[k], entry)
            ]
            if pairs:
                off = [abs(m / p - 1.0) for m, p, most in pairs if abs(m / p - 1.0) > most]
                worst = f"differs by {100 * max(off):.2g} %" if off else "agrees"
                found[entry.name, key] = f"{worst} ({len(pairs)})"
    return found


def read_verdicts() -> dict[tuple[str, str], tuple[str, list[float]]]:
    """Read the verdicts that were written, with the values that they are of."""
    document = tomllib.loads(VERDICTS.read_text("utf-8"))
    return {
        (each["entry"], each["source"]): (each["verdict"], each["values"])
        for each in document["verdict"]
    }


def write(found: dict[tuple[str, str], str]) -> None:
    """Write the verdicts, those of sources that were not at hand as they were."""
    old = read_verdicts() if VERDICTS.exists() else {}
    lines = [
        "# Made by python -m tests.catalogue.reread: what each open source says of each entry."
    ]
    for entry in entries():
        for key in entry.sources:
            verdict = found.get((entry.name, key)) or old.get((entry.name, key), ("",))[0]
            if verdict:
                lines += [
                    "", "[[verdict]]", f'entry = "{entry.name}"', f'source = "{key}"',
                    f'verdict = "{verdict}"', f"values = {fingerprint(entry)}",
                ]  # fmt: skip
    VERDICTS.write_text("\n".join(lines) + "\n", "utf-8")


def fingerprint(entry: Entry) -> list[float]:
    """Bring the values of an entry to three numbers that change with any of them."""
    v = entry.values
    # By fsum: the digits of sum are others from Python 3.12 on.
    weighed = math.fsum(each * (k + 1) for k, each in enumerate(v))
    return [float(len(v)), float(f"{math.fsum(v):.12g}"), float(f"{weighed:.12g}")]


if __name__ == "__main__":
    verdicts = compare(Path(sys.argv[1]))
    write(verdicts)
    wrong = {pair: said for pair, said in verdicts.items() if said.startswith("differs")}
    for (name, source), said in wrong.items():
        sys.stdout.write(f"{name}: {source} {said}\n")
    sys.stdout.write(f"{len(verdicts)} comparisons, {len(wrong)} differ\n")
    sys.exit(1 if wrong else 0)
