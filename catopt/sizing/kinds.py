"""What kind of value each input of a sizing is, and what is taken when it is left out."""

from __future__ import annotations

from functools import cache
from typing import Any

from catopt.casefile.sizing_file import Moored
from catopt.model.kinds import Flag, Kind, Measured, OneOf, Text, Whole
from catopt.numerals import bare_number
from catopt.sizing.inputs import Input, inputs_of
from catopt.units import Dimension, as_written


@cache
def kind_of(each: Input) -> Kind:
    """Make the kind that reads a value of an input, or each of several."""
    example: Any = each.example[0] if isinstance(each.example, tuple) else each.example
    match each.takes:
        case "TEXT":
            return Text()
        case "NAME" | "FILE":
            return Text(filled=True, example=as_written(example))
        case "WHICH":
            return OneOf(each.words)
        case "COUNT":
            return Whole(each.name, example)
        case "FLAG":
            return Flag()
    bounds = (each.above, each.at_least)
    return Measured(Dimension[each.takes], *bounds, example=as_written(example), bare=each.bare)


def from_text(each: Input, text: str) -> object:
    """Take a text as an option or an answer has it: a number without a unit is one."""
    return bare_number(text) if each.is_measure or each.takes == "COUNT" else text


@cache
def default_of(each: Input) -> Any:
    """Read what is taken of an input when it is left out; in SI."""
    value = kind_of(each).read(from_text(each, each.default))
    return (value,) if each.several else value


def usual(name: str, moored: Moored = "buoy") -> Any:
    """Return the default of an input by its name; in SI."""
    return default_of(inputs_of(moored)[name])
