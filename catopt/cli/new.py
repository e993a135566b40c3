"""``catopt new``: a commented file to start from."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from catopt.casefile.reading import Moored
from catopt.casefile.writing import TEMPLATES, template
from catopt.cli.completion import completed
from catopt.cli.options import JsonOption, LangOption
from catopt.cli.output import Printer
from catopt.cli.values import refused
from catopt.errors import InputError, Problem
from catopt.records import Record
from catopt.words import Listed, Message, term

_NAME = typer.Argument(metavar="NAME", autocompletion=completed("template"))


@dataclass(frozen=True)
class NewFile(Record):
    """A case file that was written to start from."""

    SCHEMA = "catopt.new/1"
    DOCUMENT = "template path"

    template: str
    """Name of the template."""
    path: str
    """Where the case file was written, as given or as chosen."""


def new(
    context: typer.Context,
    name: Annotated[str, _NAME],
    path: Annotated[Path | None, typer.Argument(metavar="PATH")] = None,
    lang: LangOption = "en",
    as_json: JsonOption = False,
    out: Annotated[Path | None, typer.Option("--out", metavar="FORM", help="form")] = None,
) -> None:
    """Write a commented file to start from."""
    output: Printer = context.obj
    if out is not None and path is None and out.suffix.lower() == ".xlsx":
        moored: Moored = "tanker" if "tanker" in name else "buoy"
        if moored not in name:
            raise refused("--out", str(out), Message("refused_command.goes_with_buoy_or_tanker"))
        from catopt.sizing.form import form

        _create(out, form(moored, lang))
        output.text(Message("beside.form_written", place=out))
        return
    path = path or out
    place = path or Path(f"{name}.toml")
    _create(place, template(name, lang))
    written, needs = [place], TEMPLATES[name].needs
    other = place.with_name(f"{needs}.toml")
    if needs and not other.exists():
        _create(other, template(needs, lang))
        written.append(other)
    if as_json:
        output.json(NewFile(name, str(place)).to_dict())
    else:
        files = Listed(map(str, written), "and")
        command, *options = TEMPLATES[name].command.split(" --")  # which go behind the file
        onward = " --".join([f"{command} {place}", *options])
        output.text(Message("beside.template_written", files=files, onward=onward))


def _create(place: Path, text: str | bytes) -> None:
    """Write a file that is not there yet; one that cannot be written whole is not left behind."""
    try:
        with place.open("xb") as stream:
            stream.write(text.encode() if isinstance(text, str) else text)
    except FileExistsError as error:
        raise _refused(place, Message("refused_command.there_already_kept_give_another")) from error
    except OSError as error:
        place.unlink(missing_ok=True)
        reason = term(error.strerror or str(error))
        raise _refused(place, Message("refused_command.not_written", reason=reason)) from error


def _refused(place: Path, why: Message) -> InputError:
    return InputError([Problem("path", str(place), why)])
