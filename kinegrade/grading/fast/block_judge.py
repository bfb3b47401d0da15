"""The fast twin of `judging.decision.decide`: the same decisions for thousands of answers at once.

`marks` uses it. Plain numbers are compared in double precision by `comparison` and `mistaken`.
`decide` settles whatever this leaves open: a number near a bound, mistakes that cannot be ranked,
accepted answers, a wrong unit.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import groupby
from operator import itemgetter

import numpy as np

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.columns.gathering import list_rules, read_mistakes
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.folder.papers import Paper
from kinegrade.grading.fast.another_paper import PapersAnswered
from kinegrade.grading.fast.bounds import Flags, Places, Rules, tabulate_rules
from kinegrade.grading.fast.compared_cells import compare_cells
from kinegrade.grading.fast.judged_block import JudgedBlock
from kinegrade.grading.fast.mistaken import Leading, Mistakes, find_best
from kinegrade.grading.fast.reasons import Sentence, say_together
from kinegrade.grading.fast.typed_cells import CellReader
from kinegrade.grading.judging.decision import Decision, decide, void
from kinegrade.grading.judging.follow import Decided, Follows, follow_answers, withhold
from kinegrade.grading.judging.judge import Kind, judge
from kinegrade.grading.policy.accepted import Alternative, Alternatives
from kinegrade.grading.policy.policy import NO_ROOM, Policy, Ruling
from kinegrade.grading.sheets.rows import Rows
from kinegrade.grading.typed.decimal_style import FileStyle
from kinegrade.language import Language
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.stated_marking import find_identifier

# Places to be decided one by one: the mistakes to consider there, or all
_Open = dict[int, Collection[str] | None]
# Numbers that a later answer may build on
_LED_ON: tuple[Kind, ...] = ("wrong", "mistake", "accepted")
_ROW: Callable[[tuple[int, range]], int] = itemgetter(0)
_NO_KEY = Key(Fraction(0), Tolerance())


@dataclass(frozen=True, slots=True)
class BlockJudge:
    """Everything needed to judge the rows of a class; `follows` is asked where a student may have
    carried an error forward, `papers` whether that was done on another paper. Reasons are in the
    language of the papers, or can be said in it.
    """

    papers: PapersAnswered
    policy: Policy
    alternatives: Alternatives
    styles: FileStyle
    follows: Follows | None = None

    @property
    def asks(self) -> tuple[Ask, ...]:
        """The asks in the order of the paper."""
        return self.papers.sitting.asks

    @property
    def language(self) -> Language:
        """The language of the papers."""
        return self.papers.sitting.language

    def judged(self, rows: Rows, handed_in: Callable[[Paper], bool]) -> JudgedBlock:
        """Judges every answer in these rows; void asks may give points to who `handed_in`."""
        cells = CellReader(self.asks, self.styles).cells(rows.entries.cells)
        keys = rows.papers.keys
        rules = self._rules(list_rules(keys))
        comparison = compare_cells(cells, keys, rules)
        block = JudgedBlock.begin(rows, cells, comparison, self.language)
        for place, names in self._compared(block, rules).items():
            block.put(place, self._decided(block, place, names))
        if self.follows is not None:
            questions = tuple(self._led_on(block, self.follows))
            block.word(self._list_places(questions))
            for row, led_on in groupby(questions, _ROW):
                self._credit(block, row, [question for _, question in led_on], self.follows)
        for number, ask in enumerate(self.asks):
            if self.policy.ruling(ask.column).void:
                self._void(block, number, handed_in)
        return block

    def _void(self, block: JudgedBlock, number: int, handed_in: Callable[[Paper], bool]) -> None:
        """Marks all answers to an ask as void."""
        ruling = self.policy.ruling(self.asks[number].column)
        for row, paper in enumerate(block.rows.papers):
            if number not in paper.lacks:
                place = row * len(self.asks) + number
                decision = block.decision(place)
                block.put(place, void(decision, ruling, handed_in=handed_in(paper)))

    def _ruling(self, place: int) -> Ruling:
        return self.policy.ruling(self.asks[place % len(self.asks)].column)

    def _compared(self, block: JudgedBlock, rules: Rules) -> _Open:
        """Records every certain verdict, and gives the places still open."""
        comparison = block.comparison
        certain = np.flatnonzero(comparison.certain)
        changed = np.array([self.policy.ruling(ask.column).room != NO_ROOM for ask in self.asks])
        block.put_compared(certain, changed[certain % len(self.asks)])
        wrong = np.flatnonzero(comparison.certain & ~comparison.right)
        return self._uncertain(block, comparison.certain) | self._mistaken(block, wrong, rules)

    def _rules(self, printed: Sequence[tuple[Tolerance, ...]]) -> Rules:
        """The rule for each answer under the policy, from those that the papers print."""
        rulings = [self.policy.ruling(ask.column) for ask in self.asks]
        if all(ruling.room == NO_ROOM for ruling in rulings):
            return tabulate_rules(printed)
        different = {id(rules): rules for rules in printed}
        now = {name: tuple(map(Ruling.rule, rulings, rules)) for name, rules in different.items()}
        return tabulate_rules([now[id(rules)] for rules in printed])

    def _uncertain(self, block: JudgedBlock, certain: Flags) -> _Open:
        """What was typed but could not be compared; records whatever is not a number at all."""
        none = {
            place: reading
            for place, reading in block.cells.readings.items()
            if reading.kind != "number" and not self._ruling(place).wrong_unit
        }
        verdicts = {place: judge(reading, _NO_KEY) for place, reading in none.items()}
        block.put_unread(verdicts)
        open_to = ~certain & block.cells.are_filled
        open_to[[*verdicts]] = False
        return dict.fromkeys(np.flatnonzero(open_to).tolist())

    def _mistaken(self, block: JudgedBlock, wrong: Places, rules: Rules) -> _Open:
        """Records the wrong answers to which mistakes certainly lead; gives the others, and those
        with other ways to credit.
        """
        open_to = wrong.tolist() if self.alternatives else ()
        found: _Open = {place: None for place in open_to if self._others(block, place)}
        keys, width = block.rows.papers.keys, len(self.asks)
        mistakes = Mistakes.of(wrong, read_mistakes(keys, wrong, width))
        leading = mistakes.leading(block.cells.compared, rules, block.cells.decimals)
        shares = [self.policy.ruling(ask.column).mistakes for ask in self.asks]
        single = np.flatnonzero(leading.single)
        if found:
            single = single[~np.isin(leading.places[single], [*found])]
        names = [find_identifier(name) for name in leading.known]
        alone = np.array([block.find_sentence(Sentence((name,))) for name in names], dtype=np.intp)
        self._put_mistakes(block, leading, single, alone[leading.names[single]])
        named: dict[int, int] = {}
        for place, ways in leading.group_others():
            best = find_best(ways, shares[place % width])
            if best is None:
                found.setdefault(place, {way.name for way in ways})
            elif place not in found:
                together = say_together(best.name, tuple([way.name for way in ways]))
                named[best.number] = block.find_sentence(together)
        others, said = (np.array([*each], dtype=np.intp) for each in (named, named.values()))
        self._put_mistakes(block, leading, others, said)
        return found

    def _put_mistakes(
        self, block: JudgedBlock, leading: Leading, ways: Places, said: Places
    ) -> None:
        """Records the answers to which these ways lead, each with the number of what is said."""
        block.put_mistakes(leading, ways, said)
        shares = [self.policy.ruling(ask.column).mistakes for ask in self.asks]
        if any(shares):
            for place in leading.places[ways].tolist():
                first, *_ = block.find_mistakes(place)
                block.put_share(place, shares[place % len(shares)].get(first, Fraction(0)))

    def _others(self, block: JudgedBlock, place: int) -> Sequence[Alternative]:
        row, number = divmod(place, len(self.asks))
        paper = block.rows.papers[row]
        which = paper.student, paper.source(number), self.asks[number].column
        return self.alternatives.get(which, ())

    def _decided(self, block: JudgedBlock, place: int, names: Collection[str] | None) -> Decision:
        """One answer, decided exactly, with the mistakes of these names, or all, considered."""
        row, number = divmod(place, len(self.asks))
        paper, reading = block.rows.papers[row], block.cells.reading(place)
        terms = self._ruling(place), self._others(block, place), partial(block.cells.reread, place)
        if names is None:  # most are right, and need no mistake worked out
            verdict, share = decide(reading, paper.key(number, ()), *terms)
            if verdict.kind == "right":
                return verdict, share
        return decide(reading, paper.key(number, names), *terms)

    def _led_on(self, block: JudgedBlock, follows: Follows) -> Iterator[tuple[int, range]]:
        """Rows and questions in which a number that is not right comes after another number, and
        something may follow.
        """
        led_on = block.are(*_LED_ON).reshape(-1, len(self.asks))
        questions = [
            each for each in self.papers.questions if follows.possible(self.asks[each[0]].question)
        ]
        counts = [led_on[:, list(question)].sum(axis=1) for question in questions]
        several = np.array(counts).reshape(len(questions), len(led_on)).T > 1
        for row, question in np.argwhere(several).tolist():
            yield row, questions[question]

    def _list_places(self, questions: Sequence[tuple[int, range]]) -> Places:
        """The places of the answers to these questions of rows."""
        width = len(self.asks)
        places = [row * width + number for row, question in questions for number in question]
        return np.array(places, dtype=np.intp)

    def _credit(
        self, block: JudgedBlock, row: int, led_on: Sequence[range], follows: Follows
    ) -> None:
        """Records what follows from own answers of a row, to these questions."""
        first = row * len(self.asks)
        better: dict[int, Decision] = {}
        for question in led_on:
            better |= self._followed(block, row, question, follows)
        shared = self._find_shared(block, row) if better else ()
        for number, decision in better.items():
            if any(number in question for question in shared):
                block.put(first + number, withhold(block.decision(first + number)))
            else:
                block.put(first + number, decision)

    def _find_shared(self, block: JudgedBlock, row: int) -> Sequence[range]:
        """The questions of a row that are answered as is right on another paper."""
        places = slice(row * len(self.asks), (row + 1) * len(self.asks))
        wrong = block.are(*_LED_ON)[places]
        return self.papers.find_shared(block.rows.papers[row], block.cells.values[places], wrong)

    def _followed(
        self, block: JudgedBlock, row: int, question: range, follows: Follows
    ) -> Mapping[int, Decision]:
        """What follow-through improves, by the number of the ask."""
        paper, first = block.rows.papers[row], row * len(self.asks)
        sources = {paper.source(number) for number in question}
        if len(sources) > 1:  # drawn separately: nothing follows for one mechanism from another
            return {}
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
        names = {self.asks[number].ask: number for number in question}
        return {names[ask]: decision for ask, decision in better.items()}
