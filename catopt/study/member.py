"""The members of a study: what they share, the file of each, and what is computed of it."""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Final, Literal

from catopt.arrays import Array, Flags
from catopt.casefile.document import hint, parts
from catopt.casefile.reading import Moored, case_of, is_network, network_of
from catopt.casefile.schema import CaseTable, NetworkTable, TableSchema, entries
from catopt.checks.case import check_case
from catopt.documents import parse_toml, read_text
from catopt.errors import CatoptError, InputError, refused
from catopt.largest import largest
from catopt.model import Case
from catopt.model.kinds import Kind, Measured
from catopt.model.network import Network
from catopt.quantities import QUANTITIES, Quantity
from catopt.sizing.file import SizingFile, file_of, sized
from catopt.sizing.kinds import schema_of
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.sizing import Sizing


Computed = Literal["statics", "checks", "motion", "linear", "sizing", "design"]
"""What a study may compute of each of its members."""

ConvergenceCheck = Literal["step", "none"]
"""How a run in time is proven, as of ``catopt verify --dynamic``."""


@dataclass(frozen=True)
class Output:
    """A number or a text that is kept of each member.

    `quantity`: key of its quantity; empty for a text; `high_is_worse`: which end of it is the bad
    one.
    """

    name: str
    """Of the quantity, or of the text, as study files have it."""
    quantity: str = ""
    high_is_worse: bool = True

    @property
    def measure(self) -> Quantity:
        """Its quantity."""
        return QUANTITIES[self.quantity]

    @property
    def words(self) -> Message:
        """What it is called."""
        return Message(f"study.{self.name}")

    def beyond(self, values: Array, limit: float) -> Flags:
        """Which values are beyond a limit, on its bad side."""
        return values > limit if self.high_is_worse else values < limit

    @property
    def heading(self) -> str:
        """Of its column in files: ``fairlead_tension (kN)``."""
        unit = self.measure.field_unit if self.quantity else "-"
        return self.name if unit == "-" else f"{self.name} ({unit})"


_ENDS = (
    Output("fairlead_tension", "tension"),
    Output("anchor_tension", "tension"),
    Output("anchor_uplift", "vertical_force"),
    Output("grounded_length", "grounded_length", high_is_worse=False),
)
_SPREAD = (Output("fairlead_mean", "tension"), Output("fairlead_deviation", "tension"))
_USED = Output("utilisation", "utilisation")
_GOVERNING = Output("governing")

KEPT: Final[Mapping[str, tuple[Output, ...]]] = MappingProxyType(
    {
        "line": (*_ENDS, Output("span", "span")),
        "system": (*_ENDS, Output("offset", "offset")),
        "points": (*_ENDS, Output("offset", "offset")),
        "checks": (_USED, Output("failing", "failing"), _GOVERNING),
        "motion": (
            Output("fairlead_tension", "tension"),
            *_SPREAD,
            Output("anchor_tension", "tension"),
            Output("offset", "offset"),
            Output("grounded_length", "grounded_length", high_is_worse=False),
            _USED,
            Output("change", "utilisation"),
            Output("verdict"),
        ),
        "linear": (
            Output("fairlead_probable", "tension"),
            *_SPREAD,
            Output("zero_crossing_period", "zero_crossing_period"),
            Output("reserve", "reserve", high_is_worse=False),
            Output("taut"),
        ),
        "sizing": (
            Output("line"),
            Output("holding"),
            Output("mass", "mass"),
            Output("line_length", "length"),
            Output("swing_radius", "span"),
            Output("holding_mass", "mass"),
            _USED,
            _GOVERNING,
        ),
        "design": (),  # of which the front is one answer for all members
    }
)
"""What is kept, by what is computed; at rest by what is moored.

At rest, of a line or over all lines: the largest tensions and uplift of any line, the
least grounded length. In motion, over the whole run and all lines: `change` is the largest part by
which a maximum hangs on the step, as far as that was looked for. By linear motion, at the fairlead
with the largest `fairlead_probable`; `reserve` is the least of any line.
"""


