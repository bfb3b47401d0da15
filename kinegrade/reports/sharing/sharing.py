"""Answers that fit another student's paper and not the student's own, with the number expected by
chance.

`find_sharing` is called only by `kinegrade sharing`: it is off unless an instructor asks for it.
The result is a hint where to look, never a verdict.

What counts is wrong answers that no known mistake explains. Such an answer fits another paper if it
would be right there, or is what a known mistake leads to there. By chance it fits one paper as
often as it fits the other papers of the class. So the share of papers that it fits, added up over a
student's wrong answers, is the number expected to fit any one paper. A pair is reported if the
Poisson distribution with that mean makes so many fits rarer than the level, for the whole class:
times the number of pairs, and times two, because two counts are made, of right answers and of right
answers or mistakes.

Answers to one question depend on each other: a misread number gives all the answers of a paper that
has that number. So a pair is reported only if answers to at least two questions fit.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.grading.same_key import require_same_key
from kinegrade.grading.sheets.pool import make_exam_as_put
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.reports.sharing.class_keys import read_class_keys
from kinegrade.reports.sharing.search import Pair, Search
from kinegrade.reports.sharing.wrong_answers import find_wrong_answers

_LEVEL = 0.01
MOST = 1000  # pairs reported; the most striking ones


@dataclass(frozen=True)
class Sharing:
    """The pairs worth a look, the most striking first: at most MOST of `found`, out of `pairs` in
    all.

    `papers` is the number of different papers that the `students` had, `questions` the number of
    questions they were asked.
    """

    pairs: int
    found: int
    reported: tuple[Pair, ...]
    students: int
    papers: int
    questions: int
    level: float


def find_sharing(exam: ExamFolder, marks: MarksFolder, level: float = _LEVEL) -> Sharing:
    """Searches a marks folder, with its exam folder; questions from a pool count as they were
    put.

    Raises ExamError, TableError.
    """
    require_same_key(exam, marks)
    known = make_exam_as_put(exam, read_whole(exam), marks.put) if marks.put else exam
    here = (each for each in marks.answers() if each.student not in marks.elsewhere)
    return find_pairs(known, here, level)


def find_pairs(exam: Sitting, answers: Iterable[MarkedAnswer], level: float = _LEVEL) -> Sharing:
    """The pairs of a class whose chance is below `level`. Raises ExamError where an answer does not
    belong to the exam, or the papers cannot be read.
    """
    wrong, keys = find_wrong_answers(exam, answers), read_class_keys(exam)
    search = Search(keys, wrong, level)
    found = sorted(search.found(), key=lambda each: (each.chance, each.student, each.other))
    reported = tuple(search.pair(each) for each in found[:MOST])
    return Sharing(
        search.pairs,
        len(found),
        reported,
        search.students,
        len({*keys.papers}),
        len(search.questions),
        level,
    )
