"""What Moodle gives for a typed answer is what marking here gives: at the edges, with turns, where
mistakes overlap.
"""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizMistake, QuizPaper, QuizQuestion
from kinegrade.lms.quiz.moodle.file import write
from kinegrade.lms.quiz.moodle.questions import Form
from tests.lms.quiz.a_quiz import ANGLE, SPEED, alter, make_sheet, pooled, quiz
from tests.lms.quiz.moodle_rules import Answer, box_width, faults, first, read, right
from tests.said import all_said
from tests.small_class import generate, kinegrade, write_class

FORMS = pytest.mark.parametrize("form", ["cloze", "numerical"])
TWO_PI = Fraction("6.283185307179586476925286766559005768394")
CLOSEST = Fraction(1, 10**11)  # of a number's size: what lies farther outside is told apart


def answers_to(ask: QuizAsk, form: Form = "cloze") -> tuple[Answer, ...]:
    """The answers that Moodle has after it has read an ask."""
    question = QuizQuestion("e-P-q1", make_sheet("q1", "Crank", "Find it.", (ask,)), (ask,))
    with TemporaryDirectory() as folder:
        target = Path(folder) / "quiz.xml"
        put = Quiz("en", "Mechanics", "Exam", [QuizPaper("P", "1", "Ann", (question,))])
        write(put, target, form=form)
        text = target.read_text(encoding="utf-8")
    assert faults(text) == []
    return read(text)[0].boxes[0][1]


def decimal(places: int) -> st.SearchStrategy[Fraction]:
    return st.integers(-(10**7), 10**7).map(lambda digits: Fraction(digits, 10**places))


@given(
    st.fractions(-10000, 10000).filter(lambda value: abs(value) > Fraction(1, 1000)),
    st.fractions(Fraction(1, 1000), Fraction(1, 10)),
    st.fractions(-1, 1),
)
def test_no_right_answer_is_lost_at_an_edge_and_no_wrong_one_is_taken(
    value: Fraction, share: Fraction, where: Fraction
) -> None:
    room = abs(value) * share
    ask = replace(SPEED, value=value, low=value - room, high=value + room)
    found = answers_to(ask, "numerical")
    beyond = abs(value) * CLOSEST
    assert [right(found, typed) for typed in (ask.low, ask.high, value + where * room, value)] == [
        100
    ] * 4
    assert right(found, ask.low - beyond) == right(found, ask.high + beyond) == 0


@FORMS
@pytest.mark.parametrize(
    ("value", "edge"), [("5/3", "1.65"), ("5/3", "1.6833333333333333"), ("1000/7", "144.285714286")]
)
def test_the_edge_of_a_repeating_decimal_is_right_in_moodle_too(
    value: str, edge: str, form: Form
) -> None:
    exact = Fraction(value)
    ask = replace(SPEED, value=exact, low=exact * 99 / 100, high=exact * 101 / 100)
    typed = min(max(Fraction(edge), ask.low), ask.high)
    assert abs(typed - Fraction(edge)) < Fraction(1, 10**9)
    assert right(answers_to(ask, form), typed) == 100


@given(st.fractions(Fraction(-7), Fraction(7)), st.integers(-3, 3))
def test_the_turns_that_the_text_promises_are_right(angle: Fraction, turns: int) -> None:
    value = angle * 9 / 10
    ask = alter(
        ANGLE,
        unit="rad",
        value=value,
        low=value - Fraction(1, 100),
        high=value + Fraction(1, 100),
        period=TWO_PI,
    )
    typed = value + turns * TWO_PI
    promised = abs(typed) <= 2 * TWO_PI
    assert right(answers_to(ask), typed) == 100 or not promised


def test_a_turn_more_or_less_than_the_key_is_right_and_the_text_says_so(tmp_path: Path) -> None:
    for key in (1, -3, 6):
        value = Fraction(key)
        room = Fraction(1, 100)
        ask = alter(
            ANGLE, unit="rad", value=value, low=value - room, high=value + room, period=TWO_PI
        )
        found = answers_to(ask)
        assert [right(found, value + turn * TWO_PI) for turn in (-1, 0, 1)] == [100] * 3
    write(quiz(), tmp_path / "quiz.xml")
    texts = [question.text for question in read((tmp_path / "quiz.xml").read_text("utf-8"))]
    assert ["within two turns of zero" in text for text in texts] == [False, True, False]


def test_a_mistaken_angle_earns_its_share_with_a_turn_more() -> None:
    wrong = QuizMistake("m", Fraction(60), Fraction(1, 2), "No.", Fraction(59), Fraction(61))
    found = answers_to(alter(ANGLE, mistakes=(wrong,)))
    assert [right(found, Fraction(typed)) for typed in (60, 420, -300, 30, 390)] == [
        50,
        50,
        50,
        100,
        100,
    ]


def mistake(name: str, low: str, high: str, credit: str = "0") -> QuizMistake:
    bounds = Fraction(low), Fraction(high)
    return QuizMistake(name, sum(bounds, Fraction(0)) / 2, Fraction(credit), f"{name}.", *bounds)


def sentences(found: Sequence[Answer], typed: Fraction) -> set[str]:
    taken = first(tuple(found), typed)
    return set() if taken is None or taken.never else set(taken.feedback.split("<br/>"))


