"""Unknowns that equations share, in words and equations: what expresses them by one of them, the
equation into which that is inserted, and the values.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce

from kinegrade.language.message import Message, Text
from kinegrade.mechanics.rates import Rate
from kinegrade.worked.deductions.elimination import Elimination
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import ONE, add_terms
from kinegrade.worked.formulas.equation import Equation, approximate, equate
from kinegrade.worked.formulas.exactness import is_rounded
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.projection import Share
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS, name_value

_NOTHING = 1e-12  # below which a number is one that rounding has left of zero


@dataclass(frozen=True)
class _Printed:
    """An unknown as it is printed: its symbol, which is `size` times the rate, and whether that is
    the letter of a rotation.
    """

    symbol: Formula
    size: float
    turns: bool


def print_unknown(rate: Rate, stage: Stage) -> _Printed | None:
    """A rotation of several vectors, or of none, by its letter; any other rate by its vector."""
    found, turns = stage.occurrences(rate), rate.kind == "turning"
    if turns and len(found) != 1:
        return _Printed(stage.case.naming.turning(rate.body, stage.level), 1.0, True)
    for equation, part in found:
        if part.term is not None:
            size = double(length(part.term.vector, stage.case.arithmetic))
            return _Printed(name_value(equation, part, stage.case), size, False)
    return None


@dataclass(frozen=True)
class Insertion:
    """An elimination as it is printed in a stage."""

    stage: Stage
    elimination: Elimination

    @property
    def _kept(self) -> _Printed:
        """The rate that is kept: a rotation by its letter, whatever vectors it has."""
        rate = self.elimination.kept
        printed = print_unknown(rate, self.stage)
        if rate.kind == "turning" or printed is None:
            return _Printed(self.stage.case.naming.turning(rate.body, self.stage.level), 1.0, True)
        return printed

    def explain(self, solved: Collection[Rate]) -> Iterator[Block]:
        """What expresses the unknowns, and the equation into which that is inserted."""
        case, kept = self.stage.case, self._kept
        expressed: list[Text] = [
            case.tell(_state(printed.symbol, add_terms(self._list_terms(rate, kept.symbol))))
            for rate in self.elimination.lines
            if (printed := print_unknown(rate, self.stage)) and printed.symbol != kept.symbol
        ]
        way = "relations" if self.elimination.by is None else "equation"
        yield case.say(
            Message(
                f"solution.inserted-by-{way}",
                expressed=reduce(_list_two, expressed),
                kept=case.text(kept.symbol),
            )
        )
        into = self.elimination.into
        left, right = (
            add_terms(term for share in side for term in self._insert(share, solved))
            for side in (into.left, into.right)
        )
        yield case.show(Equation(left, equate(right)))

    def find_working(self, rate: Rate) -> tuple[Formula, ...]:
        """What gives an unknown from the value of the rate kept, in numbers; nothing where that is
        zero, or the unknown is it.
        """
        kept, case = self._kept, self.stage.case
        printed = print_unknown(rate, self.stage)
        value = double(case.rates(self.stage.level)[self.elimination.kept]) * kept.size
        if printed is None or printed.symbol == kept.symbol or not value:
            return ()
        terms = self._list_terms(rate, measure(value, UNITS[self.stage.level, kept.turns]))
        return (add_terms(terms),)

    def _list_terms(self, rate: Rate, kept: Formula) -> Sequence[Formula]:
        """An unknown by the rate kept, in numbers: a multiple of that and what is added."""
        printed, line = print_unknown(rate, self.stage), self.elimination.lines[rate]
        if printed is None:
            raise TypeError("an unknown that is not printed is expressed by nothing")
        slope, offset = line.slope * printed.size / self._kept.size, line.offset * printed.size
        factor = measure(abs(slope), "m" if self._kept.turns and not printed.turns else "1")
        multiple = kept if factor == measure(1, "1") else factor * kept
        added = measure(abs(offset), UNITS[self.stage.level, printed.turns])
        signed = ((slope, multiple), (offset, added))
        return [
            one.signed(1 if number > 0 else -1) for number, one in signed if abs(number) > _NOTHING
        ]

    def _insert(self, share: Share, solved: Collection[Rate]) -> Iterator[Formula]:
        """The terms of a share, an unknown one expressed by the rate kept."""
        into, rate = self.elimination.into, share.part.unknown
        if rate is None or rate not in self.elimination.lines or share.part.term is None:
            yield from self.stage.list_terms(into, (share,), 1, solved)
            return
        turned, cosine = self.stage.state_cosine(into, share, True)
        printed = print_unknown(rate, self.stage)
        arm = measure(length(share.part.term.vector, self.stage.case.arithmetic), "m")
        for term in self._list_terms(rate, self._kept.symbol):
            size = arm * term.size if printed and printed.turns else term.size
            yield (size if cosine == ONE else size * cosine).signed(turned * term.sign)


def _state(left: Formula, right: Formula) -> Equation:
    """An equation that says where a number in it is rounded."""
    return Equation(left, approximate(right) if is_rounded(right) else equate(right))


def _list_two(first: Text, following: Text) -> Message:
    return Message("solution.equation-list", first=first, next=following)
