"""``catopt verify``: the closed form beside the truss model."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, TypeAlias

import typer

from catopt.cli import options
from catopt.cli.answering import FAILED, INTERRUPTED, STOPPED, Asked, answering
from catopt.cli.values import read_known, refuse
from catopt.errors import Problem
from catopt.verify.settings import ELEMENTS, TOLERANCE, check_settings
from catopt.words import say

if TYPE_CHECKING:
    from collections.abc import Iterator

    from catopt.answers.blocks import Answer
    from catopt.checks.result import CheckReport
    from catopt.model import Case
    from catopt.notes.front_in_motion import FrontInMotion
    from catopt.verify.case import Design, FrontVerification
    from catopt.verify.dynamic_result import DynamicVerification
    from catopt.verify.proof import Proof
    from catopt.verify.result import Verification

    _AtRest = Verification | FrontVerification
    _InMotion: TypeAlias = "_Moved | FrontInMotion | None"


class _Moved(NamedTuple):
    """Lines in motion, and the checks of their tensions."""

    found: DynamicVerification
    checks: CheckReport

    def to_dict(self) -> dict[str, Any]:
        return self.found.to_dict() | {"checks": self.checks.motion_document()}


@answering(options.OutOption)
def verify(
    asked: Asked,
    case: options.CaseArgument,
    load_case: options.LoadCaseOption = None,
    design: options.DesignOption = None,
    every: Annotated[bool, typer.Option("--all")] = False,
    elements: Annotated[int, typer.Option(metavar="N")] = ELEMENTS,
    tolerance: Annotated[float, typer.Option(metavar="X")] = TOLERANCE,
    strict: options.StrictOption = False,
    with_motion: Annotated[bool, typer.Option("--dynamic")] = False,
    once: options.OnceOption = False,
    twice_the_bars: Annotated[bool, typer.Option("--twice-the-bars")] = False,
    workers: options.CountOption = None,
) -> None:
    """Compare the closed form with a truss model that shares nothing with it."""
    asked.check_place()
    proofs = {"--once": once, "--twice-the-bars": twice_the_bars}
    refuse(_of_motion(proofs, workers, with_motion=with_motion))
    check_settings(elements, tolerance, source="options", prefix="--")
    proof: Proof = "none" if once else "bars" if twice_the_bars else "step"
    how = {"elements": elements, "tolerance": tolerance}
    moving = {"proof": proof, "workers": workers} if with_motion else None
    found: _AtRest
    dynamic: _InMotion
    if every:
        wanted = "does not go with --all, which takes every design in the load case that governs it"
        given = {"--load-case": load_case, "--design": design}
        refuse(Problem(key, str(each), wanted) for key, each in given.items() if each is not None)
        read, found, dynamic = _front(asked, case, how, moving)
    else:
        read, found, dynamic = _case(asked, read_known(case, design), load_case, how, moving)
    at_rest, in_motion = _answers(found, dynamic)

    def document() -> dict[str, Any]:
        return found.to_dict() | ({} if dynamic is None else {"dynamic": dynamic.to_dict()})

    if asked.out is not None:
        files = _files(asked, found, dynamic, document())
        asked.write(files, read, front=case if every else None)
    sections = () if in_motion is None else in_motion.sections
    asked.show(replace(at_rest, sections=(*at_rest.sections, *sections)), document)
    _leave(asked, found, dynamic, strict=strict)


def _of_motion(
    proofs: dict[str, bool], workers: int | None, *, with_motion: bool
) -> Iterator[Problem]:
    """Yield what says how a line in motion is proven, where none is run or in two ways."""
    for option, is_given in {**proofs, "--workers": workers is not None}.items():
        if is_given and not with_motion:
            yield Problem(option, "", "goes with --dynamic, which is missing")
    if all(proofs.values()):
        yield Problem("--once", "", "does not go with --twice-the-bars")
    if workers is not None and workers < 1:
        yield Problem("--workers", str(workers), "1 or more processes")


# ------------------------------------------------------------------ one case


def _case(
    asked: Asked,
    case: Case,
    load_case: str | None,
    how: dict[str, Any],
    moving: dict[str, Any] | None,
) -> tuple[Case, Verification, _Moved | None]:
    """Verify a case; what a line in motion lacks is told before anything is solved."""
    from catopt.verify.case import verify_case
    from catopt.verify.result import Verification

    if moving is not None:
        _check_for_motion(case)
    if moving is not None and case.site.seabed_slope != 0.0:
        found = Verification(case, ())  # there is no closed form to compare with
    else:
        with asked.output.progress("Load cases") as tell:
            found = verify_case(case, load_case=load_case, progress=tell, **how)
    if moving is None:
        return case, found, None
    from catopt.notes.motion import checks_in_motion
    from catopt.verify.dynamic import verify_dynamic

    with asked.output.progress("Line in motion") as tell:
        moved = verify_dynamic(
            case,
            load_case=load_case,
            progress=tell,
            announce=lambda words: asked.output.note(f"catopt: {words}"),
            **moving,
        )
    return case, found, _Moved(moved, checks_in_motion(moved))


def _check_for_motion(case: Case) -> None:
    from catopt.checks.motion import check_strengths
    from catopt.verify.dynamic_setup import check_for_motion, read_drive

    check_for_motion(case)
    read_drive(case)
    check_strengths(case)


# ------------------------------------------------------------------ a front of designs


def _front(
    asked: Asked, directory: Path, how: dict[str, Any], moving: dict[str, Any] | None
) -> tuple[Case, FrontVerification, FrontInMotion | None]:
    """Verify every design of a front in the load case that governs it, and in motion."""
    from catopt.casefile import read_case
    from catopt.casefile.design_directory import DESIGN_CASE, read_design_document
    from catopt.verify.case import verify_front

    document = read_design_document(directory)
    designs = list(_designs(directory, document["front"]))
    case = read_case(directory / DESIGN_CASE)
    with asked.output.progress("Designs") as tell:
        found = verify_front(case.title, designs, progress=tell, **how)
    if moving is None:
        return case, found, None
    from catopt.notes.front_in_motion import front_in_motion

    for each in designs:
        _check_for_motion(each.case)
    objectives = [
        tuple(entry[key] for key in document["objectives"]) for entry in document["front"]
    ]
    with asked.output.progress("Designs in motion") as tell:
        moved = front_in_motion(
            [(d.number, d.case, own) for d, own in zip(designs, objectives, strict=True)],
            document["recommended"] + 1,
            progress=tell,
            **moving,
        )
    return case, found, moved


def _designs(directory: Path, front: list[dict[str, Any]]) -> Iterator[Design]:
    """Read every design of a front with the load case of the check that governs it, if any."""
    from catopt.casefile.design_directory import read_design
    from catopt.verify.case import Design

    for number, entry in enumerate(front, start=1):
        case = read_design(directory, number)
        states = {state.name for state in case.load_cases}
        governing = [
            check["load_case"]
            for check in entry["checks"]
            if f"{check['name']} ({check['load_case']})" == entry["governing"]
        ]
        is_state = bool(governing) and governing[0] in states
        yield Design(number, case, governing[0] if is_state else None)


# ------------------------------------------------------------------ what came of it


def _answers(
    found: _AtRest, dynamic: _InMotion, *, with_series: bool = False
) -> tuple[Answer, Answer | None]:
    """Lay out what was found at rest, and in motion."""
    from catopt.answers.verification import front_answer, verification_answer
    from catopt.verify.case import FrontVerification

    if isinstance(found, FrontVerification):
        at_rest = front_answer(found)
    else:
        at_rest = verification_answer(found)
    if dynamic is None:
        return at_rest, None
    if isinstance(dynamic, _Moved):
        from catopt.answers.motion import motion_answer

        return at_rest, motion_answer(dynamic.found, dynamic.checks, with_series=with_series)
    from catopt.answers.motion import front_in_motion_answer

    return at_rest, front_in_motion_answer(dynamic)


def _files(
    asked: Asked,
    found: _AtRest,
    dynamic: _InMotion,
    document: dict[str, Any],
) -> dict[str, bytes]:
    """Make the files of --out; a line in motion has tables, a workbook and figures of its own."""
    from catopt.render.files import document_bytes, files_of
    from catopt.report.bundle import motion_pictures, verification_pictures
    from catopt.verify.result import Verification

    at_rest, in_motion = _answers(found, dynamic, with_series=True)
    if isinstance(found, Verification) and not found.parts:
        files = {"verify.json": document_bytes(document)}  # nothing at rest is compared
    else:
        files = files_of(at_rest, document, asked.language)
    if isinstance(found, Verification):
        files |= verification_pictures(found)
    if in_motion is not None:
        files |= files_of(in_motion, None, asked.language)
    if isinstance(dynamic, _Moved):
        files |= motion_pictures(dynamic.found)
    return files


def stop_if_not_converged(asked: Asked, found: DynamicVerification) -> None:
    """Leave with the status of a solver that did not converge, where a line in motion has not."""
    if found.verdict == "not converged":
        from catopt.verify.motion_words import not_converged_sentence

        asked.leave(STOPPED, say(not_converged_sentence(found), asked.language))


def _leave(asked: Asked, found: _AtRest, dynamic: _InMotion, *, strict: bool) -> None:
    """Leave where a run was stopped, one did not converge, or the models differ at rest."""
    from catopt.answers.verification import front_sentence, verdict_sentence
    from catopt.verify.case import FrontVerification

    if isinstance(dynamic, _Moved):
        if not dynamic.found.is_complete:
            from catopt.verify.motion_words import stopped_sentence

            asked.leave(INTERRUPTED, say(stopped_sentence(dynamic.found), asked.language))
        stop_if_not_converged(asked, dynamic.found)
    elif dynamic is not None:
        if not dynamic.is_complete:
            raise typer.Exit(INTERRUPTED)
        if not dynamic.has_converged:
            asked.leave(STOPPED, "for a design in motion a solver did not converge")
    if isinstance(found, FrontVerification):
        if not found.has_converged:
            asked.leave(STOPPED, "for a design a solver did not converge")
        sentence = front_sentence(found)
    else:
        sentence = verdict_sentence(found)
    if strict and not found.is_settled:
        asked.leave(FAILED, sentence)
