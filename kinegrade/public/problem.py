"""`kinegrade.template`: a problem, solved at any values."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike, fspath

from kinegrade.problem.solving import Solution, solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class Problem:
    """A template with its solver."""

    template: Template

    def solve(self, **values: str | int | float) -> Solution:
        """The solution at the given values, each a number or an exact text in the parameter's unit.

        What is not given takes its published value, or the first drawable one. A float counts as
        the decimal that it prints as. Answers have `.value`, `.exact`, `.unit` and
        `.decimal(digits)`. Raises TemplateError for unknown names and unreadable values,
        MechanismError with the reason in mechanics.

        >>> template("slider-crank").solve(phi=90, k="sqrt(3)")["omega_AB"].value
        0.0
        >>> template("slider-crank").solve(psi=90)
        Traceback (most recent call last):
        kinegrade.errors.TemplateError: slider-crank: no parameter "psi": did you mean "phi"? ...
        """
        return solve_template(self.template, {name: str(value) for name, value in values.items()})


def template(name: str | PathLike[str]) -> Problem:
    """The problem of that name (see `kinegrade list`), or of a template file, whose path ends in
    .toml. Raises TemplateError.

    >>> list(template("slider-crank").solve())[:2]
    ['v_B', 'omega_AB']
    >>> template("slider-krank")
    Traceback (most recent call last):
    kinegrade.errors.TemplateError: no template "slider-krank": did you mean "slider-crank"?
    """
    return Problem(load_template(fspath(name)))
