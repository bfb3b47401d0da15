"""The questions and asks of an exam by all the names that people have for them: q1.v_B, 1.v_B, 1a,
v_B, question 3.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from string import ascii_lowercase
from typing import NamedTuple
from unicodedata import normalize

from kinegrade.files.cell_text import make_header_key, trim
from kinegrade.question_numbers import find_bank_number, find_printed_number


class Named(NamedTuple):
    """A question, or one of its asks; `ask` is "" for the whole question."""

    question: str
    ask: str = ""

    @property
    def column(self) -> str:
        """As the files of an exam name it."""
        return f"{self.question}.{self.ask}" if self.ask else self.question


@dataclass(frozen=True)
class AskNames:
    """The names of the asks that have these columns in an answer sheet, and of the questions
    `by_hand`, which have none.

    Where papers are `shuffled`, the number of a question with asks says nothing: on each paper it
    is another's. Those by hand keep theirs.

    >>> crank = AskNames(["q1.v_B", "q1.v_b"], ["q2"])
    >>> [named.column for name in ("1b", "q1.v_B", "1", "Q2") if (named := crank.find(name))]
    ['q1.v_b', 'q1.v_B', 'q1', 'q2']
    >>> crank.find("V_B") is None
    True

    A dot may stand before the letter, unless asks are called by letters.

    >>> crank.find("1.b").column, AskNames(["q1.v_B", "q1.a"]).find("1.b")
    ('q1.v_b', None)

    A paper prints 2 for the alternatives q2a and q2b, and an ask of it may be meant by 2a.

    >>> AskNames(["q2a.v_B", "q2b.v_D"]).find("2a") is None
    True
    """

    columns: Sequence[str]
    by_hand: Sequence[str] = ()
    shuffled: bool = False

    def find(self, name: str) -> Named | None:
        """What is meant; None where it is nothing or might be two. Exact spelling comes first,
        because v_A and v_a may both be asked; otherwise case does not matter.
        """
        for named in (
            self._exact.get(trim(normalize("NFKC", name))),
            self._folded.get(make_header_key(name)),
        ):
            if named is not None and len(named) == 1:
                return next(iter(named))
        return None

    @cached_property
    def _exact(self) -> Mapping[str, set[Named]]:
        return _group(self._list())

    @cached_property
    def _folded(self) -> Mapping[str, set[Named]]:
        return _group((make_header_key(name), named) for name, named in self._list())

    def _list(self) -> Iterator[tuple[str, Named]]:
        parted = (column.partition(".") for column in self.columns)
        for question, asks in groupby(parted, lambda parts: parts[0]):
            yield from self._list_question(question, [ask for _, _, ask in asks])
        for question in self.by_hand:
            yield from self._list_question(question, [])

    def _list_question(self, question: str, asks: Sequence[str]) -> Iterator[tuple[str, Named]]:
        number = find_bank_number(question)
        lettered = any(len(ask) == 1 for ask in asks)
        moves = self.shuffled and asks
        for name in (question,) if moves else dict.fromkeys((question, number)):
            yield name, Named(question)
            for letter, ask in zip(ascii_lowercase, asks, strict=False):
                for written in (f"{name}.{ask}", f"{name}{letter}", f"{name}({letter})"):
                    yield written, Named(question, ask)
                if not lettered:
                    yield f"{name}.{letter}", Named(question, ask)
        for letter, ask in zip(ascii_lowercase, asks, strict=False):
            if (printed := find_printed_number(question)) is not None:
                yield f"{printed}{letter}", Named(question, ask)
        for ask in asks:
            yield f"{question}.{ask}", Named(question, ask)
            yield ask, Named(question, ask)


def _group(names: Iterator[tuple[str, Named]]) -> Mapping[str, set[Named]]:
    found: dict[str, set[Named]] = defaultdict(set)
    for name, named in names:
        found[name].add(named)
    return found