@dataclass(frozen=True)
class Base:
    """What all members have in common.

    `document`: of the case file, or of the file for ``catopt size``, as the TOML reader returns it;
    `source`, `folder`: its name, for messages, and where paths in it count from; `moored`: of what
    the file is for ``catopt size``; None for a case file; `convergence_check`: of a run in
    time.
    """

    document: dict[str, Any]
    source: str
    folder: str
    compute: Computed
    """What was computed of each member."""
    moored: Moored | None = None
    convergence_check: ConvergenceCheck = "step"

    @property
    def kept(self) -> tuple[Output, ...]:
        """What is kept of each member."""
        if self.compute != "statics":
            return KEPT[self.compute]
        if self.is_network:
            return KEPT["points"] if "bodies" in self.document else _ENDS
        return KEPT["system" if "system" in self.document else "line"]

    @property
    def is_network(self) -> bool:
        """Whether the file is of points and lines."""
        return self.moored is None and is_network(self.document)

    @property
    def in_bulk(self) -> bool:
        """Whether members are solved many at a time: of points, those without joints, on a body."""
        if self.compute != "statics" or not self.is_network:
            return self.compute == "statics"
        kinds = [point.get("kind") for point in self.document["points"]]
        return "joint" not in kinds and len(self.document.get("bodies", ())) == 1


Values = dict[str, float | str]
"""What is kept of a member by name: numbers in SI, and texts."""

OfSizing = Callable[[int, Mapping[str, Any], "Sizing"], None]
"""Told the number of a member, from 0, its own values by key path, and its sizing."""


def document_of(place: Path) -> dict[str, Any]:
    """Return the document of a file, as the TOML reader does; of another program's, of its case."""
    if place.suffix.lower() == ".toml":
        return parse_toml(read_text(place, str(place)), str(place))
    from catopt.casefile import read_mooring, write_case

    return parse_toml(write_case(read_mooring(place)), str(place))


def kind_of_key(base: Base, key: str) -> Kind:
    """Return what a key path takes.

    Raises InputError, about ``key``, for one that the file cannot have, that is no single value, or
    that counts into an array of tables which the file does not have.
    """
    own = NetworkTable if base.is_network else CaseTable
    top: type[TableSchema] = own if base.moored is None else schema_of(base.moored)
    table: type[TableSchema] | None = top
    place: Any = base.document
    entry, path = None, parts(key)
    for at, part in enumerate(path, start=1):
        if isinstance(part, int):
            if entry is None or not entry.array:
                raise _refused(key, Message("refused_study.no_array"))
            if not isinstance(place, list) or part >= len(place):
                there = len(place) if isinstance(place, list) else 0
                raise _refused(key, Message("refused_study.so_many_there", count=there))
            place = place[part]
            continue
        if table is None:
            raise _refused(key, Message("refused_study.no_keys"))
        if part not in entries(table):
            allowed = Message("refused_study.no_such_key", hint=hint(table, part, top))
            raise _refused(key, allowed)
        entry = entries(table)[part]
        table = entry.table
        place = place.get(part) if isinstance(place, dict) else None
        if at == len(path) and entry.array:
            raise _refused(key, Message("refused_study.one_of_array", key=key))
    if entry is None or entry.kind is None:
        raise _refused(key, Message("refused_study.single_value"))
    return entry.kind


