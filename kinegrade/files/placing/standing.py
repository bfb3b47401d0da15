"""What stands at the place of a folder, by which a command notices that it changed while it ran:
another command replaced it, or somebody saved a file in it.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from kinegrade.errors import OutputError
from kinegrade.files.placing.droppings import DESKTOP_DROPPINGS
from kinegrade.language.message import Fault, Message


@dataclass(frozen=True)
class Standing:
    """The files below a folder, each with its size, when it was saved, and when it came to be so
    on this disk; none where there is no folder. Of a folder without the file `marker` only those
    that lie in it directly.

    Renaming the folder changes none of them. Numbers of files are not among them: some network
    disks make them up anew.
    """

    files: Mapping[str, tuple[int, int, int]]
    marker: str | None = None

    def require(self, folder: Path, path: Path) -> None:
        """Raises OutputError, about `path`, where something else stands there now."""
        if find_standing(folder, self.marker) != self:
            raise refuse_changed(path)


def _holds(folder: Path, marker: str) -> bool:
    """Whether a folder has the file by which kinegrade recognises its own."""
    try:
        return (folder / marker).exists()
    except OSError:  # a name that is too long, which writing refuses
        return False


def refuse_changed(path: Path) -> OutputError:
    """The refusal to replace what has changed meanwhile."""
    what, do = Message("files.changed-meanwhile"), Message("files.give-again")
    return OutputError(Fault(str(path), what, Message("files.one-command"), do))


def find_standing(folder: Path, marker: str | None = None) -> Standing:
    """What stands there now. A folder without the file `marker`, which may be anybody's whole disk,
    is not looked through: nothing there is going to be replaced.
    """
    is_own = marker is None or _holds(folder, marker)
    files = {}
    for place, _, names in islice(os.walk(folder), None if is_own else 1):
        for name in names:
            file = Path(place, name)
            with suppress(OSError):  # taken away in this moment, or never to be seen
                found = file.lstat()
                stated = found.st_size, found.st_mtime_ns, found.st_ctime_ns
                files[file.relative_to(folder).as_posix()] = stated
    return Standing(
        {name: each for name, each in files.items() if Path(name).name not in DESKTOP_DROPPINGS},
        marker,
    )
