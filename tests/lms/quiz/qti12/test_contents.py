"""Texts, figures, solutions and variants in a package for Canvas."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path
from xml.etree.ElementTree import fromstring

import pytest

from kinegrade.errors import ExportError
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.lms.quiz.qti12.package import write
from tests.golden_files import Hold
from tests.lms.quiz import a_quiz
from tests.lms.quiz.packages import bare, files_of, listing
from tests.lms.quiz.qti12.package import items, quizzes
from tests.said import all_said


def test_texts_are_text_and_figures_are_files_of_the_package(package: Path) -> None:
    files = files_of(package)
    item = items(package)["exam-P1-q1-v_B"]
    shown = fromstring(f"<div>{item.findtext('.//mattext')}</div>")
    assert "<script>alert(1)</script>" in "".join(shown.itertext())
    assert {node.tag for node in shown.iter()} <= {
        "div",
        "p",
        "strong",
        "ol",
        "li",
        "img",
        "sup",
        "details",
        "summary",
    }
    picture = shown.find(".//img")
    assert picture is not None
    assert picture.get("src", "").removeprefix("$IMS-CC-FILEBASE$/") in files
    assert picture.get("alt") == "q1 in words & numbers"
    assert (
        bare(files["exam-P1-q1-v_B-paper/assessment_meta.xml"]).findtext("points_possible")
        == "13.5"
    )


def test_the_manifest_names_every_file_and_nothing_else(package: Path) -> None:
    files = files_of(package)
    named = re.findall(r'<file href="([^"]*)"', files["imsmanifest.xml"])
    assert sorted(named) == sorted(set(files) - {"imsmanifest.xml"})
    root = bare(files["imsmanifest.xml"])
    known = {node.get("identifier") for node in root.iter("resource")}
    assert len(known) == len(list(root.iter("resource")))
    assert {node.get("identifierref") for node in root.iter("dependency")} <= known


def test_the_solution_comes_once_with_the_last_ask_and_with_every_pooled_one(
    package: Path, tmp_path: Path
) -> None:
    solved = [
        name for name, item in items(package).items() if item.find("itemfeedback") is not None
    ]
    assert solved == ["exam-P1-q1-v_E"]
    write(a_quiz.pooled(), tmp_path / "pool.zip")
    solved = [
        name
        for name, item in items(tmp_path / "pool.zip").items()
        if item.find("itemfeedback") is not None
    ]
    assert solved == [f"exam-P1-q1-{name}" for name in ("v_B", "a_C", "v_D", "v_E")]


def test_pooled_questions_are_drawn_one_variant_for_every_ask(tmp_path: Path) -> None:
    complaints = all_said(write(a_quiz.pooled(), tmp_path / "pool.zip"))
    (quiz,) = quizzes(tmp_path / "pool.zip")
    groups = {group.get("title", ""): group for group in quiz.findall("assessment/section/section")}
    assert [len(group.findall("item")) for group in groups.values()] == [2, 2, 2, 2, 1, 1, 1]
    for group in groups.values():
        assert group.findtext("selection_ordering/selection/selection_number") == "1"
        worth = {
            entry.text
            for item in group.findall("item")
            for entry in item.iter("fieldentry")
            if re.fullmatch(r"[0-9.]+", entry.text or "")
        }
        assert worth == {group.findtext(".//points_per_item")}
    assert any(
        line.startswith("qti12: Canvas draws every question by itself") for line in complaints
    ), complaints


def test_variants_of_different_worth_are_refused(tmp_path: Path) -> None:
    dearer = a_quiz.alter(a_quiz.SPEED, points=Fraction(3))
    papers = [
        QuizPaper(code, "", "", (a_quiz.question(code, "q1", (ask,)),))
        for code, ask in (("P1", a_quiz.SPEED), ("P2", dearer))
    ]
    with pytest.raises(ExportError) as refusal:
        write(Quiz("en", "", "Test", papers), tmp_path / "pool.zip")
    assert refusal.value.problems == (
        "exam-P2-q1-v_B: is worth 3 points, and the first variant 5/2 - expected the same for "
        "all variants of an ask - fix the points in the bank",
    )


def test_what_was_left_out_and_what_is_to_be_done_is_said(tmp_path: Path) -> None:
    assert all_said(write(a_quiz.quiz(), tmp_path / "quiz.zip")) == [
        "qti12: Canvas gives a number all points or none - credit and comments for known "
        "mistakes were left out - give them with kinegrade grade, from the students' responses",
        "qti12: Canvas keeps four decimals - q2.v_F is asked for in mm/s instead of m/s, in the "
        "whole class, because that is too coarse for some answers",
        "qti12: every paper is a quiz of its own, which no student sees until it is assigned - "
        "assign each quiz to its students, and to no others, before you publish it",
    ]
    assert "CORIOLIS" not in listing(tmp_path / "quiz.zip").upper()


def test_texts_that_cannot_be_shown_are_refused_once_for_all_asks(tmp_path: Path) -> None:
    broken = a_quiz.question(
        "P", "q1", (a_quiz.SPEED, a_quiz.ZERO), statement="see [here](x) and $\\foo$"
    )
    with pytest.raises(ExportError) as refusal:
        write(Quiz("en", "", "Test", [QuizPaper("P", "1", "Bo", (broken,))]), tmp_path / "quiz.zip")
    assert [problem.split(" - ")[0] for problem in refusal.value.problems] == [
        "q1, statement: a link cannot be printed",
        "q1, statement: formula $\\foo$: unknown command \\foo",
    ]


@pytest.mark.parametrize("form", ["quiz", "pooled"])
def test_the_package_for_canvas(form: str, hold: Hold, tmp_path: Path) -> None:
    write(getattr(a_quiz, form)("zh" if form == "pooled" else "en"), tmp_path / "quiz.zip")
    hold(f"lms/quiz-qti12-{form}.txt", listing(tmp_path / "quiz.zip"))
