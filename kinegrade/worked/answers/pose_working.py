"""The working of an answer about a pose: what has been written so far, and the lengths found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.atoms import AXES, Symbol
from kinegrade.worked.formulas.equation import equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import state_quantity
from kinegrade.worked.formulas.symbols import name_component
from kinegrade.worked.positions.algebra import ONE, ZERO, Pair
from kinegrade.worked.positions.constructions import write_length_lines
from kinegrade.worked.positions.instance import METRE, Instance
from kinegrade.worked.vectors.arms import find_stated_length

AXIS_X, AXIS_Y = (ONE, ZERO), (ZERO, ONE)
_AXES: Mapping[Pair, Message] = {
    AXIS_X: Message("solution.x-axis"),
    AXIS_Y: Message("solution.y-axis"),
}


@dataclass(frozen=True)
class Working:
    """The blocks written so far, and the lengths found.

    `symbol` is that of the answer where the answer is itself the quantity worked out, else None.
    """

    instance: Instance
    symbol: Symbol | None
    found: frozenset[Expression] = frozenset()
    blocks: tuple[Block, ...] = ()

    def said(self, sentence: Message) -> Working:
        """The working with one more sentence."""
        return replace(self, blocks=(*self.blocks, self.instance.say(sentence)))

    def shown(self, lines: tuple[Row, ...]) -> Working:
        """The working with some more equations, or none."""
        return replace(self, blocks=(*self.blocks, Display(lines))) if lines else self

    def pair(self, vector: Expression) -> Pair:
        """The coordinates of a vector as formulas."""
        return self.instance.axes.pair(vector) or (ZERO, ZERO)

    def sized(self, *sizes: Expression) -> tuple[tuple[Row, ...], Working]:
        """The equations of lengths that are not known yet."""
        fresh = [size for size in dict.fromkeys(sizes) if size not in self.found]
        lines = tuple(line for size in fresh for line in self._state_length(size))
        return lines, replace(self, found=self.found | set(fresh))

    def _state_length(self, size: Expression) -> tuple[Row, ...]:
        """The equation of a length: by the statement's symbol, else by coordinates."""
        match size:
            case Call(function="distance", arguments=(Name(start), Name(end))):
                stated = find_stated_length(start, end, self.instance.case)
            case Number() | Name() | Operation() | Call():
                stated = None
            case _:
                assert_never(size)
        if stated is None:
            return write_length_lines(size, self.instance)
        left = self.instance.formula(size)
        if left.looks_like(stated):
            return ()
        value = state_quantity(self.instance.quantity(self.instance.value(size), METRE))
        return self.instance.lines(left, (*equate(stated), *value))

    def text(self, symbol: Formula) -> str:
        """A symbol as a part of a sentence."""
        return self.instance.case.text(symbol)

    def phrase(self, vector: Expression, letter: str = "") -> Message:
        """A vector in a sentence, with the letter that denotes it."""
        axis = _AXES.get(self.pair(vector))
        if axis is not None and isinstance(vector, Call) and not vector.function:
            return axis
        if isinstance(vector, Call) and vector.function == "turned":
            written = Message("solution.vector-turned", vector=self.phrase(vector.arguments[0]))
        else:
            written = Message("solution.vector", vector=self.instance.text(vector))
        if not letter:
            return written
        return Message("solution.vector-called", vector=written, letter=letter)

    def lettered(self, letter: str, vector: Expression) -> tuple[Pair, tuple[Row, ...], Working]:
        """The components of a vector under a new letter, and their equations."""
        instance, names, lines = self.instance, list[Expression](), list[Row]()
        for axis, part in zip(AXES, self.pair(vector), strict=True):
            name = instance.free(f"{letter}_{axis}")
            symbol = name_component(letter, axis)
            instance = instance.named(name, symbol, instance.value(part))
            lines += instance.equation(symbol, part)
            names.append(Name(name))
        return (names[0], names[1]), tuple(lines), replace(self, instance=instance)

    def denote(self, name: str, symbol: Symbol, tree: Expression) -> tuple[Name, Working]:
        """A new name for the value of an expression."""
        free = self.instance.free(name)
        instance = self.instance.named(free, symbol, self.instance.value(tree))
        return Name(free), replace(self, instance=instance)
