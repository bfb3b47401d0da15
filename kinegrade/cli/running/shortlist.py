"""Complaints as a terminal shows them: ten of a kind, and how many more of it stand in the file."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import assert_never

from kinegrade.errors import Problem
from kinegrade.files.tables import Complaint
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.layout import COMPLAINTS

_SHOWN = 10  # of a kind
_PARTICULARS = re.compile(r'"[^"]*"|[-+0-9.,/^*√π()]*[0-9][-+0-9.,/^*√π()]*')


def shorten_list(complaints: Sequence[Complaint], marks: Path) -> tuple[Problem, ...]:
    """The complaints in their order, at most SHOWN of each kind; the folder `marks` has all.

    Complaints are of one kind if they say the same about different cells, students or numbers.
    """
    kinds: dict[str, list[Complaint]] = defaultdict(list)
    shown: list[Problem] = []
    for complaint in complaints:
        kind = _find_kind(complaint.problem)
        kinds[kind].append(complaint)
        if len(kinds[kind]) <= _SHOWN:
            shown.append(complaint.fault)
    for each in kinds.values():
        if len(each) > _SHOWN:
            shown.append(
                Message(
                    "terminal.more-alike",
                    count=len(each) - _SHOWN,
                    first=each[0].fault,
                    file=str(marks / COMPLAINTS.name),
                )
            )
    return tuple(shown)


def _find_kind(problem: Text) -> str:
    match problem:
        case Message():
            return problem.key
        case str():
            return _PARTICULARS.sub("…", problem)
        case _:
            assert_never(problem)
