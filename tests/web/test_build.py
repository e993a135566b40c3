"""The builder's own logic: pinned bytes, what goes in, the same bytes again. No network."""

from __future__ import annotations

import io
import re
import shutil
import zipfile
from pathlib import Path

import pytest

import catopt
from catopt.errors import InputError
from catopt.web import build
from catopt.web.build import PinnedPart, document, fetched, parts, site

PART = PinnedPart(
    "a.whl",
    "https://example.org/a.whl",
    "ba7816bf" + "8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
)
"""SHA-256 of "abc" as FIPS 180-2, appendix B.1, has it."""


def test_a_part_is_taken_with_its_digest_and_another_file_or_none_is_refused(
    tmp_path: Path,
) -> None:
    with pytest.raises(InputError, match=r"--from; it is at https://example\.org/a\.whl"):
        fetched(PART, tmp_path)
    (tmp_path / "a.whl").write_bytes(b"abd")
    with pytest.raises(InputError, match=r"a\.whl: found SHA-256 .*must be ba7816bf"):
        fetched(PART, tmp_path)
    (tmp_path / "a.whl").write_bytes(b"abc")
    assert fetched(PART, tmp_path) == b"abc"


def test_every_part_comes_from_a_registry_with_its_digest() -> None:
    for each in parts():
        assert each.url.startswith(
            ("https://registry.npmjs.org/", "https://files.pythonhosted.org/")
        )
        assert each.url.endswith(f"/{each.name}")
        assert re.fullmatch(r"[0-9a-f]{64}", each.sha256)


def wheel(**files: str) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as packed:
        for name, text in files.items():
            packed.writestr(name.replace("__", "/").replace("_py", ".py"), text)
    return made.getvalue()


def test_catopt_goes_in_without_its_command_line_and_the_same_bytes_come_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Machine code that numba keeps beside the sources stays outside."""
    own = tmp_path / "catopt"
    shutil.copytree(Path(catopt.__file__).parent, own, ignore=shutil.ignore_patterns("*.nb?"))
    (own / "design" / "__pycache__").mkdir(exist_ok=True)
    (own / "design" / "__pycache__" / "assess.nbi").write_bytes(b"code")
    monkeypatch.setattr(build, "files", lambda _: own)
    archive = wheel(tool__a_py="1", tool__notes="no code")
    made = site([archive])
    assert made == site([archive])
    with zipfile.ZipFile(io.BytesIO(made)) as packed:
        names = set(packed.namelist())
    assert {"tool/a.py", "catopt/page_api/calls.py", "catopt/words/texts/desk.toml"} <= names
    assert "tool/notes" not in names
    assert not any(each.startswith(("catopt/cli/", "catopt/web/")) for each in names)
    assert not any("__pycache__" in each for each in names)


@pytest.mark.parametrize("pieces", [None, ["a"], {"a": b"abc"}])
def test_the_page_names_no_other_host(pieces: list[str] | dict[str, bytes] | None) -> None:
    page = document(pieces)
    named = set(re.findall(r"https?://([\w.-]+)", page))
    assert named <= {"pack.invalid", "www.w3.org"}
    assert "{{" not in page.split("</style>")[0]
