"""``catopt reproduce``: published figures beside catopt's own."""

from __future__ import annotations

from typing import Annotated

import typer

from catopt.answers.reproduction import reproduction_answer
from catopt.cli.answering import Asked, answering
from catopt.cli.completion import completed
from catopt.cli.options import OutOption

_NAME = typer.Argument(metavar="NAME", autocompletion=completed("study"))


@answering(OutOption, without=["units"])
def reproduce(asked: Asked, name: Annotated[str | None, _NAME] = None) -> None:
    """Recompute published figures and judge each printed number."""
    from catopt.reproduce import book
    from catopt.reproduce import reproduce as recompute

    asked.check_place()
    with asked.output.progress("Swarm runs") as tell:
        result = recompute(name, progress=tell)

    def further() -> dict[str, bytes]:
        from catopt.report.bundle import reproduction_pictures

        return {"reproduction.md": book(result).encode()} | reproduction_pictures(result)

    asked.give(reproduction_answer(result), result.to_dict, further=further)
