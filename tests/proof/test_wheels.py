"""`check` holds what a statement says of wheels that touch against the mechanism."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.translated import Translated
from kinegrade.proof.claims.claims import find_false_claims
from tests.said import all_said


def find(name: str, said: str) -> list[str]:
    """What is contradicted in another statement of a template that is shipped."""
    template = load_template(name)
    other = replace(template, words=replace(template.words, statement=Translated(plain=said)))
    return all_said(find_false_claims(other, [solve_template(other, {}, ())]))


@pytest.mark.parametrize(
    "said",
    [
        "it leaves it to the %s of $B$",
        "es verlässt sie %s vom Mittelpunkt $B$",
        "绳从 $B$ 的%s侧离开",
    ],
)
def test_a_rope_that_leaves_on_the_other_side_is_a_fault(said: str) -> None:
    sides = {"it": ("right", "left"), "es": ("rechts", "links"), "绳从": ("右", "左")}
    found = [find("hoist-with-gears", said % side) for side in sides[said.split(maxsplit=1)[0]]]
    assert sorted(map(len, found)) == [0, 1]
    assert "the points of the mechanism lie otherwise" in "".join(*filter(None, found))


@pytest.mark.parametrize(
    ("said", "wrong"),
    [
        ("The planet meshes externally with S and externally with R", True),
        ("Planet und Sonne im Außeneingriff, Planet und R im Außeneingriff", True),
        ("行星轮与太阳轮外啮合，与齿圈外啮合", True),
        ("行星轮与太阳轮外啮合，与齿圈内啮合", False),
        ("externally with S and externally, as said; the ring R", False),
    ],
)
def test_gears_that_mesh_internally_and_are_said_to_do_externally_are_a_fault(
    said: str, wrong: bool
) -> None:
    assert (
        find("differential-epicyclic-train", said)
        == [
            "statement: it says 2 times that gears mesh externally, and 1 of them do: say "
            "of the others that they mesh internally"
        ]
        * wrong
    )
