"""The vectors that an answer refers to, each found before it is used: of points, relative,
Coriolis, about a base point.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import dataclass
from typing import Any, assert_never

from kinegrade.errors import ExpressionError
from kinegrade.expressions.expression import Call, Expression, Name, Number, Operation, list_parts
from kinegrade.language.message import Message
from kinegrade.mechanics.relations import Term, add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, list_term_parts
from kinegrade.problem.kinds.kinds import Arrow
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.numbers import (
    double,
    length,
    write_absolute_value,
    write_bracketed,
    write_number,
    write_short,
)
from kinegrade.worked.steps.findings import Fact, Findings, Piece, make_key, write_point_symbol
from kinegrade.worked.steps.points import find_point, write_part_symbol, write_way
from kinegrade.worked.steps.scalars import find_rotation_value, write_rotation
from kinegrade.worked.steps.summands import write_sum_line
from kinegrade.worked.words.solution_case import LETTERS, Case

Found = Generator[Block, None, Fact]


def is_vector_call(tree: Expression) -> bool:
    """Whether an expression is a vector of the motion: a velocity or an acceleration, or a sum of
    such.
    """
    if isinstance(tree, Operation) and tree.sign in "+-":
        return is_vector_call(tree.right)
    if not isinstance(tree, Call) or tree.function not in MOTION_FUNCTIONS:
        return False
    function = MOTION_FUNCTIONS[tree.function]
    return function.level is not None and isinstance(function.gives, Arrow)


def is_rotation_call(tree: Call) -> bool:
    """Whether a call gives an angular velocity or acceleration."""
    function = tree.function
    return function in MOTION_FUNCTIONS and MOTION_FUNCTIONS[function].derivation == "rotation"


@dataclass(frozen=True)
class Facts:
    """Finds the vectors of a solution's answers."""

    case: Case
    findings: Findings
    reader: MotionReader

    def find(self, tree: Expression) -> Found:
        """The vector of an expression, with the blocks that show how it is found unless they have
        been written before.
        """
        if tree not in self.findings.answered:
            self.findings.answered[tree] = yield from self.found(tree)
        return self.findings.answered[tree]

    def found(self, tree: Expression) -> Found:
        """The vector of an expression, with the blocks that show how it is found."""
        match tree:
            case Operation():
                return (yield from self.difference(tree))
            case Call():
                return (yield from self.called(tree))
            case Number() | Name():
                raise TypeError("a number or a name is not a vector of the motion")
            case _:
                assert_never(tree)

    def called(self, tree: Call) -> Found:
        """The vector that a function of the motion gives."""
        names = [argument.name for argument in tree.arguments if isinstance(argument, Name)]
        derivation, level = MOTION_FUNCTIONS[tree.function].derivation, find_level(tree)
        match derivation:
            case "point":
                return (yield from self._of_point(names, level))
            case "relative":
                return (yield from self.relative(names[0], names[1], names[2], level))
            case "coriolis":
                return (yield from self.coriolis(names[0], names[1], names[2]))
            case "normal":
                return (yield from self._normal(names[0], names[1], names[2]))
            case "tangential":
                return (yield from self._tangential(names[0], names[1], names[2]))
            case "rotation" | "pole" | "centrode" | "value":
                raise TypeError(f"{tree.function} is not derived as a vector of the motion")
            case _:
                assert_never(derivation)

    def _of_point(self, names: list[str], level: Level) -> Found:
        """The velocity or acceleration of a point of a body."""
        point, body = (
            names[0],
            names[1] if len(names) > 1 else self.reader.owner(names[0], None),
        )
        chain = self.case.motion.frames.chain(body, point)
        yield from find_point(
            chain, self.symbol(point, body, level), self.case, level, self.findings
        )
        nothing = Fact(write_point_symbol(point, level, self.case), Vector(0, 0), False)
        return self.findings.facts.get(make_key(chain, level), nothing)

    def symbol(self, point: str, body: str, level: Level) -> str:
        """The symbol of a point's vector; with the body where the point belongs to several that
        move apart.
        """
        try:
            usual = self.reader.owner(point, None)
        except ExpressionError:
            usual = ""
        plain = write_point_symbol(point, level, self.case)
        same = usual and self.case.motion.frames.chain(
            usual, point
        ) == self.case.motion.frames.chain(body, point)
        if usual == body or same:
            return plain
        return f"{plain[:-1]}({self.case.naming.letters(body)})}}"

    def relative(self, point: str, body: str, frame: str, level: Level) -> Found:
        """The relative velocity or acceleration: along its track, or else what remains of the
        absolute vector without the transport one.
        """
        term = self.track(point, body, frame)
        number = self.findings.numbers.get(term.rate, "") if term else ""
        name = rf"{LETTERS[level]}_{{\mathrm{{r}}{number}}}"
        if term is None:
            return (yield from self._left_over(point, body, frame, name, level))
        if level == "velocity" or term.kind == "sliding":
            value = term.coefficient() * self.case.rates(level)[term.rate]
            return Fact(name, value, False, (Piece(name, term.coefficient(), value),))
        parts = [
            (write_part_symbol(part, "a", number), part.value)
            for part in list_term_parts(
                term, self.case.motion, tuple(self.case.motion.rates), level
            )
            if part.role != "coriolis"
        ]
        yield Display(tuple(write_sum_line(axis, name, parts, level) for axis in "xy"))
        return Fact(name, add_vectors(value for _, value in parts), True)

    def track(self, point: str, body: str, frame: str) -> Term | None:
        """The term of a point that is guided in the frame, None where no joint guides it."""
        frames = self.case.motion.frames
        for chain in [
            side for relation in frames.relations for side in (relation.left, relation.right)
        ]:
            for term in chain:
                moving = (term.rate.point, term.rate.body, term.frame)
                if term.rate.is_guided and moving == (point, body, frame):
                    return term
        return None

    def _left_over(self, point: str, body: str, frame: str, name: str, level: Level) -> Found:
        """v_r = v_a - v_e, a_r = a_a - a_e - a_C, by components."""
        absolute = yield from self._of_point([point, body], level)
        transport = yield from self._of_point([point, frame], level)
        parts = [(absolute.symbol, absolute.value), (transport.symbol, transport.value)]
        if level == "acceleration":
            coriolis = yield from self.find(
                Call("coriolis", (Name(point), Name(body), Name(frame)))
            )
            parts.append((coriolis.symbol, coriolis.value))
        yield self.case.say(
            Message(
                f"solution.relative-left-{level}",
                point=self.case.naming.point(point),
                frame=self.case.naming.body(frame),
            )
        )
        yield Display(tuple(write_sum_line(axis, name, parts, level, "-") for axis in "xy"))
        return Fact(name, absolute.value - add_vectors(value for _, value in parts[1:]), True)

    def coriolis(self, point: str, body: str, frame: str) -> Found:
        """The Coriolis acceleration, twice the frame's angular velocity times the relative
        speed.
        """
        relative = yield from self.find(
            Call("relative_velocity", (Name(point), Name(body), Name(frame)))
        )
        value = self.case.motion.coriolis(point, body, frame)
        omega = write_rotation(frame, self.case, "velocity")
        term = self.track(point, body, frame)
        name = rf"a_{{\mathrm{{C}}{self.findings.numbers.get(term.rate, '') if term else ''}}}"
        numbers = (
            rf"2\cdot {_write_size(find_rotation_value(frame, self.case, 'velocity'))}\cdot "
            rf"{write_short(length(relative.value, self.case.arithmetic))}"
        )
        size = write_number(length(value, self.case.arithmetic), "m/s^2")
        shown = f" = {numbers}" if any(map(double, value)) else ""
        yield Display(
            (
                rf"{name} &= 2{write_absolute_value(omega)}"
                rf"{write_absolute_value(relative.symbol)}{shown} = "
                f"{size}{write_way(value, self.case)}",
            )
        )
        return Fact(name, value, False)

    def _normal(self, point: str, base: str, body: str) -> Found:
        """The normal acceleration of a point about a base point of its body."""
        omega = self.case.motion.omega(body)
        value = self._find_arm(point, base) * -(omega * omega)
        factors = (
            f"{self.case.naming.omega(body)}^{{2}}",
            f"{write_bracketed(write_short(omega))}^{{2}}",
        )
        return (yield from self._about_base("n", point, base, value, factors))

    def _tangential(self, point: str, base: str, body: str) -> Found:
        """The tangential acceleration of a point about a base point of its body."""
        alpha = self.case.motion.alpha(body)
        value = self._find_arm(point, base).turned() * alpha
        factors = write_absolute_value(self.case.naming.alpha(body)), _write_size(alpha)
        return (yield from self._about_base("t", point, base, value, factors))

    def _find_arm(self, point: str, base: str) -> Vector:
        points = self.case.motion.points
        return points[point] - points[base]

    def _about_base(
        self, part: str, point: str, base: str, value: Vector, factors: tuple[str, str]
    ) -> Found:
        """A part of an acceleration: the arm times a factor, in symbols and in numbers."""
        naming, arithmetic = self.case.naming, self.case.arithmetic
        name = rf"a_{{{naming.point(point)}{naming.point(base)}}}^{{\mathrm{{{part}}}}}"
        letters = naming.point(base) + naming.point(point)
        size = write_short(length(self._find_arm(point, base), arithmetic))
        result = write_number(length(value, arithmetic), "m/s^2")
        formula, numbers = rf"{letters}\cdot {factors[0]}", rf"{size}\cdot {factors[1]}"
        yield Display((f"{name} &= {formula} = {numbers} = {result}",))
        return Fact(name, value, False)

    def difference(self, tree: Operation) -> Found:
        """The sum or difference of two vectors, by components."""
        left = yield from self.find(tree.left)
        right = yield from self.find(tree.right)
        match tree.sign:
            case "+" | "-" as sign:
                value = {"+": left.value + right.value, "-": left.value - right.value}[sign]
            case "*" | "/" | "**":
                raise TypeError(
                    "only sums and differences of vectors of the motion are vectors of the motion"
                )
            case _:
                assert_never(tree.sign)
        level = find_level(tree.right)
        name = _write_pair_symbol(left.symbol, right.symbol)
        parts = [(left.symbol, left.value), (right.symbol, right.value)]
        yield Display(tuple(write_sum_line(axis, name, parts, level, sign) for axis in "xy"))
        return Fact(name, value, True)


def find_level(tree: Expression) -> Level:
    """Whether a vector of the motion is a velocity or an acceleration; a sum is what its last
    summand is.
    """
    match tree:
        case Call(function=function):
            level = MOTION_FUNCTIONS[function].level
            if level is None:
                raise TypeError(f"{function} is neither a velocity nor an acceleration")
            return level
        case Operation(right=right):
            return find_level(right)
        case Number() | Name():
            raise TypeError("a number or a name is not a vector of the motion")
        case _:
            assert_never(tree)


def _write_pair_symbol(left: str, right: str) -> str:
    """v_C and v_B give v_{CB}."""
    head, _, first = left.partition("_{")
    return f"{head}_{{{first.removesuffix('}')}{right.partition('_{')[2].removesuffix('}')}}}"


def _write_size(value: Any) -> str:
    """The absolute value of a number."""
    return write_short(value).removeprefix("-")


def explain_prerequisites(tree: Expression, facts: Facts) -> Iterator[Block]:
    """How every vector in an expression is found."""
    if is_vector_call(tree):
        yield from facts.find(tree)
        return
    for part in list_parts(tree):
        yield from explain_prerequisites(part, facts)
