"""What a quiz needs of an exam folder besides the papers' own lines of the key: title, templates,
who has a paper.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from hashlib import sha256
from hmac import digest
from itertools import islice
from pathlib import Path
from typing import Any

from kinegrade.errors import ExamError, TemplateError, TomlError
from kinegrade.exact.written import NumberError, written_number, written_text
from kinegrade.exam.exam_secret import secret_of
from kinegrade.fields.toml_text import read_toml
from kinegrade.language import Language, exam_language_of
from kinegrade.problem.library import kept_template
from kinegrade.problem.template import Template
from kinegrade.problem.tolerance import Tolerance

FORMAT = 1
DIGITS = 8  # hexadecimal, of the identifier
LOOKED_AT = 64  # papers from which the bank's tolerances are seen, which zero answers widen
BROKEN = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError)
MENDING = "expected it as kinegrade generate wrote it - restore the exam folder"


@dataclass(frozen=True)
class QuizSource:
    """An exam folder; `identifier` tells it from other exams.

    It is of the bank and of what the papers' codes are made from, which tells nothing of the secret
    that draws the numbers: another exam of the same bank is another one, and whoever is on the
    roster in whatever order changes nothing.

    `templates` and `names` go by question and by student, `tolerances` by question and ask,
    `credits`, the shares of the points that the bank gives for known mistakes, by mistake.
    """

    folder: Path
    identifier: str
    language: Language
    title: str
    course: str
    versions: tuple[str, ...]
    templates: Mapping[str, Template]
    names: Mapping[str, str]
    tolerances: Mapping[tuple[str, str], Tolerance]
    credits: Mapping[str, Fraction]


def read_quiz_source(folder: Path, language: Language | None = None) -> QuizSource:
    """Reads exam.json, bank.toml and the templates; in the papers' language unless another one is
    wanted.

    Raises ExamError, with the faults of all templates.
    """
    head = _head(folder / "exam.json")
    bank = _text(folder / "bank.toml")
    title, course = (str(head.get(name, "")) for name in ("title", "course"))
    try:
        templates = _templates(folder, head)
        names = {
            str(student["student"]): written_text(student["name"]) for student in head["students"]
        }
        identifier = _identifier(head, bank)
        versions = tuple(map(str, head.get("versions", ())))
        credits = {
            str(name): written_number(share)
            for name, share in head.get("credit", {}).get("mistakes", {}).items()
        }
    except BROKEN as fault:
        raise ExamError(
            f"{folder / 'exam.json'}: is broken ({type(fault).__name__}: {fault}) - {MENDING}"
        ) from fault
    spoken = exam_language_of(head, folder / "exam.json")
    if language and language != spoken:
        title, course = _translated(bank, language, title, course)
    return QuizSource(
        folder,
        identifier,
        language or spoken,
        title,
        course,
        versions,
        templates,
        names,
        _tolerances(folder),
        credits,
    )


def key_lines(folder: Path) -> Iterator[tuple[int, str]]:
    """The lines of key.jsonl, one for each paper, with their numbers. Raises ExamError."""
    try:
        with (folder / "key.jsonl").open(encoding="utf-8") as lines:
            yield from (
                (number, line) for number, line in enumerate(lines, start=1) if line.strip()
            )
    except (OSError, UnicodeDecodeError) as fault:
        raise unreadable(folder / "key.jsonl", fault) from fault


def key_record(folder: Path, number: int, line: str) -> dict[str, Any]:
    """A line of key.jsonl, its numbers as the texts that stand there. Raises ExamError."""
    try:
        record: dict[str, Any] = json.loads(line, parse_float=str, parse_int=str)
        return {
            "student": record["student"],
            "paper": record["paper"],
            "questions": record["questions"],
            **record,
        }
    except BROKEN as fault:
        raise _broken_line(folder, number, fault) from fault


def tolerance_of(ask: Mapping[str, Any]) -> Tolerance:
    """The tolerance of an ask's entry in the key."""
    stated = ask["tolerance"]
    figures = int(stated["figures"]) if "figures" in stated else None
    return Tolerance(
        written_number(stated["relative"]), written_number(stated["absolute"]), figures
    )


def unreadable(path: Path, fault: Exception) -> ExamError:
    """The refusal of a file that cannot be read."""
    reason = fault.strerror if isinstance(fault, OSError) else "not UTF-8"
    return ExamError(
        f"{path}: cannot be read ({reason}) - expected an exam folder made by kinegrade generate "
        "- check the name"
    )


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as fault:
        raise unreadable(path, fault) from fault


def _head(path: Path) -> dict[str, Any]:
    try:
        head: dict[str, Any] = json.loads(_text(path))
        if head["format"] != FORMAT:
            raise ValueError(
                f'"format" is {head["format"]!r}, and {FORMAT} is the only one this kinegrade reads'
            )
    except BROKEN as fault:
        raise ExamError(
            f"{path}: is broken ({type(fault).__name__}: {fault}) - {MENDING}"
        ) from fault
    return head


def _identifier(head: Mapping[str, Any], bank: str) -> str:
    """What tells the exam from others; of a folder whose secret was taken out of it, by the first
    paper's code.
    """
    secret = secret_of(head)
    if secret is None:
        return sha256(f"{head['students'][0]['paper']}\n{bank}".encode()).hexdigest()[:DIGITS]
    return digest(secret.coding.encode(), f"quiz\n{bank}".encode(), "sha256").hex()[:DIGITS]


def _translated(bank: str, language: Language, *texts: str) -> tuple[str, ...]:
    """Title and course in another language, where the bank has them in it."""
    try:
        table = read_toml(bank)
    except TomlError:
        return texts
    found = (table.get(name) for name in ("title", "course"))
    return tuple(
        str(stated[language]) if isinstance(stated, dict) and language in stated else text
        for stated, text in zip(found, texts, strict=True)
    )


def _templates(folder: Path, head: Mapping[str, Any]) -> dict[str, Template]:
    """The templates by question."""
    found: dict[str, Template] = {}
    faults: list[str] = []
    for question in head["questions"]:
        try:
            found[str(question["question"])] = kept_template(
                str(question["template"]), folder / "templates"
            )
        except TemplateError as error:
            faults += error.problems
    if faults:
        raise ExamError(*(f"{folder}: {fault}" for fault in faults))
    return found


def _tolerances(folder: Path) -> dict[tuple[str, str], Tolerance]:
    """By question and ask the least that is allowed: where the answer is no zero, what the bank
    says.
    """
    found: dict[tuple[str, str], Tolerance] = {}
    for number, line in islice(key_lines(folder), LOOKED_AT):
        record = key_record(folder, number, line)
        try:
            for place, tolerance in _stated_tolerances(record):
                if place not in found or tolerance.absolute < found[place].absolute:
                    found[place] = tolerance
        except BROKEN as fault:
            raise _broken_line(folder, number, fault) from fault
    return found


def _stated_tolerances(record: Mapping[str, Any]) -> Iterator[tuple[tuple[str, str], Tolerance]]:
    """The tolerances of one paper by question and ask; raises one of BROKEN for what is none."""
    for question in record["questions"]:
        for name, ask in question["asks"].items():
            yield (str(question["question"]), name), tolerance_of(ask)


def _broken_line(folder: Path, number: int, fault: Exception) -> ExamError:
    reason = (
        f"{type(fault).__name__}: {fault}"
        if isinstance(fault, NumberError)
        else type(fault).__name__
    )
    return ExamError(f"{folder / 'key.jsonl'}:{number}: is broken ({reason}) - {MENDING}")
