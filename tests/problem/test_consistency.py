"""What makes no sense in a template is found before any numbers are put in, by `check` and by
whatever reads it.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.expressions.reading import read_expression
from kinegrade.problem.statement_faults import find_statement_faults
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.meaning.radians import require_no_radians
from tests.problem.consistency import ON_REQUEST, PUBLISHED, asking, faults
from tests.problem.crank import crank, crank_text
from tests.said import all_said
from tests.small_class import kinegrade


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


def test_numbers_of_the_source_may_stand_for_values_with_units() -> None:
    """A source that states h = 1/2 m prints its result without h; a literal alone takes any
    dimension.
    """
    assert crank(
        ('[0, "1/2", 3]', '["1/2"]'),
        (PUBLISHED, 'given = { h = "1/2" }\ngives = { v_x = "-omega/2" }'),
    )
    assert crank((PUBLISHED, 'given = { h = "0" }\ngives = { v_x = "0" }'))
    assert crank(("omega < 10000000", "2*omega < 1/5"))


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


@pytest.mark.parametrize("text", ["0", "pi/3", "phi", "phi + pi", "2*3 - 6", "1/0", "2**2"])
def test_what_is_no_plain_number_is_no_slip(text: str) -> None:
    require_no_radians(read_expression(text))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            'OA = "O A"',
            'OA = "O A O"',
            'crank.toml:24: bodies.OA: "O" stands twice in the body - list each point once',
        ),
        (
            '"pin O: ground OA"',
            '"pin O: ground OA", "pin O: OA ground"',
            "crank.toml:5: joints[2]: says what joints[1] says - state each joint once",
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
def test_a_point_stands_once_in_a_body_and_at_one_end_of_a_mark_and_a_joint_once(
    old: str, new: str, said: str
) -> None:
    assert faults((old, new)) == [said]
    crank((old, new), kept=True)  # no later rule closes an exam


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
