"""What ``catopt report`` says that it wrote: the document catopt.report/1."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import Literal

from catopt.catenary.solution import SwarmReport
from catopt.model.kinds import NotNegative, SomeForce, Time
from catopt.notes.line import Note, SizeNote
from catopt.notes.motion import InMotion
from catopt.notes.origin import SourceFile
from catopt.notes.system import NetworkNote, SystemNote
from catopt.records import Counted, Digest, Record
from catopt.verify.comparison import Compared
from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
from catopt.verify.dynamic_run import OverRuns
from catopt.verify.result import Verdict, Verification
from catopt.words import Language

AnyNote = Note | SizeNote | SystemNote | NetworkNote


@dataclass(frozen=True)
class WrittenFile(Record):
    """A file that was written."""

    DOCUMENT = "path bytes sha256"

    path: str
    """Where it was written."""
    bytes: Counted
    """Its size."""
    sha256: Digest
    """SHA-256 of it."""


def written_file(path: Path, content: bytes) -> WrittenFile:
    """Say what was written to a place."""
    return WrittenFile(str(path), len(content), sha256(content).hexdigest())


@dataclass(frozen=True)
class VerifiedInBrief(Record):
    """The closed form beside the truss model, as on the page."""

    DOCUMENT = "verdict worst(quantity unit gap) failure"

    verification: Verification | None
    failure: str = ""
    """Why the truss model has no answer; empty where it has one."""

    @cached_property
    def verdict(self) -> Verdict | Literal["no answer"]:
        """As of catopt.verify/1."""
        return "no answer" if self.verification is None else self.verification.verdict

    @property
    def worst(self) -> Compared | None:
        """The quantity on which the models agree least; None without an answer."""
        return None if self.verification is None else self.verification.static.worst


@dataclass(frozen=True)
class MovedInBrief(Record):
    """The line in motion that governs: in its load case, or of several lines."""

    DOCUMENT = (
        "part.name=load_case part.line runs part.max_tension "
        "max_fairlead_tension most_probable_max duration_of_interest most_probable_low "
        "most_probable_high "
        "part.dynamic_amplification=amplification part.slack_time utilisation"
    )

    part: DynamicPart
    utilisation: NotNegative | None
    """Largest tension of a segment over what it is allowed; None where no tension is limited."""

    @property
    def runs(self) -> Counted:
        """Runs of it."""
        return len(self.part.runs)

    @property
    def _fairlead(self) -> OverRuns:
        return self.part.of("fairlead_tension")

    @property
    def max_fairlead_tension(self) -> SomeForce:
        """Largest tension at the fairlead, N."""
        return self._fairlead.maximum

    @property
    def most_probable_max(self) -> SomeForce | None:
        """Of it in the duration of interest, N; None where nothing is random, or for few peaks."""
        return self._fairlead.most_probable_maximum

    @property
    def most_probable_low(self) -> SomeForce | None:
        """Where the 90 % interval of the most probable maximum begins, N."""
        return None if self._fairlead.tail is None else self._fairlead.tail.extreme.low

    @property
    def most_probable_high(self) -> SomeForce | None:
        """Where it ends, N."""
        return None if self._fairlead.tail is None else self._fairlead.tail.extreme.high

    @property
    def duration_of_interest(self) -> Time:
        """For which extremes are given, s."""
        return self.part.duration_of_interest

    @classmethod
    def of(cls, moved: InMotion | DynamicVerification | None) -> MovedInBrief | None:
        """Take the one that governs; None where nobody asked for motion."""
        if moved is None:
            return None
        if isinstance(moved, InMotion):
            return cls(moved.found.parts[moved.governing], moved.used(moved.governing))
        return cls(moved.governing, None)


@dataclass(frozen=True)
class WrittenNote(Record):
    """What catopt report has written: a calculation note as a page, a workbook, a PDF."""

    SCHEMA = "catopt.report/1"
    DOCUMENT = (
        "title page.path page.bytes page.sha256 workbook pdf? language date version "
        "sources(name sha256) design load_case sections passes governing verification "
        "swarm(objective evaluations runs converged_runs closed_form_difference) motion warnings"
    )

    note: AnyNote
    page: WrittenFile
    language: Language
    """Language of the page."""
    sections: tuple[str, ...]
    """Parts of the page, in their order."""
    workbook: WrittenFile | None = None
    """The workbook beside it; None where none was asked for."""
    pdf: WrittenFile | None = None
    """The same page as PDF; None where it was not asked for."""

    @property
    def title(self) -> str:
        """Title of the case; empty when it has none."""
        return self.note.case.title

    @property
    def date(self) -> str:
        """As given; empty when none was."""
        return self.note.origin.date

    @property
    def version(self) -> str:
        """Of catopt."""
        return self.note.origin.version

    @property
    def sources(self) -> tuple[SourceFile, ...]:
        """Files that the page rests on; the case file first."""
        return self.note.origin.files

    @property
    def _of(self) -> Note | SystemNote | NetworkNote:
        """The note that has the line: of a sizing, that of its recommended one."""
        return self.note.line if isinstance(self.note, SizeNote) else self.note

    @property
    def design(self) -> Counted | None:
        """Number of the design of a front; None for a case file."""
        chosen = self._of.chosen if isinstance(self._of, Note) else None
        return None if chosen is None else chosen.number

    @property
    def load_case(self) -> str:
        """Load case that is drawn; empty when there is only the load."""
        return self._of.load_case if isinstance(self._of, Note) else ""

    @property
    def passes(self) -> bool | None:
        """Whether every check is passed; None when nothing was checked."""
        checks = self._of.checks
        return checks.passes if checks.results else None

    @property
    def governing(self) -> str:
        """The check that governs, with its load case; empty when nothing was checked."""
        governing = self._of.checks.governing
        return "" if governing is None else governing.in_case

    @property
    def verification(self) -> VerifiedInBrief | None:
        """The closed form beside the truss model, as on the page; None where it was left out."""
        of = self._of
        if of.verification_failure:
            return VerifiedInBrief(None, of.verification_failure)
        return None if of.verification is None else VerifiedInBrief(of.verification)

    @property
    def swarm(self) -> SwarmReport | None:
        """The line by the particle swarm, as on the page; None where nobody asked for it."""
        swarm = self._of.swarm if isinstance(self._of, Note) else None
        return None if swarm is None else swarm.swarm

    @property
    def motion(self) -> MovedInBrief | None:
        """The line in motion in the load case that is shown; None where nobody asked for it."""
        return MovedInBrief.of(self._of.motion)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What an engineer should know before using the page."""
        return tuple(self.note.warnings)
