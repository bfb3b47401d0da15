"""Asks whose answer is the same on all papers although their numbers differ: a ratio or an angle
that hangs on none of the values that are dealt. Students may copy it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from kinegrade.draws.deck import Combination
from kinegrade.exam.setting.dealing import ClassDeal
from kinegrade.language.message import Fault, Message
from kinegrade.students.comparison import collect_columns
from kinegrade.students.separation import Separation

_TELLING = 5  # different draws: fewer may have the same answer by chance
_SAME = 1e-9  # times the answer: how far doubles are off


def list_same_answers(dealt: ClassDeal) -> Iterator[Fault]:
    """A complaint for each ask whose answer is the same on all papers; one that vanishes by its
    template is meant to.
    """
    for question in dealt.bank.questions:
        name = question.identifier
        separation = dealt.exam.filters[name].separation
        draws = [*{(*each.values(),): each for each in dealt.values[name].values()}.values()]
        if separation is None or len(draws) < _TELLING:
            continue
        for ask in _find_same(separation, draws):
            what = Message("exam.same-answer", ask=ask)
            yield Fault(f"{name} ({question.template.name})", what, do=Message("exam.ask-another"))


def _find_same(separation: Separation, draws: Sequence[Combination]) -> Iterator[str]:
    """The asks with the same answer in all draws; of most questions few draws have to be looked
    at.
    """
    if any(map(_are_same, separation.find_right(collect_columns(draws[:_TELLING])).values())):
        for name, right in separation.find_right(collect_columns(draws)).items():
            if _are_same(right) and not separation.asks[name].vanishes:
                yield name


def _are_same(right: Any) -> bool:
    """Whether these answers are all one; what has no value is none."""
    return bool(np.ptp(right) <= _SAME * np.abs(right).max())
