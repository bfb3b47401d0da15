"""Numbers of things as messages write them: "1 student", "12 students"."""

from __future__ import annotations


def counted(number: int, thing: str) -> str:
    """The number with the English word for what is counted, whose plural takes an s.

    >>> counted(1, "student"), counted(0, "complaint")
    ('1 student', '0 complaints')
    """
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"
