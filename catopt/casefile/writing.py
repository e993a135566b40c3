"""From a Case to a case file, and commented files to start from."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Collection, Iterator, Mapping, Sequence
from hashlib import sha256
from pathlib import Path as FilePath
from types import MappingProxyType
from typing import Any, Final, NamedTuple

from catopt.casefile.document import header
from catopt.casefile.schema import (
    CaseTable,
    NetworkTable,
    TableSchema,
    VariantsTable,
    WavesTable,
    WaveTrainTable,
    entries,
)
from catopt.documents import Path, unfit
from catopt.errors import refused
from catopt.model import (
    Case,
    CatalogueChoice,
    CurrentProfile,
    Design,
    Dynamics,
    Floater,
    HullAfloat,
    LoadCase,
    Motion,
    PointLoad,
    Segment,
    Service,
    Site,
    System,
    WaveState,
)
from catopt.model.kinds import Measured, OneOf
from catopt.model.line import StrainTable
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.model.sea import HARMONIC
from catopt.units import UNITS, Dimension, as_written
from catopt.words import Language, Message

_ESCAPES = str.maketrans({'"': '\\"', "\\": "\\\\", "\t": "\\t", "\n": "\\n"})
_NAMED_FILE = re.compile(r'^(\w*file) = "(.*)"$', re.MULTILINE)
_WIDTH = 100


def case_digest(case: Case | Network) -> str:
    """Return the SHA-256 of a case: of the text that `write_case` gives it, as `text_digest`."""
    return text_digest(write_case(case))


def text_digest(text: str) -> str:
    """Return the SHA-256 of a case file as `write_case` writes it, wherever its files are.

    The path of a file that it names stands for what the file holds; that of none for its name.
    """

    def held(named: re.Match[str]) -> str:
        path = FilePath(named[2])
        content = sha256(path.read_bytes()).hexdigest() if path.is_file() else path.name
        return f"{named[1]} = {content}"

    return sha256(_NAMED_FILE.sub(held, text).encode()).hexdigest()


def write_case(case: Case | Network) -> str:
    """Write a case as TOML, in SI with its units.

    Parameters
    ----------
    case : Case or Network
        What to write.

    Returns
    -------
    str
        Text that `parse_case` reads back as an equal case, to the last digit. What has no value
        (an EA of an inextensible segment, an unknown mass) is left out; a segment of a component
        takes it from the catalogue again. Paths are absolute.
    """
    if isinstance(case, Network):
        blocks = _blocks(NetworkTable, _given(case))
    else:
        # What a case has to say, by the keys of its file and in their order.
        site = case.site
        given = _given(case) | {"pso": case.swarm}
        del given["site"]
        if not site.is_in_air:
            given["site"] = _given(site) | {"water_depth": site.depth_to_seabed}
        ends = ("fairlead_height", "anchor_height")
        heights = {key: site.height_above_seabed(getattr(case, key)) for key in ends}
        given["line"] = heights | vars(case.line)
        if "system" in given:
            given["system"] = _around(case, given["system"])
        blocks = _blocks(CaseTable, {key: given[key] for key in entries(CaseTable) if key in given})
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def _blocks(
    schema: type[TableSchema], given: Mapping[str, Any], path: Path = (), *, array: bool = False
) -> Iterator[list[str]]:
    """Write a table and those below it, each as its lines; one that says nothing is not opened."""
    known = entries(schema)
    if lines := list(_lines(schema, given)):
        yield [header(path, array=array), *lines] if path else lines
    for key, value in given.items():
        inner = known[key].table if key in known else None
        if inner is not None:
            several = known[key].array
            for part in value if several else [value]:
                below = part if isinstance(part, dict) else _given(part)
                yield from _blocks(inner, below, (*path, key), array=several)


def _around(case: Case, system: System) -> dict[str, Any]:
    """Say what a system of equal lines, each like the case's, is; InputError for any other."""
    first, *_ = system.legs
    arrangement: dict[str, Any] = {
        "azimuths": [leg.azimuth for leg in system.legs],
        "anchor_radius": first.anchor_radius,
        "fairlead_radius": first.fairlead_radius,
        "force": system.force,
        "moment": system.moment,
        "yaw_free": system.yaw_free,
        "judged_line_out": system.judged_line_out,
    }
    around = System.around(
        case.line,
        fairlead_height=case.fairlead_height,
        anchor_height=case.anchor_height,
        seabed_friction=case.site.seabed_friction,
        **arrangement,
    )
    if around != system:
        found = Message("refused_file.lines_of_their_own")
        allowed = Message("refused_command.case_file_holds_equal_lines")
        raise refused("system", found, allowed, "write_case")
    if system.judged_line_out:
        del arrangement["judged_line_out"]
    return {key: value for key, value in arrangement.items() if value is not None}


