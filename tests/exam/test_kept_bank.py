"""The bank of an exam from the copies that its folder keeps: the same questions, points and
tolerances as when it was set.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from kinegrade.errors import BankError
from kinegrade.exam.bank.bank import read_bank, read_blueprint, read_kept_bank
from kinegrade.exam.bank.blueprint import Bank, BankQuestion
from tests.exam.folder_of_cranks import write_shelf
from tests.problem.crank import crank_text

TEXT = """title = "Midterm"
course = "Mechanics"
tolerance = { figures = 3 }

[[questions]]
family = "crank"
number = 2
without = ["crank-2"]
points = 10

[[questions]]
template = "mine.toml"
draw = { r = [1, 2] }
asks = { v_x = { points = 2, tolerance = { absolute = 0.25 } } }
"""


@pytest.fixture
def bank(tmp_path: Path) -> Bank:
    """A bank that draws from a shelf and has a template beside it."""
    shelf = write_shelf(tmp_path / "shelf")
    (tmp_path / "bank.toml").write_text(TEXT, encoding="utf-8")
    (tmp_path / "mine.toml").write_text(crank_text(), encoding="utf-8")
    return read_blueprint(tmp_path / "bank.toml", shelf).bank("spring")


def kept(folder: Path, bank: Bank) -> Bank:
    """The bank read again from copies as an exam folder has them."""
    (folder / "EXAM" / "templates").mkdir(parents=True)
    for question in bank.questions:
        file = folder / "EXAM" / "templates" / f"{question.template.name}.toml"
        file.write_text(question.template.file.text, encoding="utf-8")
    (folder / "EXAM" / "bank.toml").write_text(bank.text, encoding="utf-8")
    return read_again(folder, bank)


def read_again(folder: Path, bank: Bank) -> Bank:
    chosen = {question.identifier: question.template.name for question in bank.questions}
    return read_kept_bank(folder / "EXAM" / "bank.toml", folder / "EXAM" / "templates", chosen)


def said(question: BankQuestion) -> tuple[object, ...]:
    return question.identifier, question.template.file.text, question.asks, question.domains


def test_the_bank_is_read_from_its_copies_whatever_was_drawn(tmp_path: Path, bank: Bank) -> None:
    found = kept(tmp_path, bank)
    assert list(map(said, found.questions)) == list(map(said, bank.questions))
    assert replace(found, questions=()) == replace(bank, questions=())


def test_the_bank_of_a_generated_exam_is_read_from_its_folder(small_class: Path) -> None:
    bank = read_bank(small_class / "bank.toml")
    exam = small_class / "EXAM"
    chosen = {question.identifier: question.template.name for question in bank.questions}
    found = read_kept_bank(exam / "bank.toml", exam / "templates", chosen)
    assert list(map(said, found.questions)) == list(map(said, bank.questions))


def test_a_bank_with_other_questions_than_the_exam_is_refused(tmp_path: Path, bank: Bank) -> None:
    kept(tmp_path, bank)
    text = bank.text.replace("mine.toml", "crank-1.toml")
    (tmp_path / "EXAM" / "bank.toml").write_text(text, encoding="utf-8")
    with pytest.raises(
        BankError,
        match=r"bank.toml: the questions differ from those of exam.json - expected q1, q2, q3 with "
        r"the same templates - restore the exam folder as it was generated",
    ):
        read_again(tmp_path, bank)


def test_a_bank_whose_template_is_gone_is_refused(tmp_path: Path, bank: Bank) -> None:
    kept(tmp_path, bank)
    (tmp_path / "EXAM" / "templates" / "mine.toml").unlink()
    with pytest.raises(BankError, match=r'questions\[2\].template: no template "mine"'):
        read_again(tmp_path, bank)