def with_changes(base: Base, changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the document of a member: that of the base, with its own values in place."""
    document = copy.deepcopy(base.document)
    for key, value in changes.items():
        place: Any = document
        *above, last = parts(key)
        for part in above:
            place = place[part] if isinstance(part, int) else place.setdefault(part, {})
        place[last] = value
    return document


def in_file(kind: Kind, si: Any) -> Any:
    """Write a value in SI as the file has it: a bare number may be in another unit there."""
    if isinstance(kind, Measured) and kind.bare:
        return f"{si!r} {kind.dimension.si_unit}"
    return si


def _refused(key: str, allowed: Message) -> InputError:
    return refused("key", f'"{key}"', allowed)


def read_member(base: Base, changes: Mapping[str, Any]) -> Case | Network | SizingFile:
    """Read a member's file; InputError with all that is wrong in it.

    `changes`: its own values by key path, numbers in SI.
    """
    written = {key: in_file(kind_of_key(base, key), value) for key, value in changes.items()}
    document = with_changes(base, written)
    if base.is_network:
        return network_of(document, base.source, folder=base.folder)
    if base.moored is None:
        return case_of(document, base.source, folder=base.folder)
    return file_of(document, base.moored, base.source, folder=base.folder)


def compute_member(
    base: Base,
    changes: Mapping[str, Any],
    of_sizing: Callable[[Mapping[str, Any], Sizing], None] | None = None,
) -> Values:
    """Compute a member by itself; errors of the solver that it needs come through.

    `of_sizing` is told the sizing, where that is what is computed.
    """
    read = read_member(base, changes)
    if isinstance(read, SizingFile):
        found = sized(read, at_rest=True)
        if of_sizing is not None:
            of_sizing(changes, found)
        return _of_sizing(found)
    if base.compute == "motion":
        return _in_motion(base, read)
    if base.compute == "linear":
        assert isinstance(read, Case)
        from catopt.verify.linear import linear_lines

        lines = linear_lines(read)
        assert read.dynamics is not None
        storm = read.dynamics.duration_of_interest
        worst = largest(lines, lambda line: line.most_probable(storm))
        return {
            "fairlead_probable": worst.most_probable(storm),
            "fairlead_mean": worst.mean,
            "fairlead_deviation": worst.deviation,
            "zero_crossing_period": worst.period,
            "reserve": min(line.reserve for line in lines),
            "taut": "yes" if all(line.holds for line in lines) else "no",
        }
    report = check_case(read)
    failing = sum(not each.passes for each in report.results)
    return {**_of_checks(report), "failing": float(failing)}


def reason_of(error: CatoptError) -> str:
    """Say in a line why a member has no answer."""
    if isinstance(error, InputError):
        return "; ".join(str(problem) for problem in error.problems)
    return error.message


def _of_checks(report: CheckReport) -> Values:
    governing = report.governing
    if governing is None:
        return {}
    values: Values = {"governing": str(governing.in_case)}
    used = governing.utilisation
    return values if used is None else {"utilisation": used, **values}


def _in_motion(base: Base, case: Case | Network) -> Values:
    from catopt.checks.criteria import criteria_of
    from catopt.notes.motion import checks_in_motion
    from catopt.verify.dynamic import verify_dynamic

    found = verify_dynamic(
        case, convergence_check=base.convergence_check, workers=1, compares_at_rest=False
    )
    if not found.is_complete:
        raise KeyboardInterrupt
    ran = found.parts
    tension = largest(found.governing.at_ends, lambda x: x.maximum)
    values: Values = {
        "fairlead_tension": tension.maximum,
        "fairlead_mean": tension.mean,
        "fairlead_deviation": tension.std,
        "offset": max(part.of("offset").maximum for part in ran),
        "grounded_length": min(part.of("grounded_length").minimum for part in ran),
        "verdict": found.verdict,
    }
    anchored = [part.of("anchor_tension").maximum for part in ran if part.is_anchored]
    values |= {"anchor_tension": max(anchored)} if anchored else {}
    changes = [part.worst_change.size for part in ran if part.worst_change is not None]
    if changes:
        values["change"] = max(changes)
    if any(each.check == "tension" for each in criteria_of(case, analysis="dynamic").all):
        used = [each.utilisation for each in checks_in_motion(found).results]
        values["utilisation"] = max(each for each in used if each is not None)
    return values


def _of_sizing(found: Sizing) -> Values:
    line = found.point.line
    values: Values = {
        "line": " + ".join(dict.fromkeys(each.name for each in line.segments)),
        "mass": found.point.objectives["mass_kg"],
        "line_length": line.length,
        "swing_radius": found.swing.total,
        **_of_checks(found.point.checks),
    }
    if found.sinker is not None:
        values |= {"holding": "sinker", "holding_mass": found.sinker.mass}
    elif found.drag_anchor is not None:
        values |= {"holding": found.drag_anchor.anchor, "holding_mass": found.drag_anchor.mass}
    return values
