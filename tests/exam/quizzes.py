"""The quiz of an exam's folder, and its papers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.exam.quiz.quiz import read_quiz
from kinegrade.language import Language


def quiz_of(folder: Path, language: Language | None = None, **options: Any) -> Quiz:
    return read_quiz(open_exam(folder), language, **options)


def papers(folder: Path, **options: Any) -> tuple[QuizPaper, ...]:
    return tuple(quiz_of(folder, **options).papers)
