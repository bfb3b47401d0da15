"""What follows for an ask from a student's answers to earlier ones: the same plan, run on from
there, in doubles.

`follow_through` is called by `kinegrade.exam.follow_through` for the answers of a class; `Follower`
keeps one instance.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import isfinite, pi
from typing import Any

from kinegrade.errors import KinegradeError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Call, Expression
from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.doubles import Doubles, convert_number
from kinegrade.problem.assemble import Assembly, assemble
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader, find_body_names
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.following.followed import follow_values
from kinegrade.students.following.followed_quantities import (
    find_calls,
    find_level,
    find_name,
    find_share,
    make_functions,
    replace_differences,
)
from kinegrade.students.following.followed_terms import Place
from kinegrade.students.following.substituting import OwnValue
from kinegrade.students.mistaken_answers import CloseCentrodes

SAME = 1e-9  # relative: what is closer is not changed, only rounded
# Times the right answer, or below its thousandth part: from there nothing sensible follows
_FARTHEST = 1000


def follow_through(
    template: Template,
    values: Mapping[str, Any],
    earlier: Mapping[str, float],
    later: str,
    plan: Plan | None = None,
) -> float | None:
    """What follows for the ask `later`, in its unit, from a student's answers to other asks (each
    in its unit).

    `values` are the parameters in SI, in any arithmetic. None where `later` does not depend on
    those answers, or nothing follows from them: they are zero, far from any sensible value, or out
    of the plan's reach.
    """
    return Follower(
        template, {name: convert_number(value) for name, value in values.items()}, plan
    ).value(earlier, later)


@dataclass(frozen=True)
class Follower:
    """One instance, to be followed from a student's answers: its parameters in SI as doubles, and a
    plan that may be suitable.
    """

    template: Template
    values: Mapping[str, float]
    suggested: Plan | None = None

    def value(self, earlier: Mapping[str, float], later: str) -> float | None:
        """What follows for `later`, as in `follow_through`; earlier answers are all put in at
        once.
        """
        answers = {
            name: value
            for name, value in earlier.items()
            if self._sensible(name, value) and name != later
        }
        if not answers:
            return None
        found, perturbed = (
            self.result(answers, later),
            self.result(_perturb_values(answers), later),
        )
        right = self.right(later)
        if (
            found is None
            or perturbed is None
            or right is None
            or abs(found) * _FARTHEST <= abs(right)
        ):
            return None
        return found if abs(perturbed - found) > SAME * max(abs(found), abs(right)) else None

    def _sensible(self, name: str, value: float) -> bool:
        """Whether a student's answer may be put in: it is within a factor of a thousand of the
        right one.
        """
        right = self.right(name)
        return (
            right is not None
            and abs(right) > SAME
            and 1 / _FARTHEST <= abs(value / right) <= _FARTHEST
        )

    def result(self, answers: Mapping[str, float], later: str) -> float | None:
        """The answer of `later` with the student's answers put in, None where there is none."""
        motion = self.motion(answers)
        return None if motion is None else self.read(self.template.asks[later], motion)

    def right(self, name: str) -> float | None:
        """The right answer of an ask, in its unit; None where there is none."""
        return (
            None
            if self.right_motion is None
            else self.read(self.template.asks[name], self.right_motion)
        )

    @cached_property
    def right_motion(self) -> Motion | None:
        """The motion as it is, None where there is none."""
        return self.motion({})

    def motion(self, answers: Mapping[str, float]) -> Motion | None:
        """The motion with the student's answers put in; None where it cannot be solved."""
        if not self.template.scheme.drivers:
            return None
        doubles = Doubles()
        with doubles.context():
            try:
                values = [
                    value
                    for name in answers
                    for value in self._student_values(self.template.asks[name], answers[name])
                ]
                return follow_values(self.still.frames, self.plan, values, doubles)
            except (KinegradeError, ArithmeticError):
                return None

    @cached_property
    def assembly(self) -> Assembly:
        """The mechanism of the instance. Raises MechanismError where it does not fit together."""
        return assemble(self.template, self.values, Doubles())

    @cached_property
    def still(self) -> Motion:
        """The relations of the instance in doubles, with no rate known."""
        return Motion(build_frames(self.assembly.mechanism, Doubles()), Plan(()), {}, {}).map(float)

    @cached_property
    def plan(self) -> Plan:
        """The plan that serves: the one suggested, where it does. Raises Singular where there is
        none.
        """
        relations = self.still.frames.relations
        equations = [relation.equations() for relation in relations]
        if self.suggested is not None:
            try:
                sides = [relation.velocity_side() for relation in relations]
                plans.run_steps(self.suggested, equations, sides, Doubles())
            except ArithmeticError:
                pass
            else:
                return self.suggested
        return plans.find_plan(relations, equations, Doubles())

    @cached_property
    def quantities(self) -> Mapping[str, Expression]:
        """What is read for each ask."""
        return {
            name: replace_differences(ask.quantity, self.template.scheme.bodies)
            for name, ask in self.template.asks.items()
        }

    @cached_property
    def names(self) -> Mapping[str, Any]:
        """What the names in a quantity stand for."""
        return {
            **find_body_names(self.assembly.mechanism),
            **self.assembly.values,
            **self.still.points,
        }

    @cached_property
    def factors(self) -> Mapping[str, float]:
        """The units of the asks in SI."""
        return {
            name: float(Doubles().number(ask.unit.factor))
            for name, ask in self.template.asks.items()
        }

    @cached_property
    def fixed(self) -> Mapping[str, Callable[..., Any]]:
        """The functions of a quantity that the student's answers do not change."""
        centrodes = CloseCentrodes(self.template, self.values, self.plan)
        return {**self.assembly.functions, **centrodes.functions(Doubles())}

    def _student_values(self, ask: Ask, number: float) -> Iterator[OwnValue]:
        """A student's answer as it is put into a motion; nothing for what is not read off a single
        moving thing.
        """
        calls = set(find_calls(self.quantities[ask.name]))
        call = calls.pop() if len(calls) == 1 else None
        level = None if call is None else find_level(call)
        if call is not None and level is not None:
            yield OwnValue(
                lambda motion: self.read(ask, motion),
                number,
                level,
                self.place(call),
                find_share(call),
            )

    def place(self, call: Call) -> Place | None:
        """The body and point whose velocity or acceleration a call gives."""
        function = MOTION_FUNCTIONS.get(call.function)  # None for a rotation
        if function is None or function.derivation != "point":
            return None
        point, *bodies = (find_name(argument) for argument in call.arguments)
        body = self.names[bodies[0]] if bodies else None
        return MotionReader(self.still, Doubles()).owner(point, body), point

    def read(self, ask: Ask, motion: Motion) -> float | None:
        """An answer read off a motion, None where the motion does not determine it (yet)."""
        doubles = Doubles()
        functions = {**self.fixed, **make_functions(motion, doubles)}
        try:
            number = evaluate(self.quantities[ask.name], self.names, functions, doubles)
            value = float(
                number * 180 / pi if ask.unit.degrees else number / self.factors[ask.name]
            )
        except (KeyError, KinegradeError, ArithmeticError):
            return None
        return value if isfinite(value) else None


def _perturb_values(answers: Mapping[str, float]) -> dict[str, float]:
    """The answers, each changed a little, and no two of them by the same share."""
    return {
        name: value * (1 + (place + 1) / 97) for place, (name, value) in enumerate(answers.items())
    }
