"""The truss model beside the closed form: what a note shows of it, and what it leaves in doubt."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.errors import CatoptError
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.model import Case
    from catopt.verify.result import Verification


def both_models(case: Case, load_case: str = "") -> tuple[Verification | None, str]:
    """Solve a body, or a line under its load, by both models; say why where there is no answer.

    `load_case` is the name of the load case that is the load of a line.
    """
    from catopt.verify.case import LOAD, verify_case

    try:
        if case.system is not None:
            return verify_case(case), ""
        found = verify_case(replace(case, load_cases=()))
    except CatoptError as error:
        return None, error.message
    (part,) = found.parts
    return replace(found, parts=(replace(part, name=load_case or LOAD),)), ""


def doubts_of_models(found: Verification | None, failure: str, what: str) -> Iterator[str]:
    """Yield what the truss model leaves in doubt, of a "line" or a "body"."""
    if found is not None and not found.is_settled:
        differ = found.verdict == "differs"
        yield Message("notes.models_differ" if differ else "notes.models_unresolved")
    if failure:
        yield Message(f"notes.{what}_not_verified", why=failure)
