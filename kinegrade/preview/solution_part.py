"""The worked solution of the instance that is shown."""

from __future__ import annotations

from kinegrade.language import Language
from kinegrade.press.html.solution import WITH_PICTURES, write_blocks
from kinegrade.preview.instance import Instance
from kinegrade.preview.subject import Subject
from kinegrade.worked.solution import write_worked_solution


def write_solution(subject: Subject, language: Language) -> str:
    """The solution by the template's own method. Raises KinegradeError."""
    instance = Instance(subject.question)
    worked = write_worked_solution(instance.solution, instance.asks, language, None)
    return write_blocks(worked.blocks, language, WITH_PICTURES)
