"""Moodle XML: nothing that Moodle refuses or spoils, every number as the key has it, hostile texts
harmless.
"""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from html import unescape
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExportError, OutputError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.quiz.document import (
    Language,
    Quiz,
    QuizAsk,
    QuizMistake,
    QuizPaper,
    QuizQuestion,
)
from kinegrade.exam.quiz.paper import QuizWishes
from kinegrade.exam.quiz.quiz import read_quiz
from kinegrade.lms.quiz.moodle.answers import SHARES
from kinegrade.lms.quiz.moodle.file import write
from kinegrade.lms.quiz.moodle.questions import Form
from tests.golden_files import Hold
from tests.lms.quiz.a_quiz import (
    ACCELERATION,
    ANGLE,
    SPEED,
    UNEVEN,
    ZERO,
    alter,
    make_sheet,
    papers,
    pooled,
    quiz,
)
from tests.lms.quiz.moodle_rules import FRACTIONS, Answer, Question, faults, first, read, right
from tests.said import all_said

FORMS = pytest.mark.parametrize("form", ["cloze", "numerical"])
NEAR = Fraction(1, 10**13)  # Moodle keeps fourteen digits


@pytest.fixture
def target(tmp_path: Path) -> Path:
    return tmp_path / "quiz.xml"


def written(given_quiz: Quiz, target: Path, form: Form = "cloze") -> str:
    write(given_quiz, target, form=form)
    text = target.read_text(encoding="utf-8")
    target.unlink()
    assert faults(text) == []
    return text


def of_asks(*asks: QuizAsk, statement: str = "Find it.", title: str = "Crank") -> Quiz:
    question = QuizQuestion("e-P-q1", make_sheet("q1", title, statement, asks), asks)
    return Quiz("en", "Mechanics", "Exam", [QuizPaper("P", "1", "Ann", (question,))])


def answers_to(ask: QuizAsk, target: Path, form: Form = "cloze") -> tuple[Answer, ...]:
    [question] = read(written(of_asks(ask), target, form))
    return typable(question.boxes[0][1])


def typable(found: tuple[Answer, ...]) -> tuple[Answer, ...]:
    """The answers that somebody may type."""
    return tuple(answer for answer in found if not answer.never)


def same(one: Fraction, other: Fraction, size: Fraction) -> bool:
    return abs(one - other) <= NEAR * size


def holds(found: tuple[Answer, ...], ask: QuizAsk) -> None:
    """The first answer is the right number, and one that earns all is the whole interval."""
    size = max(abs(ask.low), abs(ask.high), abs(ask.value))
    assert same(found[0].value, ask.value, size)
    all_points = [answer.interval for answer in found if answer.share == 100]
    assert any(
        low <= ask.low <= ask.high <= high
        and same(low, ask.low, size)
        and same(high, ask.high, size)
        for low, high in all_points
    ), all_points
    if ask.period is None:
        assert [
            (low, high)
            for low, high in all_points
            if not (low >= ask.low - NEAR * size and high <= ask.high + NEAR * size)
        ] == []


@FORMS
@pytest.mark.parametrize("language", ["en", "zh"])
def test_every_number_is_read_back_as_the_key_has_it(
    small_class: Path, target: Path, form: Form, language: Language
) -> None:
    put = read_quiz(open_exam(small_class / "EXAM"), language)
    put = replace(put, papers=tuple(put.papers))
    questions = read(written(put, target, form))
    boxes = [box for question in questions for box in question.boxes]
    asks = [ask for paper in put.papers for question in paper.questions for ask in question.asks]
    assert len(questions) == (12 if form == "cloze" else 24)
    for ask, (mark, found) in zip(asks, boxes, strict=True):
        holds(found, ask)
        assert mark == ask.row.points * (2 if form == "cloze" else 1)
        for mistake in ask.mistakes:
            told = first(found, mistake.value)
            assert told is not None
            assert mistake.sentence in unescape(told.feedback).replace("’", "'")


