"""What letters stand for is said where there are letters of vectors, and as far as it holds."""

from __future__ import annotations

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Block, Heading, TermTable
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import kept
from tests.worked.telling import proses

LETTERS = "A vector's letter stands for its component in the direction given in its first"


def test_a_solution_without_vectors_says_nothing_of_their_letters() -> None:
    """It spoke of unknown vectors in a train of gears, and of angles from the x axis."""
    blocks = kept("differential-epicyclic-train")
    assert [block for block in blocks if isinstance(block, TermTable)] == []
    texts = tuple(proses(blocks))
    assert [text for text in texts if LETTERS in text] == []
    assert any(text.startswith("Rotations are positive") for text in texts), texts


def test_letters_and_the_sign_of_a_turn_are_explained_before_the_first_table() -> None:
    blocks = kept("rotary-engine")
    (place,) = (at for at, text in enumerate(map(str, blocks)) if LETTERS in text)
    assert isinstance(blocks[place - 1], Heading)
    assert place < next(at for at, one in enumerate(blocks) if isinstance(one, TermTable))
    (legend,) = (text for text in proses(blocks) if LETTERS in text)
    turned = (
        r"$\perp$ with $\curvearrowleft$: turned through $90^\circ$ counter-clockwise from what"
    )
    assert turned in legend


def test_arrows_clockwise_are_explained_where_a_table_has_one() -> None:
    both = (
        r"$\perp$ with $\curvearrowleft$ or $\curvearrowright$: turned through $90^\circ$ "
        "counter-clockwise or clockwise from what is named"
    )
    explained = {
        name: any(both in text for text in proses(kept(name)))
        for name in ("rotary-engine", "five-bar-two-driven-cranks")
    }
    assert explained == {"rotary-engine": False, "five-bar-two-driven-cranks": True}


def test_how_gears_mesh_says_in_which_sense_they_turn() -> None:
    """Two equations had the same words and opposite signs."""
    said = [
        text for text in proses(kept("differential-epicyclic-train")) if "mesh the gears" in text
    ]
    assert [text.partition("; ")[2] for text in said] == [
        "in an external mesh the gears turn in opposite senses:",
        "in an internal mesh the gears turn in the same sense:",
    ]


def _find_kinds(name: str, *asks: str) -> str:
    solution = solve_template(load_template(name), {})
    blocks: tuple[Block, ...] = write_worked_solution(solution, asks, "en").blocks
    said = list(proses(blocks))
    return said[said.index("Types of motion") + 1]


def test_a_body_rolls_where_that_is_used() -> None:
    assert "the roller: plane motion." in _find_kinds("tangent-cam-with-roller", "v_C")
    assert "without slipping" in _find_kinds("tangent-cam-with-roller", "omega_C")


def test_a_slider_translates() -> None:
    """It was in the figure and the statement, and in no list of motions."""
    assert _find_kinds("slider-crank", "v_B").endswith("; slider $B$: translation.")
    both = _find_kinds("elliptic-trammel-crank-driven", "v_A")
    assert both.endswith("; sliders $A$, $B$: translation.")


def test_a_slider_that_is_a_body_is_told_once() -> None:
    assert "slider" not in _find_kinds("tangent-cam-with-roller", "v_C")
    assert "slider" not in _find_kinds("rod-ground-and-incline", "omega_AB")


def test_a_point_that_moves_is_no_body_of_a_kind() -> None:
    assert "$M$" not in _find_kinds("pin-in-disc-slot-and-rod", "v_M_x")
