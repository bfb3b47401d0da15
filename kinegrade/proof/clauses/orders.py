"""Claims of points in a row: `$A$, $B$, $C$ from left to right`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from kinegrade.language.message import Message
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import LETTER, write_words
from kinegrade.proof.claims.reading import DIFFERENT, find_points, list_sentences_of

_ORDERS: Mapping[str, Vector] = {
    "right": Vector(1.0, 0.0),
    "left": Vector(-1.0, 0.0),
    "above": Vector(0.0, 1.0),
    "below": Vector(0.0, -1.0),
}
_LETTERS = re.compile(rf"\$({LETTER})\$")
_BETWEEN = re.compile(r"\s*(?:,|、|和|and|und|, and)?\s*")


def find_wrong_orders(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The rows of points that stand in another order in some instance."""
    for text in template.words.statement.texts:
        for sentence in list_sentences_of(text):
            for toward, said, names in _list_rows(template, sentence):
                if not all(_is_in_order(each, names, toward) for each in examples):
                    yield Message("template.lies-otherwise", said=said)


def _list_rows(template: Template, sentence: str) -> Iterator[tuple[Vector, str, Sequence[str]]]:
    """The points of a sentence that stand in an order, right before the words for it, or else
    behind them.
    """
    rows = [*_find_rows(sentence)]
    for kind, toward in _ORDERS.items():
        for match in re.finditer(write_words(f"order-{kind}"), sentence, re.IGNORECASE):
            before = [row for row in rows if row[-1].end() <= match.start()]
            row = next(iter([*before[-1:], *rows]), None)
            names = find_points(template, *(each[1] for each in row)) if row else []
            if row and names:
                start = min(row[0].start(), match.start())
                end = max(row[-1].end(), match.end())
                yield toward, " ".join(sentence[start:end].split()), names


def _find_rows(sentence: str) -> Iterator[list[re.Match[str]]]:
    """The letters that stand side by side, two or more."""
    row: list[re.Match[str]] = []
    for match in _LETTERS.finditer(sentence):
        if row and not _BETWEEN.fullmatch(sentence, row[-1].end(), match.start()):
            yield from [row] if len(row) > 1 else []
            row = []
        row.append(match)
    yield from [row] if len(row) > 1 else []


def _is_in_order(each: Solution, names: Sequence[str], toward: Vector) -> bool:
    """Whether points stand one beyond the other."""
    places = [each.doubles.points[name].dot(toward) for name in names]
    return all(one < other + DIFFERENT for one, other in pairwise(places))
