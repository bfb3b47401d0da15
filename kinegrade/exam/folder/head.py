"""exam.json, the head of an exam folder: read with all its faults at once.

`open_exam` calls it; nothing else reads the file.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import TypeVar

import msgspec

from kinegrade.errors import one_line
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.faults import FieldError, broken, damaged, unreadable
from kinegrade.exam.folder.numbers import not_negative, shown
from kinegrade.exam.folder.records import Candidate, ExamHead, ExamQuestion
from kinegrade.exam.roster import student_key
from kinegrade.language import LANGUAGES

FORMAT = 2  # which this kinegrade writes
FORMATS = (1, FORMAT)  # which it reads
_IDENTIFIER = re.compile(r"[^\W\d][\w'\u2032-]{0,79}")
_COLUMNS_OF_GRADES = {"student", "name", "total", "out_of", "percent", "status"}
_Table = Mapping[str, object]
_Item = TypeVar("_Item")


def read_head(folder: Path) -> ExamHead:
    """The head of an exam folder. Raises ExamError with all its faults."""
    path = folder / HEAD
    try:
        table = _table(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as fault:
        raise unreadable(path, fault) from fault
    except FieldError as fault:
        raise broken(path, [str(fault)]) from fault
    faults: list[str] = []
    head = _head(table, faults)
    if head is None:
        raise broken(path, faults)
    return head


def _table(text: str) -> _Table:
    """The JSON, numbers digit by digit as they stand, of a format that is known. Raises
    FieldError.
    """
    try:
        table = json.loads(text, parse_float=Decimal, parse_constant=_refuse_constant)
    except (ValueError, ArithmeticError, RecursionError) as fault:
        raise FieldError(f"broken JSON ({fault}) - expected one JSON object") from fault
    if not isinstance(table, dict) or "format" not in table:
        raise FieldError('no "format" - expected the number of the format')
    if table["format"] not in FORMATS:
        known = " or ".join(map(str, FORMATS))
        raise FieldError(
            f'"format" is {shown(table["format"])} - expected {known}, the only ones this '
            "kinegrade reads"
        )
    return table


def _refuse_constant(name: str) -> None:
    raise ValueError(f"{name} is not a number")


def _head(table: _Table, faults: list[str]) -> ExamHead | None:
    """The head; None where it has faults, which are listed."""
    questions = _each("questions", table, _question, faults)
    students = _each("students", table, _candidate, faults)
    faults += [
        *_repetitions("ask", (ask.column for question in questions for ask in question.asks)),
        *_repetitions("student", (student_key(each.student) for each in students)),
    ]
    try:
        _require_language(table)
        head = _converted({**table, "questions": [], "students": []}, ExamHead)
    except FieldError as fault:
        faults.append(str(fault))
        return None
    if faults:
        return None
    return msgspec.structs.replace(head, questions=tuple(questions), students=tuple(students))


def _each(
    name: str, table: _Table, read: Callable[[object], _Item], faults: list[str]
) -> list[_Item]:
    """What `read` makes of each item of a list; the faulty ones are listed and left out."""
    items = table.get(name)
    if not isinstance(items, list) or not items:
        faults.append(f'no list "{name}" - expected one that is not empty')
        return []
    results = []
    for number, item in enumerate(items, 1):
        try:
            results.append(read(item))
        except FieldError as fault:
            faults.append(f"{name} {number}: {fault}")
    return results


def _question(item: object) -> ExamQuestion:
    question = _converted(_with_its_asks(item), ExamQuestion)
    _require_identifier("question", question.question)
    if not question.asks:
        raise FieldError(f"question {question.question} asks nothing - expected at least one ask")
    for ask in question.asks:
        _require_identifier("ask", ask.ask)
    return question


def _with_its_asks(item: object) -> object:
    """A question whose asks say to which question they belong."""
    if not isinstance(item, dict) or not isinstance(item.get("asks"), list):
        return item
    whose = {"question": item.get("question")}
    asks = [{**ask, **whose} if isinstance(ask, dict) else ask for ask in item["asks"]]
    return {**item, "asks": asks}


def _candidate(item: object) -> Candidate:
    candidate = _converted(item, Candidate)
    if not student_key(candidate.student):
        raise FieldError('"student" is empty - expected an id')
    return candidate


def _converted(found: object, kind: type[_Item]) -> _Item:
    """A record of that kind. Raises FieldError."""
    try:
        return msgspec.convert(found, kind, dec_hook=_decoded)
    except (msgspec.MsgspecError, ArithmeticError, RecursionError) as fault:
        raise FieldError(damaged(fault)) from fault


def _decoded(kind: type, found: object) -> object:
    """Points, the only fractions of a head; or a credit of the bank, as it stands."""
    if kind is object:
        return found
    if kind is not Fraction:
        raise NotImplementedError(kind)
    return not_negative("points", found)


def _require_identifier(name: str, found: str) -> None:
    """Raises FieldError where that cannot be the id of a question or an ask."""
    if not _IDENTIFIER.fullmatch(found) or found in _COLUMNS_OF_GRADES:
        raise FieldError(
            f'"{name}" is {shown(found)} - expected letters, digits, "_" and "-", and no column of '
            "grades.csv"
        )


def _require_language(table: _Table) -> None:
    """Raises FieldError where a head does not say a language that this version knows."""
    said = table.get("language")
    if said not in LANGUAGES:
        found = f'"{one_line(str(said))}"' if "language" in table else "no language"
        raise FieldError(
            f"language: {found} - expected one of {', '.join(LANGUAGES)}, which this version of "
            "kinegrade knows"
        )


def _repetitions(kind: str, names: Iterable[str]) -> Iterator[str]:
    for name, count in Counter(names).items():
        if count > 1:
            yield f'{kind} "{name}" stands there {count} times - expected once'
