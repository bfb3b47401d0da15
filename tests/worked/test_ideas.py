"""The idea before the steps: what is known and sought, and why the point or frame is chosen."""

from __future__ import annotations

import re
from collections.abc import Sequence

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import METHODS, Method
from kinegrade.sign_conventions import UNSIGNED
from kinegrade.worked.document import Block, Heading, Prose
from kinegrade.worked.solution import write_worked_solution
from tests.problem.draws import draw_filter, drawn
from tests.worked.draws import kept
from tests.worked.telling import lines, proses

ALIKE = "The accelerations follow in the same way; "
IDLE = "The method asked for changes nothing here"
TITLES = {"pole": ": velocity pole", "projection": ": velocity projection theorem"}
USUAL = "The method asked for is the one by which this solution goes anyway."


def read_idea(name: str, method: Method | None = None) -> str:
    """The first paragraph below the heading, at the published values."""
    solution = solve_template(load_template(name), {})
    asked = load_template(name).asked()
    blocks = write_worked_solution(solution, asked, "en", method).blocks
    said = blocks[blocks.index(Heading("The idea", 1)) + 1]
    return said.text if isinstance(said, Prose) else ""


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_solution_says_what_is_sought_before_all_else(name: str) -> None:
    first, said, *_ = kept(name)
    assert first == Heading("The idea", 1)
    assert isinstance(said, Prose)
    text = re.sub(r"\\left\|(.*?)\\right\|", r"\1", said.text)  # the size of what may be negative
    symbols = {ask.symbol for ask in load_template(name).asks.values()}
    assert [symbol for symbol in symbols if f"${symbol}$" not in text] == []


@pytest.mark.sampled(12, also=("belt-driven-bicycle",))
@pytest.mark.parametrize("name", find_template_names())
def test_the_size_alone_is_sought_of_what_has_no_sense(name: str) -> None:
    template = load_template(name)
    signed = {ask.symbol for ask in template.asks.values() if ask.sign not in UNSIGNED}
    for one in drawn(draw_filter(template, "sizes"), 4):
        said = write_worked_solution(one.solution, template.asked(), "en").blocks[1]
        assert isinstance(said, Prose)
        sized = set(re.findall(r"\\left\|(.*?)\\right\|", said.text))
        assert sized & signed == set()


@pytest.mark.parametrize(
    ("method", "reason"),
    [
        (
            "base-point",
            "$A$ and $B$ are points of $AB$; the velocity of $A$ can be found and that of $B$ has "
            "a known direction, so $A$ serves as base point.",
        ),
        (
            "projection",
            "$A$ and $B$ are points of $AB$; the velocity of $A$ can be found and that of $B$ has "
            "a known direction. Their projections on $AB$ are equal, and this gives the velocity "
            "of $B$ alone.",
        ),
        (
            "pole",
            "The velocities of the points $A$ and $B$ of $AB$ have known directions, and the "
            "normals to them lead to its pole.",
        ),
    ],
)
def test_the_reason_is_that_of_the_method(method: Method, reason: str) -> None:
    assert read_idea("slider-crank", method) == (
        r"Known: the rotation of $OA$. Sought: $v_{B}$ (speed of slider $B$), $\omega_{AB}$ "
        r"(angular velocity of the rod $AB$), $\alpha_{AB}$ (angular acceleration of the rod $AB$) "
        r"and $a_{B}$ (acceleration of slider $B$ along the $x$ axis). " + reason
    )


def test_a_symbol_without_words_in_the_language_stands_alone() -> None:
    # the author has no words in German
    said = kept("slotted-bar-between-two-rods", language="de")[1]
    assert isinstance(said, Prose)
    assert r"$\omega_{AE}$, $v_{\mathrm{r}}$" in said.text


def test_what_rolls_on_a_moving_body_is_linked_as_seen_from_there() -> None:
    # the centre of the gear is fixed: it moves as seen from the rack alone
    assert read_idea("guided-rack-and-gear").endswith(
        "The gear rolls without slipping on the rack, which links its rotation and the motion of "
        "its centre $O$, both seen from the rack."
    )


def test_a_moving_frame_has_its_reason() -> None:
    idea = read_idea("pin-in-disc-slot-and-rod")
    assert (
        "Seen from the disc and the rod, $M$ moves along a straight line each time, so the "
        "relative velocities and accelerations lie along these lines; its velocity"
    ) in idea


