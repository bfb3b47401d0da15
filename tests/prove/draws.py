"""What a seed draws from the shipped templates."""

from __future__ import annotations

from kinegrade.problem.solution import Solution
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template
from tests.problem.draws import draw_filter, drawn

STRIDE = 37  # so that a few seeds that follow each other fall on templates of all kinds


def seeded_template(seed: int) -> Template:
    """A shipped template: as many seeds that follow each other as there are templates give each of
    them once.
    """
    names = find_template_names()
    return load_template(names[STRIDE * seed % len(names)])


def seeded_solution(seed: int) -> Solution:
    """The solution of an instance of the template of a seed, drawn as for an exam."""
    template = seeded_template(seed)
    return drawn(draw_filter(template, f"prove {seed}"), 1)[0].solution
