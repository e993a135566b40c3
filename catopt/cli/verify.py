"""``catopt verify``: the closed form beside the truss model."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import typer

from catopt.cli.options import (
    CaseArgument,
    DesignOption,
    JsonOption,
    LangOption,
    OnceOption,
    OutOption,
    ReportLanguage,
)
from catopt.verify.settings import ELEMENTS, TOLERANCE, check_settings
from catopt.words import say

if TYPE_CHECKING:
    from catopt.answers.blocks import Answer
    from catopt.checks.result import CheckReport
    from catopt.cli.output import Output
    from catopt.model import Case
    from catopt.notes.front_in_motion import FrontInMotion
    from catopt.verify.case import Design, FrontVerification
    from catopt.verify.dynamic_result import DynamicVerification
    from catopt.verify.proof import Proof
    from catopt.verify.result import Verification
    from catopt.words import Language

    _Found = Verification | FrontVerification

DIFFERS = 3
"""Of --strict: the input is right, but the models do not agree."""

STOPPED = 4
"""Of --all: for a design a solver did not converge; of --dynamic: a maximum hangs on the step."""

INTERRUPTED = 130
"""Of --dynamic: Ctrl-C; what was computed until then is printed and written."""


class _Moved(NamedTuple):
    """Lines in motion, and the checks of their tensions."""

    found: DynamicVerification
    checks: CheckReport

    def to_dict(self) -> dict[str, Any]:
        return self.found.to_dict() | {"checks": self.checks.motion_document()}


def verify(
    context: typer.Context,
    case: CaseArgument,
    load_case: Annotated[
        str | None,
        typer.Option(
            "--load-case",
            metavar="NAME",
            help="Verify this load case only; when left out every one, or the [load].",
        ),
    ] = None,
    design: DesignOption = None,
    every: Annotated[
        bool,
        typer.Option(
            "--all",
            help="Verify every design of the front in the result directory CASE, each in the load "
            "case that governs it; with --dynamic each in motion under every load case.",
        ),
    ] = False,
    elements: Annotated[
        int,
        typer.Option(
            metavar="N",
            help="Bars of a line on the coarsest of the three meshes; the others have 2 N and 4 N.",
        ),
    ] = ELEMENTS,
    tolerance: Annotated[
        float,
        typer.Option(
            metavar="X",
            help="Largest difference that counts as agreement: of the fairlead tension, of the "
            "line's length, in rad.",
        ),
    ] = TOLERANCE,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict",
            help="End with exit status 3 when the models do not agree; the answer is printed.",
        ),
    ] = False,
    with_motion: Annotated[
        bool,
        typer.Option(
            "--dynamic",
            help="Also run the line in time, in the waves, the current and the motion of the case "
            "file. Ctrl-C keeps what was computed until then.",
        ),
    ] = False,
    once: OnceOption = False,
    twice_the_bars: Annotated[
        bool,
        typer.Option(
            "--twice-the-bars",
            help="Of --dynamic: run again with twice the bars, too, also a line that stays taut.",
        ),
    ] = False,
    workers: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            help="Of --dynamic: run the seeds ([dynamics] runs) in N processes side by side; "
            "where it saves time on all cores when left out.",
        ),
    ] = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Compare the closed form with a truss model that shares nothing with it.

    Prints every quantity by both models, with the order by which the truss model closes up over
    three meshes and the difference before and after extrapolation. A line on which they differ is
    an answer: the exit status is 0 unless --strict is given.
    """
    output: Output = context.obj
    if out is not None:
        from catopt.report.files import check_directory

        check_directory(out)
    _refuse_without_motion(
        workers, with_motion=with_motion, once=once, twice_the_bars=twice_the_bars
    )
    check_settings(elements, tolerance, source="options", prefix="--")
    found: _Found
    dynamic: _Moved | FrontInMotion | None = None
    proof: Proof = "none" if once else "bars" if twice_the_bars else "step"
    if every:
        _refuse(load_case, design)
        found = _front(case, output, elements, tolerance)
        read = _case_of_front(case)
        if with_motion:
            dynamic = _front_in_motion(case, output, proof, workers)
    else:
        read = _read(case, design, with_motion=with_motion)
        if with_motion and read.site.seabed_slope != 0.0:
            from catopt.verify.result import Verification

            found = Verification(read, ())  # there is no closed form to compare with
        else:
            found = _case(read, output, load_case, elements, tolerance)
        if with_motion:
            dynamic = _dynamic(read, output, load_case, proof, workers)
    if out is not None:
        from catopt.cli.result_files import write_result

        files = _files(found, dynamic, lang.value)
        write_result(output, out, files, read, front=case if every else None)
    if as_json:
        output.json(_document(found, dynamic))
    else:
        _show(output, found, dynamic, lang.value)
    _stop_in_motion(output, dynamic, lang)
    _end(output, found, strict=strict)


