"""Numbers and their tolerances in a package for Canvas: nothing that is right is lost."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExportError
from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizPaper
from kinegrade.lms.quiz.qti12.package import write
from tests.lms.quiz import a_quiz
from tests.lms.quiz.packages import bare, files_of, listing, misplaced
from tests.lms.quiz.qti12.package import (
    ATTRIBUTES,
    EXACT,
    MODELS,
    intervals,
    items,
    one_ask,
    quizzes,
)
from tests.said import all_said


@pytest.mark.parametrize(
    "quiz", [a_quiz.quiz("en"), a_quiz.quiz("zh"), a_quiz.pooled("en"), a_quiz.pooled("zh")]
)
def test_every_element_stands_where_the_standard_lets_it(quiz: Quiz, tmp_path: Path) -> None:
    write(quiz, tmp_path / "quiz.zip")
    assert [
        fault
        for root in quizzes(tmp_path / "quiz.zip")
        for fault in misplaced(root, MODELS, ATTRIBUTES)
    ] == []


def test_every_number_that_a_double_holds_is_the_exams(package: Path) -> None:
    asks, found = a_quiz.all_asks(), items(package)
    for name in EXACT:
        ask = asks[name]
        value, low, high = intervals(found[f"exam-P1-{'q2' if name == 'phi' else 'q1'}-{name}"])[0]
        assert high == ask.high
        assert abs(low - (ask.low if value is None else lowered(ask))) < abs(high) / 10**16
        assert value == (None if name == "v_E" else ask.value)


@pytest.mark.parametrize(("place", "name"), [("q1", "v_B"), ("q2", "k")])
def test_numbers_without_end_lose_nothing_that_is_right_and_less_than_a_double_can_tell(
    package: Path, place: str, name: str
) -> None:
    ask = a_quiz.all_asks()[name]
    ((value, low, high),) = intervals(items(package)[f"exam-P1-{place}-{name}"])
    assert value is not None
    for read, meant in ((value, ask.value), (low, lowered(ask)), (high, ask.high)):
        assert abs(read - meant) < abs(meant) / 10**16
    assert low <= ask.low <= ask.high <= high


def test_margins_are_even_wherever_an_exact_answer_stands(package: Path) -> None:
    """Classic takes the upper margin, New Quizzes the lower one, which is a hair wider."""
    for item in items(package).values():
        for value, low, high in intervals(item):
            size = max(abs(low), abs(high))
            assert value is None or 0 < (value - low) - (high - value) < size / 10**11


def lowered(ask: QuizAsk) -> Fraction:
    """The lower bound that stands beside an exact answer: a hair lower than the exam's."""
    return ask.low - max(abs(ask.low), abs(ask.high)) / 10**12


def right_in_new_quizzes(read: tuple[Fraction | None, Fraction, Fraction], typed: Fraction) -> bool:
    """As New Quizzes mark: with a margin that is the answer less the lower bound, all in
    doubles.
    """
    value, low, high = read
    if value is None:
        return float(low) <= float(typed) <= float(high)
    return abs(float(typed) - float(value)) <= float(value) - float(low)


def right_in_classic_quizzes(
    read: tuple[Fraction | None, Fraction, Fraction], typed: Fraction
) -> bool:
    """As Classic Quizzes mark: four decimals of what was typed, and the margin above, in exact
    decimals.
    """
    value, low, high = read
    kept = round(typed, 4)
    return low <= kept <= high if value is None else abs(kept - value) <= high - value


@given(st.integers(100, 10**7), st.integers(1, 5))
def test_no_edge_of_a_tolerance_is_lost_in_either_of_canvas_quizzes(
    digits: int, percent: int
) -> None:
    value = Fraction(digits, 100)
    ask = a_quiz.relative("v_B", value, Fraction(percent, 100))
    with TemporaryDirectory() as folder:
        write(one_ask(ask), Path(folder) / "quiz.zip")
        (read,) = intervals(items(Path(folder) / "quiz.zip")["exam-P-q1-v_B"])
    for right in (right_in_new_quizzes, right_in_classic_quizzes):
        assert right(read, ask.low)
        assert right(read, ask.high)
        assert not right(read, ask.low - Fraction(1, 10**4))
        assert not right(read, ask.high + Fraction(1, 10**4))


def test_own_papers_are_hidden_until_they_are_assigned_and_pools_are_not(
    package: Path, tmp_path: Path
) -> None:
    write(a_quiz.pooled(), tmp_path / "pool.zip")
    for place, hidden in ((package, "true"), (tmp_path / "pool.zip", "false")):
        metas = [text for name, text in files_of(place).items() if name.endswith("_meta.xml")]
        assert metas
        assert {bare(text).findtext("only_visible_to_overrides") for text in metas} == {hidden}


def test_no_bound_reads_as_a_precision_answer(package: Path) -> None:
    assert "<vargt " not in listing(package)


def test_an_angle_is_right_with_whole_turns_added(package: Path) -> None:
    found = intervals(items(package)["exam-P1-q2-phi"])
    assert [(value, round(high - low, 6)) for value, low, high in found] == [
        (30, 1),
        (-330, 1),
        (390, 1),
        (-690, 1),
    ]


