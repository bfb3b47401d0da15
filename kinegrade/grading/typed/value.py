"""Values typed as small formulas: `√3/2`, `2 sqrt(3)/3`, `5π/3`, `2½`, `3/4`. Parsed by a small
grammar, never by `eval`.

    value   = [sign] sum                              the sign is that of the first product
    sum     = product (("+" | "-") product)*          at least one of them with a root or π
    product = power (("*" | "/") power | power)*   without a sign only before a root, π or a bracket
    power   = atom ["^" whole number]         behind "/" an atom holds no power of ten of its own
    atom    = number [½] | "√" (number | bracket) | "sqrt" bracket | "π" | "(" [sign] sum ")"

`scan_value` takes the longest formula off the front of a folded text and leaves the rest, the unit.
A formula that can be understood in two ways is refused, naming both: `1/2√3`, `5-3`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from unicodedata import numeric

from kinegrade.expressions.reading import read_rational
from kinegrade.expressions.tree import (
    PRODUCTS,
    SUMS,
    Call,
    Expression,
    Mark,
    Name,
    Number,
    Operation,
)
from kinegrade.grading.typed import formula_signs as signs
from kinegrade.grading.typed.keyboard import show
from kinegrade.grading.typed.number_text import (
    DecimalStyle,
    Power,
    TypedNumber,
    Unreadable,
    describe_number,
    require_no_uncertainty,
    scan,
)
from kinegrade.grading.typed.powers import raise_to
from kinegrade.grading.typed.raised_dot import require_no_dot_for_times
from kinegrade.language.message import Message, Quoted, Text

_MOST_ROOTS = 8
_MOST_BRACKETS = 8
_MOST_ATOMS = 24
_TEN_BEHIND: Mapping[Mark, Power] = {"*": "any", "/": "letter"}
_ZERO = Number(read_rational("0"))


@dataclass(frozen=True, slots=True)
class Formula:
    """What was typed as a formula: its tree with its sign, where it ends, and remarks on parts of
    it.
    """

    tree: Expression
    end: int
    roots: int
    pi: bool  # whether pi occurs
    remark: Text


def scan_value(
    text: str, place: int, style: DecimalStyle, typed: str, *, minus: bool = False
) -> TypedNumber | Formula | None:
    """The number or formula at `place` of a folded text; None where neither begins there. A `minus`
    before that place is the sign of a formula's first product, not of the whole; that of a number
    is left to the caller.

    Raises Unreadable for what cannot be one value, which quotes the answer as it was `typed`.
    """
    plain = scan(text, place, style)
    if plain is not None and not signs.is_continued(text, plain.end):
        return plain
    if plain is None and not signs.compile_beginnings().value.match(text, place):
        return None
    reader = _Reader(text, place, style, typed)
    tree = reader.sum(0, minus=minus)
    return Formula(tree, reader.place, reader.roots, reader.pi, reader.remark)


class _Reader:
    """Recursive descent over one folded text; `place` is where the next token begins."""

    def __init__(self, text: str, place: int, style: DecimalStyle, typed: str) -> None:
        self.text, self.place, self.style = text, place, style
        self.typed = Quoted(show(typed))
        self.roots, self.surds, self.pi, self.atoms = 0, False, False, 0
        self.remark: Text = ""

    def sum(self, depth: int, *, minus: bool) -> Expression:
        """The sum that begins here, of which a minus before it negates the first product."""
        before, self.surds = self.surds, False
        tree, terms = self.product(depth), 1
        tree = Operation("-", _ZERO, tree) if minus else tree
        while (mark := self._operator(*SUMS)) is not None:
            tree, terms = Operation(mark, tree, self.product(depth)), terms + 1
        if terms > 1 and not self.surds:
            raise Unreadable(Message("typing.range", typed=self.typed))
        self.surds |= before
        return tree

    def product(self, depth: int) -> Expression:
        tree, divided = self.power(depth), False
        while True:
            mark = self._operator(*PRODUCTS)
            if mark is None:
                factor = self.beside(depth)
                if factor is None:
                    return tree
                self._require_plain_order(divided)
                tree = Operation("*", tree, factor)
                continue
            self._require_plain_order(divided and mark == "/")
            if divided and signs.TEN.match(self.text, self.place):
                self.remark = self.remark or Message("typing.quotient-times-power")
            divided = divided or mark == "/"
            tree = Operation(mark, tree, self.power(depth, _TEN_BEHIND[mark]))

    def _require_plain_order(self, doubtful: bool) -> None:
        if doubtful:
            raise Unreadable(Message("typing.two-ways", typed=self.typed))

    def beside(self, depth: int) -> Expression | None:
        """A factor written without a multiplication sign; a bracket that holds a unit is not
        one.
        """
        if not signs.compile_beginnings().factor.match(self.text, self.place):
            return None
        state = self.place, self.roots, self.surds, self.remark
        try:
            return self.power(depth)
        except Unreadable:
            if "(" not in self.text[state[0] : state[0] + 2]:
                raise
            self.place, self.roots, self.surds, self.remark = state
            return None

    def _operator(self, *marks: Mark) -> Mark | None:
        found = signs.OPERATOR.match(self.text, self.place)
        if found is None or not signs.compile_beginnings().value.match(self.text, found.end()):
            return None
        mark = next((mark for mark in marks if mark == found[1]), None)
        self.place = self.place if mark is None else found.end()
        return mark

    def power(self, depth: int, ten: Power = "any") -> Expression:
        """A power, of a number with such a power of ten as is wanted: √3/2·10^3 is a thousand
        times √3/2.
        """
        start = self.place
        base = self.atom(depth, ten)
        if found := signs.HALF.match(self.text, self.place):
            self.place = found.end()
            return self._root_of(base)
        if found := signs.POWER.match(self.text, self.place):
            require_no_dot_for_times(self.text, start, found.end())
            self.place = found.end()
            return raise_to(base, int(found[1] or found[2]))
        return base

    def atom(self, depth: int, ten: Power) -> Expression:
        self.atoms += 1
        if self.atoms > _MOST_ATOMS:
            raise Unreadable(Message("typing.many-parts", most=_MOST_ATOMS))
        self.skip()
        if found := signs.compile_beginnings().root.match(self.text, self.place):
            self.place = found.end()
            return self._radical(depth)
        if found := signs.PI.match(self.text, self.place):
            self.place, self.surds, self.pi = found.end(), True, True
            return Name("pi")
        if self.text.startswith("(", self.place):
            return self._bracket(depth)
        return self.number(ten)

    def _radical(self, depth: int) -> Expression:
        """The root of a bracket or of a single number; whatever follows that number is not part of
        the root.
        """
        bracket = self.text.startswith("(", self.place)
        tree = self._root_of(self._bracket(depth) if bracket else self.number("none"))
        if (
            not bracket
            and (after := signs.compile_beginnings().factor.match(self.text, self.place))
            and after[0].strip() in "(πΠ𝜋"
        ):
            self._require_plain_order(
                bool(re.match(r"\s*(?:[πΠ𝜋]|\(\s*[0-9√])", self.text[self.place :]))
            )
        return tree

    def _root_of(self, tree: Expression) -> Expression:
        self.roots, self.surds = self.roots + 1, True
        if self.roots > _MOST_ROOTS:
            raise Unreadable(Message("typing.many-roots", most=_MOST_ROOTS))
        return Call("sqrt", (tree,))

    def _bracket(self, depth: int) -> Expression:
        if depth >= _MOST_BRACKETS:
            raise Unreadable(Message("typing.deep-brackets", most=_MOST_BRACKETS))
        self.place += 1
        self.skip()
        sign = self.text[self.place : self.place + 1]
        self.place += sign in ("+", "-")
        tree = self.sum(depth + 1, minus=sign == "-")
        self.skip()
        if not self.text.startswith(")", self.place):
            raise Unreadable(Message("typing.open-bracket", typed=self.typed))
        self.place += 1
        return tree

    def number(self, power: Power) -> Expression:
        """A decimal number, a fraction such as ½, or a whole number with a fraction; √3×10^-2 is a
        hundredth of √3.
        """
        found = scan(self.text, self.place, self.style, power=power)
        if found is not None:
            require_no_uncertainty(self.text, found, self.typed)
            self.remark = self.remark or describe_number(self.text, self.place, found)
            self.place = found.end
        vulgar = self._vulgar() if found is None or found.digits.isdigit() else None
        if found is None and vulgar is None:
            rest = Quoted(show(self.text[self.place :]))
            raise Unreadable(Message("typing.no-number", typed=self.typed, rest=rest))
        if found is None or vulgar is None:
            return vulgar or _make_literal(found.value if found else Fraction(0))
        return Operation("+", _make_literal(found.value), vulgar)

    def _vulgar(self) -> Expression | None:
        found = signs.MIXED.match(self.text, self.place)
        if found is None:
            return None
        self.place = found.end()
        return _make_literal(Fraction(numeric(found[0][-1])).limit_denominator(10))

    def skip(self) -> None:
        while self.text[self.place : self.place + 1].isspace():
            self.place += 1


def _make_literal(value: Fraction) -> Expression:
    whole = Number(read_rational("1") * value.numerator)
    return whole if value.denominator == 1 else Number(whole.value / value.denominator)
