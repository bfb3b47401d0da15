"""Every format in which a quiz can be written, by name: one function each, from a quiz and a file's
path to remarks.

A writer takes papers one after another, writes the file whole or not at all, and gives what the
instructor should know, one line for each point. A new system needs one more function, and its name
here.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from kinegrade.errors import Problem
from kinegrade.exam.quiz.document import Quiz
from kinegrade.lms.quiz.blackboard import file as blackboard
from kinegrade.lms.quiz.moodle import file as moodle_xml
from kinegrade.lms.quiz.qti12 import package as qti12
from kinegrade.lms.quiz.qti21 import package as qti21


class Writer(Protocol):
    """Writes a quiz to a file, with `force` over an existing plain one, and gives remarks."""

    def __call__(self, quiz: Quiz, target: Path, *, force: bool = False) -> list[Problem]: ...


WRITERS: Mapping[str, Writer] = {
    "moodle-xml": moodle_xml.write,
    "qti12": qti12.write,
    "qti21": qti21.write,
    "blackboard": blackboard.write,
}