def _document(found: _Found, dynamic: _Moved | FrontInMotion | None) -> dict[str, Any]:
    return found.to_dict() | ({} if dynamic is None else {"dynamic": dynamic.to_dict()})


def _answer(found: _Found) -> Answer:
    from catopt.answers.verification import front_answer, verification_answer
    from catopt.verify.case import FrontVerification

    if isinstance(found, FrontVerification):
        return front_answer(found)
    return verification_answer(found)


def _answer_in_motion(dynamic: _Moved | FrontInMotion, *, with_series: bool = False) -> Answer:
    if isinstance(dynamic, _Moved):
        from catopt.answers.motion import motion_answer

        return motion_answer(dynamic.found, dynamic.checks, with_series=with_series)
    from catopt.answers.front_in_motion import front_in_motion_answer

    return front_in_motion_answer(dynamic)


def _show(
    output: Output, found: _Found, dynamic: _Moved | FrontInMotion | None, language: Language
) -> None:
    from catopt.render.terminal import show

    answer = _answer(found)
    if dynamic is not None:
        moved = _answer_in_motion(dynamic)
        answer = replace(answer, sections=(*answer.sections, *moved.sections))
    show(output, answer, language)


def _files(
    found: _Found, dynamic: _Moved | FrontInMotion | None, language: Language
) -> dict[str, bytes]:
    """Make the files of --out; a line in motion has tables, a workbook and figures of its own."""
    from catopt.render.files import files_of
    from catopt.render.plain import document_bytes
    from catopt.report.bundle import motion_pictures, verification_pictures
    from catopt.verify.result import Verification

    document = _document(found, dynamic)
    if isinstance(found, Verification) and not found.parts:
        files = {"verify.json": document_bytes(document)}  # nothing at rest is compared
    else:
        files = files_of(_answer(found), document, language)
    if isinstance(found, Verification):
        files |= verification_pictures(found)
    if dynamic is not None:
        files |= files_of(_answer_in_motion(dynamic, with_series=True), None, language)
    if isinstance(dynamic, _Moved):
        files |= motion_pictures(dynamic.found)
    return files


def _stop_in_motion(
    output: Output, dynamic: _Moved | FrontInMotion | None, lang: ReportLanguage
) -> None:
    """Leave with 130 where a run was stopped, with 4 where one has not converged."""
    if isinstance(dynamic, _Moved):
        if not dynamic.found.is_complete:
            from catopt.verify.motion_words import stopped_sentence

            output.note(f"catopt: {say(stopped_sentence(dynamic.found), lang.value)}")
            raise typer.Exit(INTERRUPTED)
        stop_if_not_converged(output, dynamic.found, lang)
    elif dynamic is not None:
        if not dynamic.is_complete:
            raise typer.Exit(INTERRUPTED)
        if not dynamic.has_converged:
            output.note("catopt: for a design in motion a solver did not converge")
            raise typer.Exit(STOPPED)


def _end(output: Output, found: _Found, *, strict: bool) -> None:
    """Leave with the exit status that the comparison at rest asks for."""
    from catopt.answers.verification import front_sentence, verdict_sentence
    from catopt.verify.case import FrontVerification

    if isinstance(found, FrontVerification) and not found.has_converged:
        output.note("catopt: for a design a solver did not converge")
        raise typer.Exit(STOPPED)
    if strict and not found.is_settled:
        sentence = (
            front_sentence(found)
            if isinstance(found, FrontVerification)
            else verdict_sentence(found)
        )
        output.note(f"catopt: {sentence}")
        raise typer.Exit(DIFFERS)


def stop_if_not_converged(output: Output, found: DynamicVerification, lang: ReportLanguage) -> None:
    """Leave with the status of a solver that did not converge, where a line in motion has not."""
    if found.verdict == "not converged":
        from catopt.verify.motion_words import not_converged_sentence

        output.note(f"catopt: {say(not_converged_sentence(found), lang.value)}")
        raise typer.Exit(STOPPED)


def _read(path: Path, design: int | None, *, with_motion: bool) -> Case:
    """Read the case; what a line in motion lacks is told before anything is solved."""
    from catopt.casefile.design_directory import read_case_or_design
    from catopt.cli.state import with_known_codes

    case = with_known_codes(read_case_or_design(path, design))
    if with_motion:
        _check_for_motion(case)
    return case


