"""exam.json, the head of an exam folder: read with all its faults at once.

`open_exam` calls it; nothing else reads the file.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence, Set
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from typing import Literal, TypeVar

import msgspec

from kinegrade.errors import ExamError, FieldError
from kinegrade.exam.folder.contents import HEAD, UNFINISHED
from kinegrade.exam.folder.earlier_signs import recognise_convention
from kinegrade.exam.folder.faults import EXAM_FOLDER, REMEDY, describe_damage
from kinegrade.exam.folder.numbers import require_not_negative
from kinegrade.exam.folder.records import Candidate, ExamHead, ExamQuestion
from kinegrade.exam.roster.students import make_student_key, make_student_keys
from kinegrade.files.fields.document import FileKind, json_table, read_text
from kinegrade.files.fields.json_records import read_records
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import Read, found
from kinegrade.language import ENGLISH, Language
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message, Quoted, list_choices, list_plainly
from kinegrade.marks_folder.layout import GRADES

FORMAT = 2  # the one that this version writes
_FORMATS = (1, FORMAT)  # those that it reads
_NEWER = Message("exam.use-newer")
_FILLED_LIST = Message("exam.a-filled-list")
_MOST_BYTES = 10**9  # a class of any size
_HEAD_FILE = FileKind(EXAM_FOLDER, ExamError, _MOST_BYTES, REMEDY)
_IDENTIFIER = re.compile(r"[^\W\d][\w'\u2032-]{0,79}")
_NUMBERED = re.compile(r"q[1-9][0-9]{0,2}", re.ASCII)
_Item = TypeVar("_Item")


def read_head(folder: Path) -> ExamHead:
    """The head of an exam folder. Raises ExamError with all its faults."""
    path = folder / HEAD
    text = read_text(path, _HEAD_FILE)
    found = read_records(text, "students", Candidate)
    if found is not None and all(_list_keys(found.records)):
        with suppress(ExamError):  # whose lines the whole text tells
            return _read(json_table(str(path), found.rest, _HEAD_FILE), found.records)
    return _read(json_table(str(path), text, _HEAD_FILE))


def _read(table: Table, students: tuple[Candidate, ...] = ()) -> ExamHead:
    """The head in that table, whose students may have been read already."""
    table.required("format", _read_format)
    table.faults.require_none()  # what another format holds is not known
    questions = _read_list(table, "questions", _read_question)
    students = students or _read_list(table, "students", _read_candidate)
    columns = (ask.column for question in questions for ask in question.asks)
    _require_once(table, "questions", "ask", columns)
    _require_once(table, "students", "id", _list_keys(students))
    language = table.required("language", _read_language) or ENGLISH
    rest = {**table.content, "questions": [], "students": [], "language": language}
    try:
        head = _convert(rest, ExamHead)
    except FieldError as fault:
        table.faults.note_error(table.place, fault)
        raise table.faults.raised() from fault
    names = [question.question for question in questions]
    _require_numbers(table, head, {*names})
    _require_choices(table, head, names)
    table.faults.require_none()
    return msgspec.structs.replace(head, questions=questions, students=students)


def _list_keys(students: Iterable[Candidate]) -> Sequence[str]:
    """The ids of these students as they are compared."""
    return make_student_keys([each.student for each in students])


def require_finished(folder: Path) -> None:
    """Raises ExamError where `generate` was interrupted before the folder was whole."""
    if (folder / UNFINISHED).is_dir():
        what, do = Message("exam.unfinished"), Message("exam.resume")
        raise ExamError(Fault(str(folder), what, Message("exam.a-whole-folder"), do))


def _require_numbers(table: Table, head: ExamHead, taken: Set[str]) -> None:
    """A fault for each question to be marked by hand that has no number of its own."""
    for place, each in enumerate(head.by_hand, 1):
        if not _NUMBERED.fullmatch(each.question) or each.question in taken:
            what = Message("exam.is", name=f"by_hand[{place}]", found=found(each.question))
            table.fault("by_hand", what, Message("exam.own-number"))


def _require_choices(table: Table, head: ExamHead, names: Sequence[str]) -> None:
    """A fault where alternatives are no questions of the exam, or leave nothing to choose."""
    listed = [name for choice in head.choices for name in choice.questions]
    sound = all(0 < choice.given < len(choice.questions) for choice in head.choices)
    if not sound or len({*listed}) < len(listed) or not {*listed} <= {*names}:
        what = Message("exam.choices", questions=list_plainly(listed))
        table.fault("choices", what, Message("exam.own-alternatives"))


def _read_format(value: object) -> int:
    """The number of a format that is known."""
    for known in _FORMATS:
        if value == known and not isinstance(value, bool):
            return known
    expected = Message("exam.formats", formats=list_choices(_FORMATS))
    newer = isinstance(value, int) and value > FORMAT
    raise FieldError(found(value), expected, _NEWER if newer else "")


def _read_language(value: object) -> Language:
    """A language that this version knows."""
    for known in known_languages():
        if value == known:
            return known
    expected = Message("exam.languages", languages=list_plainly(known_languages()))
    raise FieldError(found(value), expected)


def _read_list(table: Table, key: str, read: Read[_Item]) -> tuple[_Item, ...]:
    """The entries of a list, which is not empty."""
    if key not in table:
        table.missing(key, _FILLED_LIST)
    if table.value(key) == []:
        table.fault(key, Message("exam.empty"), _FILLED_LIST)
    return table.listing(key, read)


def _read_question(value: object) -> ExamQuestion:
    question = _convert(_name_owner(value), ExamQuestion)
    _require_identifier("question", question.question)
    if not question.asks:
        what = Message("exam.asks-nothing", question=question.question)
        raise FieldError(what, Message("exam.one-ask-at-least"))
    for ask in question.asks:
        _require_identifier("ask", ask.ask)
    return question


def _name_owner(item: object) -> object:
    """A question whose asks name the question to which they belong and say whether that is a bonus,
    with the keyword of their sign convention where an earlier version wrote only its words.
    """
    if not isinstance(item, dict) or not isinstance(item.get("asks"), list):
        return item
    whose = {"question": item.get("question"), "bonus": item.get("bonus", False)}
    asks = [
        {"convention": recognise_convention(ask.get("sign")), **ask, **whose}
        if isinstance(ask, dict)
        else ask
        for ask in item["asks"]
    ]
    return {**item, "asks": asks}


def _read_candidate(value: object) -> Candidate:
    candidate = _convert(value, Candidate)
    if not make_student_key(candidate.student):
        raise FieldError(Message("exam.empty-id"), Message("exam.an-id"))
    return candidate


def _convert(value: object, kind: type[_Item]) -> _Item:
    """A record of that kind. Raises FieldError."""
    try:
        return msgspec.convert(value, kind, dec_hook=_decode)
    except (msgspec.MsgspecError, ArithmeticError, RecursionError) as fault:
        raise FieldError(describe_damage(fault)) from fault


def _decode(kind: type, value: object) -> object:
    """Points, the only fractions of a head; or a credit of the bank, as it stands."""
    if kind is object:
        return value
    if kind is not Fraction:
        raise NotImplementedError(kind)
    try:
        return require_not_negative("points", value)
    except FieldError as fault:
        raise ValueError(fault) from fault  # to which msgspec adds the place in the question


def _require_identifier(name: str, value: str) -> None:
    """Raises FieldError where that cannot be the id of a question or an ask."""
    if not _IDENTIFIER.fullmatch(value) or value in GRADES.columns:
        what = Message("exam.is", name=Quoted(name), found=found(value))
        raise FieldError(what, Message("exam.identifier", file=GRADES.name))


def _require_once(table: Table, key: str, kind: Literal["ask", "id"], names: Iterable[str]) -> None:
    """A fault for each name that appears in a list more than once."""
    listed = [*names]
    if len({*listed}) == len(listed):  # as in all but few files: counting takes twenty times longer
        return
    for name, count in Counter(listed).items():
        if count > 1:
            what = Message(f"exam.twice-{kind}", name=Quoted(name), count=count)
            table.fault(key, what, Message("exam.each-once"))
