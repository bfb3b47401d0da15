"""A search for values that break a template, among those that can be drawn and their neighbours.

Hypothesis looks for an instance that meets the conditions and still cannot be solved, and gives the
simplest it finds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from random import Random

from hypothesis import HealthCheck, find, settings
from hypothesis import strategies as st
from hypothesis.configuration import set_hypothesis_home_dir
from hypothesis.errors import NoSuchExample

from kinegrade.errors import MechanismError, Problem
from kinegrade.files.temporary import temporary_folder
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.neighbours import list_probed


def find_breaking_values(
    template: Template, asks: Sequence[str], examples: int, secret: str
) -> tuple[dict[str, str], Problem] | None:
    """Values at which the asks cannot be worked out, with the reason, drawable ones if there are
    such; None if `examples` tries show none. Another `secret` makes other tries.
    """
    probed = {name: list_probed(template, each) for name, each in template.parameters.items()}
    found = _search(template, asks, probed, examples, secret)
    if found is None:
        return None
    drawable = {name: each.choices for name, each in template.parameters.items()}
    shown = _search(template, asks, drawable, examples, secret) or found
    return shown, _find_reason(template, asks, shown) or ""


def _search(
    template: Template,
    asks: Sequence[str],
    pools: Mapping[str, Sequence[str]],
    examples: int,
    secret: str,
) -> dict[str, str] | None:
    """Values of these at which the asks cannot be worked out, if the tries show any."""
    strategy = st.fixed_dictionaries({name: st.sampled_from(pool) for name, pool in pools.items()})
    quiet = settings(
        max_examples=examples,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    with _keep_notes_elsewhere():
        try:
            return find(
                strategy,
                lambda values: _find_reason(template, asks, values) is not None,
                settings=quiet,
                random=Random(f"{secret} {template.name}"),
            )
        except NoSuchExample:
            return None


@contextmanager
def _keep_notes_elsewhere() -> Iterator[None]:
    """Hypothesis keeps notes in the current folder; an author's folder is not the place for
    them.
    """
    with temporary_folder() as folder:
        set_hypothesis_home_dir(str(folder))
        try:
            yield
        finally:
            set_hypothesis_home_dir(None)


def _find_reason(
    template: Template, asks: Sequence[str], values: Mapping[str, str]
) -> Problem | None:
    """Why an instance that meets the conditions cannot be solved; None when it can, or does not
    meet them.
    """
    try:
        if all(
            condition_holds(template, condition, values) for condition in template.scheme.conditions
        ):
            solve_template(template, values, asks)
    except MechanismError as error:
        return error.faults[0]
    return None
