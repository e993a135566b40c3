"""From a study file to a study, with every error at once."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, ClassVar, Final

import numpy as np

from catopt.arrays import Array
from catopt.casefile.document import read_tables, refuse
from catopt.casefile.reading import moored_of
from catopt.casefile.schema import TableSchema, entries
from catopt.checks.criteria import criteria_of
from catopt.documents import parse_toml, read_text
from catopt.errors import InputError, Problem, refused
from catopt.model import Case
from catopt.model.kinds import Kind, Measured, Seed, Size, Text, Whole
from catopt.model.network import Network
from catopt.study.member import (
    Base,
    Computed,
    ConvergenceCheck,
    document_of,
    kind_of_key,
    read_member,
)
from catopt.study.store import read_each, read_table
from catopt.study.study import Axis, Distribution, DistributionKind, Study
from catopt.units import Dimension, to_si
from catopt.words import Listed, Message, Several

MOST_VARIED: Final = 20
"""Tables ``[[vary]]`` of a study."""


@dataclass(frozen=True)
class AnyValue(Kind):
    """What the key that is varied takes; it is read by that key."""

    wanted = Message("refused_study.value_of_key")

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
        """What is required."""
        return Message("refused_study.names_with_values", example=self.example)

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


class VaryTable(TableSchema):
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


class StudyTable(TableSchema):
    """A whole study file."""

    title: str = ""
    case: File
    compute: Computed
    proof: ConvergenceCheck | None = None
    samples: Annotated[int, Whole("samples", example=1000)] | None = None
    seed: Seed | None = None
    limits: Limits | None = None
    share: Annotated[float, Measured(Dimension.NUMBER, above=0.0, at_most=1.0)] | None = None
    vary: Annotated[list[VaryTable], Size(1, MOST_VARIED)]


_MOST = 100_000_000
"""Members of a study: more is a slip of a count, or work for weeks."""


def read_study(path: str | os.PathLike[str]) -> Study:
    """Read a study file, TOML in UTF-8, with its case and its tables; paths count from where it is.

    InputError has every problem of the file, of its case or of its tables.
    """
    source = os.fspath(path)
    document = parse_toml(read_text(Path(path), source, kind="study file"), source)
    table, findings = read_tables(document, StudyTable)
    refuse(document, findings, source)
    problems: list[Problem] = []
    folder = Path(path).parent
    base = _base(table, folder, source)
    axes = list(_axes(table, base, folder, problems))
    limits = _limits(table, base, problems)
    problems += _of_design(table)
    if problems:
        raise InputError(problems, source)
    share = {} if table.share is None else {"share": table.share}
    study = Study(table.title, base, tuple(axes), limits, **share)
    if len(study) > _MOST:
        allowed = Message("refused_study.members_are_most_give_fewer", most=_MOST)
        raise refused("vary", Message("refused_study.members", count=len(study)), allowed, source)
    case = read_member(base, study.piece(0).changes(0))
    if base.compute == "linear" and base.is_network:
        allowed = Message("refused_study.no_linear_of_points")
        raise refused("compute", '"linear"', allowed, source)
    if base.compute == "checks" and isinstance(case, Case | Network) and not criteria_of(case).all:
        allowed = Message("refused_study.checks_with_codes_or_limits")
        raise refused("checks", Message("refused.none"), allowed, base.source)
    return study


def _of_design(table: StudyTable) -> Iterator[Problem]:
    """Yield what does not go with a design, or with nothing else."""
    if table.compute != "design":
        if table.share is not None:
            allowed = Message("refused_study.goes_with_compute_design")
            yield Problem("share", f"{table.share:g}", allowed)
        return
    if table.limits is not None:
        yield Problem("limits", "", Message("refused_study.checks_of_the_case_are_the_limits"))
    for number, each in enumerate(table.vary):
        if each.distribution is None:
            yield Problem(f"vary[{number}]", "", Message("refused_study.a_design_wants_draws"))
        elif each.key.startswith(("design", "title", "system")):
            allowed = Message("refused_study.not_what_is_sought")
            yield Problem(f"vary[{number}].key", f'"{each.key}"', allowed)


def _base(table: StudyTable, folder: Path, source: str) -> Base:
    place, compute = folder / table.case, table.compute
    document = document_of(place)
    moored = moored_of(document)
    if (compute == "sizing") != (moored is not None):
        key = "refused_study.file_for_size" if compute == "sizing" else "refused_study.a_case_file"
        raise refused("case", f'"{table.case}"', Message(key), source)
    if table.proof is not None and compute != "motion":
        allowed = Message("refused_study.goes_with_compute_motion")
        raise refused("proof", f'"{table.proof}"', allowed, source)
    return Base(document, str(place), str(place.parent), compute, moored, table.proof or "step")


def _axes(table: StudyTable, base: Base, folder: Path, problems: list[Problem]) -> Iterator[Axis]:
    """Yield what varies, in the order of the file; what is drawn is one axis, the last."""
    drawn: list[tuple[str, VaryTable]] = []
    seen: set[str] = set()
    for number, each in enumerate(table.vary):
        place = f"vary[{number}]"
        with _gathered(problems, place):
            _check_form(each)
            axis = None
            if each.distribution is not None:
                drawn.append((place, each))
            elif each.table is None:
                axis = _listed(each, base)
            else:
                path = folder / each.table
                axis = read_table(base, path, each.columns or {}, each.weight)
            keys = {each.key} if axis is None else set(axis.columns)
            for key in sorted(keys & seen):
                raise refused("key", f'"{key}"', Message("refused_study.varies_already_above"))
            seen |= keys
            if axis is not None:
                yield axis
    if drawn:
        yield from _drawn(table, base, drawn, problems)
    elif table.samples is not None or table.seed is not None:
        key = "samples" if table.samples is not None else "seed"
        problems.append(Problem(key, "", Message("refused_study.nothing_drawn_no_vary_has")))


@contextmanager
def _gathered(problems: list[Problem], place: str) -> Iterator[None]:
    """Note what is wrong in the body, by its place in the study file."""
    try:
        yield
    except InputError as error:
        of = f" of {error.source}" if error.source else ""
        problems += [replace(each, key=f"{place}.{each.key}{of}") for each in error.problems]


_FORMS: Final[tuple[tuple[set[str], set[str]], ...]] = (
    ({"key", "values"}, set()),
    ({"key", "min", "max", "count"}, set()),
    ({"key", "distribution", "mean", "deviation"}, set()),
    ({"key", "distribution", "min", "max"}, set()),
    ({"table"}, {"columns", "weight"}),
)
"""Keys of a [[vary]] that go together: those that are required, and those that may be there."""


def _check_form(each: VaryTable) -> None:
    given = set(each.given())
    if not any(wanted <= given <= wanted | more for wanted, more in _FORMS):
        order = list(entries(VaryTable)).index
        forms = Several([Listed(sorted(wanted, key=order), "and") for wanted, _ in _FORMS])
        allowed = Message("refused_study.one_these_wanted", forms=forms)
        raise refused("", ", ".join(each.given()), allowed)
    if each.distribution is not None and (each.distribution == "uniform") != ("min" in given):
        both = ("min", "max") if each.distribution == "uniform" else ("mean", "deviation")
        allowed = Message("refused_study.are_wanted_with", wanted=Listed(both, "and"))
        raise refused("distribution", f'"{each.distribution}"', allowed)


def _listed(each: VaryTable, base: Base) -> Axis:
    kind = kind_of_key(base, each.key)
    if each.values is not None:
        found, problems = read_each(kind, each.values, lambda at: f"values[{at}]")
        if problems:
            raise InputError(problems)
        return Axis({each.key: np.array(found) if isinstance(kind, Measured) else found})
    low, high = (_number(base, each, name) for name in ("min", "max"))
    assert each.count is not None
    return Axis({each.key: np.linspace(low, high, each.count)})


def _number(base: Base, each: VaryTable, name: str, *, spread: bool = False) -> float:
    """Read a value of a key that is measured; `spread` is a width, which has no range."""
    kind = kind_of_key(base, each.key)
    if not isinstance(kind, Measured):
        raise refused("key", f'"{each.key}"', Message("refused_study.no_number_with_range"))
    value = getattr(each, name)
    try:
        number = to_si(value, kind.dimension, bare=kind.bare) if spread else kind.read(value)
    except InputError as error:
        raise InputError([replace(p, key=name) for p in error.problems]) from None
    if spread and not number > 0.0:
        raise refused(name, f"{value}", Message("refused_study.must_be_above_0"))
    return number


def _drawn(
    table: StudyTable, base: Base, drawn: list[tuple[str, VaryTable]], problems: list[Problem]
) -> Iterator[Axis]:
    """Draw all keys with a distribution together; the numbers hang on nothing but the seed."""
    if table.samples is None:
        problems.append(Problem("samples", "", Message("refused_study.missing_how_many_are_be")))
        return
    rng = np.random.default_rng(table.seed or 0)
    columns: dict[str, Array] = {}
    distributions: dict[str, Distribution] = {}
    for place, each in drawn:
        with _gathered(problems, place):
            distributions[each.key] = _distribution(each, base)
            columns[each.key] = distributions[each.key].draw(rng, table.samples)
    if columns:
        yield Axis(columns, distributions=distributions)


def _distribution(each: VaryTable, base: Base) -> Distribution:
    assert each.distribution is not None
    if each.distribution == "uniform":
        low, high = (_number(base, each, name) for name in ("min", "max"))
        return Distribution("uniform", low, high)
    mean = _number(base, each, "mean")
    deviation = _number(base, each, "deviation", spread=True)
    if each.distribution == "lognormal" and not mean > 0.0:
        raise refused("mean", f"{each.mean}", Message("refused_study.must_be_above_0"))
    return Distribution(each.distribution, mean, deviation)


def _limits(table: StudyTable, base: Base, problems: list[Problem]) -> dict[str, float]:
    measured = {each.name: each for each in base.kept if each.quantity}
    found = {}
    for name, value in (table.limits or {}).items():
        if name not in measured:
            unknown = Message("refused_study.unknown_quantity")
            allowed = Message("refused.one_of", words=", ".join(measured))
            problems.append(Problem(f"limits.{name}", unknown, allowed))
            continue
        unit = measured[name].measure.si_unit
        dimension = next(d for d in Dimension if d.si_unit == ("" if unit == "-" else unit))
        with _gathered(problems, "limits"):
            found[name] = to_si(value, dimension, name)
    return found
