"""The names of bodies, points and rates in a worked solution: the paper's symbols where it has
them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import assert_never

from kinegrade.expressions.tree import Call, Name
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.tree import Lettering, Row
from kinegrade.language.math.tree import Text as Words
from kinegrade.language.message import Message, Text
from kinegrade.mechanics.mechanism import Body
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.rotational_speeds import is_rotational_speed
from kinegrade.worked.formulas.symbols import (
    begins_with_letter,
    index_letter,
    join_letters,
    name_point,
    read_symbol,
    replace_letter,
)
from kinegrade.worked.words.bodies import is_kind, is_word, name_barely, name_by_number
from kinegrade.worked.words.body_names import LINKS, BodyNames


@dataclass(frozen=True)
class Naming:
    """What a template's bodies and rates are called in one language."""

    template: Template
    language: Language

    def point(self, name: str) -> str:
        """A point in LaTeX math, for sentences."""
        return write_point_symbol(name)

    def letter(self, name: str) -> Symbol:
        """A point in formulas."""
        return name_point(name)

    def body(self, name: str) -> Message:
        """A body in prose: by the paper's letters, or the word for it."""
        return self._bodies.body(name)

    def letters(self, name: str) -> Row:
        """A body in a subscript: its letters, else the word for it."""
        label = self._bodies.label(name)
        if label.letters:
            return read_symbol(label.letters).row
        if label.number:
            return self._print_text(name_by_number(label.word, label.number))
        return self._print_text(name_barely(label.word))

    @cached_property
    def _bodies(self) -> BodyNames:
        return BodyNames(self.template)

    def _print_text(self, words: Text) -> Row:
        return (Words(open_catalogue(self.language).write(words)),)

    def omega(self, body: str) -> Symbol:
        """The symbol of a body's angular velocity."""
        return self._turning[body][0]

    def alpha(self, body: str) -> Symbol:
        """The symbol of a body's angular acceleration."""
        return self._turning[body][1]

    def turning(self, body: str, level: Level) -> Symbol:
        """The symbol of a body's angular velocity or acceleration."""
        match level:
            case "velocity":
                return self.omega(body)
            case "acceleration":
                return self.alpha(body)
            case _:
                assert_never(level)

    @cached_property
    def _turning(self) -> dict[str, tuple[Symbol, Symbol]]:
        """For each body the symbols that the asks give to its rotation, else those of its
        points.
        """
        asked = {(call, body): symbol for call, body, symbol in self._list_asked_rotations()}
        taken = set(asked.values())
        found: dict[str, tuple[Symbol, Symbol]] = {}
        for body in self.template.scheme.bodies:
            omega, alpha = asked.get(("omega", body.name)), asked.get(("alpha", body.name))
            if omega is None:
                omega = replace_letter(alpha, "omega") if alpha else self._name_own(body, taken)
            found[body.name] = (omega, alpha or replace_letter(omega, "alpha"))
            taken.add(omega)
        return found

    def _name_own(self, body: Body, taken: set[Symbol]) -> Symbol:
        """The angular velocity with the letters of a link or of a named body, else with the word
        for the body, as of a wheel; so too where another has these letters.
        """
        if not is_word(body.name):
            letters = self._name_letter(body.name)
        elif self._has_letters(body):
            letters = join_letters(map(name_point, body.points[:2]))
        else:
            return index_letter("omega", self.letters(body.name))
        symbol = index_letter("omega", letters.row)
        if symbol not in taken and "_" not in body.name:
            return symbol
        return index_letter("omega", self._print_text(name_barely(body.name)))

    def _has_letters(self, body: Body) -> bool:
        """Whether the points of a body name it: those of a link, or of what the catalogues have no
        word for, and a single one that no other body has.
        """
        kind = body.name.rstrip("0123456789")
        if len(body.points) != 1:
            return bool(body.points) and (kind in LINKS or not is_kind(kind))
        others = (one for one in self.template.scheme.bodies if one.name != body.name)
        return not any(body.points[0] in other.points for other in others)

    def _name_letter(self, name: str) -> Symbol:
        """The letters of a body; Roman numerals upright."""
        letters = name_point(name)
        return Symbol((Lettering("mathrm", letters.row),)) if set(name) <= set("IV") else letters

    def _list_asked_rotations(self) -> Iterator[tuple[str, str, Symbol]]:
        """What asks call the rotations of bodies: omega or alpha, the body, the symbol; of a
        rotational speed n_P the angular velocity omega_P.
        """
        for ask in self.template.asks.values():
            symbol, tree = read_symbol(ask.symbol), ask.quantity
            if is_rotational_speed(symbol, ask.unit) and symbol != read_symbol("n"):
                symbol = replace_letter(symbol, "omega")
            if not isinstance(tree, Call) or len(tree.arguments) != 1:
                continue
            (body,) = tree.arguments
            if not isinstance(body, Name) or tree.function not in ("omega", "alpha"):
                continue
            if begins_with_letter(symbol, tree.function):
                yield tree.function, body.name, symbol
