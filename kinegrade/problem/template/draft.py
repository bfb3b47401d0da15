"""What could be read of a template's file, before it is known whether its parts fit together."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct, field

from kinegrade.expressions.tree import Expression
from kinegrade.mechanics.mechanism import Body
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.template import (
    About,
    Ask,
    Condition,
    NamedMistake,
    Parameter,
    Published,
    Scheme,
    Template,
    TemplateFile,
    Wording,
    Words,
    list_angles,
)
from kinegrade.problem.template.translated import Translated


class Draft(Struct, frozen=True):
    """The parts of a template that could be read, by name or by their position in the file.

    `faulty` are the names whose declaration cannot be read: that is reported once, there, and not
    again wherever the name is used.
    """

    about: About | None
    statement: Translated | None
    texts: Mapping[str, Mapping[int, Wording]]
    parameters: Mapping[str, Parameter]
    lengths: Mapping[str, Expression]
    reasons: Mapping[str, Translated]
    points: Mapping[str, Expression]
    bodies: Mapping[str, Body]
    joints: Mapping[int, JointSentence]
    drivers: Mapping[int, DriverSentence]
    conditions: Mapping[int, Condition]
    asks: Mapping[str, Ask]
    published: Mapping[int, Published]
    figure: FigureHints
    faulty: frozenset[str] = frozenset()
    steps: Mapping[str, Expression] = field(default_factory=dict)
    mistakes: Mapping[str, NamedMistake] = field(default_factory=dict)
    called: Mapping[str, Translated] = field(default_factory=dict)

    @property
    def angles(self) -> frozenset[str]:
        """The names of the parameters that are angles."""
        return list_angles(self.parameters)

    def template(self, name: str, file: TemplateFile) -> Template | None:
        """The template that a draft without faults is; None where it lacks what every one has."""
        if self.about is None or self.statement is None:
            return None
        texts = {text: tuple(wordings.values()) for text, wordings in self.texts.items()}
        return Template(
            name,
            file,
            self.about,
            Words(self.statement, texts, self.reasons, self.called),
            self._scheme(),
            self.asks,
            tuple(self.published.values()),
            self.figure,
        )

    def _scheme(self) -> Scheme:
        return Scheme(
            self.parameters,
            self.lengths,
            self.points,
            tuple(self.bodies.values()),
            tuple(self.joints.values()),
            tuple(self.drivers.values()),
            tuple(self.conditions.values()),
            self.steps,
            tuple(self.mistakes.values()),
        )
