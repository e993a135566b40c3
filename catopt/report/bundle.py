"""Everything that commands write to a directory: what is drawn, and files whole or not at all."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from pathlib import Path
from time import time
from typing import TYPE_CHECKING, Any, NamedTuple

from catopt.casefile.reading import DESIGN_CASE
from catopt.casefile.writing import text_digest
from catopt.errors import InputError, refused
from catopt.interrupt import signals_wait
from catopt.largest import first_largest
from catopt.render.files import csv_of, document_bytes
from catopt.schemas import CASE_DIGEST
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignResult
    from catopt.figures.chart import Chart
    from catopt.model import Case
    from catopt.mooring.case import SystemReport
    from catopt.mooring.solution import SystemSolution
    from catopt.notes.line import Given
    from catopt.reproduce import Reproduction
    from catopt.reproduce.items import Study
    from catopt.sizing import Sizing
    from catopt.study.result import StudyResult
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.result import StaticComparison, Verification
    from catopt.words import Language

_TEMPORARY = re.compile(r"\..+\.\d+\.tmp")
_STALE = 600.0
"""Seconds after which nobody is still writing a temporary file: all are written within a few."""


def check_directory(directory: Path) -> None:
    """Make sure that files can be written to a directory, or that it can be made; nothing is left.

    Raises InputError where it is a file, or cannot be made or written to.
    """
    if directory.exists() and not directory.is_dir():
        raise _refused(directory, Message("refused_command.is_a_file"))
    place = directory
    try:
        while not place.exists() and place != place.parent:
            place = place.parent
        probe = _temporary(place / "probe")
        probe.touch()
        probe.unlink()
    except OSError as error:
        raise _refused(directory, _reason(error)) from error


def write_files(
    directory: Path,
    contents: Mapping[str, bytes],
    keep: Collection[Path] = (),
    case: bytes | None = None,
) -> tuple[Path, ...]:
    """Write files so that none is ever seen half written, and that all are of one answer.

    All are first written under temporary names; only then does each take its place, and with it
    that of an older file of the same name. A signal waits until the last one has. Every document of
    catopt among them carries the digest of its case, which goes first, so that a directory in which
    even a power cut left parts of two answers is recognised. That is `case`, or the case file among
    them; `keep` are files that were read, in whose place nothing is written.

    Raises InputError where the directory or a file in it cannot be written, or would go in the
    place of one to keep.
    """
    check_directory(directory)
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise _refused(directory, _reason(error)) from error
    of = contents.get(DESIGN_CASE) if case is None else case
    places = {directory / name: _marked(data, of) for name, data in contents.items()}
    for place in places:
        if any((place.exists() and read.exists() and place.samefile(read)) for read in keep):
            raise _refused(place, Message("refused_command.is_read"))
    try:
        for place in directory.glob(".*.tmp"):  # that a run which was killed left behind
            if _TEMPORARY.fullmatch(place.name) and time() - place.stat().st_mtime > _STALE:
                place.unlink(missing_ok=True)
        for place, content in places.items():
            with _temporary(place).open("wb") as stream:
                stream.write(content)
                stream.flush()
                os.fsync(stream.fileno())
        # The case first, documents that carry its digest last.
        ordered = sorted(places, key=lambda at: (at.name != DESIGN_CASE, at.suffix == ".json"))
        with signals_wait():
            for place in ordered:
                _temporary(place).replace(place)
    except OSError as error:
        raise _refused(directory, _reason(error)) from error
    finally:
        for place in places:
            _temporary(place).unlink(missing_ok=True)
    return tuple(places)


def _marked(content: bytes, case: bytes | None) -> bytes:
    """Put the digest of the case into a document of catopt; leave every other file."""
    if case is None or not content.startswith(b'{\n  "schema": "catopt.'):
        return content
    return document_bytes(with_digest(json.loads(content), text_digest(case.decode())))


def with_digest(document: dict[str, Any], digest: str) -> dict[str, Any]:
    """Put the digest of its case into a document, after its schema."""
    mark = {CASE_DIGEST: digest}
    return {"schema": document["schema"], **mark} | document | mark


def _temporary(place: Path) -> Path:
    """Name a file beside its place, for `replace` is only whole within one file system."""
    return place.with_name(f".{place.name}.{os.getpid()}.tmp")


def _reason(error: OSError) -> Message:
    name = f"{Path(error.filename2 or error.filename).name}: " if error.filename else ""
    reason = Several((name, term(error.strerror or str(error))), "")
    return Message("refused_command.not_written", reason=reason)


def _refused(directory: Path, why: Message) -> InputError:
    return refused("--out", str(directory), why)


SYSTEM_CASE = "system.toml"
"""The whole pattern of several lines, for ``catopt system``."""


class Drawing(NamedTuple):
    """Charts that stand together, their heading, and in how many columns they stand."""

    charts: tuple[Chart, ...]
    title: str
    columns: int = 1


def _pictures(drawn: Mapping[str, Drawing]) -> dict[str, bytes]:
    """Make the files of drawings by their names; none of one without charts."""
    from catopt.render.picture import pictures

    files: dict[str, bytes] = {}
    for name, (charts, title, columns) in drawn.items():
        if charts:
            files |= pictures(name, charts, title, columns=columns)
    return files


# ------------------------------------------------------------------ lines


def _of_tension(solution: Solution) -> Drawing:
    """Draw the tension along a line beside what its segments may carry."""
    from catopt.figures.line import tension_along

    factor = solution.safety_factor
    allowed = [segment.MBL and segment.MBL / factor for segment in solution.segments]
    basis = Message("figures.MBL_over", factor=factor)
    return Drawing((tension_along(solution, allowed, basis),), solution.title)


def _of_line(solution: Solution, depth: float, title: str) -> Drawing:
    """Draw a line in water of a depth (m)."""
    from catopt.figures.line import line_in_water

    return Drawing((line_in_water(solution, depth),), title)


def solution_pictures(case: Case, solution: Solution) -> dict[str, bytes]:
    """Draw the line in the water, the tension along it and, of a swarm, S1's figures 3 and 4."""
    line = _of_line(solution, case.site.water_depth, solution.title)
    drawn = {"line": line, "tension": _of_tension(solution)}
    return _pictures(drawn | _of_swarm("swarm", solution))


