"""The answers of a numerical question for Moodle: numbers with their tolerances, and the share of
the points that they earn.

Moodle takes the first that fits, so what is right comes first, and what several mistakes lead to
before what one does. Its intervals are symmetric and closed at both ends. An interval that is not
symmetric about the right number is therefore given twice: its symmetric part, so that Moodle shows
the right number, and the whole, about its middle.

Moodle keeps fourteen significant digits of every number. Those written here have no more, and the
tolerance is rounded up so that nothing right is lost at either end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from kinegrade.errors import ExportError
from kinegrade.exam.quiz_document import QuizAsk
from kinegrade.lms.quiz.decimals import decimal_text, rounded
from kinegrade.lms.quiz.html import plain_html
from kinegrade.lms.quiz.intervals import RightInterval, right_intervals
from kinegrade.lms.quiz.wrong_numbers import wrong_numbers

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
NEAR = Fraction(1, 10**5)  # per cent: how near a share must be to one of Moodle's
KEPT_DIGITS = 14
# Moodle makes a box of a Cloze question as wide as its longest number, which would give away the
# length of the right one. This one is longer than any that Moodle keeps, and no student types it.
WIDEST = "%0%-1.2345678901234E+300:0"


@dataclass(frozen=True)
class MoodleAnswer:
    """Right to `share` per cent within `room` of `value`, both ends included; `feedback` is
    HTML.
    """

    value: Fraction
    room: Fraction
    share: Fraction
    feedback: str = ""


def moodle_answers(ask: QuizAsk) -> tuple[MoodleAnswer, ...]:
    """The answers of an ask in the order in which Moodle tries them. Raises ExportError for a share
    that Moodle does not have.
    """
    return (*_right(ask), *_wrong(ask))


def cloze_field(ask: QuizAsk, mark: int) -> str:
    """The box of an ask inside the text of a Cloze question. Raises ExportError for a share that is
    not a whole per cent.
    """
    answers = moodle_answers(ask)
    if any(answer.share.denominator != 1 for answer in answers):
        raise ExportError(
            f"ask {ask.identifier}: a share of the points that is not a whole per cent - expected "
            "one in Cloze questions - choose 50, 25 or 20 per cent, or --as numerical"
        )
    return f"{{{mark}:NUMERICAL:{'~'.join((*map(_alternative, answers), WIDEST))}}}"


def _right(ask: QuizAsk) -> Iterator[MoodleAnswer]:
    intervals = right_intervals(ask)
    first = intervals[0]
    if first.symmetric:
        yield _covering(first.value, first, ALL)
        intervals = intervals[1:]
    else:
        value = rounded(first.value, "nearest", KEPT_DIGITS)
        inside = max(Fraction(0), min(value - first.low, first.high - value))
        yield MoodleAnswer(value, rounded(inside, "down", KEPT_DIGITS), ALL)
    for interval in intervals:
        yield _covering(interval.middle, interval, ALL)


def _wrong(ask: QuizAsk) -> Iterator[MoodleAnswer]:
    """What known mistakes lead to, with the sentences of all that lead there and the best of their
    shares.
    """
    for wrong in wrong_numbers(ask):
        sentences = dict.fromkeys(plain_html(mistake.sentence) for mistake in wrong.mistakes)
        share = _share(wrong.credit)
        for interval in wrong.intervals:
            yield _covering(interval.middle, interval, share, "<br/>".join(sentences))


def _covering(
    about: Fraction, interval: RightInterval, share: Fraction, feedback: str = ""
) -> MoodleAnswer:
    """The narrowest answer that Moodle keeps unchanged and that covers the whole interval."""
    value = rounded(about, "nearest", KEPT_DIGITS)
    room = max(value - interval.low, interval.high - value)
    return MoodleAnswer(value, rounded(room, "up", KEPT_DIGITS), share, feedback)


@lru_cache(maxsize=256)
def _share(credit: Fraction) -> Fraction:
    """The share in Moodle that equals a credit."""
    for share in SHARES:
        if abs(100 * credit - share) <= NEAR:
            return share
    raise ExportError(
        f"credit of {decimal_text(credit * 100)} per cent for known mistakes: Moodle has no such "
        f"share - expected one of {', '.join(decimal_text(share) for share in SHARES)} - choose one"
    )


def _alternative(answer: MoodleAnswer) -> str:
    share = "=" if answer.share == ALL else f"%{decimal_text(answer.share)}%"
    feedback = f"#{_guarded(answer.feedback)}" if answer.feedback else ""
    return f"{share}{decimal_text(answer.value)}:{decimal_text(answer.room)}{feedback}"


def _guarded(feedback: str) -> str:
    """Feedback with the characters escaped that have a meaning in a Cloze field."""
    return feedback.replace("&#x27;", "’").translate(_GUARDS)
