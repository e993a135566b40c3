"""What the open sources said when they were read again: nothing differs, nothing is stale."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from .reread import Entry, _of_calmar, _of_moorpy, compare, entries, fingerprint, read_verdicts

OPEN = {"CALCH", "DTO", "VRY", "MP", "MPCOST", "MPO", "DDJ", "DDJR", "BEM"}
"""Sources that a machine can read."""

BY_EYE = {
    "wire spiral-strand / volume_diameter",
    "wire spiral-strand / drag_normal",
    "polyester / EA / superline-new",
    "polyester / drag_normal",
    "polyester 8-strand / drag_normal",
    "nylon / EA / superline-new",
    "nylon / drag_normal",
    "polypropylene / drag_normal",
    "polypropylene / added_mass_normal",
    "polypropylene / added_mass_axial",
    "HMPE / EA / superline-new",
    "HMPE / drag_normal",
}
"""Entries of open sources alone that no reader looks up: comments and what a program computes."""


def test_no_entry_contradicts_its_source() -> None:
    found = read_verdicts()
    assert len(found) > 250
    assert {pair: said for pair, (said, _) in found.items() if not said.startswith("agrees")} == {}


def test_no_verdict_is_of_a_figure_that_was_changed_since() -> None:
    """When it is: python -m tests.catalogue.reread DIR reads the sources again."""
    own = {entry.name: fingerprint(entry) for entry in entries()}
    stale = [pair for pair, (_, values) in read_verdicts().items() if own.get(pair[0]) != values]
    assert stale == []


def test_what_an_open_source_has_was_read_again() -> None:
    found = {name for name, _ in read_verdicts()}
    named = (e.name for e in entries() if set(e.sources) <= OPEN)
    unread = {name for name in named if name not in found and not name.endswith("/ fit")}
    assert unread == BY_EYE


def test_every_name_is_of_one_entry() -> None:
    names = [entry.name for entry in entries()]
    assert len(set(names)) == len(names)


CALMAR = """
<ChainElementItem Type="3D" DN="14" MasseLin="4.3" Q1_CE="4.89" Q2_CE="6.32" Q3_CE="7.85" />
<ChainElementItem Type="3D" DN="16" MasseLin="5.6" Q1_CE="6.42" Q2_CE="8.15" Q3_CE="10.3" />
<ChainElementItem Type="3D" DN="18" MasseLin="7.3" Q1_CE="8.36" Q2_CE="10.6" Q3_CE="13.35" />
<ChainElementItem Type="3D" DN="20" MasseLin="9" Q1_CE="10.6" Q2_CE="13.46" Q3_CE="16.82" />
"""


def test_a_planted_misprint_is_noticed() -> None:
    """Of CALMAR's rows one that was typed as 6.5 for 5.6, and of MoorPy's polyester 697 for 679."""
    masses = (0.014, 0.016, 0.018, 0.020, 4.3, 6.5, 7.3, 9.0)
    entry = Entry("chain open-link 3D / mass / calmar", ("CALCH",), "A", 1, masses)
    pairs = _of_calmar(CALMAR, entry)
    assert [mine == printed for mine, printed in pairs] == [True, False, True, True]
    rope = Entry("polyester / mass / moorpy", ("MP",), "C", 1, (2.0, 697.0))
    text = "  polyester   :     # rope\n    mass_d2   :  679       # kg/m\n"
    assert _of_moorpy(text, rope) == [(697.0, 679.0)]


def test_a_changed_value_changes_the_fingerprint() -> None:
    entry = Entry("x", ("MP",), "C", 1, (2.0, 679.0, 3.0))
    for k in range(3):
        values = tuple(v + (0.001 if i == k else 0.0) for i, v in enumerate(entry.values))
        assert fingerprint(replace(entry, values=values)) != fingerprint(entry)
    assert fingerprint(replace(entry, values=(679.0, 2.0, 3.0))) != fingerprint(entry)


def test_without_a_source_at_hand_nothing_is_said(tmp_path: Path) -> None:
    assert compare(tmp_path) == {}
