"""What a problem's solution is to a Python user: a mapping of answers, each also a sympy
expression.
"""

from __future__ import annotations

import pickle
import re
from collections.abc import Mapping

import pytest
import sympy
from flint import arb, ctx, fmpq

import kinegrade
from kinegrade.errors import KinegradeError
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.field import Field
from kinegrade.numbers.symbolic import convert_to_sympy
from kinegrade.problem.template.library.library import find_template_names

NO_ASK = (
    'slider-crank: no ask "v_b": did you mean "v_B"? (known here: a_B, alpha_AB, omega_AB, v_B)'
)


def test_a_solution_is_a_mapping_of_its_answers() -> None:
    solution = kinegrade.template("slider-crank").solve()
    assert isinstance(solution, Mapping)
    assert "v_B" in solution
    assert "v_b" not in solution
    assert 0 not in solution
    assert list(solution) == ["v_B", "omega_AB", "alpha_AB", "a_B"]
    assert len(solution) == 4
    assert solution.get("v_b") is None
    assert dict(solution.items()) == solution
    assert solution == kinegrade.template("slider-crank").solve()
    assert solution != kinegrade.template("slider-crank").solve(phi=30)


def test_a_name_that_is_not_asked_for_is_a_key_error_that_says_which_there_are() -> None:
    solution = kinegrade.template("slider-crank").solve()
    with pytest.raises(KeyError) as caught:
        solution["v_b"]
    assert isinstance(caught.value, KinegradeError)
    assert str(caught.value) == NO_ASK
    assert str(pickle.loads(pickle.dumps(caught.value))) == NO_ASK


def test_a_solution_prints_its_answers() -> None:
    assert repr(kinegrade.template("slider-crank").solve()) == (
        "<slider-crank: v_B = 2*sqrt(3)/3 m/s, omega_AB = 1/3 rad/s, "
        "alpha_AB = 8*sqrt(3)/27 rad/s², a_B = -2/9 m/s²>"
    )


def test_an_exact_answer_is_the_sympy_expression_that_it_prints_as() -> None:
    for name in find_template_names():
        for answer in kinegrade.template(name).solve().values():
            if answer.exact is not None:
                difference = answer.sympy() - sympy.sympify(answer.exact)
                assert abs(sympy.N(difference, 40)) < 1e-35, (name, answer)
    assert kinegrade.template("slider-crank").solve()["v_B"].sympy() == 2 * sympy.sqrt(3) / 3


def test_a_notebook_shows_an_answer_as_a_formula() -> None:
    solution = kinegrade.template("slider-crank").solve()
    assert solution["v_B"]._repr_latex_() == r"$\frac{2\sqrt{3}}{3}\,\mathrm{m/s}$"
    certified = kinegrade.template("slider-crank").solve(phi=37)["v_B"]
    assert certified._repr_latex_() == r"$\approx 0.8977451442\,\mathrm{m/s}$"


def test_every_answer_of_every_template_has_a_formula() -> None:
    for name in find_template_names():
        for answer in kinegrade.template(name).solve().values():
            assert re.fullmatch(r"\$[^$]+\$", answer._repr_latex_()), (name, answer)


def test_roots_of_roots_and_angles_become_expressions() -> None:
    field = Field()
    nested = field.sqrt(3 + field.sqrt(fmpq(2))) * field.sqrt(fmpq(5)) + fmpq(1, 2)
    root = sympy.sqrt(3 + sympy.sqrt(2)) * sympy.sqrt(5) + sympy.Rational(1, 2)
    assert sympy.expand(convert_to_sympy(nested) - root) == 0
    assert convert_to_sympy(Angle(fmpq(1, 3))) == sympy.pi / 3
    assert convert_to_sympy(Angle(fmpq(1, 3)), degrees=True) == 60
    left = Angle(fmpq(1, 2), ((fmpq(2), (fmpq(-1), fmpq(3))),))
    assert convert_to_sympy(left) == sympy.pi / 2 + 2 * (sympy.pi - sympy.atan(3))
    assert convert_to_sympy(None) == sympy.oo


def test_an_enclosure_is_a_float_of_the_digits_that_are_certain() -> None:
    answer = kinegrade.template("slider-crank").solve(phi=37)["v_B"]
    assert answer.exact is None
    value = answer.sympy()
    assert isinstance(value, sympy.Float)
    assert str(value).rstrip("0") == answer.certified
    with ctx.workprec(64):
        wide = arb(1, 0.5**20) / 3
    assert str(convert_to_sympy(wide)) == "0.33333"
    assert convert_to_sympy(arb(0, 1e-60)) == 0
