"""What every layout of a paper has in common: how points are written, how the marker's table is
divided, which number stands beside a question's, where its figure stands.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.decimal_mark import write_decimal_text
from kinegrade.press.sheet import Paper, QuestionSheet
from kinegrade.question_numbers import find_other_number

COLUMNS_OF_MARKS = 13  # the total among them: as many as stand side by side in the marker's table
_BESIDE = 80.0  # millimetres: a wider figure leaves too narrow a column of text beside it


@lru_cache(maxsize=1024)
def write_points_text(points: Fraction, language: Language) -> str:
    """Points as they are printed: a decimal where one is exact, else a fraction.

    >>> [write_points_text(Fraction(value), Language("en")) for value in ("4", "5/2", "1/3")]
    ['4', '2.5', '1/3']
    """
    decimal = f"{float(points):.6g}"
    exact = Fraction(decimal) == points
    return write_decimal_text(decimal, language) if exact else str(points)


def write_share(points: Fraction, language: Language, *, bonus: bool) -> str:
    """What points are of the total, or, with a plus sign, on top of it."""
    text = write_points_text(points, language)
    return f"+{text}" if bonus else text


def write_points_in_words(points: Fraction, words: Catalogue, *, bonus: bool = False) -> str:
    """Points with the word for them: "1 point", "2.5 points", "2 bonus points"."""
    whole = points.denominator == 1
    count = int(points) if whole else write_points_text(points, words.language)
    return words.text("paper.bonus-points" if bonus else "paper.points", count=count)


def write_worth(question: QuestionSheet, words: Catalogue) -> str:
    """The points of a question with the word for them: "2 points", "2 bonus points"."""
    return write_points_in_words(question.points, words, bonus=question.bonus)


def write_other_number(question: QuestionSheet, words: Catalogue) -> str:
    """The question's number in the answer sheet, where it is another than on the paper, else ""."""
    other = find_other_number(question.identifier, question.number)
    return "" if other is None else words.text("paper.known", number=other)


def arrange_marks(
    paper: Paper, total: str, widest: int = COLUMNS_OF_MARKS
) -> list[Sequence[tuple[str, str]]]:
    """The columns of the marker's table, number and points of each question and of the total, in
    rows of at most `widest`; those of a bonus, which are not in the total, with a plus sign.
    """
    columns = [
        (str(each.number), write_share(each.points, paper.language, bonus=each.bonus))
        for each in paper.questions
    ]
    columns.append((total, write_points_text(paper.points, paper.language)))
    return [columns[start : start + widest] for start in range(0, len(columns), widest)]


def fits_beside(figure: Scene) -> bool:
    """Whether text fits beside the figure; a flat one stands better below it."""
    return figure.width <= _BESIDE and figure.height >= figure.width / 4
