"""Reading exam.json and key.jsonl of an exam folder, with all faults at once.

`open_exam` is called by `grade` and gives one paper after the other, so that a class of any size
needs the memory of a few; `read_exam` gives them all.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple, TypeVar

from kinegrade.answer_file import POOL
from kinegrade.errors import ExamError
from kinegrade.exam.roster import student_key
from kinegrade.grading.json_fields import (
    FieldError,
    field,
    identifier,
    list_of,
    not_negative,
    parsed,
    shown,
)
from kinegrade.grading.key import Ask, Exam, Examinee, Paper, questions
from kinegrade.grading.key_decoding import PaperDecoder

FORMAT = 1
# Bytes: some lines, which are long, and not more than stays in the fast memory of a processor
_BUFFER = 2**17
_MENDING = "restore the exam folder as it was generated"
Item = TypeVar("Item")


@dataclass(frozen=True, slots=True)
class ExamFolder:
    """The head of an exam; `names` are those of the students by id, in the order of the roster.

    `credit` is the table of the exam's bank for answers that are not right, as exam.json has it, or
    None.
    """

    folder: Path
    asks: tuple[Ask, ...]
    names: Mapping[str, str]
    credit: Mapping[str, Any] | None

    @property
    def students(self) -> tuple[str, ...]:
        """The ids of the examinees."""
        return tuple(self.names)

    @property
    def questions(self) -> tuple[str, ...]:
        """The questions in the order of the paper."""
        return questions(self.asks)

    def papers(self) -> Iterator[Paper]:
        """The papers in the order of the roster, read while they are asked for.

        Raises ExamError with all faults of key.jsonl, after the last line is read.
        """
        try:
            with (self.folder / "key.jsonl").open("rb", _BUFFER) as stream:
                yield from _Papers(self, stream).in_roster_order()
        except (OSError, UnicodeDecodeError) as fault:
            raise _unreadable(self.folder / "key.jsonl", fault) from fault

    def papers_of(self, students: Collection[str]) -> Mapping[str, Paper]:
        """The papers on these students' lines of the key, or of variants.jsonl. Raises ExamError
        where one is missing.
        """
        if not students:
            return {}
        found = {paper.student: paper for paper in self.papers() if paper.student in students}
        missing = set(students) - found.keys()
        if missing:
            found |= {paper.student: paper for paper in self.variants() if paper.student in missing}
        strange = sorted(set(students) - found.keys())
        if strange:
            raise _broken(self.folder, [f'key.jsonl: no line for student "{strange[0]}"'])
        return found

    def variants(self) -> tuple[Paper, ...]:
        """The papers of a pool that was made of the exam, none where there was none made. Raises
        ExamError.
        """
        path, decoder = self.folder / POOL, PaperDecoder(self.asks, self.names)
        try:
            lines = [line for line in path.read_bytes().splitlines() if line.strip()]
            return tuple(
                decoder.paper(line, f"{path}: line {number}")
                for number, line in enumerate(lines, 1)
            )
        except FileNotFoundError:
            return ()
        except (OSError, UnicodeDecodeError) as fault:
            raise _unreadable(path, fault) from fault
        except FieldError as fault:
            raise _broken(self.folder, [f"{POOL}: {fault}"]) from fault


def read_exam(folder: Path) -> Exam:
    """The whole of an exam folder made by `generate`; raises ExamError."""
    exam = open_exam(folder)
    columns = [ask.column for ask in exam.asks]
    return Exam(
        exam.asks,
        tuple(
            Examinee(
                paper.student,
                paper.name,
                dict(zip(columns, map(paper.key, range(len(columns))), strict=True)),
            )
            for paper in exam.papers()
        ),
    )


def open_exam(folder: Path) -> ExamFolder:
    """The head of an exam folder; raises ExamError for faults of exam.json, and if key.jsonl cannot
    be read.
    """
    faults: list[str] = []
    exam = _head(_text(folder), faults)
    listed = _each("exam.json: questions", list_of(exam, "questions"), _question, faults)
    students = _each("exam.json: students", list_of(exam, "students"), _student, faults)
    asks = [ask for question in listed for ask in question]
    faults = faults or [
        *_repetitions("exam.json: ask", (ask.column for ask in asks)),
        *_repetitions("exam.json: student", (student_key(student) for student, _ in students)),
    ]
    if faults:
        raise _broken(folder, faults)
    return ExamFolder(folder, tuple(asks), dict(students), exam.get("credit"))


class _Line(NamedTuple):
    """A line of key.jsonl: its number, and where it begins in the file."""

    number: int
    begin: int
    text: bytes


class _Papers:
    """Puts the lines of key.jsonl into the order of the roster; where one is early, its place is
    kept, not its text.
    """

    def __init__(self, exam: ExamFolder, stream: BinaryIO) -> None:
        self.exam, self.stream, self.decoder = exam, stream, PaperDecoder(exam.asks, exam.names)
        self.early: dict[str, _Line] = {}
        self.seen: list[str] = []
        self.faults: list[str] = []

    def in_roster_order(self) -> Iterator[Paper]:
        """All papers. Raises ExamError, after the last."""
        waiting = iter(self.exam.names)
        due = next(waiting, None)
        for line, paper in self._in_file_order():
            self.seen.append(paper.student)
            if paper.student != due:
                self.early.setdefault(paper.student, line._replace(text=b""))
                continue
            yield paper
            due = next(waiting, None)
            while due is not None and due in self.early:
                yield self._early(self.early[due])
                due = next(waiting, None)
        faults = self.faults or [*_repetitions("key.jsonl: student", self.seen), *self._strangers()]
        if faults:
            raise _broken(self.exam.folder, faults)

    def _in_file_order(self) -> Iterator[tuple[_Line, Paper]]:
        """Each line with the paper on it; none any more after the first fault."""
        for lines in self._lines():
            papers = self.decoder.usual(
                [line.text for line in lines], [self._place(line) for line in lines]
            )
            if papers is not None and not self.faults:
                yield from zip(lines, papers, strict=True)
                continue
            for line in lines:
                try:
                    paper = self.decoder.paper(line.text, self._place(line))
                    if not self.faults:
                        yield line, paper
                except FieldError as fault:
                    self.faults.append(f"key.jsonl: line {line.number}: {fault}")

    def _lines(self) -> Iterator[list[_Line]]:
        """The lines that are not empty, some at a time."""
        begin = number = 0
        while texts := self.stream.readlines(_BUFFER):
            lines = []
            for text in texts:
                if not text.isspace():
                    number += 1
                    lines.append(_Line(number, begin, text))
                begin += len(text)
            yield lines

    def _early(self, line: _Line) -> Paper:
        now = self.stream.tell()
        self.stream.seek(line.begin)
        text = self.stream.readline()
        self.stream.seek(now)
        return self.decoder.paper(text, self._place(line))

    def _place(self, line: _Line) -> str:
        return f"{self.exam.folder}/key.jsonl: line {line.number}"

    def _strangers(self) -> Iterator[str]:
        seen = set(self.seen)
        for student in sorted(self.exam.names.keys() - seen):
            yield f'key.jsonl: no line for student "{student}" - expected one'
        for student in sorted(seen - self.exam.names.keys()):
            yield f'key.jsonl: student "{student}" is not in exam.json - expected only its students'


def _text(folder: Path) -> str:
    """The text of exam.json; that key.jsonl can be opened is seen at once too."""
    text, faults = "", []
    for name in ("exam.json", "key.jsonl"):
        try:
            with (folder / name).open(encoding="utf-8") as stream:
                text = text or (stream.read() if name == "exam.json" else "")
        except (OSError, UnicodeDecodeError) as fault:
            faults.append(_unreadable(folder / name, fault).problems[0])
    if faults:
        raise ExamError(*faults)
    return text


def _unreadable(file: Path, fault: OSError | UnicodeDecodeError) -> ExamError:
    reason = fault.strerror if isinstance(fault, OSError) else "not UTF-8"
    return ExamError(
        f"{file}: cannot be read ({reason}) "
        "- expected an exam folder made by kinegrade generate - check the name"
    )


def _broken(folder: Path, faults: Iterable[str]) -> ExamError:
    return ExamError(*(f"{folder}/{fault} - {_MENDING}" for fault in faults))


def _head(text: str, faults: list[str]) -> Any:
    try:
        exam = parsed(text)
        if field(exam, "format", Decimal) != FORMAT:
            raise FieldError(
                f'"format" is {shown(exam["format"])} - expected {FORMAT}, the only one this '
                "kinegrade reads"
            )
    except FieldError as fault:
        faults.append(f"exam.json: {fault}")
        return {}
    faults += [
        f'exam.json: no list "{name}" - expected one that is not empty'
        for name in ("questions", "students")
        if not list_of(exam, name)
    ]
    return exam


def _each(
    where: str, items: Iterable[Any], read: Callable[[Any], Item], faults: list[str]
) -> list[Item]:
    """What `read` makes of each item; the faulty ones are listed and left out."""
    results = []
    for number, item in enumerate(items, 1):
        try:
            results.append(read(item))
        except FieldError as fault:
            faults.append(f"{where} {number}: {fault}")
    return results


def _question(item: Any) -> list[Ask]:
    question = identifier(item, "question")
    asks = field(item, "asks", list)
    if not asks:
        raise FieldError(f"question {question} asks nothing - expected at least one ask")
    return [
        Ask(
            question,
            identifier(ask, "ask"),
            field(ask, "unit", str),
            not_negative(ask, "points"),
            _sign(ask),
        )
        for ask in asks
    ]


def _sign(ask: Any) -> str:
    """The sign convention; exams of earlier versions do not state it."""
    return field(ask, "sign", str) if isinstance(ask, dict) and "sign" in ask else ""


def _student(item: Any) -> tuple[str, str]:
    student = field(item, "student", str)
    if not student_key(student):
        raise FieldError('"student" is empty - expected an id')
    return student, field(item, "name", str)


def _repetitions(kind: str, names: Iterable[str]) -> list[str]:
    return [
        f'{kind} "{name}" stands there {count} times - expected once'
        for name, count in Counter(names).items()
        if count > 1
    ]
