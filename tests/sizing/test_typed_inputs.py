"""The typed keywords of a sizing are those of the table of inputs."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from typing import Any, get_type_hints

import pytest

from catopt.casefile.reading import Moored
from catopt.errors import InputError
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.keywords import size_buoy, size_tanker
from catopt.units import Dimension

SIZES: dict[Moored, Callable[..., Any]] = {"buoy": size_buoy, "tanker": size_tanker}


@pytest.mark.parametrize("moored", list(SIZES))
def test_every_input_is_a_keyword_with_its_type(moored: Moored) -> None:
    hints = get_type_hints(SIZES[moored])
    assert {name: hints[name] for name in list(hints)[1:-2]} == {
        name: type_of(each) for name, each in inputs_of(moored).items()
    }
    assert list(hints)[-2:] == ["misspelt", "return"]


@pytest.mark.parametrize("moored", list(SIZES))
def test_help_has_every_input_with_its_unit_and_default(moored: Moored) -> None:
    said = inspect.getdoc(SIZES[moored]) or ""
    parameters = said.partition("Parameters\n")[2].partition("\n\nReturns\n")[0]
    for name, each in inputs_of(moored).items():
        head, _, meaning = parameters.partition(f"\n{name} : ")[2].partition("\n    ")
        assert meaning, name
        if each.is_measure and Dimension[each.takes] is not Dimension.NUMBER:
            assert head.startswith(f"{Dimension[each.takes].si_unit}, "), name
        if each.default:
            assert f"; if left out, {each.default}" in meaning.split("\n")[0], name


def test_a_misspelt_keyword_is_told_the_right_one() -> None:
    with pytest.raises(InputError, match="did you mean depth"):
        size_buoy("pillar 1.8 m", dept="12 m")  # type: ignore[arg-type]


def type_of(each: Input) -> object:
    """Return a number with text, a whole one, a flag or a text; of several a sequence, too."""
    one = {"FLAG": bool, "COUNT": int}.get(each.takes, str)
    kinds = float | str if each.is_measure else one
    return (kinds | Sequence[kinds] if each.several else kinds) | None  # type: ignore[valid-type]
