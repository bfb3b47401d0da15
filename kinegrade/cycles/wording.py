"""What moves in a cycle, in words."""

from __future__ import annotations

import math
from dataclasses import dataclass

from kinegrade.language import Language
from kinegrade.language.decimal_mark import write_decimal_text, write_decimals_of_math
from kinegrade.language.math.units import append_unit
from kinegrade.language.message import Message
from kinegrade.language.prose.plain import write_prose
from kinegrade.language.sentence import write_sentence
from kinegrade.mechanics.geometry import round_short
from kinegrade.mechanics.ground import GROUND
from kinegrade.motion.path import MotionPath
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.words.naming import Naming

_WHERE = Message("typesetting.place-cycle")
_NOTHING = 1e-9


@dataclass(frozen=True)
class Quantities:
    """Writes quantities of a cycle in prose, as formulas; `is_angle` is whether the input turns."""

    language: Language
    is_angle: bool

    def place(self, displacement: float) -> str:
        """A displacement of the input from rad in degrees, or in m."""
        if self.is_angle:
            return self.write(math.degrees(displacement), "deg")
        return self.write(displacement, "m")

    def write(self, value: float, unit: str = "1") -> str:
        """To four significant figures; what rounding leaves of zero is zero."""
        short = round_short(0.0 if abs(value) < _NOTHING else value)
        digits, _, power = str(short).partition("e")
        number = rf"{digits} \cdot 10^{{{int(power)}}}" if power else digits
        return f"${append_unit(write_decimals_of_math(number, self.language), unit)}$"


def say_plainly(message: Message, language: Language) -> str:
    """A message of prose as plain text. Raises TypesetError for a symbol that is none."""
    return write_prose(write_sentence(message, language), _WHERE)


def name_point(name: str) -> str:
    """A point, in prose."""
    return f"${write_point_symbol(name)}$"


def write_signed(number: str, language: Language) -> str:
    """A number with the minus sign, and with the decimal mark of a language."""
    return write_decimal_text(number, language).replace("-", "\u2212")


def say_input(path: MotionPath, template: Template, language: Language) -> str:
    """What the curves of a cycle are over, with its unit, in plain text. Raises TypesetError for a
    symbol that is none.
    """
    return say_plainly(name_input(path, template, language), language)


def name_input(path: MotionPath, template: Template, language: Language) -> Message:
    """The same in prose."""
    leading = path.input.leading
    if not path.input.is_angle:
        return Message("motion.axis-way", point=name_point(leading.list_points()[0]))
    naming = Naming(template, language)
    moving, base = leading.list_bodies()[:2]
    body = naming.body(moving)
    if base == GROUND:
        return Message("motion.axis-angle", body=body)
    return Message("motion.axis-relative", body=body, of=naming.body(base))
