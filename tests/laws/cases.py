"""Solved mechanisms to hold the laws against: every shipped template at drawn and at arbitrary
values, random ones.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import cache
from random import Random
from typing import Any

from hypothesis import assume
from hypothesis import strategies as st

from kinegrade.errors import MechanismError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.balls import Undecided
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from kinegrade.problem.assembling.parameters import read_parameter
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Parameter, Template
from tests.laws.growing import mechanisms
from tests.laws.position import regularity

FLOATS = Floats()


@dataclass(frozen=True)
class Case:
    """A mechanism solved in an arithmetic; work with its numbers inside `context()`."""

    mechanism: Mechanism
    arithmetic: Any
    motion: Motion

    def context(self) -> AbstractContextManager[Any]:
        return self.arithmetic.context()

    def same(self, first: Any, second: Any) -> bool:
        """Whether two numbers or vectors are equal: exactly, or as enclosures of one number."""
        if isinstance(first, Vector):
            return self.same(first.x, second.x) and self.same(first.y, second.y)
        return bool(self.arithmetic.is_zero(first - second))

    def solved(self, mechanism: Mechanism) -> Motion:
        """The motion of a changed mechanism in the same arithmetic."""
        return solve_motion(mechanism, self.arithmetic)

    def marked(self) -> list[tuple[str, str]]:
        """Every marked point with its body."""
        return [(point, body.name) for body in self.mechanism.bodies for point in body.points]

    def turning(self) -> list[str]:
        """The bodies that have a rotation."""
        return [body.name for body in self.mechanism.bodies if not body.particle]


def changed(part: Any, change: Any) -> Any:
    """A vector, line, circle, joint or driver with `change` made of each number."""
    if isinstance(part, Vector):
        return Vector(change(part.x), change(part.y))
    if is_dataclass(part) and not isinstance(part, type) and not hasattr(part, "level"):
        return replace(
            part,
            **{entry.name: changed(getattr(part, entry.name), change) for entry in fields(part)},
        )
    return part if isinstance(part, (str, bool, tuple)) else change(part)


def with_numbers(mechanism: Mechanism, change: Any) -> Mechanism:
    """The same mechanism in other numbers."""
    return Mechanism(
        {name: changed(point, change) for name, point in mechanism.points.items()},
        mechanism.bodies,
        tuple(changed(joint, change) for joint in mechanism.joints),
        tuple(changed(driver, change) for driver in mechanism.drivers),
    )


@cache
def moving_templates() -> tuple[str, ...]:
    """The names of the shipped templates that have an input; a pose has no motion."""
    return tuple(name for name in find_template_names() if shipped(name).scheme.drivers)


@cache
def shipped(name: str) -> Template:
    """A shipped template, read once."""
    return load_template(name)


@st.composite
def drawn_values(draw: Any, template: Template) -> dict[str, str]:
    """Values from the domains of a template that fulfil its conditions."""
    numbers = Random(draw(st.integers(0, 10**6)))
    values = first_fulfilling(template, lambda parameter: numbers.choice(parameter.choices))
    assume(values)
    return values


@st.composite
def arbitrary_values(draw: Any, template: Template) -> dict[str, str]:
    """Values between the drawable ones, with several decimals, that fulfil the conditions."""
    values = values_between(template, Random(draw(st.integers(0, 10**6))))
    assume(values)
    return values


def values_between(template: Template, numbers: Random) -> dict[str, str]:
    """Values between the drawable ones that fulfil the conditions; {} where few do."""

    def between(parameter: Parameter) -> str:
        sizes = [float(number(text)) for text in parameter.choices]
        return f"{numbers.uniform(min(sizes), max(sizes)):.4f}"

    return first_fulfilling(template, between)


def first_fulfilling(template: Template, choose: Callable[[Parameter], str]) -> dict[str, str]:
    """The first of several choices that fulfils the conditions, {} where none does; where one in
    five does, hypothesis would give up.
    """
    for _ in range(200):
        values = {name: choose(parameter) for name, parameter in template.parameters.items()}
        if fulfils(template, values):
            return values
    return {}


def number(text: str) -> Any:
    """A drawable value in its own unit, as a double."""
    return evaluate(
        read_expression(text), {"pi": 3.141592653589793}, make_elementary_functions(FLOATS), FLOATS
    )


def fulfils(template: Template, values: Mapping[str, str]) -> bool:
    """Whether values fulfil a template's conditions, by doubles and clear of the border."""
    known = {
        name: read_parameter(parameter, read_expression(values[name]), FLOATS)
        for name, parameter in template.parameters.items()
    } | {"pi": FLOATS.turns(1)}
    return all(
        evaluate(condition.left, known, make_elementary_functions(FLOATS), FLOATS) + 1e-9
        < evaluate(condition.right, known, make_elementary_functions(FLOATS), FLOATS)
        for condition in template.scheme.conditions
    )


@st.composite
def template_cases(draw: Any) -> Case:
    """A shipped template at drawn values, solved exactly, or at arbitrary values, solved by
    balls.
    """
    template = shipped(draw(st.sampled_from(moving_templates())))
    values = draw(st.one_of(drawn_values(template), arbitrary_values(template)))
    solution = solve_template(template, values, ())
    return Case(solution.assembly.mechanism, solution.arithmetic, solution.motion)


@st.composite
def grown_cases(draw: Any) -> Case:
    """A random mechanism, solved exactly; those at dead points are left to the law that speaks of
    them.
    """
    mechanism, field = draw(mechanisms()), Field()
    try:
        return Case(mechanism, field, solve_motion(mechanism, field))
    except (MechanismError, Undecided):
        assume(False)
        raise


def cases() -> st.SearchStrategy[Case]:
    """All of them."""
    return st.one_of(template_cases(), grown_cases())


def well_conditioned(mechanism: Mechanism) -> bool:
    """Whether doubles can be expected to hold nine digits of the motion."""
    return regularity(mechanism) > 1e-3
