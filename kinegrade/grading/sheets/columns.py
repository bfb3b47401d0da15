"""The columns of a file of answers: whose rows they are, what they answer, and what is neither."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from unicodedata import normalize

from kinegrade.ask_names import AskNames
from kinegrade.errors import TableError
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.roster.known_columns import (
    list_code_columns,
    list_columns_of_people,
    list_key_columns,
)
from kinegrade.files.answer_file import AnswerFile, Sources
from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.files.rows.row import choose_cells
from kinegrade.files.tables import Table
from kinegrade.grading.sheets.entry import Place
from kinegrade.grading.sheets.strange_headers import find_numbered
from kinegrade.language.message import Fault, Message, Text, list_plainly

_NO_STUDENT_COLUMN = Message("marking.no-student-column")
_ANSWER_COLUMN = re.compile(
    r"q[0-9]+[a-z]?\.\w+"
)  # as generate writes the headers of the answer sheet

_UNIT = re.compile(r"\s*[(\[]([^()\[\]]*)[)\]]$")  # "q1.v_B (m/s)"


@dataclass(frozen=True, slots=True)
class Columns:
    """The column that says whose a row is, that of each ask, those that answer nothing, and beside
    the first those of codes of papers and of other ids.
    """

    student: int
    asks: tuple[int | None, ...]
    extra: tuple[int, ...]
    codes: tuple[int, ...]
    ids: tuple[int, ...]

    def responses(self) -> Callable[[tuple[str, ...]], tuple[str, ...]]:
        """A function that picks the responses from the cells of a row; missing ones are blank."""
        return choose_cells(self.asks)

    def sources(self, answers: AnswerFile) -> Mapping[int, Sources]:
        """By line, the student whose line of the key each ask is marked by, in the order of the
        asks.
        """
        return {
            line: tuple(["" if index is None else sources[index - 1] for index in self.asks])
            for line, sources in answers.put.items()
        }

    def places(self, answers: AnswerFile) -> Mapping[int, tuple[Place, ...]]:
        """By line, the place of the answer to each ask, in the order of the asks, where the answers
        of a row stand on lines of their own.
        """
        file = answers.table.file
        return {
            line: tuple(
                [Place(file, line if index is None else lines[index - 1]) for index in self.asks]
            )
            for line, lines in answers.lines.items()
        }


def find_columns(table: Table, asks: Sequence[Ask]) -> Columns:
    """What the columns of a table are.

    Raises TableError where none identifies students, none answers an ask, or most answer those of
    another exam.
    """
    header = [make_header_key(cell) for cell in table.header]
    named = (header.index(name) for name in list_key_columns() if name in header)
    student = next(named, None)
    found = _find_ask_columns(table.header, asks)
    faults = []
    if student is None:
        faults.append(_explain(table, _NO_STUDENT_COLUMN, Message("marking.column-of-ids")))
    if all(index is None for index in found):
        faults.append(_explain_no_answers(table, [ask.column for ask in asks]))
    strange = [
        cell
        for cell in (_UNIT.sub("", name) for name in header)
        if _ANSWER_COLUMN.fullmatch(cell) and cell not in _list_keys(asks)
    ]
    if not faults and len(strange) > sum(index is not None for index in found):
        first = list_plainly(strange[:4])
        faults.append(_explain(table, Message("marking.another-exam", columns=first)))
    if student is None or faults:
        raise TableError(*faults)
    needless = {*list_columns_of_people()}
    unused = (index for index in range(len(header)) if index not in {student, *found})
    beside = [index for index in range(len(header)) if index != student]
    ids = set(list_key_columns()) - set(list_code_columns())
    return Columns(
        student,
        found,
        tuple(index for index in unused if header[index] not in needless),
        tuple(index for index in beside if header[index] in list_code_columns()),
        tuple(index for index in beside if header[index] in ids),
    )


def strip_unit(title: str) -> str:
    """A title without what `find_unit` finds."""
    return _UNIT.sub("", trim(title))


def find_unit(title: str) -> str:
    """What stands in brackets at the end of a title, "" where there is nothing.

    >>> find_unit("q1.v_B (m/s)")
    'm/s'
    """
    found = _UNIT.search(trim(title))
    return trim(found[1]) if found else ""


def _explain(table: Table, problem: Message, expected: Text = "") -> Fault:
    return Fault(table.file, problem, expected, Message("marking.fill-in"))


def _explain_no_answers(table: Table, columns: Sequence[str]) -> Fault:
    expected = Message("marking.answer-columns", columns=list_plainly(columns[:4]))
    if any(find_numbered(strip_unit(title), columns) for title in table.header):
        return _explain(table, Message("marking.numbers-alone"), expected)
    return _explain(table, Message("marking.no-answer-column"), expected)


def _list_keys(asks: Sequence[Ask]) -> set[str]:
    return {make_header_key(ask.column) for ask in asks}


def _find_ask_columns(header: Sequence[str], asks: Sequence[Ask]) -> tuple[int | None, ...]:
    """Exact spelling comes first, because v_A and v_a may both be asked; otherwise case does not
    matter.
    """
    backwards = list(enumerate(header))[::-1]  # so that of two equal columns the first is kept
    exact = {_make_exact_key(cell): index for index, cell in backwards}
    folded = {make_header_key(cell): index for index, cell in backwards}
    alike = Counter(make_header_key(ask.column) for ask in asks)

    def find(column: str) -> int | None:
        key = make_header_key(column)
        found = exact.get(_make_exact_key(column), folded.get(key) if alike[key] == 1 else None)
        return described.get(column) if found is None else found

    described = _find_described(header, [ask.column for ask in asks])
    return tuple(find(ask.column) for ask in asks)


def _find_described(header: Sequence[str], columns: Sequence[str]) -> Mapping[str, int]:
    """The columns whose headers name an ask otherwise, or with its unit behind: q1a, q1.v_B
    (m/s).
    """
    names = AskNames(columns, shuffled=True)
    backwards = list(enumerate(header))[::-1]
    found = ((names.find(strip_unit(cell)), index) for index, cell in backwards)
    return {named.column: index for named, index in found if named is not None and named.ask}


def _make_exact_key(column: str) -> str:
    return trim(normalize("NFKC", column))
