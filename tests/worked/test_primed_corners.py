"""Every primed letter in a polygon of a worked solution is explained in its words."""

from __future__ import annotations

import re

import pytest

from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Pictures
from tests.worked.draws import kept
from tests.worked.telling import proses


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_primed_corners_of_polygons_are_explained(name: str) -> None:
    check_primed_letters(name)


def test_the_corner_of_one_frame_is_explained_beside_the_marked_point_of_another() -> None:
    """B' was explained, of the second frame, and m' of the first never."""
    check_primed_letters("bent-rod-two-sleeves")
    said = "In the polygon, $m'$ denotes the point fixed to $AE$ that coincides with $M$."
    assert list(proses(kept("bent-rod-two-sleeves"))).count(said) == 1


def check_primed_letters(name: str) -> None:
    """Each is the subject of a sentence, as it stands or as a capital."""
    blocks = kept(name)
    pictures = [one for block in blocks if isinstance(block, Pictures) for one in block.pictures]
    symbols = {label.symbol for one in pictures for label in one.scene.labels}
    told = " ".join(proses(blocks))
    for letter in (one for one in symbols if re.fullmatch(r"[a-z]'+", one)):
        assert f"${letter}$ denotes" in told or f"${letter.upper()}$ is the point" in told, letter


@pytest.mark.sampled(12, first=5)
@pytest.mark.parametrize("name", find_template_names())
def test_the_letters_of_polygons_are_explained_once(name: str) -> None:
    """The polygon had its o, a and b, and no line said what they mark."""
    blocks = kept(name)
    pictures = [one for block in blocks if isinstance(block, Pictures) for one in block.pictures]
    polygons = [one for one in pictures if one.kind == "polygon"]
    lettered = any(
        sum(bool(re.fullmatch(r"[a-z](_.*)?'*", label.symbol)) for label in one.scene.labels) > 1
        for one in polygons
    )
    told = " ".join(proses(blocks))
    said = [told.count(f"laid off from ${origin}$") for origin in "op"]
    assert (max(said) == 1, max(said) > 1) == (lettered, False)
