"""Student ids as files of answers hold them: what a spreadsheet or a form made of them, traced back
to one student.

Used wherever answers come in. Spreadsheets drop leading zeros, people change case, exports wrap ids
as ="007". Such an id is restored if it can mean only one student; if it can mean two, there is no
guessing.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType

from kinegrade.exam.roster.students import make_student_key, make_student_keys
from kinegrade.files.cell_text import shorten, trim
from kinegrade.language.message import Message, Quoted

# As programs write a column of numbers with gaps
_WRITTEN_AS_FRACTION = re.compile(r"([0-9]+)\.0+")
_LOOK_ALIKES = str.maketrans("ILO", "110")
_NONE: Mapping[str, str] = MappingProxyType({})
_WRAPPED = re.compile(r"""=\s*"(.*)"|['#](.*)""", re.DOTALL)


def _unwrap(identifier: str) -> str:
    r"""An id without what keeps spreadsheets from dropping its zeros: ="007", '007 and #007 are
    007.

    >>> _unwrap('="0012345"'), _unwrap("#0012345")
    ('0012345', '0012345')
    """
    found = _WRAPPED.fullmatch(make_student_key(identifier))
    return make_student_key(found[1] or found[2] or "") if found else make_student_key(identifier)


class StudentIds:
    """The ids of a class, and the students by the codes of their papers, which stand for ids, and
    by `former` ids, which files may still have.

    >>> ids = StudentIds(["0012345", "S9"], {"K0Q1-9FHM": "S9"})
    >>> ids.exact('="0012345"'), ids.exact("12345"), ids.near("12345"), ids.near("s9")
    ('0012345', None, ('0012345',), ('S9',))
    >>> ids.exact("kOql 9fhm")
    'S9'
    >>> renamed = StudentIds(["0077"], {}, {"0012345": "0077"})
    >>> renamed.formerly("0012345"), renamed.formerly("12345"), renamed.near("12345")
    ('0077', None, ('0077',))
    """

    def __init__(
        self,
        students: Iterable[str],
        codes: Mapping[str, str],
        former: Mapping[str, str] = _NONE,
    ) -> None:
        self._students, self._codes, self._former = tuple(students), codes, former

    @cached_property
    def _exact(self) -> Mapping[str, str]:
        """The students by their ids as they are compared; of equal ones the first."""
        keys = make_student_keys(self._students)
        return dict(zip(reversed(keys), reversed(self._students), strict=True))

    @cached_property
    def _coded(self) -> Mapping[str, str]:
        """The students by the codes of their papers; in most files every id is exact."""
        return {_fold_code(code): student for code, student in self._codes.items()}

    @cached_property
    def _near(self) -> Mapping[str, tuple[str, ...]]:
        """The students by what is left of their ids where spreadsheets strip them."""
        near: dict[str, dict[str, None]] = defaultdict(dict)
        for student in self._students:
            near[_strip(make_student_key(student))][student] = None
        for before, student in self._former.items():
            near[_strip(make_student_key(before))][student] = None
        return {stripped: tuple(found) for stripped, found in near.items()}

    def exact(self, cell: str) -> str | None:
        """The student with that id, wrapped or not, in full-width digits or not; else the one whose
        paper has that code.
        """
        known = self._exact
        found = known.get(cell) or known.get(make_student_key(cell)) or known.get(_unwrap(cell))
        return found or self.coded(cell)

    @cached_property
    def _former_keys(self) -> Mapping[str, str]:
        return {make_student_key(before): student for before, student in self._former.items()}

    def formerly(self, cell: str) -> str | None:
        """The student who had that id, which nobody else is given."""
        return self._former_keys.get(_unwrap(cell)) if self.exact(cell) is None else None

    def all_exact(self, cells: Sequence[str]) -> list[str | None]:
        """The same for many cells."""
        found = [*map(self._exact.get, cells)]
        if None in found:
            return [at_once or self.exact(cell) for at_once, cell in zip(found, cells, strict=True)]
        return found

    def coded(self, cell: str) -> str | None:
        """The student whose paper has that code, however it is spaced."""
        return self._coded.get(_fold_code(cell))

    def near(self, cell: str) -> tuple[str, ...]:
        """The students whose ids, or former ones, differ from a cell by leading zeros, case or a
        final .0 alone.
        """
        stripped = _strip(_unwrap(cell))
        return self._near.get(stripped, ()) if stripped else ()

    def restored(self, cells: Iterable[str], taken: Collection[str]) -> Mapping[str, str]:
        """The cells that are not ids but can mean only one student, with that student: all that are
        former ids, and of those that nearly are one.

        `taken` are the students whose exact ids are in the same file: no cell that nearly is an id
        is restored to them, nor are two different ones to the same student.
        """
        meant: dict[str, set[str]] = defaultdict(set)
        found: dict[str, str] = {}
        for cell in cells:
            near, student = self.near(cell), self.formerly(cell)
            if student is not None:
                found[cell] = student
            elif len(near) == 1 and near[0] not in taken:
                meant[near[0]].add(cell)
        for student, spellings in meant.items():
            if len({make_student_key(spelling) for spelling in spellings}) == 1:
                found |= dict.fromkeys(sorted(spellings), student)
        return found

    def describe_restored(self, restored: Mapping[str, str]) -> Iterator[tuple[Message, Message]]:
        """What is said of a file whose ids were restored, and what was done: of those that students
        had before, and of those that a spreadsheet or a person changed.
        """
        before = {(_strip(make_student_key(each)), now) for each, now in self._former.items()}
        before -= {(_strip(make_student_key(each)), each) for each in self._students}
        renamed = {
            cell: student
            for cell, student in restored.items()
            if (_strip(_unwrap(cell)), student) in before
        }
        changed = {cell: restored[cell] for cell in restored if cell not in renamed}
        if renamed:
            cell, student = next(iter(renamed.items()))
            count, shown = len(renamed), Quoted(shorten(trim(cell)))
            what = Message("roster.ids-before", count=count, cell=shown, student=Quoted(student))
            yield what, Message("roster.ids-before-done", count=count)
        if changed:
            yield describe_restoration(changed)


def find_zero_twins(students: Iterable[str]) -> Iterator[tuple[str, ...]]:
    """Ids that differ by zeros in front alone, as where a spreadsheet dropped them in one place.

    >>> list(find_zero_twins(["0012", "S9", "12", "7"]))
    [('0012', '12')]
    """
    alike: dict[str, dict[str, None]] = defaultdict(dict)
    for key in map(make_student_key, students):
        if key.isdecimal():
            alike[key.lstrip("0")][key] = None
    yield from (tuple(found) for found in alike.values() if len(found) > 1)


def describe_restoration(restored: Mapping[str, str]) -> tuple[Message, Message]:
    """The one message about a file whose ids were restored: what was found, and what was done."""
    cell, student = next(iter(restored.items()))
    count, shown = len(restored), Quoted(shorten(trim(cell)))
    found = Message("roster.ids-restored", count=count, cell=shown, student=Quoted(student))
    return found, Message("roster.ids-restored-done", count=count)


def _fold_code(text: str) -> str:
    """A code of a paper as it is compared: letters that codes do not have are the digits that they
    look like.
    """
    letters = (each for each in make_student_key(text).upper() if each.isalnum())
    return "".join(letters).translate(_LOOK_ALIKES)


def _strip(key: str) -> str:
    number = _WRITTEN_AS_FRACTION.fullmatch(key)
    return (number[1] if number else key.casefold()).lstrip("0")
