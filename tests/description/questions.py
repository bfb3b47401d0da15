"""A question as a reader of its description has it: the sentences, and what is asked."""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Mapping
from typing import Any

from kinegrade.description.description import describe
from kinegrade.description.subject import make_subject
from kinegrade.language import ENGLISH
from kinegrade.problem.solution import Solution


def write_question(solution: Solution, asks: Collection[str]) -> Mapping[str, Any]:
    """The description in English, the words in it for bodies, and the quantities that are asked in
    the template's words; without the statement and without the figure.
    """
    template = solution.template
    described = describe(solution, ENGLISH, asks)
    assert described is not None
    subject = make_subject(solution, asks, ENGLISH)
    stated = tomllib.loads(template.file.text)
    return {
        "description": [paragraph.text for paragraph in described.long],
        "bodies": {
            body.name: subject.case.say(subject.body(body.name)).text
            for body in template.scheme.bodies
        },
        "asks": [
            {
                "name": name,
                "quantity": stated["asks"][name]["quantity"],
                "unit": template.asks[name].unit.text,
            }
            for name in asks
        ],
    }


def list_differences(solution: Solution, asks: Collection[str], found: Mapping[str, Any]) -> str:
    """The asks for which a reader found anything else than the key, each with both numbers."""
    known = {name: solution[name] for name in asks}
    finite = [abs(one.value) for one in known.values() if not one.at_infinity]
    slack = 1e-6 * max(1.0, *finite)
    wrong = []
    for name, one in known.items():
        key = None if one.at_infinity else one.value
        read = found.get(name)
        if (key is None) != (read is None) or (
            key is not None and abs(read - key) > max(slack, 1e-6 * abs(key))
        ):
            wrong.append(f"{name} = {key}, read {read}")
    return "; ".join(wrong)
