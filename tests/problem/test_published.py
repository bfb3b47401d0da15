"""The published results of every template hold exactly, and answers agree with independently
computed ones.
"""

from __future__ import annotations

import json
from pathlib import Path
from random import Random
from typing import Any

import pytest
from mpmath import mpf

from kinegrade.errors import MechanismError
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import read_expression
from kinegrade.numbers.angle import Angle
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Published, Template
from kinegrade.proof.published import is_printed_decimal
from tests.laws.cases import shipped

INSTANCES = 6
REFERENCE = json.loads(
    (Path(__file__).parent.parent / "data" / "reference.json").read_text(encoding="utf-8")
)
ALL = [
    pytest.param(name, index, id=f"{name}-{index}")
    for name in find_template_names()
    for index in range(len(shipped(name).published))
]


def is_printed(name: str, index: int) -> bool:
    """Whether a published result is but decimals, which a book may have rounded."""
    return all(map(is_printed_decimal, shipped(name).published[index].texts.values()))


PRINTED = [one for one in ALL if is_printed(*one.values)]
PUBLISHED = [one for one in ALL if one not in PRINTED]


def instances(template: Template, published: Published) -> list[Solution]:
    """The template solved exactly at the published values, those left open drawn from their
    domains.
    """
    random, found = Random(published.source), []
    for _ in range(20 * INSTANCES):
        values = {
            name: random.choice(parameter.choices)
            for name, parameter in template.parameters.items()
        }
        try:
            solution = solve_template(template, {**values, **published.given}, published.gives)
        except MechanismError:
            continue
        found += [solution] if solution.arithmetic.exact else []
        if len(found) == INSTANCES:
            break
    return found


def difference(solution: Solution, name: str, published: Published) -> Any:
    """What the engine gives minus what the source gives, in one exact field; angles as a direction,
    (1, 0) for none.
    """
    field, ask = solution.arithmetic.fork(), solution.template.asks[name]
    quoted = {
        "pi": field.turns(1),
        **{key: given.number for key, given in solution.parameters.items()},
    }
    expected = evaluate(published.gives[name], quoted, make_elementary_functions(field), field)
    found = evaluate(
        read_expression(str(solution[name].exact)),
        {"pi": field.turns(1)},
        make_elementary_functions(field),
        field,
    )
    if isinstance(expected, Angle):
        found = (
            found
            if isinstance(found, Angle)
            else field.turns(found / 180 if ask.unit.degrees else found)
        )
        cosine, sine = (found - expected).direction(field)
        return sine if field.sign(cosine) > 0 else cosine
    return found - expected


@pytest.mark.parametrize(("name", "index"), PUBLISHED)
def test_published_results_hold_with_zero_difference_in_the_field(name: str, index: int) -> None:
    template = load_template(name)
    published = template.published[index]
    solved = instances(template, published)
    assert solved, "no instance of the published result is exact"
    for solution in solved:
        for ask in published.gives:
            answer = solution[ask]
            assert answer.is_exact
            # An arctangent in degrees: its value over pi has no field
            if "180*" in str(answer.exact):
                degrees = evaluate(
                    published.gives[ask],
                    {
                        "pi": solution.arithmetic.turns(1),
                        **{key: given.number for key, given in solution.parameters.items()},
                    },
                    make_elementary_functions(solution.arithmetic),
                    solution.arithmetic,
                )
                assert (answer.number - degrees).direction(solution.arithmetic) == (1, 0)
            else:
                assert difference(solution, ask, published) == 0, (ask, dict(solution.parameters))


@pytest.mark.parametrize(("name", "index"), PRINTED)
def test_published_decimals_hold_to_half_a_unit_of_their_last_place(name: str, index: int) -> None:
    published = shipped(name).published[index]
    solution = solve_template(shipped(name), published.given, published.gives)
    for ask, text in published.texts.items():
        places = len(text.partition(".")[2])
        assert f"{solution[ask].value:.{places}f}" == text


def test_every_template_has_published_results() -> None:
    for name in find_template_names():
        assert load_template(name).published, name


def test_a_published_result_that_is_wrong_in_the_thirtieth_digit_is_seen() -> None:
    template = load_template("slider-crank")
    published = template.published[0]
    wrong = read_expression("(2*sqrt(3)/3 + 1e-30)*omega*r")
    solution = instances(template, published)[0]
    assert (
        difference(
            solution, "v_B", Published(published.source, published.given, {"v_B": wrong}, {})
        )
        != 0
    )


@pytest.mark.parametrize(
    ("name", "index"),
    [(name, index) for name in REFERENCE for index in range(len(REFERENCE[name]))],
)
def test_answers_agree_with_independently_computed_ones(name: str, index: int) -> None:
    entry = REFERENCE[name][index]
    solution = solve_template(load_template(name), entry["parameters"], entry["answers"])
    scale = max(abs(mpf(text)) for text in entry["answers"].values())
    for ask, text in entry["answers"].items():
        expected, found = mpf(text), mpf(solution[ask].decimal(20))
        assert abs(found - expected) <= mpf("1e-12") * max(abs(expected), scale * mpf("1e-3")), ask
