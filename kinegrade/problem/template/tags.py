"""Tags: the words by which a bank finds templates, most of them derived from what a template
asks.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, TypeAlias, cast, get_args

from kinegrade.errors import find_nearest
from kinegrade.problem.template.template import Ask, Template

KINDS = ("position", "velocity", "acceleration")
#: The tags of the shipped templates; what each means stands in `choosing.po` of every catalogue.
Tag: TypeAlias = Literal[
    "position",
    "velocity",
    "acceleration",
    "base-point",
    "belt",
    "body-frames",
    "cam",
    "centrode",
    "coriolis",
    "curved-slot",
    "curved-track",
    "four-bar",
    "gears",
    "instantaneous-translation",
    "machine",
    "pole",
    "relative-motion",
    "relative-rotation",
    "rolling",
    "simultaneous",
    "sleeve",
    "slipping-contact",
    "slot",
    "two-inputs",
]
TAGS: tuple[Tag, ...] = get_args(Tag)


def find_kind(ask: Ask) -> str:
    """What an ask is about, one of the KINDS, by the power of time in its unit: m and deg, m/s and
    rad/s, m/s^2 and rad/s^2.
    """
    return {-1: "velocity", -2: "acceleration"}.get(ask.unit.time, "position")


def select_asks(template: Template, about: str = "") -> tuple[str, ...]:
    """The asks with points that are of one of the KINDS; without a kind, all that have points."""
    return tuple(name for name in template.asked() if about in ("", find_kind(template.asks[name])))


def list_tags(template: Template) -> frozenset[str]:
    """The highest kind among the asks with points, and the tags that the template's author
    added.
    """
    kinds = {find_kind(template.asks[name]) for name in template.asked()}
    highest = next((name for name in reversed(KINDS) if name in kinds), "position")
    return frozenset({highest, *template.about.tags})


def find_misspelt_tags(template: Template) -> Iterator[tuple[str, Tag]]:
    """The tags of an author's own that are almost a known one, each with that."""
    for own in template.about.tags:
        if own not in TAGS and (near := find_nearest(own, TAGS)):
            yield own, cast(Tag, near[0])
