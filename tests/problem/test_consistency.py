"""What makes no sense in a template is found before any numbers are put in, by `check` and by
whatever reads it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import TemplateError
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
from kinegrade.problem.statement_faults import find_statement_faults
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.meaning.meaning import Scope
from kinegrade.problem.template.meaning.radians import require_no_radians
from tests.problem.crank import crank, crank_text
from tests.said import all_said, said
from tests.small_class import kinegrade

PUBLISHED = 'gives = { v_x = "-omega*h" }'
ON_REQUEST = '\n[asks]\nw = { quantity = "%s", unit = "%s", means = { en = "w", zh = "w 量" } }\n'


def faults(*changes: tuple[str, str]) -> list[str]:
    """What reading the changed crank refuses."""
    with pytest.raises(TemplateError) as refusal:
        crank(*changes)
    return list(refusal.value.problems)


def asking(quantity: str, unit: str) -> list[str]:
    """What reading the crank refuses when something further may be asked for on request."""
    return faults(("\n[asks]\n", ON_REQUEST % (quantity, unit)))


@pytest.mark.parametrize(
    ("quantity", "unit", "problem"),
    [
        (
            "direction(A - O)",
            "deg",
            "direction(...) of 1 argument - expected direction(POINT, POINT)",
        ),
        ("angle(P - A)", "deg", "angle(...) of 1 argument - expected angle(VECTOR, VECTOR)"),
        (
            "speed(A)",
            "m/s",
            'unknown function "speed" - did you mean "magnitude(velocity(B))"',
        ),
        ("omega(A)", "rad/s", "omega(...): argument 1 is a point - expected omega(BODY[, BODY])"),
        (
            "magnitude(velocity(A + P))",
            "m/s",
            "velocity(...): argument 1 is a vector - expected velocity(POINT[, BODY])",
        ),
        (
            "magnitude(velocity(A, r))",
            "m/s",
            "velocity(...): argument 2 is a length (m) - expected velocity(POINT[, BODY])",
        ),
        (
            "radius(circle_of_poles(OA, h))",
            "m",
            "circle_of_poles(...): argument 2 is a length (m) - "
            "expected circle_of_poles(BODY, PARAMETER)",
        ),
        (
            "velocity(A)",
            "m/s",
            "a vector - expected a number - take magnitude(...), x(...), y(...) or along(...) of a vector",
        ),
        (
            "x(acceleration(A))",
            "m/s",
            'this is an acceleration (m/s^2): it cannot be counted in "m/s" - '
            'write unit = "m/s^2", or ask for something else',
        ),
        (
            "distance(O, A)",
            "rad/s",
            'this is a length (m): it cannot be counted in "rad/s" - '
            'write unit = "m", or ask for something else',
        ),
        (
            "angle(A - O, P - A)",
            "m",
            'this is a pure number or an angle: it cannot be counted in "m" - '
            'write unit = "rad", "deg" or "1", or ask for something else',
        ),
        (
            "omega(OA)*r**2",
            "m/s",
            'this is something in m^2/s: it cannot be counted in "m/s" - '
            'write unit = "m^2/s", or ask for something else',
        ),
        (
            "magnitude(velocity(A)) + r",
            "m/s",
            '"+": a velocity (m/s) and a length (m) do not go together - check the units',
        ),
        (
            "x(velocity(A) + A)",
            "m/s",
            '"+": a velocity (m/s) and a length (m) do not go together - check the units',
        ),
        (
            "x(A*A)",
            "m",
            '"*" between a point and a point - angles go with angles, points with points, '
            "numbers with numbers",
        ),
        (
            "r/A",
            "m",
            '"/" between a length (m) and a point - angles go with angles, points with points, '
            "numbers with numbers",
        ),
        (
            "OA*2",
            "m",
            '"*" between a body and a number - angles go with angles, points with points, '
            "numbers with numbers",
        ),
        (
            "right + 1",
            "m",
            '"+" between the name of a side and a number - angles go with angles, '
            "points with points, numbers with numbers",
        ),
        ("A**2", "m^2", "a power of a point - expected a number to be raised"),
        ("sqrt(r)", "m", 'this is something in m^1/2: it cannot be counted in "m"'),
        ("r**h", "m", "a power must be a whole number of at most 16: for roots write sqrt(...)"),
        ("sin(r)", "1", "sin(...): argument 1 is a length (m) - expected sin(ANGLE)"),
        ("sin(60)", "1", "60 radians - did you mean 60 degrees? write pi/3"),
        ("direction(O, A) + 90", "deg", "90 radians - did you mean 90 degrees? write pi/2"),
    ],
)
def test_an_ask_on_request_that_makes_no_sense_is_refused(
    quantity: str, unit: str, problem: str
) -> None:
    (fault,) = asking(quantity, unit)
    assert fault.startswith(f"crank.toml:27: asks.w.quantity: {problem}")


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        (
            '"(0, h)"',
            '"polar(O, r, 60)"',
            "20: points.P: 60 radians - did you mean 60 degrees? write pi/3",
        ),
        (
            "line(P, 0)",
            "line(P, -37/2)",
            "21: points.A: -37/2 radians - did you mean -37/2 degrees? write -37*pi/360",
        ),
        (
            "line(P, 0)",
            "line(P, 1)",
            "21: points.A: 1 radian - did you mean 1 degree? write pi/180",
        ),
        (
            '"(0, h)"',
            '"(0, omega)"',
            "20: points.P: its coordinates are an angular velocity (rad/s) - expected a length (m) - "
            "check the units",
        ),
        (
            '"(0, h)"',
            '"(0, h/r)"',
            "20: points.P: its coordinates are a pure number or an angle - expected a length (m) - a "
            "number becomes a length by one that is given: with the module m, a gear of z teeth has "
            "the radius m*z/2",
        ),
        (
            '"(0, h)"',
            '"(omega, h)"',
            "20: points.P: (x, y): an angular velocity (rad/s) and a length (m) do not go together - "
            "check the units",
        ),
        (
            '"(0, h)"',
            '"h"',
            "20: points.P: a length (m) - expected a point, like (x, y) or polar(O, r, phi)",
        ),
        (
            '"(0, h)"',
            '"(right, h)"',
            "20: points.P: (x, y): argument 1 is the name of a side - expected (NUMBER, NUMBER)",
        ),
        (
            '"OA turns", velocity = "omega"',
            '"OA turns", velocity = "omega*r"',
            "6: inputs[1]: its velocity is a velocity (m/s) - expected an angular velocity (rad/s) - "
            "check the units",
        ),
        (
            '"OA turns", velocity = "omega"',
            '"OA turns", velocity = "omega", acceleration = "omega"',
            "6: inputs[1]: its acceleration is an angular velocity (rad/s) - "
            "expected an angular acceleration (rad/s^2) - check the units",
        ),
        (
            '"OA turns", velocity = "omega"',
            '"A of OA moves along 30", velocity = "omega*r"',
            "6: inputs[1]: 30 radians - did you mean 30 degrees? write pi/6",
        ),
        (
            '"OA turns", velocity = "omega"',
            '"A of OA moves along O", velocity = "omega*r"',
            "6: inputs[1]: moves along a point - expected +x, -x, +y, -y or an angle, "
            "like direction(O, A)",
        ),
        (
            '"pin O: ground OA"',
            '"pin O: ground OA", "circle(O, omega) of OA touches line(A, 0)"',
            "5: joints[2]: circle(...): a length (m) and "
            "an angular velocity (rad/s) do not go together - check the units",
        ),
        (
            "omega < 10000000",
            "omega < h",
            '7: conditions[1]: "omega < h": an angular velocity (rad/s) and a length (m) '
            "do not go together - check the units",
        ),
        (
            "omega < 10000000",
            "distance(h, r) < h",
            "7: conditions[1]: distance(...): argument 1 is a length (m) - expected distance(POINT, ",
        ),
        (
            PUBLISHED,
            'gives = { v_x = "-omega" }',
            "32: published[1].gives.v_x: this is an angular velocity (rad/s): "
            'it cannot be counted in "m/s" - write unit = "rad/s", or ask for something else',
        ),
        (
            PUBLISHED,
            'gives = { v_x = "omega*length(h)" }',
            "32: published[1].gives.v_x: unknown func",
        ),
    ],
)
def test_what_makes_no_sense_is_refused_with_its_place(old: str, new: str, problem: str) -> None:
    found = faults((old, new))
    assert any(fault.startswith(f"crank.toml:{problem}") for fault in found), found


def test_a_named_length_of_two_dimensions_is_refused_once() -> None:
    lengths = '\n[lengths]\nmixed = "h + omega"\n\n[points]\n'
    assert faults(("\n[points]\n", lengths), ('"(0, h)"', '"(mixed, mixed)"')) == [
        'crank.toml:19: lengths.mixed: "+": a length (m) and an angular velocity (rad/s) '
        "do not go together - check the units"
    ]


def test_numbers_of_the_source_may_stand_for_values_with_units() -> None:
    """A source that states h = 1/2 m prints its result without h; a literal alone takes any
    dimension.
    """
    crank(
        ('[0, "1/2", 3]', '["1/2"]'),
        (PUBLISHED, 'given = { h = "1/2" }\ngives = { v_x = "-omega/2" }'),
    )
    crank((PUBLISHED, 'given = { h = "0" }\ngives = { v_x = "0" }'))
    crank(("omega < 10000000", "2*omega < 1/5"))


def test_check_refuses_a_template_whose_ask_on_request_has_the_wrong_unit(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(
        crank_text(("\n[asks]\n", ON_REQUEST % ("x(acceleration(A))", "m/s"))), encoding="utf-8"
    )
    shown = kinegrade("check", file)
    assert shown.exit_code == 2
    assert (
        "crank.toml:27: asks.w.quantity: this is an acceleration (m/s^2): it cannot be counted in"
        in shown.stderr
    )


def test_an_exam_that_keeps_such_a_template_can_still_be_read() -> None:
    text = crank_text(("\n[asks]\n", ON_REQUEST % ("x(acceleration(A))", "m/s")))
    assert read_template("crank", text, kept=True).asks["w"].unit.text == "m/s"


def test_one_unreadable_unit_is_one_fault() -> None:
    assert faults(('r     = { unit = "m"', 'r     = { unit = "furlong"')) == [
        'crank.toml:14: parameters.r.unit: unit "furlong" - expected a product or quotient like m/s^2 of '
        "1, cm, deg, ft, h, in, km, m, min, mm, r, rad, rpm, s"
    ]


def test_one_wrong_unit_is_one_fault() -> None:
    (fault,) = faults(('h     = { unit = "m"', 'h     = { unit = "s"'))
    assert fault == (
        'crank.toml:15: parameters.h.unit: "s" does not fit where h is used (2 faults), as in points.P: '
        "its coordinates are a time (s) - expected a length (m) - check the units"
    )


def test_one_point_or_ask_that_cannot_be_read_is_one_fault() -> None:
    assert faults(('"(0, h)"', '"(0, h"')) == [
        'crank.toml:20: points.P: "(0, h", character 6: found the end, expected "," or ")"'
    ]
    assert faults(('"(0, 0)"', '"(0 0)"')) == [
        'crank.toml:19: points.O: "(0 0)", character 4: found "0", expected "," or ")"'
    ]
    assert faults(('"x(velocity(A))"', '"x(velocity(A)"')) == [
        'crank.toml:27: asks.v_x.quantity: "x(velocity(A)", character 14: found the end, expected "," or ")"'
    ]


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


@pytest.mark.parametrize("text", ["0", "pi/3", "phi", "phi + pi", "2*3 - 6", "1/0", "2**2"])
def test_what_is_no_plain_number_is_no_slip(text: str) -> None:
    require_no_radians(read_expression(text))


@pytest.mark.parametrize(
    ("changes", "fault"),
    [
        (
            [("h     = {", "height = {")],
            '20: points.P: unknown name "h" (and at 3 more places) - '
            "known here: O, clockwise, counterclockwise and 8 more",
        ),
        (
            [('OA = "O A"', 'CA = "O A"')],
            '5: joints[1]: no body "OA" (and at 1 more place) - known here: CA, ground',
        ),
        (
            [('quantity = "x(v', 'qantity = "x(v')],
            '27: asks.v_x.qantity: unknown key - did you mean "quantity"? (known here: cyclic, '
            "means, points, quantity, sign, symbol, unit, vanishes)",
        ),
    ],
)
def test_one_misspelt_name_does_not_flood_its_author(
    changes: list[tuple[str, str]], fault: str
) -> None:
    assert faults(*changes) == [f"crank.toml:{fault}"]


def test_one_misspelt_table_does_not_make_every_name_unknown() -> None:
    assert faults(("[parameters]", "[parameter]")) == [
        'crank.toml:13: parameter: unknown table or key - did you mean "parameters"?'
    ]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            'OA = "O A"',
            'OA = "O A O"',
            'crank.toml:24: bodies.OA: "O" stands twice in the body - list each point once',
        ),
        (
            "[asks]",
            '[figure]\nlengths = [{ symbol = "r", from = "A", to = "A" }]\n[asks]',
            'crank.toml:27: figure.lengths[1].to: a mark from "A" to itself - expected another point',
        ),
        (
            "[asks]",
            '[figure]\nangles = [{ symbol = "r", at = "O", from = "A", to = "A" }]\n[asks]',
            'crank.toml:27: figure.angles[1].from: a mark from "A" to itself - expected another point',
        ),
        (
            "[asks]",
            '[figure]\nangles = [{ symbol = "r", at = "O", from = "right", to = "O" }]\n[asks]',
            'crank.toml:27: figure.angles[1].to: a mark from "O" to itself - expected another point',
        ),
        (
            "[asks]",
            '[figure]\nframes = [{ x = "x", y = "y", at = "A", to = "A" }]\n[asks]',
            'crank.toml:27: figure.frames[1].to: a mark from "A" to itself - expected another point',
        ),
    ],
)
def test_a_point_stands_once_in_a_body_and_at_one_end_of_a_mark(
    old: str, new: str, said: str
) -> None:
    assert faults((old, new)) == [said]
    crank((old, new), kept=True)  # no later rule closes an exam


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


@pytest.mark.parametrize(
    ("behind", "unit"),
    [
        (" rad/s", "rad/s"),
        ("m.", "m"),
        (" m/s², and", "m/s²"),
        (" degrees", "degrees"),
        ("°", "°"),
        (" in the slot", ""),
        (" above", ""),
        (" $m$", ""),
    ],
)
def test_a_unit_typed_behind_a_given_is_a_fault(behind: str, unit: str) -> None:
    template = crank(("{{ h.value }} above", f"{{{{ h.value }}}}{behind} above"))
    said = (
        f"crank.toml: statement.en: {{{{ h }}}} is printed with its unit, and {unit} stands behind "
        "it: leave that out, and print another unit by that of the parameter"
    )
    assert all_said(find_statement_faults(template)) == [said] * bool(unit)