_UNSAID: Final[Mapping[type, Mapping[str, object]]] = {
    Segment: {"EA": math.inf, "drag_method": "given"},
    Site: {"seabed_slope": 0.0, "contact_offset": 0.0},
    PointLoad: {"added_mass_coefficient": 0.0},
    Floater: {"wind_speed": 0.0, "wind_direction": 0.0},
    HullAfloat: {"memory": 100.0},
    LoadCase: {"state": "intact", "fairlead_rise": 0.0},
    Service: {"wear_rate": 0.0},
    Design: {"headings": 1},
    Point: {"submerged_weight": 0.0, "force": (0.0, 0.0, 0.0)},
    MooredBody: {"x": 0.0, "y": 0.0, "force": (0.0, 0.0), "moment": 0.0},
}
"""Keys that go unsaid at their default."""


def _given(part: object) -> dict[str, Any]:
    """Return what a part of the model has to say, by key; what is its default goes unsaid."""
    given = {
        key: value
        for key, value in vars(part).items()
        if value is not None and value is not False and value not in ("", ())
    }
    match part:
        case Segment():
            if part.nominal_diameter is not None:
                given["diameter"] = part.nominal_diameter
            if isinstance(part.EA, StrainTable):
                del given["EA"]
                given["strain"], given["strain_tension"] = part.EA.strain, part.EA.tension
            if part.component:  # which would give its own name to a segment without one
                given["name"] = part.name
        case CatalogueChoice():
            given["variants"] = part.by_quantity
        case LineBetween():
            given |= vars(part.line)
        case MooredBody(yaw_free=False):
            given["yaw_free"] = False
        case WaveState() if part.elevation_file:
            keys = ["stretching", "elevation_file", "elevation_x", "shortest_period", "direction"]
            given = {key: given[key] for key in keys if key in given}
        case WaveState():
            train = entries(WaveTrainTable) if part.spectrum else ()
            keys = [*train, "stretching", "seed", "trains"]
            given = {key: given[key] for key in keys if key in given}
    unsaid = _unsaid(part, given)
    return {key: value for key, value in given.items() if key not in unsaid}


def _unsaid(part: object, given: Mapping[str, Any]) -> Collection[str]:
    """List the keys that go unsaid, beside those with nothing."""
    match part:
        case CurrentProfile() if part.directions:
            return ("direction",)
        case Motion(period=None):
            return HARMONIC
        case Dynamics(broken_line=None):
            return ("broken_end", "broken_by")
        case Dynamics(broken_by="MBL"):
            return ("broken_end",)
    defaults = _UNSAID.get(type(part), {})
    return [key for key, default in defaults.items() if given.get(key) == default]


def _lines(schema: type[TableSchema], given: Mapping[str, Any]) -> Iterator[str]:
    """Write the keys of a table that are given, most in the order of the table."""
    known = entries(schema)
    for key in given if schema in (VariantsTable, WavesTable) else known:
        if key not in given or known[key].kind is None:
            continue
        kind, value = known[key].kind, given[key]
        unit = kind.si_unit if isinstance(kind, Measured) else None
        if key == "wear_rate":
            yield f"{key} = {_wear(value)}"
        elif known[key].array:
            yield _array(key, [_written(item, unit) for item in value])
        else:
            yield f"{key} = {_written(value, unit)}"


def _wear(rate: float) -> str:
    """Write a rate of wear (m/s) in mm a year, where that reads back as the same number."""
    unit = UNITS[Dimension.SPEED]["mm/year"]
    per_year = float(f"{rate / unit:.15g}")
    if per_year * unit == rate:
        return _written(per_year, "mm/year")
    return _written(rate, "m/s")


