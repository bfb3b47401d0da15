"""A class of 137 in two groups and three rooms, and its roster in the forms in which registrars and
systems send it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from openpyxl import Workbook

from kinegrade.files.csv_writing import write_csv_text

CLASS = 137
ROOMS = ("Hall 7", "Annex", "Lab 2")
_NAMES = (
    ("伟", "王"),
    ("娜娜", "欧阳"),
    ("Jürgen", "Weiß"),
    ("Zoë", "O'Neil"),
    ("Émilie", "du Châtelet"),
    ("Łucja", "Żółkiewska"),
    ("Ada", "Lovelace"),
)
_CHINESE = 2  # the first so many names


@dataclass(frozen=True)
class Person:
    """A student; ids have leading zeros, some have extra time."""

    student: str
    first: str
    last: str
    group: str
    room: str
    seat: int
    language: str
    extra_time: str

    @property
    def name(self) -> str:
        """As it is printed."""
        chinese = self.language == "中文"
        return f"{self.last}{self.first}" if chinese else f"{self.first} {self.last}"


def people(count: int = CLASS) -> list[Person]:
    """The first so many of the class."""
    return list(map(_person, range(count)))


def _person(place: int) -> Person:
    which = place % len(_NAMES)
    return Person(
        f"00{12345 + place}",
        *_NAMES[which],
        group="AB"[place % 2],
        room=ROOMS[place % 3],
        seat=place // 3 + 1,
        language="中文" if which < _CHINESE else "",
        extra_time="25 %" if place % 20 == 3 else "",
    )


def write_registrar(path: Path, class_: Sequence[Person]) -> Path:
    """A registrar's workbook with titles above the header, seats and all."""
    workbook = Workbook()
    sheet = workbook.active
    assert sheet is not None
    sheet.append(["Prüfungsliste Technische Mechanik"])
    header = "Matrikelnummer Nachname Vorname Übungsgruppe Hörsaal Platz Sprache Zeitverlängerung"
    sheet.append(header.split())
    for each in class_:
        where = each.group, each.room, each.seat
        sheet.append([each.student, each.last, each.first, *where, each.language, each.extra_time])
    workbook.save(path)
    return path


def write_participants(path: Path, class_: Sequence[Person]) -> Path:
    """The participants of a Moodle course."""
    header = ["First name", "Last name", "ID number", "Email address", "Groups"]
    rows = [
        [each.first, each.last, each.student, f"{each.student}@x.org", each.group]
        for each in class_
    ]
    return _write(path, header, rows, "utf-8-sig")


def write_gradebook(path: Path, class_: Sequence[Person]) -> Path:
    """The gradebook of a Canvas course."""
    header = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Quiz (12)"]
    points = ["    Points Possible", "", "", "", "", "10"]
    rows = [
        [f"{each.last}, {each.first}", str(number), each.student, f"u{number}", each.group, ""]
        for number, each in enumerate(class_)
    ]
    return _write(path, header, [points, *rows], "utf-8-sig")


def write_chinese(path: Path, class_: Sequence[Person]) -> Path:
    """A list of a Chinese registry, in GB18030."""
    rows = [[each.student, each.name, each.group] for each in class_]
    return _write(path, ["学号", "姓名", "班级"], rows, "gb18030")


def _write(path: Path, header: Sequence[str], rows: Sequence[Sequence[str]], encoding: str) -> Path:
    path.write_bytes(write_csv_text(header, rows).encode(encoding))
    return path


def in_rooms(class_: Sequence[Person]) -> Iterator[tuple[str, list[str]]]:
    """Each room with the ids of those who sit in it, by seat."""
    for room in ROOMS:
        seated = sorted((each for each in class_ if each.room == room), key=lambda each: each.seat)
        yield room, [each.student for each in seated]
