"""What a file held before `--force` replaced it: kept beside it, so that a slip loses nothing."""

from __future__ import annotations

import filecmp
import os
import shutil
from enum import Enum, auto
from itertools import count
from pathlib import Path

ENDING = ".previous"  # last in the name, so that no program takes a kept file for a table or a text


class Previous(Enum):
    """Which of the files replaced at one place stay beside it."""

    ALL = auto()  # tables and texts, which people fill in: NAME.previous-1, NAME.previous-2, ...
    LAST = auto()  # what people only read, and write again many times: NAME.previous
    NONE = auto()  # files in folders of the program's own


def keep_previous(target: Path, new: Path, which: Previous) -> None:
    """Keeps what stands at `target`, where `new` holds something else, under a name beside it.

    The target itself stays where it is until it is replaced. Raises OSError.
    """
    if which is Previous.NONE or not target.exists() or filecmp.cmp(target, new, shallow=False):
        return
    kept = _name_of_last(target) if which is Previous.LAST else find_free_name(target)
    try:
        os.link(target, kept)
    except OSError:  # a file system without second names
        shutil.copy2(target, kept)


def _name_of_last(target: Path) -> Path:
    name = target.with_name(target.name + ENDING)
    name.unlink(missing_ok=True)
    return name


def find_free_name(target: Path) -> Path:
    """The first name beside it for one more that is kept."""
    names = (target.with_name(f"{target.name}{ENDING}-{number}") for number in count(1))
    return next(name for name in names if not name.exists())
