"""``catopt fatigue``: how long a line lasts in the sea states of a year."""

from __future__ import annotations

from catopt.answers.verification import fatigue_answer, fatigue_sentence
from catopt.casefile.reading import read_mooring_or_design
from catopt.cli import options
from catopt.cli.answering import FAILED, STOPPED, Asked, answering
from catopt.cli.values import with_known_codes
from catopt.words import say


@answering(options.TablesOutOption)
def fatigue(
    asked: Asked,
    case: options.CaseArgument,
    load_case: options.LoadCaseOption = None,
    once: options.OnceOption = False,
    workers: options.CountOption = None,
    strict: options.StrictOption = False,
) -> None:
    """Find the damage of each segment in a year of the sea states of [fatigue], and its life."""
    from catopt.verify.fatigue import verify_fatigue

    asked.check_place()
    read = with_known_codes(read_mooring_or_design(case, None))
    with asked.output.progress("Sea states") as tell:
        report = verify_fatigue(
            read,
            load_case=load_case,
            convergence_check="none" if once else "step",
            workers=workers,
            progress=tell,
            announce=lambda words: asked.output.note(f"catopt: {say(words, asked.language)}"),
        )
    asked.give(fatigue_answer(report), report.to_dict, read)
    if report.verdict == "not converged" or (strict and not report.passes):
        status = STOPPED if report.verdict == "not converged" else FAILED
        asked.leave(status, fatigue_sentence(report))
