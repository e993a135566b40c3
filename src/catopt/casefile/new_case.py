"""Commented case files to start from."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from catopt.errors import InputError, Problem
from catopt.units import as_written

__all__ = ["TEMPLATES", "template"]

TEMPLATES: Mapping[str, str] = MappingProxyType(
    {"buoy": "marker buoy in 9.5 m of water on 20 m of chain"}
)
"""Names of the templates, each with what it is."""


def template(name: str) -> str:
    """Return a commented case file that solves as it stands.

    Parameters
    ----------
    name : str
        One of `TEMPLATES`.

    Returns
    -------
    str
        TOML.

    Raises
    ------
    InputError
        When there is no such template.
    """
    if name not in TEMPLATES:
        known = ", ".join(TEMPLATES)
        raise InputError([Problem("template", as_written(name), f"one of {known} is wanted")])
    from importlib.resources import files

    return (files(__package__) / "templates" / f"{name}.toml").read_text(encoding="utf-8")
