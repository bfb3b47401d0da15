"""The papers of each room in one file, in the order of the seats, beside the file of all papers."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from kinegrade.exam.folder.contents import PAPERS, ROOMS
from kinegrade.exam.roster.roster import find_seat
from kinegrade.exam.roster.students import Student, make_room_stems
from kinegrade.press.join import open_volume

_NOWHERE = "without-room"  # the booklet of students of whom no room is known


def write_room_booklets(folder: Path, students: Iterable[Student]) -> None:
    """Write the booklets of an exam whose papers stand in `folder`, in place of those that it has;
    none where no student has a room, or no paper is printed.
    """
    shutil.rmtree(folder / ROOMS, ignore_errors=True)
    rooms: dict[str, list[Student]] = {}
    for student in sorted(students, key=find_seat):
        rooms.setdefault(student.room, []).append(student)
    if not any(rooms) or not (folder / PAPERS).is_dir():
        return
    (folder / ROOMS).mkdir()
    names = name_booklets(rooms)
    for room, inside in rooms.items():
        with open_volume(folder / ROOMS / f"{names[room]}.pdf", duplex=True) as append:
            for each in inside:
                append((folder / PAPERS / f"{each.file_name}.pdf").read_bytes())


def name_booklets(rooms: Iterable[str]) -> Mapping[str, str]:
    """The stem of the file of each room, "" among them for none."""
    named: Sequence[str] = [room for room in rooms if room]
    stems = make_room_stems([*named, _NOWHERE])
    return {**{room: stems[room] for room in named}, "": stems[_NOWHERE]}
