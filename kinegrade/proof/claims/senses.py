"""Claims of the way in which something turns or moves."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from kinegrade.language.message import Message
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.driven import Driven, Imposed, find_driven
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import list_prose
from kinegrade.proof.claims.patterns import list_words
from kinegrade.proof.claims.reading import find_points, name_senses, read_claims
from kinegrade.sign_conventions import OPPOSITE, Convention

_TURNS: Mapping[Convention, int] = {"ccw": 1, "cw": -1}
_STILL = 1e-9  # rad/s: less is what doubles leave


def find_wrong_senses(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """What is said of the way in which something goes, and is not so."""
    yield from _find_wrong_inputs(template)
    yield from _find_wrong_bodies(template, examples)
    yield from _find_second_senses(template)


def _find_wrong_inputs(template: Template) -> Iterator[Message]:
    """`turns clockwise with {{ n }}` where some drawable value turns it the other way."""
    driven = [
        (f"{{{{ {name}.{part} }}}}", each)
        for part, named in find_driven(template.scheme.drivers, template.parameters).items()
        for name, each in named.items()
    ]
    for claim in _read_senses(template, "going"):
        yield from _judge(template, claim, [(slot, each, each.velocity) for slot, each in driven])
    for claim in _read_senses(template, "accelerating"):
        changes = [(slot, each, each.acceleration) for slot, each in driven if each.acceleration]
        yield from _judge(template, claim, changes)


def _read_senses(template: Template, kind: str) -> Iterator[Mapping[str, str]]:
    """The claims of a kind, of each sense and given that with the longest sentence."""
    claims = sorted(read_claims(template, kind), key=lambda claim: len(claim["said"]))
    yield from {(claim["sense"], claim["given"]): claim for claim in claims}.values()


def _judge(
    template: Template,
    claim: Mapping[str, str],
    driven: Sequence[tuple[str, Driven, Imposed | None]],
) -> Iterator[Message]:
    """That a claim names the other sense than the rate that is its given."""
    (said,) = name_senses(claim["sense"])
    for slot, found, rate in driven:
        if rate is None or rate.given != claim["given"]:
            continue
        if found.positive not in {said, OPPOSITE[said]}:
            continue
        backwards = (found.positive != said) != rate.turned
        choices = template.parameters[claim["given"]].choices
        wrong = [each for each in choices if each.startswith("-") != backwards]
        if wrong and len(wrong) == len(choices):
            yield Message("template.other-sense", said=claim["said"])
        elif wrong:
            value = f"{claim['given']} = {wrong[0]}"
            yield Message("template.other-sense-at", said=claim["said"], value=value, slot=slot)


def _find_wrong_bodies(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """`$OA$ turns clockwise` of a body that turns the other way in an instance."""
    for claim in read_claims(template, "body-going"):
        (said,) = name_senses(claim["sense"])
        if said not in _TURNS:
            continue
        ends = find_points(template, claim["start"], claim["end"])
        bodies = [
            body.name for body in template.scheme.bodies if ends and {*ends} <= {*body.points}
        ]
        rates = [
            each.doubles.omega(body) * _TURNS[said] for each in examples for body in bodies[:1]
        ]
        if rates and max(rates) < -_STILL:
            yield Message("template.other-sense", said=claim["said"])
        elif rates and min(rates) < -_STILL:
            yield Message("template.other-sense-in-some", said=claim["said"])


def _find_second_senses(template: Template) -> Iterator[Message]:
    """`{{ E.moving }}, to the left`: the slot says the sense that each instance has."""
    texts = [text for _, prose in list_prose(template) for text in prose.texts]
    senses = "|".join(map(re.escape, list_words("sense")))
    pattern = rf"(\{{\{{\s*\w+\s*\.\s*(?:moving|turning)\s*\}}\}})[,，]?\s*({senses})(?![\w-])"
    for text in texts:
        for slot, said in re.findall(pattern, text):
            yield Message("template.sense-twice", slot=slot, said=said)
