"""What kind of thing an expression gives, and of which dimension, found over its tree without any
values.

A number that only literals make takes any dimension where it is added, compared or asked for, as
the source's values in SI may be written out; as a factor it has none. Angles are pure numbers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.angular import is_angle
from kinegrade.errors import FieldError, did_you_mean
from kinegrade.expression import Call, Expression, Name, Number, Operation, whole_power
from kinegrade.problem.dimension import NUMBER, Dimension
from kinegrade.problem.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Ring,
    Scalar,
    Side,
    Straight,
    Unknown,
    in_words,
    united,
)
from kinegrade.problem.radians import radians_slip
from kinegrade.problem.signatures import PlainSlot, Signature, Slot

PLAIN: Mapping[PlainSlot, tuple[type[Kind], ...]] = {
    "NUMBER": (Scalar,),
    "PLACE": (Arrow,),
    "VECTOR": (Arrow,),
    "LINE": (Straight,),
    "CIRCLE": (Ring,),
    "LINE or CIRCLE": (Straight, Ring),
    "PLACE or LINE": (Arrow, Straight),
    "SIDE": (Side,),
}
TOGETHER = "angles go with angles, points with points, numbers with numbers"


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
            return power(left, whole_power(tree.right))
        right = self.kind(tree.right)
        if Unknown() in (left, right):
            return Unknown()
        match tree.sign:
            case "+" | "-":
                self.require_angles(tree)
                return added(tree, left, right)
            case "*" | "/":
                return scaled(tree.sign, left, right)
            case _:
                assert_never(tree.sign)

    def require_angles(self, tree: Operation) -> None:
        """Raises FieldError where a plain number is added to an angle, as 90 in `phi + 90`."""
        for one, other in ((tree.left, tree.right), (tree.right, tree.left)):
            if is_angle(one, self.angles):
                radians_slip(other)

    def call(self, tree: Call) -> Kind:
        """The value of a function."""
        signature = self.functions.get(tree.function)
        if signature is None:
            if not tree.function:
                raise FieldError("a pair (x, y)", "a number or an angle here")
            known = [name for name in self.functions if name]
            near = did_you_mean(tree.function, known)
            raise FieldError(f'unknown function "{tree.function}"', do=near)
        if not signature.needed <= len(tree.arguments) <= len(signature.slots):
            what = f"{called(tree)} of {counted(len(tree.arguments))}"
            raise FieldError(what, signature.usage(tree.function))
        kinds = [self.kind(argument) for argument in tree.arguments]
        slots = signature.slots[: len(kinds)]
        for number, slot in enumerate(slots):
            if not self.fits(slot, tree.arguments[number], kinds[number]):
                what = f"{called(tree)}: argument {number + 1} is {in_words(kinds[number])}"
                raise FieldError(what, signature.usage(tree.function))
        return signature.result(tree.function, kinds)

    def fits(self, slot: Slot, tree: Expression, kind: Kind) -> bool:
        """Whether an argument fills a slot. Raises FieldError for degrees where radians are
        meant.
        """
        if isinstance(kind, Unknown):
            return True
        match slot:
            case "RATIO":
                return is_number(kind)
            case "ANGLE":
                radians_slip(tree)
                return is_number(kind)
            case "PLACE or ANGLE":
                return isinstance(kind, Arrow) or self.fits("ANGLE", tree, kind)
            case "POINT":
                return isinstance(kind, Arrow) and kind.point != ""
            case "BODY":
                named = isinstance(tree, Name) and tree.name in self.bodies
                return isinstance(kind, BodyKind) or named
            case "PARAMETER":
                return isinstance(tree, Name) and tree.name in self.angles
            case _:
                return isinstance(kind, PLAIN[slot])


def is_number(kind: Kind) -> bool:
    """Whether this is a pure number, an angle or a literal."""
    return isinstance(kind, Scalar) and kind.dimension in (None, NUMBER)


def called(tree: Call) -> str:
    """A call for a message."""
    return f"{tree.function}(...)" if tree.function else "(x, y)"


def counted(count: int) -> str:
    """How many arguments."""
    return f"{count} argument{'' if count == 1 else 's'}"


def power(base: Kind, exponent: int) -> Kind:
    """A number to a whole power."""
    match base:
        case Unknown():
            return base
        case Scalar(dimension):
            return base if dimension is None else Scalar(dimension ** Fraction(exponent))
        case Arrow() | Straight() | Ring() | BodyKind() | Side():
            raise FieldError(f"a power of {in_words(base)}", "a number to be raised to a power")
        case _:
            assert_never(base)


def added(tree: Operation, left: Kind, right: Kind) -> Kind:
    """The sum or difference of two numbers, or of two vectors; a sign before either is a difference
    from zero.
    """
    signed = tree.sign == "-" and tree.left == Number(0)
    if signed and isinstance(right, Scalar):
        return right
    if signed and isinstance(right, Arrow):
        return Arrow(right.dimension)
    if isinstance(left, Scalar) and isinstance(right, Scalar):
        return Scalar(united(f'"{tree.sign}"', left, right))
    if isinstance(left, Arrow) and isinstance(right, Arrow):
        return Arrow(united(f'"{tree.sign}"', left, right))
    raise misfit(tree.sign, left, right)


def scaled(sign: Literal["*", "/"], left: Kind, right: Kind) -> Kind:
    """A product or a quotient; a vector may be multiplied and divided by a number."""
    if not isinstance(left, Scalar | Arrow) or not isinstance(right, Scalar | Arrow):
        raise misfit(sign, left, right)
    if isinstance(right, Arrow) and (sign == "/" or isinstance(left, Arrow)):
        raise misfit(sign, left, right)
    first, second = left.dimension, right.dimension
    found = None
    if first is not None or second is not None:
        found = multiplied(sign, first or NUMBER, second or NUMBER)
    vectorial = isinstance(left, Arrow) or isinstance(right, Arrow)
    return Arrow(found) if vectorial else Scalar(found)


def multiplied(sign: Literal["*", "/"], first: Dimension, second: Dimension) -> Dimension:
    """The dimension of a product or a quotient."""
    match sign:
        case "*":
            return first * second
        case "/":
            return first / second
        case _:
            assert_never(sign)


def misfit(sign: str, left: Kind, right: Kind) -> FieldError:
    """The error for two things between which a sign makes no sense."""
    kinds: Sequence[Kind] = (left, right)
    words = " and ".join(in_words(kind) for kind in kinds)
    return FieldError(f'"{sign}" between {words}', do=TOGETHER)
