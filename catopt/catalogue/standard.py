"""The catalogue that comes with catopt."""

from __future__ import annotations

from functools import cache

from catopt.catalogue.collection import Catalogue


@cache
def standard() -> Catalogue:
    """Return the catalogue that comes with catopt; it is read once."""
    from catopt.catalogue.reading import read_standard

    return read_standard()
