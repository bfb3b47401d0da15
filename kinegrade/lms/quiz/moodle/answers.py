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
from kinegrade.exam.quiz.document import QuizAsk
from kinegrade.language.html_text import write_plain_html
from kinegrade.language.message import Message, list_plainly
from kinegrade.lms.quiz.decimals import round_to_digits, write_decimal
from kinegrade.lms.quiz.intervals import RightInterval, find_right_intervals
from kinegrade.lms.quiz.wrong_numbers import find_wrong_numbers

_ALL = Fraction(100)
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
_NEAR = Fraction(1, 10**5)  # per cent: how near a share must be to one of Moodle's
_KEPT_DIGITS = 14
# Moodle makes a box of a Cloze question as wide as its longest number, which would give away the
# length of the right one. This one is longer than any that Moodle keeps, and no student types it.
_WIDEST = "%0%-1.2345678901234E+300:0"


@dataclass(frozen=True)
class MoodleAnswer:
    """Right to `share` per cent within `room` of `value`, both ends included; `feedback` is
    HTML.
    """

    value: Fraction
    room: Fraction
    share: Fraction
    feedback: str = ""


def list_moodle_answers(ask: QuizAsk) -> tuple[MoodleAnswer, ...]:
    """The answers of an ask in the order in which Moodle tries them. Raises ExportError for a share
    that Moodle does not have.
    """
    return (*_list_right(ask), *_list_wrong(ask))


def write_cloze_field(ask: QuizAsk, mark: int) -> str:
    """The box of an ask inside the text of a Cloze question. Raises ExportError for a share that is
    not a whole per cent.
    """
    answers = list_moodle_answers(ask)
    if any(answer.share.denominator != 1 for answer in answers):
        raise ExportError(Message("quiz-file.no-whole-share", ask=ask.identifier))
    return f"{{{mark}:NUMERICAL:{'~'.join((*map(_write_alternative, answers), _WIDEST))}}}"


def _list_right(ask: QuizAsk) -> Iterator[MoodleAnswer]:
    intervals = find_right_intervals(ask)
    first = intervals[0]
    if first.symmetric:
        yield _make_covering(first.value, first, _ALL)
        intervals = intervals[1:]
    else:
        value = round_to_digits(first.value, "nearest", _KEPT_DIGITS)
        inside = max(Fraction(0), min(value - first.low, first.high - value))
        yield MoodleAnswer(value, round_to_digits(inside, "down", _KEPT_DIGITS), _ALL)
    for interval in intervals:
        yield _make_covering(interval.middle, interval, _ALL)


def _list_wrong(ask: QuizAsk) -> Iterator[MoodleAnswer]:
    """What known mistakes lead to, with the sentences of all that lead there and the best of their
    shares.
    """
    for wrong in find_wrong_numbers(ask):
        sentences = dict.fromkeys(write_plain_html(mistake.sentence) for mistake in wrong.mistakes)
        share = _find_share(wrong.credit)
        for interval in wrong.intervals:
            yield _make_covering(interval.middle, interval, share, "<br/>".join(sentences))


def _make_covering(
    about: Fraction, interval: RightInterval, share: Fraction, feedback: str = ""
) -> MoodleAnswer:
    """The narrowest answer that Moodle keeps unchanged and that covers the whole interval."""
    value = round_to_digits(about, "nearest", _KEPT_DIGITS)
    room = max(value - interval.low, interval.high - value)
    return MoodleAnswer(value, round_to_digits(room, "up", _KEPT_DIGITS), share, feedback)


@lru_cache(maxsize=256)
def _find_share(credit: Fraction) -> Fraction:
    """The share in Moodle that equals a credit."""
    for share in SHARES:
        if abs(100 * credit - share) <= _NEAR:
            return share
    shares = list_plainly(write_decimal(share) for share in SHARES)
    percent = write_decimal(credit * 100)
    raise ExportError(Message("quiz-file.no-such-share", percent=percent, shares=shares))


def _write_alternative(answer: MoodleAnswer) -> str:
    share = "=" if answer.share == _ALL else f"%{write_decimal(answer.share)}%"
    feedback = f"#{_guard(answer.feedback)}" if answer.feedback else ""
    return f"{share}{write_decimal(answer.value)}:{write_decimal(answer.room)}{feedback}"


def _guard(feedback: str) -> str:
    """Feedback with the characters escaped that have a meaning in a Cloze field."""
    return feedback.replace("&#x27;", "’").translate(_GUARDS)
