"""A quantity with its unit: a given or an answer, exact or enclosed, and how it prints."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.pi_multiple import multiply_by_pi
from kinegrade.numbers.rounded_text import write_decimal
from kinegrade.numbers.text import LATEX, write_angle, write_exact
from kinegrade.numbers.units import Unit

if TYPE_CHECKING:
    from kinegrade.numbers.symbolic import SympyExpression

CERTIFIED_DIGITS = 40
LONGEST_CLOSED_FORM = (
    60  # characters: longer ones do not fit beside their decimal on a page of the key
)


@dataclass(frozen=True)
class Quantity:
    """`number` counts units of `measure`: a rational, a surd, an Angle, or a ball when no small
    field holds it.

    None stands for a coordinate or distance of a point at infinity. `consequences` gives what known
    mistakes lead to in place of an answer, from its name and value.
    """

    name: str
    number: Any
    measure: Unit
    consequences: Callable[[str, float], Mapping[str, float]] | None = field(
        default=None, compare=False, repr=False
    )

    def __str__(self) -> str:
        short = self.exact is not None and len(self.exact) <= LONGEST_CLOSED_FORM
        return f"{self.name} = {self.exact if short else self.decimal(10)} {self.measure.printed}"

    @property
    def unit(self) -> str:
        """The unit as text, "m/s^2"."""
        return self.measure.text

    @property
    def at_infinity(self) -> bool:
        """Whether this is a coordinate or distance of a point at infinity."""
        return self.number is None

    @property
    def is_exact(self) -> bool:
        """Whether the number is exact, not an enclosure."""
        return not isinstance(self.number, arb)

    @cached_property
    def exact(self) -> str | None:
        """The exact number as text that `expression` reads back, or None for an enclosure."""
        if not self.is_exact:
            return None
        if self.at_infinity:
            return "infinity"
        if isinstance(self.number, Angle):
            return write_angle(self.number, self.measure.degrees)
        return write_exact(self.number)

    @property
    def latex(self) -> str | None:
        """The exact number in LaTeX math, or None for an enclosure."""
        if not self.is_exact:
            return None
        if self.at_infinity:
            return r"\infty"
        if isinstance(self.number, Angle):
            return write_angle(self.number, self.measure.degrees, LATEX)
        return write_exact(self.number, LATEX)

    def _repr_latex_(self) -> str:
        """What a notebook shows: a number that fits a line, with its unit."""
        # Only notebooks show numbers so
        from kinegrade.language.math.latex import MATHJAX, write_latex_math  # noqa: PLC0415

        number = self.closed_form or rf"\approx {self.decimal(10)}"
        unit = "" if self.at_infinity or self.unit == "1" else rf"\,\unit{{{self.unit}}}"
        return f"${write_latex_math(number + unit, self.name, MATHJAX)}$"

    def sympy(self) -> SympyExpression:
        """The number as a sympy expression, in the same unit: exact, or a Float of the digits that
        are certain where it is an enclosure; oo at infinity.
        """
        from kinegrade.numbers.symbolic import convert_to_sympy  # noqa: PLC0415  # takes 0.3 s

        return convert_to_sympy(self.number, degrees=self.measure.degrees)

    @property
    def closed_form(self) -> str | None:
        """The exact number in LaTeX math where it fits a line, else None; a short decimal as it
        is.
        """
        if self.exact is None or len(self.exact) > LONGEST_CLOSED_FORM:
            return None
        return write_decimal(self.plain, 12) if self.is_plain else self.latex

    @property
    def plain(self) -> Any:
        """The number, angles that are a rational part of a turn in degrees where that is the
        unit.
        """
        degrees = self.measure.degrees and isinstance(self.number, Angle) and not self.number.parts
        return self.number.half_turns * 180 if degrees else self.number

    @property
    def is_plain(self) -> bool:
        """Whether the decimal of a few digits says all."""
        return isinstance(self.plain, fmpq) and is_short_decimal(self.plain)

    @property
    def is_zero(self) -> bool:
        """Whether the number is zero; for an enclosure: a ball about zero."""
        if self.at_infinity:
            return False
        if isinstance(self.number, Angle):
            return not self.number.parts and bool(self.number.half_turns == 0)
        return 0 in self.number if isinstance(self.number, arb) else bool(self.number == 0)

    @property
    def is_negative(self) -> bool:
        """Whether the number is below zero."""
        return not self.is_zero and self.value < 0

    @property
    def is_reversed(self) -> bool:
        """Whether its size counts the other way: it is negative, or an angle beyond half a turn."""
        return self.is_negative or self._is_reflex

    @property
    def size(self) -> Quantity:
        """The quantity without its sign; of an angle beyond half a turn what is left of a turn."""
        whole = Angle(fmpq(2)) if self._is_reflex else 0
        return replace(self, number=whole - self.number) if self.is_reversed else self

    @property
    def _is_reflex(self) -> bool:
        return self.measure.degrees and isinstance(self.number, Angle) and self.value > 180

    @cached_property
    def certified(self) -> str:
        """The number to CERTIFIED_DIGITS significant digits, correctly rounded."""
        return self.decimal(CERTIFIED_DIGITS)

    @property
    def value(self) -> float:
        """The nearest double; infinity at infinity."""
        return float(self.certified)  # from 17 digits one in a hundred would be off by one bit

    @property
    def mistakes(self) -> Mapping[str, float]:
        """What known mistakes lead to, in `unit`, by their identifiers; those that change nothing
        are not there.

        Empty for givens and at infinity. `problem.mistake_names` lists the mistakes and their
        sentences.
        """
        if self.consequences is None or self.at_infinity:
            return {}
        return self.consequences(self.name, self.value)

    def decimal(self, digits: int) -> str:
        """The number to `digits` significant digits, correctly rounded."""
        if self.at_infinity:
            return "infinity"
        return write_decimal(self.number, digits, self.measure.degrees)

    @property
    def full_turn(self) -> str:
        """A full turn in the unit of an angle, to 40 digits."""
        return "360" if self.measure.degrees else write_decimal(Angle(fmpq(2)), CERTIFIED_DIGITS)

    @property
    def given_text(self) -> str:
        """The number as a problem states it: a short decimal where it ends, else its LaTeX; degrees
        as degrees.
        """
        return write_decimal(self.plain, 12) if self.is_plain else self.latex or self.decimal(6)

    def record(self) -> dict[str, Any]:
        """exact, value and unit, as the key and `solve --json` write them; no value at infinity."""
        return {
            "exact": self.exact,
            "value": None if self.at_infinity else self.value,
            "unit": self.unit,
            "decimal": self.certified,
        }


def is_short_decimal(number: Any) -> bool:
    """Whether a rational number is a decimal of few digits.

    >>> is_short_decimal(fmpq(1, 8)), is_short_decimal(fmpq(1, 3))
    (True, False)
    """
    return bool((number * 10**6).q == 1)


def express_in_unit(name: str, number: Any, unit: Unit) -> Quantity:
    """The quantity whose value in SI (angles: an Angle or a ball of radians) is `number`."""
    if unit.degrees and isinstance(number, arb):
        return Quantity(name, number * 180 / arb.pi(), unit)
    if isinstance(number, Angle):
        return Quantity(name, number, unit)
    if isinstance(number, int):
        number = fmpq(number)
    return Quantity(name, number / _find_scale(unit, number), unit)


def _find_scale(unit: Unit, number: Any) -> Any:
    """What a unit is in SI, enclosed for an enclosure."""
    scale = unit.scale
    if isinstance(number, arb):
        return arb(scale.rational) * arb.pi() ** scale.power
    return multiply_by_pi(scale.rational, scale.power)
