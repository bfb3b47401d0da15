"""How far an answer may be off, as the row of the answer table states it, in the ask's unit."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.exam.printing.rules import make_decimals_rule, make_percent, write_amount
from kinegrade.exam.setting.setting import SetAsk
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Message, Part, list_choices
from kinegrade.mechanics.motion import Motion
from kinegrade.problem.tolerance import find_scale_of_mechanism
from kinegrade.round_numbers import round_down


def write_row_tolerance(entry: SetAsk, motion: Motion, language: Language) -> tuple[str, ...]:
    """The lines of an ask's row, as prose: its tolerance on this paper, and the amount that is
    allowed next to zero, whatever its answer is. `motion` is the instance's, in doubles.
    """
    words = open_catalogue(language)
    lines = map(words.write, (*_list_stated(entry), *_list_near_zero(entry, motion)))
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


def _list_near_zero(entry: SetAsk, motion: Motion) -> Iterator[Message]:
    """The amount as far down as it is round, so that what the row allows is always right: other
    figures would tell how large the mechanism's answers are.
    """
    room = entry.ask.tolerance.share * find_scale_of_mechanism(motion, entry.answer.measure)
    if room > 0 and (amount := round_down(room)) > entry.stated.absolute:
        number = write_amount(amount, entry.answer.unit, r"\pm")
        yield Message("paper.tolerance-near-zero", number=number)
