"""A paper is printed the same, whoever else is printed with it: alone, in another order, among
names in other scripts.
"""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from kinegrade.exam.bank.bank import Bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.printing import Extras, PressOrder, Printed, PrintRun, print_papers
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.language import Language
from kinegrade.press.protocol import Engine
from tests.exam.engines import pair_with_engines

NAMES = ("Zoë", "Ann Lee", "王伟", "O'Neil")
CLASS = Roster(tuple(Student(name, name, "", str(at)) for at, name in enumerate(NAMES)), ())


@pytest.fixture
def papers(golden_bank: Bank) -> tuple[Bank, list[SetPaper]]:
    """A bank whose questions each student has in another order, and the papers of a class."""
    [question] = golden_bank.questions
    questions = question, replace(question, identifier="q2"), replace(question, identifier="q3")
    bank = replace(golden_bank, questions=questions, shuffle=True)
    return bank, list(deal_exam(bank, CLASS, FromWords("printing")).papers())


@pytest.mark.sampled(6, by="language")  # each engine, and each language
@pytest.mark.parametrize(("language", "engine"), pair_with_engines("en", "zh"))
def test_a_paper_printed_alone_is_the_same_as_among_others(
    papers: tuple[Bank, list[SetPaper]], engine: Engine, language: Language
) -> None:
    bank, class_papers = papers
    order = PressOrder(engine, "a4")
    run = PrintRun(bank, language, order, Extras(solutions=True))

    def printed(chosen: list[SetPaper]) -> list[Printed]:
        return print_papers(run, order.press(), chosen)

    together = printed(class_papers)
    assert len({paper.paper.pdf for paper in together}) == len(NAMES)
    assert [paper for paper in together if not paper.solution] == []
    assert printed(class_papers[::-1]) == together[::-1]
    assert [alone for paper in class_papers[::2] for alone in printed([paper])] == together[::2]
