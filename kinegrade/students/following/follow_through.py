"""What follows for an ask from a student's answers to earlier ones: the same plan, run on from
there, in doubles.

`follow_through` is called by `kinegrade.exam.follow_through` for the answers of a class; `Follower`
keeps one instance.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain, product
from math import isfinite, pi
from typing import Any

from kinegrade.errors import KinegradeError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Call, Expression, walk
from kinegrade.mechanics import plan as plans
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.doubles import Doubles, convert_number
from kinegrade.problem.assembling.assemble import Assembly, assemble
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.quantities.reader import MotionReader, find_body_names
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.following.departures import Equations, state_equations
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
from kinegrade.students.following.own_lengths import OwnLengths
from kinegrade.students.following.own_values import OwnValue
from kinegrade.students.mistaking.mistaken_answers import CloseCentrodes

SAME = 1e-9  # relative: what is closer is not changed, only rounded
_LEAST = 1e-3  # in the unit of an ask: the least amount beside which a difference is seen
_VANISHING = 1e-3  # of the right answer: what is smaller follows from nothing sensible


def follow_through(
    template: Template,
    values: Mapping[str, Any],
    earlier: Mapping[str, float],
    later: str,
    plan: Plan | None = None,
) -> tuple[float, ...]:
    """The values that may follow for the ask `later`, in its unit, from a student's answers to
    other asks (each in its unit); which is open, as students go on in several ways.

    `values` are the parameters in SI, in any arithmetic. Empty where `later` does not depend on
    those answers, or nothing follows from them: they are zero, far from any sensible value, or out
    of the plan's reach.
    """
    return Follower(
        template, {name: convert_number(value) for name, value in values.items()}, plan
    ).consequences(earlier, later)


@dataclass(frozen=True)
class Follower:
    """One instance, to be followed from a student's answers: its parameters in SI as doubles, and a
    plan that may be suitable.
    """

    template: Template
    values: Mapping[str, float]
    suggested: Plan | None = None
    kept: dict[tuple[tuple[str, float], ...], Sequence[Motion]] = field(
        default_factory=dict, repr=False, compare=False
    )

    def consequences(self, earlier: Mapping[str, float], later: str) -> tuple[float, ...]:
        """What follows for `later`, as in `follow_through`; earlier answers are all put in at
        once.
        """
        right = self.right(later)
        answers = {
            name: value
            for name, value in earlier.items()
            if value and name != later and abs(self.right(name) or 0.0) > SAME
        }
        if right is None or not answers:
            return ()
        if all(self._is_right(name, value) for name, value in answers.items()):
            return (right,)
        found: list[float] = []
        for motion in self._keep_motions(tuple(answers.items())):
            value = self.read(self.template.asks[later], motion)
            if value is not None and abs(value) > _VANISHING * abs(right):
                nearest = min(abs(value - other) for other in (right, *found))
                if nearest > SAME * max(abs(value), abs(right), _LEAST):
                    found.append(value)
        return tuple(found)

    def _is_right(self, name: str, value: float) -> bool:
        """Whether a student's answer is exactly the right one."""
        right = self.right(name)
        return right is not None and abs(value - right) <= SAME * abs(right)

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
        return next(iter(self._keep_motions(())), None)

    def _keep_motions(self, answers: tuple[tuple[str, float], ...]) -> Sequence[Motion]:
        """The motions with some answers put in, found once for all asks that are read off them."""
        if answers not in self.kept:
            self.kept[answers] = tuple(self._find_motions(dict(answers)))
        return self.kept[answers]

    def _find_motions(self, answers: Mapping[str, float]) -> Iterator[Motion]:
        """The motions with the student's answers put in; none where it cannot be solved."""
        if not self.template.scheme.drivers:
            return
        with Doubles().context(), suppress(KinegradeError, ArithmeticError):
            ways = [
                self._student_values(self.template.asks[name], number)
                for name, number in answers.items()
            ]
            for values in product(*ways):
                for equations in (self.equations, self.equations.by_detours):
                    yield from follow_values(equations, tuple(chain(*values)))

    @cached_property
    def equations(self) -> Equations:
        """The equations of the mechanism, and the points that students may have velocities of."""
        calls = [call for tree in self.quantities.values() for call in find_calls(tree)]
        asked = [place for call in calls if (place := self.place(call))]
        return state_equations(self.still.frames, self.plan, asked)

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
    def called(self) -> Mapping[str, Collection[str]]:
        """The functions that are called in the quantity of each ask, by name."""
        return {
            name: {part.function for part in walk(tree) if isinstance(part, Call)}
            for name, tree in self.quantities.items()
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
        return {name: Doubles().scale(ask.unit.scale) for name, ask in self.template.asks.items()}

    @cached_property
    def fixed(self) -> Mapping[str, Callable[..., Any]]:
        """The functions of a quantity that the student's answers do not change."""
        centrodes = CloseCentrodes(self.template, self.values, self.plan)
        return {**self.assembly.functions, **centrodes.functions(Doubles())}

    def _student_values(self, ask: Ask, number: float) -> Sequence[Sequence[OwnValue]]:
        """The ways of putting a student's answer into a motion; one that puts in nothing for what
        is not read off a single moving thing.
        """
        tree = self.quantities[ask.name]
        if ask.unit.is_length:
            lengths = OwnLengths(self.equations.right)
            return tuple(lengths.list_ways(tree, number * self.factors[ask.name])) or ((),)
        calls = set(find_calls(tree))
        call = calls.pop() if len(calls) == 1 else None
        level = None if call is None or ask.unit.degrees else find_level(call)
        if call is None or level is None:
            return ((),)
        place, share = self.place(call), find_share(call)
        return ((OwnValue(lambda motion: self.read(ask, motion), number, level, place, share),),)

    def place(self, call: Call) -> Place | None:
        """The body and point whose velocity or acceleration a call gives, absolute or relative."""
        function = MOTION_FUNCTIONS.get(call.function)  # None for a rotation
        if function is None or function.derivation not in ("point", "relative"):
            return None
        point, *bodies = (find_name(argument) for argument in call.arguments)
        body = self.names[bodies[0]] if bodies else None
        return MotionReader(self.still, Doubles()).owner(point, body), point

    def read(self, ask: Ask, motion: Motion) -> float | None:
        """An answer read off a motion, None where the motion does not determine it (yet)."""
        doubles = Doubles()
        called = self.called[ask.name]
        functions = {**self.fixed, **make_functions(motion, doubles, called)}
        try:
            number = evaluate(self.quantities[ask.name], self.names, functions, doubles)
            value = float(
                number * 180 / pi if ask.unit.degrees else number / self.factors[ask.name]
            )
        except (KeyError, KinegradeError, ArithmeticError):
            return None
        return value if isfinite(value) else None
