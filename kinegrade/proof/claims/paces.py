"""Claims of inputs that go faster or slower, and of those relative to another body."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from kinegrade.expressions.tree import find_names
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import write_words
from kinegrade.proof.claims.reading import list_sentences_of, read_claims

_OTHER = {"faster": "slower", "slower": "faster"}
_SLOT = re.compile(r"\{\{\s*(\w+)[^}]*\}\}")
_ACCELERATION = -2  # the power of time


def find_wrong_paces(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`the speed {{ v }}, which decreases with the acceleration {{ a }}` of an input whose rates
    have one sign.
    """
    for kind, sign in (("faster", 1), ("slower", -1)):
        claims = [*read_claims(template, f"pace-{kind}")]
        for claim in (*claims, *_read_clauses(template, kind, claims)):
            for place, sentence in enumerate(template.scheme.drivers):
                if claim["given"] not in find_names(sentence.acceleration):
                    continue
                drivers = [each.assembly.mechanism.drivers[place] for each in examples]
                paces = [sign * float(one.velocity) * float(one.acceleration) for one in drivers]
                if paces and max(paces) < 0:
                    yield Message("template.pace-contradicted", said=claim["said"])
                elif paces and min(paces) < 0:
                    yield Message("template.pace-in-some", said=claim["said"])


def _read_clauses(
    template: Template, kind: str, known: Sequence[Mapping[str, str]]
) -> Iterator[Mapping[str, str]]:
    """`it is slowing down, the magnitude of its deceleration being {{ a }}`: the first given behind
    such words that is an acceleration, in a sentence with one of both kinds alone.
    """
    words, other = (write_words(f"pace-clause-{each}") for each in (kind, _OTHER[kind]))
    for text in template.words.statement.texts:
        for sentence in list_sentences_of(text):
            match = re.search(words, sentence, re.IGNORECASE)
            if match is None or re.search(other, sentence, re.IGNORECASE):
                continue
            for slot in _SLOT.finditer(sentence, match.end()):
                given = template.parameters.get(slot[1])
                if given is not None and given.unit.time == _ACCELERATION:
                    said = " ".join(sentence[match.start() : slot.end()].split())
                    if not any(each["given"] == given.name for each in known):
                        yield {"given": given.name, "said": said}
                    break


def find_wrong_references(template: Template) -> Iterator[Message]:
    """`turns relative to $AB$ with {{ omega }}` of an input that is relative to the ground."""
    for claim in read_claims(template, "relative"):
        for sentence in template.scheme.drivers:
            if sentence.of == GROUND and claim["given"] in find_names(sentence.velocity):
                yield Message("template.relative-to-ground", said=claim["said"])
