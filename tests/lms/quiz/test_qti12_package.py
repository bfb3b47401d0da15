"""Packages: the same bytes from the same quiz, whole or not at all, names that any system takes."""

from __future__ import annotations

import re
import tracemalloc
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExportError, OutputError
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.lms.quiz.blackboard import file as blackboard
from kinegrade.lms.quiz.formats import Writer
from kinegrade.lms.quiz.packaging import make_stable_name
from kinegrade.lms.quiz.qti12 import package as qti12
from kinegrade.lms.quiz.qti21 import package as qti21
from tests.lms.quiz import a_quiz

WRITERS = (qti12.write, qti21.write, blackboard.write)


@pytest.mark.parametrize("write", WRITERS)
def test_the_same_quiz_gives_the_same_bytes(write: Writer, tmp_path: Path) -> None:
    for name in ("one.zip", "two.zip"):
        write(a_quiz.quiz(), tmp_path / name)
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()


@pytest.mark.parametrize("write", WRITERS)
def test_an_error_in_between_leaves_what_was_there(write: Writer, tmp_path: Path) -> None:
    (tmp_path / "quiz.zip").write_text("before")
    paper = a_quiz.papers()[0]
    with pytest.raises(
        ExportError,
        match='the name "[^"]*" stands for two things - expected one for each paper and '
        "question - set the exam again",
    ):
        write(Quiz("en", "", "Test", [paper, paper]), tmp_path / "quiz.zip", force=True)
    assert [path.name for path in tmp_path.iterdir()] == ["quiz.zip"]
    assert (tmp_path / "quiz.zip").read_text() == "before"


@pytest.mark.parametrize("write", WRITERS)
def test_a_place_that_cannot_be_written_is_named(write: Writer, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    with pytest.raises(
        OutputError,
        match="quiz.zip: cannot be written .* - expected a place with room and permission",
    ):
        write(a_quiz.quiz(), tmp_path / "file" / "quiz.zip")


@pytest.mark.parametrize("write", WRITERS)
def test_a_file_that_somebody_puts_there_meanwhile_is_not_replaced(
    write: Writer, tmp_path: Path
) -> None:
    target = tmp_path / "quiz.zip"

    def meddled() -> Iterator[QuizPaper]:
        yield from a_quiz.papers()
        target.write_text("theirs")

    with pytest.raises(OutputError, match="quiz.zip: already exists - expected a new name - add"):
        write(Quiz("en", "", "Test", meddled()), target)
    assert [(file.name, file.read_text()) for file in tmp_path.iterdir()] == [
        ("quiz.zip", "theirs")
    ]


@pytest.mark.parametrize("write", WRITERS)
def test_memory_does_not_grow_with_the_class(write: Writer, tmp_path: Path) -> None:
    def peak(count: int) -> int:
        questions = (a_quiz.question(f"P{i}", "q1", (a_quiz.SPEED,)) for i in range(count))
        papers = (
            QuizPaper(f"P{i}", str(i), "", (question,)) for i, question in enumerate(questions)
        )
        tracemalloc.reset_peak()
        write(Quiz("en", "", "Test", papers), tmp_path / "quiz.zip", force=True)
        return tracemalloc.get_traced_memory()[1]

    tracemalloc.start()
    try:
        peak(5)  # what is kept once: tables, caches
        few, lots = peak(5), peak(105)
    finally:
        tracemalloc.stop()
    assert lots - few < 100 * 4000  # a paper weighs more; the zip's own directory is what stays


@given(st.text(max_size=120))
def test_any_identifier_becomes_a_name_and_different_ones_stay_different(text: str) -> None:
    name = make_stable_name(text)
    assert re.fullmatch(r"[A-Za-z][A-Za-z0-9_.-]{0,79}", name)
    assert ".." not in name
    assert make_stable_name(name) == name
    assert make_stable_name(f"{text} ") != name
