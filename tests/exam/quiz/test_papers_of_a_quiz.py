"""The papers of a quiz: their numbers, rules, texts and figures, and what mistakes earn."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.quiz.paper import QuizWishes, make_quiz_paper, show_instance
from kinegrade.exam.quiz.quiz import PLAIN
from kinegrade.exam.quiz.source import read_quiz_source
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.stated_marking import find_identifier
from kinegrade.students.mistaking.mistake_names import describe_mistakes
from tests.exam.quiz.exam_folders import asks, copied, first_line, read_line, rewritten
from tests.exam.quizzes import papers, quiz_of
from tests.small_class import STUDENTS


def test_every_number_is_the_one_by_which_marks_are_decided(small_class: Path) -> None:
    exam = read_whole(open_exam(small_class / "EXAM"))
    found = {paper.student: asks(paper) for paper in papers(small_class / "EXAM")}
    assert list(found) == list(STUDENTS)
    for examinee in exam.examinees:
        for ask in exam.asks:
            key, put = examinee.keys[ask.column], found[examinee.student][ask.column]
            assert (put.value, (put.low, put.high), put.period) == (
                key.value,
                key.interval,
                key.period,
            )
            assert (put.row.points, put.row.unit) == (ask.points, ask.unit)
            assert [(mistake.identifier, mistake.value) for mistake in put.mistakes] == [
                (find_identifier(label), value) for label, value in key.mistakes.items()
            ]
            for mistake in put.mistakes:
                assert mistake.interval == key.rule.interval(mistake.value)


def test_statements_and_figures_are_those_of_the_paper(small_class: Path) -> None:
    bank = read_bank(small_class / "bank.toml")
    setting = deal_exam(
        bank, Roster.read(small_class / "roster.csv", odd_ids=True), FromWords("spring")
    )
    for paper, put in zip(setting.papers(), papers(small_class / "EXAM"), strict=True):
        page = lay_out_paper(bank, paper, "en")
        assert (put.code, put.student, put.name) == (page.code, page.student, page.name)
        for sheet, question in zip(page.questions, put.questions, strict=True):
            rows = tuple(replace(row, tolerance=()) for row in sheet.rows)
            # what a quiz says of the figure at length, a paper does not
            assert replace(question.sheet, described=sheet.described) == replace(sheet, rows=rows)
            assert tuple(ask.row for ask in question.asks) == rows


@pytest.mark.parametrize("name", find_template_names())
def test_what_is_shown_needs_no_solving(name: str) -> None:
    template = load_template(name)
    solution = solve_template(template, {})
    shown = show_instance(template, {}, template.asks)
    assert write_statement(template, shown.parameters, "en") == write_statement(
        template, solution.parameters, "en"
    )
    assert shown.mechanism == solution.assembly.mechanism.map(float)


def test_the_rule_is_the_banks_even_where_zero_answers_have_more_room(small_class: Path) -> None:
    questions = papers(small_class / "EXAM")[0].questions
    rules = [question.rule for question in questions]
    assert "at most 1 % of that value" in rules[0]
    assert [question.digits for question in questions] == [4, 4, 4]
    assert (
        "For $v_{y}$: an answer is right if it differs from the exact value by at most "
        r"$0.25\,\unit{m/s}$." in rules[1]
    )
    assert r"0.5 % of that value, or by at most $0.001\,\unit{rad/s^2}$, whichever" in rules[2]
    assert [rule for rule in rules if "table" in rule] == []


def test_a_quiz_in_the_other_language(small_class: Path) -> None:
    chinese = quiz_of(small_class / "EXAM", "zh")
    assert (chinese.language, chinese.title, chinese.course) == ("zh", "期中测验", "力学")
    paper = next(iter(chinese.papers))
    assert paper.questions[1].sheet.title == "曲柄"
    assert "精确值" in paper.questions[0].rule
    mistake = paper.questions[0].asks[0].mistakes[0]
    assert mistake.sentence == describe_mistakes("zh")[mistake.identifier]
    assert quiz_of(small_class / "EXAM").language == "en"


def test_mistakes_earn_what_is_wished_or_stay_out(small_class: Path) -> None:
    half = papers(small_class / "EXAM", wishes=QuizWishes(credit=Fraction(1, 2)))[0]
    assert {mistake.credit for ask in asks(half).values() for mistake in ask.mistakes} == {
        Fraction(1, 2)
    }
    assert {
        mistake.credit
        for ask in asks(papers(small_class / "EXAM")[0]).values()
        for mistake in ask.mistakes
    } == {0}
    none = papers(small_class / "EXAM", wishes=QuizWishes(mistakes=False))[0]
    assert not [ask for ask in asks(none).values() if ask.mistakes]


def test_mistakes_earn_what_the_bank_says_unless_something_else_is_wished(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    head["credit"] = {"follow-through": "1/3", "mistakes": {"sense-reversed": "1/2"}}
    (exam / "exam.json").write_text(json.dumps(head), encoding="utf-8")
    found = [mistake for ask in asks(papers(exam)[0]).values() for mistake in ask.mistakes]
    assert {mistake.credit for mistake in found if mistake.identifier == "sense-reversed"} == {
        Fraction(1, 2)
    }
    assert {mistake.credit for mistake in found if mistake.identifier != "sense-reversed"} == {0}
    wished = papers(exam, wishes=QuizWishes(credit=Fraction(0)))[0]
    assert {mistake.credit for ask in asks(wished).values() for mistake in ask.mistakes} == {0}


def test_a_mistake_within_what_is_right_is_none(small_class: Path, tmp_path: Path) -> None:
    exam = copied(small_class, tmp_path)
    line = first_line(exam)
    ask = line["questions"][0]["asks"]["v_B"]
    ask["mistakes"] = {"wrong-pole": ask["decimal"], "of-tomorrow": "77"}
    source = read_quiz_source(open_exam(rewritten(exam, line)))
    paper = make_quiz_paper(source, PLAIN, read_line(line))
    assert [
        (mistake.identifier, mistake.sentence) for mistake in asks(paper)["q1.v_B"].mistakes
    ] == [("of-tomorrow", "of-tomorrow")]


def test_significant_figures_give_an_interval_that_is_not_symmetric(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    line = first_line(exam)
    ask = line["questions"][0]["asks"]["v_B"]
    ask |= {
        "exact": None,
        "decimal": "1.2304",
        "value": 1.2304,
        "tolerance": {"relative": 0, "absolute": 0, "figures": 3},
    }
    put = asks(papers(rewritten(exam, line))[0])["q1.v_B"]
    assert (put.low, put.high) == (Fraction("1.225"), Fraction("1.235"))


def test_an_angle_keeps_its_period_and_an_enclosure_its_decimal(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    line = first_line(exam)
    question = line["questions"][0]
    question["asks"]["v_B"] |= {
        "period": "360",
        "exact": "pi/3",
        "decimal": "1.0471975511965977461542144610931676",
        "value": 1.0471975511965976,
    }
    question["parameters"]["r"] = {"exact": None, "value": 2.5e-1, "unit": "m"}
    del question["drawn"]
    paper = papers(rewritten(exam, line))[0]
    put = asks(paper)["q1.v_B"]
    assert (put.period, put.value) == (360, Fraction("1.0471975511965977461542144610931676"))
    assert r"r = 0.25\,\unit{m}" in paper.questions[0].sheet.statement
