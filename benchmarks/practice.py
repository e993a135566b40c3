"""What catopt recommends beside what is laid: buoys of known makers, and a ship beside her cable.

    python -m benchmarks.practice [--out benchmarks/results/practice.md]

Practice is of the Sealite manual of the Nautilus-2200, page 11 (44 mm down to 32 mm of chain by
depth, two to three depths of it), of the buoys' own entries in CALMAR's library (their smallest and
largest chain), and of the equipment number of the ship; all are in the catalogue
(`catopt.catalogue.practice`). Sites are stated in full below. A buoy's chain agrees with practice
when it is within one size that is sold of the maker's and two to 3.2 depths long. The maker's own
size is sized too, at the same site: that line passes every check as well, where one is printed.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import catopt
from benchmarks.common import page
from catopt.catalogue.choice import chosen
from catopt.catalogue.practice import laid_for_buoy
from catopt.errors import CatoptError
from catopt.loads import buoys
from catopt.model import CatalogueChoice
from catopt.sizing import Sizing

CHAIN = "chain open-link 4D Q2"
SCOPE = (2.0, 3.2)
"""Depths that a buoy's chain is to be long."""


@dataclass(frozen=True)
class Site:
    """A buoy and its place; lengths in m, speeds in m/s."""

    buoy: str
    depth: float
    current: float
    hs: float
    wind: float = 25.0


TABLE = (
    Site("T-5000l-2.4m", 10.0, 1.0, 1.0),
    Site("T-5000l-2.4m", 18.0, 1.0, 1.5),
    Site("T-5000l-2.4m", 28.0, 1.0, 1.5),
)
"""Those that a maker's table is for, within 0.2 m of its buoy."""

LAID = (
    Site("T-5000l-2.4m", 20.0, 2.5, 2.0),
    Site("T-9000l-3.0m", 20.0, 1.0, 4.0),
    Site("T-9000l-3.0m", 50.0, 1.0, 4.0),
)
"""Such buoys are laid; 1.0.0 had no answer."""

OWN = (
    Site("T-1000l-1.24m", 6.0, 0.5, 0.5, 15.0),
    Site("T-1800l-1.24m", 8.0, 0.75, 0.75, 20.0),
    Site("T-2500l-1.85m", 10.0, 0.75, 1.0, 20.0),
    Site("T-5000l-2.4m", 12.0, 1.0, 1.5),
    Site("T-9000l-3.0m", 20.0, 1.0, 2.0),
    Site("LT-9000l-3.0m", 20.0, 1.0, 2.0),
    Site("SP-3200l-1.2m", 12.0, 0.75, 1.0, 20.0),
    Site("2S5PL", 20.0, 1.0, 2.0),
    Site("2S5PL +2", 20.0, 1.0, 2.0),
)
"""Every buoy of the library."""


TWENTY = (
    Site("T-1000l-1.24m", 4.0, 0.5, 0.5, 15.0),
    Site("T-1000l-1.24m", 8.0, 1.0, 0.75, 20.0),
    Site("T-1800l-1.24m", 6.0, 1.0, 0.5, 20.0),
    Site("T-1800l-1.24m", 12.0, 0.75, 1.0, 20.0),
    Site("T-2500l-1.85m", 8.0, 1.0, 1.0, 20.0),
    Site("T-2500l-1.85m", 15.0, 1.0, 1.5, 25.0),
    Site("T-2500l-1.85m", 25.0, 0.75, 2.0, 25.0),
    Site("T-5000l-2.4m", 8.0, 1.5, 1.0, 25.0),
    Site("T-5000l-2.4m", 15.0, 1.0, 2.0, 25.0),
    Site("T-5000l-2.4m", 20.0, 1.5, 2.0, 25.0),
    Site("T-5000l-2.4m", 30.0, 1.0, 2.5, 25.0),
    Site("T-5000l-2.4m", 45.0, 1.0, 3.0, 25.0),
    Site("T-9000l-3.0m", 15.0, 2.0, 2.0, 25.0),
    Site("T-9000l-3.0m", 30.0, 1.0, 3.0, 25.0),
    Site("T-9000l-3.0m", 60.0, 1.0, 4.0, 25.0),
    Site("LT-9000l-3.0m", 15.0, 1.5, 2.0, 25.0),
    Site("LT-9000l-3.0m", 40.0, 1.0, 3.0, 25.0),
    Site("2S5PL", 15.0, 1.0, 1.5, 25.0),
    Site("2S5PL", 30.0, 1.0, 3.0, 25.0),
    Site("2S5PL +2", 25.0, 2.5, 2.0, 25.0),
)
"""Depths of 4 to 60 m, currents to 2.5 m/s, seas of 0.5 to 4 m."""

