"""The error for a key that contradicts what is derived again from its folder."""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.errors import ExamError

REMEDY = (
    "expected both to agree - restore the exam folder as it was generated, or use the version "
    "of kinegrade that made it"
)


def explain_contradiction(where: str, differences: Iterable[str]) -> ExamError:
    """The refusal to derive anything that differs from the key in these ways."""
    return ExamError(*(f"{where}: {difference} - {REMEDY}" for difference in differences))


def describe_difference(name: str, found: object, derived: str) -> str:
    """The difference between a value that the key states and the one derived."""
    return f"{name} is {found} by the key, but {derived} follows from the values drawn"
