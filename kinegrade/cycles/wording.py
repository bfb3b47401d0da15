"""What moves in a cycle, in words."""

from __future__ import annotations

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
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


def say_input(path: MotionPath, template: Template, language: Language) -> str:
    """What the curves of a cycle are over, with its unit, in plain text. Raises TypesetError for a
    symbol that is none.
    """
    leading = path.input.leading
    if not path.input.is_angle:
        way = Message("motion.axis-way", point=name_point(leading.list_points()[0]))
        return say_plainly(way, language)
    naming = Naming(template, language)
    moving, base = leading.list_bodies()[:2]
    body = naming.body(moving)
    if base == GROUND:
        return say_plainly(Message("motion.axis-angle", body=body), language)
    relative = Message("motion.axis-relative", body=body, of=naming.body(base))
    return say_plainly(relative, language)
