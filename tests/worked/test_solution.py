"""Worked solutions: their equations hold, their projections determine what they say, their last
lines are the key.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from math import cos, hypot, pi, radians, sin

import numpy as np
import pytest

from kinegrade.errors import MechanismError, TemplateError
from kinegrade.language import ENGLISH
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.language.prose.typst import write_prose
from kinegrade.mechanics.plan import Plan
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector import add_vectors
from kinegrade.mechanics.vector_equation import Level
from kinegrade.numbers.floats import Floats
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import METHODS, Method
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Heading, Pictures
from kinegrade.worked.solution import collect_needs, write_worked_solution
from kinegrade.worked.steps.couplers import find_coupler
from kinegrade.worked.steps.steps import find_stage
from kinegrade.worked.steps.titles import select_scalars
from kinegrade.worked.vectors.needed_rates import select_steps
from kinegrade.worked.vectors.projection import Projection, Share, find_deductions
from kinegrade.worked.vectors.stage import Stage, measure_along_direction
from tests.worked.chains import chains, disagreements, part_value
from tests.worked.draws import drawn, kept, told
from tests.worked.reader.amounts import Amount, Unreadable
from tests.worked.reader.formula_reader import read_formula
from tests.worked.telling import boxed, displayed, mathematics, proses, tidy

CLOSE = 1e-9
TIDY = 1e-7  # angles are whole where they are so to within 1e-7 degrees
Told = tuple[Stage, tuple[Relation, ...], tuple[str, ...]]


@lru_cache(maxsize=2)
def stages(name: str, place: int) -> tuple[Told, ...]:
    """Every step that the answers of one drawn instance need, with its scalar relations and what it
    gives.
    """
    return tuple(stages_of(drawn(name)[place]))


def stages_of(solution: Solution) -> Iterator[Told]:
    case = Case(solution, "en")
    chosen = select_steps(solution.motion, collect_needs(case, solution.template.asks.values()))
    levels: tuple[Level, Level] = ("velocity", "acceleration")
    for level, steps in zip(levels, chosen, strict=True):
        known: set[str] = set()
        for step in steps:
            yield find_stage(step, case, level, known), select_scalars(step, case), step.unknowns
            known |= set(step.unknowns)


def all_stages(name: str) -> Iterator[Told]:
    return (told for place in range(len(drawn(name))) for told in stages(name, place))


def every_telling(name: str) -> Iterator[tuple[Block, ...]]:
    """The solutions of a template: two instances, both languages, and each method where it makes a
    difference.
    """
    yield from (kept(name, place) for place in range(len(drawn(name))))
    yield kept(name, language="zh")
    if any(find_coupler(stage) for stage, _, _ in stages(name, 0)):
        yield from (kept(name, 0, method) for method in METHODS if method != "base-point")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_each_answer_of_the_key_stands_in_one_box(name: str) -> None:
    for place, solution in enumerate(drawn(name)):
        finite = [answer for answer in solution.answers.values() if not answer.at_infinity]
        boxes = (box for box in boxed(kept(name, place)) if box != r"\infty")
        found = [read_formula(read_math(box, "worked"), know_nothing) for box in boxes]
        assert len(found) == len(finite)
        right = sorted(map(measure_in_si, finite))
        for value, number in zip(sorted(found, key=lambda one: one.value), right, strict=True):
            assert value.value == pytest.approx(number, abs=value.room + 1e-12)


def know_nothing(symbol: str) -> Amount:
    raise Unreadable(symbol)


def measure_in_si(answer: Quantity) -> float:
    """The value of an answer, angles in radians, rotational speeds in turns."""
    factor = radians(1) if answer.measure.degrees else Floats().scale(answer.measure.scale)
    turns = 2 * pi if answer.measure.counts_turns else 1.0
    return float(answer.decimal(12)) * factor / turns


@lru_cache(maxsize=2000)
def typeset(latex: str) -> None:
    write_typst_math(latex, "worked")


@lru_cache(maxsize=2000)
def set_in_prose(text: str) -> None:
    assert not re.search(r"<\w+>", text)
    write_prose(text, "worked", ENGLISH)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_formula_and_sentence_can_be_typeset(name: str) -> None:
    for blocks in every_telling(name):
        formulas, texts = tuple(mathematics(blocks)), tuple(proses(blocks))
        assert formulas
        assert texts
        for latex in formulas:
            typeset(latex)
        for text in texts:
            set_in_prose(text)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_what_is_printed_between_the_signs_of_equality_is_equal(name: str) -> None:
    for blocks in every_telling(name):
        _, wrong = disagreements(blocks)
        assert not wrong


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_nothing_superfluous_is_printed(name: str) -> None:
    """No product with zero, no sign before a bracketed negative number alone, no number said to be
    itself.
    """
    for blocks in every_telling(name):
        for line in displayed(blocks):
            assert not re.search(r"(?<![\d.])0(?:\\cdot|\\cos|\\,\\(?!unit|mathrm))", line)
            assert not re.search(r"[-+]\(-[\d.]+\)(?:\\cos|$)", line)
            assert not re.search(r"(?:^|= )([-\d.]+) = \1(?:$|\\,)", line)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_symbol_is_its_own_opposite(name: str) -> None:
    for blocks in every_telling(name):
        for left, parts in chains(blocks):
            assert f"-{left}" not in parts
            assert (
                rf"-\left|{left}\right|" not in parts
                or part_value(parts[-1].partition(r"\,\unit")[0]) < 0
            )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_nothing_is_told_twice(name: str) -> None:
    lines = [line for line in displayed(kept(name)) if not line.startswith("&") and "/s" in line]
    assert len(lines) == len(set(lines))


def test_a_centrode_is_told_at_angles_that_no_exact_field_holds() -> None:
    template = load_template("rod-ground-incline-fixed-centrode")
    solution = solve_template(template, {"l": "1", "theta": "20", "gamma": "100"}, ["rho"])
    assert not solution.arithmetic.exact
    (radius,) = boxed(write_worked_solution(solution, ["rho"], "en").blocks)
    assert read_formula(read_math(radius, "worked"), know_nothing).value == pytest.approx(
        1 / sin(radians(100)), abs=5e-4
    )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_both_sides_of_every_vector_equation_agree(name: str) -> None:
    for stage, _, _ in all_stages(name):
        for equation in stage.equations:
            rest = add_vectors(part.value for part in equation.left) - add_vectors(
                part.value for part in equation.right
            )
            assert abs(float(rest.x)) < CLOSE
            assert abs(float(rest.y)) < CLOSE


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_projected_equation_holds_with_the_cosines_that_are_printed(name: str) -> None:
    for stage, scalars, unknowns in all_stages(name):
        for deduction in find_deductions(stage.equations, scalars, unknowns):
            for projection in deduction.projections:
                left, right = (
                    sum(amount(share, stage) for share in side)
                    for side in (projection.left, projection.right)
                )
                assert left == pytest.approx(right, abs=TIDY * scale_of(projection))


def amount(share: Share, stage: Stage) -> float:
    """A share with its sign: an unknown one by its algebraic value along its positive sense."""
    part = share.part
    if part.unknown and part.term:
        size = float(measure_along_direction(part.term, stage.case, stage.level))
    else:
        size = hypot(float(part.value.x), float(part.value.y))
    return share.sign * size * cos(radians(share.angle))


def scale_of(projection: Projection) -> float:
    return 1 + max(
        hypot(float(part.value.x), float(part.value.y)) for part in projection.equation.parts
    )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_the_deductions_of_a_step_determine_each_of_its_unknowns_once(name: str) -> None:
    for stage, scalars, unknowns in all_stages(name):
        if not stage.equations:
            continue
        given = list(find_deductions(stage.equations, scalars, unknowns))
        assert sorted(rate for deduction in given for rate in deduction.unknowns) == sorted(
            unknowns
        )
        solved: set[str] = set()
        for deduction in given:
            rows = [projection.row() for projection in deduction.projections]
            rows += [
                {rate: float(factor) for rate, factor in scalar.turning}
                for scalar in deduction.scalars
            ]
            matrix = np.array([[row.get(rate, 0.0) for rate in deduction.unknowns] for row in rows])
            assert np.linalg.matrix_rank(matrix, tol=CLOSE) == len(deduction.unknowns)
            left_out = {rate for row in rows for rate, factor in row.items() if abs(factor) > TIDY}
            assert left_out & set(unknowns) <= solved | set(deduction.unknowns)
            solved |= set(deduction.unknowns)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_without_any_one_step_of_the_plan_there_is_no_solution(name: str) -> None:
    solution = drawn(name)[0]
    needs = collect_needs(Case(solution, "en"), solution.template.asks.values())
    for step in {step for steps in select_steps(solution.motion, needs) for step in steps}:
        steps = tuple(other for other in solution.motion.plan.steps if other != step)
        with pytest.raises(
            MechanismError, match="the plan does not give .*, which the answers need - solve the "
        ):
            select_steps(replace(solution.motion, plan=Plan(steps)), needs)


def test_a_vector_equation_has_its_table_and_its_pictures() -> None:
    blocks = told(solve_template(load_template("slider-crank"), {}))
    step = next(
        place for place, block in enumerate(blocks) if block == Heading("$AB$: base point $A$", 2)
    )
    pictures = next(block for block in blocks[step:] if isinstance(block, Pictures))
    assert [picture.caption for picture in pictures.pictures] == [
        "velocities, dashed: sought",
        "velocity polygon, 1 mm corresponds to 0.05 m/s",
    ]


@pytest.mark.parametrize(
    ("method", "title"),
    [
        ("base-point", "$AB$: base point $A$"),
        ("projection", "$AB$: velocity projection theorem"),
        ("pole", "$AB$: velocity pole"),
    ],
)
def test_the_method_is_chosen_by_whoever_sets_the_exam(method: Method, title: str) -> None:
    solution = solve_template(load_template("slider-crank"), {"phi": "30"})
    blocks = told(solution, method)
    assert Heading(title, 2) in blocks
    equations = displayed(blocks)
    speeds = {line for line in equations if line.startswith("v_{B} &=") and "unit" in line}
    assert len(speeds) == 1
    assert any(line.startswith(r"\omega_{AB} &=") for line in equations), equations


def test_the_author_of_a_template_chooses_the_method() -> None:
    text = load_template("slider-crank").file.text
    template = read_template("crank", f'method = "pole"\n{text}')
    assert Heading("$AB$: velocity pole", 2) in told(solve_template(template, {}))
    with pytest.raises(
        TemplateError, match='method: "guess" - expected base-point, projection or pole'
    ):
        read_template("crank", f'method = "guess"\n{text}')


def test_a_rod_in_instantaneous_translation_has_its_pole_at_infinity() -> None:
    blocks = told(solve_template(load_template("slider-crank"), {"phi": "90"}))
    assert "at infinity" in "\n".join(proses(blocks))


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_senses_in_words_agree_with_signs(name: str) -> None:
    asks = load_template(name).asks.values()
    clockwise = tuple(f"{ask.symbol} &=" for ask in asks if ask.sign == "cw")
    for place in range(len(drawn(name))):
        for line in displayed(kept(name, place)):
            # a given speed on a circle is told by its size, and an answer as the box counts it
            sized = line.startswith((r"\left|", "v_", "a_", *clockwise))
            if line.endswith(r"\text{(clockwise)}") and not sized:
                value = re.split(r"=|\\approx", line)[-1]
                assert value.strip().startswith("-")


def test_certified_values_are_told_like_exact_ones() -> None:
    """An angle of 37 degrees leaves every small field: what vanishes then vanishes to within
    rounding only.
    """
    template = load_template("extended-rod-driving-rocker")
    blocks = told(solve_template(template, {"phi": "37", "delta": "53"}))
    assert boxed(blocks)
    assert [line for line in displayed(blocks)[-8:] if "\\sqrt" in line] == []


def lines_of(name: str, method: Method | None = None) -> list[str]:
    blocks = write_worked_solution(
        solve_template(load_template(name), {}), load_template(name).asked(), "en", method
    ).blocks
    return displayed(blocks)


def test_a_reversed_given_that_no_field_holds_is_told_as_stated() -> None:
    # 35 degrees below the line: the statement says 35, the values are enclosures
    values = {"a": "24", "phi": "-35", "n": "105"}
    solution = solve_template(load_template("geneva-drive"), values)
    assert r"\cos\varphi" in " ".join(displayed(told(solution)))


def test_a_point_whose_motion_a_step_takes_as_known_is_told_before() -> None:
    lines = lines_of("rolling-wheel-pin-slotted-rocker")
    sizes = [line for line in lines if line.startswith("v_{B} &=")]
    assert sizes == [
        tidy(
            r"v_{B} &= \sqrt{v_{B,OB}^{2}+v_{B,\perp OB}^{2}} = \sqrt{(-0.1732\,\unit{m/s})^{2} + "
            r"(0.3\,\unit{m/s})^{2}} \approx 0.3464\,\unit{m/s}"
        )
    ]


def test_the_sense_in_which_a_driver_counts_is_kept() -> None:
    # The wheel is driven to the left, which counts positive
    lines = lines_of("rolling-wheel-pin-slotted-rocker")
    rolling = r"\omega_{1} &= \frac{v_{O}}{R} = \frac{0.2\,\unit{m/s}}{0.5\,\unit{m}} = "
    assert any(line.startswith(rolling) for line in lines), lines


def test_a_known_vector_told_negative_stands_between_bars() -> None:
    lines = lines_of("stone-crusher", "base-point")
    assert any(r"\approx -1.0660\,\unit{m/s}" in line for line in lines), lines
    assert any(r"\left|v_{G}\right|\sin" in line for line in lines), lines


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("flat-faced-follower-eccentric-circle", "So $C$ serves as the moving point."),
        (
            "five-bar-two-driven-cranks",
            "$C$ from the base point $A$ of $AC$ and $B$ from the base point $C$ of $BC$.",
        ),
        (
            "guided-rack-and-gear",
            r"Here $\boldsymbol{v}_{\mathrm{a}} = 0$, "
            r"$\boldsymbol{v}_{\mathrm{e}} = \boldsymbol{v}_{A} + ",
        ),
        ("planetary-gear-external-rim-velocities", "rolling without slipping on a fixed circle"),
    ],
)
def test_what_a_teacher_would_say(name: str, sentence: str) -> None:
    assert sentence in "\n".join(proses(kept(name)))
