"""Papers put together from a pool: questions that a learning management system drew, each from some
student's line of the key.

`grade` makes a `Pool` where responses came from one, and records in the marks folder whose line
each answer was marked by; feedback, report and sharing read it there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.exact_keys import ListedKeys
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.exam.keyed_exam import Examinee, KeyedExam
from kinegrade.grading.sheets.entry import Entry
from kinegrade.grading.sheets.sheet import Sheet
from kinegrade.marks_folder.rows import Put


@dataclass(frozen=True)
class Pool:
    """The papers whose questions were put to others, by the student whose line of the key holds
    them.
    """

    papers: Mapping[str, Paper] = field(default_factory=dict)

    def paper(self, paper: Paper, entry: Entry) -> Paper:
        """The paper by which an entry is marked."""
        if not entry.put:
            return paper
        keys = [
            (self.papers[source] if source else paper).keys[number]
            for number, source in enumerate(entry.put)
        ]
        return Paper(paper.student, paper.name, ListedKeys(keys), entry.put)

    def put_together(self, exam: Sitting, sheet: Sheet) -> Iterator[Paper]:
        """All papers that were put together for the entries of a sheet."""
        if self.papers:
            for paper in exam.papers():
                for entry in sheet.entries[paper.student]:
                    if entry.put:
                        yield self.paper(paper, entry)


def read_pool(exam: ExamFolder, sheet: Sheet) -> Pool:
    """The papers that a sheet's entries are marked by, other than the students' own. Raises
    ExamError.
    """
    wanted = {
        source for entries in sheet.listed.values() for entry in entries for source in entry.put
    }
    return Pool(exam.papers_of(wanted - {""}))


def list_put_rows(asks: Iterable[Ask], paper: Paper) -> Iterator[tuple[str, str, str, str]]:
    """Whose line of the key each of a student's answers is marked by; nothing if the paper is the
    student's own.
    """
    if paper.put:
        for number, ask in enumerate(asks):
            yield paper.student, ask.question, ask.ask, paper.source(number)


def make_exam_as_put(folder: ExamFolder, exam: KeyedExam, put: Put) -> KeyedExam:
    """The exam with every student's keys as the questions were put. Raises ExamError."""
    if not put:
        return exam
    papers = folder.papers_of({source for each in put.values() for source in each.values()})
    numbers = {ask.column: number for number, ask in enumerate(exam.asks)}

    def examinee(before: Examinee) -> Examinee:
        keys = {
            column: papers[source].key(numbers[column])
            for column, source in put.get(before.student, {}).items()
            if column in numbers
        }
        return Examinee(before.student, before.name, {**before.keys, **keys})

    return KeyedExam(exam.asks, tuple(map(examinee, exam.examinees)))
