"""What a draw is predicted to cost: by hand for a crank, and by what makes a draw easier."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import pytest

from kinegrade.numbers.floats import Floats
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from kinegrade.students.difficulty import Difficulty
from kinegrade.students.mistaking.unnamed_slips import list_unnamed_slips
from tests.problem.crank import crank
from tests.problem.draws import draw_filter


def turning_crank() -> Template:
    """A crank at an angle: v_x = -omega r sin(h)."""
    return crank(
        (
            'h     = { unit = "m", draw = [0, "1/2", 3], means = { en = "height of A", '
            'zh = "A 的高度" } }',
            'h     = { unit = "deg", draw = [30, 40, 45, 50, 60], means = { en = "angle", '
            'zh = "角" } }',
        ),
        ("draw = [2, 1000000, 20000000]", "draw = [2, -2, 3, -3]"),
        ('P = "(0, h)"\n', ""),
        ('A = "meet(circle(O, r), line(P, 0), right)"', 'A = "polar(O, r, h)"'),
        ("-omega*h", "-omega*r*sin(h)"),
    )


def predicted(template: Template, *draws: dict[str, str], **points: int) -> list[float]:
    asked = {name: Fraction(count) for name, count in points.items()}
    separation = draw_filter(template, asks=tuple(points)).separation
    found: list[float] = Difficulty(separation, asked).predict(draws).tolist()
    return found


def crank_points(angle: str, omega: str) -> float:
    """What one mistake costs of the two points for v_x = -omega r sin(h)."""
    (found,) = predicted(turning_crank(), {"r": "1", "h": angle, "omega": omega}, v_x=2)
    return found


def test_a_sense_that_has_to_be_thought_of_is_harder() -> None:
    assert crank_points("30", "-2") < crank_points("30", "2") < 2


def test_where_sine_and_cosine_are_equal_a_known_mistake_and_a_slip_cost_nothing() -> None:
    """Each costs as much as a sense that is not thought of."""
    sense = crank_points("30", "2") - crank_points("30", "-2")
    easier = crank_points("30", "2") - crank_points("45", "2")
    assert easier == pytest.approx(2 * sense)


def test_points_weigh_the_asks() -> None:
    draw = {"r": "1", "h": "30", "omega": "2"}
    one, two, both = (
        predicted(turning_crank(), draw, **asked)[0]
        for asked in ({"v_x": 3}, {"v_y": 2}, {"v_x": 3, "v_y": 2})
    )
    assert both == pytest.approx(one + two)


def test_where_nothing_is_asked_all_draws_are_alike() -> None:
    assert Difficulty(None, {}).predict([{}, {}]).tolist() == [0, 0]
    assert Difficulty(None, {}).predict([]).tolist() == []


def test_a_given_is_misread_one_at_a_time() -> None:
    template = load_template("two-rods-driven-ends")
    values = {name: index + 2.0 for index, name in enumerate(template.parameters)}
    changed = [
        [name for name in values if slip.givens(template, values, Floats())[name] != values[name]]
        for slip in list_unnamed_slips(template)
    ]
    assert [names for names in changed if len(names) != 1] == []
    # Each velocity and acceleration reversed, forgotten, or the other one; the angle from the other
    # axis; each length for the other
    counted = Counter(name for (name,) in changed)
    rates = dict.fromkeys(("v_A", "v_B", "a_A", "a_B"), 3)
    assert counted == {"AC": 1, "BC": 1, "gamma": 1, **rates}


def test_a_given_that_is_zero_makes_a_draw_easier() -> None:
    template = load_template("slider-crank")
    still, speeding = (
        {"r": "0.2", "k": "2", "phi": "60", "omega": "5", "alpha": alpha} for alpha in ("0", "10")
    )
    easier, harder = predicted(template, still, speeding, a_B=4)
    assert easier < harder


def test_equal_lengths_make_a_draw_easier() -> None:
    template = load_template("two-rods-driven-ends")
    given = {"gamma": "60", "v_A": "0.4", "v_B": "0.6", "a_A": "1", "a_B": "2"}
    equal, unequal = ({"AC": length, "BC": "0.5", **given} for length in ("0.5", "0.8"))
    asks = dict.fromkeys(template.asked(), 1)
    easier, harder = predicted(template, equal, unequal, **asks)
    assert easier < harder
