"""What the class report calls questions, asks, verdicts, and the reasons why points were lost."""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.grading.verdict_names import name_verdict
from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message, Text
from kinegrade.marks_folder.hand_marks import BY_HAND
from kinegrade.press.class_sheet import Symbol
from kinegrade.question_numbers import find_bank_number

_RULES: Mapping[str, Message] = {
    "follow-through": Message("report.legend-follow-through"),
    "another paper": Message("report.legend-another-paper"),
}
_REASONS: Mapping[str, Message] = {
    "opposite": Message("report.reason-opposite"),
    "power of ten": Message("report.reason-power-of-ten"),
    "twice": Message("report.reason-twice"),
    "half": Message("report.reason-half"),
    "degrees for radians": Message("report.reason-degrees-for-radians"),
    "radians for degrees": Message("report.reason-radians-for-degrees"),
    "revolutions per minute": Message("report.reason-turns-per-minute"),
    "revolutions per second": Message("report.reason-turns-per-second"),
    "another ask": Message("report.reason-another-ask"),
    "rounded": Message("report.reason-rounded"),
    "close": Message("report.reason-close"),
    "unexplained": Message("report.reason-unexplained"),
    "wrong unit": Message("report.reason-wrong-unit"),
    "unreadable": Message("report.reason-unreadable"),
    "blank": Message("report.reason-blank"),
    "accepted": Message("report.reason-accepted"),
    "follow-through": Message("report.reason-follow-through"),
    "another paper": Message("report.reason-another-paper"),
    "mistake": Message("report.reason-mistake"),
    "void": Message("report.reason-void"),
    BY_HAND: Message("report.reason-by-hand"),
}


def name_question(question: str, catalogue: Catalogue) -> str:
    """A question by its number in the bank."""
    return catalogue.write(Message("report.numbered", number=find_bank_number(question)))


def find_symbol(column: str, wording: Wording) -> Symbol:
    """The symbol of an ask, by its column."""
    return Symbol(wording.symbols.get(column), column.split(".", 1)[1])


def explain_verdict(verdict: str) -> Text:
    """What a legend says of a verdict: its name, and where its rule cannot be guessed, the rule."""
    return _RULES[verdict] if verdict in _RULES else name_verdict(verdict)


def describe_reason(reason: str, wording: Wording) -> Text:
    """The sentence for a known mistake, or the words for a hint or a verdict; an unknown reason as
    it stands in the marks.
    """
    if reason in wording.mistakes:
        return wording.mistakes[reason]
    return _REASONS.get(reason, reason)
