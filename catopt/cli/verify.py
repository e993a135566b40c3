"""``catopt verify``: the closed form beside the truss model."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.answers.blocks import Answer
from catopt.answers.design import front_in_motion_answer
from catopt.answers.motion import motion_answer, ship_answer
from catopt.answers.verification import (
    front_answer,
    front_sentence,
    verdict_sentence,
    verification_answer,
)
from catopt.casefile import write_case
from catopt.casefile.reading import (
    DESIGN_CASE,
    read_case_or_design,
    read_design,
    read_design_document,
    read_mooring_or_design,
)
from catopt.cli import options
from catopt.cli.answering import FAILED, INTERRUPTED, STOPPED, Asked, Documents, Files, answering
from catopt.cli.values import refuse, with_known_codes
from catopt.errors import Problem
from catopt.model import Case
from catopt.model.network import Network, require_case
from catopt.verify.convergence_check import ELEMENTS, TOLERANCE, ConvergenceCheck, check_settings
from catopt.verify.motion_words import not_converged_sentence, stopped_sentence
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.notes.front_in_motion import FrontInMotion
    from catopt.verify.case import Design, FrontVerification
    from catopt.verify.dynamic_result import DynamicVerification
    from catopt.verify.result import Verification
    from catopt.verify.ship_result import ShipVerification


@dataclass(frozen=True)
class _Found:
    """What came of a case, or of every design of a front."""

    case: Case | Network
    at_rest: Verification | FrontVerification
    sentence: str
    answers: tuple[Answer, ...]
    pictures: tuple[Files, ...] = ()
    in_motion: Documents = dict
    stop: Callable[[], None] = lambda: None
    """Leaves where a solver did not converge or was stopped."""


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
    scheduler: Annotated[str | None, typer.Option(metavar="ADDRESS")] = None,
) -> None:
    """Compare the closed form with a truss model that shares nothing with it."""
    asked.check_place()
    proofs = {"--once": once, "--twice-the-bars": twice_the_bars}
    refuse(_of_motion(proofs, workers, with_motion=with_motion))
    refuse(_of_cluster(scheduler, workers, is_moving_front=every and with_motion))
    check_settings(elements, tolerance, source="options", prefix="--")
    convergence_check: ConvergenceCheck = "none" if once else "bars" if twice_the_bars else "step"
    how = {"elements": elements, "tolerance": tolerance}
    moving = {"convergence_check": convergence_check, "workers": workers} if with_motion else None
    if every:
        wanted = Message("refused_command.does_not_go_with_all")
        given = {"--load-case": load_case, "--design": design}
        refuse(
            Problem(key, str(value), wanted) for key, value in given.items() if value is not None
        )
        found = _front(asked, case, how, moving, scheduler)
    else:
        read = read_mooring_or_design(case, design)
        if isinstance(read, Case):
            read = with_known_codes(read)
        found = _one(asked, read, load_case, how, moving)

    def document() -> dict[str, Any]:
        return found.at_rest.to_dict() | found.in_motion()

    if asked.out is not None:
        from catopt.render.files import document_bytes, files_of

        files = {"verify.json": document_bytes(document())}
        for answer in found.answers:
            files |= files_of(answer, None, asked.language)
        for draw in found.pictures:
            files |= draw()
        asked.write(files, found.case, front=case if every else None)
    sections = tuple(section for answer in found.answers for section in answer.sections)
    asked.show(replace(found.answers[0], sections=sections), document)
    found.stop()
    if strict and not found.at_rest.is_settled:
        asked.leave(FAILED, found.sentence)


def _of_motion(
    proofs: dict[str, bool], workers: int | None, *, with_motion: bool
) -> Iterator[Problem]:
    """Yield what says how a line in motion is proven, where none is run or in two ways."""
    for option, is_given in {**proofs, "--workers": workers is not None}.items():
        if is_given and not with_motion:
            yield Problem(option, "", Message("refused_command.goes_with_dynamic_which_missing"))
    if all(proofs.values()):
        yield Problem("--once", "", Message("refused_command.does_not_go_with_twice"))


def _of_cluster(
    scheduler: str | None, workers: int | None, *, is_moving_front: bool
) -> Iterator[Problem]:
    """Yield what says where designs in motion are run, where none are, or in two ways."""
    if scheduler is not None and not is_moving_front:
        wanted = Message("refused_command.goes_with_all_and_dynamic")
        yield Problem("--scheduler", scheduler, wanted)
    if scheduler is not None and workers is not None:
        wanted = Message("refused_command.does_not_go_with_scheduler")
        yield Problem("--workers", str(workers), wanted)
    if workers is not None and workers < 1:
        yield Problem("--workers", str(workers), Message("refused_command.n_1_or_more_processes"))


# ------------------------------------------------------------------ one case, or one network


def _one(
    asked: Asked,
    case: Case | Network,
    load_case: str | None,
    how: dict[str, Any],
    moving: dict[str, Any] | None,
) -> _Found:
    """Verify a case or a network; what lines in motion lack is told before anything is solved."""
    from catopt.report import bundle
    from catopt.verify.case import verify_case
    from catopt.verify.result import Verification

    if (
        moving is not None
        and isinstance(case, Case)
        and case.floater
        and case.floater.on_two_scales
    ):
        return _ship(asked, case, load_case, moving)
    if moving is not None:
        _check_for_motion(case)
    if moving is not None and case.site.seabed_slope != 0.0:
        at_rest = Verification(case, ())  # there is no closed form to compare with
    else:
        with asked.output.progress(Message("beside.load_cases")) as tell:
            at_rest = verify_case(case, load_case=load_case, progress=tell, **how)
    answers = (verification_answer(at_rest),) if at_rest.parts else ()
    pictures = (partial(bundle.verification_pictures, at_rest),)
    found = _Found(case, at_rest, verdict_sentence(at_rest), answers, pictures)
    return found if moving is None else _moved(asked, found, load_case, moving)


def _moved(asked: Asked, found: _Found, load_case: str | None, moving: dict[str, Any]) -> _Found:
    """Run in time what was verified at rest; what was asked for stands first."""
    from catopt.notes.motion import checks_in_motion
    from catopt.report import bundle
    from catopt.verify.dynamic import verify_dynamic

    with asked.output.progress(Message("motion.title")) as tell:
        moved = verify_dynamic(
            found.case,
            load_case=load_case,
            progress=tell,
            announce=lambda words: asked.output.note(f"catopt: {words}"),
            **moving,
        )
    checks = checks_in_motion(moved)
    answer = motion_answer(moved, checks, with_series=asked.out is not None)
    return replace(
        found,
        answers=(answer, *found.answers),
        pictures=(*found.pictures, partial(bundle.motion_pictures, moved, asked.language)),
        in_motion=lambda: {"dynamic": replace(moved, checks=checks.in_motion).to_dict()},
        stop=partial(stop_in_doubt, asked, moved),
    )


def _ship(asked: Asked, case: Case, load_case: str | None, moving: dict[str, Any]) -> _Found:
    """Run the ship of a case on two time scales; the truss model has no part in it."""
    from catopt.verify.result import Verification
    from catopt.verify.two_scales import verify_ship

    wanted = Message("refused_command.does_not_go_with_ship")
    given = {
        "--load-case": load_case is not None,
        "--twice-the-bars": moving["convergence_check"] == "bars",
        "--workers": moving["workers"] is not None,
    }
    refuse(Problem(key, "", wanted) for key, is_given in given.items() if is_given)
    with asked.output.progress(Message("beside.ship_in_motion")) as tell:
        moved = verify_ship(case, progress=tell)
    return _Found(
        case,
        Verification(case, ()),
        "",
        (ship_answer(moved),),
        pictures=(partial(_led_files, moved),),
        in_motion=lambda: {"ship": moved.to_dict()},
    )


def _led_files(moved: ShipVerification) -> dict[str, bytes]:
    """Write what leads the ship's lines in the truss model, and the case that does so."""
    from catopt.verify.ship_result import DRIFT, RAOS, drift_csv, led_case, raos_csv

    texts = {RAOS: raos_csv(moved), DRIFT: drift_csv(moved)}
    texts["lines_in_motion.toml"] = write_case(led_case(moved))
    return {name: text.encode() for name, text in texts.items()}


