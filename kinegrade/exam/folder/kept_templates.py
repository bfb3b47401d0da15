"""The templates of which an exam folder keeps copies, by question.

One that this version can no longer read stops whatever needs it; anything else only loses its
words.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import ExamError, Problem, TemplateError
from kinegrade.exam.folder.records import ExamQuestion
from kinegrade.language.message import Fault
from kinegrade.problem.template.library.library import load_kept_template
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class KeptTemplates:
    """The templates that can be read, by question, and what is wrong with the others."""

    readable: Mapping[str, Template]
    faults: tuple[Problem, ...]

    def all(self) -> Mapping[str, Template]:
        """The templates of all questions. Raises ExamError with the faults of those that cannot be
        read.
        """
        if self.faults:
            raise ExamError(*self.faults)
        return self.readable


def read_kept_templates(folder: Path, questions: Sequence[ExamQuestion]) -> KeptTemplates:
    """The templates of these questions, of which the folder holds the files."""
    readable: dict[str, Template] = {}
    faults: list[Problem] = []
    for each in questions:
        try:
            readable[each.question] = load_kept_template(each.template, folder)
        except TemplateError as error:
            faults += (Fault(str(folder.parent), each) for each in error.faults)
    return KeptTemplates(readable, tuple(faults))
