"""The answers of a numerical question for Moodle: numbers with how far from them counts, and what share it earns.

Moodle takes the first that fits, so what is right stands first and then the narrowest. It knows symmetric intervals
only, closed at both ends; an interval that is not symmetric about the right number is given twice, as the part that
is, so that Moodle shows the right number, and whole, about its middle.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from kinegrade.errors import ExportError
from kinegrade.exam.quiz_document import QuizAsk, QuizMistake
from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.html import plain_html
from kinegrade.lms.quiz.intervals import right_intervals

ALL = Fraction(100)
SHARES = tuple(
    map(
        Fraction,
        (
            "100",
            "90",
            "83.33333",
            "80",
            "75",
            "70",
            "66.66667",
            "60",
            "50",
            "40",
            "33.33333",
            "30",
            "25",
            "20",
            "16.66667",
            "14.28571",
            "12.5",
            "11.11111",
            "10",
            "5",
            "0",
        ),
    )
)
_GUARDS = str.maketrans({"}": r"\}", "#": r"\#", "~": "&#126;", "{": "&#123;", "\\": "&#92;"})
NEAR = Fraction(1, 10**5)  # per cent: how near to one of its shares Moodle wants a share to be


@dataclass(frozen=True)
class MoodleAnswer:
    """Right to `share` per cent within `room` of `value`, both ends included; `feedback` is HTML."""

    value: Fraction
    room: Fraction
    share: Fraction
    feedback: str = ""


def moodle_answers(ask: QuizAsk) -> tuple[MoodleAnswer, ...]:
    """The answers of an ask in the order in which Moodle tries them. Raises ExportError for a share it has not."""
    return (*_right(ask), *sorted(_wrong(ask.mistakes), key=lambda answer: answer.room))


def cloze_field(ask: QuizAsk, mark: int) -> str:
    """The box of an ask inside the text of a Cloze question. Raises ExportError for a share that has decimals there."""
    answers = moodle_answers(ask)
    if any(answer.share.denominator != 1 for answer in answers):
        raise ExportError(
            f"ask {ask.identifier}: a share of the points that is no whole per cent - expected one in "
            "Cloze questions - choose 50, 25 or 20 per cent, or --as numerical"
        )
    return f"{{{mark}:NUMERICAL:{'~'.join(map(_alternative, answers))}}}"


def _right(ask: QuizAsk) -> Iterator[MoodleAnswer]:
    first, *turned = right_intervals(ask)
    if not first.symmetric:
        yield MoodleAnswer(first.value, min(first.value - first.low, first.high - first.value), ALL)
        turned = [first, *turned]
    else:
        yield MoodleAnswer(first.value, (first.high - first.low) / 2, ALL)
    for interval in turned:
        yield MoodleAnswer(
            (interval.low + interval.high) / 2, (interval.high - interval.low) / 2, ALL
        )


def _wrong(mistakes: Iterable[QuizMistake]) -> Iterator[MoodleAnswer]:
    """One answer for each wrong number, whatever mistakes lead to it; the best of their shares."""
    by_interval: dict[tuple[Fraction, Fraction], list[QuizMistake]] = {}
    for mistake in mistakes:
        by_interval.setdefault(mistake.interval, []).append(mistake)
    for (low, high), alike in by_interval.items():
        share = max(_share(mistake.credit) for mistake in alike)
        feedback = "<br/>".join(plain_html(mistake.sentence) for mistake in alike)
        yield MoodleAnswer((low + high) / 2, (high - low) / 2, share, feedback)


@lru_cache(maxsize=256)
def _share(credit: Fraction) -> Fraction:
    """The share of Moodle's that a credit is."""
    for share in SHARES:
        if abs(100 * credit - share) <= NEAR:
            return share
    raise ExportError(
        f"credit of {decimal_text(credit * 100)} per cent for known mistakes: Moodle has no such share - "
        f"expected one of {', '.join(decimal_text(share) for share in SHARES)} - choose one"
    )


def _alternative(answer: MoodleAnswer) -> str:
    share = "=" if answer.share == ALL else f"%{decimal_text(answer.share)}%"
    feedback = f"#{_guarded(answer.feedback)}" if answer.feedback else ""
    return f"{share}{decimal_text(answer.value)}:{decimal_text(answer.room)}{feedback}"


def _guarded(feedback: str) -> str:
    """Feedback without what means something in a Cloze field."""
    return feedback.replace("&#x27;", "’").translate(_GUARDS)
