"""Looking for the good combinations of a question: the first of its deck, one for each place of a
class, and some to spare where papers have to be made alike.

Which combinations are found first depends on the deck only: not on how many places there are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import ceil
from typing import Literal

from kinegrade.draws.draw_filter import DrawFilter, Verdict
from kinegrade.draws.examining import Reason, name_reason
from kinegrade.draws.rounding_advice import advise_on_rounding
from kinegrade.errors import DrawError
from kinegrade.language.message import Fault, Message, Part, list_plainly

# Combinations that are looked at for each place. Shipped templates need 2 to 20; where one in 400
# is not enough, an author has to widen the domains rather than an instructor to wait.
LOOKS = 400

# Combinations that are looked at before a question is given up of which none is good: where one in
# 300 is, a class of 30 has its papers, whatever its secret
PATIENCE = 2_000

# Combinations refused for rounding that are enough for each place: what helps, helps half of them
_ENOUGH = 2

# Combinations in one part at most: more at a time are looked at no faster, and several processes
# are busy to the end of a round, for which the next one waits
PART = 12


@dataclass(frozen=True)
class DeckPart:
    """Positions of a question's deck that are filtered together."""

    question: str
    positions: range


Whose = Literal["students", "versions", "draws"]  # what the places of a deal are
Verdicts = tuple[Verdict, ...]
Look = Callable[
    [Sequence[DeckPart]], Iterable[Verdicts]
]  # the filters' verdicts on parts, in order


@dataclass(frozen=True)
class Deal:
    """A question as far as its deck of `size` combinations was looked at for `places` places.

    `verdicts` are those of the filter, position by position; `spare` good combinations are looked
    for beyond one for each place; as many as `patience` are looked at before it is given up.
    """

    size: int
    places: int
    verdicts: Verdicts = ()
    spare: int = 0
    patience: int = PATIENCE

    @cached_property
    def positions(self) -> Sequence[int]:
        """The positions of the good combinations."""
        return [position for position, verdict in enumerate(self.verdicts) if verdict is None]

    @property
    def wanted(self) -> int:
        """How many good combinations are looked for."""
        return self.places + self.spare

    @property
    def good(self) -> int:
        """How many different combinations are dealt: one for each place while they last."""
        return min(len(self.positions), self.places)

    @property
    def refused(self) -> dict[Reason, int]:
        """By reason how many combinations were refused until each place had one."""
        looked = self.positions[self.places - 1] + 1 if self.lasting else self.bound
        reasons = (reason for reason in self.verdicts[:looked] if reason is not None)
        return dict(sorted(Counter[Reason](reasons).items()))

    @property
    def lasting(self) -> bool:
        """Whether there is a combination for each place."""
        return len(self.positions) >= self.places

    def shortage(self, name: str, whose: Whose, question: DrawFilter) -> Fault:
        """The complaint that there are too few; `whose` says what the places are, `question` was
        dealt.
        """
        places = Message(f"template.for-{whose}", count=self.places)
        what = Message(
            "template.too-few-fit", good=self.good, among=self.looked_at(), places=places
        )
        return Fault(name, what, Message("template.one-for-each"), self.advise(question))

    def advise(self, question: DrawFilter) -> Message:
        """What to do for more good combinations: what leaves those in peace that are refused for
        rounding, where these are most of the refused or enough for all places; else more values.
        """
        refused = [position for position, verdict in enumerate(self.verdicts) if verdict]
        rounding = [position for position in refused if self.verdicts[position] == "rounding"]
        mostly = 2 * len(rounding) > len(refused)
        if not mostly and len(rounding) < _ENOUGH * (self.places - self.good):
            return question.widening
        helps = advise_on_rounding(question, [*map(question.deck.combination, rounding)])
        otherwise = Message("template.no-tolerance-enough") if mostly else question.widening
        return helps or otherwise

    def looked_at(self) -> Message:
        """The combinations that were looked at, in words."""
        looked = len(self.verdicts)
        if looked < self.size:
            return Message("template.first-combinations", looked=looked, size=self.size)
        return Message("template.all-combinations", size=self.size)

    @property
    def hopeless(self) -> bool:
        """Whether as many as patience allows were looked at, and none is good."""
        return not self.positions and len(self.verdicts) >= min(self.size, self.patience)

    @property
    def bound(self) -> int:
        """How many combinations are looked at, at most."""
        return min(self.size, max(LOOKS * self.places, self.patience))

    def further(self) -> range:
        """The positions to look at next, none if no more are needed or there is no hope: as many as
        are likely to be needed, but no more at a time than before, so that a hopeless deck is
        recognised early.
        """
        if self.hopeless:
            return range(0)
        looked = len(self.verdicts)
        found = len(self.positions)
        missing = max(self.wanted - found, 0)
        likely = ceil(missing * (looked + 1) / (found + 1))
        most = LOOKS - looked if looked < LOOKS else looked
        most = most if found else min(most, self.patience - looked)
        return range(looked, min(looked + min(likely, most), self.bound))

    def looked(self, verdicts: Verdicts) -> Deal:
        """The same deal with the verdicts on the positions that follow."""
        return replace(self, verdicts=self.verdicts + verdicts)


