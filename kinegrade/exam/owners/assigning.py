"""`kinegrade assign`: a spare paper becomes that of a student, who writes it already.

Its numbers and its code stay, and so does every other paper.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from msgspec import structs

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import KEY, SPARES
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.folder.writing import encode_line
from kinegrade.exam.generating.growing.adding import write_rest
from kinegrade.exam.generating.growing.grown_class import find_stem
from kinegrade.exam.generating.growing.grown_folder import copy_exam, open_grown_folder
from kinegrade.exam.owners.papers_anew import print_anew
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.exam.roster.students import Student, make_student_key
from kinegrade.exam.roster.taken_ids import list_former_owners, list_twins
from kinegrade.language.message import Fault, Message, Quoted, list_plainly


@dataclass(frozen=True)
class Assigned:
    """Whose paper it is now, by its code, how many spare papers are left, and what is said of a
    workbook that was typed into.
    """

    student: str
    code: str
    left: int
    typed: tuple[Message, ...]

    @property
    def summary(self) -> Message:
        """What was done, in one line."""
        return Message(
            "exam.assigned", code=self.code, student=Quoted(self.student), count=self.left
        )


def assign_paper(path: Path, code: str, student: Student) -> Assigned:
    """Give the spare paper of that code to a student who has none; printed again, it carries the
    name.

    Raises ExamError where there is no such spare paper, or the student has a paper, perhaps under
    an id with other zeros in front; OutputError. Then nothing is written.
    """
    exam = open_exam(path)
    spare = _find_spare(exam, code)
    owner = make_owner(exam, spare, student)
    left = tuple(each for each in exam.head.spares if each != spare)
    head = structs.replace(exam.head, students=(*exam.head.students, owner), spares=left)
    with open_grown_folder(exam) as folder:
        copy_exam(exam, folder)
        _move_line(exam, folder, spare, owner)
        rename_files(folder, Path(spare.file).stem, Path(owner.file).stem)
        print_anew(ExamFolder(folder, head), (owner,))
        typed = write_rest(exam, folder, head)
    return Assigned(owner.student, owner.paper, len(left), typed)


def _find_spare(exam: ExamFolder, code: str) -> Candidate:
    """The spare paper of that code. Raises ExamError."""
    by_code = {each.paper: each for each in exam.head.spares}
    found = StudentIds((), {each: each for each in by_code}).coded(code)
    if found is not None:
        return by_code[found]
    owner = StudentIds((), exam.codes).coded(code)
    what = (
        Message("exam.no-spare", code=Quoted(code))
        if owner is None
        else Message("exam.spare-taken", code=Quoted(code), student=Quoted(owner))
    )
    known = Message("exam.spares-left", codes=list_plainly(by_code))
    do = known if by_code else Message("exam.generate-spares")
    if owner is not None:
        do = Message("exam.write-exchange")
    raise ExamError(Fault(str(exam.head_file), what, do=do))


def make_owner(exam: ExamFolder, spare: Candidate, student: Student) -> Candidate:
    """The student with that paper. Raises ExamError where the student has one already."""
    known = {make_student_key(each): each for each in exam.students}
    key = make_student_key(student.student)
    if not key or key in known:
        shown = Quoted(student.student)
        what = Message("exam.has-own-paper", student=shown) if key else Message("exam.empty-id")
        expected = Message("exam.students-without")
        do = Message("exam.write-exchange") if key else ""
        raise ExamError(Fault(str(exam.head_file), what, expected, do))
    where, late = str(exam.head_file), Message("exam.other-person-late")
    others = (
        *list_twins(exam.students, student.student, where, late),
        *list_former_owners(exam.former_ids, student.student, where),
    )
    if others:
        raise ExamError(*others)
    return structs.replace(
        spare,
        student=student.student,
        name=student.name,
        email=student.email,
        group=student.group,
        room=student.room,
        was_spare=True,
        file=str(PurePosixPath(spare.file).with_name(f"{find_stem(exam, student)}.pdf")),
    )


def _move_line(exam: ExamFolder, folder: Path, spare: Candidate, owner: Candidate) -> None:
    """Give the line of the key to the student."""
    line = exam.keys.line_of(spare.student)
    others = [each for each in exam.keys.spare_lines() if each.student != spare.student]
    (folder / SPARES).write_bytes(b"".join(map(encode_line, others)))
    if not others:
        (folder / SPARES).unlink()
    key = exam.keys.file.read_bytes()
    ended = key if key.endswith(b"\n") else key + b"\n"
    moved = encode_line(structs.replace(line, student=owner.student))
    (folder / KEY).write_bytes(ended + moved)


def rename_files(folder: Path, old: str, new: str) -> None:
    """All files of a paper, whatever their kind."""
    for file in sorted(folder.glob(f"*/**/{old}.*")):
        file.rename(file.with_name(f"{new}{file.suffix}"))
