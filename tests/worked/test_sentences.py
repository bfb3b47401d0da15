"""Sentences of worked solutions say one thing each, whole, and nothing twice."""

from __future__ import annotations

import re

import pytest

from kinegrade.language import Language
from kinegrade.problem.template.library.library import find_template_names
from tests.worked.draws import kept
from tests.worked.telling import proses

BROKEN = re.compile(r"[:：]\s*(?:Here|Hier|其中)")
NESTED = re.compile(r"[(（][^()（）$]*[(（]")
SAID_OF_ITSELF = re.compile(
    r"lies at the distance \$([A-Z])([A-Z])\$ from \$([A-Z])\$; \$([A-Z]{2})\$"
)
AT_A_NAMED_DISTANCE = ("two-rods-driven-ends",)


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("language", ["en", "de", "zh"])
@pytest.mark.parametrize("name", find_template_names())
def test_what_a_colon_announces_follows_it(name: str, language: Language) -> None:
    """The velocity of G was announced, and the length of EG followed."""
    assert [text for text in proses(kept(name, language=language)) if BROKEN.search(text)] == []


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("name", find_template_names())
def test_what_is_sought_has_no_brackets_within_brackets(name: str, language: Language) -> None:
    known, *_ = [
        text for text in proses(kept(name, language=language)) if re.search("求|ought", text)
    ]
    assert NESTED.findall(known) == []


@pytest.mark.sampled(12, first=1, also=AT_A_NAMED_DISTANCE)
@pytest.mark.parametrize("name", find_template_names())
def test_no_point_lies_at_the_distance_that_has_its_own_letters(name: str) -> None:
    """E lies at the distance OE from O."""
    said = [one for text in proses(kept(name)) for one in SAID_OF_ITSELF.findall(text)]
    for one, other, centre, line in said:
        assert centre not in (one, other) or {one, other} != {*line}
    assert said or name not in AT_A_NAMED_DISTANCE


def test_a_distance_that_is_sought_is_not_said_to_be_itself() -> None:
    """OC (distance OC)."""
    assert not [text for text in proses(kept("tangent-cam-with-roller")) if "$OC$ (" in text]
