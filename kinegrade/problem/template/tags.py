"""Tags: the words by which a bank finds templates, most of them derived from what a template
asks.
"""

from __future__ import annotations

from kinegrade.problem.template.template import Ask, Template

KINDS = ("position", "velocity", "acceleration")


def _find_kind(ask: Ask) -> str:
    """What an ask is about, by the power of time in its unit: m and deg, m/s and rad/s, m/s^2 and
    rad/s^2.
    """
    return {-1: "velocity", -2: "acceleration"}.get(ask.unit.time, "position")


def select_asks(template: Template, about: str = "") -> tuple[str, ...]:
    """The asks with points that are of one of the KINDS; without a kind, all that have points."""
    return tuple(
        name for name in template.asked() if about in ("", _find_kind(template.asks[name]))
    )


def list_tags(template: Template) -> frozenset[str]:
    """The highest kind among the asks with points, and the tags that the template's author
    added.
    """
    kinds = {_find_kind(template.asks[name]) for name in template.asked()}
    highest = next((name for name in reversed(KINDS) if name in kinds), "position")
    return frozenset({highest, *template.about.tags})
