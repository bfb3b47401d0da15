"""The folders that a command reads, by which it notices that another one replaced them meanwhile:
what it read before and what it reads then do not fit, and neither is at fault.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

from kinegrade.errors import KinegradeError
from kinegrade.files.placing.standing import refuse_changed

_Stated: TypeAlias = tuple[int, int, int] | None


@dataclass(frozen=True)
class _Reading:
    """A folder that is read, and how the file in it stood then that is written anew whenever the
    folder is replaced.
    """

    path: Path
    file: Path
    stated: _Stated


@dataclass(frozen=True)
class _Readings:
    """All that were read in a block."""

    all: list[_Reading] = field(default_factory=list)


_CURRENT: ContextVar[_Readings | None] = ContextVar("readings", default=None)


@contextmanager
def watching_readings() -> Iterator[None]:
    """Raises OutputError in place of an error in the block where a folder that it read has been
    replaced by somebody else.
    """
    token = _CURRENT.set(_Readings())
    try:
        yield
    except (KinegradeError, OSError) as error:
        if changed := _find_changed():
            raise refuse_changed(changed.path) from error
        raise
    finally:
        _CURRENT.reset(token)


def note_reading(path: Path, marker: str) -> None:
    """That a folder begins to be read, of which every replacement writes the file `marker`."""
    if readings := _CURRENT.get():
        file = path.absolute() / marker
        readings.all.append(_Reading(path, file, _state(file)))


def require_readings() -> None:
    """Raises OutputError where a folder that was read has been replaced: what was made of it is of
    neither.
    """
    if changed := _find_changed():
        raise refuse_changed(changed.path)


def forget_readings(place: Path) -> None:
    """That this command puts the folder in its place, or replaced it, itself."""
    if readings := _CURRENT.get():
        readings.all[:] = [
            each for each in readings.all if each.file.parent.resolve() != place.resolve()
        ]


def _find_changed() -> _Reading | None:
    readings = _CURRENT.get()
    found = readings.all if readings else ()
    return next((each for each in found if _state(each.file) != each.stated), None)


def _state(file: Path) -> _Stated:
    """What tells one file at a place from the next, also where both say the same."""
    try:
        found = file.lstat()
    except OSError:
        return None
    return found.st_size, found.st_mtime_ns, found.st_ctime_ns
