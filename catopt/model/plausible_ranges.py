"""Which values a quantity may have, each range with a name by which it is set aside.

``accept = ["friction"]`` at the top of a file, and ``accept=["friction"]`` of a part of the model,
take values beyond the range of that name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, fields
from functools import cache
from typing import ClassVar, Final, NamedTuple

from catopt.constants import STANDARD_GRAVITY
from catopt.model.kinds import Accepted, Checked, Findings
from catopt.words import Message


class Range(NamedTuple):
    """Least and largest plausible value of some keys, in SI; a key may have its table before it."""

    name: str
    least: float
    most: float
    keys: str


RANGES: Final = (
    Range("friction", 0.0, 2.0, "seabed_friction friction"),
    Range("water_density", 950.0, 1100.0, "water_density"),
    Range("body_density", 20.0, 20_000.0, "density"),
    Range("drag", 0.0, 10.0, "drag_normal drag_axial drag_coefficient"),
    Range("added_mass", 0.0, 10.0, "added_mass_normal added_mass_axial added_mass_coefficient"),
    Range(
        "damping",
        0.0,
        2.0,
        "surge_damping sway_damping yaw_damping roll_damping pitch_damping line_damping",
    ),
    Range("safety_factor", 1.0, 20.0, "safety_factor safety_factor_line_out proof_load_factor"),
    Range("water_depth", 0.05, 12_000.0, "water_depth low_water"),
    Range("diameter", 0.0005, 1.0, "diameter diameters diameter_min diameter_max nominal_diameter"),
    Range(
        "wave_height", 0.0, 40.0, "waves.height trains.height sea_states.height hs hmax max_height"
    ),
    Range("wave_period", 0.3, 60.0, "waves.period trains.period sea_states.period peak_period"),
    Range("current_speed", -10.0, 10.0, "current.speed current.speeds environment.current"),
    Range("wind_speed", 0.0, 100.0, "wind_speed environment.wind"),
)
"""Beyond what ports, ships, chain and the sea have, so that what is refused is a slip."""

HEAVIER: Final = "weight_in_water"
"""Name by which a weight in water above that in air is accepted."""
SLACK: Final = 1e-3
"""Part by which a weight in water may exceed that in air: rounding of the two figures."""
NAMES: Final = (*(each.name for each in RANGES), HEAVIER)
"""Of the ranges that may be set aside."""
_OF_KEY: Final = {key: each for each in RANGES for key in each.keys.split()}


def range_of(path: Sequence[object]) -> Range | None:
    """Find the range of a key by the names in its path."""
    names = [part for part in path if isinstance(part, str)]
    return _OF_KEY.get(".".join(names[-2:])) or _OF_KEY.get(names[-1])


_ACCEPTED: ContextVar[tuple[Accepted, ...]] = ContextVar("accepted", default=())


@contextmanager
def accepting(names: Sequence[str]) -> Iterator[None]:
    """Make parts of the model that accept values beyond the ranges of some names."""
    before = _ACCEPTED.set(tuple(names))
    try:
        yield
    finally:
        _ACCEPTED.reset(before)


@dataclass(frozen=True)
class Plausible(Checked):
    """A part of the model whose values have plausible ranges."""

    TABLE: ClassVar[str] = ""
    """Of a file, where some of its keys have a range there alone."""

    accept: tuple[Accepted, ...] = field(
        default_factory=_ACCEPTED.get, kw_only=True, compare=False, repr=False
    )
    """Names of the plausible ranges that its values may go beyond."""

    def __post_init__(self) -> None:
        names = (self.accept,) if isinstance(self.accept, str) else tuple(self.accept)
        object.__setattr__(self, "accept", names)
        super().__post_init__()
        found = Findings(of=self)
        for name in names:
            found.word("accept", name, NAMES, quoted=True)
        for key, name, allowed in beyond(self):
            if name not in names:
                found.add(key, ", ".join(f"{each:g}" for each in _several(self, key)), allowed)
        found.raise_if_any()


@cache
def _ranged(of: type, table: str) -> tuple[tuple[str, Range], ...]:
    """List the attributes of a class that have a range."""
    pairs = ((each.name, range_of((table, each.name))) for each in fields(of))
    return tuple((name, known) for name, known in pairs if known is not None)


def _several(part: Plausible, key: str) -> list[float]:
    """List the numbers of an attribute, which may be one, several or none."""
    value = getattr(part, key)
    every = value if isinstance(value, tuple) else (value,)
    return [each for each in every if each is not None]


def beyond(part: Plausible) -> Iterator[tuple[str, str, Message]]:
    """Find the attributes beyond their range: key, name of the range, and what is allowed."""
    if getattr(part, "is_in_air", False):  # neither water nor depth
        return
    of: type = type(part)
    for key, known in _ranged(of, part.TABLE):
        value = getattr(part, key)
        if value is None or (type(value) is float and known.least <= value <= known.most):
            continue  # as nearly all are
        if any(not known.least <= each <= known.most for each in _several(part, key)):
            bounds = {"least": known.least, "most": f"{known.most:g}", "name": known.name}
            yield key, known.name, Message("refused_case.implausible", **bounds)
    weight, mass = getattr(part, "submerged_weight", None), getattr(part, "mass", None)
    if weight is not None and mass is not None:
        in_air = mass * STANDARD_GRAVITY
        if weight > in_air * (1.0 + SLACK):
            said = Message("refused_case.heavier_in_water", air=in_air, name=HEAVIER)
            yield "submerged_weight", HEAVIER, said


def accepted_in(accept: Sequence[str], whole: object) -> tuple[Accepted, ...]:
    """Return names that are accepted, with those that parts of a model go beyond."""
    used = {name for part in _parts(whole) for _, name, _ in beyond(part)}
    return tuple(name for name in NAMES if name in used or name in accept)


def _parts(whole: object) -> Iterator[Plausible]:
    """Yield the parts of a model that accept values, each once."""
    left, seen = [whole], set()
    while left:
        part = left.pop()
        if isinstance(part, tuple):
            left += part
        elif isinstance(part, Checked) and id(part) not in seen:
            seen.add(id(part))
            left += [each for each in vars(part).values() if isinstance(each, tuple | Checked)]
            if isinstance(part, Plausible) and part.accept:
                yield part
