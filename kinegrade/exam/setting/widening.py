"""What an instructor can write into a bank so that a question has more values to be drawn."""

from __future__ import annotations

from typing import assert_never

from kinegrade.exam.bank.blueprint import BankQuestion
from kinegrade.language.message import Message


def say_how_to_widen(question: BankQuestion) -> Message:
    """How there are more values: stated in the entry, where that names the template; else with
    another template, as a shipped one has its values.
    """
    name = question.template.name
    match question.chosen:
        case "template":
            return Message("exam.widen-by-draw", given=next(iter(question.template.parameters)))
        case "steps":
            return Message("exam.widen-givens")
        case "family" | "tag":
            return Message("exam.widen-drawn", template=name)
        case "any":
            return Message("exam.widen-any", template=name)
        case _:
            assert_never(question.chosen)
