"""Worked solutions of shipped templates at the published and at drawn values, each written once."""

from __future__ import annotations

from functools import lru_cache

from kinegrade.language import Language
from kinegrade.problem.solving import Solution, solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Method
from kinegrade.worked.document import Block
from kinegrade.worked.solution import write_worked_solution
from tests.problem.draws import draw_filter
from tests.problem.draws import drawn as draws_of

DRAWS = 1


@lru_cache(maxsize=2)  # a template after another: see conftest.py
def drawn(name: str) -> tuple[Solution, ...]:
    """The published instance and a drawn one, solved for all asks that an exam may put."""
    template = load_template(name)
    values = [one.values for one in draws_of(draw_filter(template), DRAWS)]
    return tuple(solve_template(template, given) for given in ({}, *values))


def told(
    solution: Solution, method: Method | None = None, language: Language = "en"
) -> tuple[Block, ...]:
    return write_worked_solution(solution, solution.template.asks, language, method).blocks


@lru_cache(maxsize=16)
def kept(
    name: str, place: int = 0, method: Method | None = None, language: Language = "en"
) -> tuple[Block, ...]:
    """The solution of one drawn instance, worked out once for all tests."""
    return told(drawn(name)[place], method, language)


def stated(name: str, language: Language = "en", **values: str) -> tuple[Block, ...]:
    """The solution at values that are stated, the others as published: it stays when draws change."""
    return told(solve_template(load_template(name), values), language=language)
