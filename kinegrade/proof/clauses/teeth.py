"""Whose teeth a given counts in words and in joints."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.expressions.tree import find_names
from kinegrade.language.message import Message, list_plainly
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import list_words
from kinegrade.proof.clauses.sentences import list_named


def find_misplaced_teeth(template: Template) -> Iterator[Message]:
    """A given that counts the teeth of a gear and makes the radius of others alone."""
    circles = [
        (body, shape)
        for joint in template.scheme.joints
        for body, shape in ((joint.body, joint.circle), (joint.of, joint.on))
        if shape is not None and shape.function == "circle"
    ]
    for name, given in template.parameters.items():
        text = given.means.texts[0] if given.means.texts else ""
        counts = any(word in text.lower() for word in list_words("tooth-count"))
        parts = [part for parts in list_named(template, text) for part in parts] if counts else []
        meant = {body for part in parts for body in part.bodies}
        own = {body for body, shape in circles if name in find_names(shape)}
        if own and meant & {body for body, _ in circles} and not meant & own:
            yield Message(
                "template.teeth-elsewhere",
                name=name,
                named=list_plainly(sorted(meant)),
                actual=list_plainly(sorted(own)),
            )
