"""A table is written whole while another process writes one of the same name beside it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from catopt.answers.blocks import Table, tabulate, texts
from catopt.render.files import write_table


def test_a_table_does_not_lose_its_file_to_another_process(tmp_path: Path) -> None:
    """The other takes away its own temporary file, which had the same name."""

    def parts() -> Iterator[Table]:
        yield tabulate("members", texts("study.members", ["1"]))
        (tmp_path / ".members.csv.tmp").unlink(missing_ok=True)
        yield tabulate("members", texts("study.members", ["2"]))

    write_table(tmp_path / "members.csv", parts(), None, 2)
    assert (tmp_path / "members.csv").read_text("utf-8").split()[-2:] == ["1", "2"]
    assert [each.name for each in tmp_path.iterdir()] == ["members.csv"]
