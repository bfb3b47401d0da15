"""Which questions each paper of an exam holds: all, and of alternatives those of its place."""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.choices import fits_paper
from kinegrade.exam.setting.kept_deal import Stated


def give_questions(
    bank: Bank, secret: str, places: Mapping[str, int], stated: Stated
) -> dict[str, frozenset[str]]:
    """The questions of each paper, or version, of the class; one that has some already, as
    `stated`, keeps them as long as the bank may give them.
    """
    names = [each.identifier for each in bank.questions]
    optional = {name for choice in bank.choices for name in choice.questions}
    given: dict[str, frozenset[str]] = {}
    for paper, place in places.items():
        held = [*stated.get(paper, ())]
        if bank.choices and fits_paper(held, names, bank.choices):
            given[paper] = frozenset(held)
            continue
        chosen = {name for each in bank.choices for name in each.choose(secret, place)}
        given[paper] = frozenset(each for each in names if each not in optional or each in chosen)
    return given
