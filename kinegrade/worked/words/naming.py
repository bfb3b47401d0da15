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
from kinegrade.mechanics.joints import GROUND
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
from kinegrade.worked.words.bodies import is_kind, is_word, name_barely, name_by_number, name_kind

# Named by their end points
_LINKS = frozenset({"crank", "rocker", "rod", "bar", "arm", "strut", "jaw", "coupler"})

# Round bodies by a part of the template's family; wheels in others
_ROUND = {"gear": "gear", "belt": "pulley"}


@dataclass(frozen=True)
class _Label:
    """What tells a body from others: the template's word for it, its letters in LaTeX math, its
    number in prose; "" for what it has not.
    """

    word: str = ""
    letters: str = ""
    number: str = ""


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
        if name == GROUND:
            return Message("solution.ground")
        label = self._find_label(name)
        if label.number:
            return name_by_number(label.word, label.number)
        if not label.word:
            return Message("solution.plain-body", letters=label.letters)
        word = name_kind(label.word)
        if not label.letters:
            return word
        return Message("solution.lettered-body", body=word, letters=label.letters)

    def letters(self, name: str) -> Row:
        """A body in a subscript: its letters, else the word for it."""
        label = self._find_label(name)
        if label.letters:
            return read_symbol(label.letters).row
        if label.number:
            return self._print_text(name_by_number(label.word, label.number))
        return self._print_text(name_barely(label.word))

    def _print_text(self, words: Text) -> Row:
        return (Words(open_catalogue(self.language).write(words)),)

    def _find_label(self, name: str) -> _Label:
        if not is_word(name):
            head, _, letters = name.partition("_")
            if letters and is_word(head):
                return _Label(head, letters)
            if self._is_round(name):
                return self._label_wheel(name)
            return _Label(letters=write_point_symbol(name))
        kind = name.rstrip("0123456789")
        points = self._points(name)
        if kind in _LINKS and len(points) > 1:
            bent = self.template.figure.shapes.get(name) == "bent"
            ends = points if bent else (points[0], points[-1])
            return _Label(kind, "".join(map(write_point_symbol, ends)))
        return _Label(kind, number=name[len(kind) :])

    def _is_round(self, body: str) -> bool:
        """Whether a body has a circle with which it rolls, meshes or touches, or runs with a
        belt.
        """
        return len(body) < 3 and any(
            joint.circle and body in (joint.body, joint.of if joint.carrier else "")
            for joint in self.template.scheme.joints
        )

    def _label_wheel(self, body: str) -> _Label:
        """The wheel, gear or pulley; with its number in the figure, else its letter where there are
        several, or where the letter is a Roman numeral.
        """
        family = self.template.about.family
        kind = next((kind for part, kind in _ROUND.items() if part in family), "wheel")
        if set(body) <= set("IV"):
            return _Label(kind, number=body)
        number = self.template.figure.labels.get(body) or ""
        if number.isdigit():
            return _Label(kind, number=number)
        if sum(self._is_round(other.name) for other in self.template.scheme.bodies) > 1:
            symbol = write_point_symbol(body)
            return _Label(kind, symbol, f"${symbol}$")
        return _Label(kind)

    def _points(self, body: str) -> tuple[str, ...]:
        return next(
            (other.points for other in self.template.scheme.bodies if other.name == body), ()
        )

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
            return bool(body.points) and (kind in _LINKS or not is_kind(kind))
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
