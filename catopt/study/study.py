"""A study: a case, what varies in it, and what is computed of each member."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Any, Literal

import numpy as np

from catopt._version import identity
from catopt.arrays import Array, Codes
from catopt.constants import YEAR
from catopt.model.kinds import Measured
from catopt.quantities import Quantity
from catopt.records import Counted, Digest, From
from catopt.study.member import Base, kind_of_key

DistributionKind = Literal["normal", "lognormal", "uniform", "gumbel"]


@dataclass(frozen=True)
class Distribution:
    """A distribution of a value.

    `kind`: of which form; gumbel is that of largest values; `first`, `second`: mean and standard
    deviation of the value itself; of a uniform one its ends.

    Examples
    --------
    >>> import numpy as np
    >>> Distribution("normal", 50.0, 5.0).at(np.array([-2.0, 0.0, 2.0])).tolist()
    [40.0, 50.0, 60.0]
    """

    kind: DistributionKind
    first: float
    second: float

    def draw(self, rng: np.random.Generator, count: int) -> Array:
        """Draw so many values."""
        a, b = self.first, self.second
        if self.kind == "normal":
            return rng.normal(a, b, count)
        if self.kind == "lognormal":
            return rng.lognormal(*self._logarithm, count)
        if self.kind == "gumbel":
            return rng.gumbel(*self._gumbel, count)
        return rng.uniform(a, b, count)

    def at(self, normal: Array) -> Array:
        """Values that are exceeded as seldom as a standard normal one exceeds `normal`."""
        from scipy.special import log_ndtr, ndtr

        a, b = self.first, self.second
        if self.kind == "normal":
            return a + b * normal
        if self.kind == "lognormal":
            middle, width = self._logarithm
            return np.exp(middle + width * normal)
        if self.kind == "gumbel":
            mode, scale = self._gumbel
            found: Array = mode - scale * np.log(-log_ndtr(normal))
            return found
        between: Array = a + (b - a) * ndtr(normal)
        return between

    def normal_of(self, values: Array) -> Array:
        """Return standard normal values exceeded as seldom as these: `at` turned round."""
        from scipy.special import ndtri, ndtri_exp

        a, b = self.first, self.second
        if self.kind == "normal":
            return (values - a) / b
        if self.kind == "lognormal":
            middle, width = self._logarithm
            return (np.log(values) - middle) / width
        if self.kind == "gumbel":
            mode, scale = self._gumbel
            rare: Array = ndtri_exp(-np.exp(-(values - mode) / scale))
            return rare
        share: Array = ndtri((values - a) / (b - a))
        return share

    @property
    def _logarithm(self) -> tuple[float, float]:
        """Mean and standard deviation of the logarithm."""
        width = math.sqrt(math.log1p((self.second / self.first) ** 2))
        return math.log(self.first) - 0.5 * width**2, width

    @property
    def _gumbel(self) -> tuple[float, float]:
        """Mode and scale."""
        scale = self.second * math.sqrt(6.0) / math.pi
        return self.first - float(np.euler_gamma) * scale, scale


@dataclass(frozen=True, eq=False)
class Axis:
    """Keys whose values go together; the axes of a study are multiplied.

    `columns`: values by key path, all of the same length: numbers in SI as an array, words and
    counts as they are; `weights`: what each of them counts; None where all count the same;
    `distributions`: by key path, what they were drawn from; empty where they were not; `counted`:
    how many rows of a table they are; empty where they are of none.
    """

    columns: Mapping[str, Sequence[Any] | Array]
    weights: Array | None = None
    distributions: Mapping[str, Distribution] = field(default_factory=dict)
    counted: str = ""

    @property
    def keys(self) -> Annotated[tuple[str, ...], From(1)]:
        """Key paths whose values go together."""
        return tuple(self.columns)

    @property
    def is_drawn(self) -> bool:
        """Whether they were drawn at random."""
        return bool(self.distributions)

    @property
    def size(self) -> Counted:
        """How many values there are of them."""
        return len(self)

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    @property
    def name(self) -> str:
        """What its dimension is called: its key, or rows and draws of several."""
        if len(self.columns) == 1:
            return next(iter(self.columns))
        return "draw" if self.is_drawn else "row: " + ", ".join(self.columns)

    @property
    def shares(self) -> Array:
        """What each of its values counts, in all 1."""
        if self.weights is None:
            return np.full(len(self), 1.0 / len(self))
        scaled = self.weights / self.weights.max()  # the sum of the largest floats is none
        shares: Array = scaled / scaled.sum()
        return shares

    def take(self, at: Codes) -> dict[str, Sequence[Any] | Array]:
        """Return the values at some places, by key."""
        return {
            key: column[at] if isinstance(column, np.ndarray) else [column[k] for k in at.tolist()]
            for key, column in self.columns.items()
        }


PIECE = MappingProxyType(
    {"statics": 20_000, "checks": 100, "motion": 1, "linear": 50, "sizing": 4, "design": 1}
)
"""Members that are computed, and stored, together: some seconds of work."""


@dataclass(frozen=True)
class StudyPiece:
    """Members that are computed together.

    `number`, `first`: of the piece, and of its first member, from 0; `columns`: values of each
    member by key path.
    """

    number: int
    first: int
    columns: Mapping[str, Sequence[Any] | Array]

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def changes(self, member: int) -> dict[str, Any]:
        """Return the values of a member, counted within the piece, by key path."""
        return {key: _plain(column[member]) for key, column in self.columns.items()}


@dataclass(frozen=True, eq=False)
class Study:
    """A study, ready to be run.

    `base`: what all members have in common; `limits`: values in SI, by quantity, beyond which the
    share of the members is asked for.
    """

    title: str
    """Title of the study; empty when it has none."""
    base: Base
    axes: Annotated[tuple[Axis, ...], From(1)]
    """What varies; all combinations are members, the last varies fastest."""
    limits: Mapping[str, float] = field(default_factory=dict)
    share: float = 0.95  # of the draws in which a design has to pass

    def __len__(self) -> int:
        return math.prod(len(axis) for axis in self.axes)

    @property
    def keys(self) -> tuple[str, ...]:
        """Key paths that vary."""
        return tuple(key for axis in self.axes for key in axis.columns)

    @property
    def heights_that_stay(self) -> tuple[str, ...]:
        """Keys of fairleads whose heights are given and stay while the water depth varies."""
        if "site.water_depth" not in self.keys:
            return ()
        file = self.base.document
        heights = [
            f"points[{k}].height"
            for k, point in enumerate(file.get("points", ()))
            if point.get("kind") == "fairlead" and "height" in point
        ]
        heights += ["line.fairlead_height"] * ("fairlead_height" in file.get("line", {}))
        return tuple(key for key in heights if key not in self.keys)

    @property
    def distributions(self) -> Mapping[str, Distribution]:
        """What keys were drawn from, by key path; empty where anything else varies, too."""
        found: Mapping[str, Distribution] = {}
        for axis in self.axes:
            if axis.is_drawn:
                found = axis.distributions
            elif len(axis) > 1:
                return {}
        return found

    def values(self, first: int, end: int) -> dict[str, Sequence[Any] | Array]:
        """Return the values of a range of members by key path."""
        found: dict[str, Sequence[Any] | Array] = {}
        for axis, at in zip(self.axes, self.places(first, end), strict=True):
            found |= axis.take(at)
        return found

    def values_of(self, member: int) -> dict[str, Any]:
        """Return the values of one member, from 0, by key path."""
        return {key: _plain(column[0]) for key, column in self.values(member, member + 1).items()}

    def reported_of(self, member: int) -> dict[str, Any]:
        """Return what tells a member: its title where that varies, or else all its values."""
        values = self.values_of(member)
        return {"title": values["title"]} if "title" in values else values

    def quantity_of(self, key: str) -> Quantity | None:
        """Return what the values of a key are, in the unit of SI; None for words and counts."""
        kind = kind_of_key(self.base, key)
        if not isinstance(kind, Measured):
            return None
        unit = kind.dimension.si_unit or "-"
        return Quantity(key, key, "", unit, unit, 1.0, 6, "significant")

    def written(self, key: str, value: Any) -> str:
        """Write a value of a key with its unit in SI; years of what lasts as long."""
        quantity = self.quantity_of(key)
        if quantity is not None and quantity.si_unit == "s" and value >= YEAR:
            return f"{value / YEAR:.6g} years"
        return str(value) if quantity is None else quantity.format(value, unit=True)

    def places(self, first: int, end: int) -> list[Codes]:
        """Return, of a range of members, the place of each on every axis."""
        sizes = [len(axis) for axis in self.axes]
        return list(np.unravel_index(np.arange(first, end), sizes))

    def shares(self) -> Array:
        """Return what each member counts, in all 1."""
        shares = np.ones(1)
        for axis in self.axes:
            shares = np.multiply.outer(shares, axis.shares).ravel()
        return shares

    @property
    def _piece(self) -> int:
        """Members of a piece; those at rest that are solved one by one are as slow as checks."""
        is_slow = self.base.compute == "statics" and not self.base.in_bulk
        return PIECE["checks" if is_slow else self.base.compute]

    @property
    def pieces(self) -> int:
        """How many pieces there are."""
        return math.ceil(len(self) / self._piece)

    def piece(self, number: int) -> StudyPiece:
        """Return a piece by its number from 0."""
        first, end = self.piece_start(number), self.piece_start(number + 1)
        return StudyPiece(number, first, self.values(first, end))

    def piece_start(self, number: int) -> int:
        """Return the first member of a piece, from 0; that after the last for the next piece."""
        return min(number * self._piece, len(self))

    @cached_property
    def digest(self) -> Digest:
        """SHA-256 of all that decides the numbers: case, files, values, version."""
        base = self.base
        own = [identity(), base.compute, base.moored, base.convergence_check, base.document]
        digest = sha256(json.dumps(own, sort_keys=True, default=str).encode())
        for path in _files(base.document, base.folder):
            digest.update(path.read_bytes())
        for axis in self.axes:
            for key, column in axis.columns.items():
                digest.update(key.encode())
                is_array = isinstance(column, np.ndarray)
                said = np.asarray(column).tobytes() if is_array else json.dumps(column).encode()
                digest.update(said)
        return digest.hexdigest()


def _files(table: Any, folder: str) -> Iterator[Path]:
    """Files that a document names and that are there."""
    if isinstance(table, list):
        for each in table:
            yield from _files(each, folder)
    elif isinstance(table, dict):
        for key, value in table.items():
            if isinstance(value, str) and (key == "file" or key.endswith("_file")):
                path = Path(folder) / value
                if path.is_file():
                    yield path
            else:
                yield from _files(value, folder)


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value