def test_a_number_that_two_mistakes_lead_to_shows_both_and_earns_the_better_share() -> None:
    near = (mistake("wide", "10", "20"), mistake("narrow", "18", "21", "1/4"))
    found = answers_to(replace(SPEED, mistakes=near))
    shown = {typed: sentences(found, Fraction(typed)) for typed in (9, 10, 17, 18, 19, 20, 21, 22)}
    both = {"wide.", "narrow."}
    assert shown == {
        9: set(),
        10: {"wide."},
        17: {"wide."},
        18: both,
        19: both,
        20: both,
        21: {"narrow."},
        22: set(),
    }
    assert [right(found, Fraction(typed)) for typed in (17, 19, 21)] == [0, 25, 25]


MISTAKES = st.lists(
    st.tuples(st.integers(20, 60), st.integers(0, 12), st.sampled_from(["0", "1/4", "1/2"])),
    max_size=6,
)


@given(MISTAKES, st.integers(80, 300))
def test_every_number_shows_all_the_mistakes_that_lead_to_it(
    drawn: list[tuple[int, int, str]], quarter: int
) -> None:
    mistakes = tuple(
        mistake(f"m{place}", str(middle - room), str(middle + room), credit)
        for place, (middle, room, credit) in enumerate(drawn)
    )
    typed = Fraction(quarter, 4)
    leading = [each for each in mistakes if each.interval[0] <= typed <= each.interval[1]]
    found = answers_to(replace(SPEED, mistakes=mistakes))
    assert sentences(found, typed) == {each.sentence for each in leading}
    assert right(found, typed) == max((100 * each.credit for each in leading), default=0)


@pytest.mark.parametrize("value", ["2", "-12345.678", "1/3", "-0.00012345678901234567", "0"])
def test_the_width_of_a_box_tells_nothing_of_the_number(value: str) -> None:
    exact = Fraction(value)
    room = abs(exact) / 50 or Fraction(1, 100)
    ask = replace(SPEED, value=exact, low=exact - room, high=exact + room)
    assert box_width(answers_to(ask)) == 21


def test_exams_of_one_title_do_not_share_their_pools(small_class: Path, tmp_path: Path) -> None:
    write_class(tmp_path)
    assert generate(tmp_path, "EXAM", "--seed", "autumn").exit_code == 0
    categories = []
    first = shutil.copytree(small_class / "EXAM", tmp_path / "FIRST")  # the pool is stored there
    for exam in (first, tmp_path / "EXAM"):
        target = tmp_path / f"{len(categories)}.xml"
        put = ("quiz", exam, "--to", "moodle-xml", "--variants", "2", "-o", target)
        assert kinegrade(*put).exit_code == 1
        categories.append({one.category for one in read(target.read_text(encoding="utf-8"))})
    assert len(categories[0]) == len(categories[1]) == 3
    assert not categories[0] & categories[1]


def test_the_mark_of_each_pool_is_said(tmp_path: Path) -> None:
    *_, cloze = all_said(write(pooled(), tmp_path / "cloze.xml"))
    assert cloze == (
        "moodle-xml: Moodle adds a random question to a quiz with mark 1, whatever its variants "
        "are worth - set the mark of each there: q1 17, q2 10"
    )
    *_, numerical = all_said(write(pooled(), tmp_path / "numerical.xml", form="numerical"))
    assert numerical.endswith(
        "q1 v_B 2.5, q1 a_C 2, q1 v_D 2, q1 v_E 2, q2 phi 2, q2 k 1, q2 v_F 2"
    )


def test_a_pool_of_numerical_questions_draws_variants_of_one_ask(tmp_path: Path) -> None:
    write(pooled(), tmp_path / "quiz.xml", form="numerical")
    asks: dict[str, set[str]] = {}
    for question in read((tmp_path / "quiz.xml").read_text(encoding="utf-8")):
        asks.setdefault(question.category, set()).add(question.name.rpartition(": ")[2])
    assert len(asks) == 7
    assert [names for names in asks.values() if len(names) != 1] == []


def test_that_moodle_has_no_way_to_put_own_papers_is_said(tmp_path: Path) -> None:
    no_route = "moodle-xml: the questions of a Moodle quiz are the same for all students"
    told = all_said(write(quiz(), tmp_path / "own.xml"))
    assert any(line.startswith(no_route) for line in told), told
    versions = [replace(paper, student="", name="Version A") for paper in quiz().papers]
    for name, put in (("pool", pooled()), ("versions", replace(quiz(), papers=versions))):
        remarks = all_said(write(put, tmp_path / f"{name}.xml"))
        assert [line for line in remarks if line.startswith(no_route)] == []


def test_a_file_that_many_sites_do_not_take_is_named(tmp_path: Path) -> None:
    def one(code: int) -> QuizPaper:
        sheet = make_sheet("q1", "Crank", "Find it. " * 12000, (SPEED,))
        question = QuizQuestion(f"e-{code}-q1", sheet, (SPEED,))
        return QuizPaper(str(code), "", "", (question,))

    put = Quiz("en", "", "Exam", [one(code) for code in range(20)])
    *_, remark = all_said(write(put, tmp_path / "quiz.xml"))
    assert remark == (
        "moodle-xml: the file has 2.18 MB, and many sites take no more than 2 MB in one upload - "
        "add --split 2 if yours refuses it"
    )
