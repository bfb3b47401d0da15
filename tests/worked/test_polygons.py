"""The polygon of a step follows the table above it, and is there where vectors are added."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

import pytest

from kinegrade.figure.scene import FIRM, THIN, Bow, Outline, Strokes
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Picture, Pictures, Prose, TermTable
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn, kept, stated, told

ROUND = 1.6  # radians: a longer arc is a rim


def list_drawings(blocks: Sequence[Block], caption: str) -> list[Picture]:
    """The pictures whose captions begin so."""
    shown = [
        picture for block in blocks if isinstance(block, Pictures) for picture in block.pictures
    ]
    return [picture for picture in shown if picture.caption.startswith(caption)]


def list_tables(blocks: Sequence[Block]) -> list[list[str]]:
    return [
        [write_row(term.symbol) for term in block.terms]
        for block in blocks
        if isinstance(block, TermTable)
    ]


def test_vectors_that_change_places_in_a_polygon_do_so_in_the_table() -> None:
    # a_B^n would lie on a_A^n, as the crank and the rocker are parallel
    table = list_tables(stated("bent-coupler-instant-translation"))[-1]
    assert table == [
        r"\boldsymbol{a}_{B}^{\mathrm{t}}",
        r"\boldsymbol{a}_{B}^{\mathrm{n}}",
        r"\boldsymbol{a}_{A}^{\mathrm{n}}",
        r"\boldsymbol{a}_{BA}^{\mathrm{t}}",
    ]


def test_a_point_of_two_bodies_has_one_acceleration_and_no_polygon() -> None:
    blocks = stated("planetary-gear-external-rim-accelerations")
    assert [block for block in blocks if isinstance(block, Pictures)] == []


def test_a_rotation_that_is_not_worked_out_is_in_no_picture() -> None:
    # BC and the ram are asked for; the rod AB turns, too
    solution = solve_template(load_template("toggle-press"), {})
    blocks = write_worked_solution(solution, ("omega_BC", "v_D"), "en").blocks
    first, second = list_drawings(blocks, "velocities")
    symbols = {label.symbol for picture in (first, second) for label in picture.scene.labels}
    assert r"\omega_{BC}" in symbols
    assert not {r"\omega_{AB}", r"\omega_{BD}"} & symbols


def test_vectors_too_short_to_draw_are_named_below_the_picture() -> None:
    blocks = stated("rolling-wheel-pin-slotted-rocker", phi="-3")
    (picture,) = list_drawings(blocks, "velocities")
    assert picture.caption == r"velocities, dashed: sought (too short to draw: $v_{\mathrm{e}}$)"


def test_a_vector_too_short_for_a_polygon_is_named_below_it() -> None:
    """The arrow beside it leads to the tip of their sum, and is labelled as that vector alone."""
    blocks = stated("rolling-wheel-pin-slotted-rocker", phi="-3")
    (picture,) = list_drawings(blocks, "acceleration polygon")
    short = r"$a_{\mathrm{e}}^{\mathrm{n}}$, $a_{\mathrm{r}}$ and $a_{\mathrm{Cor}}$"
    assert picture.caption.endswith(f" (too short to draw: {short})")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_each_vector_of_a_table_is_in_its_polygon_or_named_below_it(name: str) -> None:
    for table, drawings in pairwise(told(drawn(name)[0])):
        if isinstance(table, TermTable) and isinstance(drawings, Pictures):
            polygons = [one for one in drawings.pictures if "polygon" in one.caption]
            for picture in polygons if len(polygons) == 1 else ():
                # What is sought may turn out as zero
                found = (term for term in table.terms if "?" not in term.magnitude)
                symbols = {write_row(term.symbol) for term in found} - {"0"}
                plain = {re.sub(r"\\boldsymbol\{(\w)\}", r"\1", symbol) for symbol in symbols}
                labels = {label.symbol for label in picture.scene.labels}
                assert [one for one in plain - labels if f"${one}$" not in picture.caption] == []


def test_accelerations_have_a_polygon_and_no_sketch_that_would_say_it_again() -> None:
    blocks = stated("rolling-wheel-pin-slotted-rocker")
    shown = [len(block.pictures) for block in blocks if isinstance(block, Pictures)]
    assert shown == [2, 1]
    assert len(list_drawings(blocks, "acceleration polygon")) == 1


def test_a_pole_at_infinity_has_no_picture() -> None:
    """That the normals are parallel stands beside the step; they were drawn with two arrows."""
    pictures = [one.caption for one in list_drawings(stated("extended-rod-driving-rocker"), "")]
    assert [caption for caption in pictures if "pole" in caption] == []


def test_corners_of_two_frames_have_letters_of_their_own_and_are_explained_where_they_are() -> None:
    values = {"b": "0.18", "phi": "-26", "omega_1": "-6", "omega_2": "6"}
    letters = {"m'", "m''", "m"}
    for given, wanted in (({}, letters - {"m''"}), (values, letters)):
        blocks = stated("pin-in-disc-slot-and-rod", **given)
        (polygon,) = list_drawings(blocks, "velocity polygon")
        assert letters & {label.symbol for label in polygon.scene.labels} == wanted
        told = "".join(block.text for block in blocks if isinstance(block, Prose))
        assert ("$m''$ denotes" in told) == ("m''" in wanted)


def test_a_velocity_that_is_asked_is_in_the_picture_of_its_step() -> None:
    (velocities,) = list_drawings(stated("watt-linkage"), "velocities")
    assert "v_{P}" in {label.symbol for label in velocities.scene.labels}


def test_a_velocity_in_a_slot_has_a_thin_line_to_its_symbol_outside() -> None:
    values = {"l": "0.6", "theta": "35", "psi": "115", "omega": "-2", "v_B": "0.4"}
    blocks = stated("slotted-rocker-and-slider-two-drivers", **values)
    (velocities,) = list_drawings(blocks, "velocities")
    (label,) = (one for one in velocities.scene.labels if one.symbol == r"v_{\mathrm{r}}")
    strokes = (part for part in velocities.scene.primitives if isinstance(part, Strokes))
    ends = [line[0] - label.centre for part in strokes if part.pen == THIN for line in part.lines]
    beside = (label.width / 2 + 0.5, label.height / 2 + 0.5)
    assert any(abs(end.x) < beside[0] and abs(end.y) < beside[1] for end in ends), ends


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_the_caption_says_what_an_outline_in_a_polygon_is(name: str) -> None:
    """It looked like an arrow of another kind."""
    for polygon in list_drawings(kept(name), "velocity polygon"):
        outlines = (one for one in polygon.scene.primitives if isinstance(one, Outline))
        hollow = any(one.fill == "none" for one in outlines)
        assert ("outline" in polygon.caption) == hollow


@pytest.mark.sampled(12, first=4)
@pytest.mark.parametrize("name", find_template_names())
def test_all_that_is_sought_is_dashed(name: str) -> None:
    """Angular velocities were solid, under "dashed: sought"."""
    for picture in list_drawings(kept(name), "velocities, dashed: sought"):
        bows = [one for one in picture.scene.primitives if isinstance(one, Bow)]
        assert FIRM not in {one.pen for one in bows if abs(one.sweep) < ROUND}
