"""Numbers of things as messages write them: "1 student", "12 students"."""

from __future__ import annotations


def count_in_words(number: int, thing: str) -> str:
    """The number with the English word for what is counted, whose plural takes an s.

    >>> count_in_words(1, "student"), count_in_words(0, "complaint")
    ('1 student', '0 complaints')
    """
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"
