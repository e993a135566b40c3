"""A campaign over sizings in motion: none may recommend what its own motion fails.

    python -m tests.campaign --lines 0 --in-motion 300

Ships have an even number, buoys an odd one. What is recommended is written, read back and run again
by `verify_ship` or `verify_dynamic`, which know nothing of the search. Its verdict has to be that
every check is passed, in every sea that it was run in: of a ship, by the upper ends of the
intervals, which she is sized by, and by what is most probable, which is written. At rest it has to
keep its own code.
"""

from __future__ import annotations

import random
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from catopt.casefile import parse_case, write_case
from catopt.checks.case import check_case
from catopt.errors import InputError, NoAnswerError, NotConvergedError
from catopt.model import Case
from catopt.notes.motion import checks_in_motion
from catopt.sizing.result import Sizing
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.two_scales import verify_ship
from tests.sizing.alone import alone
from tests.sizing.at_rest import size_buoy, size_tanker
from tests.sizing.test_any_sizing import drawn_buoy, drawn_ship


def drawn(number: int) -> dict[str, Any]:
    """Draw what is known of a mooring in waves."""
    draw = random.Random(f"in motion {number}")
    given = drawn_buoy(draw) if number % 2 else drawn_ship(draw)
    given["hs"] = draw.uniform(0.3, 3.0)
    if not number % 2:
        given["lines"] = draw.choice((1, 1, 1, 3, 4))
        prefer = draw.choice((None, "balanced", "lightest", "least-swing"))
        given["prefer"] = None if (prefer, given["lines"] > 1) == ("least-swing", True) else prefer
    if draw.random() < 0.2:
        given["peak_period"] = tuple(part * given["hs"] ** 0.5 for part in (3.6, 4.3))
    return given


def judge(number: int) -> tuple[str, list[str]]:
    """Size and run again: what came of it, and what is wrong with that."""
    given = drawn(number)
    sizer = size_buoy if number % 2 else size_tanker
    try:
        with alone():
            found = sizer(**given, in_motion=True)
    except NoAnswerError:
        return "none passes", []
    except NotConvergedError as error:
        return "not converged", [str(error)]
    except InputError as error:
        fine = "would not float upright" in str(error) or _is_no_motion(sizer, given)
        return "refused", [] if fine else [str(error)]
    return "recommended", faults_of(found)


def _is_no_motion(sizer: Callable[..., Sizing], given: dict[str, Any]) -> bool:
    """Whether what is refused is so at rest, too: a ship aground, a buoy that is pulled under."""
    try:
        with alone():
            sizer(**given)
    except InputError:
        return True
    except NoAnswerError:
        return False
    return False


def faults_of(found: Sizing) -> list[str]:
    """Say which checks fail in motion, or at rest, of what is recommended."""
    moved = found.in_motion
    assert moved is not None
    faults = [f"at rest: {each.in_case}" for each in check_case(_still(found)).failed]
    case = parse_case(write_case(moved.case))
    assert case.waves is not None
    for period in moved.how.periods or (case.waves.period,):
        sea = replace(case, waves=replace(case.waves, period=period))
        faults += _failing(sea, is_of_ship=moved.is_of_ship)
    if any(each.passes for each in moved.less):
        faults.append("less passes, too")
    return faults


def _failing(case: Case, *, is_of_ship: bool) -> Iterator[str]:
    """Run it, and say which checks fail."""
    assert case.dynamics is not None
    if not is_of_ship:
        report = checks_in_motion(verify_dynamic(case, convergence_check="none", workers=1))
        yield from (f"in motion: {each.in_case}" for each in report.failed)
        return
    for by in ("upper", "most-probable"):
        report = verify_ship(replace(case, dynamics=replace(case.dynamics, judged_by=by))).checks
        yield from (f"in motion, {by}: {each.in_case}" for each in report.failed)


def _still(found: Sizing) -> Case:
    return replace(found.case, design=None)


def run(count: int, first: int, say: Callable[[str], None]) -> int:
    """Run a campaign over sizings in motion; returns how many are faulty."""
    verdicts: Counter[tuple[str, str]] = Counter()
    faulty, began = 0, time.perf_counter()
    for number in range(first, first + count):
        verdict, faults = judge(number)
        verdicts["buoy" if number % 2 else "ship", verdict] += 1
        faulty += bool(faults)
        for each in faults:
            say(f"number {number}, {verdict}: {each}")
    for (kind, verdict), of in sorted(verdicts.items()):
        say(f"{kind}, {verdict:15}{of:8,}")
    say(f"{time.perf_counter() - began:.0f} s, {faulty} faulty")
    return faulty