def test_a_problem_of_positions_names_its_way() -> None:
    assert read_idea("pose-four-bar-coupler").endswith(
        "First come the coordinates of the points; what else is asked follows from them."
    )


def test_coordinates_alone_lead_to_nothing_else() -> None:
    """What else was asked followed from them, where nothing was."""
    solution = solve_template(load_template("pose-cam-tappet"), {}, ["y_A"])
    blocks = write_worked_solution(solution, ["y_A"], "en").blocks
    idea = next(text for text in proses(blocks) if "Sought: " in text)
    assert idea.endswith("point by point, from the distances and lines that place each.")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_method_asked_for_changes_the_solution_or_it_says_why_not(name: str) -> None:
    plain = kept(name)
    for method in METHODS:
        blocks = kept(name, 0, method)
        said = _read_note(blocks)
        assert bool(said) == (blocks[bool(said) :] == plain), method


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
@pytest.mark.parametrize("method", TITLES)
def test_a_method_asked_for_is_taken_in_some_step_or_applies_to_none(
    name: str, method: Method
) -> None:
    blocks = kept(name, 0, method)
    titles = [block.text for block in blocks if isinstance(block, Heading) and block.level == 2]
    taken = any(TITLES[method] in title for title in titles)
    assert taken != (_read_note(blocks) == IDLE)


def _read_note(blocks: Sequence[Block]) -> str:
    """Which of the notes a solution begins with, nothing where it has none."""
    text = blocks[0].text if isinstance(blocks[0], Prose) else ""
    return next((note for note in (IDLE, USUAL) if text.startswith(note)), "")


@pytest.mark.parametrize(
    ("name", "method", "note"),
    [
        ("pin-in-disc-slot-and-rod", "pole", IDLE),
        ("slider-crank", "base-point", USUAL),
        ("slider-crank", "pole", ""),
    ],
)
def test_a_method_that_changes_nothing_has_its_reason(name: str, method: Method, note: str) -> None:
    assert _read_note(kept(name, 0, method)) == note


@pytest.mark.parametrize(
    ("name", "method", "alike"),
    [
        ("slider-crank", "base-point", True),
        ("slider-crank", "pole", False),  # accelerations go by the base point
        ("stone-crusher", None, False),  # a pole gives the velocities
        ("crank-rocker-towed-wheel", None, True),  # velocities of two bodies, accelerations of one
        ("crossed-belt-drive", None, False),  # no step finds a vector
    ],
)
def test_accelerations_follow_alike_only_where_their_steps_are_those_of_velocities(
    name: str, method: Method | None, alike: bool
) -> None:
    asked = load_template(name).asked()
    blocks = write_worked_solution(solve_template(load_template(name), {}), asked, "en", method)
    assert (ALIKE in "\n".join(proses(blocks.blocks))) == alike


def test_a_belt_says_what_links_the_rotations() -> None:
    # the idea said what is known and sought, and nothing of why it can be found
    link = (
        "Seen from the arm $OA$, the rims of pulleys joined by a belt have equal speeds, which "
        "links the rotations."
    )
    assert read_idea("crossed-belt-drive").count(link) == 1


def test_a_point_of_two_rods_is_the_idea_where_base_points_meet_in_it() -> None:
    reason = (
        "$C$ is a point of the rod $BC$ and the rod $AC$; from the base points $B$ and $A$ it has "
        "the same velocity, and this equation links the unknown magnitudes."
    )
    assert reason in read_idea("two-rods-driven-ends")


def test_base_points_one_after_the_other_are_the_idea_where_bodies_are_joined() -> None:
    assert read_idea("five-bar-two-driven-cranks").endswith(
        "$AC$ and $BC$ lead from one point of known velocity to another; base points one after the "
        "other link their rotations."
    )


def test_a_pole_that_no_normals_lead_to_has_its_way_in_the_idea() -> None:
    assert read_idea("guide-tube-rod-fixed-centrode").endswith(
        "From these follows the velocity pole of $BC$."
    )


