"""From a bank to a practice sheet: so many draws of every question, each solved and proved as those
of an exam are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from msgspec.structs import replace

from kinegrade.exam.bank.blueprint import Bank, Blueprint
from kinegrade.exam.bank.texts import require_bank_language
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.exam.setting.key_mistakes import find_mistaken_answers
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.language.prose.html import write_page_line
from kinegrade.practice.document import PracticeSheet
from kinegrade.practice.drawn import DrawnQuestion
from kinegrade.practice.questions import make_question
from kinegrade.press.sheet import Paper
from kinegrade.students.mistaking.mistake_names import describe_all_mistakes


@dataclass(frozen=True)
class MadeSheet:
    """A sheet, and what is to be said of it: questions that it lacks or has in fewer draws."""

    sheet: PracticeSheet
    notes: tuple[Message, ...]


def make_practice_sheet(
    blueprint: Blueprint, draws: int, seed: str, language: Language
) -> MadeSheet:
    """The sheet of a bank with so many draws of every question, fewer where there are fewer good
    ones. Raises BankError, DrawError, TypesetError.
    """
    bank = _open_bank(blueprint, seed)
    require_bank_language(bank, language)
    dealt = _deal(bank, draws, seed)
    papers = list(dealt.papers())
    laid_out = [lay_out_paper(bank, paper, language) for paper in papers]
    drawn = [_select_different(each) for each in _sort_by_question(papers, laid_out)]
    questions = [make_question(each, bank.credit.mistakes, language) for each in drawn]
    templates = [question.template for question in bank.questions]
    named = {
        label.partition(".")[0] for each in questions for ask in each.asks for label in ask.mistakes
    }
    sentences = describe_all_mistakes(templates, language)
    first = laid_out[0]
    sheet = PracticeSheet(
        first.title,
        first.course,
        tuple(write_page_line(rule, Message("practice.rules")) for rule in first.rules),
        {name: text for name, text in sentences.items() if name in named},
        tuple(questions),
    )
    return MadeSheet(sheet, tuple(_list_notes(blueprint, dealt, drawn, draws)))


def _open_bank(blueprint: Blueprint, seed: str) -> Bank:
    """The bank without what concerns papers alone: versions, orders, alternatives, questions that
    people mark; every question with numbers of its own.
    """
    bank = blueprint.bank(FromWords(seed).drawing)
    questions = tuple(replace(each, dealing="own") for each in bank.questions)
    return replace(bank, questions=questions, versions=0, shuffle=False, choices=(), by_hand=())


def _deal(bank: Bank, draws: int, seed: str) -> ClassDeal:
    names = [f"draw-{number}" for number in range(1, draws + 1)]
    roster = Roster(tuple(Student(name, "", "", name) for name in names), ())
    return deal_exam(bank, roster, FromWords(seed))


def _sort_by_question(
    papers: Sequence[SetPaper], laid_out: Sequence[Paper]
) -> Iterator[list[DrawnQuestion]]:
    """For each question what the papers have of it."""
    mistaken = list(find_mistaken_answers(papers))
    for place, question in enumerate(papers[0].questions):
        name = question.question.identifier
        yield [
            DrawnQuestion(paper.questions[place], sheet.questions[place], known[name])
            for paper, sheet, known in zip(papers, laid_out, mistaken, strict=True)
        ]


def _select_different(drawn: Sequence[DrawnQuestion]) -> list[DrawnQuestion]:
    """Those with different numbers."""
    found = {tuple(each.question.drawn.values.items()): each for each in reversed(drawn)}
    return list(reversed(found.values()))


def _list_notes(
    blueprint: Blueprint, dealt: ClassDeal, drawn: Sequence[Sequence[DrawnQuestion]], draws: int
) -> Iterator[Message]:
    """Questions that people mark, which are left out, and those with fewer draws."""
    left_out = len(blueprint.frame.by_hand)
    if left_out:
        yield Message("practice.by-hand", count=left_out)
    for question, each in zip(dealt.bank.questions, drawn, strict=True):
        if len(each) < draws:
            yield _tell_fewer(question.identifier, len(each), dealt)


def _tell_fewer(question: str, count: int, dealt: ClassDeal) -> Message:
    looked, advice = dealt.deals[question], dealt.advise(question)
    return Message(
        "practice.fewer", question=question, count=count, among=looked.looked_at(), advice=advice
    )
