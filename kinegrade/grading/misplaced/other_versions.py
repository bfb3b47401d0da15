"""Students of one version among the answers to another: a learning management system has a file of
answers for each version of a quiz, and whoever sat another version than their own is in its file.

Whether a file is that of a version is decided by how many of its students have that version, which
chance has to explain hardly ever. No mark is changed.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import exp, lgamma, log

from kinegrade.files.tables import Complaint
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.language.message import Message

_LEAST = 5  # students in a file: fewer may have the same version by chance
_LEVEL = 0.01  # chance that a file of students of all versions is held to be that of one
_FEW = 0.25  # of a file's students: more of them are of a class, not of one version


@dataclass(frozen=True)
class OtherVersions:
    """The answers of a class whose `students`, by id, have these `versions`, in the order of the
    rows.
    """

    students: Sequence[str]
    versions: Sequence[str]
    answers: ClassAnswers

    def list_complaints(self) -> Iterator[Complaint]:
        """A complaint for each student of a version in the file of another."""
        total = Counter(self.versions)
        for rows in self._rows_by_file().values():
            counts = Counter(self.versions[row] for row in rows)
            version, count = counts.most_common(1)[0]
            share = total[version] / len(self.versions)
            if _is_file_of_one(count, len(rows), share):
                yield from self._complain(rows, version, count)

    def _rows_by_file(self) -> Mapping[str, Sequence[int]]:
        """The rows of those who stand in a file, by file."""
        found: dict[str, list[int]] = defaultdict(list)
        for row, file in enumerate(self.answers.files):
            if self.answers.lines[row]:
                found[file].append(row)
        return found

    def _complain(self, rows: Sequence[int], version: str, count: int) -> Iterator[Complaint]:
        for row in rows:
            own = self.versions[row]
            if own != version:
                whose, of = self.students[row], len(rows)
                problem = Message(
                    "marking.of-other-version", own=own, other=version, count=count, of=of
                )
                done = Message("marking.by-own-version", own=own, other=version, student=whose)
                yield self.answers.complain(row, problem, done)


def _is_file_of_one(count: int, of: int, share: float) -> bool:
    """Whether so many students of a file have one version, which that share of the class has."""
    others = of - count
    if of < _LEAST or others > _FEW * of or share >= 1:
        return False
    return sum(_find_chance(each, of, 1 - share) for each in range(others + 1)) <= _LEVEL


def _find_chance(count: int, of: int, share: float) -> float:
    """The probability of so many out of so many, by the binomial distribution."""
    ways = lgamma(of + 1) - lgamma(count + 1) - lgamma(of - count + 1)
    return exp(ways + count * log(share) + (of - count) * log(1 - share))
