"""What the known mistakes are called: by identifier in banks and marks, by a sentence for people.

An identifier is stable: banks set credits by it, and marks name it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from typing import Literal, get_args

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Template

MistakeName = Literal[
    "coriolis-dropped",
    "coriolis-halved",
    "coriolis-reversed",
    "coriolis-wrong-omega",
    "relative-normal-dropped",
    "relative-normal-outwards",
    "path-normal-dropped",
    "path-normal-outwards",
    "omega-not-squared",
    "tangential-dropped",
    "relative-for-absolute",
    "absolute-for-relative",
    "meshing-reversed",
    "belt-reversed",
    "arm-for-sum",
    "inverse-ratio",
    "wrong-pole",
    "far-pivot-for-pole",
    "far-end-for-pole",
    "pole-on-velocities",
    "neighbours-omega",
    "translation-assumed",
    "centre-for-pole",
    "transport-for-absolute",
    "transport-of-other-frame",
    "added-as-scalars",
    "other-branch",
    "sine-for-cosine",
    "degrees-for-radians",
    "diameter-for-radius",
    "rpm-not-converted",
    "millimetres-for-metres",
    "supplementary-angle",
    "one-length-for-another",
    "sense-reversed",
    "minus-in-magnitude",
    "power-of-ten-up",
    "power-of-ten-down",
    "two-powers-of-ten-up",
    "two-powers-of-ten-down",
    "three-powers-of-ten-up",
    "three-powers-of-ten-down",
    "degrees-per-second",
    "rpm-typed",
]
MISTAKE_NAMES: tuple[MistakeName, ...] = get_args(MistakeName)


def describe_all_mistakes(templates: Iterable[Template], language: Language) -> Mapping[str, str]:
    """What each mistake is, those that authors of questions state in these templates among them.
    Raises TemplateError where one has no sentence in the language.
    """
    own = {
        each.identifier: each.means.in_language(language)
        for template in templates
        for each in template.scheme.mistakes
    }
    return {**describe_mistakes(language), **own}


@cache
def describe_mistakes(language: Language) -> Mapping[str, str]:
    """By identifier what each mistake is, in one sentence for the student who made it.

    >>> describe_mistakes(Language("en"))["coriolis-halved"]
    'The factor 2 of the Coriolis acceleration was forgotten.'
    """
    catalogue = open_catalogue(language)
    return {name: catalogue.write(Message(f"mistake.{name}")) for name in MISTAKE_NAMES}
