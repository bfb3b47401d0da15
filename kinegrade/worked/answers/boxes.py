"""The boxes around the answers of a solution, each where its value is first given."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.language.math.tree import Accent, Mark, Row, Sign, Space
from kinegrade.problem.template.template import Ask
from kinegrade.worked.answers.answer_senses import state_answer_sense
from kinegrade.worked.answers.answers import state_value
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, TermTable
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.formulas.symbols import INFINITY, read_symbol

_RELATIONS = (Sign("="), Sign(r"\approx"))


@dataclass(frozen=True)
class _Sought:
    """An answer as a line may state it: by its symbol or its size, and its value, with the box
    that takes the place of the value; after metres stand centimetres where these are asked for.
    `sense` says in words where the answer points, if no step has done so.
    """

    letters: frozenset[Row]
    boxes: Mapping[Row, Row]
    sense: Row = ()


@dataclass
class AnswerBoxes:
    """Puts a box around each answer that the blocks give; `missing` are those not given yet."""

    case: Case
    missing: dict[str, _Sought]

    @staticmethod
    def around(asked: Iterable[Ask], case: Case) -> AnswerBoxes:
        """The boxes around what is asked."""
        return AnswerBoxes(case, {ask.name: _make_sought(ask, case) for ask in asked})

    def frame(self, blocks: Iterable[Block]) -> Iterator[Block]:
        """The blocks with the answers in boxes."""
        for block in blocks:
            match block:
                case Display():
                    yield self._frame_lines(block)
                case Heading() | Prose() | TermTable() | Pictures():
                    yield block
                case _:
                    assert_never(block)

    def state_missing(self, asked: Iterable[Ask]) -> Iterator[Block]:
        """Those of the answers that no line has given in the letters of the question."""
        for ask in asked:
            if ask.name in self.missing:
                value = state_quantity(self.case.solution.answers[ask.name])
                sense = state_answer_sense(ask, self.case)
                yield self.case.show(Equation(read_symbol(ask.symbol), value, sense))

    def _frame_lines(self, display: Display) -> Display:
        left: Row = ()
        lines = []
        for line in display.lines:
            stated = _find_left(line)
            left = stated or left
            lines.append(self._frame_value(left, line))
        return replace(display, lines=tuple(lines))

    def _frame_value(self, left: Row, line: Row) -> Row:
        """The line with its value in a box, where it gives an answer for the first time."""
        start, end = find_value(line)
        for name, sought in self.missing.items():
            if left in sought.letters and line[start:end] in sought.boxes:
                del self.missing[name]
                sense = () if Space("quad") in line[end:] else sought.sense
                return (*line[:start], *sought.boxes[line[start:end]], *line[end:], *sense)
        return line


def _make_sought(ask: Ask, case: Case) -> _Sought:
    symbol, answer = read_symbol(ask.symbol), case.solution.answers[ask.name]
    written = (symbol, -symbol, abs(symbol))
    letters = frozenset(one.print(case.notation) for one in written)
    if answer.at_infinity:
        return _Sought(letters, {INFINITY.print(): (Accent("boxed", INFINITY.print()),)})
    value, in_metres = state_quantity(answer), state_value(ask, case)
    row = value[-1].right.print(case.notation)
    boxes: dict[Row, Row] = {row: (Accent("boxed", row),)}
    if in_metres != value:
        plain = in_metres[-2].right.print(case.notation)
        boxes.setdefault(plain, (*plain, Sign(value[-1].relation), *boxes[row]))
    return _Sought(letters, boxes, state_answer_sense(ask, case))


def _find_left(line: Row) -> Row:
    """What stands to the left of the alignment mark; nothing where a line goes on."""
    return line[: line.index(Mark())] if Mark() in line else ()


def find_value(line: Row) -> tuple[int, int]:
    """Where the last right side of a line begins and ends, its sense in words left out."""
    relations = [place for place, node in enumerate(line) if node in _RELATIONS]
    start = relations[-1] + 1 if relations else len(line)
    quads = [place for place in range(start, len(line)) if line[place] == Space("quad")]
    end = quads[0] if quads else len(line)
    return start, end - 1 if line[end - 1] == Sign(",") else end
