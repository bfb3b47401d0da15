"""Graphs over the cycle at the end of worked solutions: each goes through its answer at the instant."""

from __future__ import annotations

import pytest

from kinegrade.cycles.chapter import require_graphs, write_cycle_chapter
from kinegrade.cycles.cycle import make_cycle
from kinegrade.errors import MechanismError, TemplateError
from kinegrade.exam.printing.pages import QuestionPlace
from kinegrade.exam.printing.solution_pages import work_question
from kinegrade.figure.scene import FIRM, Disc, Label, Outline
from kinegrade.language import ENGLISH, Language
from kinegrade.press.latex.solution import write_solution_body
from kinegrade.press.sheet import SolutionSheet
from kinegrade.press.typst.solution import SolutionLayouts
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Heading, Picture, Pictures, Prose


def solve(name: str) -> Solution:
    return solve_template(load_template(name), {})


def list_graphs(solution: Solution, asks: tuple[str, ...]) -> tuple[Picture, ...]:
    last = write_cycle_chapter(solution, asks, ENGLISH)[-1]
    assert isinstance(last, Pictures)
    return last.pictures


def find_curve(picture: Picture) -> list[tuple[float, float]]:
    """The corners of the curve, mm."""
    lines = [each for each in picture.scene.primitives if isinstance(each, Outline)]
    assert {each.pen for each in lines} == {FIRM}
    return [tuple(corner) for each in lines for corner in each.corners]


@pytest.mark.parametrize("name", ["slider-crank", "four-bar-parallel-coupler"])
def test_each_answer_has_a_graph_that_goes_through_the_dot_of_the_instant(name: str) -> None:
    solution = solve(name)
    asks = solution.template.asked()
    graphs = list_graphs(solution, asks)
    assert len(graphs) == len(asks)
    for picture in graphs:
        (dot,) = (each for each in picture.scene.primitives if isinstance(each, Disc))
        assert min(abs(x - dot.centre.x) for x, _ in find_curve(picture)) < 0.2
        gaps = [abs(x - dot.centre.x) + abs(y - dot.centre.y) for x, y in find_curve(picture)]
        assert min(gaps) < 0.5


def test_a_graph_is_as_high_as_its_values_are_large() -> None:
    """v_B of a slider-crank between 0 and 1.166 m/s, on an axis from 0 to 1.5."""
    solution = solve("slider-crank")
    (picture,) = list_graphs(solution, ("v_B",))
    (curve,) = make_cycle(solution, ("v_B",)).curves
    labels = [each for each in picture.scene.primitives if isinstance(each, Label)]
    middle = {each.symbol: each.centre for each in labels}
    unit = middle["1.5"].y - middle["0.5"].y
    highest = max(y for _, y in find_curve(picture))
    assert (highest - middle["0.0"].y) / unit == pytest.approx(curve.values.max(), abs=1e-3)


def test_what_grows_beyond_bounds_is_cut_off_and_that_is_said() -> None:
    solution = solve("four-bar-parallel-coupler")
    _, axis, said, _ = write_cycle_chapter(solution, ("v_C",), ENGLISH)
    assert axis == Prose(
        "Horizontal axis: rotation of $AB$ since the instant (°). The dot marks the instant of the "
        "question."
    )
    assert isinstance(said, Prose)
    assert "cut off" in said.text
    (picture,) = list_graphs(solution, ("v_C",))
    assert picture.caption == r"$v_{C}$ ($\unit{m/s}$)"
    highest_tick = max(label.centre.y for label in picture.scene.labels)
    assert max(y for _, y in find_curve(picture)) == pytest.approx(highest_tick)


def test_numbers_have_the_decimal_mark_of_the_language() -> None:
    *_, last = write_cycle_chapter(solve("slider-crank"), ("v_B",), Language("de"))
    assert isinstance(last, Pictures)
    labels = [each.symbol for each in last.pictures[0].scene.labels]
    assert "0{,}5" in labels


def test_what_does_not_move_has_no_graphs_and_is_refused_where_they_are_asked_for() -> None:
    solution = solve("pose-four-bar-coupler")
    asks = solution.template.asked()
    assert write_cycle_chapter(solution, asks, ENGLISH) == ()
    with pytest.raises(MechanismError, match="no driver moves the mechanism: it has no cycle"):
        require_graphs(solution, asks)


def test_an_answer_of_one_instant_has_no_graph() -> None:
    solution = solve("guide-tube-rod-fixed-centrode")
    assert write_cycle_chapter(solution, ("rho",), ENGLISH) == ()
    with pytest.raises(TemplateError, match='"rho" has no curve over the cycle'):
        require_graphs(solution, ("rho",))


def test_both_typesetters_print_them() -> None:
    solution = solve("slider-crank")
    question = work_question(QuestionPlace(1, "q1"), solution, ("v_B",), ENGLISH, cycle=True)
    assert Heading("Over the whole cycle", 1) in question.blocks
    sheet = SolutionSheet(ENGLISH, "C", "T", "", "", "", "", (question,))
    for source in (SolutionLayouts(sheet).write(), write_solution_body(sheet)):
        assert "Over the whole cycle" in source
        assert "360" in source
