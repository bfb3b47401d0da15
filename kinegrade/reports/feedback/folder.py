"""`kinegrade feedback`: a folder with a sheet for every student, written whole or not at all.

`sheets/` holds one file for each student; `feedback.csv` says which is whose, for programs that
send them out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import chain
from pathlib import Path, PurePosixPath
from typing import Literal, NamedTuple, assert_never

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.roster.students import choose_places
from kinegrade.files.csv_writing import neutralise, write_for_people
from kinegrade.files.output import output_folder
from kinegrade.files.placing.edits import find_edits
from kinegrade.grading.wording import Wording
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.press.html.feedback import write_feedback_html
from kinegrade.press.markdown.feedback import write_feedback_markdown
from kinegrade.press.sheet import FeedbackSheet
from kinegrade.processes.executor import THIS_PROCESS, map_in_order, split_in_parts
from kinegrade.reports.feedback.feedback import make_feedback_sheets

Text = Literal["html", "md"]
# The sheet as PDF, a solution behind it where there is one
Press = Callable[[FeedbackSheet, bytes | None], bytes]
_PART = 20  # sheets in one task
_MARKER, _SHEETS = "feedback.csv", "sheets"
PACKED = "moodle.zip"


@dataclass(frozen=True)
class FeedbackWishes:
    """What is wanted: `form` is a kind of text, or what prints a PDF, a function that other
    processes can be sent.

    With `solutions` everybody gets the worked solutions that the exam folder has: in the PDF, or as
    a file beside. With `force` the output may replace an earlier one. `own` has the words of
    languages in which students get their sheets because their papers are in them. `pack` writes
    another file, the zip of a learning management system, from the files by student.
    """

    form: Text | Press
    language: Language
    solutions: bool = False
    force: bool = False
    own: Mapping[Language, Wording] = field(default_factory=dict)
    pack: Callable[[Path, Mapping[str, Sequence[Path]]], None] | None = None


@dataclass(frozen=True)
class _Handout:
    """What one student gets, before it is printed; `place` begins the paths of the files."""

    candidate: Candidate
    place: str
    sheet: FeedbackSheet
    solution: bytes | None


class WrittenFeedback(NamedTuple):
    """How many sheets there are, and what is to be said of those that they replaced."""

    sheets: int
    notes: tuple[Message, ...]


def write_feedback(
    exam: ExamFolder,
    marks: MarksFolder,
    output: Path,
    wording: Wording,
    wishes: FeedbackWishes,
    *,
    workers: Executor = THIS_PROCESS,
) -> WrittenFeedback:
    """Writes the folder `output`, its sheets made by `workers`; sheets of a folder that it replaces
    and somebody edited stay beside it.

    Raises ExamError, TableError, TypesetError, OutputError; then nothing is written.
    """
    if wishes.solutions and marks.put:
        what = Message("feedback.pool-solutions", exam=str(exam.path))
        expected, do = Message("feedback.no-solutions"), Message("feedback.add-no-solutions")
        raise ExamError(Fault(str(marks.path), what, expected, do))
    contents = _MARKER, _SHEETS, PACKED
    make = partial(_make_part, wishes.form)
    edits = find_edits(output, marker=_MARKER)
    with output_folder(output, marker=_MARKER, contents=contents, force=wishes.force) as folder:
        (folder / _SHEETS).mkdir()
        rows, written = [], dict[str, list[Path]]()
        sheets = make_feedback_sheets(marks, exam, wording, wishes.language, wishes.own)
        places = _choose_places(exam, marks, wishes.form)
        handouts = _print_handouts(sheets, places, exam, wishes)
        parts = map_in_order(workers, make, split_in_parts(handouts, _PART))
        for candidate, files in chain.from_iterable(parts):
            written[candidate.student] = _write_sheets(folder / _SHEETS, files)
            whose = candidate.student, neutralise(candidate.name), neutralise(candidate.email)
            rows.append((*whose, f"{_SHEETS}/{next(iter(files))}"))
        write_for_people(folder / _MARKER, ("student", "name", "email", "file"), rows)
        if wishes.pack is not None:
            wishes.pack(folder / PACKED, written)
        edits.settle(folder)
    return WrittenFeedback(len(rows), tuple(edits.describe()))


def _write_sheets(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Writes what one student gets, and says where."""
    sheets = [folder / name for name in files]
    for sheet, content in zip(sheets, files.values(), strict=True):
        sheet.parent.mkdir(exist_ok=True)
        sheet.write_bytes(content)
    return sheets


def list_sheets(
    exam: ExamFolder, marks: MarksFolder, output: Path, form: Text | Press
) -> dict[str, Path]:
    """Where the sheets will be, by student."""
    suffix = "pdf" if callable(form) else form
    places = _choose_places(exam, marks, form)
    return {student: output / _SHEETS / f"{place}.{suffix}" for student, place in places.items()}


def _choose_places(exam: ExamFolder, marks: MarksFolder, form: Text | Press) -> dict[str, str]:
    """Where the sheet of each marked student is, and what may stand beside a text."""
    stems = exam.head.file_stems
    marked = [each.student for each in marks.totals.students if each.student in stems]
    files = 1 if callable(form) else 2
    chosen = choose_places([stems[student] for student in marked], each=files)
    return dict(zip(marked, chosen, strict=True))


def _print_handouts(
    sheets: Iterable[tuple[Candidate, FeedbackSheet]],
    places: Mapping[str, str],
    exam: ExamFolder,
    wishes: FeedbackWishes,
) -> Iterator[_Handout]:
    for candidate, sheet in sheets:
        solution = exam.solution(candidate.student) if wishes.solutions else None
        yield _Handout(candidate, places[candidate.student], sheet, solution)


def _make_part(
    form: Text | Press, part: Sequence[_Handout]
) -> list[tuple[Candidate, dict[str, bytes]]]:
    """Whose files, and the files by name, for a part of the class."""
    return [
        (each.candidate, dict(_write_files(each.place, each.sheet, each.solution, form)))
        for each in part
    ]


def _write_files(
    place: str, sheet: FeedbackSheet, solution: bytes | None, form: Text | Press
) -> Iterator[tuple[str, bytes]]:
    """The names and contents of one student's files, the sheet first."""
    if callable(form):
        yield f"{place}.pdf", form(sheet, solution)
        return
    beside = f"{place}-solution.pdf" if solution is not None else ""
    sheet = replace(sheet, solution=PurePosixPath(beside).name)
    text = _write_text(sheet, form)
    yield f"{place}.{form}", text.encode("utf-8", "backslashreplace")
    if solution is not None:
        yield beside, solution


def _write_text(sheet: FeedbackSheet, form: Text) -> str:
    match form:
        case "md":
            return write_feedback_markdown(sheet)
        case "html":
            return write_feedback_html(sheet)
        case _:
            assert_never(form)
