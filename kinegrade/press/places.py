"""How messages name the place of a fault on a sheet: the paper, the question, the text."""

from __future__ import annotations

from typing import Literal

from kinegrade.language.message import Location, Message

SheetPart = Literal[
    "title", "statement", "symbol", "meaning", "sign", "tolerance", "remark", "solution", "givens"
]
RULES = Message("typesetting.place-rules")
KEY = Message("typesetting.place-key")
ALL_PAPERS = Message("typesetting.place-papers")
ALL_SOLUTIONS = Message("typesetting.place-solutions")
GALLERY = Message("typesetting.place-gallery")


def locate_part(where: Location, part: SheetPart) -> Message:
    """A text of a question, or of an ask."""
    return Message(f"typesetting.part-{part}", where=where)


def locate_paper(code: str) -> Message:
    """A student's paper."""
    return Message("typesetting.place-paper", code=code)


def locate_solutions(code: str) -> Message:
    """The worked solutions of a student's paper."""
    return Message("typesetting.place-solutions-of", code=code)


def locate_question(where: Location, question: str, template: str = "") -> Message:
    """A question on a sheet, with its template where it is known."""
    if not template:
        return Message("typesetting.place-question", where=where, question=question)
    return Message(
        "typesetting.place-question-of", where=where, question=question, template=template
    )
