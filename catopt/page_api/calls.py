"""The questions of the page, their answers, and the page around them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import lru_cache, partial, wraps
from typing import TYPE_CHECKING, Any, Final, TypeVar, cast

from markupsafe import Markup

from catopt._version import identity
from catopt.answers.blocks import (
    Answer,
    Brief,
    CardBlock,
    Facts,
    Figure,
    Section,
    Text,
    Verdict,
    Warnings,
    section,
)
from catopt.casefile.reading import parse_case
from catopt.documents import parse_toml
from catopt.errors import CatoptError, InputError, refused
from catopt.page_api.fields import (
    DOORS,
    START,
    Door,
    at_rest_of,
    can_run,
    door_of,
    fields_of,
    refuse_other,
    text_of,
    values_of,
)
from catopt.render.values import UNITS
from catopt.words import LANGUAGES, Language, Measure, Message, is_said, say, term

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.checks.verdict import Who
    from catopt.model import Case
    from catopt.mooring.case import SystemReport
    from catopt.quantities import Units
    from catopt.sizing import Sizing

_WAVES: Final = '<path class="wave" d="M2 22q5-4 10 0t10 0 10 0 10 0 10 0 10 0"/>'
_PICTURES: Final = {
    "buoy": Markup(
        f'{_WAVES}<path class="body" d="M28 24v-6h3V6h2v12h3v6z"/>'
        '<path class="rope" d="M32 24q-2 12-22 13"/><path class="body" d="M4 34h8v4H4z"/>'
    ),
    "tanker": Markup(
        f'{_WAVES}<path class="body" d="M22 17h38v9H27z"/><path class="body" d="M52 10h6v7h-6z"/>'
        '<path class="rope" d="M23 18q-4 17-16 19"/><path class="body" d="m3 38 4-5 4 5z"/>'
    ),
    "line": Markup(
        f'{_WAVES}<path class="rope" d="M58 22Q46 37 6 37"/><path class="body" d="m3 38 4-5 4 5z"/>'
        '<circle class="body" cx="58" cy="21" r="3"/>'
    ),
    "body": Markup(
        '<circle class="body" cx="32" cy="20" r="6"/><path class="rope" d="M32 14V3M37 17l19-8'
        'M37 23l19 8M32 26v11M27 23 8 31M27 17 8 9"/>'
    ),
}
"""What the doors look like."""


def shell(language: Language = "en", *, runs: bool | None = None) -> str:
    """Render the body of the page as HTML, every word in a language.

    `runs`: whether lines can be run in time where it is shown; by what is here when left out.

    Examples
    --------
    >>> 'data-key="site.water_depth"' in shell("vi")
    True
    """
    from catopt.render.page import template

    rendered = template("catopt.page_api", "shell.html").render(
        language=language,
        languages=[(code, say(Message("desk.own_name"), code)) for code in LANGUAGES],
        doors=DOORS,
        fields={door: fields_of(door, runs=runs) for door in DOORS},
        runs=can_run() if runs is None else runs,
        start=START,
        say=lambda key: say(Message(f"desk.{key}"), language),
        words=partial(say, language=language),
        pictures=_PICTURES,
        unit_of=lambda label: Message("desk.unit_of", label=label),
        slider=lambda label: Message("desk.slider", label=label),
        footer=say(Message("page.footer", version=identity()), language),
    )
    return rendered.removesuffix("\n")


Question = Mapping[str, Any]
Reply = dict[str, Any]
Asked = TypeVar("Asked", bound=Callable[..., Any])

_FILE: Final = re.compile(r"""\w*file\s*=|buoys\s*=|["'][^"'\n]*\.[A-Za-z]""")
"""A key of files, or a value that may be the name of one."""


def ask(call: str, question: Question) -> Reply:
    """Answer a question, one of `CALLS`.

    It has ``text``, a case file or a file for ``catopt size``, or ``door``, ``values`` by key and
    ``base``, of which it is made. Also ``lang`` and ``units``, as the command line has them, and
    ``kept``: the text that ``"compare"`` puts the answer beside, and ``app``: whether lines can be
    run from where it is shown. ``"run"`` sizes in motion, and returns when it has, or ``"stop"``
    was asked; ``"progress"`` says how far it is. What is returned was asked for; or
    ``problems``, each with key, found and allowed, ``message`` and ``status``, the command's exit
    status, when there is no answer.

    Examples
    --------
    >>> ask("solve", {"text": ""})["status"]
    2
    """
    wrong = _wrong(call, question)
    if wrong:
        return {"problems": [], "message": wrong, "status": 2}
    if call in ABOUT_A_RUN:
        from catopt.page_api import runs

        return runs.stop() if call == "stop" else runs.progress()
    language = cast("Language", question.get("lang", "en"))
    who: Who = "app" if question.get("app") else "page"
    before = UNITS.set(cast("Units", question.get("units", "")))
    try:
        made = (question.get("door", "line"), question.get("values", {}), question.get("base", ""))
        text = question["text"] if "text" in question else text_of(*made)
        _door(text)  # refuses what no door is for
        if call in _DOCUMENTS:
            return _DOCUMENTS[call](text)
        if call == "compare":
            return _compare(question.get("kept", ""), text, language)
        if call == "note":
            return _note(text, language)
        if call == "files":
            return _files(text, language)
        if call == "run" and not _ran(text):
            return {"stopped": True}
        # Draw the answer at every step of a slider; the whole has every table of the command.
        from catopt.render.page import card, fragment

        answer = _laid_out(text, is_whole=call in ("whole", "run"), who=who)
        drawn, more = answer.sections[:1], answer.sections[1:]
        return {
            "html": fragment(replace(answer, sections=drawn), language),
            "more": fragment(replace(answer, sections=more), language) if more else "",
            "card": card(answer, language),
            **_beside(text, language),
            **_open(text),
        }
    except CatoptError as error:  # its words are the command's
        problems = [
            {
                "key": problem.key,
                "found": say(problem.found, language),
                "allowed": say(problem.allowed, language),
            }
            for problem in (error.problems if isinstance(error, InputError) else ())
        ]
        message = "" if problems else say(error.message, language)
        return {"problems": problems, "message": message, "status": error.exit_status}
    finally:
        UNITS.reset(before)


def _wrong(call: str, question: Question) -> str:
    """Say what is wrong with a question in itself; empty when nothing is."""
    allowed = {"lang": LANGUAGES, "units": ("", "tf", "kN", "si"), "door": DOORS}
    if call not in CALLS:
        return f"no such question: {call}"
    for key, words in allowed.items():
        if key in question and question[key] not in words:
            return f"{key}: {question[key]!r} is none of {', '.join(words)}"
    is_text = all(isinstance(question.get(key, ""), str) for key in ("text", "base", "kept"))
    values = question.get("values", {})
    is_form = isinstance(values, Mapping) and all(
        isinstance(value, str) for value in values.values()
    )
    return "" if is_text and is_form else "text, base, kept and values are texts"


def _kept(function: Asked) -> Asked:
    """Answer once what is asked again; not where a text may name a file, which may change."""
    once = lru_cache(maxsize=8)(function)

    @wraps(function)
    def call(text: str, *more: Any, **named: Any) -> Any:
        return (function if _FILE.search(text) else once)(text, *more, **named)

    return cast("Asked", call)


def _case(text: str) -> Case:
    from catopt.checks.profiles import profiles_of

    case = parse_case(text)
    profiles_of(case.checks)
    return case


def _sizing(text: str, door: Door) -> Sizing:
    """Give the sizing in motion where it was run, else that at rest: a slider waits for no run."""
    return _in_motion(text) or _at_rest(text, door)


def _in_motion(text: str) -> Sizing | None:
    if not can_run():
        return None
    from catopt.page_api.runs import found_in_motion

    return found_in_motion(text)


@_kept
def _at_rest(text: str, door: Door) -> Sizing:
    """Size once what its note and its document are asked of, too."""
    from catopt.sizing.file import parse_file, sized

    if can_run():
        text = at_rest_of(door, text)
    elif parse_toml(text, "").get("motion", {}).get("run"):
        raise refused("motion.run", "true", Message("desk.no_runs", kind=door))
    return sized(parse_file(text, cast("Any", door)), at_rest=True)


def _ran(text: str) -> bool:
    """Run a sizing in motion; whether it came to its end. Of a line there is nothing to run."""
    door = _door(text)
    if door in ("line", "body"):
        return True
    if not can_run():
        raise refused("motion.run", "true", Message("desk.no_runs", kind=door))
    from catopt.page_api.runs import run

    return run(text, door) is not None


def _door(text: str) -> Door:
    try:
        return door_of(parse_toml(text, ""))
    except InputError:
        refuse_other(text)
        raise


# ------------------------------------------------------------------ the commands' documents


def _of_a_line(call: str, text: str) -> Reply:
    from catopt.catenary.case import solve_case
    from catopt.catenary.case_curve import curve_case
    from catopt.checks.case import check_case

    answered: dict[str, Callable[[Case], Any]]
    answered = {"solve": solve_case, "check": check_case, "curve": curve_case}
    reply: Reply = answered[call](_case(text)).to_dict()
    return reply


def _system(text: str) -> Reply:
    report, checks = _checked(text)
    return report.to_dict() | {"checks": checks.brief.to_dict()}


def _checked(text: str) -> tuple[SystemReport, CheckReport]:
    from catopt.checks.system import check_system
    from catopt.mooring.case import report_system

    case = _case(text)
    report = report_system(case)
    return report, check_system(case, report)


def _open(text: str) -> Reply:
    door = _door(text)
    return {"door": door, "values": values_of(door, text), "text": text}


def _name(door: Door) -> str:
    return "case.toml" if door in ("line", "body") else "sizing.toml"


# ------------------------------------------------------------------ what the page shows


def _beside(text: str, language: Language) -> Reply:
    """Say what was taken of what was not given, and which other lines there are, of a sizing."""
    from catopt.answers.size_card import other_words
    from catopt.figures.sizing import choices

    door = _door(text)
    if door not in ("buoy", "tanker"):
        return {}
    of = _sizing(text, door)
    assumed = {
        taken.of.key: say(Message("desk.assumed", value=taken.said), language)
        for taken in of.inputs
        if taken.origin != "given"
    }
    others = [
        {
            "key": "line.prefer",
            "value": other.prefer,
            "name": say(term(other.prefer), language),
            "words": say(other_words(of, other), language),
        }
        for other in of.alternatives
        if other.settled is not None and not is_said(other_words(of, other), "sizing.same_line")
    ]
    return {"assumed": assumed, "others": others[:3], "choices": choices(of)[1]}


def _laid_out(text: str, *, is_whole: bool, who: Who = "page") -> Answer:
    return _answer(text, is_whole=is_whole, who=who, is_run=_in_motion(text) is not None)


@_kept
def _answer(text: str, *, is_whole: bool, who: Who, is_run: bool) -> Answer:  # noqa: ARG001
    """Answer once what is asked again in other words or units, or compared."""
    door = _door(text)
    if door == "line":
        first, others, on_card = _line(text, readout=is_whole)
    elif door == "body":
        first, others, on_card = _body(text)
    else:
        first, others, on_card = _sized(text, door, who)
    sections = (first, *(section for other in others for section in other.sections if is_whole))
    named = []
    for number, part in enumerate(sections):  # results of a line stand beside its drawing
        news = (e for e in part.blocks if not (isinstance(e, Facts) and e.name == "summary"))
        named.append(Section(part.title, tuple(news), f"part-{number}"))
    return Answer("desk", others[0].title, tuple(named), Message("desk.kind"), on_card)


def _compare(kept: str, text: str, language: Language) -> Reply:
    """Lay out an answer beside one that was kept."""
    from catopt.answers.of_result import comparison
    from catopt.render.page import fragment

    door = _door(text)
    before = values_of(door, kept) if _door(kept) == door else {}
    now = values_of(door, text)
    inputs = [
        (field.label, before.get(field.key, ""), now.get(field.key, ""))
        for field in fields_of(door)
        if before.get(field.key, "") != now.get(field.key, "")
    ]
    of_kept, present = _laid_out(kept, is_whole=True), _laid_out(text, is_whole=True)
    beside = comparison(of_kept, present, inputs)
    return {"html": fragment(replace(present, sections=(beside,)), language)}


_Laid = tuple[Section, list[Answer], tuple[CardBlock, ...]]
"""What is drawn, all that the commands say, and the same on a card."""


def _line(text: str, *, readout: bool) -> _Laid:
    """Lay a line out; what the drawings say where one points waits until a slider rests."""
    from catopt.answers.check import check_answer, failing_checks, governing_sentence
    from catopt.answers.solution import result_facts, solution_answer
    from catopt.catalogue.family import chain_words
    from catopt.catenary.case import solve_case, under_a_load
    from catopt.checks.case import check_case
    from catopt.figures.line import line_in_water, tension_along

    case = _case(text)
    case.check_still_water()
    solution = solve_case(case)
    report = check_case(case)
    depth = under_a_load(case)[0].site.water_depth
    factor = solution.safety_factor
    allowed = [part.MBL and part.MBL / factor for part in solution.segments]
    basis = Message("figures.MBL_over", factor=factor)
    first = section(
        "desk.answer",
        Warnings((*solution.warnings, *report.warnings)),
        Figure(line_in_water(solution, depth, failing_checks(report), readout=readout)),
        Facts("results", result_facts(solution), Message("captions.result")),
        Figure(tension_along(solution, allowed, basis, readout=readout)),
    )
    (segment, *_), facts = case.line.segments, result_facts(solution)
    chain = segment.component and chain_words(segment.component, segment.nominal_diameter)
    length = Measure("length", solution.line.length)
    card: tuple[CardBlock, ...] = (
        Text(Message("desk.line_is", chain=chain or segment.name, length=length)),
        Verdict.of_judgement(report.judgement),
        Facts("desk_card", facts[:6]),
        *([Brief((governing_sentence(report),))] if report.results else []),
    )
    return first, [solution_answer(case, solution), check_answer(report)], card


def _body(text: str) -> _Laid:
    from catopt.answers.system import system_answer
    from catopt.figures.mooring import near, plan

    report, checks = _checked(text)
    drawn = (plan(report.solution), near(report.solution))
    first = section("desk.answer", *(Figure(chart) for chart in drawn if chart is not None))
    answer = system_answer(report, checks)
    return first, [answer], (Text(answer.title), Verdict.of_judgement(checks.judgement))


def _sized(text: str, door: Door, who: Who) -> _Laid:
    from catopt.answers.check import failing_checks
    from catopt.answers.size import size_answer
    from catopt.answers.size_card import size_card
    from catopt.figures.sizing import choices, elevation, swing_circle
    from catopt.sizing.verdict import judgement_of

    of = _sizing(text, door)
    charts = (elevation(of, failing_checks(of.point.checks)), swing_circle(of), choices(of)[0])
    first = section("desk.answer", *map(Figure, charts))
    # What to type is another than on a command line.
    verdict = Verdict.of_judgement(judgement_of(of, who))
    card = size_card(of, with_others=False)
    shown = tuple(verdict if isinstance(block, Verdict) else block for block in card)
    return first, [size_answer(of)], shown


def _note(text: str, language: Language) -> Reply:
    """Make the calculation note, without the truss model, which catopt report puts beside it."""
    from catopt.notes.origin import Asked, source_of
    from catopt.render.page import page

    door, asked = _door(text), Asked(verify=False)
    file = source_of(_name(door), text)
    if door == "line":
        from catopt.answers.note_line import line_note_answer
        from catopt.notes.line import note_of

        answer = line_note_answer(note_of(_case(text), (file,), asked))
    elif door == "body":
        from catopt.answers.note_system import system_note_answer
        from catopt.notes.system import system_note

        answer = system_note_answer(system_note(_case(text), (file,), asked))
    else:
        from catopt.answers.note_size import size_note_answer
        from catopt.notes.line import Given, size_note

        answer = size_note_answer(size_note(_sizing(text, door), Given(file), asked))
    return {"name": f"{door}.html", "html": page(answer, language).decode()}


def _files(text: str, language: Language) -> Reply:
    """Pack what ``--out`` writes of an answer: workbook, tables, figures, document and case."""
    from base64 import b64encode
    from io import BytesIO
    from zipfile import ZIP_DEFLATED, ZipFile

    from catopt.render.files import files_of
    from catopt.report import bundle

    door = _door(text)
    if door == "line":
        from catopt.answers.check import check_answer
        from catopt.answers.solution import solution_answer
        from catopt.catenary.case import solve_case
        from catopt.checks.case import check_case

        case = _case(text)
        solution, checks = solve_case(case), check_case(case)
        files = files_of(solution_answer(case, solution), solution.to_dict(), language)
        files |= files_of(check_answer(checks), checks.to_dict(), language)
        files |= bundle.solution_pictures(case, solution)
    elif door == "body":
        from catopt.answers.system import system_answer

        report, of_system = _checked(text)
        files = files_of(system_answer(report, of_system), _system(text), language)
        files |= bundle.system_pictures(report)
    else:
        from catopt.answers.size import size_answer
        from catopt.notes.line import Given
        from catopt.notes.origin import source_of

        of = _sizing(text, door)
        files = files_of(size_answer(of), of.to_dict(), language)
        files |= bundle.size_files(of, language, Given(source_of(_name(door), text)))
    made = BytesIO()
    with ZipFile(made, "w", ZIP_DEFLATED) as packed:
        for name, data in files.items():
            packed.writestr(name, data)
    return {"name": f"{door}.zip", "base64": b64encode(made.getvalue()).decode()}


_DOCUMENTS: Final[Mapping[str, Callable[[str], Reply]]] = {
    **{call: partial(_of_a_line, call) for call in ("solve", "check", "curve")},
    "system": _system,
    "size": lambda text: _sizing(text, _door(text)).to_dict(),
    "open": _open,
    "file": lambda text: {"name": _name(_door(text)), "text": text},
}
ABOUT_A_RUN: Final = ("progress", "stop")
"""What is answered while another question is."""
CALLS: Final = (*_DOCUMENTS, "live", "whole", "note", "compare", "files", "run", *ABOUT_A_RUN)
"""What can be asked."""
