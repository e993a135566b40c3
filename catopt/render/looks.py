"""How what has a role looks in a drawing: one table (looks.toml), for every renderer."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from importlib.resources import files
from typing import Any, NamedTuple


class Look(NamedTuple):
    """How a role looks; what the fields are is said in the table."""

    stroke: str = ""
    width: float = 1.0
    dash: tuple[float, ...] = ()
    fill: str = ""
    opacity: float = 1.0
    sign: str = ""
    size: float = 6.0


_TABLE = tomllib.loads(files(__package__).joinpath("looks.toml").read_text("utf-8"))

COLOURS: Mapping[str, tuple[str, str]] = {
    name: (light, dark) for name, (light, dark) in _TABLE["colours"].items()
}
"""Each colour on light paper and on dark."""
SIGNS: Mapping[str, Mapping[str, Any]] = _TABLE["signs"]
"""Each sign, as every renderer draws it."""
LOOKS: Mapping[str, Look] = {role: Look(**look) for role, look in _TABLE["looks"].items()}
"""The look of each role."""


def stylesheet() -> str:
    """Write the looks as CSS, in light and in dark colours."""
    return "\n".join(_rules()) + "\n"


def _rules() -> Iterator[str]:
    light, dark = (
        "".join(f"--{name}:{pair[index]};" for name, pair in COLOURS.items()) for index in (0, 1)
    )
    yield f":root{{{light}}}"
    yield f"@media screen and (prefers-color-scheme: dark){{:root{{{dark}}}}}"
    for role, look in LOOKS.items():
        rule = f"fill:var(--{look.fill});" if look.fill else "fill:none;"
        if look.opacity < 1.0:
            rule += f"fill-opacity:{look.opacity:g};"
        if look.stroke:
            rule += f"stroke:var(--{look.stroke});stroke-width:{look.width:g};"
        if look.dash:
            rule += f"stroke-dasharray:{' '.join(f'{each:g}' for each in look.dash)};"
        yield f"svg .{role}{{{rule}}}"
