"""Blackboard's text files: a line for an ask, nothing in it that breaks the line, numbers that are
the exam's.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import ExportError
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.lms.quiz.blackboard.file import write
from tests.golden_files import Hold
from tests.lms.quiz import a_quiz
from tests.lms.quiz.packages import files_of, listing
from tests.said import all_said

DOUBLE = ("a_C", "v_D", "v_E", "phi", "v_F")  # whose numbers a double holds with all their digits


def lines(place: Path) -> list[list[str]]:
    """The fields of the lines of a file."""
    text = place.read_bytes().decode()
    assert text.endswith("\n")
    return [line.split("\t") for line in text.removesuffix("\n").split("\n")]


def one_ask(ask: a_quiz.QuizAsk, tmp_path: Path) -> tuple[list[str], list[str]]:
    """The fields of the line of an ask, and the complaints."""
    place = tmp_path / "quiz.txt"
    paper = QuizPaper("P", "1", "Bo", (a_quiz.question("P", "q1", (ask,)),))
    complaints = all_said(write(Quiz("en", "", "Test", [paper]), place))
    (found,) = lines(place)
    return found, complaints


def many(count: int) -> Quiz:
    """A pool of as many variants of one ask."""
    papers = (
        QuizPaper(f"P{i}", "", "", (a_quiz.question(f"P{i}", "q1", (a_quiz.SPEED,)),))
        for i in range(count)
    )
    return Quiz("en", "", "Test", papers)


def test_the_interval_of_every_ask_is_the_exams(tmp_path: Path) -> None:
    write(a_quiz.quiz(), tmp_path / "quiz.txt")
    found = lines(tmp_path / "quiz.txt")
    assert [len(fields) for fields in found] == [4] * 11
    assert {fields[0] for fields in found} == {"NUM"}
    for (name, ask), (_, _, value, tolerance) in zip(
        a_quiz.all_asks().items(), found, strict=False
    ):
        low, high = Fraction(value) - Fraction(tolerance), Fraction(value) + Fraction(tolerance)
        if name in DOUBLE:
            assert (low, high) == (ask.low, ask.high)
        else:
            assert low <= ask.low <= ask.high <= high
            assert abs(high - ask.high) + abs(low - ask.low) < abs(ask.value) / 10**15


def test_an_uneven_interval_stands_about_its_middle_and_that_is_said(tmp_path: Path) -> None:
    fields, complaints = one_ask(a_quiz.UNEVEN, tmp_path)
    assert fields[2:] == ["10.75", "1.75"]
    assert (
        "blackboard: q1.v_E is not in the middle of what counts as right - the middle is given "
        "there as the answer, so that the tolerance is exactly the exam's - tell the students the answer from the key"
    ) in complaints


def test_an_angle_is_asked_for_within_half_a_turn(tmp_path: Path) -> None:
    angle = replace(a_quiz.ANGLE, value=Fraction(350), low=Fraction(349), high=Fraction(351))
    fields, complaints = one_ask(angle, tmp_path)
    assert fields[2:] == ["-10", "1"]
    assert fields[1].endswith("φ = ?° Give the angle within half a turn of zero (−180° to 180°).")
    assert any(line.startswith("blackboard: q1.phi is an angle") for line in complaints), complaints


def test_a_number_without_tolerance_has_no_field_for_it(tmp_path: Path) -> None:
    fields, _ = one_ask(a_quiz.ask("n", Fraction(3), Fraction(3), Fraction(3)), tmp_path)
    assert fields[2:] == ["3"]


def test_no_text_breaks_its_line(tmp_path: Path) -> None:
    wild = a_quiz.alter(a_quiz.SPEED, meaning="a\tb $v$", sign="c\u2028d", symbol=r"v_{B}")
    fields, _ = one_ask(wild, tmp_path)
    assert len(fields) == 4
    assert fields[1].endswith("a b v (c d): v_B = ? m/s")


def test_the_figure_is_on_a_students_paper_but_pooled_questions_have_none(tmp_path: Path) -> None:
    fields, complaints = one_ask(a_quiz.SPEED, tmp_path)
    assert "(The figure is on your paper, at question 1.)" in fields[1]
    write(many(1), tmp_path / "pool.txt")
    assert "figure" not in (tmp_path / "pool.txt").read_text("utf-8")
    assert complaints[0].startswith("blackboard: its text upload has no figures")
    assert (
        complaints[-1] == "blackboard: its text upload has no points - set them there: q1.v_B 2.5"
    )


def test_every_line_says_whose_paper_it_is_of_and_so_do_the_complaints(tmp_path: Path) -> None:
    together = all_said(write(a_quiz.quiz(), tmp_path / "quiz.txt"))
    codes = [fields[1].split(" ")[0] for fields in lines(tmp_path / "quiz.txt")]
    assert codes == ["[P1]"] * 7 + ["[P2]"] * 4
    assert any("the questions of 2 papers stand in one file" in line for line in together), together
    apart = all_said(write(a_quiz.quiz(), tmp_path / "quiz.zip"))
    assert any("every paper is a file of its own" in line for line in apart), apart


def test_what_is_drawn_for_each_student_is_on_no_printed_paper(tmp_path: Path) -> None:
    complaints = all_said(write(many(2), tmp_path / "pool.txt"))
    assert "no printed paper has these numbers" in complaints[0]
    assert not any("hand out" in line or "[P" in line for line in complaints)
    assert not any("[P" in fields[1] for fields in lines(tmp_path / "pool.txt"))


def test_more_questions_than_blackboard_takes_are_refused(tmp_path: Path) -> None:
    write(many(250), tmp_path / "quiz.txt")
    with pytest.raises(ExportError) as refusal:
        write(many(251), tmp_path / "more.txt")
    assert refusal.value.problems == (
        f"{tmp_path / 'more.txt'}: would hold 251 questions - expected up to 250, the most that "
        "Blackboard takes at a "
        "time - write to a name that ends in .zip, which gives every paper its own file",
    )
    assert [path.name for path in tmp_path.iterdir()] == ["quiz.txt"]


def test_a_zip_holds_a_file_for_every_paper_or_parts_of_every_pool(tmp_path: Path) -> None:
    write(a_quiz.quiz(), tmp_path / "papers.zip")
    sizes = {name: text.count("\n") for name, text in files_of(tmp_path / "papers.zip").items()}
    assert sizes == {"paper-P1-0012345.txt": 7, "paper-P2-_1_1-259581b8b0.txt": 4}
    write(many(510), tmp_path / "pool.ZIP")
    sizes = {name: text.count("\n") for name, text in files_of(tmp_path / "pool.ZIP").items()}
    assert sizes == {"q1.v_B.txt": 250, "q1.v_B-2.txt": 250, "q1.v_B-3.txt": 10}


def test_texts_that_cannot_be_shown_are_refused(tmp_path: Path) -> None:
    broken = a_quiz.alter(a_quiz.SPEED, symbol=r"\foo")
    with pytest.raises(ExportError, match=r"q1: formula \$\\foo\$: unknown command \\foo"):
        one_ask(broken, tmp_path)


def test_the_files_for_blackboard(hold: Hold, tmp_path: Path) -> None:
    write(a_quiz.quiz("en"), tmp_path / "en.zip")
    write(a_quiz.pooled("zh"), tmp_path / "zh.zip")
    hold("lms/quiz-blackboard.txt", listing(tmp_path / "en.zip") + listing(tmp_path / "zh.zip"))
