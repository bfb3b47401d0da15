"""Formulas as they are printed: numbers and vectors, read by recursive descent."""

from __future__ import annotations

import cmath
import math
import operator
import re
from collections.abc import Callable, Mapping

from tests.description.reader.deferred import Deferred, combined, known, position
from tests.description.reader.names import atom_at, is_greek, pair_of_points, plain, point_name

Number = float | complex
Formula = Deferred[Number]

FUNCTIONS: dict[str, Callable[..., float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": lambda angle: 1 / math.tan(angle),
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
    "atan2": lambda pair: math.atan2(pair.real, pair.imag),
}
SPACE = re.compile(r"(?:\\[;:! ]|\\left(?![A-Za-z])|\\right(?![A-Za-z])|\s)+")
COMMAND = re.compile(r"\\([A-Za-z]+|,)")
DECIMAL = re.compile(r"\d+(?:\.\d+)?")
DEGREES = re.compile(r"\^(?:\\circ(?![A-Za-z])|\{\\circ\})")
BRACKETS = {"(": ")", "[": "]", "{": "}"}


class FormulaReader:
    """Reads one formula; the numbers it may name are given."""

    def __init__(self, text: str, numbers: Mapping[str, float]) -> None:
        self.text = text
        self.numbers = numbers
        self.place = 0

    def read(self) -> Formula:
        """The whole formula."""
        value = self.sum()
        if self.rest():
            raise self.fault()
        return value

    def fault(self) -> ValueError:
        """The complaint that names the place."""
        return ValueError(f"formula not understood: {self.text} at {self.text[self.place :]!r}")

    def rest(self) -> str:
        """What is left of the text."""
        found = SPACE.match(self.text, self.place)
        if found:
            self.place = found.end()
        return self.text[self.place :]

    def takes(self, word: str) -> bool:
        """Whether the text goes on with that word, which is then read."""
        rest = self.rest()
        found = rest.startswith(word)
        if found and word[0] == "\\" and word[-1].isalpha():
            found = not rest[len(word) :][:1].isalpha()
        if found:
            self.place += len(word)
        return found

    def expects(self, word: str) -> None:
        """Reads that word."""
        if not self.takes(word):
            raise self.fault()

    def sum(self) -> Formula:
        """Terms with their signs."""
        if self.takes("-"):
            value = combined(operator.neg, self.product())
        else:
            self.takes("+")
            value = self.product()
        while True:
            if self.takes("+"):
                value = combined(operator.add, value, self.product())
            elif self.takes("-"):
                value = combined(operator.sub, value, self.product())
            else:
                return value

    def product(self) -> Formula:
        """Factors side by side, multiplied or divided."""
        value = self.power()
        while True:
            if self.takes("/"):
                value = combined(operator.truediv, value, self.power())
            elif self.takes_times() or self.begins_factor():
                value = combined(operator.mul, value, self.power())
            else:
                return value

    def takes_times(self) -> bool:
        """Whether a sign of multiplication follows, which is then read."""
        return any(self.takes(sign) for sign in (r"\cdot", r"\times", "*", r"\,"))

    def begins_factor(self) -> bool:
        """Whether another factor follows without a sign."""
        rest = self.rest()
        if not rest:
            return False
        if rest[0] == "\\":
            return not rest.startswith((r"\rvert", r"\rVert"))
        return rest[0].isalnum() or rest[0] in "(["

    def power(self) -> Formula:
        """A factor with its exponents, or an angle in degrees."""
        value = self.primary()
        while self.rest().startswith("^"):
            degrees = DEGREES.match(self.text, self.place)
            if degrees:
                self.place = degrees.end()
                value = combined(operator.mul, value, known(math.pi / 180))
            else:
                value = combined(operator.pow, value, self.exponent())
        return value

    def exponent(self) -> Formula:
        """What stands above."""
        self.expects("^")
        return self.group() if self.rest().startswith("{") else self.digit()

    def digit(self) -> Formula:
        """The one digit that is read where no braces stand."""
        found = self.rest()[:1]
        if not found.isdigit():
            raise self.fault()
        self.place += 1
        return known(float(found))

    def group(self, opening: str = "{") -> Formula:
        """A formula between brackets, or the two components of a vector."""
        self.expects(opening)
        value = self.sum()
        if opening == "(" and self.takes(","):
            value = combined(components, value, self.sum())
        self.expects(BRACKETS[opening])
        return value

    def primary(self) -> Formula:
        """A number, a name, a group or a command."""
        rest = self.rest()
        if not rest:
            raise self.fault()
        if rest[0] in BRACKETS:
            return self.group(rest[0])
        number = DECIMAL.match(rest)
        if number:
            self.place += number.end()
            return known(float(number[0]))
        if rest[0] == "|":
            return self.absolute("|", "|")
        command = COMMAND.match(rest)
        if command and not is_greek(command[1]):
            return self.command(command[1])
        return self.name()

    def absolute(self, opening: str, closing: str) -> Formula:
        """The length of a vector, or a number without its sign."""
        self.expects(opening)
        value = self.sum()
        self.expects(closing)
        return combined(abs, value)

    def command(self, word: str) -> Formula:
        """A fraction, a root, a function, a vector."""
        self.expects("\\" + word)
        if word in ("frac", "tfrac", "dfrac"):
            above = self.group()
            return combined(operator.truediv, above, self.group())
        if word == "sqrt":
            return combined(math.sqrt, self.group())
        if word == "overrightarrow":
            first, second = pair_of_points(self.braced())
            return combined(operator.sub, position(second), position(first))
        if word == "overline":
            return self.distance(*pair_of_points(self.braced()))
        if word in ("lvert", "lVert"):
            return self.absolute("", r"\r" + word[1:])
        if word in ("mathrm", "operatorname"):
            return self.function(self.braced())
        return self.function(word)

    def braced(self) -> str:
        """The text between braces."""
        self.expects("{")
        start, depth = self.place, 0
        while self.place < len(self.text):
            depth += {"{": 1, "}": -1}.get(self.text[self.place], 0)
            if depth < 0:
                break
            self.place += 1
        inside = self.text[start : self.place]
        self.expects("}")
        return inside

    def function(self, word: str) -> Formula:
        """A function of an angle or of a ratio."""
        if word not in FUNCTIONS:
            raise ValueError(f"command not understood: {word} in {self.text}")
        exponent = self.exponent() if self.rest().startswith("^") else known(1.0)
        value = combined(FUNCTIONS[word], self.argument())
        return combined(operator.pow, value, exponent)

    def argument(self) -> Formula:
        """What a function is taken of: a group, or factors up to the next space or function."""
        if self.rest().startswith(("(", "[")):
            return self.group(self.rest()[0])
        value = self.power()
        while self.begins_factor() and not self.at_end_of_argument():
            value = combined(operator.mul, value, self.power())
        return value

    def at_end_of_argument(self) -> bool:
        """Whether a space, a group or a function follows."""
        command = COMMAND.match(self.rest())
        return self.rest()[0] in "([" or (command is not None and not is_greek(command[1]))

    def name(self) -> Formula:
        """The longest name that is given, or the distance of two points."""
        self.rest()
        ends: list[int] = []
        while len(ends) < 6 and (atom := atom_at(self.text, ends[-1] if ends else self.place)):
            ends.append(atom.end())
        for end in reversed(ends):
            name = plain(self.text[self.place : end])
            if name in self.numbers:
                self.place = end
                return known(self.numbers[name])
        if self.text.startswith(r"\pi", self.place):
            self.place += 3
            return known(math.pi)
        coordinate = self.coordinate(ends)
        if coordinate:
            return coordinate
        if len(ends) >= 2:
            first, second = pair_of_points(self.text[self.place : ends[1]])
            if first[0].isupper() and second[0].isupper():
                self.place = ends[1]
                return self.distance(first, second)
        raise self.fault()

    def coordinate(self, ends: list[int]) -> Formula | None:
        """A coordinate of a point, `x_{A}`, where it is not a number given."""
        found = re.match(r"(x|y)_\{?([A-Z][^{}]*(?:\{[^{}]*\})?)\}?", self.rest())
        if not ends or found is None:
            return None
        self.place = ends[0]
        axis = found[1]
        point = position(point_name(found[2]))
        return combined(lambda place: place.real if axis == "x" else place.imag, point)

    def distance(self, first: str, second: str) -> Formula:
        """The distance of two points."""
        return combined(lambda a, b: abs(b - a), position(first), position(second))


def formula(text: str, numbers: Mapping[str, float]) -> Formula:
    """The number or vector that the formula stands for."""
    return FormulaReader(text, numbers).read()


def number(text: str, numbers: Mapping[str, float]) -> Deferred[float]:
    """The number that the formula stands for."""
    return combined(real, formula(text, numbers))


def components(x: Number, y: Number) -> complex:
    """The vector with these components."""
    return complex(real(x), real(y))


def real(value: Number) -> float:
    """The value itself, which must not be a vector."""
    if isinstance(value, complex):
        raise TypeError("a vector stands where a number should")
    return float(value)


def rotated(vector: complex, angle: float) -> complex:
    """The vector turned counter-clockwise through an angle."""
    return vector * cmath.rect(1, angle)