def _written(value: Any, unit: str | None) -> str:
    """Write a value; `unit` is that of a number, empty for a pure one, and None for all else."""
    if unit is not None:
        digits = repr(float(value))  # the shortest text that reads back as the same number
        return f'"{digits} {unit}"' if unit else digits
    if isinstance(value, str):
        if unfit(value):
            allowed = Message("refused_command.take_out", value=value[:40])
            raise refused("text", unfit(value), allowed)
        return f'"{value.translate(_ESCAPES)}"'
    return str(value).lower() if isinstance(value, bool) else str(int(value))


def _array(key: str, values: Sequence[str]) -> str:
    """Write a key with its array, on as many lines as it needs."""
    line = f"{key} = [{', '.join(values)}]"
    if len(line) <= _WIDTH:
        return line
    lines, row = [f"{key} = ["], ""
    for value in values:
        if row and len(f"  {row}{value},") > _WIDTH:
            lines.append(f"  {row.rstrip()}")
            row = ""
        row += f"{value}, "
    return "\n".join([*lines, f"  {row.rstrip()}", "]"])


class Template(NamedTuple):
    """What a template is of, and the command that takes its file: ``solve`` for most.

    `needs`: another template whose file it names.
    """

    about: str
    command: str = "solve"
    needs: str = ""


TEMPLATES: Mapping[str, Template] = MappingProxyType(
    {
        "buoy": Template("marker buoy on 20 m of chain, every key with a comment"),
        "tanker": Template("tanker on one chain with a sinker, two load cases", "check"),
        "leg": Template("chain, wire and chain with a clump weight, water levels", "check"),
        "system": Template("body moored by six lines", "system"),
        "points": Template("bridle and lines between points, some of them free joints", "system"),
        "design": Template("search for the chain, length and sinker of a buoy", "design"),
        "motion": Template("line in waves, current and motion", "verify --dynamic"),
        "floater": Template("buoy afloat on its line, in wind and waves", "verify --dynamic"),
        "study": Template("a case again and again, with what varies in it", "study", "buoy"),
        "size-buoy": Template("buoy in its weather, in place of options", "size buoy"),
        "size-tanker": Template("tanker in its weather, in place of options", "size tanker"),
    }
)
"""Templates by name."""


def template(name: str, language: Language = "en") -> str:
    """Return a commented file that its command takes as it stands.

    Parameters
    ----------
    name : str
        One of `TEMPLATES`.
    language : str
        Of its comments and its title; keys are the same in all.

    Returns
    -------
    str
        TOML.

    Raises
    ------
    InputError
        When there is no such template.
    """
    if name not in TEMPLATES:
        from catopt.catalogue.family import meant

        allowed = meant(Message("refused.one_of", words=", ".join(TEMPLATES)), name, TEMPLATES)
        raise refused("template", as_written(name), allowed)
    from importlib.resources import files

    own = files(__package__)
    text = (own / "templates" / f"{name}.toml").read_text(encoding="utf-8")
    if language != "en":
        said = tomllib.loads((own / f"comments.{language}.toml").read_text(encoding="utf-8"))
        text = "".join(_translated(line, said) for line in text.splitlines(keepends=True))
    return _with_others(text) if "{others}" in text else text


def _translated(line: str, said: Mapping[str, str]) -> str:
    """Say the comment or the title of a line in another language, by the English one."""
    if title := re.match('title = "(.*?)"', line):
        line = line.replace(title[1], said[title[1]])
    for mark in re.finditer("# ", line):
        comment = line[mark.end() :].rstrip("\n")
        if comment in said:
            return f"{line[: mark.end()]}{said[comment]}\n"
    return line


def _with_others(text: str) -> str:
    """Put the other words that a key takes where a comment has ``{others}``."""
    table: type[TableSchema] = CaseTable
    lines = []
    for line in text.splitlines(keepends=True):
        if header := re.match(r"(?:# )?\[+([\w.]+)\]+", line):
            table = CaseTable
            for part in header[1].split("."):
                table = entries(table)[part].table or table
        if "{others}" in line:
            key, value = re.findall(r"^(?:# )?(\w+) = (.*?)  +#", line)[0]
            kind = entries(table)[key].kind
            assert isinstance(kind, OneOf)
            others = [word for word in kind.words if f'"{word}"' not in value]
            line = line.replace("{others}", ", ".join(others))
        lines.append(line)
    return "".join(lines)
