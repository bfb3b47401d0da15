"""The tables `[late]` and `[tries]` of a policy.

[late]
due = "2026-12-01 18:00 +01:00"
grace = "15 min"
penalty = "10 %"
per = "day"
at-most = "50 %"
extensions = { 1002 = "2 days", 1003 = "2026-12-05 18:00 +01:00" }

[tries]
penalty = "5 %"
at-most = "20 %"
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime, timedelta
from fractions import Fraction
from typing import get_args

from kinegrade.deadlines.duration import read_duration
from kinegrade.deadlines.moment import parse_moment, read_moment
from kinegrade.errors import FieldError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import choice, found, share
from kinegrade.grading.lateness.rule import Base, LateRule, Penalties, Per, TryRule
from kinegrade.language.message import Message, Quoted

LATE = (
    #: When it is due; where it is not stated, the date of the bank.
    "due",
    #: How much later costs nothing: `"15 min"`, `"2 h"`, `"1 day"`.
    "grace",
    #: What each begun unit of time costs, a share of the points: `"10 %"`.
    "penalty",
    #: The unit of time: `"day"`, where it is not stated, `"hour"`, `"week"`, or `"once"`, however
    #: late.
    "per",
    #: What being late costs at most, a share of the points; all of them where it is not stated.
    "at-most",
    #: What the shares are of: `"maximum"`, the points that could be had, where it is not stated, or
    #: `"total"`, those that were reached; the same for `[tries]`.
    "of",
    #: Students who have more time, by id: `{ 1002 = "2 days", 1003 = "2026-12-05 18:00" }`.
    "extensions",
)
TRIES = (
    #: What each submission after the first costs, a share of the points: `"5 %"`.
    "penalty",
    #: What they cost at most.
    "at-most",
    #: What the shares are of, as under `[late]`, where it may stand instead: it is one for both.
    "of",
)
_PER: tuple[Per, ...] = get_args(Per)
_BASES: tuple[Base, ...] = get_args(Base)
_LIKE_LATE = '{ penalty = "10 %", per = "day" }'
_LIKE_TRIES = '{ penalty = "5 %" }'
_WHOLE = Fraction(1)
_NO_TIME = timedelta(0)


def read_penalties(table: Table, exam: ExamFolder) -> Penalties:
    """What a policy subtracts for being late and for trying again; nothing after a fault."""
    stated = table.table("late", _LIKE_LATE).only(*LATE)
    tried = table.table("tries", _LIKE_TRIES).only(*TRIES)
    late = _read_late(stated, exam) if "late" in table else None
    tries = _read_tries(tried) if "tries" in table else None
    return Penalties(late, tries, _read_base(stated, tried))


def _read_base(late: Table, tries: Table) -> Base:
    """What the shares of both are of; notes that they differ."""
    one, other = (each.optional("of", choice(_BASES)) for each in (late, tries))
    if one and other and one != other:
        what = Message("deadline.other-base", tries=Quoted(other), late=Quoted(one))
        tries.fault("of", what, do=Message("deadline.one-entry"))
    return one or other or "maximum"


def _read_late(stated: Table, exam: ExamFolder) -> LateRule | None:
    due = stated.optional("due", read_moment) or parse_moment(exam.head.due)
    if due is None and "due" not in stated:
        stated.missing("due", Message("deadline.no-due"))
    penalty = stated.required("penalty", share)
    grace = stated.with_default("grace", read_duration, _NO_TIME)
    per: Per = stated.with_default("per", choice(_PER), "day")
    most = stated.with_default("at-most", share, _WHOLE)
    extensions = _read_extensions(stated, exam, due)
    if due is None or penalty is None:
        return None
    return LateRule(due, penalty, per, most, grace, extensions)


def _read_extensions(
    stated: Table, exam: ExamFolder, due: datetime | None
) -> Mapping[str, datetime]:
    """When it is due for students who have more time."""
    table = stated.table("extensions", '{ 1002 = "2 days" }')
    unknown = Message("deadline.unknown-student")
    ids = (*exam.students, *exam.former_ids)
    known = table.only(*ids, unknown=unknown) if table else table

    def read(value: object) -> datetime:
        moment = parse_moment(value.strip()) if isinstance(value, str) else None
        moment = value if isinstance(value, datetime) else moment
        if moment is None:
            return (due or datetime.min) + _read_more_time(value)
        if due is not None and (moment.tzinfo is None) != (due.tzinfo is None):
            raise FieldError(found(value), Message("deadline.as-due"))
        return moment

    return _by_present_ids(known.entries(read), exam.former_ids, known)


def _by_present_ids(
    read: Mapping[str, datetime], former_ids: Mapping[str, str], table: Table
) -> Mapping[str, datetime]:
    """What was read by the ids that students have now; notes who has two entries."""
    for before, now in former_ids.items():
        if {before, now} <= read.keys():
            what = Message("deadline.same-student", student=Quoted(now))
            table.fault(before, what, do=Message("deadline.one-entry"))
    return {former_ids.get(student, student): moment for student, moment in read.items()}


def _read_more_time(value: object) -> timedelta:
    try:
        return read_duration(value)
    except FieldError as error:
        raise FieldError(error.what, Message("deadline.an-extension")) from error


def _read_tries(stated: Table) -> TryRule | None:
    penalty = stated.required("penalty", share)
    most = stated.with_default("at-most", share, _WHOLE)
    return None if penalty is None else TryRule(penalty, most)
