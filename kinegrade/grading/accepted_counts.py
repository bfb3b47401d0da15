"""For how many students each accepted answer of a policy counted: for none, it may be mistaken."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from kinegrade.exam.folder.asks import Ask
from kinegrade.grading.marks import MarkedBlock
from kinegrade.grading.policy.policy import Policy
from kinegrade.language.message import Message, Quoted


@dataclass(frozen=True)
class AcceptedCounts:
    """The counts of a marking by answer column and number, block by block."""

    policy: Policy
    asks: Sequence[Ask]
    counts: Counter[tuple[str, int]] = field(default_factory=Counter)

    def watched(self, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
        """The same blocks, counted on their way."""
        for block in blocks:
            for place, number in block.judged.accepted.items():
                if block.judged.kind(place) == "accepted":
                    self.counts[self.asks[place % len(self.asks)].column, number] += 1
            yield block
            del block  # so that the next takes its place

    def describe(self) -> Iterator[Message]:
        """A line for each accepted answer, in the order of the asks."""
        for ask in self.asks:
            for each in self.policy.ruling(ask.column).accepted:
                yield Message(
                    "policy.counted",
                    ask=ask.column,
                    number=each.number,
                    text=Quoted(each.text),
                    count=self.counts[ask.column, each.number],
                )
