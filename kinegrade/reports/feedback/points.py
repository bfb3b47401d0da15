"""Points and questions as a feedback sheet names them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message
from kinegrade.marks_folder.open_questions import OpenQuestion, add_open_points
from kinegrade.marks_folder.rows import StudentTotal
from kinegrade.numbers.amounts import write_amount
from kinegrade.question_numbers import find_other_number


def mark_decimals(number: str, catalogue: Catalogue) -> str:
    """A number that is written with a decimal point, with the mark of the language."""
    return number.replace(".", catalogue.decimal_mark)


def write_points(points: Fraction, catalogue: Catalogue) -> str:
    """So many points."""
    return mark_decimals(write_amount(points), catalogue)


def write_share(points: Fraction, out_of: Fraction, catalogue: Catalogue) -> str:
    """Points out of the maximum."""
    return f"{write_points(points, catalogue)} / {write_points(out_of, catalogue)}"


def say_bonus(points: str, catalogue: Catalogue) -> str:
    """Points that come on top of the maximum."""
    return catalogue.text("feedback.bonus", points=points)


def head_question(question: str, number: int) -> Message:
    """A question by its number on the paper, and in the bank where that is another one."""
    other = find_other_number(question, number)
    if other is None:
        return Message("feedback.question", number=number)
    return Message("feedback.question-known", number=number, other=other)


def write_total(
    total: StudentTotal, still_open: Sequence[OpenQuestion], catalogue: Catalogue
) -> str:
    """Points out of the maximum, and what is still to be marked by hand; whether the student was
    absent.
    """
    share = write_share(total.total, total.out_of, catalogue)
    if not total.is_present:
        return catalogue.text("feedback.absent", total=share)
    if not still_open:
        return share
    points = write_points(add_open_points(still_open), catalogue)
    return catalogue.text("feedback.total-open", total=share, points=points)
