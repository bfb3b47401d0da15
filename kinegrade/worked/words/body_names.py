"""The names of bodies in sentences: by the paper's letters, or by the word for them."""

from __future__ import annotations

from msgspec import Struct

from kinegrade.language.catalogue import FORM_SEPARATOR
from kinegrade.language.message import ByLanguage, Message, Noun, Part
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.words.bodies import is_word, name_by_number, name_kind

#: Named by their end points
LINKS = frozenset({"crank", "rocker", "rod", "bar", "arm", "strut", "jaw", "coupler"})

# Round bodies by a part of the template's family; wheels in others
_ROUND = {"gear": "gear", "belt": "pulley"}


class Label(Struct, frozen=True):
    """What tells a body from others: the template's word for it, its letters in LaTeX math, its
    number in prose; "" for what it has not.
    """

    word: str = ""
    letters: str = ""
    number: str = ""


def _name_as_called(text: str) -> Part:
    """A body by a noun in all its forms, or by one that has a single form."""
    forms = tuple(each.strip() for each in text.split(FORM_SEPARATOR))
    return Noun(forms) if len(forms) > 1 else Message("solution.other-body", name=text)


class BodyNames(Struct, frozen=True):
    """What a template's bodies are called."""

    template: Template

    def body(self, name: str) -> Message:
        """A body in prose: as the author calls it in a language, else by the paper's letters, or
        the word for it.
        """
        if name == GROUND:
            return Message("solution.ground")
        called = self.template.words.called.get(name)
        if called is None:
            return self._by_word(name)
        if called.plain is not None:
            return Message("solution.other-body", name=called.plain)
        words = ((language, _name_as_called(text)) for language, text in called.by_language)
        called_otherwise = self._by_word(name)
        return Message("solution.named-body", body=ByLanguage(tuple(words), called_otherwise))

    def _by_word(self, name: str) -> Message:
        """A body by the paper's letters, or the word for it."""
        label = self.label(name)
        if label.number:
            return name_by_number(label.word, label.number)
        if not label.word:
            return Message("solution.plain-body", letters=label.letters)
        word = name_kind(label.word)
        if not label.letters:
            return word
        return Message("solution.lettered-body", body=word, letters=label.letters)

    def label(self, name: str) -> Label:
        """What a body is called by."""
        if not is_word(name):
            head, _, letters = name.partition("_")
            if letters and is_word(head):
                return Label(head, letters)
            if self._is_round(name):
                return self._label_wheel(name)
            return Label(letters=write_point_symbol(name))
        kind = name.rstrip("0123456789")
        points = self._points(name)
        if kind in LINKS and len(points) > 1:
            bent = self.template.figure.shapes.get(name) == "bent"
            ends = points if bent else (points[0], points[-1])
            return Label(kind, "".join(map(write_point_symbol, ends)))
        return Label(kind, number=name[len(kind) :])

    def _is_round(self, body: str) -> bool:
        """Whether a body has a circle with which it rolls, meshes or touches, or runs with a
        belt.
        """
        return len(body) < 3 and any(
            joint.circle and body in (joint.body, joint.of if joint.carrier else "")
            for joint in self.template.scheme.joints
        )

    def _label_wheel(self, body: str) -> Label:
        """The wheel, gear or pulley; with its number in the figure, else its letter where there are
        several, or where the letter is a Roman numeral.
        """
        family = self.template.about.family
        kind = next((kind for part, kind in _ROUND.items() if part in family), "wheel")
        if set(body) <= set("IV"):
            return Label(kind, number=body)
        number = self.template.figure.labels.get(body) or ""
        if number.isdigit():
            return Label(kind, number=number)
        if sum(self._is_round(other.name) for other in self.template.scheme.bodies) > 1:
            symbol = write_point_symbol(body)
            return Label(kind, symbol, f"${symbol}$")
        return Label(kind)

    def _points(self, body: str) -> tuple[str, ...]:
        return next(
            (other.points for other in self.template.scheme.bodies if other.name == body), ()
        )
