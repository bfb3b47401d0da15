"""`kinegrade exchange`: a student gets the paper that was written in place of the own one.

Two students exchange theirs; a spare paper takes the place of the own, which is spare then; a
student of another version gets that; and a spare paper that was assigned to the wrong student is
passed on. What is printed of these papers is printed anew; all others stay.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from msgspec import structs

from kinegrade.errors import ExamError, suggest
from kinegrade.exam.folder.contents import POOL
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import Candidate, PaperBefore
from kinegrade.exam.generating.growing.adding import write_rest
from kinegrade.exam.generating.growing.grown_folder import copy_exam, open_grown_folder
from kinegrade.exam.owners.assigning import make_owner, rename_files
from kinegrade.exam.owners.papers_anew import print_anew, replace_lines
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.exam.roster.students import Student, make_student_key
from kinegrade.exam.setting.kept_exam import student_of
from kinegrade.language.message import Fault, Message, Quoted


@dataclass(frozen=True)
class Exchanged:
    """What was done, in one line, and what is said of a workbook that was typed into, and of a pool
    that is gone.
    """

    summary: Message
    notes: tuple[Message, ...]


@dataclass(frozen=True)
class _Change:
    """Who stands in the exam now, and the line of the key there, by who stood there before;
    `passed_on` are those who have taken the place of another person.
    """

    owners: Mapping[str, Candidate]
    lines: Mapping[str, KeyLine]
    summary: Message
    passed_on: Mapping[Candidate, Candidate] = field(default_factory=dict)


@dataclass(frozen=True)
class ExchangeWishes:
    """With `new_id` the student is the person who has the paper already, under another id; a pool
    that was made of the exam, which nobody answered, is removed by `drop_pool`.
    """

    new_id: bool = False
    drop_pool: bool = False


def exchange_papers(path: Path, code: str, student: Student, wishes: ExchangeWishes) -> Exchanged:
    """Give the paper of that code, or of that version, to a student of the exam who has another, or
    an assigned spare paper to one who has none, with the name given, by default that of the person
    before.

    Raises ExamError where there is no such paper, where it is the student's already, or is that of
    somebody who would be left without, and where a pool was made of the exam and is not to be
    removed; OutputError. Then nothing is written.
    """
    exam = open_exam(path)
    change = _rename(exam, code, student) if wishes.new_id else _find_change(exam, code, student)
    has_pool, changed = exam.keys.has_pool and not change.passed_on, change.owners
    if has_pool and not wishes.drop_pool:  # whose questions are known by the papers they are of
        raise _refuse(exam, Message("exam.pool-of-papers"), Message("exam.responses-of-pool"))
    head = structs.replace(
        exam.head,
        students=tuple(changed.get(each.student, each) for each in exam.head.students),
        spares=tuple(changed.get(each.student, each) for each in exam.head.spares),
        corrections=exam.head.corrections + 1,  # marks that were given before are by another key
        papers_before=(*exam.head.papers_before, *_list_before(exam, changed)),
    )
    dropped = [Message("exam.pool-dropped", file=str(exam.keys.pool_file))] if has_pool else []
    with open_grown_folder(exam) as folder:
        copy_exam(exam, folder)
        replace_lines(exam, folder, change.lines)
        if has_pool:
            (folder / POOL).unlink()
        for before, after in change.passed_on.items():
            rename_files(folder, Path(before.file).stem, Path(after.file).stem)
        print_anew(ExamFolder(folder, head), tuple(changed.values()))
        typed = write_rest(exam, folder, head, change.passed_on)
    return Exchanged(change.summary, (*typed, *dropped))


def _find_change(exam: ExamFolder, code: str, student: Student) -> _Change:
    """What is exchanged. Raises ExamError."""
    known = {make_student_key(each.student): each for each in exam.head.students}
    own = known.get(make_student_key(student.student))
    if own is None:
        return _pass_on(exam, code, student)
    if student.name or student.email or student.group:
        what = Message("exam.has-own-name", student=Quoted(own.student))
        raise _refuse(exam, what, Message("exam.leave-out-name"))
    letter = code.strip().upper()
    if letter in exam.head.versions:
        return _change_version(exam, own, letter)
    return _exchange(exam, own, _find_paper(exam, code))


def _exchange(exam: ExamFolder, own: Candidate, other: Candidate) -> _Change:
    """Two papers, of which one may be spare, change hands. Raises ExamError."""
    if other == own:
        raise _explain_own(exam, own)
    there = Message("exam.spare-now", code=own.paper)
    if other not in exam.head.spares:
        there = Message("exam.has-paper", student=Quoted(other.student), code=own.paper)
    here = Message("exam.has-paper", student=Quoted(own.student), code=other.paper)
    return _Change(
        {own.student: _with_paper(own, other), other.student: _with_paper(other, own)},
        {
            own.student: _with_owner(exam.keys.line_of(other.student), own),
            other.student: _with_owner(exam.keys.line_of(own.student), other),
        },
        Message("exam.exchanged", here=here, there=there),
    )


def _change_version(exam: ExamFolder, own: Candidate, letter: str) -> _Change:
    """A student gets another version, whose letter stands before the code. Raises ExamError."""
    if own.version == letter:
        raise _explain_own(exam, own)
    line = exam.keys.line_of(own.student)
    other = next((each for each in exam.head.everybody if each.version == letter), None)
    if other is None:
        raise _refuse(exam, Message("exam.version-unheld", version=letter), "")
    code = f"{letter}-{own.paper.removeprefix(f'{own.version}-')}"
    owner = structs.replace(own, paper=code, version=letter)
    changed = structs.replace(
        exam.keys.line_of(other.student), student=own.student, paper=code, place=line.place
    )
    return _Change(
        {own.student: owner},
        {own.student: changed},
        Message("exam.has-version", student=Quoted(own.student), version=letter, code=code),
    )


def _pass_on(exam: ExamFolder, code: str, student: Student) -> _Change:
    """A spare paper that was assigned to a mistyped id is that of another. Raises ExamError."""
    before = _find_paper(exam, code)
    if before in exam.head.spares:
        what = Message("exam.nothing-to-exchange", student=Quoted(student.student))
        raise _refuse(exam, what, Message("exam.write-assign", code=before.paper))
    if not before.was_spare:
        what = Message("exam.spare-taken", code=Quoted(code), student=Quoted(before.student))
        raise _refuse(exam, what, Message("exam.only-spare-passed-on"))
    stated = student.name or student.email or student.group
    kept = replace(student, name=before.name, email=before.email, group=before.group)
    owner = _hand_over(exam, before, student if stated else kept)
    done = Message(
        "exam.passed-on",
        code=owner.paper,
        student=Quoted(owner.student),
        name=owner.name or Message("exam.no-name-known"),
        before=Quoted(before.student),
    )
    return _replace(exam, before, owner, done)


def _rename(exam: ExamFolder, code: str, student: Student) -> _Change:
    """Who has the paper of that code, or that id, has another id, and what else is given. Raises
    ExamError.
    """
    before = _find_paper(exam, code)
    if before in exam.head.spares:
        what = Message("marking.nobodys-paper", code=before.paper)
        raise _refuse(exam, what, Message("exam.write-assign", code=before.paper))
    person = student_of(before)
    same = replace(
        person,
        student=student.student,
        name=student.name or person.name,
        email=student.email or person.email,
        group=student.group or person.group,
    )
    if same == person:
        what = Message("exam.same-id", student=Quoted(before.student))
        raise _refuse(exam, what, Message("exam.give-another-id"))
    owner = structs.replace(_hand_over(exam, before, same), was_spare=before.was_spare)
    whose, who = Quoted(before.student), Quoted(owner.student)
    done = Message("exam.has-new-id", before=whose, student=who, code=owner.paper)
    return _replace(exam, before, owner, done)


def _replace(exam: ExamFolder, before: Candidate, owner: Candidate, done: Message) -> _Change:
    """Somebody stands in the place of another, with the same paper."""
    line = _with_owner(exam.keys.line_of(before.student), owner)
    return _Change({before.student: owner}, {before.student: line}, done, {before: owner})


def _hand_over(exam: ExamFolder, before: Candidate, student: Student) -> Candidate:
    """A student in the place of another, whose ids files may still have. Raises ExamError."""
    others = tuple(each for each in exam.head.students if each != before)
    rest = ExamFolder(exam.path, structs.replace(exam.head, students=others))
    owner, new = make_owner(rest, before, student), make_student_key(student.student)
    former = (*before.formerly, before.student)
    kept = tuple(each for each in former if make_student_key(each) != new)
    return structs.replace(owner, formerly=kept)


def _list_before(exam: ExamFolder, changed: Mapping[str, Candidate]) -> Iterator[PaperBefore]:
    """The papers that students of the exam had who have others now."""
    for student, now in changed.items():
        before = exam.head.candidates.get(student)
        if before is not None and now.student == student:
            yield PaperBefore(student, before.paper, exam.head.corrections + 1)


def _find_paper(exam: ExamFolder, code: str) -> Candidate:
    """Whose paper has that code, or who has that id. Raises ExamError."""
    everybody = {each.student: each for each in exam.head.everybody}
    codes = {each.paper: each.student for each in exam.head.everybody if each.paper}
    found = StudentIds(exam.students, codes).exact(code)
    if found is None:
        what = Message("exam.no-such-paper", code=Quoted(code))
        raise _refuse(exam, what, suggest(code, codes))
    return everybody[found]


def _with_paper(owner: Candidate, other: Candidate) -> Candidate:
    """Somebody with the paper of another."""
    return structs.replace(
        owner, paper=other.paper, version=other.version, was_spare=other.was_spare
    )


def _with_owner(line: KeyLine, owner: Candidate) -> KeyLine:
    return structs.replace(line, student=owner.student)


def _explain_own(exam: ExamFolder, own: Candidate) -> ExamError:
    what = Message("exam.spare-taken", code=Quoted(own.paper), student=Quoted(own.student))
    return _refuse(exam, what, Message("exam.name-another-paper"))


def _refuse(exam: ExamFolder, what: Message, do: str | Message) -> ExamError:
    return ExamError(Fault(str(exam.head_file), what, do=do))