def _check_for_motion(case: Case) -> None:
    from catopt.checks.motion import check_strengths
    from catopt.verify.dynamic_setup import check_for_motion, read_drive

    check_for_motion(case)
    read_drive(case)
    check_strengths(case)


def _case(
    case: Case, output: Output, load_case: str | None, elements: int, tolerance: float
) -> Verification:
    from catopt.verify.case import verify_case

    with output.progress("Load cases") as tell:
        return verify_case(
            case, load_case=load_case, elements=elements, tolerance=tolerance, progress=tell
        )


def _dynamic(
    case: Case, output: Output, load_case: str | None, proof: Proof, workers: int | None
) -> _Moved:
    from catopt.notes.motion import checks_in_motion
    from catopt.verify.dynamic import verify_dynamic

    with output.progress("Line in motion") as tell:
        found = verify_dynamic(
            case,
            load_case=load_case,
            proof=proof,
            workers=workers,
            progress=tell,
            announce=lambda words: output.note(f"catopt: {words}"),
        )
    return _Moved(found, checks_in_motion(found))


def _case_of_front(directory: Path) -> Case:
    from catopt.casefile import read_case
    from catopt.casefile.design_directory import DESIGN_CASE

    return read_case(directory / DESIGN_CASE)


def _front(directory: Path, output: Output, elements: int, tolerance: float) -> FrontVerification:
    designs = _designs(directory)
    title = _case_of_front(directory).title
    from catopt.verify.case import verify_front

    with output.progress("Designs") as tell:
        return verify_front(title, designs, elements=elements, tolerance=tolerance, progress=tell)


def _front_in_motion(
    directory: Path, output: Output, proof: Proof, workers: int | None
) -> FrontInMotion:
    from catopt.casefile.design_directory import read_design_document
    from catopt.notes.front_in_motion import front_in_motion

    document, designs = read_design_document(directory), _designs(directory)
    for each in designs:
        _check_for_motion(each.case)
    objectives = [
        tuple(entry[key] for key in document["objectives"]) for entry in document["front"]
    ]
    with output.progress("Designs in motion") as tell:
        return front_in_motion(
            [(d.number, d.case, own) for d, own in zip(designs, objectives, strict=True)],
            document["recommended"] + 1,
            proof=proof,
            workers=workers,
            progress=tell,
        )


def _refuse(load_case: str | None, design: int | None) -> None:
    from catopt.errors import InputError, Problem

    given = {"--load-case": load_case, "--design": design}
    problems = [
        Problem(option, str(value), "does not go with --all, which takes every design in the load "
        "case that governs it")
        for option, value in given.items()
        if value is not None
    ]  # fmt: skip
    if problems:
        raise InputError(problems, "options")


def _refuse_without_motion(
    workers: int | None, *, with_motion: bool, once: bool, twice_the_bars: bool
) -> None:
    """Refuse what says how a line in motion is proven, where none is run or in two ways."""
    from catopt.errors import InputError, Problem

    given = {
        "--once": once, "--twice-the-bars": twice_the_bars, "--workers": workers is not None,
    }  # fmt: skip
    problems = [
        Problem(option, "", "goes with --dynamic, which is missing")
        for option, is_given in given.items()
        if is_given and not with_motion
    ]
    if once and twice_the_bars:
        problems.append(Problem("--once", "", "does not go with --twice-the-bars"))
    if workers is not None and workers < 1:
        problems.append(Problem("--workers", str(workers), "1 or more processes"))
    if problems:
        raise InputError(problems, "options")


def _designs(directory: Path) -> list[Design]:
    """Read every design of a front with the load case that governs it."""
    from catopt.casefile.design_directory import read_design, read_design_document

    front = read_design_document(directory)["front"]
    cases = [read_design(directory, number) for number in range(1, len(front) + 1)]
    from catopt.verify.case import Design

    return [
        Design(number, case, _governing_load_case(entry, case))
        for number, (case, entry) in enumerate(zip(cases, front, strict=True), start=1)
    ]


def _governing_load_case(entry: dict[str, Any], case: Case) -> str | None:
    """Find the load case of the check that governs a design; None where none is named."""
    for check in entry["checks"]:
        if f"{check['name']} ({check['load_case']})" == entry["governing"]:
            names = {state.name for state in case.load_cases}
            return str(check["load_case"]) if check["load_case"] in names else None
    return None
