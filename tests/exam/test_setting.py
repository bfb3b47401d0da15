"""Setting: what each student gets, and how far from the right answer is still right."""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest
from msgspec.structs import replace

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.paper_codes import make_paper_code
from kinegrade.exam.setting.setting import SetPaper
from tests.small_class import BANK, write_class


@pytest.fixture
def bank(tmp_path: Path) -> Bank:
    return read_bank(write_class(tmp_path) / "bank.toml")


def roster(count: int) -> Roster:
    return Roster(tuple(Student(str(number), "", "", str(number)) for number in range(count)), ())


def papers(bank: Bank, count: int, secret: str = "spring") -> list[SetPaper]:
    return list(deal_exam(bank, roster(count), FromWords(secret)).papers())


def drawn(paper: SetPaper) -> list[object]:
    return [question.drawn.values for question in paper.questions]


def test_a_question_more_leaves_the_codes_of_the_papers_as_they_are(
    bank: Bank, tmp_path: Path
) -> None:
    before = papers(bank, 4)
    (tmp_path / "bank.toml").write_text(
        BANK + '[[questions]]\ntemplate = "slider-crank"\n', encoding="utf-8"
    )
    longer = papers(read_bank(tmp_path / "bank.toml"), 4)
    assert [paper for paper in longer if drawn(paper)[3] == drawn(paper)[0]] == []
    assert [paper.code for paper in longer] == [paper.code for paper in before]


def test_papers_differ_in_every_question(bank: Bank) -> None:
    for first, second in pairwise(papers(bank, 6)):
        assert [
            (one, other)
            for one, other in zip(drawn(first), drawn(second), strict=True)
            if one == other
        ] == []


def test_only_the_banks_domains_are_drawn(bank: Bank) -> None:
    for paper in papers(bank, 9):
        values = paper.questions[1].drawn.values
        assert (values["h"], values["r"] in "123", values["omega"] in "234") == ("0", True, True)


def test_a_zero_answer_has_room_for_what_a_calculator_leaves_of_it(bank: Bank) -> None:
    for paper in papers(bank, 4):
        values, (v_x, v_y) = paper.questions[1].drawn.values, paper.questions[1].asks
        fastest = int(values["r"]) * int(values["omega"])
        assert v_x.answer.is_zero
        assert v_x.tolerance.absolute == Fraction(fastest, 10**10)
        assert (v_y.tolerance.relative, v_y.tolerance.absolute) == (0, Fraction(1, 4))


def test_an_absolute_tolerance_of_the_bank_stands_where_it_is_the_wider(bank: Bank) -> None:
    question = bank.questions[1]
    wide = replace(
        question.asks[0], tolerance=replace(question.asks[0].tolerance, absolute=Fraction(3))
    )
    changed = replace(bank, questions=(replace(question, identifier="q2", asks=(wide,)),))
    assert papers(changed, 1)[0].questions[0].asks[0].tolerance.absolute == 3


def test_paper_codes_depend_on_secret_and_student_alone() -> None:
    assert (
        make_paper_code("spring", "007") == "WJPK-SNPQ"
    )  # printed on papers: to be the same for ever
    codes = {
        make_paper_code(secret, str(number))
        for secret in ("spring", "autumn")
        for number in range(500)
    }
    assert len(codes) == 1000
    assert [
        code
        for code in codes
        if not re.fullmatch("[0-9A-HJKMNP-TV-Z]{4}-[0-9A-HJKMNP-TV-Z]{4}", code)
    ] == []