def test_a_wheel_that_its_pole_has_solved_takes_its_accelerations_from_a_base_point() -> None:
    assert (
        "The velocity pole has an acceleration of its own; accelerations are therefore found from "
        "a base point whose acceleration is known."
    ) in proses(kept("wheel-on-circular-track"))


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_every_solution_of_a_mechanism_says_more_than_what_is_sought(name: str) -> None:
    # the robot arm said what is known and sought, and no way from the one to the other
    said = kept(name)[1]
    assert isinstance(said, Prose)
    assert ". " in said.text.partition("Sought: ")[2]


def test_a_driver_between_two_moving_bodies_is_known_and_links_their_rotations() -> None:
    idea = read_idea("two-link-robot-arm")
    assert idea.startswith("Known: the rotation of $OA$ and the rotation of $AB$ relative to $OA$.")
    assert idea.endswith(
        "The angular velocities of $AB$ and $OA$ differ by the given relative one, and the "
        "velocities of points of $AB$ follow from the base point $A$."
    )


def test_a_driver_that_a_step_finds_with_other_relations_is_known_too() -> None:
    assert read_idea("slider-crank-relative-rotation-driver").startswith(
        "Known: the rotation of $AB$ relative to $OA$."
    )


def test_two_frames_one_on_the_other_have_their_reason() -> None:
    assert read_idea("bent-rod-two-sleeves").endswith(
        "Seen from $AE$, $M$ moves along a straight line, and so does the fixed point $B$ seen "
        "from $CMD$, so the relative velocities and accelerations lie along these lines; the two "
        "compositions follow one another."
    )


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_the_base_points_of_the_idea_are_those_of_the_steps(name: str) -> None:
    said = kept(name)[1]
    titles = " ".join(block.text for block in kept(name) if isinstance(block, Heading))
    assert isinstance(said, Prose)
    for point in re.findall(r"so \$(.*?)\$ serves as base point", said.text):
        assert f"base point ${point}$" in titles


def test_the_base_point_is_the_one_whose_velocity_is_known() -> None:
    """Though the chain of AB begins at B, which CB carries."""
    said = read_idea("toggle-press")
    assert "the velocity of $A$ is given and that of $B$ has a known direction" in said
    assert "so $A$ serves as base point." in said


def test_what_rolls_on_two_bodies_is_told_once() -> None:
    said = read_idea("stepped-drum-on-two-ropes")
    assert said.count("do not slip on the drum, and their motions are known") == 1


def test_a_path_beside_the_line_that_gives_it_is_parallel_to_it() -> None:
    """The centre of the roller moves at the distance q from the flank."""
    said = read_idea("tangent-cam-with-roller")
    assert (
        "$C$ moves along a straight line parallel to $FE$, so its relative velocity and "
        "acceleration lie along it"
    ) in said


def test_on_a_circle_the_relative_velocity_alone_is_along_the_path() -> None:
    said = read_idea("eccentric-cam-offset-follower")
    assert "a circle about $C$, so its relative velocity is tangent to it" in said


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_the_way_is_told_in_words_with_letters_of_points_alone(name: str) -> None:
    """v_r, a_Cor, O' stood there, which the steps explain; what eliminates what is told there."""
    template, said = load_template(name), read_idea(name)
    for ask in template.asks.values():
        said = said.replace(f"${ask.symbol}$", "")
    known = find_points(template.words.statement.in_language("en")) | {*template.figure.labels}
    way = said.rpartition(")")[2] if ")" in said else said.partition("Sought: ")[2]
    assert way.count(". ") <= 3
    assert not re.search(r"\\(boldsymbol|mathrm|omega|alpha)|[va]_", way)
    assert find_points(way) <= known


def find_points(text: str) -> set[str]:
    """The letters of points in the formulas of a text."""
    formulas = re.findall(r"\$(.*?)\$", text)
    plain = [one.replace("{", "").replace("}", "") for one in formulas]
    return {letter for one in plain for letter in re.findall(r"[A-Z](?:_\d)?'?", one)}


def test_a_point_on_a_circle_about_a_fixed_axis_takes_no_base_point() -> None:
    # it was said of the rod between two wheels on a cylinder, whose pole is the cylinder's centre
    solution = solve_template(load_template("two-wheels-on-cylinder"), {})
    asked = solution.template.asked()
    told = "\n".join(lines(write_worked_solution(solution, asked, "en").blocks))
    assert "a_{B}^{\\mathrm{n}}" in told
    assert "acceleration of its own" not in told
