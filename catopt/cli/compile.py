"""``catopt compile``: machine code of every kernel function, made now and kept."""

from __future__ import annotations

import typer

from catopt.cli.output import Printer
from catopt.words import Message


def compile_all(context: typer.Context) -> None:
    """Compile all that catopt compiles, once, and keep it for every later run."""
    from time import perf_counter

    from catopt.compile_jobs import JOBS, compile_always

    output: Printer = context.obj
    with compile_always(), output.progress(Message("beside.parts_compiled")) as tell:
        for done, (name, job) in enumerate(JOBS.items()):
            if tell is not None:
                tell(done, len(JOBS))
            start = perf_counter()
            job()
            output.text(f"{name}: {perf_counter() - start:.1f} s")
