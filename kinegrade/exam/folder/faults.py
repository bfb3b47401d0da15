"""Messages about an exam folder that is missing, damaged or of an unknown format."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from kinegrade.errors import ExamError, FieldError, Problem
from kinegrade.language.message import Fault, Message, Quoted, Text

AS_GENERATED = Message("exam.as-generated")
REMEDY = Message("exam.restore")
EXAM_FOLDER = Message("exam.an-exam-folder")


def explain_broken(where: Path | Text, faults: Iterable[Problem]) -> ExamError:
    """The refusal of a file, or a line of it, with these faults; each says what was expected."""
    place = str(where) if isinstance(where, Path) else where
    return ExamError(*(Fault(place, fault, do=REMEDY) for fault in faults))


def describe_damage(fault: Exception) -> Fault:
    """A fault of form, as `explain_broken` takes it."""
    reason = fault.faults[0] if isinstance(fault, FieldError) else str(fault)
    return Fault("", Message("exam.broken", reason=reason), AS_GENERATED)


def name_line(number: int) -> Message:
    """A line of a file, as the place of a fault."""
    return Message("exam.line", number=number)


def name_paper(student: str) -> Message:
    """A student's paper, as the place of a fault."""
    return Message("exam.paper-of-student", student=Quoted(student))


def name_line_of(student: str) -> Message:
    """The line of a student, as the place of a fault."""
    return Message("exam.line-of-student", student=Quoted(student))


@contextmanager
def decoding(path: Path, where: Text) -> Iterator[None]:
    """Raises ExamError if the part of a file that is decoded here, such as a line, is at fault."""
    try:
        yield
    except FieldError as fault:
        raise explain_broken(path, [Fault(where, fault.faults[0])]) from fault
    except UnicodeDecodeError as fault:
        raise explain_unreadable(path, fault) from fault


def explain_unreadable(path: Path, fault: OSError | UnicodeDecodeError) -> ExamError:
    """The refusal of a file that cannot be read at all."""
    reason = str(fault.strerror) if isinstance(fault, OSError) else Message("exam.not-utf-8")
    what, do = Message("files.cannot-be-read", reason=reason), Message("files.check-the-name")
    return ExamError(Fault(str(path), what, EXAM_FOLDER, do))
