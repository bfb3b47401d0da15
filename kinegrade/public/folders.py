"""Whether the folders that are given are what they are given for: an exam, or marks, or a place to
write at.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from kinegrade.errors import OutputError, TableError
from kinegrade.exam.folder.contents import CONTENTS, HEAD, KEY
from kinegrade.language.message import Fault, Message, Text
from kinegrade.marks_folder.layout import ANSWERS, GRADES
from kinegrade.marks_folder.layout import FILES as MARKS_FILES

_Kind = Literal["EXAM", "MARKS"]
_FILES: Mapping[_Kind, tuple[str, ...]] = {
    "EXAM": (HEAD, KEY),
    "MARKS": (ANSWERS.name, GRADES.name),
}
_EXPECTED: Mapping[_Kind, Message] = {
    "EXAM": Message("terminal.exam-folder"),
    "MARKS": Message("terminal.marks-folder"),
}
_PARTS: Mapping[_Kind, tuple[str, ...]] = {
    "EXAM": CONTENTS,
    "MARKS": MARKS_FILES,
}


def expect_own_place(output: Path) -> None:
    """Raises OutputError where writing there would replace a part of an exam, or of marks, by
    something else.
    """
    target = output.absolute()
    for folder, name in ((target.parent, target.name), (target.parent.parent, target.parent.name)):
        for kind, files in _FILES.items():
            inside = all((folder / file).exists() for file in files)
            if inside and target.is_file() and name in _PARTS[kind]:
                part = Message("terminal.part-of-folder", kind=kind, folder=folder.name)
                raise OutputError(Fault(str(output), part))


def expect_folders(*given: tuple[Path | None, _Kind]) -> None:
    """Raises TableError where a folder of the other kind, or a file, was given.

    A folder that is neither is left to the code that reads it. Two swapped folders are one fault.
    """
    wrong = [
        (path, kind, found)
        for path, kind in given
        if path is not None and (found := _find_kind(path)) not in (None, kind)
    ]
    swapped = {(kind, found) for _, kind, found in wrong} >= {("EXAM", "MARKS"), ("MARKS", "EXAM")}
    do = Message("terminal.swap-folders") if swapped else Message("terminal.name-folder")
    faults = [
        Fault(
            str(path),
            Message("terminal.wrong-folder", found=found, kind=kind),
            _EXPECTED[kind],
            do,
        )
        for path, kind, found in wrong
    ]
    if faults:
        raise TableError(*(faults[:1] if swapped else faults))


def _find_kind(path: Path) -> Text | None:
    """What stands there; None for a folder that is neither, or nothing."""
    if path.is_file():
        return Message("terminal.a-file")
    kinds = (
        kind for kind, names in _FILES.items() if any((path / name).exists() for name in names)
    )
    return next(kinds, None)