@FORMS
def test_hostile_texts_and_awkward_numbers(target: Path, form: Form) -> None:
    for language in ("en", "zh"):
        questions = read(written(quiz(language), target, form))  # type: ignore[arg-type]
        assert "<script" not in "".join(question.text for question in questions)
    asks = [ask for paper in papers() for question in paper.questions for ask in question.asks]
    boxes = [box for question in read(written(quiz(), target, form)) for box in question.boxes]
    for ask, (_, found) in zip(asks, boxes, strict=True):
        holds(found, ask)


def test_the_small_class_as_a_file(small_class: Path, target: Path, hold: Hold) -> None:
    put = read_quiz(open_exam(small_class / "EXAM"))
    text = written(replace(put, papers=list(put.papers)[:2]), target)
    hold("lms/quiz-moodle.xml", re.sub(r'(encoding="base64">)[^<]*', r"\1(the figure)", text))


def test_mistakes_earn_their_share_and_are_told(target: Path) -> None:
    found = answers_to(ACCELERATION, target)
    assert right(found, Fraction("-12.345")) == right(found, Fraction("-12.46845")) == 100
    assert right(found, Fraction("-12.46846")) == 0
    assert [(answer.value, answer.share, answer.feedback) for answer in found[1:]] == [
        (-7, 50, "Coriolis term &lt; left out &amp; more ]]&gt;"),
        (Fraction("12.345"), 0, "wrong sense"),
    ]


def test_a_sentence_of_all_that_cloze_uses_is_told_as_it_is(target: Path) -> None:
    sentence = 'a } b # c ~ d \\ e / f " g {1:NM:=2} h \\'
    mistake = QuizMistake("m", Fraction(9), Fraction(0), sentence, Fraction(8), Fraction(10))
    assert unescape(answers_to(replace(SPEED, mistakes=(mistake,)), target)[1].feedback) == sentence


def test_equal_mistakes_are_one_answer_with_both_sentences_and_the_better_share(
    target: Path,
) -> None:
    twice = (
        QuizMistake("a", Fraction(7), Fraction(1, 10), "First.", Fraction(6), Fraction(8)),
        QuizMistake("b", Fraction(7), Fraction(1, 4), "Second.", Fraction(6), Fraction(8)),
        QuizMistake("c", Fraction(5), Fraction(0), "Exact."),
    )
    found = answers_to(replace(SPEED, mistakes=twice), target)[1:]
    assert [(answer.room, answer.share, answer.feedback) for answer in found] == [
        (1, 25, "First.<br/>Second."),
        (0, 0, "Exact."),
    ]


@FORMS
def test_an_uneven_interval_is_whole_and_the_right_number_is_shown(
    target: Path, form: Form
) -> None:
    found = answers_to(UNEVEN, target, form)
    assert [answer.interval for answer in found] == [(9, 11), (9, Fraction("12.5"))]
    assert found[0].value == 10
    assert [right(found, Fraction(typed)) for typed in ("8.999", "9", "12.5", "12.501")] == [
        0,
        100,
        100,
        0,
    ]


@FORMS
def test_zero_has_its_absolute_room(target: Path, form: Form) -> None:
    assert [(answer.value, answer.room) for answer in answers_to(ZERO, target, form)] == [
        (0, Fraction(1, 100))
    ]


@FORMS
def test_whole_turns_more_or_less_are_right(target: Path, form: Form) -> None:
    found = answers_to(ANGLE, target, form)
    assert found[0].value == 30
    assert [
        right(found, Fraction(typed))
        for typed in (30, -330, 31, "29.5", "-330.5", "-331", 390, "390.5", 391, -690, 750)
    ] == [100, 100, 0, 100, 100, 0, 100, 100, 0, 100, 0]


@given(st.fractions(-1000, 1000), st.fractions(0, 10), st.fractions(0, 10))
def test_any_interval_is_read_back(value: Fraction, below: Fraction, above: Fraction) -> None:
    from tempfile import TemporaryDirectory

    ask = replace(SPEED, value=value, low=value - below, high=value + above)
    with TemporaryDirectory() as folder:
        holds(answers_to(ask, Path(folder) / "quiz.xml"), ask)


