"""Whether two typed cells say the same: 1,5 and 1.50 do, 1.5 and 1.51 do not."""

from __future__ import annotations

from kinegrade.files.cell_text import is_answered, trim
from kinegrade.grading.typed.answers import PAPERS_RULE, read
from kinegrade.grading.typed.number_text import DecimalStyle


def are_same(
    first: str,
    second: str,
    unit: str,
    styles: tuple[DecimalStyle, DecimalStyle] = (PAPERS_RULE, PAPERS_RULE),
) -> bool:
    """Whether two answers in `unit` are spelt alike, are equal numbers as each is read by its
    style, or are both blank.

    >>> are_same("1,5", "1.50 m/s", "m/s"), are_same("1.5", "1.51", "m/s"), are_same("?", "!", "1")
    (True, False, False)
    """
    if trim(first) == trim(second):
        return True
    if not (is_answered(first) and is_answered(second)):
        return not is_answered(first) and not is_answered(second)
    one, other = (read(*each) for each in zip((first, second), (unit, unit), styles, strict=True))
    if one.value is None or other.value is None:
        return False
    return (one.value, one.error) == (other.value, other.error)
