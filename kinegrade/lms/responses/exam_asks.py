"""What an exam asks and whom, as far as responses have to be assigned: read from exam.json
alone.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from kinegrade.errors import ExamError

BROKEN = (KeyError, TypeError, ValueError, AttributeError, RecursionError)
MENDING = "expected it as kinegrade generate wrote it - restore the exam folder"


@dataclass(frozen=True, slots=True)
class Person:
    """A student of the exam; `email` is "" where none is known."""

    student: str
    email: str


@dataclass(frozen=True)
class ExamAsks:
    """The answer columns of each question in the exam's order, like q1.v_B, with their units, and
    the students.
    """

    questions: Mapping[str, tuple[str, ...]]
    students: tuple[Person, ...]
    units: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def columns(self) -> tuple[str, ...]:
        """The answer columns of all questions."""
        return tuple(column for columns in self.questions.values() for column in columns)

    @property
    def summary(self) -> str:
        """The exam's questions in a few words, for messages."""
        counts = ", ".join(
            f"{question}: {len(columns)}" for question, columns in self.questions.items()
        )
        return f"{len(self.columns)} asks in {len(self.questions)} questions ({counts})"


def read_exam_asks(folder: Path) -> ExamAsks:
    """The asks and students of an exam folder. Raises ExamError."""
    path = folder / "exam.json"
    try:
        exam = json.loads(path.read_text(encoding="utf-8"))
        questions = {
            str(question["question"]): _columns(question) for question in exam["questions"]
        }
        students = tuple(
            Person(str(entry["student"]), str(entry.get("email", ""))) for entry in exam["students"]
        )
        units = {
            f"{question['question']}.{ask['ask']}": str(ask.get("unit", ""))
            for question in exam["questions"]
            for ask in question["asks"]
        }
    except OSError as fault:
        raise ExamError(
            f"{path}: cannot be read ({fault.strerror}) - expected an exam folder made by "
            "kinegrade generate - check the name"
        ) from fault
    except BROKEN as fault:
        raise ExamError(
            f"{path}: is broken ({type(fault).__name__}: {fault}) - {MENDING}"
        ) from fault
    return ExamAsks(questions, students, units)


def _columns(question: Mapping[str, Any]) -> tuple[str, ...]:
    return tuple(f"{question['question']}.{ask['ask']}" for ask in question["asks"])