TRAPS = st.text(st.sampled_from("{}#~:=%\\/\"'<>&]1NMUERICAL$ \n\x00é中")) | st.text()


@given(TRAPS, TRAPS, TRAPS)
def test_no_text_breaks_a_question(name: str, sentence: str, title: str) -> None:
    from tempfile import TemporaryDirectory

    ask = replace(
        SPEED,
        mistakes=(QuizMistake("m", Fraction(9), Fraction(0), sentence, Fraction(8), Fraction(10)),),
    )
    question = QuizQuestion("e-P-q1", make_sheet("q1", title, "Find it.", (ask,)), (ask,))
    put = Quiz("en", "", f"T{title}", [QuizPaper("P", "1", name, (question,))])
    with TemporaryDirectory() as folder:
        [found] = read(written(put, Path(folder) / "quiz.xml"))
    assert len(found.boxes) == 1
    assert [answer.value for answer in typable(found.boxes[0][1])][1:] == [9]


@pytest.mark.parametrize(
    "text", ["{1:SHORTANSWER:=x}", "{:NM:=1}", "{#1}", "a {2:MC:=x~y} b", "\\{1:NM:=1:2\\}"]
)
def test_a_text_that_looks_like_a_box_is_none(target: Path, text: str) -> None:
    ask = alter(SPEED, meaning=f"speed {text}", sign=f"sign {text}")
    [question] = read(written(of_asks(ask, statement=f"Take {text} as it is."), target))
    assert len(question.boxes) == 1
    assert question.text.count("&#123;") == 3


def test_formulas_beside_boxes_stay_as_they_are(target: Path) -> None:
    statement = r"With $\frac{a}{b} = x_{1}$ and $v_{AB}^{2}$."
    [question] = read(written(of_asks(SPEED, statement=statement), target))
    assert r"\(\frac{a}{b} = x_{1}\) and \(v_{AB}^{2}\)" in question.text


def test_marks_are_whole_and_in_the_ratio_of_the_points(target: Path) -> None:
    points = {SPEED: "2.5", UNEVEN: "1", ZERO: "0.25"}
    asks = [alter(ask, points=Fraction(worth)) for ask, worth in points.items()]
    remarks = all_said(write(of_asks(*asks), target))
    [question] = read(target.read_text(encoding="utf-8"))
    assert [mark for mark, _ in question.boxes] == [10, 4, 1]
    assert "4 times its points" in question.text
    assert remarks[:1] == [
        "marks in Moodle are 4 times the points, because a Cloze question has whole marks only; "
        "the maximum grade of the quiz corrects that"
    ]
    remarks = all_said(write(of_asks(*asks), target, form="numerical", force=True))
    assert [remark for remark in remarks if "times the points" in remark] == []
    numerical = read(target.read_text(encoding="utf-8"))
    assert [question.boxes[0][0] for question in numerical] == [
        Fraction("2.5"),
        1,
        Fraction("0.25"),
    ]


def test_papers_have_categories_and_pools_have_one_for_each_question(target: Path) -> None:
    own = read(written(quiz(), target))
    assert {question.category.split("/")[-1] for question in own} == {"P1", "P2"}
    assert own[0].tags == ("kinegrade", "q1", "P1")
    assert {question.category.split("/")[2] for question in own} == {
        "Kinematics & <quiz> ]]> (4711)"
    }
    pool = read(written(pooled(), target))
    assert [(question.category, question.tags) for question in pool] == [
        ("$course$/top/Kinematics (4711)/q1 Slider-crank OAB & co.", ("kinegrade", "q1")),
        ("$course$/top/Kinematics (4711)/q2 Slider-crank OAB & co.", ("kinegrade", "q2")),
        ("$course$/top/Kinematics (4711)/q1 Slider-crank OAB & co.", ("kinegrade", "q1")),
    ]


def test_identifiers_stay_when_the_exam_is_written_again(small_class: Path, target: Path) -> None:
    once, again = (written(read_quiz(open_exam(small_class / "EXAM")), target) for _ in range(2))
    assert once == again
    numerical = read(written(read_quiz(open_exam(small_class / "EXAM")), target, "numerical"))
    assert len({question.identifier for question in numerical}) == 24


