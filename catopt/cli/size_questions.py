"""What ``catopt size`` asks for on a terminal when it was not given."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.cli.wizard import Question
    from catopt.render.texts import Words

__all__ = ["Given", "asked_buoy", "asked_tanker"]

Given = dict[str, Any]
"""Options by name as they were given: mostly texts. None: left out."""


def asked_buoy(given: Given, words: Words) -> Given:
    """Ask on a terminal, when what a buoy needs was not given."""
    by_force = given["--force"] is not None or given["--reserve-buoyancy"] is not None
    is_known = given["BUOY"] is not None or (
        given["--force"] is not None and given["--reserve-buoyancy"] is not None
    )
    if given["--depth"] is not None and is_known:
        return given
    from catopt.cli.wizard import Question, ask, is_watched
    from catopt.loads import buoys
    from catopt.units import Dimension

    if not is_watched():
        return given
    if given["BUOY"] is None and not by_force:
        names = (*(each.name for each in buoys()), "own")
        question = Question("BUOY", "Buoy", "pillar 1.8 m", None, names)
        answer = ask([question], given, words)["BUOY"]
        by_force = answer == "own"
        given = given if by_force else {**given, "BUOY": answer}
    questions: list[Question] = []
    if by_force:
        questions += [
            Question("--force", "Horizontal force on the buoy", "", Dimension.FORCE),
            Question("--reserve-buoyancy", "Its reserve buoyancy", "", Dimension.FORCE),
        ]
    return _with_place(given, questions, words, soil=True, is_pushed=not by_force)


def asked_tanker(given: Given, words: Words) -> Given:
    """Ask on a terminal, when what a ship needs was not given."""
    wanted = ("--length", "--breadth", "--draught", "--depth")
    if all(given[each] is not None for each in wanted):
        return given
    from catopt.cli.wizard import Question, is_watched
    from catopt.units import Dimension

    if not is_watched():
        return given
    questions = [
        Question("--length", "Length of the ship over all", "", Dimension.LENGTH),
        Question("--breadth", "Breadth", "", Dimension.LENGTH),
        Question("--draught", "Draught, loaded", "", Dimension.LENGTH),
    ]
    return _with_place(given, questions, words, soil=False)


def _with_place(
    given: Given,
    questions: list[Question],
    words: Words,
    *,
    soil: bool,
    is_pushed: bool = True,
) -> Given:
    """Ask the questions and those of the place; what stands in the file of defaults is offered."""
    from catopt.cli.size_options import DEFAULTS
    from catopt.cli.wizard import Question, ask
    from catopt.loads.sinker import SOIL_FRICTION
    from catopt.units import Dimension

    asked = ask(
        [*questions, Question("--depth", "Water depth at high water", "", Dimension.LENGTH)],
        given,
        words,
    )
    high = asked.get("--depth") or given["--depth"] or ""
    further = [Question("--low-water", "Water depth at low water", high, Dimension.LENGTH)]
    if is_pushed:
        further += [
            Question("--wind", "Wind at 10 m", DEFAULTS["--wind"], Dimension.SPEED),
            Question("--current", "Tidal current", DEFAULTS["--current"], Dimension.SPEED),
        ]
    if given["--hmax"] is None:
        further.append(
            Question("--hs", "Significant wave height", DEFAULTS["--hs"], Dimension.LENGTH)
        )
    if soil and given["--friction"] is None:
        further.append(Question("--soil", "Soil", "fine or silty sand", None, tuple(SOIL_FRICTION)))
    return {**given, **asked, **ask(further, given, words)}
