"""The vectors that an answer refers to, each found before it is used: of points, relative,
Coriolis, about a base point.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import dataclass
from typing import Any, assert_never

from kinegrade.errors import ExpressionError
from kinegrade.expression import Call, Expression, Name, Number, Operation, parts
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.relations import Term, total
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, term_parts
from kinegrade.problem.quantities import Quantities
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.numbers import absolute_value, bracketed, double, length, short, stated
from kinegrade.worked.phrases import phrase
from kinegrade.worked.points import (
    Fact,
    Findings,
    Piece,
    find_point,
    key_of,
    part_symbol,
    point_symbol,
    way,
)
from kinegrade.worked.scalars import turning, turning_value
from kinegrade.worked.solution_case import LETTERS, Case
from kinegrade.worked.summands import sum_line

Found = Generator[Block, None, Fact]
LEVELS: dict[str, Level] = {
    "velocity": "velocity",
    "acceleration": "acceleration",
    "relative_velocity": "velocity",
    "relative_acceleration": "acceleration",
    "coriolis": "acceleration",
    "normal_acceleration": "acceleration",
    "tangential_acceleration": "acceleration",
}


def is_vector_call(tree: Expression) -> bool:
    """Whether an expression is a vector of the motion: a velocity or an acceleration, or a sum of
    such.
    """
    if isinstance(tree, Operation) and tree.sign in "+-":
        return is_vector_call(tree.right)
    return isinstance(tree, Call) and tree.function in LEVELS


@dataclass(frozen=True)
class Facts:
    """Finds the vectors of a solution's answers."""

    case: Case
    findings: Findings
    quantities: Quantities

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
        function = tree.function
        if function in ("velocity", "acceleration"):
            return (yield from self.of_point(names, LEVELS[function]))
        if function in ("relative_velocity", "relative_acceleration"):
            return (yield from self.relative(names[0], names[1], names[2], LEVELS[function]))
        if function == "coriolis":
            return (yield from self.coriolis(names[0], names[1], names[2]))
        return (yield from self.about_base(function, names[0], names[1], names[2]))

    def of_point(self, names: list[str], level: Level) -> Found:
        """The velocity or acceleration of a point of a body."""
        point, body = (
            names[0],
            names[1] if len(names) > 1 else self.quantities.owner(names[0], None),
        )
        chain = self.case.motion.frames.chain(body, point)
        yield from find_point(
            chain, self.symbol(point, body, level), self.case, level, self.findings
        )
        nothing = Fact(point_symbol(point, level, self.case), Vector(0, 0), False)
        return self.findings.facts.get(key_of(chain, level), nothing)

    def symbol(self, point: str, body: str, level: Level) -> str:
        """The symbol of a point's vector; with the body where the point belongs to several that
        move apart.
        """
        try:
            usual = self.quantities.owner(point, None)
        except ExpressionError:
            usual = ""
        plain = point_symbol(point, level, self.case)
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
            return (yield from self.left_over(point, body, frame, name, level))
        if level == "velocity" or term.kind == "sliding":
            value = term.coefficient() * self.case.rates(level)[term.rate]
            return Fact(name, value, False, (Piece(name, term.coefficient(), value),))
        parts = [
            (part_symbol(part, "a", number), part.value)
            for part in term_parts(term, self.case.motion, tuple(self.case.motion.rates), level)
            if part.role != "coriolis"
        ]
        yield Display(tuple(sum_line(axis, name, parts, level) for axis in "xy"))
        return Fact(name, total(value for _, value in parts), True)

    def track(self, point: str, body: str, frame: str) -> Term | None:
        """The term of a point that is guided in the frame, None where no joint guides it."""
        frames = self.case.motion.frames
        for chain in [
            side for relation in frames.relations for side in (relation.left, relation.right)
        ]:
            for term in chain:
                if term.frame == frame and term.rate.startswith(
                    (f"slide {point} {body}/", f"circle {point} {body}/")
                ):
                    return term
        return None

    def left_over(self, point: str, body: str, frame: str, name: str, level: Level) -> Found:
        """v_r = v_a - v_e, a_r = a_a - a_e - a_C, by components."""
        absolute = yield from self.of_point([point, body], level)
        transport = yield from self.of_point([point, frame], level)
        parts = [(absolute.symbol, absolute.value), (transport.symbol, transport.value)]
        if level == "acceleration":
            coriolis = yield from self.find(
                Call("coriolis", (Name(point), Name(body), Name(frame)))
            )
            parts.append((coriolis.symbol, coriolis.value))
        yield Prose(
            phrase(
                f"relative_left_{level}",
                self.case.language,
                point=self.case.naming.point(point),
                frame=self.body(frame),
            )
        )
        yield Display(tuple(sum_line(axis, name, parts, level, "-") for axis in "xy"))
        return Fact(name, absolute.value - total(value for _, value in parts[1:]), True)

    def coriolis(self, point: str, body: str, frame: str) -> Found:
        """The Coriolis acceleration, twice the frame's angular velocity times the relative
        speed.
        """
        relative = yield from self.find(
            Call("relative_velocity", (Name(point), Name(body), Name(frame)))
        )
        value = self.case.motion.coriolis(point, body, frame)
        omega = turning(frame, self.case, "velocity")
        term = self.track(point, body, frame)
        name = rf"a_{{\mathrm{{C}}{self.findings.numbers.get(term.rate, '') if term else ''}}}"
        numbers = (
            rf"2\cdot {absolute_number(turning_value(frame, self.case, 'velocity'))}\cdot "
            rf"{short(length(relative.value, self.case.arithmetic))}"
        )
        size = stated(length(value, self.case.arithmetic), "m/s^2")
        shown = f" = {numbers}" if any(map(double, value)) else ""
        yield Display(
            (
                rf"{name} &= 2{absolute_value(omega)}{absolute_value(relative.symbol)}{shown} = "
                f"{size}{way(value, self.case)}",
            )
        )
        return Fact(name, value, False)

    def about_base(self, function: str, point: str, base: str, body: str) -> Found:
        """The normal or tangential acceleration of a point about a base point of its body."""
        naming, motion = self.case.naming, self.case.motion
        arm = motion.points[point] - motion.points[base]
        letters = naming.point(base) + naming.point(point)
        normal = function.startswith("normal")
        part = "n" if normal else "t"
        name = rf"a_{{{naming.point(point)}{naming.point(base)}}}^{{\mathrm{{{part}}}}}"
        value = (
            arm * -(motion.omega(body) * motion.omega(body))
            if normal
            else arm.turned() * motion.alpha(body)
        )
        size = short(length(arm, self.case.arithmetic))
        if normal:
            formula = rf"{letters}\cdot {naming.omega(body)}^{{2}}"
            numbers = rf"{size}\cdot {bracketed(short(motion.omega(body)))}^{{2}}"
        else:
            formula = rf"{letters}\cdot {absolute_value(naming.alpha(body))}"
            numbers = rf"{size}\cdot {absolute_number(motion.alpha(body))}"
        result = stated(length(value, self.case.arithmetic), "m/s^2")
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
        level = level_of(tree.right)
        name = pair_symbol(left.symbol, right.symbol)
        parts = [(left.symbol, left.value), (right.symbol, right.value)]
        yield Display(tuple(sum_line(axis, name, parts, level, sign) for axis in "xy"))
        return Fact(name, value, True)

    def body(self, name: str) -> str:
        """A body in prose."""
        return (
            phrase("ground", self.case.language) if name == GROUND else self.case.naming.body(name)
        )


def level_of(tree: Expression) -> Level:
    """Whether a vector of the motion is a velocity or an acceleration; a sum is what its last
    summand is.
    """
    match tree:
        case Call(function=function):
            return LEVELS[function]
        case Operation(right=right):
            return level_of(right)
        case Number() | Name():
            raise TypeError("a number or a name is not a vector of the motion")
        case _:
            assert_never(tree)


def pair_symbol(left: str, right: str) -> str:
    """v_C and v_B give v_{CB}."""
    head, _, first = left.partition("_{")
    return f"{head}_{{{first.removesuffix('}')}{right.partition('_{')[2].removesuffix('}')}}}"


def absolute_number(value: Any) -> str:
    """The absolute value of a number."""
    return short(value).removeprefix("-")


def prerequisites(tree: Expression, facts: Facts) -> Iterator[Block]:
    """How every vector in an expression is found."""
    if is_vector_call(tree):
        yield from facts.find(tree)
        return
    for part in parts(tree):
        yield from prerequisites(part, facts)
