"""What a feedback sheet says about one answer: the verdict, why it was given, and what probably
went wrong.

`feedback` puts it in the rows of a sheet. Remarks are prose, with `$...$` math.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import reduce
from typing import assert_never

from kinegrade.grading.judging.hints import Hint
from kinegrade.grading.wording import Wording
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.hand_marks import BY_HAND
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.numbers.decimals import round_to_decimal
from kinegrade.numbers.written import read_number
from kinegrade.reports.classes.tally import hint_of
from kinegrade.reports.feedback.reading_notes import find_note
from kinegrade.reports.paper_record import PaperRecord, RightAnswer

_VERDICTS: Mapping[str, Message] = {
    "right": Message("feedback.verdict-right"),
    "accepted": Message("feedback.verdict-accepted"),
    "follow-through": Message("feedback.verdict-follow-through"),
    "another paper": Message("feedback.verdict-wrong"),
    "mistake": Message("feedback.verdict-wrong"),
    "wrong": Message("feedback.verdict-wrong"),
    "wrong unit": Message("feedback.verdict-wrong-unit"),
    "blank": Message("feedback.verdict-blank"),
    "unreadable": Message("feedback.verdict-unreadable"),
    "void": Message("feedback.verdict-void"),
    BY_HAND: Message("feedback.verdict-by-hand"),
}
_EXPLAINED: Mapping[str, Message] = {
    "wrong unit": Message("feedback.wrong-unit"),
    "unreadable": Message("feedback.unreadable"),
    "accepted": Message("feedback.accepted"),
    "follow-through": Message("feedback.follow-through"),
    "another paper": Message("feedback.another-paper"),
    "void": Message("feedback.void"),
}
_FIGURES, _MOST_FIGURES = 2, 17  # of percentages
_MANY = 3  # times the right value: from there on a percentage says little
_WITH_NOTE = ("wrong unit", "unreadable")  # their notes on reading the cell are for the student too


@dataclass(frozen=True)
class Remark:
    """`prose` explains the verdict, "" where it needs no explanation; `note` is plain text: the
    note made on reading the cell. A `guess` goes by the number alone.
    """

    prose: Text = ""
    note: Text = ""
    guess: bool = False


def name_verdict(verdict: str) -> Text:
    """A verdict as students read it; an unknown one as it stands in the marks."""
    return _VERDICTS.get(verdict, verdict)


def make_remark(answer: MarkedAnswer, paper: PaperRecord, wording: Wording) -> Remark:
    """What is said about an answer."""
    match answer.judged:
        case "by hand":
            return Remark(note=answer.reason_given)
        case "mistake":
            return Remark(_list_mistakes(answer, wording))
        case "wrong":
            return _explain_wrong(answer, paper, wording)
        case "right" | "blank":
            return Remark()
        case "void" if answer.out_of:
            return Remark(Message("feedback.void-full"))
        case verdict if verdict in _EXPLAINED:
            note = find_note(answer) if verdict in _WITH_NOTE else ""
            return Remark(_EXPLAINED[verdict], note)
        case _:
            return Remark(note=answer.reason)


def _list_mistakes(answer: MarkedAnswer, wording: Wording) -> Text:
    """The sentences on the mistakes, any of which may have been made."""
    known = wording.mistakes
    sentences: list[Text] = [known[name] for name in answer.mistakes if name in known]
    return reduce(_join_either, sentences) if sentences else ""


def _join_either(first: Text, second: Text) -> Message:
    return Message("feedback.either-mistake", first=first, second=second)


def _explain_wrong(answer: MarkedAnswer, paper: PaperRecord, wording: Wording) -> Remark:
    """What the number suggests, or else how far off it is."""
    found, right = hint_of(answer, paper), paper.answers.get(answer.column)
    if right is None:
        return Remark()
    hint = "" if found is None else _describe_hint(found, answer, right, wording)
    if found is None or not hint:
        return Remark(_measure_error(answer, right))
    return Remark(_turn(hint) if found.reversed_sign else hint, guess=True)


def _measure_error(answer: MarkedAnswer, right: RightAnswer) -> Text:
    """How far off a wrong number is, by its size and its sign; "" where nothing was read."""
    if not answer.read_as:
        return ""
    value = read_number(answer.read_as)
    if not right.value or not value:
        return Message("feedback.not-zero" if value else "feedback.zero")
    ratio = value / right.value
    said = (
        Message("feedback.off-by", difference=write_percent(abs(abs(ratio) - 1)))
        if abs(ratio) < _MANY
        else Message("feedback.off-times", factor=Decimal(f"{float(abs(ratio)):.2g}"))
    )
    return _turn(said) if ratio < 0 else said


def _turn(said: Text) -> Message:
    return Message("feedback.turned-as-well", hint=said)


def _describe_hint(found: Hint, answer: MarkedAnswer, right: RightAnswer, wording: Wording) -> Text:
    match found.kind:
        case "opposite":
            return Message("feedback.opposite")
        case "twice":
            return Message("feedback.twice")
        case "half":
            return Message("feedback.half")
        case "degrees for radians":
            return Message("feedback.degrees-for-radians")
        case "radians for degrees":
            return Message("feedback.radians-for-degrees")
        case "revolutions per minute":
            return Message("feedback.turns-per-minute")
        case "revolutions per second":
            return Message("feedback.turns-per-second")
        case "power of ten":
            return _describe_slip(found.power)
        case "another ask":
            symbol = wording.symbols.get(found.column, "")
            return Message("feedback.other-ask", symbol=symbol) if symbol else ""
        case "rounded" | "close":
            return _describe_nearness(answer, right)
        case _:
            assert_never(found.kind)


def _describe_slip(power: int) -> Message:
    factor = 10 ** abs(power)
    if power > 0:
        return Message("feedback.too-large", factor=factor)
    return Message("feedback.too-small", factor=factor)


def _describe_nearness(answer: MarkedAnswer, right: RightAnswer) -> Message:
    """How far off it is, and how far it may be on its side."""
    value, size = read_number(answer.read_as), abs(right.value)
    low, high = right.bounds
    below, above = (right.value - low) / size, (high - right.value) / size
    difference, allowed = abs(value - right.value) / size, above if value > right.value else below
    shown, room = _write_apart(100 * difference, 100 * allowed)
    return Message(
        "feedback.close" if below == above else "feedback.close-on-this-side",
        difference=Message("grammar.percent", number=shown),
        allowed=Message("grammar.percent", number=room),
    )


def _write_apart(number: Fraction, bound: Fraction) -> tuple[Decimal, Decimal]:
    """A number and the bound below it, which is rounded down, with two significant figures or as
    many more as it takes to see that the number is larger.

    >>> _write_apart(Fraction("0.104"), Fraction("0.1006"))
    (Decimal('0.104'), Decimal('0.1'))
    """
    for figures in range(_FIGURES, _MOST_FIGURES + 1):
        shown = round_to_decimal(number, figures)
        below = round_to_decimal(bound, figures, "down")
        if shown > below:
            break
    return Decimal(f"{shown:f}"), Decimal(f"{below:f}")


def write_percent(share: Fraction) -> Message:
    """Two significant figures, or more where two would read 1 %.

    >>> write_percent(Fraction("0.0134")).parts, write_percent(Fraction("0.01004")).parts
    ({'number': Decimal('1.3')}, {'number': Decimal('1.004')})
    """
    one = Fraction(1, 100)
    places = 2 if abs(share - one) >= Fraction(1, 2000) or share == one else 4
    return Message("grammar.percent", number=Decimal(f"{float(100 * share):.{places}g}"))