SOILS = ("sand", "stiff clay", "mud")
"""On which a sinker stands beside CALMAR's, of which no soil is named."""


def main() -> None:
    """Run and print."""
    page(argparse.ArgumentParser(description=__doc__), lambda of: report(of.smoke))


def report(smoke: bool) -> Iterator[str]:
    """Yield the page; of a smoke the first site alone."""
    began = time.process_time()
    yield "# catopt beside practice"
    yield ""
    yield "## Beside a maker's table"
    yield ""
    yield from _table(TABLE[:1] if smoke else TABLE)
    if smoke:
        return
    yield ""
    yield "## Buoys that are laid"
    yield ""
    yield from _table(LAID)
    yield ""
    yield "## Every buoy of the library"
    yield ""
    yield from _table(OWN)
    yield ""
    yield "## Twenty buoys, and their sinkers by soil"
    yield ""
    yield from _twenty()
    yield ""
    yield "## A ship beside her own cable"
    yield ""
    yield from _ship()
    yield ""
    yield f"{time.process_time() - began:.0f} s of processor."


def _table(sites: tuple[Site, ...]) -> list[str]:
    rows = [
        "| buoy | depth, current, Hs, wind | catopt: chain, length, depths, sinker "
        "| own limits (mm) | practice | sizes apart | the maker's size, sized here |",
        "|---|---|---|---|---|---|---|",
    ]
    return [*rows, *(_row(site) for site in sites)]


def _twenty() -> Iterator[str]:
    """Tabulate them, and count what agrees."""
    soils = ", ".join(SOILS)
    yield (
        "| buoy | depth, current, Hs, wind | catopt: chain, length, depths, sinker "
        f"| own limits (mm) | length laid (m) | sinker on {soils} (t) |"
    )
    yield "|---|---|---|---|---|---|"
    sized_ones = in_limits = as_long = in_order = 0
    for site in TWENTY:
        shape = next(each for each in buoys() if each.name == site.buoy)
        low, high = (1e3 * (each or 0.0) for each in (shape.chain_min, shape.chain_max))
        where = f"{site.depth:g} m, {site.current:g} m/s, {site.hs:g} m, {site.wind:g} m/s"
        start = f"| {site.buoy} | {where}"
        try:
            found = sized(site)
        except CatoptError as error:
            yield f"{start} | NO ANSWER: {error.message} | {low:g} to {high:g} | | |"
            continue
        sized_ones += 1
        line = found.point.line
        in_limits += low <= round(1e3 * (line.segments[0].nominal_diameter or 0.0), 6) <= high
        laid = laid_for_buoy(shape.widest, site.depth, site.current)
        said = "no table"
        if laid is not None:
            least, most = laid.lengths
            said = f"{least:g} to {most:g}"
            as_long += 0.75 * least <= line.length <= 1.25 * most
        masses = [_sinker_on(site, soil) for soil in SOILS]
        known = [each for each in masses if each is not None]
        in_order += len(known) == len(SOILS) and known == sorted(known)
        texts = ", ".join("none" if each is None else f"{each:g}" for each in masses)
        yield f"{start} | {_said(found, site.depth)} | {low:g} to {high:g} | {said} | {texts} |"
    yield ""
    yield (
        f"Of {len(TWENTY)} sized at rest {sized_ones} have an answer: {in_limits} have a chain "
        f"within the limits of the buoy's own entry, {as_long} a length within 25 % of what the "
        f"maker of a 2.2 m buoy lays there, and of {in_order} the sinker grows as the soil gets "
        "softer (none: no sinker of 60 t and less holds). Longer are buoys whose entry ends at a "
        "thin chain. No maker's or authority's table of sinkers was read."
    )


