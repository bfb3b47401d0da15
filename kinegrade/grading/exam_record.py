"""What reports and feedback tell about an exam: its title, who had which paper, and what was right
on it.

`read_exam_record` reads exam.json; `PaperRecords` finds single lines of key.jsonl, so that a class
of any size needs memory for one paper. Marks are not decided here: that is `exam_folder` and
`judge`.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import nan
from pathlib import Path
from typing import Any

from kinegrade.errors import ExamError
from kinegrade.exact.written import written_number, written_text
from kinegrade.exam.folder.keys import rule
from kinegrade.exam.roster import file_names
from kinegrade.grading.key_lines import KeyLines
from kinegrade.grading.pool import Put
from kinegrade.language import Language, exam_language_of

_MENDING = "expected it as kinegrade generate wrote it - restore the exam folder"
_BROKEN = (KeyError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError)


@dataclass(frozen=True, slots=True)
class Sitter:
    """A student of the exam: the paper's code, the version where there are versions, the stem of
    all own files.
    """

    student: str
    name: str
    email: str
    code: str
    version: str
    stem: str


@dataclass(frozen=True)
class ExamRecord:
    """The head of an exam; `language` is that of its papers, `students` in the order of the roster.

    With `solutions` the bank wants feedback to hold the worked solutions.
    """

    title: str
    course: str
    date: str
    language: Language
    questions: tuple[str, ...]
    versions: tuple[str, ...]
    students: Mapping[str, Sitter]
    solutions: bool = False


@dataclass(frozen=True, slots=True)
class RightAnswer:
    """What was right: `exact` as an expression where it has one; `allowed` is how far off was right
    by the paper.
    """

    value: Fraction
    exact: str | None
    unit: str
    allowed: Fraction


@dataclass(frozen=True)
class PaperRecord:
    """One paper: the questions as printed, right answers by column, drawn numbers by question and
    parameter.

    A number is NaN where the question's asks were put with different ones.
    """

    printed: tuple[str, ...]
    answers: Mapping[str, RightAnswer]
    parameters: Mapping[tuple[str, str], float]


def read_exam_record(folder: Path) -> ExamRecord:
    """The head of an exam folder. Raises ExamError."""
    path = folder / "exam.json"
    try:
        exam = json.loads(path.read_text(encoding="utf-8"))
        stems = file_names(entry["student"] for entry in exam["students"])
        students = {
            entry["student"]: _sitter(entry, stems[entry["student"]]) for entry in exam["students"]
        }
        questions = tuple(str(question["question"]) for question in exam["questions"])
    except OSError as fault:
        raise _missing(path, fault) from fault
    except _BROKEN as fault:
        raise ExamError(
            f"{path}: is broken ({type(fault).__name__}: {fault}) - {_MENDING}"
        ) from fault
    texts = {name: str(exam.get(name, "")) for name in ("title", "course", "date")}
    return ExamRecord(
        **texts,
        language=exam_language_of(exam, path),
        questions=questions,
        versions=tuple(exam.get("versions", ())),
        students=students,
        solutions=exam.get("solutions") is True,
    )


def _sitter(entry: Mapping[str, Any], stem: str) -> Sitter:
    return Sitter(
        written_text(entry["student"]),
        written_text(entry["name"]),
        written_text(entry.get("email", "")),
        written_text(entry.get("paper", "")),
        written_text(entry.get("version", "")),
        stem,
    )


class PaperRecords:
    """The lines of key.jsonl by student, each read when it is wanted.

    `put` says which answers were marked by other lines than the student's own, where questions came
    from a pool.
    """

    def __init__(self, folder: Path, put: Put | None = None) -> None:
        """Finds where the line of each student begins. Raises ExamError."""
        self._put = put or {}
        self._path = folder / "key.jsonl"
        try:
            self._lines = KeyLines(self._path)
        except OSError as fault:
            raise _missing(self._path, fault) from fault
        except _BROKEN as fault:
            raise ExamError(
                f"{self._path}: is broken ({type(fault).__name__}: {fault}) - {_MENDING}"
            ) from fault

    def paper(self, student: str) -> PaperRecord:
        """The paper of a student. Raises ExamError where the exam has none of that student's."""
        if student not in self._lines:
            raise ExamError(
                f'{self._path}: no paper of student "{student}" - expected one for everybody who '
                "is marked "
                "- name the exam folder by which these marks were made"
            )
        try:
            return _paper(self._lines.paper(student, written_number))
        except _BROKEN as fault:
            raise ExamError(
                f'{self._path}: the paper of student "{student}" is broken '
                f"({type(fault).__name__}: "
                f"{fault}) - {_MENDING}"
            ) from fault

    def marked(self, student: str, columns: Iterable[str]) -> PaperRecord:
        """The paper of a student whose answers stand in these columns. Raises ExamError where it
        does not ask them.
        """
        paper = self._as_put(self.paper(student), self._put.get(student, {}))
        unknown = next((column for column in columns if column not in paper.answers), None)
        if unknown is not None:
            raise ExamError(
                f'{self._path}: the paper of student "{student}" does not ask {unknown}, which was '
                "marked "
                "- expected the marks of this exam - name the exam folder by which they were made"
            )
        return paper

    def _as_put(self, own: PaperRecord, put: Mapping[str, str]) -> PaperRecord:
        """The paper with those answers, and the numbers of their questions, that were put to the
        student.

        A question whose asks come from several variants has several numbers for each parameter, so
        it has none.
        """
        answers, parameters = dict(own.answers), dict(own.parameters)
        sources: dict[str, set[str]] = {}
        for column, source in put.items():
            other = self.paper(source)
            if column in other.answers:
                answers[column] = other.answers[column]
            question = column.partition(".")[0]
            sources.setdefault(question, set()).add(source)
            parameters |= {
                place: number if len(sources[question]) == 1 else nan
                for place, number in other.parameters.items()
                if place[0] == question
            }
        return PaperRecord(own.printed, answers, parameters)


def _paper(record: Mapping[str, Any]) -> PaperRecord:
    questions = record["questions"]
    identifiers = tuple(question["question"] for question in questions)
    answers = {
        f"{question['question']}.{name}": _right_answer(entry)
        for question in questions
        for name, entry in question["asks"].items()
    }
    parameters = {
        (question["question"], name): float(written_number(entry["value"]))
        for question in questions
        for name, entry in question.get("parameters", {}).items()
    }
    return PaperRecord(tuple(record.get("printed", identifiers)), answers, parameters)


def _right_answer(entry: Mapping[str, Any]) -> RightAnswer:
    value = written_number(entry["decimal"] if "decimal" in entry else entry["value"])
    tolerance = entry["tolerance"]
    stated = rule(
        written_number(tolerance["relative"]),
        written_number(tolerance["absolute"]),
        tolerance.get("figures"),
    )
    low, high = stated.key(value).interval
    exact = None if entry.get("exact") is None else written_text(entry["exact"])
    return RightAnswer(value, exact, written_text(entry["unit"]), max(value - low, high - value))


def _missing(path: Path, fault: OSError) -> ExamError:
    return ExamError(
        f"{path}: cannot be read ({fault.strerror}) - expected an exam folder made by kinegrade "
        "generate - check the name"
    )
