"""Chain, wire and fibre rope by nominal diameter, every figure with source and confidence.

Confidence is A (read in the primary or official document), B (in two independent secondary
sources, or in one and checked by numbers), C (in one secondary source) or R (recalled, read in no
document; used only when asked for). Diameters are nominal and in m; all else is SI.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from catopt.catalogue.collection import ALL, NO_VARIANTS, Catalogue
from catopt.catalogue.components import (
    Alternative,
    Component,
    Figure,
    Hydrodynamic,
    Provenance,
    Source,
)
from catopt.catalogue.family import ComponentName, Family, Sizes
from catopt.catalogue.finding import search, standard
from catopt.constants import SEA_WATER_DENSITY

__all__ = [
    "ALL",
    "Alternative",
    "Catalogue",
    "Component",
    "ComponentName",
    "Family",
    "Figure",
    "Hydrodynamic",
    "Provenance",
    "Sizes",
    "Source",
    "component",
    "families",
    "parse_name",
    "read_families",
    "search",
    "standard",
]


def families(among: Catalogue | None = None) -> tuple[Family, ...]:
    """List the families of a catalogue, catopt's own unless another is given."""
    return (among or standard()).families


def component(
    family: str,
    diameter: float | str,
    *,
    grade: str | None = None,
    variants: Mapping[str, str] = NO_VARIANTS,
    water_density: float | str = SEA_WATER_DENSITY,
    allow_recalled: bool = False,
    among: Catalogue | None = None,
) -> Component:
    """Look a component up, with the source and the confidence of every figure.

    Parameters
    ----------
    family : str
        A family, with or without its grade: ``"chain studless"``, ``"chain studless R3"``.
    diameter : float
        Nominal diameter, m: of the bar of a chain's links, or of the rope as sold; text with its
        unit, ``"76 mm"``, is read. Any within the range of the family, whether or not it is a size
        that is sold.
    grade : str, optional
        When it is not in the name.
    variants : mapping of str to str, optional
        Where sources disagree, which one to follow: ``{"EA": "orcaflex"}`` by quantity, or
        ``{"all": "orcaflex"}`` for every quantity that has a variant of that name.
    water_density : float
        For the submerged weight, kg/m3.
    allow_recalled : bool
        Whether figures that were read in no document (confidence R) may be used.
    among : Catalogue, optional
        Instead of catopt's own.

    Raises
    ------
    InputError
        With every problem: no such family, grade or variant, or a diameter outside the range in
        which its figures hold.

    Examples
    --------
    >>> import catopt
    >>> chain = catopt.component("chain studless R3", "76 mm")
    >>> f"{chain.mass:.1f} kg/m, {chain.MBL / 1e3:.0f} kN"
    '115.5 kg/m, 4884 kN'
    """
    return (among or standard()).component(
        family,
        diameter,
        grade=grade,
        variants=variants,
        water_density=water_density,
        allow_recalled=allow_recalled,
    )


def parse_name(name: object, among: Catalogue | None = None) -> ComponentName:
    """Read the name of a component: ``"chain studless R3"`` is ``("chain studless", "R3")``.

    Capitals, hyphens and the order of the words do not matter; the grade is None when the name has
    none.

    Raises
    ------
    InputError
        There is none of that name; the message gives the nearest.
    """
    return (among or standard()).parse_name(name)


def read_families(path: str | os.PathLike[str]) -> Catalogue:
    """Read a user's own families, in the format of catopt's own data files, TOML in UTF-8.

    Its figures may name catopt's sources beside their own. The catalogue has those families alone;
    ``standard().with_families(...)`` joins them to catopt's.

    Raises
    ------
    InputError
        When the file cannot be read, or with every problem of what it says, by key path.
    """
    from catopt.catalogue import reading

    known = {s.key: s for f in standard().families for figure in f.figures for s in figure.sources}
    return reading.read_families(path, known)
