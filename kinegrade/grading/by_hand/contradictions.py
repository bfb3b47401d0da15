"""Marks by hand that say two things of the same."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.grading.by_hand.hand_file import GIVE_NEW, HandRow
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.numbers.amounts import write_amount


def find_contradictions(rows: Iterable[HandRow]) -> Iterator[Fault]:
    """Two marks of one student for the same thing with different points, and a mark for a question
    as a whole beside one for a part of it: whether a policy lets them count or not, as one of them
    would be lost among those that are kept.
    """
    seen: dict[tuple[str, str], HandRow] = {}
    parts: dict[tuple[str, str], HandRow] = {}
    for row in rows:
        mark = row.mark
        before = seen.setdefault((mark.student, mark.column), row)
        if before.mark.points != mark.points:
            yield _explain_twice(before, row)
        if mark.ask:
            parts.setdefault((mark.student, mark.question), row)
    for (student, question), part in parts.items():
        if (student, question) in seen:
            yield _explain_whole_and_part(seen[student, question], part)


def _explain_twice(first: HandRow, second: HandRow) -> Fault:
    what = Message(
        "marking.twice-by-hand",
        student=Quoted(second.mark.student),
        column=second.mark.column,
        here=write_amount(second.mark.points),
        there=write_amount(first.mark.points),
        place=first.where,
    )
    carried = first.carried or second.carried
    return Fault(second.where, what, do=GIVE_NEW if carried else Message("marking.keep-one"))


def _explain_whole_and_part(whole: HandRow, part: HandRow) -> Fault:
    what = Message(
        "marking.whole-and-part",
        student=Quoted(part.mark.student),
        column=part.mark.column,
        place=whole.where,
    )
    carried = whole.carried or part.carried
    do = Message("marking.give-whole" if carried else "marking.keep-one")
    return Fault(part.where, what, do=do)