def deal(
    filters: Mapping[str, DrawFilter], places: int, look: Look, patience: int = PATIENCE
) -> dict[str, Deal]:
    """The questions dealt to so many places, one or more; `look` asks the filters.

    Raises DrawError with every question of which no combination is good among as many as
    `patience` allows.
    """
    begun = {
        name: Deal(each.deck.size, places, patience=patience) for name, each in filters.items()
    }
    return look_further(filters, begun, look)


def look_further(
    filters: Mapping[str, DrawFilter], begun: Mapping[str, Deal], look: Look
) -> dict[str, Deal]:
    """Deals that were begun, looked at as far as they need. Raises as `deal`."""
    deals = dict(begun)
    while parts := [part for name, each in deals.items() for part in _split(name, each.further())]:
        for part, verdicts in zip(parts, look(parts), strict=True):
            deals[part.question] = deals[part.question].looked(verdicts)
        _require_hope(filters, deals)
    return deals


def look_here(filters: Mapping[str, DrawFilter], parts: Sequence[DeckPart]) -> Iterator[Verdicts]:
    """The filters' verdicts on parts, found by this process."""
    return (filters[part.question].verdicts(part.positions) for part in parts)


def _split(question: str, positions: range) -> Iterator[DeckPart]:
    """Positions in parts of much the same size."""
    for first in range(positions.start, positions.stop, PART):
        yield DeckPart(question, range(first, min(first + PART, positions.stop)))


def _require_hope(filters: Mapping[str, DrawFilter], deals: Mapping[str, Deal]) -> None:
    """Raises DrawError for questions of which nothing can be dealt, once that is known of all."""
    if any(not each.positions and not each.hopeless for each in deals.values()):
        return
    faults = [
        _explain_hopeless(f"{name} ({filters[name].template.name})", each, filters[name])
        for name, each in deals.items()
        if each.hopeless
    ]
    if faults:
        raise DrawError(*faults)


def _explain_hopeless(where: str, hopeless: Deal, question: DrawFilter) -> Fault:
    reasons = count_reasons(hopeless.refused)
    what = Message("template.none-fit", among=hopeless.looked_at(), reasons=reasons)
    expected = Message("template.one-for-each-student")
    if not question.template.scheme.has_mechanism:
        what = Message("template.none-fit-as", what=what, why=question.explain_first())
    return Fault(where, what, expected, hopeless.advise(question))


def count_reasons(refused: Mapping[Reason, int]) -> Part:
    """How often each reason refused a combination, in words: "degenerate 3, mistake 12"."""
    counted = [
        Message("template.reason-count", reason=name_reason(reason), number=count)
        for reason, count in refused.items()
    ]
    return list_plainly(counted) if counted else Message("grammar.no-names")
