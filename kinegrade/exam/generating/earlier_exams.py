"""`kinegrade generate --avoid`: what earlier exams dealt, so that nobody gets it again."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from pathlib import Path

from kinegrade.errors import DrawError
from kinegrade.exam.bank.blueprint import Earlier
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.language.message import Fault, Message


def read_earlier_exams(
    paths: Iterable[Path], kept: ExamHead | None, sheets: Iterable[Path] = ()
) -> Earlier:
    """By template the values that students of the exams in these folders had, each once, and what
    the exam with the head `kept`, which is replaced, keeps to already, as the other `sheets` of its
    series do.

    Raises ExamError where a folder is none, or is damaged.
    """
    found: dict[str, dict[tuple[tuple[str, str], ...], None]] = {}
    heads = (kept, *(open_exam(sheet).head for sheet in sheets))
    dealt = _list_dealt(map(open_exam, (*paths, *sheets)))
    for name, values in (*chain.from_iterable(map(_list_kept, heads)), *dealt):
        found.setdefault(name, {})[tuple(values.items())] = None
    return {name: tuple(map(dict, each)) for name, each in found.items()}


def _list_kept(kept: ExamHead | None) -> Iterator[tuple[str, Mapping[str, str]]]:
    for name, dealt in kept.earlier.items() if kept is not None else ():
        yield from ((name, values) for values in dealt)


def _list_dealt(exams: Iterable[ExamFolder]) -> Iterator[tuple[str, Mapping[str, str]]]:
    """What each student had of each question, by its template."""
    for exam in exams:
        templates = {each.question: each.template for each in exam.head.questions}
        for line in exam.keys.lines():
            yield from ((templates[each.question], each.values) for each in line.questions)


def require_enough(dealt: ClassDeal) -> None:
    """Raises DrawError for questions of which earlier exams leave too few combinations for
    everyone to have other numbers.
    """
    faults = [
        Fault(fault.where, fault.what, fault.expected, Message("exam.fewer-to-avoid"))
        for name, fault in dealt.find_shortages().items()
        if dealt.exam.filters[name].earlier.values
    ]
    if faults:
        raise DrawError(*faults)


def count_avoided(dealt: ClassDeal) -> Iterator[Message]:
    """For each question of which earlier exams dealt any combination how many, and how many are
    left.
    """
    for name, question in dealt.exam.filters.items():
        excluded = question.earlier.count(question.deck)
        if excluded:
            yield Message(
                "exam.avoided",
                question=name,
                template=question.template.name,
                count=excluded,
                left=question.deck.size - excluded,
            )


def list_repeated(dealt: ClassDeal) -> Iterator[Message]:
    """A line for each question of which papers that stay have numbers of earlier exams."""
    for name, question in dealt.exam.filters.items():
        whose = [each for each, had in dealt.values[name].items() if question.earlier.has(had)]
        if whose:
            yield Message("exam.stay-avoided", question=name, count=len(whose), first=whose[0])
