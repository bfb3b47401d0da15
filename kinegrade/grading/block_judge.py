"""Thousands of answers held against their keys at once: what `decide` says of each, in a fraction of the time.

`marks` uses it. Plain numbers are compared in double precision by `nearness`; `decide` is asked about all that this
leaves open: a number near a bound, several mistakes that lead to one answer, accepted answers, a wrong unit.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import groupby
from math import nan
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.accepted import Alternative, Alternatives
from kinegrade.grading.decimal_style import FileStyle
from kinegrade.grading.decision import BY_POLICY, Decision, decide, voided
from kinegrade.grading.follow import Decided, Follows, follow_through
from kinegrade.grading.judge import Kind, Verdict, judge
from kinegrade.grading.judged_block import FULL_SHARE, NO_SHARE, JudgedBlock, Row
from kinegrade.grading.key import Ask, Key, Rule, StatedKey, rule
from kinegrade.grading.nearness import Comparison, Flags, Rules, compare, rules_of
from kinegrade.grading.policy import NO_ROOM, Policy, Ruling
from kinegrade.grading.typed_cells import CellReader

Places = NDArray[np.intp]
Keys = Sequence[Key | StatedKey]
Open = dict[int, Collection[str] | None]  # places to be decided one by one: the mistakes that come in question, or all
_LED_ON: tuple[Kind, ...] = ("wrong", "mistake", "accepted")  # numbers from which somebody may have gone on
_TOO_NEAR = 1e-9  # relative: of two mistakes that are nearer together either may be the nearer one
_NO_RULE = rule(Fraction(0), Fraction(0))
_NO_KEY = Key(Fraction(0), Fraction(0))
_OWNER = itemgetter(0)


class _Way(NamedTuple):
    """A mistake that may lead to the answer at a place: how far from the answer, and in words."""

    place: int
    name: str
    certain: bool
    difference: float
    value: float
    reason: str


@dataclass(frozen=True, slots=True)
class BlockJudge:
    """What it takes to judge the rows of a class; `follows` is asked where somebody may have gone on from an error."""

    asks: tuple[Ask, ...]
    policy: Policy
    alternatives: Alternatives
    styles: FileStyle
    follows: Follows | None = None

    @property
    def questions(self) -> list[range]:
        """Where the asks of each question stand among all asks."""
        groups = groupby(range(len(self.asks)), lambda number: self.asks[number].question)
        return [range(places[0], places[-1] + 1) for places in (list(group) for _, group in groups)]

    def judged(self, rows: Sequence[Row]) -> JudgedBlock:
        """Judges every answer of these rows."""
        cells = CellReader(self.asks, self.styles).cells([entry.responses for _, entry in rows])
        count = len(cells.typed)
        block = JudgedBlock(rows, cells, ["blank"] * count, [""] * count, [NO_SHARE] * count)
        for place, names in self._compared(block).items():
            block.put(place, self._decided(block, place, names))
        if self.follows is not None:
            for row, question in self._led_on(block):
                self._follow_through(block, row, question, self.follows)
        for number, ask in enumerate(self.asks):
            self._void(block, number, self.policy.ruling(ask.column))
        return block

    def _ruling(self, place: int) -> Ruling:
        return self.policy.ruling(self.asks[place % len(self.asks)].column)

    def _compared(self, block: JudgedBlock) -> Open:
        """Puts down all that is certain, and gives what is not."""
        keys = [key for paper, _ in block.rows for key in paper.keys]
        rules = rules_of(self._rules_now(keys))
        comparison = compare(block.cells.values, np.array(list(map(_centre, keys))), rules)
        right = np.flatnonzero(comparison.certain & comparison.right)
        wrong = np.flatnonzero(comparison.certain & ~comparison.right)
        _put_numbers(block, "right", right, comparison, self._suffixes())
        _put_numbers(block, "wrong", wrong, comparison, self._suffixes())
        return self._uncertain(block, comparison.certain) | self._mistaken(block, wrong, keys, rules)

    def _rules_now(self, keys: Keys) -> list[Rule]:
        """The rule of each answer by the policy."""
        rulings = [self.policy.ruling(ask.column) for ask in self.asks]
        if all(ruling.room == NO_ROOM for ruling in rulings):
            return [key.rule or _NO_RULE for key in keys]
        now: dict[tuple[int, int], Rule] = {}  # few rules serve a whole class, and they are slow to compare
        for number, key in enumerate(keys):
            place = number % len(rulings), id(key.rule)
            if place not in now:
                stated = key.rule or _NO_RULE
                now[place] = rulings[place[0]].key(stated.key(Fraction(1))).rule or stated
        return [now[number % len(rulings), id(key.rule)] for number, key in enumerate(keys)]

    def _suffixes(self) -> list[str]:
        rulings = (self.policy.ruling(ask.column) for ask in self.asks)
        return ["" if ruling.room == NO_ROOM else BY_POLICY for ruling in rulings]

    def _uncertain(self, block: JudgedBlock, certain: Flags) -> Open:
        """What was typed and could not be compared; puts down what is no number at all."""
        found: Open = {}
        for place in np.flatnonzero(~certain).tolist():
            reading = block.cells.odd.get(place)
            if reading is not None and reading.kind != "number" and not self._ruling(place).wrong_unit:
                block.put(place, (judge(reading, _NO_KEY), block.credits[NO_SHARE]))
            elif block.cells.typed[place]:
                found[place] = None
        return found

    def _mistaken(self, block: JudgedBlock, wrong: Places, keys: Keys, rules: Rules) -> Open:
        """Puts down the wrong answers to which just one mistake leads; gives those with several, or other ways out."""
        listed = wrong.tolist()
        names = [name for place in listed for name in keys[place].mistakes]
        values = np.array([value for place in listed for value in keys[place].mistakes.values()], dtype=np.float64)
        owners = np.repeat(wrong, [len(keys[place].mistakes) for place in listed])
        led = compare(block.cells.values[owners], values, rules.at(owners))
        likely = np.flatnonzero(led.right | ~led.decided)
        ways = [_Way(*each) for each in zip(
            owners[likely].tolist(), [names[each] for each in likely.tolist()], led.certain[likely].tolist(),
            led.difference[likely].tolist(), led.centres[likely].tolist(), led.reasons(likely), strict=True)]
        found: Open = {place: None for place in listed if self._others(block, place)} if self.alternatives else {}
        for place, group in groupby(ways, _OWNER):
            leading, shares = list(group), self._ruling(place).mistakes
            best = _best(leading, shares)
            if best is None:
                found.setdefault(place, {way.name for way in leading})
            elif place not in found:
                share = shares.get(best.name, block.credits[NO_SHARE])
                block.put(place, (Verdict("mistake", f"{best.name}: leads to {best.reason}"), share))
        return found

    def _others(self, block: JudgedBlock, place: int) -> Sequence[Alternative]:
        row, number = divmod(place, len(self.asks))
        return self.alternatives.get((block.rows[row][0].student, self.asks[number].column), ())

    def _decided(self, block: JudgedBlock, place: int, names: Collection[str] | None) -> Decision:
        """One answer, decided exactly; of the mistakes by those of these names, or by all."""
        row, number = divmod(place, len(self.asks))
        key, reread = block.rows[row][0].key(number, names), partial(block.cells.reread, place)
        return decide(block.cells.reading(place), key, self._ruling(place), self._others(block, place), reread)

    def _led_on(self, block: JudgedBlock) -> Iterator[tuple[int, range]]:
        """Rows and questions with a number that is not right after another one."""
        for row in range(len(block.rows)):
            kinds = block.kinds[row * len(self.asks) : (row + 1) * len(self.asks)]
            for question in self.questions:
                if sum(kind in _LED_ON for kind in kinds[question.start : question.stop]) > 1:
                    yield row, question

    def _follow_through(self, block: JudgedBlock, row: int, question: range, follows: Follows) -> None:
        paper, first = block.rows[row][0], row * len(self.asks)
        answers = [
            Decided(self.asks[number], block.cells.reading(first + number), paper.key(number, ()),
                    self._ruling(number), block.decision(first + number))
            for number in question
        ]
        better = follow_through(paper.student, answers, follows)
        for number in question:
            if self.asks[number].ask in better:
                block.put(first + number, better[self.asks[number].ask])

    def _void(self, block: JudgedBlock, number: int, ruling: Ruling) -> None:
        """Says of all answers to an ask that they are void, where they are."""
        if ruling.void:
            for row, (_, entry) in enumerate(block.rows):
                place = row * len(self.asks) + number
                block.put(place, voided(block.decision(place), ruling, handed_in=entry.line is not None))


def _put_numbers(
    block: JudgedBlock, kind: Kind, places: Places, comparison: Comparison, suffixes: Sequence[str]
) -> None:
    share = FULL_SHARE if kind == "right" else NO_SHARE
    for place, reason in zip(places.tolist(), comparison.reasons(places), strict=True):
        block.kinds[place], block.shares[place] = kind, share
        block.reasons[place] = f"key {reason}{suffixes[place % len(suffixes)]}"


def _best(ways: Sequence[_Way], shares: Mapping[str, Fraction]) -> _Way | None:
    """Of the mistakes that lead to an answer the one with the best credit, of equal ones the nearest, then by name.

    None where double precision cannot tell.
    """
    if not all(way.certain for way in ways):
        return None
    best = min(ways, key=lambda way: (-shares.get(way.name, 0), way.difference, way.name)) if ways[1:] else ways[0]
    for way in ways:
        near = abs(way.difference - best.difference) < _TOO_NEAR * abs(best.value)
        if near and way.value != best.value:
            return None
    return best


def _centre(key: Key | StatedKey) -> float:
    """The right answer in double precision; NaN where that is not all there is to compare with."""
    if isinstance(key, StatedKey):
        return nan if key.period else key.approximately
    return nan if key.period or key.rule is None else float(key.value)
