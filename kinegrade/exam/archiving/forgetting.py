"""`kinegrade forget`: an exam without its people.

Who wrote which paper is removed for ever: ids, names, addresses, seats, codes, all printed papers
and the secret, by which an id would lead to its numbers. The key, the templates and the marks stay,
under new names in an order that chance makes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from secrets import SystemRandom, token_hex

from msgspec import structs

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import (
    BANK,
    CONTENTS,
    FORMULA_PAGES,
    FORMULA_TEXT,
    HEAD,
    KEY,
    KEY_COLUMNS,
    LOGO,
    NOTICE,
    POOL,
    TEMPLATES,
)
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.exam.folder.writing import encode_line
from kinegrade.exam.generating.exam_files import write_head
from kinegrade.exam.generating.growing.grown_folder import open_grown_folder
from kinegrade.files.output import output_folder
from kinegrade.files.placing.copying import copy_tree
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.forgetting import forget_marks
from kinegrade.marks_folder.layout import FILES, MARKER

_STAY = (LOGO, FORMULA_PAGES, FORMULA_TEXT)
_OTHER_SYSTEMS = "moodle.csv"


def require_people(exam: ExamFolder) -> None:
    """Raises ExamError where the people were forgotten already: names dealt once more would cut off
    the marks that have those of the first time.
    """
    if exam.head.forgotten:
        what, expected = Message("archive.forgotten-already"), Message("archive.with-people")
        raise ExamError(Fault(str(exam.path), what, expected, Message("archive.name-all-marks")))


def require_all_marks(exam: ExamFolder, left: Sequence[Path]) -> None:
    """Raises ExamError where marks of the exam are left that are known and not named."""
    if left:
        what = Message("archive.unnamed-marks", marks=list_plainly(map(str, left)))
        raise ExamError(Fault(str(exam.path), what, do=Message("archive.name-or-delete-marks")))


@dataclass(frozen=True)
class Forgetting:
    """An exam and its marks, whose people are to be forgotten."""

    exam: ExamFolder
    marks: Sequence[MarksFolder]

    def list_removed(self) -> list[str]:
        """The files of the exam that are removed, folders as one."""
        kept = {HEAD, NOTICE, KEY, KEY_COLUMNS, POOL, TEMPLATES, *_STAY}
        found = sorted(each.name for each in self.exam.path.iterdir())
        return [
            name for name in found if name in CONTENTS and name not in kept and not _is_bank(name)
        ]

    def forget(self) -> int:
        """Removes everybody from the folders, from all of them or from none; gives how many people
        there were. Raises OutputError, ExamError, TableError.
        """
        names, known_as = self._make_names(), token_hex(8)
        with ExitStack() as stack:
            for each in self.marks:
                contents = *FILES, _OTHER_SYSTEMS
                written = output_folder(each.path, marker=MARKER, contents=contents, force=True)
                target = stack.enter_context(written)
                forget_marks(each, {**names, each.exam: known_as}, target)
            self._write_exam(stack.enter_context(open_grown_folder(self.exam)), names, known_as)
        return len(names)

    def _make_names(self) -> Mapping[str, str]:
        """A new name for everybody, in an order that nobody knows."""
        students = [*self.exam.students, *self._list_pool()]
        for marks in self.marks:
            students += marks.totals.by_student
            students += [each[1] for each in marks.log]  # who has left the class among them
        everybody = list(dict.fromkeys(students))
        SystemRandom().shuffle(everybody)
        digits = len(str(len(everybody)))
        return {student: f"p{place:0{digits}d}" for place, student in enumerate(everybody, 1)}

    def _list_pool(self) -> Iterator[str]:
        return (each.student for each in self.exam.keys.pool_lines())

    def _write_exam(self, folder: Path, names: Mapping[str, str], known_as: str) -> None:
        for file in self.exam.path.iterdir():
            if file.name in _STAY or _is_bank(file.name):
                (folder / file.name).write_bytes(file.read_bytes())
        copy_tree(self.exam.path / TEMPLATES, folder / TEMPLATES)  # with its shared mechanisms
        (folder / KEY).write_bytes(_encode(self.exam.keys.lines(), names))
        if self.exam.keys.has_pool:
            (folder / POOL).write_bytes(_encode(self.exam.keys.pool_lines(), names))
        head = structs.replace(_forget_head(self.exam.head, names), known_as=known_as)
        stated = self.exam.head.editable
        left = {name: each for name, each in (stated or {}).items() if (folder / name).exists()}
        write_head(head, None if stated is None else left, folder)


def _is_bank(name: str) -> bool:
    return name.startswith(Path(BANK).stem) and name.endswith(Path(BANK).suffix)


def _encode(lines: Iterator[KeyLine], names: Mapping[str, str]) -> bytes:
    """The lines of a key under new names, in their order."""
    new = [
        structs.replace(each, student=names[each.student], paper="", place=None) for each in lines
    ]
    return b"".join(map(encode_line, sorted(new, key=lambda each: each.student)))


def _forget_head(head: ExamHead, names: Mapping[str, str]) -> ExamHead:
    students = [_forget_candidate(each, names) for each in head.students]
    return structs.replace(
        head,
        students=tuple(sorted(students, key=lambda each: each.student)),
        spares=(),
        papers_before=(),
        secret=None,
        label=None,
        codes=None,
        reproducible=None,
        seed=None,
        forgotten=True,
    )


def _forget_candidate(candidate: Candidate, names: Mapping[str, str]) -> Candidate:
    """What statistics need: the version of the paper and the group."""
    return Candidate(names[candidate.student], "", version=candidate.version, group=candidate.group)
