"""The students of a class by their e-mail addresses, which a mark by hand may name them by."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from kinegrade.exam.folder.records import Candidate
from kinegrade.files.cell_text import make_header_key


@dataclass(frozen=True)
class Addresses:
    """Those of these students; they are compared once a mark names somebody by none of the ids."""

    students: Sequence[Candidate]

    def find(self, cell: str) -> str | None:
        """The student with that address, where no other has it."""
        return self._known.get(make_header_key(cell))

    @cached_property
    def _known(self) -> Mapping[str, str]:
        listed = [(make_header_key(each.email), each.student) for each in self.students]
        counted = Counter(address for address, _ in listed)
        return {address: each for address, each in listed if address and counted[address] == 1}
