"""The responses of a Moodle quiz (Results > Responses > download), with headers in any language.

The asks of one mechanism are in one cell as parts of a Cloze question, or each in a question of its
own. Slots follow the order of the exam. A row of dashes is a student without an attempt.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.lms.responses.ask_headers import expect_exam
from kinegrade.lms.responses.cloze import Wording, part_count, parts, wording
from kinegrade.lms.responses.moodle_columns import (
    NOTHING,
    MoodleColumns,
    QuestionColumns,
    columns_per_question,
    grade_columns,
    moodle_columns,
)
from kinegrade.lms.responses.typed_rows import Attempts, NotTaken, TypedRow, TypedRows, whole

TITLE = Message("responses.moodle")
_NOT_GRADED = Message("marking.not-graded")
_STATE_COLUMNS = 4
_FROM_END = 2  # columns from the end of an attempt to its grade
_NAMES = 2  # the first two columns, by which no student is found


@dataclass(frozen=True, slots=True)
class _Slot:
    """A question of the quiz: the columns of response, right answer and text, its asks, and the
    words that separate them.
    """

    column: int
    right_answer: int | None
    text: int | None
    asks: tuple[str, ...]
    words: Wording | None


def recognises(header: Sequence[str]) -> bool:
    """Whether these are the columns of a Moodle quiz report, of responses or of grades."""
    grades = grade_columns(header)
    return len(grades) > 1 or (
        len(grades) == 1 and columns_per_question(header[grades[0] + 1 :]) is not None
    )


def read(table: Table, head: ExamHead, attempts: Attempts) -> TypedRows:
    """The responses of finished attempts, or of all. Raises TableError where questions and asks do
    not agree.
    """
    columns = moodle_columns(table)
    slots = _slots(table, columns, head)
    rows, complaints, not_taken = [], [], []
    for row in table.rows:
        if not any(trim(row.cell(index)) for index in range(_NAMES, columns.grade)):
            complaints.append(_averages(table, row, columns))
            continue
        reason = _not_taken(table, row, columns, attempts)
        if reason:
            not_taken.append(reason)
            continue
        responses, faults = _responses(table, row, slots)
        right, texts = _right(row, slots), _texts(row, slots)
        rows.append(
            TypedRow(row, responses, right=right, texts=texts, submitted=_find_end(row, columns))
        )
        complaints += faults
    assumed = tuple(
        Message("responses.column", columns=table.header[slot.column], asks=list_plainly(slot.asks))
        for slot in slots
    )
    return TypedRows(
        head.columns,
        frozenset(slot.column for slot in slots),
        tuple(rows),
        tuple(range(_NAMES, columns.grade)),
        complaints=tuple(complaints),
        assumed=assumed,
        not_taken=tuple(not_taken),
        drawn=tuple(slot.asks for slot in slots),
    )


def _find_end(row: Row, columns: MoodleColumns) -> str:
    """When an attempt was completed, "" where it is not: the duration alone stands between that and
    the grade.
    """
    place = columns.grade - _FROM_END
    cell = trim(row.cell(place)) if place >= _NAMES + 1 else ""
    return "" if cell == NOTHING else cell


def _averages(table: Table, row: Row, columns: MoodleColumns) -> Complaint:
    problem = Message("responses.averages")
    return Complaint(
        table.file, row.line, table.header[columns.grade], whole(row), problem, _NOT_GRADED
    )


def _not_taken(
    table: Table, row: Row, columns: MoodleColumns, attempts: Attempts
) -> NotTaken | None:
    """Why a row is left out, None where it is not."""
    if trim(row.cell(columns.grade)) != NOTHING:
        return None
    before = [trim(row.cell(index)) for index in range(_NAMES, columns.grade)]
    column = table.header[columns.grade]
    empty = all(_response(row, question) in ("", NOTHING) for question in columns.questions)
    if empty and before[-1] == NOTHING:
        # status, start, end and duration come before the grade; all are dashes where the student
        # has not begun
        if all(cell == NOTHING for cell in before[-_STATE_COLUMNS:]):
            problem = Message("responses.no-attempt")
            return NotTaken(row, column, problem, _NOT_GRADED, attempted=False)
        problem, done = _explain_not_submitted(before), Message("responses.close-attempt")
        return NotTaken(row, column, problem, done, attempted=True)
    if attempts == "finished":
        problem = Message("responses.unfinished")
        done = Message("responses.close-or-include")
        return NotTaken(row, column, problem, done, attempted=True)
    return None


def _explain_not_submitted(before: Sequence[str]) -> Message:
    """With the status, where the cells before the grade have it."""
    if len(before) < _STATE_COLUMNS:
        return Message("responses.not-submitted")
    state = Quoted(shorten(before[-_STATE_COLUMNS]))
    return Message("responses.not-submitted-but", state=state)


def _response(row: Row, question: QuestionColumns) -> str:
    return trim(row.cell(question.response))


def _slots(table: Table, columns: MoodleColumns, head: ExamHead) -> tuple[_Slot, ...]:
    found = [_parts_of(table, question) for question in columns.questions]
    by_question = len(found) == len(head.questions)
    sizes = [len(each.asks) for each in head.questions] if by_question else [1] * len(found)
    counts = [
        size if count is None else count for (_, count), size in zip(found, sizes, strict=True)
    ]
    if sum(counts) != len(head.columns):
        raise _disagreement(table, counts, head)
    slots, first = [], 0
    for question, (words, _), count in zip(columns.questions, found, counts, strict=True):
        mine = head.columns[first : first + count]
        if len({name.partition(".")[0] for name in mine}) > 1:
            raise _disagreement(table, counts, head)
        slots.append(_Slot(question.response, question.right_answer, question.text, mine, words))
        first += count
    return tuple(slots)


def _disagreement(table: Table, counts: Sequence[int], head: ExamHead) -> TableError:
    problem = Message("responses.answers", count=len(counts), answers=list_plainly(counts))
    advice = expect_exam(head, Message("responses.made-from-exam"))
    return TableError(Fault(table.file, problem, do=advice))


def _parts_of(table: Table, question: QuestionColumns) -> tuple[Wording | None, int | None]:
    """The words that separate the parts of a column, and how many parts there are: None where no
    student answered.
    """
    for index in (question.right_answer, question.response):
        cells = [] if index is None else _filled(table, index)
        if cells:
            words = wording(cells)
            return words, part_count(cells, words) if words else 1
    return None, None


def _filled(table: Table, index: int) -> list[str]:
    return [row.cell(index) for row in table.rows if trim(row.cell(index)) not in ("", NOTHING)]


def _right(row: Row, slots: Sequence[_Slot]) -> tuple[str, ...]:
    """The right answers as the file has them, "" where it has none."""
    right: list[str] = []
    for slot in slots:
        cell = "" if slot.right_answer is None else row.cell(slot.right_answer)
        right += (parts(cell, slot.words, len(slot.asks)) if slot.words else (cell,)) or (
            "",
        ) * len(slot.asks)
    return tuple(right)


def _texts(row: Row, slots: Sequence[_Slot]) -> tuple[str, ...]:
    """The texts of the questions, for each ask; "" where the file does not have them."""
    texts: list[str] = []
    for slot in slots:
        texts += ["" if slot.text is None else row.cell(slot.text)] * len(slot.asks)
    return tuple(texts)


def _responses(
    table: Table, row: Row, slots: Sequence[_Slot]
) -> tuple[tuple[str, ...], list[Complaint]]:
    responses: list[str] = []
    faults = []
    for slot in slots:
        cell = row.cell(slot.column)
        blank = trim(cell) in ("", NOTHING)
        typed = parts(cell, slot.words, len(slot.asks)) if slot.words and not blank else (cell,)
        if blank:
            typed = ("",) * len(slot.asks)
        elif typed is None:
            typed = ("",) * len(slot.asks)
            problem = Message("responses.parts", count=len(slot.asks))
            faults.append(
                Complaint(
                    table.file,
                    row.line,
                    table.header[slot.column],
                    shorten(cell),
                    problem,
                    Message("responses.parts-blank", asks=list_plainly(slot.asks)),
                )
            )
        responses += typed
    return tuple(responses), faults
