"""A coordinate that nothing takes up is left out of a finished solution."""

from __future__ import annotations

import pytest

from kinegrade.language.math.reading import read_math
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.economy import leave_out_unused
from kinegrade.worked.solution import write_worked_solution
from tests.worked.telling import displayed, lines, read_display

PLACE = Prose("$S$ lies here:")
FOUND = read_display([r"x_{S} &= 2\,\unit{m}", r"y_{S} &= 3\,\unit{m}"])


def reread(*blocks: Block, told: str = "") -> list[str]:
    return list(lines(leave_out_unused(blocks, [read_math(told, "test")])))


def test_a_coordinate_goes_unless_a_later_line_names_it() -> None:
    used = read_display([r"SB &= y_{S} - 1\,\unit{m}"])
    assert reread(PLACE, FOUND, used)[1:-1] == [r"    y_{S} &= 3\,\unit{m}"]


def test_a_coordinate_stays_whose_number_a_check_takes() -> None:
    side = read_math(r"-2\,\unit{m}", "test")
    check = Prose(r"Check: left side $-2\,\unit{m}$, right side $-2\,\unit{m}$.", (side,))
    assert reread(PLACE, FOUND, check)[1:-1] == [r"    x_{S} &= 2\,\unit{m}"]


def test_a_number_that_only_ends_alike_does_not_keep_a_coordinate() -> None:
    check = Prose(r"Left side $12\,\unit{m}$.", (read_math(r"12\,\unit{m}", "test"),))
    assert reread(PLACE, FOUND, check)[:-1] == []


def test_a_coordinate_stays_that_is_zero_an_answer_or_named_by_a_sentence() -> None:
    boxed = read_display([r"x_{S} &= \boxed{2\,\unit{m}}", r"y_{S} &= 0"])
    assert displayed(leave_out_unused((PLACE, boxed), [])) == displayed((boxed,))
    assert reread(PLACE, FOUND, told="x_{S}")[1:] == [r"    x_{S} &= 2\,\unit{m}"]


def test_a_sentence_that_leads_to_nothing_goes_too() -> None:
    assert reread(PLACE, FOUND) == []


def test_an_equation_of_a_coordinate_goes_with_it_and_leaves_the_sentence_of_the_other() -> None:
    circle = read_display([r"(x_{S} - 1\,\unit{m})^{2} + y_{S}^{2} &= 9\,\unit{m^2}"])
    level = read_display([r"y_{S} &= 0", r"x_{S} &= 4\,\unit{m}"])
    assert reread(PLACE, circle, level) == [PLACE.text, "    y_{S} &= 0"]
    assert len(reread(PLACE, circle, level, told="x_{S}")) == 4


def test_a_line_that_goes_on_goes_with_its_equation() -> None:
    long = Display(tuple(read_math(one, "test") for one in (r"x_{S} &= 1 + 1", r"&= 2\,\unit{m}")))
    assert reread(Prose("Here."), long) == ["Here."]


@pytest.mark.parametrize(
    ("name", "unused"),
    [
        ("crank-bar-through-sleeve-with-arm", ("x_{D} &=", "y_{D} &=")),
        ("two-wheels-on-cylinder", ("x_{B} &=",)),
    ],
)
def test_shipped_solutions_find_no_coordinate_for_nothing(
    name: str, unused: tuple[str, ...]
) -> None:
    template = load_template(name)
    blocks = write_worked_solution(solve_template(template, {}), template.asked(), "en").blocks
    assert not [line for line in displayed(blocks) if line.startswith(unused)]


def test_a_projection_of_many_vectors_is_not_written_twice_in_symbols() -> None:
    template = load_template("pin-in-two-rings")
    blocks = write_worked_solution(solve_template(template, {}), template.asked(), "en").blocks
    (solved,) = (
        line for line in displayed(blocks) if line.startswith(r"a_{\mathrm{r}1}^{\mathrm{t}} &=")
    )
    assert r"a_{\mathrm{e}1}" not in solved
