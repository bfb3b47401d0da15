"""Alternatives: questions of which each paper of an exam holds only some.

Everything that asks which questions a paper may hold asks `fits_paper`; which it does hold is said
by its line of the key.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from math import gcd

import msgspec

from kinegrade.draws.keyed_order import address


class Choice(msgspec.Struct, frozen=True):
    """Alternatives, of which each paper holds as many as are `given`."""

    questions: tuple[str, ...]
    given: int

    def choose(self, secret: str, place: int) -> tuple[str, ...]:
        """Those of the paper at a place of the class: to as many places one after another as there
        are alternatives each is given equally often, and to any others from there on once more to
        some than to others, at most.
        """
        count = len(self.questions)
        evenly = count // gcd(count, self.given)  # so many papers hold each equally often
        round_number, turn = divmod(place, count)
        ranked = sorted(
            self.questions,
            key=lambda name: address(secret, "alternative", str(round_number), name),
        )
        first = turn * self.given + turn // evenly  # then with other neighbours
        return tuple(ranked[(first + step) % count] for step in range(self.given))


def fits_paper(held: Sequence[str], questions: Collection[str], choices: Iterable[Choice]) -> bool:
    """Whether these may be all questions of one paper of an exam with these `questions`: each
    once, and of alternatives as many as are given.
    """
    found = set(held)
    optional: set[str] = set()
    for choice in choices:
        if len(found.intersection(choice.questions)) != choice.given:
            return False
        optional.update(choice.questions)
    return len(found) == len(held) and set(questions) - optional <= found <= set(questions)
