"""The command ``catopt``: every failure ends in a message and an exit status."""

from __future__ import annotations

import sys
from collections.abc import Sequence

__all__ = ["main"]

INTERRUPTED = 130
"""128 + SIGINT: what a shell reports of a program that was interrupted."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : sequence of str, optional
        Without the program's name; those of the process when left out.

    Returns
    -------
    int
        Exit status: 0 done, 1 a fault of ours, 2 wrong input, 3 no answer exists,
        4 not converged, 130 interrupted.
    """
    from catopt.cli.output import Output

    output = Output()
    try:
        return _run(arguments, output)
    except KeyboardInterrupt:
        status = INTERRUPTED
    except SystemExit as stop:
        status = stop.code if isinstance(stop.code, int) else 0
    except Exception as error:  # noqa: BLE001 - the last stop before the user
        status = _report(error, output)
    if status == INTERRUPTED:
        output.note("catopt: interrupted")
    return status


def _run(arguments: Sequence[str] | None, output: object) -> int:
    from catopt.cli.app import app

    app(args=None if arguments is None else list(arguments), prog_name="catopt", obj=output)
    return 0
