"""Papers put together from a pool: questions that a learning management system drew, each from
somebody's line of the key.

`grade` makes a `Pool` where responses came from one, and writes whose line every answer was marked
by into the marks folder; feedback, report and sharing read it there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.keys import Ask, Exam, Examinee, Paper, Sitting
from kinegrade.grading.sheet import Entry, Sheet
from kinegrade.marks_folder.rows import Put


@dataclass(frozen=True)
class Pool:
    """The papers whose questions were put to others, by the student on whose line of the key they
    stand.
    """

    papers: Mapping[str, Paper] = field(default_factory=dict)

    def paper(self, own: Paper, entry: Entry) -> Paper:
        """The paper by which an entry is marked."""
        if not entry.put:
            return own
        keys = [
            (self.papers[source] if source else own).keys[number]
            for number, source in enumerate(entry.put)
        ]
        return Paper(own.student, own.name, keys, entry.put)

    def put_together(self, exam: Sitting, sheet: Sheet) -> Iterator[Paper]:
        """All papers that were put together for the entries of a sheet."""
        if self.papers:
            for own in exam.papers():
                for entry in sheet.entries[own.student]:
                    if entry.put:
                        yield self.paper(own, entry)


def pool_of(exam: ExamFolder, sheet: Sheet) -> Pool:
    """The papers that a sheet's entries are marked by beside everybody's own. Raises ExamError."""
    wanted = {
        source for entries in sheet.entries.values() for entry in entries for source in entry.put
    }
    return Pool(exam.papers_of(wanted - {""}))


def put_rows(asks: Iterable[Ask], paper: Paper) -> Iterator[tuple[str, str, str, str]]:
    """Whose line of the key each of a student's answers is marked by; nothing for the student's
    paper.
    """
    if paper.put:
        for number, ask in enumerate(asks):
            yield paper.student, ask.question, ask.ask, paper.source(number)


def exam_as_put(folder: ExamFolder, exam: Exam, put: Put) -> Exam:
    """The exam with everybody's keys as the questions were put. Raises ExamError."""
    if not put:
        return exam
    papers = folder.papers_of({source for each in put.values() for source in each.values()})
    numbers = {ask.column: number for number, ask in enumerate(exam.asks)}

    def examinee(own: Examinee) -> Examinee:
        keys = {
            column: papers[source].key(numbers[column])
            for column, source in put.get(own.student, {}).items()
            if column in numbers
        }
        return Examinee(own.student, own.name, {**own.keys, **keys})

    return Exam(exam.asks, tuple(map(examinee, exam.examinees)))
