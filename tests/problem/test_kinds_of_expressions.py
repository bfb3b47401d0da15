"""Every expression has a kind, which messages name in words, and numbers alone are added to numbers."""

from __future__ import annotations

from typing import Any

import pytest

from kinegrade.expressions.evaluation import make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.numbers.field import Field
from kinegrade.problem.centrode import Centrodes
from kinegrade.problem.kinds.dimension import LENGTH, SPEED
from kinegrade.problem.kinds.kinds import (
    Arrow,
    BodyKind,
    Kind,
    Ring,
    Scalar,
    Side,
    Straight,
    describe_kind,
)
from kinegrade.problem.kinds.signatures import CONSTRUCTIONS, ELEMENTARY
from kinegrade.problem.quantities.functions import QUANTITIES, make_quantities
from kinegrade.problem.template.meaning.meaning import Scope
from tests.problem.consistency import ON_REQUEST, faults
from tests.problem.crank import crank
from tests.said import said


def test_signatures_are_there_for_every_function_and_for_no_other() -> None:
    field, nothing = Field(), {}
    values = make_elementary_functions(field)
    places = {**values, **make_constructions(field, nothing)}
    motion: Any = None
    of_poles = Centrodes(crank(), nothing, None).functions(field)
    assert set(ELEMENTARY) == set(values)
    assert set(CONSTRUCTIONS) == set(places)
    assert set(QUANTITIES) == {*places, *make_quantities(motion, field), *of_poles}


SCOPE = Scope(
    {
        "r": Scalar(LENGTH),
        "A": Arrow(LENGTH, "A"),
        "v": Arrow(SPEED),
        "rod": BodyKind(),
        "upper": Side(),
    },
    QUANTITIES,
    frozenset({"rod"}),
    frozenset({"phi"}),
)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("2*pi", Scalar(None)),
        ("sqrt(3)/2", Scalar(None)),
        ("-r", Scalar(LENGTH)),
        ("-v", Arrow(SPEED)),
        ("r**-2*r**3", Scalar(LENGTH)),
        ("sqrt(r*r)", Scalar(LENGTH)),
        ("abs(r) + 1", Scalar(LENGTH)),
        ("turned(v)*2/3", Arrow(SPEED)),
        ("line(A, pi/2)", Straight()),
        ("circle(A, r)", Ring()),
        ("foot(A, line(A, A + (1, 0)))", Arrow(LENGTH)),
        ("along(v, A)", Scalar(SPEED)),
        ("sqrt(magnitude(v)**2)", Scalar(SPEED)),
    ],
)
def test_the_kind_of_an_expression(text: str, kind: Kind) -> None:
    assert SCOPE.kind(read_expression(text)) == kind


def test_kinds_in_words() -> None:
    kinds: tuple[Kind, ...] = (Straight(), Ring(), BodyKind(), Side(), Arrow(None), Scalar(None))
    assert [said(describe_kind(kind)) for kind in kinds] == [
        "a line",
        "a circle",
        "a body",
        "the name of a side",
        "a vector",
        "a number",
    ]


@pytest.mark.parametrize(
    ("quantity", "number"),
    [
        ("magnitude(velocity(A)) + 3", "3"),
        ("3 + magnitude(velocity(A))", "3"),
        ("abs(x(velocity(A)) - 1/2)", "1/2"),
    ],
)
def test_a_number_added_to_what_has_a_dimension_is_refused(quantity: str, number: str) -> None:
    asked = ON_REQUEST % (quantity, "m/s")
    assert faults(("\n[asks]\n", asked)) == [
        f"crank.toml:27: asks.w.quantity: {number} is added to a velocity (m/s) - add a given with a "
        "unit, or nothing"
    ]


@pytest.mark.parametrize(
    ("quantity", "unit"),
    [
        ("-magnitude(velocity(A))", "m/s"),
        ("magnitude(velocity(A)) + 0", "m/s"),
        ("direction(O, A) - 2*pi", "rad"),
        ("r/h + 3", "1"),
        ("2*magnitude(velocity(A))", "m/s"),
    ],
)
def test_a_number_may_be_added_to_a_number(quantity: str, unit: str) -> None:
    assert "w" in crank(("\n[asks]\n", ON_REQUEST % (quantity, unit))).asks
