"""Formulas say what the expressions say: precedence, signs, and where a product needs its dot."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExpressionError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, find_names
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.numbers.floats import Floats
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template
from kinegrade.worked.case import write_row
from kinegrade.worked.construction_steps import list_steps
from kinegrade.worked.formulas.leaves import formulate
from kinegrade.worked.formulas.symbols import collect_symbols, read_symbol
from kinegrade.worked.positions.axes import choose_axes
from tests.worked.latex_value import value_of
from tests.worked.telling import tidy

POINTS = {"A": "A", "B": "B", "O1": "O_{1}"}


def write_latex(
    tree: Expression, symbols: Mapping[str, str], degrees: bool = False, points: Iterable[str] = ()
) -> str:
    """The LaTeX of an expression, its names as given."""
    read = {name: read_symbol(latex) for name, latex in symbols.items()}
    return write_row(formulate(read, tuple(points)).state(tree, degrees).print())


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("-omega", r"-\omega"),
        ("-omega**2*r", r"-\omega^{2}\,r"),
        ("u*t", r"u\,t"),
        ("k*r*cos(phi + pi/2)", r"k\,r \cos(\varphi + 90^\circ)"),
        ("-l_1*sin(psi)/sin(theta)", r"-\frac{l_{1} \sin\psi}{\sin\theta}"),
        ("R*sin(phi)/(1 - cos(phi))", r"\frac{R \sin\varphi}{1 - \cos\varphi}"),
        ("a - (b - c)", "a - (b - c)"),
        ("a + (b - c)", "a + b - c"),
        ("-(a + b)*c", r"-(a + b)\,c"),
        ("-(a + b)/c", r"-\frac{a + b}{c}"),
        ("a/b/c", r"\frac{a}{b\,c}"),
        ("a/(b/c)", r"\frac{a}{\frac{b}{c}}"),
        ("sin(phi)*r", r"\sin\varphi \cdot r"),
        ("2*pi*n/60", r"\frac{2 \pi\,n}{60}"),
        ("sin(phi)**2", r"\sin^{2}\varphi"),
        ("(-a)**2", "(-a)^{2}"),
        ("cos(2*phi)", r"\cos 2 \varphi"),
        ("cos(-phi)", r"\cos(-\varphi)"),
        ("sqrt(r**2 - e**2)", r"\sqrt{r^{2} - e^{2}}"),
        ("2*3*a", r"2 \cdot 3 a"),
        ("x(A) + y(O1)", "x_{A} + y_{O_{1}}"),
        ("distance(A, B)/2", r"\frac{AB}{2}"),
        ("0.25*r", "0.25 r"),
    ],
)
def test_a_formula_looks_as_in_a_textbook(text: str, latex: str) -> None:
    assert write_latex(read_expression(text), POINTS) == tidy(latex)
    assert write_typst_math(latex, "test")


def test_angles_print_in_degrees_where_that_is_asked_and_vectors_with_an_arrow() -> None:
    assert write_latex(read_expression("phi - pi/2"), {}, degrees=True) == tidy(
        r"\varphi - 90^\circ"
    )
    assert write_latex(read_expression("phi - pi/2"), {}) == tidy(r"\varphi - \frac{\pi}{2}")
    assert write_latex(read_expression("lam*(B - A)"), POINTS, points=("A", "B")) == tidy(
        r"\lambda\,\overrightarrow{AB}"
    )


def expressions(template: Template) -> Iterator[Expression]:
    """All expressions of numbers in a template."""
    yield from template.scheme.lengths.values()
    for driver in template.scheme.drivers:
        yield from (driver.velocity, driver.acceleration)
    for condition in template.scheme.conditions:
        yield from (condition.left, condition.right)
    for published in template.published:
        yield from published.gives.values()
    axes = choose_axes(list_steps(template))
    for step in list_steps(template):
        yield from axes.pair(step.tree) or ()


def both_values(tree: Expression, start: float = 0.3, step: float = 0.617) -> tuple[float, float]:
    """The value of an expression, and of what is printed for it, at some values of its names."""
    leaves = {
        name: start + step * count % 1.1
        for count, name in enumerate(dict.fromkeys(find_names(tree)))
    }
    numbers = {name: math.pi if name == "pi" else value for name, value in leaves.items()}
    symbols = {name: f"v_{{{count}}}" for count, name in enumerate(leaves)} | {"pi": r"\pi"}
    functions = {
        **make_elementary_functions(Floats()),
        "x": lambda value: value,
        "y": lambda value: value + 1,
    }
    printed = write_latex(flat(tree), symbols)
    assert write_typst_math(printed, "test")
    values = {symbol: numbers[name] for name, symbol in symbols.items() if name in numbers}
    with Floats().context():
        return float(evaluate(tree, numbers, functions, Floats())), value_of(printed, values)


def flat(tree: Expression) -> Expression:
    """x(A) as A, y(A) as A + 1 in the places of coordinates, which the second opinion does not
    know.
    """
    if isinstance(tree, Operation):
        return Operation(tree.sign, flat(tree.left), flat(tree.right))
    if isinstance(tree, Call):
        if tree.function in ("x", "y"):
            one = (
                Number(read_expression("1").value)
                if tree.function == "y"
                else Number(read_expression("0").value)
            )  # type: ignore[union-attr]
            return Operation("+", tree.arguments[0], one)
        return Call(tree.function, tuple(flat(part) for part in tree.arguments))
    return tree


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_expression_of_every_template_is_printed_with_its_own_value(name: str) -> None:
    template = load_template(name)
    for tree in expressions(template):
        assert write_typst_math(
            write_row(formulate(collect_symbols(template)).state(tree).print()), name
        )
        for start, step in ((0.3, 0.617), (1.0, -0.02)):
            with suppress(ValueError):  # the root of a negative number, at these values
                value, printed = both_values(tree, start, step)
                assert printed == pytest.approx(value, rel=1e-9), write_latex(tree, {})


LEAVES = st.sampled_from(["a", "b", "c", "phi", "2", "0.5", "1", "3/2"]).map(
    read_expression
) | st.sampled_from("abc").map(Name)
TREES = st.recursive(
    LEAVES,
    lambda inner: (
        st.builds(Operation, st.sampled_from("+-*/"), inner, inner)
        | st.builds(lambda tree: Operation("-", read_expression("0"), tree), inner)
        | st.builds(lambda tree: Operation("**", tree, read_expression("2")), inner)
        | st.builds(
            lambda function, tree: Call(function, (tree,)),
            st.sampled_from(["sin", "cos", "abs"]),
            inner,
        )
    ),
    max_leaves=8,
)


@given(TREES)
def test_any_expression_is_printed_with_its_own_value(tree: Expression) -> None:
    try:
        value, printed = both_values(tree)
    except (ArithmeticError, ValueError, ExpressionError):
        return
    if math.isfinite(value) and 1e-6 < abs(value) < 1e6:
        assert printed == pytest.approx(value, rel=1e-6), write_latex(tree, {})
