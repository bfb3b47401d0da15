"""Messages about an exam folder that is missing, damaged or of an unknown format."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from kinegrade.errors import ExamError, FieldError, write_message

AS_GENERATED = "expected it as kinegrade generate wrote it"
REMEDY = "restore the exam folder as it was generated"


def explain_broken(where: Path | str, faults: Iterable[str]) -> ExamError:
    """The refusal of a file, or a line of it, with these faults; each says what was expected."""
    return ExamError(*(write_message(str(where), fault, do=REMEDY) for fault in faults))


def describe_damage(fault: Exception) -> str:
    """A fault of form, as `explain_broken` takes it."""
    return f"is broken ({fault}) - {AS_GENERATED}"


@contextmanager
def decoding(path: Path, where: str) -> Iterator[None]:
    """Raises ExamError if the part of a file that is decoded here, such as a line, is at fault."""
    try:
        yield
    except FieldError as fault:
        raise explain_broken(path, [f"{where}: {fault}"]) from fault
    except UnicodeDecodeError as fault:
        raise explain_unreadable(path, fault) from fault


def explain_unreadable(path: Path, fault: OSError | UnicodeDecodeError) -> ExamError:
    """The refusal of a file that cannot be read at all."""
    reason = fault.strerror if isinstance(fault, OSError) else "not UTF-8"
    return ExamError(
        f"{path}: cannot be read ({reason}) "
        "- expected an exam folder made by kinegrade generate - check the name"
    )
