"""Whose lines a key holds: one for each candidate, and no others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator

from kinegrade.exam.folder.contents import HEAD


def find_ownership_faults(owners: Collection[str], candidates: Collection[str]) -> Iterator[str]:
    """What is wrong with the students of the lines: students with several lines, candidates with
    none, and students who are not candidates.
    """
    yield from find_repetitions(owners)
    for student in sorted(set(candidates).difference(owners)):
        yield f'no line for student "{student}" - expected one'
    for student in sorted(set(owners).difference(candidates)):
        yield f'student "{student}" is not in {HEAD} - expected only its students'


def find_repetitions(owners: Collection[str]) -> Iterator[str]:
    """A fault for each student with several lines."""
    for student, count in Counter(owners).items():
        if count > 1:
            yield f'student "{student}" appears {count} times - expected once'
