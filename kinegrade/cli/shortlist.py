"""Complaints as a terminal shows them: ten of a kind, and how many more of it stand in the file."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

from kinegrade.language.message import Message, Text
from kinegrade.tables import Complaint

_SHOWN = 10  # of a kind
_PARTICULARS = re.compile(r'"[^"]*"|[-+0-9.,/^*√π()]*[0-9][-+0-9.,/^*√π()]*')


def shorten_list(complaints: Sequence[Complaint], file: Path) -> tuple[Text, ...]:
    """The complaints in their order, at most SHOWN of each kind; `file` has all of them.

    Complaints are of one kind if they say the same about different cells, students or numbers.
    """
    kinds: dict[str, list[Complaint]] = defaultdict(list)
    shown: list[Text] = []
    for complaint in complaints:
        kind = _PARTICULARS.sub("…", complaint.problem)
        kinds[kind].append(complaint)
        if len(kinds[kind]) <= _SHOWN:
            shown.append(str(complaint))
    for each in kinds.values():
        if len(each) > _SHOWN:
            shown.append(
                Message(
                    "terminal.more-alike",
                    count=len(each) - _SHOWN,
                    first=str(each[0]),
                    file=str(file),
                )
            )
    return tuple(shown)
