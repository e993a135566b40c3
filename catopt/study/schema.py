"""The form of a study file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Final

from catopt.casefile.schema import Table
from catopt.model.kinds import Kind, Seed, Size, Text, Whole
from catopt.study.axis import DistributionKind
from catopt.study.base import Computed, Proof

MOST_VARIED: Final = 20
"""Tables ``[[vary]]`` of a study."""


@dataclass(frozen=True)
class AnyValue(Kind):
    """What the key that is varied takes; it is read by that key."""

    wanted = 'a value as the key takes it is wanted, such as "50 kN"'

    def read(self, value: object) -> object:
        """Return it as it stands."""
        if not isinstance(value, bool | int | float | str):
            raise self._refused(value)
        return value


@dataclass(frozen=True)
class ByName(Kind):
    """Names with a value each."""

    example: str

    @property
    def wanted(self) -> str:
        """What is wanted."""
        return f"names with a value each are wanted, such as {self.example}"

    def read(self, value: object) -> Mapping[str, Any]:
        """Return them as they stand."""
        if not isinstance(value, dict) or not all(
            isinstance(each, int | float | str) for each in value.values()
        ):
            raise self._refused(value)
        return value


Value = Annotated[Any, AnyValue()]
File = Annotated[str, Text(filled=True, example='"case.toml"')]
Key = Annotated[str, Text(filled=True, example='"load.horizontal_force"')]
Columns = Annotated[Any, ByName('{ Fx = "system.force[0]" }')]
Limits = Annotated[Any, ByName('{ fairlead_tension = "50 kN" }')]


class VaryTable(Table):
    """One thing that varies, or several that go together."""

    symbols: ClassVar[Mapping[str, str]] = {"from": "min", "to": "max", "file": "table"}

    key: Key = ""
    values: list[Value] | None = None
    min: Value | None = None
    max: Value | None = None
    count: Annotated[int, Whole("count", example=11)] | None = None
    distribution: DistributionKind | None = None
    mean: Value | None = None
    deviation: Value | None = None
    table: Annotated[str, Text(filled=True, example='"weather.csv"')] | None = None
    columns: Columns | None = None
    weight: Annotated[str, Text(filled=True, example='"hours"')] | None = None


class StudyTable(Table):
    """A whole study file."""

    title: str = ""
    case: File
    compute: Computed
    proof: Proof | None = None
    samples: Annotated[int, Whole("samples", example=1000)] | None = None
    seed: Seed | None = None
    limits: Limits | None = None
    vary: Annotated[list[VaryTable], Size(1, MOST_VARIED)]
