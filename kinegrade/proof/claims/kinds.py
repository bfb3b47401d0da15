"""The kinds of quantities that words name, "angular velocity", against those that units have."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Template

# Rates by the powers of length, time and angle of their units; words of the first contain others
_KINDS = {
    (0, -2, 1): "angular-acceleration",
    (0, -1, 1): "angular-velocity",
    (1, -2, 0): "acceleration",
    (1, -1, 0): "velocity",
}


def note_other_kinds(template: Template) -> Iterator[Message]:
    """A remark for each ask whose words name another kind of rate than its unit has: "angular
    velocity" in rad/s^2.
    """
    for name, ask in template.asks.items():
        own = _KINDS.get((ask.unit.length, ask.unit.time, ask.unit.angle))
        named = {kind for text in ask.means.texts for kind in name_kinds(text)}
        if own and named and own not in named:
            yield Message("template.another-kind", name=name, unit=ask.unit.printed)


def name_kinds(said: str) -> Iterator[str]:
    """The kinds of rates that a text names; an angular velocity is no velocity besides."""
    text = said.lower()
    for kind in _KINDS.values():
        for language in known_languages():
            for word in open_catalogue(language).text(f"template.kind-{kind}").split("|"):
                if word in text:
                    yield kind
                    text = text.replace(word, "")
