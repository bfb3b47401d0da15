"""The papers of each room in one file, in the order of the seats, beside the file of all papers."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Mapping, Set
from pathlib import Path

from kinegrade.exam.folder.contents import PAPERS, ROOMS
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.roster import find_seat
from kinegrade.exam.roster.students import Student
from kinegrade.exam.roster.volume_names import VolumeNames, name_volumes
from kinegrade.exam.setting.kept_exam import student_of
from kinegrade.press.join import open_volume

_NOWHERE = "without-room"  # the booklet of students of whom no room is known


def write_room_booklets(folder: Path, head: ExamHead, before: ExamFolder | None = None) -> None:
    """Write the booklets of an exam whose papers stand in `folder`, in place of those that it has,
    with one of the spare papers, which go to any room; none where no student has a room, or no
    paper is printed.

    `folder` may be a copy of what an exam was `before`: a booklet that has the same papers as then
    stays, as it would come out the same.
    """
    booklets = _arrange_booklets(head) if (folder / PAPERS).is_dir() else {}
    same = _find_unchanged(booklets, before, folder) if before is not None else frozenset()
    for old in (folder / ROOMS).glob("*"):
        if old.stem not in same:
            old.unlink()
    if not booklets:
        shutil.rmtree(folder / ROOMS, ignore_errors=True)
        return
    (folder / ROOMS).mkdir(exist_ok=True)
    for stem in booklets.keys() - same:
        _write_booklet(folder, stem, booklets[stem])


def _arrange_booklets(head: ExamHead) -> dict[str, tuple[str, ...]]:
    """The papers of each booklet in their order, by their file names; no booklet where no student
    has a room.
    """
    rooms: dict[str, list[Student]] = {}
    for student in sorted(map(student_of, head.students), key=find_seat):
        rooms.setdefault(student.room, []).append(student)
    if not any(rooms):
        return {}
    names = _name_booklets(head)
    booklets = {names.stems[room]: inside for room, inside in rooms.items()}
    if head.spares:
        booklets[names.spare] = list(map(student_of, head.spares))
    return {stem: tuple(each.file_name for each in inside) for stem, inside in booklets.items()}


def _find_unchanged(
    booklets: Mapping[str, tuple[str, ...]], before: ExamFolder, folder: Path
) -> Set[str]:
    """The booklets with the same papers as before, by their bytes, in the same order."""
    earlier = _arrange_booklets(before.head)
    return {
        stem
        for stem, inside in booklets.items()
        if earlier.get(stem) == inside
        and (folder / ROOMS / f"{stem}.pdf").is_file()
        and all(_is_unchanged(before.path, folder, name) for name in inside)
    }


def _is_unchanged(before: Path, folder: Path, name: str) -> bool:
    now, then = (place / PAPERS / f"{name}.pdf" for place in (folder, before))
    return then.is_file() and now.read_bytes() == then.read_bytes()


def list_booklets(head: ExamHead) -> Set[str]:
    """The stems of the booklets that an exam may have."""
    names = _name_booklets(head)
    return {*names.stems.values(), names.spare}


def _name_booklets(head: ExamHead) -> VolumeNames:
    return name_volumes((each.room for each in head.students), _NOWHERE)


def _write_booklet(folder: Path, stem: str, inside: Iterable[str]) -> None:
    with open_volume(folder / ROOMS / f"{stem}.pdf", duplex=True) as append:
        for name in inside:
            append((folder / PAPERS / f"{name}.pdf").read_bytes())
