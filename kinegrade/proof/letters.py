"""Points that the statement names and the figure does not letter: only those of bodies, joints and
circles have letters.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kinegrade.figure.sketch import sketch
from kinegrade.language.message import Message
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.problem.template.template import Template

_FORMULA = re.compile(r"\$([^$\n]+)\$")


def note_points_without_letter(
    template: Template, examples: Iterable[Solution]
) -> Iterator[Message]:
    """A remark for each point that a formula of the statement consists of, and no letter of the
    figures of these instances. Raises TemplateError as `sketch` does.
    """
    hints = mark_question(template, template.asked())
    for example in examples if template.scheme.has_mechanism else ():
        shown = _list_letters(example, hints)
        for point in _find_named_points(template):
            symbol = write_point_symbol(point)
            if not {_plain(symbol), _plain(hints.labels.get(point) or symbol)} & shown:
                yield Message("template.no-letter", point=point)


def _list_letters(example: Solution, hints: FigureHints) -> set[str]:
    scene = sketch(example.assembly.mechanism.map(float), hints)
    return {_plain(label.symbol) for label in scene.labels}


def _find_named_points(template: Template) -> Iterator[str]:
    texts = template.words.statement.texts
    named = {_plain(formula) for text in texts for formula in _FORMULA.findall(text)}
    for point in template.scheme.points:
        if _plain(write_point_symbol(point)) in named:
            yield point


def _plain(symbol: str) -> str:
    """O_{1} is O_1."""
    return symbol.replace("{", "").replace("}", "")
