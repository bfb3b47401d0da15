"""Reading exam.json and key.jsonl of an exam folder, with all faults at once.

`read_exam` is called by `grade`. Numbers are taken from the digits that stand in the files, never through
binary floating point.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache, partial
from math import isclose
from pathlib import Path
from typing import Any, TypeVar

from kinegrade.errors import ExamError
from kinegrade.exam.roster import student_key
from kinegrade.grading.key import Ask, Exam, Examinee, Key, rule

FORMAT = 1
_NUMBER = re.compile(r"-?[0-9]{1,100}(?:\.[0-9]{1,100})?(?:[eE][+-]?[0-9]{1,2})?")
_RATIONAL = re.compile(r"-?[0-9]{1,300}(?:/[0-9]{0,299}[1-9][0-9]{0,299})?")
_IDENTIFIER = re.compile(r"[^\W\d][\w'\u2032-]{0,79}")
_COLUMNS_OF_GRADES = {"student", "name", "total", "out_of", "percent"}
_LARGEST_POWER = 300
_FIGURES = range(1, 16)
_AGREEMENT = 1e-9
_MENDING = "restore the exam folder as it was generated"
_KINDS: Mapping[type, str] = {str: "a text", list: "a list", dict: "an object", Decimal: "a number"}
Item = TypeVar("Item")


class _FieldError(Exception):
    """One fault in a file, to become one line of an ExamError."""


def read_exam(folder: Path) -> Exam:
    """Reads an exam folder made by `generate`; raises ExamError."""
    exam_text, key_text = _texts(folder)
    faults: list[str] = []
    exam = _head(exam_text, faults)
    questions = _each("exam.json: questions", _list(exam, "questions"), _question, faults)
    students = _each("exam.json: students", _list(exam, "students"), _student, faults)
    asks = [ask for question in questions for ask in question]
    lines = [line for line in key_text.split("\n") if line.strip()]
    papers = _each("key.jsonl: line", lines, partial(_paper, asks), faults) if not faults else []
    faults = faults or _repetitions(asks, students, papers) or _strangers(students, papers)
    if faults:
        raise ExamError(*(f"{folder}/{fault} - {_MENDING}" for fault in faults))
    keys = dict(papers)
    return Exam(tuple(asks), tuple(Examinee(student, name, keys[student]) for student, name in students))


def _texts(folder: Path) -> tuple[str, str]:
    texts, faults = [], []
    for name in ("exam.json", "key.jsonl"):
        try:
            texts.append((folder / name).read_text(encoding="utf-8"))
        except (OSError, UnicodeDecodeError) as fault:
            reason = fault.strerror if isinstance(fault, OSError) else "not UTF-8"
            faults.append(
                f"{folder / name}: cannot be read ({reason}) "
                "- expected an exam folder made by kinegrade generate - check the name"
            )
    if faults:
        raise ExamError(*faults)
    return texts[0], texts[1]


def _head(text: str, faults: list[str]) -> Any:
    try:
        exam = _json(text)
        if _field(exam, "format", Decimal) != FORMAT:
            raise _FieldError(
                f'"format" is {exam["format"]} - expected {FORMAT}, the only one this kinegrade reads'
            )
    except _FieldError as fault:
        faults.append(f"exam.json: {fault}")
        return {}
    faults += [
        f'exam.json: no list "{name}" - expected one that is not empty'
        for name in ("questions", "students")
        if not _list(exam, name)
    ]
    return exam


def _each(where: str, items: Iterable[Any], read: Callable[[Any], Item], faults: list[str]) -> list[Item]:
    """What `read` makes of each item; the faulty ones are listed and left out."""
    results = []
    for number, item in enumerate(items, 1):
        try:
            results.append(read(item))
        except _FieldError as fault:
            faults.append(f"{where} {number}: {fault}")
    return results


def _json(text: str) -> Any:
    """JSON whose numbers are Decimals, digit by digit as they stand."""
    try:
        return json.loads(text, parse_float=Decimal, parse_int=Decimal, parse_constant=_refuse_constant)
    except (ValueError, ArithmeticError, RecursionError) as fault:
        raise _FieldError(f"broken JSON ({fault}) - expected one JSON object") from fault


def _refuse_constant(name: str) -> Any:
    raise ValueError(f"{name} is not a number")


def _list(item: Any, name: str) -> Sequence[Any]:
    found = item.get(name) if isinstance(item, dict) else None
    return found if isinstance(found, list) else []


def _field(item: Any, name: str, kind: type[Item]) -> Item:
    found = item.get(name) if isinstance(item, dict) else None
    if not isinstance(found, kind):
        raise _FieldError(f'no "{name}" that is {_KINDS[kind]} - expected one')
    return found


def _identifier(item: Any, name: str) -> str:
    found = _field(item, name, str)
    if not _IDENTIFIER.fullmatch(found) or found in _COLUMNS_OF_GRADES:
        raise _FieldError(
            f'"{name}" is {found!r} - expected letters, digits, "_" and "-", and no column of grades.csv'
        )
    return found


def _amount(item: Any, name: str) -> Fraction:
    """A number, or a text that spells one (a decimal or a plain fraction), exactly."""
    found = item.get(name) if isinstance(item, dict) else None
    amount = _exactly(found) if isinstance(found, Decimal | str) else None
    if amount is None:
        raise _FieldError(f'"{name}" is {found!r} - expected a number')
    return amount


@lru_cache(maxsize=4096)  # points and tolerances repeat on every paper
def _exactly(text: Decimal | str) -> Fraction | None:
    if isinstance(text, Decimal):
        return Fraction(text) if text.is_finite() and abs(text.adjusted()) <= _LARGEST_POWER else None
    return Fraction(text) if _NUMBER.fullmatch(text) or _RATIONAL.fullmatch(text) else None


def _not_negative(item: Any, name: str) -> Fraction:
    amount = _amount(item, name)
    if amount < 0:
        raise _FieldError(f'"{name}" is {item[name]} - expected zero or more')
    return amount


def _question(item: Any) -> list[Ask]:
    question = _identifier(item, "question")
    asks = _field(item, "asks", list)
    if not asks:
        raise _FieldError(f"question {question} asks nothing - expected at least one ask")
    return [
        Ask(question, _identifier(ask, "ask"), _field(ask, "unit", str), _not_negative(ask, "points"), _sign(ask))
        for ask in asks
    ]


def _sign(ask: Any) -> str:
    """The sign convention; exams of earlier versions do not state it."""
    return _field(ask, "sign", str) if isinstance(ask, dict) and "sign" in ask else ""


def _student(item: Any) -> tuple[str, str]:
    student = _field(item, "student", str)
    if not student_key(student):
        raise _FieldError('"student" is empty - expected an id')
    return student, _field(item, "name", str)


def _paper(asks: Sequence[Ask], line: str) -> tuple[str, Mapping[str, Key]]:
    paper = _json(line)
    student = _field(paper, "student", str)
    found = {
        f"{_field(question, 'question', str)}.{name}": entry
        for question in _field(paper, "questions", list)
        for name, entry in _field(question, "asks", dict).items()
    }
    if found.keys() != {ask.column for ask in asks}:
        odd = ", ".join(sorted(found.keys() ^ {ask.column for ask in asks}))
        raise _FieldError(f'student "{student}": the asks differ from exam.json in {odd} - expected the same')
    try:
        return student, {ask.column: _key(ask, found[ask.column]) for ask in asks}
    except _FieldError as fault:
        raise _FieldError(f'student "{student}": {fault}') from fault


def _key(ask: Ask, entry: Any) -> Key:
    try:
        if _field(entry, "unit", str) != ask.unit or _amount(entry, "points") != ask.points:
            raise _FieldError("unit or points differ from exam.json - expected the same")
        value = _value(entry)
        tolerance = _field(entry, "tolerance", dict)
        relative, absolute = _not_negative(tolerance, "relative"), _not_negative(tolerance, "absolute")
        period = _not_negative(entry, "period") if "period" in entry else None
        figures, mistakes = _figures(tolerance), _mistakes(entry)
    except _FieldError as fault:
        raise _FieldError(f"{ask.column}: {fault}") from fault
    return rule(relative, absolute, figures).key(value, period, mistakes)


def _figures(tolerance: Any) -> int | None:
    """To how many significant figures an answer has to agree with the right one, where that is asked for."""
    if "figures" not in tolerance:
        return None
    figures = tolerance["figures"]
    if not isinstance(figures, Decimal) or figures not in _FIGURES:
        raise _FieldError(f'"figures" is {figures!r} - expected a whole number from 1 to 15')
    return int(figures)


def _mistakes(entry: Any) -> Mapping[str, Fraction]:
    """What known mistakes lead to, by the mistake's id; exams of earlier versions do not state it."""
    if "mistakes" not in entry:
        return {}
    mistakes = _field(entry, "mistakes", dict)
    return {name: _amount(mistakes, name) for name in mistakes}


