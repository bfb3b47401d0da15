"""The error for a key that contradicts what is derived again from its folder."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from kinegrade.errors import ExamError, Problem
from kinegrade.language.message import Fault, Message, Part, Quoted, Text, list_plainly

_EXPECTED = Message("exam.both-to-agree")
_REMEDY = Message("exam.restore-or-version")


def explain_contradiction(where: Text, differences: Iterable[Problem]) -> ExamError:
    """The refusal to derive anything that differs from the key in these ways."""
    return ExamError(*(Fault(where, each, _EXPECTED, _REMEDY) for each in differences))


def describe_difference(name: str, found: str, derived: str) -> Message:
    """The difference between a value that the key states and the one derived."""
    return Message("exam.value-differs", name=name, found=found, derived=derived)


def list_names(names: Iterable[str]) -> Part:
    """Names as differences state them: those that are not empty, or that there are none."""
    known = list(filter(None, names))
    return list_plainly(known) if known else Message("grammar.no-names")


def name_place(key: Path, student: str, question: str = "") -> Message:
    """The paper of a student in a key, or a question of it, as the place of a contradiction."""
    whose = Quoted(student)
    place = Message("exam.student", student=whose)
    if question:
        place = Message("exam.student-question", student=whose, question=question)
    return Message("exam.at", file=str(key), place=place)
