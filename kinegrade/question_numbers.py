"""The number of a question: files name it q3, texts for people say 3."""

from __future__ import annotations


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