def _sinker_on(site: Site, soil: str) -> float | None:
    """Mass of a site's sinker on a soil, t; None where there is none."""
    try:
        anchor = sized(site, soil=soil).point.anchor
    except CatoptError:
        return None
    return None if anchor is None or anchor.mass is None else anchor.mass / 1e3


def _row(site: Site) -> str:
    shape = next(each for each in buoys() if each.name == site.buoy)
    limits = f"{1e3 * (shape.chain_min or 0.0):g} to {1e3 * (shape.chain_max or 0.0):g}"
    where = f"{site.depth:g} m, {site.current:g} m/s, {site.hs:g} m, {site.wind:g} m/s"
    laid = laid_for_buoy(shape.widest, site.depth, site.current)
    practice, apart, own = "no table", "-", "-"
    try:
        found = sized(site)
    except CatoptError as error:
        return f"| {site.buoy} | {where} | NO ANSWER: {error.message} | {limits} | | | |"
    size = 1e3 * (found.point.line.segments[0].nominal_diameter or 0.0)
    if laid is not None:
        low, high = laid.lengths
        practice = f"{1e3 * laid.chain:g} mm, {low:g} to {high:g} m ({laid.buoy_diameter:g} m buoy)"
        apart = f"{sizes_apart(size, 1e3 * laid.chain)}"
        own = _own(site, 1e3 * laid.chain)
    return (
        f"| {site.buoy} | {where} | {_said(found, site.depth)} | {limits} | {practice} | {apart} "
        f"| {own} |"
    )


def sized(site: Site, **more: Any) -> Sizing:
    """Size a buoy at its site."""
    return catopt.size_buoy(
        site.buoy,
        depth=site.depth,
        current=site.current,
        hs=site.hs,
        wind=site.wind,
        chain=CHAIN,
        **more,
    )


def _said(of: Sizing, depth: float) -> str:
    line, anchor = of.point.line, of.point.anchor
    size = 1e3 * (line.segments[0].nominal_diameter or 0.0)
    assert anchor is not None
    assert anchor.mass is not None
    fails = "" if of.point.checks.passes else " FAILS"
    scope = f"{line.length / depth:.2f}"
    return f"{size:g} mm, {line.length:g} m, {scope}, {anchor.mass / 1e3:g} t{fails}"


def _own(site: Site, size: float) -> str:
    """Size the next size sold up to a maker's own, at the same site."""
    near = min(SIZES, key=lambda each: (abs(each - size), each)) * 1e-3
    try:
        found = sized(site, diameter_min=near, diameter_max=near)
    except CatoptError:
        return f"{1e3 * near:g} mm: no length of it"
    return _said(found, site.depth)


def _sizes() -> tuple[float, ...]:
    sold = chosen(CatalogueChoice(), 1025.0).sold(CHAIN)
    return tuple(round(1e3 * each.nominal_diameter, 6) for each in sold)


SIZES = _sizes()
"""mm, of the chain that buoys are sized with."""


def sizes_apart(one: float, other: float) -> int:
    """Count the steps of the series between two sizes, mm, each at its nearest one sold."""
    places = [min(range(len(SIZES)), key=lambda k: abs(SIZES[k] - each)) for each in (one, other)]
    return abs(places[0] - places[1])


def _ship() -> list[str]:
    found = catopt.size_tanker(dwt="50000 t", depth="20 m")
    line = found.point.line
    assert found.drag_anchor is not None
    return [
        f"- tanker of 50,000 DWT in 20 m: {line.segments[0].name}, {line.length:g} m, anchor of "
        f"{found.drag_anchor.mass / 1e3:g} t ({found.drag_anchor.anchor}), every check passes: "
        f"{found.point.checks.passes}",
        f"- {found.practice}",
    ]


if __name__ == "__main__":
    main()
