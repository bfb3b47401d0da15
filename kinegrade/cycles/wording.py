"""What moves in a cycle, in words."""

from __future__ import annotations

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimal_text
from kinegrade.language.message import Message
from kinegrade.language.prose.plain import write_prose
from kinegrade.mechanics.ground import GROUND
from kinegrade.motion.path import MotionPath
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.words.naming import Naming

_WHERE = Message("typesetting.place-cycle")


def say_plainly(message: Message, language: Language) -> str:
    """A message of prose as plain text. Raises TypesetError for a symbol that is none."""
    return write_prose(open_catalogue(language).write(message), _WHERE)


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
