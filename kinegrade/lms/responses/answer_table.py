"""From a download to a table with the columns of EXAM/answers.csv, which grading reads like any
other.

Every cell is what was typed; every row that is left out is reported with its whole content. Where
questions came from a pool, `pooled` says whose line of the key each of them belongs to.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from kinegrade.errors import TableError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.files.answer_file import AnswerFile, LeftOut, Sources
from kinegrade.files.cell_text import shorten, trim
from kinegrade.files.rows.cell_grid import pack_grid
from kinegrade.files.rows.packed_rows import pack_rows
from kinegrade.files.rows.row import Row
from kinegrade.files.tables import Complaint, Table, drop_headers
from kinegrade.language.message import Fault, Message, Quoted, list_choices, list_plainly
from kinegrade.lms.responses.assumptions import list_assumptions
from kinegrade.lms.responses.detection import DIALECTS, detected, is_header
from kinegrade.lms.responses.people import Columns, Found, People
from kinegrade.lms.responses.pooled import Pairs, own_papers_only, pool_of, put_to
from kinegrade.lms.responses.sheet import pass_on, read_answer_file
from kinegrade.lms.responses.times import DecidedOrder, read_times
from kinegrade.lms.responses.typed_rows import Attempts, TypedRow, TypedRows, whole

if TYPE_CHECKING:
    from kinegrade.exam.quiz.variants import Variants

SOURCES = tuple(DIALECTS)
Assumption: TypeAlias = Fault | Message
_FEW = 3  # this many unknown rows may each be a typing error; more are another class
_POOLED = ("moodle", "canvas")  # the systems that draw questions from pools


@dataclass(frozen=True, slots=True)
class Responses:
    """The answer sheet made from a download, the name of its source, and what was assumed, one line
    for each assumption.
    """

    answers: AnswerFile
    source: str
    assumed: tuple[Assumption, ...]

    @property
    def table(self) -> Table:
        """The answer sheet alone."""
        return self.answers.table


@dataclass(frozen=True, slots=True)
class ReadingWishes:
    """How files are read: the system they come from, detected where None; which attempts count; the
    encoding of CSV files that are not UTF-8; whether students answered their own papers although a
    pool was made.
    """

    source: str | None = None
    attempts: Attempts = "finished"
    encoding: str | None = None
    own_papers: bool = False


DETECTED = ReadingWishes()


def read_responses(
    path: Path, exam: ExamFolder, wishes: ReadingWishes = DETECTED, name: str = ""
) -> Responses:
    """Reads a CSV file or workbook that was downloaded from a system or a form.

    Each attempt of a student is a row, in chronological order. Where a pool was made from the exam,
    the questions answered in a quiz are recognised by it, unless each student answered their own
    paper. `name` replaces the file's name in messages. Raises TableError, ExamError.
    """
    table = read_answer_file(path, wishes.encoding, is_header(wishes.source))
    table = replace(table, file=name or table.file, rows=drop_headers(table))
    system = detected(table) if wishes.source is None else _known(wishes.source, path)
    if system == "sheet" and (answers := pass_on(table, exam.students)) is not None:
        assumed = list_assumptions(table, system, wishes.source)
        return Responses(answers, system, tuple(assumed))
    typed = DIALECTS[system].read(table, exam.head, wishes.attempts)
    if typed.by_number:
        _refuse_shuffled(table.file, exam)
    everybody = [*(each.row for each in typed.rows), *(each.row for each in typed.not_taken)]
    people = People(exam.head.students, exam.head.spares)
    columns = people.columns(everybody, typed.people, typed.named)
    if not columns.indices and typed.rows:
        raise TableError(Fault(table.file, Message("responses.no-people")))
    found = people.find_all(everybody, table.header, columns)
    _refuse_another_class(table, everybody, columns, found, exam.head.students)
    variants = None if wishes.own_papers or system not in _POOLED else pool_of(exam)
    answers, orders = _answers(_Read(table, typed, columns, found), variants, exam)
    assumed = list_assumptions(table, system, wishes.source, typed, columns)
    return Responses(answers, system, (*assumed, *orders, *_restored(table.file, found, people)))


def _refuse_shuffled(file: str, exam: ExamFolder) -> None:
    """Raises TableError where a number alone is another question on each paper."""
    if exam.printed_orders():
        first = exam.head.columns[0]
        expected = Message("responses.full-name", column=first)
        raise TableError(Fault(file, Message("responses.numbers-shuffled"), expected))


def _refuse_another_class(
    table: Table,
    rows: Sequence[Row],
    columns: Columns,
    found: Sequence[Found],
    students: Sequence[Candidate],
) -> None:
    """Raises TableError where a file has rows and none belongs to a student of the exam."""
    if len(found) < _FEW or any(each.student is not None or each.likely for each in found):
        return
    shown = Quoted(trim(rows[0].cell(columns.indices[0])))
    raise TableError(
        Fault(
            table.file,
            Message("responses.another-class", count=len(found), first=shown),
            Message("responses.ids-like", id=Quoted(students[0].student)),
            Message("responses.name-class-file"),
        )
    )


@dataclass(frozen=True, slots=True)
class _Read:
    """A download as it was read; `found` are the students of the rows, then those of the rows that
    are left out.
    """

    table: Table
    typed: TypedRows
    columns: Columns
    found: Sequence[Found]


def _answers(
    read: _Read, variants: Variants | None, exam: ExamFolder
) -> tuple[AnswerFile, Sequence[Message]]:
    """The answer sheet, and what decided on the order of its times. Raises TableError where it is
    not certain which questions the answers belong to.
    """
    table, typed = read.table, read.typed
    pairs: Pairs = list(zip(typed.rows, read.found, strict=False))
    put: Mapping[int, Sources] = {}
    if variants is None:
        pairs = own_papers_only(table.file, typed, pairs, exam)
    else:
        put = put_to(table.file, typed, pairs, variants, exam)
    left = list(_left_out(table, typed, read.found[len(typed.rows) :]))
    complaints = (
        *_about_answers(table, typed, read.columns),
        *typed.complaints,
        *_about_people(table, pairs),
        *(each.complaint for each in left if not each.student),
    )
    header = ("student", *typed.columns)
    listed = [*_rows(pairs)]
    rows = pack_grid(listed) or pack_rows(listed)  # a grid is marked by columns
    sheet = replace(table, header=header, rows=rows, complaints=complaints)
    timed = [each for each, _ in pairs if each.submitted]
    moments, decided = read_times(each.submitted for each in timed)
    lines = [timed[each.place].row.line for each in decided]
    orders = [_tell_order(table.file, *each) for each in zip(lines, decided, strict=True)]
    times = {each.row.line: time for each, time in zip(timed, moments, strict=True)}
    taken = tuple(each for each in left if each.student)
    coded = frozenset(who.student for _, who in pairs if who.student and who.by_code)
    return AnswerFile(sheet, put, taken, typed.lines, times, coded), orders


def _tell_order(file: str, line: int, decided: DecidedOrder) -> Message:
    """By which row the times of a file are read day first, or month first."""
    where, time = f"{file}:{line}", Quoted(shorten(decided.time))
    if decided.day_first:
        return Message("responses.day-first", where=where, time=time)
    return Message("responses.month-first", where=where, time=time)


def _known(source: str, path: Path) -> str:
    if source not in DIALECTS:
        raise TableError(
            Fault(
                path.name,
                Message("responses.unknown-system", name=Quoted(source)),
                Message("responses.systems", systems=list_plainly(DIALECTS)),
                Message("responses.name-one-or-none"),
            )
        )
    return source


def _about_answers(table: Table, typed: TypedRows, columns: Columns) -> Iterator[Complaint]:
    """The table's complaints without those about cells that are not read, such as times of
    completion.
    """
    read = {table.header[place] for place in {*typed.sources, *columns.indices}}
    return (each for each in table.complaints if not each.column or each.column in read)


def _left_out(table: Table, typed: TypedRows, found: Sequence[Found]) -> Iterator[LeftOut]:
    """Why rows are left out, each with its student, "" where the exam has no such student."""
    for each, who in zip(typed.not_taken, found, strict=True):
        complaint = Complaint(
            table.file, each.row.line, each.column, whole(each.row), each.problem, each.done
        )
        yield LeftOut(who.student or "", complaint, each.attempted)


def _restored(file: str, found: Sequence[Found], people: People) -> Iterator[Fault]:
    restored = {each.restored: each.student for each in found if each.student and each.restored}
    for problem, done in people.describe_restored(restored):
        yield Fault(file, problem, do=done)


def _rows(found: Sequence[tuple[TypedRow, Found]]) -> Iterator[Row]:
    """The rows of the students that were found, in chronological order."""
    timed = all(each.moment for each, _ in found)
    for each, who in sorted(found, key=lambda pair: pair[0].moment) if timed else found:
        if who.student is not None:
            yield Row(each.row.line, (who.student, *each.responses))


def _about_people(table: Table, found: Sequence[tuple[TypedRow, Found]]) -> Iterator[Complaint]:
    """Rows of nobody in the exam, and rows that only the code of a paper gives to a student."""
    for each, who in found:
        if who.student is None or who.code:
            content = who.code if who.student and who.code else whole(each.row)
            where = table.file, each.row.line, who.column, content
            yield Complaint(*where, who.problem, _explain_done(who))


def _explain_done(who: Found) -> Message:
    if who.student is not None:
        return Message("marking.marked-by-code", student=Quoted(who.student))
    if who.code:
        return Message("marking.assign", code=who.code)
    if not who.likely:
        return Message("marking.not-graded")
    return Message("marking.correct-file", students=list_choices(map(Quoted, who.likely)))