def _value(entry: Any) -> Fraction:
    """The exact value where it is a plain number, else the decimal text, else the value's own digits."""
    exact = entry.get("exact")
    texts = {"exact": exact if isinstance(exact, str) and _RATIONAL.fullmatch(exact) else None}
    texts |= {name: entry.get(name) for name in ("decimal", "value")}
    values = {name: _amount(texts, name) for name, text in texts.items() if text is not None}
    if not values:
        raise _FieldError('neither "decimal" nor "value" is there - expected the right answer')
    first, *others = values.values()
    if not all(isclose(first, other, rel_tol=_AGREEMENT) for other in others):  # a check only: floats will do
        raise _FieldError(f"{', '.join(values)} say different numbers - expected one and the same")
    return first


def _repetitions(
    asks: Sequence[Ask], students: Sequence[tuple[str, str]], papers: Sequence[tuple[str, Any]]
) -> list[str]:
    kinds = {
        "exam.json: ask": [ask.column for ask in asks],
        "exam.json: student": [student_key(student) for student, _ in students],
        "key.jsonl: student": [student for student, _ in papers],
    }
    return [
        f'{kind} "{name}" stands there {count} times - expected once'
        for kind, names in kinds.items()
        for name, count in Counter(names).items()
        if count > 1
    ]


def _strangers(students: Sequence[tuple[str, str]], papers: Sequence[tuple[str, Any]]) -> list[str]:
    known, keyed = {student for student, _ in students}, {student for student, _ in papers}
    return [
        *(f'key.jsonl: no line for student "{who}" - expected one' for who in sorted(known - keyed)),
        *(
            f'key.jsonl: student "{who}" is not in exam.json - expected only its students'
            for who in sorted(keyed - known)
        ),
    ]
