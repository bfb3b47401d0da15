"""Exams whose papers are alike hard: shipped banks, one question, versions, late students."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from kinegrade.draws.deal import deal, look_here
from kinegrade.draws.deck import Combination
from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.exam.setting.difficulties import find_difficulty
from kinegrade.exam.setting.setting import Exam
from kinegrade.reports.predictions import find_predictions
from tests.small_class import kinegrade

BANKS = Path(__file__).parents[2] / "banks"
SECRET = FromWords("alike")
CLASS = 24  # students


def roster(count: int) -> Roster:
    return Roster(tuple(Student(f"s{each}", "", "", f"s{each}") for each in range(count)), ())


@cache
def bank(name: str) -> Bank:
    return read_bank(BANKS / f"{name}.toml")


def sums(exam: Exam, values: Mapping[str, list[Combination]]) -> np.ndarray:
    """What is predicted for each paper, in points."""
    return np.sum([find_difficulty(exam, name).predict(each) for name, each in values.items()], 0)


def naive(exam: Exam, count: int) -> np.ndarray:
    """What is predicted where place p gets the p-th good combination of every question."""
    deals = deal(exam.filters, count, partial(look_here, exam.filters))
    return sums(
        exam,
        {
            name: [exam.filters[name].deck.combination(at) for at in each.positions[:count]]
            for name, each in deals.items()
        },
    )


@cache
def deal_demo() -> ClassDeal:
    """The demonstration bank dealt to a class."""
    return deal_exam(bank("demo"), roster(CLASS), SECRET)


@cache
def spread_by_luck() -> float:
    """How much the papers of that class differ where place p gets the p-th good combination."""
    return float(naive(deal_demo().exam, CLASS).std())


def dealt(whole: ClassDeal) -> np.ndarray:
    return sums(whole.exam, {name: [*each.values()] for name, each in whole.values.items()})


def different(whole: ClassDeal) -> set[int]:
    """How many different combinations are dealt, of each question."""
    return {len({tuple(one.values()) for one in each.values()}) for each in whole.values.values()}


@pytest.mark.left(beside="test_versions_are_alike_and_their_students_have_the_same")
def test_papers_of_a_shipped_bank_differ_at_most_a_third_as_much() -> None:
    assert dealt(deal_demo()).std() <= spread_by_luck() / 3
    assert different(deal_demo()) == {CLASS}


def test_a_single_question_takes_what_is_near_the_middle() -> None:
    alone = replace(bank("demo"), questions=bank("demo").questions[:1])
    whole = deal_exam(alone, roster(40), SECRET)
    assert dealt(whole).std() <= naive(whole.exam, 40).std() / 4
    assert different(whole) == {40}


def test_versions_are_alike_and_their_students_have_the_same() -> None:
    whole = deal_exam(replace(bank("demo"), versions=4), roster(30), SECRET)
    assert {"".join(each) for each in whole.values.values()} == {"ABCD"}
    # Four papers have few sums to choose from: 0.037 against 0.123 points here
    assert dealt(whole).std() <= spread_by_luck() / 3


def write_roster(file: Path, students: range) -> Path:
    lines = ["student,name", *(f"s{each},N" for each in students)]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


def test_late_students_get_papers_like_those_of_the_others(tmp_path: Path) -> None:
    exam, early = tmp_path / "EXAM", write_roster(tmp_path / "roster.csv", range(12))
    words = ("--reproducible", "late", "--no-papers")
    first = kinegrade("generate", "demo", early, "-o", exam, *words)
    assert first.exit_code == 0, first.stderr
    before = find_predictions(open_exam(exam)).difficulties
    late = write_roster(tmp_path / "late.csv", range(12, 16))
    added = kinegrade("generate", "demo", early, "-o", exam, "--add", late)
    assert added.exit_code == 0, added.stderr
    after = find_predictions(open_exam(exam)).difficulties
    assert {student: after[student] for student in before} == before
    totals = {student: sum(each.values()) for student, each in after.items()}
    middle = np.mean([totals[student] for student in before])
    for student in set(after) - set(before):
        assert abs(totals[student] - middle) <= spread_by_luck() / 2


def test_what_is_predicted_of_a_folder_is_what_was_dealt(tmp_path: Path) -> None:
    exam, students = tmp_path / "EXAM", write_roster(tmp_path / "roster.csv", range(5))
    options = ("--reproducible", "alike", "--no-papers")
    assert kinegrade("generate", "demo", students, "-o", exam, *options).exit_code == 0
    found = find_predictions(open_exam(exam)).difficulties
    whole = deal_exam(bank("demo"), roster(5), SECRET)
    assert found.keys() == whole.places.keys()
    totals = {student: sum(each.values()) for student, each in found.items()}
    assert [totals[student] for student in whole.places] == pytest.approx([*dealt(whole)])
