"""The files in which a quiz is written, by the names that `quiz --to` reads: a row each.

The command line offers these names and no others.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Protocol

from kinegrade.errors import ExportError, Problem
from kinegrade.exam.quiz.document import Quiz
from kinegrade.language.message import Message
from kinegrade.lms.quiz.blackboard import file as blackboard
from kinegrade.lms.quiz.moodle import file as moodle_xml
from kinegrade.lms.quiz.moodle.questions import Form
from kinegrade.lms.quiz.qti12 import package as qti12
from kinegrade.lms.quiz.qti21 import package as qti21


class Writer(Protocol):
    """Writes a quiz to a file, with `force` over an existing plain one, and gives what the
    instructor should know, one line for each point.

    It takes papers one after another, and writes the file whole or not at all.
    """

    def __call__(self, quiz: Quiz, target: Path, *, force: bool = False) -> list[Problem]: ...


@dataclass(frozen=True)
class FileWishes:
    """How a file is to be written: the form of its questions, and the size of its parts, None for
    one file.
    """

    form: Form = "cloze"
    megabytes: Fraction | None = None


@dataclass(frozen=True)
class QuizFormat:
    """One kind of file: what writes it as it is wished, and whether it may be split into parts."""

    writer: Callable[[FileWishes], Writer]
    splits: bool = False


def _always(writer: Writer) -> QuizFormat:
    """A file that is written in one way only."""
    return QuizFormat(lambda wishes: writer)


def _choose_moodle(wishes: FileWishes) -> Writer:
    if wishes.megabytes is None:
        return partial(moodle_xml.write, form=wishes.form)
    return partial(moodle_xml.write_parts, megabytes=wishes.megabytes, form=wishes.form)


FORMATS: Mapping[str, QuizFormat] = {
    "moodle-xml": QuizFormat(_choose_moodle, splits=True),
    "qti12": _always(qti12.write),
    "qti21": _always(qti21.write),
    "blackboard": _always(blackboard.write),
}


def choose_writer(name: str, wishes: FileWishes) -> Writer:
    """What writes a quiz in a format. Raises ExportError for parts of what cannot be split."""
    chosen = FORMATS[name]
    if wishes.megabytes is not None and not chosen.splits:
        raise ExportError(Message("terminal.no-split", system=name))
    return chosen.writer(wishes)
