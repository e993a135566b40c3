"""Writing a directory of files whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping
from pathlib import Path

from catopt.errors import InputError, Problem

__all__ = ["check_directory", "write_files"]


def check_directory(directory: Path) -> None:
    """Make sure that files can be written to a directory, or that it can be made; nothing is left.

    Raises
    ------
    InputError
        It is a file, or it cannot be made or written to.
    """
    if directory.exists() and not directory.is_dir():
        raise _refused(directory, "is a file; give a directory")
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
    directory: Path, contents: Mapping[str, bytes], keep: Collection[Path] = ()
) -> tuple[Path, ...]:
    """Write files so that none is ever seen half written.

    All are first written under temporary names; only then does each take its place, and with it
    that of an older file of the same name.

    Parameters
    ----------
    directory : Path
        Made when it is missing.
    contents : mapping of str to bytes
        File names and what they hold.
    keep : collection of Path
        Files that were read, in whose place nothing is written.

    Returns
    -------
    tuple of Path
        The files, in the order given.

    Raises
    ------
    InputError
        The directory or a file in it cannot be written, or would go in the place of one to keep.
    """
    check_directory(directory)
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise _refused(directory, _reason(error)) from error
    places = {directory / name: content for name, content in contents.items()}
    for place in places:
        if any(_is_same(place, read) for read in keep):
            raise _refused(place, "is the file that is read; give another place")
    try:
        for place, content in places.items():
            _write_through(_temporary(place), content)
        for place in places:
            _temporary(place).replace(place)
    except OSError as error:
        raise _refused(directory, _reason(error)) from error
    finally:
        for place in places:
            _temporary(place).unlink(missing_ok=True)
    return tuple(places)


def _is_same(place: Path, other: Path) -> bool:
    return place.exists() and other.exists() and place.samefile(other)


def _temporary(place: Path) -> Path:
    """Name a file beside its place, for `replace` is only whole within one file system."""
    return place.with_name(f".{place.name}.{os.getpid()}.tmp")


def _write_through(place: Path, content: bytes) -> None:
    with place.open("wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())


def _reason(error: OSError) -> str:
    name = f"{Path(error.filename2 or error.filename).name}: " if error.filename else ""
    return f"cannot be written: {name}{error.strerror or error}"


def _refused(directory: Path, why: str) -> InputError:
    return InputError([Problem("--out", str(directory), why)])
