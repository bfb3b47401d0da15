"""The number of a question: files name it q3, texts for people say 3."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

_NUMBERED = re.compile("q(?P<number>[0-9]+)(?P<alternative>[a-z]?)")


def find_bank_number(identifier: str) -> str:
    """The number of a question in the bank's order, of an alternative with its letter; an
    identifier of another form is its own number.

    >>> find_bank_number("q3"), find_bank_number("q2b"), find_bank_number("bonus")
    ('3', '2b', 'bonus')
    """
    return identifier.removeprefix("q") if _NUMBERED.fullmatch(identifier) else identifier


def find_printed_number(identifier: str) -> str | None:
    """What papers print for an alternative, None for other questions.

    >>> find_printed_number("q2b"), find_printed_number("q2")
    ('2', None)
    """
    found = _NUMBERED.fullmatch(identifier)
    return found["number"] if found and found["alternative"] else None


def sort_as_in_bank(identifiers: Iterable[str]) -> tuple[str, ...]:
    """Questions in the bank's order; those of another form stay behind them as they are.

    >>> sort_as_in_bank(["q10", "q1", "bonus", "q2b", "q2a"])
    ('q1', 'q2a', 'q2b', 'q10', 'bonus')
    """
    return tuple(sorted(identifiers, key=_find_place))


def _find_place(identifier: str) -> tuple[bool, int, str]:
    found = _NUMBERED.fullmatch(identifier)
    return (False, int(found["number"]), identifier) if found else (True, 0, "")


def find_other_number(identifier: str, number: int) -> str | None:
    """The number in the bank's order where it is not the one on the paper.

    >>> find_other_number("q3", 1), find_other_number("q3", 3)
    ('3', None)
    """
    in_bank = find_bank_number(identifier)
    return None if in_bank == str(number) else in_bank


def number_printed(printed: Sequence[str]) -> list[int]:
    """The numbers on a paper of the questions that are marked here, in their order there: those of
    the bank's order, between which the questions that are marked by hand keep theirs. Several
    alternatives of one number are counted on from it.

    >>> number_printed(["q4", "q1", "q3"]), number_printed(["bonus", "q2"])
    ([1, 3, 4], [1, 2])
    >>> number_printed(["q1", "q2c", "q2a", "q5"])
    [1, 2, 3, 5]
    """
    found = [_NUMBERED.fullmatch(each) for each in printed]
    if not all(found):
        return [*range(1, len(printed) + 1)]
    numbers: list[int] = []
    for number in sorted(int(each["number"]) for each in found if each):
        numbers.append(max(number, numbers[-1] + 1) if numbers else number)
    return numbers
