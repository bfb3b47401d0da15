"""Each construction and each measure of a pose, told on a template that has nothing else."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import (
    find_shipped,
    load_template,
)
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.answers.poses import explain_pose_answers
from kinegrade.worked.case import Case
from kinegrade.worked.positions.positions import explain_positions
from kinegrade.worked.solution import write_worked_solution
from tests.worked.chains import chains, disagreements, part_value
from tests.worked.draws import kept, stated
from tests.worked.positions.poses import require_printable, sentences
from tests.worked.positions.test_shipped_poses import require_coordinates
from tests.worked.telling import displayed as lines
from tests.worked.telling import proses, tidy, tidy_prose

TEXTS = '{ en = "a length", zh = "长度" }'
HEAD = f"""
family = "test"
source = "by hand"
title = {TEXTS}
joints = ["pin A: ground AB"]
inputs = []
[statement]
en = "{{{{ r }}}} {{{{ phi }}}}"
zh = "{{{{ r }}}} {{{{ phi }}}}"
[parameters]
r = {{ unit = "m", draw = [2], means = {TEXTS} }}
phi = {{ unit = "deg", draw = [30], means = {TEXTS} }}
[bodies]
AB = "A B"
[points]
A = "(0, 0)"
B = "polar(A, r, phi)"
"""


def test_an_angle_without_a_field_gives_decimals_that_say_they_are_rounded() -> None:
    solution = solve_template(load_template("slider-crank"), {"r": "1/5", "k": "2", "phi": "37"})
    assert lines(explain_positions(Case(solution, "en"), ["A"]).write())[0] == tidy(
        r"x_{A} &= r \cos\varphi = 0.2\,\unit{m} \cdot \cos 37^\circ \approx 0.1597\,\unit{m}"
    )


@pytest.mark.parametrize(
    ("construction", "told"),
    [
        ("meet(line(A, phi), line((r, 0), 2*pi/3))", "the line through $A$ in the direction"),
        (
            "meet(line(A, B), line((r, 0), pi/2))",
            r"the line $AB$ and the line through $(r,\ 0)$ parallel to the $y$ axis",
        ),
        (
            "meet(line((0, r), 0), line((r, 0), pi/2))",
            r"the line through $(0,\ r)$ parallel to the $x$ axis",
        ),
        ("meet(line(A, B), line((r, 0), (0, r)))", r"the line $(r,\ 0)(0,\ r)$"),
        ("meet(circle(B, r), line((0, r/2), -phi), left)", "the left-hand intersection"),
        ("meet(circle(B, r), line((0, r/4), 0), left)", "the left-hand intersection"),
        ("meet(line((r, 0), pi/2), circle(B, r), lower)", "the lower intersection"),
        ("meet(line((0, r/4), B), circle(B, r), lower)", "the lower intersection"),
        ("meet(line((r, 0), pi/2), circle(A, r), clockwise)", "the $y$ axis touches the circle"),
        (
            "meet(circle((r, 0), 2*r), line((0, r/2), B), right)",
            "the circle about $H_{1}$ of radius $2 r$",
        ),
        (
            "meet(circle(A, r), circle(B, r/2), clockwise)",
            "on the right of the line from $A$ to $B$",
        ),
        (
            "meet(circle(A, r), circle(B, r/2), upper)",
            "The law of cosines in the triangle $ABC$ gives its angle at $A$",
        ),
        ("foot((r, r), line(A, B))", r"the perpendicular from $(r,\ r)$ to the line $AB$"),
        ("foot(B, line((0, r), 0))", "the foot of the perpendicular from $B$"),
        ("toward(A, B, 3*r)", "on the ray from $A$ through $B$, at the distance $3 r$ from $A$"),
        ("toward(A, B, -r)", "on the line from $B$ through $A$, beyond $A$ at the distance $r$"),
        ("toward(B, B - (r, r), -r/2)", r"in the direction of the vector $(r,\ r)$"),
        ("toward(B, B - (r, r), r/2)", r"in the direction of the vector $(-r,\ -r)$"),
        (
            "midpoint(B, polar(B, r, pi/2))",
            "$H_{1}$ lies at the distance $r$ from $B$ in the direction of $y$",
        ),
        ("polar(midpoint(A, B), -r, phi)", "opposite to the direction"),
        ("B - turned(B)/2", "From $B$ to $C$ leads the vector"),
        ("B", "$C$ coincides with $B$"),
        ("(A + B)/2 + (r, x(B))", "Coordinates of $C$"),
        (
            "polar(A, distance(A, B), direction(A, B) + pi/6)",
            r"the direction $\angle(x, \overrightarrow{AB}) + 30^\circ$",
        ),
    ],
)
def test_every_construction_is_told_with_numbers_that_agree(construction: str, told: str) -> None:
    text = (
        HEAD
        + f'C = "{construction}"\n[asks]\nx_C = {{ quantity = "x(C)", unit = "m", sign = "+x", '
        f"points = 1, means = {TEXTS} }}"
    )
    for values in ({"r": "2", "phi": "30"}, {"r": "2", "phi": "37"}):
        solution = solve_template(read_template("test", text), values)
        blocks = explain_positions(Case(solution, "en"), ["C"]).write()
        assert tidy_prose(told) in " ".join(sentences(blocks))
        require_printable(blocks, construction)
        require_printable(explain_positions(Case(solution, "zh"), ["C"]).write(), construction)
        assert disagreements(blocks)[1] == []
        require_coordinates(solution, "C", dict(chains(blocks)))


@pytest.mark.parametrize(
    ("quantity", "unit", "end"),
    [
        ("distance(B, line((0, r), 0))", "m", r"\left|y_{B} - r\right|"),
        ("distance(B, line((0, r), (r, 0)))", "m", "frac"),
        ("magnitude(B - A)", "m", r"\frac{x_{B}}{\cos\varphi}"),
        ("2*distance(A, B) + x(B)", "m", r"2 AB + x_{B}"),
        ("between(B - A, turned(A - B))", "deg", ""),
        ("between(B, (1, 0))/2", "deg", r"\frac{\angle(\boldsymbol{u}, \boldsymbol{v})}{2}"),
        ("direction(B, A)", "deg", ""),
        ("angle(turned(B), A - B)", "deg", ""),
        ("along(B, (1, 1))", "m", "frac"),
        ("sin(direction(A, B))", "1", r"\sin\angle(x, \overrightarrow{AB})"),
        ("angle((0, 1), (r, -r))", "rad", ""),
        ("distance(A, midpoint(A, B))", "mm", ""),
        ("x(polar(B, r, phi)) - x(B)", "m", "x_{H_{1}} - x_{B}"),
    ],
)
def test_every_measure_of_a_pose_ends_with_its_answer(quantity: str, unit: str, end: str) -> None:
    text = (
        HEAD
        + f'[asks]\nq = {{ quantity = "{quantity}", unit = "{unit}", sign = "signed", points = 1, '
        f"vanishes = true, means = {TEXTS} }}"
    )
    for values in ({"r": "2", "phi": "30"}, {"r": "2", "phi": "37"}):
        solution = solve_template(read_template("test", text), values)
        blocks = explain_pose_answers(Case(solution, "en"), ("q",))
        require_printable(blocks, quantity)
        require_printable(explain_pose_answers(Case(solution, "zh"), ("q",)), quantity)
        assert disagreements(blocks)[1] == []
        symbol, parts = list(chains(blocks))[-1]
        assert symbol == "q"
        assert (end if end == "frac" else tidy(end)) in parts[0]
        value = part_value(parts[-1])
        answer = float(solution["q"].value) * {"deg": 3.14159265358979 / 180, "mm": 0.001}.get(
            unit, 1
        )
        assert value == pytest.approx(answer, rel=1e-3)


def test_a_length_that_several_answers_need_is_found_once() -> None:
    solution = solve_template(load_template("pose-four-bar-coupler"), {})
    told = [
        left
        for left, _ in chains(explain_pose_answers(Case(solution, "en"), ["A11", "A12", "A21"]))
    ]
    assert told == ["BC", "A_{11}", "A_{12}", "A_{21}"]


@pytest.mark.parametrize(
    ("phi", "told"),
    [
        ("30", "between $0^\\circ$ and $90^\\circ$"),
        ("150", "between $90^\\circ$ and $180^\\circ$"),
        ("210", "between $-180^\\circ$ and $-90^\\circ$"),
        ("-30", "between $-90^\\circ$ and $0^\\circ$"),
        ("0", "$q$ is zero"),
        ("90", "$q$ is $90^\\circ$"),
        ("180", "$q$ is $180^\\circ$"),
        ("270", "$q$ is $-90^\\circ$"),
    ],
)
def test_the_quadrant_of_an_angle_is_told_from_the_signs_of_its_cosine_and_sine(
    phi: str, told: str
) -> None:
    text = (
        HEAD
        + '[asks]\nq = { quantity = "angle((1, 0), B - A)", unit = "deg", sign = "ccw", points = '
        f"1, vanishes = true, means = {TEXTS} }}"
    )
    solution = solve_template(read_template("test", text), {"r": "2", "phi": phi})
    assert told in sentences(explain_pose_answers(Case(solution, "en"), ("q",)))[-1]


@pytest.mark.parametrize(("unit", "factor"), [("ft/s", 0.3048), ("km/h", 1000 / 3600)])
def test_an_answer_in_other_units_stands_behind_that_in_si(unit: str, factor: float) -> None:
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    asked = 'v_B      = { quantity = "magnitude(velocity(B))", unit = "'
    assert f'{asked}m/s"' in text
    template = read_template("slider-crank", text.replace(f'{asked}m/s"', f'{asked}{unit}"'))
    values = {"r": "1/5", "k": "2", "phi": "30", "omega": "4"}
    speed = solve_template(load_template("slider-crank"), values)["v_B"].value
    blocks = write_worked_solution(solve_template(template, values), ["v_B"], "en").blocks
    (line,) = (each for each in lines(blocks) if rf"\unit{{{unit}}}" in each)
    assert rf"\,\unit{{m/s}} \approx {speed / factor:.4g}\,\unit{{{unit}}}" in line


@pytest.mark.parametrize(
    "name", ["slider-driven-gear-on-rack", "crank-bar-through-sleeve-with-arm"]
)
def test_a_coordinate_that_is_zero_is_told_with_the_other(name: str) -> None:
    """A distance was worked out without it, and a reader looked for it in vain."""
    values = dict(chains(kept(name)))
    point = {"slider-driven-gear-on-rack": "C", "crank-bar-through-sleeve-with-arm": "B"}[name]
    assert {f"x_{{{point}}}", f"y_{{{point}}}"} <= values.keys()
    assert ["0"] in (values[f"x_{{{point}}}"], values[f"y_{{{point}}}"])


def test_an_origin_at_a_moving_point_is_fixed_there() -> None:
    # x_C was differentiated with time though B, the origin, moves
    assert "The origin of the coordinates is fixed where $B$ is at this instant." in proses(
        kept("crank-slider-in-floating-link")
    )


def test_a_side_that_has_the_length_of_another_is_one_of_a_parallelogram() -> None:
    said = "\n".join(proses(kept("two-rods-driven-ends")))
    assert "$OACB$ is a parallelogram, so $OA=BC$. $A$ lies at the distance $BC$ from $O$" in said


def test_of_two_directions_with_one_tangent_the_side_tells_which_is_meant() -> None:
    # tan = -0.64 was followed by 147.48 degrees
    given = {"a": "310", "b": "240", "d": "660", "h": "280", "phi": "-10", "omega": "-3"}
    said = "\n".join(proses(stated("watt-linkage", **given)))
    assert "$BD$ leads to the left and upwards, so its angle with the $x$ axis" in said


def test_a_point_at_a_distance_is_placed_by_the_acute_angle_with_an_axis() -> None:
    """It lay in the direction -90 degrees - beta, counted counter-clockwise from the x axis."""
    said = (
        r"$B$ lies at the distance $l$ from $C$; $CB$ makes $\beta$ with the $y$ axis and points "
        "downwards to the left:"
    )
    assert said in list(proses(kept("toggle-press")))
