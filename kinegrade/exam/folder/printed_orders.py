"""The order of the questions on shuffled papers."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

import msgspec

from kinegrade.exam.choices import Choice, fits_paper
from kinegrade.exam.folder.asks import list_questions
from kinegrade.exam.folder.faults import AS_GENERATED, explain_broken, explain_unreadable, name_line
from kinegrade.exam.folder.records import ExamHead
from kinegrade.language.message import Fault, Message

_STATED = b'"printed"'


class _Order(msgspec.Struct, gc=False):
    student: str
    printed: tuple[str, ...]


def read_printed_orders(
    key: Path, questions: tuple[str, ...], choices: Collection[Choice] = ()
) -> Mapping[str, tuple[str, ...]]:
    """The orders that differ from that of the bank's `questions`, by student; of `choices` papers
    hold only some.

    Raises ExamError for a paper that states other questions.
    """
    try:
        with key.open("rb") as lines:
            orders = dict(_read_orders(key, enumerate(lines, 1), questions, choices))
    except OSError as fault:
        raise explain_unreadable(key, fault) from fault
    return {student: order for student, order in orders.items() if order != questions}


def read_held_questions(key: Path, head: ExamHead) -> Mapping[str, tuple[str, ...]]:
    """The questions of each paper, by student, where the exam has alternatives; else nothing.

    Raises ExamError for a paper that states other questions.
    """
    if not head.choices:
        return {}
    return read_printed_orders(key, list_questions(head.asks), head.choices)


def _read_orders(
    key: Path,
    lines: Iterator[tuple[int, bytes]],
    questions: tuple[str, ...],
    choices: Collection[Choice],
) -> Iterator[tuple[str, tuple[str, ...]]]:
    decode = msgspec.json.Decoder(_Order).decode
    for number, line in lines:
        if line.isspace():
            continue
        # All papers of an exam state their order or none does; reading on would cost as much as
        # marking
        if _STATED not in line:
            return
        try:
            found = decode(line)
            if not fits_paper(found.printed, questions, choices):
                raise ValueError
        except (ValueError, RecursionError) as fault:
            wrong = Fault(name_line(number), Message("exam.not-an-order"), AS_GENERATED)
            raise explain_broken(key, [wrong]) from fault
        yield found.student, found.printed
