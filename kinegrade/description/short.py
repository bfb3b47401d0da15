"""A figure in one line of plain text, as the image of a page has it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import assert_never

from kinegrade.language import Language
from kinegrade.language.lines import shorten
from kinegrade.language.message import Message, list_plainly
from kinegrade.language.prose.plain import write_line
from kinegrade.language.sentence import write_sentence
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.driven_words import name_sense
from kinegrade.problem.given import list_givens
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.template.driven import Drives, find_driven
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.words.body_names import BodyNames

MOST = 125  # characters: screen readers break longer ones up


def describe_briefly(
    template: Template, parameters: Mapping[str, Quantity], language: Language
) -> str:
    """What the figure shows, in at most MOST characters of plain text: its title, the points and
    which way what is driven goes, as far as there is room.
    """
    title = template.about.title.in_language(language)
    points = list_plainly(_list_points(template))
    motions = list_plainly(_list_motions(template, parameters, language))
    texts = [
        Message("description.short-points", title=title, points=points),
        Message("description.short", title=title),
    ]
    if motions.items:
        full = Message("description.short-motions", title=title, points=points, motions=motions)
        texts.insert(0, full)
    lines = [write_line(write_sentence(text, language), template.name) for text in texts]
    return next((line for line in lines if len(line) <= MOST), shorten(lines[-1], MOST))


def _list_points(template: Template) -> Iterator[str]:
    """The points of bodies that the figure names, each once."""
    points = (point for body in template.scheme.bodies for point in body.points)
    for point in dict.fromkeys(points):
        if template.figure.labels.get(point, point) is not None:
            yield f"${write_point_symbol(point)}$"


def _list_motions(
    template: Template, parameters: Mapping[str, Quantity], language: Language
) -> Iterator[Message]:
    """Which way each driven body turns, and each driven point moves, where statements say it;
    nothing of motions relative to another body.
    """
    alone = [driver for driver in template.scheme.drivers if driver.of == GROUND]
    driven: Drives = find_driven(alone, template.parameters)
    givens = list_givens(template, parameters)
    bodies = BodyNames(template)
    for part, named in driven.items():
        for name, one in named.items():
            sense = name_sense(one, givens)
            if sense is None:
                continue
            match part:
                case "turning":
                    body = bodies.body(name)
                    yield Message("description.short-turning", body=body, sense=sense)
                case "moving":
                    point = f"${write_point_symbol(name)}$"
                    yield Message("description.short-moving", point=point, sense=sense)
                case _:
                    assert_never(part)