def _of_swarm(name: str, solution: Solution) -> dict[str, Drawing]:
    """Draw S1's figures 3 and 4; nothing when there was no swarm."""
    from catopt.figures.swarm import fitness, swarm_tension

    swarm, title = solution.swarm, solution.title
    if swarm is None:
        return {}
    exact = solution.fairlead.tension - swarm.closed_form_difference["tension_N"]
    return {
        f"{name}_fitness": Drawing((fitness(swarm),), title),
        f"{name}_tension": Drawing((swarm_tension(swarm, exact),), title),
    }


def _of_solution(solution: Solution) -> Drawing:
    """Draw a line that came without its case: the water reaches up to its fairlead."""
    in_water = _of_line(solution, solution.fairlead_height, solution.title)
    return Drawing((*in_water.charts, *_of_tension(solution).charts), solution.title)


def _of_curve(result: CaseCurve) -> Drawing:
    from catopt.figures.line import load_curve

    return Drawing((load_curve(result),), result.case.title)


# ------------------------------------------------------------------ bodies and designs


def _of_plan(solution: SystemSolution, title: str) -> Drawing:
    """Draw a body on its lines from above, and near the body where that shows more."""
    from catopt.figures import mooring

    around = mooring.near(solution)
    return Drawing((mooring.plan(solution), *(() if around is None else (around,))), title)


def system_pictures(report: SystemReport) -> dict[str, bytes]:
    """Draw a body on its lines; the figures of what was not asked for are left out."""
    from catopt.figures import mooring

    title, solution, circle = report.case.title, report.solution, report.circle
    drawn = {"plan": _of_plan(solution, title)}
    if circle is not None:
        views = (mooring.watch_track(solution, circle), mooring.watch_round(solution, circle))
        drawn["watch_circle"] = Drawing(views, title)
    if report.curves:
        drawn["restoring"] = Drawing((mooring.restoring(report.curves, solution),), title)
    return _pictures(drawn)


def _of_front(result: DesignResult) -> Drawing:
    """Draw a front, and of single lines three of them."""
    from catopt.figures.sizing import front, front_lines

    document = result.to_dict()
    is_line = not result.best.checks.places
    lines = (front_lines(result, document),) if is_line else ()
    return Drawing((front(document), *lines), result.case.title)


def design_pictures(result: DesignResult) -> dict[str, bytes]:
    """Draw the front and three of its lines; of whole moorings the recommended one in plan."""
    drawn = {"front": _of_front(result)}
    found = result.best.mooring
    if found is not None:
        plan = _of_plan(found.farthest, result.case.title)
        drawn["plan"] = plan._replace(charts=plan.charts[:1])
    return _pictures(drawn)