def test_an_answer_too_small_for_four_decimals_is_asked_for_in_a_finer_unit(package: Path) -> None:
    item = items(package)["exam-P1-q2-v_F"]
    ask = replace(a_quiz.TINY, low=Fraction("4.2075"), high=Fraction("4.2925"))
    assert intervals(item) == [(Fraction("4.25"), lowered(ask), ask.high)]
    text = item.findtext(".//mattext") or ""
    assert "? mm/s (2 points)" in text
    assert "Mind the unit: mm/s here, not m/s." in text


@pytest.mark.parametrize(
    ("unit", "value", "finer", "factor"),
    [
        ("m", "0.0021", "mm", 1000),
        ("cm", "0.0011", "mm", 10),
        ("km", "0.0000020", "mm", 10**6),
        ("m/s^2", "0.0008", "mm/s^2", 1000),
    ],
)
def test_units_change_by_whole_powers_of_ten(
    unit: str, value: str, finer: str, factor: int, tmp_path: Path
) -> None:
    ask = a_quiz.relative("x", Fraction(value), unit=unit)
    write(one_ask(ask), tmp_path / "quiz.zip")
    ((found, low, high),) = intervals(items(tmp_path / "quiz.zip")["exam-P-q1-x"])
    assert (found, low, high) == (ask.value * factor, lowered(ask) * factor, ask.high * factor)
    shown, meant = (one.replace("^2", "&lt;sup&gt;2&lt;/sup&gt;") for one in (finer, unit))
    text = listing(tmp_path / "quiz.zip")
    assert f"? {shown} (2 points)" in text
    assert f"Mind the unit: {shown} here, not {meant}." in text


def test_an_answer_whose_unit_has_no_finer_one_is_refused_with_all_others(tmp_path: Path) -> None:
    area = a_quiz.alter(a_quiz.LOST, identifier="area", symbol="A", unit="m^2")
    questions = tuple(
        a_quiz.question("P", f"q{number}", (ask,))
        for number, ask in enumerate((a_quiz.LOST, area), 1)
    )
    quiz = Quiz("en", "", "Test", [QuizPaper("P", "1", "Bo", questions)])
    with pytest.raises(ExportError) as refusal:
        write(quiz, tmp_path / "quiz.zip")
    first, second = refusal.value.problems
    assert first == (
        "exam-P-q1: ω_AB = 0.00004 rad/s, right from 0.0000392 to 0.0000408, is no longer right "
        "with the "
        "four decimals that Canvas keeps - expected an answer that is - set the exam with lms = "
        '"canvas" in the bank, which refuses such draws, or allow a wider tolerance'
    )
    assert second.startswith("exam-P-q2: A = 0.00004 m^2, ")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("low", "high", "taken"),
    [
        ("0.2235", "0.2245", True),
        ("0.22435", "0.22455", True),
        ("0.2244", "0.2245", True),
        ("0.22441", "0.22456", True),
        ("0.22441", "0.22449", False),
    ],
)
def test_an_answer_is_taken_where_its_four_decimals_are_right(
    low: str, high: str, taken: bool, tmp_path: Path
) -> None:
    ask = replace(a_quiz.LOST, value=Fraction("0.224488"), low=Fraction(low), high=Fraction(high))
    if taken:
        write(one_ask(ask), tmp_path / "quiz.zip")
        assert f">{high}</varlte>" in listing(tmp_path / "quiz.zip")
    else:
        with pytest.raises(ExportError, match="is no longer right with the four decimals"):
            write(one_ask(ask), tmp_path / "quiz.zip")


def test_answers_that_may_be_lost_at_an_edge_are_named(tmp_path: Path) -> None:
    ask = a_quiz.relative("omega", Fraction("0.0055"), unit="rad/s", share=Fraction(1, 100))
    assert all_said(write(one_ask(ask), tmp_path / "quiz.zip"))[0] == (
        "qti12: Canvas keeps four decimals, too few for q1.omega on some papers: an answer near "
        "the limit of the tolerance may be marked the other way there - mark with kinegrade "
        "grade, from the students' responses"
    )


def test_hundreds_of_refusals_are_told_by_the_first_and_a_count(tmp_path: Path) -> None:
    papers = [
        QuizPaper(str(i), str(i), "", (a_quiz.question(str(i), "q1", (a_quiz.LOST,)),))
        for i in range(100)
    ]
    with pytest.raises(ExportError) as refusal:
        write(Quiz("en", "", "Test", papers), tmp_path / "quiz.zip")
    assert len(refusal.value.problems) == 41
    assert refusal.value.problems[-1] == "quiz: and 60 more"


def test_whole_numbers_may_be_asked_for_exactly(tmp_path: Path) -> None:
    write(
        one_ask(a_quiz.ask("n", Fraction(3), Fraction(3), Fraction(3), unit="1")),
        tmp_path / "quiz.zip",
    )
    assert intervals(items(tmp_path / "quiz.zip")["exam-P-q1-n"]) == [(3, 3, 3)]
