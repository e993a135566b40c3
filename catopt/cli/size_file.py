"""A file in place of the options of ``catopt size``; options go before it.

Every key of the file stands for one option. What is wrong is told by the key where the file gave
the value, or gives none, and by the option where that was given.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from collections.abc import Iterator

    import typer

    from catopt.casefile.sizing_file import Moored, SizingFile
    from catopt.documents import Path as KeyPath
    from catopt.errors import Problem

__all__ = ["OPTIONS", "Filled", "fill", "is_file", "key_of"]

_COMMON: Final = {
    "site.water_depth": "--depth",
    "site.low_water": "--low-water",
    "site.water_density": "--water-density",
    "environment.wind": "--wind",
    "environment.current": "--current",
    "environment.hs": "--hs",
    "environment.hmax": "--hmax",
    "environment.period": "--period",
    "line.components": "--chain",
    "line.diameter_min": "--diameter-min",
    "line.diameter_max": "--diameter-max",
    "line.length_step": "--length-step",
    "line.prefer": "--prefer",
    "sinker.material": "--sinker",
    "sinker.density": "--sinker-density",
    "sinker.soil": "--soil",
    "sinker.friction": "--friction",
    "checks.code": "--code",
    "checks.allow_recalled": "--recalled",
    "service.life": "--life",
    "service.wear_rate": "--wear",
    "buoy.file": "--buoys",
}

OPTIONS: Final[Mapping[Moored, Mapping[str, str]]] = MappingProxyType(
    {
        "buoy": MappingProxyType(
            _COMMON
            | {
                "environment.marine_growth": "--growth",
                "buoy.name": "BUOY",
                "buoy.horizontal_force": "--force",
                "buoy.reserve_buoyancy": "--reserve-buoyancy",
                "buoy.keel_depth": "--keel-depth",
            }
        ),
        "tanker": MappingProxyType(
            _COMMON
            | {
                "ship.length": "--length",
                "ship.breadth": "--breadth",
                "ship.draught": "--draught",
                "ship.ballast_draught": "--ballast-draught",
                "ship.moulded_depth": "--moulded-depth",
                "ship.deadweight": "--dwt",
                "ship.frontal_area": "--frontal-area",
                "ship.lateral_area": "--lateral-area",
                "ship.fairlead_above_water": "--fairlead",
                "buoy.name": "--buoy",
                "buoy.hawser_length": "--hawser",
                "line.clump_weights": "--clump-weight",
                "system.lines": "--lines",
                "system.pretension": "--pretension",
                "anchor.name": "--anchor",
                "anchor.soil": "--soil",
            }
        ),
    }
)
"""The option that each key stands for."""

_OVERRULED: Final = {
    "--soil": ("sinker.friction",),
    "--friction": ("sinker.soil",),
    "--force": ("buoy.name",),
    "--reserve-buoyancy": ("buoy.name",),
}
"""Keys that an option goes before beside its own, for they are another way to say the same."""

_SINKER: Final = "sinker"
_KEEL: Final = ("buoy", "keel_depth")


def is_file(name: str | None) -> bool:
    """Say whether what stands where a buoy's name may stand is a file."""
    if name is None:
        return False
    return name.endswith(".toml") or "/" in name or os.sep in name or Path(name).is_file()


def key_of(option: str, file: SizingFile, *, held_by_sinker: bool) -> KeyPath | None:
    """Return the path of the key that an option stands for; None where there is none.

    Parameters
    ----------
    option : str
        Its name; that of one of several values is ``--clump-weight (2)``.
    file : SizingFile
        Of the buoy or the tanker.
    held_by_sinker : bool
        Which soil is meant.
    """
    from catopt.casefile.location import parts

    name, _, number = option.partition(" (")
    if file.moored == "tanker" and name == "BUOY":
        name = "--buoy"
    keys = [key for key, each in OPTIONS[file.moored].items() if each == name]
    if not keys:
        return None
    key = keys[0] if held_by_sinker or len(keys) == 1 else keys[1]
    return (*parts(key), *((int(number.rstrip(")")) - 1,) if number else ()))


