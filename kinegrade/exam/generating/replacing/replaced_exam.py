"""What stands in an exam folder that `generate --force` replaces, so that nothing in it is lost in
silence.

Its papers may be printed already: they are compared with the new ones, student by student. Worked
solutions, the key lines of a pool, answers typed into the sheet and edited sources are kept, or the
replacement is refused.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from msgspec import structs

from kinegrade.errors import ExamError, TableError
from kinegrade.exam.folder.contents import ANSWERS, HEAD, POOL, SOLUTIONS
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.exam_secret import ExamSecret
from kinegrade.exam.folder.faults import AS_GENERATED
from kinegrade.exam.folder.head import read_head
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.generating.hand_work import is_answered, refuse_edited, require_nothing_edited
from kinegrade.exam.generating.options import GenerateOptions
from kinegrade.exam.generating.replacing.paper_changes import PaperChanges, list_otherwise
from kinegrade.exam.generating.replacing.paper_digests import paper_digests
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import read_place
from kinegrade.exam.roster.taken_ids import list_former_owners
from kinegrade.files.placing.copying import copy_tree
from kinegrade.language.message import Fault, Message, Quoted

_UNKNOWN = Message("exam.unknown-before")
_MOST_PLACES = 100  # for each student; beyond the class are only those of students who left


@dataclass(frozen=True)
class ReplacedExam:
    """An exam folder that is about to be replaced; `papers` holds a digest of each student's key,
    `kept` the key itself.

    `head` and `secret` are None where the folder is damaged, so that its papers are not known.
    """

    folder: Path
    head: ExamHead | None
    secret: ExamSecret | None
    papers: Mapping[str, bytes]
    kept: Mapping[str, KeyLine]

    @property
    def spares(self) -> tuple[str, ...]:
        """The spare papers by their names: they may be printed, and so they stay."""
        return tuple(each.student for each in self.head.spares) if self.head else ()

    def changes(self, new: Path) -> PaperChanges:
        """How the papers differ from those of the folder `new`. Raises ExamError."""
        head = read_head(new)
        papers = paper_digests(ExamFolder(new, head))
        common = [student for student in self.papers if student in papers]
        stated = list_otherwise(self.folder, self.head, new, head) if self.head else ()
        return PaperChanges(
            tuple(student for student in common if self.papers[student] == papers[student]),
            tuple(student for student in common if self.papers[student] != papers[student]),
            tuple(student for student in self.papers if student not in papers),
            tuple(student for student in papers if student not in self.papers),
            tuple(stated),
        )


def replaced_exam(folder: Path, *, new_numbers: bool) -> ReplacedExam | None:
    """The exam that a folder holds, None where there is none.

    Raises ExamError where it is damaged, unless its papers are to be replaced by `new_numbers`;
    OutputError where answers were typed into it, for that is seen before any work is done.
    """
    if not (folder / HEAD).exists():
        return None
    if is_answered(folder / ANSWERS):
        raise refuse_edited(folder, [ANSWERS])
    try:
        return read_replaced(open_exam(folder))
    except ExamError as error:
        if new_numbers:
            return ReplacedExam(folder, None, None, {}, {})
        faults = (Message("exam.or-replace", problem=each) for each in error.faults)
        raise ExamError(*faults) from error


def require_own_ids(old: ReplacedExam | None, roster: Roster) -> None:
    """Raises TableError where a student has an id that another of the roster had before."""
    if old is None or old.head is None:
        return
    students = {each.student for each in roster.students}
    former = {before: owner for before, owner in old.head.former_ids.items() if owner in students}
    faults = [
        fault
        for each in roster.students
        for fault in list_former_owners(former, each.student, f"{roster.file}:{each.line}")
    ]
    if faults:
        raise TableError(*faults)


def remember(old: ReplacedExam | None, head: ExamHead) -> ExamHead:
    """A new head with what marks that were given before are known by: corrections of the key,
    exchanges of papers, and the ids that students had.
    """
    if old is None or old.head is None:
        return head
    former = {each.student: each.formerly for each in old.head.students}
    students = (
        structs.replace(each, formerly=former.get(each.student, ())) for each in head.students
    )
    known = {"corrections": old.head.corrections, "papers_before": old.head.papers_before}
    return structs.replace(head, students=tuple(students), **known)


def read_replaced(exam: ExamFolder) -> ReplacedExam:
    """The exam of which everything is known that a replacement may change. Raises ExamError."""
    secret = required_secret(exam)
    exam.require_sound_key()
    papers = paper_digests(exam)
    kept = {line.student: line for line in (*exam.keys.lines(), *exam.keys.spare_lines())}
    _require_places(exam, kept)
    return ReplacedExam(exam.path, exam.head, secret, papers, kept)


def required_secret(exam: ExamFolder) -> ExamSecret:
    """What the numbers of an exam are drawn from. Raises ExamError where its folder does not say
    it.
    """
    secret = exam.head.drawn_from
    if secret is None:
        what, do = Message("exam.no-secret"), Message("exam.restore-folder")
        raise ExamError(Fault(str(exam.path / HEAD), what, AS_GENERATED, do))
    return secret


def _require_places(exam: ExamFolder, kept: Mapping[str, KeyLine]) -> None:
    """Raises ExamError where papers state places that were not dealt to this class, each once."""
    whose: dict[int, str] = {}
    for student, line in kept.items():
        if line.place is None:
            continue
        first = whose.setdefault(line.place, student)
        if first != student or not 0 <= line.place < _MOST_PLACES * len(kept):
            what = Message("exam.strange-place", student=Quoted(student), place=line.place)
            raise ExamError(Fault(str(exam.keys.file), what))


def settle(
    old: ReplacedExam | None, folder: Path, options: GenerateOptions
) -> tuple[PaperChanges | None, tuple[Message, ...]]:
    """Keep in the new exam at `folder` what belongs to papers that stay; give the changes, and
    remarks on the rest; no changes where the old exam cannot be read.

    Raises OutputError where something would be lost or changed that the `options` do not allow to;
    ExamError.
    """
    if old is None:
        return None, ()
    require_nothing_edited(old.folder, old.head, folder)
    printed = () if options.solutions else (SOLUTIONS, f"{SOLUTIONS}.pdf")
    if old.secret is None:
        return None, (_UNKNOWN, *_dropped((*printed, POOL), old.folder))
    changes = old.changes(folder)
    if not options.new_numbers:
        changes.require_numbers_kept(old.folder, _list_uncorrected(old, folder))
    if not changes.harmless:
        return changes, tuple(_dropped((*printed, POOL), old.folder))
    if not (options.new_numbers or options.accept_changes):
        changes.require_rest_kept(old.folder)
    if changes.otherwise:
        dropped = _dropped(printed, old.folder)
        return changes, (*changes.remarks(), *dropped, *_keep((POOL,), old.folder, folder))
    remarks = tuple(_keep((*printed, POOL), old.folder, folder))
    if not options.solutions:
        _move_solutions(old, folder)
    return changes, remarks


def _list_uncorrected(old: ReplacedExam, new: Path) -> list[str]:
    """The sources of the new exam that are as the old one had them before they were corrected."""
    given = old.head.given if old.head else {}
    there = ((name, new / name, digest) for name, digest in given.items())
    return [
        name
        for name, file, digest in there
        if file.is_file() and sha256(file.read_bytes()).hexdigest() == digest
    ]


def _keep(names: Iterable[str], old: Path, new: Path) -> Iterator[Message]:
    """Copy into the folder `new` what belongs to papers that stay, and say so."""
    for name in names:
        source = old / name
        if source.is_dir():
            copy_tree(source, new / name)
        elif source.is_file():
            shutil.copy2(source, new / name)
        else:
            continue
        if name == POOL:
            yield Message("exam.pool-stays", name=name)
        else:
            yield Message("exam.solutions-stay", name=name)


def _move_solutions(old: ReplacedExam, new: Path) -> None:
    """Put worked solutions that were kept to where the new exam has their papers."""
    everybody = old.head.everybody if old.head else ()
    before = {each.student: read_place(each.file) for each in everybody}
    for each in read_head(new).everybody:
        place = read_place(each.file)
        kept = new / SOLUTIONS / f"{before.get(each.student, place)}.pdf"
        target = new / SOLUTIONS / f"{place}.pdf"
        if kept != target and kept.is_file():
            target.parent.mkdir(exist_ok=True)
            kept.rename(target)


def _dropped(names: Iterable[str], old: Path) -> Iterator[Message]:
    """What belonged to papers that are replaced and goes with them, said."""
    for name in names:
        if (old / name).exists():
            yield Message("exam.dropped", name=name)
