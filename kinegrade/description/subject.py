"""What is described: an instance in the letters of its statement, with what its statement prints
and its figure marks.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from kinegrade.description.numbers import NumberLengths
from kinegrade.expressions.tree import Expression, find_names
from kinegrade.language import Language
from kinegrade.language.message import Listing, Message, list_all, list_plainly
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.mechanism import Body
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.problem.as_stated import restate
from kinegrade.problem.needs import find_needs
from kinegrade.problem.printed_givens import find_printed_givens
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.sentences import JointSentence
from kinegrade.problem.template.template import Template
from kinegrade.worked.case import Case
from kinegrade.worked.construction_steps import Step
from kinegrade.worked.positions.instance import RADIAN, Instance, make_instance


@dataclass(frozen=True)
class Subject:
    """An instance with the givens that its statement prints, and the marks of its figure.

    `drawn` is the instance as it was dealt; `changes` says whether accelerations are asked.
    """

    drawn: Solution
    instance: Instance
    printed: frozenset[str]
    marks: FigureHints
    changes: bool

    @property
    def case(self) -> Case:
        """The instance in the letters of its statement, in the language of the description."""
        return self.instance.case

    @property
    def template(self) -> Template:
        """The template in the letters of the statement."""
        return self.case.template

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The points that the figure shows, and those from which they are constructed, without
        those that depend on a given which the statement does not print.
        """
        unknown = set(self.template.parameters) - self.printed
        lengths = self.template.scheme.lengths.items()
        unknown |= {name for name, tree in lengths if unknown & set(find_names(tree))}
        told = list[Step]()
        for step in self.instance.steps:
            if unknown & set(find_names(step.tree)):
                unknown.add(step.point)
            else:
                told.append(step)
        return tuple(told)

    @property
    def joints(self) -> tuple[tuple[Joint, JointSentence], ...]:
        """The joints with their sentences."""
        joints = self.case.solution.assembly.mechanism.joints
        return tuple(zip(joints, self.template.scheme.joints, strict=True))

    @cached_property
    def points(self) -> frozenset[str]:
        """The names of these points."""
        return frozenset(step.point for step in self.steps)

    @cached_property
    def named_points(self) -> frozenset[str]:
        """The points of bodies, joints, drivers and frames, which the description names."""
        scheme = self.template.scheme
        names = {point for body in scheme.bodies for point in body.points}
        for joint in scheme.joints:
            shapes = [shape for shape in (joint.circle, joint.on) if shape is not None]
            names |= {joint.point, *(name for shape in shapes for name in find_names(shape))}
        names |= {name for driver in scheme.drivers for name in (driver.point, driver.centre)}
        return frozenset(names | {frame.at for frame in self.marks.frames})

    @cached_property
    def values(self) -> Mapping[str, Any]:
        """The values that expressions name, in doubles: SI, angles in radians."""
        return {name: self._to_double(value) for name, value in self.instance.values.items()}

    def _to_double(self, value: Any) -> Any:
        if isinstance(value, Angle):
            return self.instance.quantity(value, RADIAN).value
        if isinstance(value, Vector):
            return value.map(float)
        return value if isinstance(value, str) else float(value)

    @cached_property
    def doubles(self) -> Mapping[str, Vector]:
        """The places of the points that are described, in doubles, m."""
        return {step.point: self.values[step.point] for step in self.steps}

    @property
    def numbers(self) -> NumberLengths:
        """The numbers of the template that are lengths."""
        return NumberLengths(self.template)

    @cached_property
    def telling(self) -> Instance:
        """The instance in which numbers that are lengths have names."""
        shapes = [shape for _, joint in self.joints for shape in (joint.circle, joint.on)]
        trees = [*(step.tree for step in self.steps), *self.template.scheme.lengths.values()]
        instance = self.instance
        for tree in (*trees, *filter(None, shapes)):
            instance = self.numbers.tell(instance, tree)
        return instance

    def body(self, name: str) -> Message:
        """A body in prose."""
        return self.case.naming.body(name)

    def bodies(self, names: Iterable[str]) -> Listing:
        """Several bodies in prose."""
        return list_all(map(self.body, names))

    def list_points(self, names: Iterable[str]) -> Listing:
        """Several points in prose."""
        return list_plainly(f"${self.instance.letter(name)}$" for name in names)

    def keep_told(self, body: Body) -> tuple[str, ...]:
        """The points of a body that are described."""
        return tuple(point for point in body.points if point in self.points)

    def place(self, point: str, body: str) -> Message:
        """A point of a body in prose; a particle is its point."""
        letter = self.instance.letter(point)
        bodies = self.template.scheme.bodies
        if any(each.particle for each in bodies if each.name == body):
            return Message("description.point-alone", point=letter)
        return Message("description.point-of-body", point=letter, body=self.body(body))

    def text(self, tree: Expression, degrees: bool = False) -> str:
        """An expression in symbols, as a part of a sentence."""
        return self.instance.text(tree, degrees)


def make_subject(solution: Solution, asks: Collection[str], language: Language) -> Subject:
    """The subject of a question that asks for these."""
    template = solution.template
    instance = make_instance(Case(restate(solution), language))
    printed = find_printed_givens(template, asks)
    marks = mark_givens(template, printed, asks)
    return Subject(solution, instance, printed, marks, find_needs(template, asks).changes)