@dataclass(frozen=True)
class Filled:
    """Options, filled up from a file if there is one.

    Attributes
    ----------
    options : dict
        By name: a text, a list of texts, a whole number or a flag; None: left out.
    file : SizingFile or None
        Where the rest came from.
    typed : frozenset of str
        Options that were typed.
    """

    options: dict[str, Any]
    file: SizingFile | None = None
    typed: frozenset[str] = frozenset()

    @property
    def is_sound(self) -> bool:
        """Whether nothing is wrong with the file in itself."""
        return self.file is None or not self.file.findings

    @contextmanager
    def telling(self) -> Iterator[None]:
        """Tell what is wrong by the keys of the file; nothing is done with a file at fault."""
        from catopt.errors import InputError

        file = self.file
        if file is None:
            yield
            return
        try:
            yield
        except InputError as error:
            if error.source != "options" and self.is_sound:
                raise  # of another file
            of_options = error.problems if error.source == "options" else ()
            raise file.error(self._by_key(problem) for problem in of_options) from None
        if not self.is_sound:
            raise file.error()

    def _by_key(self, problem: Problem) -> tuple[KeyPath | None, Problem]:
        """Name the keys of the file in place of options that were not typed."""
        from catopt.documents import dotted

        def named(found: re.Match[str]) -> str:
            path = self._key(found[0])
            return found[0] if path is None else dotted(path)

        allowed = re.sub(r"--[a-z]+(-[a-z]+)*", named, problem.allowed)
        path = self._key(problem.key)
        if path == _KEEL and "BUOY" in self.options and self.options["BUOY"] is not None:
            path = ("buoy", "name")  # which the depth of the keel comes from
            allowed = f"its chain is made fast {problem.found} under water; {allowed}"
        return path, replace(problem, allowed=allowed)

    def _key(self, option: str) -> KeyPath | None:
        if option.partition(" (")[0] in self.typed or self.file is None:
            return None
        held = self.options.get("--anchor", _SINKER) == _SINKER
        return key_of(option, self.file, held_by_sinker=held)


def fill(
    context: typer.Context, options: dict[str, Any], place: str | None, moored: Moored
) -> Filled:
    """Fill up what was not typed from a file.

    Parameters
    ----------
    context : typer.Context
        Knows what was typed.
    options : dict
        By name, defaults among them.
    place : str or None
        Of the file; None: there is none.
    moored : {"buoy", "tanker"}
        Which of the two kinds of file is wanted.

    Raises
    ------
    InputError
        The file cannot be read. What is wrong in it is told later, with all the rest.
    """
    if place is None:
        return Filled(options)
    from catopt.casefile.sizing_file import read_sizing
    from catopt.documents import dotted

    file = read_sizing(place, moored)
    typed = _typed(context)
    overruled = {key for option in typed for key in _OVERRULED.get(option, ())}
    filled = dict(options)
    if "sinker" in file.document and moored == "tanker" and "--anchor" not in typed:
        filled["--anchor"] = _SINKER
    held_by_sinker = filled.get("--anchor", _SINKER) == _SINKER
    for path, value in file.values.items():
        key = dotted(path)
        option = OPTIONS[moored].get(key)
        of_other_hold = path[0] == ("anchor" if held_by_sinker else "sinker")
        if option is None or option in typed or key in overruled:
            continue
        if of_other_hold and moored == "tanker":
            continue
        filled[option] = _as_typed(value)
    if filled["--buoys"] is not None and "--buoys" not in typed:
        filled["--buoys"] = Path(file.folder) / filled["--buoys"]
    return Filled(filled, file, typed)


def _typed(context: typer.Context) -> frozenset[str]:
    """List the options that were typed, by name."""
    found = set()
    for parameter in context.command.params:
        source = context.get_parameter_source(parameter.name or "")
        if parameter.opts and source is not None and source.name != "DEFAULT":
            found.add(parameter.opts[0])
    return frozenset(found)


def _as_typed(value: Any) -> Any:
    """Write a value in SI as an option has it; what is no measure stays."""
    if isinstance(value, list):
        return [_as_typed(each) for each in value]
    return repr(value) if isinstance(value, float) else value
