"""Questions that stand under one number in markings of several exams, and are not the same."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from kinegrade.grading.exams_beside import list_exams_of
from kinegrade.language.message import Fault, Message, list_all
from kinegrade.marks_folder.cells import read_records_if_any
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import ANSWERS, MERGED


def find_unlike_questions(folders: Sequence[MarksFolder]) -> Iterator[Fault]:
    """A complaint for each folder with questions that ask something else than those of the same
    number in the first, or are of another template, where exams stand beside the marks.
    """
    first, *others = folders
    asked, templates = _list_asks(first), _list_templates(first)
    for folder in others:
        here, own = _list_asks(folder), _list_templates(folder)
        unlike = [
            question
            for question in here.keys() & asked.keys()
            if here[question] != asked[question]
            or own.get(question, "") != templates.get(question, own.get(question, ""))
        ]
        if unlike:
            what = Message(
                "marks.other-questions",
                count=len(unlike),
                questions=list_all(sorted(unlike)),
                first=str(first.path),
            )
            yield Fault(str(folder.path), what, do=Message("marks.whose-column", file=MERGED.name))


def _list_asks(folder: MarksFolder) -> Mapping[str, set[str]]:
    """What is asked in each question of marks.csv."""
    found: dict[str, set[str]] = defaultdict(set)
    question, ask = (ANSWERS.columns.index(name) for name in ("question", "ask"))
    for _, cells in read_records_if_any(folder.path, ANSWERS):
        found[cells[question]].add(cells[ask])
    return found


def _list_templates(folder: MarksFolder) -> Mapping[str, str]:
    """The template of each question, where the exam of these marks stands beside them."""
    exam = next(list_exams_of(folder), None)
    return {each.question: each.template for each in exam.head.questions} if exam else {}
