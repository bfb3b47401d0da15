"""For how many students each accepted answer of a policy counted: for none, it may be mistaken; and
who has all points for what follows from one.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from kinegrade.exam.folder.asks import Ask
from kinegrade.grading.fast.judged_block import FULL_SHARE, JudgedBlock
from kinegrade.grading.marks import MarkedBlock
from kinegrade.grading.policy.policy import Policy
from kinegrade.language.message import Message, Quoted, list_first

_NAMED = 5  # students


@dataclass(frozen=True)
class AcceptedCounts:
    """The counts of a marking by answer column and number, block by block; the students who have
    all points for an answer, by its column and that of the accepted answer from which it follows.
    """

    policy: Policy
    asks: Sequence[Ask]
    counts: Counter[tuple[str, int]] = field(default_factory=Counter)
    following: dict[tuple[str, str], list[str]] = field(default_factory=lambda: defaultdict(list))

    def watched(self, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
        """The same blocks, counted on their way."""
        for block in blocks:
            for place, number in block.judged.accepted.items():
                if block.judged.kind(place) == "accepted":
                    self.counts[self.asks[place % len(self.asks)].column, number] += 1
            self._note_following(block.judged)
            yield block
            del block  # so that the next takes its place

    def _note_following(self, judged: JudgedBlock) -> None:
        for place, names in judged.rests_on.items():
            if judged.kind(place) != "follow-through" or judged.shares[place] != FULL_SHARE:
                continue
            row, number = divmod(place, len(self.asks))
            for beside, ask in enumerate(self.asks):
                basis = row * len(self.asks) + beside
                same = ask.question == self.asks[number].question and ask.ask in names
                if same and judged.kind(basis) == "accepted" and judged.shares[basis] == FULL_SHARE:
                    which = self.asks[number].column, ask.column
                    self.following[which].append(judged.rows.papers[row].student)

    def describe(self) -> Iterator[Message]:
        """A line for each accepted answer, in the order of the asks, and for what follows from
        them.
        """
        for ask in self.asks:
            for each in self.policy.ruling(ask.column).accepted:
                yield Message(
                    "policy.counted",
                    ask=ask.column,
                    number=each.number,
                    text=Quoted(each.text),
                    count=self.counts[ask.column, each.number],
                )
        for (column, basis), students in self.following.items():
            yield Message(
                "policy.follows-accepted",
                ask=column,
                basis=basis,
                count=len(students),
                students=list_first(students, _NAMED),
            )
