"""The solved instance whose solution is written, with its language and method."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, assert_never

from kinegrade.expressions.expression import Call, Name
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rates
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.solving import Solution
from kinegrade.problem.template.sentences import JointSentence
from kinegrade.problem.template.template import Method, Template
from kinegrade.worked.document import Prose, say
from kinegrade.worked.words.naming import Naming

LETTERS: Mapping[Level, str] = {"velocity": "v", "acceleration": "a"}


@dataclass(frozen=True)
class Case:
    """A solved instance with the words for its solution."""

    solution: Solution
    language: Language
    method: Method | None = None

    @property
    def template(self) -> Template:
        """The template of the instance."""
        return self.solution.template

    @property
    def motion(self) -> Motion:
        """The motion of the instance."""
        return self.solution.motion

    @property
    def arithmetic(self) -> Any:
        """The arithmetic in which the instance is solved."""
        return self.solution.arithmetic

    def rates(self, level: Level) -> Rates:
        """The rates of the motion, or their changes."""
        match level:
            case "velocity":
                return self.motion.rates
            case "acceleration":
                return self.motion.changes
            case _:
                assert_never(level)

    @cached_property
    def naming(self) -> Naming:
        """The names of bodies, points and rates."""
        return Naming(self.template, self.language)

    def write(self, message: Message) -> str:
        """What a message says in the language of the solution."""
        return open_catalogue(self.language).write(message)

    def say(self, message: Message) -> Prose:
        """A paragraph that says a message."""
        return say(message, self.language)

    def joint(self, term: Term) -> JointSentence | None:
        """The sentence of the joint that guides a sliding or circling point, None for a free
        point.
        """
        rate = term.rate
        if not rate.is_guided:
            return None
        for sentence in self.template.scheme.joints:
            same = sentence.body == rate.body and sentence.of == rate.of
            if same and (
                sentence.point == rate.point
                or _find_centre(sentence) == rate.point
                or sentence.kind == "sleeve"
            ):
                return sentence
        return None


def _find_centre(sentence: JointSentence) -> str:
    """The point about which a touching or rolling circle lies, "" where the joint has none."""
    return _find_first_name(sentence.circle) if sentence.circle else ""


def _find_first_name(call: Call) -> str:
    """The name that stands first in the brackets of a line or a circle, "" where none does."""
    return call.arguments[0].name if call.arguments and isinstance(call.arguments[0], Name) else ""
