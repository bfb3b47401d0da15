"""Small mechanisms stated in a test, and the chapters of their solutions as a reader sees them."""

from __future__ import annotations

from textwrap import dedent

from kinegrade.language import Language
from kinegrade.problem.solving import Solution, solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Method
from kinegrade.worked.document import Block
from kinegrade.worked.solution import write_worked_solution
from tests.worked.telling import lines

FRAME = """
family = "slider-crank"
source = "by hand"
title = { en = "Small", zh = "小" }
statement = { en = "Given.", zh = "已知。" }
"""
PARAMETERS = """
[parameters]
l = { unit = "m", draw = [1], means = { en = "length", zh = "长" } }
omega = { unit = "rad/s", draw = [2], means = { en = "rate", zh = "角速度" } }
"""


def solve_small(mechanism: str, **asks: str) -> Solution:
    """A mechanism in the words of templates, solved for quantities given as "quantity in unit"."""
    asked = "\n".join(_write_ask(name, *text.rsplit(" in ", 1)) for name, text in asks.items())
    text = f"{FRAME}{dedent(mechanism)}\n{PARAMETERS}\n[asks]\n{asked}\n"
    return solve_template(read_template("small", text, kept=True), {})


def _write_ask(name: str, quantity: str, unit: str) -> str:
    means = '{ en = "asked", zh = "所求" }'
    return f'{name} = {{ quantity = "{quantity}", unit = "{unit}", means = {means} }}'


def write_blocks(
    solution: Solution, method: Method | None = None, language: Language = "en"
) -> tuple[Block, ...]:
    """The solution of all that is asked."""
    return write_worked_solution(solution, solution.template.asks, language, method).blocks


def read_chapter(
    title: str, solution: Solution, method: Method | None = None, language: Language = "en"
) -> str:
    """The text below a heading, up to the next heading of its level or a higher one; without
    pictures, boxes and checks.
    """
    text = _read_lines(solution, method, language)
    start = text.index(title)
    level = len(title.split(maxsplit=1)[0])
    ends = (
        place
        for place in range(start + 1, len(text))
        if text[place].startswith("#") and len(text[place].split(maxsplit=1)[0]) <= level
    )
    return _tidy(text[start + 1 : next(ends, len(text))])


def find_untold(expected: str, solution: Solution, method: Method | None = None) -> list[str]:
    """The lines expected, as `as_read` reads them, that no line of the solution begins with."""
    told = _tidy(_read_lines(solution, method, "en")).splitlines()
    return [
        line
        for line in as_read(expected).splitlines()
        if not any(one.startswith(line) for one in told)
    ]


def _read_lines(solution: Solution, method: Method | None, language: Language) -> list[str]:
    return list(lines(write_blocks(solution, method, language), boxes=False))


def _tidy(told: list[str]) -> str:
    left_out = ("    [picture", "Check by ")
    return "\n".join(" ".join(line.split()) for line in told if not line.startswith(left_out))


def as_read(text: str) -> str:
    """A text stated in a test: an indented line goes on the line before it, without a blank where
    that ends with a backslash.
    """
    return dedent(text).strip().replace("\\\n    ", "").replace("\n    ", " ")
