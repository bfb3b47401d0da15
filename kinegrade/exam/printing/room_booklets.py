"""The papers of each room in one file, in the order of the seats, beside the file of all papers."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Set
from pathlib import Path

from kinegrade.exam.folder.contents import PAPERS, ROOMS
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.roster import find_seat
from kinegrade.exam.roster.students import Student
from kinegrade.exam.roster.volume_names import VolumeNames, name_volumes
from kinegrade.exam.setting.kept_exam import student_of
from kinegrade.press.join import open_volume

_NOWHERE = "without-room"  # the booklet of students of whom no room is known


def write_room_booklets(folder: Path, head: ExamHead) -> None:
    """Write the booklets of an exam whose papers stand in `folder`, in place of those that it has,
    with one of the spare papers, which go to any room; none where no student has a room, or no
    paper is printed.
    """
    shutil.rmtree(folder / ROOMS, ignore_errors=True)
    rooms: dict[str, list[Student]] = {}
    for student in sorted(map(student_of, head.students), key=find_seat):
        rooms.setdefault(student.room, []).append(student)
    if not any(rooms) or not (folder / PAPERS).is_dir():
        return
    (folder / ROOMS).mkdir()
    names = _name_booklets(head)
    for room, inside in rooms.items():
        _write_booklet(folder, names.stems[room], inside)
    if head.spares:
        _write_booklet(folder, names.spare, map(student_of, head.spares))


def list_booklets(head: ExamHead) -> Set[str]:
    """The stems of the booklets that an exam may have."""
    names = _name_booklets(head)
    return {*names.stems.values(), names.spare}


def _name_booklets(head: ExamHead) -> VolumeNames:
    return name_volumes((each.room for each in head.students), _NOWHERE)


def _write_booklet(folder: Path, stem: str, students: Iterable[Student]) -> None:
    with open_volume(folder / ROOMS / f"{stem}.pdf", duplex=True) as append:
        for each in students:
            append((folder / PAPERS / f"{each.file_name}.pdf").read_bytes())
