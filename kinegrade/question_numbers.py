"""The number of a question: files name it q3, texts for people say 3."""

from __future__ import annotations

from collections.abc import Sequence


def find_bank_number(identifier: str) -> str:
    """The number of a question in the bank's order; an identifier of another form is its own
    number.

    >>> find_bank_number("q3"), find_bank_number("bonus")
    ('3', 'bonus')
    """
    number = identifier.removeprefix("q")
    return number if number.isdecimal() else identifier


def find_other_number(identifier: str, number: int) -> str | None:
    """The number in the bank's order where it is not the one on the paper.

    >>> find_other_number("q3", 1), find_other_number("q3", 3)
    ('3', None)
    """
    in_bank = find_bank_number(identifier)
    return None if in_bank == str(number) else in_bank


def number_printed(printed: Sequence[str]) -> list[int]:
    """The numbers on a paper of the questions that are marked here, in their order there: those of
    the bank's order, between which the questions that are marked by hand keep theirs.

    >>> number_printed(["q4", "q1", "q3"]), number_printed(["bonus", "q2"])
    ([1, 3, 4], [1, 2])
    """
    numbers = [find_bank_number(each) for each in printed]
    if all(number.isdecimal() for number in numbers):
        return sorted(map(int, numbers))
    return [*range(1, len(numbers) + 1)]
