"""A problem for Python users: load it by name, solve it at any values."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.problem.solving import Solution, solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class Problem:
    """A template with its solver."""

    template: Template

    @classmethod
    def load(cls, name: str) -> Problem:
        """The problem of that name or path. Raises TemplateError."""
        return cls(load_template(name))

    def solve(self, **values: str | int | float) -> Solution:
        """The solution at the given values, each a number or an exact text in the parameter's unit.

        What is not given takes its published value, or the first drawable one. A float counts as
        the decimal that it prints as. Answers have `.value`, `.exact`, `.unit` and
        `.decimal(digits)`. Raises TemplateError for unknown names and unreadable values,
        MechanismError with the reason in mechanics.

        >>> Problem.load("slider-crank").solve(phi=90, k="sqrt(3)")["omega_AB"].value
        0.0
        """
        return solve_template(self.template, {name: str(value) for name, value in values.items()})
