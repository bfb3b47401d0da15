"""What verdicts are called in complaints and in the class report."""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.language.message import Message, Text

_VERDICTS: Mapping[str, Message] = {
    "right": Message("report.verdict-right"),
    "accepted": Message("report.verdict-accepted"),
    "follow-through": Message("report.verdict-follow-through"),
    "another paper": Message("report.verdict-another-paper"),
    "mistake": Message("report.verdict-mistake"),
    "wrong": Message("report.verdict-wrong"),
    "wrong unit": Message("report.verdict-wrong-unit"),
    "blank": Message("report.verdict-blank"),
    "unreadable": Message("report.verdict-unreadable"),
    "void": Message("report.verdict-void"),
    "by hand": Message("report.reason-by-hand"),
}


def name_verdict(verdict: str) -> Text:
    """A verdict as the instructor reads it; an unknown one as it stands in the marks."""
    return _VERDICTS.get(verdict, verdict)
