"""An exam folder as a quiz: the key's own numbers, the papers' own texts and figures, whoever makes
them.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import ExamError, KinegradeError
from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.folder.key.exact_keys import read_key_line
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.exam.printing.pages import lay_out_paper
from kinegrade.exam.quiz import quiz
from kinegrade.exam.quiz.document import QuizAsk, QuizPaper
from kinegrade.exam.quiz.paper import QuizWishes, make_quiz_paper, show_instance
from kinegrade.exam.quiz.quiz import PLAIN
from kinegrade.exam.quiz.source import read_quiz_source
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.processes.executor import Start, open_executor
from kinegrade.stated_marking import find_identifier
from kinegrade.students.mistaking.mistake_names import describe_mistakes
from tests.exam.quizzes import papers, quiz_of
from tests.small_class import STUDENTS, generate, write_class


def asks(paper: QuizPaper) -> dict[str, QuizAsk]:
    return {
        f"{question.sheet.identifier}.{ask.identifier}": ask
        for question in paper.questions
        for ask in question.asks
    }


def copied(small_class: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))


def rewritten(exam: Path, line: dict[str, Any]) -> Path:
    """The exam with another first line of its key."""
    key = exam / "key.jsonl"
    others = key.read_text(encoding="utf-8").splitlines()[1:]
    key.write_text("\n".join([json.dumps(line), *others]) + "\n", encoding="utf-8")
    return exam


def read_line(line: dict[str, Any]) -> KeyLine:
    return read_key_line(json.dumps(line).encode())


def first_line(exam: Path) -> dict[str, Any]:
    line: dict[str, Any] = json.loads(
        (exam / "key.jsonl").read_text(encoding="utf-8").splitlines()[0]
    )
    return line


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


def test_variants_are_the_first_papers_and_nobodys(small_class: Path) -> None:
    pool, own = papers(small_class / "EXAM", variants=2), papers(small_class / "EXAM")
    assert pool == tuple(replace(paper, student="", name="") for paper in own[:2])
    with pytest.raises(
        ExamError, match="has 4 different papers - expected 5 for 5 variants of each question - ask"
    ):
        quiz_of(small_class / "EXAM", variants=5)


def test_a_version_is_put_once_and_questions_in_the_order_in_which_responses_are_read(
    tmp_path: Path,
) -> None:
    folder = write_class(tmp_path)
    bank = (folder / "bank.toml").read_text(encoding="utf-8")
    (folder / "bank.toml").write_text("versions = 2\nshuffle = true\n" + bank, encoding="utf-8")
    assert generate(folder).exit_code == 0
    put = papers(folder / "EXAM")
    assert [(paper.code, paper.student, paper.name) for paper in put] == [
        ("A", "", "Version A"),
        ("B", "", "Version B"),
    ]
    lines = open_exam(folder / "EXAM").keys.texts()
    orders = {tuple(json.loads(line)["printed"]) for _, line in lines}
    read = list(open_exam(folder / "EXAM").questions)
    assert orders - {tuple(read)}
    assert [[question.sheet.identifier for question in paper.questions] for paper in put] == [
        read,
        read,
    ]
    assert len(papers(folder / "EXAM", variants=2)) == 2
    with pytest.raises(ExamError, match="has 2 different papers"):
        quiz_of(folder / "EXAM", variants=3)


@pytest.mark.sampled(2, by="start")
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_other_processes_make_the_same_papers(
    small_class: Path, monkeypatch: pytest.MonkeyPatch, start: Start
) -> None:
    monkeypatch.setattr(quiz, "_PART", 1)
    with open_executor(2, "quiz", start) as workers:
        assert papers(small_class / "EXAM", workers=workers) == papers(small_class / "EXAM")


def test_papers_are_counted_for_a_progress_bar(small_class: Path) -> None:
    counts: list[int] = []

    def watched(items: Any, count: int) -> Any:
        counts.append(count)
        return items

    assert len(papers(small_class / "EXAM", progress=watched)) == 4
    papers(small_class / "EXAM", progress=watched, variants=3)
    assert counts == [4, 3]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        (
            "exam.json",
            None,
            r"exam.json: cannot be read \(No such file or directory\) - expected an exam folder "
            r"made by",
        ),
        (
            "bank.toml",
            b"\xff",
            r"bank.toml: cannot be read \(not UTF-8\) - expected an exam folder made by kinegrade",
        ),
        (
            "key.jsonl",
            None,
            r"key.jsonl: cannot be read \(No such file or directory\) - expected an exam folder",
        ),
        (
            "exam.json",
            b"{}",
            r"exam.json: format: missing - expected 1 or 2, the only ones this kinegrade reads",
        ),
        (
            "exam.json",
            b'{"format": 3}',
            r"exam.json:1: format: 3 - expected 1 or 2, the only ones this kinegrade reads - use a",
        ),
        (
            "exam.json",
            b'{"format": 1, "questions": [], "students": 5}',
            r"exam.json:1: questions: empty - expected a list that is not empty - restore the",
        ),
        (
            "key.jsonl",
            b"{",
            r"key.jsonl: line 1: is broken \(.*\) - expected it as kinegrade generate wrote it",
        ),
        ("templates/crank.toml", b"family = 5", r"EXAM: crank.toml"),
    ],
)
def test_a_folder_at_fault_is_refused(
    small_class: Path, tmp_path: Path, name: str, text: bytes | None, message: str
) -> None:
    exam = copied(small_class, tmp_path)
    if text is None:
        (exam / name).unlink()
    else:
        (exam / name).write_bytes(text)
    with pytest.raises(ExamError, match=message):
        papers(exam)


def test_a_broken_line_of_the_key_is_named(small_class: Path, tmp_path: Path) -> None:
    exam = copied(small_class, tmp_path)
    source, line = read_quiz_source(open_exam(exam)), first_line(exam)
    line["questions"][0]["asks"]["v_B"]["points"] = "1e999"
    with pytest.raises(
        ExamError,
        match=r'the line of student "007": is broken \("points" is .* - expected a number\) - expect',
    ):
        make_quiz_paper(source, PLAIN, read_line(line))


@pytest.mark.parametrize(
    ("change", "unknown"),
    [
        (lambda line: line.update(student="008"), "008"),
        (lambda line: line["questions"][0].update(question="q9"), "q9"),
        (lambda line: line["questions"][0]["asks"].update(v_Z={}), "v_Z"),
    ],
)
def test_a_line_that_the_head_does_not_know_is_named(
    small_class: Path, tmp_path: Path, change: Callable[[dict[str, Any]], None], unknown: str
) -> None:
    exam = copied(small_class, tmp_path)
    source, line = read_quiz_source(open_exam(exam)), first_line(exam)
    ask = line["questions"][0]["asks"]["v_B"]
    change(line)
    if unknown == "v_Z":
        line["questions"][0]["asks"]["v_Z"] = ask
    with pytest.raises(
        ExamError, match=rf"is broken \('{unknown}' is not in exam.json\) - expected it as"
    ):
        make_quiz_paper(source, PLAIN, read_line(line))


def test_a_value_that_builds_no_mechanism_is_told_with_its_paper(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    source, line = read_quiz_source(open_exam(exam)), first_line(exam)
    line["questions"][1]["drawn"]["h"] = "99"
    with pytest.raises(KinegradeError, match=rf"EXAM: paper {line['paper']}, q2: points.A: "):
        make_quiz_paper(source, PLAIN, read_line(line))


def test_the_asks_are_known_ahead_of_the_papers(small_class: Path) -> None:
    quiz = quiz_of(small_class / "EXAM", variants=2, wishes=QuizWishes(mistakes=False))
    ahead = list(quiz.asks)
    of_papers = [
        (question.sheet.identifier, ask)
        for paper in quiz.papers
        for question in paper.questions
        for ask in question.asks
    ]
    assert ahead == of_papers


def test_a_solution_has_graphs_where_those_of_the_exam_have(
    small_class: Path, tmp_path: Path
) -> None:
    exam = copied(small_class, tmp_path)
    drawn = count_pictures(exam)
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    (exam / "exam.json").write_text(json.dumps(head | {"cycle": True}), encoding="utf-8")
    moving = [len(question.asks) for question in papers(exam, variants=1)[0].questions]
    assert count_pictures(exam) == [few + asked for few, asked in zip(drawn, moving, strict=True)]


def count_pictures(exam: Path) -> list[int]:
    """The pictures of each solution of the first paper."""
    (paper,) = papers(exam, variants=1, wishes=QuizWishes(solutions=True))
    return [len(question.solution.pictures) for question in paper.questions]