def _of_sizing(of: Sizing) -> Drawing:
    """Draw the recommended line in the load case that is hardest on it."""
    name, solution = of.hardest
    state = next(load_case for load_case in of.case.load_cases if load_case.name == name)
    return _of_line(solution, of.case.site.water_depth + state.water_level, of.case.title)


def size_files(
    of: Sizing, language: Language = "en", given: Given | None = None
) -> dict[str, bytes]:
    """Make the files of ``catopt size ... --out DIR`` beside document, tables and workbook.

    The line in the water, the calculation note in a language, and the case that all commands take;
    of several lines the case of the whole pattern, of lengths run in motion their picture, too.
    No note where nothing says what was asked for.
    """
    from catopt.casefile import write_case

    drawn = {"line": _of_sizing(of)}
    if of.in_motion is not None and of.in_motion.by_length:
        from catopt.figures.sizing import tension_by_length

        drawn["by_length"] = Drawing((tension_by_length(of.in_motion),), of.case.title)
    files = {DESIGN_CASE: write_case(of.line_case).encode(), **_pictures(drawn)}
    if given is not None:
        files["note.html"] = _size_page(of, given, language)
    if (whole := of.system_case) is not None:
        files[SYSTEM_CASE] = write_case(whole).encode()
    return files


def _size_page(of: Sizing, given: Given, language: Language) -> bytes:
    from catopt.answers.note_size import size_note_answer
    from catopt.notes.line import size_note
    from catopt.render.page import page

    return page(size_note_answer(size_note(of, given)), language)


def write_member_note(
    folder: str,
    source: str,
    language: Language,
    member: int,
    changes: Mapping[str, Any],
    sizing: Sizing,
) -> None:
    """Write the note of a study's member, counted from 0: ``0007-pillar-at-km-12.html``.

    `source` is the file that all sizings have in common, `changes` are the member's own values.
    """
    from catopt.notes.line import Given
    from catopt.notes.origin import read_source

    own = tuple(
        (key, f"{value:.10g} (SI)" if isinstance(value, float) else str(value))
        for key, value in changes.items()
    )
    title = re.sub(r"[^a-z0-9]+", "-", str(changes.get("title", "")).casefold()).strip("-")
    name = "-".join(filter(None, (f"{member + 1:04d}", title))) + ".html"
    given = Given(read_source(Path(source)), own)
    write_files(Path(folder), {name: _size_page(sizing, given, language)})


# ------------------------------------------------------------------ other models, motion


def _of_comparison(found: Verification, part: StaticComparison) -> Drawing:
    """Draw a line by both models; of a body the most loaded one."""
    from catopt.figures.motion import comparison

    titles = [found.case.title, part.name if found.is_named else ""]
    line = first_largest([pair.finest.fairlead.tension for pair in part.lines])
    if part.kind != "line":
        titles.append(Message("figures.most_loaded", line=part.name_of_line(line)))
    return Drawing(comparison(part.lines[line]), ", ".join(filter(None, titles)), 2)


def _numbered(name: str, drawings: Iterator[Drawing], count: int) -> dict[str, Drawing]:
    """Name one drawing as it is, and each of several by its number."""
    if count == 1:
        return {name: next(drawings)}
    return {f"{name}_{number}": drawing for number, drawing in enumerate(drawings, start=1)}


def verification_pictures(found: Verification) -> dict[str, bytes]:
    """Draw every load case; of a body the most loaded line."""
    drawings = (_of_comparison(found, part) for part in found.parts)
    return _pictures(_numbered("comparison", drawings, len(found.parts)))


def _of_motion(part: DynamicPart, title: str) -> Drawing:
    """Draw a line in motion: its history, spectrum, envelope and peaks."""
    from catopt.figures import motion

    peaks = motion.peaks_above(part)
    charts = (motion.whole_history(part), motion.spectrum(part), motion.envelope_chart(part))
    return Drawing(charts if peaks is None else (*charts, peaks), title)


def motion_pictures(found: DynamicVerification, language: Language = "en") -> dict[str, bytes]:
    """Draw every load case in motion, or the governing line of a body; of a buoy afloat a film."""
    title, parts = found.case.title, found.parts
    from catopt.answers.motion import by_lines

    if by_lines(found):
        part = found.governing
        drawn = _pictures({"dynamic": _of_motion(part, f"{title}, {part.where}")})
        return drawn | _afloat(found, language)
    titles = (
        [title] if len(parts) == 1 else [f"{title}, {chart.name}".strip(", ") for chart in parts]
    )
    drawings = map(_of_motion, parts, titles)
    drawn = _pictures(_on_slope(found) | _numbered("dynamic", drawings, len(parts)))
    return drawn | _afloat(found, language)


