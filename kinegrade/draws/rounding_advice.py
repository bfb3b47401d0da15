"""What helps where honest rounding could leave a tolerance in most combinations of a question: more
figures carried, or wider tolerances, as tried on combinations that were refused for it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from kinegrade.draws.deck import Combination
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.examining import Examined, Refused
from kinegrade.language.message import Message, list_all, list_choices
from kinegrade.numbers.tolerance import MOST_CARRY
from kinegrade.students.rounding.accuracy import find_usual_share

_TRIED = 30  # combinations
_HELPED = 0.5  # of them: what helps fewer is not worth advice


def advise_on_rounding(question: DrawFilter, refused: Sequence[Combination]) -> Message | None:
    """What to state in the bank so that rounding leaves most of these combinations in peace; None
    where nothing does.
    """
    tried = refused[:_TRIED]
    shares = _find_shares(question, tried)
    ways = [*_find_carry(question, tried)]
    if shares:
        wide = (
            Message("template.ask-needs", ask=ask, share=share * 100)
            for ask, share in shares.items()
        )
        ways.append(Message("template.honest-helps", asks=list_all(wide)))
    return Message("template.rounding-helps", ways=list_choices(ways)) if ways else None


def _find_carry(question: DrawFilter, tried: Sequence[Combination]) -> Iterator[Message]:
    """The fewest figures to be carried that help, if any do."""
    for carry in range(question.carry + 1, MOST_CARRY + 1):
        if _is_helped(replace(question, carry=carry).examine(tried)):
            yield Message("template.carry-helps", figures=carry)
            return


def _find_shares(question: DrawFilter, tried: Sequence[Combination]) -> Mapping[str, Fraction]:
    """By ask the relative tolerance that is enough in nine of ten, of the asks that rounding leaves
    as they are stated; nothing where honest tolerances do not help.
    """
    asks: set[str] = set()
    found = question.examine(tried)
    while not (lost := _find_lost(found)) <= asks:
        asks |= lost
        stated = {ask: rule for ask, rule in question.tolerances.items() if ask not in asks}
        found = replace(question, tolerances=stated).examine(tried)
    if not _is_helped(found):
        return {}
    rules = [one.tolerances for one in found if isinstance(one, Examined)]
    return {ask: find_usual_share([each[ask].relative for each in rules]) for ask in sorted(asks)}


def _find_lost(found: Sequence[Examined | Refused]) -> set[str]:
    """The asks for which instances are refused because rounding could leave them."""
    return {one.ask for one in found if isinstance(one, Refused) and one.reason == "rounding"}


def _is_helped(found: Sequence[Examined | Refused]) -> bool:
    """Whether most instances are good now."""
    return sum(isinstance(one, Examined) for one in found) > _HELPED * len(found)
