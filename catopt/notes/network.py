"""What the note of lines between points is made of: its file with the answers, and its origin."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from catopt.casefile.reading import read_mooring
from catopt.casefile.schema import NetworkTable
from catopt.checks.network import check_network, criteria_of_network
from catopt.checks.remarks import NO_CHECK
from catopt.model.network import Network
from catopt.mooring.held import LinesAtRest, at_rest
from catopt.mooring.network_out import NetworkOut, each_line_out, largest_tensions
from catopt.notes.directory import Asked, case_path
from catopt.notes.origin import origin_of, read_source
from catopt.notes.sheet import AnyNote, Stated
from catopt.ties import first_largest
from catopt.words import Message, is_said

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport


@dataclass(frozen=True, kw_only=True)
class NetworkSheet(Stated):
    """What is stated of lines between points; `rest` has all of them."""

    rest: LinesAtRest

    @property
    def lines(self) -> int:
        """How many there are."""
        return len(self.rest.runs)

    @property
    def intact(self) -> tuple[Solution, ...]:
        """Every line with all there."""
        return self.rest.lines


@dataclass(frozen=True, kw_only=True)
class NetworkNote(AnyNote):
    """Everything that the page of lines between points shows, the body held.

    `checks` are of every line, intact and with each out, which `line_out` has.
    """

    case: Network
    sheet: NetworkSheet
    rest: LinesAtRest
    line_out: tuple[NetworkOut, ...]
    checks: CheckReport

    @property
    def tensions(self) -> tuple[float, ...]:
        """Largest of each line, N."""
        return largest_tensions(self.rest)

    @property
    def most_loaded(self) -> int:
        """The line of the largest tension, counted from 0; the first of several."""
        return first_largest(self.tensions)


def read_network_note(path: Path, asked: Asked | None = None) -> NetworkNote:
    """Read a file of points and lines, or a directory with one, and compute its note.

    Raises InputError, NoAnswerError and NotConvergedError as `read_mooring` and `check_network` do.
    """
    asked = asked or Asked()
    place = case_path(path)
    network, source = read_mooring(place), read_source(place)
    assert isinstance(network, Network)
    rest = at_rest(network)
    line_out = each_line_out(network) if len(network.lines) > 1 else ()
    checks = check_network(network, rest, line_out or None)
    warnings = [each for each in checks.warnings if not is_said(each, NO_CHECK)]
    if asked.verify:
        warnings.append(Message("notes.network_not_verified"))
    return NetworkNote(
        case=network,
        rest=rest,
        line_out=line_out,
        checks=checks,
        origin=origin_of((source,), asked.date, NetworkTable),
        sheet=NetworkSheet(
            case=network,
            report=checks,
            criteria=criteria_of_network(network),
            anchor=network.anchor,
            rest=rest,
        ),
        warnings=tuple(dict.fromkeys(warnings)),
    )
