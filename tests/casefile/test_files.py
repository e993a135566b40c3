"""Files that are not there, are no text, or carry what editors add."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt.casefile import parse_case, read_case, template
from catopt.errors import InputError

TEXT = template("buoy")


def message(path: str) -> str:
    with pytest.raises(InputError) as caught:
        read_case(path)
    return str(caught.value)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.usefixtures("folder")
def test_no_such_file() -> None:
    assert message("case.toml") == "case.toml: 1 error\n  case file: there is no such file"


def test_no_such_file_but_one_spelt_nearly_so(folder: Path) -> None:
    (folder / "buoy.toml").write_text(TEXT, encoding="utf-8")
    assert message("bouy.toml").endswith("there is no such file; did you mean buoy.toml?")


@pytest.mark.usefixtures("folder")
def test_no_such_folder() -> None:
    assert message("cases/case.toml").endswith("there is no such file, and no folder cases")


def test_a_folder(folder: Path) -> None:
    (folder / "buoy").mkdir()
    assert message("buoy") == "buoy: 1 error\n  case file: it is a folder; give a file"
    (folder / "buoy" / "case.toml").write_text(TEXT, encoding="utf-8")
    assert message("buoy").endswith("it is a folder; give the file in it, buoy/case.toml")


def test_a_name_that_no_file_can_have() -> None:
    assert "it cannot be read: " in message("a\0b")


def test_a_file_in_another_encoding(folder: Path) -> None:
    latin = TEXT.replace("marker buoy", "bouée").replace("Marker buoy", "Bouée")
    (folder / "case.toml").write_bytes(latin.encode("latin-1"))
    line = 1 + latin[: latin.index("é")].count("\n")
    expected = f"case.toml: 1 error\n  line {line}: found the byte 0xE9; save the file as UTF-8"
    assert message("case.toml") == expected


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_a_file_in_utf_16(folder: Path, encoding: str) -> None:
    mark = "" if encoding == "utf-16" else "\ufeff"
    (folder / "case.toml").write_bytes((mark + TEXT).encode(encoding))
    assert message("case.toml").endswith("file: found UTF-16 text; save it as UTF-8")


def test_the_byte_order_mark_and_line_ends_of_windows(folder: Path) -> None:
    data = b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode()
    (folder / "case.toml").write_bytes(data)
    assert read_case("case.toml") == parse_case(TEXT)
    assert parse_case("\ufeff" + TEXT) == parse_case(TEXT)


def test_a_path_object_is_taken(folder: Path) -> None:
    (folder / "case.toml").write_text(TEXT, encoding="utf-8")
    assert read_case(folder / "case.toml") == parse_case(TEXT)


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("a = 20 m", 'put a value with a unit in quotes, such as "9.5 m"'),
        ("a = 9,5", "write a decimal point, not a comma"),
        ("a = 1 000", "write the number without gaps"),
        ("a = .5", "write a digit on both sides of the decimal point"),
        ("a = 5.", "write a digit on both sides of the decimal point"),
        ("a = deep", "put text in quotes"),
        ("a =", "the value is missing"),
        ("a =   # later", "the value is missing"),
        ("a: 5", "write = between a key and its value, not a colon"),
        ('a = "C:\\cases"', "write / instead of \\, or put the text in single quotes"),
        ("a = “5 m”", 'use plain quotes: "'),
        ('a = "5 m', "the closing quote is missing"),
        ("a = 1\na = 2", "this key is given twice in its table; keep one"),
        ("[a]\n[a]", "this section is given twice; merge its keys into one"),
        ("[[a]", "expected ']]' at the end of an array declaration"),
    ],
)
def test_a_mistake_of_syntax_is_explained(line: str, told: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(line)
    (problem,) = caught.value.problems
    last = line.splitlines()[-1]
    assert problem.key.startswith(f"line {len(line.splitlines())}, column ")
    assert problem.found == "`" + last.replace("\\", "\\\\").strip() + "`"
    assert problem.allowed == told


def test_the_place_is_the_end_when_something_stays_open() -> None:
    with pytest.raises(InputError, match="end of document: unclosed array"):
        parse_case("a = [1,\n2\n")


def test_a_bottomless_array_and_an_endless_number() -> None:
    with pytest.raises(InputError, match="nested too deeply"):
        parse_case("a = " + "[" * 100_000)
    with pytest.raises(InputError, match="file: "):
        parse_case("a = " + "1" * 10_000)


ANOTHERS = "password:hunter2, 5 x\nTOKEN=hunter2\n"


def test_the_words_of_another_file_named_by_mistake_are_not_told(tmp_path: Path) -> None:
    secret = tmp_path / "credentials"
    secret.write_text(ANOTHERS)
    text = f'{TEXT}\n[catalogue]\nfile = "{{}}"\n'
    with pytest.raises(InputError, match="line 1, column 9") as caught:
        parse_case(text.format(secret.as_posix()))
    assert "hunter2" not in str(caught.value)
    secret.rename(own := tmp_path / "own.toml")  # of one's own families the line is told
    with pytest.raises(InputError, match="found `password:hunter2, 5 x`"):
        parse_case(text.format(own.as_posix()))
