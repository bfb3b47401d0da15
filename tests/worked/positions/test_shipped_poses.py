"""Positions of shipped templates, told in words and equations whose numbers agree."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.width import measure_row
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
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.equation import WIDEST
from kinegrade.worked.formulas.numbers import has_short_form
from kinegrade.worked.positions.positions import explain_positions
from tests.laws.cases import shipped
from tests.worked.chains import chains, disagreements, part_value
from tests.worked.draws import drawn
from tests.worked.positions.poses import ROUNDED, bare, require_printable, sentences
from tests.worked.telling import displayed as lines
from tests.worked.telling import tidy

POSES = (
    "pose-cam-tappet",
    "pose-four-bar-coupler",
    "pose-sleeve-slider-rod",
    "triangle-pose-three-frames",
)


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
            assert any(bare(answer.closed_form) in bare(part) for part in parts), parts


@pytest.mark.parametrize("name", POSES)
def test_a_pose_asks_for_nothing_but_positions(name: str) -> None:
    assert [ask for ask in load_template(name).asks.values() if not is_positional(ask)] == []


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "$B$ is the intersection (on the right of the line from $O$ to $A$) of"),
        ("zh", "的两交点中位于由 $O$ 指向 $A$ 的直线右侧的一个"),
        (
            "de",
            "$B$ ist der rechts von der Geraden von $O$ nach $A$ gelegene Schnittpunkt der $x$-Achse",
        ),
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
    assert said in "\n".join(sentences(blocks))


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
