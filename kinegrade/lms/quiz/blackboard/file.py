"""Quizzes as the text files that Blackboard uploads: a line for every ask, number and tolerance, no
figures.

Blackboard takes up to 250 questions at a time. A target that ends in `.zip` holds a file for every
paper, or one for every ask with all its variants; any other target is one such file.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

from kinegrade.errors import Problem, TypesetError
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.files.output import output_file
from kinegrade.files.zip_package import Package, open_package
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.lms.quiz.blackboard.line import write_question_line
from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.packaging import make_stable_name
from kinegrade.lms.quiz.remarks import Remarks

_MOST = 250  # questions in one upload to Ultra; Original takes 500
_PRINTED = Message("quiz-file.no-figures")
_DRAWN = Message("quiz-file.no-figures-of-variants")
_FOR_ONE = Message("quiz-file.blackboard-for-one")


def write(quiz: Quiz, target: Path, *, force: bool = False) -> list[Problem]:
    """Writes the file, with `force` over an existing plain file; gives what the instructor should
    know about it, one line for each point.

    Raises ExportError with everything that the format cannot express, OutputError; `target` is then
    unchanged.
    """
    writer = _Writer(quiz)
    if target.suffix.lower() == ".zip":
        with open_package(target, force=force) as parts:
            writer.write_files(parts)
            return writer.complaints()
    with output_file(target, force=force) as partial:
        writer.write_one(partial, target)
        return writer.complaints()


class _Writer:
    """The state while papers are written one after another."""

    def __init__(self, quiz: Quiz) -> None:
        self._quiz, self._remarks = quiz, Remarks()
        self._points: dict[str, Fraction] = {}

    def complaints(self) -> list[Problem]:
        """What was left out. Raises ExportError with all faults."""
        self._remarks.raise_faults()
        listed = list_plainly(
            f"{column} {write_decimal(points)}" for column, points in self._points.items()
        )
        self._remarks.complain(Message("quiz-file.points", points=listed))
        return self._remarks.complaints

    def write_one(self, place: Path, target: Path) -> None:
        """All lines in one file."""
        count = owned = 0
        with place.open("x", encoding="utf-8", newline="\n") as stream:
            for paper in self._quiz.papers:
                owned += _is_owned(paper)
                for _, line in self._lines(paper):
                    count += 1
                    if count <= _MOST:
                        stream.write(f"{line}\n")
        if owned:
            several = Message("quiz-file.blackboard-together", papers=owned)
            self._remarks.complain(several if owned > 1 else _FOR_ONE)
        if count > _MOST:
            self._remarks.refuse(
                Fault(str(target), Message("quiz-file.too-many", number=count, most=_MOST))
            )

    def write_files(self, parts: Package) -> None:
        """A file for every paper, and for every ask of pooled questions."""
        pools: dict[str, list[str]] = {}
        written: dict[str, int] = {}
        for paper in self._quiz.papers:
            if _is_owned(paper):
                self._remarks.complain(_FOR_ONE)
                name = make_stable_name(
                    "-".join(filter(None, ("paper", paper.code, paper.student)))
                )
                _add_files(parts, name, [line for _, line in self._lines(paper)], 0)
                continue
            for column, line in self._lines(paper):
                pools.setdefault(column, []).append(line)
                if len(pools[column]) == _MOST:
                    written[column] = _add_files(
                        parts, make_stable_name(column), pools.pop(column), written.get(column, 0)
                    )
        for column, lines in pools.items():
            _add_files(parts, make_stable_name(column), lines, written.get(column, 0))

    def _lines(self, paper: QuizPaper) -> Iterator[tuple[str, str]]:
        """The asks of a paper, each with its column and its line."""
        owned, language = _is_owned(paper), self._quiz.language_of(paper)
        code = paper.code if owned else ""
        for question in paper.questions:
            if question.sheet.figure is not None:
                self._remarks.complain(_PRINTED if owned else _DRAWN)
            if question.solution.parts or any(ask.mistakes for ask in question.asks):
                self._remarks.complain(Message("quiz-file.left-out"))
            for ask in question.asks:
                column = f"{question.sheet.identifier}.{ask.identifier}"
                self._points.setdefault(column, ask.row.points)
                try:
                    yield (
                        column,
                        write_question_line(question, ask, language, self._remarks, code),
                    )
                except TypesetError as fault:
                    self._remarks.refuse_texts(fault)


def _is_owned(paper: QuizPaper) -> bool:
    """Whether it is printed for a student or as a version, and not pooled."""
    return bool(paper.student or paper.name)


def _add_files(parts: Package, name: str, lines: list[str], before: int) -> int:
    """Writes lines into files that Blackboard takes, numbered on from those before; gives how many
    there are now.
    """
    for start in range(0, len(lines), _MOST):
        before += 1
        suffix = f"-{before}" if before > 1 else ""
        parts.add(
            f"{name}{suffix}.txt",
            "".join(f"{line}\n" for line in lines[start : start + _MOST]).encode(),
        )
    return before
