"""Positions are told from the constructions, with numbers that agree, and the answers of poses end
as in the key.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

import pytest

from kinegrade.language import ENGLISH, Language
from kinegrade.language.known import known_languages
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.language.math.width import measure_row
from kinegrade.language.prose.typst import write_prose
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import (
    find_shipped,
    find_template_names,
    load_template,
)
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.answers.boxes import AnswerBoxes
from kinegrade.worked.answers.poses import explain_pose_answers, is_positional
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Prose
from kinegrade.worked.formulas.equation import WIDEST
from kinegrade.worked.formulas.numbers import has_short_form
from kinegrade.worked.positions.positions import explain_positions
from kinegrade.worked.solution import write_worked_solution
from tests.laws.cases import shipped
from tests.worked.chains import chains, disagreements, part_value
from tests.worked.draws import drawn, kept, stated
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
POSES = (
    "pose-cam-tappet",
    "pose-four-bar-coupler",
    "pose-sleeve-slider-rod",
    "triangle-pose-three-frames",
)


def sentences(blocks: Iterable[Block]) -> list[str]:
    return [block.text for block in blocks if isinstance(block, Prose)]


def require_printable(blocks: Iterable[Block], where: str) -> None:
    for text in sentences(blocks):
        assert write_prose(text, where, ENGLISH)
    for line in lines(blocks):
        assert line.count("&") == 1
        assert "--" not in line
        assert write_typst_math(line.replace("&", " "), where)


# Their coordinates are given quantities in symbols: no number follows from another
SYMBOLIC = frozenset({"pole-sleeve-slider-rod", "rolling-wheel-rim-points"})


def whole_chapter(solution: Solution, language: Language) -> tuple[Block, ...]:
    """Positions of all points, and the answers that are positions."""
    template = solution.template
    asks = [name for name, ask in template.asks.items() if is_positional(ask)]
    return (
        *explain_positions(Case(solution, language), template.scheme.points).write(),
        *explain_pose_answers(Case(solution, language), asks),
    )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_template_is_told_in_every_language_and_its_numbers_agree(name: str) -> None:
    for solution in drawn(name):
        for language in known_languages():
            blocks = whole_chapter(solution, language)
            require_printable(blocks, name)
            count, wrong = disagreements(blocks)
            assert wrong == []
        told = dict(chains(blocks))
        for point in solution.template.scheme.points:
            require_coordinates(solution, point, told)
        if name in SYMBOLIC:
            assert count == 0
        else:
            assert count > 0 or all(len(parts) < 2 for parts in told.values())


def require_coordinates(solution: Solution, point: str, told: dict[str, list[str]]) -> None:
    """What is told of a point ends with the coordinates that the mechanism has."""
    place = solution.assembly.values[point]
    symbol = (
        point if len(point) == 1 else point[0] + ("'" if point[1:] == "p" else f"_{{{point[1:]}}}")
    )
    for axis, value in (("x", place.x), ("y", place.y)):
        parts = told.get(f"{axis}_{{{symbol}}}")
        if parts is None:
            assert place == (0, 0)
            continue
        end = part_value(parts[-1])
        assert end is not None
        assert end == pytest.approx(float(value), rel=1e-3, abs=1e-9)


def bare(latex: str) -> str:
    """A formula without brackets."""
    return re.sub(r"\\(?:left|right)|[()]| ", "", tidy(latex))


ROUNDED = re.compile(r"\d\.\d{4}|[1-9]\.\d{3}|\d\d\.\d\d")  # four digits, as all that is rounded

ANSWERS = [
    (name, ask)
    for name in find_template_names()
    for ask, asked in shipped(name).asks.items()
    if is_positional(asked)
]


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize(("name", "ask"), ANSWERS)
def test_the_last_line_ends_with_the_answer_of_the_key(name: str, ask: str) -> None:
    for solution in drawn(name):
        answer, asked = solution[ask], tidy(solution.template.asks[ask].symbol)
        placed = explain_positions(Case(solution, "en"), solution.template.scheme.points).write()
        case = Case(solution, "en")
        boxes = AnswerBoxes.around((solution.template.asks[ask],), case)
        told = tuple(boxes.frame((*placed, *explain_pose_answers(case, (ask,)))))
        parts = dict(chains(told))[asked]
        printed = parts[-1].split(r"\,\unit")[0].removesuffix(r"^\circ")
        rounded = answer.decimal(len(printed.strip("-0.").replace(".", "")) or 1)
        assert float(printed) == pytest.approx(float(rounded), rel=1e-3)
        exact = not any(ROUNDED.search(part) for part in parts[:-1])
        if exact and answer.closed_form is not None and has_short_form(answer):
            assert any(bare(answer.closed_form) in bare(part) for part in parts)


@pytest.mark.parametrize("name", POSES)
def test_a_pose_asks_for_nothing_but_positions(name: str) -> None:
    assert all(is_positional(ask) for ask in load_template(name).asks.values())


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "$B$ is the intersection (on the right of the line from $O$ to $A$) of"),
        ("zh", "的两交点中位于由 $O$ 指向 $A$ 的直线右侧的一个"),
        ("de", "$B$ ist der rechts von der Geraden von $O$ nach $A$ gelegene Schnittpunkt von"),
    ],
)
def test_the_side_of_a_directed_line_is_told_as_the_template_names_it(
    language: Language, said: str
) -> None:
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    assert ", right)" in text
    template = read_template("slider-crank", text.replace(", right)", ", right of O->A)"))
    values = {"r": "1/5", "k": "2", "phi": "150"}
    solution = solve_template(template, values)
    assert solution["v_B"] == solve_template(load_template("slider-crank"), values)["v_B"]
    blocks = explain_positions(Case(solution, language), ["B"]).write()
    assert any(said in sentence for sentence in sentences(blocks))


def test_a_slider_crank_is_told_as_in_a_textbook() -> None:
    solution = solve_template(load_template("slider-crank"), {"r": "1/5", "k": "2", "phi": "30"})
    blocks = explain_positions(Case(solution, "en"), ["B"]).write()
    assert sentences(blocks) == [
        "$O$ is the origin of the coordinates.",
        r"$A$ lies at the distance $r$ from $O$; $OA$ makes $\varphi$ with the $x$ axis and points "
        "upwards to the right:",
        r"$B$ is the right-hand intersection of the $x$ axis and the circle about $A$ of "
        r"radius $k\,r$:",
    ]
    assert lines(blocks) == [
        tidy(line)
        for line in [
            r"x_{A} &= r \cos\varphi = 0.2\,\unit{m} \cdot \cos 30^\circ = "
            r"\frac{\sqrt{3}}{10}\,\unit{m} \approx 0.1732\,\unit{m}",
            r"y_{A} &= r \sin\varphi = 0.2\,\unit{m} \cdot \sin 30^\circ = 0.1\,\unit{m}",
            r"(x_{B} - x_{A})^{2} + y_{A}^{2} &= (k\,r)^{2}",
            "y_{B} &= 0",
            r"x_{B} &= x_{A} + \sqrt{(k\,r)^{2} - y_{A}^{2}} = 0.1732\,\unit{m} + "
            r"\sqrt{(2 \cdot 0.2\,\unit{m})^{2} - (0.1\,\unit{m})^{2}} "
            r"\approx 0.5605\,\unit{m}",
        ]
    ]
    assert sentences(explain_positions(Case(solution, "zh"), ["A"]).write())[-1] == (
        r"点 $A$ 到 $O$ 的距离为 $r$，$OA$ 与 $x$ 轴成 $\varphi$ 角，指向右上方："
    )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_line_is_broken_at_a_relation_sign_where_it_grows_too_wide(name: str) -> None:
    for line in lines(whole_chapter(drawn(name)[1], "en")):
        relations = line.count("=") + line.count(r"\approx") + line.count(r"\propto")
        assert relations == 1 or measure_row(read_math(line, "test")) <= WIDEST + 4


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
