"""A search for values that break a template: anywhere between the smallest and the largest drawable ones, nice or not.

Hypothesis looks for an instance that meets the conditions and still cannot be solved, and gives the simplest it finds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from tempfile import TemporaryDirectory
from typing import Any

from hypothesis import HealthCheck, find, settings
from hypothesis import strategies as st
from hypothesis.configuration import set_hypothesis_home_dir
from hypothesis.errors import NoSuchExample

from kinegrade.errors import MechanismError
from kinegrade.exact.text import decimal_text
from kinegrade.problem.drawing import holds
from kinegrade.problem.solving import certified, parameter_values, read_values, solve_template
from kinegrade.problem.template import Parameter, Template

DECIMALS = 2


def breaking_values(template: Template, examples: int) -> tuple[dict[str, str], str] | None:
    """Values at which the asked quantities cannot be found, with the reason; None if `examples` tries show none."""
    strategy = st.fixed_dictionaries(
        {name: between(template, parameter) for name, parameter in template.parameters.items()}
    )
    quiet = settings(
        max_examples=examples,
        derandomize=True,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    with nothing_left_behind():
        try:
            found = find(
                strategy, lambda values: reason(template, values) is not None, settings=quiet
            )
        except NoSuchExample:
            return None
    return found, reason(template, found) or ""


@contextmanager
def nothing_left_behind() -> Iterator[None]:
    """Hypothesis keeps notes in the current folder; an author's folder is not the place for them."""
    with TemporaryDirectory() as folder:
        set_hypothesis_home_dir(folder)
        try:
            yield
        finally:
            set_hypothesis_home_dir(None)


def reason(template: Template, values: Mapping[str, str]) -> str | None:
    """Why an instance that meets the conditions cannot be solved; None when it can, or does not meet them."""
    try:
        if all(holds(template, condition, values) for condition in template.conditions):
            solve_template(template, values, template.asked())
    except MechanismError as error:
        return error.problems[0]
    return None


def between(template: Template, parameter: Parameter) -> Any:
    """Texts of decimals between the smallest and the largest drawable value of a parameter."""
    sizes = [float(size(template, parameter.name, text)) for text in parameter.choices]
    low, high = (round(bound * 10**DECIMALS) for bound in (min(sizes), max(sizes)))
    return st.integers(low, high).map(lambda count: f"{count / 10**DECIMALS:.{DECIMALS}f}")


def size(template: Template, name: str, text: str) -> str:
    """A drawable value in its unit, as a decimal."""
    parameter = template.parameters[name]
    trees = read_values(template, {name: text})

    def decimal(arithmetic: Any) -> str:
        value = parameter_values(template, trees, arithmetic)[name]
        number = value if parameter.unit.degrees else value / parameter.unit.factor
        if parameter.unit.degrees and not arithmetic.exact:
            number = number * 180 / arithmetic.turns(1)
        return decimal_text(number, 15, parameter.unit.degrees)

    return certified(decimal)
