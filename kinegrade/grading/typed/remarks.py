"""What an instructor should know of how a number was read."""

from __future__ import annotations

import re
from typing import assert_never

from kinegrade.grading.typed.number_text import TypedNumber
from kinegrade.grading.typed.value import Formula
from kinegrade.language.message import Message, Text

_DECIMAL = r"[0-9]+[.,][0-9]+"
_IN_BRACKETS = re.compile(rf"\(\s*(?:{_DECIMAL}|[0-9]+)\s*\)")
_SLASH = re.compile(rf"{_DECIMAL}\s*/\s*{_DECIMAL}")


def describe_doubt(found: TypedNumber | Formula, minus: bool) -> Text:
    """What the instructor should know about how a number was read, with the sign that was typed or
    given in words.
    """
    match found:
        case TypedNumber():
            digits = apply_sign(found, minus)
            return found.reason and Message(
                "typing.number-read-as", digits=digits, reason=found.reason
            )
        case Formula():
            return found.remark
        case _:
            assert_never(found)


def describe_form(text: str) -> Text:
    """What the instructor should know of a number in brackets, and of two with a slash between."""
    if _IN_BRACKETS.fullmatch(text):
        return Message("typing.in-brackets")
    if _SLASH.fullmatch(text):
        return Message("typing.quotient-of-decimals")
    return ""


def apply_sign(found: TypedNumber, minus: bool) -> str:
    """A typed number in plain digits with its sign."""
    return f"-{found.digits}" if minus else found.digits