def stop_in_doubt(asked: Asked, moved: DynamicVerification) -> None:
    """Leave where a line in motion was stopped, or its solver did not converge."""
    if not moved.is_complete:
        asked.leave(INTERRUPTED, stopped_sentence(moved))
    if moved.verdict == "not converged":
        asked.leave(STOPPED, not_converged_sentence(moved))


def _check_for_motion(case: Case | Network) -> None:
    from catopt.checks.case import check_strengths
    from catopt.verify.dynamic_setup import check_for_motion, read_drive

    check_for_motion(case)
    read_drive(case)
    check_strengths(case)


# ------------------------------------------------------------------ a front of designs


def _front(
    asked: Asked,
    directory: Path,
    how: dict[str, Any],
    moving: dict[str, Any] | None,
    scheduler: str | None,
) -> _Found:
    """Verify every design of a front in the load case that governs it, and in motion."""
    from catopt.verify.case import verify_front

    document = read_design_document(directory)
    designs = list(_designs(directory, document["front"]))
    case = read_case_or_design(directory / DESIGN_CASE, None)
    with asked.output.progress(Message("beside.designs")) as tell:
        front = verify_front(case.title, designs, progress=tell, **how)
    stop = partial(_stop_front, asked, front, None)
    found = _Found(case, front, front_sentence(front), (front_answer(front),), stop=stop)
    if moving is None:
        return found
    from catopt.notes.front_in_motion import front_in_motion

    for design in designs:
        _check_for_motion(design.case)
    objectives = [
        tuple(entry[key] for key in document["objectives"]) for entry in document["front"]
    ]
    with ExitStack() as stack:
        executor = None
        if scheduler is not None:
            from catopt.study.run import cluster

            executor, _ = stack.enter_context(cluster(scheduler))
        tell = stack.enter_context(asked.output.progress(Message("beside.designs_in_motion")))
        moved = front_in_motion(
            [(d.number, d.case, own) for d, own in zip(designs, objectives, strict=True)],
            document["recommended"] + 1,
            executor=executor,
            progress=tell,
            **moving,
        )
    return replace(
        found,
        answers=(front_in_motion_answer(moved), *found.answers),
        in_motion=lambda: {"dynamic": moved.to_dict()},
        stop=partial(_stop_front, asked, front, moved),
    )


def _stop_front(asked: Asked, front: FrontVerification, moved: FrontInMotion | None) -> None:
    """Leave where designs in motion were stopped, or a solver did not converge for one."""
    if moved is not None and not moved.is_complete:
        raise typer.Exit(INTERRUPTED)
    if moved is not None and not moved.has_converged:
        asked.leave(STOPPED, Message("beside.not_converged_in_motion"))
    if not front.has_converged:
        asked.leave(STOPPED, Message("beside.not_converged"))


def _designs(directory: Path, front: list[dict[str, Any]]) -> Iterator[Design]:
    """Read every design of a front with the load case of the check that governs it, if any."""
    from catopt.verify.case import Design

    for number, entry in enumerate(front, start=1):
        case = require_case(read_design(directory, number), str(directory))
        states = {state.name for state in case.load_cases}
        governing = [
            check["load_case"]
            for check in entry["checks"]
            if f"{check['name']} ({check['load_case']})" == entry["governing"]
        ]
        is_state = bool(governing) and governing[0] in states
        yield Design(number, case, governing[0] if is_state else None)
