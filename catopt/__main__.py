"""The command ``catopt``: every failure ends in a message and an exit status."""

from __future__ import annotations

import sys

TYPE_CHECKING = False  # so that nothing is loaded before Ctrl-C is heeded
if TYPE_CHECKING:
    from collections.abc import Sequence

    from catopt.cli.output import Printer

FAULT = 1
WRONG_INPUT = 2
INTERRUPTED = 130
"""128 + SIGINT: what a shell reports of a program that was interrupted."""

LONGEST_NAME = 60
"""Letters of the name of a file that are shown."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line with arguments, those of the process when left out.

    Returns the exit status: 0 done, 1 a fault of ours, 2 wrong input, 3 no answer exists, 4 not
    converged, 130 interrupted.
    """
    try:
        if arguments is None:  # the process is the program's own
            from catopt.interrupt import heed_signals
            from catopt.threads import one_thread

            heed_signals()
            one_thread()
        from contextvars import copy_context

        from catopt.cli.options import asked_language
        from catopt.cli.output import Printer
    except KeyboardInterrupt:  # while the program is still being loaded
        sys.stderr.write("catopt: interrupted\n")
        return INTERRUPTED
    output = Printer()
    asked = sys.argv[1:] if arguments is None else list(arguments)
    output.language = asked_language(asked)
    status = 0
    try:
        if arguments is None:
            from catopt.cli.output import guard_streams

            guard_streams()
        copy_context().run(_run, arguments, output)
    except KeyboardInterrupt:
        status = INTERRUPTED
    except SystemExit as stop:
        status = stop.code if isinstance(stop.code, int) else int(stop.code is not None)
    except Exception as error:
        status = _failed(error, output)
    if status == INTERRUPTED:
        output.note("catopt: interrupted")
    if arguments is None:
        from catopt.interrupt import no_interrupt_from_now

        no_interrupt_from_now()
    return status


def _run(arguments: Sequence[str] | None, output: Printer) -> None:
    from catopt.cli.app import command
    from catopt.cli.help_words import HELP_ALL, WHOLE, run

    typed = None if arguments is None else list(arguments)
    if HELP_ALL in (sys.argv if typed is None else typed):
        typed = ["--help" if each == HELP_ALL else each for each in typed or sys.argv[1:]]
        WHOLE.set(True)
    raise SystemExit(run(command, output.language, args=typed, prog_name="catopt", obj=output))


def _failed(error: Exception, output: Printer) -> int:
    """Say why there is no answer, with the traceback if asked for; returns the exit status."""
    from catopt.errors import CatoptError
    from catopt.interrupt import was_interrupted

    if isinstance(error, CatoptError) and error.exit_status != FAULT:
        output.refusal(error)
        return error.exit_status
    if (said := _of_the_place(error)) and not output.debug:
        from catopt.words import say

        output.note(f"catopt: {say(said, output.language)}")
        return WRONG_INPUT
    if was_interrupted() and not output.debug:  # what is stopped half-way says anything
        return INTERRUPTED
    if output.debug:
        from traceback import format_exception

        output.note("".join(format_exception(error)).rstrip())
        return FAULT
    what = f"{type(error).__name__}: {error}".splitlines()[0]
    output.note(
        f"catopt: a fault of catopt's own ({what})\n"
        "Run it again as 'catopt --debug ...' and report what that prints with your case file."
    )
    return FAULT


def _of_the_place(error: Exception) -> str:
    """Say what a file, a disk or the working directory does not do; empty for any other fault."""
    from errno import EDQUOT, ELOOP, ENAMETOOLONG, ENOSPC, EROFS
    from pathlib import Path

    if not isinstance(error, OSError):
        return ""
    try:
        Path.cwd()
    except FileNotFoundError:
        from catopt.words import Message

        return Message("beside.no_working_directory")
    if error.errno not in (EDQUOT, ELOOP, ENAMETOOLONG, ENOSPC, EROFS):
        return ""
    name = str(error.filename or "")
    short = name if len(name) <= LONGEST_NAME else f"{name[:LONGEST_NAME]}..."
    return f"{short}: {error.strerror}" if short else str(error.strerror)


if __name__ == "__main__":
    sys.exit(main())
