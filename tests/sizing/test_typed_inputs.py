"""The typed keywords of a sizing are those of the table of inputs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import get_type_hints

import pytest

from catopt.casefile.reading import Moored
from catopt.sizing.inputs import Input, inputs_of
from catopt.sizing.keywords import BuoyInputs, TankerInputs

KEYWORDS: dict[Moored, type] = {"buoy": BuoyInputs, "tanker": TankerInputs}


@pytest.mark.parametrize("moored", list(KEYWORDS))
def test_every_input_is_a_keyword_with_its_type(moored: Moored) -> None:
    assert get_type_hints(KEYWORDS[moored]) == {
        name: type_of(each) for name, each in inputs_of(moored).items()
    }


def type_of(each: Input) -> object:
    """Return a number with text, a whole one, a flag or a text; of several a sequence, too."""
    one = {"FLAG": bool, "COUNT": int}.get(each.takes, str)
    kinds = float | str if each.is_measure else one
    return kinds | Sequence[kinds] if each.several else kinds  # type: ignore[valid-type]
