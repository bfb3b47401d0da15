"""Cranks with a statement, and what check finds wrong with what it claims."""

from __future__ import annotations

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.claims import find_false_claims
from tests.problem.turning_crank import CRANK
from tests.said import all_said


def crank(statement: str) -> Template:
    """The crank OA of length r with the point M at 0.5 m, and N in the middle."""
    text = CRANK.replace('en = "{{ r }} ', f"en = '''{statement} ").replace(
        '{{ omega }}", zh = "{{ r }}', "{{ omega }}''', zh = \"{{ r }}", 1
    )
    given = 'half = { unit = "m", draw = ["1/2"], means = { en = "a", zh = "a" } }'
    text = text.replace("[parameters]", f"[parameters]\n{given}").replace('half = "r/2"\n', "")
    text = text.replace("[bodies]", 'N = "midpoint(O, A)"\n[bodies]')
    return read_template("crank", text.replace('"O A M"', '"O A M N"'))


def find(statement: str, **values: str) -> list[str]:
    """What is contradicted at r = 1 and phi = 60, or at other values."""
    template = crank(statement)
    solution = solve_template(template, {"r": "1", **values}, ())
    return all_said(find_false_claims(template, [solution]))
