"""A class that grows: whether a roster is that of the exam folder to which late students are added,
and who is late.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from kinegrade.errors import TableError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.generating.replacing.paper_changes import compare_students
from kinegrade.exam.printing.reprint import find_kinds
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student, choose_places, make_file_names, make_student_key
from kinegrade.exam.roster.taken_ids import list_former_owners, list_twins
from kinegrade.exam.setting.kept_exam import student_of
from kinegrade.language.message import Fault, Message, Quoted


@dataclass(frozen=True)
class LateClass:
    """The late students of an exam, and the class `together`: who has a paper, then these."""

    late: Roster
    together: tuple[Student, ...]


def late_class(exam: ExamFolder, roster: Roster, late: Roster) -> LateClass:
    """The late students, with file names beside those of the others.

    Raises TableError where the roster is not that of the exam, where a late student has a paper
    already, or would need the file name of somebody who has one.
    """
    earlier = tuple(map(student_of, exam.head.students))
    spares = tuple(map(student_of, exam.head.spares))
    known = {make_student_key(each.student): each for each in earlier}
    faults = [*_roster_faults(exam, known, roster), *_known_faults(exam, known, late)]
    if faults:
        raise TableError(*faults)
    _require_names_kept((*earlier, *spares), late)
    stems = make_file_names(each.student for each in (*earlier, *spares, *late.students))
    seated = late.seated.students
    before, files = len(exam.head.everybody), 1 + len(find_kinds(exam))
    places = choose_places([stems[each.student] for each in seated], each=files, before=before)
    newcomers = tuple(map(_with_files_at, seated, places))
    return LateClass(replace(late, students=newcomers), (*earlier, *newcomers))


def _roster_faults(
    exam: ExamFolder, known: Mapping[str, Student], roster: Roster
) -> Iterator[Fault]:
    """How a roster differs from that of an exam, but for its order, and for those who came
    unannounced and were assigned a spare paper.
    """
    given = {make_student_key(each.student): each for each in roster.students}
    unannounced = {make_student_key(each.student) for each in exam.head.students if each.was_spare}
    for student in (each for key, each in known.items() if key not in {*given, *unannounced}):
        yield Fault(
            roster.file,
            Message("exam.no-student", student=Quoted(student.student)),
            Message("exam.everyone-with-paper", exam=str(exam.path)),
            Message("exam.add-line"),
        )
    for key, student in given.items():
        if key not in known:
            whose = Quoted(student.student)
            yield Fault(
                _place(roster, student),
                Message("exam.student-without-paper", student=whose, exam=str(exam.path)),
                Message("exam.students-of-exam"),
                Message("exam.list-late-alone"),
            )
        else:
            yield from _changes(exam, known[key], roster, student)


def _changes(exam: ExamFolder, known: Student, roster: Roster, given: Student) -> Iterator[Fault]:
    """What of a student stands otherwise in the exam, on whose paper the name is printed."""
    for field, here, there in compare_students(given, known):
        if here != there:
            whose, file = Quoted(given.student), str(exam.path / HEAD)
            yield Fault(
                _place(roster, given),
                Message("exam.field-of-student", field=field, text=Quoted(here), student=whose),
                Message("exam.as-in", text=Quoted(there), file=file),
                Message("exam.correct-line"),
            )


def _known_faults(exam: ExamFolder, known: Mapping[str, Student], late: Roster) -> Iterator[Fault]:
    for student in late.students:
        if make_student_key(student.student) in known:
            what = Message(
                "exam.has-paper-already",
                student=Quoted(student.student),
                name=student.name,
                exam=str(exam.path),
            )
            expected, do = Message("exam.students-without"), Message("exam.delete-line")
            yield Fault(_place(late, student), what, expected, do)
            continue
        yield from list_neighbours(exam, student, _place(late, student))
        yield from list_former_owners(exam.former_ids, student.student, _place(late, student))
        if not late.odd_ids:
            where, do = _place(late, student), Message("roster.one-person")
            yield from list_twins(exam.students, student.student, where, do)


def list_neighbours(exam: ExamFolder, student: Student, where: str) -> Iterator[Fault]:
    """Those of the exam who sit on the seat of a new student."""
    for each in exam.head.students if student.room and student.seat else ():
        if (each.room, each.seat) == (student.room, student.seat):
            seat, whose = student.seat, Quoted(each.student)
            what = Message("exam.seat-taken", seat=seat, room=student.room, student=whose)
            yield Fault(where, what, do=Message("exam.another-seat"))


def _require_names_kept(earlier: Sequence[Student], late: Roster) -> None:
    """Raises TableError where files of students who have a paper would be called otherwise: not
    every file system tells capitals from small letters.
    """
    before = make_file_names(each.student for each in earlier)
    after = make_file_names(each.student for each in (*earlier, *late.students))
    faults = [
        Fault(late.file, Message("exam.id-differs-in-capitals", student=Quoted(student)))
        for student, stem in before.items()
        if after[student] != stem
    ]
    if faults:
        raise TableError(*faults)


def _with_files_at(student: Student, place: str) -> Student:
    return replace(student, file_name=place)


def find_stem(exam: ExamFolder, student: Student) -> str:
    """The file name of somebody new. Raises TableError where that of a student with a paper would
    change.
    """
    everybody = exam.head.everybody
    late = Roster((student,), (), str(exam.head_file))
    _require_names_kept(tuple(map(student_of, everybody)), late)
    return make_file_names([*(each.student for each in everybody), student.student])[
        student.student
    ]


def _place(roster: Roster, student: Student) -> str:
    return f"{roster.file}:{student.line}"
