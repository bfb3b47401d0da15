"""The pages of papers that all of an exam are to have: papers in large print, which take as many as
they take, do not count.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.exam.roster.students import Student


def count_usual(students: Sequence[Student], pages: Sequence[int]) -> Iterator[tuple[Student, int]]:
    """The students with the pages of their papers, but those in large print."""
    for student, count in zip(students, pages, strict=True):
        if not student.reads_large_print:
            yield student, count


def find_most_pages(students: Sequence[Student], pages: Sequence[int]) -> int:
    """How many pages the longest paper has of those that count; 0 where none does."""
    return max((count for _, count in count_usual(students, pages)), default=0)
