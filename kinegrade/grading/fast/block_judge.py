"""Thousands of answers compared with their keys at once: the same verdicts as `decide`, in a
fraction of the time.

`marks` uses it. Plain numbers are compared in double precision by `bulk_comparison`. `decide`
settles whatever this leaves open: a number near a bound, several mistakes that lead to one answer,
accepted answers, a wrong unit.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import chain, groupby
from math import nan
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.keys import Ask, Key, Paper
from kinegrade.exam.folder.stated_keys import StatedKeys, read_stated_mistakes
from kinegrade.grading.fast.comparison import Comparison, Flags, Rules, compare, may_agree, rules_of
from kinegrade.grading.fast.judged_block import FULL_SHARE, NO_SHARE, JudgedBlock, Row
from kinegrade.grading.fast.reasons import read_comparisons, read_reasons, write_mistakes
from kinegrade.grading.fast.typed_cells import CellReader
from kinegrade.grading.judging.decision import Decision, decide, void
from kinegrade.grading.judging.follow import Decided, Follows, follow_answers
from kinegrade.grading.judging.judge import Kind, judge
from kinegrade.grading.policy.accepted import Alternative, Alternatives
from kinegrade.grading.policy.policy import NO_ROOM, Policy, Ruling
from kinegrade.grading.typed.decimal_style import FileStyle
from kinegrade.language import ENGLISH, Language
from kinegrade.numbers.tolerance import Tolerance

_Places = NDArray[np.intp]
# Places to be decided one by one: the mistakes to consider there, or all
_Open = dict[int, Collection[str] | None]
# Numbers that a later answer may build on
_LED_ON: tuple[Kind, ...] = ("wrong", "mistake", "accepted")
_TOO_NEAR = 1e-9  # relative: of two mistakes this near to each other, either may be the nearer one
_NO_KEY = Key(Fraction(0), Tolerance())
_OWNER = itemgetter(0)


class _Way(NamedTuple):
    """A mistake that may lead to the answer at a place: its distance from the answer, also in
    words.
    """

    place: int
    name: str
    certain: bool
    difference: float
    value: float
    comparison: str


@dataclass(frozen=True, slots=True)
class BlockJudge:
    """Everything needed to judge the rows of a class; `follows` is asked where a student may have
    carried an error forward. Reasons are in `language`, or can be said in it.
    """

    asks: tuple[Ask, ...]
    policy: Policy
    alternatives: Alternatives
    styles: FileStyle
    follows: Follows | None = None
    language: Language = ENGLISH

    @property
    def questions(self) -> list[range]:
        """The positions of each question's asks among all asks."""
        groups = groupby(range(len(self.asks)), lambda number: self.asks[number].question)
        return [range(places[0], places[-1] + 1) for places in (list(group) for _, group in groups)]

    def judged(self, rows: Sequence[Row]) -> JudgedBlock:
        """Judges every answer in these rows."""
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

    def _compared(self, block: JudgedBlock) -> _Open:
        """Records every certain verdict, and gives the places still open."""
        papers = [paper for paper, _ in block.rows]
        rules, centres = (
            self._rules_now(papers),
            np.array([_list_centres(paper) for paper in papers], dtype=np.float64),
        )
        comparison = compare(block.cells.values, centres.reshape(-1), rules)
        self._put_numbers(block, comparison)
        wrong = np.flatnonzero(comparison.certain & ~comparison.right)
        return self._uncertain(block, comparison.certain) | self._mistaken(block, wrong, rules)

    def _rules_now(self, papers: Sequence[Paper]) -> Rules:
        """The rule for each answer under the policy."""
        rulings = [self.policy.ruling(ask.column) for ask in self.asks]
        stated = [_list_rules(paper) for paper in papers]
        if all(ruling.room == NO_ROOM for ruling in rulings):
            return rules_of(stated)
        different = {id(rules): rules for rules in stated}
        now = {name: tuple(map(Ruling.rule, rulings, rules)) for name, rules in different.items()}
        return rules_of([now[id(rules)] for rules in stated])

    def _put_numbers(self, block: JudgedBlock, comparison: Comparison) -> None:
        certain = np.flatnonzero(comparison.certain)
        changed = self._changed_rules()[certain % len(self.asks)]
        for by_policy in (False, True):
            places = certain[changed == by_policy]
            self._put_alike(block, comparison, places, by_policy=by_policy)

    def _put_alike(
        self, block: JudgedBlock, comparison: Comparison, places: _Places, *, by_policy: bool
    ) -> None:
        """Numbers at places where the paper's rule holds, or where the policy's does."""
        listed = places.tolist()
        right = comparison.right[places].tolist()
        reasons = comparison.reasons(places, read_reasons(self.language, by_policy=by_policy))
        for place, is_right, reason in zip(listed, right, reasons, strict=True):
            block.kinds[place], block.shares[place] = (
                ("right", FULL_SHARE) if is_right else ("wrong", NO_SHARE)
            )
            block.reasons[place] = reason
        if by_policy:
            block.by_policy.update(listed)

    def _changed_rules(self) -> Flags:
        """For each ask, whether the policy's rule is not the paper's."""
        rulings = (self.policy.ruling(ask.column) for ask in self.asks)
        return np.array([ruling.room != NO_ROOM for ruling in rulings], dtype=np.bool_)

    def _uncertain(self, block: JudgedBlock, certain: Flags) -> _Open:
        """What was typed but could not be compared; records whatever is not a number at all."""
        found: _Open = {}
        for place in np.flatnonzero(~certain).tolist():
            reading = block.cells.readings.get(place)
            if (
                reading is not None
                and reading.kind != "number"
                and not self._ruling(place).wrong_unit
            ):
                block.put(place, (judge(reading, _NO_KEY), block.credits[NO_SHARE]))
            elif block.cells.typed[place]:
                found[place] = None
        return found

    def _mistaken(self, block: JudgedBlock, wrong: _Places, rules: Rules) -> _Open:
        """Records the wrong answers that exactly one mistake leads to; gives those with several, or
        with other ways to credit.
        """
        listed, none = wrong.tolist(), block.credits[NO_SHARE]
        credit = [self.policy.ruling(ask.column).mistakes for ask in self.asks]
        found: _Open = (
            {place: None for place in listed if self._others(block, place)}
            if self.alternatives
            else {}
        )
        for place, group in groupby(self._ways(block, listed, rules), _OWNER):
            leading, shares = list(group), credit[place % len(credit)]
            best = _find_best(leading, shares)
            if best is None:
                found.setdefault(place, {way.name for way in leading})
            elif place not in found:
                others = sorted(way.name for way in leading if way is not best)
                mistakes = (best.name, *others)
                reason = write_mistakes(mistakes, best.comparison, self.language)
                block.put_mistakes(place, mistakes, reason, shares.get(best.name, none))
        return found

    def _ways(self, block: JudgedBlock, wrong: Sequence[int], rules: Rules) -> Iterator[_Way]:
        """The mistakes that may lead to the wrong answers at these places, in the order of the
        places.
        """
        mistakes = _list_mistakes(
            [(block.rows[place // len(self.asks)][0], place % len(self.asks)) for place in wrong]
        )
        names = list(chain.from_iterable(mistakes))
        values = np.fromiter(
            chain.from_iterable(each.values() for each in mistakes), np.float64, len(names)
        )
        owners = np.repeat(np.array(wrong, dtype=np.intp), list(map(len, mistakes)))
        near = np.flatnonzero(may_agree(block.cells.values[owners], values, rules.at(owners)))
        names, owners = [names[each] for each in near.tolist()], owners[near]
        led = compare(block.cells.values[owners], values[near], rules.at(owners))
        likely = np.flatnonzero(led.right | ~led.decided)
        return map(
            _Way,
            owners[likely].tolist(),
            [names[each] for each in likely.tolist()],
            led.certain[likely].tolist(),
            led.difference[likely].tolist(),
            led.centres[likely].tolist(),
            led.reasons(likely, read_comparisons(self.language)),
        )

    def _others(self, block: JudgedBlock, place: int) -> Sequence[Alternative]:
        row, number = divmod(place, len(self.asks))
        paper = block.rows[row][0]
        which = paper.student, paper.source(number), self.asks[number].column
        return self.alternatives.get(which, ())

    def _decided(self, block: JudgedBlock, place: int, names: Collection[str] | None) -> Decision:
        """One answer, decided exactly; only the mistakes with these names are considered, or
        all.
        """
        row, number = divmod(place, len(self.asks))
        key, reread = block.rows[row][0].key(number, names), partial(block.cells.reread, place)
        return decide(
            block.cells.reading(place), key, self._ruling(place), self._others(block, place), reread
        )

    def _led_on(self, block: JudgedBlock) -> Iterator[tuple[int, range]]:
        """Rows and questions in which a number that is not right comes after another number."""
        for row in range(len(block.rows)):
            kinds = block.kinds[row * len(self.asks) : (row + 1) * len(self.asks)]
            for question in self.questions:
                if sum(kind in _LED_ON for kind in kinds[question.start : question.stop]) > 1:
                    yield row, question

    def _follow_through(
        self, block: JudgedBlock, row: int, question: range, follows: Follows
    ) -> None:
        paper, first = block.rows[row][0], row * len(self.asks)
        sources = {paper.source(number) for number in question}
        if len(sources) > 1:  # drawn separately: nothing follows for one mechanism from another
            return
        answers = [
            Decided(
                self.asks[number],
                block.cells.reading(first + number),
                paper.key(number, ()),
                self._ruling(number),
                block.decision(first + number),
            )
            for number in question
        ]
        better = follow_answers(sources.pop(), answers, follows)
        for number in question:
            if self.asks[number].ask in better:
                block.put(first + number, better[self.asks[number].ask])

    def _void(self, block: JudgedBlock, number: int, ruling: Ruling) -> None:
        """Marks all answers to an ask as void, if it is void."""
        if ruling.void:
            for row, (_, entry) in enumerate(block.rows):
                place = row * len(self.asks) + number
                block.put(
                    place, void(block.decision(place), ruling, handed_in=entry.line is not None)
                )


def _find_best(ways: Sequence[_Way], shares: Mapping[str, Fraction]) -> _Way | None:
    """The mistake with the best credit among those that lead to an answer; of equals the nearest,
    then the first by name.

    None where double precision cannot decide.
    """
    if len(ways) == 1 and ways[0].certain:
        return ways[0]
    if not all(way.certain for way in ways):
        return None
    best = min(ways, key=lambda way: (-shares.get(way.name, 0), way.difference, way.name))
    for way in ways:
        near = abs(way.difference - best.difference) < _TOO_NEAR * abs(best.value)
        if near and way.value != best.value:
            return None
    return best


def _list_centres(paper: Paper) -> Sequence[float]:
    """The right answers in double precision; NaN where there is more to compare with than that."""
    if isinstance(paper.keys, StatedKeys):
        return paper.keys.centres
    return [nan if key.period else float(key.value) for key in paper.keys]


def _list_rules(paper: Paper) -> tuple[Tolerance, ...]:
    if isinstance(paper.keys, StatedKeys):
        return paper.keys.terms.rules
    return tuple(key.rule for key in paper.keys)


def _list_mistakes(wrong: Sequence[tuple[Paper, int]]) -> Sequence[Mapping[str, float | Fraction]]:
    """The wrong values that mistakes lead to in these asks."""
    stated = [(paper.keys, ask) for paper, ask in wrong if isinstance(paper.keys, StatedKeys)]
    return (
        read_stated_mistakes(stated)
        if len(stated) == len(wrong)
        else [paper.keys[ask].mistakes for paper, ask in wrong]
    )
