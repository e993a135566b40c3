"""Every command that answers: what is typed, and which files it writes."""

from __future__ import annotations

from typing import NamedTuple


class Command(NamedTuple):
    """A command, its document, and the names of its files by kind; ``others`` are whole names."""

    line: str
    document: str
    tables: str
    figures: str = ""
    others: str = "case.toml"
    sheets: tuple[str, ...] = ()
    workbook: str = ""

    @property
    def files(self) -> set[str]:
        found = {f"{self.document}.json", *self.others.split()}
        found |= {f"{name}.xlsx" for name in self.workbooks}
        found |= {f"{name}.csv" for name in self.tables.split()}
        return found | {f"{name}.{end}" for name in self.figures.split() for end in ("png", "svg")}

    @property
    def workbooks(self) -> list[str]:
        return (self.workbook or self.document).split()


OF_SOLVE = "inputs segments_given summary segments profile"
OF_VERIFY = "verdicts quantities meshes shapes"
COMMANDS = [
    Command("solve BUOY --profile", "solution", OF_SOLVE, "line tension"),
    Command(
        "solve BUOY --method pso --profile", "solution", f"{OF_SOLVE} swarm_runs swarm_history",
        "line tension swarm_fitness swarm_tension",
    ),
    Command("check strength.toml", "check", "checks load_cases", sheets=("Checks", "Load cases")),
    Command("curve SOUGHT", "curve", "curve curve_marks", "curve"),
    Command("design DESIGN", "design", "checks components front neighbours search", "front"),
    Command("system FSO", "system", "body lines", "plan"),
    Command(
        "system FSO EVERYTHING", "system",
        "body lines line_out watch_circle water_levels restoring_1 restoring_2 held_1_forces "
        "held_1_load held_1_moments held_2_forces held_2_load held_2_moments",
        "plan restoring watch_circle",
        sheets=(
            "Body", "Lines", "One line out", "Watch circle", "Restoring 1", "Restoring 2",
            "Water levels", "Lines on a held body 1", "Lines on a held body 2",
        ),
    ),
    Command(
        "loads ship --dwt '50000 t' --depth '20 m' --wind '20 m/s'", "loads", "loads numbers notes",
        others="", sheets=("Forces", "Numbers", "Notes"),
    ),
    Command(
        "SIZE_BUOY", "size",
        "inputs sizing alternatives candidates checks forces numbers notes", "line",
        others="case.toml note.html",
        sheets=(
            "Inputs as they were read", "Sizing", "Candidates", "Checks", "Forces", "Numbers",
            "Notes",
        ),
    ),
    Command(
        "verify BUOY", "verify", OF_VERIFY, "comparison",
        sheets=tuple(OF_VERIFY.title().split()),
    ),
    Command(
        "verify coded.toml --dynamic", "verify",
        f"{OF_VERIFY} dynamic_checks dynamic_envelope dynamic_runs dynamic_series "
        "dynamic_statistics dynamic_summary",
        "comparison dynamic", workbook="verify dynamic",
        sheets=(
            *OF_VERIFY.title().split(), "Checks of the tensions in motio", "Statistics", "Summary",
            "Runs", "Envelope", "Series",
        ),
    ),
    Command(
        "fatigue FATIGUE --once", "fatigue",
        "fatigue fatigue_damage fatigue_sea_states fatigue_strength",
    ),
    Command(
        "study FLEET --workers 1", "study",
        "members study study_governing study_holding study_influences study_line study_worst",
        "study", others="study.sqlite",
    ),
    Command(
        "reproduce tanker_20m_sinker", "reproduction", "reproduction", "tanker_20m_sinker_lines",
        others="reproduction.md", sheets=("Comparison", "Inputs", "Findings"),
    ),
    Command(
        "catalog search --mbl '500 kN'", "catalog", "components figures families sources",
        others="", sheets=("Components", "Figures", "Families", "Sources"),
    ),
    Command("catalog list", "catalog", "figures families sources", others=""),
]  # fmt: skip

QUESTIONS = [
    "catalog list",
    "catalog show 'chain studless' R4 --diameter '76 mm'",
    "catalog show 'chain studless R4'",
    "catalog show 'chain stud-link'",
    "catalog show nylon --diameter '64 mm'",
    "catalog show 'wire 6-strand wire-core' --diameter 0.09 --recalled",
    "catalog search --mbl '500 kN'",
    "catalog search --mbl '50 tf' --family 'chain studless' --all-sizes",
]

MANY = [
    "solve BUOY --profile",
    "solve BUOY --method pso --runs 2 --iterations 50",
    "solve SLACK",
    "solve SOUGHT",
    "solve TANKER",
    "check TANKER",
    "check DESIGN",
    "design DESIGN",
    *QUESTIONS,
    "catalog show 'chain stud-link U2' --diameter '60 mm'",
    "catalog search --mbl '500 kN' --recalled",
    "curve SOUGHT --over offset",
    "curve BUOY --to '1 kN' --points 4",
    "curve SLACK --over offset",
    "curve CASES/ship-200m-sinker/case.toml",
    "curve DESIGN",
    "curve chain-and-wire.toml",
    "curve buoyed.toml --to '400 kN'",
    "curve bights.toml",
    "loads buoy 'pillar 1.8 m' --depth '12 m' SEA --chain '25 mm' --growth '20 mm' --pull '3 kN'",
    "loads ship SHIP SEA --propeller tanker",
    "loads ship SHIP SEA --current '2 m/s' --kind 'tanker ballast' --drift largest-wave "
    "--wind-angle '30 deg' --current-angle '45 deg'",
    "loads ship known-ship.toml",
    *(
        f"system {case} AT_REST"
        for case in (
            "FSO", "four-lines.toml", "with-strength.toml", "untitled-two-lines.toml",
            "one-line.toml", "two-headings.toml", "no-force.toml", "taut.toml",
        )
    ),
    "size buoy --depth '12 m' --low-water '10 m' --force '8 kN' --reserve-buoyancy '25 kN' "
    "--hs '1.5 m' --period '6 s' --life '3 years' --wear '0.2 mm/year' "
    "--soil 'gravel or coarse sand' --prefer lightest --chain 'chain open-link 4D Q2' "
    "--code IALA-CALMAR",
    "size buoy 'pillar 1.8 m' --depth '12 m'",
    "SMALL --ballast-draught '4 m' --dwt '9000 t'",
    "SMALL --low-water '7.5 m' --anchor stockless --soil 'soft clay'",
    "SMALL --anchor sinker --clump-weight '5 t' --clump-weight '10 t'",
    "SMALL --buoy 'mooring buoy 5.0 m' --lines 4 --low-water '20 m'",
    "verify DESIGN --elements 40",
    "verify FSO --elements 60",
    "verify SLACK",
    "verify twice.toml --elements 40 --tolerance 1e-9",
    "verify tension-known.toml",
    "verify bights.toml",
    "verify at-sea.toml --dynamic",
    "verify moving.toml --dynamic",
    "verify raos.toml --dynamic",
    "verify twice-in-motion.toml --dynamic --elements 40",
    "verify slack-in-motion.toml --dynamic",
    "verify led.toml --dynamic --elements 40 --once",
    "verify pushed.toml --dynamic --elements 40",
    "reproduce load_sharing",
]  # fmt: skip
"""Answers of every kind and with every sentence that they may hold."""
