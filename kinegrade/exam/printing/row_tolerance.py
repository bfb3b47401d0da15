"""How far an answer may be off, as the row of the answer table states it, in the ask's unit."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.exam.printing.rules import make_decimals_rule, make_percent, write_amount
from kinegrade.exam.setting.setting import SetAsk
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Message, Part, list_choices


def write_row_tolerance(entry: SetAsk, language: Language) -> tuple[str, ...]:
    """The lines of an ask's row, as prose: its tolerance on this paper.

    What is allowed next to zero would tell how large the answer is: the rules of the paper say it.
    """
    words = open_catalogue(language)
    lines = map(words.write, _list_stated(entry))
    return tuple(write_decimals_of_prose(line, language) for line in lines)


def _list_stated(entry: SetAsk) -> Iterator[Message]:
    stated, unit = entry.stated, entry.answer.unit
    choices: list[Part] = []
    if stated.figures:
        choices.append(Message("paper.tolerance-figures", figures=stated.figures))
    if stated.relative:
        choices.append(make_percent(stated.relative))
    if stated.absolute:
        choices.append(write_amount(stated.absolute, unit, r"\pm"))
    yield Message("paper.tolerance-stated", amounts=list_choices(choices))
    decimals = None if stated.share else make_decimals_rule(stated.absolute)
    if decimals:
        yield decimals
