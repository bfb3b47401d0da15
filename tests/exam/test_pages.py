"""What stands on a paper and in the key: the student's own numbers, the answers in the key
alone.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.key_pages import make_key_book, make_key_paper, write_interval
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.printing.sample import make_sample_bank
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.language import ENGLISH
from kinegrade.press.typst.key import write_key_source
from kinegrade.press.typst.paper import write_paper_source
from kinegrade.problem.template.library.library import load_template
from tests.small_class import write_class

CLASS = Roster((Student("007", "王伟", "", "007"), Student("0012", "Zoë", "", "0012")), ())


@pytest.fixture(scope="module")
def bank(tmp_path_factory: pytest.TempPathFactory) -> Bank:
    folder: Path = tmp_path_factory.mktemp("bank")
    return read_bank(write_class(folder) / "bank.toml")


@pytest.fixture(scope="module")
def papers(bank: Bank) -> list[SetPaper]:
    return list(deal_exam(bank, CLASS, FromWords("spring")).papers())


def test_a_paper_holds_its_students_numbers(bank: Bank, papers: list[SetPaper]) -> None:
    for paper in papers:
        sheet = lay_out_paper(bank, paper, "en").questions[0]
        for quantity in paper.questions[0].drawn.solution.parameters.values():
            assert quantity.size.given_text in sheet.statement
        rows = [(row.symbol, row.unit, row.points) for row in sheet.rows]
        assert rows == [("v_{B}", "m/s", 3), ("a_{B}", "m/s^2", 2.5)]
        assert sheet.figure is not None
        assert sheet.source == ""  # where a problem was published is for the instructor


@pytest.mark.parametrize(("asked", "given"), [("omega_AB", False), ("alpha_AB", True)])
def test_a_paper_gives_no_acceleration_where_none_is_asked_for(asked: str, given: bool) -> None:
    bank = make_sample_bank(load_template("bar-through-swivelling-sleeve"))
    (question,) = bank.questions
    asks = tuple(ask for ask in question.asks if ask.name == asked)
    smaller = replace(bank, questions=(replace(question, asks=asks),))
    (paper, *_) = deal_exam(smaller, CLASS, FromWords("spring")).papers()
    (sheet,) = lay_out_paper(smaller, paper, "en").questions
    assert ("acceleration" in sheet.statement) is given


@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_paper_gives_an_answer_away(bank: Bank, papers: list[SetPaper], language: str) -> None:
    for paper in papers:
        source = write_paper_source(lay_out_paper(bank, paper, language))  # type: ignore[arg-type]
        answers = [ask.answer for question in paper.questions for ask in question.asks]
        digits = [answer.decimal(5).lstrip("-") for answer in answers]
        telling = [text for text in digits if len(text) > 5]
        assert telling
        assert not [text for text in telling if text in source]
        surds = [answer.latex for answer in answers if answer.latex and "sqrt" in answer.latex]
        assert not [latex for latex in surds if latex in source]
        assert "spring" not in source


def test_the_key_holds_every_answer_and_warns(bank: Bank, papers: list[SetPaper]) -> None:
    book = make_key_book(bank, [make_key_paper(bank, paper, "en") for paper in papers], "en")
    assert book.warning == "For the instructor only: this key shows every answer."
    source = write_key_source(book)
    for paper in papers:
        assert paper.code in source
        for question in paper.questions:
            for ask in question.asks:
                assert ask.answer.decimal(6).replace("-", "\u2212") in source


def test_both_languages_carry_the_same_paper(bank: Bank, papers: list[SetPaper]) -> None:
    english, chinese = (lay_out_paper(bank, papers[0], language) for language in ("en", "zh"))  # type: ignore[arg-type]
    assert (english.title, chinese.title) == ("Midterm", "期中测验")
    assert english.code == chinese.code
    assert english.points == chinese.points == sum(question.points for question in bank.questions)
    for one, other in zip(english.questions, chinese.questions, strict=True):
        assert one.figure == other.figure
        assert [row.symbol for row in one.rows] == [row.symbol for row in other.rows]
        assert one.statement != other.statement


def test_the_interval_of_right_answers_is_the_printed_rule(papers: list[SetPaper]) -> None:
    for paper in papers:
        (v_B, _), (v_x, v_y), _ = (question.asks for question in paper.questions)
        low, high = map(float, write_interval(v_B, ENGLISH).strip("[]").split(", "))
        assert [low, high] == pytest.approx(
            [v_B.answer.value * 0.99, v_B.answer.value * 1.01], 1e-5
        )
        low, high = map(float, write_interval(v_x, ENGLISH).strip("[]").split(", "))
        assert low == -high == -float(v_x.tolerance.absolute)
        low, high = map(float, write_interval(v_y, ENGLISH).strip("[]").split(", "))
        assert high - low == 0.5
