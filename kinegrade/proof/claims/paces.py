"""Claims of inputs that go faster or slower, and of those relative to another body."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.expressions.tree import find_names
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.reading import read_claims


def find_wrong_paces(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`the speed {{ v }}, which decreases with the acceleration {{ a }}` of an input whose rates
    have one sign.
    """
    for kind, sign in (("faster", 1), ("slower", -1)):
        for claim in read_claims(template, f"pace-{kind}"):
            for place, sentence in enumerate(template.scheme.drivers):
                if claim["given"] not in find_names(sentence.acceleration):
                    continue
                drivers = [each.assembly.mechanism.drivers[place] for each in examples]
                paces = [sign * float(one.velocity) * float(one.acceleration) for one in drivers]
                if paces and max(paces) < 0:
                    yield Message("template.pace-contradicted", said=claim["said"])
                elif paces and min(paces) < 0:
                    yield Message("template.pace-in-some", said=claim["said"])


def find_wrong_references(template: Template) -> Iterator[Message]:
    """`turns relative to $AB$ with {{ omega }}` of an input that is relative to the ground."""
    for claim in read_claims(template, "relative"):
        for sentence in template.scheme.drivers:
            if sentence.of == GROUND and claim["given"] in find_names(sentence.velocity):
                yield Message("template.relative-to-ground", said=claim["said"])
