"""``--units`` of every command that prints an answer."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from enum import StrEnum
from functools import wraps
from typing import Annotated, Any, TypeVar

import typer

Command = TypeVar("Command", bound=Callable[..., None])


class ForceUnits(StrEnum):
    """Units of forces."""

    TONNE_FORCE = "tf"
    KILONEWTON = "kN"
    SI = "si"


_OPTION = Annotated[
    ForceUnits | None,
    typer.Option(
        "--units",
        metavar="UNITS",
        envvar="CATOPT_UNITS",
        show_envvar=False,
        help="Units of tables, figures and notes: tf or kN for forces, or si for all; if left out, "
        "CATOPT_UNITS of the environment, or else the usual unit of each. JSON is in SI.",
    ),
]


def in_units(command: Command) -> Command:
    """Give a command ``--units`` behind its ``--lang``; its answer is then shown in them."""

    @wraps(command)
    def in_wanted_units(*args: Any, units: ForceUnits | None = None, **options: Any) -> None:
        from catopt.render.units import UNITS

        before = UNITS.set("" if units is None else units.value)
        try:
            command(*args, **options)
        finally:
            UNITS.reset(before)

    own = inspect.signature(command, eval_str=True).parameters
    made = inspect.Parameter(
        "units", inspect.Parameter.KEYWORD_ONLY, default=None, annotation=_OPTION
    )
    place = list(own).index("lang") + 1
    parameters = [*own.values()]
    kinds = inspect.Parameter.KEYWORD_ONLY
    last = [each.replace(kind=kinds) for each in parameters[place:]]
    signature = inspect.Signature([*parameters[:place], made, *last])
    in_wanted_units.__signature__ = signature  # type: ignore[attr-defined]
    return in_wanted_units  # type: ignore[return-value]
