"""Which column of Moodle's quiz responses is what: found by shape and order, because the names may
be in any language.

After the column of the grade, which ends in "/10.00", come one to three columns for each question -
its text, the response, the right answer - whichever the person who downloaded the file ticked, with
the same number.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.tables import Table
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Fault, Message, list_all, list_plainly

NOTHING = "-"  # what Moodle writes in an empty cell
_GRADE = re.compile(r".*/\s*\d+(?:[.,]\d+)?", re.DOTALL)
_NUMBERED = (re.compile(r"(.*?)\s*\d+"), re.compile(r"(.*\S)\s+\S+"))  # "Response 1", "Response ii"
_MOST_COLUMNS = 3
_LONGEST_NAME = 200  # characters, taken from the end, where the number is
_LONGEST_SHOWN = 60
_LETTER = re.compile(r"[^\W\d_]")
_RIGHT_ANSWER = {
    "right answer",
    "richtige antwort",
    "réponse correcte",
    "respuesta correcta",
    "标准答案",
    "正解",
}
_QUESTION = {"question", "frage", "pregunta", "题目", "問題"}
_ADVICE = Message("responses.download-report")


@dataclass(frozen=True, slots=True)
class QuestionColumns:
    """The columns of a question's response, and of its right answer and its text where they were
    downloaded.
    """

    response: int
    right_answer: int | None
    text: int | None = None


@dataclass(frozen=True, slots=True)
class MoodleColumns:
    """The columns of the grade and of the questions after it."""

    grade: int
    questions: tuple[QuestionColumns, ...]


def grade_columns(header: Sequence[str]) -> list[int]:
    """The columns of marks: one in a responses report, several in a grades report."""
    return [
        index for index, name in enumerate(header) if _GRADE.fullmatch(trim(name[-_LONGEST_NAME:]))
    ]


def columns_per_question(names: Sequence[str]) -> int | None:
    """How many columns each question has, judged by their names; None where these do not repeat.

    >>> columns_per_question(["Frage 1", "Antwort 1", "Frage 2", "Antwort 2"])
    2
    """
    for pattern in _NUMBERED:
        found = [pattern.fullmatch(_key(name)) for name in names]
        stems = [match[1] for match in found if match]
        if not names or len(stems) < len(names):
            continue
        width = stems.index(stems[0], 1) if stems[0] in stems[1:] else len(stems)
        if (
            width <= _MOST_COLUMNS
            and len(stems) % width == 0
            and stems == stems[:width] * (len(stems) // width)
        ):
            return width
    return None


def moodle_columns(table: Table) -> MoodleColumns:
    """The columns of a responses report. Raises TableError for another report, or one without
    responses.
    """
    grades = grade_columns(table.header)
    if len(grades) != 1:
        problem = Message("responses.grades-report") if grades else Message("responses.no-grades")
        raise TableError(Fault(table.file, problem, Message("responses.of-quiz"), _ADVICE))
    first = grades[0] + 1
    names = table.header[first:]
    width = columns_per_question(names)
    if width is None:
        shown = list_plainly(map(_shorten, names[:6])) if names else Message("responses.nothing")
        problem = Message("responses.after-grade", columns=shown)
        raise TableError(Fault(table.file, problem, Message("responses.numbered"), _ADVICE))
    starts = range(first, len(table.header), width)
    response = _response(table, names[:width], starts)
    right = response + 1 if response + 1 < width else None
    return MoodleColumns(
        grades[0],
        tuple(
            QuestionColumns(
                start + response,
                None if right is None else start + right,
                start if response else None,
            )
            for start in starts
        ),
    )


def _response(table: Table, names: Sequence[str], starts: Iterable[int]) -> int:
    """Which of a question's columns is the response: the text comes before it, the right answer
    after it.
    """
    stems = [_stem(name) for name in names]
    missing = (len(names) == 1 and stems[0] in _RIGHT_ANSWER | _QUESTION) or (
        len(names) == 2 and stems[0] in _QUESTION and stems[1] in _RIGHT_ANSWER
    )
    if missing:
        problem = Message("responses.no-responses", columns=list_all(map(_shorten, names)))
        expected = Message("responses.column-of-responses")
        raise TableError(Fault(table.file, problem, expected, _ADVICE))
    if len(names) == 2 and stems[1] not in _RIGHT_ANSWER:
        first, second = (_letters(table, [start + place for start in starts]) for place in (0, 1))
        return 1 if stems[0] in _QUESTION or first > 2 * second else 0
    return 1 if len(names) == _MOST_COLUMNS else 0


def _shorten(name: str) -> str:
    return show_in_one_line(name[:_LONGEST_SHOWN])


def _stem(name: str) -> str:
    found = _NUMBERED[0].fullmatch(_key(name))
    return found[1] if found else _key(name)


def _key(name: str) -> str:
    return make_header_key(name[-_LONGEST_NAME:])


def _letters(table: Table, columns: Sequence[int]) -> int:
    """How many letters these columns contain: the texts of questions have many, answers few."""
    return sum(len(_LETTER.findall(row.cell(index))) for row in table.rows for index in columns)
