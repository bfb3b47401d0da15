"""All files of a class, one after another: what `kinegrade grade EXAM a.csv b.csv` reads before
marking.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.answer_file import AnswerFile
from kinegrade.language.message import Fault, Message
from kinegrade.lms.responses.answer_table import Assumption, ReadingWishes, read_responses


@dataclass(frozen=True, slots=True)
class ClassFiles:
    """The answer sheets made from the files, and what was assumed, one line for each assumption."""

    files: tuple[AnswerFile, ...]
    assumed: tuple[Assumption, ...]


def read_class(paths: Sequence[Path], exam: ExamFolder, wishes: ReadingWishes) -> ClassFiles:
    """Reads the files of one class. Raises TableError, ExamError."""
    refuse_one_file_twice(paths)
    read = [
        read_responses(path, exam, wishes, name)
        for path, name in zip(paths, _told_apart(paths), strict=True)
    ]
    assumed = tuple(line for each in read for line in each.assumed)
    return ClassFiles(tuple(each.answers for each in read), assumed)


def refuse_one_file_twice(paths: Sequence[Path]) -> None:
    """Raises TableError where two paths lead to one file."""
    seen: set[Path] = set()
    for path in paths:
        if path.resolve() in seen:
            raise TableError(Fault(str(path), Message("responses.given-twice")))
        seen.add(path.resolve())


def _told_apart(paths: Sequence[Path]) -> tuple[str, ...]:
    """The names of files in messages: with their folders where two have the same name.

    >>> _told_apart([Path("a/x.csv"), Path("b/x.csv")])
    ('a/x.csv', 'b/x.csv')
    """
    names = tuple(path.name for path in paths)
    return names if len(set(names)) == len(names) else tuple(map(str, paths))
