"""Ids that nobody new may have: one that is another's but for zeros in front, and one that another
student had before.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from kinegrade.exam.roster.student_ids import find_zero_twins
from kinegrade.exam.roster.students import make_student_key
from kinegrade.language.message import Fault, Message, Quoted


def list_twins(
    students: Collection[str], newcomer: str, where: str, do: Message
) -> Iterator[Fault]:
    """That one of the students has the newcomer's id but for zeros in front."""
    for twins in find_zero_twins((newcomer, *students)):
        if make_student_key(newcomer) == twins[0]:
            what = Message("exam.zero-twin", student=Quoted(newcomer), other=Quoted(twins[1]))
            yield Fault(where, what, do=do)


def list_former_owners(former_ids: Mapping[str, str], newcomer: str, where: str) -> Iterator[Fault]:
    """That another student had this id before, which files of answers and marks may still have."""
    now = {make_student_key(before): owner for before, owner in former_ids.items()}
    owner = now.get(make_student_key(newcomer))
    if owner is not None:
        what = Message("exam.former-id", student=Quoted(newcomer), now=Quoted(owner))
        yield Fault(where, what, do=Message("exam.id-nobody-had"))
