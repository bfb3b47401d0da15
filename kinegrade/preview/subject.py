"""What is previewed: the problems of a template's file or of a bank's, as exams would ask them."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from kinegrade.exam.bank.bank import read_blueprint
from kinegrade.exam.bank.blueprint import BankQuestion
from kinegrade.exam.printing.sample import make_sample_bank
from kinegrade.problem.template.library.library import load_template

# At the beginning of a line: only banks have it, and it is found while the rest cannot be read
_QUESTIONS = re.compile(rb"^\s*(\[\[\s*)?questions\b", re.MULTILINE)


@dataclass(frozen=True)
class Subject:
    """One problem of a file, with the label under which it is chosen."""

    label: str
    question: BankQuestion


def read_subjects(path: Path) -> tuple[Subject, ...]:
    """The problems of a file, each of a bank's candidates among them. Raises TemplateError or
    BankError with all faults of the file.
    """
    return _read_bank(path) if _is_bank(path) else (_read_template(path),)


def _is_bank(path: Path) -> bool:
    with suppress(OSError):  # its reader says what is wrong
        return _QUESTIONS.search(path.read_bytes()) is not None
    return False


def _read_template(path: Path) -> Subject:
    template = load_template(str(path))
    (question,) = make_sample_bank(template).questions
    return Subject(template.name, question)


def _read_bank(path: Path) -> tuple[Subject, ...]:
    return tuple(
        Subject(f"{slot.identifier}: {candidate.template.name}", candidate)
        for slot in read_blueprint(path).slots
        for candidate in slot.candidates
    )