def test_names_are_kept_whole_and_levels_of_categories_are_not_torn(target: Path) -> None:
    put = replace(of_asks(SPEED, title="long & " * 90), title="Spring/Summer " + "x" * 300)
    [question] = read(written(put, target))
    assert question.name.endswith("…")
    assert question.category.count("/") == 3
    assert question.category.split("/")[2].startswith("Spring∕Summer")


def test_figures_and_solutions_travel(small_class: Path, target: Path) -> None:
    put = read_quiz(open_exam(small_class / "EXAM"), variants=1, wishes=QuizWishes(solutions=True))
    questions = read(written(put, target))
    assert [
        question for question in questions if not question.files["figure.svg"].startswith(b"<svg")
    ] == []
    assert [question for question in questions if r"\begin{aligned}" not in question.feedback] == []
    for question in questions:
        shown = re.findall(r'src="@@PLUGINFILE@@/([^"]*)"', question.feedback)
        assert shown == [f"solution-{number}.svg" for number in range(1, len(shown) + 1)]
        assert {*shown} == {*question.feedback_files}
    assert any(question.feedback_files for question in questions), questions
    assert [
        question for question in questions if ", drawn to scale: points " not in question.text
    ] == []


def test_our_shares_are_moodles() -> None:
    assert set(SHARES) == FRACTIONS


def credited(credit: Fraction) -> QuizAsk:
    return replace(SPEED, mistakes=(QuizMistake("m", Fraction(9), credit, "No."),))


@pytest.mark.parametrize(
    ("credit", "share"),
    [
        (Fraction(1, 3), "33.33333"),
        (Fraction(1, 8), "12.5"),
        (Fraction(5, 6), "83.33333"),
        (Fraction(1, 20), "5"),
    ],
)
def test_a_third_is_moodles_third(target: Path, credit: Fraction, share: str) -> None:
    assert answers_to(credited(credit), target, "numerical")[1].share == Fraction(share)


def test_credits_that_moodle_does_not_know_are_refused(target: Path) -> None:
    with pytest.raises(
        ExportError,
        match="credit of 33 per cent for known mistakes: Moodle has no such share - exp",
    ):
        write(of_asks(credited(Fraction(33, 100))), target)
    with pytest.raises(
        ExportError,
        match="v_B: a share of the points that is not a whole per cent - expected one in",
    ):
        write(of_asks(credited(Fraction(1, 3))), target)
    assert not list(target.parent.iterdir())


def test_an_empty_quiz_is_refused(target: Path) -> None:
    with pytest.raises(
        ExportError,
        match="quiz: no paper - expected at least one - choose an exam that has students",
    ):
        write(Quiz("en", "", "", ()), target)


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine", encoding="utf-8")
    with pytest.raises(OutputError, match="cannot be written"):
        write(quiz(), tmp_path / "file" / "quiz.xml")


def test_a_file_appears_whole_or_not_at_all(target: Path) -> None:
    def breaking() -> list[QuizPaper]:
        yield papers()[0]  # type: ignore[misc]
        raise ExportError("in the middle")

    target.write_text("old", encoding="utf-8")
    with pytest.raises(ExportError, match="in the middle"):
        write(replace(quiz(), papers=breaking()), target, force=True)
    assert [(file.name, file.read_text()) for file in target.parent.iterdir()] == [
        ("quiz.xml", "old")
    ]


def names(questions: list[Question]) -> list[str]:
    return [question.name for question in questions]


def test_a_numerical_question_says_what_it_asks_for(target: Path) -> None:
    questions = read(written(quiz(), target, "numerical"))
    assert names(questions)[:2] == [
        "P1 q1 Slider-crank OAB & co.: v_B",
        "P1 q1 Slider-crank OAB & co.: a_C",
    ]
    assert r"\(v_{B} =\) ? m/s (2.5 points)" in questions[0].text
    assert (
        r"(positive along \(+x\)): \(a_{C}^{\mathrm{n}} =\) ? m/s<sup>2</sup>" in questions[1].text
    )
