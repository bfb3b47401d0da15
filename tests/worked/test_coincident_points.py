"""Points of different bodies that coincide have different letters, in checks as in equations."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Block
from tests.worked.draws import drawn, kept
from tests.worked.telling import displayed, proses

# v_{A(cam)} = ... = 1.32 m/s: the letter, the whole index, the magnitude
CARRIED = re.compile(
    r"^[va]_\{([A-Z](?:_\{\d\})?)(\([^)]*\))[^&]*&=.*?(\d[\d.]*\\,\\unit\{[^}]*\})(?:\\quad.*)?$"
)


def find_confused(blocks: tuple[Block, ...]) -> Iterator[str]:
    """The checks from point to point that take the motion of A(cam) and name A."""
    checks = [text for text in proses(blocks) if re.match("Check by the (base|projection)", text)]
    for line in displayed(blocks):
        for letter, owner, value in CARRIED.findall(line):
            for check in checks:
                way, _, sides = check.partition(": ")
                named = re.findall(r"\$([^$]*)\$", way.split(", multiplied")[0])
                if value in sides and letter in named and letter + owner not in named:
                    yield check


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_checks_name_the_body_of_a_point_that_belongs_to_several(name: str) -> None:
    for place in range(len(drawn(name))):
        assert list(find_confused(kept(name, place))) == []


def test_a_point_does_not_coincide_with_itself() -> None:
    told = list(proses(kept("flat-faced-follower-curvature-radius")))
    assert any(text.startswith("Relative to the cam, $A$ has the velocity") for text in told), told
    assert [text for text in told if "the point of $BC$ that coincides with $A$" in text] == []
