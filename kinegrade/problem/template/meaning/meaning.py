"""What kind of thing an expression gives, and of which dimension, found over its tree without any
values.

A number that only literals make takes any dimension where it is added, compared or asked for, as
the source's values in SI may be written out; as a factor it has none. Angles are pure numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.errors import FieldError, suggest_examples
from kinegrade.expressions.angular import is_angle
from kinegrade.expressions.evaluation import read_whole_power
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation
from kinegrade.language.message import Message, Quoted, list_all
from kinegrade.problem.kinds.dimension import NUMBER, Dimension
from kinegrade.problem.kinds.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Ring,
    Scalar,
    Side,
    Straight,
    Unknown,
    describe_kind,
    unite_dimensions,
)
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, PlainSlot, Signature, Slot
from kinegrade.problem.template.meaning.radians import require_no_radians

_PLAIN: Mapping[PlainSlot, tuple[type[Kind], ...]] = {
    "NUMBER": (Scalar,),
    "PLACE": (Arrow,),
    "VECTOR": (Arrow,),
    "LINE": (Straight,),
    "CIRCLE": (Ring,),
    "LINE|CIRCLE": (Straight, Ring),
    "PLACE|LINE": (Arrow, Straight),
    "SIDE": (Side,),
}
_TOGETHER = Message("template.what-goes-together")


@dataclass(frozen=True)
class Scope:
    """What may be named and called at a place of a template, and what is known of it."""

    names: Mapping[str, Kind]
    functions: Mapping[str, Signature]
    bodies: frozenset[str]
    angles: frozenset[str]

    def kind(self, tree: Expression) -> Kind:
        """The kind of the expression. Raises FieldError where its parts do not go together."""
        match tree:
            case Number():
                return Scalar(None)
            case Name("pi"):
                return Scalar(None)
            case Name(name):
                return self.names.get(name) or Unknown()
            case Operation():
                return self.operation(tree)
            case Call():
                return self.call(tree)
            case _:
                assert_never(tree)

    def operation(self, tree: Operation) -> Kind:
        """A sum, difference, product, quotient or power."""
        left = self.kind(tree.left)
        if tree.sign == "**":
            return _raise_kind(left, read_whole_power(tree.right))
        right = self.kind(tree.right)
        if Unknown() in (left, right):
            return Unknown()
        match tree.sign:
            case "+" | "-":
                self._require_angles(tree)
                return _add_kinds(tree, left, right)
            case "*" | "/":
                return _scale_kind(tree.sign, left, right)
            case _:
                assert_never(tree.sign)

    def _require_angles(self, tree: Operation) -> None:
        """Raises FieldError where a plain number is added to an angle, as 90 in `phi + 90`."""
        for one, other in ((tree.left, tree.right), (tree.right, tree.left)):
            if is_angle(one, self.angles):
                require_no_radians(other)

    def call(self, tree: Call) -> Kind:
        """The value of a function."""
        signature = self.functions.get(tree.function)
        if signature is None:
            if not tree.function:
                raise FieldError(Message("template.a-pair"), Message("template.number-or-angle"))
            raise self._explain_unknown(tree.function)
        if not signature.needed <= len(tree.arguments) <= len(signature.slots):
            count = len(tree.arguments)
            what = Message("template.call-of", call=_write_call(tree), count=count)
            raise FieldError(what, signature.usage(tree.function))
        kinds = [self.kind(argument) for argument in tree.arguments]
        slots = signature.slots[: len(kinds)]
        for number, slot in enumerate(slots):
            if not self.fits(slot, tree.arguments[number], kinds[number]):
                what = Message(
                    "template.argument-is",
                    call=_write_call(tree),
                    number=number + 1,
                    kind=describe_kind(kinds[number]),
                )
                raise FieldError(what, signature.usage(tree.function))
        return signature.result(tree.function, kinds)

    def _explain_unknown(self, function: str) -> FieldError:
        """The error for a function that there is not."""
        examples = {name: each.example for name, each in self.functions.items() if name}
        group = "points" if self.functions.keys() <= CONSTRUCTIONS.keys() else "quantities"
        what = Message("template.unknown-function", name=Quoted(function))
        return FieldError(what, do=suggest_examples(function, examples, group))

    def fits(self, slot: Slot, tree: Expression, kind: Kind) -> bool:
        """Whether an argument fills a slot. Raises FieldError for degrees where radians are
        meant.
        """
        if isinstance(kind, Unknown):
            return True
        match slot:
            case "RATIO":
                return _is_number(kind)
            case "ANGLE":
                require_no_radians(tree)
                return _is_number(kind)
            case "PLACE|ANGLE":
                return isinstance(kind, Arrow) or self.fits("ANGLE", tree, kind)
            case "POINT":
                return isinstance(kind, Arrow) and kind.point != ""
            case "BODY":
                named = isinstance(tree, Name) and tree.name in self.bodies
                return isinstance(kind, BodyKind) or named
            case "PARAMETER":
                return isinstance(tree, Name) and tree.name in self.angles
            case _:
                return isinstance(kind, _PLAIN[slot])


def _is_number(kind: Kind) -> bool:
    """Whether this is a pure number, an angle or a literal."""
    return isinstance(kind, Scalar) and kind.dimension in (None, NUMBER)


def _write_call(tree: Call) -> str:
    """A call for a message."""
    return f"{tree.function}(...)" if tree.function else "(x, y)"


def _raise_kind(base: Kind, exponent: int) -> Kind:
    """A number to a whole power."""
    match base:
        case Unknown():
            return base
        case Scalar(dimension):
            return base if dimension is None else Scalar(dimension ** Fraction(exponent))
        case Arrow() | Straight() | Ring() | BodyKind() | Side():
            what = Message("template.power-of", kind=describe_kind(base))
            raise FieldError(what, Message("template.number-for-power"))
        case _:
            assert_never(base)


def _add_kinds(tree: Operation, left: Kind, right: Kind) -> Kind:
    """The sum or difference of two numbers, or of two vectors; a sign before either is a difference
    from zero.
    """
    signed = tree.sign == "-" and tree.left == Number(0)
    if signed and isinstance(right, Scalar):
        return right
    if signed and isinstance(right, Arrow):
        return Arrow(right.dimension)
    if isinstance(left, Scalar) and isinstance(right, Scalar):
        return Scalar(unite_dimensions(Quoted(tree.sign), left, right))
    if isinstance(left, Arrow) and isinstance(right, Arrow):
        return Arrow(unite_dimensions(Quoted(tree.sign), left, right))
    raise _explain_misfit(tree.sign, left, right)


def _scale_kind(sign: Literal["*", "/"], left: Kind, right: Kind) -> Kind:
    """A product or a quotient; a vector may be multiplied and divided by a number."""
    if not isinstance(left, Scalar | Arrow) or not isinstance(right, Scalar | Arrow):
        raise _explain_misfit(sign, left, right)
    if isinstance(right, Arrow) and (sign == "/" or isinstance(left, Arrow)):
        raise _explain_misfit(sign, left, right)
    first, second = left.dimension, right.dimension
    found = None
    if first is not None or second is not None:
        found = _multiply_dimensions(sign, first or NUMBER, second or NUMBER)
    vectorial = isinstance(left, Arrow) or isinstance(right, Arrow)
    return Arrow(found) if vectorial else Scalar(found)


def _multiply_dimensions(sign: Literal["*", "/"], first: Dimension, second: Dimension) -> Dimension:
    """The dimension of a product or a quotient."""
    match sign:
        case "*":
            return first * second
        case "/":
            return first / second
        case _:
            assert_never(sign)


def _explain_misfit(sign: str, left: Kind, right: Kind) -> FieldError:
    """The error for two things between which a sign makes no sense."""
    kinds = list_all([describe_kind(left), describe_kind(right)])
    return FieldError(Message("template.between", sign=Quoted(sign), kinds=kinds), do=_TOGETHER)
