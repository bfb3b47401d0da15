"""Students: who they are, how ids are compared, what their files are called, and where they stand
below a folder with a file for each.

There they stand side by side, and from a thousand on in numbered folders, as programs that show a
folder are slow with more. A place is a path without suffix, `0012` or `07/0012`. An exam keeps that
of each paper, so that folders of any version are read alike.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import PurePosixPath
from typing import Literal, TypeAlias
from unicodedata import normalize
from urllib.parse import quote

from kinegrade.files.cell_text import drop_invisible, trim

#: How a paper is printed: as usual, in letters of 18 points, a question a page, or as usual with
#: its figures for swell paper beside it.
PrintFormat: TypeAlias = Literal["", "large-print", "tactile"]
MOST_TOGETHER = 1000  # files in one folder
_LONGEST_STEM = 100
_LONGEST_ROOM = 50  # characters of up to four bytes
_UNSAFE = re.compile(r"[^\w.-]+")
_RESERVED = re.compile(r"(?:con|prn|aux|nul|com[0-9]|lpt[0-9])(?:\.|$)", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Student:
    """One student; `file_name` is safe on every system and different from all others of the
    roster, on a paper that is set behind a numbered folder where the class is large.

    What a roster does not say is "": `language`, in which the paper is printed, is then that of the
    exam, and `print_format` the usual one; `extra_time` is a text such as "25 %" or "30 min".
    `line` is where the student stands in the roster's file, 0 where there is none. A `spare` paper
    has no student yet: its id is a name for it, which is not printed.
    """

    student: str
    name: str
    email: str
    file_name: str
    group: str = ""
    room: str = ""
    seat: str = ""
    language: str = ""
    extra_time: str = ""
    print_format: PrintFormat = ""
    spare: bool = False
    line: int = field(default=0, compare=False)

    @property
    def reads_large_print(self) -> bool:
        """Whether the paper is printed in large letters, on as many pages as that takes."""
        return self.print_format == "large-print"

    @property
    def reads_by_touch(self) -> bool:
        """Whether the figures of the paper are made for swell paper as well."""
        return self.print_format == "tactile"


def make_student_key(student: str) -> str:
    """An id as it is compared: surrounding blanks, full-width forms and what cannot be seen are
    ignored, zeros and case matter.

    >>> make_student_key("\\uff10\\uff10\\uff17 ")
    '007'
    """
    if student.isascii() and student.isalnum():  # as most ids are
        return student
    return trim(normalize("NFKC", drop_invisible(student)))


def make_student_keys(students: Sequence[str]) -> Sequence[str]:
    """The same of many ids, most of which stand as they are.

    >>> make_student_keys(["007", "S9"]), make_student_keys(["007 "])
    (['007', 'S9'], ['007'])
    """
    together = "".join(students)
    if together.isascii() and together.isalnum():
        return students
    return [*map(make_student_key, students)]


def make_file_names(students: Iterable[str]) -> dict[str, str]:
    """A file stem for each id: the id itself where it is plain, percent-encoded where it is not.

    No two stems are equal, not even where the file system takes upper and lower case for the same.

    >>> make_file_names(["007", "a/b", "CON"])
    {'007': '007', 'a/b': 'a%2Fb', 'CON': '%43ON'}
    """
    stems = {student: _make_stem(student) for student in students}
    alike = Counter(stem.lower() for stem in stems.values())
    return {
        student: _cut(student, _encode_capitals(stem) if alike[stem.lower()] > 1 else stem)
        for student, stem in stems.items()
    }


def make_room_stems(rooms: Iterable[str]) -> dict[str, str]:
    """A file stem for each room, in its own words as far as file systems allow.

    >>> make_room_stems(["Hall 7", "H/1", "h 1", "\u6559\u4e00-101"])
    {'Hall 7': 'Hall-7', 'H/1': 'H%2F1', 'h 1': 'h%201', '教一-101': '教一-101'}
    """
    names = dict.fromkeys(rooms)
    plain = {room: _UNSAFE.sub("-", normalize("NFKC", room)).strip(".-") for room in names}
    alike = Counter(stem.casefold() for stem in plain.values())
    encoded = make_file_names(names)
    return {
        room: stem if _is_safe(stem) and alike[stem.casefold()] == 1 else encoded[room]
        for room, stem in plain.items()
    }


def choose_places(stems: Sequence[str], *, each: int = 1, before: int = 0) -> list[str]:
    """The places of students whose files begin with these stems, of whom everybody has `each` so
    many, behind those of so many students `before`.

    >>> choose_places(["a", "b"], before=999)
    ['00/a', '01/b']
    """
    together = MOST_TOGETHER // each
    if before + len(stems) <= together:
        return list(stems)
    return [f"{number // together:02}/{stem}" for number, stem in enumerate(stems, before)]


def read_place(file: str) -> str:
    """The place of a file that is named from the exam folder on; "" where none is named.

    >>> read_place("papers/07/0012.pdf")
    '07/0012'
    """
    path = PurePosixPath(file)
    return "" if not file else str(PurePosixPath(*path.parts[1:]).with_name(path.stem))


def _is_safe(stem: str) -> bool:
    return 0 < len(stem) <= _LONGEST_ROOM and not _RESERVED.match(stem)


def _make_stem(student: str) -> str:
    stem = quote(student, safe="", errors="surrogatepass").replace("~", "%7E")
    if stem.startswith(".") or _RESERVED.match(stem):
        return f"%{ord(stem[0]):02X}{stem[1:]}"
    return stem


def _encode_capitals(stem: str) -> str:
    return re.sub(r"(%..)|([A-Z])", lambda found: found[1] or f"%{ord(found[2]):02X}", stem)


def _cut(student: str, stem: str) -> str:
    """The stem, shortened if it is long: file systems allow 255 bytes at most. The encoding never
    gives `%-`, so it stays unique.
    """
    if len(stem) <= _LONGEST_STEM:
        return stem
    digest = sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:32]
    return f"{stem[:40]}%-{digest}"
