"""An instance solved: what it gives to everything after."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from kinegrade.errors import NoSuchAsk, suggest
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.motion import Motion
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.assemble import Assembly
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template.template import Template


@dataclass(frozen=True, eq=False, repr=False)
class Solution(Mapping[str, Quantity]):
    """An instance solved: its parameters and answers in their units, and the motion they come
    from. It maps the names of what is asked to the answers, and equals any mapping of equal ones.
    """

    template: Template
    parameters: Mapping[str, Quantity]
    answers: Mapping[str, Quantity]
    assembly: Assembly
    motion: Motion
    arithmetic: Arithmetic

    @cached_property
    def doubles(self) -> Motion:
        """The motion in doubles: for scales, and for working it out again by hand."""
        return self.motion.map(float)

    def __getitem__(self, ask: str) -> Quantity:
        """The answer of an ask. Raises NoSuchAsk, a KeyError."""
        if ask not in self.answers:
            raise NoSuchAsk(Fault(self.template.name, explain_no_ask(str(ask), self.answers)))
        return self.answers[ask]

    def __iter__(self) -> Iterator[str]:
        return iter(self.answers)

    def __len__(self) -> int:
        return len(self.answers)

    def only(self, asks: Collection[str]) -> Solution:
        """The same with the answers of these asks alone."""
        answers = {name: each for name, each in self.answers.items() if name in asks}
        return replace(self, answers=answers)

    def __repr__(self) -> str:
        return f"<{self.template.name}: {', '.join(map(str, self.answers.values()))}>"


def explain_no_ask(name: str, known: Iterable[str]) -> Message:
    """That nothing of that name is asked, with the name that may have been meant."""
    hint = suggest(name, known)
    return Message("template.no-ask", name=Quoted(name), hint=hint)
