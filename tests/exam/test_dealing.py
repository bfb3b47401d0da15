"""A class is dealt to by place: no order of the roster, no other student decides what a paper is."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result
from msgspec.structs import replace

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.exam.setting.key_record import make_key_line
from kinegrade.exam.setting.setting import set_paper, set_papers
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.processes.executor import Start, open_executor
from tests.problem.crank import crank_text
from tests.small_class import key_lines, kinegrade, write_class

BANK = """title = "T"
course = "C"
{options}
[[questions]]
template = "slider-crank"
[[questions]]
template = "crank.toml"
draw = {{ h = [1], r = "1 .. 5 step 1", omega = "1 .. 4 step 1" }}
"""
CLASS = [f"s{number}" for number in range(7)]


@pytest.fixture
def bank(tmp_path: Path) -> Bank:
    return read_bank(write_class(tmp_path) / "bank.toml")


def roster(*students: str) -> Roster:
    return Roster(tuple(Student(each, "", "", each) for each in students), ())


def write(folder: Path, students: list[str], options: str = "") -> None:
    (folder / "bank.toml").write_text(BANK.format(options=options), encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    with (folder / "roster.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([["student", "name"], *([each, "N"] for each in students)])


def generate(folder: Path, name: str, *options: str) -> Result:
    """What `generate` says; papers are printed from the key and would only take their time."""
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / name, "--no-papers", *options)


def papers(folder: Path) -> dict[str, dict[str, Any]]:
    """All that papers are printed from: the lines of the key, by student."""
    return {each["student"]: each for each in key_lines(folder)}


@pytest.mark.parametrize("options", ["", "shuffle = true", "versions = 3"])
def test_sorting_the_roster_changes_nobodys_paper(tmp_path: Path, options: str) -> None:
    write(tmp_path, CLASS, options)
    assert generate(tmp_path, "ONE", "--reproducible", "spring").exit_code == 0
    write(tmp_path, [*CLASS[3:], *reversed(CLASS[:3])], options)
    assert generate(tmp_path, "TWO", "--reproducible", "spring").exit_code == 0
    assert papers(tmp_path / "ONE") == papers(tmp_path / "TWO")
    head = json.loads((tmp_path / "TWO" / "exam.json").read_text(encoding="utf-8"))
    assert [each["student"] for each in head["students"]] == [*CLASS[3:], "s2", "s1", "s0"]


@pytest.mark.parametrize("options", ["", "shuffle = true", "versions = 3"])
def test_late_students_change_nobodys_paper_wherever_they_stand(
    tmp_path: Path, options: str
) -> None:
    write(tmp_path, CLASS, options)
    assert generate(tmp_path, "EXAM").exit_code == 0
    before = papers(tmp_path / "EXAM")
    write(tmp_path, ["late1", *CLASS, "late2"], options)
    result = generate(tmp_path, "EXAM", "--force")
    assert result.exit_code == 0, result.stderr
    assert "EXAM: 7 papers keep their numbers, 0 changed, 0 gone, 2 new" in result.stderr
    after = papers(tmp_path / "EXAM")
    assert {name: after[name] for name in before} == before
    late = {each["place"] for each in key_lines(tmp_path / "EXAM") if "late" in each["student"]}
    assert late == {7, 8}


def test_a_class_that_grew_has_no_two_papers_alike(tmp_path: Path) -> None:
    write(tmp_path, CLASS)
    assert generate(tmp_path, "EXAM").exit_code == 0
    write(tmp_path, [*CLASS, *(f"late{number}" for number in range(13))])
    assert generate(tmp_path, "EXAM", "--force").exit_code == 0
    lines = key_lines(tmp_path / "EXAM")
    for question in (0, 1):
        drawn = {json.dumps(line["questions"][question]["drawn"]) for line in lines}
        assert len(drawn) == 20


def test_words_alone_decide_an_exam_whose_numbers_are_new(tmp_path: Path) -> None:
    words = ("--reproducible", "spring")
    write(tmp_path, CLASS[2:])
    assert generate(tmp_path, "EXAM", *words).exit_code == 0
    write(tmp_path, CLASS)
    assert generate(tmp_path, "EXAM", *words, "--force", "--new-numbers").exit_code == 0
    assert generate(tmp_path, "FRESH", *words).exit_code == 0
    assert papers(tmp_path / "EXAM") == papers(tmp_path / "FRESH")


def test_other_numbers_give_other_places(tmp_path: Path) -> None:
    write(tmp_path, CLASS)
    assert generate(tmp_path, "EXAM").exit_code == 0
    before = [line["place"] for line in key_lines(tmp_path / "EXAM")]
    for _ in range(3):
        assert generate(tmp_path, "EXAM", "--force", "--new-numbers").exit_code == 0
        if [line["place"] for line in key_lines(tmp_path / "EXAM")] != before:
            return
    raise AssertionError("the places stayed")


@pytest.mark.parametrize("place", ['"first"', "true", "1.5", "-1", "1000000", "999999", "2"])
def test_a_place_that_is_none_is_refused(tmp_path: Path, place: str) -> None:
    write(tmp_path, CLASS)
    assert generate(tmp_path, "EXAM").exit_code == 0
    key = tmp_path / "EXAM" / "key.jsonl"
    text = key.read_text(encoding="utf-8")
    key.write_text(re.sub(r'"place": ?1,', f'"place": {place},', text), encoding="utf-8")
    result = generate(tmp_path, "EXAM", "--force")
    assert result.exit_code == 2
    assert "key.jsonl:" in result.stderr
    assert "place" in result.stderr


def test_what_was_dealt_stands_in_the_key(tmp_path: Path) -> None:
    write(tmp_path, CLASS)
    assert generate(tmp_path, "EXAM").exit_code == 0
    lines = key_lines(tmp_path / "EXAM")
    assert sorted(line["place"] for line in lines) == list(range(7))
    template = load_template("slider-crank")
    for first in (line["questions"][0] for line in lines):
        stated = {name: each["exact"] for name, each in first["parameters"].items()}
        again = solve_template(template, first["drawn"]).parameters
        assert stated == {name: quantity.exact for name, quantity in again.items()}


def test_a_paper_is_set_alone_as_in_its_class(bank: Bank) -> None:
    whole = deal_exam(bank, roster(*CLASS), FromWords("spring"))
    together = [make_key_line(paper) for paper in whole.papers()]
    fresh = deal_exam(bank, roster("x"), FromWords("spring")).exam
    alone = [make_key_line(set_paper(fresh, whole.dealt(each))) for each in whole.roster.students]
    assert alone == together


def test_papers_are_set_together_as_alone(bank: Bank) -> None:
    whole = deal_exam(bank, roster(*CLASS), FromWords("spring"))
    dealt = [whole.dealt(each) for each in whole.roster.students]
    one, other = (deal_exam(bank, roster("x"), FromWords("spring")).exam for _ in range(2))
    alone = [make_key_line(set_paper(one, each)) for each in dealt]
    assert [make_key_line(each) for each in set_papers(other, dealt)] == alone


def test_the_places_of_a_class_get_the_same_whoever_has_them(bank: Bank) -> None:
    one = deal_exam(bank, roster(*CLASS), FromWords("spring"))
    other = deal_exam(bank, roster(*(f"other{each}" for each in CLASS)), FromWords("spring"))
    assert by_place(one) == by_place(other)


def by_place(dealt: ClassDeal) -> dict[int, tuple[Mapping[str, str], ...]]:
    papers = (dealt.dealt(student) for student in dealt.roster.students)
    return {paper.place: paper.values for paper in papers}


@pytest.mark.sampled(2, by="start")
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_other_processes_deal_the_same(bank: Bank, start: Start) -> None:
    students = roster(*(str(number) for number in range(30)))
    bank = replace(bank, questions=(bank.questions[0], bank.questions[2]))
    here = deal_exam(bank, students, FromWords("spring"))
    with open_executor(2, "generate", start) as workers:
        there = deal_exam(bank, students, FromWords("spring"), workers)
    assert there.deals == here.deals
    assert list(map(there.dealt, students.students)) == list(map(here.dealt, students.students))


SHORT = "q2 (crank): 20 of the 20 combinations of values are fit for 25 {}, so some have the same "


def test_too_few_combinations_are_dealt_round_and_said(tmp_path: Path) -> None:
    write(tmp_path, [f"s{number}" for number in range(25)])
    result = generate(tmp_path, "EXAM")
    assert result.exit_code == 1
    complaint = f"complaint: {SHORT.format('students')}numbers - expected one for each - state"
    assert complaint in result.stderr
    head = json.loads((tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert [question.get("good") for question in head["questions"]] == [None, 20]
    drawn = [json.dumps(line["questions"][1]["drawn"]) for line in key_lines(tmp_path / "EXAM")]
    assert sorted(map(drawn.count, set(drawn))) == [1] * 15 + [2] * 5


def test_too_few_combinations_are_refused_where_nothing_may_be_complained_of(
    tmp_path: Path,
) -> None:
    write(tmp_path, [f"s{number}" for number in range(25)])
    result = generate(tmp_path, "EXAM", "--strict")
    assert result.exit_code == 2
    assert f"error: {SHORT.format('students')}" in result.stderr
    assert not (tmp_path / "EXAM").exists()
