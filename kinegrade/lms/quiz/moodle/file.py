"""Questions for Moodle (Question bank > Import > Moodle XML format), one paper after another.

`moodle_xml_questions` writes them. Moodle's import adds questions and never replaces any.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain
from pathlib import Path

from kinegrade.errors import ExportError, Problem
from kinegrade.exam.quiz.document import Quiz, QuizPaper
from kinegrade.files.output import output_file, output_folder
from kinegrade.language.message import Message, list_plainly
from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.moodle.questions import (
    Form,
    Sheet,
    list_pool_marks,
    make_sheet,
    write_paper_questions,
)

_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n'
_FOOT = "</quiz>\n"
_MILLION = 10**6
# MB that a site takes in one upload by default; also far below what stops the import
_USUAL_LIMIT = 2
_PARTS = tuple(f"quiz-{number}.xml" for number in range(1, 10000))


def write(quiz: Quiz, target: Path, *, form: Form = "cloze", force: bool = False) -> list[Problem]:
    """Writes the questions of a quiz, with `force` over an existing plain file; gives what the
    instructor should know.

    Raises ExportError for a quiz without papers and for credits for which Moodle has no share,
    TypesetError for texts that cannot be shown, OutputError; `target` is then unchanged.
    """
    with (
        output_file(target, force=force) as partial,
        partial.open("x", encoding="utf-8", newline="\n") as stream,
    ):
        questions = _Questions(quiz, form)
        stream.write(_HEAD)
        stream.writelines(questions.papers())
        stream.write(_FOOT)
    size = target.stat().st_size
    remarks = questions.remarks()
    if size > _USUAL_LIMIT * _MILLION:
        remarks.append(Message("quiz-file.large", megabytes=_write_shown(size)))
    return remarks


def write_parts(
    quiz: Quiz, target: Path, megabytes: Fraction, *, form: Form = "cloze", force: bool = False
) -> list[Problem]:
    """The same as a folder of files quiz-1.xml, quiz-2.xml ..., each complete and of at most
    `megabytes` million bytes.

    With `force` a folder of such files is replaced. Raises ExportError also for a paper that alone
    takes more.
    """
    with output_folder(target, marker=_PARTS[0], contents=_PARTS, force=force) as folder:
        questions = _Questions(quiz, form)
        for number, part in enumerate(_write_parts(questions.papers(), megabytes)):
            (folder / _PARTS[number]).write_bytes(part)
    return questions.remarks()


def _write_parts(papers: Iterable[str], megabytes: Fraction) -> Iterator[bytes]:
    """Complete files, each of as many papers as fit."""
    frame = len(_HEAD) + len(_FOOT)
    most, size = megabytes * _MILLION - frame, 0
    waiting: list[bytes] = []
    for number, paper in enumerate(papers, start=1):
        written = paper.encode()
        if len(written) > most:
            raise ExportError(
                Message(
                    "quiz-file.too-large",
                    paper=number,
                    megabytes=_write_shown(len(written)),
                    most=_write_shown(most + frame),
                )
            )
        if size + len(written) > most:
            yield _write_file(waiting)
            waiting, size = [], 0
        waiting.append(written)
        size += len(written)
    if waiting:
        yield _write_file(waiting)


def _write_file(papers: Iterable[bytes]) -> bytes:
    return b"".join((_HEAD.encode(), *papers, _FOOT.encode()))


def _write_shown(size: Fraction | int) -> str:
    return f"{float(Fraction(size) / _MILLION):.3g}"


@dataclass
class _Questions:
    """The questions of a quiz, and what is noted of them while they are written."""

    quiz: Quiz
    form: Form
    scale: int = 1
    personal: bool = False  # whether any paper is a student's
    marks: dict[str, Fraction] = field(default_factory=dict)  # of the pools, by their names

    def papers(self) -> Iterator[str]:
        """The text of each paper. Raises what `write` does."""
        papers = iter(self.quiz.papers)
        first = next(papers, None)
        if first is None:
            raise ExportError(Message("quiz-file.no-paper"))
        quiz = self.quiz
        sheet = make_sheet(quiz.language, self.form, quiz.title, quiz.identifier, first)
        self.scale = sheet.scale
        for paper in chain([first], papers):
            self._look_at(paper, sheet)
            own = replace(sheet, language=quiz.language_of(paper))
            yield "".join(write_paper_questions(paper, own))

    def _look_at(self, paper: QuizPaper, sheet: Sheet) -> None:
        self.personal = self.personal or bool(paper.student)
        if not (paper.student or paper.name):
            for question in paper.questions:
                self.marks.update(list_pool_marks(question, sheet))

    def remarks(self) -> list[Problem]:
        """What is left for the instructor to do, once all is written."""
        found: list[Problem] = []
        if self.scale > 1:
            found.append(Message("quiz-file.scaled", scale=self.scale))
        if self.marks:
            marks = (f"{name} {write_decimal(mark)}" for name, mark in self.marks.items())
            found.append(Message("quiz-file.pools", marks=list_plainly(marks)))
        if self.personal:
            found.append(Message("quiz-file.no-route"))
        return found