def _afloat(found: DynamicVerification, language: Language) -> dict[str, bytes]:
    """Draw a buoy afloat at the largest tension of all runs, and what it does around it."""
    hull = found.governing.governing.hull
    if hull is None or hull.scene is None:
        return {}
    from catopt.figures.motion import film_of, worst_moment
    from catopt.render.page import film_page

    title = ", ".join(filter(None, (found.case.title, found.governing.where)))
    drawn = {"moment": Drawing((worst_moment(hull.scene),), title)}
    return _pictures(drawn) | {"film.html": film_page(film_of(hull.scene), title, language)}


def _on_slope(found: DynamicVerification) -> dict[str, Drawing]:
    """Draw the line at rest on a bed that slopes, under its first load."""
    from catopt.figures.motion import on_slope

    site = found.case.site
    if site.seabed_slope == 0.0:
        return {}
    part = found.parts[0]
    levels = {state.name: state.water_level for state in found.case.load_cases}
    depth = site.water_depth + levels.get(part.name, 0.0)
    return {"line": Drawing((on_slope(part, depth, site.seabed_slope),), found.case.title)}


def _of_moved(found: DynamicVerification) -> Drawing:
    part = found.governing
    return _of_motion(part, ", ".join(filter(None, (found.case.title, part.where))))


# ------------------------------------------------------------------ studies


def _of_study(result: StudyResult) -> Drawing:
    """Draw how often values are exceeded: of the quantities with limits, or else of the first."""
    from catopt.figures.studies import share_worse

    known = [statistic for statistic in result.statistics if statistic.least < statistic.largest]
    drawn = [statistic for statistic in known if statistic.limit is not None] or known[:1]
    return Drawing(tuple(share_worse(result, statistic) for statistic in drawn), result.study.title)


def reproduction_pictures(result: Reproduction) -> dict[str, bytes]:
    """Draw the studies; of a swarm with the tables of its runs."""
    from catopt.answers.solution import swarm_tables

    files: dict[str, bytes] = {}
    for study in result.studies:
        drawn, solution = _of_reproduced(study), study.by_swarm
        if solution is not None and solution.swarm is not None:
            history, runs = swarm_tables(solution.swarm)
            files[f"{study.name}_runs.csv"] = csv_of(runs.to_dataframe())
            files[f"{study.name}_history.csv"] = csv_of(history.to_dataframe())
            drawn = _of_swarm(study.name, solution) | drawn
        files |= _pictures(drawn)
    return files


def _of_reproduced(study: Study) -> dict[str, Drawing]:
    """Draw the lines of a study to scale, and a body by several models."""
    from catopt.figures import studies

    drawn: dict[str, Drawing] = {}
    if study.drawn:
        lines = [(line.name, line.solution) for line in study.drawn]
        depth = max(line.depth or line.solution.fairlead_height for line in study.drawn)
        charts = (studies.lines_to_scale(lines, depth),)
        drawn[f"{study.name}_lines"] = Drawing(charts, study.title)
    if study.moorings:
        of = study.moorings
        views = (studies.models_from_above(of), studies.models_near(of))
        side = studies.models_from_the_side(of, study.loaded_line)
        drawn[f"{study.name}_plan"] = Drawing(views, study.title, 2)
        drawn[f"{study.name}_elevation"] = Drawing((side,), study.title)
    return drawn


# ------------------------------------------------------------------ in a notebook


_DRAWN: dict[str, Callable[[Any], Drawing]] = {
    "CaseCurve": _of_curve,
    "DesignResult": _of_front,
    "DynamicVerification": _of_moved,
    "Sizing": _of_sizing,
    "Solution": _of_solution,
    "SolutionInCurrent": _of_solution,
    "StudyResult": _of_study,
    "SystemSolution": lambda found: _of_plan(found, found.title),
    "Verification": lambda found: _of_comparison(found, found.parts[0]),
}
"""What draws a result, by the name of its class."""


def pictures_of(name: str, result: Any) -> dict[str, bytes]:
    """Draw what `figure_of` draws, as files; none where nothing is worth a chart."""
    return _pictures({name: _DRAWN[type(result).__name__](result)})


def figure_of(result: Any) -> Figure:
    """Draw a result; TypeError for what has no drawing."""
    from catopt.render.picture import picture

    name = type(result).__name__
    if name not in _DRAWN:
        raise TypeError(f"a {name} has no drawing; those of {', '.join(_DRAWN)} have one")
    charts, title, columns = _DRAWN[name](result)
    return picture(charts, title, columns=columns)
