"""Files of a folder that people edited after it was written: kept beside it when it is replaced.

All files of a folder that we write get one time, a whole second; whatever was saved later has
another one. Folders without such a time, as earlier versions wrote, tell nothing.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path

from kinegrade.files.placing.droppings import DESKTOP_DROPPINGS
from kinegrade.files.placing.previous import find_free_name
from kinegrade.language.message import Message, list_first

_SECOND = 10**9  # in nanoseconds
_NAMED = 5  # files that a message names


@dataclass(frozen=True)
class Edits:
    """The `names` of the files below `folder` that were edited, and the folder where they are
    `kept` when it is replaced, None where there are none.
    """

    folder: Path
    names: tuple[str, ...]
    kept: Path | None

    def settle(self, new: Path) -> None:
        """Copies what was edited, and gives all files of the `new` folder one time, by which those
        edited later are known. Raises OSError.
        """
        if self.kept is not None:
            for name in self.names:
                (self.kept / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(self.folder / name, self.kept / name)
        times = _list_times(new)
        written = min(times.values(), default=0) // _SECOND * _SECOND
        for file in times:
            os.utime(file, ns=(written, written))

    def describe(self) -> Iterator[Message]:
        """That files were edited, and where they are now."""
        if self.kept is not None:
            yield Message(
                "files.edited-kept",
                folder=str(self.folder),
                count=len(self.names),
                names=list_first(self.names, _NAMED),
                kept=str(self.kept),
            )


def find_edits(folder: Path, *, marker: str, guarded: Collection[str] = ()) -> Edits:
    """What was edited in a folder since it was written, but for files whose loss their readers
    refuse (`guarded`); nothing in a folder without the `marker`, which is not replaced.
    """
    times = _list_times(folder) if os.path.isfile(folder / marker) else {}
    written = min(times.values(), default=0)
    later = sorted(file for file, time in times.items() if time > written)
    sealed = written % _SECOND == 0
    names = (file.relative_to(folder).as_posix() for file in later if sealed)
    edited = tuple(name for name in names if name not in guarded)
    return Edits(folder, edited, find_free_name(folder) if edited else None)


def _list_times(folder: Path) -> dict[Path, int]:
    """When each file below a folder was last saved, in nanoseconds."""
    files = (each for each in folder.rglob("*") if each.name not in DESKTOP_DROPPINGS)
    return {file: file.stat().st_mtime_ns for file in files if file.is_file()}
