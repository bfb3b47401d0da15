r"""Claims of lengths by formulas: `$AB$ of length $2l/5$`, `at the distance $\sqrt{2}\,r$`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import combinations
from math import sqrt

from kinegrade.errors import ExpressionError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Expression, find_names
from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.patterns import NO_SUBJECT
from kinegrade.proof.claims.reading import DIFFERENT, find_points, read_claims

_FRACTION = re.compile(r"\\[td]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_ROOT = re.compile(r"\\sqrt\s*(?:\{([^{}]*)\}|(\w))")
_SPACE = re.compile(r"\\[,;:! ]|\\quad|\s+")
_SIDE_BY_SIDE = re.compile(r"(?<=[\w)])\s+(?=[\w(])")
_PIECE = re.compile(r"sqrt|\d+(?:\.\d+)?|\w|[^\w\s]")


def find_wrong_formulas(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """The lengths that no two points have, or not those that are named."""
    for claim in read_claims(template, "length-formula"):
        ends = find_points(template, claim["start"], claim["end"])
        yield from _judge(template, claim, [(ends[0], ends[1])] if ends else [], examples)
    for claim in read_claims(template, "distance-formula", NO_SUBJECT):
        pairs = [*combinations(template.scheme.points, 2)]
        yield from _judge(template, claim, pairs, examples)


def _judge(
    template: Template,
    claim: dict[str, str],
    pairs: Sequence[tuple[str, str]],
    examples: Sequence[Solution],
) -> Iterator[Message]:
    """That the formula of a claim is the distance of none of these pairs."""
    tree = _read_formula(template, claim["formula"])
    if tree is None or not pairs:
        return
    for each in examples:
        value = _evaluate(template, tree, each)
        at = each.doubles.points
        sizes = [length(at[end] - at[start]) for start, end in pairs]
        if value is None:
            return
        if not any(abs(size - value) <= DIFFERENT * abs(value) for size in sizes):
            yield Message("template.lies-otherwise", said=claim["said"])
            return


def _read_formula(template: Template, formula: str) -> Expression | None:
    """A formula as an expression of given lengths; None where it is none."""
    text = _FRACTION.sub(r"((\1)/(\2))", formula)
    text = _ROOT.sub(lambda found: f"sqrt({found[1] or found[2]})", text)
    text = _SPACE.sub(" ", text.replace(r"\cdot", "*").replace(r"\times", "*"))
    names = {
        word: each.name
        for each in template.parameters.values()
        for word in {each.name, each.symbol}
        if each.unit.is_length and re.fullmatch(r"\w", word)
    }
    pieces = [names.get(piece, piece) for piece in _PIECE.findall(text)]
    spaced = _SIDE_BY_SIDE.sub("*", " ".join(pieces)).replace("sqrt*", "sqrt")
    try:
        tree = read_expression(spaced)
    except ExpressionError:
        return None
    used = {*find_names(tree)}
    return tree if used and used <= {*names.values()} else None


def _evaluate(template: Template, tree: Expression, each: Solution) -> float | None:
    """The value of a formula in an instance, in metres; None where it has none."""
    values = {
        name: abs(each.parameters[name].value) * Floats().scale(given.unit.scale)
        for name, given in template.parameters.items()
        if given.unit.is_length
    }
    try:
        return float(evaluate(tree, values, {"sqrt": sqrt}, Floats()))
    except (ExpressionError, ValueError, ZeroDivisionError):
        return None
