"""A check says of what has been found something else than each equation before it: where its
letters change a little, it changes by no multiple of what that equation does.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from math import hypot

from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Row
from kinegrade.worked.document import Block
from tests.worked.reader.amounts import Amount, MixedUnits, Unreadable
from tests.worked.reader.checks import RELATION, split_check
from tests.worked.reader.equations import Line, read_page
from tests.worked.reader.formula_reader import Worth, find_symbols, read_formula

_STEP = 1e-6
_SAME = 1e-7  # of the size of both, what is left of them crosswise
Change = Mapping[str, float]


@dataclass(frozen=True)
class _Claim:
    """Two sides that are said to be equal."""

    left: Row
    right: Row

    def differentiate(self, worth: Worth, found: Set[str]) -> Change:
        """By how much it changes with each letter that has been found, relative to its value;
        nothing where it cannot be read.
        """
        letters = {*find_symbols(self.left), *find_symbols(self.right)} & found
        try:
            changes = {letter: self._change(worth, letter) for letter in letters}
        except (Unreadable, MixedUnits, ZeroDivisionError, ValueError):
            return {}
        size = hypot(*changes.values())
        return {letter: one / size for letter, one in changes.items() if abs(one) > _SAME * size}

    def _change(self, worth: Worth, letter: str) -> float:
        step = _STEP * (abs(worth(letter).value) or 1.0)
        more, less = (self._measure(_shift(worth, letter, one)) for one in (step, -step))
        return (more - less) / (2 * _STEP)

    def _measure(self, worth: Worth) -> float:
        return read_formula(self.left, worth).value - read_formula(self.right, worth).value


def _shift(worth: Worth, letter: str, step: float) -> Worth:
    def shifted(symbol: str) -> Amount:
        amount = worth(symbol)
        return replace(amount, value=amount.value + step) if symbol == letter else amount

    return shifted


def find_told_before(blocks: Sequence[Block], worth: Worth, given: Set[str]) -> Iterator[str]:
    """The checks that a line above them has said, in its letters; those `given` are not found."""
    found = set[str]()
    told: list[_Claim] = []
    for block in blocks:
        sides = split_check(block)
        if sides:
            check = _Claim(*(read_math(RELATION.split(side)[0].strip(), "") for side in sides))
            change = check.differentiate(worth, found)
            if any(_are_multiples(change, one.differentiate(worth, found)) for one in told):
                yield " = ".join(sides)
            continue
        for line in (part for part in read_page((block,)) if isinstance(part, Line)):
            found |= {*find_symbols(line.left)} - given
            lettered = (side.row for side in line.sides if any(find_symbols(side.row)))
            told += (_Claim(line.left, row) for row in lettered)


def _are_multiples(first: Change, second: Change) -> bool:
    """Whether two changes are in proportion; one that is nothing is in none."""
    if not first or first.keys() != second.keys():
        return False
    turned = sum(first[letter] * second[letter] for letter in first)
    return all(abs(first[letter] * turned - second[letter]) < 1e-5 for letter in first)
