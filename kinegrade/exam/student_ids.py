"""Student ids as files of answers hold them: what a spreadsheet or a form made of them, traced back
to one student.

Used wherever answers come in. A spreadsheet eats leading zeros, people change case, exports wrap
ids as ="007". Such an id is restored where it can mean one student only; where it can mean two,
nobody is guessed.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping

from kinegrade.exam.roster import student_key
from kinegrade.tables import shortened, trimmed

# As programs write a column of numbers with gaps
_WRITTEN_AS_FRACTION = re.compile(r"([0-9]+)\.0+")
_WRAPPED = re.compile(r"""=\s*"(.*)"|['#](.*)""", re.DOTALL)


def unwrapped(identifier: str) -> str:
    r"""An id without what keeps spreadsheets from eating its zeros: ="007", '007 and #007 are 007.

    >>> unwrapped('="0012345"'), unwrapped("#0012345")
    ('0012345', '0012345')
    """
    found = _WRAPPED.fullmatch(student_key(identifier))
    return student_key(found[1] or found[2] or "") if found else student_key(identifier)


class StudentIds:
    """The ids of a class.

    >>> ids = StudentIds(["0012345", "S9"])
    >>> ids.exact('="0012345"'), ids.exact("12345"), ids.near("12345"), ids.near("s9")
    ('0012345', None, ('0012345',), ('S9',))
    """

    def __init__(self, students: Iterable[str]) -> None:
        self._exact: dict[str, str] = {}
        near: dict[str, list[str]] = defaultdict(list)
        for student in students:
            self._exact.setdefault(student_key(student), student)
            near[_bare(student_key(student))].append(student)
        self._near = {bare: tuple(found) for bare, found in near.items()}

    def exact(self, cell: str) -> str | None:
        """The student with that id, wrapped or not, in full-width digits or not."""
        known = self._exact
        return known.get(cell) or known.get(student_key(cell)) or known.get(unwrapped(cell))

    def near(self, cell: str) -> tuple[str, ...]:
        """The students whose ids differ from a cell by leading zeros, case or a final .0 alone."""
        bare = _bare(unwrapped(cell))
        return self._near.get(bare, ()) if bare else ()

    def restored(self, cells: Iterable[str], taken: Collection[str]) -> Mapping[str, str]:
        """Of cells that are no ids those that can mean one student only, with that student.

        `taken` are the students whose own ids stand in the same file: for them nothing is restored.
        Neither is it where two different cells would mean the same student.
        """
        meant: dict[str, set[str]] = defaultdict(set)
        for cell in cells:
            near = self.near(cell)
            if len(near) == 1 and near[0] not in taken:
                meant[near[0]].add(cell)
        found: dict[str, str] = {}
        for student, spellings in meant.items():
            if len({student_key(spelling) for spelling in spellings}) == 1:
                found |= dict.fromkeys(sorted(spellings), student)
        return found


def restoration(restored: Mapping[str, str]) -> tuple[str, str]:
    """What is said once of a file whose ids were restored: what was found, and what was done.

    >>> restoration({"12345": "0012345"})[0]
    '1 student id is not as in the exam: "12345" for "0012345"'
    """
    cell, student = next(iter(restored.items()))
    example = f'"{shortened(trimmed(cell))}" for "{student}"'
    if len(restored) == 1:
        found = f"1 student id is not as in the exam: {example}"
        taken = "taken for this student, as it can mean nobody else"
    else:
        found = f"{len(restored)} student ids are not as in the exam, such as {example}"
        taken = "taken for these students, as each can mean one only"
    return found, f"{taken}; keep ids as text, as in answers.xlsx"


def _bare(key: str) -> str:
    number = _WRITTEN_AS_FRACTION.fullmatch(key)
    return (number[1] if number else key.casefold()).lstrip("0")
